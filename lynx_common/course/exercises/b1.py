"""Exercises of B1, task planning: pitches that are possible, the roll over a belt, another machine."""

import numpy as np

from ... import arm
from .answers import Form
from .exercise import Exercise
from .reader import Own

d_1, L_1, L_2, L_3 = arm.Geometry()  # the report's


def opposite(a: float, b: float, c: float) -> float:
    """The angle between the sides b and c of a triangle, opposite to a."""
    return float(np.arccos((b**2 + c**2 - a**2) / (2 * b * c)))


# B1.1: pitches at 0.4 m, level with the shoulder; the arm stretched makes a triangle.
FAR, STRETCHED = 0.4, L_1 + L_2
PITCHES = np.array([-1, 1]) * opposite(STRETCHED, FAR, L_3)

# B1.2: belt C runs at 30 deg from x through an item at (0.25, 0.1).
AZIMUTH, ACROSS = np.arctan2(0.1, 0.25), np.deg2rad(30 + 90)
ROLL = AZIMUTH - ACROSS
WITHOUT_BASE = "this leaves out theta_1: the gripper turns with the base."


# B1.3: an excavator.
def along_the_ground(reach: float, drop: float) -> float:
    return float(np.sqrt(reach**2 - drop**2))


def excavator(boom: float, stick: float, bucket: float, joint: float, depth: float) -> Exercise:
    """B1.3: lengths, the height of the boom's joint, and the depth of the teeth, in metres."""
    drop = joint + depth - bucket
    far = along_the_ground(boom + stick, drop)
    return Exercise(
        form=Form(()),
        unit="metres",
        right=far,
        misconceptions=(
            (
                along_the_ground(boom + stick, joint + depth),
                "this puts the end of the stick at the teeth; it is a bucket's length above them.",
            ),
            (
                along_the_ground(boom + stick + bucket, joint + depth),
                "this stretches the bucket as well; it is to point straight down.",
            ),
            (
                along_the_ground(boom + stick, depth - bucket),
                f"this counts the depth from the boom's joint, which is {joint} m above the ground.",
            ),
            (boom + stick, "the end of the stick gets that far only at the height of the joint."),
        ),
        hints=(
            "Walk back from the teeth along the bucket: where is the end of the stick, from the boom's joint?",
            "Stretched, boom and stick are the long side of a right triangle. Which of its sides is the drop?",
        ),
        explanation=f"The end of the stick is a bucket's length above the teeth, at $-{depth} + {bucket} = "
        f"{bucket - depth:.1f}$ m, which is {drop:.1f} m below the joint. Stretched, boom and stick reach "
        f"{boom + stick:.1f} m: $\\sqrt{{{boom + stick:.1f}^2 - {drop:.1f}^2}} = {far:.3f}$ m.",
        code=f"answer_3 = np.sqrt(({boom} + {stick}) ** 2 - ({joint} + {depth} - {bucket}) ** 2)",
    )


EXERCISES = {
    "B1.1": Exercise(
        form=Form((2,)),
        unit="radians",
        right=PITCHES,
        misconceptions=(
            (PITCHES[::-1], "the lowest comes first."),
            (PITCHES + np.pi / 2, "this is theta_2 + theta_3 + theta_4; the pitch is 90 deg less."),
            (
                [-opposite(L_3, FAR, STRETCHED), opposite(L_3, FAR, STRETCHED)],
                "this is the angle at the shoulder; the one at the gripper is asked for.",
            ),
            (lambda x: x[0] == x[1], "these are equal; an interval is expected."),
        ),
        hints=(
            "Draw the triangle of shoulder, wrist and gripper, the arm stretched: its sides are 0.4, 0.1, 0.4 m.",
            "Section 6 gives an interval for the pitch. What are D and psi, level with the shoulder?",
        ),
        explanation="The interval of section 6 with $D = 0.4$ m and $\\psi = 0$: $k = \\frac{1}{8}$, so the "
        "pitch lies between -82.8° and 82.8°. At either end the arm is stretched.",
        code="L = arm.Geometry()\n"
        "k = (0.4**2 + L.L_3**2 - (L.L_1 + L.L_2) ** 2) / (2 * 0.4 * L.L_3)\n"
        "answer_1 = [-np.arccos(k), np.arccos(k)]",
    ),
    "B1.2": Exercise(
        form=Form(()),
        unit="radians",
        right=ROLL,
        period=np.pi,  # half a turn swaps the fingers
        misconceptions=(
            (
                ROLL + np.pi / 2,
                "this opens the fingers along the belt; they are to stand across it, so that it can run on.",
            ),
            (-ACROSS, WITHOUT_BASE),
            (ACROSS, WITHOUT_BASE),
            (AZIMUTH, "this is theta_1 alone; the fingers would open along x."),
            (-ROLL, "the sign: with the gripper down, the roll turns the other way round than the base."),
        ),
        hints=(
            "Which direction is across the belt, as an angle from x?",
            "theta_5 = theta_1 - beta. What is the azimuth of the item?",
        ),
        explanation="Across the belt is 30° + 90° = 120° from $x$. The item's azimuth is 21.8°. So $\\theta_5$ is "
        "21.8° - 120° = -98.2°, or half a turn more, 81.8°, which only swaps the fingers.",
        code="answer_2 = np.arctan2(0.1, 0.25) - np.deg2rad(120)",
    ),
    "B1.3": Own(
        excavator,
        {
            "boom": (5.7, 5.2, 6.2, 0.1),
            "stick": (2.9, 2.5, 3.2, 0.1),
            "bucket": (1.5, 1.2, 1.5, 0.1),
            "joint": (1.5, 1.4, 1.8, 0.1),
            "depth": (2.0, 2.0, 2.6, 0.1),
        },
    ),
}
