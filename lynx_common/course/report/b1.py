"""Section 1.4 of the report, task planning: its table, figure and claims."""

import numpy as np

from .item import claim, numbers

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

NOTEBOOK = "B1_task_planning"
PRINTED = {
    "1.4, p. 9": {
        "Table 1.4": numbers("six poses of the gripper, a to f: position and pitch", POSES, 9),
        "Fig. 1.7": numbers(
            "the six postures; the labels at their grippers read the positions of Table 1.4", POSES[:, :3], 2
        ),
        "claim B1.1": claim(
            "the inverse kinematics (with the slips of section 1.3 mended) is accurate at all six poses"
        ),
        "claim B1.2": claim("among the six are extreme positions"),
        "claim B1.3": claim(
            "the postures drawn are possible with the real range of joint 2, 0 to 180 deg by section 1.2",
            "holds, if a, d and e are taken with the elbow up; they are drawn with the elbow down",
            "joint 2 of a, d and e as drawn is at -17, -3 and -3 deg",
        ),
    },
}
