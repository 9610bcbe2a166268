"""Stage of B2: over the top with a choice of branch at every instant; a jump is seen, and can be avoided."""

import sympy as sp
from IPython.display import HTML

from ... import arm
from ...arm import formulas
from ...symbolic import TASK, WRIST, P
from ..stage import Challenge, Choice, Control, Item, Line, Slider, Space, Words, before, largest, magnitude, stage
from .solids import DEGREES, arm_in_space, chosen, frames_of, light, values_of

PLACE, BRANCH = sp.symbols("place branch", real=True)
FIXED, OWN = sp.symbols("fixed_1:6", real=True), sp.symbols("own_1:6", real=True)
NAMED = {"front, up": 1, "front, down": 2, "back, up": 3, "back, down": 4}
JUMP = 60  # degrees, from one step of the slider to the next


def change_of_branch(geometry: arm.Geometry = arm.LYNX) -> HTML:
    """A slider leads the gripper over the base; left front and up all the way, right as the reader chooses."""
    size, far = sum(geometry), round(0.4 * (sum(geometry) - geometry.d_1), 2)
    height = round(geometry.d_1 + geometry.L_3 + 0.75 * (geometry.L_1 + geometry.L_2), 3)
    let: dict[sp.Symbol, sp.Expr] = {}
    branches = []
    for name in NAMED:
        angles = sp.symbols(" ".join(f"{name.replace(', ', '_')}_{i}" for i in range(1, 6)), real=True)
        let |= dict(zip(angles, _angles(name, far, height), strict=True))
        branches.append(angles)
    let |= {own: chosen(BRANCH, *enumerate(q, start=1)) for own, *q in zip(OWN, *branches, strict=True)}
    views, words = [], []
    for q, title in ((branches[0], "front and up, all the way"), (OWN, "as you choose")):
        line = Line(sp.Matrix([[-far, 0, height], [far, 0, height]]), "z", 1.5)
        parts: list[Item] = [*arm_in_space(frames_of(q), size), line]
        views.append(Space((0, 0, round(0.5 * size, 4)), 0.7 * size, round(size / 6, 4), parts, title=title))
        row = f"{'left ' if q is branches[0] else 'right'}{{}}°{{}}°{{}}°{{}}°{{}}°"
        words.append(Words(row, [DEGREES * angle for angle in q], 0, columns=True))
    words.insert(0, Words(" " * 8 + "θ₁   θ₂   θ₃   θ₄   θ₅", columns=True))
    controls: list[Control] = [Slider(PLACE, "x", -far, far, far, 0.01, "m"), Choice(BRANCH, "branch", NAMED, 1)]
    title = (
        "Two arms lead the gripper over the base; a slider for its place, a choice for the branch of the right one"
    )
    fixed = values_of(P, geometry)
    return stage(views, controls, words, fixed, title, challenges=[_challenge(far)], let=let)


def _challenge(far: float) -> Challenge:
    jump = largest(*(magnitude(q - before(q)) for q in OWN))
    return Challenge(
        "Lead the right arm over the base to the left end without a jump. Where, and into which branch, do you "
        "have to change?",
        "Over the base, front and up became back and down: there both are one posture.",
        -0.98 * far - PLACE,
        sp.pi * JUMP / 180 - jump,
        f"A joint jumped by {JUMP}° or more: reset.",
    )


def _angles(branch: str, far: float, height: float) -> list[sp.Expr]:
    """Joint angles of a branch, as "front, up", for the gripper at (x, 0) on a level line, upright over the base.

    Front has azimuth 0 where x >= 0 and 180 degrees beyond; back has it the other way round, and 0 at x = 0 too,
    where a half turn of the base changes nothing but the plane that the arm is said to be in.
    """
    side, elbow = branch.split(", ")
    distance, front = magnitude(PLACE), side == "front"
    pitch = sp.pi / 2 - sp.pi / 3 * distance / far
    ahead, behind = (0, sp.pi) if front else (sp.pi, 0)
    azimuth = sp.Piecewise((behind, PLACE < 0), (ahead, PLACE > 0), (0, True))
    place = (azimuth, distance if front else -distance, height, pitch if front else sp.pi - pitch, 0)
    task = dict(zip(TASK, map(sp.sympify, place), strict=True))
    wrist = dict(zip(WRIST, formulas.wrist().xreplace(task), strict=True))
    bend = -1 if (side, elbow) in (("front", "up"), ("back", "down")) else 1  # up and down as seen from its side
    angles = light(formulas.joint_angles()).xreplace({formulas.SIGMA: sp.Integer(bend)})
    return list(angles.xreplace(wrist).xreplace(task))
