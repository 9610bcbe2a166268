"""The door from SymPy to intervals: bounds of a formula over whole boxes of its symbols.

Every step is rounded outwards, and a constant that no float holds exactly is an interval itself, so that the
bounds hold for the formula as it stands, not only for what floats make of it.
"""

from collections.abc import Callable, Sequence
from math import prod
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from .. import reading
from ..errors import InputError
from ._door import read

EPS = np.finfo(float).eps
EXACT = 2**53  # floats hold whole numbers up to here

Interval = tuple[np.ndarray, np.ndarray]  # lower and upper ends


def enclose(expr: Any, *vectors: Sequence[sp.Symbol]) -> Callable[..., Interval]:
    """Compile ``expr`` into a function of one box per vector of symbols, which gives a lower and an upper bound.

    Parameters
    ----------
    expr : expression, column matrix of n entries, or matrix of shape (m, n)
        Of sums, products, whole powers, square roots, sines and cosines, and pi.
    *vectors : sequences of symbols, e.g. ``POSE``

    Returns
    -------
    f : callable
        ``f(box)`` takes lower and upper ends, (..., len(vector), 2), and gives lower and upper bounds of
        ``expr`` over the box, two arrays of shape (...), (..., n) or (..., m, n). At least one of the two is NaN
        where the formula may leave its domain, as by a division by zero. Raises InputError for ends that are not
        numbers, or reversed.

    Raises InputError for functions that have no interval form here. A symbol that occurs twice is taken twice, so
    the bounds are wider than need be, and get tight as boxes get small. Enclose a matrix first, and then its
    determinant in symbols for its entries: that is both faster and tighter than the expanded determinant.

    >>> x = sp.Symbol("x", real=True)
    >>> lower, upper = enclose(x**2 - x, (x,))([[0, 0.5]])
    >>> float(lower.round(9)), float(upper.round(9))
    (-0.5, 0.25)
    """
    read_vectors, matrix, shape = read(expr, vectors)
    symbols = [symbol for vector in read_vectors for symbol in vector]
    steps, results = sp.cse(list(matrix), order="canonical")
    _check([entry for _, entry in steps] + list(results))

    def f(*boxes: ArrayLike) -> Interval:
        if len(boxes) != len(read_vectors):
            raise InputError(f"One box for each of {len(read_vectors)} vectors is expected, not {len(boxes)}.")
        given = [_box(box, vector) for box, vector in zip(boxes, read_vectors, strict=True)]
        batch = np.broadcast_shapes(*(box.shape[:-2] for box in given))
        ends = [end for box in given for end in np.moveaxis(box, (-2, -1), (0, 1))]
        known: dict[sp.Basic, Interval] = dict(zip(symbols, map(tuple, ends), strict=True))
        with np.errstate(all="ignore"):
            for symbol, entry in steps:
                known[symbol] = _of(entry, known)
            values = [_of(entry, known) for entry in results]
        bounds = np.empty((2, prod(batch), len(values)))
        for i, value in enumerate(values):
            for side in (0, 1):
                bounds[side, :, i] = np.broadcast_to(value[side], batch).reshape(-1)
        lower, upper = bounds.reshape(2, *batch, *shape)
        return lower, upper

    return f


def _box(box: ArrayLike, symbols: tuple[sp.Symbol, ...]) -> np.ndarray:
    ends = reading.real(box, f"a box of {reading.named(symbols)}", len(symbols), 2)
    if (ends[..., 0] > ends[..., 1]).any():
        raise InputError(f"A box of {reading.named(symbols)} has a lower end above its upper one.")
    return ends


