"""Paths in task coordinates (azimuth, signed r, z, pitch, roll).

Nothing here asks whether the arm reaches: that is ``follow``.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .. import reading
from ..errors import InputError, told_apart
from ..symbolic import TASK

# Room for rounding: of a parameter beyond 0 or 1, and, in metres, of a line that meets the base axis.
ROOM = 1e-9

TURNING = np.array([True, False, False, True, True])  # which task coordinates are angles


@dataclass(frozen=True)
class Path:
    """A path: ``path(s)`` takes s, (...) within 0 to 1, and gives task coordinates (..., 5).

    ``point`` is a function of s with a last axis of length 1. Raises InputError where s is not within 0 to 1.

    >>> bump = Path(lambda s: [0, 0.3, 0.2, 0, 0] + np.sin(np.pi * s) * [0, 0, 0.1, 0, 0])
    >>> bump(0.5)
    array([0. , 0.3, 0.3, 0. , 0. ])
    """

    point: Callable[[np.ndarray], np.ndarray]

    def __call__(self, s: ArrayLike) -> np.ndarray:
        """Task coordinates at s."""
        return self.point(share(s, "path's parameter s")[..., None])


def line(start: ArrayLike, end: ArrayLike) -> Path:
    """The straight line in task coordinates between two of them, (5,) each; InputError where they are equal.

    The gripper runs straight in the arm's own plane. In space it does so only if the azimuth stays the same.

    >>> line([0, 0.2, 0.1, 0, 0], [0, 0.4, 0.3, 0, 0])(0.5)
    array([0. , 0.3, 0.2, 0. , 0. ])
    """
    start, end = (reading.finite(task, "task coordinates", 5) for task in (start, end))
    if np.array_equal(start, end):
        raise InputError(f"A line needs two different ends; both are {start.tolist()}: its length is zero.")
    return Path(lambda s: (1 - s) * start + s * end)


def space_line(start: ArrayLike, end: ArrayLike, pitch: tuple[float, float], roll: float = 0.0) -> Path:
    """The straight line in space between two positions, (3,) metres in the base frame.

    The azimuth follows the gripper and is not wrapped on the way; r is positive, unless the line meets the base
    axis: then the azimuth stays as it is and r runs on below zero. The first pitch holds at the start, the
    second at the end. Raises InputError where both positions are equal.

    >>> space_line([0.3, -0.1, 0.2], [0.3, 0.1, 0.2], pitch=(0, 0))(0.5).round(9) + 0.0
    array([0. , 0.3, 0.2, 0. , 0. ])
    """
    start, end = (reading.finite(position, "a position", 3) for position in (start, end))
    if np.array_equal(start, end):
        raise InputError(f"A line needs two different ends; both are {start.tolist()}: its length is zero.")
    (x, y, _), (u, v, _) = start, end - start
    first, last = np.arctan2(y, x), np.arctan2(end[1], end[0])
    if abs(x * v - y * u) <= ROOM * np.hypot(u, v):  # it meets the base axis, or is upright
        azimuth = first if np.hypot(x, y) > ROOM else last
        towards = np.array([np.cos(azimuth), np.sin(azimuth), 0])
        ends = ([azimuth, p @ towards, p[2], tilt, roll] for p, tilt in zip((start, end), pitch, strict=True))
        return line(*ends)
    straight = line([*start, pitch[0], roll], [*end, pitch[1], roll])

    def point(s: np.ndarray) -> np.ndarray:
        at_x, at_y, z, tilt, turn = np.moveaxis(straight.point(s), -1, 0)
        # The line is seen from the base axis under less than half a turn.
        azimuth = first + np.arctan2(x * at_y - y * at_x, x * at_x + y * at_y)
        return np.stack([azimuth, np.hypot(at_x, at_y), z, tilt, turn], axis=-1)

    return Path(point)


def joined(*paths: Path) -> Path:
    """Paths one after another, each over an equal share of s.

    Each must begin where the one before ends, to 1e-9, full turns of its angles aside: it is moved by these, so
    that nothing jumps. Raises InputError otherwise, with the two values that differ.

    >>> a, b, c = [0, 0.2, 0.1, 0, 0], [0, 0.3, 0.2, 0, 0], [0, 0.3, 0.4, 0, 0]
    >>> joined(line(a, b), line(b, c))([0.5, 0.75])
    array([[0. , 0.3, 0.2, 0. , 0. ],
           [0. , 0.3, 0.3, 0. , 0. ]])
    """
    if not paths:
        raise InputError("One path or more is needed; none was given.")
    moved: list[Path] = []
    turns = np.zeros(5)
    for number, path in enumerate(paths):
        if moved:
            end, start = moved[-1](1.0), path(0.0)
            turns = 2 * np.pi * np.rint((end - start) / (2 * np.pi)) * TURNING
            apart = np.abs(start + turns - end)
            if not apart.max() <= ROOM:
                worst = int(apart.argmax())
                begins, ends = told_apart((start + turns)[worst], end[worst], decimals=6)
                where = f"with {TASK[worst]} {begins}, where the one before ends with {ends}"
                raise InputError(f"Path {number} begins {where}.")
        moved.append(_moved(path, turns))

    def point(s: np.ndarray) -> np.ndarray:
        scaled = len(moved) * s
        number = np.clip(np.floor(scaled), 0, len(moved) - 1)
        task = np.empty((*s.shape[:-1], 5))
        for i, path in enumerate(moved):
            own = number[..., 0] == i
            task[own] = path.point(scaled[own] - i)
        return task

    return Path(point)


def _moved(path: Path, by: np.ndarray) -> Path:
    return Path(lambda s: path.point(s) + by)


def share(x: ArrayLike, name: str) -> np.ndarray:
    """``x`` as float64; InputError where it is not real, NaN or not within 0 to 1."""
    x = reading.real(x, f"the {name}")
    outside = ~((x >= -ROOM) & (x <= 1 + ROOM))
    if outside.any():
        raise InputError(f"The {name} runs from 0 to 1; {x[outside][0]} was given.")
    return x
