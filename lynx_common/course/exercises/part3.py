"""Exercises of Part 3: ranks, the largest determinant, a wrist of three axes, what a structure carries."""

from collections.abc import Callable

import numpy as np

from .exercise import TOLERANCE, Exercise, numbers

# P3.1: five postures (theta_2, theta_3) in degrees, of an arm with two equal links.
POSTURES_DEG = np.array([[30, 0], [45, 90], [90, 0], [0, 180], [0, 60]])


def _position_jacobian(theta_2: float, theta_3: float) -> np.ndarray:
    """For theta_1 = 0 and links of length 10; rows x, y, z."""
    s_2, c_2 = 10 * np.sin(theta_2), 10 * np.cos(theta_2)
    s_23, c_23 = 10 * np.sin(theta_2 + theta_3), 10 * np.cos(theta_2 + theta_3)
    return np.array([[0, -s_2 - s_23, -s_23], [c_2 + c_23, 0, 0], [0, c_2 + c_23, c_23]])


RANKS = np.array(
    [np.linalg.matrix_rank(_position_jacobian(*q), tol=1e-9) for q in np.deg2rad(POSTURES_DEG)], float
)
WHOLE_RANKS = np.array([3, 4, 3, 3, 4], float)
ONE_FOR_ANY = np.array([2, 2, 2, 2, 3], float)

# P3.2: sin(theta_3) cos(theta_3 / 2) is largest where sin(theta_3 / 2)^2 = 1/3.
BEND = 2 * float(np.arcsin(1 / np.sqrt(3)))
ROUNDEST = 2 * np.pi / 3  # where the smallest singular value of shoulder and elbow is largest

# P3.3: a wrist with axes z, y and (sin beta, 0, cos beta); singular values sqrt(1 + cos), 1, sqrt(1 - cos).
LEAST = 0.6
LEAN = float(np.arccos(1 - LEAST**2))


def _near(value: float, tolerance: float = 5 * TOLERANCE) -> Callable[[float], bool]:
    return lambda x: bool(abs(x - value) <= tolerance)


def _is(expected: np.ndarray) -> Callable[[np.ndarray], bool]:
    return lambda x: bool((x == expected).all())


def _carried(wrench: np.ndarray) -> bool:
    """Whether a wrench (f, m) loads no motor of a SCARA arm: a couple about a level axis, and not zero."""
    return bool(np.abs(wrench[[0, 1, 2, 5]]).max() <= TOLERANCE < np.abs(wrench[3:5]).max())


def _holds(*places: int) -> Callable[[np.ndarray], bool]:
    """Whether one of these entries is not zero."""
    return lambda x: bool(np.abs(x[list(places)]).max() > TOLERANCE)


