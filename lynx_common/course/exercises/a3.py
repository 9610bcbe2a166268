"""Exercises of A3, inverse kinematics: back to the wrist, another branch, another arm."""

import numpy as np
import sympy as sp

from ... import arm
from .answers import Form
from .exercise import Exercise, to_four_digits
from .reader import Own

# A3.1: the wrist above a gripper that points down.
GRIPPER = np.array([0.25, 0, 0.05])


def wrist(*axis: float) -> np.ndarray:
    return GRIPPER - arm.LYNX.L_3 * np.array(axis)


# A3.2: an object behind an arm whose base turns by no more than 90 deg.
OBJECT = np.array([-0.2, 0.1, 0.3])
FRONT_UP, FRONT_DOWN, BACK_UP, BACK_DOWN = arm.inverse_kinematics(OBJECT, 0.0)
NOT_TURNED_OVER = arm.joint_angles([BACK_UP[0], -np.hypot(*OBJECT[:2]), OBJECT[2], 0, 0])
TURN = np.array([2 * np.pi, 0, 0, 0, 0])
QUARTER = np.array([0, 0, 0, np.pi / 2, 0])
CABLE = "it holds the object, but the cable does not allow this theta_1; let the shoulder face away."


# A3.3: the SCARA arm.
x, y, z = sp.symbols("x y z", real=True)
QUADRANT = "an arc tangent of a quotient loses the quadrant; use sp.atan2(y, x)."


def targets(L_1: float, L_2: float) -> dict[str, np.ndarray]:
    """Reachable ones all around the column, the elbow neither stretched nor folded."""
    rng = np.random.default_rng(0)
    q_1, q_2 = rng.uniform(-np.pi, np.pi, 40), rng.uniform(0.2, 2.8, 40)
    reach = L_1 * np.exp(1j * q_1) + L_2 * np.exp(1j * (q_1 + q_2))
    return {"x": reach.real, "y": reach.imag, "z": rng.uniform(0, 0.2, 40)}


def of_quotient(a: sp.Expr, b: sp.Expr) -> sp.Expr:
    return sp.atan(a / b)


def scara(d_1: float, L_1: float, L_2: float) -> Exercise:
    """A3.3, for a column and two links of these lengths, in metres."""
    q_2 = sp.acos((x**2 + y**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2))

    def shoulder(q_2: sp.Expr, atan=sp.atan2, inner_atan=sp.atan2) -> sp.Expr:
        """The arc tangents take a numerator and a denominator."""
        return atan(y, x) - inner_atan(L_2 * sp.sin(q_2), L_1 + L_2 * sp.cos(q_2))

    q_1, d_3 = shoulder(q_2), d_1 - z
    return Exercise(
        form=Form((3,), targets(L_1, L_2)),
        unit=["radians", "radians", "metres"],
        right=[q_1, q_2, d_3],
        period=2 * np.pi * np.array([1, 1, 0]),
        parts={"theta_1 is": np.s_[:, 0], "theta_2 is": np.s_[:, 1], "d_3 is": np.s_[:, 2]},
        misconceptions=(
            ([shoulder(-q_2), -q_2, d_3], "the gripper is there, but with the other elbow: theta_2 is negative."),
            ([q_1, q_2, -d_3], "the slide lowers the gripper, so d_3 is d_1 - z."),
            ([shoulder(q_2, of_quotient), q_2, d_3], QUADRANT),
            ([shoulder(q_2, sp.atan2, of_quotient), q_2, d_3], QUADRANT),
            ([shoulder(q_2, of_quotient, of_quotient), q_2, d_3], QUADRANT),
            ([q_1, q_1 + q_2, d_3], "theta_2 is counted from the first link; this is counted from x."),
            (
                [2 * sp.atan2(y, x) - q_1, q_2, d_3],
                "in theta_1 the angle within the triangle is to be taken off, not added, for theta_2 >= 0.",
            ),
        ),
        hints=(
            "Seen from above it is the triangle of section 1, with x and y in place of r_wrist and h.",
            "The law of cosines gives cos(theta_2), with x**2 + y**2 for the square of the third side; "
            "then theta_1 as in (1.7).",
        ),
        explanation="From above, the SCARA arm is the triangle of section 1, lying down: $x$ and $y$ take the "
        "place of $r_{wrist}$ and $h$, $\\theta_1$ that of $\\theta_2$, and $\\theta_2$ that of $\\theta_3$. "
        f"The slide makes up the height, $d_3 = {d_1} - z$.",
        code=f"C = (x**2 + y**2 - {L_1}**2 - {L_2}**2) / (2 * {L_1} * {L_2})\n"
        "q_2 = sp.acos(C)\n"
        f"q_1 = sp.atan2(y, x) - sp.atan2({L_2} * sp.sin(q_2), {L_1} + {L_2} * sp.cos(q_2))\n"
        f"answer_3 = [q_1, q_2, {d_1} - z]",
    )


