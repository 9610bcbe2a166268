"""Joint angles along samples of a path, on one continuous branch."""

from dataclasses import dataclass
from itertools import product
from math import ceil, floor, prod

import numpy as np
from numpy.typing import ArrayLike

from .. import arm, reading
from ..arm import AT_LIMIT, out_of_reach
from ..errors import InputError, JointLimitError, JumpError, LynxError, OutOfReachError, PathError

# A motion whose joints turn by more than this between two samples, in radians, cannot be told from a jump.
LARGEST_STEP = np.pi / 2

LARGEST_SEARCH = 10**9  # bytes

# So near to 0 (radians) is theta_3 at full stretch, where the two elbows are one: at distance e from it theta_3
# is about sqrt(8 e / reach), and rounding makes that 1e-7.
STRETCHED = 1e-6


@dataclass(frozen=True, repr=False)
class Followed:
    """Joint angles along a path of n samples, and where it cannot be followed.

    q : (n, 5) radians, not wrapped; NaN at each sample that fails.
    reached : (n,) bool; the links reach.
    allowed : (n,) bool; the joints are within their limits, without full turns taken off (True if not reached).
    continuous : (n,) bool; the sample is not a jump away from the one before.
    failure : PathError that says which sample fails first, why, and by how much; None if none does.
    """

    q: np.ndarray
    reached: np.ndarray
    allowed: np.ndarray
    continuous: np.ndarray
    failure: PathError | None

    def __repr__(self) -> str:
        return f"<{len(self.q)} samples: {self.failure or 'all followed'}>"

    @property
    def ok(self) -> bool:
        """Whether every sample is reached, within limits, and no jump away from the one before."""
        return self.failure is None


def follow(task: ArrayLike, geometry: arm.Geometry = arm.LYNX, limits: ArrayLike = arm.JOINT_LIMITS) -> Followed:
    """Joint angles that follow samples of a path continuously within joint limits, with the least travel.

    Joint travel is the sum of the Euclidean norms of the steps in joint space. A motion keeps the sign of theta_3,
    which is what it means to stay on an elbow (which of the two is the higher one changes where the wrist passes
    above the shoulder); it may change sign only at a sample at full stretch, where both elbows are one. Nor can
    it add a full turn on the way. Among all motions this leaves, first those with the fewest samples that fail
    are chosen, then the one of least travel: dynamic programming over elbows and full turns.

    Parameters
    ----------
    task : array, shape (n, 5)
        Task coordinates, as a ``Path`` gives them; samples such that no joint moves by 90 deg between two.
    limits : array, shape (5, 2)
        Lower and upper joint limits in radians.

    Returns
    -------
    followed : Followed
        Its q has ``task`` for task coordinates, give or take full turns. What happens between the samples is not
        asked. Raises InputError where ``task`` is not of shape (n, 5) or not finite, or limits make no sense.

    >>> from lynx_common.motion import line
    >>> along = line([0, 0.3, 0.2, 0, 0], [0, 0.6, 0.2, 0, 0])(np.linspace(0, 1, 31))
    >>> follow(along).failure.sample  # the first that the links do not reach
    19
    """
    task, limits = reading.finite(task, "task coordinates", None, 5), reading.limits(limits, 5)
    elbows = _elbows(task, geometry)
    reached = np.isfinite(elbows[:, 0, 0])
    turned = elbows + _turns(elbows[reached], limits)[:, None, None]  # (turns, n, elbow, joint)
    allowed = ~((_excess(turned, limits) > AT_LIMIT).any(axis=-1) & reached[:, None])
    turn, elbow = _least_travel(elbows, allowed)
    pick = (turn, np.arange(len(task)), elbow)
    q, allowed, continuous = turned[pick], allowed[pick], np.ones(len(task), bool)
    continuous[1:] = ~(np.abs(np.diff(q, axis=0)).max(axis=-1) > LARGEST_STEP)
    failure = _failure(task, q, (reached, allowed, continuous), geometry, limits)
    fails = ~(reached & allowed & continuous)
    return Followed(np.where(fails[:, None], np.nan, q), reached, allowed, continuous, failure)


def _elbows(task: np.ndarray, geometry: arm.Geometry) -> np.ndarray:
    """Joint angles (n, 2, 5), theta_3 >= 0 first, without full turns between samples."""
    rows = arm.joint_angles(task, geometry)
    with np.errstate(invalid="ignore"):
        rows = np.where(rows[:, :1, 2:3] >= 0, rows, rows[:, ::-1])
    # Both elbows run on from turn to turn together, as the direction of the wrist does, halfway between them.
    steps = np.rint(np.diff(rows.mean(axis=1), axis=0) / (2 * np.pi))
    rows[1:] -= 2 * np.pi * np.cumsum(np.nan_to_num(steps), axis=0)[:, None]
    return rows


