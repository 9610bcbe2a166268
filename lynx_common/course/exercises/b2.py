"""Exercises of B2, animation: where the elbow is, how to come to full stretch, another robot over its own base."""

import numpy as np

from ... import arm
from .exercise import TOLERANCE, Exercise, numbers

d_1, L_1, L_2, L_3 = arm.LYNX


def _near(a: np.ndarray, b: np.ndarray) -> bool:
    return bool(np.abs(np.subtract(a, b)).max() <= 10 * TOLERANCE)


# B2.1: the elbow for these angles.
POSTURE = np.deg2rad([90, 60, -45, 75, 0])
ELBOW, WRIST, GRIPPER = arm.joint_positions(POSTURE)[2:]

# B2.2: theta_3 ~ u^(n/2), for n = 1 to 6; its first and second derivative at u = 0.
FINITE = np.array([0, 1, 0, 1, 1, 1])
SPEED_ONLY = np.array([0, 1, 1, 1, 1, 1])
AT_REST = np.array([0, 0, 0, 1, 1, 1])
LIKE_THE_PATH = np.array([1, 1, 1, 1, 1, 1])

# B2.3: two level links of 0.25 m; the gripper runs from (0.3, 0) to (-0.3, 0), over the column.
LINK, START = 0.25, 0.3
HALF = np.arccos(-START / (2 * LINK))
END = np.array([-HALF, 2 * HALF])
AT_START = np.array([HALF - np.pi, 2 * np.pi - 2 * HALF])
JUMPED = AT_START + [np.pi, 0]


EXERCISES = {
    "B2.1": Exercise(
        read=numbers((3,)),
        right=lambda x: _near(x, ELBOW),
        misconceptions=(
            (lambda x: _near(x, WRIST), "this is the wrist, one link farther."),
            (lambda x: _near(x, GRIPPER), "this is the gripper; the elbow is the end of the upper arm."),
            (
                lambda x: _near(x, ELBOW[[1, 0, 2]]),
                "this leaves out theta_1: the arm's plane is turned by 90 deg.",
            ),
            (lambda x: _near(x, ELBOW - [0, 0, d_1]), "this is counted from the shoulder; d_1 is missing."),
            (
                lambda x: _near(x, [0, ELBOW[2] - d_1, d_1 + ELBOW[1]]),
                "sine and cosine are swapped: theta_2 is counted from the horizontal.",
            ),
            (lambda x: _near(np.array(x) / 1000, ELBOW), "right in millimetres; metres are expected."),
            (
                lambda x: _near(x, arm.joint_positions(np.rad2deg(POSTURE))[2]),
                "the angles went in as degrees; cos and sin take radians.",
            ),
        ),
        describe=lambda x: f"this is {np.linalg.norm(x - ELBOW):.3f} m from the elbow.",
        hints=(
            "Of (1.25) to (1.38), which three belong to the elbow? Which of the five angles do they hold?",
            "Out from the axis it is L_1 cos(theta_2); theta_1 turns that from x to y.",
        ),
        explanation="Only $\\theta_1$ and $\\theta_2$ matter. The elbow is $L_1\\cos 60° = 0.1$ m out from the "
        "axis, along $y$, and $d_1 + L_1\\sin 60° = 0.2732$ m high.",
        code="L = arm.LYNX\n"
        "answer_1 = [0, L.L_1 * np.cos(np.deg2rad(60)), L.d_1 + L.L_1 * np.sin(np.deg2rad(60))]",
    ),
    "B2.2": Exercise(
        read=numbers((6,)),
        right=lambda x: _near(x, FINITE),
        misconceptions=(
            (lambda x: not np.isin(x, [0, 1]).all(), "six numbers are expected, each 1 (yes) or 0 (no)."),
            (lambda x: _near(x, SPEED_ONLY), "this keeps the speed finite; look at the acceleration for n = 3."),
            (
                lambda x: _near(x, AT_REST),
                "these are the ones that bring the elbow to rest; finite is less than that. Look at n = 2.",
            ),
            (
                lambda x: _near(x, LIKE_THE_PATH),
                "this is so for the gripper; the elbow goes as the square root of what is left of the path.",
            ),
            (lambda x: _near(x, 1 - FINITE), "yes and no are swapped: 1 means that both stay finite."),
        ),
        describe=lambda x: f"look again at n = {', '.join(str(n + 1) for n in np.flatnonzero(x != FINITE))}.",
        hints=(
            "If u^n of the path is left, theta_3 is about a constant times u^(n/2). Differentiate that twice.",
            "u^p has a finite second derivative at u = 0 if p is at least 2; and for which smaller p?",
        ),
        explanation="$\\theta_3 \\sim u^{n/2}$. The second derivative goes as $\\frac{n}{2}(\\frac{n}{2} - 1)\\, "
        "u^{n/2 - 2}$: it is bounded for $n \\ge 4$, and for $n = 2$, where the factor in front is zero and the "
        "elbow passes at a steady speed. For $n = 1$ neither has a bound, for $n = 3$ only the speed has one.",
        code="answer_2 = [0, 1, 0, 1, 1, 1]",
    ),
    "B2.3": Exercise(
        read=numbers((2,)),
        right=lambda x: _near(x, END),
        misconceptions=(
            (lambda x: _near(np.deg2rad(x), END), "this is right in degrees; radians are expected."),
            (
                lambda x: _near(x, JUMPED) or _near(x, JUMPED - [2 * np.pi, 0]),
                "the gripper is there, but joint 1 has jumped by half a turn over the column.",
            ),
            (
                lambda x: np.abs(x - END).max() > 1 and _near(np.exp(1j * x), np.exp(1j * END)),
                "the posture is right, but an angle is wrapped: on the way it would have to jump by a full turn.",
            ),
            (lambda x: _near(x, AT_START), "this is where it starts."),
            (lambda x: _near(x, END[::-1]), "theta_1 comes first."),
            (lambda x: _near(x, -AT_START), "this is the other elbow, at the start."),
        ),
        describe=lambda x: (
            f"this puts the gripper at ({LINK * (np.cos(x[0]) + np.cos(x.sum())):.3f}, "
            f"{LINK * (np.sin(x[0]) + np.sin(x.sum())):.3f}) m, or does not go there without a jump."
        ),
        hints=(
            "With equal links the gripper is 2 L cos(theta_2 / 2) from the column, in the direction "
            "theta_1 + theta_2 / 2. Let that distance have a sign.",
            "The direction stays 0 all the way. At the end the distance is -0.3 m: which theta_2, beyond 180 deg?",
        ),
        explanation="The gripper is at the signed distance $r = 2L\\cos(\\theta_2/2)$ in the direction "
        "$\\theta_1 + \\theta_2/2$. Keep the direction at 0 and let $r$ run from 0.3 m to $-0.3$ m: $\\theta_2$ "
        "runs on through 180°, where the arm is folded, to 253.7°, and $\\theta_1 = -\\theta_2/2$ from "
        "-53.1° to -126.9°.",
        code="half = np.arccos(-0.3 / (2 * 0.25))\nanswer_3 = [-half, 2 * half]",
    ),
}