EXERCISES = {
    "A3.1": Exercise(
        form=Form((3,)),
        unit="metres",
        right=wrist(0, 0, -1),
        misconceptions=(
            (GRIPPER, "this is the gripper, not the wrist: there is a link between them."),
            (
                wrist(0, 0, 1),
                "the gripper points down, so the wrist is above it: walk back along the axis, not on.",
            ),
            (wrist(1, 0, 0), "this is for a gripper that points level and outwards, pitch 0."),
        ),
        hints=(
            "From the gripper, in which direction and how far is it back to the wrist?",
            "With n for the unit vector in which the gripper points, it is back by L_3 along n. What is n here?",
        ),
        explanation="The axis is $n = (0, 0, -1)$, so $p - L_3 n$ is $L_3$ *above* the gripper.",
        code="answer_1 = np.array([0.25, 0, 0.05]) - arm.LYNX.L_3 * np.array([0, 0, -1])",
    ),
    "A3.2": Exercise(
        form=Form((5,)),
        unit="radians",
        right=BACK_UP,
        counts=lambda q: q[:4],  # any roll will do
        period=2 * np.pi * np.array([0, 1, 1, 1]),
        misconceptions=(
            (BACK_UP - QUARTER, "this is theta_4 of Table 1.1; in Table 1.2 it is 90 deg more."),
            *((q, CABLE) for q in (FRONT_UP, FRONT_DOWN)),
            *((BACK_UP + turn, "the cable does not allow a full turn more.") for turn in (TURN, -TURN)),
            (BACK_DOWN, "the object is held, but with the elbow down."),
            *(
                (
                    q,
                    "the gripper is at the object, but points back to the base. inverse_kinematics takes the "
                    "pitch seen from the front, for all four branches: here 0.",
                )
                for q in NOT_TURNED_OVER
            ),
            (
                lambda q: to_four_digits(arm.forward_kinematics(q)[:3, 3], OBJECT),
                "the gripper is at the object, but points another way.",
            ),
        ),
        hints=(
            "In which two branches is theta_1 turned by 180 deg from the direction of the object?",
            "arm.inverse_kinematics(position, pitch) returns four rows, in the order of arm.BRANCHES; pitch is 0.",
        ),
        explanation="The object's azimuth is 153°, which the cable does not allow. Turned by 180° the shoulder "
        "is at -27°, which it allows. So it has to be a *back* branch, and of these the one with the elbow up.",
        code='row = arm.BRANCHES.index(("back", "up"))\n'
        "answer_2 = arm.inverse_kinematics([-0.2, 0.1, 0.3], pitch=0.0)[row]",
    ),
    # With L_2 > L_1 the elbow may lie behind the column, so that every arc tangent has all quadrants.
    "A3.3": Own(
        scara, {"d_1": (0.4, 0.3, 0.6, 0.01), "L_1": (0.25, 0.2, 0.28, 0.01), "L_2": (0.3, 0.32, 0.42, 0.01)}
    ),
}
