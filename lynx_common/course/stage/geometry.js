// Where things stand, and what follows from a drag: pure functions of numbers, without a page.
const RAD = Math.PI / 180, MINUS = "\u2212";

// A plane view in so many pixels: equal scales, as large as fits. place: data to [x, y, depth, pixels per unit].
function plane({low, high}, width, height) {
  const [left, right, top, bottom] = [46, 14, 10, 38], [dx, dy] = [high[0] - low[0], high[1] - low[1]];
  const scale = Math.min((width - left - right) / dx, (height - top - bottom) / dy);
  const x0 = (width + left - right - scale * dx) / 2, y0 = (height + top - bottom + scale * dy) / 2;
  return {
    scale, box: [x0, y0 - scale * dy, scale * dx, scale * dy],
    place: ([a, b]) => [x0 + scale * (a - low[0]), y0 - scale * (b - low[1]), 0, scale],
    back: ([x, y]) => [low[0] + (x - x0) / scale, low[1] + (y0 - y) / scale],
  };
}

// A view in space, seen from afar with some perspective; turn and tilt in degrees.
function space({centre, radius}, width, height, turn, tilt) {
  const [c, s, C, S] = [Math.cos(turn * RAD), Math.sin(turn * RAD), Math.cos(tilt * RAD), Math.sin(tilt * RAD)];
  const far = 4.5 * radius, scale = Math.min(0.475 * width, 0.64 * height) / radius;
  const axes = p => {
    const [x, y, z] = p.map((v, i) => v - centre[i]), away = x * s + y * c;
    return [x * c - y * s, z * C + away * S, away * C - z * S];
  };
  return {
    scale, axes,
    place: p => {
      const [across, up, depth] = axes(p), k = scale * far / (far + depth);
      return [width / 2 + k * across, height / 2 - k * up, depth, k];
    },
    back: ([x, y], depth) => {  // the point of that depth
      const k = scale * far / (far + depth), across = (x - width / 2) / k, up = (height / 2 - y) / k;
      const away = depth * C + up * S;
      return [across * c + away * s, away * c - across * s, up * C - depth * S].map((v, i) => v + centre[i]);
    },
  };
}

// What is farther is drawn first.
const ordered = solids => solids.sort((a, b) => b.depth - a.depth);

// The points of an item in runs, each without a gap: a curve ends where a number is missing, all else is not drawn.
function runsOf(item, numbers, curve, trail) {
  if (!(numbers[item.when] >= 0)) return [];
  let flat = numbers.slice(item.points[0], item.points[0] + item.points[1]);
  if (item.along) {
    const [which, first, last, pieces] = item.along;
    flat = Array.from({length: pieces + 1}, (_, i) => curve(which, first + (last - first) * i / pieces)).flat();
  } else if (item.trail) flat = trail(item);
  const points = Array.from({length: flat.length / item.size}, (_, i) => flat.slice(i * item.size, (i + 1) * item.size)), runs = [[]];
  for (const point of points) {
    if (point.every(Number.isFinite)) runs[runs.length - 1].push(point);
    else if (item.along) runs.push([]);
    else return [];
  }
  return runs.filter(run => run.length);
}

// Where f changes its sign between two points; halved, since it may jump or bend there.
function cut(f, a, b, positive) {
  for (let i = 0; i < 6; i++) {
    const m = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    if (f(...m) >= 0 === positive) a = m; else b = m;
  }
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}

// The region where f(a, b) >= 0 as polygons, and its border as pieces, on a grid of cells.
function contour(f, low, high, columns, rows) {
  const at = (i, j) => [low[0] + (high[0] - low[0]) * i / columns, low[1] + (high[1] - low[1]) * j / rows];
  const values = Array.from({length: rows + 1}, (_, j) => Array.from({length: columns + 1}, (_, i) => f(...at(i, j))));
  const region = [], border = [];
  for (let j = 0; j < rows; j++) for (let i = 0, run = null; i <= columns; i++) {
    const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]], v = corners.map(([a, b]) => values[b][a]);
    const full = i < columns && v.every(value => value >= 0);
    if (full && run === null) run = i;
    if (!full && run !== null) { region.push([at(run, j), at(i, j), at(i, j + 1), at(run, j + 1)]); run = null; }
    if (full || i === columns || !v.every(Number.isFinite)) continue;
    const polygon = [], cuts = [];
    corners.forEach((corner, k) => {
      const next = (k + 1) % 4, [a, b] = [at(...corner), at(...corners[next])];
      if (v[k] >= 0) polygon.push(a);
      if (v[k] >= 0 !== v[next] >= 0) { cuts.push(cut(f, a, b, v[k] >= 0)); polygon.push(cuts[cuts.length - 1]); }
    });
    if (polygon.length > 2) region.push(polygon);
    for (let k = 0; k + 1 < cuts.length; k += 2) border.push([cuts[k], cuts[k + 1]]);
  }
  return {region, border};
}

