"""Exercises of A3, inverse kinematics: back to the wrist, another branch, another arm."""

import numpy as np
import sympy as sp

from ... import arm
from ...symbolic import P, numeric
from .exercise import TOLERANCE, Exercise, expressions, numbers

# A3.1: the wrist above a gripper that points down.
GRIPPER = np.array([0.25, 0, 0.05])


def _wrist(direction: np.ndarray) -> np.ndarray:
    return GRIPPER - arm.LYNX.L_3 * np.array(direction)


def _near(a: np.ndarray, b: np.ndarray) -> bool:
    return bool(np.abs(a - b).max() <= TOLERANCE)


# A3.2: an object behind an arm whose base turns by no more than 90 deg.
OBJECT, LIMIT = np.array([-0.2, 0.1, 0.3]), np.pi / 2
OUTWARD = OBJECT * [1, 1, 0] / np.hypot(*OBJECT[:2])


def _held(q: np.ndarray) -> bool:
    pose = arm.forward_kinematics(q)
    return _near(pose[:3, 3], OBJECT) and _near(pose[:3, 2], OUTWARD)


def _within_cable(q: np.ndarray) -> bool:
    return abs(np.angle(np.exp(1j * q[0]))) <= LIMIT + TOLERANCE


def _elbow_up(q: np.ndarray) -> bool:
    elbows = arm.joint_positions(arm.inverse_kinematics(OBJECT, 0.0)[:2])[:, 2, 2]
    return arm.joint_positions(q)[2, 2] > elbows.mean()


def _behind(q: np.ndarray) -> bool:
    return _held(q) and _within_cable(q) and bool(_elbow_up(q))


def _describe_held(q: np.ndarray) -> str:
    pose = arm.forward_kinematics(q)
    away = np.linalg.norm(pose[:3, 3] - OBJECT)
    turned = np.rad2deg(np.arccos(np.clip(pose[:3, 2] @ OUTWARD, -1, 1)))
    return f"the gripper is {away:.3f} m from the object, and its axis is {turned:.0f} deg off."


# A3.3: the SCARA arm.
x, y, z = sp.symbols("x y z", real=True)
d_1, L_1, L_2, _ = P
SCARA = (x, y, z, d_1, L_1, L_2)


def _scara_samples() -> np.ndarray:
    """Reachable targets all around the column, (n, 6) in the order of SCARA."""
    rng = np.random.default_rng(0)
    lengths = rng.uniform(0.2, 0.5, (40, 3))
    q_1, q_2 = rng.uniform(-np.pi, np.pi, 40), rng.uniform(0.2, 2.8, 40)
    reach = lengths[:, 1] * np.exp(1j * q_1) + lengths[:, 2] * np.exp(1j * (q_1 + q_2))
    return np.column_stack([reach.real, reach.imag, rng.uniform(0, 0.2, 40), lengths])


SAMPLES = _scara_samples()


def _scara_off(answer: sp.Matrix) -> np.ndarray:
    """How far the gripper is from its target along x, y, z and, in the last column, theta_2, by sample."""
    theta_1, theta_2, d_3 = numeric(answer, SCARA)(SAMPLES).T
    *target, height, first, second = SAMPLES.T
    gripper = first * np.exp(1j * theta_1) + second * np.exp(1j * (theta_1 + theta_2))
    return np.column_stack([gripper.real, gripper.imag, height - d_3, theta_2]) - np.column_stack(
        [*target, 0 * height]
    )


def _gripper_there(answer: sp.Matrix) -> bool:
    return bool((np.abs(_scara_off(answer)[:, :3]).max(axis=1) <= TOLERANCE).all())


def _describe_scara(answer: sp.Matrix) -> str:
    off = _scara_off(answer)
    if np.isnan(off).any():
        return f"for {np.isnan(off).any(axis=1).sum()} of {len(off)} targets within reach it gives no number."
    away = np.abs(off[:, :3]).max(axis=1) > TOLERANCE
    flat = np.abs(off[:, :2]).max() <= TOLERANCE
    return (
        f"the gripper misses {away.sum()} of {len(off)} targets; seen from above it is "
        f"{'right' if flat else 'off'}, "
        f"its height is {'right' if np.abs(off[:, 2]).max() <= TOLERANCE else 'off'}."
    )


