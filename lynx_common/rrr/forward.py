"""Forward kinematics: all poses of the platform at given motor angles."""

from functools import cache

import numpy as np

from ..errors import NoPoseError, SelfMotionError
from ..symbolic import DESIGN, POSE, compiled, real
from . import formulas
from .condition import ALPHAS, as_complex, condition_at, self_motion
from .formulas import THETA
from .geometry import RRR, Geometry, checked, elbows, one, platform_joints

MODES = 6  # assembly modes, at most

PART = 4096  # configurations worked through at a time
NEARLY_REAL = 1e-3  # where two real roots nearly meet, rounding can give them imaginary parts
NEWTON = 6  # steps; four suffice but where two poses nearly meet
CLOSED = 1e-12  # largest miss of a leg that counts as closed, as a share of S_A + L
SAME = 1e-7  # solutions nearer than this, in radians and shares of L, are one


_newton = compiled(POSE, THETA, DESIGN)(formulas.newton)


def forward_kinematics(theta: np.ndarray, geometry: Geometry = RRR) -> np.ndarray:
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

    Source: notebook Part2, section 7.
    """
    theta = real(theta, THETA)
    flat = theta.reshape(-1, 3)
    pose = np.empty((len(flat), MODES, 3))
    for start in range(0, len(flat), PART):
        part = slice(start, start + PART)
        pose[part] = _poses(flat[part], geometry)
    return pose.reshape(*theta.shape[:-1], MODES, 3)


def assemble(theta: np.ndarray, near: np.ndarray, geometry: Geometry = RRR) -> np.ndarray:
    """The pose, (3,), at motor angles (3,) that is nearest to the pose ``near``, (3,).

    Distance is that in the plane, with alpha times r_platform as the third coordinate. Raises SelfMotionError
    where the motor angles do not fix the pose, NoPoseError where none closes, and InputError for anything but
    three finite motor angles and one finite pose.
    """
    theta, near = one("set of motor angles", theta, THETA), checked(one("pose", near, POSE))
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
    pose = np.full((len(theta), 2 * MODES, 3), np.nan)
    (sound,) = np.nonzero(np.isfinite(theta).all(axis=-1) & ~self_motion(theta, geometry))
    alpha = _roots(theta[sound], geometry)
    row, column = np.nonzero(np.isfinite(alpha))
    theta, alpha = theta[sound[row]], alpha[row, column]
    start = np.concatenate([np.c_[centre, alpha] for centre in _centres(alpha, theta, geometry)])
    refined = _refined(start, np.concatenate([theta, theta]), geometry)
    for side in (0, 1):
        pose[sound[row], column + side * MODES] = refined[side * len(row) : (side + 1) * len(row)]
    return _distinct(pose, geometry)


def _roots(theta: np.ndarray, geometry: Geometry) -> np.ndarray:
    """The angles alpha, (n, 6), that satisfy the condition; NaN for complex roots."""
    positive, negative = np.moveaxis(condition_at(ALPHAS, theta[:, None], geometry), -1, 0)
    value = positive - negative
    opposite = ALPHAS[np.abs(value).argmax(axis=-1), None] - np.pi  # the largest value comes to t = infinity
    fourier = np.fft.rfft(value)[:, :4] / 8 * [1, 2, 2, 2] * np.exp(1j * opposite * np.arange(4))
    polynomial = (fourier @ _half_angle()).real  # highest power first
    companion = np.zeros((len(theta), 6, 6))
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


def _centres(alpha: np.ndarray, theta: np.ndarray, geometry: Geometry) -> tuple[np.ndarray, np.ndarray]:
    """Both points, (n, 2), at the distance L from the two of the three points that are farthest apart."""
    r = as_complex(platform_joints(np.zeros(3), geometry))
    w = as_complex(elbows(theta, geometry)) - np.exp(1j * alpha[:, None]) * r
    side = np.roll(w, -1, axis=1) - w
    longest = np.abs(side).argmax(axis=1)[:, None]
    side, w = (np.take_along_axis(x, longest, axis=1)[:, 0] for x in (side, w))
    height = np.sqrt(np.maximum((2 * geometry.L / np.abs(side)) ** 2 - 1, 0)) / 2
    both = [w + side * (0.5 + sign * 1j * height) for sign in (1, -1)]
    return tuple(np.stack([c.real, c.imag], axis=-1) for c in both)


def _refined(pose: np.ndarray, theta: np.ndarray, geometry: Geometry) -> np.ndarray:
    """``pose`` (n, 3) after Newton's method on the legs' lengths; NaN where they do not close.

    The best of all steps is kept: where two poses meet, A is singular, and a step can lead away from a solution.
    """
    best, least = pose, np.full(len(pose), np.inf)
    for _ in range(NEWTON + 1):
        with np.errstate(invalid="ignore", divide="ignore"):
            off, step = np.moveaxis(_newton(pose, theta, geometry), -2, 0)
        miss = np.abs(off).max(axis=-1, initial=0)
        best = np.where((miss < least)[:, None], pose, best)
        least = np.fmin(miss, least)
        pose = pose - step
    S_A, L, *_ = geometry
    return np.where((least <= CLOSED * (S_A + L) * L)[:, None], _wrap(best), np.nan)


def _distinct(pose: np.ndarray, geometry: Geometry) -> np.ndarray:
    """Each pose of (n, 12, 3) once, ordered by alpha, then X_c: (n, 6, 3)."""
    x, y, alpha = np.moveaxis(pose, -1, 0)
    parts = (x / geometry.L, y / geometry.L, np.cos(alpha), np.sin(alpha))
    same = np.logical_and.reduce([np.abs(part[..., None] - part[:, None]) <= SAME for part in parts])
    again = np.tril(same, -1).any(axis=-1)
    pose = np.where(again[..., None], np.nan, pose)
    order = np.lexsort((pose[..., 0], np.round(pose[..., 2], 9)), axis=-1)[:, :MODES]
    return np.take_along_axis(pose, order[..., None], axis=1)


def _wrap(pose: np.ndarray) -> np.ndarray:
    """``pose`` with its last entry in (-pi, pi]."""
    turned = np.pi - np.mod(np.pi - pose[..., -1:], 2 * np.pi)
    turned = np.where(turned <= -np.pi, np.pi, turned)  # where rounding makes it a full turn
    return np.concatenate([pose[..., :-1], turned], axis=-1)
