"""The robot itself: its lengths and angles, and where its joints are."""

from dataclasses import astuple, dataclass, fields

import numpy as np
import sympy as sp

from .. import reading
from ..errors import GeometryError, InputError
from ..symbolic import DESIGN, POSE, compiled, real
from . import formulas
from .formulas import THETA

CORNERS = (np.pi / 2, 7 * np.pi / 6, 11 * np.pi / 6)
TURNS = 720  # values of alpha at which a new geometry is tried


@dataclass(frozen=True)
class Geometry(reading.Record):
    """Lengths in mm and angles in radians; report Tables 2.1 and 2.2.

    S_A : the driven link; L : the link that ends at the platform; r_platform, r_base : radii of the circles on
    which the joints of platform and base lie, at platform_angles and base_angles. Raises GeometryError unless
    the lengths are finite and longer than zero, each set of angles is three finite numbers, and there is a
    pose at which all legs close. (A robot that misses it by less than r_platform times a quarter of a degree
    is let pass.)
    """

    S_A: float = 170.0
    L: float = 130.0
    r_platform: float = 130.0
    r_base: float = 290.0
    base_angles: tuple[float, float, float] = CORNERS
    platform_angles: tuple[float, float, float] = CORNERS

    def __post_init__(self) -> None:
        for name, value in zip((field.name for field in fields(self)), astuple(self), strict=True):
            object.__setattr__(self, name, (_angles if name.endswith("angles") else _length)(name, value))
        lengths = self.S_A, self.L, self.r_platform, self.r_base
        object.__setattr__(self, "values", (*lengths, *self.base_angles, *self.platform_angles))
        if not _closes(self):
            given = f"{self.S_A:g}, {self.L:g}, {self.r_platform:g} and {self.r_base:g} mm"
            span = f"a leg spans {abs(self.S_A - self.L):g} to {self.S_A + self.L:g} mm"
            raise GeometryError("S_A, L, r_platform, r_base", given, f"{span}, and no pose lets all three close")


def _length(name: str, value: float) -> float:
    if not isinstance(value, int | float | np.number) or isinstance(value, bool | complex | np.complexfloating):
        raise GeometryError(name, value, "a length is a real number of millimetres")
    if not (np.isfinite(value) and value > 0):
        raise GeometryError(name, value, "a length is finite and longer than zero")
    return float(value)


def _angles(name: str, value: tuple[float, float, float]) -> tuple[float, float, float]:
    try:
        angles = reading.real(value, name)
    except InputError:
        angles = np.empty(0)
    if angles.shape != (3,) or not np.isfinite(angles).all():
        raise GeometryError(name, value, "three finite angles in radians are expected")
    reading.warn_of_degrees(angles, name)
    return tuple(map(float, angles))


def _closes(geometry: Geometry) -> bool:
    """Whether some pose closes all legs, tried at TURNS values of alpha with room for those between them.

    At one alpha each leg allows the platform's centre a ring. Rings of one size that have a point in common have
    one where two of their circles cross (or all are the same ring, which they are not at every alpha).
    """
    S_A, L, r_platform, r_base, *_ = geometry
    turn = np.exp(2j * np.pi * np.arange(TURNS) / TURNS)[:, None]
    centre = r_base * np.exp(1j * np.array(geometry.base_angles))
    centre = centre - turn * r_platform * np.exp(1j * np.array(geometry.platform_angles))
    slack = np.pi / TURNS * r_platform + 1e-9 * (S_A + L)
    ends = np.array([max(abs(S_A - L) - slack, 0), S_A + L + slack])
    c, rho = np.repeat(centre, 2, axis=1), np.tile(ends, 3)
    apart = c[:, None] - c[:, :, None]
    with np.errstate(invalid="ignore", divide="ignore"):
        along = (abs(apart) ** 2 + rho[:, None] ** 2 - rho**2) / (2 * abs(apart))
        across = 1j * np.sqrt(rho[:, None] ** 2 - along**2)
        crossings = [c[:, :, None] + (along + side * across) * apart / abs(apart) for side in (1, -1)]
    points = np.concatenate([x.reshape(TURNS, -1) for x in crossings], axis=1)
    span = abs(points[..., None] - centre[:, None])
    rounding = 1e-9 * (S_A + L)
    return bool(((span >= ends[0] - rounding) & (span <= ends[1] + rounding)).all(axis=-1).any())


RRR = Geometry()


_base_joints = compiled(DESIGN)(formulas.base_joints)
_platform_joints = compiled(POSE, DESIGN)(formulas.platform_joints)


@compiled(THETA[:1], (DESIGN[0], DESIGN[3], DESIGN[4]))
def _elbow() -> sp.Matrix:
    """That of one leg; a leg is S_A, r_base and its base angle."""
    return (formulas.base_joints() + formulas.driven_links())[0, :].T


def base_joints(geometry: Geometry = RRR) -> np.ndarray:
    """The motors PB_1, PB_2, PB_3, in mm: (3, 2)."""
    return _base_joints(geometry)


def platform_joints(pose: np.ndarray, geometry: Geometry = RRR) -> np.ndarray:
    """The platform's joints PP_i in mm: (..., 3) to (..., 3, 2); report eq. (2.1) with the angles of Table 2.2."""
    return _platform_joints(checked(pose), geometry)


def elbows(theta: np.ndarray, geometry: Geometry = RRR) -> np.ndarray:
    """The elbows M_1, M_2, M_3, in mm, for motor angles (..., 3): (..., 3, 2). NaN makes NaN of its own elbow."""
    S_A, _, _, r_base, *_ = geometry
    legs = [(S_A, r_base, beta) for beta in geometry.base_angles]
    return _elbow(real(theta, THETA)[..., None], np.array(legs))


def checked(pose: np.ndarray) -> np.ndarray:
    """``pose`` as float64; warns where alpha can hardly be meant in radians."""
    pose = real(pose, POSE)
    reading.warn_of_degrees(pose[..., 2], "alpha", 2 * np.pi)
    return pose


def one(what: str, values: np.ndarray, symbols: tuple[sp.Symbol, ...]) -> np.ndarray:
    """``values`` as float64, (n,); InputError unless they are one finite number a symbol."""
    values = real(values, symbols)
    if values.ndim > 1 or not np.isfinite(values).all():
        raise InputError(f"One {what} is expected, {len(symbols)} finite numbers; {values.tolist()} was given.")
    return values
