"""A stage's own scripts, run in V8 without a browser: what they draw on their canvases is recorded.

    page = FakePage(shown)               what IPython shows, or its HTML
    page.slide("θ₁", 30)                 moves a slider, as a reader would; "time" by its id works, too
    page.choose("elbow", "down")         takes one of a few options
    page.drag(0, (100, 80), (140, 90))   a pointer on the first canvas, pixels
    page.frames(0, 500, 1000)            lets requestAnimationFrame run at these milliseconds
    page.drawings[0].strokes             polylines on the first canvas since it was last cleared
    page.run("inputs")                   the value of any expression, also of the page's own names

Only what a stage uses is there. Anything else a script asks for is an error.
"""

import html
import json
import re
from dataclasses import dataclass
from typing import Any

import numpy as np
from py_mini_racer import MiniRacer

BROWSER = r"""
"use strict";
const made = [], canvasesMade = [], observed = {}, timers = [], media = {}, byName = {};
let waiting = [], innerWidth = 800;

function recorder() {
  const calls = [], state = {};
  const gradient = colours => ({colours, addColorStop: (at, colour) => colours.push(colour)});
  return new Proxy({calls}, {
    get: (target, name) => name === "calls" ? calls : name in state ? state[name] : (...args) => {
      if (name === "clearRect") calls.length = 0;
      const numbers = args.flat(3).filter(v => typeof v === "number");
      if (!numbers.every(Number.isFinite)) throw new Error("a number is missing in " + name);
      calls.push({name, args, state: {...state}});
      return name.startsWith("create") ? gradient([]) : undefined;
    },
    set: (target, name, value) => { state[name] = value; return true; },
  });
}

function makeElement(tag, attributes = {}) {
  const pen = tag === "canvas" ? recorder() : null;
  const one = {
    tag, children: [], listeners: {}, attributes, textContent: "", className: "", value: "", hidden: false,
    parentNode: null, parentElement: null, clientWidth: 600, background: "rgba(0, 0, 0, 0)",
    style: {setProperty(name, value) { this[name] = value; }},
    append(...more) {
      more.filter(child => child.tag).forEach(child => { child.parentNode = child.parentElement = one; });
      one.children.push(...more);
    },
    appendChild(child) { one.append(child); return child; },
    setAttribute: (name, value) => { attributes[name] = value; },
    addEventListener: (name, listener) => { one.listeners[name] = listener; },
    setPointerCapture: () => {},
    getBoundingClientRect: () => ({left: 0, top: 0, height: 345.2}),
    getContext: () => pen,
  };
  if (pen) canvasesMade.push(one);
  made.push(one);
  return Object.assign(one, attributes);
}

const document = {
  activeElement: null, documentElement: makeElement("html"),
  getElementById: id => { if (!(id in byName)) throw new Error("no element " + id); return byName[id]; },
  createElement: tag => makeElement(tag),
};
const around = makeElement("body"), frameElement = makeElement("iframe");
around.append(frameElement);
const parent = {document: {documentElement: makeElement("html"), body: around}};
const getComputedStyle = node => ({backgroundColor: node.background});
const window = {devicePixelRatio: 1};
const requestAnimationFrame = callback => waiting.push(callback);
globalThis.setTimeout = (callback, delay) => timers.push({callback, delay});
globalThis.clearTimeout = id => { if (id) delete timers[id - 1]; };
const matchMedia = query => media[query] ??= {matches: false, addEventListener: () => {}};
class Observer {
  constructor(callback) { this.callback = callback; }
  observe(node) { (observed[this.constructor.name] ??= []).push(this.callback); }
}
class IntersectionObserver extends Observer {}
class ResizeObserver extends Observer {}
class MutationObserver extends Observer {}

function frame(stamp) { const now = waiting; waiting = []; now.forEach(callback => callback(stamp)); }
function atRestNow() { timers.splice(0).filter(Boolean).forEach(({callback}) => callback()); }
function control(name) {
  const label = made.find(e => e.tag === "label" && e.children[0]?.textContent === name);
  return label ? label.children[1] : document.getElementById(name);
}
function slide(name, value) {
  const input = control(name);
  input.value = Math.min(+input.max, Math.max(+input.min, value));
  input.oninput();
}
function choose(name, option) {
  const field = made.find(e => e.tag === "fieldset" && e.children[0].textContent === name);
  field.children[1].children.find(e => e.children[1]?.textContent === option).children[0].oninput();
}
function text() { return made.filter(e => e.textContent).map(e => e.textContent); }
"""


@dataclass
class Stroke:
    """A polyline (n, 2), in pixels."""

    points: np.ndarray
    colour: str
    width: float
    dashed: bool


@dataclass
class Drawing:
    """One canvas: strokes; filled shapes (n, 2) and their colour; discs (x, y, radius); words (text, x, y)."""

    strokes: list[Stroke]
    shapes: list[tuple[np.ndarray, str]]
    discs: list[tuple]
    words: list[tuple]


