"""The motions that twists make, alone and in a chain of joints, and twists seen from another frame."""

import numpy as np
from numpy.typing import ArrayLike

from ..errors import ScrewError
from ..reading import finite, pose
from ._lines import UNIT_TOLERANCE, vectors

# Below this angle (radians) a limit takes the place of a quotient that becomes 0/0. It is multiplied by theta^2,
# so that the next term of its series, of order theta^2, counts for theta^4: less than rounding.
SMALL = 1e-4


def exp(twist: ArrayLike) -> np.ndarray:
    r"""The motion that a twist makes in one unit of time: (..., 6) to poses (..., 4, 4).

    For a unit screw times an angle: the rotation by that angle about its axis, and the advance along it.

    .. math:: e^{\hat\xi} = \begin{bmatrix} I + a W + b W^2 & (I + b W + c W^2)\, v \\ 0 & 1 \end{bmatrix},
        \quad a = \frac{\sin\theta}{\theta},\; b = \frac{1 - \cos\theta}{\theta^2},\;
        c = \frac{\theta - \sin\theta}{\theta^3}

    with :math:`\theta = |\omega|` and W the matrix of omega x. Source: Modern Robotics, section 3.3.3.

    >>> exp([1, 2, 3, 0, 0, 0])[:3, 3]  # without a turn: a step along v
    array([1., 2., 3.])
    """
    twist = vectors(twist, "a twist", 6)
    v, omega = twist[..., :3], twist[..., 3:]
    theta = np.linalg.norm(omega, axis=-1)[..., None, None]
    a, b = np.sinc(theta / np.pi), np.sinc(theta / (2 * np.pi)) ** 2 / 2
    large = np.where(theta < SMALL, 1.0, theta)
    c = np.where(theta < SMALL, 1 / 6, (large - np.sin(large)) / large**3)
    W = _cross_matrix(omega)
    T = np.zeros((*twist.shape[:-1], 4, 4))
    T[..., :3, :3] = np.eye(3) + a * W + b * W @ W
    T[..., :3, 3] = ((np.eye(3) + b * W + c * W @ W) @ v[..., None])[..., 0]
    T[..., 3, 3] = 1
    T[np.isnan(twist).any(axis=-1)] = np.nan
    return T


def adjoint(T: ArrayLike) -> np.ndarray:
    """The matrix, (..., 6, 6), that takes a twist as seen from frame b to the same seen from frame a; T = T_a_b.

    With ``T`` as a motion: it carries a screw along. A wrench goes by the transpose of the inverse, so that the
    power stays what it is. Raises InputError where ``T`` is not a pose. Source: Modern Robotics, section 3.3.2.

    >>> adjoint(exp([0, -2, 0, 0, 0, 0])) @ [0, 0, 0, 0, 0, 1]  # a turn about z, seen from 2 to its left
    array([-2.,  0.,  0.,  0.,  0.,  1.])
    """
    T = pose(T)
    R = T[..., :3, :3]
    upper = np.concatenate([R, _cross_matrix(T[..., :3, 3]) @ R], axis=-1)
    lower = np.concatenate([0 * R, R], axis=-1)  # not np.zeros: NaN in, NaN out
    return np.concatenate([upper, lower], axis=-2)


def product_of_exponentials(twists: ArrayLike, home: ArrayLike, q: ArrayLike) -> np.ndarray:
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

    >>> about_z = [[0], [0], [0], [0], [0], [1]]
    >>> product_of_exponentials(about_z, exp([1, 0, 0, 0, 0, 0]), [np.pi / 2])[:3, 3].round(6)
    array([0., 1., 0.])
    """
    return _motions(twists, q)[-1] @ pose(home)


def space_jacobian(twists: ArrayLike, q: ArrayLike) -> np.ndarray:
    """The joints' screws where they are at ``q``: (6, n) and (..., n) to (..., 6, n), seen from the base.

    Its columns add up, times the joint velocities, to the twist of the end. v is that of the point at the origin;
    to have the velocity of a point p of the end, multiply by ``adjoint(exp((-p, 0)))``. Raises ScrewError where a
    screw is zero or not a unit screw. Source: Modern Robotics, section 5.1.

    >>> out_along_x = [[0, 1], [0, 0], [0, 0], [0, 0], [0, 0], [1, 0]]  # once turned about z
    >>> space_jacobian(out_along_x, [np.pi / 2, 3])[:3, 1].round(6)
    array([0., 1., 0.])
    """
    columns = [adjoint(T) @ xi for T, xi in zip(_motions(twists, q), np.transpose(twists), strict=False)]
    return np.stack(columns, axis=-1)


def _motions(twists: ArrayLike, q: ArrayLike) -> list[np.ndarray]:
    """The motions of what lies beyond joint 0, 1, ..., n: n + 1 arrays of poses (..., 4, 4)."""
    twists = finite(twists, "the joints' screws", 6, None)
    speed, turn = np.linalg.norm(twists[:3], axis=0), np.linalg.norm(twists[3:], axis=0)
    magnitude = np.where(turn > 0, turn, speed)
    for joint in np.flatnonzero(np.abs(magnitude - 1) > UNIT_TOLERANCE):
        raise ScrewError(f"The screw of joint {joint + 1} must be a unit screw", float(magnitude[joint]))
    q = vectors(q, "the joint variables", twists.shape[1])
    motions = [np.eye(4) + 0 * q[..., :1, None]]
    for i, xi in enumerate(twists.T):
        motions.append(motions[-1] @ exp(xi * q[..., i, None]))
    return motions


def _cross_matrix(vector: np.ndarray) -> np.ndarray:
    """The matrix of ``vector`` x: (..., 3) to (..., 3, 3)."""
    x, y, z = np.moveaxis(vector, -1, 0)
    zero = np.zeros_like(x)
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(*vector.shape, 3)
