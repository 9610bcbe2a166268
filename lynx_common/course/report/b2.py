"""Section 1.5 of the report, animation: its equations, table, figures and claims.

The report counts the base as joint 1 and the gripper as joint 5; P_5x is the x coordinate of the gripper.
"""

import numpy as np
import sympy as sp
from sympy import cos, sin

from ...symbolic import P, Q
from .a3 import IF_TABLE_1_1, LOWER, TABLE_1_1
from .item import Facts, claim, equation, formula, numbers

theta_1, theta_2, theta_3, theta_4, theta_5 = Q
d_1, L_1, L_2, L_3 = P
forearm, gripper = theta_2 + theta_3, theta_2 + theta_3 + theta_4

OUT = {
    3: L_1 * cos(theta_2),
    4: L_1 * cos(theta_2) + L_2 * cos(forearm),
    5: L_1 * cos(theta_2) + L_2 * cos(forearm) + L_3 * cos(gripper),
}
UP = {
    3: L_1 * sin(theta_2) + d_1,
    4: L_1 * sin(theta_2) + L_2 * sin(forearm) + d_1,
    5: L_1 * sin(theta_2) + L_2 * sin(forearm) + L_3 * sin(gripper) + d_1,
}
NAMES = {3: "elbow", 4: "wrist", 5: "gripper"}

# Rows a to e: x, y, z in metres, pitch in degrees.
POSES = np.array([[0.32, 0, 0.2, -90], [0.2, 0, 0.4, 0], [0, 0, 0.6, 90], [-0.2, 0, 0.4, 0], [-0.32, 0, 0.2, -90]])
# Fig. 1.9: the corners in the order in which they are joined, read off the picture.
STAR = np.array([[0.2, 0, 0.4], [-0.16, 0.12, 0.4], [0.06, -0.19, 0.4], [0.06, 0.19, 0.4], [-0.16, -0.12, 0.4]])


def _position(joint: int, first: int, *verdict: str, **more) -> dict[str, Facts]:
    """The four equations of a joint: x, y, z, and all three."""
    place = [OUT[joint] * cos(theta_1), OUT[joint] * sin(theta_1), UP[joint]]
    facts = [
        formula(f"{axis} of the {NAMES[joint]}", equation(sp.Symbol(f"P_{joint}{axis}"), value), *verdict, **more)
        for axis, value in zip("xyz", place, strict=True)
    ]
    facts.append(formula(f"position of the {NAMES[joint]}", sp.Matrix(place), *verdict, **more))
    return {f"eq. 1.{number}": fact for number, fact in enumerate(facts, start=first)}


NOTEBOOK = "B2_animation"
PRINTED = {
    "1.5, pp. 10-11": {
        **_position(5, 25, IF_TABLE_1_1, LOWER, condition=TABLE_1_1),
        **_position(4, 29),
        **_position(3, 33),
        "eq. 1.37": formula("position of the shoulder", sp.Matrix([0, 0, d_1])),
        "eq. 1.38": formula("position of the base", sp.Matrix([0, 0, 0])),
        "claim B2.1": claim("the gripper points down at a and e, is level at b and d, and points up at c"),
        "claim B2.2": claim("turning joint 5 multiplies the gripper's pose by a turn about its z axis"),
        "claim B2.3": claim(
            "the equations of section 1.3.2 give the joint angles of all five poses",
            "holds, if phi of d and e is read as 180 deg - phi, and any theta_1 is taken at c",
            "with phi as given the wrist of d would be 0.4243 m from the shoulder, and at c (1.14) is 0/0",
        ),
        "claim B2.4": claim(
            "the interpolated points, shown one after another, are a motion of the arm",
            "holds, if the arm stops at c and theta_1 turns there by 180 deg, or if theta_1 stays and it leans "
            "backwards",
            "between two samples at c theta_1 jumps by 180 deg, which the pictures do not show",
        ),
        "claim B2.5": claim(
            "the joints' positions, connected, show the arm: neighbours are a link apart, whatever the angles"
        ),
        "claim B2.6": claim(
            "the star shows how well the arm performs",
            "holds, if it shows that the inverse kinematics reaches the points drawn; how the arm moves between "
            "them it does not show",
            "at the samples the error is that of rounding, for an arm of quite other lengths too; between them it "
            "is not",
        ),
    },
    "1.5, p. 10": {
        "Table 1.5": numbers("five poses of the gripper, a to e: position and pitch", POSES, 9),
    },
    "1.5, p. 11": {
        "Fig. 1.8": numbers("the gripper passes the five marked points, a to e", POSES[:, :3], 2),
        "Fig. 1.9": numbers("corners of a star that the gripper draws at z = 0.4 m", STAR, 2),
    },
}
