"""The shortest way of the gripper around a circle in the arm's own plane: tangent, arc, tangent."""

import numpy as np
from numpy.typing import ArrayLike

from .. import arm, reading
from ..errors import CollisionError, EndpointError, InputError, told_apart
from ._following import follow
from ._paths import ROOM, Path, line


def detour(
    start: ArrayLike,
    end: ArrayLike,
    centre: ArrayLike,
    radius: float,
    margin: float = 0.0,
    turn: int = 0,
    *,
    geometry: arm.Geometry = arm.LYNX,
) -> Path:
    """The shortest way of the gripper that keeps ``margin`` from a circle in the arm's plane, at even speed.

    A straight line where that is clear; else tangent, arc, tangent. Pitch and roll change evenly along it. It is
    the gripper's way: whether the arm follows, and clears the obstacle with its links, is for ``follow`` and
    ``obstacles.clearance`` to say. Source: notebook B3, section 7.

    Parameters
    ----------
    start, end : arrays, shape (5,)
        Task coordinates, of one azimuth.
    centre : (r, z) in metres
    radius, margin : metres, not negative
    turn : 0, 1 or -1
        The side to pass: the shorter (1 at a tie); from the direction of r towards that of z; or the other.

    Returns
    -------
    path : Path
        Raises EndpointError where the arm cannot take the start or the end (cause: OutOfReachError,
        JointLimitError) or they are nearer to the circle than the margin (CollisionError); InputError for two
        different azimuths, equal ends, or numbers that make no circle.

    >>> under = detour([0, 0.2, 0.3, 0, 0], [0, 0.4, 0.3, 0, 0], centre=(0.3, 0.3), radius=0.05)
    >>> under(0.5).round(4)
    array([0.  , 0.3 , 0.25, 0.  , 0.  ])
    """
    start, end = _ends(start, end, geometry)
    centre = reading.finite(centre, "the centre of the circle (r, z)", 2)
    radius, margin = reading.number(radius, "radius", least=0), reading.number(margin, "margin", least=0)
    turn, keep = reading.whole(turn, "turn", -1, 1), radius + margin
    for name, task in (("start", start), ("end", end)):
        distance = float(np.hypot(*(task[1:3] - centre))) - radius
        if distance < margin - ROOM:
            raise EndpointError(name, CollisionError(distance, margin))
    straight = line(start, end)
    if _distance_from_origin(start[1:3] - centre, end[1:3] - centre) >= keep - ROOM:
        return straight
    if turn:
        return _around(straight, centre, keep, turn)[0]
    (left, its_length), (right, other_length) = (_around(straight, centre, keep, way) for way in (1, -1))
    return right if its_length - other_length > ROOM else left


def _around(straight: Path, centre: np.ndarray, radius: float, turn: int) -> tuple[Path, float]:
    """The way round on one side, at even speed in (r, z), and its length in metres."""
    first, last = (straight(s)[1:3] - centre for s in (0.0, 1.0))
    angle = np.arctan2(first[1], first[0])
    sweep = turn * (np.arctan2(last[1], last[0]) - angle) % (2 * np.pi)
    to_touch, from_touch = (np.arccos(min(1, radius / np.hypot(*p))) for p in (first, last))
    tangent, arc = radius * np.tan(to_touch), radius * (sweep - to_touch - from_touch)
    length = tangent + arc + radius * np.tan(from_touch)

    def point(s: np.ndarray) -> np.ndarray:
        way = s * length - tangent  # from the first point of touch
        on_arc = np.clip(way, 0, arc)
        at = angle + turn * (to_touch + on_arc / radius)
        outwards = np.concatenate([np.cos(at), np.sin(at)], axis=-1)
        along = turn * np.concatenate([-np.sin(at), np.cos(at)], axis=-1)
        task = straight.point(s)
        task[..., 1:3] = centre + radius * outwards + (way - on_arc) * along
        return task

    return Path(point), float(length)


def _ends(start: ArrayLike, end: ArrayLike, geometry: arm.Geometry) -> list[np.ndarray]:
    ends = [reading.finite(task, "task coordinates", 5) for task in (start, end)]
    for name, task in zip(("start", "end"), ends, strict=True):
        if failure := follow(task[None], geometry).failure:
            raise EndpointError(name, failure.cause)
    if abs(ends[0][0] - ends[1][0]) > ROOM:
        given = " and ".join(told_apart(*(np.rad2deg(task[0]) for task in ends), decimals=2))
        raise InputError(f"The way stays in one plane of the arm; the azimuths given are {given} deg.")
    if np.array_equal(ends[0], ends[1]):
        raise InputError("The start and the end of the motion are the same: its length is zero.")
    return ends


def _distance_from_origin(first: np.ndarray, last: np.ndarray) -> float:
    """Distance of the origin from the segment between two points of the plane."""
    along = last - first
    squared = along @ along
    share = np.clip(-(first @ along) / squared, 0, 1) if squared > 0 else 0.0
    return float(np.hypot(*(first + share * along)))