def _turns(elbows: np.ndarray, limits: np.ndarray) -> np.ndarray:
    """Full turns, (k, 5) radians, that added to a whole motion may bring it within limits.

    ``elbows`` are the samples that are reached. One choice is enough for a joint where it keeps the limits all
    along, and for azimuth and roll, which do not depend on the elbow.
    """
    if not len(elbows):
        return np.zeros((1, 5))
    choices = []
    for joint, (lower, upper) in enumerate(limits + np.array([-AT_LIMIT, AT_LIMIT])):
        angles = elbows[..., joint, None]
        low, high = angles.min(), angles.max()
        first, last = ceil((lower - high) / (2 * np.pi)), floor((upper - low) / (2 * np.pi))
        if first > last:  # no sample is within limits: as near to them as may be
            first = last = round((lower + upper - low - high) / (4 * np.pi))
        _check_size(len(elbows) * (last - first + 1.0))
        turns = 2 * np.pi * np.array(sorted(range(first, last + 1), key=abs))
        outside = ((angles + turns < lower) | (angles + turns > upper)).sum(axis=(0, 1))
        choices.append(turns[[outside.argmin()]] if outside.min() == 0 or joint in (0, 4) else turns)
    _check_size(len(elbows) * prod(map(float, map(len, choices))))
    return np.array(list(product(*choices)))


def _check_size(postures: float) -> None:
    """InputError where so many postures, of two elbows and five joints each, would fill the memory."""
    if (size := 80 * postures) > LARGEST_SEARCH:
        need = f"{size / 1e9:.2g} GB would be needed; 1 GB is allowed"
        raise InputError(f"Limits so wide leave so many full turns to choose from that {need}.")


def _excess(q: np.ndarray, limits: np.ndarray) -> np.ndarray:
    """By how much joint angles (..., 5) exceed their limits, in radians; NaN at NaN."""
    lower, upper = limits.T
    return np.maximum(0, np.maximum(lower - q, q - upper))


def _least_travel(elbows: np.ndarray, allowed: np.ndarray) -> tuple[int, np.ndarray]:
    """Which full turns, and which elbow at each sample, (n,), fail least often, and of these travel least.

    ``elbows`` is (n, 2, 5), NaN where not reached; ``allowed`` (turns, n, 2). For each choice of turns the
    cheapest way to either elbow of a sample is the cheapest way to the sample before, and one step. It keeps to
    its elbow, but at full stretch, and beside a sample out of reach, where the motion is broken anyway.
    """
    steps = np.diff(elbows, axis=0)
    travel = np.linalg.norm(steps, axis=-1)  # (n - 1, 2)
    failure = 1 + np.nansum(travel)  # costs more than any travel
    step = np.where(np.abs(steps).max(axis=-1) > LARGEST_STEP, failure, np.nan_to_num(travel))
    may_change = (np.abs(elbows[:-1, 0, 2]) <= STRETCHED) | np.isnan(travel[:, 0])
    here = failure * ~allowed
    n, cost = len(elbows), here[:, :1].sum(axis=1)  # (turns, 2)
    came_from = np.broadcast_to([0, 1], (n, *cost.shape)).copy()
    for i in range(1, n):
        if may_change[i - 1]:
            came_from[i, cost[:, 0] < cost[:, 1]] = 0
            came_from[i, cost[:, 1] < cost[:, 0]] = 1
            cost = np.repeat(cost.min(axis=1, keepdims=True), 2, axis=1)
        cost = cost + step[i - 1] + here[:, i]
    turn, last = np.unravel_index(cost.argmin(), cost.shape)
    elbow = np.full(n, last)
    for i in range(n - 1, 0, -1):
        elbow[i - 1] = came_from[i, turn, elbow[i]]
    return int(turn), elbow


def _failure(
    task: np.ndarray,
    q: np.ndarray,
    holds: tuple[np.ndarray, np.ndarray, np.ndarray],
    geometry: arm.Geometry,
    limits: np.ndarray,
) -> PathError | None:
    """The first failure of joint angles q, (n, 5); it ``holds`` that they are reached, allowed, continuous."""
    for sample in map(int, np.flatnonzero(~np.all(holds, axis=0))):
        reached, allowed, _ = (x[sample] for x in holds)
        if not reached:
            cause: LynxError = OutOfReachError(*out_of_reach(task[sample], geometry))
        elif not allowed:
            joint = int(_excess(q[sample], limits).argmax())
            cause = JointLimitError(joint + 1, float(q[sample, joint]), *map(float, limits[joint]))
        else:
            step = np.abs(q[sample] - q[sample - 1])
            cause = JumpError(sample, int(step.argmax()) + 1, float(step.max()), LARGEST_STEP)
        return PathError(sample, len(task), cause)
    return None
