"""The course's symbols, each made once, and the one door from SymPy to NumPy.

Symbols and numbers never share a name: ``theta_2`` and ``L_1`` are symbols, ``q`` and
``geometry`` are arrays and records of numbers.
"""

from collections.abc import Callable, Sequence
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
    expr : expression, column matrix of n entries, or matrix of shape (m, n)
    *vectors : sequences of symbols, e.g. the joint angles ``Q`` and the lengths ``P``

    Returns
    -------
    f : callable
        ``f(q, p)`` takes real arrays of shape (..., len(Q)) and (..., len(P)), whose leading axes
        broadcast as in NumPy, and returns float64 of shape (...), (..., n) or (..., m, n). Where an
        input is NaN or infinite, the whole entry of the batch is NaN. Raises InputError for complex
        input and for a last axis of another length.
    """
    vectors = tuple(map(tuple, vectors))
    matrix = expr if isinstance(expr, sp.MatrixBase) else sp.Matrix([expr])
    shape = () if matrix is not expr else matrix.shape[: 1 if matrix.shape[1] == 1 else 2]
    entries = tuple(matrix)
    if missing := matrix.free_symbols.difference(*vectors):
        names = ", ".join(sorted(map(str, missing)))
        raise InputError(f"The expression also holds {names}, which none of the vectors of symbols lists.")

    def f(*arrays: np.ndarray) -> np.ndarray:
        arrays = [real(x, symbols) for x, symbols in zip(arrays, vectors, strict=True)]
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


@cache
def _compiled(entries: tuple[sp.Expr, ...], vectors: tuple[tuple[sp.Symbol, ...], ...]) -> Callable:
    return sp.lambdify(vectors, list(entries), modules="numpy", cse=True)


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
    return f"({', '.join(map(str, symbols))})" if len(symbols) > 1 else str(symbols[0])


def _fill(out: np.ndarray, function: Callable, arrays: list[np.ndarray]) -> None:
    """Write ``function`` of ``arrays``, of shape (n,) or (samples, n), into ``out``, (samples, entries)."""
    columns = [np.ascontiguousarray(x.T) for x in arrays]
    values = np.empty(out.shape[::-1])
    with np.errstate(invalid="ignore"):  # outside a function's domain is NaN here, without a warning
        for row, value in zip(values, function(*columns), strict=True):
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
    expanded = sp.expand(expr)
    without_squared_sines = sp.expand(TR5(expanded))
    ways = [expanded] if without_squared_sines == expanded else [expanded, without_squared_sines]
    return sp.factor_terms(min(map(TR10i, ways), key=sp.count_ops))
