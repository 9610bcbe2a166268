"""Stage of A3: where the gripper is, and all joint angles that bring it there."""

import numpy as np
import sympy as sp
from IPython.display import HTML

from ... import arm
from ...arm import formulas
from ...symbolic import TASK, WRIST, XYZ, P, Q
from ..stage import Body, Challenge, Choice, Handle, Line, Plane, Slider, Space, Words, before, largest, least, magnitude, stage
from .solids import about, arm_in_space, chosen, circle, frames_of, room, values_of, wrapped

ELBOW = sp.Symbol("elbow", real=True)


def branches_of_a_target(
    wrist: sp.Matrix | None = None,
    cosine: sp.Expr | None = None,
    shoulder: sp.Expr | None = None,
    geometry: arm.Geometry = arm.LYNX,
) -> HTML:
    """A target to be dragged, in space and in the arm's plane; both shapes, the angles of all branches, the limits.

    The three formulas are those of notebook A3: ``wrist`` is (r_wrist, h) in the symbols of task coordinates,
    ``cosine`` that of theta_3 in r_wrist and h, ``shoulder`` theta_2 in r_wrist, h and theta_3.
    """
    (azimuth, r, z, pitch, _), (d_1, L_1, L_2, _) = TASK, P
    if wrist is None:
        (r_w, h), wrist = WRIST, formulas.wrist()
        cosine = (r_w**2 + h**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)
        shoulder = sp.atan2(h, r_w) - sp.atan2(L_2 * sp.sin(Q[2]), L_1 + L_2 * sp.cos(Q[2]))
    distance, size, far = sp.sqrt(wrist.dot(wrist)), sum(geometry), sum(geometry) - geometry.d_1
    reached = room(distance, L_1, L_2)
    up = sp.Piecewise((-1, wrist[0] >= 0), (1, True))  # the sign of theta_3 with the higher elbow
    postures = [posture(sign, wrist, cosine, shoulder) for sign in (up, -up)]
    own = [chosen(ELBOW, (1, a), (-1, b)) for a, b in zip(*postures, strict=True)]
    other = [chosen(ELBOW, (-1, a), (1, b)) for a, b in zip(*postures, strict=True)]
    target = sp.Matrix([[r * sp.cos(azimuth), r * sp.sin(azimuth), z]])
    solids = [*arm_in_space(frames_of(other), size, reached, pale=True), *arm_in_space(frames_of(own), size, reached)]
    space = Space((0, 0, round(0.36 * size, 4)), 0.78 * size, round(size / 6, 4), solids, [_in_space(target)])
    shapes = [circle((0, d_1), L_1 + L_2, "aid"), circle((0, d_1), sp.Abs(L_1 - L_2), "aid")]
    for q, colour, bodies in ((other, "pale", 0), (own, "steel", 1)):
        shapes.append(Body(side_view(q), 0.02 * size, colour, when=reached))
        shapes += [Body(side_view(q)[i, :], 0.027 * size, "joint", when=reached) for i in (1, 2, 3) if bodies]
    shapes.append(Line(sp.Matrix([[r, z], [wrist[0], d_1 + wrist[1]]]), "target", 2.5, dashed=True))
    handle = Handle(sp.Matrix([[r, z]]), XYZ[:2], {r: XYZ[0], z: XYZ[1]})
    half = 1.12 * far
    plane = Plane("r [m]", "z [m]", (-half, geometry.d_1 - half), (half, geometry.d_1 + half), round(far / 2.5, 2), shapes, [handle])  # noqa: E501
    challenges = _challenges(own, wrist, distance, reached)
    title = "The arm with both elbows, in space and in its own plane; sliders for its target"
    words = _words(postures, distance, reached)
    return stage([space, plane], _controls(geometry), words, values_of((*P, TASK[4]), (*geometry, 0)), title, challenges=challenges)


def _controls(geometry: arm.Geometry) -> list[Slider | Choice]:
    (azimuth, r, z, pitch, _), far = TASK, round(sum(geometry) - geometry.d_1, 2)
    low, high = geometry.d_1 - far, geometry.d_1 + far
    return [
        Slider(azimuth, "azimuth", -180, 180, 30),
        Slider(r, "r", -far, far, round(0.6 * far, 2), 0.01, "m"),
        Slider(z, "z", round(low, 2), round(high, 2), round(geometry.d_1 + 0.2 * far, 2), 0.01, "m"),
        Slider(pitch, "pitch", -180, 180, -30),
        Choice(ELBOW, "elbow", {"up": 1, "down": -1}, 1),
    ]


