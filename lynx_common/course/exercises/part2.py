"""Exercises of Part 2, the parallel robot: a leg's span, motor angles of a mode, a full turn, assembly modes, a
self-motion and its neighbour of second order, a force at the needle, and a loose platform."""

from collections.abc import Callable

import numpy as np

from ... import rrr
from .answers import Form
from .exercise import TOLERANCE, Exercise
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


# P2.7: a third robot.
def corner(base: float, platform: float, driven: float, distal: float) -> float:
    """The turn at which the distal links point to the middle, from the triangle of PB, M and the origin."""
    elbow = platform + distal
    return float(np.arccos((base**2 + elbow**2 - driven**2) / (2 * base * elbow)))


def loose_platform(r_base: int, r_platform: int, S_A: int, L: int) -> Exercise:
    """P2.7, for a robot of these lengths, in mm."""
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
        code=f"answer_7 = np.arccos(({r_base}**2 + {elbow}**2 - {S_A}**2) / (2 * {r_base} * {elbow}))",
    )


# P2.4 and P2.5: triangles with a corner in the middle. The driven links of P2.4 end S_A short of it; the robot of
# P2.5 is the printed one of P2.7.
BOTH = np.array([-1, 1])
BASE, PLATFORM, DISTAL = 300, 100, 150


def side(one: float, other: float, degrees: float) -> float:
    """The third side of a triangle, opposite to the angle between the two given ones."""
    return float(np.sqrt(one**2 + other**2 - 2 * one * other * np.cos(np.deg2rad(degrees))))


def turns(elbow: float, distal: float = rrr.RRR.L) -> np.ndarray:
    """Both turns that close the distal link, with elbows so far from the middle and the joints 130 mm."""
    return BOTH * float(np.arccos((elbow**2 + 130**2 - distal**2) / (2 * elbow * 130)))


def entry_is(which: int, known: float) -> Callable[[np.ndarray], bool]:
    """Whether one entry of an answer is this wrong one."""
    return lambda x: abs(x[which] - known) <= TOLERANCE * known


POINTED = turns(290 - 170)
CARRIED, LONGER = side(BASE, PLATFORM, 60), side(PLATFORM, PLATFORM + DISTAL, 2) - DISTAL

