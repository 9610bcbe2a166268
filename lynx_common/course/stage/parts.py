"""What a stage is made of: views and what is in them, controls, words, a motion, challenges; all plain data."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import sympy as sp

ALWAYS = sp.Integer(1)


@dataclass(frozen=True)
class Slider:
    """Sets ``symbol`` between ``low`` and ``high``; in the unit "°" all but the formulas is in degrees."""

    symbol: sp.Symbol
    name: str
    low: float
    high: float
    home: float
    step: float = 1
    unit: str = "°"


@dataclass(frozen=True)
class Choice:
    """Sets ``symbol`` to one of a few numbers, each under a name: {"left": 1, "right": -1}."""

    symbol: sp.Symbol
    name: str
    options: Mapping[str, float]
    home: float


@dataclass(frozen=True)
class Line:
    """A line through ``points``, (n, 2) in a plane and (n, 3) in space, shown ``when`` a number is not negative.

    A curve is one point, (1, 2) or (1, 3), that depends on a parameter: ``along`` = (symbol, first, last, pieces).
    With ``trail`` the line is the way of its one point in the motion. Without width it shows only its dots.
    """

    points: sp.Matrix
    colour: str
    width: float = 2
    dots: float = 0  # radius in pixels
    dashed: bool = False
    filled: bool = False
    label: str = ""  # beside the first point
    when: sp.Expr = ALWAYS
    along: tuple[sp.Symbol, float, float, int] | None = None
    trail: bool = False


@dataclass(frozen=True)
class Body:
    """A round rod about the line through ``points``; a ball, where that is one point.

    ``radius`` is an expression. With ``flat`` ends it is a cylinder, such as a joint about its axis; with
    ``clear`` one sees through it.
    """

    points: sp.Matrix
    radius: sp.Expr
    colour: str
    flat: bool = False
    clear: bool = False
    when: sp.Expr = ALWAYS


@dataclass(frozen=True)
class Level:
    """In a plane, the region where ``value`` is not negative, and its border; of the two symbols of the axes.

    Where ``value`` is NaN there is neither. ``shade`` is the opacity of the region, ``width`` that of its border.
    """

    value: sp.Expr
    over: tuple[sp.Symbol, sp.Symbol]
    colour: str
    shade: float = 0.2
    width: float = 1.5
    dashed: bool = False


Item = Line | Body | Level  # what a view shows
Control = Slider | Choice


@dataclass(frozen=True)
class Words:
    """A line of text in which each {} is one of ``values``, shown ``when`` a number is not negative."""

    text: str
    values: Sequence[sp.Expr] = ()
    digits: int = 3
    when: sp.Expr = ALWAYS
    columns: bool = False  # of equal width, as in a matrix


@dataclass(frozen=True)
class Handle:
    """A point of a view to be grabbed: the sliders follow, so that it goes where the finger is.

    ``moves`` gives sliders new values, in the symbols ``target`` of the place of the finger; where one is NaN or
    beyond the slider's range the handle stops, and where it stops or lags, those of ``reasons`` are shown whose
    time it is. ``at`` is a point, (1, 2) or (1, 3); in space it moves in the plane square to the line of sight.
    """

    at: sp.Matrix
    target: Sequence[sp.Symbol]
    moves: Mapping[sp.Symbol, sp.Expr]
    reasons: Sequence[Words] = ()


@dataclass(frozen=True)
class Plane:
    """A drawing with equal scales: names of its axes, its corners, and the distance between grid lines."""

    x: str
    y: str
    low: tuple[float, float]
    high: tuple[float, float]
    tick: float
    items: Sequence[Item]
    handles: Sequence[Handle] = ()


@dataclass(frozen=True)
class Space:
    """A view in space that can be turned, over a floor at z = 0 with a grid.

    It looks at ``centre`` and holds all within ``radius`` of it. ``turn`` and ``tilt`` are in degrees: 0 and 0 has
    x to the right and z up, 0 and 90 is seen from above.
    """

    centre: tuple[float, float, float]
    radius: float
    tick: float
    items: Sequence[Item]
    handles: Sequence[Handle] = ()
    title: str = ""
    turn: float = -40
    tilt: float = 24


@dataclass(frozen=True)
class Motion:
    """A table of values, one column a symbol, run through in ``seconds``; between two rows it is straight.

    The symbols are those of sliders, or others, which only the motion sets.
    """

    values: Mapping[sp.Symbol, np.ndarray] = field(repr=False)
    seconds: float
    name: str = "motion"


@dataclass(frozen=True)
class Challenge:
    """Met where ``met`` is not negative, if ``keep`` has not been negative on the way since the start.

    ``keep`` may hold ``before(symbol)``, the value of an input one step of its slider, or less, ago.
    """

    task: str
    done: str
    met: sp.Expr
    keep: sp.Expr = ALWAYS
    lost: str = "Not this way: reset, and try again."


def before(symbol: sp.Symbol) -> sp.Symbol:
    """What ``symbol`` was a moment ago; for ``keep``."""
    return sp.Symbol(f"{symbol}_before", real=True)
