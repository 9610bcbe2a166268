"""The five-joint Lynxmotion arm: lengths, joint limits, and where its links are for given joint angles.

Metres and radians. Joint angles are those of report Table 1.2; the gripper's *pitch*, the angle of its
axis above the horizontal in the arm's own plane, is then theta_2 + theta_3 + theta_4 - pi/2, and its
*roll* about that axis is theta_5. All functions take batches: an array of joint angles has shape (..., 5).
A row of joint angles that holds NaN or infinity gives NaN throughout; complex numbers, and a last axis
that is not 5 long, raise InputError.
"""

from collections.abc import Callable, Iterator
from dataclasses import astuple, dataclass, fields
from functools import cache

import numpy as np
import sympy as sp

from . import dh
from .errors import GeometryError
from .symbolic import P, Q, numeric, tidy


@dataclass(frozen=True)
class Geometry:
    """Lengths in metres; report Table 1.3. Unpacks in this order.

    d_1 : base to shoulder, along the vertical; L_1 : shoulder to elbow; L_2 : elbow to wrist;
    L_3 : wrist to gripper. Raises GeometryError unless all are finite and none is negative, and the
    two links L_1 and L_2 are longer than zero.
    """

    d_1: float = 0.1
    L_1: float = 0.2
    L_2: float = 0.2
    L_3: float = 0.1

    def __post_init__(self) -> None:
        for name, value in zip((field.name for field in fields(self)), astuple(self), strict=True):
            _check_length(name, value)
            object.__setattr__(self, name, float(value))

    def __iter__(self) -> Iterator[float]:
        return iter((self.d_1, self.L_1, self.L_2, self.L_3))

    def __array__(self, dtype: type | None = None, copy: bool | None = None) -> np.ndarray:
        return np.array(tuple(self), dtype=dtype)


def _check_length(name: str, value: float) -> None:
    if not isinstance(value, int | float | np.number) or isinstance(value, complex | np.complexfloating):
        raise GeometryError(name, value, "a length is a real number of metres")
    if not np.isfinite(value):
        raise GeometryError(name, value, "a length is finite")
    if value < 0:
        raise GeometryError(name, value, "a length is not negative")
    if value == 0 and name in ("L_1", "L_2"):
        raise GeometryError(name, value, "the upper arm and the forearm are longer than zero")


LYNX = Geometry()

# Lower and upper limit of each joint, (5, 2), radians. An assumption: the report gives only the ranges that
# it sweeps in section 1.2. Within these lie all of its own tasks; the wrist's are +-150 deg about straight.
JOINT_LIMITS = np.pi / 180 * np.array([[-180, 180], [0, 180], [-150, 150], [-60, 240], [-180, 180]])
JOINT_LIMITS.setflags(write=False)


def dh_table() -> list[dh.Row]:
    """The five rows of the standard (distal) DH table in the symbols Q and P; report Table 1.2."""
    theta_1, theta_2, theta_3, theta_4, theta_5 = Q
    d_1, L_1, L_2, L_3 = P
    return [
        dh.Row(0, sp.pi / 2, d_1, theta_1),
        dh.Row(L_1, 0, 0, theta_2),
        dh.Row(L_2, 0, 0, theta_3),
        dh.Row(0, sp.pi / 2, 0, theta_4),
        dh.Row(0, 0, L_3, theta_5),
    ]


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
