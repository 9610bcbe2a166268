"""Straight lines in joint space: whether they are free, and how long they are; and what is asked of the input."""

from collections.abc import Callable

import numpy as np

from ..errors import EndpointError, InputError, JointLimitError, NotFreeError
from ..reading import real, shortened

# Room for rounding where a start or a goal stands exactly at a limit, as in ``arm``.
AT_LIMIT = 1e-9

# Postures that are tried on one line, and tries of all kinds: more would fill the memory.
LARGEST_EDGE, LARGEST_BUDGET = 100_000, 10_000_000

Free = Callable[[np.ndarray], np.ndarray]


def joint_travel(path: np.ndarray) -> float:
    """Sum of the lengths of the straight pieces of a path (n, m), in radians; NaN where it holds NaN."""
    path = real(path, "a path", None, None)
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())


def edges_free(free: Free, a: np.ndarray, b: np.ndarray, resolution: float) -> np.ndarray:
    """Whether the straight lines from a to b, (k, m) each, are free: (k,) of bool.

    They are tried at every ``resolution`` radians or nearer, in one call of ``free`` for all.
    """
    if not len(a):
        return np.zeros(0, bool)
    pieces = np.maximum(1, np.ceil(np.linalg.norm(b - a, axis=1) / resolution).astype(int))
    first = np.cumsum(pieces + 1) - pieces - 1
    edge = np.repeat(np.arange(len(a)), pieces + 1)
    share = ((np.arange(len(edge)) - first[edge]) / pieces[edge])[:, None]
    return np.logical_and.reduceat(_free(free, (1 - share) * a[edge] + share * b[edge]), first)


def _free(free: Free, q: np.ndarray) -> np.ndarray:
    found = np.asarray(free(q))
    if found.shape != (len(q),) or found.dtype != bool:
        raise InputError(
            f"free(q) must return one bool a posture, shape ({len(q)},); "
            f"it returned {found.dtype} of shape {found.shape}."
        )
    return found


def problem(
    free: Free, limits: np.ndarray, start: np.ndarray, goal: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Limits, start and goal as arrays of numbers; raises what ``plan`` says."""
    limits = finite("limits", limits, 2)
    if limits.shape[1] != 2 or (limits[:, 0] >= limits[:, 1]).any():
        raise InputError(f"Limits are pairs, a lower and a larger upper one; {limits.tolist()} was given.")
    ends = []
    for name, q in (("start", start), ("goal", goal)):
        q = finite(name, q, 1)
        if q.shape != limits[:, 0].shape:
            raise InputError(f"The {name} must have one angle a joint, {len(limits)}; {q.size} were given.")
        for joint in np.flatnonzero((q < limits[:, 0] - AT_LIMIT) | (q > limits[:, 1] + AT_LIMIT)):
            cause = JointLimitError(int(joint) + 1, float(q[joint]), *map(float, limits[joint]))
            raise EndpointError(name, cause)
        if not _free(free, q[None].copy())[0]:  # whatever it does with its argument
            raise EndpointError(name, NotFreeError(q))
        ends.append(q)
    return limits, *ends


def finite(name: str, values: np.ndarray, axes: int) -> np.ndarray:
    """``values`` as float64; InputError unless they are finite real numbers on so many axes, one at least."""
    array = real(values, f"the {name}")
    if array.ndim != axes or not array.size or not np.isfinite(array).all():
        shape = "(m,)" if axes == 1 else "(m, 2)"
        raise InputError(f"The {name} must be finite real numbers, {shape}; {shortened(values)} was given.")
    return array.copy()


def check_budget(name: str, value: int) -> None:
    """InputError unless ``value`` is a whole number from 1 to LARGEST_BUDGET."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or not 1 <= value <= LARGEST_BUDGET:
        raise InputError(f"The number of {name} is a whole one from 1 to {LARGEST_BUDGET}; {value!r} was given.")


def check_lengths(longest: float, **lengths: float) -> None:
    """InputError unless each is one finite number above 0, in radians of joint travel.

    A ``resolution`` must not ask for more than LARGEST_EDGE postures on a line as long as the longest.
    """
    for name, value in lengths.items():
        if real(value, f"the {name}").shape or not 0 < value < np.inf:
            raise InputError(f"The {name} is a positive length in joint space; {value!r} was given.")
    if (postures := longest / lengths["resolution"]) > LARGEST_EDGE:
        given = f"a resolution of {lengths['resolution']:g} would try {postures:.2g}"
        raise InputError(f"On one line {LARGEST_EDGE} postures can be tried at most; {given}.")
