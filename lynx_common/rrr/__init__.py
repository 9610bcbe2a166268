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
from .condition import self_motion
from .forward import assemble, forward_kinematics
from .geometry import RRR, Geometry, base_joints, elbows, platform_joints
from .inverse import WORKING_MODES, inverse_kinematics, leg_lengths, solve
from .velocity import jacobians, singularity_type
from .workspace import constant_orientation_workspace, reachable

__all__ = [
    "DESIGN",
    "POSE",
    "RRR",
    "WORKING_MODES",
    "Geometry",
    "assemble",
    "base_joints",
    "constant_orientation_workspace",
    "elbows",
    "formulas",
    "forward_kinematics",
    "inverse_kinematics",
    "jacobians",
    "leg_lengths",
    "platform_joints",
    "reachable",
    "self_motion",
    "singularity_type",
    "solve",
]
