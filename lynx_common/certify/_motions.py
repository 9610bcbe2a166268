"""Proofs along a motion, by a known Lipschitz constant and bisection."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InputError
from ..reading import finite, number, real

EPS = np.finfo(float).eps


@dataclass(frozen=True)
class Certificate:
    """What ``along`` or ``over`` found.

    verdict : "certified", "refuted" or "undecided".
    bound : a lower bound of the quantity that is proven everywhere, whatever the verdict.
    evaluations : how many values or bounds of it were asked for.
    witness : a place, (n,), where it is below the minimum; None unless refuted.
    boxes : (k, n, 2), the boxes into which ``over`` has cut the one that it was given; with ``along`` none.
    """

    verdict: str
    bound: float
    evaluations: int
    witness: np.ndarray | None
    boxes: np.ndarray = field(default_factory=lambda: np.empty((0, 0, 2)), repr=False)


def along(
    f: Callable[[np.ndarray], np.ndarray],
    lipschitz: float,
    q: ArrayLike,
    minimum: float = 0.0,
    budget: int = 100_000,
    rounding: float = 1e-12,
) -> Certificate:
    """Prove that f >= minimum along a motion, or find a place where it is not.

    What is proven holds at *every* point of the straight segments in joint space between neighbouring samples. It
    says nothing of a path that leaves them, such as a straight line of the gripper. A piece of length l with the
    value f in its middle has the lower bound f - lipschitz l / 2. Where that falls short of the minimum, the
    piece is halved; each round evaluates all pieces that are left at once.

    Parameters
    ----------
    f : callable
        Takes joint angles (k, m), gives (k,).
    lipschitz : float
        |f(a) - f(b)| <= lipschitz |a - b| everywhere, Euclidean norm. The proof is worth as much as this number.
    q : array, shape (n, m), n >= 1
        Samples of the motion, in radians: [start, end], or what ``follow`` returns.
    budget : int
        Largest number of evaluations of f.
    rounding : float
        How far a value of f may be from the true one, in units of f. This, and what the rounding of q can
        change, is taken off each bound.

    Undecided where the budget is spent, or f touches the minimum within rounding. Raises InputError where q, a
    value of f, or one of the numbers is not real and finite, or ``lipschitz`` or ``rounding`` is negative. Source:
    the lower bound of Piyavskii and Shubert, by bisection.

    >>> height = lambda q: 1.5 - np.cos(q[:, 0])
    >>> along(height, lipschitz=1, q=[[-1], [2]], minimum=0.4).verdict, along(height, 1, [[-1], [2]], 0.6).verdict
    ('certified', 'refuted')
    """
    lipschitz, rounding = number(lipschitz, "Lipschitz constant", least=0), number(rounding, "rounding", least=0)
    minimum, q = number(minimum, "minimum"), _samples(q)
    start, change = (q, 0 * q) if len(q) == 1 else (q[:-1], np.diff(q, axis=0))
    reach = lipschitz * np.linalg.norm(change, axis=1)  # how far f may change along a segment
    slack = rounding + 8 * EPS * lipschitz * np.linalg.norm(q, axis=1).max()
    segment, middle, half = _first_pieces(len(start))
    proven, open_bound, evaluations = np.inf, -np.inf, 0
    while len(segment):
        if evaluations + len(segment) > budget:
            return Certificate("undecided", float(min(proven, open_bound)), evaluations, None)
        at = start[segment] + middle[:, None] * change[segment]
        low, high = _values(f, at, slack)
        evaluations += len(at)
        change_to_end = reach[segment] * half
        bound = low - change_to_end
        if high.min() < minimum:
            return Certificate("refuted", float(min(proven, bound.min())), evaluations, at[high.argmin()])
        halve = (bound < minimum) & (change_to_end > slack)  # below the slack halving does not help
        proven = min(proven, bound[~halve].min(initial=np.inf))  # of the pieces that are done with
        open_bound = bound[halve].min(initial=np.inf)  # of those that are left
        segment, middle, half = _halves(segment[halve], middle[halve], half[halve])
    return Certificate("certified" if proven >= minimum else "undecided", float(proven), evaluations, None)


def _samples(q: ArrayLike) -> np.ndarray:
    q = finite(q, "the samples of a motion", None, None)
    if not q.size:
        raise InputError(f"A motion has a sample and a joint at least; one of shape {q.shape} was given.")
    return q


def _first_pieces(segments: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """All samples, as pieces of no width, and all segments: number of the segment, middle, half width.

    The last two are shares of the segment: sums of powers of 1/2, so exact.
    """
    each = np.arange(segments)
    segment = np.concatenate([each, each[-1:], each])
    return segment, np.repeat([0, 1, 0.5], [segments, 1, segments]), np.repeat([0, 0.5], [segments + 1, segments])


def _halves(
    segment: np.ndarray, middle: np.ndarray, half: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The first and the second half of each piece, as such pieces."""
    middles = np.stack([middle - half / 2, middle + half / 2], axis=1)
    return np.repeat(segment, 2), middles.ravel(), np.repeat(half / 2, 2)


def _values(f: Callable[[np.ndarray], np.ndarray], q: np.ndarray, slack: float) -> tuple[np.ndarray, np.ndarray]:
    """Between which values, (k,) each, f lies at q, (k, m)."""
    value = real(f(q), "the quantity")
    if value.shape != (len(q),):
        raise InputError(f"f(q) must return one number a posture, shape ({len(q)},); its shape is {value.shape}.")
    for i in np.flatnonzero(~np.isfinite(value)):
        raise InputError(f"The quantity is {value[i]} at q = {q[i].tolist()}.")
    doubt = slack + 4 * EPS * np.abs(value)
    return value - doubt, value + doubt
