"""When: time scalings, and the shortest time in which the joints may move along a path.

A time scaling s(tau) is the share s of a path covered after the share tau = t/T of the time, from 0 to 1. Each
takes tau, (...) within 0 to 1, and returns s and its first and second derivative with respect to tau, three arrays
of that shape; divided by T and T**2 they are those with respect to time. Raises InputError outside 0 to 1.

Source: Lynch and Park, *Modern Robotics*, section 9.2; ``from_stretch`` and ``to_stretch`` are this course's.
"""

import numpy as np
from numpy.typing import ArrayLike

from .. import reading
from ..errors import InputError, JumpError
from ._following import LARGEST_STEP
from ._paths import share

Scaling = tuple[np.ndarray, np.ndarray, np.ndarray]


def cubic(tau: ArrayLike) -> Scaling:
    """s = 3 tau^2 - 2 tau^3: at rest at both ends, with a jump of the acceleration.

    >>> s, s_dot, s_ddot = cubic([0.0, 0.5, 1.0])
    >>> s_dot.tolist(), s_ddot.tolist()
    ([0.0, 1.5, 0.0], [6.0, 0.0, -6.0])
    """
    return _polynomial(tau, 0, 0, 3, -2)


def quintic(tau: ArrayLike) -> Scaling:
    """s = 10 tau^3 - 15 tau^4 + 6 tau^5: at rest at both ends, without acceleration there.

    >>> s, s_dot, s_ddot = quintic([0.0, 0.5, 1.0])
    >>> s_dot.tolist(), s_ddot.tolist()
    ([0.0, 1.875, 0.0], [0.0, 0.0, 0.0])
    """
    return _polynomial(tau, 0, 0, 0, 10, -15, 6)


def from_stretch(tau: ArrayLike) -> Scaling:
    """s = 15 tau^4 - 24 tau^5 + 10 tau^6: for a path that starts at full stretch.

    There theta_3 grows as the square root of s. With s ~ tau^4 it grows as tau^2, so that joint speeds and
    accelerations stay finite, as they do not with ``quintic``. At the end it rests as ``quintic`` does.

    >>> from_stretch([0.0, 0.5, 1.0])[0].tolist()
    [0.0, 0.34375, 1.0]
    """
    return _polynomial(tau, 0, 0, 0, 0, 15, -24, 10)


def to_stretch(tau: ArrayLike) -> Scaling:
    """``from_stretch`` run backwards: for a path that ends at full stretch, 1 - s ~ (1 - tau)^4.

    >>> to_stretch([0.0, 0.5, 1.0])[0].tolist()
    [0.0, 0.65625, 1.0]
    """
    s, s_dot, s_ddot = from_stretch(1 - share(tau, "time tau"))
    return 1 - s, s_dot, -s_ddot


def trapezoidal(tau: ArrayLike, blend: float = 0.25) -> Scaling:
    """Constant acceleration for the share ``blend`` of the time, constant speed, and the same deceleration.

    ``blend`` is above 0 and at most 1/2, where nothing is left for the constant speed; InputError otherwise.

    >>> s, s_dot, s_ddot = trapezoidal([0.0, 0.5, 1.0])
    >>> (s_dot.round(4) + 0.0).tolist()
    [0.0, 1.3333, 0.0]
    """
    blend = reading.number(blend, "blend, a share of the time", above=0, most=0.5)
    tau = share(tau, "time tau")
    speed = 1 / (1 - blend)
    acceleration = speed / blend
    rising, falling = np.minimum(tau, blend), np.maximum(tau - (1 - blend), 0)
    s = speed * np.maximum(tau - blend, 0) + acceleration / 2 * (rising**2 - falling**2)
    s_ddot = acceleration * ((tau < blend) * 1.0 - (tau > 1 - blend))
    return s, acceleration * (rising - falling), s_ddot


def duration(q: ArrayLike, speed_limits: ArrayLike, acceleration_limits: ArrayLike) -> float:
    """Shortest time in which joint angles sampled along a motion keep the limits of speed and acceleration.

    Speeds shrink as 1/T and accelerations as 1/T**2 when the motion is stretched to last T, so that one of the
    two decides. They are taken at the samples, by differences, and extrapolated to both ends; between samples
    nothing is known, and of what comes before and after nothing is asked. At full stretch theta_3 is known to 1e-7
    rad only, which shows in the accelerations where there are more than some 3,000 samples.

    Parameters
    ----------
    q : array, shape (n, 5), n >= 4
        Joint angles in radians at equal steps of time, the time scaling applied: ``follow(path(s)).q``.
    speed_limits, acceleration_limits : floats or arrays, shape (5,)
        Positive, rad/s and rad/s^2; infinite where there is no limit.

    Returns
    -------
    T : float
        Seconds; 0 where nothing moves. Raises InputError where q holds NaN (as where a path was not followed)
        or too few samples, or a limit is not positive; JumpError where a joint moves by more than 90 deg
        between two samples.

    >>> q = np.outer(np.linspace(0, 1, 101), [1.0, 0, 0, 0, 0])  # joint 1 turns by 1 rad, evenly
    >>> round(duration(q, speed_limits=0.5, acceleration_limits=np.inf), 9)  # seconds
    2.0
    """
    q = reading.finite(q, "joint angles", None, 5)
    if len(q) < 4:
        raise InputError(f"Four samples of joint angles or more are expected; {len(q)} were given.")
    _check_steps(q)
    speed = (len(q) - 1) * np.diff(q, axis=0)
    acceleration = (len(q) - 1) * np.diff(speed, axis=0)
    fastest = np.abs(np.vstack([speed, _ends(speed, 0.5)])).max(axis=0)
    hardest = np.abs(np.vstack([acceleration, _ends(acceleration, 1)])).max(axis=0)
    by_speed = fastest / _limit("speed", speed_limits)
    by_acceleration = hardest / _limit("acceleration", acceleration_limits)
    return float(max(by_speed.max(), np.sqrt(by_acceleration.max())))


def _check_steps(q: np.ndarray) -> None:
    """Raise JumpError where a joint angle of samples (n, 5) moves by more than LARGEST_STEP at once."""
    steps = np.abs(np.diff(q, axis=0))
    for sample in np.flatnonzero((steps > LARGEST_STEP).any(axis=1)) + 1:
        joint = int(steps[sample - 1].argmax())
        raise JumpError(int(sample), joint + 1, float(steps[sample - 1, joint]), LARGEST_STEP)


def _ends(values: np.ndarray, beyond: float) -> np.ndarray:
    """Values (n, 5) extrapolated beyond both ends, by this share of a step."""
    (first, second), (last, before) = values[:2], values[-1:-3:-1]
    return np.array([first + beyond * (first - second), last + beyond * (last - before)])


def _limit(name: str, values: ArrayLike) -> np.ndarray:
    values = reading.real(values, f"a limit of {name}")
    if values.shape not in ((), (5,)) or not np.all(values > 0):
        raise InputError(f"A limit of {name} is one positive number, or one a joint; {values.tolist()} was given.")
    return values


def _polynomial(tau: ArrayLike, *coefficients: float) -> Scaling:
    s, tau = np.polynomial.Polynomial(coefficients), share(tau, "time tau")
    return s(tau), s.deriv(1)(tau), s.deriv(2)(tau)
