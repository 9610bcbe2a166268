"""How circles cut each other into pieces, and which pieces are boundary."""

import numpy as np

# What counts as one point, as a share of the largest circle's radius.
SAME = 1e-10


def distinct(circles: np.ndarray) -> np.ndarray:
    """Circles of some size, each once."""
    scale = circles[:, 2].max(initial=0)
    circles = circles[circles[:, 2] > SAME * scale]
    alike = np.abs(circles[:, None] - circles).max(axis=-1) <= SAME * scale
    return circles[~np.tril(alike, -1).any(axis=1)]


def crossings(a: np.ndarray, rho_a: float, b: np.ndarray, rho_b: float) -> tuple[np.ndarray, np.ndarray]:
    """Where circles about a and b, (..., 2), cross: to the left and to the right of the way from a to b.

    Circles that touch have the same point twice, even where rounding keeps them apart; for circles that do not
    meet it is a point between them or beyond, and for those about one centre NaN.
    """
    apart = b - a
    squared = (apart * apart).sum(axis=-1, keepdims=True)
    with np.errstate(invalid="ignore", divide="ignore"):
        along = (squared + rho_a**2 - rho_b**2) / (2 * squared)
        across = np.sqrt(np.maximum(rho_a**2 / squared - along**2, 0))
        middle, left = a + along * apart, across * apart[..., ::-1] * [-1, 1]
    return middle + left, middle - left


def cuts_of(circles: np.ndarray, i: int) -> np.ndarray:
    """Angles, ascending and at least one, at which the other circles meet circle ``i``."""
    x, y, rho = circles[i]
    dx, dy = circles[:, 0] - x, circles[:, 1] - y
    d = np.hypot(dx, dy)
    with np.errstate(invalid="ignore", divide="ignore"):
        cosine = (d**2 + rho**2 - circles[:, 2] ** 2) / (2 * d * rho)
    meets = abs(cosine) <= 1 + SAME
    cosine = np.where(abs(cosine) >= 1 - SAME, np.sign(cosine), cosine)[meets]  # circles that touch meet once
    towards, half = np.arctan2(dy, dx)[meets], np.arccos(cosine)
    cuts = np.sort(np.mod([towards - half, towards + half], 2 * np.pi), axis=None)
    cuts = cuts[np.diff(cuts, prepend=-1) > SAME]
    return cuts if len(cuts) else np.zeros(1)


def beside(circles: np.ndarray, points: np.ndarray, rho: np.ndarray) -> np.ndarray:
    """How far to go from points (n, 2) on circles of radius rho, (n,), so that no circle is in between: (n,)."""
    away = np.hypot(points[:, None, 0] - circles[:, 0], points[:, None, 1] - circles[:, 1])
    gaps = np.abs(away - circles[:, 2])
    gaps[gaps <= SAME * circles[:, 2].max()] = np.inf  # the circle itself
    return np.minimum(gaps.min(axis=1), rho) / 2


def arcs_of(circle: np.ndarray, cuts: np.ndarray, turn: np.ndarray) -> list[tuple]:
    """The boundary's arcs on one circle; ``turn`` is 1 or -1 where a piece of it is boundary, and 0 elsewhere."""
    begins = turn != np.roll(turn, 1)
    begins[0] |= not begins.any()
    start, turn = cuts[begins], turn[begins]
    sweep = np.diff(start, append=start[:1] + 2 * np.pi)
    start = np.where(turn > 0, start, start + sweep)
    return [(*circle, *row) for row in zip(start, turn * sweep, strict=True) if row[1]]


def on(arcs: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Points of arcs (..., 5) at angles (..., m): (..., m, 2)."""
    direction = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    return arcs[..., None, :2] + arcs[..., None, 2:3] * direction
