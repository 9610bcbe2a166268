"""How circles cut each other into pieces, and what becomes of the pieces that are boundary."""

import numpy as np
from numpy.typing import ArrayLike

from ..reading import real

# How near to each other two points, or two circles, count as one: a share of the largest circle's radius.
TOLERANCE = 1e-10


def crossings(a: ArrayLike, rho_a: float, b: ArrayLike, rho_b: float) -> tuple[np.ndarray, np.ndarray]:
    """Where circles about a and b, (..., 2), cross: to the left and to the right of the way from a to b.

    Circles that touch have the same point twice, even where rounding keeps them apart; for circles that do not
    meet it is a point between them or beyond, and for those about one centre NaN.

    >>> crossings([0, 0], 5, [6, 0], 5)
    (array([3., 4.]), array([ 3., -4.]))
    """
    a, b = real(a, "a centre", 2), real(b, "a centre", 2)
    apart = b - a
    squared = (apart * apart).sum(axis=-1, keepdims=True)
    with np.errstate(invalid="ignore", divide="ignore"):
        along = (squared + rho_a**2 - rho_b**2) / (2 * squared)
        across = np.sqrt(np.maximum(rho_a**2 / squared - along**2, 0))
        middle, left = a + along * apart, across * apart[..., ::-1] * [-1, 1]
    return middle + left, middle - left


def distinct(circles: np.ndarray) -> np.ndarray:
    """Circles of some size, each once."""
    scale = circles[:, 2].max(initial=0)
    circles = circles[circles[:, 2] > TOLERANCE * scale]
    alike = np.abs(circles[:, None] - circles).max(axis=-1) <= TOLERANCE * scale
    return circles[~np.tril(alike, -1).any(axis=1)]


def cuts_of(circles: np.ndarray, i: int) -> np.ndarray:
    """Angles, ascending and at least one, at which the other circles cut circle ``i``; its pieces begin there."""
    x, y, rho = circles[i]
    dx, dy = circles[:, 0] - x, circles[:, 1] - y
    d = np.hypot(dx, dy)
    with np.errstate(invalid="ignore", divide="ignore"):
        cosine = (d**2 + rho**2 - circles[:, 2] ** 2) / (2 * d * rho)
    meets = abs(cosine) <= 1 + TOLERANCE
    cosine = np.where(abs(cosine) >= 1 - TOLERANCE, np.sign(cosine), cosine)[meets]  # those that touch meet once
    towards, half = np.arctan2(dy, dx)[meets], np.arccos(cosine)
    cuts = np.sort(np.mod([towards - half, towards + half], 2 * np.pi), axis=None)
    cuts = cuts[np.diff(cuts, prepend=-1) > TOLERANCE]
    return cuts if len(cuts) else np.zeros(1)


def clear_distance(circles: np.ndarray, points: np.ndarray, rho: np.ndarray) -> np.ndarray:
    """How far one may step off points (n, 2) on circles of radius rho, (n,), and cross no other circle: (n,)."""
    away = np.hypot(points[:, None, 0] - circles[:, 0], points[:, None, 1] - circles[:, 1])
    gaps = np.abs(away - circles[:, 2])
    gaps[gaps <= TOLERANCE * circles[:, 2].max()] = np.inf  # the point's own circle
    return np.minimum(gaps.min(axis=1), rho) / 2


def boundary_arcs(circle: np.ndarray, cuts: np.ndarray, side: np.ndarray) -> np.ndarray:
    """The boundary's arcs on one circle, (n, 5): x, y, radius, start, sweep, with the inside on the left.

    ``side`` has an entry for each piece between ``cuts``: 1 where the region is within the circle, -1 where it is
    outside, and 0 where the piece is no boundary. Neighbouring pieces of one side become one arc.
    """
    begins = side != np.roll(side, 1)
    if not begins.any():
        begins[0] = True  # the whole circle is one arc
    start, side = cuts[begins], side[begins]
    sweep = np.diff(start, append=start[:1] + 2 * np.pi)
    start = np.where(side > 0, start, start + sweep)  # outside the circle, the inside is on the left clockwise
    return np.column_stack([np.tile(circle, (len(start), 1)), start, side * sweep])[side != 0]


def points_on(arcs: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Points of arcs (..., 5) at angles (..., m): (..., m, 2)."""
    direction = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    return arcs[..., None, :2] + arcs[..., None, 2:3] * direction
