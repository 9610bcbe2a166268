"""The shortest way of the gripper around a circle in the arm's own plane: tangent, arc, tangent."""

import numpy as np

from .. import arm, reading
from ..errors import CollisionError, EndpointError, InputError, told_apart
from ..symbolic import TASK
from .following import follow
from .paths import ROOM, Path, line


def detour(
    start: np.ndarray,
    end: np.ndarray,
    centre: tuple[float, float],
    radius: float,
    margin: float = 0.0,
    turn: int = 0,
    *,
    geometry: arm.Geometry = arm.LYNX,
) -> Path:
    """The shortest way of the gripper that keeps ``margin`` from a circle in the arm's plane, at even speed.

    A straight line where that is clear; else tangent, arc, tangent. Pitch and roll change evenly along it. It is
    the gripper's way: whether the arm follows, and clears the obstacle with its links, is for ``follow`` and
    ``obstacles.clearance`` to say. Source: notebook B3, section 5.

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
        Its derivative in (r, z) has the length of the way as its norm, throughout. Raises EndpointError where the
        arm cannot take the start or the end (cause: OutOfReachError, JointLimitError) or they are nearer to
        the circle than the margin (CollisionError); InputError for two different azimuths, equal ends, or
        numbers that make no circle.
    """
    start, end = _ends(start, end, geometry)
    centre, keep = _circle(centre, radius, margin, turn)
    for name, task in (("start", start), ("end", end)):
        distance = float(np.hypot(*(task[1:3] - centre))) - radius
        if distance < margin - ROOM:
            raise EndpointError(name, CollisionError(distance, margin))
    straight = line(start, end)
    if _distance_from_origin(start[1:3] - centre, end[1:3] - centre) >= keep - ROOM:
        return straight
    if turn:
        return _around(straight, centre, keep, turn)
    left, right = (_around(straight, centre, keep, way) for way in (1, -1))
    longer = np.hypot(*left.derivative(0.0)[1:3]) - np.hypot(*right.derivative(0.0)[1:3])
    return right if longer > ROOM else left


def _around(straight: Path, centre: np.ndarray, radius: float, turn: int) -> Path:
    first, last = (straight(s)[1:3] - centre for s in (0.0, 1.0))
    angle = np.arctan2(first[1], first[0])
    sweep = turn * (np.arctan2(last[1], last[0]) - angle) % (2 * np.pi)
    to_touch, from_touch = (np.arccos(min(1, radius / np.hypot(*p))) for p in (first, last))
    tangent, arc = radius * np.tan(to_touch), radius * (sweep - to_touch - from_touch)
    length = tangent + arc + radius * np.tan(from_touch)

    def frame(s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Direction from the centre to the point of touch, the tangent there, and how far beyond it s is."""
        way = s * length - tangent
        on_arc = np.clip(way, 0, arc)
        at = angle + turn * (to_touch + on_arc / radius)
        c, s = np.cos(at), np.sin(at)
        return np.concatenate([c, s], axis=-1), turn * np.concatenate([-s, c], axis=-1), way - on_arc

    def point(s: np.ndarray) -> np.ndarray:
        outwards, along, beyond = frame(s)
        task = straight.point(s)
        task[..., 1:3] = centre + radius * outwards + beyond * along
        return task

    def slope(s: np.ndarray) -> np.ndarray:
        change = straight.slope(s)
        change[..., 1:3] = length * frame(s)[1]
        return change

    return Path(point, slope)


def _ends(start: np.ndarray, end: np.ndarray, geometry: arm.Geometry) -> list[np.ndarray]:
    ends = [reading.batch(task, TASK) for task in (start, end)]
    for name, task in zip(("start", "end"), ends, strict=True):
        if task.shape != (5,) or not np.isfinite(task).all():
            raise InputError(f"The {name} is five finite task coordinates; {task.tolist()} was given.")
        if failure := follow(task[None], geometry).failure:
            raise EndpointError(name, failure.cause)
    if abs(ends[0][0] - ends[1][0]) > ROOM:
        given = " and ".join(told_apart(*(np.rad2deg(task[0]) for task in ends), decimals=2))
        raise InputError(f"The way stays in one plane of the arm; the azimuths given are {given} deg.")
    if np.array_equal(*ends):
        raise InputError("The start and the end of the motion are the same: its length is zero.")
    return ends


def _circle(centre: tuple[float, float], radius: float, margin: float, turn: int) -> tuple[np.ndarray, float]:
    centre = reading.real(centre, "the centre of the circle")
    if centre.shape != (2,) or not np.isfinite(centre).all():
        raise InputError(f"The centre of the circle is (r, z), two finite numbers; {centre.tolist()} was given.")
    for name, value in (("radius", radius), ("margin", margin)):
        if not 0 <= reading.real(value, f"the {name}") < np.inf:
            raise InputError(f"The {name} is finite and not negative, in metres; {value} was given.")
    if turn not in (-1, 0, 1):
        raise InputError(f"The turn is 1, -1, or 0 for the shorter one; {turn!r} was given.")
    return centre, float(radius + margin)


def _distance_from_origin(first: np.ndarray, last: np.ndarray) -> float:
    """Distance of the origin from the segment between two points of the plane."""
    along = last - first
    squared = along @ along
    share = np.clip(-(first @ along) / squared, 0, 1) if squared > 0 else 0.0
    return float(np.hypot(*(first + share * along)))
