"""Stage of Part 3: where an arm loses a freedom, and the force that its motors do not feel there."""

import numpy as np
import sympy as sp
from IPython.display import HTML

from ... import arm
from ...arm import formulas
from ...symbolic import WRIST, XYZ, P, Q
from ..stage import (
    Body,
    Challenge,
    Handle,
    Item,
    Level,
    Line,
    Plane,
    Slider,
    Space,
    Words,
    largest,
    least,
    magnitude,
    stage,
)
from .solids import DEGREES, arm_in_space, frames_of, values_of

PART_3 = arm.Geometry(5, 10, 10, 0)
HOME_DEG = (20, 30, -80)
SPEED = 0.3  # joint speed, in rad/s, whose velocities of the end are drawn
PLACE = sp.symbols("across up", real=True)  # on the map, in degrees


def lost_freedom(geometry: arm.Geometry = PART_3) -> HTML:
    """The end of the arm to be dragged; velocity ellipse, force of least torque, and the map of the determinant.

    All is about the wrist; a gripper is left out. The arm of Part 3 has no unit.
    """
    size = sum(geometry) - geometry.L_3
    end, radial, block = _end(), _radius(), _block()
    items: list[Item] = [*arm_in_space(frames_of([*Q[:3], 0, 0]), size, gripper=False), *_velocities(size)]
    view = Space((0, 0, round(0.36 * size, 4)), 0.8 * size, round(size / 6, 4), items, [_handle(end)])
    here = dict(zip(Q[1:3], (sp.pi * place / 180 for place in PLACE), strict=True))
    factors = [sp.sin(Q[2]).xreplace(here), radial.xreplace(here)]
    chart: list[Item] = [Level(-factors[0] * factors[1], PLACE, "right", 0.25, 0)]
    chart.append(Level(factors[1], PLACE, "x", 0, 2))
    chart += [Line(sp.Matrix([[-180, turn], [180, turn]]), "z", 2) for turn in (-180, 0, 180)]
    at = DEGREES * sp.Matrix([Q[1:3]])
    chart.append(Line(at, "target", 0, dots=5))
    chosen = Handle(at, PLACE, dict(zip(Q[1:3], here.values(), strict=True)))
    view_of_map = Plane("θ₂ [°]", "θ₃ [°]", (-180, -180), (180, 180), 60, chart, [chosen])
    sliders = [Slider(q, f"θ{i}", -180, 180, home) for q, i, home in zip(Q, "₁₂₃", HOME_DEG, strict=False)]
    title = "The arm in space with the velocities of its end, and the map of the determinant over θ₂ and θ₃"
    challenges = _challenges(radial, least(magnitude(radial), _singular_values(block)[1]), geometry)
    words = _words(radial, block, size)
    return stage([view, view_of_map], sliders, words, values_of(P, geometry), title, challenges=challenges)


def _challenges(radial: sp.Expr, smallest: sp.Expr, geometry: arm.Geometry) -> list[Challenge]:
    lost = Challenge(
        "Lose a freedom without stretching the elbow.",
        "The end is on the base axis: it cannot move square to the arm's plane; a push that way costs nothing.",
        least(0.0125 * (geometry.L_1 + geometry.L_2) - magnitude(radial), magnitude(sp.sin(Q[2])) - 0.3),
    )
    good = float(f"{0.99 * geometry.L_1 / 2**0.5:.3g}")  # of L / sqrt(2), the most with two links of one length
    best = Challenge(
        f"Make the worst direction as good as it gets: a smallest singular value of {good} or more.",
        "The arm moves nearly as well in its worst direction as in the second.",
        smallest - good,
    )
    return [lost, best] if geometry.L_1 == geometry.L_2 else [lost]


def _end() -> sp.Matrix:
    return formulas.joint_positions()[3, :]


def _radius() -> sp.Expr:
    """Signed distance of the end from the base axis."""
    return P[1] * sp.cos(Q[1]) + P[2] * sp.cos(Q[1] + Q[2])


def _block() -> sp.Matrix:
    """Velocities of the end in the arm's plane, (r, z), for 1 rad/s of theta_2 and of theta_3: the columns."""
    height = P[1] * sp.sin(Q[1]) + P[2] * sp.sin(Q[1] + Q[2])
    return sp.Matrix([_radius(), height]).jacobian(Q[1:3])


