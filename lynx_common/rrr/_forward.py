"""Forward kinematics: all poses of the platform at given motor angles."""

from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from .. import reading
from ..arcs import crossings
from ..errors import NoPoseError, SelfMotionError
from ..symbolic import DESIGN, POSE, compiled
from . import formulas
from ._condition import ALPHAS, condition_at, platform_free, self_motion
from ._geometry import RRR, Geometry, elbows, platform_joints
from .formulas import ELBOWS, THETA

MODES = 6  # assembly modes, at most
AT_ONCE = 4096  # configurations worked through at a time
NEARLY_REAL = 1e-3  # where two real roots nearly meet, rounding can give them imaginary parts
NEAR = 0.05  # how far the third leg may miss, as a share of L, for a start of Newton's method
NEWTON = 20  # steps; four suffice but where two poses nearly meet, and each step halves what is left
CLOSED = 1e-12  # largest miss of a leg that counts as closed, as a share of S_A + L
ROUNDED = 1e-15  # miss that no further step makes smaller
ONE_POSE = 1e-7  # solutions nearer than this, in radians and shares of L, are one

_newton = compiled(POSE, ELBOWS, DESIGN)(formulas.newton)


def forward_kinematics(theta: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    """All poses at which the robot can be assembled with its motors at given angles.

    At an angle alpha each leg holds the centre at the distance L from M_i - R(alpha) r_i, with r_i the
    platform's joint seen from its centre. So these three points lie on a circle of radius L. As a condition on
    alpha that is a trigonometric polynomial of degree 3, and one of degree 6 in tan(alpha / 2), turned here so
    that no root is near infinity. Its roots are refined by Newton's method on the lengths of the legs.

    Parameters
    ----------
    theta : array, shape (..., 3)
        Motor angles in radians.

    Returns
    -------
    pose : array, shape (..., 6, 3)
        X_c, Y_c in mm and alpha in (-pi, pi], ordered by alpha, then X_c; NaN in the rows beyond the last. All
        rows are NaN where no pose closes, and where the platform can move with the motors locked
        (``self_motion``), even if there are isolated poses besides.

    Source: notebook Part2, section 5.

    >>> poses = forward_kinematics(np.deg2rad([-136.277, -16.277, 103.723]))
    >>> int(np.isfinite(poses[:, 0]).sum())  # of the six rows so many hold a pose
    2
    """
    theta = reading.batch(theta, THETA)
    flat = theta.reshape(-1, 3)
    pose = np.empty((len(flat), MODES, 3))
    for start in range(0, len(flat), AT_ONCE):
        part = slice(start, start + AT_ONCE)
        pose[part] = _poses(flat[part], geometry)
    return pose.reshape(*theta.shape[:-1], MODES, 3)


def assemble(theta: ArrayLike, near: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    """The pose, (3,), at motor angles (3,) that is nearest to the pose ``near``, (3,).

    Distance is that in the plane, with alpha times r_platform as the third coordinate. Raises SelfMotionError
    where the motor angles do not fix the pose, NoPoseError where none closes, and InputError for anything but
    three finite motor angles and one finite pose.

    >>> assemble(np.deg2rad([-136.277, -16.277, 103.723]), near=[0, 0, 1]).round(2) + 0.0
    array([0.  , 0.  , 1.24])
    """
    theta, near = reading.finite(theta, "the motor angles", 3), reading.finite(near, "a pose", 3)
    if self_motion(theta, geometry):
        raise SelfMotionError(theta.tolist())
    pose = forward_kinematics(theta, geometry)
    pose = pose[np.isfinite(pose).all(axis=-1)]
    if not len(pose):
        raise NoPoseError(theta.tolist())
    away = _wrap(pose - near) * [1, 1, geometry.r_platform]
    return pose[np.linalg.norm(away, axis=-1).argmin()]


def _poses(theta: np.ndarray, geometry: Geometry) -> np.ndarray:
    """``forward_kinematics`` of (n, 3)."""
    M = elbows(theta, geometry)
    condition = condition_at(M, geometry)
    (sound,) = np.nonzero(np.isfinite(theta).all(axis=-1) & ~platform_free(M, condition, geometry))
    alpha = _roots(condition[sound])
    row, root = np.nonzero(np.isfinite(alpha))
    row, alpha = sound[row], alpha[row, root]
    start = _starts(alpha, M[row], geometry)  # (2, k, 3), NaN where a start is none
    side, number = np.nonzero(np.isfinite(start[..., 0]))
    pose = np.full((len(theta), 2 * MODES, 3), np.nan)
    row, column = row[number], root[number] + side * MODES
    pose[row, column] = _refined(start[side, number], M[row].reshape(-1, 6), geometry)
    return _distinct(pose, geometry)


def _roots(condition: np.ndarray) -> np.ndarray:
    """The angles alpha, (n, 6), that satisfy the condition given by its terms (n, 8, 2); NaN for complex roots."""
    value = condition[..., 0] - condition[..., 1]
    opposite = ALPHAS[np.abs(value).argmax(axis=-1), None] - np.pi  # the largest value comes to t = infinity
    fourier = np.fft.rfft(value)[:, :4] / 8 * [1, 2, 2, 2] * np.exp(1j * opposite * np.arange(4))
    polynomial = (fourier @ _half_angle()).real  # highest power first
    companion = np.zeros((len(value), 6, 6))
    companion[:, 1:, :-1] = np.eye(5)
    companion[:, 0] = -polynomial[:, 1:] / polynomial[:, :1]
    t = np.linalg.eigvals(companion)
    alpha = opposite + 2 * np.arctan(t.real)
    return np.where(np.abs(t.imag) <= NEARLY_REAL * (1 + np.abs(t) ** 2), alpha, np.nan)


@cache
def _half_angle() -> np.ndarray:
    """exp(i k alpha) (1 + t^2)^3 as polynomials in t = tan(alpha / 2), k = 0 to 3: (4, 7), highest power first."""
    plus, minus = np.poly1d([1j, 1]), np.poly1d([-1j, 1])
    return np.array([(plus ** (3 + k) * minus ** (3 - k)).coeffs for k in range(4)])


def _starts(alpha: np.ndarray, M: np.ndarray, geometry: Geometry) -> np.ndarray:
    """Poses at alpha, (k,), at which two legs close exactly and the third nearly: (2, k, 3), else NaN.

    The two are those whose points M_i - R(alpha) r_i, the centre at the distance L from each, are farthest
    apart. Both crossings can be poses, where the third point lies on another.
    """
    centred = np.zeros((len(alpha), 3))
    centred[:, 2] = alpha
    point = M - platform_joints(centred, geometry)  # (k, 3, 2)
    side = point[:, [1, 2, 0]] - point
    longest = np.hypot(side[..., 0], side[..., 1]).argmax(axis=1)
    a, b, third = (point[np.arange(len(alpha)), (longest + i) % 3] for i in range(3))
    start = np.empty((2, len(alpha), 3))
    start[..., :2], start[..., 2] = crossings(a, geometry.L, b, geometry.L), alpha
    to_third = start[..., :2] - third
    start[np.abs(np.hypot(to_third[..., 0], to_third[..., 1]) - geometry.L) > NEAR * geometry.L] = np.nan
    return start


def _refined(pose: np.ndarray, M: np.ndarray, geometry: Geometry) -> np.ndarray:
    """``pose`` (n, 3) for elbows (n, 6) after Newton's method on the legs' lengths; NaN where they do not close.

    The best of all steps is kept: where two poses meet, A is singular, and a step can lead away from a solution.
    """
    S_A, L, *_ = geometry
    pose = _wrap(pose)
    best, least, left = pose.copy(), np.full(len(pose), np.inf), np.arange(len(pose))
    for _ in range(NEWTON + 1):
        with np.errstate(invalid="ignore", divide="ignore"):
            off, step = np.moveaxis(_newton(pose[left], M[left], geometry), -2, 0)
        miss = np.abs(off).max(axis=-1, initial=0)
        better = left[miss < least[left]]
        best[better] = pose[better]
        least[left] = np.fmin(miss, least[left])
        pose[left] = _wrap(pose[left] - step)
        left = left[least[left] > ROUNDED * (S_A + L) * L]
        if not len(left):
            break
    return np.where((least <= CLOSED * (S_A + L) * L)[:, None], best, np.nan)


def _distinct(pose: np.ndarray, geometry: Geometry) -> np.ndarray:
    """Each pose of (n, 12, 3) once, ordered by alpha, then X_c: (n, 6, 3)."""
    x, y, alpha = np.moveaxis(pose, -1, 0)
    parts = (x / geometry.L, y / geometry.L, np.cos(alpha), np.sin(alpha))
    same = np.logical_and.reduce([np.abs(part[..., None] - part[:, None]) <= ONE_POSE for part in parts])
    again = np.tril(same, -1).any(axis=-1)
    pose = np.where(again[..., None], np.nan, pose)
    order = np.lexsort((pose[..., 0], np.round(pose[..., 2], 9)), axis=-1)[:, :MODES]
    return np.take_along_axis(pose, order[..., None], axis=1)


def _wrap(pose: np.ndarray) -> np.ndarray:
    """``pose`` with its last entry in (-pi, pi]."""
    turned = np.pi - np.mod(np.pi - pose[..., -1:], 2 * np.pi)
    turned = np.where(turned <= -np.pi, np.pi, turned)  # where rounding makes it a full turn
    return np.concatenate([pose[..., :-1], turned], axis=-1)
