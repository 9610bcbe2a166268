"""The robot itself: its lengths and angles, and where its joints are."""

from dataclasses import dataclass
from itertools import combinations, product

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from .. import reading
from ..arcs import crossings
from ..errors import GeometryError, InputError
from ..symbolic import DESIGN, POSE, compiled
from . import formulas
from .formulas import THETA

CORNERS = (np.pi / 2, 7 * np.pi / 6, 11 * np.pi / 6)
TURNS = 720  # values of alpha at which a new geometry is tried


_base_joints = compiled(DESIGN)(formulas.base_joints)
_platform_joints = compiled(POSE, DESIGN)(formulas.platform_joints)


@compiled(THETA[:1], (DESIGN[0], DESIGN[3], DESIGN[4]))
def _elbow() -> sp.Matrix:
    """That of one leg; a leg is S_A, r_base and its base angle."""
    return (formulas.base_joints() + formulas.driven_links())[0, :].T


@dataclass(frozen=True)
class Geometry(reading.Record):
    """Lengths in mm and angles in radians; report Tables 2.1 and 2.2.

    S_A : the driven link; L : the link that ends at the platform; r_platform, r_base : radii of the circles on
    which the joints of platform and base lie, at platform_angles and base_angles. Raises GeometryError unless
    the lengths are finite and longer than zero, each set of angles is three finite numbers, and there is a
    pose at which all legs close. (One that misses this by less than r_platform times a quarter of a degree is
    accepted.)
    """

    S_A: float = 170.0
    L: float = 130.0
    r_platform: float = 130.0
    r_base: float = 290.0
    base_angles: tuple[float, float, float] = CORNERS
    platform_angles: tuple[float, float, float] = CORNERS

    def __post_init__(self) -> None:
        for name in ("S_A", "L", "r_platform", "r_base"):
            object.__setattr__(self, name, reading.length(name, getattr(self, name), "millimetres"))
        for name in ("base_angles", "platform_angles"):
            object.__setattr__(self, name, _angles(name, getattr(self, name)))
        lengths = self.S_A, self.L, self.r_platform, self.r_base
        object.__setattr__(self, "values", (*lengths, *self.base_angles, *self.platform_angles))
        if not _closes(self):
            given = f"{self.S_A:g}, {self.L:g}, {self.r_platform:g} and {self.r_base:g} mm"
            span = f"a leg spans {abs(self.S_A - self.L):g} to {self.S_A + self.L:g} mm"
            raise GeometryError("S_A, L, r_platform, r_base", given, f"{span}, and no pose lets all three close")


def _angles(name: str, value: ArrayLike) -> tuple[float, ...]:
    try:
        angles = reading.finite(value, name, 3)
    except InputError:
        raise GeometryError(name, value, "three finite angles in radians are expected") from None
    reading.warn_of_degrees(angles, name)
    return tuple(angles.tolist())


def _closes(geometry: Geometry) -> bool:
    """Whether some pose closes all legs, tried at TURNS values of alpha, with room for those between them.

    At one alpha leg i allows the platform's centre a ring about PB_i - R(alpha) r_i, all three of one size. Rings
    of one size that have a point in common have one where two of their circles cross, so those points are tried.
    (Three rings in one place have no such point; but they are not in one place at every alpha.)
    """
    S_A, L, r_platform, *_ = geometry
    poses = np.zeros((TURNS, 3))
    poses[:, 2] = 2 * np.pi / TURNS * np.arange(TURNS)
    centres = _base_joints(geometry) - _platform_joints(poses, geometry)  # (alpha, leg, coordinate)
    between, rounding = np.pi / TURNS * r_platform, 1e-9 * (S_A + L)
    inner, outer = max(abs(S_A - L) - between, 0), S_A + L + between
    for (i, j), (rho_i, rho_j) in product(combinations(range(3), 2), product((inner, outer), repeat=2)):
        for points in crossings(centres[:, i], rho_i, centres[:, j], rho_j):
            away = np.linalg.norm(points[:, None] - centres, axis=-1)
            if ((away >= inner - rounding) & (away <= outer + rounding)).all(axis=-1).any():
                return True
    return False


RRR = Geometry()


def base_joints(geometry: Geometry = RRR) -> np.ndarray:
    """The motors PB_1, PB_2, PB_3, in mm: (3, 2).

    >>> base_joints().round(1).tolist()
    [[0.0, 290.0], [-251.1, -145.0], [251.1, -145.0]]
    """
    return _base_joints(geometry)


def platform_joints(pose: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    """The platform's joints PP_i in mm: (..., 3) to (..., 3, 2); report eq. (2.1) with the angles of Table 2.2.

    >>> platform_joints([0, 0, np.pi]).round(1)[0] + 0.0
    array([   0., -130.])
    """
    return _platform_joints(reading.batch(pose, POSE), geometry)


def elbows(theta: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    """The elbows M_1, M_2, M_3, in mm, for motor angles (..., 3): (..., 3, 2). NaN makes NaN of its own elbow.

    >>> elbows(np.zeros(3)).round(1)[0]
    array([170., 290.])
    """
    S_A, _, _, r_base, *_ = geometry
    legs = [(S_A, r_base, beta) for beta in geometry.base_angles]
    return _elbow(reading.batch(theta, THETA)[..., None], np.array(legs))
