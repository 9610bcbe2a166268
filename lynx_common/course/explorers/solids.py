"""The robots as solids, in symbols: what the stages draw of them."""

from collections.abc import Iterable, Sequence

import numpy as np
import sympy as sp

from ... import arm
from ...arm import formulas
from ...symbolic import P, Q
from ..stage import ALWAYS, Body, Line, Slider, largest, least

NAMES = [f"θ{i}" for i in "₁₂₃₄₅"]
LENGTHS = [f"L{i}" for i in "₁₂₃"]
DEGREES = 180 / sp.pi
ROUNDING = 1e-8  # of the reach: full stretch counts as reached; a page keeps nine digits of 1 + ROUNDING


def values_of(symbols: Sequence[sp.Symbol], geometry: Iterable[float]) -> dict[sp.Symbol, float]:
    """What is fixed on a stage: the lengths of its robot."""
    return dict(zip(symbols, geometry, strict=True))


def length_sliders(geometry: arm.Geometry) -> list[Slider]:
    """For the links and the gripper: each may be as short as half; longer arms would not fit the picture."""
    lengths = zip(P[1:], LENGTHS, tuple(geometry)[1:], strict=True)
    return [Slider(at, name, round(x - int(50 * x) / 100, 6), x, x, 0.01, "m") for at, name, x in lengths]


def arm_in_space(
    frames: Sequence[sp.Matrix], size: float, when: sp.Expr = ALWAYS, gripper: bool = True, pale: bool = False
) -> list[Body]:
    """The arm whose frames have the poses T_0_1 to T_0_5, as thick as suits an arm of this ``size``."""
    shoulder, elbow, wrist, tip = (frames[i][:3, 3].T for i in (0, 1, 2, 4))
    x, z, u = frames[4][:3, 0].T, frames[4][:3, 2].T, size / 0.6
    colours = ("pale", "pale", "pale") if pale else ("steel", "joint", "x")

    def rod(start, end, radius, colour=0, flat=False) -> Body:
        points = sp.Matrix.vstack(sp.Matrix([start]), sp.Matrix([end]))
        return Body(points, radius * u, colours[colour], flat, when=when)

    def joint(at, frame, half, radius) -> Body:
        axis = half * u * frame[:3, 2].T
        return rod(at - axis, at + axis, radius, 1, flat=True)

    up = sp.Matrix([[0, 0, u]])
    parts = [rod(0 * up, 0.014 * up, 0.056, 1, True), rod(0.014 * up, shoulder - 0.012 * up, 0.03, 0, True)]
    parts += [rod(shoulder, elbow, 0.0165), rod(elbow, wrist, 0.0135)]
    parts += [joint(shoulder, frames[0], 0.026, 0.026), joint(elbow, frames[1], 0.023, 0.021)]
    if not gripper:
        return [*parts, rod(wrist, wrist, 0.018, 2)]
    palm, half = tip - 0.05 * u * z, 0.026 * u * x
    parts += [joint(wrist, frames[2], 0.018, 0.0165), rod(wrist, palm, 0.0105)]
    parts += [rod(palm - half, palm + half, 0.0075, 1)]
    return parts + [rod(palm + side, tip + side, 0.006, 2) for side in (half, -half)]


def frames_of(q: Sequence[sp.Expr]) -> list[sp.Matrix]:
    """T_0_1 to T_0_5 of the Lynxmotion arm at joint angles ``q``, in P."""
    place = dict(zip(Q, q, strict=True))
    return [T.xreplace(place) for T in formulas.frames()[1:]]


def axes_of(T: sp.Matrix, length: float, when: sp.Expr = ALWAYS, width: float = 2.5) -> list[Line]:
    """The axes of a frame in their colours, with their names at the ends."""
    at = T[:3, 3].T
    ends = [at + length * T[:3, i].T for i in range(3)]
    rows = [sp.Matrix.vstack(end, at) for end in ends]
    return [Line(row, name, width, label=name, when=when) for row, name in zip(rows, "xyz", strict=True)]


def circle(centre: Sequence[sp.Expr], radius: sp.Expr, colour: str, **style) -> Line:
    """A thin circle in a plane."""
    t = sp.Symbol("turn", real=True)
    points = sp.Matrix([[centre[0] + radius * sp.cos(t), centre[1] + radius * sp.sin(t)]])
    return Line(points, colour, **{"width": 1.2, "dashed": True} | style, along=(t, 0, round(2 * np.pi, 8), 72))


def room(distance: sp.Expr, one: sp.Expr, other: sp.Expr) -> sp.Expr:
    """Not negative where two links of these lengths can span the distance."""
    return least((one + other) * (1 + ROUNDING) - distance, distance - (1 - ROUNDING) * sp.Abs(one - other))


def about(angle: sp.Expr, middle: sp.Expr) -> sp.Expr:
    """An angle less ``middle``, by full turns into [-pi, pi)."""
    turn = 2 * sp.pi
    return angle - middle - turn * sp.floor((angle - middle) / turn + sp.Rational(1, 2))


def wrapped(angle: sp.Expr) -> sp.Expr:
    """An angle in degrees, by full turns into (-180, 180]."""
    return -DEGREES * about(-angle, sp.Integer(0))


def chosen(symbol: sp.Symbol, *cases: tuple[float, sp.Expr]) -> sp.Expr:
    """The expression that belongs to the value of ``symbol``; the last one otherwise."""
    *some, (_, last) = cases
    return sp.Piecewise(*((expr, sp.Eq(symbol, value)) for value, expr in some), (last, True))


def light(expr: sp.Matrix) -> sp.Matrix:
    """The same with ``least`` and ``largest`` for Min and Max, which take long over what replaces a symbol."""
    return expr.replace(sp.Min, least).replace(sp.Max, largest)
