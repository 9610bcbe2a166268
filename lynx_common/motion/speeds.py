"""How fast the joints move along a path, and the shortest time in which they may."""

import numpy as np
import sympy as sp

from .. import arm, reading
from ..errors import InputError, JumpError
from ..symbolic import TASK, P, Q, compiled
from .following import LARGEST_STEP, STRETCHED


@compiled(Q, P)
def _task_jacobian() -> sp.Matrix:
    return arm.formulas.task_coordinates().jacobian(Q)


def joint_velocities(q: np.ndarray, task_dot: np.ndarray, geometry: arm.Geometry = arm.LYNX) -> np.ndarray:
    """Joint velocities that move the task coordinates at given velocities: the Jacobian of these, solved.

    Parameters
    ----------
    q : array, shape (..., 5)
        Joint angles in radians.
    task_dot : array, shape (..., 5)
        Velocities of azimuth, r, z, pitch and roll, per any unit: of a path's s, of tau, or of time.

    Returns
    -------
    q_dot : array, shape (..., 5)
        Radians per the same unit. NaN where the arm is straight or folded (to 1e-6 rad): there the velocities of
        the task coordinates alone do not determine it.

    Source: the Jacobian of ``arm.task_coordinates``, whose determinant is L_1 L_2 sin(theta_3), but for its sign.
    """
    J, task_dot = _task_jacobian(q, geometry), reading.batch(task_dot, TASK)
    bent = np.abs(np.sin(reading.batch(q, Q)[..., 2])) > STRETCHED  # det J = -L_1 L_2 sin(theta_3); False at NaN
    J = np.where(bent[..., None, None], J, np.eye(5))
    return np.where(bent[..., None], np.linalg.solve(J, task_dot[..., None])[..., 0], np.nan)


def duration(q: np.ndarray, speed_limits: np.ndarray, acceleration_limits: np.ndarray) -> float:
    """Shortest time in which joint angles sampled along a motion keep the limits of speed and acceleration.

    Speeds shrink as 1/T and accelerations as 1/T**2 when the motion is stretched to last T, so that one of the
    two decides. They are taken at the samples, by differences, and extrapolated to both ends; between samples
    nothing is known, and of what comes before and after nothing is asked. At full stretch theta_3 is known to 1e-7
    rad only, which shows in the accelerations where there are more than some 3,000 samples.

    Parameters
    ----------
    q : array, shape (n, 5), n >= 4
        Joint angles in radians at equal steps of time, the time scaling applied: ``follow(path(s)).q``.
    speed_limits, acceleration_limits : floats or arrays, shape (5,)
        Positive, rad/s and rad/s^2; infinite where there is no limit.

    Returns
    -------
    T : float
        Seconds; 0 where nothing moves. Raises InputError where q holds NaN (as where a path was not followed)
        or too few samples, or a limit is not positive; JumpError where a joint moves by more than 90 deg
        between two samples.
    """
    q = reading.batch(q, Q)
    if q.ndim != 2 or len(q) < 4:
        raise InputError(
            f"Four samples of joint angles or more are expected, (n, 5); the shape given is {q.shape}."
        )
    if bad := np.flatnonzero(~np.isfinite(q).all(axis=1)).tolist():
        raise InputError(f"Of the joint angles {len(bad)} samples are not finite, the first is number {bad[0]}.")
    _check_steps(q)
    speed = (len(q) - 1) * np.diff(q, axis=0)
    acceleration = (len(q) - 1) * np.diff(speed, axis=0)
    fastest = np.abs(np.vstack([speed, _ends(speed, 0.5)])).max(axis=0)
    hardest = np.abs(np.vstack([acceleration, _ends(acceleration, 1)])).max(axis=0)
    by_speed = fastest / _limit("speed", speed_limits)
    by_acceleration = hardest / _limit("acceleration", acceleration_limits)
    return float(max(by_speed.max(), np.sqrt(by_acceleration.max())))


def _check_steps(q: np.ndarray) -> None:
    """Raise JumpError where a joint angle of samples (n, 5) moves by more than LARGEST_STEP at once."""
    steps = np.abs(np.diff(q, axis=0))
    for sample in np.flatnonzero((steps > LARGEST_STEP).any(axis=1)) + 1:
        joint = int(steps[sample - 1].argmax())
        raise JumpError(int(sample), joint + 1, float(steps[sample - 1, joint]), LARGEST_STEP)


def _ends(values: np.ndarray, beyond: float) -> np.ndarray:
    """Values (n, 5) extrapolated beyond both ends, by this share of a step."""
    (first, second), (last, before) = values[:2], values[-1:-3:-1]
    return np.array([first + beyond * (first - second), last + beyond * (last - before)])


def _limit(name: str, values: np.ndarray) -> np.ndarray:
    values = reading.real(values, f"a limit of {name}")
    if values.shape not in ((), (5,)) or not np.all(values > 0):
        raise InputError(f"A limit of {name} is one positive number, or one a joint; {values.tolist()} was given.")
    return values