EXERCISES = {
    "P3.1": Exercise(
        read=numbers((5,)),
        right=_is(RANKS),
        misconceptions=(
            (
                _is(ONE_FOR_ANY),
                "where both factors of the determinant vanish, more than one direction may be lost.",
            ),
            (_is(WHOLE_RANKS), "these are ranks of the whole Jacobian; the position part is asked for."),
            (_is(3 - RANKS), "these are the directions lost; the rank counts those that are left."),
        ),
        describe=lambda x: (
            "look again at posture "
            + ", ".join(str(i + 1) for i in np.flatnonzero(x != RANKS))
            + "; which of the two factors vanish there?"
        ),
        hints=(
            "Evaluate sin(theta_3) and r = cos(theta_2) + cos(theta_2 + theta_3) for each posture.",
            "Where both vanish, write down the three columns: which of them are zero, and which are parallel?",
        ),
        explanation="At (30°, 0°) only the elbow factor vanishes, at (45°, 90°) only $r$: rank 2. At (90°, 0°) "
        "the arm is stretched upright: the first column is zero, since $r = 0$, and the other two are parallel: "
        "rank 1. At (0°, 180°) the end is in the shoulder, where $\\theta_1$ and $\\theta_2$ do not move it: 1. "
        "(0°, 60°) is regular: 3.",
        code="postures = np.zeros((5, 5))\n"
        "postures[:, 1:3] = np.deg2rad([[30, 0], [45, 90], [90, 0], [0, 180], [0, 60]])\n"
        "J_p = arm.jacobian(postures, arm.Geometry(5, 10, 10, 0))[:, :3, :3]\n"
        "answer_1 = np.linalg.matrix_rank(J_p, tol=1e-9)",
    ),
    "P3.2": Exercise(
        read=numbers(()),
        right=_near(BEND),
        misconceptions=(
            (_near(float(np.rad2deg(BEND)), 0.05), "this is right in degrees; radians are expected."),
            (_near(np.pi / 2), "there sin(theta_3) is largest, but the arm's reach shrinks as it bends."),
            (_near(ROUNDEST), "there the smallest singular value is largest; the determinant is not."),
            (_near(-BEND), "this is right for the other elbow; the positive angle is expected."),
            (_near(BEND / 2), "this is half of it: theta_3 / 2."),
        ),
        describe=lambda x: f"this is {abs(x - BEND):.4f} rad too {'much' if x > BEND else 'little'}.",
        hints=(
            "For a given theta_3, which theta_2 makes r largest? Then r is the distance from shoulder to end.",
            "That distance is 2 L cos(theta_3 / 2). Maximise sin(theta_3) cos(theta_3 / 2).",
        ),
        explanation="With the end level with the shoulder, $r = 2 L \\cos\\frac{\\theta_3}{2}$, and "
        "$|\\det| = 2 L^3 \\sin\\theta_3 \\cos\\frac{\\theta_3}{2} = 4 L^3 s (1 - s^2)$ with "
        "$s = \\sin\\frac{\\theta_3}{2}$. Its derivative $1 - 3 s^2$ is zero at "
        "$s = 1/\\sqrt 3$: $\\theta_3 = 1.2310$ rad, 70.5°.",
        code="answer_2 = 2 * np.arcsin(1 / np.sqrt(3))",
    ),
    "P3.3": Exercise(
        read=numbers(()),
        right=_near(LEAN),
        misconceptions=(
            (_near(float(np.rad2deg(LEAN)), 0.05), "this is right in degrees; radians are expected."),
            (
                _near(float(np.arcsin(LEAST))),
                "this makes the determinant 0.6; it is not the smallest singular value.",
            ),
            (
                _near(float(np.arccos(1 - LEAST))),
                "this takes 1 - cos(beta) for the value; its square root is meant.",
            ),
            (
                _near(np.pi - LEAN),
                "here the third axis is as near to the first, turned over; the least lean is asked.",
            ),
        ),
        describe=lambda x: f"this is {abs(x - LEAN):.4f} rad too {'much' if x > LEAN else 'little'}.",
        hints=(
            "The three axes are the columns of the angular Jacobian. The middle one is square to the others.",
            "For two unit columns with the angle beta between them, J^T J is [[1, c], [c, 1]] with c = cos(beta).",
        ),
        explanation="The columns are $z$, $y$ and $(\\sin\\beta, 0, \\cos\\beta)$. The second is square to the "
        "others and has the singular value 1. The other two have $J^T J$ with eigenvalues $1 \\pm \\cos\\beta$, "
        "so the smallest singular value is $\\sqrt{1 - \\cos\\beta}$. "
        "It is 0.6 at $\\cos\\beta = 0.64$: $\\beta = 0.8763$ rad, 50.2°. "
        "The determinant there is $\\sin\\beta = 0.77$.",
        code="answer_3 = np.arccos(1 - 0.6**2)",
    ),
    "P3.4": Exercise(
        read=numbers((6,)),
        right=_carried,
        misconceptions=(
            (_holds(2), "the slide can move along z, so its motor has to hold a force along z."),
            (_holds(5), "the arm can turn its tool about z, so a motor has to hold a moment about z."),
            (
                _holds(0, 1),
                "the arm can move its tool level, so motors have to hold a level force. Or did you write the "
                "moment first? The force comes first.",
            ),
        ),
        describe=lambda x: "every arm carries a wrench of zeros; another one is asked for.",
        hints=(
            "Which motions can the four joints make together? Three parallel axes make a plane motion.",
            "The power f . v + m . omega has to be zero for v along x, y and z, and for a turn about z.",
        ),
        explanation="Three vertical axes move the tool in the level plane and turn it about the vertical; the "
        "slide adds the third direction. So $v$ may be anything and $\\omega$ is vertical, and "
        "$f \\cdot v + m \\cdot \\omega$ is zero for all of them only if $f = 0$ and $m_z = 0$. What is left are "
        "couples about level axes, $(0, 0, 0, m_x, m_y, 0)$: the bearings carry what would tip the tool over.",
        code="axes = screws.revolute([0, 0, 1], [[0, 0, 0], [0.3, 0, 0], [0.5, 0.2, 0]])\n"
        "twists = np.column_stack([*axes, screws.prismatic([0, 0, 1])])\n"
        "answer_4 = screws.reciprocal_system(twists)[:, 0]",
    ),
}