def posture(sign: sp.Expr, wrist: sp.Matrix, cosine: sp.Expr, shoulder: sp.Expr) -> list[sp.Expr]:
    """The five joint angles with theta_3 of this sign, in TASK and P."""
    at_wrist = dict(zip(WRIST, wrist, strict=True))
    theta_3 = sign * sp.acos(largest(-1, least(1, cosine)))  # beyond lies only what ROUNDING lets pass
    theta_2 = shoulder.subs(Q[2], theta_3).subs(at_wrist)
    theta_3 = theta_3.subs(at_wrist)
    return [TASK[0], theta_2, theta_3, TASK[3] + sp.pi / 2 - theta_2 - theta_3, TASK[4]]


def side_view(q: list[sp.Expr]) -> sp.Matrix:
    """Base, shoulder, elbow, wrist and gripper in the arm's own plane, (5, 2)."""
    points = formulas.joint_positions().subs(Q[0], 0)[:, [0, 2]]
    return points.xreplace(dict(zip(Q, q, strict=True)))


def _in_space(at: sp.Matrix) -> Handle:
    """The target keeps its side of the base axis."""
    (x, y, _), height = XYZ, sp.Symbol("height", real=True)
    side = sp.Piecewise((-1, TASK[1] < 0), (1, True))
    place = [sp.atan2(side * y, side * x), side * sp.sqrt(x**2 + y**2), height]
    return Handle(at, (x, y, height), dict(zip(TASK[:3], place, strict=True)))


def _words(postures: list[list[sp.Expr]], distance: sp.Expr, reached: sp.Expr) -> list[Words]:
    """The angles of the four branches, and which are beyond a limit; or why there are none."""
    (_, L_1, L_2, _) = P
    text = "Out of reach: the wrist would be {} m from the shoulder; the links reach from {} to {} m."
    words = [Words(text, [distance, sp.Abs(L_1 - L_2), L_1 + L_2], when=-reached)]
    words.append(Words(" " * 14 + "θ₁   θ₂   θ₃   θ₄   θ₅", when=reached, columns=True))
    for name, q in _four(postures).items():
        inside = within_limits(q)
        for mark, when in (("", least(reached, inside)), (" ✕", least(reached, -inside))):
            row = f"{name:11}" + "{}" * 5 + mark
            words.append(Words(row, [wrapped(angle) for angle in q], 0, when, columns=True))
    return [*words, Words("in degrees; ✕: beyond a joint limit", when=reached)]


def _four(postures: list[list[sp.Expr]]) -> dict[str, list[sp.Expr]]:
    """The four branches by name; front is the azimuth with which r is not negative."""
    turned = [[q[0] + sp.pi, sp.pi - q[1], -q[2], sp.pi - q[3], q[4] + sp.pi] for q in postures]
    rows = {}
    for side, these, those in (("front", postures, turned), ("back", turned, postures)):
        for elbow, a, b in zip(("up", "down"), these, those, strict=True):
            pairs = zip(a, b, strict=True)
            rows[f"{side}, {elbow}"] = [sp.Piecewise((one, TASK[1] >= 0), (other, True)) for one, other in pairs]
    return rows


def within_limits(q: list[sp.Expr]) -> sp.Expr:
    """Not negative where theta_2 to theta_4 are within their limits, give or take full turns; the others always are."""
    slack = []
    for angle, (low, high) in zip(q[1:4], np.rad2deg(arm.JOINT_LIMITS[1:4]).round().astype(int).tolist(), strict=True):
        middle, half = sp.pi * (low + high) / 360, sp.pi * (high - low) / 360
        slack.append(half + sp.Float(1e-9) - magnitude(about(angle, middle)))
    return least(*slack)


def _challenges(own: list[sp.Expr], wrist: sp.Matrix, distance: sp.Expr, reached: sp.Expr) -> list[Challenge]:
    now = {symbol: before(symbol) for symbol in (*TASK[1:4], ELBOW)}
    step = magnitude(own[2] - own[2].xreplace(now))
    over = least(-wrist[0] - sp.Rational(1, 10) * (P[1] + P[2]), reached)
    return [
        Challenge(
            "Find a target that the arm reaches in one shape only.",
            "At full stretch the two elbows are one.",
            least(distance - sp.Rational(99, 100) * (P[1] + P[2]), reached),
        ),
        Challenge(
            "Lead the wrist over the base to the other side with the elbow up all the way, and no jump of 60° or more.",
            "Up became down without a jump: at full stretch there is no difference.",
            over,
            least(sp.pi / 3 - step, reached, ELBOW),
            "The elbow jumped, went down, or could not reach: reset, and look for another place to pass.",
        ),
    ]
