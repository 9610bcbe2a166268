"""Exercises of B1, task planning: pitches that are possible, the roll over a belt, another machine."""

import numpy as np

from ... import arm
from .exercise import TOLERANCE, Exercise, numbers

d_1, L_1, L_2, L_3 = arm.Geometry()  # the report's


def _near(a: np.ndarray, b: np.ndarray) -> bool:
    return bool(np.abs(np.subtract(a, b)).max() <= 10 * TOLERANCE)


# B1.1: pitches at 0.4 m, level with the shoulder.
FAR = 0.4
WIDEST = np.arccos((FAR**2 + L_3**2 - (L_1 + L_2) ** 2) / (2 * FAR * L_3))
PITCHES = np.array([-WIDEST, WIDEST])
AT_THE_ELBOW = np.arccos((FAR**2 + (L_1 + L_2) ** 2 - L_3**2) / (2 * FAR * (L_1 + L_2)))

# B1.2: belt C runs at 30 deg from x through an item at (0.25, 0.1).
AZIMUTH, ACROSS = np.arctan2(0.1, 0.25), np.deg2rad(30 + 90)
ROLL = AZIMUTH - ACROSS


def _same_grip(x: float) -> float:
    """Distance in radians from the nearest roll that opens across the belt: half a turn swaps the fingers."""
    return abs((x - ROLL + np.pi / 2) % np.pi - np.pi / 2)


# B1.3: the excavator.
BOOM, STICK, BUCKET, JOINT, DEPTH = 5.7, 2.9, 1.5, 1.5, 2.0


def _along_the_ground(reach: float, drop: float) -> float:
    return float(np.sqrt(reach**2 - drop**2))


REACH = _along_the_ground(BOOM + STICK, JOINT + DEPTH - BUCKET)


EXERCISES = {
    "B1.1": Exercise(
        read=numbers((2,)),
        right=lambda x: _near(x, PITCHES),
        misconceptions=(
            (lambda x: _near(np.deg2rad(x), PITCHES), "this is right in degrees; radians are expected."),
            (lambda x: _near(x[::-1], PITCHES), "the lowest comes first."),
            (
                lambda x: _near(x, PITCHES + np.pi / 2),
                "this is theta_2 + theta_3 + theta_4; the pitch is 90 deg less.",
            ),
            (
                lambda x: _near(x, [-AT_THE_ELBOW, AT_THE_ELBOW]),
                "this is the angle at the shoulder; the one at the gripper is asked for.",
            ),
            (lambda x: _near(x[0], x[1]), "these are equal; an interval is expected."),
        ),
        describe=lambda x: (
            f"the lowest is off by {abs(x[0] - PITCHES[0]):.3f} rad, "
            f"the highest by {abs(x[1] - PITCHES[1]):.3f} rad."
        ),
        hints=(
            "Draw the triangle of shoulder, wrist and gripper, the arm stretched: its sides are 0.4, 0.1, 0.4 m.",
            "With rho = 0.4 and psi = 0 the pitch lies between -arccos(k) and arccos(k).",
        ),
        explanation="The interval of section 6 with $\\rho = 0.4$ m and $\\psi = 0$: $k = \\frac{1}{8}$, so the "
        "pitch lies between -82.8° and 82.8°. At either end the arm is stretched.",
        code="L = arm.Geometry()\n"
        "k = (0.4**2 + L.L_3**2 - (L.L_1 + L.L_2) ** 2) / (2 * 0.4 * L.L_3)\n"
        "answer_1 = [-np.arccos(k), np.arccos(k)]",
    ),
    "B1.2": Exercise(
        read=numbers(()),
        right=lambda x: _same_grip(x) <= 10 * TOLERANCE,
        misconceptions=(
            (lambda x: _same_grip(np.deg2rad(x)) <= 0.01, "right in degrees; radians are expected."),
            (
                lambda x: _same_grip(x + np.pi / 2) <= 10 * TOLERANCE,
                "this opens the fingers along the belt; they are to stand across it, so that it can run on.",
            ),
            (
                lambda x: _same_grip(x + AZIMUTH) <= 10 * TOLERANCE or _same_grip(-x + AZIMUTH) <= 10 * TOLERANCE,
                "this leaves out theta_1: the gripper turns with the base.",
            ),
            (
                lambda x: _same_grip(x - ACROSS) <= 10 * TOLERANCE,
                "this is theta_1 alone; the fingers would open along x.",
            ),
            (
                lambda x: _same_grip(-x) <= 10 * TOLERANCE,
                "the sign: with the gripper down, the roll turns the other way round than the base.",
            ),
        ),
        describe=lambda x: f"the fingers are {np.rad2deg(_same_grip(x)):.0f} deg off.",
        hints=(
            "Which direction is across the belt, as an angle from x?",
            "theta_5 = theta_1 - beta. What is the azimuth of the item?",
        ),
        explanation="Across the belt is 30° + 90° = 120° from $x$. The item's azimuth is 21.8°. So $\\theta_5$ is "
        "21.8° - 120° = -98.2°, or half a turn from it, which only swaps the fingers.",
        code="answer_2 = np.arctan2(0.1, 0.25) - np.deg2rad(120)",
    ),
    "B1.3": Exercise(
        read=numbers(()),
        right=lambda x: abs(x - REACH) <= 0.006,
        misconceptions=(
            (
                lambda x: abs(x - _along_the_ground(BOOM + STICK, JOINT + DEPTH)) <= 0.006,
                "this puts the end of the stick at the teeth; it is a bucket's length above them.",
            ),
            (
                lambda x: abs(x - _along_the_ground(BOOM + STICK + BUCKET, JOINT + DEPTH)) <= 0.006,
                "this stretches the bucket as well; it is to point straight down.",
            ),
            (
                lambda x: abs(x - _along_the_ground(BOOM + STICK, DEPTH - BUCKET)) <= 0.006,
                "this counts the depth from the boom's joint, which is 1.5 m above the ground.",
            ),
            (
                lambda x: abs(x - BOOM - STICK) <= 0.006,
                "the end of the stick gets that far only at the height of the joint.",
            ),
        ),
        describe=lambda x: f"this is {abs(x - REACH):.2f} m {'too much' if x > REACH else 'too little'}.",
        hints=(
            "Walk back from the teeth along the bucket: where is the end of the stick, from the boom's joint?",
            "It is 2 m below the joint. How far out can boom and stick together reach there?",
        ),
        explanation="The end of the stick is a bucket's length above the teeth, at $-2 + 1.5 = -0.5$ m, which is "
        "2 m below the joint. Stretched, boom and stick reach 8.6 m: $\\sqrt{8.6^2 - 2^2} = 8.36$ m.",
        code="answer_3 = np.sqrt((5.7 + 2.9) ** 2 - (1.5 + 2.0 - 1.5) ** 2)",
    ),
}
