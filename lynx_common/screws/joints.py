"""Chains of joints, given by their screws where all angles are zero: pose and Jacobian without link frames."""

import numpy as np

from ..errors import ScrewError
from ..reading import pose, real
from .exponential import adjoint, exp
from .lines import UNIT_TOLERANCE


def product_of_exponentials(twists: np.ndarray, home: np.ndarray, q: np.ndarray) -> np.ndarray:
    r"""Pose of the end of a chain, :math:`e^{\hat\xi_1 q_1} \cdots e^{\hat\xi_n q_n} M`.

    Parameters
    ----------
    twists : array, shape (6, n)
        The joints' unit screws in the base frame where q = 0, one a column, the base first.
    home : array, shape (4, 4)
        The pose M of the end where q = 0.
    q : array, shape (..., n)
        Joint variables: radians, or lengths for joints that slide.

    Returns
    -------
    T : array, shape (..., 4, 4)

    Raises ScrewError where a screw is zero or not a unit screw. Source: Modern Robotics, eq. (4.14).
    """
    *_, last = _frames(twists, q)
    return last @ pose(real(home, "home", 4, 4))


def space_jacobian(twists: np.ndarray, q: np.ndarray) -> np.ndarray:
    """The joints' screws where they are at ``q``: (6, n) and (..., n) to (..., 6, n), seen from the base.

    Its columns add up, times the joint velocities, to the twist of the end. v is that of the point at the origin;
    to have the velocity of a point p of the end, multiply by ``adjoint(exp((-p, 0)))``. Raises ScrewError where a
    screw is zero or not a unit screw. Source: Modern Robotics, section 5.1.
    """
    frames = _frames(twists, q)
    columns = [(adjoint(T) @ xi[:, None])[..., 0] for T, xi in zip(frames, np.transpose(twists), strict=False)]
    return np.stack(columns, axis=-1)


def _frames(twists: np.ndarray, q: np.ndarray) -> list[np.ndarray]:
    """The motions of what lies beyond joint 0, 1, ..., n: n + 1 arrays of poses (..., 4, 4)."""
    twists = _unit(real(twists, "the screws", 6, None))
    q = real(q, "the joint variables", twists.shape[1])
    q = np.where(np.isfinite(q).all(axis=-1, keepdims=True), q, np.nan)
    frames = [np.eye(4) + 0 * q[..., :1, None]]
    for i, xi in enumerate(twists.T):
        frames.append(frames[-1] @ exp(xi * q[..., i, None]))
    return frames


def _unit(twists: np.ndarray) -> np.ndarray:
    speed, turn = np.linalg.norm(twists[:3], axis=0), np.linalg.norm(twists[3:], axis=0)
    magnitude = np.where(turn > 0, turn, speed)
    if (off := ~(np.abs(magnitude - 1) <= UNIT_TOLERANCE)).any():
        joint = int(np.flatnonzero(off)[0])
        raise ScrewError(f"The screw of joint {joint + 1} must be a unit screw", float(magnitude[joint]))
    return twists
