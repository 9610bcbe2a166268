"""One target at a time: joint angles on one branch, or task coordinates of a pose; errors that say why not."""

import numpy as np
from numpy.typing import ArrayLike

from .. import reading
from ..errors import InputError, JointLimitError, NotAchievableError, OutOfReachError
from ..symbolic import TASK, XYZ, compiled
from . import formulas
from ._geometry import JOINT_LIMITS, LYNX, Geometry, into_limits
from ._inverse import BRANCHES, inverse_kinematics, out_of_reach

_front = compiled(XYZ, TASK[3:4], TASK[4:])(formulas.front)

# A position this near to the base axis, as a share of the arm's length, has no azimuth of its own.
AXIS_TOLERANCE = 1e-9

# How far the gripper's axis may be from the arm's plane, in radians: as far as a matrix may be from a rotation.
IN_PLANE = reading.POSE_TOLERANCE


def solve(
    position: ArrayLike, pitch: float, roll: float = 0.0, branch: int = 0, *, geometry: Geometry = LYNX
) -> np.ndarray:
    """Joint angles, (5,) radians within JOINT_LIMITS, that reach one target on one branch.

    ``position`` is (3,) in metres, ``branch`` an index into ``BRANCHES``. Raises OutOfReachError,
    JointLimitError, and InputError for a target that is not one position and two angles, all finite.

    >>> np.rad2deg(solve([0.3, 0, 0.3], pitch=0.0)).round(2)
    array([  0.,  90., -90.,  90.,   0.])
    """
    branch = reading.whole(branch, "branch", 0, len(BRANCHES) - 1)
    position = reading.finite(position, "a position", 3)
    pitch, roll = reading.number(pitch, "pitch"), reading.number(roll, "roll")
    q = inverse_kinematics(position, pitch, roll, geometry=geometry)[branch]
    if np.isnan(q).any():
        raise OutOfReachError(*out_of_reach(_front(position, (pitch,), (roll,)), geometry))
    allowed = into_limits(q)
    for joint in np.flatnonzero(np.isnan(allowed)):
        raise JointLimitError(int(joint) + 1, float(q[joint]), *map(float, JOINT_LIMITS[joint]))
    return allowed


def task_of_pose(T: ArrayLike, geometry: Geometry = LYNX) -> np.ndarray:
    """Task coordinates, (5,), of a pose ``T`` of the gripper, (4, 4), seen from the front (r >= 0).

    Five joints take a pose only if the gripper's axis lies in a vertical plane through the base axis,
    (p x n) . z = 0; otherwise NotAchievableError says by which angle it leaves the arm's plane. On the base axis
    the azimuth is the gripper's own, and 0 if it stands upright there. Raises InputError where ``T`` is not
    a pose. Whether the links reach is not asked here.

    >>> task_of_pose([[0, 0, 1, 0.3], [0, 1, 0, 0], [-1, 0, 0, 0.2], [0, 0, 0, 1]]).round(4) + 0.0
    array([0.    , 0.3   , 0.2   , 0.    , 3.1416])
    """
    T = reading.pose(T)
    if T.shape != (4, 4) or np.isnan(T).any():
        raise InputError("A pose is expected: a 4 x 4 matrix of real, finite numbers.")
    (x, y, axis), p = T[:3, :3].T, T[:3, 3]
    on_axis = np.hypot(p[0], p[1]) <= AXIS_TOLERANCE * sum(geometry)
    level = axis[:2] if on_axis else p[:2]
    upright = on_axis and np.hypot(level[0], level[1]) <= IN_PLANE
    azimuth = 0.0 if upright else np.arctan2(level[1], level[0])
    outward = np.array([np.cos(azimuth), np.sin(azimuth), 0])
    left = np.array([-np.sin(azimuth), np.cos(azimuth), 0])
    leaves = np.arcsin(np.clip(axis @ left, -1, 1))
    if abs(leaves) > IN_PLANE:
        raise NotAchievableError(float(leaves))
    pitch, roll = np.arctan2(axis[2], axis @ outward), np.arctan2(-x @ left, -y @ left)
    return np.array([azimuth, 0.0 if on_axis else p @ outward, p[2], pitch, roll])