EXERCISES = {
    "A3.1": Exercise(
        read=numbers((3,)),
        right=lambda p: _near(p, _wrist([0, 0, -1])),
        misconceptions=(
            (lambda p: _near(p, GRIPPER), "this is the gripper, not the wrist: there is a link between them."),
            (
                lambda p: _near(p, _wrist([0, 0, 1])),
                "the gripper points down, so the wrist is above it: walk back along the axis, not on.",
            ),
            (
                lambda p: _near(p, _wrist([1, 0, 0])),
                "this is for a gripper that points level and outwards, pitch 0.",
            ),
        ),
        describe=lambda p: f"this is {np.linalg.norm(p - _wrist([0, 0, -1])):.3f} m from the wrist.",
        hints=("The wrist is at p - L_3 n.", "The axis n of a gripper that points straight down is (0, 0, -1)."),
        explanation="The axis is $n = (0, 0, -1)$, so $p - L_3 n$ is $L_3$ *above* the gripper.",
        code="answer_1 = np.array([0.25, 0, 0.05]) - arm.LYNX.L_3 * np.array([0, 0, -1])",
    ),
    "A3.2": Exercise(
        read=numbers((5,)),
        right=_behind,
        misconceptions=(
            (lambda q: _behind(np.deg2rad(q)), "this is right in degrees, and the package works in radians."),
            (
                lambda q: _behind(q + [0, 0, 0, np.pi / 2, 0]),
                "this is theta_4 of Table 1.1; in Table 1.2 it is 90 deg more.",
            ),
            (
                lambda q: _held(q) and not _within_cable(q),
                "it holds the object, but the cable does not allow this theta_1; let the shoulder face away.",
            ),
            (lambda q: _held(q) and not _elbow_up(q), "the object is held, but with the elbow down."),
            (
                lambda q: _near(arm.forward_kinematics(q)[:3, 3], OBJECT),
                "the gripper is at the object, but points another way. inverse_kinematics takes the pitch "
                "seen from the front, for all four branches: here 0.",
            ),
        ),
        describe=_describe_held,
        hints=(
            "In which two branches is theta_1 turned by 180 deg from the direction of the object?",
            "arm.inverse_kinematics(position, pitch) returns four rows, in the order of arm.BRANCHES; pitch is 0.",
        ),
        explanation="The object's azimuth is 153°, which the cable does not allow. Turned by 180° the shoulder "
        "is at -27°, which it allows. So it has to be a *back* branch, and of these the one with the elbow up.",
        code='row = arm.BRANCHES.index(("back", "up"))\n'
        "answer_2 = arm.inverse_kinematics([-0.2, 0.1, 0.3], pitch=0.0)[row]",
    ),
    "A3.3": Exercise(
        read=expressions(SCARA, 3),
        right=lambda answer: _gripper_there(answer) and bool((_scara_off(answer)[:, 3] >= -TOLERANCE).all()),
        misconceptions=(
            (_gripper_there, "the gripper is there, but with the other elbow: theta_2 is negative."),
            (
                lambda answer: _gripper_there(sp.Matrix([answer[0], answer[1], -answer[2]])),
                "the slide lowers the gripper, so d_3 is d_1 - z.",
            ),
            (
                lambda answer: _gripper_there(answer.replace(sp.atan, _full_turn)),
                "an arc tangent of a quotient loses the quadrant; use sp.atan2(y, x).",
            ),
            (
                lambda answer: _gripper_there(sp.Matrix([answer[0], answer[1] - answer[0], answer[2]])),
                "theta_2 is counted from the first link; this is counted from x.",
            ),
            (
                lambda answer: _gripper_there(sp.Matrix([2 * sp.atan2(y, x) - answer[0], answer[1], answer[2]])),
                "in theta_1 the angle within the triangle is to be taken off, not added, for theta_2 >= 0.",
            ),
        ),
        describe=_describe_scara,
        hints=(
            "Seen from above it is the triangle of section 1, with x and y in place of r_wrist and h.",
            "cos(theta_2) = (x**2 + y**2 - L_1**2 - L_2**2) / (2 L_1 L_2); then theta_1 as in (1.7).",
        ),
        explanation="From above, the SCARA arm is the triangle of section 1, lying down: $x$ and $y$ take the "
        "place of $r_{wrist}$ and $h$, $\\theta_1$ that of $\\theta_2$, and $\\theta_2$ that of $\\theta_3$. "
        "The slide makes up the height.",
        code="C = (x**2 + y**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)\n"
        "q_2 = sp.acos(C)\n"
        "q_1 = sp.atan2(y, x) - sp.atan2(L_2 * sp.sin(q_2), L_1 + L_2 * sp.cos(q_2))\n"
        "answer_3 = [q_1, q_2, d_1 - z]",
    ),
}


def _full_turn(quotient: sp.Expr) -> sp.Expr:
    """The angle whose tangent is ``quotient``, with the quadrant that its numerator and denominator tell."""
    return sp.atan2(*sp.fraction(quotient))
