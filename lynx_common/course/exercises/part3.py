"""Exercises of Part 3: ranks, what a structure carries, second order, an order, a wrist, damping."""

import numpy as np

from .answers import Form
from .exercise import Exercise
from .reader import Own

# P3.1: five postures (theta_2, theta_3) in degrees; ranks of the position's Jacobian, and of the whole one.
OF_POSITION, OF_ALL = np.array([2, 2, 1, 1, 3]), np.array([3, 4, 3, 3, 4])
POSITION_FOR_ALL = (
    "position-singular is taken for singular: where the end is on the base axis, the base cannot move it, but it "
    "still turns it."
)


# P3.2: what a SCARA arm carries without any motor.
def carried(f_x: float, f_y: float, f_z: float, x: float, y: float, z: float) -> Exercise:
    """P3.2, for a force, in N, and the point of the tool that it acts on, seen from the gripper, in metres."""
    m_x, m_y, m_z = np.cross([x, y, z], [f_x, f_y, f_z])
    return Exercise(
        form=Form((6,)),
        right=[0, 0, 0, m_x, m_y, 0],
        misconceptions=(
            ([f_x, f_y, f_z, m_x, m_y, m_z], "this is the whole load; a part of it is held by motors."),
            ([f_x, f_y, f_z, 0, 0, m_z], "this is what the motors hold; what they need not hold is asked for."),
            ([f_x, f_y, f_z, 0, 0, 0], "motors hold a force; and the force has a moment about the gripper."),
            ([0, 0, 0, 0, 0, 0], "some part of this load is carried; which motions can the arm not make?"),
            (
                [0, 0, f_z, m_x, m_y, 0],
                "the slide can move along z, so its motor has to hold a force along z.",
            ),
            (
                [0, 0, 0, m_x, m_y, m_z],
                "the arm can turn its gripper about z, so a motor has to hold a moment about z.",
            ),
            (
                [f_x, f_y, 0, m_x, m_y, 0],
                "the arm can move its gripper level, so motors have to hold a level force.",
            ),
            ([m_x, m_y, 0, 0, 0, 0], "the moment is written first; the force comes first."),
            ([0, 0, 0, -m_x, -m_y, 0], "this takes f x r for the moment; it is r x f."),
        ),
        hints=(
            "Which motions can the four joints make together? Three parallel axes make a plane motion.",
            "The power f . v + m . omega has to be zero for v along x, y and z, and for a turn about z. "
            "The moment of the load is r x f.",
        ),
        explanation="Three vertical axes move the gripper in the level plane and turn it about the vertical; the "
        "slide adds the third direction. So $v$ may be anything and $\\omega$ is vertical, and "
        "$f \\cdot v + m \\cdot \\omega$ is zero for all of them only if $f = 0$ and $m_z = 0$. What is left are "
        "couples about level axes, $(0, 0, 0, m_x, m_y, 0)$: the bearings carry what would tip the gripper over. "
        f"Here it is $m = r \\times f = ({m_x:.4g}, {m_y:.4g}, {m_z:.4g})$ Nm.",
        code="axes = screws.revolute([0, 0, 1], [[0, 0, 0], [0.3, 0, 0], [0.5, 0.2, 0]])\n"
        "twists = np.column_stack([*axes, screws.prismatic([0, 0, 1])])\n"
        f"force, tip = [{f_x:g}, {f_y:g}, {f_z:g}], [{x:g}, {y:g}, {z:g}]\n"
        "load, free = np.append(force, np.cross(tip, force)), screws.reciprocal_system(twists)\n"
        "answer_2 = free @ np.linalg.lstsq(free, load)[0]  # the part of the load that the columns of free span",
    )


# P3.3: a stretched arm, pushed in a little: to second order by L_1 L_2 / (L_1 + L_2) / 2 times the bend squared.
SHORTER, FOLD = 0.02, 12 * 8 / (12 + 8)


def bend_and_speed(fold: float) -> list[float]:
    """Bend, and its rate while the end moves inward at 1 unit/s, where it has come in by fold / 2 * bend**2."""
    bend = (2 * SHORTER / fold) ** 0.5
    return [bend, 1 / (fold * bend)]


# P3.4: four postures, and what their order would be by other measures.
NEAREST_FIRST = np.array([3, 2, 1, 4])  # smallest singular values 5.08, 4.23, 1.55 and 7.07
BY_SIGNED_DETERMINANT = np.array([1, 3, 2, 4])  # determinants -1534, 366, -633 and 750
BY_MAGNITUDE = np.array([2, 3, 4, 1])
BY_SHOULDER = np.array([2, 4, 1, 3])  # |r| is 16.32, 4.23, 18.51 and 8.66
SIGN = (
    "the sign of the determinant is taken for its size: the sign only tells on which side of a singularity "
    "the arm is, not how near."
)
MAGNITUDE = "this is the order of the determinant's magnitude; a small factor may hide in a product."

