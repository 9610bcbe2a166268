"""Exercises of Part 2, the parallel robot: a leg's span, motor angles of a mode, a full turn, a loose platform."""

from collections.abc import Callable
from functools import cache

import numpy as np

from ... import rrr
from .exercise import TOLERANCE, Exercise, numbers

# P2.1 and P2.2: the report's robot at this pose.
TURN = np.deg2rad(20)
POSE = np.array([-60, 80, TURN])
MODE = rrr.WORKING_MODES.index((-1, 1, -1))
AT_THE_ORIGIN = (rrr.RRR.S_A, rrr.RRR.L, rrr.RRR.r_platform, 1e-9)
EXCHANGED = (rrr.RRR.L, rrr.RRR.S_A)

# P2.3 and P2.4: other robots, in mm.
R_BASE, R_PLATFORM, S_A = 250, 100, 120
SHORTEST = R_BASE + R_PLATFORM - S_A
BASE, PLATFORM, DRIVEN, DISTAL = 300, 100, 200, 150


def _corner(base: float, platform: float, driven: float, distal: float) -> float:
    """The turn at which the distal links point to the middle, from the triangle of PB, M and the origin."""
    elbow = platform + distal
    return float(np.arccos((base**2 + elbow**2 - driven**2) / (2 * base * elbow)))


LOOSE = _corner(BASE, PLATFORM, DRIVEN, DISTAL)
STRETCHED = float(np.arccos((BASE**2 + PLATFORM**2 - (DRIVEN + DISTAL) ** 2) / (2 * BASE * PLATFORM)))


def _near(value: float, tolerance: float = 10 * TOLERANCE) -> Callable[[float], bool]:
    return lambda x: bool(abs(x - value) <= tolerance)


# What follows asks the robot's module when an answer is judged, not at import, which would have to compile it.


@cache
def _spans(lengths: tuple[float, ...] = (), alpha: float = TURN) -> np.ndarray:
    return rrr.leg_lengths([*POSE[:2], alpha], rrr.Geometry(*lengths))


@cache
def _modes(lengths: tuple[float, ...] = (), alpha: float = TURN) -> np.ndarray:
    return rrr.inverse_kinematics([*POSE[:2], alpha], rrr.Geometry(*lengths))


def _span(leg: int = 1, scale: float = 1, **facts) -> Callable[[float], bool]:
    return lambda x: bool(abs(x / scale - _spans(**facts)[leg]) <= 0.01)


def _mode(*modes: int, **facts) -> Callable[[np.ndarray], bool]:
    """Whether angles are those of one of ``modes``, up to full turns."""
    return lambda x: any(_apart(x, _modes(**facts)[mode]).max() <= 10 * TOLERANCE for mode in modes)


