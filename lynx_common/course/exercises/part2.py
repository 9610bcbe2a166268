"""Exercises of Part 2, the parallel robot: a leg's span, motor angles of a mode, a full turn, a loose platform."""

import numpy as np

from ... import rrr
from .answers import Form
from .exercise import Exercise
from .reader import Own

# P2.1 and P2.2: the report's robot at this pose.
X_C, Y_C, TURN = -60, 80, np.deg2rad(20)
POSE = np.array([X_C, Y_C, TURN])
AT_THE_ORIGIN = rrr.Geometry(r_base=1e-9)
EXCHANGED = rrr.Geometry(S_A=rrr.RRR.L, L=rrr.RRR.S_A)
SPANS = rrr.leg_lengths(POSE)
MODES, MODE = rrr.inverse_kinematics(POSE), rrr.WORKING_MODES.index((-1, 1, -1))


def span(alpha: float) -> float:
    """Of leg 2."""
    return float(rrr.leg_lengths([X_C, Y_C, alpha])[1])


def other_legs(mode: int) -> str:
    """Which legs bend to the other side in this mode."""
    legs = [str(i + 1) for i in range(3) if rrr.WORKING_MODES[mode][i] != rrr.WORKING_MODES[MODE][i]]
    return f"leg {legs[0]} bends" if len(legs) == 1 else f"legs {' and '.join(legs)} bend"


# P2.3: another robot, in mm.
R_BASE, R_PLATFORM, S_A = 250, 100, 120


# P2.4: a third robot.
def corner(base: float, platform: float, driven: float, distal: float) -> float:
    """The turn at which the distal links point to the middle, from the triangle of PB, M and the origin."""
    elbow = platform + distal
    return float(np.arccos((base**2 + elbow**2 - driven**2) / (2 * base * elbow)))


def loose_platform(r_base: int, r_platform: int, S_A: int, L: int) -> Exercise:
    """P2.4, for a robot of these lengths, in mm."""
    elbow, loose = r_platform + L, corner(r_base, r_platform, S_A, L)
    stretched = float(np.arccos((r_base**2 + r_platform**2 - (S_A + L) ** 2) / (2 * r_base * r_platform)))
    return Exercise(
        form=Form(()),
        unit="radians",
        right=loose,
        misconceptions=(
            (-loose, "this is the same with everything mirrored; a turn to the left is asked for."),
            (stretched, "here the legs are stretched: that is type 1, and the workspace ends."),
            (
                corner(r_base, r_platform, L, S_A),
                f"the links are exchanged: the driven one is {S_A} mm long, the distal one {L}.",
            ),
            (
                corner(290, 130, 170, 130),
                "this is the angle of the report's robot; the one here has other lengths.",
            ),
        ),
        hints=(
            "The three lines of the distal links are turned into each other by 120 deg. When do such lines meet?",
            "When they pass through the middle. Then M_i is r_platform + L from it: a triangle with PB_i and S_A.",
        ),
        explanation="Turned into each other by 120°, the three lines meet only if they pass through the middle. "
        f"Then $M_i$ is $r_{{platform}} + L = {elbow}$ mm from it, in the direction of $PP_i$, which is turned by "
        "$\\alpha$ against $PB_i$. The law of cosines: "
        f"$\\cos\\alpha = ({r_base}^2 + {elbow}^2 - {S_A}^2) / (2 \\cdot {r_base} \\cdot {elbow}) = "
        f"{np.cos(loose):.4f}$.",
        code=f"answer_4 = np.arccos(({r_base}**2 + {elbow}**2 - {S_A}**2) / (2 * {r_base} * {elbow}))",
    )


