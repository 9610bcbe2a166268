"""Stage of A1: five joint angles, the frames and the pose that they make; and a gripper to be led."""

from collections.abc import Sequence

import numpy as np
import sympy as sp
from IPython.display import HTML

from ... import arm
from ...arm import formulas
from ...symbolic import TASK, WRIST, XYZ, P, Q
from ..stage import Body, Challenge, Choice, Control, Handle, Item, Slider, Space, Words, largest, least, stage
from .solids import NAMES, arm_in_space, axes_of, length_sliders

HOME_DEG = (60, 45, -30, 60, 30)  # report Table 1.3
SHOWN = sp.Symbol("frames", real=True)


def joints_and_frames(frames: Sequence[sp.Matrix] | None = None, geometry: arm.Geometry = arm.LYNX) -> HTML:
    """Sliders for the five joint angles, or the gripper itself to be dragged; frames, and the pose of the last.

    ``frames`` : T_0_1 to T_0_5, in the symbols ``arm.Q`` and ``arm.P``, as derived in notebook A1.
    """
    frames, size = list(frames or formulas.frames()[1:]), sum(geometry)
    tip, far = frames[4][:3, 3], sum(P[1:])
    star = sp.Matrix([far / 2, -far / 4, P[0] - far / 10])
    items: list[Item] = [*arm_in_space(frames, size), Body(star.T, 0.018 * size, "target")]
    for T in (sp.eye(4), *frames[:4]):
        items += axes_of(T, 0.11 * size, SHOWN)
    items += axes_of(frames[4], 0.13 * size)
    starts = ["T₀₅ ", *[4 * " "] * 3]
    rows = [f"{start}{{}} {{}} {{}} {{}}" for start in starts]
    words = [Words(row, list(frames[4][i, :]), columns=True) for i, row in enumerate(rows)]
    words.append(Words("gripper at {}, {}, {} m", list(tip)))
    challenges = _challenges(tip, star, size)
    view = Space((0, 0, round(0.36 * size, 4)), 0.78 * size, round(size / 6, 4), items, [grip(tip)])
    title = "The arm in space, its gripper and the frames of its links; sliders for its joint angles and lengths"
    controls: list[Control] = [
        *joint_sliders(HOME_DEG),
        Choice(SHOWN, "frames", {"gripper only": -1, "all": 1}, -1),
        *length_sliders(geometry),
    ]
    return stage([view], controls, words, {P[0]: geometry.d_1}, title, challenges=challenges)


def _challenges(tip: sp.Matrix, star: sp.Matrix, size: float) -> list[Challenge]:
    down = least(
        0.03 * size - sp.sqrt((tip - star).dot(tip - star)), -sp.sin(formulas.pitch()) - sp.cos(sp.pi / 18)
    )
    r = formulas.task_coordinates()[1]
    return [
        Challenge(
            "Bring the gripper to the ball with the fork pointing down.", "At the ball, pointing down.", down
        ),
        Challenge(
            "Bring the gripper where θ₁ cannot move it.",
            "On the base axis: θ₁ turns the gripper about itself. It has lost a direction to move in.",
            0.02 * size - sp.Abs(r),
        ),
    ]


def joint_sliders(home: Sequence[float], limits: np.ndarray = arm.JOINT_LIMITS) -> list[Slider]:
    """One for each joint, between its limits."""
    facts = zip(Q, NAMES, np.rad2deg(limits).round().tolist(), home, strict=True)
    return [Slider(symbol, name, low, high, value) for symbol, name, (low, high), value in facts]


def grip(tip: sp.Matrix) -> Handle:
    """The gripper as a handle: pitch, roll and branch stay; beyond its reach the arm points at the finger."""
    x, y, z = XYZ
    side = sp.Piecewise((-1, formulas.task_coordinates()[1] < 0), (1, True))
    bend = sp.Piecewise((1, Q[2] > 0), (-1, True))
    task = [sp.atan2(side * y, side * x), side * sp.sqrt(x**2 + y**2), z, formulas.pitch(), Q[4]]
    at_finger = dict(zip(TASK, task, strict=True))
    wrist = dict(zip(WRIST, formulas.wrist().xreplace(at_finger), strict=True))
    angles = formulas.joint_angles().xreplace({formulas.SIGMA: bend} | wrist).xreplace(at_finger)
    distance, nearest, farthest = (bound.xreplace(wrist) for bound in formulas.reach())
    out = largest(distance - farthest, nearest - distance)
    text = "Out of reach: the wrist would be {} m from the shoulder; the links reach from {} to {} m."
    reason = Words(text, [distance, nearest, farthest], when=out - 1e-9)
    return Handle(tip.T, XYZ, dict(zip(Q, angles, strict=True)), [reason])
