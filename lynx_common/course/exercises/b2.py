"""Exercises of B2, animation: where the elbow is, how to come to full stretch, another robot over its own base."""

from itertools import product

import numpy as np

from ... import arm
from .answers import Form
from .exercise import Exercise
from .reader import Own

d_1, L_1, L_2, L_3 = arm.LYNX

# B2.1: the elbow for these angles.
POSTURE = np.deg2rad([90, 60, -45, 75, 0])
ELBOW, WRIST, GRIPPER = arm.joint_positions(POSTURE)[2:]
IN_DEGREES = arm.joint_positions(np.rad2deg(POSTURE) % (2 * np.pi))[2]

# B2.2: theta_3 ~ u^(n/2), for n = 1 to 6; whether its first and second derivative at u = 0 are finite.
FINITE = np.array([0, 1, 0, 1, 1, 1])

# B2.3: two level links; the gripper runs straight over the column.
JUMPED = "the gripper is there, but joint 1 has jumped by half a turn over the column."
WRAPPED = "the posture is right, but an angle is wrapped: on the way it would have to jump by a full turn."


def over_the_column(link: float, start: float) -> Exercise:
    """B2.3: the length of either link, and where the gripper starts on the x axis, in metres."""
    half = float(np.arccos(-start / (2 * link)))
    turn = np.rad2deg(half)
    end = np.array([-half, 2 * half])
    at_start = np.array([half - np.pi, 2 * np.pi - 2 * half])
    return Exercise(
        form=Form((2,)),
        unit="radians",
        right=end,
        misconceptions=(
            (at_start + [np.pi, 0], JUMPED),
            (at_start - [np.pi, 0], JUMPED),
            *(
                (end + 2 * np.pi * np.array(turns), WRAPPED)
                for turns in product((-1, 0, 1), repeat=2)
                if turns != (0, 0)
            ),
            (at_start, "this is where it starts."),
            (-at_start, "this is the other elbow, at the start."),
            (end[::-1], "theta_1 comes first."),
        ),
        hints=(
            "With equal links the gripper is 2 L cos(theta_2 / 2) from the column, in the direction "
            "theta_1 + theta_2 / 2. Let that distance have a sign.",
            f"The direction stays 0 all the way. At the end the distance is -{start} m: which theta_2 > 180 deg?",
        ),
        explanation="The gripper is at the signed distance $r = 2L\\cos(\\theta_2/2)$ in the direction "
        f"$\\theta_1 + \\theta_2/2$. Keep the direction at 0 and let $r$ run from {start} m to $-{start}$ m: "
        f"$\\theta_2$ runs on through 180°, where the arm is folded, to {2 * turn:.1f}°, and "
        f"$\\theta_1 = -\\theta_2/2$ from {turn - 180:.1f}° to {-turn:.1f}°.",
        code=f"half = np.arccos(-{start} / (2 * {link}))\nanswer_3 = [-half, 2 * half]",
    )


EXERCISES = {
    "B2.1": Exercise(
        form=Form((3,)),
        unit="metres",
        right=ELBOW,
        misconceptions=(
            (WRIST, "this is the wrist, one link farther."),
            (GRIPPER, "this is the gripper; the elbow is the end of the upper arm."),
            (ELBOW[[1, 0, 2]], "this leaves out theta_1: the arm's plane is turned by 90 deg."),
            (ELBOW - [0, 0, d_1], "this is counted from the shoulder; d_1 is missing."),
            (
                [0, ELBOW[2] - d_1, d_1 + ELBOW[1]],
                "sine and cosine are swapped: theta_2 is counted from the horizontal.",
            ),
            (IN_DEGREES, "the angles went in as degrees; cos and sin take radians."),
        ),
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
        form=Form((6,), yes_no=True),
        choices=(0, 1),
        right=FINITE,
        misconceptions=(
            ([0, 1, 1, 1, 1, 1], "this keeps the speed finite; the acceleration has to be finite, too."),
            ([0, 0, 0, 1, 1, 1], "these are the ones that bring the elbow to rest; finite is less than that."),
            (
                [1, 1, 1, 1, 1, 1],
                "this is so for the gripper; the elbow goes as the square root of what is left of the path.",
            ),
            (1 - FINITE, "yes and no are swapped: 1 means that both stay finite."),
        ),
        hints=(
            "If u^n of the path is left, theta_3 is about a constant times u^(n/2). Differentiate that twice.",
            "u^p has a finite second derivative at u = 0 if p is at least 2; and for which smaller p?",
        ),
        explanation="$\\theta_3 \\sim u^{n/2}$. The second derivative goes as $\\frac{n}{2}(\\frac{n}{2} - 1)\\, "
        "u^{n/2 - 2}$: it is bounded for $n \\ge 4$, and for $n = 2$, where the factor in front is zero and the "
        "elbow passes at a steady speed. For $n = 1$ neither has a bound, for $n = 3$ only the speed has one.",
        code="answer_2 = [0, 1, 0, 1, 1, 1]",
    ),
    "B2.3": Own(over_the_column, {"link": (0.25, 0.22, 0.26, 0.001), "start": (0.3, 0.29, 0.36, 0.001)}),
}
