"""The course's symbols, each made once, and the one door from SymPy to NumPy.

Symbols and numbers never share a name: ``theta_2`` and ``L_1`` are symbols, ``q`` and
``geometry`` are arrays and records of numbers.
"""

from collections.abc import Callable, Iterable, Sequence
from functools import cache
from math import prod

import numpy as np
import sympy as sp
from sympy.simplify.fu import TR5, TR10i

from . import reading
from .errors import InputError

# The five joint angles and the four lengths of the Lynxmotion arm; report Tables 1.2 and 1.3.
Q = sp.symbols("theta_1:6", real=True)
P = sp.symbols("d_1 L_1:4", nonnegative=True)

# What the five joints of the arm set: azimuth of its plane, signed distance from the base axis, height,
# pitch and roll of the gripper; and the wrist in that plane, seen from the shoulder.
TASK = sp.symbols("azimuth r z pitch roll", real=True)
WRIST = sp.symbols("r_wrist h", real=True)

ANGLES = {*Q, TASK[0], TASK[3], TASK[4]}

# One row of a DH table, in general; report eq. (1.1).
ROW = sp.symbols("a alpha d theta", real=True)

# Pose of the 3-RRR's platform, and the robot's design parameters; report Tables 2.1 to 2.3. The angles beta
# are those of the base joints about the origin, gamma those of the platform's joints about its centre.
POSE = sp.symbols("X_c Y_c alpha", real=True)
DESIGN = (
    *sp.symbols("S_A L r_platform r_base", positive=True),
    *sp.symbols("beta_1:4", real=True),
    *sp.symbols("gamma_1:4", real=True),
)

# Samples worked through at a time, so that intermediate results stay in the processor's cache; more where an
# expression has few entries.
CHUNK, ENTRIES = 2048, 16


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
    vectors, matrix = _vectors(vectors), _real_valued(reading.formulas(expr))
    one = np.isscalar(expr) or (isinstance(expr, sp.Expr) and not expr.is_Matrix)
    shape = () if one else matrix.shape[: 1 if matrix.shape[1] == 1 else 2]
    entries = tuple(matrix)
    if missing := matrix.free_symbols.difference(*vectors):
        names = ", ".join(sorted(map(str, missing)))
        raise InputError(f"The expression also holds {names}, which none of the vectors of symbols lists.")
    turning = [[i for i, symbol in enumerate(vector) if symbol in ANGLES] for vector in vectors]

    def f(*arrays: np.ndarray) -> np.ndarray:
        if len(arrays) != len(vectors):
            wanted = " and ".join(map(_named, vectors)) or "none"
            raise InputError(f"One array for each of {wanted} is expected; the number given is {len(arrays)}.")
        arrays = [real(x, symbols) for x, symbols in zip(arrays, vectors, strict=True)]
        for x, symbols, angular in zip(arrays, vectors, turning, strict=True):
            if angular:
                reading.warn_of_degrees(x[..., angular] if len(angular) < len(symbols) else x, _named(symbols))
        batch = np.broadcast_shapes(*(x.shape[:-1] for x in arrays))
        size = prod(batch)
        flat = [x if x.ndim == 1 else _flat(x, batch, size) for x in arrays]
        out = np.empty((size, len(entries)))
        chunk = CHUNK * max(1, ENTRIES // len(entries))
        for start in range(0, size, chunk):
            part = slice(start, start + chunk)
            _fill(out[part], _compiled(entries, vectors), [x if x.ndim == 1 else x[part] for x in flat])
        return out.reshape(batch + shape)

    return f


def _vectors(vectors: Sequence[Sequence[sp.Symbol]]) -> tuple[tuple[sp.Symbol, ...], ...]:
    """Vectors of symbols as tuples; InputError where one is none, or a symbol stands in two places."""
    for vector in vectors:
        if isinstance(vector, str) or not isinstance(vector, Iterable):
            raise InputError(f"Vectors of symbols, such as (x,), are expected, not {reading.shortened(vector)}.")
    vectors = tuple(map(tuple, vectors))
    symbols = [symbol for vector in vectors for symbol in vector]
    for symbol in symbols:
        if not isinstance(symbol, sp.Symbol):
            raise InputError(f"Vectors of symbols are expected; one of them holds {reading.shortened(symbol)}.")
        if symbols.count(symbol) > 1:
            raise InputError(f"The symbol {symbol} is listed twice.")
    return vectors


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
def _compiled(entries: tuple[sp.Expr, ...], vectors: tuple[tuple[sp.Symbol, ...], ...]) -> Callable:
    try:
        return sp.lambdify(vectors, list(entries), modules="numpy", cse=True)
    except NotImplementedError as fault:
        raise InputError(f"The expression has no NumPy function: {str(fault).partition(chr(10))[0]}.") from None


def real(x: np.ndarray, symbols: tuple[sp.Symbol, ...]) -> np.ndarray:
    """``x`` as float64; InputError where it is not real or its last axis does not match ``symbols``."""
    x = reading.real(x, _named(symbols))
    if x.ndim == 0 or x.shape[-1] != len(symbols):
        raise InputError(
            f"The last axis must hold the {len(symbols)} values {_named(symbols)}; the shape given is {x.shape}."
        )
    return x


def _flat(x: np.ndarray, batch: tuple[int, ...], size: int) -> np.ndarray:
    return np.broadcast_to(x, (*batch, x.shape[-1])).reshape(size, x.shape[-1])


@cache
def _named(symbols: tuple[sp.Symbol, ...]) -> str:
    return f"({', '.join(map(str, symbols))})" if len(symbols) != 1 else str(symbols[0])


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


def tidy(expr: sp.Expr | sp.MatrixBase) -> sp.Expr | sp.MatrixBase:
    """``expr``, or each entry of it, with sums of angles joined and common factors taken out.

    Made for products of link transforms, where it takes hundredths of a second and ``simplify``
    takes seconds: cos(a) cos(b) - sin(a) sin(b) becomes cos(a + b), and sin(a)**2 + cos(a)**2 becomes 1.
    """
    if isinstance(expr, sp.MatrixBase):
        return expr.applyfunc(tidy)
    (expr,) = reading.formulas(expr)
    expanded = sp.expand(expr)
    without_squared_sines = sp.expand(TR5(expanded))
    ways = [expanded] if without_squared_sines == expanded else [expanded, without_squared_sines]
    return sp.factor_terms(min(map(TR10i, ways), key=sp.count_ops))