// Inputs in the units of the sliders, as the formulas take them.
const inFormulas = (inputs, controls) => inputs.map((v, i) => controls[i]?.unit === "°" ? v * RAD : v);

// The inputs on the straight way from one state to another, no further apart than a slider's step; the last is `to`.
function onTheWay(from, to, steps) {
  const n = Math.max(1, Math.ceil(Math.max(...to.map((v, i) => Math.abs(v - from[i]) / steps[i])) - 1e-6));
  return Array.from({length: n}, (_, k) => k + 1 === n ? to : to.map((v, i) => from[i] + (v - from[i]) * (k + 1) / n));
}

// The account of each challenge {lost, met} after a move: what was lost on the way stays so, and what is met, too.
function account(before, from, to, steps, keeps, met) {
  const lost = before.map(one => one.lost);
  let last = from;
  for (const now of onTheWay(from, to, steps)) {
    keeps(now, last).forEach((kept, k) => { lost[k] = lost[k] || !(kept >= 0); });
    last = now;
  }
  return met(to).map((value, k) => ({lost: lost[k], met: before[k].met || (!lost[k] && value >= 0)}));
}

// Where the inputs go as the finger moves from a place where they could follow to another; solve(point) gives the new
// values of the controls that the handle moves. At a limit it goes as far as it can, and says which it is.
function dragged(solve, moves, controls, inputs, from, to) {
  let limit = null;
  const tried = share => {
    const found = solve(from.map((v, i) => v + share * (to[i] - v))), next = inputs.slice();
    for (const [k, place] of moves.entries()) {
      const {unit, low, high, step} = controls[place], turns = unit === "°" ? 360 : 0;
      let value = unit === "°" ? found[k] / RAD : found[k];
      if (turns) value += turns * Math.round((inputs[place] - value) / turns);  // no joint jumps by a full turn
      if (Number.isFinite(value) && (value < low || value > high)) limit = [place, value < low ? low : high];
      if (!(value >= low - 1e-6 * step && value <= high + 1e-6 * step)) return null;
      next[place] = Math.min(high, Math.max(low, value));
    }
    return next;
  };
  const whole = tried(1);
  if (whole) return {inputs: whole, share: 1, limit: null};
  const why = limit;
  let best = null, low = 0, high = 1;
  for (let i = 0; i < 14; i++) {
    const middle = (low + high) / 2, next = tried(middle);
    if (next) { best = next; low = middle; } else high = middle;
  }
  return {inputs: best || inputs, share: best ? low : 0, limit: why};
}

// The row of a motion at a share of its time, between two rows as on a straight line.
function rowAt(rows, share) {
  const at = Math.min(1, Math.max(0, share)) * (rows.length - 1), i = Math.min(rows.length - 2, Math.floor(at));
  return rows.length < 2 ? rows[0] : rows[i].map((v, k) => v + (at - i) * (rows[i + 1][k] - v));
}

// A number with so many decimals.
function numeral(value, digits) {
  if (!Number.isFinite(value)) return "–";
  const fixed = Math.abs(value).toFixed(digits);
  return (value < 0 && +fixed ? MINUS : "") + fixed;
}
function filledIn(text, values, digits, columns) {
  let next = 0;
  return text.replace(/{}/g, () => numeral(values[next++], digits).padStart(columns ? digits + (digits ? 3 : 5) : 0));
}

// A colour #rrggbb with so much light: below 1 towards black, above 1 towards white.
function lit(colour, light) {
  const n = parseInt(colour.slice(1), 16), w = Math.max(0, Math.min(1, light - 1)), d = Math.min(1, light);
  return "rgb(" + [16, 8, 0].map(b => Math.round((1 - w) * d * (n >> b & 255) + 255 * w)).join() + ")";
}
