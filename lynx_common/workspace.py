"""What the arm reaches: sweeps over the ranges of its joints, voxels, and the exact section of its workspace.

*Limits* are an array (4, 2) in radians, lower and upper limit of theta_1 to theta_4, as in ``JOINT_LIMITS[:4]``;
theta_5 moves neither wrist nor gripper. A joint whose two limits are equal stands still. Points are given in the
plane of the arm: signed r along its azimuth, and z, in metres.
"""

from dataclasses import dataclass
from math import prod

import numpy as np

from . import arm
from .arcs import Region
from .errors import InputError, told_apart
from .reading import limits as read_limits
from .reading import real
from .symbolic import CHUNK

POINTS = {"wrist": 3, "gripper": 4}  # rows of ``arm.joint_positions``

# Points this near to each other are one, in metres (or for an arm longer than 1 m, as a share of its length).
# So there are fewer PLACES than this in a row, and two coordinates fit into one integer.
SAME, PLACES = 1e-9, 2**32

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


def sweep(limits: np.ndarray, step: float, point: str = "wrist", *, geometry: arm.Geometry = arm.LYNX) -> Sweep:
    """All points that the wrist or the gripper takes as joints 1 to 4 go through their limits in equal steps.

    No more is computed than differs: theta_1 only turns the picture, and theta_4 does not move the wrist.
    Points are distinct to 1e-9 m. Raises InputError where limits are reversed, or where ``step`` (radians) is not
    positive, larger than a joint's range, or so small that more than 100 million postures would be computed.
    """
    limits, row, unit = read_limits(limits, 4), _row(point), SAME * max(1, sum(geometry))
    counts = [_count(joint, *pair, step) for joint, pair in enumerate(limits, start=1)]
    needed = max(counts[0], prod(map(float, counts[1:3] if point == "wrist" else counts[1:])))
    if needed > LARGEST_SWEEP:
        most = f"{LARGEST_SWEEP:.0e} are allowed"
        raise InputError(f"With a step of {step:g} rad {needed:.2g} postures would be computed; {most}.")
    azimuth, *values = (low + step * np.arange(count) for (low, _), count in zip(limits, counts, strict=True))
    combinations = prod(counts)
    if point == "wrist":
        values[2] = values[2][:1]
    at_once, found = max(1, 16 * CHUNK // prod(map(len, values[1:]))), []
    for start in range(0, len(values[0]), at_once):
        postures = np.meshgrid(0, values[0][start : start + at_once], *values[1:], 0, indexing="ij")
        r, _, z = arm.joint_positions(np.stack(postures, axis=-1).reshape(-1, 5), geometry)[:, row].T
        found.append(np.unique(_rounded(r / unit) * PLACES + _rounded(z / unit)))
    distinct = np.unique(np.concatenate(found))
    r = (distinct + PLACES // 2) // PLACES
    return Sweep(unit * r, unit * (distinct - r * PLACES), combinations, azimuth)


def occupancy(points: Sweep, edge: float) -> Occupancy:
    """Which cubes of the given edge (metres) hold a point of a sweep, turned to each of its azimuths.

    Raises InputError where the edge is not positive, or so small that the grid would take more than 1 GB.
    """
    if real(edge, "the edge of a voxel").shape or not 0 < edge < np.inf:
        raise InputError(f"The edge of a voxel is a positive length in metres; {edge} was given.")
    x, low, high = np.abs(points.r).max(), points.z.min(), points.z.max()
    if edge < 1e-6 * max(x, high - low):
        raise InputError(f"An edge of {edge} m is less than a millionth of the workspace.")
    half, tall = round(x / edge), round((high - low) / edge) + 1
    wide = 2 * half + 1
    if (size := wide * wide * tall) > LARGEST_GRID:
        raise InputError(f"With an edge of {edge} m the grid would take {size / 1e9:.1f} GB; 1 GB is allowed.")
    grid = np.zeros((wide, wide, tall), bool)
    layer = _rounded((points.z - low) / edge)
    for azimuth in points.azimuth:
        x, y = (_rounded(points.r * along / edge) for along in (np.cos(azimuth), np.sin(azimuth)))
        grid.reshape(-1)[((half + x) * wide + half + y) * tall + layer] = True
    return Occupancy(grid, np.array([-half * edge, -half * edge, low]), edge)


def section(limits: np.ndarray, point: str = "wrist", *, geometry: arm.Geometry = arm.LYNX) -> Region:
    """The exact region of (signed r, z) that wrist or gripper reaches with theta_2, theta_3 within their limits.

    theta_1 does not matter to it, nor theta_4 to the wrist. The gripper's section is known where theta_2 and
    theta_3 can move and theta_4 turns fully; InputError otherwise.

    Source: notebook A2, sections 4 and 7.
    """
    limits, _ = read_limits(limits, 4), _row(point)
    region = Region(_circles(limits, geometry), lambda points: _wrist_reaches(points, limits, geometry))
    if point == "wrist":
        return region
    if not np.ptp(limits[1:3], axis=1).all():
        raise InputError("The gripper's section is known where joints 2 and 3 can move; one of them stands still.")
    if np.ptp(limits[3]) < 2 * np.pi - SAME:
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
    return arm.within_limits(q, within).any(axis=-1)


def _rounded(x: np.ndarray) -> np.ndarray:
    return np.rint(x).astype(np.intp)


def _row(point: str) -> int:
    if point not in POINTS:
        raise InputError(f"The point is one of {', '.join(POINTS)}; {point!r} was given.")
    return POINTS[point]


def _count(joint: int, lower: float, upper: float, step: float) -> int:
    """How many angles there are from the lower limit up to the upper one; the last may fall short of it."""
    if real(step, "the step").shape or not 0 < step < np.inf:
        raise InputError(f"The step is a positive angle in radians; {step} was given.")
    if 0 < upper - lower < step * (1 - SAME):
        given, most = told_apart(step, upper - lower)
        raise InputError(f"A step of {given} rad is larger than the range of joint {joint}, {most} rad.")
    return int((upper - lower) / step + SAME) + 1