def _singular_values(block: sp.Matrix) -> tuple[sp.Expr, sp.Expr]:
    """Of a matrix (2, 2), the larger first."""
    squares, det = sum(x**2 for x in block), block.det()
    largest_one = sp.sqrt((squares + sp.sqrt((squares - 2 * det) * (squares + 2 * det))) / 2)
    return largest_one, magnitude(det) / largest_one


def _velocities(size: float) -> list[Item]:
    """Velocities in the arm's plane (the ellipse) and square to it, and the line of the force of least torque."""
    end, block, t = _end(), _block(), sp.Symbol("turn", real=True)
    out, side = sp.Matrix([[sp.cos(Q[0]), sp.sin(Q[0]), 0]]), sp.Matrix([[-sp.sin(Q[0]), sp.cos(Q[0]), 0]])
    up = sp.Matrix([[0, 0, 1]])
    speeds = SPEED * block * sp.Matrix([sp.cos(t), sp.sin(t)])
    ellipse = Line(
        end + speeds[0] * out + speeds[1] * up, "target", 2.5, filled=True, along=(t, 0, round(2 * np.pi, 8), 60)
    )
    square = SPEED * _radius() * side
    (a, b), (c, d) = block.tolist()
    angle = sp.atan2(2 * (a * c + b * d), a**2 + b**2 - c**2 - d**2) / 2 + sp.pi / 2
    weak = sp.cos(angle) * out + sp.sin(angle) * up
    in_plane = magnitude(_radius()) - _singular_values(block)[1]
    lines: list[Item] = [ellipse, Line(sp.Matrix.vstack(end - square, end + square), "target", 2.5)]
    for direction, when in ((weak, in_plane), (side, -in_plane)):
        force = 0.22 * size * direction
        rod = sp.Matrix.vstack(end - force, end + force)
        lines += [Body(rod, 0.006 * size, "printed", when=when), Line(rod, "printed", 0, dots=4, when=when)]
    return lines


def _handle(end: sp.Matrix) -> Handle:
    """The end; the elbow stays bent to its side, and the arm on its side of the base axis."""
    x, y, z = XYZ
    side = sp.Piecewise((-1, _radius() < 0), (1, True))
    bend = sp.Piecewise((1, Q[2] > 0), (-1, True))
    place = {WRIST[0]: side * sp.sqrt(x**2 + y**2), WRIST[1]: z - P[0]}
    angles = formulas.joint_angles().xreplace({formulas.SIGMA: bend})
    moves = {Q[0]: sp.atan2(side * y, side * x)} | {Q[i]: angles[i].xreplace(place) for i in (1, 2)}
    distance, nearest, farthest = (bound.xreplace(place) for bound in formulas.reach())
    text = "Out of reach: {} from the shoulder; the links reach from {} to {}."
    out = largest(distance - farthest, nearest - distance)
    return Handle(end, XYZ, moves, [Words(text, [distance, nearest, farthest], 2, out - sp.Float(1e-9))])


def _words(radial: sp.Expr, block: sp.Matrix, size: float) -> list[Words]:
    large, small = _singular_values(block)
    square, rounding = magnitude(radial), sp.Float(1e-6) * size
    smallest, most = least(square, small), largest(square, large)
    other = square + large + small - smallest - most
    elbow, shoulder = rounding - small, rounding - square
    regular = smallest - rounding
    return [
        Words("determinant {}", [-radial * P[1] * P[2] * sp.sin(Q[2])], 1),
        Words("singular values {}, {}, {} per radian", [most, other, smallest], 2),
        Words("{} of it square to the arm's plane", [square], 2),
        Words("speed 1 in the worst direction: {} rad/s", [1 / smallest], 2, regular),
        Words("speed 1 in the worst direction: no joint speed will do", when=-regular),
        Words("a force of 1 along the pink line: a torque of {}", [smallest], 2),
        Words("elbow singularity: a pull along the arm is carried by no motor", when=elbow),
        Words("shoulder singularity: a push square to the arm's plane is carried by no motor", when=shoulder),
    ]
