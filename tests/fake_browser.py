"""A page's own script, run in V8 without a browser: what it draws on its canvases is recorded.

    page = FakePage(source)            the text of an HTML page, or what IPython shows it in
    page.slide("θ1", 30)               moves a slider, as a reader would; "time" by its id works, too
    page.frames(0, 500, 1000)          lets requestAnimationFrame run at these milliseconds
    page.drawings[0].strokes           polylines on the first canvas since it was last cleared

Only what the course's pages use is there. Anything else a script asks for is an error.
"""

import html
import json
import re
from dataclasses import dataclass
from typing import Any

import numpy as np
from py_mini_racer import MiniRacer

SCRIPT = r"""
"use strict";
const elements = {}, created = [], canvases = [], observers = [];
let waiting = [];

function recorder() {
  const calls = [], state = {};
  return new Proxy({calls}, {
    get: (target, name) => name === "calls" ? calls : name in state ? state[name] : (...args) => {
      if (name === "clearRect") calls.length = 0;
      calls.push({name, args, state: {...state}});
    },
    set: (target, name, value) => { state[name] = value; return true; },
  });
}

function element(tag, attributes = {}) {
  const children = [], listeners = {};
  const made = {
    tag, children, listeners, style: {}, attributes, textContent: "", width: 0, height: 0,
    append: (...more) => children.push(...more),
    insertBefore: (child, before) => children.push(child),
    setAttribute: (name, value) => { attributes[name] = value; },
    addEventListener: (name, listener) => { listeners[name] = listener; },
    setPointerCapture: () => {},
    getContext: () => pen,
    ...attributes,
  };
  const pen = tag === "canvas" ? recorder() : null;
  if (pen) canvases.push(made);
  created.push(made);
  return made;
}

const document = {
  getElementById: id => { if (!(id in elements)) throw new Error("no element " + id); return elements[id]; },
  createElement: tag => element(tag),
};
const window = {devicePixelRatio: 1};
const requestAnimationFrame = callback => waiting.push(callback);
class IntersectionObserver {
  constructor(callback) { observers.push(callback); }
  observe() {}
}

function frame(stamp) { const now = waiting; waiting = []; now.forEach(callback => callback(stamp)); }
function seen(isIntersecting) { observers.forEach(callback => callback([{isIntersecting}])); }
function labelled(name) {
  const label = created.find(e => e.tag === "label" && e.children[0] === name);
  return label ? label.children[1] : document.getElementById(name);
}
function slide(name, value) {
  const input = labelled(name);
  input.value = Math.min(+input.max, Math.max(+input.min, value));
  input.oninput();
}
function text() { return created.filter(e => e.textContent).map(e => e.textContent); }
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
    """One canvas: strokes; filled discs and squares as (x, y, size, colour); words as (text, x, y, colour)."""

    strokes: list[Stroke]
    discs: list[tuple]
    squares: list[tuple]
    words: list[tuple]

    def of(self, colour: str, width: float) -> list[np.ndarray]:
        """Points of the strokes of one colour and width."""
        return [stroke.points for stroke in self.strokes if (stroke.colour, stroke.width) == (colour, width)]


class FakePage:
    """A page whose script has run."""

    def __init__(self, source: str):
        self.source = page_in(source)
        self.engine = MiniRacer()
        self.engine.eval(SCRIPT)
        for tag, attributes in re.findall(r"<(\w+) ([^>]*\bid=[^>]*)>", self.source.split("<script>")[0]):
            found = dict(re.findall(r'([\w-]+)="([^"]*)"', attributes))
            self.engine.eval(f"elements[{found['id']!r}] = element({tag!r}, {json.dumps(found)})")
        (script,) = re.findall(r"<script>(.*?)</script>", self.source, re.DOTALL)
        self.engine.eval(f"(() => {{{script}}})()")

    def run(self, expression: str) -> Any:
        """The value of a JavaScript expression."""
        return json.loads(self.engine.eval(f"JSON.stringify({expression}) ?? 'null'"))

    def slide(self, name: str, value: float) -> None:
        self.run(f"slide({json.dumps(name)}, {value})")

    def fire(self, name: str, event: str, **facts: float) -> None:
        """An event on the element ``name``: ``onclick``, ``onpointerdown`` ..."""
        self.run(f"document.getElementById({json.dumps(name)}).{event}({json.dumps(facts)})")

    def frames(self, *stamps: float) -> None:
        for stamp in stamps:
            self.run(f"frame({stamp})")

    @property
    def text(self) -> list[str]:
        """The text of every element that has some."""
        return self.run("text()")

    @property
    def drawings(self) -> list[Drawing]:
        return [_drawing(calls) for calls in self.run("canvases.map(canvas => canvas.getContext().calls)")]


def page_in(shown: str) -> str:
    """The page within an iframe's srcdoc, or the page itself."""
    found = re.search('srcdoc="([^"]*)"', shown)
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
            path.append(args)
        elif name == "arc":
            disc = args[:3]
        elif name == "setLineDash":
            dash = args[0]
        elif name == "stroke":
            drawing.strokes.append(Stroke(np.array(path), state["strokeStyle"], state["lineWidth"], bool(dash)))
        elif name == "fill" and disc:
            drawing.discs.append((*disc, state["fillStyle"]))
        elif name == "fillRect":
            drawing.squares.append((args[0] + args[2] / 2, args[1] + args[3] / 2, args[2], state["fillStyle"]))
        elif name == "fillText":
            drawing.words.append((*args, state["fillStyle"]))
    return drawing
