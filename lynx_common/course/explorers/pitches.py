"""Stage of B1: at one point, which pitches does the gripper reach, and with which elbow within the limits?"""

import numpy as np
import sympy as sp
from IPython.display import HTML

from ... import arm
from ...arm import formulas
from ...symbolic import TASK, WRIST, XYZ, P
from ..stage import Body, Challenge, Handle, Level, Line, Plane, Slider, Words, largest, least, stage
from .branches import side_view, within_limits
from .solids import DEGREES, circle, room, values_of

HOME = (0.32, 0.2, -40)  # pose f of the notebook, but for its pitch


def pitches_at_a_point(geometry: arm.Geometry = arm.LYNX) -> HTML:
    """A point to be dragged and a pitch; both shapes, a fan of all pitches, and where the arm is within its limits."""
    (_, r, z, pitch, _), (d_1, L_1, L_2, L_3) = TASK, P
    size, far = sum(geometry), sum(geometry) - geometry.d_1
    postures, (low, high) = _postures(), (geometry.d_1 - 1.08 * far, geometry.d_1 + 1.08 * far)
    inside = [within_limits(q) for q in postures]
    items = [Level(least(_reached(), slack), (r, z), colour, 0.2) for slack, colour in zip(inside, ("right", "target"), strict=True)]
    items += _fan(inside) + [circle((r, z), L_3, "aid")]
    for q, slack, colour in (*zip(postures[::-1], inside[::-1], ("target", "right")[:2], strict=True),):
        for shown, shade in ((least(_reached(), slack), colour), (least(_reached(), -slack), "pale")):
            items.append(Body(side_view(q), 0.018 * size, "steel" if shade == "right" else shade, when=shown))
    handle = Handle(sp.Matrix([[r, z]]), XYZ[:2], {r: XYZ[0], z: XYZ[1]})
    view = Plane("r [m]", "z [m]", (-1.08 * far, low), (1.08 * far, high), round(far / 2.5, 2), items, [handle])
    scale = far / 0.5
    sliders = [
        Slider(r, "r", -round(far, 2), round(far, 2), round(HOME[0] * scale, 2), 0.01, "m"),
        Slider(z, "z", 0, round(high, 2), round(HOME[1] * scale, 2), 0.01, "m"),
        Slider(pitch, "pitch", -180, 180, HOME[2], 1),
    ]
    title = "The arm from the side at one point, with all pitches that it reaches there"
    return stage([view], sliders, _words(postures, inside), values_of((*P, TASK[0], TASK[4]), (*geometry, 0, 0)), title, challenges=_challenges(inside))


def _postures() -> list[list[sp.Expr]]:
    """Joint angles with the elbow up and with the elbow down, in TASK and P."""
    wrist = dict(zip(WRIST, formulas.wrist(), strict=True))
    up = sp.Piecewise((-1, WRIST[0] >= 0), (1, True))
    return [list(formulas.joint_angles().xreplace({formulas.SIGMA: sign}).xreplace(wrist)) for sign in (up, -up)]


def _reached() -> sp.Expr:
    wrist = formulas.wrist()
    return room(sp.sqrt(wrist.dot(wrist)), P[1], P[2])


def _fan(inside: list[sp.Expr]) -> list[Line]:
    """Where the wrist may be for a gripper at the point: thin where the links reach, thick within the limits."""
    (_, r, z, pitch, _), L_3, turn = TASK, P[3], sp.Symbol("turn", real=True)
    lines = []
    for shown, width in ((_reached(), 1.5), (least(_reached(), largest(*inside)), 5)):
        one = sp.Piecewise((1, shown.xreplace({pitch: turn}) >= 0), (sp.nan, True), evaluate=False)
        place = sp.Matrix([[r - one * L_3 * sp.cos(turn), z - L_3 * sp.sin(turn)]])
        lines.append(Line(place, "y", width, along=(turn, -round(np.pi, 8), round(np.pi, 8), 144)))
    return lines


def _words(postures: list[list[sp.Expr]], inside: list[sp.Expr]) -> list[Words]:
    reached, words = _reached(), []
    distance = sp.sqrt(formulas.wrist().dot(formulas.wrist()))
    text = "Out of reach at this pitch: the wrist would be {} m from the shoulder, which has {} m of links."
    words.append(Words(text, [distance, P[1] + P[2]], when=-reached))
    for name, q, slack in zip(("up  ", "down"), postures, inside, strict=True):
        angles = [DEGREES * angle for angle in q[1:4]]
        for end, shown in (("", slack), (" beyond a limit", -slack)):
            words.append(Words(f"elbow {name}{{}}°{{}}°{{}}°" + end, angles, 0, least(reached, shown), columns=True))
    return words


def _challenges(inside: list[sp.Expr]) -> list[Challenge]:
    (_, r, z, pitch, _), (d_1, L_1, L_2, L_3), reached = TASK, P, _reached()
    one = least(largest(*inside), -least(*inside), reached)
    out = sp.sqrt((L_1 + L_2) ** 2 - (z + L_3 - d_1) ** 2)
    return [
        Challenge(
            "Find a point and a pitch at which only one elbow is within the limits.",
            "One elbow only: a planner has no choice there.",
            one,
        ),
        Challenge(
            "With the gripper pointing straight down, go out as far as the links allow, 0.15 to 0.25 m high.",
            "Stretched: further out the pitch has to rise.",
            least(reached, -sp.sin(pitch) - sp.cos(sp.pi / 90), r - sp.Rational(97, 100) * out, z - 0.15, 0.25 - z),
        ),
    ]
