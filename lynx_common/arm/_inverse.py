"""Inverse kinematics: all joint angles that bring the gripper to given task coordinates, or to a given pose."""

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from ..errors import InputError
from ..reading import real
from ..symbolic import TASK, WRIST, XYZ, P, compiled
from . import formulas
from ._geometry import LYNX, Geometry

BRANCHES = (("front", "up"), ("front", "down"), ("back", "up"), ("back", "down"))

_both_elbows = compiled(TASK, P)(formulas.both_elbows)
_branches = compiled(XYZ, TASK[3:4], TASK[4:], P)(formulas.branches)


def joint_angles(task: ArrayLike, geometry: Geometry = LYNX) -> np.ndarray:
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

    >>> joint_angles([0, 0.5, 0.1, 0, 0])[0].round(4) + 0.0  # full stretch
    array([0.    , 0.    , 0.    , 1.5708, 0.    ])
    """
    return _both_elbows(task, geometry)


def inverse_kinematics(
    position: ArrayLike, pitch: ArrayLike | None = None, roll: ArrayLike = 0.0, *, geometry: Geometry = LYNX
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

    Source: report eqs. (1.14) to (1.24), for both shoulders; notebook A3, section 4. Joint limits
    are not applied (``within_limits``).

    >>> inverse_kinematics([0.3, 0, 0.3], pitch=0.0).shape
    (4, 5)
    """
    if pitch is None or isinstance(pitch, Geometry):
        raise InputError(
            "A position (x, y, z), a pitch and a roll are expected. Of a pose T, task_of_pose(T) gives the task "
            "coordinates, and joint_angles of these both elbows."
        )
    return _branches(position, _column(pitch, "pitch"), _column(roll, "roll"), geometry)


def _column(x: ArrayLike, name: str) -> np.ndarray | tuple[float]:
    """``x``, (...), with a last axis of length 1."""
    return (float(x),) if isinstance(x, float) else real(x, name)[..., None]


def out_of_reach(task: ArrayLike, geometry: Geometry) -> tuple[float, float, float]:
    """Distance of the wrist from the shoulder, the least and the largest that the links reach, for one task.

    >>> [round(length, 4) for length in out_of_reach([0, 0.6, 0.1, 0, 0], LYNX)]
    [0.5, 0.0, 0.4]
    """
    distance, nearest, farthest = _reach(task, geometry).tolist()
    return distance, nearest, farthest


@compiled(TASK, P)
def _reach() -> sp.Matrix:
    return sp.Matrix(formulas.reach()).xreplace(dict(zip(WRIST, formulas.wrist(), strict=True)))
