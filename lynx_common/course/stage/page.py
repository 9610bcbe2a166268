"""A stage as one page that asks for nothing but itself: its data, its formulas as JavaScript, its scripts."""

import html
import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from re import sub

import numpy as np
import sympy as sp
from IPython.display import HTML

from ...drawing import COLOURS
from ...errors import InputError
from ...reading import formulas, number, real
from .parts import (
    ALWAYS,
    Body,
    Challenge,
    Choice,
    Handle,
    Level,
    Line,
    Motion,
    Plane,
    Slider,
    Space,
    Words,
    before,
)
from .script import DIGITS, javascript

AT_ONCE = 1e9  # the step of what has none between its values
FOLDER = Path(__file__).parent
# One colour for one meaning, as in the figures, and three of the robots' own; on a light page and on a dark one.
LIGHT = COLOURS | {"steel": "#62738a", "joint": "#3a4450", "pale": "#b4bac4"}
DARK = dict(
    zip(
        LIGHT,
        ("#a9b1bd", "#ff7f3a", "#22c493", "#4aa8ee", "#e08fbd", "#6fc4f2", "#f5b62e", "#7c828b")
        + ("#8a9cb5", "#5d6a7b", "#50565f"),
        strict=True,
    )
)


def stage(
    views: Sequence[Plane | Space],
    controls: Sequence[Slider | Choice],
    words: Sequence[Words],
    fixed: Mapping[sp.Symbol, float],
    title: str,
    motion: Motion | None = None,
    challenges: Sequence[Challenge] = (),
    let: Mapping[sp.Symbol, sp.Expr] | None = None,
) -> HTML:
    """Views that follow the controls, the handles and the motion; words and challenges below.

    ``let`` gives names to intermediate results, each in terms of those before it; ``fixed`` holds the values of
    all other symbols; ``title`` is what a reader hears who cannot see it. The same input gives the same page, to
    the letter. Raises InputError for a colour that the page does not have, a motion that is not a table of finite
    numbers, and symbols whose value nothing gives.
    """
    writer = _Writer(controls, motion, fixed, let or {})
    facts = {
        "title": title,
        "views": [writer.view(view) for view in views],
        "controls": [vars(control) | {"symbol": str(control.symbol)} for control in controls],
        "home": writer.home,
        "steps": [getattr(control, "step", AT_ONCE) for control in controls] + [AT_ONCE] * writer.hidden,
        "words": [writer.words(line) for line in words],
        "challenges": [writer.challenge(one) for one in challenges],
        "motion": writer.motion,
        "fixed": [float(value) for value in fixed.values()],
        "colours": [LIGHT, DARK],
    }
    return HTML(_framed(_page(facts, writer.script()), title))


