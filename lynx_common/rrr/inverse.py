"""Inverse kinematics: all motor angles that bring the platform to a given pose."""

from collections.abc import Callable
from functools import cache
from itertools import product

import numpy as np
import sympy as sp

from ..errors import AssemblyError, InputError
from ..symbolic import DESIGN, POSE, numeric
from .geometry import RRR, Geometry, base, checked, one, platform

# Sign of (M_i - PB_i) x (PP_i - M_i), leg by leg: +1 where the leg bends to the left on its way to the platform.
WORKING_MODES = tuple(product((1, -1), repeat=3))

# Room for rounding where a leg is stretched or folded, as a share of its length. The loop then stays open by less.
# It is smaller than the arm's, whose targets are printed with few digits; here a leg bends by the root of it.
REACH_TOLERANCE = 1e-12


def inverse_kinematics(pose: np.ndarray, geometry: Geometry = RRR) -> np.ndarray:
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

    Source: report eqs. (2.3) to (2.12), with the base joints put back; notebook Part2, sections 2 and 4.
    """
    pose = checked(pose)
    both = _both_sides()(pose, geometry).reshape(*pose.shape[:-1], 2, 3)
    both = np.where(spans(squared_lengths()(pose, geometry), geometry)[..., None, :], both, np.nan)
    side = (1 - np.array(WORKING_MODES)) // 2
    return both[..., side, np.arange(3)]


def leg_lengths(pose: np.ndarray, geometry: Geometry = RRR) -> np.ndarray:
    """Distances |PP_i - PB_i| in mm, which a leg spans from |S_A - L| to S_A + L: (..., 3) to (..., 3)."""
    return np.sqrt(squared_lengths()(checked(pose), geometry))


def solve(pose: np.ndarray, mode: int = 0, *, geometry: Geometry = RRR) -> np.ndarray:
    """Motor angles, (3,), for one pose (3,) and one working mode, an index into ``WORKING_MODES``.

    Raises AssemblyError, which names each leg that cannot close and by how much it misses, and InputError for a
    mode that there is not, or anything but one finite pose.
    """
    if isinstance(mode, bool) or mode not in range(len(WORKING_MODES)):
        raise InputError(f"The working mode is a number from 0 to {len(WORKING_MODES) - 1}; {mode!r} was given.")
    theta = inverse_kinematics(one("pose", pose, POSE), geometry)[int(mode)]
    if np.isnan(theta).any():
        length = leg_lengths(pose, geometry)
        (failing,) = np.nonzero(np.isnan(theta))
        S_A, L, *_ = geometry
        raise AssemblyError((failing + 1).tolist(), length[failing].tolist(), abs(S_A - L), S_A + L)
    return theta


def spans(squared: np.ndarray, geometry: Geometry) -> np.ndarray:
    """Whether a leg can span lengths given by their squares, mm^2: (...) to (...) of bool; NaN it cannot."""
    S_A, L, *_ = geometry
    slack = REACH_TOLERANCE * (S_A + L)
    return (squared >= max(abs(S_A - L) - slack, 0) ** 2) & (squared <= (S_A + L + slack) ** 2)


def leg() -> sp.Matrix:
    """PP_i - PB_i as rows, in symbols."""
    return platform() - base()


@cache
def squared_lengths() -> Callable:
    """|PP_i - PB_i|^2 of poses (..., 3), in mm^2: (..., 3)."""
    return numeric(sp.Matrix([x**2 + y**2 for x, y in leg().tolist()]), POSE, DESIGN)


@cache
def _both_sides() -> Callable:
    """Angles of the three legs, first with the sign +1, then with -1."""
    angles = [motor_angle(sigma, x, y) for sigma, (x, y) in product((1, -1), leg().tolist())]
    return numeric(sp.Matrix(angles), POSE, DESIGN)


def motor_angle(sigma: sp.Expr, x: sp.Expr, y: sp.Expr) -> sp.Expr:
    """Angle of the motor whose leg spans (x, y) and bends to the side ``sigma``; valid where the leg closes."""
    S_A, L, *_ = DESIGN
    squared = x**2 + y**2
    k = squared + S_A**2 - L**2
    below_root = ((S_A + L) ** 2 - squared) * (squared - (S_A - L) ** 2)  # (2 S_A |u|)^2 - k^2
    root = sp.sqrt((below_root + sp.Abs(below_root)) / 2)  # not negative, whatever rounding does
    return sp.atan2(y * k - sigma * x * root, x * k + sigma * y * root)
