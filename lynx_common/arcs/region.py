"""Plane regions whose boundary lies on circles."""

from collections.abc import Callable
from functools import cached_property

import numpy as np

from ..errors import InputError
from ..reading import real
from .circles import arcs_of, beside, cuts_of, distinct, on

LARGEST_BOUNDARY = 10**7  # points


class Region:
    """A plane region bounded by arcs of given circles.

    circles : (n, 3), rows (x, y, radius); they hold all of the boundary, and may hold more
    contains : points (..., 2) to (...,) of bool

    ``a | b`` is the union and ``a & b`` the intersection of two regions. Lengths are in one unit, the caller's.
    """

    def __init__(self, circles: np.ndarray, contains: Callable[[np.ndarray], np.ndarray]):
        circles = real(circles, "circles")
        if circles.shape[1:] != (3,) or not np.isfinite(circles).all() or (circles[:, 2] < 0).any():
            raise InputError("Circles are expected as finite rows x, y, radius, the radius not negative.")
        self.circles, self.contains = circles, contains

    def __or__(self, other: "Region") -> "Region":
        return _joined(self, other, np.logical_or)

    def __and__(self, other: "Region") -> "Region":
        return _joined(self, other, np.logical_and)

    def mirror(self) -> "Region":
        """The region seen in a mirror along the second axis: x becomes -x."""
        return Region(self.circles * [-1, 1, 1], lambda points: self.contains(points * np.array([-1, 1])))

    def around(self, radius: float) -> "Region":
        """All points at exactly the distance ``radius`` from some point of this region, which is one piece.

        This is what the end of a link reaches that can be turned fully about every point of the region.
        """
        x, y, rho, _, _ = self.arcs.T
        corners = self.ends[abs(self.arcs[:, 4]) < 2 * np.pi].reshape(-1, 2)
        circles = [
            np.insert(corners, 2, radius, axis=1),
            np.c_[x, y, rho + radius],
            np.c_[x, y, abs(rho - radius)],
        ]

        def contains(points: np.ndarray) -> np.ndarray:
            nearest, farthest = self.distances(points)
            return (self.contains(points) | (nearest <= radius)) & (farthest >= radius)

        return Region(np.vstack(circles), contains)

    @cached_property
    def arcs(self) -> np.ndarray:
        """The boundary: (n, 5), rows x, y, radius, start, sweep (radians), with the inside on the left."""
        circles = distinct(self.circles)
        if not len(circles):
            return np.empty((0, 5))
        cuts = [cuts_of(circles, i) for i in range(len(circles))]
        pieces = [len(c) for c in cuts]
        x, y, rho = np.repeat(circles, pieces, axis=0).T
        middle = np.concatenate([c + np.diff(c, append=c[0] + 2 * np.pi) / 2 for c in cuts])
        outwards = np.stack([np.cos(middle), np.sin(middle)], axis=-1)
        points = np.stack([x, y], axis=-1) + rho[:, None] * outwards
        step = beside(circles, points, rho)[:, None] * outwards
        inner, outer = np.asarray(self.contains(np.stack([points - step, points + step])), int)
        turns = np.split(inner - outer, np.cumsum(pieces)[:-1])  # +1: the inside is within the circle
        arcs = [arc for one in zip(circles, cuts, turns, strict=True) for arc in arcs_of(*one)]
        return np.reshape(arcs, (-1, 5))

    @property
    def ends(self) -> np.ndarray:
        """First and last point of each arc, (n, 2, 2)."""
        return on(self.arcs, self.arcs[:, 3:4] + self.arcs[:, 4:] * [0, 1])

    @property
    def area(self) -> float:
        """The integral of x dy along the boundary."""
        x, _, rho, t = self._measured()
        return float((rho * (x * np.sin(t) + rho * (t + np.sin(t) * np.cos(t)) / 2) @ [-1, 1]).sum())

    @property
    def perimeter(self) -> float:
        """Length of the whole boundary, that of holes included."""
        return float((self.arcs[:, 2] * abs(self.arcs[:, 4])).sum())

    @property
    def volume(self) -> float:
        """Volume that the region sweeps in a half turn about the line x = 0: pi |x| integrated over it.

        A region that is its own mirror image sweeps the solid of revolution, each point of it once.
        """
        x, _, rho, t = self._measured()
        sin, cos = np.sin(t), np.cos(t)
        cubic = x**2 * sin + x * rho * (t + sin * cos) + rho**2 * (sin - sin**3 / 3)
        side = np.sign(x + rho * np.cos(t.mean(axis=1, keepdims=True)))
        return float(np.pi / 2 * (side * rho * cubic @ [-1, 1]).sum())

    def distances(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Distance from points (..., 2) to the nearest and to the farthest point of the boundary: two of (...)."""
        points = real(points, "points of the plane", 2)[..., None, :]
        away = points - self.arcs[:, :2]
        rho, d = self.arcs[:, 2], np.hypot(away[..., 0], away[..., 1])
        to_ends = np.linalg.norm(points[..., None, :] - self.ends, axis=-1)
        angle = np.arctan2(away[..., 1], away[..., 0])
        near = np.where(self._faces(angle), abs(d - rho), to_ends.min(axis=-1))
        far = np.where(self._faces(angle + np.pi), d + rho, to_ends.max(axis=-1))
        return near.min(axis=-1, initial=np.inf), far.max(axis=-1, initial=-np.inf)

    def boundary(self, step: float = np.pi / 180) -> list[np.ndarray]:
        """Closed polylines, (n, 2), along the boundary, for drawing; at most ``step`` radians between points.

        Raises InputError where the step is not positive, or would give more than 10 million points.
        """
        if real(step, "the step").shape or not 0 < step < np.inf:
            raise InputError(f"The step is a positive angle in radians; {step} was given.")
        if (points := float(np.abs(self.arcs[:, 4]).sum()) / step) > LARGEST_BOUNDARY:
            raise InputError(
                f"A step of {step:g} rad would give {points:.2g} points; {LARGEST_BOUNDARY:.0e} are allowed."
            )
        arcs, ends, loops = list(self.arcs), list(self.ends), []
        while arcs:
            line, (first, place) = [arcs.pop(0)], ends.pop(0)
            while arcs:
                gaps = np.abs(np.array(ends)[:, 0] - place).max(axis=1)
                if gaps.min() >= np.abs(first - place).max():
                    break
                line.append(arcs.pop(gaps.argmin()))
                place = ends.pop(gaps.argmin())[1]
            steps = [np.linspace(0, 1, 2 + int(abs(arc[4]) / step)) for arc in line]
            points = [on(a, a[3] + a[4] * share) for a, share in zip(line, steps, strict=True)]
            loops.append(np.vstack([*points, first]))
        return loops

    def _measured(self) -> tuple[np.ndarray, ...]:
        """x, y, radius as columns, and both end angles, (n, 2), of the arcs, cut where they cross x = 0."""
        x, y, rho, start, sweep = self.arcs.T
        with np.errstate(invalid="ignore", divide="ignore"):
            crossing = np.arccos(-x / rho)
        cuts = [start]
        for at in (crossing, -crossing):
            share = np.mod((at - start) * np.sign(sweep), 2 * np.pi) / abs(sweep)
            cuts.append(start + sweep * np.where(share < 1, share, 0))
        cuts = np.sort(np.stack([*cuts, start + sweep], axis=-1) * np.sign(sweep)[:, None], axis=-1)
        t = np.stack([cuts[:, :-1], cuts[:, 1:]], axis=-1) * np.sign(sweep)[:, None, None]
        return *(np.repeat(v, 3)[:, None] for v in (x, y, rho)), t.reshape(-1, 2)

    def _faces(self, angle: np.ndarray) -> np.ndarray:
        start, sweep = self.arcs[:, 3], self.arcs[:, 4]
        return np.mod((angle - start) * np.sign(sweep), 2 * np.pi) <= abs(sweep)


def annulus(x: float, y: float, inner: float, outer: float) -> Region:
    """Points whose distance from (x, y) lies between ``inner`` and ``outer``."""
    x, y, inner, outer = real([x, y, inner, outer], "centre and radii of an annulus")
    if not (np.isfinite([x, y]).all() and 0 <= inner <= outer < np.inf):
        given = f"({x}, {y}), {inner} and {outer} were given"
        raise InputError(f"An annulus has a finite centre and radii 0 <= inner <= outer; {given}.")

    def contains(points: np.ndarray) -> np.ndarray:
        d = np.hypot(*np.moveaxis(real(points, "points of the plane", 2) - [x, y], -1, 0))
        return (d >= inner) & (d <= outer)

    return Region([(x, y, inner), (x, y, outer)], contains)


def _joined(a: Region, b: Region, both: Callable) -> Region:
    circles = np.vstack([a.circles, b.circles])
    return Region(circles, lambda points: both(a.contains(points), b.contains(points)))
