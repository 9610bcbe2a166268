"""What the arm reaches: sweeps over the ranges of its joints, voxels, and the exact section of its workspace.

*Limits* are an array (4, 2) in radians, lower and upper limit of theta_1 to theta_4, as in ``JOINT_LIMITS[:4]``;
theta_5 moves neither wrist nor gripper. A joint whose two limits are equal stands still. Points are given in the
plane of the arm: signed r along its azimuth, and z, in metres.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import prod

import numpy as np
from numpy.typing import ArrayLike

from . import arm, reading
from .arcs import Region
from .errors import InputError, told_apart
from .symbolic import CHUNK

POINTS = {"wrist": 3, "gripper": 4}  # rows of ``arm.joint_positions``

# Points this near to each other are one, in metres (or for an arm longer than 1 m, as a share of its length); a
# step may miss the end of a range by this share of itself.
TOLERANCE = 1e-9

LARGEST_GRID = 10**9  # bytes, one a voxel
LARGEST_SWEEP = 10**8  # postures


@dataclass(frozen=True)
class Sweep:
    """Distinct points (signed r, z), arrays (n,) in metres, and how many joint combinations they stand for.

    ``azimuth`` holds the values of theta_1, (m,) radians: the points in space are these points at each of them.
    """

    r: np.ndarray
    z: np.ndarray
    combinations: int
    azimuth: np.ndarray


@dataclass(frozen=True)
class Occupancy:
    """A grid of cubes of one edge, (nx, ny, nz) of bool: True where a point lies within.

    ``first`` is the centre of the first cube; the base axis runs through centres.
    """

    grid: np.ndarray
    first: np.ndarray
    edge: float

    @property
    def centres(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """x, y and z of the cubes' centres, shaped to broadcast over ``grid``."""
        return np.ix_(*(at + self.edge * np.arange(n) for at, n in zip(self.first, self.grid.shape, strict=True)))


def sweep(limits: ArrayLike, step: float, point: str = "wrist", *, geometry: arm.Geometry = arm.LYNX) -> Sweep:
    """All points that the wrist or the gripper takes as joints 1 to 4 go through their limits in equal steps.

    No more is computed than differs: theta_1 only turns the picture, and theta_4 does not move the wrist.
    Points are distinct to 1e-9 m, in the order of r and then z. Raises InputError where limits are reversed, or
    where ``step`` (radians) is not above 0, larger than a joint's range, or so small that more than 100 million
    postures would be computed.

    >>> found = sweep(np.deg2rad([[0, 0], [0, 90], [0, 0], [0, 90]]), step=np.pi / 4)
    >>> found.combinations, found.r.round(4), found.z.round(4)  # three places of the wrist, on a quarter circle
    (9, array([0.    , 0.2828, 0.4   ]), array([0.5   , 0.3828, 0.1   ]))
    """
    limits, row, step = reading.limits(limits, 4), _row(point), reading.number(step, "step", above=0)
    counts = [_count(joint, lower, upper, step) for joint, (lower, upper) in enumerate(limits, start=1)]
    needed = max(counts[0], prod(map(float, counts[1:3] if point == "wrist" else counts[1:])))
    if needed > LARGEST_SWEEP:
        most = f"{LARGEST_SWEEP:.0e} are allowed"
        raise InputError(f"With a step of {step:g} rad {needed:.2g} postures would be computed; {most}.")
    azimuth, *angles = (lower + step * np.arange(count) for (lower, _), count in zip(limits, counts, strict=True))
    if point == "wrist":
        angles[2] = angles[2][:1]
    unit = TOLERANCE * max(1, sum(geometry))
    found = []
    for postures in _combinations(angles):
        r, _, z = arm.joint_positions(postures, geometry)[:, row].T
        found.append(_distinct(np.rint([r / unit, z / unit])))
    r, z = unit * _distinct(np.concatenate(found, axis=1)) + 0.0  # no -0
    return Sweep(r, z, prod(counts), azimuth)


