"""Inverse kinematics: all motor angles that bring the platform to a given pose."""

from itertools import product

import numpy as np
from numpy.typing import ArrayLike

from .. import reading
from ..errors import AssemblyError
from ..symbolic import DESIGN, POSE, compiled
from . import formulas
from ._geometry import RRR, Geometry

# Sign of (M_i - PB_i) x (PP_i - M_i), leg by leg: +1 where the leg bends to the left on its way to the platform.
WORKING_MODES = tuple(product((1, -1), repeat=3))

# Room for rounding where a leg is stretched or folded, as a share of its length. The loop then stays open by less.
# It is smaller than the arm's, whose targets are printed with few digits; here a leg bends by the root of it.
REACH_TOLERANCE = 1e-12


squared_lengths = compiled(POSE, DESIGN)(formulas.squared_lengths)
_motor_angles = compiled(POSE, DESIGN)(formulas.motor_angles)


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
    both = _motor_angles(pose, geometry)
    both = np.where(closes(squared_lengths(pose, geometry), geometry)[..., None, :], both, np.nan)
    side = (1 - np.array(WORKING_MODES)) // 2
    return both[..., side, np.arange(3)]


def leg_lengths(pose: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    """Distances |PP_i - PB_i| in mm, which a leg spans from |S_A - L| to S_A + L: (..., 3) to (..., 3).

    >>> leg_lengths([0, 0, 0])
    array([160., 160., 160.])
    """
    return np.sqrt(squared_lengths(pose, geometry))


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


def closes(squared: np.ndarray, geometry: Geometry) -> np.ndarray:
    """Whether a leg can span lengths given by their squares, mm^2: (...) to (...) of bool; NaN it cannot."""
    S_A, L, *_ = geometry
    slack = REACH_TOLERANCE * (S_A + L)
    return (squared >= max(abs(S_A - L) - slack, 0) ** 2) & (squared <= (S_A + L + slack) ** 2)
