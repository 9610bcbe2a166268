"""Stage of A3: where the gripper is, and all joint angles that bring it there."""

from collections.abc import Sequence

import numpy as np
import sympy as sp
from IPython.display import HTML

from ... import arm
from ...arm import formulas
from ...symbolic import TASK, WRIST, XYZ, P, Q
from ..stage import (
    Body,
    Challenge,
    Choice,
    Handle,
    Item,
    Line,
    Plane,
    Slider,
    Space,
    Words,
    before,
    largest,
    least,
    magnitude,
    stage,
)
from .solids import about, arm_in_space, chosen, circle, frames_of, length_sliders, room, wrapped

ELBOW, DISTANCE, REACHED = sp.symbols("elbow distance reached", real=True)
UP, DOWN = sp.symbols("up_1:6", real=True), sp.symbols("down_1:6", real=True)


def branches_of_a_target(
    wrist: sp.Matrix | None = None,
    cosine: sp.Expr | None = None,
    shoulder: sp.Expr | None = None,
    geometry: arm.Geometry = arm.LYNX,
) -> HTML:
    """A target to be dragged, in space and in the arm's plane; both shapes, and the angles of all branches.

    The three formulas are those of notebook A3: ``wrist`` is (r_wrist, h) in the symbols of task coordinates,
    ``cosine`` that of theta_3 in r_wrist and h, ``shoulder`` theta_2 in r_wrist, h and theta_3.
    """
    if wrist is None:
        wrist, cosine, shoulder = three_formulas()
    let = both_elbows(wrist, cosine, shoulder)
    own, other = sp.symbols("own_1:6", real=True), sp.symbols("other_1:6", real=True)
    let |= {symbol: chosen(ELBOW, (1, up), (-1, down)) for symbol, up, down in zip(own, UP, DOWN, strict=True)}
    let |= {symbol: chosen(ELBOW, (-1, up), (1, down)) for symbol, up, down in zip(other, UP, DOWN, strict=True)}
    views = _views(own, other, geometry)
    title = "The arm with both elbows, in space and in its own plane; sliders for its target and its lengths"
    fixed = {P[0]: geometry.d_1, TASK[4]: 0.0}
    return stage(views, _controls(geometry), _words(), fixed, title, challenges=_challenges(own), let=let)


def three_formulas() -> tuple[sp.Matrix, sp.Expr, sp.Expr]:
    """Those of notebook A3: the wrist, the cosine of theta_3, and theta_2."""
    (r_wrist, h), (_, L_1, L_2, _) = WRIST, P
    cosine = (r_wrist**2 + h**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)
    shoulder = sp.atan2(h, r_wrist) - sp.atan2(L_2 * sp.sin(Q[2]), L_1 + L_2 * sp.cos(Q[2]))
    return formulas.wrist(), cosine, shoulder


