// The page: controls, pointers and keys in, pictures and words out.
const {controls, views, words, challenges, motion, fixed, steps, home} = facts;
const element = (tag, facts = {}, ...children) => { const made = Object.assign(document.createElement(tag), facts); made.append(...children); return made; };
const byId = id => document.getElementById(id);
const FONT = "system-ui, -apple-system, Segoe UI, Roboto, sans-serif";
const LOOKS = [
  {ink: "#24292f", muted: "#6b7380", grid: "#e6e9ee", axis: "#c3c9d2", shadow: "rgba(20,30,50,.045)", fill: "#667387", accent: "#d9480f", good: "#2b8a3e"},
  {ink: "#e6e8eb", muted: "#98a0ab", grid: "#2a2e35", axis: "#4b525c", shadow: "rgba(0,0,0,.17)", fill: "#98a6ba", accent: "#ff9f5a", good: "#69db7c"},
].map((look, i) => ({...look, colours: facts.colours[i]}));

let look = LOOKS[0], inputs = home.slice(), spoken = null, share = 0, playing = false, began = null, seen = true, held = null, reason = "";
let tally = challenges.map(() => ({lost: false, met: false}));
const angles = views.map(({turn, tilt}) => ({turn, tilt})), calm = matchMedia("(prefers-reduced-motion: reduce)");
const given = values => inFormulas(values, controls);
const numbersAt = values => compute(given(values), fixed);

// Controls
const shown = controls.map((control, place) => {
  const {name, low, high, step, unit, options} = control, decimals = (String(step).split(".")[1] || "").length;
  const change = value => { stop(); go(inputs.map((v, i) => i === place ? +value : v)); };
  if (options) {
    const row = element("div"), field = element("fieldset", {}, element("legend", {textContent: name}), row);
    const radios = Object.entries(options).map(([text, value]) => {
      const radio = element("input", {type: "radio", name: "c" + place, value, oninput: () => change(value)});
      row.append(element("label", {}, radio, element("span", {textContent: text})));
      return radio;
    });
    byId("controls").append(field);
    return () => radios.forEach(radio => { radio.checked = +radio.value === inputs[place]; });
  }
  const value = element("output"), input = element("input", {type: "range", min: low, max: high, step, value: inputs[place], oninput: () => change(input.value)});
  byId("controls").append(element("label", {}, element("span", {textContent: name}), input, value));
  return () => {
    const text = numeral(inputs[place], decimals) + (unit === "°" ? "°" : unit && " " + unit);
    if (document.activeElement !== input || +input.value !== inputs[place]) input.value = inputs[place];
    input.style.setProperty("--at", 100 * (inputs[place] - low) / (high - low) + "%");
    input.setAttribute("aria-valuetext", text);
    value.textContent = text;
  };
});
byId("controls").style.setProperty("--names", Math.max(2, ...controls.map(control => control.name.length)) + "ch");
const lines = words.map(({columns}) => byId("words").appendChild(element("div", {className: columns ? "columns" : ""})));
const tasks = challenges.map(() => byId("challenges").appendChild(element("li", {}, element("span"), element("span"))));

// Pictures
const canvases = views.map((view, k) => {
  const canvas = element("canvas", {tabIndex: view.centre ? 0 : -1}), box = element("div", {className: "view"}, canvas);
  if (view.title) box.append(element("div", {className: "title", textContent: view.title}));
  canvas.setAttribute("role", "img");
  if (view.centre) canvas.title = "Drag to turn" + (view.handles.length ? ", the ring to move" : "");
  byId("views").append(box);
  listen(canvas, view, k);
  return canvas;
});
const frames = views.map(() => null), fields = new Map(), trails = new Map();
byId("main").className = controls.length ? (views.length > 1 ? "many" : "one") : (views.length > 1 ? "bare many" : "bare");

