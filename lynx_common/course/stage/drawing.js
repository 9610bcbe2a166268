// How things look: solids and floor in space, lines and regions in a plane.
const CIRCLE = Array.from({length: 33}, (_, i) => [Math.cos(i * Math.PI / 16), Math.sin(i * Math.PI / 16)]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = v => { const l = Math.hypot(...v) || 1; return v.map(x => x / l); };
const moved = (a, ...steps) => steps.reduce((p, [k, v]) => p.map((x, i) => x + k * v[i]), a);
const middle = (a, b) => a.map((x, i) => (x + b[i]) / 2);

function trace(pen, points, close) {
  pen.beginPath();
  points.forEach(([x, y], i) => i ? pen.lineTo(x, y) : pen.moveTo(x, y));
  if (close) pen.closePath();
}
function stroke(pen, points, colour, width, dash = []) {
  Object.assign(pen, {strokeStyle: colour, lineWidth: width, lineJoin: "round", lineCap: "round"});
  pen.setLineDash(dash);
  trace(pen, points);
  pen.stroke();
}
function disc(pen, [x, y], radius, fill) {
  pen.fillStyle = fill;
  pen.beginPath();
  pen.arc(x, y, radius, 0, 7);
  pen.fill();
}
function write(pen, text, x, y, colour, align = "left", size = 12) {
  Object.assign(pen, {fillStyle: colour, font: size + "px " + FONT, textAlign: align, textBaseline: "middle"});
  pen.fillText(text, x, y);
}

// Light comes from the upper left: across a rod it falls off, wherever the rod points.
function across(pen, [x, y], [nx, ny], r, colour) {
  const side = 0.55 * nx + ny < 0 ? 1 : -1, slope = Math.abs(ny) * 0.5 + 0.5;
  const g = pen.createLinearGradient(x + nx * r * side, y + ny * r * side, x - nx * r * side, y - ny * r * side);
  [[0, 0.92], [0.28, 1 + 0.34 * slope], [0.62, 0.86], [1, 0.46]].forEach(([at, light]) => g.addColorStop(at, lit(colour, light)));
  return g;
}
function rod(pen, A, B, a, b, colour) {
  const angle = Math.atan2(B[1] - A[1], B[0] - A[0]), n = [-Math.sin(angle), Math.cos(angle)];
  pen.fillStyle = across(pen, middle(A, B), n, Math.max(a, b), colour);
  pen.beginPath();
  pen.arc(A[0], A[1], a, angle + Math.PI / 2, angle - Math.PI / 2);
  pen.arc(B[0], B[1], b, angle - Math.PI / 2, angle + Math.PI / 2);
  pen.closePath();
  pen.fill();
}
function ball(pen, [x, y], r, colour) {
  const g = pen.createRadialGradient(x - 0.35 * r, y - 0.42 * r, 0.05 * r, x, y, r);
  [[0, 1.55], [0.45, 1.02], [1, 0.48]].forEach(([at, light]) => g.addColorStop(at, lit(colour, light)));
  disc(pen, [x, y], r, g);
}
function cylinder(pen, camera, a, b, radius, colour) {
  const axis = unit(moved(b, [-1, a])), u = unit(cross(axis, Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0])), v = cross(axis, u);
  const rims = [a, b].map(end => CIRCLE.map(([c, s]) => camera.place(moved(end, [radius * c, u], [radius * s, v]))));
  const [A, B] = [a, b].map(camera.place), angle = Math.atan2(B[1] - A[1], B[0] - A[0]), n = [-Math.sin(angle), Math.cos(angle)];
  const along = ([x, y]) => x * n[0] + y * n[1], edges = rims.map(rim => rim.slice().sort((p, q) => along(p) - along(q)));
  pen.fillStyle = across(pen, middle(A, B), n, radius * A[3], colour);
  for (const shape of [...rims, [edges[0][0], edges[1][0], edges[1][32], edges[0][32]]]) { trace(pen, shape, true); pen.fill(); }
  const near = A[2] < B[2] ? 0 : 1, normal = camera.axes(moved(near ? b : a, [near ? 1 : -1, axis])).map((x, i) => x - camera.axes(near ? b : a)[i]);
  pen.fillStyle = lit(colour, 0.86 + 0.3 * Math.max(-0.6, 0.8 * normal[1] - 0.5 * normal[0] - 0.35 * normal[2]));
  trace(pen, rims[near], true);
  pen.fill();
}

