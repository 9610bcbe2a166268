"""The planar 3-RRR parallel robot: inverse and forward kinematics, singularities, workspace; in millimetres.

Angles are in radians. Each leg i has its motor at the base joint PB_i, an elbow M_i, and ends at the joint
PP_i of the platform; the link S_A from PB_i to M_i is driven, the link L from M_i to PP_i is not. A *pose* is
(X_c, Y_c, alpha), the platform's centre and its turn; ``theta`` holds the three motor angles, each measured
from the x axis. All functions but ``solve`` and ``assemble`` take batches. NaN or infinity in a row gives NaN, and
False where the answer is yes or no; complex numbers and a last axis of another length raise InputError, and an
alpha beyond a full turn each way warns that degrees were meant.
"""

from ..symbolic import DESIGN, POSE
from . import formulas
from ._condition import self_motion
from ._forward import assemble, forward_kinematics
from ._geometry import RRR, Geometry, base_joints, elbows, platform_joints
from ._inverse import inverse_kinematics, leg_lengths, solve
from ._velocity import jacobians, singularity_type
from ._workspace import constant_orientation_workspace, reachable
from .formulas import WORKING_MODES
