"""Exercises of A1, forward kinematics: joint angles of a pose, order of a product, another arm."""

import numpy as np
import sympy as sp

from ... import arm, dh
from ...symbolic import P, Q, numeric
from .exercise import TOLERANCE, Exercise, expressions, numbers

# A1.1: the arm stretched out level along +y.
QUARTER = np.pi / 2
OFFSET = np.array([0, 0, 0, QUARTER, 0])
TURN = np.array([QUARTER, 0, 0, 0, 0])


def _level_off(q: np.ndarray) -> tuple[float, float]:
    """Metres between the gripper and its place, and degrees between its axis and +y."""
    d_1, *links = arm.LYNX
    pose = arm.forward_kinematics(q)
    away = np.linalg.norm(pose[:3, 3] - [0, sum(links), d_1])
    return away, np.rad2deg(np.arctan2(np.linalg.norm(np.cross(pose[:3, 2], [0, 1, 0])), pose[1, 2]))


def _level(q: np.ndarray) -> bool:
    away, turned = _level_off(q)
    return max(away, np.deg2rad(turned)) <= TOLERANCE


def _describe_level(q: np.ndarray) -> str:
    away, turned = _level_off(q)
    if max(away, np.deg2rad(turned)) < 0.01:
        return "nearly; use np.pi / 2 rather than a rounded number."
    return f"the gripper is {away:.3f} m from its place, and its axis is {turned:.0f} deg off +y."


# A1.2: the camera on the forearm, for the angles of report Table 1.3.
ANGLES = np.pi / 180 * np.array([60, 45, -30, 60, 30])
CAMERA = np.array(dh.trans(-0.1, 0.03, 0), float)
PROXIMAL = np.array(dh.trans(-arm.LYNX.L_2, 0, 0), float)  # from the forearm's end to its start


def _forearm(q: np.ndarray = ANGLES) -> np.ndarray:
    return arm.link_frames(q)[3]


def _describe_camera(pose: np.ndarray) -> str:
    right = _forearm() @ CAMERA
    axes_right = np.abs(pose - right)[:3, :3].max() <= TOLERANCE
    away = np.linalg.norm((pose - right)[:3, 3])
    return f"the axes are {'right' if axes_right else 'not right'}, and the origin is {away:.3f} m from its place."


def _is(pose: np.ndarray, other: np.ndarray) -> bool:
    return bool(np.abs(pose - other).max() <= TOLERANCE)


# A1.3: the SCARA arm.
theta_1, theta_2 = Q[:2]
d_1, L_1, L_2, _ = P
d_3 = sp.Symbol("d_3", real=True)
SCARA_SYMBOLS = (theta_1, theta_2, d_1, d_3, L_1, L_2)


def _scara(second: sp.Expr, height: sp.Expr) -> sp.Matrix:
    x = L_1 * sp.cos(theta_1) + L_2 * sp.cos(second)
    y = L_1 * sp.sin(theta_1) + L_2 * sp.sin(second)
    return sp.Matrix([x, y, height])


GRIPPER = _scara(theta_1 + theta_2, d_1 - d_3)
PROXIMAL_GRIPPER = sp.Matrix([L_1 + L_2 * sp.cos(theta_1), L_2 * sp.sin(theta_1), d_1 - d_3])


def _off(position: sp.Matrix, other: sp.Matrix = GRIPPER) -> float:
    samples = np.random.default_rng(0).uniform(0.1, 1.0, (20, len(SCARA_SYMBOLS)))
    return float(np.abs(numeric(position - other, SCARA_SYMBOLS)(samples)).max())


def _describe_gripper(p: sp.Matrix) -> str:
    right = [_off(p[i : i + 1, :], GRIPPER[i : i + 1, :]) <= TOLERANCE for i in range(3)]
    return (
        ", ".join(f"{name} is {'right' if ok else 'not right'}" for name, ok in zip("xyz", right, strict=True))
        + "."
    )


