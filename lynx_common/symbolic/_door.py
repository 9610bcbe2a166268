"""The one door from SymPy to NumPy."""

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from functools import cache, partial, wraps
from math import isfinite, prod
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.pycode import PythonCodePrinter

from .. import reading
from ..errors import InputError
from ._symbols import ANGLES

# Samples worked through at a time, so that intermediate results stay in the processor's cache; more where an
# expression has few entries.
CHUNK, ENTRIES = 2048, 16


class _Numpy(NumPyPrinter):
    """SymPy's printer, but for a choice of two, which takes ``select`` half as long again as ``where``."""

    def _print_Piecewise(self, expr: sp.Piecewise) -> str:
        if len(expr.args) != 2 or expr.args[1][1] != sp.true:
            return super()._print_Piecewise(expr)
        (first, condition), (other, _) = expr.args
        return f"where({self._print(condition)}, {self._print(first)}, {self._print(other)})"


SETTINGS = {"fully_qualified_modules": False, "inline": True, "allow_unknown_functions": True}
PRINTERS = {"numpy": _Numpy(SETTINGS), "math": PythonCodePrinter(SETTINGS)}


def numeric(expr: sp.Expr | sp.MatrixBase, *vectors: Sequence[sp.Symbol]) -> Callable[..., np.ndarray]:
    """Compile ``expr`` into a function of one array per vector of symbols, which broadcasts over batches.

    Plain ``sp.lambdify`` of a matrix fails on a batch as soon as one entry is a constant, such
    as the bottom row of a transform; here every entry is broadcast to the batch. Compiled at
    the first call, and once for the same expression.

    Parameters
    ----------
    expr : expression, column matrix of n entries, or matrix of shape (m, n); lists of these will do
    *vectors : sequences of symbols, e.g. the joint angles ``Q`` and the lengths ``P``

    Returns
    -------
    f : callable
        ``f(q, p)`` takes real arrays of shape (..., len(Q)) and (..., len(P)), whose leading axes
        broadcast as in NumPy, and returns float64 of shape (...), (..., n) or (..., m, n). Where an
        input is NaN or infinite, the whole entry of the batch is NaN; so is a value outside a function's
        domain. Raises InputError for complex input, a last axis of another length, and another number of arrays.

    Raises InputError for an expression that is complex, is text, or holds symbols that no vector lists.

    >>> x = sp.Symbol("x", real=True)
    >>> numeric(x**2, (x,))([[1.0], [3.0]])
    array([1., 9.])
    """
    read_vectors, matrix, shape = read(expr, vectors)
    entries, angular = tuple(matrix), tuple(map(_angular, read_vectors))
    # Hashing the entries takes longer than the work.
    compiled_with = cache(partial(_compiled, entries, read_vectors))

    def f(*arrays: ArrayLike) -> np.ndarray:
        if (sample := _sample(arrays, read_vectors, angular)) is not None:
            with suppress(ArithmeticError, ValueError, TypeError, NameError, AttributeError):  # NumPy will know
                return np.array(compiled_with("math")(*sample), float).reshape(shape)
        return _of_batch(arrays, read_vectors, angular, compiled_with("numpy"), (len(entries), shape))

    return f


def read(expr: Any, vectors: Sequence[Sequence[sp.Symbol]]) -> tuple[tuple, sp.MatrixBase, tuple[int, ...]]:
    """The vectors as tuples, ``expr`` as a real matrix, and its shape: (), (n,) or (m, n); or InputError."""
    read_vectors, matrix = _vectors(vectors), _real_valued(reading.formulas(expr))
    if missing := matrix.free_symbols.difference(*read_vectors):
        names = ", ".join(sorted(map(str, missing)))
        raise InputError(f"The expression also holds {names}, which none of the vectors of symbols lists.")
    one = np.isscalar(expr) or (isinstance(expr, sp.Expr) and not expr.is_Matrix)
    return read_vectors, matrix, () if one else matrix.shape[: 1 if matrix.shape[1] == 1 else 2]


def _sample(arrays: tuple, vectors: tuple, angular: tuple) -> list | None:
    """The arrays as tuples of floats, if they are one sample that needs no second look; else None."""
    if len(arrays) != len(vectors):
        return None
    sample = []
    for x, symbols, turning in zip(arrays, vectors, angular, strict=True):
        if type(x) is np.ndarray and x.dtype == float and x.ndim == 1:
            x = x.tolist()
        elif isinstance(x, reading.Record):
            x = x.values
        elif type(x) not in (list, tuple) or not all(type(value) in (float, int) for value in x):
            return None
        if len(x) != len(symbols) or not isfinite(sum(x)):
            return None
        indices, most, _ = turning
        if indices and max([abs(x[i]) for i in indices]) > most:
            return None
        sample.append(x)
    return sample