def _check(entries: list[sp.Expr]) -> None:
    """Raise InputError where an entry holds what ``_of`` does not know."""
    for node in (node for entry in entries for node in sp.preorder_traversal(entry)):
        power = isinstance(node, sp.Pow) and (node.exp.is_Integer or node.exp in (sp.S.Half, -sp.S.Half))
        known = node.is_Symbol or (node.is_Number and node.is_finite) or node == sp.pi
        if not (known or power or isinstance(node, sp.Add | sp.Mul | sp.sin | sp.cos)):
            raise InputError(
                f"{node} cannot be enclosed: sums, products, whole powers, roots, sines and cosines can."
            )


def _of(entry: sp.Expr, known: dict[sp.Basic, Interval]) -> Interval:
    """The interval of an expression, from those of its symbols."""
    if entry in known:
        return known[entry]
    if not entry.args:
        return _constant(entry)
    if isinstance(entry, sp.Pow):
        base = _of(entry.base, known)
        whole = entry.exp if entry.exp.is_Integer else 2 * entry.exp
        power = _power(base if entry.exp.is_Integer else _root(base), abs(int(whole)))
        return _reciprocal(power) if whole < 0 else power
    if isinstance(entry, sp.sin | sp.cos):
        return _wave(_of(entry.args[0], known), np.pi / 2 if isinstance(entry, sp.sin) else 0.0)
    combine = _sum if isinstance(entry, sp.Add) else _product
    first, *others = (_of(part, known) for part in entry.args)
    for other in others:
        first = combine(first, other)
    return first


def _outwards(lower: np.ndarray, upper: np.ndarray) -> Interval:
    return np.nextafter(lower, -np.inf), np.nextafter(upper, np.inf)


def _constant(number: sp.Expr) -> Interval:
    value = np.array(float(number))
    return (value, value) if number.is_Integer and abs(number) <= EXACT else _outwards(value, value)


def _sum(a: Interval, b: Interval) -> Interval:
    return _outwards(a[0] + b[0], a[1] + b[1])


def _product(a: Interval, b: Interval) -> Interval:
    ends = np.array(np.broadcast_arrays(a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]))
    return _outwards(ends.min(axis=0), ends.max(axis=0))


def _power(a: Interval, n: int) -> Interval:
    """The n-th power, n >= 1; an even one is not negative."""
    if n == 1:
        return a
    if n % 2:
        return _product(a, _power(a, n - 1))
    low, high = _power(a, n // 2)
    nearest = np.where((low <= 0) & (high >= 0), 0.0, np.minimum(np.abs(low), np.abs(high)))
    farthest = np.maximum(np.abs(low), np.abs(high))
    lower, upper = _outwards(nearest * nearest, farthest * farthest)
    return np.maximum(lower, 0.0), upper


def _root(a: Interval) -> Interval:
    inside = np.where(a[0] >= 0, a, np.nan)
    lower, upper = _outwards(np.sqrt(inside[0]), np.sqrt(inside[1]))
    return np.maximum(lower, 0.0), upper


def _reciprocal(a: Interval) -> Interval:
    without_zero = np.where((a[0] <= 0) & (a[1] >= 0), np.nan, a)
    return _outwards(1 / without_zero[1], 1 / without_zero[0])


def _wave(a: Interval, crest: float) -> Interval:
    """The cosine of a - crest: 1 if the interval holds a crest, -1 if it holds a trough, else by its ends."""
    slack = 4 * EPS * (1 + np.maximum(np.abs(a[0]), np.abs(a[1])))  # of NumPy's functions, and of the crests
    first, last = (np.sin(end) if crest else np.cos(end) for end in a)

    def holds(place: float) -> np.ndarray:
        turns = (a[0] - slack - place) / (2 * np.pi), (a[1] + slack - place) / (2 * np.pi)
        return np.isfinite(first + last) & (np.ceil(turns[0]) <= np.floor(turns[1]))

    lower = np.where(holds(crest + np.pi), -1.0, np.maximum(np.minimum(first, last) - slack, -1.0))
    upper = np.where(holds(crest), 1.0, np.minimum(np.maximum(first, last) + slack, 1.0))
    return lower, upper
