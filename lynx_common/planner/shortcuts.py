"""Cutting the corners of a path."""

import numpy as np

from ..errors import InputError
from .edges import Free, check_budget, check_lengths, edges_free, finite


def shortcut(
    free: Free, path: np.ndarray, tries: int = 200, seed: int = 0, resolution: float = 0.05
) -> np.ndarray:
    """A path (n, m) with corners cut off, wherever a straight line between two random places of it is free.

    Both ends stay; joint travel never grows. ``tries`` lines are tried, and equal input gives equal output. Raises
    InputError where the path is not (n, m), n >= 2, and finite, or a number makes no sense.
    """
    path = finite("path", path, 2)
    if len(path) < 2:
        raise InputError(f"A path has two corners or more; {len(path)} were given.")
    check_budget("tries", tries)
    check_lengths(float(np.linalg.norm(np.ptp(path, axis=0))), resolution=resolution)
    for first, second in np.sort(np.random.default_rng(seed).random((tries, 2)), axis=1):
        along = np.append(0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1)))
        ends = np.array([first, second]) * along[-1]
        a, b = np.clip(np.searchsorted(along, ends, side="right") - 1, 0, len(path) - 2)
        if a == b:
            continue
        cut = np.stack([np.interp(ends, along, joint) for joint in path.T], axis=1)
        corners = np.concatenate([path[a : a + 1], cut, path[b + 1 : b + 2]])
        # What is left of the two pieces is checked anew: at other postures than the whole was.
        if edges_free(free, corners[:-1], corners[1:], resolution).all():
            path = np.concatenate([path[: a + 1], cut, path[b + 1 :]])
    return path