EXERCISES = {
    "P2.1": Exercise(
        form=Form(()),
        unit="millimetres",
        right=SPANS[1],
        misconceptions=(
            (rrr.leg_lengths(POSE, AT_THE_ORIGIN)[1], "this is counted from the origin; the leg begins at PB_2."),
            (span(20 % (2 * np.pi)), "the 20 went in as radians; cos and sin take radians, so convert."),
            (span(0), "the platform is turned by alpha; this is the span at alpha = 0."),
            (span(-TURN), "the platform is turned the other way; mind the signs in (2.2)."),
            (SPANS[0], "this is leg 1; leg 2 was asked for."),
            (SPANS[2], "this is leg 3; leg 2 was asked for."),
        ),
        hints=(
            "Where is PP_2? It is 130 mm from C, at the angle 210 deg + alpha.",
            "PB_2 is 290 mm from the origin, at 210 deg. The span is the distance between the two points.",
        ),
        explanation="$PP_2 = C + 130\\,(\\cos 230°, \\sin 230°) = (-143.56, -19.59)$ and "
        "$PB_2 = 290\\,(\\cos 210°, \\sin 210°) = (-251.15, -145)$, in mm. They are 165.24 mm apart; the leg "
        "spans 40 to 300 mm, so it closes.",
        code="PB_2 = 290 * np.array([np.cos(np.deg2rad(210)), np.sin(np.deg2rad(210))])\n"
        "PP_2 = np.array([-60, 80]) + 130 * np.array([np.cos(np.deg2rad(230)), np.sin(np.deg2rad(230))])\n"
        "answer_1 = np.linalg.norm(PP_2 - PB_2)",
    ),
    "P2.2": Exercise(
        form=Form((3,)),
        unit="radians",
        right=MODES[MODE],
        period=2 * np.pi,
        misconceptions=(
            *(
                (MODES[mode], "one elbow for all: here legs 1 and 3 bend to one side, and leg 2 to the other.")
                for mode in (0, 7)
            ),
            (MODES[7 - MODE], "every leg bends to the other side: + is to the left on the way to the platform."),
            *(
                (MODES[mode], f"{other_legs(mode)} to the other side.")
                for mode in range(1, 7)
                if mode not in (MODE, 7 - MODE)
            ),
            *(
                (angles, "the base joints are left out: each leg begins at its PB_i, not at the origin.")
                for angles in rrr.inverse_kinematics(POSE, AT_THE_ORIGIN)
            ),
            *(
                (angles, "the links are exchanged: the driven one is 170 mm long, the distal one 130.")
                for angles in rrr.inverse_kinematics(POSE, EXCHANGED)
            ),
            *((angles, "alpha is left out.") for angles in rrr.inverse_kinematics([X_C, Y_C, 0])),
        ),
        hints=(
            "For one leg: the direction of PP_i - PB_i, and the angle at the motor by the law of cosines.",
            "A leg bends to the left where the angle at the motor is taken off, to the right where it is added.",
        ),
        explanation="With $u = PP_i - PB_i$, $\\delta = \\operatorname{atan2}(u_y, u_x)$ and "
        "$\\cos\\beta = (|u|^2 + 170^2 - 130^2) / (2 \\cdot 170\\, |u|)$ it is $\\theta_i = \\delta - \\beta$ "
        "for $+$ and $\\delta + \\beta$ for $-$: $-91.24°$, $3.77°$, $153.36°$.",
        code="pose = [-60, 80, np.deg2rad(20)]\n"
        "u = rrr.platform_joints(pose) - rrr.base_joints()\n"
        "length = np.linalg.norm(u, axis=1)\n"
        "beta = np.arccos((length**2 + 170**2 - 130**2) / (2 * 170 * length))\n"
        "answer_2 = np.arctan2(u[:, 1], u[:, 0]) - np.array([-1, 1, -1]) * beta",
    ),
    "P2.3": Exercise(
        form=Form(()),
        unit="millimetres",
        right=R_BASE + R_PLATFORM - S_A,
        misconceptions=(
            (R_BASE - R_PLATFORM - S_A, "this is enough at alpha = 0, where the legs are shortest."),
            (R_BASE + R_PLATFORM, "this is what the whole leg has to span; S_A is a part of it."),
            (abs(R_PLATFORM - S_A), "the base joints are left out: motors are at PB_i, not in the middle."),
            (R_BASE - R_PLATFORM + S_A, "this is the longest that still folds at alpha = 0."),
            (np.hypot(R_BASE, R_PLATFORM) - S_A, "this is enough up to alpha = 90 deg."),
        ),
        hints=(
            "How far is PP_i from PB_i, least and most, when the platform turns about the middle?",
            "A leg spans from |S_A - L| to S_A + L. The least and the most of that distance have to lie within.",
        ),
        explanation="The span runs from $r_{base} - r_{platform} = 150$ mm to $r_{base} + r_{platform} = 350$ mm. "
        "So $S_A + L \\ge 350$, which makes $L \\ge 230$ mm; and $|S_A - L| \\le 150$ holds for it, $110$.",
        code="r_base, r_platform, S_A = 250, 100, 120\nanswer_3 = r_base + r_platform - S_A",
    ),
    "P2.4": Own(
        loose_platform,
        {
            "r_base": (300, 290, 310, 2),
            "r_platform": (100, 90, 110, 2),
            "S_A": (200, 195, 210, 5),
            "L": (150, 145, 160, 5),
        },
    ),
}
