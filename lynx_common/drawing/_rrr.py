"""The planar 3-RRR robot: base, platform and three legs, in mm; a leg that does not close shows its gap."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .. import rrr
from ..reading import real
from ._style import COLOURS, OUTLINE

# What is drawn, from back to front, and how.
STYLES: dict[str, dict[str, Any]] = {
    "base": {"color": COLOURS["link"], "linestyle": "-", "marker": "s", "markersize": 9, "linewidth": 1.5},
    "gap": {"color": COLOURS["printed"], "linestyle": "--", "linewidth": 2},
    "distal link $L$": {"color": COLOURS["y"], "linestyle": "-", "marker": "o"},
    "driven link $S_A$": {"color": COLOURS["z"], "linestyle": "-", "marker": "o"},
    "platform": {"color": COLOURS["x"], "linestyle": "-", "marker": "o"},
    "needle": {"color": COLOURS["target"], "linestyle": "", "marker": "*", "markersize": 11},
}
# A gap below this share of L is one of rounding.
CLOSED = 1e-6


def rrr_2d(
    ax: Axes, pose: ArrayLike, theta: ArrayLike, geometry: rrr.Geometry = rrr.RRR, **style: Any
) -> list[Any]:
    """The robot at ``pose`` (X_c, Y_c in mm, alpha in rad) with motor angles ``theta``, (3,); returns its artists.

    All links are drawn at their lengths. Where the distal one, pointing at its platform joint, ends elsewhere, the
    gap (short or beyond) is dashed, with its length. A leg whose angle is NaN is drawn stretched towards its
    platform joint, or folded, whichever comes nearer. ``style`` goes to all lines; ``ax.legend()`` names them.

    >>> pose, ax = [20, 30, 0.3], plt.figure().gca()
    >>> artists = drawing.rrr_2d(ax, pose, rrr.inverse_kinematics(pose)[0])
    """
    PB, M, ends, PP = joints(pose, theta, geometry)
    gaps = np.linalg.norm(PP - ends, axis=1)
    is_open = gaps > CLOSED * geometry.L
    places = {
        "base": PB[[0, 1, 2, 0]],
        "gap": _segments(np.where(is_open[:, None], ends, np.nan), PP),
        "distal link $L$": _segments(M, ends),
        "driven link $S_A$": _segments(PB, M),
        "platform": PP[[0, 1, 2, 0]],
        "needle": np.reshape(pose, (1, 3))[:, :2],
    }
    of_all: dict[str, Any] = {"markersize": 5}
    artists = [ax.plot(*places[name].T, **of_all | own | style, label=name)[0] for name, own in STYLES.items()]
    artists += [_write_gap(ax, ends[i], PP, i, gaps[i], geometry) for i in range(3) if is_open[i]]
    ax.set(xlabel="X [mm]", ylabel="Y [mm]", aspect="equal")
    ax.relim()
    return artists


def _write_gap(ax: Axes, end: np.ndarray, PP: np.ndarray, leg: int, gap: float, geometry: rrr.Geometry) -> Any:
    """The size of a gap beside it, on the side away from the middle of the platform."""
    middle = (end + PP[leg]) / 2
    x, y = _unit(PP[leg : leg + 1] - end)[0, ::-1] * [-1, 1]
    if (middle - PP.mean(axis=0)) @ [x, y] < 0:
        x, y = -x, -y
    place = middle + geometry.r_platform / 8 * np.array([x, y])
    side: Any = {"ha": "left" if x > 0.3 else "right" if x < -0.3 else "center"}
    side["va"] = "bottom" if y > 0.3 else "top" if y < -0.3 else "center"
    paper = {"color": "white", "pad": 0.5, "alpha": 0.8}
    return ax.text(place[0], place[1], f"{gap:.1f} mm", color=COLOURS["link"], bbox=paper, zorder=6, **side)


def label_rrr(ax: Axes, pose: ArrayLike, theta: ArrayLike, geometry: rrr.Geometry = rrr.RRR) -> None:
    """Write the names of all joints, and of the needle C, beside them.

    >>> drawing.label_rrr(plt.figure().gca(), [0, 0, 0], rrr.inverse_kinematics([0, 0, 0])[0])
    """
    PB, M, _, PP = joints(pose, theta, geometry)
    middle, needle = np.mean(PB, axis=0), real(pose, "a pose", 3)[:2]
    for name, points, centre, shift in (("PB", PB, middle, 20), ("M", M, middle, 14), ("PP", PP, needle, -22)):
        for leg, point in enumerate(points, start=1):
            away = (point - centre) / np.linalg.norm(point - centre)
            _write(ax, f"${name}_{leg}$", point, shift * away)
    _write(ax, "$C$", needle, np.array([10, 8]))


def joints(
    pose: ArrayLike, theta: ArrayLike, geometry: rrr.Geometry
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Base joints, elbows, free ends of the distal links, and platform joints, (3, 2) each."""
    PB, PP = rrr.base_joints(geometry), rrr.platform_joints(pose, geometry)
    theta = real(theta, "motor angles", 3)
    M = rrr.elbows(np.where(np.isnan(theta), _reaching(PB, PP, geometry), theta), geometry)
    return PB, M, M + geometry.L * _unit(PP - M), PP


def _reaching(PB: np.ndarray, PP: np.ndarray, geometry: rrr.Geometry) -> np.ndarray:
    """Motor angles with which legs that cannot close come nearest to their platform joints."""
    away = PP - PB
    towards = np.arctan2(away[:, 1], away[:, 0])
    backwards = (geometry.S_A < geometry.L) & (np.hypot(*away.T) < geometry.L)
    return towards + np.pi * backwards


def _unit(vectors: np.ndarray) -> np.ndarray:
    angle = np.arctan2(vectors[:, 1], vectors[:, 0])  # which the zero vector has, too
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def _segments(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Three segments as one polyline, (9, 2), broken by NaN."""
    return np.stack([start, end, np.full_like(start, np.nan)], axis=1).reshape(-1, 2)


def _write(ax: Axes, text: str, point: np.ndarray, offset: np.ndarray) -> None:
    (x, y), (dx, dy) = point, offset
    label = ax.annotate(text, (x, y), xytext=(dx, dy), textcoords="offset points", ha="center", va="center")
    label.set_path_effects(OUTLINE)