// The floor: a grid that fades, and on it a soft shadow of all bodies, as of light from above.
function floor(pen, view, camera, look) {
  const {tick, centre, radius} = view, reach = 1.3 * radius, ticks = Math.ceil(reach / tick);
  const [i0, j0] = [0, 1].map(i => Math.round(centre[i] / tick));
  const fade = (x, y) => Math.max(0, 1 - ((x - centre[0]) ** 2 + (y - centre[1]) ** 2) / reach ** 2);
  for (let i = i0 - ticks; i <= i0 + ticks; i++) for (let j = j0 - ticks; j <= j0 + ticks; j++) for (const [di, dj] of [[1, 0], [0, 1]]) {
    const shown = fade((i + di / 2) * tick, (j + dj / 2) * tick), axis = di ? j === 0 : i === 0;
    if (shown <= 0) continue;
    pen.globalAlpha = Math.min(1, 1.5 * shown);
    stroke(pen, [[i, j], [i + di, j + dj]].map(([a, b]) => camera.place([a * tick, b * tick, 0])), axis ? look.axis : look.grid, 1);
  }
  pen.globalAlpha = 1;
}
function shadows(pen, camera, bodies, size, look) {
  for (const spread of [3, 2, 1, 0, -1]) {
    pen.fillStyle = look.shadow;
    pen.beginPath();
    for (const {points, radius} of bodies) points.forEach((p, i) => {
      const q = points[Math.min(i + 1, points.length - 1)], angle = Math.atan2(q[1] - p[1], q[0] - p[0]), r = Math.max(0, radius + 0.004 * spread * size);
      const rim = Array.from({length: 16}, (_, k) => {
        const turn = angle - Math.PI / 2 + Math.PI * (k % 8) / 7 + (k < 8 ? 0 : Math.PI), end = k < 8 ? q : p;
        return camera.place([end[0] + r * Math.cos(turn), end[1] + r * Math.sin(turn), 0]);
      });
      rim.forEach(([x, y], k) => k ? pen.lineTo(x, y) : pen.moveTo(x, y));
      pen.closePath();
    });
    pen.fill();
  }
}

function drawSpace(pen, view, camera, items, look) {
  floor(pen, view, camera, look);
  shadows(pen, camera, items.filter(({item}) => item.kind === "body" && !item.clear), view.radius, look);
  const solids = [];
  for (const {item, points, radius} of items) {
    const colour = look.colours[item.colour], seen = points.map(camera.place), add = (depth, draw) => solids.push({depth, draw});
    if (item.kind === "line") {
      const dash = item.dashed ? [2, 6] : [];
      if (item.filled) add(Math.max(...seen.map(p => p[2])), () => { pen.globalAlpha = 0.35; pen.fillStyle = colour; trace(pen, seen, true); pen.fill(); pen.globalAlpha = 1; });
      if (item.width) for (let i = 1; i < seen.length; i++) add((seen[i - 1][2] + seen[i][2]) / 2, () => stroke(pen, [seen[i - 1], seen[i]], colour, item.width, dash));
      if (item.dots) seen.forEach(p => add(p[2], () => disc(pen, p, item.dots, colour)));
      if (item.label) add(seen[0][2], () => write(pen, item.label, seen[0][0] + 6, seen[0][1] - 6, colour, "left", 13));
    } else if (points.length === 1) add(seen[0][2] - (item.clear ? 0 : radius), () => {
      pen.globalAlpha = item.clear ? 0.45 : 1;
      ball(pen, seen[0], radius * seen[0][3], colour);
      pen.globalAlpha = 1;
    }); else for (let i = 1; i < points.length; i++) {
      const [A, B] = [seen[i - 1], seen[i]];
      add((A[2] + B[2]) / 2, () => item.flat ? cylinder(pen, camera, points[i - 1], points[i], radius, colour) : rod(pen, A, B, radius * A[3], radius * B[3], colour));
    }
  }
  ordered(solids).forEach(solid => solid.draw());
}

