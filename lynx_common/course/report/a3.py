"""Section 1.3 of the report, inverse kinematics: its equations, figures and claims.

The report's phi is here the symbol ``pitch``, and its P_joint4x and P_joint4y are ``r_wrist`` and ``h``.
"""

import numpy as np
import sympy as sp
from sympy import acos, atan, atan2, cos, pi, sin, sqrt

from ...symbolic import TASK, WRIST, P, Q
from .a1 import DISTAL, link
from .item import claim, equation, formula, numbers

theta_1, theta_2, theta_3, theta_4, theta_5 = Q
d_1, L_1, L_2, L_3 = P
r, z, pitch = TASK[1:4]
r_wrist, h = WRIST
x, y, D, sigma, c_3, c_2, s_2 = sp.symbols("x y D sigma c_3 c_2 s_2", real=True)
x_off, side = sp.Symbol("x", real=True, nonzero=True), sp.Symbol("side", real=True)  # front 1, back -1
in_front = sp.Symbol("x", positive=True)
R_13, R_23, R_31, R_32, R_33 = sp.symbols("R_13 R_23 R_31 R_32 R_33", real=True)
forearm, gripper = theta_2 + theta_3, theta_2 + theta_3 + theta_4

LINKS = [link(DISTAL, i)[:3, :3] for i in range(5)]
R_wrist, R_target = sp.MatrixSymbol("R_wrist", 3, 3), sp.MatrixSymbol("R_target", 3, 3)
T_1, T_2, T_3 = (sp.MatrixSymbol(f"T_{i}", 3, 3) for i in (1, 2, 3))
TO_THE_WRIST, TO_THE_GRIPPER = LINKS[0] * LINKS[1] * LINKS[2], sp.prod(LINKS[1:], LINKS[0])

WRIST_UP = L_1 * sin(theta_2) + L_2 * sin(forearm)
ALONG, ACROSS = L_1 + L_2 * cos(theta_3), L_2 * sin(theta_3)  # the wrist seen along the upper arm
COSINE = (r_wrist**2 + h**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)
DISTANCE_2 = r_wrist**2 + h**2

TABLE_1_1 = {theta_4: theta_4 + pi / 2}
IF_TABLE_1_1 = "holds, if theta_4 is that of Table 1.1, 90 deg less than that of Table 1.2"
LOWER = "with theta_4 of Table 1.2 the gripper points 90 deg lower than theta_2 + theta_3 + theta_4"
ONE_ELBOW = "holds, if the elbow with a positive theta_3 is meant; the negative one reaches the same wrist"
NO_SIGN = "a cosine leaves the sign of the angle open, and the formula takes one of the two"
NOT_AT_90 = "cos(theta_1) is not 0; x cos(theta_1) + y sin(theta_1) is right there too"
AT_90 = "at theta_1 = 90 deg x / cos(theta_1) is 0/0"

c, s, C, S = cos(theta_1), sin(theta_1), cos(pitch), sin(pitch)
UPRIGHT = sp.Matrix([[C, 0, S, x], [0, 1, 0, y], [-S, 0, C, z], [0, 0, 0, 1]])
IN_THE_PLANE = sp.Matrix([[c * C, -s, -c * S, x], [s * C, c, -s * S, y], [S, 0, C, z], [0, 0, 0, 1]])

# Fig. 1.5: five angles in degrees, position and its error in metres, orientation row by row and its error.
ORIENTATION = [0.7071, 0, 0.7071, -0.7071, 0, 0.7071, 0, -1, 0]
FIG_1_5 = np.array([45, 5.2644, 60, 24.7356, 90, 0.2707, 0.2707, 0.3, 0.1, *ORIENTATION, 2.1414])
FIG_1_5_RIGHT = np.array([45, 60.8808, -82.8192, -158.0616, 135, 0.2, 0.2, 0.3, 0, *np.eye(3).ravel(), 0])

