"""A formula of SymPy as a page that draws without a kernel: compiled to JavaScript, and moved by sliders."""

import html
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import sympy as sp
from IPython.display import HTML

from ..errors import InputError
from ..reading import formulas

PAGE = Path(__file__).with_name("script.html").read_text(encoding="utf-8")
KEPT = (
    "await|break|case|catch|class|const|continue|debugger|default|delete|do|else|enum|export|extends|false|finally"
    "|for|function|if|import|in|instanceof|let|new|null|return|static|super|switch|this|throw|true|try|typeof|var"
    "|void|while|with|yield|Math|part\\d+"  # by JavaScript, and by what is written here
)
NAME = re.compile(rf"(?!(?:{KEPT})$)[A-Za-z]\w*", re.ASCII)
ALWAYS = sp.Integer(1)
DIGITS = 9  # significant ones of each number in a page; more would differ between processors


@dataclass(frozen=True)
class Slider:
    """Sets ``symbol`` between ``low`` and ``high``; in the unit "°" all but the formula is in degrees."""

    symbol: sp.Symbol
    name: str
    low: float
    high: float
    home: float
    step: float = 1
    unit: str = "°"


@dataclass(frozen=True)
class Line:
    """A polyline through ``points``, expressions of shape (n, 2), shown ``when`` a number is not negative."""

    points: sp.Matrix
    colour: str
    width: float = 2
    dots: float = 0  # radius in pixels
    dashed: bool = False
    label: str = ""  # beside the first point
    when: sp.Expr = ALWAYS


@dataclass(frozen=True)
class View:
    """A drawing with equal scales: names of its axes, its corners, and the distance between grid lines."""

    x: str
    y: str
    low: tuple[float, float]
    high: tuple[float, float]
    tick: float
    lines: Sequence[Line]


@dataclass(frozen=True)
class Words:
    """A line of text in which each {} is one of ``values``, shown ``when`` a number is not negative."""

    text: str
    values: Sequence[sp.Expr] = ()
    digits: int = 3
    when: sp.Expr = ALWAYS


def javascript(entries: Sequence[sp.Expr], *vectors: Sequence[sp.Symbol]) -> str:
    """The source of a JavaScript function of one array per vector of symbols, which returns an array of numbers.

    The counterpart of ``symbolic.numeric``, for one point at a time. Common parts are computed once. Raises
    InputError for symbols that no vector lists, and for names that JavaScript does not allow.
    """
    symbols = [symbol for vector in vectors for symbol in vector]
    matrix = formulas(entries)
    if names := sorted(map(str, matrix.free_symbols.difference(symbols))):
        raise InputError(f"The expressions also hold {', '.join(names)}, which no vector lists.")
    if unfit := [str(s) for s in symbols if not NAME.fullmatch(str(s))]:
        raise InputError(f"{', '.join(unfit)} cannot be the name of a variable in JavaScript.")
    matrix = matrix.xreplace({number: sp.Float(number, DIGITS) for number in matrix.atoms(sp.Float)})
    parts, (results, *_) = sp.cse([matrix], symbols=sp.numbered_symbols("part", real=True))
    steps = "".join(f"const {name} = {sp.jscode(part)}; " for name, part in parts)
    arguments = ", ".join(f"[{', '.join(map(str, vector))}]" for vector in vectors)
    return f"({arguments}) => {{ {steps}return [{', '.join(map(sp.jscode, results))}]; }}"


def page(
    views: Sequence[View],
    sliders: Sequence[Slider],
    words: Sequence[Words],
    fixed: Mapping[sp.Symbol, float],
    title: str,
    height: int,
) -> HTML:
    """Views that follow the sliders, and words below them; it asks for nothing but itself.

    ``fixed`` holds the values of all other symbols, ``title`` is what a reader hears who cannot see it, ``height``
    counts pixels. The same input gives the same page, to the letter.
    """
    if isinstance(height, bool) or not isinstance(height, int) or height < 1:
        raise InputError(f"The height is a whole number of pixels; {height!r} was given.")
    entries: list[sp.Expr] = []

    def place(numbers: Sequence[sp.Expr]) -> list[int]:
        """Where the numbers stand in what the compiled function returns: the first, and how many."""
        entries.extend(formulas(numbers) if len(numbers) else ())
        return [len(entries) - len(numbers), len(numbers)]

    facts = {
        "views": [vars(view) | {"lines": [_line(line, place) for line in view.lines]} for view in views],
        "sliders": [vars(slider) | {"symbol": str(slider.symbol)} for slider in sliders],
        "words": [vars(w) | {"values": place(w.values), "when": place([w.when])[0]} for w in words],
        "fixed": [float(value) for value in fixed.values()],
    }
    compute = javascript(entries, [slider.symbol for slider in sliders], list(fixed))
    facts = json.loads(json.dumps(facts), parse_float=lambda number: float(f"{float(number):.{DIGITS}g}"))
    data = json.dumps(facts, ensure_ascii=False).replace("<", "\\u003c")  # no text ends the script
    filled = {"FACTS": data, "COMPUTE": compute}
    text = re.sub("|".join(filled), lambda name: filled[name[0]], PAGE)  # in one pass: a text may be a name
    return HTML(
        f'<div><iframe srcdoc="{html.escape(text)}" title="{html.escape(title)}" '
        f'style="width:100%;max-width:700px;height:{height}px;border:0"></iframe></div>'
    )


def _line(line: Line, place) -> dict:
    return vars(line) | {"points": place(list(line.points)), "when": place([line.when])[0]}