function fit() {
  const fine = window.devicePixelRatio || 1, small = innerWidth < 560;
  canvases.forEach((canvas, k) => {
    const width = canvas.parentNode.clientWidth, most = small ? (views.length > 1 ? 236 : 320) : views.length > 1 ? 340 : 420;
    const height = Math.round(Math.min(most, views[k].centre ? 0.86 * width : width + 4));
    Object.assign(canvas, {width: Math.round(width * fine), height: Math.round(height * fine)});
    canvas.style.height = height + "px";
    canvas.getContext("2d").setTransform(fine, 0, 0, fine, 0, 0);
    frames[k] = [width, height];
  });
  draw();
}
const cameraOf = (view, k) => view.centre ? space(view, ...frames[k], angles[k].turn, angles[k].tilt) : plane(view, ...frames[k]);
function trailOf(item) {
  if (!trails.has(item)) trails.set(item, motion.rows.map(row => numbersAt(withRow(row)).slice(item.points[0], item.points[0] + item.points[1])));
  return trails.get(item).slice(0, 2 + Math.floor(share * (motion.rows.length - 1))).flat();
}
function fieldOf(item, view, camera) {
  const key = [...item.uses.map(i => inputs[i]), ...camera.box].join();
  if (fields.get(item)?.key !== key) {
    const at = given(inputs), cells = camera.box.slice(2).map(pixels => Math.max(8, Math.round(pixels / 5)));
    fields.set(item, {key, ...contour((a, b) => levels[item.value]([a, b], at, fixed)[0], view.low, view.high, ...cells)});
  }
  return fields.get(item);
}
function draw() {
  if (views.length && !frames[0]) return;
  const at = given(inputs), numbers = compute(at, fixed), curve = (which, t) => curves[which]([t], at, fixed);
  views.forEach((view, k) => {
    const pen = canvases[k].getContext("2d"), camera = cameraOf(view, k), items = [];
    for (const item of view.items) {
      if (item.kind === "level") { items.push({item, field: fieldOf(item, view, camera)}); continue; }
      const radius = numbers[item.radius];
      for (const points of runsOf(item, numbers, curve, trailOf)) if (item.kind === "line" || radius > 0) items.push({item, points, radius});
    }
    pen.clearRect(0, 0, ...frames[k]);
    (view.centre ? drawSpace : drawPlane)(pen, view, camera, items, look);
    view.handles.forEach(handle => {
      const point = numbers.slice(handle.at[0], handle.at[0] + handle.at[1]);
      if (point.every(Number.isFinite)) ring(pen, camera.place(point), held?.handle === handle, look);
    });
  });
  say(numbers);
}
function say(numbers) {
  shown.forEach(show => show());
  words.forEach(({text, values: [start, count], digits, when, columns}, k) => {
    lines[k].textContent = numbers[when] >= 0 ? filledIn(text, numbers.slice(start, start + count), digits, columns) : "";
  });
  byId("reason").textContent = reason;
  challenges.forEach(({task, done, lost}, k) => {
    const state = tally[k].met ? "met" : tally[k].lost ? "lost" : "open", [mark, text] = tasks[k].children;
    tasks[k].className = state;
    mark.textContent = {met: "✓", lost: "↺", open: "○"}[state];
    text.textContent = {met: done, lost: task + " " + lost, open: task}[state];
  });
  const met = tally.filter(one => one.met).length;
  byId("count").textContent = challenges.length ? "Challenges: " + met + " of " + challenges.length : "";
  clearTimeout(spoken);
  spoken = setTimeout(atRest, 700);
}
// What is spoken, once things are at rest.
function atRest() {
  const text = [...lines.map(line => line.textContent), reason, ...tasks.filter(t => t.className !== "open").map(t => t.children[1].textContent)].filter(Boolean).join("; ");
  canvases.forEach((canvas, k) => canvas.setAttribute("aria-label", facts.title + (views[k].centre ? ". Arrow keys turn the view. " : ". ") + text));
  if (!playing) byId("spoken").textContent = text;
}

// From state to state
function go(next, because = "") {
  const at = (numbers, k) => numbers[challenges[k].met], keeps = (now, last) => kept(given(now), given(last), fixed);
  tally = account(tally, inputs, next, steps, keeps, values => { const found = numbersAt(values); return challenges.map((_, k) => at(found, k)); });
  inputs = next;
  reason = because;
  draw();
}
const withRow = row => { const next = inputs.slice(); motion.places.forEach((place, i) => { next[place] = row[i]; }); return next; };
function show(now) {
  share = now;
  inputs = withRow(rowAt(motion.rows, share));
  reason = "";
  tally = tally.map((one, k) => ({...one, lost: one.lost || challenges[k].strict}));  // nobody steers here
  byId("time").value = share;
  byId("time").style.setProperty("--at", 100 * share + "%");
  byId("time").setAttribute("aria-valuetext", (share * motion.seconds).toFixed(1) + " s");
  draw();
}
function tick(stamp) {
  if (!playing) return;
  const pace = SPEEDS[speed] / motion.seconds / 1000;
  if (began === null || !seen) began = stamp - share / pace;
  if (seen) show((stamp - began) * pace % 1);
  requestAnimationFrame(tick);
}
const SPEEDS = [1, 2, 0.25, 0.5];
let speed = 0;
function run(on) {
  playing = on;
  began = null;
  byId("play").className = on ? "on" : "";
  byId("play").setAttribute("aria-label", (on ? "Pause: " : "Play: ") + (motion?.name || ""));
  if (on) requestAnimationFrame(tick);
}
function stop() { if (playing) run(false); }
byId("reset").onclick = () => {
  stop();
  [inputs, reason, share] = [home.slice(), "", 0];
  tally = tally.map(({met}) => ({met, lost: false}));
  angles.forEach((angle, k) => Object.assign(angle, {turn: views[k].turn, tilt: views[k].tilt}));
  if (motion) byId("time").value = 0;
  draw();
};
if (motion) {
  byId("player").hidden = false;
  byId("play").onclick = () => run(!playing);
  byId("time").oninput = () => { stop(); show(+byId("time").value); };
  byId("speed").onclick = () => { speed = (speed + 1) % SPEEDS.length; began = null; byId("speed").textContent = SPEEDS[speed] + "×"; };
  new IntersectionObserver(entries => { seen = entries[entries.length - 1].isIntersecting; }).observe(byId("main"));
}

