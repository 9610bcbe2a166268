"""Proofs over a box: bounds of a formula by intervals, and bisection until they decide."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from .. import reading
from ..errors import InputError
from ._motions import Certificate

LARGEST_BUDGET = 10**8  # boxes

# Lower and upper bounds, (k,) each, of a quantity over boxes (k, n, 2), as ``symbolic.enclose`` gives them.
Bounds = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


def over(
    bounds: Bounds, box: ArrayLike, minimum: float = 0.0, within: Bounds | None = None, budget: int = 1_000_000
) -> Certificate:
    """Prove that a quantity is above ``minimum`` everywhere in a box.

    A box whose lower bound is not above the minimum is halved across its widest side, compared with the sides
    of the first box; each round bounds all boxes that are left at once. A box counts only with two finite bounds.

    Parameters
    ----------
    bounds : callable
        Lower and upper bounds, (k,) each, of the quantity over boxes (k, n, 2): see ``symbolic.enclose``.
    box : array, shape (n, 2)
        Lower and upper ends.
    within : callable like ``bounds``
        Bounds of a second quantity: where that is negative throughout, nothing needs to be proven.
    budget : int
        Largest number of boxes, of all sizes together.

    Refuted where the quantity is below the minimum in the middle of a box. Undecided where the budget is spent, as
    it is where the quantity touches the minimum. ``holds`` proves the boxes of a certificate again.

    >>> from lynx_common.symbolic import enclose
    >>> x = sp.Symbol("x", real=True)
    >>> over(enclose(x**2 - x, (x,)), [[0, 1]], minimum=-0.26).verdict
    'certified'
    """
    box, minimum = reading.finite(box, "a box", None, 2), reading.number(minimum, "minimum")
    budget = reading.whole(budget, "budget", 1, LARGEST_BUDGET)
    if not (box[:, 0] < box[:, 1]).all():
        raise InputError(f"A box has lower ends below its upper ones; {box.tolist()} was given.")
    left, done, evaluations, proven, open_bound = box[None], [], 0, np.inf, -np.inf
    while len(left):
        if evaluations + len(left) > budget:
            return Certificate("undecided", float(min(proven, open_bound)), evaluations, None)
        lower, above, outside = _judged(bounds, left, minimum, within)
        evaluations += len(left)
        proven = min(proven, lower[above & ~outside].min(initial=np.inf))
        done.append(left[above | outside])
        left, lower = left[~(above | outside)], lower[~(above | outside)]
        open_bound = np.where(np.isnan(lower), -np.inf, lower).min(initial=np.inf)
        if (witness := _witness(bounds, left, minimum, within)) is not None:
            return Certificate("refuted", float(min(proven, open_bound)), evaluations, witness)
        left = np.concatenate(_halves(left, box))
    return Certificate("certified", float(proven), evaluations, None, np.concatenate(done))


def holds(
    bounds: Bounds, box: ArrayLike, boxes: ArrayLike, minimum: float = 0.0, within: Bounds | None = None
) -> bool:
    """Whether ``boxes`` (k, n, 2) cover ``box`` without a gap, and the quantity is above ``minimum`` in each.

    It repeats no search: each box is bounded once, and the halving of the first box must end in these boxes.

    >>> from lynx_common.symbolic import enclose
    >>> x = sp.Symbol("x", real=True)
    >>> f = enclose(x**2 - x, (x,))
    >>> proof = over(f, [[0, 1]], minimum=-0.26)
    >>> holds(f, [[0, 1]], proof.boxes, minimum=-0.26), holds(f, [[0, 1]], proof.boxes[1:], minimum=-0.26)
    (True, False)
    """
    box, boxes = reading.finite(box, "a box", None, 2), reading.finite(boxes, "boxes", None, len(box), 2)
    _, above, outside = _judged(bounds, boxes, minimum, within)
    ends, left = {one.tobytes() for one in boxes}, box[None]
    for _ in range(len(boxes) + 1):  # a gap would be halved for ever
        left = left[[one.tobytes() not in ends for one in left]]
        if not len(left):
            return bool((above | outside).all())
        left = np.concatenate(_halves(left, box))
        if len(left) > 2 * len(boxes):
            return False
    return False


def _judged(
    bounds: Bounds, boxes: np.ndarray, minimum: float, within: Bounds | None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Lower bounds, whether they are above the minimum for certain, and whether a box is outside: (k,) each."""
    lower, upper = bounds(boxes)
    outside = np.zeros(len(boxes), bool)
    if within is not None:
        least, most = within(boxes)
        outside = np.isfinite(least) & (most < 0)
    return lower, np.isfinite(upper) & np.isfinite(lower) & (lower > minimum), outside


def _witness(bounds: Bounds, boxes: np.ndarray, minimum: float, within: Bounds | None) -> np.ndarray | None:
    """The middle of a box, if the quantity is below the minimum there for certain."""
    middle = np.repeat(boxes.mean(axis=-1, keepdims=True), 2, axis=-1)
    lower, upper = bounds(middle)
    below = np.isfinite(lower) & (upper < minimum)
    if within is not None:
        least, most = within(middle)
        below &= np.isfinite(most) & (least >= 0)
    return middle[below.argmax(), :, 0] if below.any() else None


def _halves(boxes: np.ndarray, first: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Boxes halved across the side that is widest in comparison with that of the first box."""
    side = (np.diff(boxes)[..., 0] / np.diff(first)[:, 0]).argmax(axis=1)
    number = np.arange(len(boxes))
    middle = boxes[number, side].mean(axis=1)
    low, high = boxes.copy(), boxes.copy()
    low[number, side, 1], high[number, side, 0] = middle, middle
    return low, high
