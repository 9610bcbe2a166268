"""Inverse kinematics: all joint angles that bring the gripper to given task coordinates, or to a given pose."""

from collections.abc import Callable
from functools import cache

import numpy as np
import sympy as sp

from .. import reading
from ..symbolic import CHUNK, TASK, WRIST, P, numeric, real
from .geometry import LYNX, Geometry

BRANCHES = (("front", "up"), ("front", "down"), ("back", "up"), ("back", "down"))

# The wrist may miss the reach of the links by this share of their length: a target at full stretch is reached
# even where rounding puts it a hair outside. The gripper then misses it by no more than that.
REACH_TOLERANCE = 1e-9

PART = 8 * CHUNK  # targets worked through at a time, to stay in the processor's cache
XYZ = sp.symbols("x y z", real=True)
SIGMA = sp.symbols("sigma", real=True)  # sign of theta_3


def joint_angles(task: np.ndarray, geometry: Geometry = LYNX) -> np.ndarray:
    r"""Joint angles that reach given task coordinates, with the elbow up and with the elbow down.

    With the wrist at :math:`(r_w, h)` from the shoulder, in the arm's own plane, the law of cosines gives

    .. math:: \cos\theta_3 = \frac{r_w^2 + h^2 - L_1^2 - L_2^2}{2 L_1 L_2}

    and the sign of theta_3 is free. Nothing is wrapped, so that ``task_coordinates`` of the result is ``task``
    itself, and angles run on where the gripper passes over the base axis.

    Parameters
    ----------
    task : array, shape (..., 5)
        azimuth, signed r, z, pitch, roll; metres and radians (see ``task_coordinates``).

    Returns
    -------
    q : array, shape (..., 2, 5)
        Elbow up, elbow down: up is the one whose elbow is higher. Both rows are equal at full stretch. Rows
        of a target that the links cannot reach are NaN.

    Source: report eqs. (1.14) to (1.24), with their errors mended; notebook A3, sections 1 to 3.
    """
    return _on_reachable(_both_elbows(), real(task, TASK), geometry)


def inverse_kinematics(
    position: np.ndarray, pitch: np.ndarray, roll: np.ndarray = 0.0, geometry: Geometry = LYNX
) -> np.ndarray:
    """Joint angles of all four branches that reach a position, pitch and roll.

    The shoulder may face the target (*front*) or turn its back on it (*back*); either way the elbow may be up
    or down. Pitch and roll are those of the front branches. On the base axis, front takes azimuth 0.

    Parameters
    ----------
    position : array, shape (..., 3)
        Gripper position in metres, base frame.
    pitch, roll : arrays, shape (...)
        Angles in radians. The leading axes of all three broadcast.

    Returns
    -------
    q : array, shape (..., 4, 5)
        Joint angles in (-pi, pi], one row per entry of ``BRANCHES``; NaN where the links do not reach.

    Source: report eqs. (1.14) to (1.24), for both shoulders; notebook A3, section 7. Joint limits
    are not applied (``within_limits``).
    """
    position, pitch, roll = real(position, XYZ), reading.real(pitch, "pitch"), reading.real(roll, "roll")
    batch = np.broadcast_shapes(position.shape[:-1], pitch.shape, roll.shape)
    target = [np.broadcast_to(position, (*batch, 3)).reshape(-1, 3)]
    target += [np.broadcast_to(x, batch).ravel() for x in (pitch, roll)]
    q = np.empty((len(target[0]), 4, 5))
    for start in range(0, len(q), PART):
        part = slice(start, start + PART)
        q[part] = _on_reachable(_branches(), front(*(x[part] for x in target)), geometry)
    return q.reshape(*batch, 4, 5)


def front(position: np.ndarray, pitch: np.ndarray, roll: np.ndarray) -> np.ndarray:
    """Task coordinates, (..., 5), of the front branches; azimuth 0 on the base axis."""
    x, y, z = np.moveaxis(position, -1, 0)
    r = np.sqrt(x * x + y * y)
    azimuth = np.where(r == 0, 0.0, np.arctan2(y, x))
    return np.stack(np.broadcast_arrays(azimuth, r, z, pitch, roll), axis=-1)


def _on_reachable(rows: Callable, task: np.ndarray, geometry: Geometry) -> np.ndarray:
    """``rows`` of joint angles for task coordinates (..., 5), elbow up first; NaN where the links do not reach."""
    at = wrist()(task, geometry)
    distance, nearest, farthest = reach(at, geometry)
    slack = REACH_TOLERANCE * farthest
    with np.errstate(invalid="ignore"):
        reached = (distance >= nearest - slack) & (distance <= farthest + slack)
        up = np.where(at[..., 0] >= 0, -1.0, 1.0)  # the sign of theta_3 with which the elbow is the higher one
    return rows(task, at, np.where(reached, up, np.nan)[..., None], geometry)  # `numeric` passes NaN on


def reach(wrist: np.ndarray, geometry: Geometry) -> tuple[np.ndarray, float, float]:
    """Distance of the wrist from the shoulder, and the least and the largest that the links reach."""
    _, L_1, L_2, _ = geometry
    r_wrist, h = wrist[..., 0], wrist[..., 1]
    return np.sqrt(r_wrist * r_wrist + h * h), abs(L_1 - L_2), L_1 + L_2


@cache
def wrist() -> Callable:
    """From task coordinates to (r_wrist, h); report eqs. (1.17) and (1.18)."""
    (_, r, z, pitch, _), (d_1, _, _, L_3) = TASK, P
    return numeric(sp.Matrix([r - L_3 * sp.cos(pitch), z - d_1 - L_3 * sp.sin(pitch)]), TASK, P)


@cache
def _both_elbows() -> Callable:
    return numeric(sp.Matrix.vstack(*_elbows()), TASK, WRIST, (SIGMA,), P)


@cache
def _branches() -> Callable:
    """The four rows of BRANCHES, wrapped into (-pi, pi]."""
    facing = _elbows()
    # The shoulder turned half round makes the same shape, seen from behind: what was up stays up.
    back = [
        sp.Matrix([[q_1 + sp.pi, sp.pi - q_2, -q_3, sp.pi - q_4, q_5 + sp.pi]])
        for q_1, q_2, q_3, q_4, q_5 in facing
    ]
    rows = sp.Matrix.vstack(*facing, *back)
    wrapped = rows.applyfunc(lambda q: q - 2 * sp.pi * sp.ceiling((q - sp.pi) / (2 * sp.pi), evaluate=False))
    return numeric(wrapped, TASK, WRIST, (SIGMA,), P)


def _elbows() -> list[sp.Matrix]:
    """Rows of joint angles, for theta_3 of the sign sigma and of the other sign."""
    return [_elbow().subs(SIGMA, sign).T for sign in (SIGMA, -SIGMA)]


def _elbow() -> sp.Matrix:
    """The five joint angles for theta_3 of the sign sigma; report eqs. (1.19) to (1.24)."""
    (azimuth, _, _, pitch, roll), (r_wrist, h), (_, L_1, L_2, _) = TASK, WRIST, P
    D = (r_wrist**2 + h**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)
    D = sp.Max(-1, sp.Min(1, D))  # beyond lies only what REACH_TOLERANCE lets pass
    S = sp.sqrt((1 - D) * (1 + D))
    theta_3 = SIGMA * sp.atan2(S, D)
    theta_2 = sp.atan2(h, r_wrist) - SIGMA * sp.atan2(L_2 * S, L_1 + L_2 * D)
    return sp.Matrix([azimuth, theta_2, theta_3, pitch + sp.pi / 2 - theta_2 - theta_3, roll])