# P2.6: the force, and A^-1 B with all legs bent to the left or to the right.
PUSH, NEEDLE = np.array([6, -8, 0]), np.array([30, -40, 0.2])
LEFT, RIGHT = (np.linalg.solve(*rrr.jacobians(NEEDLE, rrr.inverse_kinematics(NEEDLE)[mode])) for mode in (0, 7))
TORQUES = PUSH @ LEFT

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
        explanation="With $\\rho$ for the length and $\\delta$ for the direction of $PP_i - PB_i$, and "
        "$\\cos\\eta = (\\rho^2 + 170^2 - 130^2) / (2 \\cdot 170\\, \\rho)$, it is $\\theta_i = \\delta - \\eta$ "
        "for $+$ and $\\delta + \\eta$ for $-$: $-91.24°$, $3.77°$, $153.36°$.",
        code="pose = [-60, 80, np.deg2rad(20)]\n"
        "leg = rrr.platform_joints(pose) - rrr.base_joints()\n"
        "rho = np.linalg.norm(leg, axis=1)\n"
        "eta = np.arccos((rho**2 + 170**2 - 130**2) / (2 * 170 * rho))\n"
        "answer_2 = np.arctan2(leg[:, 1], leg[:, 0]) - np.array([-1, 1, -1]) * eta",
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
    "P2.4": Exercise(
        form=Form((2,)),
        unit="radians",
        right=POINTED,
        misconceptions=(
            (POINTED[::-1], "the smaller comes first."),
            (turns(170), "S_A is counted from the motor; how far are the elbows from the middle?"),
            (turns(290 - 130, 170), "the links are exchanged: the driven one is 170 mm."),
            (BOTH * corner(290, 130, 170, 130), "these are of type 2; the motors then do not point inwards."),
            (lambda x: x[0] == x[1], "these are equal; the two are each other's mirror images."),
        ),
        hints=(
            "Where are the elbows? On the lines from the middle to the motors, 290 - 170 mm from the middle.",
            "The middle, M_i and PP_i are corners of a triangle whose sides are 120, 130 and 130 mm.",
        ),
        explanation="The elbows are 120 mm from the middle, $PP_i$ is 130 mm from it, at $\\alpha$ to them. "
        "The triangle closes: $\\cos\\alpha = (120^2 + 130^2 - 130^2) / (2 \\cdot 120 \\cdot 130)$, so "
        "$\\alpha = \\pm 62.51°$. At $-$ the legs all bend to the left, at $+$ all to the right.",
        code="tilt = np.arccos((120**2 + 130**2 - 130**2) / (2 * 120 * 130))\nanswer_4 = [-tilt, tilt]",
    ),
    "P2.5": Exercise(
        form=Form((2,)),
        unit="millimetres",
        right=[CARRIED, LONGER],
        parts={"S_A is": 0, "the lengthening is": 1},
        misconceptions=(
            (entry_is(0, CARRIED - DISTAL), "with this S_A the legs are stretched at 60 deg."),
            (entry_is(0, side(BASE, PLATFORM, 90)), "this S_A belongs to a turn of 90 deg."),
            (entry_is(0, side(BASE, PLATFORM, 120)), "mind the sign in the law of cosines."),
            (entry_is(1, PLATFORM * np.deg2rad(2)), "this is the way of PP_i, which runs square to the link."),
            (
                entry_is(1, side(PLATFORM, PLATFORM + DISTAL, np.rad2deg(2)) - DISTAL),
                "cos takes radians; convert.",
            ),
            (entry_is(1, LONGER + DISTAL), "this is how long the links would be; asked is by how much longer."),
        ),
        hints=(
            "For (a) S_A has to be the distance d of section 7. For (b) draw the triangle of C, PP_i and M_i.",
            "(a) is the law of cosines with r_base and r_platform. In (b) M_i is 250 mm from C, and PP_i 100 mm.",
        ),
        explanation="(a) $d^2 = 300^2 + 100^2 - 2 \\cdot 300 \\cdot 100 \\cos 60° = 70000$: 264.6 mm. (b) "
        "$\\sqrt{100^2 + 250^2 - 2 \\cdot 100 \\cdot 250 \\cos 2°} - 150 = 0.1015$ mm: it hardly resists.",
        code="d_60 = np.sqrt(300**2 + 100**2 - 2 * 300 * 100 * np.cos(np.deg2rad(60)))\n"
        "link = np.sqrt(100**2 + 250**2 - 2 * 100 * 250 * np.cos(np.deg2rad(2)))\n"
        "answer_5 = [d_60, link - 150]",
    ),
    "P2.6": Exercise(
        form=Form((3,)),
        right=TORQUES,
        misconceptions=(
            (TORQUES / 1000, "this is right in N m; N mm are expected."),
            (LEFT @ PUSH, "A^-1 B takes motor speeds to speeds of the pose; for torques it is transposed."),
            (PUSH @ np.linalg.inv(LEFT), "this is B^-1 A; torques take the transpose of A^-1 B."),
            (PUSH @ RIGHT, "here all legs bend to the right."),
        ),
        hints=(
            "Work in equals work out in every motion: torques times motor speeds are the force times that of C.",
            "The pose has a third coordinate, with no moment: tau is (A^-1 B)^T times (6, -8, 0).",
        ),
        explanation="$\\tau = (A^{-1}B)^T (6, -8, 0)^T$. In two steps: $A^T \\lambda = (6, -8, 0)^T$ are the "
        "three equations of statics of the platform, with $L\\lambda_i$ the force along distal link $i$; motor "
        "$i$ holds its own link, $\\tau_i = B_{ii}\\lambda_i$.",
        code="at = [30, -40, 0.2]\n"
        "A_6, B_6 = rrr.jacobians(at, rrr.inverse_kinematics(at)[0])\n"
        "answer_6 = B_6 @ np.linalg.solve(A_6.T, [6, -8, 0])",
    ),
    "P2.7": Own(
        loose_platform,
        {
            "r_base": (300, 290, 310, 2),
            "r_platform": (100, 90, 110, 2),
            "S_A": (200, 195, 210, 5),
            "L": (150, 145, 160, 5),
        },
    ),
}
