"""Section 1.4 of the report, task planning: its table, figure and claims."""

import numpy as np

from .item import Item

NOTEBOOK = "B1_task_planning"

# Rows a to f: x, y, z in metres, pitch in degrees.
POSES = np.array(
    [
        [0.4, 0.1, 0.2, 0],
        [0.5, 0.0, 0.1, 0],
        [0.0, 0.0, 0.6, 90],
        [0.1, 0.4, 0.3, 45],
        [-0.1, -0.4, 0.3, 45],
        [0.32, 0.0, 0.2, -90],
    ]
)


def _claim(number: int, says: str, verdict: str = "holds", because: str = "") -> Item:
    return Item(f"claim B1.{number}", "1.4, p. 9", says, True, NOTEBOOK, verdict, because)


ITEMS = [
    Item(
        key="Table 1.4",
        where="1.4, p. 9",
        says="six poses of the gripper, a to f: position and pitch",
        printed=POSES,
        digits=9,
        notebook=NOTEBOOK,
        verdict="holds",
    ),
    Item(
        key="Fig. 1.7",
        where="1.4, p. 9",
        says="the six postures; the labels at their grippers read the positions of Table 1.4",
        printed=POSES[:, :3],
        digits=2,
        notebook=NOTEBOOK,
        verdict="holds",
    ),
    _claim(1, "the inverse kinematics (with the slips of section 1.3 mended) is accurate at all six poses"),
    _claim(2, "among the six are extreme positions"),
    _claim(
        3,
        "the postures drawn are possible with the real range of joint 2, which section 1.2 says is 0 to 180 deg",
        "wrong: a, d and e are possible with the elbow up, not down as drawn",
        "joint 2 of a, d and e as drawn is at -17, -3 and -3 deg",
    ),
]
