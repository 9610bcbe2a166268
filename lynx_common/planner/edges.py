"""Straight lines in joint space: whether they are free, and how long they are; and what is asked of the input."""

from collections.abc import Callable

import numpy as np

from ..errors import EndpointError, InputError, JointLimitError, NotFreeError

# Room for rounding where a start or a goal stands exactly at a limit, as in ``arm``.
AT_LIMIT = 1e-9

Free = Callable[[np.ndarray], np.ndarray]


def joint_travel(path: np.ndarray) -> float:
    """Sum of the lengths of the straight pieces of a path (n, m), in radians."""
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
        if not _free(free, q[None])[0]:
            raise EndpointError(name, NotFreeError(q))
        ends.append(q)
    return limits, *ends


def finite(name: str, values: np.ndarray, axes: int) -> np.ndarray:
    """``values`` as float64; InputError unless they are finite real numbers on so many axes, one at least."""
    values = np.asarray(values)
    if values.ndim != axes or not values.size or values.dtype.kind not in "iuf" or not np.isfinite(values).all():
        shape = "(m,)" if axes == 1 else "(m, 2)"
        raise InputError(f"The {name} must be finite real numbers, {shape}; {values.tolist()} was given.")
    return values.astype(float)


def check_budget(name: str, value: int) -> None:
    """InputError unless ``value`` is a whole number, 1 or more."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < 1:
        raise InputError(f"The number of {name} is a whole number, 1 or more; {value!r} was given.")


def check_lengths(**lengths: float) -> None:
    """InputError unless each is one finite number above 0, in radians of joint travel."""
    for name, value in lengths.items():
        if np.iscomplexobj(value) or np.ndim(value) or not (np.isfinite(value) and value > 0):
            raise InputError(f"The {name} is a positive length in joint space; {value!r} was given.")
