"""The one reader of input: numbers, angles, limits, poses, formulas; or a sentence that says what is wrong.

Text is never taken for a number or a formula, and never evaluated.
"""

import sys
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import fields
from functools import cache
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from .errors import GeometryError, InputError, told_apart

# How far the rotation of a pose may be from orthogonal, and how far one may be that was rounded to few digits.
POSE_TOLERANCE, ROUNDED_POSE = 1e-6, 1e-2
TO_NEAREST = (
    " If it was rounded, the nearest rotation is U @ V, of U, _, V = np.linalg.svd(T[:3, :3]): "
    "put it in the place of T[:3, :3]."
)

NO_NUMBERS = str, bytes, bool, np.bool_, type(None)  # though float() reads them
TWO_TURNS = 4 * np.pi  # angles beyond are hardly meant in radians


class Record:
    """Base of the frozen records of a robot's parameters, which are checked once, when they are made.

    ``values`` holds them as floats, in the order in which the record unpacks; it is an array to NumPy.
    """

    values: tuple[float, ...]

    def __new__(cls, *_: object, **parameters: object) -> "Record":
        known = [field.name for field in fields(cls)]  # type: ignore[arg-type]  # of the dataclasses made of it
        for name in parameters.keys() - known:
            raise GeometryError(name, parameters[name], f"there are {', '.join(known)}")
        return super().__new__(cls)

    def __iter__(self) -> Iterator[float]:
        return iter(self.values)

    def __array__(self, dtype: type | None = None, copy: bool | None = None) -> np.ndarray:
        return np.array(self.values, dtype=dtype)


def length(name: str, value: Any, unit: str, zero: bool = False) -> float:
    """A length of a robot, longer than zero unless it may be ``zero``; GeometryError otherwise.

    >>> length("L_1", sp.Integer(2) / 10, "metres")
    Traceback (most recent call last):
    lynx_common.errors.GeometryError: Geometry: L_1 is 1/5; a length is a real number of metres.
    """
    if not isinstance(value, int | float | np.number) or isinstance(value, bool | np.complexfloating):
        raise GeometryError(name, value, f"a length is a real number of {unit}")
    if not (np.isfinite(value) and (value > 0 or (zero and value == 0))):
        raise GeometryError(
            name, value, f"a length is finite and {'not negative' if zero else 'longer than zero'}"
        )
    return float(value)


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
    x = real(x, named(tuple(symbols)))
    if x.ndim == 0 or x.shape[-1] != len(symbols):
        names = named(tuple(symbols))
        raise InputError(
            f"The last axis must hold the {len(symbols)} values {names}; the shape given is {x.shape}."
        )
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


def _spelled(shape: Sequence[int | None]) -> str:
    letters = iter("nmk")  # of the axes of any length
    names = [next(letters) if length is None else str(length) for length in shape]
    return f"({', '.join(names)}{',' * (len(names) == 1)})"


@cache
def named(symbols: tuple[sp.Symbol, ...]) -> str:
    """Symbols as they stand in a sentence: (x, y), or x alone."""
    return f"({', '.join(map(str, symbols))})" if len(symbols) != 1 else str(symbols[0])


def _objects(array: np.ndarray) -> Iterator[object]:
    return iter(array.flat if array.dtype == object else ())


def shortened(x: Any) -> str:
    """``x`` as text that fits into a sentence.

    >>> shortened(np.arange(3))
    '[0, 1, 2]'
    """
    text = repr(x.tolist() if isinstance(x, np.ndarray) and x.size < 100 else x)
    return " ".join((text if len(text) <= 80 else f"{text[:77]}...").split())


