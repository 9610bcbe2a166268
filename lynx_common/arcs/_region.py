"""Plane regions whose boundary lies on circles."""

from collections.abc import Callable
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InputError
from ..reading import finite, number, real
from ._circles import boundary_arcs, clear_distance, cuts_of, distinct, points_on

LARGEST_BOUNDARY = 10**7  # points


class Region:
    """A plane region bounded by arcs of given circles.

    circles : (n, 3), rows (x, y, radius); they hold all of the boundary, and may hold more
    contains : points (..., 2) to (...,) of bool

    ``a | b`` is the union and ``a & b`` the intersection of two regions. Lengths are in one unit, the caller's.
    Raises InputError unless the circles are finite, and no radius is negative.

    >>> lens = annulus(0, 0, 0, 1) & annulus(1, 0, 0, 1)
    >>> lens.contains([[0.5, 0], [-0.5, 0]]), round(lens.area, 4)
    (array([ True, False]), 1.2284)
    """

    def __init__(self, circles: ArrayLike, contains: Callable[[np.ndarray], np.ndarray]):
        self.circles = finite(circles, "circles, rows of x, y and radius", None, 3)
        self._contains = contains
        if (self.circles[:, 2] < 0).any():
            raise InputError(f"A circle's radius is not negative; {self.circles[:, 2].min():g} was given.")

    def contains(self, points: ArrayLike) -> np.ndarray:
        """Whether points (..., 2) lie in the region: (...) of bool."""
        return self._contains(real(points, "points of the plane", 2))

    def __or__(self, other: "Region") -> "Region":
        circles = np.vstack([self.circles, other.circles])
        return Region(circles, lambda points: self.contains(points) | other.contains(points))

    def __and__(self, other: "Region") -> "Region":
        circles = np.vstack([self.circles, other.circles])
        return Region(circles, lambda points: self.contains(points) & other.contains(points))

    def mirror(self) -> "Region":
        """The region seen in a mirror along the second axis: x becomes -x."""
        return Region(self.circles * [-1, 1, 1], lambda points: self.contains(points * [-1, 1]))

    def around(self, radius: float) -> "Region":
        """All points at exactly the distance ``radius`` from some point of this region, which is one piece.

        This is what the end of a link reaches that can be turned fully about every point of the region.

        >>> round(annulus(0, 0, 0, 2).around(3).area / np.pi, 6)  # a ring, from 1 to 5
        24.0
        """
        radius = number(radius, "radius", least=0)
        x, y, rho, _, sweep = self.arcs.T
        corners = self.ends[abs(sweep) < 2 * np.pi].reshape(-1, 2)
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
        sides = self._sides(circles, cuts)
        return np.concatenate(list(map(boundary_arcs, circles, cuts, sides)))

    def _sides(self, circles: np.ndarray, cuts: list[np.ndarray]) -> list[np.ndarray]:
        """On which side of each piece the region lies, circle by circle; as ``boundary_arcs`` asks for it.

        A piece is judged by two points beside its middle, so near to it that no other circle is in between.
        """
        pieces = [len(angles) for angles in cuts]
        x, y, rho = np.repeat(circles, pieces, axis=0).T
        middle = np.concatenate([start + np.diff(start, append=start[0] + 2 * np.pi) / 2 for start in cuts])
        outwards = np.stack([np.cos(middle), np.sin(middle)], axis=-1)
        points = np.stack([x, y], axis=-1) + rho[:, None] * outwards
        step = clear_distance(circles, points, rho)[:, None] * outwards
        within, outside = self.contains(np.stack([points - step, points + step])).astype(int)
        return np.split(within - outside, np.cumsum(pieces)[:-1])

    @property
    def ends(self) -> np.ndarray:
        """First and last point of each arc, (n, 2, 2)."""
        return points_on(self.arcs, self.arcs[:, 3:4] + self.arcs[:, 4:] * [0, 1])

    @property
    def area(self) -> float:
        """The integral of x dy along the boundary."""
        x, rho, t = self._cut_at_axis()
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
        x, rho, t = self._cut_at_axis()
        sin, cos = np.sin(t), np.cos(t)
        cubic = x**2 * sin + x * rho * (t + sin * cos) + rho**2 * (sin - sin**3 / 3)
        side = np.sign(x + rho * np.cos(t.mean(axis=1, keepdims=True)))
        return float(np.pi / 2 * (side * rho * cubic @ [-1, 1]).sum())

    def distances(self, points: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Distance from points (..., 2) to the nearest and to the farthest point of the boundary: two of (...).

        >>> [x.round(6).tolist() for x in annulus(0, 0, 1, 2).distances([[0, 0], [0, 3]])]
        [[1.0, 1.0], [2.0, 5.0]]
        """
        points = real(points, "points of the plane", 2)[..., None, :]
        away = points - self.arcs[:, :2]
        rho, d = self.arcs[:, 2], np.hypot(away[..., 0], away[..., 1])
        to_ends = np.linalg.norm(points[..., None, :] - self.ends, axis=-1)
        angle = np.arctan2(away[..., 1], away[..., 0])
        near = np.where(self._covers(angle), abs(d - rho), to_ends.min(axis=-1))
        far = np.where(self._covers(angle + np.pi), d + rho, to_ends.max(axis=-1))
        return near.min(axis=-1, initial=np.inf), far.max(axis=-1, initial=-np.inf)

    def boundary(self, step: float = np.pi / 180) -> list[np.ndarray]:
        """Closed polylines, (n, 2), along the boundary, for drawing; at most ``step`` radians between points.

        Raises InputError where the step is not above 0, or would give more than 10 million points.

        >>> len(annulus(0, 0, 1, 2).boundary())
        2
        """
        step = number(step, "step", above=0)
        if (count := float(np.abs(self.arcs[:, 4]).sum()) / step) > LARGEST_BOUNDARY:
            raise InputError(
                f"A step of {step:g} rad would give {count:.2g} points; {LARGEST_BOUNDARY:.0e} are allowed."
            )
        loops = []
        for arcs in self._loops():
            shares = [np.linspace(0, 1, 2 + int(abs(arc[4]) / step)) for arc in arcs]
            lines = [points_on(arc, arc[3] + arc[4] * share) for arc, share in zip(arcs, shares, strict=True)]
            loops.append(np.vstack([*lines, lines[0][0]]))
        return loops

    def _loops(self) -> list[list[np.ndarray]]:
        """The arcs of each closed curve of the boundary, in the order in which they follow each other."""
        arcs, ends, loops = list(self.arcs), list(self.ends), []
        while arcs:
            loop, (first, last) = [arcs.pop(0)], ends.pop(0)
            while arcs:
                gaps = np.abs(np.array(ends)[:, 0] - last).max(axis=1)
                following = int(gaps.argmin())
                if gaps[following] >= np.abs(first - last).max():
                    break  # nothing is nearer than where it began
                loop.append(arcs.pop(following))
                last = ends.pop(following)[1]
            loops.append(loop)
        return loops

    def _cut_at_axis(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """x and radius as columns (n, 1), and the angles (n, 2) of both ends, of the arcs cut where x = 0."""
        x, _, rho, start, sweep = self.arcs.T
        turn = np.sign(sweep)
        with np.errstate(invalid="ignore", divide="ignore"):
            crossing = np.arccos(-x / rho)
        cuts = [start]
        for angle in (crossing, -crossing):
            share = np.mod((angle - start) * turn, 2 * np.pi) / abs(sweep)
            on_arc = np.where(share < 1, share, 0)  # else, or where it is NaN, a piece of length 0
            cuts.append(start + sweep * on_arc)
        along = np.sort(np.stack([*cuts, start + sweep], axis=-1) * turn[:, None], axis=-1)
        ends = np.stack([along[:, :-1], along[:, 1:]], axis=-1) * turn[:, None, None]
        return np.repeat(x, 3)[:, None], np.repeat(rho, 3)[:, None], ends.reshape(-1, 2)

    def _covers(self, angle: np.ndarray) -> np.ndarray:
        """Whether arcs have a point in this direction from their centres."""
        start, sweep = self.arcs[:, 3], self.arcs[:, 4]
        return np.mod((angle - start) * np.sign(sweep), 2 * np.pi) <= abs(sweep)


def annulus(x: float, y: float, inner: float, outer: float) -> Region:
    """Points whose distance from (x, y) lies between ``inner`` and ``outer``.

    Raises InputError unless all are finite and 0 <= inner <= outer.

    >>> round(annulus(0, 0, 1, 2).area / np.pi, 6)
    3.0
    """
    centre = finite([x, y], "the centre of an annulus", 2)
    inner = number(inner, "inner radius of an annulus", least=0)
    outer = number(outer, "outer radius of an annulus", least=inner)

    def contains(points: np.ndarray) -> np.ndarray:
        d = np.hypot(*np.moveaxis(points - centre, -1, 0))
        return (d >= inner) & (d <= outer)

    return Region([(*centre, inner), (*centre, outer)], contains)
