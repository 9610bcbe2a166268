"""Angles, limits, poses and formulas."""

import sys
import warnings
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from ..errors import InputError, told_apart
from ._numbers import finite, real, shortened

# How far the rotation of a pose may be from orthogonal, and how far one may be that was rounded to few digits.
POSE_TOLERANCE, ROUNDED_POSE = 1e-6, 1e-2
TO_NEAREST = (
    " If it was rounded, the nearest rotation is U @ V, of U, _, V = np.linalg.svd(T[:3, :3]): "
    "put it in the place of T[:3, :3]."
)

TWO_TURNS = 4 * np.pi  # angles beyond are hardly meant in radians


def warn_of_degrees(angles: np.ndarray, name: str, most: float = TWO_TURNS) -> None:
    """Warn where an angle is larger than ``most`` radians; the warning points to the line outside the package.

    >>> warn_of_degrees(np.array([3.0]), "theta")  # says nothing
    """
    if not angles.size or not max(np.fmax.reduce(angles, axis=None), -np.fmin.reduce(angles, axis=None)) > most:
        return
    for angle in angles[(np.abs(angles) > most) & np.isfinite(angles)][:1]:
        turns = {2 * np.pi: "a full turn", TWO_TURNS: "two full turns"}[most]
        level = 2
        while sys._getframe(level).f_globals.get("__name__", "").startswith("lynx_common."):
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
