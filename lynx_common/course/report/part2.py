"""Section 2.1 of the report, the 3-RRR parallel robot: its equations, and (2.13), which repeats one of them.

``x_PP`` and ``y_PP`` are the coordinates of a platform joint, ``x_PB`` and ``y_PB`` those of the base joint of the
same leg, ``theta`` and ``psi`` the angles of its two links. Lengths are in millimetres.
"""

import sympy as sp
from sympy import cos, pi, sin

from ...symbolic import DESIGN, POSE
from .item import Facts, equation, formula

X_c, Y_c, alpha = POSE
S_A, L, r_platform, *_ = DESIGN
x_PP, y_PP, x_PB, y_PB, theta, psi, t = sp.symbols("x_PP y_PP x_PB y_PB theta psi t", real=True)
e_1, e_2, e_3, i, sign = sp.symbols("e_1 e_2 e_3 i sign", real=True)
C, R = sp.Matrix([X_c, Y_c]), sp.Matrix([[cos(alpha), -sin(alpha)], [sin(alpha), cos(alpha)]])
R_BC = sp.MatrixSymbol("R", 2, 2)

CORNER = 2 * pi * (i - 1) / 3  # of the platform, by (2.1)
E = {e_1: -2 * y_PP * S_A, e_2: -2 * x_PP * S_A, e_3: x_PP**2 + y_PP**2 + S_A**2 - L**2}
FROM_THE_BASE = {x_PP: x_PP - x_PB, y_PP: y_PP - y_PB}
APART = equation(L**2, (x_PP - x_PB) ** 2 + (y_PP - y_PB) ** 2)
FROM_THE_ELBOW = (x_PP - x_PB - S_A * cos(theta)) ** 2 + (y_PP - y_PB - S_A * sin(theta)) ** 2
ROOT = sp.sqrt(e_1**2 - (e_3 - e_2) * (e_3 + e_2))
AT_THE_ORIGIN = "it leaves out the base joint, as if all three motors were at the origin"
ANY_LENGTH = "base joint and platform joint may be anything from 40 to 300 mm apart, depending on the pose"


def _from_the_base(e: sp.Symbol, says: str) -> Facts:
    """One of (2.6) to (2.8)."""
    right = E[e].subs(FROM_THE_BASE, simultaneous=True)
    verdict = "wrong: the platform joint has to be measured from the base joint, not from the origin"
    return formula(says, equation(e, E[e]), verdict, AT_THE_ORIGIN, right=right)


NOTEBOOK = "Part2_parallel_robot"
PRINTED = {
    "2.1, pp. 14-17": {
        "eq. 2.1": formula(
            "joint i of the platform",
            equation(sp.Matrix([x_PP, y_PP]), R_BC * r_platform * sp.Matrix([cos(CORNER), sin(CORNER)]) + C),
            "wrong: by Table 2.2, which the numbers follow, every corner is 90 deg further round",
            "its first corner is to the right of the centre, that of Table 2.2 above it",
            meaning={R_BC: R},
            right=r_platform * R * sp.Matrix([cos(CORNER + pi / 2), sin(CORNER + pi / 2)]) + C,
        ),
        "eq. 2.2": formula("the rotation matrix of the platform", equation(R_BC, R)),
        "eq. 2.3": formula(
            "x of the platform joint, along the two links of its leg",
            equation(x_PP, S_A * cos(theta) + L * cos(psi)),
            "wrong: the x of the base joint is to be added",
            AT_THE_ORIGIN,
            right=x_PB + S_A * cos(theta) + L * cos(psi),
        ),
        "eq. 2.4": formula(
            "y of the platform joint, along the two links of its leg",
            equation(y_PP, S_A * sin(theta) + L * sin(psi)),
            "wrong: the y of the base joint is to be added",
            AT_THE_ORIGIN,
            right=y_PB + S_A * sin(theta) + L * sin(psi),
        ),
        "eq. 2.5": formula(
            "base joint and platform joint are L apart",
            APART,
            "wrong: elbow and platform joint are; base joint and elbow are S_A apart",
            ANY_LENGTH,
            right=FROM_THE_ELBOW,
        ),
        "eq. 2.6": _from_the_base(e_1, "factor of the sine in (2.9)"),
        "eq. 2.7": _from_the_base(e_2, "factor of the cosine in (2.9)"),
        "eq. 2.8": _from_the_base(e_3, "the term in (2.9) without theta"),
        "eq. 2.9": formula(
            "that the leg closes, as an equation for theta",
            sp.Matrix([e_1 * sin(theta) + e_2 * cos(theta) + e_3]),
            meaning=E,
        ),
        "eq. 2.10": formula(
            "the same in t = tan(theta / 2)", sp.Matrix([(e_3 - e_2) * t**2 + 2 * e_1 * t + e_3 + e_2])
        ),
        "eq. 2.11": formula(
            "its two roots",
            equation(t, (-e_1 + sign * ROOT) / (e_3 - e_2)),
            "holds, if e_3 is not e_2; where they are equal, (2.10) is linear, its root is -e_3 / e_1, and the "
            "other angle is 180 deg",
            "where e_3 = e_2 it divides by zero, and half of 180 deg has no tangent",
            condition={equation(e_2, e_3): sp.false},
        ),
        "eq. 2.12": formula("theta from t", equation(theta, 2 * sp.atan(t))),
    },
    "2.2, pp. 17-19": {
        "eq. 2.13": formula(
            "base joint and platform joint are L apart",
            APART,
            "wrong: elbow and platform joint are, as for (2.5)",
            ANY_LENGTH,
            right=FROM_THE_ELBOW,
        ),
    },
}
