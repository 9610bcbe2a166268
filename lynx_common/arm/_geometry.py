"""The arm itself: its lengths, its joint limits and its DH table."""

import os
from dataclasses import astuple, dataclass

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from .. import dh, reading
from ..errors import GeometryError
from ..symbolic import P, Q


@dataclass(frozen=True)
class Geometry(reading.Record):
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
        for name in ("d_1", "L_1", "L_2", "L_3"):
            value = reading.length(name, getattr(self, name), "metres", zero=name in ("d_1", "L_3"))
            object.__setattr__(self, name, value)
        object.__setattr__(self, "values", astuple(self))


def geometry_of(words: str) -> Geometry:
    """The arm with some lengths given in words, metres; GeometryError for a name or a length that is none.

    >>> geometry_of("L_1=0.25 L_3=0.12")
    Geometry(d_1=0.1, L_1=0.25, L_2=0.2, L_3=0.12)
    """
    lengths: dict[str, float] = {}
    for name, _, text in (word.partition("=") for word in words.replace(",", " ").split()):
        if name in lengths:
            raise GeometryError(name, f"{lengths[name]} and {text}", "each length is given once")
        try:
            lengths[name] = float(text)
        except ValueError:
            raise GeometryError(name, text or "not given", "lengths are written as in L_1=0.25 L_3=0.12") from None
    return Geometry(**lengths)


# The arm of the course, or the one of `make figures ARM="..."`, which hands it over here.
LYNX = geometry_of(os.environ.get("LYNX_ARM", ""))

# Lower and upper limit of each joint, (5, 2), radians. An assumption: the report gives only the ranges that
# it sweeps in section 1.2. Within these lie all of its own tasks; the wrist's are +-150 deg about straight.
JOINT_LIMITS = np.pi / 180 * np.array([[-180, 180], [0, 180], [-150, 150], [-60, 240], [-180, 180]])
JOINT_LIMITS.setflags(write=False)

# The same if each joint is a hobby servo that turns 90 deg to either side of the angle at which it was mounted. An
# assumption, too: mounted with the arm straight up, at theta = (0, 90, 0, 90, 0) deg. Mounted at other angles the
# limits move with them (notebook B1, section 8).
SERVO_LIMITS = np.pi / 180 * np.array([[-90, 90], [0, 180], [-90, 90], [0, 180], [-90, 90]])
SERVO_LIMITS.setflags(write=False)


def dh_table() -> list[dh.Row]:
    """The five rows of the standard (distal) DH table in the symbols Q and P; report Table 1.2.

    >>> print(dh_table()[0])
    Row(a=0, alpha=pi/2, d=d_1, theta=theta_1)
    """
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


def within_limits(q: ArrayLike, limits: ArrayLike = JOINT_LIMITS) -> np.ndarray:
    """Whether every joint is within ``limits`` (5, 2), give or take full turns: (..., 5) to (...) of bool.

    NaN and infinite angles are not. Raises InputError unless the limits are finite, and none reversed.

    >>> within_limits([[0, 1.0, 0, 1.5, 0], [0, -1.0, 0, 1.5, 0]])  # theta_2 is from 0 to 180 deg
    array([ True, False])
    """
    return np.isfinite(into_limits(q, limits)).all(axis=-1)


def into_limits(q: ArrayLike, limits: ArrayLike = JOINT_LIMITS) -> np.ndarray:
    """The same angles, (..., 5), moved by full turns into ``limits``; NaN where no turn brings them there.

    >>> into_limits([0, 1.0 + 2 * np.pi, 0, 1.5, 0])
    array([0. , 1. , 0. , 1.5, 0. ])
    """
    lower, upper = reading.limits(limits, 5).T
    q = reading.batch(q, Q)
    reading.warn_of_degrees(q, "q")
    with np.errstate(invalid="ignore"):
        above = np.mod(q - lower + AT_LIMIT, 2 * np.pi) - AT_LIMIT
    return np.where(above <= upper - lower + AT_LIMIT, np.clip(lower + above, lower, upper), np.nan)