def both_elbows(wrist: sp.Matrix, cosine: sp.Expr, shoulder: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """The wrist, its distance and slack, and the joint angles with the elbow UP and DOWN, in TASK and P."""
    let = dict(zip(WRIST, wrist, strict=True))
    let[DISTANCE] = sp.sqrt(WRIST[0] ** 2 + WRIST[1] ** 2)
    let[REACHED] = room(DISTANCE, P[1], P[2])
    bend, fold = sp.symbols("bend fold", real=True)
    let[fold] = sp.acos(largest(-1, least(1, cosine)))  # beyond lies only what ROUNDING lets pass
    let[bend] = sp.Piecewise((-1, WRIST[0] >= 0), (1, True))  # the sign of theta_3 with the higher elbow
    for q, sign in ((UP, bend), (DOWN, -bend)):
        let |= {q[0]: TASK[0], q[2]: sign * fold, q[1]: shoulder.xreplace({Q[2]: q[2]})}
        let |= {q[3]: TASK[3] + sp.pi / 2 - q[1] - q[2], q[4]: TASK[4]}
    return let


def _views(own: Sequence[sp.Symbol], other: Sequence[sp.Symbol], geometry: arm.Geometry) -> list[Space | Plane]:
    (azimuth, r, z, _, _), (d_1, L_1, L_2, _), size = TASK, P, sum(geometry)
    solids = [
        *arm_in_space(frames_of(other), size, REACHED, pale=True),
        *arm_in_space(frames_of(own), size, REACHED),
    ]
    target = sp.Matrix([[r * sp.cos(azimuth), r * sp.sin(azimuth), z]])
    space = Space((0, 0, round(0.36 * size, 4)), 0.78 * size, round(size / 6, 4), solids, [_in_space(target)])
    shapes: list[Item] = [circle((0, d_1), L_1 + L_2, "aid"), circle((0, d_1), sp.Abs(L_1 - L_2), "aid")]
    shapes += [*arm_from_the_side(other, size, REACHED, pale=True), *arm_from_the_side(own, size, REACHED)]
    back = sp.Matrix([[r, z], [WRIST[0], d_1 + WRIST[1]]])
    shapes.append(Line(back, "target", 2.5, dashed=True, when=-REACHED))
    handle, far = Handle(sp.Matrix([[r, z]]), XYZ[:2], {r: XYZ[0], z: XYZ[1]}), 1.12 * (size - geometry.d_1)
    low, high = (-far, geometry.d_1 - far), (far, geometry.d_1 + far)
    return [space, Plane("r [m]", "z [m]", low, high, round(far / 2.8, 2), shapes, [handle])]


def arm_from_the_side(
    q: Sequence[sp.Expr], size: float, when: sp.Expr, pale: bool = False, hand: bool = True
) -> list[Body]:
    """The arm in its own plane."""
    points, (link, joint) = side_view(q), ("pale", "pale") if pale else ("steel", "joint")
    rods = [(points[:4, :], 0.02, link), *[(points[3:, :], 0.014, link)][: int(hand)]]
    rods += [(points[i, :], 0.027, joint) for i in (1, 2, 3)]
    return [Body(rod, width * size, colour, when=when) for rod, width, colour in rods]


def _controls(geometry: arm.Geometry) -> list[Slider | Choice]:
    (azimuth, r, z, pitch, _), far = TASK, round(sum(geometry) - geometry.d_1, 2)
    low, high = geometry.d_1 - far, geometry.d_1 + far
    return [
        Slider(azimuth, "azimuth", -180, 180, 30),
        Slider(r, "r", -far, far, round(0.6 * far, 2), 0.01, "m"),
        Slider(z, "z", round(low, 2), round(high, 2), round(geometry.d_1 + 0.2 * far, 2), 0.01, "m"),
        Slider(pitch, "pitch", -180, 180, -30),
        Choice(ELBOW, "elbow", {"up": 1, "down": -1}, 1),
        *length_sliders(geometry),
    ]


def side_view(q: Sequence[sp.Expr]) -> sp.Matrix:
    """Base, shoulder, elbow, wrist and gripper in the arm's own plane, (5, 2)."""
    points = formulas.joint_positions().subs(Q[0], 0)[:, [0, 2]]
    return points.xreplace(dict(zip(Q, q, strict=True)))


def _in_space(at: sp.Matrix) -> Handle:
    """The target keeps its side of the base axis."""
    (x, y, _), height = XYZ, sp.Symbol("height", real=True)
    side = sp.Piecewise((-1, TASK[1] < 0), (1, True))
    place = [sp.atan2(side * y, side * x), side * sp.sqrt(x**2 + y**2), height]
    return Handle(at, (x, y, height), dict(zip(TASK[:3], place, strict=True)))


def _words() -> list[Words]:
    """The angles of the four branches, and which are beyond a limit; or why there are none."""
    (_, L_1, L_2, _) = P
    text = "Out of reach: the wrist would be {} m from the shoulder; the links reach from {} to {} m."
    words = [Words(text, [DISTANCE, sp.Abs(L_1 - L_2), L_1 + L_2], when=-REACHED)]
    words.append(Words(" " * 14 + "θ₁   θ₂   θ₃   θ₄   θ₅", when=REACHED, columns=True))
    for name, q in _four().items():
        inside = within_limits(q)
        for mark, when in (("", least(REACHED, inside)), (" ✕", least(REACHED, -inside))):
            row = f"{name:11}" + "{}" * 5 + mark
            words.append(Words(row, [wrapped(angle) for angle in q], 0, when, columns=True))
    return [*words, Words("in degrees; ✕: beyond a joint limit", when=REACHED)]


def _four() -> dict[str, list[sp.Expr]]:
    """The four branches by name; front is the azimuth with which r is not negative."""
    turned = [[q[0] + sp.pi, sp.pi - q[1], -q[2], sp.pi - q[3], q[4] + sp.pi] for q in (UP, DOWN)]
    rows = {}
    for side, these, those in (("front", (UP, DOWN), turned), ("back", turned, (UP, DOWN))):
        for elbow, a, b in zip(("up", "down"), these, those, strict=True):
            pairs = zip(a, b, strict=True)
            rows[f"{side}, {elbow}"] = [sp.Piecewise((one, TASK[1] >= 0), (other, True)) for one, other in pairs]
    return rows


def within_limits(q: Sequence[sp.Expr]) -> sp.Expr:
    """Not negative where theta_2 to theta_4 are within their limits, modulo full turns; the others always are."""
    slack = []
    for angle, (low, high) in zip(
        q[1:4], np.rad2deg(arm.JOINT_LIMITS[1:4]).round().astype(int).tolist(), strict=True
    ):
        middle, half = sp.pi * (low + high) / 360, sp.pi * (high - low) / 360
        slack.append(half + sp.Float(1e-9) - magnitude(about(angle, middle)))
    return least(*slack)


def _challenges(own: Sequence[sp.Symbol]) -> list[Challenge]:
    links = P[1] + P[2]
    step = magnitude(own[2] - before(own[2]))
    return [
        Challenge(
            "Find a target that the arm reaches in one shape only.",
            "At full stretch the two elbows are one.",
            least(DISTANCE - 0.99 * links, REACHED),
        ),
        Challenge(
            "Lead the wrist over the base to the other side, the elbow up all the way and without a jump of 60°.",
            "Up became down without a jump: at full stretch there is no difference.",
            -WRIST[0] - 0.1 * links,
            least(sp.pi / 3 - step, REACHED, ELBOW),
            "The elbow jumped, went down, or could not reach: reset, and look for another place to pass.",
        ),
    ]