EXERCISES = {
    "A1.1": Exercise(
        read=numbers((5,)),
        right=_level,
        misconceptions=(
            (lambda q: _level(np.deg2rad(q)), "this is right in degrees, and the package works in radians."),
            (
                lambda q: _level(q + OFFSET),
                "this is theta_4 of Table 1.1, counted from the forearm; in Table 1.2 it is 90 deg more.",
            ),
            (
                lambda q: _level(np.deg2rad(q) + OFFSET),
                "these are degrees, and theta_4 of Table 1.1; radians and theta_4 of Table 1.2 are expected.",
            ),
            (lambda q: _level(q + TURN), "the arm lies along +x; theta_1 turns it about the vertical, to +y."),
            (lambda q: _level(q + 2 * TURN), "the arm lies along -y; turn it half round."),
        ),
        describe=_describe_level,
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
        read=numbers((4, 4)),
        right=lambda pose: _is(pose, _forearm() @ CAMERA),
        misconceptions=(
            (
                lambda pose: _is(pose, CAMERA @ _forearm()),
                "the shift was taken along the axes of the base. It is given in frame 3, so in the product it "
                "stands to the right of T_0_3: mind the order.",
            ),
            (
                lambda pose: _is(pose, _forearm(np.rad2deg(ANGLES)) @ CAMERA),
                "the joint angles went in as degrees, and the package works in radians.",
            ),
            (
                lambda pose: _is(pose, arm.link_frames(ANGLES)[5] @ CAMERA),
                "this camera sits on the gripper; it was to sit on the forearm, which carries frame 3.",
            ),
            (
                lambda pose: any(_is(pose, arm.link_frames(ANGLES)[i] @ CAMERA) for i in (2, 4)),
                "this camera moves with the link before the forearm or after it; the forearm carries frame 3.",
            ),
            (
                lambda pose: _is(pose, _forearm() @ PROXIMAL @ CAMERA),
                "this is frame 3 of the proximal table, at the start of the forearm; frame 3 of the distal one, "
                "whose pose T_0_3 is, sits at its end.",
            ),
            (lambda pose: _is(pose, _forearm()), "this is frame 3 itself; the camera is shifted from it."),
            (lambda pose: _is(pose, np.linalg.inv(_forearm() @ CAMERA)), "this is the base seen from the camera."),
            (lambda pose: _is(pose.T, _forearm() @ CAMERA), "this is the transpose of the pose."),
        ),
        describe=_describe_camera,
        hints=(
            "Frame 3 moves with the forearm. `numeric` makes a function of its pose T_0_3, as it did of T_0_5.",
            "Neighbouring indices must match: T_0_c = T_0_3 T_3_c.",
        ),
        explanation="Read the indices: $T_{0c} = T_{03} T_{3c}$. A transform that is given in the moving frame is "
        "multiplied from the right.",
        code="forearm = numeric(T_0_3, arm.Q, arm.P)(q, arm.LYNX)\nanswer_2 = forearm @ dh.trans(-0.1, 0.03, 0)",
    ),
    "A1.3": Exercise(
        read=expressions(SCARA_SYMBOLS, 3),
        right=lambda p: _off(p) <= TOLERANCE,
        misconceptions=(
            (
                lambda p: _off(p, _scara(theta_2, d_1 - d_3)) <= TOLERANCE,
                "theta_2 is counted from the first link, so the second link points at theta_1 + theta_2.",
            ),
            (
                lambda p: _off(p, _scara(theta_1 + theta_2, d_1 + d_3)) <= TOLERANCE,
                "the slide moves the gripper down, so its d_3 lowers the gripper.",
            ),
            (
                lambda p: _off(p, PROXIMAL_GRIPPER) <= TOLERANCE,
                "this is a distal table multiplied in the proximal way: dh.modified takes a before theta, so each "
                "row needs the a of the link before.",
            ),
            (
                lambda p: _off(p.extract([1, 0, 2], [0])) <= TOLERANCE,
                "x and y are swapped: at theta_1 = theta_2 = 0 the arm lies along x.",
            ),
            (
                lambda p: sp.diff(p[2], theta_2) != 0,
                "both joint axes are vertical, so no joint angle changes the height.",
            ),
        ),
        describe=_describe_gripper,
        hints=(
            "Seen from above it is a planar arm with two links. At which angle from x does the second link point?",
            "A standard DH table of it has three rows. Which alpha in the second turns z down the slide?",
        ),
        explanation="The first row lifts by $d_1$ and reaches out by $L_1$; the second reaches out by $L_2$ "
        "and, with $\\alpha = \\pi$, turns $z$ downwards, so that the slide $d_3$ lowers the gripper.",
        code="table = [dh.Row(L_1, 0, d_1, theta_1), dh.Row(L_2, sp.pi, 0, theta_2), dh.Row(0, 0, d_3, 0)]\n"
        "answer_3 = tidy(dh.chain(table)[-1][:3, 3])",
    ),
}