// A grid with numbers and the names of the axes; then the items, in their order.
function axes(pen, {x, y, low, high, tick}, frame, look) {
  const [left, top, width, height] = frame.box, name = v => String(+v.toFixed(6)).replace("-", MINUS);
  const ticks = i => Array.from({length: Math.floor(high[i] / tick + 1e-9) - Math.ceil(low[i] / tick - 1e-9) + 1}, (_, k) => (Math.ceil(low[i] / tick - 1e-9) + k) * tick);
  const [xs, ys] = [ticks(0), ticks(1)].map((all, i) => all.filter(v => frame.scale * tick > 36 - 14 * i || Math.round(v / tick) % 2 === 0));
  for (const v of ticks(0)) { const [a] = frame.place([v, 0]); stroke(pen, [[a, top], [a, top + height]], Math.abs(v) < 1e-9 ? look.axis : look.grid, 1); }
  for (const v of ticks(1)) { const [, b] = frame.place([0, v]); stroke(pen, [[left, b], [left + width, b]], Math.abs(v) < 1e-9 ? look.axis : look.grid, 1); }
  for (const v of xs) write(pen, name(v), frame.place([v, 0])[0], top + height + 12, look.muted, "center", 11);
  for (const v of ys) write(pen, name(v), left - 7, frame.place([0, v])[1], look.muted, "right", 11);
  write(pen, x, left + width / 2, top + height + 28, look.ink, "center");
  pen.save(); pen.translate(left - 36, top + height / 2); pen.rotate(-Math.PI / 2); write(pen, y, 0, 0, look.ink, "center"); pen.restore();
}
function drawPlane(pen, view, frame, items, look) {
  axes(pen, view, frame, look);
  pen.save(); pen.beginPath(); pen.rect(...frame.box); pen.clip();
  for (const {item, points, radius, field} of items) {
    const colour = look.colours[item.colour], seen = points?.map(frame.place);
    if (item.kind === "level") {
      pen.fillStyle = colour; pen.globalAlpha = item.shade; pen.beginPath();
      for (const polygon of field.region) { polygon.map(frame.place).forEach(([x, y], i) => i ? pen.lineTo(x, y) : pen.moveTo(x, y)); pen.closePath(); }
      if (item.shade) pen.fill();
      pen.globalAlpha = 1; pen.beginPath();
      for (const [a, b] of field.border) { pen.moveTo(...frame.place(a).slice(0, 2)); pen.lineTo(...frame.place(b).slice(0, 2)); }
      Object.assign(pen, {strokeStyle: colour, lineWidth: item.width, lineCap: "round"}); pen.setLineDash(item.dashed ? [3, 4] : []);
      if (item.width) pen.stroke();
    } else if (item.kind === "body") {
      pen.globalAlpha = item.clear ? 0.4 : 1;
      if (seen.length === 1) ball(pen, seen[0], radius * frame.scale, colour);
      for (let i = 1; i < seen.length; i++) rod(pen, seen[i - 1], seen[i], radius * frame.scale, radius * frame.scale, colour);
      pen.globalAlpha = 1;
    } else {
      if (item.filled) { pen.globalAlpha = 0.25; pen.fillStyle = colour; trace(pen, seen, true); pen.fill(); pen.globalAlpha = 1; }
      if (item.width) stroke(pen, seen, colour, item.width, item.dashed ? [4, 6] : []);
      if (item.dots) seen.forEach(p => disc(pen, p, item.dots, colour));
      if (item.label) write(pen, item.label, seen[0][0] + 9, seen[0][1] - 11, colour, "left", 13);
    }
  }
  pen.restore();
}

// A ring to be grabbed.
function ring(pen, at, held, look) {
  pen.globalAlpha = held ? 0.35 : 0.2;
  disc(pen, at, held ? 19 : 15, look.accent);
  pen.globalAlpha = 1;
  Object.assign(pen, {strokeStyle: look.accent, lineWidth: 2});
  pen.setLineDash([]); pen.beginPath(); pen.arc(at[0], at[1], held ? 11 : 9, 0, 7); pen.stroke();
}