# P3.5: a wrist with axes z, y and (sin beta, 0, cos beta); singular values sqrt(1 + cos), 1, sqrt(1 - cos).
LEAST = 0.6
LEAN = float(np.arccos(1 - LEAST**2))


def damped(limit: float, sigma: float) -> Exercise:
    """P3.6: the joint speed allowed, in rad/s, and the singular value in whose direction something is lost."""

    def share_lost(damping: float) -> float:
        return damping**2 / (damping**2 + sigma**2)

    damping = 1 / (2 * limit)
    share = share_lost(damping)
    return Exercise(
        form=Form((2,)),
        right=[damping, share],
        parts={"the damping is": np.s_[0], "the share is": np.s_[1]},
        misconceptions=(
            (
                [1 / limit, share_lost(1 / limit)],
                "this damping keeps the limit with room to spare: the highest joint speed is half of 1/lambda.",
            ),
            ([damping, 1 - share], "the second number is the share that is left, not the one lost."),
            (
                [damping, damping / (damping**2 + sigma**2)],
                "lambda over the sum of squares is no share: its unit is that of a speed.",
            ),
            (
                [damping, sigma / (damping**2 + sigma**2)],
                "the second number is the joint speed; the error is asked.",
            ),
        ),
        hints=(
            "Section 10 gives the speed and the error over sigma. Where is the speed highest, and how high is it?",
            "The highest speed is 1/(2 lambda); the share lost is lambda^2/(sigma^2 + lambda^2).",
        ),
        explanation="The joint speed is never more than $1/(2\\lambda)$ for 1 unit/s, so "
        f"$\\lambda = 1/(2 \\cdot {limit}) = {damping:.4g}$ units per rad. At $\\sigma = {sigma:g}$ it costs "
        f"$\\lambda^2/(\\sigma^2 + \\lambda^2) = {share:.4f}$ of the motion.",
        code=f"damping = 1 / (2 * {limit})\nanswer_6 = [damping, damping**2 / (damping**2 + {sigma:g}**2)]",
    )


