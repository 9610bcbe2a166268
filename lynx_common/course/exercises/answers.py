"""Reading an answer: whatever is given becomes an array of floats, or a sentence that says what was given instead.

Text is never evaluated, what is too large is not worked through, and an object may raise what it likes. Formulas
are evaluated in complex numbers, so that real ones that hold I are read as well.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import reduce
from itertools import islice
from math import prod
from numbers import Number
from operator import add, mul
from typing import Any

import numpy as np
import sympy as sp
from sympy.functions.elementary.piecewise import ExprCondPair

ENTRIES, LEVELS, PARTS = 40, 3, 1000  # at most: numbers in a list, lists within lists, parts of a formula
DUST = 1e-12  # an imaginary part so small, beside the number, is rounding

# What is given by mistake, by its type; the first that fits.
KINDS = {
    str | bytes: "text",
    dict: "a dict",
    set | frozenset: "a set, which has no order,",
    bool | np.bool_: "True or False",
    type(...): "a list with dots in it",
    type(None): "None",
    Iterator: "a generator",
    sp.MatrixExpr: "a SymPy matrix that is not written out",
    sp.Basic: "an equation, or another object of SymPy that is no formula,",
    type: "a class, or a function without its argument,",
    Callable: "a function",
}


class UnreadableAnswerError(Exception):
    """An answer of the wrong kind or shape; holds the sentence that says so."""


@dataclass(frozen=True)
class Form:
    """What an answer looks like: how many entries and, for formulas, samples of each symbol, known by its name.

    >>> Form((2,)).read(sp.Matrix([1, sp.pi]))
    array([1.        , 3.14159265])
    """

    shape: tuple[int, ...]
    samples: Mapping[str, np.ndarray] = field(default_factory=dict)
    yes_no: bool = False  # True and False are read, as 1 and 0

    def read(self, answer: object) -> np.ndarray:
        """``answer`` as floats of this shape; of formulas, as (samples, n). Raises UnreadableAnswerError."""
        try:
            entries, shape = _laid_out(answer)
            if len(entries) > ENTRIES:
                raise _Fault(f"{len(entries):,} of them were given")
            if self.yes_no:
                entries = [int(entry) if isinstance(entry, bool | np.bool_) else entry for entry in entries]
            with np.errstate(all="ignore"):
                values = [_value(entry, self.samples) for entry in entries]
                return self._real(self._arranged(values, shape))
        except _Fault as fault:
            given = str(fault)
        except Exception:  # what is given may be any object, and raise anything
            given = "what was given cannot be read"
        raise UnreadableAnswerError(f"{self.wanted}; {given}.")

    @property
    def wanted(self) -> str:
        if self.samples:
            return f"{self.shape[0]} formulas in {', '.join(self.samples)} are expected, as a list"
        return f"{self._counted(self.shape)} {'are' if self.shape else 'is'} expected"

    def _counted(self, shape: tuple[int, ...]) -> str:
        what = "formula" if self.samples else "number"
        return "".join(f"{n} rows of " for n in shape[:-1]) + (f"{shape[-1]} {what}s" if shape else f"one {what}")

    def _arranged(self, values: list[np.ndarray], shape: tuple[int, ...]) -> list[np.ndarray]:
        """The values asked for: of a point, also from [x, y, z, 1] and from the pose of a frame."""
        own = tuple(n for n in shape if n != 1)
        if own == self.shape:
            return values
        if self.shape == (3,) and own == (4,) and np.all(values[3] == 1):
            return values[:3]
        if self.shape == (3,) and own == (4, 4) and np.all(_stacked(values[12:]) == [0, 0, 0, 1]):
            return values[3:12:4]
        raise _Fault(f"{self._counted(own)} {'were' if own else 'was'} given")

    def _real(self, values: list[np.ndarray]) -> np.ndarray:
        value = _stacked(values)
        if self.samples:
            value = np.broadcast_to(value, (len(next(iter(self.samples.values()))), *self.shape))
        if not (np.isfinite(value).all() and (np.abs(value.imag) <= 1e-6 * (1 + np.abs(value.real))).all()):
            where = " for some values of its symbols" if self.samples else ""
            raise _Fault(f"an entry is not a real, finite number{where}")
        return value.real.reshape(value.shape if self.samples else self.shape)


class _Fault(Exception):
    """What is wrong with what was given; holds a clause of a sentence."""


def _laid_out(x: object, level: int = 0) -> tuple[list, tuple[int, ...]]:
    """The entries of nested lists, arrays and matrices in one list, and the shape that they had."""
    if np.ma.isMaskedArray(x) and np.ma.is_masked(x):
        raise _Fault("some entries of what was given are masked")
    if isinstance(x, sp.MatrixBase | sp.NDimArray | np.ndarray):
        if prod(x.shape) > ENTRIES:
            raise _Fault(f"{prod(x.shape):,} of them were given")
        x = x.tolist()
    elif hasattr(x, "__array__") and not isinstance(x, type | np.generic | sp.MatrixExpr):
        return _laid_out(np.asarray(x), level)
    if not isinstance(x, list | tuple | range | sp.Tuple):
        return [x], ()
    if len(x) > ENTRIES:
        raise _Fault(f"{len(x):,} of them were given")
    if level == LEVELS or not len(x):
        raise _Fault("an empty list was given" if not len(x) else "lists within lists within lists were given")
    rows = [_laid_out(row, level + 1) for row in x]
    if len({shape for _, shape in rows}) > 1:
        raise _Fault("rows of different lengths were given")
    return [entry for row, _ in rows for entry in row], (len(x), *rows[0][1])


def _stacked(values: list[np.ndarray]) -> np.ndarray:
    return np.stack(np.broadcast_arrays(*values), axis=-1)


def _value(x: object, samples: Mapping[str, np.ndarray]) -> np.ndarray:
    """An entry as a complex number, or as one for each sample."""
    if isinstance(x, Number | sp.Expr) and not isinstance(x, bool | sp.MatrixExpr):
        formula = isinstance(x, sp.Expr)
        if formula and len(list(islice(sp.preorder_traversal(x), PARTS + 1))) > PARTS:
            raise _Fault(f"a formula with more than {PARTS} parts was given")
        return _evaluated(x, samples) if formula else _number(x)
    given = next((words for kind, words in KINDS.items() if isinstance(x, kind)), None)
    raise _Fault(f"{given or f'an object of type {type(x).__name__:.40}'} was given")


def _number(x: Any) -> np.ndarray:
    try:
        return np.array(complex(x))
    except OverflowError:
        return np.array(complex(np.inf))


def _evaluated(x: sp.Basic, samples: Mapping[str, np.ndarray]) -> np.ndarray:
    """The value of a formula; each number in it becomes a float first, so that nothing can grow."""
    if isinstance(x, sp.Symbol):
        if x.name not in samples:
            raise _Fault(f"what was given holds the symbol {x.name:.40}")
        return samples[x.name].astype(complex)
    if isinstance(x, sp.Number | sp.NumberSymbol):
        return _number(float(x))
    if x in CONSTANTS:
        return CONSTANTS[x]
    if x.func not in FUNCTIONS:
        raise _Fault(f"what was given holds {x.func.__name__:.40}, which is not read here")
    value = FUNCTIONS[x.func](*(_evaluated(part, samples) for part in x.args))
    if isinstance(value, tuple) or not np.iscomplexobj(value):
        return value
    return np.where(np.abs(value.imag) <= DUST * np.abs(value), value.real, value)


def _on_reals(function: Callable) -> Callable:
    """A function of real numbers as one of complex numbers: NaN where they are not real."""
    return lambda *z: function(*(np.where(part.imag == 0, part.real, np.nan) for part in z)) + 0j


def _comparison(function: Callable) -> Callable:
    return lambda a, b: function(a.real, b.real)


def _choice(*pairs: tuple[np.ndarray, np.ndarray]) -> np.ndarray:
    conditions = np.broadcast_arrays(*(np.asarray(condition, bool) for _, condition in pairs))
    return np.select(conditions, np.broadcast_arrays(*(value for value, _ in pairs)), np.nan)


CONSTANTS: dict[Any, Any] = {
    sp.I: np.complex128(1j),
    sp.zoo: np.complex128(np.nan),
    sp.true: np.True_,
    sp.false: np.False_,
}
FUNCTIONS: dict[Any, Callable] = {
    sp.Add: lambda *terms: reduce(add, terms),
    sp.Mul: lambda *factors: reduce(mul, factors),
    sp.Pow: np.power,
    sp.exp: np.exp,
    sp.log: np.log,
    sp.sin: np.sin,
    sp.cos: np.cos,
    sp.tan: np.tan,
    sp.cot: lambda z: 1 / np.tan(z),
    sp.asin: np.arcsin,
    sp.acos: np.arccos,
    sp.atan: np.arctan,
    sp.atan2: _on_reals(np.arctan2),
    sp.Max: _on_reals(lambda *x: reduce(np.maximum, x)),
    sp.Min: _on_reals(lambda *x: reduce(np.minimum, x)),
    sp.Mod: _on_reals(np.mod),
    sp.sign: _on_reals(np.sign),
    sp.Abs: lambda z: np.abs(z) + 0j,
    sp.re: lambda z: np.real(z) + 0j,
    sp.im: lambda z: np.imag(z) + 0j,
    sp.arg: lambda z: np.angle(z) + 0j,
    sp.conjugate: np.conj,
    sp.Gt: _comparison(np.greater),
    sp.Ge: _comparison(np.greater_equal),
    sp.Lt: _comparison(np.less),
    sp.Le: _comparison(np.less_equal),
    sp.Eq: _comparison(np.equal),
    sp.Ne: _comparison(np.not_equal),
    sp.And: lambda *conditions: reduce(np.logical_and, conditions),
    sp.Or: lambda *conditions: reduce(np.logical_or, conditions),
    sp.Not: np.logical_not,
    ExprCondPair: lambda value, condition: (value, condition),
    sp.Piecewise: _choice,
}
