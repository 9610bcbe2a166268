"""Forward kinematics: where the links and the gripper are for given joint angles, and how fast they move."""

from collections.abc import Callable
from functools import cache

import numpy as np
import sympy as sp

from .. import dh
from ..symbolic import P, Q, numeric, tidy
from .geometry import LYNX, Geometry, dh_table


def forward_kinematics(q: np.ndarray, geometry: Geometry = LYNX) -> np.ndarray:
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
    """
    return _pose()(q, geometry)


def link_frames(q: np.ndarray, geometry: Geometry = LYNX) -> np.ndarray:
    """Poses of the frames 0 (base) to 5 (gripper) in the base frame: (..., 5) to (..., 6, 4, 4).

    Source: the partial products of report eq. (1.2).
    """
    stacked = _link_frames()(q, geometry)
    return stacked.reshape(*stacked.shape[:-2], 6, 4, 4)


def joint_positions(q: np.ndarray, geometry: Geometry = LYNX) -> np.ndarray:
    """Positions in metres of base, shoulder, elbow, wrist and gripper: (..., 5) to (..., 5, 3).

    Source: report eqs. (1.25) to (1.38), with this module's theta_4.
    """
    return _joint_positions()(q, geometry)


def task_coordinates(q: np.ndarray, geometry: Geometry = LYNX) -> np.ndarray:
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
    """
    return _task_coordinates()(q, geometry)


def jacobian(q: np.ndarray, geometry: Geometry = LYNX) -> np.ndarray:
    """Geometric Jacobian of the gripper: (..., 5) to (..., 6, 5).

    Maps joint velocities in rad/s to the gripper's velocity (v, omega), m/s over rad/s, in the base frame.

    Source: report eqs. (3.2) and (3.3), with the axis and origin of frame i - 1 for joint i.
    """
    return _jacobian()(q, geometry)


@cache
def _frames() -> list[sp.Matrix]:
    return [sp.eye(4), *map(tidy, dh.chain(dh_table()))]


@cache
def _pose() -> Callable:
    return numeric(_frames()[-1], Q, P)


@cache
def _link_frames() -> Callable:
    return numeric(sp.Matrix.vstack(*_frames()), Q, P)


@cache
def _joint_positions() -> Callable:
    base, shoulder, elbow, wrist, _, gripper = (T[:3, 3].T for T in _frames())
    return numeric(sp.Matrix.vstack(base, shoulder, elbow, wrist, gripper), Q, P)


@cache
def _task_coordinates() -> Callable:
    theta_1, theta_2, theta_3, theta_4, theta_5 = Q
    # The gripper in frame 1, whose x and y axes span the arm's plane.
    in_plane = tidy(dh.chain(dh_table()[1:])[-1])
    pitch = theta_2 + theta_3 + theta_4 - sp.pi / 2
    return numeric(sp.Matrix([theta_1, in_plane[0, 3], P[0] + in_plane[1, 3], pitch, theta_5]), Q, P)


@cache
def _jacobian() -> Callable:
    linear = _frames()[-1][:3, 3].jacobian(Q)
    angular = sp.Matrix.hstack(*(T[:3, 2] for T in _frames()[:-1]))
    return numeric(linear.col_join(angular), Q, P)
