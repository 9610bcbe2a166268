"""Section 1.5 of the report, animation: its equations, table, figures and claims.

The report counts the base as joint 1 and the gripper as joint 5; P_5x is the x coordinate of the gripper.
"""

import numpy as np
import sympy as sp
from sympy import cos, pi, sin

from ...symbolic import P, Q
from .item import Item, equation

NOTEBOOK = "B2_animation"
theta_1, theta_2, theta_3, theta_4, theta_5 = Q
d_1, L_1, L_2, L_3 = P
forearm, gripper = theta_2 + theta_3, theta_2 + theta_3 + theta_4

TABLE_1_1 = {theta_4: theta_4 + pi / 2}
IF_TABLE_1_1 = "holds, if theta_4 is that of Table 1.1, 90 deg less than that of Table 1.2"
LOWER = "with theta_4 of Table 1.2 the gripper points 90 deg lower than theta_2 + theta_3 + theta_4"

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


def _item(number: int, says: str, printed: sp.Basic, gripper: bool = False) -> Item:
    verdict, because, condition = (IF_TABLE_1_1, LOWER, TABLE_1_1) if gripper else ("holds", "", None)
    key, where = f"eq. 1.{number}", "1.5, pp. 10-11"
    return Item(key, where, says, printed, NOTEBOOK, verdict, because, condition=condition)


def _positions(joint: int, first: int) -> list[Item]:
    """The four equations of a joint: x, y, z, and all three."""
    place = [OUT[joint] * cos(theta_1), OUT[joint] * sin(theta_1), UP[joint]]
    items = [
        _item(
            first + i, f"{axis} of the {NAMES[joint]}", equation(sp.Symbol(f"P_{joint}{axis}"), value), joint == 5
        )
        for i, (axis, value) in enumerate(zip("xyz", place, strict=True))
    ]
    return [*items, _item(first + 3, f"position of the {NAMES[joint]}", sp.Matrix(place), joint == 5)]


def _claim(number: int, says: str, verdict: str = "holds", because: str = "") -> Item:
    return Item(f"claim B2.{number}", "1.5, pp. 10-11", says, True, NOTEBOOK, verdict, because)


ITEMS = [
    *_positions(5, 25),
    *_positions(4, 29),
    *_positions(3, 33),
    _item(37, "position of the shoulder", sp.Matrix([0, 0, d_1])),
    _item(38, "position of the base", sp.Matrix([0, 0, 0])),
    Item(
        key="Table 1.5",
        where="1.5, p. 10",
        says="five poses of the gripper, a to e: position and pitch",
        printed=POSES,
        digits=9,
        notebook=NOTEBOOK,
        verdict="holds",
    ),
    Item(
        key="Fig. 1.8",
        where="1.5, p. 11",
        says="the gripper passes the five marked points, a to e",
        printed=POSES[:, :3],
        digits=2,
        notebook=NOTEBOOK,
        verdict="holds",
    ),
    Item(
        key="Fig. 1.9",
        where="1.5, p. 11",
        says="corners of a star that the gripper draws at z = 0.4 m",
        printed=STAR,
        digits=2,
        notebook=NOTEBOOK,
        verdict="holds",
    ),
    _claim(1, "the gripper points down at a and e, is level at b and d, and points up at c"),
    _claim(2, "turning joint 5 multiplies the gripper's pose by a turn about its z axis"),
    _claim(
        3,
        "the equations of section 1.3.2 give the joint angles of all five poses",
        "wrong: atan2(y, x) serves for a, b, d, e, and at c any theta_1 will do",
        "(1.14) has 0/0 at c, and theta_1 = 0 at d, where the wrist would then be 0.4243 m from the shoulder",
    ),
    _claim(
        4,
        "the interpolated points, shown one after another, are a motion of the arm",
        "wrong: for a motion theta_1 has to stay at 0, and the arm to lean over backwards from c on",
        "at c theta_1 jumps by 180 deg between two samples, which the pictures do not show",
    ),
    _claim(5, "the joints' positions, connected, show the arm: neighbours are a link apart, whatever the angles"),
    _claim(
        6,
        "the star shows how well the arm performs",
        "wrong: its error is between the samples; and drawn in one go it winds twice round the base, where "
        "joint 1 has one turn within this course's limits",
        "at the samples the error is that of rounding, also for an arm of quite other lengths",
    ),
]
