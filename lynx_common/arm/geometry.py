"""The arm itself: its lengths, its joint limits and its DH table."""

from dataclasses import astuple, dataclass, fields

import numpy as np
import sympy as sp

from .. import dh
from ..errors import GeometryError
from ..reading import Record, warn_of_degrees
from ..reading import limits as read_limits
from ..symbolic import P, Q, real


@dataclass(frozen=True)
class Geometry(Record):
    """Lengths in metres; report Table 1.3. Unpacks in this order.

    d_1 : base to shoulder, along the vertical; L_1 : shoulder to elbow; L_2 : elbow to wrist;
    L_3 : wrist to gripper. Raises GeometryError unless all are finite and none is negative, and the
    two links L_1 and L_2 are longer than zero.
    """

    d_1: float = 0.1
    L_1: float = 0.2
    L_2: float = 0.2
    L_3: float = 0.1

    def __post_init__(self) -> None:
        for name, value in zip((field.name for field in fields(self)), astuple(self), strict=True):
            _check_length(name, value)
            object.__setattr__(self, name, float(value))
        object.__setattr__(self, "values", astuple(self))


def _check_length(name: str, value: float) -> None:
    if not isinstance(value, int | float | np.number) or isinstance(value, bool | complex | np.complexfloating):
        raise GeometryError(name, value, "a length is a real number of metres")
    if not np.isfinite(value):
        raise GeometryError(name, value, "a length is finite")
    if value < 0:
        raise GeometryError(name, value, "a length is not negative")
    if value == 0 and name in ("L_1", "L_2"):
        raise GeometryError(name, value, "the upper arm and the forearm are longer than zero")


LYNX = Geometry()

# Lower and upper limit of each joint, (5, 2), radians. An assumption: the report gives only the ranges that
# it sweeps in section 1.2. Within these lie all of its own tasks; the wrist's are +-150 deg about straight.
JOINT_LIMITS = np.pi / 180 * np.array([[-180, 180], [0, 180], [-150, 150], [-60, 240], [-180, 180]])
JOINT_LIMITS.setflags(write=False)


def dh_table() -> list[dh.Row]:
    """The five rows of the standard (distal) DH table in the symbols Q and P; report Table 1.2."""
    theta_1, theta_2, theta_3, theta_4, theta_5 = Q
    d_1, L_1, L_2, L_3 = P
    return [
        dh.Row(0, sp.pi / 2, d_1, theta_1),
        dh.Row(L_1, 0, 0, theta_2),
        dh.Row(L_2, 0, 0, theta_3),
        dh.Row(0, sp.pi / 2, 0, theta_4),
        dh.Row(0, 0, L_3, theta_5),
    ]


# Room for rounding where an angle stands exactly at a limit, in radians.
AT_LIMIT = 1e-9


def within_limits(q: np.ndarray, limits: np.ndarray = JOINT_LIMITS) -> np.ndarray:
    """Whether every joint is within ``limits`` (5, 2), give or take full turns: (..., 5) to (...) of bool.

    NaN and infinite angles are not. Raises InputError unless the limits are finite, and none reversed.
    """
    return np.isfinite(into_limits(q, limits)).all(axis=-1)


def into_limits(q: np.ndarray, limits: np.ndarray = JOINT_LIMITS) -> np.ndarray:
    """The same angles, (..., 5), moved by full turns into ``limits``; NaN where no turn brings them there."""
    lower, upper = read_limits(limits, 5).T
    q = real(q, Q)
    warn_of_degrees(q, "q")
    with np.errstate(invalid="ignore"):
        above = np.mod(q - lower + AT_LIMIT, 2 * np.pi) - AT_LIMIT
    return np.where(above <= upper - lower + AT_LIMIT, np.clip(lower + above, lower, upper), np.nan)
