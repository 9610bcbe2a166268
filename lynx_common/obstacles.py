"""Obstacles: how far the whole arm is from a sphere, and proofs of that between samples.

Metres and radians; joint angles are those of ``arm``.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from . import arm
from .errors import InputError
from .reading import real
from .symbolic import CHUNK

EPS = np.finfo(float).eps


@dataclass(frozen=True)
class Sphere:
    """A ball, by its centre (x, y, z) and its radius in metres, base frame.

    Raises InputError unless the centre is three finite numbers and the radius is finite and not negative.
    """

    centre: tuple[float, float, float]
    radius: float

    def __post_init__(self) -> None:
        centre, radius = real(self.centre, "the centre of a sphere"), real(self.radius, "its radius")
        if centre.shape != (3,) or not np.isfinite(centre).all():
            raise InputError(f"The centre of a sphere is three finite numbers; {self.centre!r} was given.")
        if radius.shape != () or not 0 <= radius < np.inf:
            raise InputError(f"The radius of a sphere is finite and not negative; {self.radius!r} was given.")
        object.__setattr__(self, "centre", tuple(map(float, centre)))
        object.__setattr__(self, "radius", float(radius))

    def distance(self, points: np.ndarray) -> np.ndarray:
        """Distance of points from the surface, negative inside: (..., 3) to (...)."""
        return np.linalg.norm(real(points, "points", 3) - self.centre, axis=-1) - self.radius


def clearance(
    q: np.ndarray, sphere: Sphere, geometry: arm.Geometry = arm.LYNX, link_radius: float = 0.0
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
    """
    if not 0 <= real(link_radius, "the radius of the links") < np.inf:
        raise InputError(f"The radius of the links is finite and not negative; {link_radius} was given.")
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
    """
    _, L_1, L_2, L_3 = geometry
    return float(np.linalg.norm([L_1 + L_2 + L_3, L_2 + L_3, L_3]))


@dataclass(frozen=True)
class Certificate:
    """What ``certify`` found.

    verdict : "certified", "refuted" or "undecided".
    bound : a lower bound of f that is proven all along, whatever the verdict.
    evaluations : how many values of f were asked for.
    witness : joint angles, (m,), where f is below the minimum; None unless refuted.
    """

    verdict: str
    bound: float
    evaluations: int
    witness: np.ndarray | None


def certify(
    f: Callable[[np.ndarray], np.ndarray],
    lipschitz: float,
    q: np.ndarray,
    minimum: float = 0.0,
    budget: int = 100_000,
    rounding: float = 1e-12,
) -> Certificate:
    """Prove that f >= minimum along a motion, or find a place where it is not.

    What is proven holds at *every* point of the straight segments in joint space between neighbouring samples. It
    says nothing of a path that leaves them, such as a straight line of the gripper. A piece of length l with the
    value f in its middle has the lower bound f - lipschitz l / 2. Where that falls short of the minimum, the
    piece is halved; each round evaluates all pieces that are left at once.

    Parameters
    ----------
    f : callable
        Takes joint angles (k, m), gives (k,).
    lipschitz : float
        |f(a) - f(b)| <= lipschitz |a - b| everywhere, Euclidean norm. The proof is worth as much as this number.
    q : array, shape (n, m), n >= 1
        Samples of the motion, in radians: [start, end], or what ``follow`` returns.
    budget : int
        Largest number of evaluations of f.
    rounding : float
        How far a value of f may be from the true one, in units of f. This, and what the rounding of q can
        change, is taken off each bound.

    Undecided where the budget is spent, or f touches the minimum within rounding. Raises InputError where q, a
    value of f, or one of the numbers is not real and finite, or ``lipschitz`` or ``rounding`` is negative. Source:
    the lower bound of Piyavskii and Shubert, by bisection.
    """
    q = _samples(q, lipschitz, minimum, rounding)
    start, change = (q, 0 * q) if len(q) == 1 else (q[:-1], np.diff(q, axis=0))
    reach = lipschitz * np.linalg.norm(change, axis=1)  # how far f may change along a segment
    slack = rounding + 8 * EPS * lipschitz * np.linalg.norm(q, axis=1).max()
    segment, middle, half = _first_pieces(len(start))
    verdict, proven, left, evaluations = "certified", np.inf, -np.inf, 0
    while len(segment):
        if evaluations + len(segment) > budget:
            return Certificate("undecided", float(min(proven, left)), evaluations, None)
        at = start[segment] + middle[:, None] * change[segment]
        (low, high), change_to_end = _values(f, at, slack), reach[segment] * half
        evaluations += len(at)
        bound = low - change_to_end
        if high.min() < minimum:
            return Certificate("refuted", float(min(proven, bound.min())), evaluations, at[high.argmin()])
        short = bound < minimum
        halve = short & (change_to_end > slack)  # below the slack halving does not help
        verdict = "undecided" if (short & ~halve).any() else verdict
        proven, left = (min(x, bound[part].min(initial=np.inf)) for x, part in ((proven, ~halve), (np.inf, halve)))
        segment, middle, half = (np.repeat(x[halve], 2) for x in (segment, middle, half / 2))
        middle += half * np.tile([-1, 1], len(half) // 2)
    return Certificate(verdict, float(proven), evaluations, None)


def _samples(q: np.ndarray, lipschitz: float, minimum: float, rounding: float) -> np.ndarray:
    q = real(q, "joint angles")
    if q.ndim != 2 or not q.size or not np.isfinite(q).all():
        raise InputError(f"Finite joint angles are expected, (n, m) with n >= 1; shape {q.shape} was given.")
    lipschitz, minimum, rounding = real([lipschitz, minimum, rounding], "Lipschitz constant, minimum and rounding")
    if not (0 <= lipschitz < np.inf and np.isfinite(minimum) and 0 <= rounding < np.inf):
        given = f"{lipschitz:g}, {minimum:g} and {rounding:g} were given"
        raise InputError(f"Lipschitz constant, minimum and rounding are finite, the first and last >= 0; {given}.")
    return q


def _first_pieces(segments: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """All samples, as pieces of no width, and all segments: number of the segment, middle, half width.

    The last two are shares of the segment: sums of powers of 1/2, so exact.
    """
    number = np.arange(segments)
    segment = np.concatenate([number, number[-1:], number])
    return segment, np.repeat([0, 1, 0.5], [segments, 1, segments]), np.repeat([0, 0.5], [segments + 1, segments])


def _values(f: Callable[[np.ndarray], np.ndarray], q: np.ndarray, slack: float) -> tuple[np.ndarray, np.ndarray]:
    """Between which values, (k,) each, f lies at q, (k, m)."""
    value = real(f(q), "the quantity").reshape(len(q))
    if (bad := ~np.isfinite(value)).any():
        raise InputError(f"The quantity is {value[bad][0]} at q = {q[bad][0].tolist()}.")
    doubt = slack + 4 * EPS * np.abs(value)
    return value - doubt, value + doubt


def _distance(points: np.ndarray, centre: tuple[float, float, float]) -> np.ndarray:
    """Distance (k,) of a point from the lines between joint positions, (3, 5, k)."""
    link = points[:, 1:] - points[:, :-1]
    towards = np.array(centre)[:, None, None] - points[:, :-1]
    squared = (link * link).sum(axis=0)
    share = np.divide((towards * link).sum(axis=0), squared, out=np.zeros_like(squared), where=squared > 0)
    away = towards - np.clip(share, 0, 1) * link
    return np.sqrt((away * away).sum(axis=0).min(axis=0))
