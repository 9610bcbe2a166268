"""Exercises of A1, forward kinematics: joint angles of a pose, order of a product, another arm."""

import numpy as np
import sympy as sp

from ... import arm, dh
from ...symbolic import Q
from .answers import Form
from .exercise import Exercise
from .reader import Own

QUARTER = np.pi / 2

# A1.2: the camera on the forearm, for the angles of report Table 1.3.
ANGLES = np.pi / 180 * np.array([60, 45, -30, 60, 30])
CAMERA = np.array(dh.trans(-0.1, 0.03, 0), float)
FRAMES = arm.link_frames(ANGLES)
FOREARM = FRAMES[3]
IN_DEGREES = arm.link_frames(np.rad2deg(ANGLES) % (2 * np.pi))[3]  # without a warning
PROXIMAL = np.array(dh.trans(-arm.LYNX.L_2, 0, 0), float)  # from the forearm's end to its start
POSE_UNIT = [["", "", "", "metres"]] * 3 + [[""] * 4]
POSE_PARTS = {"the position is": np.s_[:3, 3], "its axes are": np.s_[:3, :3], "its last row is": np.s_[3]}

# A1.3: the SCARA arm.
theta_1, theta_2 = Q[:2]
d_3 = sp.Symbol("d_3", real=True)
RANDOM = np.random.default_rng(0).uniform(0.1, 1.0, (3, 20))
SAMPLES = dict(zip(("theta_1", "theta_2", "d_3"), RANDOM, strict=True))


def scara(d_1: float, L_1: float, L_2: float) -> Exercise:
    """A1.3, for a column and two links of these lengths, in metres."""
    down = d_1 - d_3

    def gripper(first=theta_1, second=theta_1 + theta_2, height=down) -> list[sp.Expr]:
        """For links that point at these angles from x."""
        x = L_1 * sp.cos(first) + L_2 * sp.cos(second)
        return [x, L_1 * sp.sin(first) + L_2 * sp.sin(second), height]

    x, y, _ = gripper()
    return Exercise(
        form=Form((3,), SAMPLES),
        right=gripper(),
        parts={"x is": np.s_[:, 0], "y is": np.s_[:, 1], "z is": np.s_[:, 2]},
        misconceptions=(
            (
                gripper(second=theta_2),
                "theta_2 is counted from the first link, so the second link points at theta_1 + theta_2.",
            ),
            (gripper(height=d_1 + d_3), "the slide moves the gripper down, so its d_3 lowers the gripper."),
            (
                [L_1 + L_2 * sp.cos(theta_1), L_2 * sp.sin(theta_1), down],
                "this is a distal table multiplied in the proximal way: dh.modified takes a before theta, so each "
                "row needs the a of the link before.",
            ),
            (
                [y, x, down],
                "x and y are swapped: at theta_1 = theta_2 = 0 the arm lies along x.",
            ),
            *(
                (
                    gripper(height=down + lift),
                    "both joint axes are vertical, so no joint angle changes the height.",
                )
                for lift in (L_2 * sp.sin(theta_2), y)
            ),
            (
                gripper(theta_1 * sp.pi / 180, (theta_1 + theta_2) * sp.pi / 180),
                "this takes the angles for degrees; sin and cos take radians, and so does this course.",
            ),
        ),
        hints=(
            "Seen from above it is a planar arm with two links. At which angle from x does the second link point?",
            "A standard DH table of it has three rows. Which alpha in the second turns z down the slide?",
        ),
        explanation=f"The first row lifts by $d_1 = {d_1}$ m and reaches out by $L_1 = {L_1}$ m; the second "
        f"reaches out by $L_2 = {L_2}$ m and, with $\\alpha = \\pi$, turns $z$ downwards, so that the slide $d_3$ "
        "lowers the gripper.",
        code=f"first, second = dh.Row({L_1}, 0, {d_1}, theta_1), dh.Row({L_2}, sp.pi, 0, theta_2)\n"
        "table = [first, second, dh.Row(0, 0, d_3, 0)]\n"
        "answer_3 = tidy(dh.chain(table)[-1][:3, 3])",
    )


