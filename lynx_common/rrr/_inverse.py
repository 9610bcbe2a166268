"""Inverse kinematics: all motor angles that bring the platform to a given pose."""

import numpy as np
from numpy.typing import ArrayLike

from .. import reading
from ..errors import AssemblyError
from ..symbolic import DESIGN, POSE, compiled
from . import formulas
from ._geometry import RRR, Geometry
from .formulas import WORKING_MODES

closing = compiled(POSE, DESIGN)(formulas.closing)
_squared_lengths = compiled(POSE, DESIGN)(formulas.squared_lengths)
_working_modes = compiled(POSE, DESIGN)(formulas.working_modes)


def inverse_kinematics(pose: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    r"""Motor angles of all eight working modes that bring the platform to a pose.

    With :math:`u = PP_i - PB_i` and :math:`k = |u|^2 + S_A^2 - L^2`, the law of cosines gives the angle at the
    motor between u and the driven link, :math:`\cos = k / (2 S_A |u|)`, to either side of u.

    Parameters
    ----------
    pose : array, shape (..., 3)
        X_c, Y_c in mm and alpha in radians.

    Returns
    -------
    theta : array, shape (..., 8, 3)
        Angles in [-pi, pi], one row per entry of ``WORKING_MODES``. An entry is NaN where its leg cannot close.
        Where PP_i = PB_i (possible if S_A = L) any angle closes, and 0 is given.

    Source: report eqs. (2.3) to (2.12), with the base joints put back; notebook Part2, section 2.

    >>> np.rad2deg(inverse_kinematics([0, 0, 0]))[0].round(3)  # in the middle, all legs bent to the left
    array([-136.277,  -16.277,  103.723])
    """
    return _working_modes(pose, geometry)


def leg_lengths(pose: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    """Distances |PP_i - PB_i| in mm, which a leg spans from |S_A - L| to S_A + L: (..., 3) to (..., 3).

    >>> leg_lengths([0, 0, 0])
    array([160., 160., 160.])
    """
    return np.sqrt(_squared_lengths(pose, geometry))


def solve(pose: ArrayLike, mode: int = 0, *, geometry: Geometry = RRR) -> np.ndarray:
    """Motor angles, (3,), for one pose (3,) and one working mode, an index into ``WORKING_MODES``.

    Raises AssemblyError, which names each leg that cannot close and by how much it misses, and InputError for a
    mode that there is not, or anything but one finite pose.

    >>> np.rad2deg(solve([0, 0, 0], mode=7)).round(3)  # all legs bent to the right
    array([ -43.723,   76.277, -163.723])
    """
    mode = reading.whole(mode, "working mode", 0, len(WORKING_MODES) - 1)
    pose = reading.finite(pose, "a pose", 3)
    theta = inverse_kinematics(pose, geometry)[mode]
    if np.isnan(theta).any():
        length = leg_lengths(pose, geometry)
        (failing,) = np.nonzero(np.isnan(theta))
        S_A, L, *_ = geometry
        raise AssemblyError((failing + 1).tolist(), length[failing].tolist(), abs(S_A - L), S_A + L)
    return theta