// Pointers and keys
function listen(canvas, view, k) {
  const spot = e => { const box = canvas.getBoundingClientRect(); return [e.clientX - box.left, e.clientY - box.top]; };
  const grabbed = (x, y, room) => {
    const numbers = numbersAt(inputs), camera = cameraOf(view, k);
    const places = view.handles.map((handle, which) => {
      const point = numbers.slice(handle.at[0], handle.at[0] + handle.at[1]), [a, b, depth] = camera.place(point);
      return {handle, point, depth, which, away: Math.hypot(a - x, b - y), offset: [a - x, b - y]};
    });
    return places.filter(({away}) => away < room).sort((a, b) => a.away - b.away)[0];
  };
  const number = handle => views.flatMap(v => v.handles).indexOf(handle);
  canvas.addEventListener("touchstart", e => { const t = e.touches[0]; if (grabbed(...spot(t), 30)) e.preventDefault(); }, {passive: false});
  canvas.onpointerdown = e => {
    const [x, y] = spot(e), found = grabbed(x, y, e.pointerType === "touch" ? 30 : 20);
    if (!found && !view.centre) return;
    held = found ? {...found, k} : {turning: [e.clientX, e.clientY], k};
    canvas.setPointerCapture(e.pointerId);
    if (found) { stop(); draw(); }
  };
  canvas.onpointermove = e => {
    const [x, y] = spot(e);
    if (!held || held.k !== k) { canvas.style.cursor = grabbed(x, y, 20) ? "grab" : view.centre ? "move" : "default"; return; }
    if (held.turning) {
      const touch = e.pointerType === "touch";
      turn((e.clientX - held.turning[0]) * 0.5, touch ? 0 : (e.clientY - held.turning[1]) * 0.4);
      held.turning = [e.clientX, e.clientY];
      return;
    }
    const to = cameraOf(view, k).back([x + held.offset[0], y + held.offset[1]], held.depth), which = number(held.handle);
    drag(which, held, to);
  };
  canvas.onpointerup = canvas.onpointercancel = () => { if (held) { held = null; draw(); } };
  function turn(by, tilted) {
    angles[k].turn = (angles[k].turn + by) % 360;
    angles[k].tilt = Math.max(0, Math.min(90, angles[k].tilt + tilted));
    draw();
  }
  canvas.onkeydown = e => {
    const step = view.centre && {ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -5], ArrowDown: [0, 5]}[e.key];
    if (step) { turn(...step); e.preventDefault(); }
  };
}
function drag(which, grip, to) {
  const {handle} = grip, at = given(inputs), solve = point => handles[which](point, at, fixed);
  const {inputs: next, share: way, limit} = dragged(solve, handle.moves, controls, inputs, grip.point, to);
  grip.point = grip.point.map((v, i) => v + way * (to[i] - v));
  const numbers = solve(to).slice(handle.moves.length), because = [];
  let place = 0;
  for (const {text, digits, count} of handle.reasons) {
    if (numbers[place] >= 0) because.push(filledIn(text, numbers.slice(place + 1, place + 1 + count), digits));
    place += 1 + count;
  }
  if (limit && !because.length) because.push(controls[limit[0]].name + " is at its limit, " + numeral(limit[1], 2).replace(/\.?0+$/, "") + controls[limit[0]].unit.replace(/^(?=\w)/, " ") + ".");
  go(next, because.join(" "));
}

// The page around: its colours, and how high the frame has to be
function dress() {
  let around = null, paper = null;
  try { around = frameElement; } catch { /* a page of another origin */ }
  for (let node = around?.parentElement; node && !paper; node = node.parentElement) {
    const colour = getComputedStyle(node).backgroundColor;
    if (!/^(transparent|rgba\(.*, 0\))$/.test(colour)) paper = colour;
  }
  const parts = paper?.match(/[\d.]+/g)?.map(Number);
  const dark = parts ? 0.3 * parts[0] + 0.6 * parts[1] + 0.1 * parts[2] < 128 : matchMedia("(prefers-color-scheme: dark)").matches;
  look = LOOKS[+dark];
  const style = document.documentElement.style;
  style.colorScheme = dark ? "dark" : "light";
  Object.entries({...look, paper: paper || (dark ? "#131416" : "#ffffff")}).forEach(([name, value]) => style.setProperty("--" + name, value));
  draw();
}
function tellHeight() {
  try { if (frameElement) frameElement.style.height = Math.ceil(byId("main").getBoundingClientRect().height) + "px"; } catch { /* as above */ }
}
try {
  const attributes = {attributes: true, attributeFilter: ["class", "style", "data-theme", "data-jp-theme-light"]};
  const watch = new MutationObserver(() => { dress(); setTimeout(dress, 300); });
  [parent.document.documentElement, parent.document.body].forEach(node => watch.observe(node, attributes));
} catch { /* as above */ }
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", dress);
new ResizeObserver(fit).observe(byId("views"));
new ResizeObserver(tellHeight).observe(byId("main"));
dress();
fit();
if (motion && !challenges.length && !calm.matches) run(true); else if (motion) run(false);
