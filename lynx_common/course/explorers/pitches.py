"""Stage of B1: at one point, which pitches does the gripper reach, and with which elbow within the limits?"""

import numpy as np
import sympy as sp
from IPython.display import HTML

from ... import arm
from ...symbolic import TASK, XYZ, P
from ..stage import Challenge, Handle, Item, Level, Line, Plane, Slider, Words, largest, least, stage
from .branches import DISTANCE, DOWN, REACHED, UP, arm_from_the_side, both_elbows, three_formulas, within_limits
from .solids import DEGREES, circle, values_of

INSIDE, COLOURS = sp.symbols("inside_up inside_down", real=True), ("right", "target")
HOME = (0.32, 0.2, -40)  # pose f of the notebook, but for its pitch


def pitches_at_a_point(geometry: arm.Geometry = arm.LYNX) -> HTML:
    """A point to be dragged, and a pitch; all pitches there, both elbows, and where they are within limits."""
    (_, r, z, pitch, _), size, far = TASK, sum(geometry), sum(geometry) - geometry.d_1
    L_3 = P[3]
    let = both_elbows(*three_formulas())
    let |= {slack: least(REACHED, within_limits(q)) for slack, q in zip(INSIDE, (UP, DOWN), strict=True)}
    items: list[Item] = [Level(slack, (r, z), colour, 0.2) for slack, colour in zip(INSIDE, COLOURS, strict=True)]
    items += [*_wrists(), circle((r, z), L_3, "aid")]
    for q, slack in ((DOWN, INSIDE[1]), (UP, INSIDE[0])):
        items += arm_from_the_side(q, size, least(REACHED, -slack - sp.Float(1e-12)), pale=True)
        items += arm_from_the_side(q, size, slack)
    handle = Handle(sp.Matrix([[r, z]]), XYZ[:2], {r: XYZ[0], z: XYZ[1]})
    low, high = (geometry.d_1 - 1.08 * far, geometry.d_1 + 1.08 * far)
    view = Plane("r [m]", "z [m]", (-1.08 * far, low), (1.08 * far, high), round(far / 2.5, 2), items, [handle])
    scale = far / 0.5
    sliders = [
        Slider(r, "r", -round(far, 2), round(far, 2), round(HOME[0] * scale, 2), 0.01, "m"),
        Slider(
            z,
            "z",
            round(geometry.d_1 - far, 2),
            round(geometry.d_1 + far, 2),
            round(HOME[1] * scale, 2),
            0.01,
            "m",
        ),
        Slider(pitch, "pitch", -180, 180, HOME[2]),
    ]
    title = "The arm from the side at one point, and all pitches that it reaches there"
    fixed = values_of((*P, TASK[0], TASK[4]), (*geometry, 0, 0))
    return stage([view], sliders, _words(), fixed, title, challenges=_challenges(), let=let)


def _wrists() -> list[Line]:
    """Where the wrist may be for a gripper at the point: thin where the links reach, thick within the limits."""
    (_, r, z, pitch, _), L_3 = TASK, P[3]
    lines = []
    for shown, width in ((REACHED, 1.5), (largest(*INSIDE), 5)):
        one = sp.Piecewise((1, shown >= 0), (sp.nan, True))
        place = sp.Matrix([[r - one * L_3 * sp.cos(pitch), z - L_3 * sp.sin(pitch)]])
        lines.append(Line(place, "y", width, along=(pitch, -round(np.pi, 8), round(np.pi, 8), 180)))
    return lines


def _words() -> list[Words]:
    text = "Out of reach at this pitch: the wrist would be {} m from the shoulder, which has {} m of links."
    words = [Words(text, [DISTANCE, P[1] + P[2]], when=-REACHED)]
    for name, q, slack in zip(("up  ", "down"), (UP, DOWN), INSIDE, strict=True):
        angles = [DEGREES * angle for angle in q[1:4]]
        for end, shown in (("", slack), (" ✕", least(REACHED, -slack - sp.Float(1e-12)))):
            words.append(Words(f"elbow {name}{{}}°{{}}°{{}}°" + end, angles, 0, shown, columns=True))
    return [
        *words,
        Words("✕: beyond a joint limit. Blue: the elbow up is within them; yellow: the elbow down."),
        Words("Green: the wrist, for all pitches."),
    ]


def _challenges() -> list[Challenge]:
    (_, r, z, pitch, _), (d_1, L_1, L_2, L_3) = TASK, P
    one = least(largest(*INSIDE), -least(*INSIDE) - sp.Float(1e-12), REACHED)
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
            least(
                REACHED, -sp.sin(pitch) - sp.cos(sp.pi / 90), r - sp.Rational(97, 100) * out, z - 0.15, 0.25 - z
            ),
        ),
    ]