def _of_batch(arrays: tuple, vectors: tuple, angular: tuple, function: Callable, out: tuple) -> np.ndarray:
    """The values for a batch of any shape, worked through in chunks; ``out`` is their number and their shape."""
    entries, shape = out
    if len(arrays) != len(vectors):
        wanted = " and ".join(map(reading.named, vectors)) or "none"
        raise InputError(f"One array for each of {wanted} is expected; the number given is {len(arrays)}.")
    given = [np.array(x.values) if isinstance(x, reading.Record) else x for x in arrays]
    read = [reading.batch(x, symbols) for x, symbols in zip(given, vectors, strict=True)]
    for x, (indices, most, names) in zip(read, angular, strict=True):
        if indices:
            angles = x[..., indices] if len(indices) < x.shape[-1] else x
            reading.warn_of_degrees(angles, names, most)
    batch = np.broadcast_shapes(*(x.shape[:-1] for x in read))
    size = prod(batch)
    flat = [x if x.ndim == 1 else _flat(x, batch, size) for x in read]
    values = np.empty((size, entries))
    chunk = CHUNK * max(1, ENTRIES // entries)
    for start in range(0, size, chunk):
        part = slice(start, start + chunk)
        _fill(values[part], function, [x if x.ndim == 1 else x[part] for x in flat])
    return values.reshape(batch + shape)


def _angular(symbols: tuple[sp.Symbol, ...]) -> tuple[tuple[int, ...], float, str]:
    """Which of the symbols are angles, from where on these are hardly meant in radians, and their names."""
    indices = tuple(i for i, symbol in enumerate(symbols) if symbol in ANGLES)
    angles = tuple(symbols[i] for i in indices)
    return indices, min((ANGLES[angle] for angle in angles), default=0.0), reading.named(angles)


def compiled(*vectors: Sequence[sp.Symbol]) -> Callable[[Callable[[], sp.MatrixBase]], Callable[..., np.ndarray]]:
    """Turn a function that returns a formula into the function of numbers that ``numeric`` makes of it.

    The formula is made at the first call, and kept as ``formula`` of the result.

    >>> x = sp.Symbol("x", real=True)
    >>> @compiled((x,))
    ... def square():
    ...     return x**2
    >>> square([3.0])
    array(9.)
    """

    def decorate(formula: Callable[[], sp.MatrixBase]) -> Callable[..., np.ndarray]:
        once = cache(formula)
        made = cache(lambda: numeric(once(), *vectors))

        @wraps(formula)
        def function(*arrays: ArrayLike) -> np.ndarray:
            return made()(*arrays)

        function.formula = once  # type: ignore[attr-defined]
        return function

    return decorate


def _vectors(vectors: Sequence[Sequence[sp.Symbol]]) -> tuple[tuple[sp.Symbol, ...], ...]:
    """Vectors of symbols as tuples; InputError where one is none, or a symbol stands in two places."""
    for vector in vectors:
        if isinstance(vector, str) or not isinstance(vector, Iterable):
            raise InputError(f"Vectors of symbols, such as (x,), are expected, not {reading.shortened(vector)}.")
    as_tuples = tuple(map(tuple, vectors))
    symbols = [symbol for vector in as_tuples for symbol in vector]
    for symbol in symbols:
        if not isinstance(symbol, sp.Symbol):
            raise InputError(f"Vectors of symbols are expected; one of them holds {reading.shortened(symbol)}.")
        if symbols.count(symbol) > 1:
            raise InputError(f"The symbol {symbol} is listed twice.")
    return as_tuples


def _real_valued(matrix: sp.MatrixBase) -> sp.MatrixBase:
    """``matrix`` without the imaginary unit, for real symbols; InputError where it does not go away."""
    if not matrix.has(sp.I):
        return matrix
    as_real = {symbol: sp.Dummy(symbol.name, real=True) for symbol in matrix.free_symbols}
    expanded = matrix.xreplace(as_real).applyfunc(lambda entry: sp.simplify(entry.expand(complex=True)))
    if complex_ones := [entry for entry, found in zip(matrix, expanded, strict=True) if found.has(sp.I)]:
        raise InputError(f"The expression is complex: {complex_ones[0]}. Only real ones become functions.")
    return expanded.xreplace({dummy: symbol for symbol, dummy in as_real.items()})


@cache
def _compiled(entries: tuple[sp.Expr, ...], vectors: tuple[tuple[sp.Symbol, ...], ...], modules: str) -> Callable:
    """Compiled with ``math`` for one sample, which is ten times faster there, or with NumPy for batches."""
    try:
        return sp.lambdify(vectors, list(entries), modules=modules, cse=True, printer=PRINTERS[modules])
    except NotImplementedError as fault:
        raise InputError(f"The expression has no NumPy function: {str(fault).partition(chr(10))[0]}.") from None


def _flat(x: np.ndarray, batch: tuple[int, ...], size: int) -> np.ndarray:
    return np.broadcast_to(x, (*batch, x.shape[-1])).reshape(size, x.shape[-1])


def _fill(out: np.ndarray, function: Callable, arrays: list[np.ndarray]) -> None:
    """Write ``function`` of ``arrays``, of shape (n,) or (samples, n), into ``out``, (samples, entries)."""
    columns = [np.ascontiguousarray(x.T) for x in arrays]
    values = np.empty(out.shape[::-1])
    with np.errstate(invalid="ignore"):  # outside a function's domain is NaN here, without a warning
        try:
            computed = function(*columns)
        except (NameError, TypeError, AttributeError) as fault:
            raise InputError(f"The expression has no NumPy function: {fault}.") from None
        for row, value in zip(values, computed, strict=True):
            if np.iscomplexobj(value):
                raise InputError("The expression is complex, such as a root of a negative number is.")
            row[:] = value
    for x in columns:
        finite = np.isfinite(x)
        if not finite.all():
            values[:, ~finite.all(axis=0)] = np.nan
    out[:] = values.T
