"""Stage of B3: a ball in the way, the thread that is pulled tight around it, and the arm that follows."""

import sympy as sp
from IPython.display import HTML

from ... import arm
from ...arm import formulas
from ...symbolic import TASK, WRIST, XYZ, P
from ..stage import (
    Body,
    Challenge,
    Choice,
    Control,
    Handle,
    Item,
    Line,
    Plane,
    Slider,
    Words,
    largest,
    least,
    magnitude,
    stage,
)
from .branches import arm_from_the_side, side_view, within_limits
from .solids import circle, light, room, values_of

# Points 3 and 4 of the report's Fig. 1.10, as (r, z, pitch), and its obstacle.
START, END = (0, 0.6, sp.pi / 2), (sp.Rational(-1, 5), sp.Rational(2, 5), sp.pi)
BALL = sp.symbols("ball_r ball_z radius margin", real=True)
SHARE, BEND, KEEP, ENDS, REACHED, CLEAR, CLEAR_OF_LINE = sp.symbols(
    "share bend keep ends reached clear line", real=True
)
POSTURE = sp.symbols("q_1:6", real=True)
HOME = (-0.2, 0.6, 0.15, 0)
LINK = 0.02  # m, how thick the links are all round, as in notebook B3
ASKED = 0.02  # m, the clearance of the challenge


def thread_around_a_ball(geometry: arm.Geometry = arm.LYNX) -> HTML:
    """The ball to be dragged, its size and a margin; the gripper's shortest way, and the arm on it."""
    let = _way() | _posture()
    points, size = side_view(POSTURE), sum(geometry)
    shown = least(REACHED, ENDS)
    track = sp.Matrix([[sp.Piecewise((TASK[1], ENDS >= 0), (sp.nan, True)), TASK[2]]])
    items: list[Item] = [
        Body(sp.Matrix([BALL[:2]]), BALL[2], "printed", clear=True),
        circle(BALL[:2], KEEP, "aid"),
        Line(track, "z", 2.5, along=(SHARE, 0, 1, 120)),
        *arm_from_the_side(POSTURE, size, shown),
        Body(points[4, :], 0.02 * size, "x", when=shown),
        *(Line(sp.Matrix([p[:2]]), "target", 0, dots=5, label=name) for p, name in ((START, "3"), (END, "4"))),
    ]
    grab = Handle(sp.Matrix([BALL[:2]]), XYZ[:2], dict(zip(BALL[:2], XYZ[:2], strict=True)))
    view = Plane("r [m]", "z [m]", (-0.52, -0.02), (0.38, 0.8), 0.1, items, [grab])
    ranges = ((-0.4, 0.2), (0.2, 0.7), (0.02, 0.2), (0, 0.08))
    names = ("ball r", "ball z", "radius", "margin")
    controls: list[Control] = [Slider(SHARE, "way", 0, 1, 0, 0.01, "")]
    controls += [
        Slider(s, name, *r, h, 0.01, "m") for s, name, r, h in zip(BALL, names, ranges, HOME, strict=True)
    ]
    controls.append(Choice(BEND, "elbow", {"θ₃ < 0": -1, "θ₃ > 0": 1}, -1))
    title = "The arm from the side, a ball in its way and the shortest way of the gripper around it"
    fixed = values_of((*P, TASK[0], TASK[4]), (*geometry, 0, 0))
    return stage([view], controls, _words(), fixed, title, challenges=_challenges(shown), let=let)


def _challenges(shown: sp.Expr) -> list[Challenge]:
    moved = [magnitude(symbol - home) for symbol, home in zip(BALL[:2], HOME, strict=False)]
    at_home = least(0.005 - largest(*moved), BALL[2] - HOME[2] + 0.001)
    past = Challenge(
        "Pass the ball where it is, with the whole arm at least 20 mm clear of it, from point 3 to point 4.",
        "Past the ball, links and all.",
        SHARE - 0.999,
        least(CLEAR - ASKED + sp.Float(1e-9), shown, at_home),
        "The arm came too near, could not follow, or the ball was moved: reset.",
    )
    through = Challenge(
        "Find a place for the ball at which the gripper's way is clear, and a link goes through the ball.",
        "The thread is the gripper's way. Nobody asked the links.",
        least(shown, -CLEAR - 0.005),
    )
    return [past, through]


def _from_centre(point: tuple) -> sp.Matrix:
    return sp.Matrix(point[:2]) - sp.Matrix(BALL[:2])


