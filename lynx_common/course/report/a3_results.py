"""Section 1.3 of the report, inverse kinematics: its figures and claims."""

import numpy as np

from .item import Item

NOTEBOOK = "A3_inverse_kinematics"

# Fig. 1.5: five angles in degrees, position and its error in metres, orientation row by row and its error.
ORIENTATION = [0.7071, 0, 0.7071, -0.7071, 0, 0.7071, 0, -1, 0]
FIG_1_5 = np.array([45, 5.2644, 60, 24.7356, 90, 0.2707, 0.2707, 0.3, 0.1, *ORIENTATION, 2.1414])
FIG_1_5_RIGHT = np.array([45, 60.8808, -82.8192, -158.0616, 135, 0.2, 0.2, 0.3, 0, *np.eye(3).ravel(), 0])


def _claim(number: int, says: str, verdict: str = "holds", because: str = "") -> Item:
    return Item(f"claim A3.{number}", "1.3, p. 7", says, True, NOTEBOOK, verdict, because)


ITEMS = [
    Item(
        key="Fig. 1.5",
        where="1.3.1, p. 6",
        says="joint angles for R = I at (0.2, 0.2, 0.3) m, and the pose that they give: off by 0.1 m and 2.1414",
        printed=FIG_1_5,
        digits=4,
        notebook=NOTEBOOK,
        verdict="wrong: four sets of angles reach the pose with no error, the first with theta_1 to theta_5 at "
        "45, 60.8808, -82.8192, -158.0616, 135 deg",
        because="it has the wrist at the target, where the gripper belongs, and its last two angles are those of "
        "(1.10) and (1.11)",
        right=FIG_1_5_RIGHT,
    ),
    Item(
        key="Fig. 1.6",
        where="1.3.2, p. 8",
        says="theta_1 to theta_4 (of Table 1.1) for (0.30, 0.20, 0.35) m, pitch 45 deg: 0.59, 0, 1.10, -0.32",
        printed=np.array([0.59, 0.00, 1.10, -0.32]),
        digits=2,
        notebook=NOTEBOOK,
        verdict="holds",
    ),
    _claim(
        1,
        "an error of 0.1 m means that the solution is relatively accurate",
        "wrong: the wrist was put where the gripper belongs, and the error is L_3",
        "with another L_3, from 0 to 0.2 m, the angles are the same and the error is that L_3",
    ),
    _claim(
        2,
        "the orientation error may come from the ranges of the joints or from the mechanics",
        "wrong: it comes from (1.10) and (1.11)",
        "with (1.10) and (1.11) mended, the same first three angles leave no error of orientation",
    ),
    _claim(
        3,
        "the method is numerical; its convergence or initial guess may be at fault",
        "wrong: it is a chain of closed formulas, in which nothing converges",
        "it puts the wrist, for which it solves, on the target to rounding",
    ),
    _claim(4, "once theta_1 is known, what remains is a planar arm of three links"),
]
