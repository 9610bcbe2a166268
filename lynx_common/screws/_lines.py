"""The lines behind six-vectors: axes of joints, lines of action of forces, and the line of any twist."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import ScrewError
from ..reading import real

# How far a unit vector may be from length 1.
UNIT_TOLERANCE = 1e-9

# A twist turns at all if its axis is not farther than the inverse of this from the origin.
NO_TURN = 1e-12


class Screw(NamedTuple):
    """A line, a pitch and a magnitude, as arrays over the batch.

    axis : unit vector along the line, (..., 3)
    point : the point of the line that is nearest to the origin, (..., 3)
    pitch : advance along the line for a turn of 1 rad, (...); infinite for a translation, whose line may pass
        anywhere, and is given through the origin
    magnitude : |omega|, or |v| of a translation, (...)
    """

    axis: np.ndarray
    point: np.ndarray
    pitch: np.ndarray
    magnitude: np.ndarray


def revolute(axis: ArrayLike, point: ArrayLike) -> np.ndarray:
    """The unit twist, (..., 6), of a revolute joint about the line through ``point`` along ``axis``.

    Both are (..., 3), and broadcast. Raises ScrewError where the axis is not a unit vector. Source: Modern
    Robotics, section 3.3.2.2.

    >>> revolute([0, 0, 1], [2, 0, 0])
    array([ 0., -2.,  0.,  0.,  0.,  1.])
    """
    axis = _direction(axis)
    return _six(np.cross(vectors(point, "a point", 3), axis), axis)


def prismatic(axis: ArrayLike) -> np.ndarray:
    """The unit twist, (..., 6), of a joint that slides along ``axis``, (..., 3); ScrewError as for ``revolute``.

    >>> prismatic([0, 0, 1])
    array([0., 0., 1., 0., 0., 0.])
    """
    axis = _direction(axis)
    return _six(axis, 0 * axis)


def force(axis: ArrayLike, point: ArrayLike) -> np.ndarray:
    """The wrench, (..., 6), of a force of 1 along the line through ``point``; ScrewError as for ``revolute``.

    >>> force([0, 0, 1], [2, 0, 0])
    array([ 0.,  0.,  1.,  0., -2.,  0.])
    """
    axis = _direction(axis)
    return _six(axis, np.cross(vectors(point, "a point", 3), axis))


def screw_axis(twist: ArrayLike) -> Screw:
    """Line, pitch and magnitude of twists (..., 6), so that v = magnitude (point x axis + pitch axis).

    Raises ScrewError where a twist is zero. Source: Modern Robotics, section 3.3.2.2.

    >>> line = screw_axis([0, -6, 1.5, 0, 0, 3])
    >>> line.point + 0.0, line.pitch.item(), line.magnitude.item()
    (array([2., 0., 0.]), 0.5, 3.0)
    """
    twist = vectors(twist, "a twist", 6)
    v, omega = twist[..., :3], twist[..., 3:]
    speed, turn = (np.linalg.norm(x, axis=-1, keepdims=True) for x in (v, omega))
    if ((speed == 0) & (turn == 0)).any():
        raise ScrewError("A screw must have an axis", 0.0)
    slides = turn <= NO_TURN * speed
    magnitude = np.where(slides, speed, turn)
    axis = np.where(slides, v, omega) / magnitude
    point = np.where(slides, 0 * v, np.cross(axis, v / magnitude))
    pitch = np.where(slides[..., 0], np.inf, (axis * v / magnitude).sum(axis=-1))
    return Screw(axis, point, pitch, magnitude[..., 0])


def vectors(x: ArrayLike, name: str, n: int) -> np.ndarray:
    """``x`` as vectors (..., n); one that holds NaN or infinity becomes NaN throughout."""
    x = real(x, name, n)
    return np.where(np.isfinite(x).all(axis=-1, keepdims=True), x, np.nan)


def _direction(axis: ArrayLike) -> np.ndarray:
    """``axis`` as unit vectors (..., 3)."""
    axis = vectors(axis, "an axis", 3)
    length = np.linalg.norm(axis, axis=-1)
    if (off := np.abs(length - 1) > UNIT_TOLERANCE).any():
        raise ScrewError("An axis must be a unit vector", float(length[off].flat[0]))
    return axis


def _six(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Six-vectors, (..., 6), of their halves, which broadcast; NaN in one half is NaN in both."""
    return vectors(np.concatenate(np.broadcast_arrays(first, second), axis=-1), "a six-vector", 6) + 0.0  # no -0