def warn_of_degrees(angles: np.ndarray, name: str, most: float = TWO_TURNS) -> None:
    """Warn where an angle is larger than ``most`` radians; the warning points to the line outside the package.

    >>> warn_of_degrees(np.array([3.0]), "theta")  # says nothing
    """
    if not angles.size or not max(np.fmax.reduce(angles, axis=None), -np.fmin.reduce(angles, axis=None)) > most:
        return
    for angle in angles[(np.abs(angles) > most) & np.isfinite(angles)][:1]:
        turns = {2 * np.pi: "a full turn", TWO_TURNS: "two full turns"}[most]
        level = 2
        while sys._getframe(level).f_globals.get("__name__", "").startswith(f"{__package__}."):
            level += 1
        warnings.warn(f"{name} = {angle:g} rad is more than {turns}; were degrees meant?", stacklevel=level + 1)


def limits(x: ArrayLike, joints: int | None = None) -> np.ndarray:
    """Lower and upper limit of each joint as float64, (joints, 2); InputError unless finite and none reversed.

    >>> limits([[-1, 1], [0, 2]]).shape
    (2, 2)
    """
    x = finite(x, "limits, a lower and an upper one a joint", joints, 2)
    if (x[:, 0] > x[:, 1]).any():
        joint = int((x[:, 0] > x[:, 1]).argmax())
        lower, upper = told_apart(*x[joint])
        raise InputError(f"The limits of joint {joint + 1} are reversed: {lower} is above {upper}.")
    warn_of_degrees(x, "a limit")
    return x


def pose(T: ArrayLike) -> np.ndarray:
    """``T`` as poses (..., 4, 4); those that hold NaN or infinity become NaN, InputError where one is no pose.

    >>> pose(2 * np.eye(4))
    Traceback (most recent call last):
    lynx_common.errors.InputError: A pose is expected: a rotation, a position, and the row 0 0 0 1; it is off by 7.
    """
    T = real(T, "a pose", 4, 4)
    T = np.where(np.isfinite(T).all(axis=(-2, -1), keepdims=True), T, np.nan)
    R = T[..., :3, :3]
    with np.errstate(invalid="ignore"):
        off = np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)).max(axis=(-2, -1))
        off = np.maximum(off, np.abs(np.linalg.det(R) - 1))
        off = np.maximum(off, np.abs(T[..., 3, :] - [0, 0, 0, 1]).max(axis=-1))
    if (off > POSE_TOLERANCE).any():
        largest = np.nanmax(off)
        sentence = f"A pose is expected: a rotation, a position, and the row 0 0 0 1; it is off by {largest:.2g}."
        raise InputError(sentence + TO_NEAREST * bool(largest < ROUNDED_POSE))
    return T


def formulas(x: Any, name: str = "The expression") -> sp.ImmutableDenseMatrix:
    """A formula, or lists, a tuple, an array or a matrix of them, as a matrix (m, n); a list is a column.

    Raises InputError for text, for what is no formula, and where there is none, or a third axis.

    >>> formulas([sp.Symbol("x"), 1]).shape
    (2, 1)
    """
    if isinstance(x, sp.MatrixExpr):
        x = x.as_explicit()
    if isinstance(x, sp.NDimArray | np.ndarray):
        x = x.tolist()
    if isinstance(x, sp.MatrixBase):
        rows = x.tolist()
    elif isinstance(x, list | tuple | sp.Tuple):
        rows = [list(row) if isinstance(row, list | tuple | sp.Tuple) else [row] for row in x]
    else:
        rows = [[x]]
    if not any(rows) or len({len(row) for row in rows}) > 1:
        raise InputError(f"{name} has no entries, or rows of different lengths.")
    return sp.ImmutableDenseMatrix([[_formula(entry, name) for entry in row] for row in rows])


def _formula(x: Any, name: str) -> sp.Expr:
    try:
        formula = sp.sympify(x, strict=True)  # strict: text is not parsed
    except (sp.SympifyError, TypeError, AttributeError):
        formula = None
    if not isinstance(formula, sp.Expr) or formula.is_Matrix:
        raise InputError(f"{name} holds {shortened(x)}, which is no formula of SymPy; text is not read as one.")
    if formula.has(sp.zoo):
        raise InputError(f"{name} holds a division by zero.")
    return formula