class FakePage:
    """A page whose scripts have run. ``before`` is run first: a dark page around, say."""

    def __init__(self, shown: Any, before: str = ""):
        self.source = page_in(getattr(shown, "data", shown))
        self.engine = MiniRacer()
        self.engine.eval(BROWSER + before)
        body, *scripts = re.split(r"<script>", self.source)
        for tag, attributes in re.findall(r"<(\w+) ([^>]*\bid=[^>]*)>", body):
            found = dict(re.findall(r'([\w-]+)="([^"]*)"', attributes))
            self.engine.eval(f"byName[{found['id']!r}] = makeElement({tag!r}, {json.dumps(found)})")
        for script in scripts:
            self.engine.eval(script.partition("</script>")[0])

    def run(self, expression: str) -> Any:
        """The value of a JavaScript expression; None stands for NaN."""
        return json.loads(self.engine.eval(f"JSON.stringify({expression}) ?? 'null'"))

    @property
    def facts(self) -> dict:
        return self.run("facts")

    def slide(self, name: str, value: float) -> None:
        self.run(f"slide({json.dumps(name)}, {value})")

    def choose(self, name: str, option: str) -> None:
        self.run(f"choose({json.dumps(name)}, {json.dumps(option)})")

    def click(self, name: str) -> None:
        self.run(f"document.getElementById({json.dumps(name)}).onclick()")

    def press(self, key: str, view: int = 0) -> None:
        self.run(f"canvasesMade[{view}].onkeydown({{key: {json.dumps(key)}, preventDefault() {{}}}})")

    def point(self, event: str, at: tuple, view: int = 0, kind: str = "mouse") -> None:
        facts = {"clientX": float(at[0]), "clientY": float(at[1]), "pointerId": 1, "pointerType": kind}
        self.run(f"canvasesMade[{view}].onpointer{event}({json.dumps(facts)})")

    def drag(self, view: int, *places: tuple, kind: str = "mouse") -> None:
        self.point("down", places[0], view, kind)
        for place in places[1:]:
            self.point("move", place, view, kind)
        self.point("up", places[-1], view, kind)

    def place(self, point: list, view: int = 0) -> np.ndarray:
        """Where a point of a view is on its canvas, in pixels."""
        return np.array(self.run(f"cameraOf(views[{view}], {view}).place({list(map(float, point))})")[:2])

    def lead(self, to: list, view: int = 0, handle: int = 0, kind: str = "mouse") -> None:
        """Drag a handle to a point of its view."""
        start, count = self.run(f"views[{view}].handles[{handle}].at")
        at = self.run("numbersAt(inputs)")[start : start + count]
        self.drag(view, self.place(at, view), self.place(to, view), kind=kind)

    def frames(self, *stamps: float) -> None:
        for stamp in stamps:
            self.run(f"frame({stamp})")

    def numbers(self, inputs: np.ndarray) -> np.ndarray:
        """What the page computes for inputs (n, k), in radians: (n, m)."""
        found = self.run(f"{json.dumps(np.asarray(inputs).tolist())}.map(row => compute(row, fixed))")
        return np.array(found, dtype=float)

    @property
    def text(self) -> list[str]:
        """The text of every element that has some."""
        return self.run("text()")

    @property
    def drawings(self) -> list[Drawing]:
        return [_drawing(calls) for calls in self.run("canvasesMade.map(canvas => canvas.getContext().calls)")]


def page_in(shown: str) -> str:
    """The page within an iframe's srcdoc, or the page itself."""
    found = re.search("srcdoc='([^']*)'", shown)
    return html.unescape(found[1]) if found else shown


def compute(function: str, inputs: np.ndarray, *fixed: list) -> np.ndarray:
    """What a JavaScript function gives for each row of inputs; null stands for NaN."""
    rows, more = json.dumps(inputs.tolist()), json.dumps(fixed)
    program = f"const f = {function}; JSON.stringify({rows}.map(row => f(row, ...{more})))"
    return np.array(json.loads(MiniRacer().eval(program)), dtype=float)


def _drawing(calls: list[dict]) -> Drawing:
    drawing, path, disc, dash = Drawing([], [], [], []), [], None, []
    for call in calls:
        name, args, state = call["name"], call["args"], call["state"]
        if name == "beginPath":
            path, disc = [], None
        elif name in ("moveTo", "lineTo"):
            path.append(args[:2])
        elif name == "arc":
            disc = args[:3]
            path.append(args[:2])
        elif name == "setLineDash":
            dash = args[0]
        elif name == "stroke":
            drawing.strokes.append(Stroke(np.array(path), state["strokeStyle"], state["lineWidth"], bool(dash)))
        elif name == "fill":
            fill = state["fillStyle"]
            colour = fill if isinstance(fill, str) else fill["colours"][0]
            drawing.shapes.append((np.array(path), colour))
            if disc and len(path) == 1:
                drawing.discs.append((*disc, colour))
        elif name == "fillText":
            drawing.words.append((*args, state["fillStyle"]))
    return drawing