def _apart(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return np.abs(np.exp(1j * x) - np.exp(1j * y))


def _which(x: np.ndarray) -> str:
    off, other = (_apart(x, _modes()[mode]) > 10 * TOLERANCE for mode in (MODE, 7 - MODE))
    faults = [f"leg {i + 1} {'is off' if other[i] else 'bends to the other side'}" for i in np.flatnonzero(off)]
    return f"{', '.join(faults)}."


EXERCISES = {
    "P2.1": Exercise(
        read=numbers(()),
        right=_span(),
        misconceptions=(
            (_span(lengths=AT_THE_ORIGIN), "this is counted from the origin; the leg begins at PB_2."),
            (_span(alpha=20 % (2 * np.pi)), "the 20 went in as radians; cos and sin take radians, so convert."),
            (_span(alpha=0), "the platform is turned by alpha; this is the span at alpha = 0."),
            (_span(alpha=-TURN), "the platform is turned the other way; mind the signs in (2.2)."),
            (_span(0), "this is leg 1; leg 2 was asked for."),
            (_span(2), "this is leg 3; leg 2 was asked for."),
            (_span(scale=1e-3), "right in metres; millimetres are expected."),
        ),
        describe=lambda x: f"this is {abs(x - _spans()[1]):.2f} mm too {'much' if x > _spans()[1] else 'little'}.",
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
        read=numbers((3,)),
        right=_mode(MODE),
        misconceptions=(
            (lambda x: _mode(MODE)(np.deg2rad(x)), "right in degrees; radians are expected."),
            (_mode(0, 7), "one elbow for all: here legs 1 and 3 bend to one side, and leg 2 to the other."),
            (
                _mode(7 - MODE),
                "every leg bends to the other side: + is to the left on the way to the platform.",
            ),
            (
                _mode(*range(8), lengths=AT_THE_ORIGIN),
                "the base joints are left out: each leg begins at its PB_i, not at the origin.",
            ),
            (
                _mode(*range(8), lengths=EXCHANGED),
                "the links are exchanged: the driven one is 170 mm long, the distal one 130.",
            ),
            (_mode(*range(8), alpha=0), "alpha is left out."),
        ),
        describe=_which,
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
        read=numbers(()),
        right=_near(SHORTEST, 0.5),
        misconceptions=(
            (_near(R_BASE - R_PLATFORM - S_A, 0.5), "this is enough at alpha = 0, where the legs are shortest."),
            (_near(R_BASE + R_PLATFORM, 0.5), "this is what the whole leg has to span; S_A is a part of it."),
            (
                _near(abs(R_PLATFORM - S_A), 0.5),
                "the base joints are left out: motors are at PB_i, not in the middle.",
            ),
            (_near(R_BASE - R_PLATFORM + S_A, 0.5), "this is the longest that still folds at alpha = 0."),
            (_near(np.hypot(R_BASE, R_PLATFORM) - S_A, 0.5), "this is enough up to alpha = 90 deg."),
            (_near(SHORTEST / 1000, 5e-4), "right in metres; millimetres are expected."),
        ),
        describe=lambda x: (
            f"with {x:.1f} mm it "
            + ("does not get round." if x < SHORTEST else "may get round, but a shorter link does, too.")
        ),
        hints=(
            "How far is PP_i from PB_i, least and most, when the platform turns about the middle?",
            "It is 150 mm at alpha = 0 and 350 mm at 180 deg. A leg spans from |S_A - L| to S_A + L.",
        ),
        explanation="The span runs from $r_{base} - r_{platform} = 150$ mm to $r_{base} + r_{platform} = 350$ mm. "
        "So $S_A + L \\ge 350$, which makes $L \\ge 230$ mm; and $|S_A - L| \\le 150$ holds for it, $110$.",
        code="r_base, r_platform, S_A = 250, 100, 120\nanswer_3 = r_base + r_platform - S_A",
    ),
    "P2.4": Exercise(
        read=numbers(()),
        right=_near(LOOSE),
        misconceptions=(
            (_near(np.rad2deg(LOOSE), 0.05), "right in degrees; radians are expected."),
            (
                _near(-LOOSE),
                "this is the same with everything mirrored; a turn to the left is asked for.",
            ),
            (
                _near(STRETCHED),
                "here the legs are stretched: that is type 1, and the workspace ends.",
            ),
            (
                _near(_corner(BASE, PLATFORM, DISTAL, DRIVEN)),
                "the links are exchanged: the driven one is 200 mm long, the distal one 150.",
            ),
            (
                _near(_corner(290, 130, 170, 130)),
                "this is the angle of the report's robot; the one here has other lengths.",
            ),
        ),
        describe=lambda x: f"this is {abs(x - LOOSE):.4f} rad too {'much' if x > LOOSE else 'little'}.",
        hints=(
            "The three lines of the distal links are turned into each other by 120 deg. When do such lines meet?",
            "When they pass through the middle. Then M_i is r_platform + L from it: a triangle with PB_i and S_A.",
        ),
        explanation="Turned into each other by 120°, the three lines meet only if they pass through the middle. "
        "Then $M_i$ is $r_{platform} + L = 250$ mm from it, in the direction of $PP_i$, which is turned by "
        "$\\alpha$ against $PB_i$. The law of cosines: "
        "$\\cos\\alpha = (300^2 + 250^2 - 200^2) / (2 \\cdot 300 \\cdot 250) = 3/4$.",
        code="answer_4 = np.arccos((300**2 + 250**2 - 200**2) / (2 * 300 * 250))",
    ),
}
