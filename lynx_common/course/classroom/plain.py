"""Answers as plain data, on their way from the process that ran somebody's notebook to the one that judges them.

Numbers, lists, and formulas as trees of names; nothing is pickled, and no text is evaluated. What is neither
becomes the name of its type.
"""

from itertools import islice
from math import prod
from numbers import Number
from typing import Any

import numpy as np
import sympy as sp
from sympy.functions.elementary.piecewise import ExprCondPair

from ..exercises.answers import ENTRIES, FUNCTIONS, PARTS

BY_NAME = {function.__name__: function for function in FUNCTIONS}


class _Other(Exception):
    """What is no number, list or formula; holds what it is called."""


def encode(answer: object) -> Any:
    """``answer`` as JSON can hold it.

    >>> encode([1, sp.Symbol("x") / 2])
    [1.0, {'Mul': [0.5, {'Symbol': 'x'}]}]
    """
    try:
        return _plain(answer)
    except _Other as other:
        return {"other": str(other)[:80]}
    except Exception:  # an answer may be any object, and raise anything
        return {"other": type(answer).__name__[:80]}


def _plain(x: Any) -> Any:
    if x is None or x is ...:
        return None
    if isinstance(x, sp.MatrixBase | sp.NDimArray | np.ndarray) or hasattr(type(x), "__array__"):
        x = x if hasattr(x, "shape") else np.asarray(x)
        if prod(x.shape) > ENTRIES:
            raise _Other(f"array with {prod(x.shape):,} entries")
        x = x.tolist()
    if isinstance(x, list | tuple | range | sp.Tuple):
        return [_plain(entry) for entry in x[: ENTRIES + 1]]
    if isinstance(x, bool | np.bool_ | type(sp.true) | type(sp.false)):
        return bool(x)
    if isinstance(x, sp.Basic) and not isinstance(x, sp.Number):
        return _tree(x)
    if isinstance(x, Number | sp.Number):
        return _number(x)
    raise _Other(type(x).__name__)


def _number(x: Any) -> float | dict[str, list[float]]:
    try:
        z = complex(x)
    except OverflowError:
        z = complex(np.inf)
    return {"complex": [z.real, z.imag]} if z.imag else z.real


def _tree(x: sp.Basic) -> Any:
    if len(list(islice(sp.preorder_traversal(x), PARTS + 1))) > PARTS:
        raise _Other(f"formula with more than {PARTS} parts")
    if isinstance(x, sp.Symbol):
        return {"Symbol": x.name}
    if x is sp.zoo or x is sp.I or isinstance(x, sp.NumberSymbol):
        return float("nan") if x is sp.zoo else _number(x)
    if x.func not in FUNCTIONS:
        raise _Other(x.func.__name__)
    return {x.func.__name__: [_plain(part) for part in x.args]}


def decode(data: Any) -> object:
    """The answer that ``encode`` made ``data`` of."""
    if data is None:
        return ...
    if isinstance(data, list):
        return [decode(entry) for entry in data]
    if not isinstance(data, dict):
        return data
    ((name, given),) = data.items()
    if name == "other":
        return type(str(given), (), {})()
    if name == "Symbol":
        return sp.Symbol(given)
    if name == "complex":
        return complex(*given)
    made = BY_NAME[name]
    options = {} if made is ExprCondPair else {"evaluate": False}  # so that no number can grow
    return made(*map(decode, given), **options)
