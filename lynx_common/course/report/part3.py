"""Part III of the report, singularity avoidance: equations, table, figures and claims. Lengths have no unit."""

import numpy as np
import sympy as sp

from ...symbolic import Q
from .a1 import LINK, link
from .item import claim, equation, formula, numbers

theta_1, theta_2, theta_3, theta_4 = ANGLES = Q[:4]

TABLE_3_1 = sp.Matrix([[0, sp.pi / 2, 5, theta_1], [10, 0, 0, theta_2], [10, 0, 0, theta_3], [0, 0, 0, theta_4]])

# The axes z and origins p of the frames h = i - 1 and i, and the position of the end; (3.2) is about these.
Z_H, P_H, Z_I, P_I, P_END = (
    sp.Matrix(sp.symbols(f"{name}_x {name}_y {name}_z", real=True)) for name in ("z_h", "p_h", "z_i", "p_i", "p")
)
FRAME_I = dict(zip((*Z_H, *P_H), (*Z_I, *P_I), strict=True))

# (3.3) in blocks, and what they are by the table: derivatives of the end's position, axes of the frames before.
LINKS = [link(TABLE_3_1, i) for i in range(4)]
FRAMES = [sp.eye(4), *(sp.prod(LINKS[1 : i + 1], LINKS[0]) for i in range(4))]
LINEAR = [sp.MatrixSymbol(f"J_v{i}", 3, 1) for i in range(1, 5)]
ANGULAR = [sp.MatrixSymbol(f"J_w{i}", 3, 1) for i in range(1, 5)]
RATES = {J: sp.ImmutableMatrix(FRAMES[-1][:3, 3].diff(angle)) for J, angle in zip(LINEAR, ANGLES, strict=True)}
AXES = {J: sp.ImmutableMatrix(T[:3, 2]) for J, T in zip(ANGULAR, FRAMES, strict=False)}

WAYPOINTS = np.array([[0, 0, 5], [10, 0, 10], [15, 5, 10]])

NOTEBOOK = "Part3_singularity_avoidance"
PRINTED = {
    "3.1, pp. 20-21": {
        "claim P3.1": claim(
            "in a singular configuration, where the Jacobian loses rank, a robot loses degrees of freedom",
            "holds, if joint rates determine the end's velocity; the platform of a parallel robot can also gain a "
            "freedom",
            "where the lines of its distal links meet, its platform can turn infinitesimally with all motors "
            "locked",
        ),
        "claim P3.2": claim("where the determinant is zero, there are directions in which the end cannot move"),
    },
    "3.2, pp. 21-23": {
        "eq. 3.1": formula(
            "the transform of one link from its row of Table 3.1", equation(sp.MatrixSymbol("T_i", 4, 4), LINK)
        ),
        "eq. 3.2": formula(
            "the end's velocity (v, omega) for a unit rate of joint i, from an axis z_i and a point p_i on it",
            sp.Matrix.vstack(Z_I.cross(P_END - P_I), Z_I),
            "holds, if z_i and p_i belong to the axis that joint i turns about: in Table 3.1 that of frame i - 1",
            "the axis of frame i is that of the next joint, with which the columns are not the position's "
            "derivative",
            condition=FRAME_I,
        ),
        "eq. 3.3": formula(
            "the whole Jacobian, a column for each joint",
            equation(sp.MatrixSymbol("J", 6, 4), sp.BlockMatrix([LINEAR, ANGULAR])),
            meaning=RATES | AXES,
        ),
        "eq. 3.4": numbers("three waypoints; the arm reaches them", WAYPOINTS, 6),
        "Table 3.1": formula("the DH table of a four-joint arm", TABLE_3_1),
        "claim P3.3": claim("the arm has four degrees of freedom"),
        "claim P3.4": claim(
            "the Jacobian of Fig. 3.1 is derived from the forward kinematics",
            "wrong: it is another matrix, whose determinant is zero in every posture",
            "its entries differ from how the end moves when a joint turns a little, by up to 10.54 units per rad",
        ),
        "claim P3.5": claim(
            "varying theta_1, with the other angles 0, shows which configurations are singular",
            "wrong: all of these configurations are singular; theta_2 and theta_3 tell which others are",
            "the determinant does not depend on theta_1, and theta_3 = 0 makes it zero",
        ),
    },
    "3.3, pp. 23-24": {
        "Fig. 3.1": numbers(
            "least and largest determinant, for a full turn of theta_1 with the other angles at 0",
            np.array([-3.8e-14, 4.0e-14]),
            15,
            "wrong: on the whole line it is 0",
            "sin(theta_3) is a factor of it, and theta_3 is 0 throughout; what is drawn is rounding error",
            right=np.zeros(2),
        ),
        "Fig. 3.2": numbers("the waypoints, joined by two lines", WAYPOINTS, 0),
        "claim P3.6": claim(
            "peaks and troughs of the determinant are the most and the least controllable configurations",
            "wrong: the determinant has a sign; at troughs and peaks its magnitude is the same",
            "the Jacobian has the same singular values at both: 18.510, 16.383 and 5.077 units per rad",
        ),
        "claim P3.7": claim(
            "the trajectory is smooth",
            "wrong: at the second waypoint its direction changes by 50.8 deg",
            "two straight lines that meet at an angle make a corner, where the velocity jumps",
        ),
        "claim P3.8": claim(
            "the trajectory avoids singular configurations",
            "wrong: it begins in one, at the shoulder, where the rank is 1",
            "the first waypoint is reached only with theta_3 = 180 deg, where both factors of the determinant are "
            "0",
        ),
        "claim P3.9": claim(
            "the plot of the determinant validates the trajectory",
            "wrong: the plot says nothing about the trajectory",
            "the plot is of straight postures, and the trajectory has none",
        ),
    },
    "3.4, pp. 24-25": {
        "claim P3.10": claim(
            "the determinant of the position part may overlook singularities that have to do with orientation",
            "holds, if arms with a wrist of three axes are meant; for this arm's position and pitch it overlooks "
            "none",
            "it is the determinant of position and pitch as well, and the four twists depend only where "
            "sin(theta_3) is 0",
        ),
        "claim P3.11": claim("the whole Jacobian and a second-order criterion tell more than the determinant"),
        "claim P3.12": claim(
            "the analysis rests on screw theory",
            "holds, if the columns of (3.3) count as screws, which they are, about the end; what is judged is "
            "only halves",
            "the halves of joints 2 to 4 are dependent in every posture, the whole screws only where sin(theta_3) "
            "is 0",
        ),
        "claim P3.13": claim(
            "near a singular configuration a joint can have to move very fast, which makes control hard"
        ),
        "claim P3.14": claim(
            "smooth trajectories through the waypoints avoid singular configurations",
            "wrong: smoothness says nothing of singularities; the least singular value along the path would",
            "the straight line from (10, 0, 10) to (-10, 0, 10) is smooth, and crosses the base axis, where det "
            "J_p is 0",
        ),
        "claim P3.15": claim(
            "the trajectories are smooth and predictable, so that abrupt motions are unlikely",
            "holds, if the arm stops at the second waypoint; otherwise its velocity jumps there by 0.857 of its "
            "speed",
            "the path printed turns by 50.8 deg there, and says nothing of time",
        ),
        "claim P3.16": claim(
            "the method identifies and avoids singularities during operation, and so contributes to safety",
            "wrong: no posture of the path is looked at; to be shown is a bound of the least singular value along "
            "it",
            "the postures plotted are straight, none of the path is, and the path begins where the rank is 1",
        ),
    },
}
