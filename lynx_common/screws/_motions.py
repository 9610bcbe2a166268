"""The motions that twists make, and twists seen from another frame."""

import numpy as np
from numpy.typing import ArrayLike

from ..reading import pose
from ._lines import vectors

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


def _cross_matrix(vector: np.ndarray) -> np.ndarray:
    """The matrix of ``vector`` x: (..., 3) to (..., 3, 3)."""
    x, y, z = np.moveaxis(vector, -1, 0)
    zero = np.zeros_like(x)
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(*vector.shape, 3)
