"""Time scalings s(tau): the share s of a path covered after the share tau = t/T of the time, from 0 to 1.

Each takes tau, (...) within 0 to 1, and returns s and its first and second derivative with respect to tau, three
arrays of that shape; divided by T and T**2 they are those with respect to time. Raises InputError outside 0 to 1.

Source: Lynch and Park, *Modern Robotics*, section 9.2; ``from_stretch`` and ``to_stretch`` are this course's.
"""

import numpy as np

from ..errors import InputError
from .paths import unit

Scaling = tuple[np.ndarray, np.ndarray, np.ndarray]


def linear(tau: np.ndarray) -> Scaling:
    """s = tau: constant speed, with a jump from rest and back to it."""
    return _polynomial(tau, 0, 1)


def cubic(tau: np.ndarray) -> Scaling:
    """s = 3 tau^2 - 2 tau^3: at rest at both ends, with a jump of the acceleration."""
    return _polynomial(tau, 0, 0, 3, -2)


def quintic(tau: np.ndarray) -> Scaling:
    """s = 10 tau^3 - 15 tau^4 + 6 tau^5: at rest at both ends, without acceleration there."""
    return _polynomial(tau, 0, 0, 0, 10, -15, 6)


def from_stretch(tau: np.ndarray) -> Scaling:
    """s = 15 tau^4 - 24 tau^5 + 10 tau^6: for a path that starts at full stretch.

    There theta_3 grows as the square root of s. With s ~ tau^4 it grows as tau^2, so that joint speeds and
    accelerations stay finite, as they do not with ``quintic``. At the end it rests as ``quintic`` does.
    """
    return _polynomial(tau, 0, 0, 0, 0, 15, -24, 10)


def to_stretch(tau: np.ndarray) -> Scaling:
    """``from_stretch`` run backwards: for a path that ends at full stretch, 1 - s ~ (1 - tau)^4."""
    s, s_dot, s_ddot = from_stretch(1 - unit(tau, "time tau"))
    return 1 - s, s_dot, -s_ddot


def trapezoidal(tau: np.ndarray, blend: float = 0.25) -> Scaling:
    """Constant acceleration for the share ``blend`` of the time, constant speed, and the same deceleration.

    ``blend`` is above 0 and at most 1/2, where nothing is left for the constant speed; InputError otherwise.
    """
    if not 0 < blend <= 0.5:
        raise InputError(f"The blend is a share of the time, above 0 and at most 0.5; {blend} was given.")
    tau = unit(tau, "time tau")
    speed = 1 / (1 - blend)
    acceleration = speed / blend
    rising, falling = np.minimum(tau, blend), np.maximum(tau - (1 - blend), 0)
    s = speed * np.maximum(tau - blend, 0) + acceleration / 2 * (rising**2 - falling**2)
    s_ddot = acceleration * ((tau < blend) * 1.0 - (tau > 1 - blend))
    return s, acceleration * (rising - falling), s_ddot


def _polynomial(tau: np.ndarray, *coefficients: float) -> Scaling:
    s, tau = np.polynomial.Polynomial(coefficients), unit(tau, "time tau")
    return s(tau), s.deriv(1)(tau), s.deriv(2)(tau)
