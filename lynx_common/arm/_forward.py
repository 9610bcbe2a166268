"""Forward kinematics: where the links and the gripper are for given joint angles, and how fast they move."""

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from ..symbolic import P, Q, compiled
from . import formulas
from ._geometry import LYNX, Geometry

_pose = compiled(Q, P)(formulas.pose)
_joint_positions = compiled(Q, P)(formulas.joint_positions)
_task_coordinates = compiled(Q, P)(formulas.task_coordinates)
_jacobian = compiled(Q, P)(formulas.jacobian)


@compiled(Q, P)
def _link_frames() -> sp.Matrix:
    return sp.Matrix.vstack(*formulas.frames())


def forward_kinematics(q: ArrayLike, geometry: Geometry = LYNX) -> np.ndarray:
    """Pose of the gripper in the base frame.

    Parameters
    ----------
    q : array, shape (..., 5)
        Joint angles in radians, any turn.

    Returns
    -------
    T_0_5 : array, shape (..., 4, 4)
        Homogeneous transform; its third column is the gripper's axis, its fourth the position in metres.

    Source: report eq. (1.2) with Table 1.2; derived in ``notebooks/A1_forward_kinematics.ipynb``.

    >>> forward_kinematics([0, 0, 0, np.pi / 2, 0])[:3, 3].round(6)  # stretched out level
    array([0.5, 0. , 0.1])
    """
    return _pose(q, geometry)


def link_frames(q: ArrayLike, geometry: Geometry = LYNX) -> np.ndarray:
    """Poses of the frames 0 (base) to 5 (gripper) in the base frame: (..., 5) to (..., 6, 4, 4).

    Source: the partial products of report eq. (1.2).

    >>> link_frames(np.zeros((7, 5))).shape
    (7, 6, 4, 4)
    """
    stacked = _link_frames(q, geometry)
    return stacked.reshape(*stacked.shape[:-2], 6, 4, 4)


def joint_positions(q: ArrayLike, geometry: Geometry = LYNX) -> np.ndarray:
    """Positions in metres of base, shoulder, elbow, wrist and gripper: (..., 5) to (..., 5, 3).

    Source: report eqs. (1.25) to (1.38), with this module's theta_4.

    >>> joint_positions([0, np.pi / 2, 0, np.pi / 2, 0])[:, 2].round(6)  # upright: the heights
    array([0. , 0.1, 0.3, 0.5, 0.6])
    """
    return _joint_positions(q, geometry)


def task_coordinates(q: ArrayLike, geometry: Geometry = LYNX) -> np.ndarray:
    """What the five joints set, in coordinates that are smooth everywhere, over the base axis too.

    Parameters
    ----------
    q : array, shape (..., 5)
        Joint angles in radians.

    Returns
    -------
    task : array, shape (..., 5)
        azimuth of the arm's plane (= theta_1); r, the gripper's signed distance from the base axis in
        the direction of that azimuth; z, its height; pitch, the angle of its axis above the horizontal;
        roll (= theta_5). Metres and radians; angles are not wrapped.

    Source: derived in ``notebooks/A1_forward_kinematics.ipynb``, "In the arm's own plane".

    >>> task_coordinates([0.3, 0, 0, np.pi / 2, 0.1]).round(6)
    array([0.3, 0.5, 0.1, 0. , 0.1])
    """
    return _task_coordinates(q, geometry)


def jacobian(q: ArrayLike, geometry: Geometry = LYNX) -> np.ndarray:
    """Geometric Jacobian of the gripper: (..., 5) to (..., 6, 5).

    Maps joint velocities in rad/s to the gripper's velocity (v, omega), m/s over rad/s, in the base frame.

    Source: report eqs. (3.2) and (3.3), with the axis and origin of frame i - 1 for joint i.

    >>> jacobian([0, 0, 0, np.pi / 2, 0])[:3, 0].round(6) + 0.0  # stretched out along x, joint 1 moves it along y
    array([0. , 0.5, 0. ])
    """
    return _jacobian(q, geometry)
