"""Numbers and arrays of numbers."""

from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from ..errors import InputError
from ._records import Record

NO_NUMBERS = str, bytes, bool, np.bool_, type(None)  # though float() reads them


def real(x: ArrayLike, name: str, *shape: int | None) -> np.ndarray:
    """``x`` as float64 whose last axes have ``shape``, None being any length; InputError where they have not.

    SymPy's numbers are read too. Complex numbers, truth values, words, None and what is masked are refused.

    >>> real([sp.Rational(1, 2), 3], "lengths")
    array([0.5, 3. ])
    """
    if isinstance(x, Record):
        raise InputError(f"Numbers are expected for {name}, not {x}; it is given as geometry=...")
    if not isinstance(x, np.ndarray) or x.dtype != float or isinstance(x, np.ma.MaskedArray):
        x = _as_float(x, name)
    tail = x.shape[x.ndim - len(shape) :] if x.ndim >= len(shape) else ()
    if len(tail) != len(shape) or any(want not in (None, have) for have, want in zip(tail, shape, strict=True)):
        raise InputError(f"The last axes of {name} must be {_spelled(shape)}; the shape given is {x.shape}.")
    return x


def batch(x: ArrayLike, symbols: Sequence[sp.Symbol]) -> np.ndarray:
    """``x`` as float64, (..., n): one value a symbol on its last axis; InputError otherwise.

    >>> batch([[1, 2], [3, 4]], sp.symbols("x y")).shape
    (2, 2)
    """
    if type(x) is np.ndarray and x.dtype == float and x.ndim and x.shape[-1] == len(symbols):
        return x  # as mostly; to find the names would take longer than all the rest
    names = named(tuple(symbols))
    x = real(x, names)
    if x.ndim == 0 or x.shape[-1] != len(symbols):
        wanted = f"the {len(symbols)} values {names}"
        raise InputError(f"The last axis must hold {wanted}; the shape given is {x.shape}.")
    return x


def finite(x: ArrayLike, name: str, *shape: int | None) -> np.ndarray:
    """``x`` as float64 of exactly this shape, None being any length, all of it finite; InputError otherwise.

    >>> finite([1, 2, np.nan], "a position", 3)
    Traceback (most recent call last):
    lynx_common.errors.InputError: Finite numbers are expected for a position; [1.0, 2.0, nan] was given.
    """
    array = real(x, name)
    if array.ndim != len(shape) or any(want not in (None, n) for n, want in zip(array.shape, shape, strict=True)):
        given = shortened(x) if array.ndim < 2 else f"an array of shape {array.shape}"
        raise InputError(f"Finite numbers of shape {_spelled(shape)} are expected for {name}; {given} was given.")
    if not np.isfinite(array).all():
        row = int(np.argwhere(~np.isfinite(array))[0, 0]) if array.ndim > 1 else None
        given = shortened(array if row is None else array[row])
        where = "" if row is None else f" in row {row}"
        raise InputError(f"Finite numbers are expected for {name}; {given} was given{where}.")
    return array


def number(
    x: Any, name: str, *, above: float | None = None, least: float | None = None, most: float | None = None
) -> float:
    """``x`` as one finite float within the bounds that are given; InputError otherwise.

    >>> number(sp.Rational(1, 2), "step", above=0)
    0.5
    """
    value = real(x, f"the {name}")
    bounds = ((above, "above {:g}"), (least, "not below {:g}"), (most, "not above {:g}"))
    allowed = " and ".join(text.format(bound) for bound, text in bounds if bound is not None)
    if (
        value.shape
        or not np.isfinite(value)
        or (above is not None and value <= above)
        or (least is not None and value < least)
        or (most is not None and value > most)
    ):
        raise InputError(f"The {name} is one finite number{allowed and ', '}{allowed}; {shortened(x)} was given.")
    return float(value)


def whole(x: Any, name: str, least: int, most: int) -> int:
    """``x`` as a whole number from ``least`` to ``most``; InputError otherwise.

    >>> whole(2.5, "branch", 0, 3)
    Traceback (most recent call last):
    lynx_common.errors.InputError: The branch is a whole number from 0 to 3; 2.5 was given.
    """
    if isinstance(x, bool) or not isinstance(x, int | np.integer) or not least <= x <= most:
        raise InputError(f"The {name} is a whole number from {least} to {most}; {shortened(x)} was given.")
    return int(x)


def _as_float(x: Any, name: str) -> np.ndarray:
    if np.ma.is_masked(x):
        raise InputError(f"Real numbers are expected for {name}; some of those given are masked.")
    try:
        array = np.asarray(x)
    except ValueError:
        raise InputError(f"Real numbers are expected for {name}; rows of different lengths were given.") from None
    if np.iscomplexobj(array):
        raise InputError(f"Real numbers are expected for {name}; complex ones were given.")
    try:
        if array.dtype == bool or any(isinstance(one, NO_NUMBERS) for one in _objects(array)):
            raise TypeError
        return array.astype(float, casting="unsafe" if array.dtype == object else "same_kind")
    except (TypeError, ValueError):
        raise InputError(f"Real numbers are expected for {name}; {shortened(x)} was given.") from None


def _objects(array: np.ndarray) -> Iterator[object]:
    return iter(array.flat if array.dtype == object else ())


def _spelled(shape: Sequence[int | None]) -> str:
    letters = iter("nmk")  # of the axes of any length
    names = [next(letters) if length is None else str(length) for length in shape]
    return f"({', '.join(names)}{',' * (len(names) == 1)})"


@cache
def named(symbols: tuple[sp.Symbol, ...]) -> str:
    """Symbols as they stand in a sentence: (x, y), or x alone.

    >>> named(sp.symbols("x y"))
    '(x, y)'
    """
    return f"({', '.join(map(str, symbols))})" if len(symbols) != 1 else str(symbols[0])


def shortened(x: Any) -> str:
    """``x`` as text that fits into a sentence.

    >>> shortened(np.arange(3))
    '[0, 1, 2]'
    """
    text = repr(x.tolist() if isinstance(x, np.ndarray) and x.size < 100 else x)
    return " ".join((text if len(text) <= 80 else f"{text[:77]}...").split())
