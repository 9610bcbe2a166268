"""Reading what is given: numbers, angles, limits, poses, formulas; or a sentence that says what was given instead.

Text is never taken for a number or a formula, and never evaluated.
"""

import sys
import warnings
from collections.abc import Iterator
from dataclasses import fields

import numpy as np
import sympy as sp

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
        known = [field.name for field in fields(cls)]
        for name in parameters.keys() - known:
            raise GeometryError(name, parameters[name], f"there are {', '.join(known)}")
        return super().__new__(cls)

    def __iter__(self) -> Iterator[float]:
        return iter(self.values)

    def __array__(self, dtype: type | None = None, copy: bool | None = None) -> np.ndarray:
        return np.array(self.values, dtype=dtype)


def real(x: np.ndarray, name: str, *shape: int | None) -> np.ndarray:
    """``x`` as float64 whose last axes have ``shape``, None being any length; InputError where they have not.

    SymPy's numbers are read too. Complex numbers, truth values, words, None and what is masked are refused.
    """
    if isinstance(x, Record):
        raise InputError(f"Numbers are expected for {name}, not {x}; it is given as geometry=...")
    if not isinstance(x, np.ndarray) or x.dtype != float or isinstance(x, np.ma.MaskedArray):
        x = _as_float(x, name)
    tail = x.shape[x.ndim - len(shape) :] if x.ndim >= len(shape) else ()
    if len(tail) != len(shape) or any(want not in (None, have) for have, want in zip(tail, shape, strict=True)):
        wanted = ", ".join("n" if want is None else str(want) for want in shape)
        raise InputError(f"The last axes of {name} must be ({wanted}); the shape given is {x.shape}.")
    return x


def _as_float(x: object, name: str) -> np.ndarray:
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


def shortened(x: object) -> str:
    """``x`` as text that fits into a sentence."""
    text = repr(x.tolist() if isinstance(x, np.ndarray) and x.size < 100 else x)
    return " ".join((text if len(text) <= 80 else f"{text[:77]}...").split())


def warn_of_degrees(angles: np.ndarray, name: str, most: float = TWO_TURNS) -> None:
    """Warn where an angle is larger than ``most`` radians; the warning points to the line outside the package."""
    if not angles.size or not max(np.fmax.reduce(angles, axis=None), -np.fmin.reduce(angles, axis=None)) > most:
        return
    for angle in angles[(np.abs(angles) > most) & np.isfinite(angles)][:1]:
        turns = {2 * np.pi: "a full turn", TWO_TURNS: "two full turns"}[most]
        level = 2
        while sys._getframe(level).f_globals.get("__name__", "").startswith(f"{__package__}."):
            level += 1
        warnings.warn(f"{name} = {angle:g} rad is more than {turns}; were degrees meant?", stacklevel=level + 1)


def limits(x: np.ndarray, joints: int) -> np.ndarray:
    """Lower and upper limit of each joint as float64, (joints, 2); InputError unless finite and none reversed."""
    x = real(x, "limits")
    if x.shape != (joints, 2) or not np.isfinite(x).all():
        shape = f"a ({joints}, 2) array of finite angles: lower and upper, joints 1 to {joints}"
        raise InputError(f"Limits are expected as {shape}; {shortened(x)} was given.")
    if (x[:, 0] > x[:, 1]).any():
        joint = int((x[:, 0] > x[:, 1]).argmax())
        lower, upper = told_apart(*x[joint])
        raise InputError(f"The limits of joint {joint + 1} are reversed: {lower} is above {upper} rad.")
    warn_of_degrees(x, "a limit")
    return x


def pose(T: np.ndarray) -> np.ndarray:
    """``T`` as poses (..., 4, 4); those that hold NaN or infinity become NaN, InputError where one is no pose."""
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


def formulas(x: object, name: str = "The expression") -> sp.ImmutableDenseMatrix:
    """A formula, or lists, a tuple, an array or a matrix of them, as a matrix (m, n); a list is a column.

    Raises InputError for text, for what is no formula, and where there is none, or a third axis.
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


def _formula(x: object, name: str) -> sp.Expr:
    try:
        formula = sp.sympify(x, strict=True)  # strict: text is not parsed
    except (sp.SympifyError, TypeError, AttributeError):
        formula = None
    if not isinstance(formula, sp.Expr) or formula.is_Matrix:
        raise InputError(f"{name} holds {shortened(x)}, which is no formula of SymPy; text is not read as one.")
    if formula.has(sp.zoo):
        raise InputError(f"{name} holds a division by zero.")
    return formula