EXERCISES = {
    "A1.1": Exercise(
        form=Form((5,)),
        unit="radians",
        right=[QUARTER, 0, 0, QUARTER, 0],
        also=([-QUARTER, np.pi, 0, QUARTER, 0],),
        counts=lambda q: q[:4],  # any roll will do
        period=2 * np.pi,
        misconceptions=(
            (
                [QUARTER, 0, 0, 0, 0],
                "this is theta_4 of Table 1.1, counted from the forearm; in Table 1.2 it is 90 deg more.",
            ),
            ([0, 0, 0, QUARTER, 0], "the arm lies along +x; theta_1 turns it about the vertical, to +y."),
            ([-QUARTER, 0, 0, QUARTER, 0], "the arm lies along -y; turn it half round."),
        ),
        hints=(
            "Which joint alone decides in which vertical plane the arm lies?",
            "With theta_2 = theta_3 = 0 both links are level. The gripper's axis is then at theta_4 - 90 deg.",
        ),
        explanation="$\\theta_1 = 90°$ turns the arm into the plane of $y$ and $z$. "
        "With $\\theta_2 = \\theta_3 = 0$ both links are level, and so is the gripper's axis, which points at "
        "$\\theta_2 + \\theta_3 + \\theta_4 - 90°$, for "
        "$\\theta_4 = 90°$. $\\theta_5$ only rolls the gripper, so any value is right.",
        code="answer_1 = np.deg2rad([90, 0, 0, 90, 0])",
    ),
    "A1.2": Exercise(
        form=Form((4, 4)),
        unit=POSE_UNIT,
        right=FOREARM @ CAMERA,
        parts=POSE_PARTS,
        misconceptions=(
            (
                CAMERA @ FOREARM,
                "the shift was taken along the axes of the base. It is given in frame 3, so in the product it "
                "stands to the right of T_0_3: mind the order.",
            ),
            (IN_DEGREES @ CAMERA, "the joint angles went in as degrees, and the package works in radians."),
            (
                FRAMES[5] @ CAMERA,
                "this camera sits on the gripper; it was to sit on the forearm, which carries frame 3.",
            ),
            (FRAMES[2] @ CAMERA, "this camera sits on the upper arm; the forearm carries frame 3."),
            (FRAMES[4] @ CAMERA, "this camera moves with the link after the forearm, which carries frame 3."),
            (
                FOREARM @ PROXIMAL @ CAMERA,
                "this is frame 3 of the proximal table, at the start of the forearm; frame 3 of the distal one, "
                "whose pose T_0_3 is, sits at its end.",
            ),
            (FOREARM, "this is frame 3 itself; the camera is shifted from it."),
            (np.linalg.inv(FOREARM @ CAMERA), "this is the base seen from the camera."),
            ((FOREARM @ CAMERA).T, "this is the transpose of the pose."),
        ),
        hints=(
            "Frame 3 moves with the forearm. `numeric` makes a function of its pose T_0_3, as it did of T_0_5.",
            "Of T_0_3 and T_3_c, which stands on the left, so that neighbouring indices match?",
        ),
        explanation="Read the indices: $T_{0c} = T_{03} T_{3c}$. A transform that is given in the moving frame is "
        "multiplied from the right.",
        code="forearm = numeric(T_0_3, arm.Q, arm.P)(q, arm.LYNX)\nanswer_2 = forearm @ dh.trans(-0.1, 0.03, 0)",
    ),
    "A1.3": Own(
        scara, {"d_1": (0.4, 0.3, 0.6, 0.01), "L_1": (0.3, 0.25, 0.4, 0.01), "L_2": (0.25, 0.15, 0.24, 0.01)}
    ),
}