NOTEBOOK = "A3_inverse_kinematics"
PRINTED = {
    "1.3, pp. 5-7": {
        "eq. 1.3": formula(
            "the azimuth of the base",
            equation(theta_1, atan(y / in_front)),
            "holds, if x > 0; for x < 0 it points the other way, and at x = 0 it divides by zero",
            "the r of (1.4) is never negative, and for a target at (-0.3, 0.2) m it is -33.7 deg instead of "
            "146.3 deg",
            condition={x: in_front},
        ),
        "eq. 1.4": formula(
            "what the triangle of the links has to span: distance and height of the target",
            equation(sp.Matrix([r_wrist, h]), sp.Matrix([r, z - d_1])),
            "holds, if L_3 = 0; otherwise the triangle ends at the wrist, which is L_3 short of the target",
            "upper arm and forearm span a triangle up to the wrist, and the gripper is L_3 beyond it",
            condition={L_3: sp.Integer(0)},
        ),
        "eq. 1.5": formula("the law of cosines for the elbow", equation(D, COSINE)),
        "eq. 1.6": formula(
            "the elbow's angle",
            equation(theta_3, atan2(sqrt(1 - D**2), D)),
            ONE_ELBOW,
            NO_SIGN,
            condition={sigma: sp.Integer(1)},
        ),
        "eq. 1.7": formula("the shoulder's angle", equation(theta_2, atan2(h, r_wrist) - atan2(ACROSS, ALONG))),
        "eq. 1.8": formula(
            "the orientation of the forearm",
            equation(R_wrist, sp.MatMul(T_1, T_2, T_3)),
            meaning=dict(zip((T_1, T_2, T_3), LINKS, strict=False)),
        ),
        "eq. 1.9": formula(
            "what remains for the wrist to do",
            equation(sp.MatrixSymbol("R_remaining", 3, 3), sp.MatMul(R_wrist.T, R_target)),
            meaning={R_wrist: TO_THE_WRIST, R_target: TO_THE_GRIPPER},
        ),
        "eq. 1.10": formula(
            "theta_4 from what remains",
            equation(theta_4, atan(R_23 / R_13)),
            "wrong: it is atan2(R_13, -R_23)",
            "R_13 is sin(theta_4) and R_23 is -cos(theta_4): the entries are swapped, and a sign is lost",
            right=atan2(R_13, -R_23),
        ),
        "eq. 1.11": formula(
            "theta_5 from what remains",
            equation(theta_5, atan2(sqrt(R_13**2 + R_23**2), R_33)),
            "wrong: it is atan2(R_31, R_32)",
            "R_33 is 0 and the root is 1 for every orientation the arm can take, so it is always 90 deg",
            right=atan2(R_31, R_32),
        ),
        "eq. 1.12": formula(
            "the gripper's pitch",
            equation(pitch, theta_2 + theta_3 + theta_4),
            IF_TABLE_1_1,
            LOWER,
            condition=TABLE_1_1,
        ),
        "eq. 1.13": formula(
            "the gripper's pose for a pitch, x along the gripper",
            equation(sp.MatrixSymbol("T", 4, 4), UPRIGHT),
            "wrong: its turn is one by theta_1 about z, times one by minus the pitch about y",
            "it leaves out theta_1, and for a positive pitch it points down, where (1.16) has it point up",
            right=IN_THE_PLANE,
        ),
        "eq. 1.14": formula(
            "the azimuth of the base",
            equation(theta_1, atan(y / x_off)),
            "holds, if x > 0, or x < 0 and phi is read as 180 deg - phi; at x = 0 it divides by zero",
            "for x < 0 the shoulder turns away, and with phi as given pose e of Table 1.4 is out of reach",
            condition={side: sp.sign(x_off)},
        ),
        "eq. 1.15": formula(
            "signed distance of the gripper from the base axis, as a sum of three links",
            sp.Matrix([L_1 * cos(theta_2) + L_2 * cos(forearm) + L_3 * cos(gripper), x / cos(theta_1)]),
            f"{IF_TABLE_1_1}, and {NOT_AT_90}",
            f"theta_4 of Table 1.2 is 90 deg more, and {AT_90}",
            condition=TABLE_1_1 | {y: x * sp.tan(theta_1)},
        ),
        "eq. 1.16": formula(
            "height of the gripper over the shoulder, as a sum of three links",
            equation(z - d_1, WRIST_UP + L_3 * sin(gripper)),
            IF_TABLE_1_1,
            LOWER,
            condition=TABLE_1_1,
        ),
        "eq. 1.17": formula(
            "signed distance of the wrist",
            sp.Matrix([x / cos(theta_1) - L_3 * cos(pitch), L_1 * cos(theta_2) + L_2 * cos(forearm)]),
            f"holds, if {NOT_AT_90}",
            AT_90,
            condition={y: x * sp.tan(theta_1)},
        ),
        "eq. 1.18": formula(
            "height of the wrist over the shoulder", sp.Matrix([z - d_1 - L_3 * sin(pitch), WRIST_UP])
        ),
        "eq. 1.19": formula("the law of cosines for the elbow", equation(c_3, COSINE)),
        "eq. 1.20": formula(
            "the elbow's angle",
            equation(theta_3, acos(c_3)),
            ONE_ELBOW,
            NO_SIGN,
            condition={sigma: sp.Integer(1)},
        ),
        "eq. 1.21": formula(
            "the shoulder's sine", equation(sp.Symbol("s_2"), (ALONG * h - ACROSS * r_wrist) / DISTANCE_2)
        ),
        "eq. 1.22": formula(
            "the shoulder's cosine",
            equation(c_2, (ALONG * r_wrist - ACROSS * h) / DISTANCE_2),
            "wrong: the sign between the two terms is plus",
            "with the minus the squares of sine and cosine do not add up to 1",
            right=(ALONG * r_wrist + ACROSS * h) / DISTANCE_2,
        ),
        "eq. 1.23": formula("the shoulder's angle from its sine and cosine", equation(theta_2, atan2(s_2, c_2))),
        "eq. 1.24": formula(
            "the wrist's angle, from the pitch and the two angles before it",
            equation(theta_4, pitch - theta_3 - theta_2),
            IF_TABLE_1_1,
            LOWER,
            condition={pitch: pitch - pi / 2},
        ),
    },
    "1.3.1, p. 6": {
        "Fig. 1.5": numbers(
            "joint angles for R = I at (0.2, 0.2, 0.3) m, and the pose that they give: off by 0.1 m and 2.1414",
            FIG_1_5,
            4,
            "wrong: four sets of angles reach the pose with no error, the first with theta_1 to theta_5 at "
            "45, 60.8808, -82.8192, -158.0616, 135 deg",
            "it has the wrist at the target, where the gripper belongs, and its last two angles are those of "
            "(1.10) and (1.11)",
            right=FIG_1_5_RIGHT,
        ),
    },
    "1.3.2, p. 8": {
        "Fig. 1.6": numbers(
            "theta_1 to theta_4 (of Table 1.1) for (0.30, 0.20, 0.35) m: 0.59, 0, 1.10, -0.32; "
            "the pitch of 45 deg is ours, none is printed",
            [0.59, 0.00, 1.10, -0.32],
            2,
        ),
    },
    "1.3, p. 7": {
        "claim A3.1": claim(
            "an error of 0.1 m means that the solution is relatively accurate",
            "wrong: the wrist was put where the gripper belongs, and the error is L_3",
            "with another L_3, from 0 to 0.2 m, the angles are the same and the error is that L_3",
        ),
        "claim A3.2": claim(
            "the orientation error may come from the ranges of the joints or from the mechanics",
            "wrong: it comes from (1.10) and (1.11)",
            "with (1.10) and (1.11) mended, the same first three angles leave no error of orientation",
        ),
        "claim A3.3": claim(
            "the method is numerical; its convergence or initial guess may be at fault",
            "wrong: it is a chain of closed formulas, in which nothing converges",
            "it puts the wrist, for which it solves, on the target to rounding",
        ),
        "claim A3.4": claim("once theta_1 is known, what remains is a planar arm of three links"),
    },
}
