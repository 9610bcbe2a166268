"""Paths in task coordinates (azimuth, signed r, z, pitch, roll), each with its exact derivative.

Nothing here asks whether the arm reaches: that is ``follow``.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .. import reading
from ..errors import InputError, told_apart
from ..symbolic import TASK, XYZ

# Room for rounding: of a parameter beyond 0 or 1, and, in metres, of a line that meets the base axis.
ROOM = 1e-9

ANGLES = np.array([True, False, False, True, True])  # which task coordinates are angles


@dataclass(frozen=True)
class Path:
    """A path: ``path(s)`` and ``path.derivative(s)`` take s, (...) within 0 to 1, and give (..., 5).

    The derivative is the one with respect to s, metres and radians per unit of s. Raises InputError where s is
    not real or not within 0 to 1. Made of two functions, ``point`` and ``slope``, of s with a last axis of
    length 1.
    """

    point: Callable[[np.ndarray], np.ndarray]
    slope: Callable[[np.ndarray], np.ndarray]

    def __call__(self, s: np.ndarray) -> np.ndarray:
        """Task coordinates at s."""
        return self.point(unit(s, "path's parameter s")[..., None])

    def derivative(self, s: np.ndarray) -> np.ndarray:
        """How they change with s."""
        return self.slope(unit(s, "path's parameter s")[..., None])


def line(start: np.ndarray, end: np.ndarray) -> Path:
    """The straight line in task coordinates between two of them, (5,) each; InputError where they are equal.

    The gripper runs straight in the arm's own plane. In space it does so only if the azimuth stays the same.
    """
    start, end = _finite(start), _finite(end)
    change = end - start
    if not change.any():
        raise InputError(f"A line needs two different ends; both are {start.tolist()}: its length is zero.")
    return Path(lambda s: (1 - s) * start + s * end, lambda s: change + 0 * s)


def sinusoidal(start: np.ndarray, end: np.ndarray, amplitude: np.ndarray) -> Path:
    """A line with a bump, amplitude * sin(pi s), (5,) in task coordinates; source: report section 1.6."""
    straight, amplitude = line(start, end), _finite(amplitude)
    return Path(
        lambda s: straight.point(s) + amplitude * np.sin(np.pi * s),
        lambda s: straight.slope(s) + np.pi * amplitude * np.cos(np.pi * s),
    )


def arc(
    centre: np.ndarray,
    radius: float,
    angles: tuple[float, float],
    pitch: tuple[float, float],
    azimuth: float = 0.0,
    roll: float = 0.0,
) -> Path:
    """A circular arc in the arm's plane, about ``centre`` = (r, z), by the polar angle about it.

    The first of ``angles`` and of ``pitch`` holds at the start, the second at the end; angles run from the
    direction of r towards that of z, any number of turns. Metres and radians. Raises InputError where the radius
    is not positive or the angles are equal.
    """
    if not radius > 0:
        raise InputError(f"The radius of an arc is a positive length in metres; {radius} was given.")
    if np.isfinite(angles).all() and angles[0] == angles[1]:
        raise InputError(f"An arc needs two different angles; both are {angles[0]} rad: its length is zero.")
    _, r, z, _, _ = _finite([azimuth, *centre, pitch[0], roll])
    # A line in (azimuth, radius, polar angle, pitch, roll), bent.
    polar = line(*([azimuth, radius, angle, tilt, roll] for angle, tilt in zip(angles, pitch, strict=True)))

    def point(s: np.ndarray) -> np.ndarray:
        azimuth, radius, angle, pitch, roll = np.moveaxis(polar.point(s), -1, 0)
        return np.stack([azimuth, r + radius * np.cos(angle), z + radius * np.sin(angle), pitch, roll], axis=-1)

    def slope(s: np.ndarray) -> np.ndarray:
        (_, radius, angle, _, _), along = np.moveaxis(polar.point(s), -1, 0), polar.slope(s)
        turning = radius * along[..., 2]
        along[..., 1], along[..., 2] = -turning * np.sin(angle), turning * np.cos(angle)
        return along

    return Path(point, slope)


def space_line(start: np.ndarray, end: np.ndarray, pitch: tuple[float, float], roll: float = 0.0) -> Path:
    """The straight line in space between two positions, (3,) metres in the base frame.

    The azimuth follows the gripper and is not wrapped on the way; r is positive, unless the line meets the base
    axis: then the azimuth stays as it is and r runs on below zero. The first pitch holds at the start, the
    second at the end. Raises InputError where both positions are equal.
    """
    start, end = reading.batch(start, XYZ), reading.batch(end, XYZ)
    if np.array_equal(start, end):
        raise InputError(f"A line needs two different ends; both are {start.tolist()}: its length is zero.")
    (x, y, _), (u, v, _) = start, end - start
    first, last = np.arctan2(y, x), np.arctan2(end[1], end[0])
    if abs(x * v - y * u) <= ROOM * np.hypot(u, v):  # it meets the base axis, or is upright
        azimuth = first if np.hypot(x, y) > ROOM else last
        towards = np.array([np.cos(azimuth), np.sin(azimuth), 0])
        return line(
            *([azimuth, p @ towards, p[2], tilt, roll] for p, tilt in zip((start, end), pitch, strict=True))
        )
    ends = line([*start, pitch[0], roll], [*end, pitch[1], roll])

    def point(s: np.ndarray) -> np.ndarray:
        at_x, at_y, z, tilt, turn = np.moveaxis(ends.point(s), -1, 0)
        # The line is seen from the base axis under less than half a turn.
        azimuth = first + np.arctan2(x * at_y - y * at_x, x * at_x + y * at_y)
        return np.stack([azimuth, np.hypot(at_x, at_y), z, tilt, turn], axis=-1)

    def slope(s: np.ndarray) -> np.ndarray:
        at_x, at_y, *_ = np.moveaxis(ends.point(s), -1, 0)
        r, along = np.hypot(at_x, at_y), ends.slope(s)
        along[..., 0], along[..., 1] = (at_x * v - at_y * u) / r**2, (at_x * u + at_y * v) / r
        return along

    return Path(point, slope)


def joined(*paths: Path) -> Path:
    """Paths one after another, each over an equal share of s; at a joint the derivative is that of the next.

    Each must begin where the one before ends, to 1e-9, full turns of its angles aside: it is moved by these, so
    that nothing jumps. Raises InputError otherwise, with the two sets of task coordinates.
    """
    if not paths:
        raise InputError("One path or more is needed; none was given.")
    moved = list(paths[:1])
    for number, path in enumerate(paths[1:], start=1):
        end, start = moved[-1](1.0), path(0.0)
        turns = 2 * np.pi * np.rint((end - start) / (2 * np.pi)) * ANGLES
        if not np.abs(start + turns - end).max() <= ROOM:
            which = int(np.abs(start + turns - end).argmax())
            begins, ends = told_apart((start + turns)[which], end[which], decimals=6)
            raise InputError(
                f"Path {number} begins with {TASK[which]} {begins}, where the one before ends with {ends}."
            )
        moved.append(Path(lambda s, path=path, turns=turns: path.point(s) + turns, path.slope))
    return Path(
        lambda s: _by_share(s, [path.point for path in moved]),
        lambda s: len(moved) * _by_share(s, [path.slope for path in moved]),
    )


def polyline(points: np.ndarray) -> Path:
    """Straight lines in task coordinates through points (n, 5), n >= 2, an equal share of s each.

    Raises InputError where two neighbours are equal, or there are fewer than two points.
    """
    if len(points) < 2:
        raise InputError(f"A polyline needs two points or more; {len(points)} were given.")
    return joined(*(line(*pair) for pair in pairwise(points)))


def unit(x: np.ndarray, name: str) -> np.ndarray:
    """``x`` as float64; InputError where it is not real, NaN or not within 0 to 1."""
    x = reading.real(x, f"the {name}")
    outside = ~((x >= -ROOM) & (x <= 1 + ROOM))
    if outside.any():
        raise InputError(f"The {name} runs from 0 to 1; {x[outside][0]} was given.")
    return x


def _by_share(s: np.ndarray, functions: list[Callable]) -> np.ndarray:
    """The value at s, (..., 1), of the function whose share of s holds it."""
    scaled = len(functions) * s
    number = np.clip(np.floor(scaled), 0, len(functions) - 1)
    out = np.empty((*s.shape[:-1], 5))
    for i, function in enumerate(functions):
        own = number[..., 0] == i
        out[own] = function(scaled[own] - i)
    return out


def _finite(task: np.ndarray) -> np.ndarray:
    task = reading.batch(task, TASK)
    if task.shape != (5,) or not np.isfinite(task).all():
        raise InputError(f"Five finite task coordinates are expected; {task.tolist()} was given.")
    return task
