"""Obstacles: how far the whole arm is from a sphere, and how fast that can change.

Metres and radians; joint angles are those of ``arm``.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from . import arm
from .reading import finite, number, real
from .symbolic import CHUNK


@dataclass(frozen=True)
class Sphere:
    """A ball, by its centre (x, y, z) and its radius in metres, base frame.

    Raises InputError unless the centre is three finite numbers and the radius is finite and not negative.
    """

    centre: tuple[float, float, float]
    radius: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "centre", tuple(finite(self.centre, "the centre of a sphere", 3).tolist()))
        object.__setattr__(self, "radius", number(self.radius, "radius of a sphere", least=0))

    def distance(self, points: ArrayLike) -> np.ndarray:
        """Distance of points from the surface, negative inside: (..., 3) to (...).

        >>> Sphere((0, 0, 0.5), radius=0.2).distance([0, 0, 1]).item()
        0.3
        """
        return np.linalg.norm(real(points, "points", 3) - self.centre, axis=-1) - self.radius


def clearance(
    q: ArrayLike, sphere: Sphere, link_radius: float = 0.0, *, geometry: arm.Geometry = arm.LYNX
) -> np.ndarray:
    """Signed distance of the whole arm from a sphere; negative where they overlap.

    The links are the straight lines between ``arm.joint_positions``, base to gripper, ``link_radius`` metres thick
    all round (capsules).

    Parameters
    ----------
    q : array, shape (..., 5)
        Joint angles in radians.

    Returns
    -------
    distance : array, shape (...)
        Metres; NaN where q is not finite. Raises InputError where the link radius is not finite or negative.

    >>> upright = [0, np.pi / 2, 0, np.pi / 2, 0]
    >>> clearance(upright, Sphere((0.3, 0, 0.3), 0.1)).round(6).item()
    0.2
    """
    link_radius = number(link_radius, "radius of the links", least=0)
    q = real(q, "joint angles", 5)
    points = arm.joint_positions(q, geometry).reshape(-1, 5, 3)
    nearest = np.empty(len(points))
    for start in range(0, len(points), CHUNK):
        part = slice(start, start + CHUNK)
        nearest[part] = _distance(np.ascontiguousarray(points[part].T), sphere.centre)
    return (nearest - sphere.radius - link_radius).reshape(q.shape[:-1])


def lipschitz_constant(geometry: arm.Geometry = arm.LYNX) -> float:
    """A Lipschitz constant of ``clearance`` in joint space, metres per radian of Euclidean joint distance.

    No point of the arm moves faster than this when the joint velocity has norm 1, so the distance of the nearest
    one changes no faster. Joint i moves a point by at most its lever arm, that is the length of the links
    beyond: L_1 + L_2 + L_3 for joints 1 and 2, L_2 + L_3 for joint 3, L_3 for joint 4, none for joint 5. Joint 1
    moves it square to the arm's plane and the others within it, so that the speeds add as squares,

        l_1^2 theta_1_dot^2 + (l_2 |theta_2_dot| + l_3 |theta_3_dot| + l_4 |theta_4_dot|)^2
            <= max(l_1^2, l_2^2 + l_3^2 + l_4^2) |q_dot|^2    (Cauchy and Schwarz),

    and since l_1 = l_2 the second is the larger.

    >>> round(lipschitz_constant(), 4)
    0.5916
    """
    _, L_1, L_2, L_3 = geometry
    return float(np.linalg.norm([L_1 + L_2 + L_3, L_2 + L_3, L_3]))


def _distance(points: np.ndarray, centre: tuple[float, float, float]) -> np.ndarray:
    """Distance (k,) of a point from the lines between joint positions, (3, 5, k)."""
    link = points[:, 1:] - points[:, :-1]
    towards = np.array(centre)[:, None, None] - points[:, :-1]
    squared = (link * link).sum(axis=0)
    share = np.divide((towards * link).sum(axis=0), squared, out=np.zeros_like(squared), where=squared > 0)
    away = towards - np.clip(share, 0, 1) * link
    return np.sqrt((away * away).sum(axis=0).min(axis=0))
