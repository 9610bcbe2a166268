"""Section 1.6 of the report, trajectories between points: its figures and claims."""

import numpy as np

from .item import Item

NOTEBOOK = "B3_trajectories"

# The crosses of Fig. 1.10: x, y, z in metres.
POINTS = np.array([[0.2, 0, 0.2], [0.1, 0, 0.4], [0, 0, 0.6], [-0.2, 0, 0.4], [-0.3, 0, 0.2]])


def _figure(number: str, says: str, reading: np.ndarray, digits: int) -> Item:
    return Item(f"Fig. {number}", "1.6, p. 13", says, reading, NOTEBOOK, "holds", digits=digits)


def _claim(number: int, says: str, verdict: str = "holds", because: str = "") -> Item:
    return Item(f"claim B3.{number}", "1.6, p. 13", says, True, NOTEBOOK, verdict, because)


ITEMS = [
    _figure("1.10", "the five points of the gripper's way (crosses)", POINTS, 2),
    _figure(
        "1.11",
        "the free motion bulges to x = 0.26 m at z = 0.28 m; at point 3 the arm stands upright, its joints at "
        "heights of 0, 0.1, 0.3, 0.5 and 0.6 m",
        np.array([0.26, 0.28, 0, 0.1, 0.3, 0.5, 0.6]),
        2,
    ),
    _figure(
        "1.12",
        "the detour goes straight down from point 3 to z = 0.494949 m, where the pitch is 0.745732 rad, and from "
        "there straight to point 4",
        np.array([0.494949, 0.745732]),
        6,
    ),
    _claim(
        1,
        "the motions are those between the points of Table 1.5",
        "wrong: three of the five points in the figures are others",
        "with those of Table 1.5 the free motion leaves the arm's reach",
    ),
    _claim(2, "the free motion and the linear motion can be done"),
    _claim(
        3,
        "the distance from the obstacle to the line, compared with its radius, tells whether a route is safe",
        "wrong: what tells is the distance from the obstacle to the whole arm, on the way between the points",
        "the line goes on beyond the points and refuses safe routes; and routes pass on which a link collides",
    ),
    _claim(4, "the straight way from point 3 to point 4 is blocked"),
    _claim(5, "the detour is clear of the obstacle"),
    _claim(
        6,
        "the parameters of a spline around the obstacle are hard to adjust",
        "wrong: here, with both ends equally far from the centre, one height will do, and the clearance gives it",
        "with a bump 3.86 cm high, a sine and a parabola both keep the 0.18 m asked for",
    ),
]
