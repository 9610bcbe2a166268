"""Section 1.1 of the report, forward kinematics: its equations, tables, figures and claims."""

import numpy as np
import sympy as sp

from ...symbolic import ROW, P, Q
from .item import claim, equation, formula, numbers

a, alpha, d, theta = ROW
theta_1, theta_2, theta_3, theta_4, theta_5 = Q
d_1, L_1, L_2, L_3 = P
QUARTER = sp.pi / 2

LINK = sp.Matrix(
    [
        [sp.cos(theta), -sp.sin(theta) * sp.cos(alpha), sp.sin(theta) * sp.sin(alpha), a * sp.cos(theta)],
        [sp.sin(theta), sp.cos(theta) * sp.cos(alpha), -sp.cos(theta) * sp.sin(alpha), a * sp.sin(theta)],
        [0, sp.sin(alpha), sp.cos(alpha), d],
        [0, 0, 0, 1],
    ]
)

PROXIMAL = sp.Matrix(
    [
        [0, 0, 0, theta_1],
        [0, QUARTER, 0, theta_2],
        [L_1, 0, 0, theta_3],
        [L_2, 0, 0, theta_4 + QUARTER],
        [0, QUARTER, 0, theta_5],
    ]
)

DISTAL = sp.Matrix(
    [
        [0, QUARTER, d_1, theta_1],
        [L_1, 0, 0, theta_2],
        [L_2, 0, 0, theta_3],
        [0, QUARTER, 0, theta_4],
        [0, 0, L_3, theta_5],
    ]
)


def link(table: sp.Matrix, row: int) -> sp.Matrix:
    """(1.1) with a row of a distal table filled in."""
    return LINK.subs(dict(zip(ROW, table.row(row), strict=True)))


T_0_5 = sp.MatrixSymbol("T_{05}", 4, 4)
LINKS = [sp.MatrixSymbol(f"T_{{{i}{i + 1}}}", 4, 4) for i in range(5)]

# Lengths d_1, L_1, L_2, L_3 in metres, then the five joint angles in degrees.
PARAMETERS = np.array([0.1, 0.2, 0.2, 0.1, 60, 45, -30, 60, 30])

NOTEBOOK = "A1_forward_kinematics"
PRINTED = {
    "1.1, p. 2": {
        "Table 1.1": formula(
            "the proximal (modified) DH table",
            PROXIMAL,
            "holds, if frame 0 is taken at the shoulder and frame 5 at the wrist (d_1 = L_3 = 0), "
            "and its theta_4 is 90 deg less than that of Table 1.2",
            "its column d holds only zeros, and its theta_4 + 90 deg is called theta_4 in Table 1.2",
            condition={d_1: sp.Integer(0), L_3: sp.Integer(0), theta_4: theta_4 + QUARTER},
        ),
        "Fig. 1.1": formula(
            "joints and frames of the arm; drawn with the gripper level, x_5 up and z_5 forward",
            sp.Matrix([[0, 0, 1], [0, -1, 0], [1, 0, 0]]),
            "holds, if theta_2 + theta_3 + theta_4 = 90 deg with theta_4 of Table 1.2, or 0 with Table 1.1",
            "with all angles of Table 1.2 at 0 the gripper points straight down, not level",
            condition={theta_4: QUARTER - theta_2 - theta_3},
        ),
        "claim A1.1": claim(
            "the proximal convention leaves out d_1 and L_3, so the distal one must be used",
            "wrong: the proximal table carries both, d_1 in row 1 and L_3 in row 5, and serves as well",
            "with these in its column d, and the same theta_4, it gives the same pose, symbol for symbol",
        ),
    },
    "1.1, p. 3": {
        "eq. 1.1": formula(
            "the transform of one link from its row of the distal table",
            equation(sp.MatrixSymbol("T_{n-1,n}", 4, 4), LINK),
        ),
        "eq. 1.2": formula(
            "the gripper's pose is the product of the five link transforms",
            equation(T_0_5, sp.MatMul(*LINKS)),
            meaning={T: link(DISTAL, i) for i, T in enumerate(LINKS)},
        ),
        "Table 1.2": formula("the distal (standard) DH table", DISTAL),
    },
    "1.1, pp. 2-4": {
        "claim A1.2": claim(
            "Tables 1.1 and 1.2 describe one arm with one theta_4",
            "wrong: for the same pose theta_4 of Table 1.2 is 90 deg more than theta_4 of Table 1.1",
            "at theta_4 = 0 the gripper of Table 1.1 continues the forearm, that of Table 1.2 is perpendicular to "
            "it",
        ),
    },
    "1.1, p. 4": {
        "Table 1.3": numbers("lengths of the arm, and joint angles for Fig. 1.2", PARAMETERS, 9),
        "Fig. 1.2": numbers(
            "the gripper's position for Table 1.3: (0.2156, 0.373429, 0.267303) m",
            [0.2156, 0.373429, 0.267303],
            6,
        ),
        "claim A1.3": claim(
            "Fig. 1.2 shows position and orientation of the gripper",
            "holds, if orientation means the direction in which the gripper points; its roll cannot be seen",
            "with theta_5 90 deg more the picture is the same, and the orientation is another",
        ),
    },
}