def _page(facts: dict, formulas_: str) -> str:
    """The whole page, its numbers with so many digits as all processors agree on."""
    facts = json.loads(json.dumps(facts), parse_float=lambda number: float(f"{float(number):.{DIGITS}g}"))
    data = json.dumps(facts, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")  # ends no script
    filled = {name.upper(): _bare(FOLDER / f"{name}.js") for name in ("geometry", "drawing", "stage")}
    filled |= {"FACTS": data, "FORMULAS": formulas_}
    page = (FOLDER / "stage.html").read_text(encoding="utf-8")
    return sub("|".join(filled), lambda name: filled[name[0]], page)  # in one pass: a text may be a name


def _framed(page: str, title: str) -> str:
    """An iframe that holds the page itself, in apostrophes: half as long as with every quote escaped."""
    within = page.replace("&", "&amp;").replace("'", "&#39;")
    return (
        f"<div><iframe srcdoc='{within}' title=\"{html.escape(title)}\" "
        'style="width:100%;height:640px;border:0;display:block"></iframe></div>'
    )


class _Writer:
    """Turns parts into data, and gathers their formulas: each number has its place in one compiled function."""

    def __init__(self, controls: Sequence, motion: Motion | None, fixed: Mapping, let: Mapping):
        self.inputs = [control.symbol for control in controls]
        self.home = [control.home for control in controls]
        self.controls = list(self.inputs)
        self.fixed, self.let, self.motion = list(fixed), let, None
        if motion:
            self.motion = self._table(motion, controls)
        self.hidden = len(self.inputs) - len(controls)
        self.numbers: list[sp.Expr] = []
        self.kept: list[sp.Expr] = []
        self.curves: list[str] = []
        self.levels: list[str] = []
        self.handles: list[str] = []

    def _table(self, motion: Motion, controls: Sequence) -> dict:
        """The motion's columns, in the units of the sliders; symbols that have no slider become inputs, too."""
        columns = {symbol: real(column, f"the motion of {symbol}") for symbol, column in motion.values.items()}
        lengths = {column.shape for column in columns.values()}
        if len(lengths) != 1 or len(next(iter(lengths))) != 1 or not all(np.isfinite(list(columns.values())).flat):
            raise InputError("A motion is a table of finite numbers: for each symbol a column, all equally long.")
        seconds = number(motion.seconds, "duration in seconds", above=0)
        units = {control.symbol: getattr(control, "unit", "") for control in controls}
        rows = [np.rad2deg(c) if units.get(symbol) == "°" else c for symbol, c in columns.items()]
        for symbol, row in zip(columns, rows, strict=True):
            if symbol not in self.inputs:
                self.inputs.append(symbol)
                self.home.append(float(row[0]))
        places = [self.inputs.index(symbol) for symbol in columns]
        rounded = [np.round(row, 4) + 0.0 for row in rows]
        table = [row.tolist() for row in np.transpose(rounded)]
        return {"name": motion.name, "seconds": seconds, "places": places, "rows": table}

    def place(self, numbers: Sequence[sp.Expr]) -> list[int]:
        """Where the numbers stand in what the compiled function returns: the first, and how many."""
        self.numbers.extend(formulas(numbers) if len(numbers) else ())
        return [len(self.numbers) - len(numbers), len(numbers)]

    def view(self, view: Plane | Space) -> dict:
        kinds: dict[type, Callable] = {Line: self.line, Body: self.body, Level: self.level}
        items = [_said(kinds[type(item)](item)) for item in view.items]
        handles = [self.handle(handle) for handle in view.handles]
        return vars(view) | {"items": items, "handles": handles}

    def line(self, line: Line) -> dict:
        given = {"when": self.place([line.when])[0], "colour": _known(line.colour), "size": line.points.shape[1]}
        if line.along:
            symbol, *span = line.along
            self.curves.append(self.compile(list(line.points), [symbol]))
            return vars(line) | given | {"kind": "line", "points": [], "along": [len(self.curves) - 1, *span]}
        return vars(line) | given | {"kind": "line", "points": self.place(list(line.points))}

    def body(self, body: Body) -> dict:
        numbers = {"points": self.place(list(body.points)), "radius": self.place([body.radius])[0]}
        when = {"when": self.place([body.when])[0], "size": body.points.shape[1]}
        return vars(body) | numbers | when | {"kind": "body", "colour": _known(body.colour)}

    def level(self, level: Level) -> dict:
        used = self.inputs_of(level.value).difference(level.over)
        uses = [place for place, symbol in enumerate(self.inputs) if symbol in used]
        self.levels.append(self.compile([level.value], level.over))
        kind = {"kind": "level", "value": len(self.levels) - 1, "uses": uses, "over": []}
        return vars(level) | kind | {"colour": _known(level.colour)}

    def words(self, words: Words) -> dict:
        return vars(words) | {"values": self.place(words.values), "when": self.place([words.when])[0]}

    def handle(self, handle: Handle) -> dict:
        moved = [self.controls.index(symbol) for symbol in handle.moves]
        numbers = [*handle.moves.values(), *(number for r in handle.reasons for number in (r.when, *r.values))]
        self.handles.append(self.compile(numbers, handle.target))
        reasons = [{"text": r.text, "digits": r.digits, "count": len(r.values)} for r in handle.reasons]
        return {"at": self.place(list(handle.at)), "moves": moved, "reasons": reasons}

    def challenge(self, challenge: Challenge) -> dict:
        self.kept.append(challenge.keep)
        texts = {"task": challenge.task, "done": challenge.done, "lost": challenge.lost}
        return texts | {"met": self.place([challenge.met])[0], "strict": challenge.keep != ALWAYS}

    def compile(self, numbers: Sequence[sp.Expr], first: Sequence[sp.Symbol]) -> str:
        """A function of ``first``, the inputs and what is fixed; ``first`` may hide inputs of the same name."""
        unique = [symbol if symbol not in first else sp.Symbol(f"hidden_{symbol}") for symbol in self.inputs]
        return javascript(numbers, first, unique, self.fixed, let=self.let)

    def inputs_of(self, expr: sp.Expr) -> set[sp.Symbol]:
        """What an expression depends on, also by way of the intermediate results."""
        used = expr.free_symbols
        for symbol, value in reversed(list(self.let.items())):
            used = used | value.free_symbols if symbol in used else used
        return used

    def script(self) -> str:
        """All compiled functions, by name."""
        earlier = {symbol: before(symbol) for symbol in (*self.inputs, *self.let)}
        let = dict(self.let) | {before(symbol): expr.xreplace(earlier) for symbol, expr in self.let.items()}
        then = [before(symbol) for symbol in self.inputs]
        named: dict[str, str | list[str]] = {
            "compute": javascript(self.numbers, self.inputs, self.fixed, let=self.let),
            "kept": javascript(self.kept, self.inputs, then, self.fixed, let=let),
            "curves": self.curves,
            "levels": self.levels,
            "handles": self.handles,
        }
        texts = (f"[{', '.join(code)}]" if isinstance(code, list) else code for code in named.values())
        return "".join(f"const {name} = {text};\n" for name, text in zip(named, texts, strict=True))


def _said(item: dict) -> dict:
    """Without what is not so: a page takes what is missing for no."""
    return {name: value for name, value in item.items() if not (value is None or value is False or value == "")}


def _bare(file: Path) -> str:
    """A script without its indents and comments, which only its readers need."""
    return sub(r"(?m)^\s+|^//.*\n|  // .*$", "", file.read_text("utf-8"))


def _known(colour: str) -> str:
    if colour not in LIGHT:
        raise InputError(f"The colours of a stage are {', '.join(LIGHT)}; {colour!r} was given.")
    return colour
