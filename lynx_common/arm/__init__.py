"""The five-joint Lynxmotion arm: lengths, joint limits, forward and inverse kinematics, Jacobian.

Metres and radians. Joint angles are those of report Table 1.2; the gripper's *pitch*, the angle of its
axis above the horizontal in the arm's own plane, is then theta_2 + theta_3 + theta_4 - pi/2, and its
*roll* about that axis is theta_5. All functions but ``solve`` and ``task_of_pose`` take batches: an array of joint
angles has shape (..., 5). A row of joint angles that holds NaN or infinity gives NaN throughout, and is not
within limits; complex numbers, and a last axis that is not 5 long, raise InputError.

*Task coordinates* (azimuth = theta_1, signed r, z, pitch, roll) are what the five joints set. They are smooth
everywhere, over the base axis too. (position, pitch, roll) is a reader's chart of them, with a seam at r = 0.
"""

from ..symbolic import P, Q
from . import formulas
from ._forward import forward_kinematics, jacobian, joint_positions, link_frames, task_coordinates
from ._geometry import AT_LIMIT, JOINT_LIMITS, LYNX, SERVO_LIMITS, Geometry, dh_table, into_limits, within_limits
from ._inverse import BRANCHES, inverse_kinematics, joint_angles, out_of_reach
from ._target import solve, task_of_pose
from ._urdf import urdf