def _combinations(angles: list[np.ndarray]) -> Iterator[np.ndarray]:
    """All postures (n, 5) of theta_2 to theta_4, the others being 0; some values of theta_2 at a time."""
    at_once = max(1, 16 * CHUNK // prod(map(len, angles[1:])))
    for start in range(0, len(angles[0]), at_once):
        grid = np.meshgrid(0, angles[0][start : start + at_once], *angles[1:], 0, indexing="ij")
        yield np.stack(grid, axis=-1).reshape(-1, 5)


def _distinct(points: np.ndarray) -> np.ndarray:
    """Columns (r, z) of points (2, n), each once, in the order of r and then z."""
    r, z = points
    points = points[:, np.lexsort([z, r])]
    differs = (np.diff(points) != 0).any(axis=0)  # from the one before it
    return points[:, np.append(True, differs)]


def occupancy(points: Sweep, edge: float) -> Occupancy:
    """Which cubes of the given edge (metres) hold a point of a sweep, turned to each of its azimuths.

    Raises InputError where the edge is not above 0, or so small that the grid would take more than 1 GB.

    >>> four = sweep(np.deg2rad([[0, 270], [0, 0], [0, 0], [0, 0]]), step=np.pi / 2)  # one point, turned
    >>> int(occupancy(four, edge=0.1).grid.sum())
    4
    """
    edge = reading.number(edge, "edge of a cube", above=0)
    farthest, low, high = np.abs(points.r).max(), points.z.min(), points.z.max()
    if edge < 1e-6 * max(farthest, high - low):
        raise InputError(f"An edge of {edge} m is less than a millionth of the workspace.")
    half, tall = round(farthest / edge), round((high - low) / edge) + 1
    wide = 2 * half + 1
    if (size := wide * wide * tall) > LARGEST_GRID:
        raise InputError(f"With an edge of {edge} m the grid would take {size / 1e9:.1f} GB; 1 GB is allowed.")
    grid = np.zeros((wide, wide, tall), bool)
    layer = _rounded((points.z - low) / edge)
    for azimuth in points.azimuth:
        x, y = (_rounded(points.r * along / edge) for along in (np.cos(azimuth), np.sin(azimuth)))
        grid.reshape(-1)[((half + x) * wide + half + y) * tall + layer] = True
    return Occupancy(grid, np.array([-half * edge, -half * edge, low]), edge)


def section(limits: ArrayLike, point: str = "wrist", *, geometry: arm.Geometry = arm.LYNX) -> Region:
    """The exact region of (signed r, z) that wrist or gripper reaches with theta_2, theta_3 within their limits.

    theta_1 does not matter to it, nor theta_4 to the wrist. The gripper's section is known where theta_2 and
    theta_3 can move and theta_4 turns fully; InputError otherwise.

    Source: notebook A2, sections 2 and 4.

    >>> ring = section(np.deg2rad([[0, 0], [0, 360], [0, 180], [0, 0]]))  # all that the two links reach
    >>> round(ring.area / np.pi, 6)
    0.16
    """
    limits, _ = reading.limits(limits, 4), _row(point)
    region = Region(_circles(limits, geometry), lambda points: _wrist_reaches(points, limits, geometry))
    if point == "wrist":
        return region
    if not np.ptp(limits[1:3], axis=1).all():
        raise InputError("The gripper's section is known where joints 2 and 3 can move; one of them stands still.")
    if np.ptp(limits[3]) < 2 * np.pi - TOLERANCE:
        raise InputError("The gripper's section is known for a theta_4 that turns fully; its limits are less.")
    return region.around(geometry.L_3)


def _circles(limits: np.ndarray, geometry: arm.Geometry) -> np.ndarray:
    """Circles that hold the boundary: theta_3 at a limit, 0 or 180 deg; theta_2 at a limit."""
    d_1, L_1, L_2, _ = geometry
    stretch = np.sqrt(L_1**2 + L_2**2 + 2 * L_1 * L_2 * np.cos(limits[2]))
    about_shoulder = [(0, d_1, radius) for radius in (*stretch, L_1 + L_2, abs(L_1 - L_2))]
    about_elbow = [(L_1 * np.cos(q), d_1 + L_1 * np.sin(q), L_2) for q in limits[1]]
    return np.array(about_shoulder + about_elbow)


def _wrist_reaches(points: np.ndarray, limits: np.ndarray, geometry: arm.Geometry) -> np.ndarray:
    d_1, L_1, L_2, _ = geometry
    task = np.zeros((*points.shape[:-1], 5))
    task[..., 1:3] = points
    q = arm.joint_angles(task, arm.Geometry(d_1, L_1, L_2, 0))  # a gripper of no length is at the wrist
    within = np.pi * np.array([[-2, 2]] * 5)
    within[1:3] = limits[1:3]
    return np.any(arm.within_limits(q, within), axis=-1)


def _rounded(x: np.ndarray) -> np.ndarray:
    return np.rint(x).astype(np.intp)


def _row(point: str) -> int:
    if point not in POINTS:
        raise InputError(f"The point is one of {', '.join(POINTS)}; {point!r} was given.")
    return POINTS[point]


def _count(joint: int, lower: float, upper: float, step: float) -> int:
    """How many angles there are from the lower limit up to the upper one; the last may fall short of it."""
    if 0 < upper - lower < step * (1 - TOLERANCE):
        given, most = told_apart(step, upper - lower)
        raise InputError(f"A step of {given} rad is larger than the range of joint {joint}, {most} rad.")
    return int((upper - lower) / step + TOLERANCE) + 1
