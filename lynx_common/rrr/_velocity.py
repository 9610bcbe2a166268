"""Velocities: how motors and platform move together, and where that breaks down."""

import numpy as np
from numpy.typing import ArrayLike

from ..symbolic import DESIGN, POSE, compiled
from . import formulas
from ._geometry import RRR, Geometry
from .formulas import THETA

# Shares below which a determinant counts as zero. Rounding of a pose at which a leg is stretched bends the leg
# by about the square root of the machine's precision, 1e-8.
SINGULAR = 1e-6


_velocity_rows = compiled(POSE, THETA, DESIGN)(formulas.velocity_rows)
_normalised = compiled(POSE, THETA, DESIGN)(formulas.normalised)


def jacobians(pose: ArrayLike, theta: ArrayLike, geometry: Geometry = RRR) -> tuple[np.ndarray, np.ndarray]:
    """A and B of A x_dot = B theta_dot, with x the pose.

    Row i says that the speed of PP_i along its distal link is the speed of M_i along it, times L.

    Parameters
    ----------
    pose : array, shape (..., 3)
        X_c, Y_c in mm and alpha in radians.
    theta : array, shape (..., 3)
        Motor angles in radians that belong to the pose, as from ``inverse_kinematics``. The leading axes of both
        broadcast.

    Returns
    -------
    A : array, shape (..., 3, 3)
        Rows [PP_i - M_i, (PP_i - C) x (PP_i - M_i)], in mm and mm^2.
    B : array, shape (..., 3, 3)
        Diagonal, with (M_i - PB_i) x (PP_i - M_i), in mm^2.

    Source: Gosselin and Angeles 1990 (they write A x_dot + B theta_dot = 0); notebook Part2, section 6.

    >>> A, B = jacobians([0, 0, 0], np.deg2rad([-136.277, -16.277, 103.723]))
    >>> np.diagonal(B).round() + 0.0  # all three legs bent alike
    array([19657., 19657., 19657.])
    """
    rows = _velocity_rows(pose, theta, geometry)
    return rows[..., :3], rows[..., 3, None] * np.eye(3)


def singularity_type(pose: ArrayLike, theta: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    """0 where the pose is regular, 1 where det B = 0, 2 where det A = 0, 3 where both.

    The arguments are those of ``jacobians``. Type 1: a leg is stretched or folded, and the platform loses a
    freedom. Type 2: the lines of the three distal links meet in a point or are parallel, and it gains one.
    Lengths are divided out: the sine at each elbow, and det A of unit links over r_platform, are compared with
    SINGULAR. NaN where pose or theta is not finite; shape (...).

    >>> singularity_type([0, 0, 0], np.deg2rad([[-136.277, -16.277, 103.723]]))
    array([0.])
    """
    normalised = _normalised(pose, theta, geometry)
    zero = np.abs(normalised) <= SINGULAR
    return np.where(np.isfinite(normalised).all(axis=-1), zero[..., :3].any(axis=-1) + 2.0 * zero[..., 3], np.nan)
