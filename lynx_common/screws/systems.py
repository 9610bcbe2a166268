"""Screw systems: how many of some twists are independent, and which wrenches do no work on any of them."""

import numpy as np

from ..errors import InputError
from ..reading import real

# Singular values below this share of the largest count as zero. Those of a dependent system come out near 1e-16 of
# it; so what passes for dependent is so, but for errors of 1e-9 in the data.
RANK_TOLERANCE = 1e-9


def reciprocal_product(twist: np.ndarray, wrench: np.ndarray) -> np.ndarray:
    """Power f . v + m . omega of a wrench on a twist, (..., 6) each; (...). Reciprocal are those where it is 0."""
    return (real(twist, "a twist", 6) * real(wrench, "a wrench", 6)).sum(axis=-1)


def order(system: np.ndarray, length: float = 1.0) -> np.ndarray:
    """Number of independent twists among the columns: (..., 6, n) to integers (...).

    ``length`` makes v and omega comparable: v is divided by it. It decides only whether a small singular value
    (RANK_TOLERANCE) is zero; take about the size of the robot. Of wrenches it counts the independent ones; there
    take the inverse of the length.
    """
    values = np.linalg.svd(_scaled(system, length), compute_uv=False)
    largest = values.max(axis=-1, keepdims=True, initial=0.0)
    return (values > RANK_TOLERANCE * largest).sum(axis=-1)


def reciprocal_system(twists: np.ndarray, length: float = 1.0) -> np.ndarray:
    """All wrenches that do no work on any of the twists, as columns of a basis: (6, n) to (6, 6 - order).

    It is the null space of the transposed matrix, by singular values; see ``order`` for ``length``. The columns
    are orthonormal once their forces are multiplied by ``length``. On a chain's joint twists: the wrenches that
    its structure carries without any motor.
    """
    scaled = _scaled(twists, length)
    if scaled.ndim != 2:
        raise InputError("One system is expected, (6, n): the number of wrenches differs from system to system.")
    left, _, _ = np.linalg.svd(scaled)
    return _scaled(left[:, int(order(twists, length)) :], length)


def _scaled(system: np.ndarray, length: float) -> np.ndarray:
    system = real(system, "a system of screws", 6, None)
    if not np.isfinite(system).all():
        raise InputError("Twists and wrenches of a system are finite numbers.")
    if not (np.isfinite(length) and length > 0):
        raise InputError(f"The length that makes v and omega comparable is positive; {length} was given.")
    return system / np.array([length] * 3 + [1.0] * 3)[:, None]
