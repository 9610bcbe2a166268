"""Screw systems: how many of some twists are independent, and which wrenches do no work on any of them."""

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InputError
from ..reading import finite, number, real

# Singular values below this share of the largest count as zero. Those of a dependent system come out near 1e-16 of
# it; so what passes for dependent is so, but for errors of 1e-9 in the data.
RANK_TOLERANCE = 1e-9


def reciprocal_product(twist: ArrayLike, wrench: ArrayLike) -> np.ndarray:
    """Power f . v + m . omega of a wrench on a twist, (..., 6) each; (...). Reciprocal are those where it is 0.

    >>> reciprocal_product([1, 2, 3, 0, 0, 0.5], [0, 0, 1, 0, 0, 2]).item()
    4.0
    """
    return (real(twist, "a twist", 6) * real(wrench, "a wrench", 6)).sum(axis=-1)


def order(system: ArrayLike, length: float = 1.0) -> np.ndarray:
    """Number of independent twists among the columns: (..., 6, n) to integers (...).

    ``length`` makes v and omega comparable: v is divided by it. It decides only whether a small singular value
    (RANK_TOLERANCE) is zero; take about the size of the robot. Of wrenches it counts the independent ones; there
    take the inverse of the length. Raises InputError where a number is not finite, or the length not above 0.

    >>> order([[0, 0, 0], [0, 1, 2], [0, 0, 0], [0, 0, 0], [0, 0, 0], [1, 1, 1]]).item()  # three parallel turns
    2
    """
    system = real(system, "a system of screws", 6, None)
    if not np.isfinite(system).all():
        raise InputError("Twists and wrenches of a system are finite numbers.")
    values = np.linalg.svd(_scaled(system, length), compute_uv=False)
    largest = values.max(axis=-1, keepdims=True, initial=0.0)
    return (values > RANK_TOLERANCE * largest).sum(axis=-1)


def reciprocal_system(twists: ArrayLike, length: float = 1.0) -> np.ndarray:
    """All wrenches that do no work on any of the twists, as columns of a basis: (6, n) to (6, 6 - order).

    It is the null space of the transposed matrix, by singular values; see ``order`` for ``length``. The columns
    are orthonormal once their forces are multiplied by ``length``. On a chain's joint twists: the wrenches that
    its structure carries without any motor.

    >>> abs(reciprocal_system(np.eye(6)[:, :5])).T  # of all twists but turns about z: a couple about z
    array([[0., 0., 0., 0., 0., 1.]])
    """
    twists = finite(twists, "the twists of one system", 6, None)
    left, _, _ = np.linalg.svd(_scaled(twists, length))
    return _scaled(left[:, int(order(twists, length)) :], length)


def _scaled(system: np.ndarray, length: float) -> np.ndarray:
    length = number(length, "length", above=0)
    return system / np.array([length] * 3 + [1.0] * 3)[:, None]
