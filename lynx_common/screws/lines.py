"""The lines behind six-vectors: axes of twists, lines of action of wrenches, and their pitch."""

from typing import NamedTuple

import numpy as np

from ..errors import ScrewError
from ..reading import real

# How far a unit vector may be from length 1.
UNIT_TOLERANCE = 1e-9

# A twist turns at all if its axis is not farther than the inverse of this from the origin.
NO_TURN = 1e-12


class Screw(NamedTuple):
    """A line, a pitch and a strength, as arrays over the batch.

    axis : unit vector along the line, (..., 3)
    point : the point of the line that is nearest to the origin, (..., 3)
    pitch : advance along the line for a turn of 1 rad, (...); infinite for a translation or a couple, whose
        line may then pass anywhere, and is given through the origin
    magnitude : |omega| of a twist, |f| of a wrench; |v| or |m| where the pitch is infinite, (...)
    """

    axis: np.ndarray
    point: np.ndarray
    pitch: np.ndarray
    magnitude: np.ndarray


def screw(axis: np.ndarray, point: np.ndarray, pitch: np.ndarray = 0.0) -> np.ndarray:
    """The unit twist, (..., 6), about a line: (point x axis + pitch axis, axis); (axis, 0) for an infinite pitch.

    ``axis`` and ``point`` are (..., 3), ``pitch`` is (...); they broadcast. Raises ScrewError where the axis is
    not a unit vector. Source: Modern Robotics, section 3.3.2.2.
    """
    axis, point, pitch = real(axis, "an axis", 3), real(point, "a point", 3), real(pitch, "a pitch")[..., None]
    length = np.linalg.norm(axis, axis=-1)
    if (off := np.abs(length - 1) > UNIT_TOLERANCE).any():
        raise ScrewError("An axis must be a unit vector", float(length[off].flat[0]))
    turns = np.isfinite(pitch) | np.isnan(pitch)
    finite = np.where(turns, pitch, 0.0)
    with np.errstate(invalid="ignore"):
        v = np.where(turns, np.cross(point, axis) + finite * axis, axis)
        omega = np.where(turns, axis, 0 * axis)
    twist = np.concatenate(np.broadcast_arrays(v, omega), axis=-1)
    return np.where(np.isfinite(twist).all(axis=-1, keepdims=True), twist, np.nan)


def revolute(axis: np.ndarray, point: np.ndarray) -> np.ndarray:
    """The unit twist, (..., 6), of a revolute joint about the line through ``point`` along ``axis``."""
    return screw(axis, point)


def prismatic(axis: np.ndarray) -> np.ndarray:
    """The unit twist, (..., 6), of a joint that slides along ``axis``."""
    return screw(axis, np.zeros(3), np.inf)


def force(axis: np.ndarray, point: np.ndarray) -> np.ndarray:
    """The wrench, (..., 6), of a force of 1 along the line through ``point``."""
    return swap(screw(axis, point))


def couple(axis: np.ndarray) -> np.ndarray:
    """The wrench, (..., 6), of a couple of 1 about ``axis``."""
    return swap(prismatic(axis))


def screw_axis(twist: np.ndarray) -> Screw:
    """Line, pitch and magnitude of twists (..., 6), so that twist = magnitude * screw(axis, point, pitch).

    Raises ScrewError where a twist is zero. Source: Modern Robotics, section 3.3.2.2.
    """
    twist = real(twist, "a twist", 6)
    twist = np.where(np.isfinite(twist).all(axis=-1, keepdims=True), twist, np.nan)
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


def swap(six: np.ndarray) -> np.ndarray:
    """The halves of six-vectors exchanged: a force along a line has the numbers of a turn about it, swapped."""
    return np.concatenate([six[..., 3:], six[..., :3]], axis=-1)