EXERCISES = {
    "P3.1": Exercise(
        form=Form((2, 5)),
        choices=(0, 1, 2, 3, 4),
        right=[OF_POSITION, OF_ALL],
        misconceptions=(
            ([OF_ALL, OF_POSITION], "the rows are exchanged: the position's Jacobian comes first."),
            (
                [3 - OF_POSITION, 4 - OF_ALL],
                "these are the directions lost; the ranks count those that are left.",
            ),
            *(
                ([OF_POSITION, taken], POSITION_FOR_ALL)
                for taken in (OF_POSITION, OF_POSITION + 1, [3, 3, 3, 3, 4])
            ),
            *(
                (
                    [taken, OF_ALL],
                    "a regular arm is taken for a regular position: the whole Jacobian may have full rank where "
                    "the base only turns the end, and does not move it.",
                )
                for taken in (OF_ALL - 1, np.minimum(OF_ALL, 3))
            ),
            (
                [[2, 2, 2, 2, 3], OF_ALL],
                "where both factors of the determinant vanish, the position may lose more than one direction.",
            ),
        ),
        hints=(
            "Evaluate sin(theta_3) and r = cos(theta_2) + cos(theta_2 + theta_3) for each posture.",
            "For the position: where both vanish, which columns are zero, and which are parallel? For the whole: "
            "section 3 names the only factor that makes the four screws dependent.",
        ),
        explanation="At (30°, 0°) only the elbow factor vanishes, at (45°, 90°) only $r$: the position has rank "
        "2. At (90°, 0°) the arm is stretched upright: the first column is zero, since $r = 0$, and the other two "
        "are parallel: 1. At (0°, 180°) the end is in the shoulder, and $\\theta_1$ and $\\theta_2$ do not move "
        "it: 1. (0°, 60°) is regular: 3. The whole Jacobian has rank 3 where $\\sin\\theta_3 = 0$ and else 4: at "
        "(45°, 90°) the position is singular, and the arm is not.",
        code="postures = np.zeros((5, 5))\n"
        "postures[:, 1:3] = np.deg2rad([[30, 0], [45, 90], [90, 0], [0, 180], [0, 60]])\n"
        "whole_J = arm.jacobian(postures, arm.Geometry(5, 10, 10, 0))[..., :4]\n"
        "answer_1 = [np.linalg.matrix_rank(M, tol=1e-9) for M in (whole_J[:, :3, :3], whole_J)]",
    ),
    "P3.2": Own(
        carried,
        {
            "f_x": (8, 5, 9, 1),
            "f_y": (6, 6, 9, 1),
            "f_z": (30, 20, 40, 1),
            "x": (0.05, 0.05, 0.08, 0.01),
            "y": (0.02, 0.01, 0.02, 0.005),
            "z": (-0.1, -0.12, -0.08, 0.01),
        },
    ),
    "P3.3": Exercise(
        form=Form((2,)),
        unit=("radians", ""),
        parts={"the bend is": 0, "the speed is": 1},
        right=bend_and_speed(FOLD),
        misconceptions=(
            (bend_and_speed(2 * FOLD), "the half of the second-order term is missing."),
            (
                bend_and_speed(12 * 8 * (12 + 8)),
                "this is t, the share of the kernel; the elbow turns by L_1 + L_2 times as much.",
            ),
            (bend_and_speed(10 * 10 / (10 + 10)), "these are the links of this section's arm, not 12 and 8."),
            (
                [bend_and_speed(FOLD)[0], bend_and_speed(FOLD)[0] / SHORTER],
                "the speed is the mean one since full stretch; it is not constant, and that just then is asked.",
            ),
        ),
        hints=(
            "The kernel at full stretch is (-L_2, L_1 + L_2): with a share t the elbow bends by (L_1 + L_2) t.",
            "The end comes inward by L_1 L_2 bend^2 / (2 (L_1 + L_2)). Solve for the bend; differentiate by time.",
        ),
        explanation="With the share $t$ of the kernel the end comes inward by $L_1 L_2 (L_1 + L_2)\\,t^2/2$, and "
        "the elbow bends by $\\theta_3 = (L_1 + L_2)\\,t$. So it is $\\delta = L_1 L_2\\,\\theta_3^2 / "
        "(2 (L_1 + L_2)) = 2.4\\,\\theta_3^2$. At $\\delta = 0.02$ that is 0.09129 rad, 5.2°. And $\\dot\\delta = "
        "4.8\\,\\theta_3 \\dot\\theta_3 = 1$ gives 2.282 rad/s.",
        code="bend = np.sqrt(0.02 / 2.4)\nanswer_3 = [bend, 1 / (4.8 * bend)]",
    ),
    "P3.4": Exercise(
        form=Form((4,)),
        choices=(1, 2, 3, 4),
        right=NEAREST_FIRST,
        misconceptions=(
            (NEAREST_FIRST[::-1], "this is the right order, backwards: the nearest comes first."),
            (NEAREST_FIRST - 1, "the postures are counted from 1."),
            (BY_SIGNED_DETERMINANT, SIGN),
            (BY_SIGNED_DETERMINANT[::-1], SIGN),
            (BY_MAGNITUDE, MAGNITUDE),
            (BY_MAGNITUDE[::-1], MAGNITUDE),
            (BY_SHOULDER, "this is the order of the shoulder's value |r|; the elbow may have the smaller one."),
            (lambda x: len({*x}) < 4, "each of the numbers 1 to 4 is expected once."),
        ),
        hints=(
            "Which of the three singular values says how far the worst direction is from being lost?",
            "`sigma_min` of section 7 takes postures (..., 3), in radians.",
        ),
        explanation="The smallest singular values are 5.08, 4.23, 1.55 and 7.07 units per rad. The determinants "
        "are $-1534$, $366$, $-633$ and $750$: neither by sign nor by magnitude do they give this order. Posture "
        "3 is nearly straight, and yet posture 2 has the smaller determinant.",
        code="postures = np.zeros((4, 5))\n"
        "postures[:, 1:3] = np.deg2rad([[-30, 70], [125, -120], [10, 20], [90, -120]])\n"
        "J_p = arm.jacobian(postures, arm.Geometry(5, 10, 10, 0))[..., :3, :3]\n"
        "answer_4 = np.argsort(np.linalg.svd(J_p, compute_uv=False)[:, -1]) + 1",
    ),
    "P3.5": Exercise(
        form=Form(()),
        unit="radians",
        right=LEAN,
        misconceptions=(
            (
                float(np.arcsin(LEAST)),
                "this makes the determinant 0.6; its size is not the smallest singular value.",
            ),
            (
                float(np.arccos(1 - LEAST)),
                "this takes 1 - cos(beta) for the value; its square root is meant.",
            ),
            (
                np.pi - LEAN,
                "here the third axis is as near to the first, turned over; the least lean is asked.",
            ),
        ),
        hints=(
            "The three axes are the columns of the angular Jacobian. The middle one is square to the others.",
            "For two unit columns with the angle beta between them, J^T J is [[1, c], [c, 1]] with c = cos(beta).",
        ),
        explanation="The columns are $z$, $y$ and $(\\sin\\beta, 0, \\cos\\beta)$. The second is square to the "
        "others and has the singular value 1. The other two have $J^T J$ with eigenvalues $1 \\pm \\cos\\beta$, "
        "so the smallest singular value is $\\sqrt{1 - \\cos\\beta}$. "
        "It is 0.6 at $\\cos\\beta = 0.64$: $\\beta = 0.8763$ rad, 50.2°. "
        "The determinant there is $\\sin\\beta = 0.77$.",
        code="answer_5 = np.arccos(1 - 0.6**2)",
    ),
    "P3.6": Own(damped, {"limit": (0.8, 0.6, 1.2, 0.02), "sigma": (3, 2, 5, 0.1)}),
}