def _way() -> dict[sp.Symbol, sp.Expr]:
    """(r, z, pitch) at SHARE of the way: tangent, arc, tangent on the shorter side; or straight, where clear."""
    first, last = map(_from_centre, (START, END))
    away = [sp.sqrt(v.dot(v)) for v in (first, last)]
    names = "begin t_first t_last turned_left turned_right arc turn gone on_arc at"
    begin, t_first, t_last, left, right, arc, turn, gone, on_arc, at = sp.symbols(names, real=True)
    between = sp.atan2(last[1], last[0]) - begin
    let = {
        KEEP: BALL[2] + BALL[3],
        ENDS: least(*away) - KEEP + sp.Float(1e-9),
        begin: sp.atan2(first[1], first[0]),
    }
    for symbol, v in ((t_first, first), (t_last, last)):
        let[symbol] = sp.sqrt(largest(v.dot(v) - KEEP**2, 0))
    touch = sp.atan2(t_first, KEEP) + sp.atan2(t_last, KEEP)
    let |= {
        symbol: sign * between - 2 * sp.pi * sp.floor(sign * between / (2 * sp.pi)) - touch
        for symbol, sign in ((left, 1), (right, -1))
    }
    let |= {arc: KEEP * least(left, right), turn: sp.Piecewise((1, left <= right + sp.Float(1e-9)), (-1, True))}
    let |= {gone: SHARE * (t_first + arc + t_last) - t_first, on_arc: largest(0, least(gone, arc))}
    let[at] = begin + turn * (sp.atan2(t_first, KEEP) + on_arc / KEEP)
    beyond = turn * (gone - on_arc)
    around = [BALL[0] + KEEP * sp.cos(at) - beyond * sp.sin(at), BALL[1] + KEEP * sp.sin(at) + beyond * sp.cos(at)]
    straight = [a + SHARE * (b - a) for a, b in zip(START, END, strict=True)]
    let[CLEAR_OF_LINE] = _straight_clear(first, last, KEEP)
    for symbol, one, other in zip(TASK[1:3], straight, around, strict=False):
        let[symbol] = sp.Piecewise((one, CLEAR_OF_LINE >= 0), (other, True))
    return let | {TASK[3]: straight[2]}


def _straight_clear(first: sp.Matrix, last: sp.Matrix, keep: sp.Expr) -> sp.Expr:
    """How far the straight line stays outside the circle."""
    step = last - first
    nearest = first + largest(0, least(1, -first.dot(step) / step.dot(step))) * step
    return sp.sqrt(nearest.dot(nearest)) - keep


def _posture() -> dict[sp.Symbol, sp.Expr]:
    """Joint angles there, with theta_3 of the sign BEND, and the clearance of the whole arm."""
    let = dict(zip(WRIST, formulas.wrist(), strict=True))
    let[REACHED] = room(sp.sqrt(WRIST[0] ** 2 + WRIST[1] ** 2), P[1], P[2])
    let |= zip(POSTURE, light(formulas.joint_angles()).xreplace({formulas.SIGMA: BEND}), strict=True)
    return let | {CLEAR: _clearance(side_view(POSTURE), sp.Matrix([BALL[:2]])) - BALL[2] - LINK}


def _clearance(points: sp.Matrix, centre: sp.Matrix) -> sp.Expr:
    """Distance of a point from the links, whose lengths are known not to be zero but for the gripper's."""
    distances = []
    for i in range(4):
        link, towards = points[i + 1, :] - points[i, :], centre - points[i, :]
        share = largest(0, least(1, towards.dot(link) / (link.dot(link) + sp.Float(1e-12))))
        away = towards - share * link
        distances.append(sp.sqrt(away.dot(away)))
    return least(*distances)


def _words() -> list[Words]:
    tip, shown = side_view(POSTURE)[4, :] - sp.Matrix([BALL[:2]]), least(ENDS, REACHED)
    text = "clearance of the gripper {} m, of the whole arm, its links 20 mm thick all round, {} m"
    return [
        Words(text, [sp.sqrt(tip.dot(tip)) - BALL[2], CLEAR], 3, shown),
        Words("a link is in the ball", when=least(shown, -CLEAR)),
        Words("beyond a joint limit", when=least(shown, -within_limits(POSTURE))),
        Words("The links do not reach this place of the way.", when=least(ENDS, -REACHED)),
        Words("Point 3 or point 4 is nearer to the ball than the margin: there is no way.", when=-ENDS),
    ]
