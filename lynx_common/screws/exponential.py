"""From twists to motions and back, and twists seen from another frame."""

import numpy as np

from ..reading import pose, real

# Below this angle (radians) limits take the place of quotients, which become 0/0. These are multiplied by
# theta^2, so that the next term of their series, of order theta^2, counts for theta^4: less than rounding.
SMALL = 1e-4


def hat(twist: np.ndarray) -> np.ndarray:
    """The matrix of a twist, (..., 6) to (..., 4, 4): it maps points (x, y, z, 1) to their velocities."""
    twist = real(twist, "a twist", 6)
    matrix = np.zeros((*twist.shape[:-1], 4, 4))
    matrix[..., :3, :3] = cross_matrix(twist[..., 3:])
    matrix[..., :3, 3] = twist[..., :3]
    return matrix


def exp(twist: np.ndarray) -> np.ndarray:
    r"""The motion that a twist makes in one unit of time: (..., 6) to poses (..., 4, 4).

    For a unit screw times an angle: the rotation by that angle about its axis, and the advance along it.

    .. math:: e^{\hat\xi} = \begin{bmatrix} I + a W + b W^2 & (I + b W + c W^2)\, v \\ 0 & 1 \end{bmatrix},
        \quad a = \frac{\sin\theta}{\theta},\; b = \frac{1 - \cos\theta}{\theta^2},\;
        c = \frac{\theta - \sin\theta}{\theta^3}

    with :math:`\theta = |\omega|` and W the matrix of omega x. Source: Modern Robotics, section 3.3.3.
    """
    twist = real(twist, "a twist", 6)
    v, omega = twist[..., :3], twist[..., 3:]
    with np.errstate(invalid="ignore"):
        theta = np.linalg.norm(omega, axis=-1)[..., None, None]
        a, b, c = np.sinc(theta / np.pi), np.sinc(theta / (2 * np.pi)) ** 2 / 2, _third(theta)
        W = cross_matrix(omega)
        T = np.zeros((*twist.shape[:-1], 4, 4))
        T[..., :3, :3] = np.eye(3) + a * W + b * W @ W
        T[..., :3, 3] = ((np.eye(3) + b * W + c * W @ W) @ v[..., None])[..., 0]
        T[..., 3, 3] = 1
    T[~np.isfinite(twist).all(axis=-1)] = np.nan
    return T


def log(T: np.ndarray) -> np.ndarray:
    """The twist with |omega| <= pi that makes the motion ``T`` in one unit of time: (..., 4, 4) to (..., 6).

    At half a turn omega and -omega are the same rotation; either may be given. Raises InputError where ``T`` is
    not a pose. Source: Modern Robotics, section 3.3.3; but the rotation goes through its quaternion, which loses
    no digits near half a turn, where the book's formula divides by sin(theta).
    """
    T = pose(T)
    omega = _rotation_vector(T[..., :3, :3])
    theta = np.linalg.norm(omega, axis=-1)[..., None, None]
    W = cross_matrix(omega)
    V_inverse = np.eye(3) - W / 2 + _of_inverse(theta) * W @ W
    return np.concatenate([(V_inverse @ T[..., :3, 3:])[..., 0], omega], axis=-1)


def adjoint(T: np.ndarray) -> np.ndarray:
    """The matrix, (..., 6, 6), that takes a twist as seen from frame b to the same seen from frame a; T = T_a_b.

    With ``T`` as a motion: it carries a screw along. A wrench goes by the transpose of the inverse, so that the
    power stays what it is. Raises InputError where ``T`` is not a pose. Source: Modern Robotics, section 3.3.2.
    """
    T = pose(T)
    R = T[..., :3, :3]
    upper = np.concatenate([R, cross_matrix(T[..., :3, 3]) @ R], axis=-1)
    lower = np.concatenate([0 * R, R], axis=-1)  # not np.zeros: NaN in, NaN out
    return np.concatenate([upper, lower], axis=-2)


def inverse(T: np.ndarray) -> np.ndarray:
    """The pose of frame a in frame b, for ``T`` = T_a_b: (..., 4, 4) to the same."""
    T = pose(T)
    back = T.copy()
    back[..., :3, :3] = np.swapaxes(T[..., :3, :3], -1, -2)
    back[..., :3, 3:] = -back[..., :3, :3] @ T[..., :3, 3:]
    return back


def cross_matrix(vector: np.ndarray) -> np.ndarray:
    """The matrix of ``vector`` x: (..., 3) to (..., 3, 3)."""
    x, y, z = np.moveaxis(vector, -1, 0)
    zero = np.zeros_like(x)
    return np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(*vector.shape, 3)


def _third(theta: np.ndarray) -> np.ndarray:
    """(theta - sin(theta)) / theta^3, to what its product with theta^2 needs."""
    large = np.where(theta < SMALL, 1.0, theta)
    return np.where(theta < SMALL, 1 / 6, (large - np.sin(large)) / large**3)


def _of_inverse(theta: np.ndarray) -> np.ndarray:
    """(1 - theta/2 cot(theta/2)) / theta^2, to what its product with theta^2 needs."""
    large = np.where(theta < SMALL, 1.0, theta)
    return np.where(theta < SMALL, 1 / 12, (1 - large / 2 / np.tan(large / 2)) / large**2)


def _rotation_vector(R: np.ndarray) -> np.ndarray:
    """Axis times angle, (..., 3), of rotations (..., 3, 3), by way of the quaternion (w, x, y, z)."""
    # Four times the outer product of the quaternion with itself: its longest row gives the quaternion safely.
    (a, b, c), (d, e, f), (g, h, i) = (np.moveaxis(R[..., k, :], -1, 0) for k in range(3))
    rows = [
        [1 + a + e + i, h - f, c - g, d - b],
        [h - f, 1 + a - e - i, b + d, c + g],
        [c - g, b + d, 1 - a + e - i, f + h],
        [d - b, c + g, f + h, 1 - a - e + i],
    ]
    outer = np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)
    longest = np.argmax(np.diagonal(outer, axis1=-2, axis2=-1), axis=-1)
    q = np.take_along_axis(outer, longest[..., None, None], axis=-2)[..., 0, :]
    q = q * np.where(q[..., :1] < 0, -1, 1) / np.linalg.norm(q, axis=-1, keepdims=True)
    sine, cosine = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True), q[..., :1]
    return q[..., 1:] * 2 * np.arctan2(sine, cosine) / np.where(sine == 0, 1.0, sine)
