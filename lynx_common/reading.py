"""Reading what is given: real numbers of the right shape, or a sentence that says what was given instead."""

import numpy as np

from .errors import InputError

# How far the rotation of a pose may be from orthogonal.
POSE_TOLERANCE = 1e-6


def real(x: np.ndarray, name: str, *shape: int | None) -> np.ndarray:
    """``x`` as float64 whose last axes have ``shape``, None being any length; InputError where they have not.

    SymPy's numbers are read too. Complex ones are refused, and so are words.
    """
    x = np.asarray(x)
    if x.dtype != float:
        x = _as_float(x, name)
    tail = x.shape[x.ndim - len(shape) :] if x.ndim >= len(shape) else ()
    if len(tail) != len(shape) or any(want not in (None, have) for have, want in zip(tail, shape, strict=True)):
        wanted = ", ".join("n" if want is None else str(want) for want in shape)
        raise InputError(f"The last axes of {name} must be ({wanted}); the shape given is {x.shape}.")
    return x


def _as_float(x: np.ndarray, name: str) -> np.ndarray:
    if np.iscomplexobj(x):
        raise InputError(f"Real numbers are expected for {name}; complex ones were given.")
    try:
        return x.astype(float, casting="unsafe" if x.dtype == object else "same_kind")
    except (TypeError, ValueError):
        raise InputError(f"Real numbers are expected for {name}; {x.tolist()!r} was given.") from None


def limits(x: np.ndarray, joints: int) -> np.ndarray:
    """Lower and upper limit of each joint as float64, (joints, 2); InputError unless finite and none reversed."""
    x = real(x, "limits")
    if x.shape != (joints, 2) or not np.isfinite(x).all():
        shape = f"a ({joints}, 2) array of finite angles: lower and upper, joints 1 to {joints}"
        raise InputError(f"Limits are expected as {shape}; {x.tolist()} was given.")
    if (x[:, 0] > x[:, 1]).any():
        joint = int((x[:, 0] > x[:, 1]).argmax())
        lower, upper = x[joint]
        raise InputError(f"The limits of joint {joint + 1} are reversed: {lower:.4f} is above {upper:.4f} rad.")
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
        raise InputError(
            f"A pose is expected: a rotation, a position, and the row 0 0 0 1; it is off by {np.nanmax(off):.2g}."
        )
    return T
