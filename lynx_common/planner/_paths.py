"""Paths of straight pieces in joint space: how long they are, whether they are free, and how to shorten them."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InputError
from ..reading import finite, number, real, whole

Free = Callable[[np.ndarray], np.ndarray]

# Postures that are tried on one line, and tries of all kinds: more would fill the memory.
LARGEST_LINE, LARGEST_BUDGET = 100_000, 10_000_000


def joint_travel(path: ArrayLike) -> float:
    """Sum of the lengths of the straight pieces of a path (n, m), in radians; NaN where it holds NaN.

    >>> joint_travel([[0, 0], [3, 4], [3, 5]])
    6.0
    """
    path = real(path, "a path", None, None)
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())


def shortcut(free: Free, path: ArrayLike, tries: int = 200, seed: int = 0, resolution: float = 0.05) -> np.ndarray:
    """A path (n, m) with corners cut off, wherever a straight line between two random places of it is free.

    Both ends stay; joint travel never grows. ``tries`` lines are tried, and equal input gives equal output. Raises
    InputError unless the path is finite and has two corners or more, ``tries`` is a whole number above 0, and
    ``resolution`` a length above 0.

    >>> everywhere = lambda q: np.ones(len(q), bool)
    >>> joint_travel(shortcut(everywhere, [[0, 0], [0, 1], [1, 1]])) < 1.5
    True
    """
    path = finite(path, "a path", None, None)
    if len(path) < 2:
        raise InputError(f"A path has two corners or more; {len(path)} were given.")
    tries = whole(tries, "number of tries", 1, LARGEST_BUDGET)
    resolution = fine_enough(resolution, float(np.linalg.norm(np.ptp(path, axis=0))))
    for shares in np.sort(np.random.default_rng(seed).random((tries, 2)), axis=1):
        travelled = np.append(0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1)))
        at = shares * travelled[-1]
        first, last = np.clip(np.searchsorted(travelled, at, side="right") - 1, 0, len(path) - 2)
        if first == last:
            continue  # both places are on one piece, which is straight
        cut = np.stack([np.interp(at, travelled, joint) for joint in path.T], axis=1)
        # What is left of the two pieces is checked anew: at other postures than the whole was.
        corners = np.concatenate([path[first : first + 1], cut, path[last + 1 : last + 2]])
        if lines_free(free, corners[:-1], corners[1:], resolution).all():
            path = np.concatenate([path[: first + 1], cut, path[last + 1 :]])
    return path


def lines_free(free: Free, a: np.ndarray, b: np.ndarray, resolution: float) -> np.ndarray:
    """Whether the straight lines from a to b, (k, m) or one (m,) for all, are free: (k,) of bool.

    They are tried at every ``resolution`` radians or nearer, ends included, in one call of ``free`` for all.
    """
    lengths = np.linalg.norm(b - a, axis=1)
    if not len(lengths):
        return np.zeros(0, bool)
    pieces = np.maximum(1, np.ceil(lengths / resolution).astype(int))
    line = np.repeat(np.arange(len(lengths)), pieces + 1)  # to which each posture belongs
    begins = np.cumsum(pieces + 1) - (pieces + 1)
    share = ((np.arange(len(line)) - begins[line]) / pieces[line])[:, None]
    start, end = (x[line] if x.ndim == 2 else x for x in (a, b))
    return np.logical_and.reduceat(asked(free, (1 - share) * start + share * end), begins)


def asked(free: Free, q: np.ndarray) -> np.ndarray:
    """What ``free`` says of postures (k, m); InputError unless that is one bool a posture."""
    found = np.asarray(free(q))
    if found.shape != (len(q),) or found.dtype != bool:
        raise InputError(
            f"free(q) must return one bool a posture, shape ({len(q)},); "
            f"it returned {found.dtype} of shape {found.shape}."
        )
    return found


def fine_enough(resolution: float, longest: float) -> float:
    """The resolution as a number above 0; InputError where a line as long as the longest would take too much."""
    resolution = number(resolution, "resolution", above=0)
    if (postures := longest / resolution) > LARGEST_LINE:
        given = f"a resolution of {resolution:g} would try {postures:.2g}"
        raise InputError(f"On one line {LARGEST_LINE} postures can be tried at most; {given}.")
    return resolution
