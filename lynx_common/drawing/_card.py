"""The 3-RRR robot as a page of card, to print, cut out and join with paper fasteners."""

from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, FancyBboxPatch, Polygon
from numpy.typing import ArrayLike

from .. import rrr

SCALE = 1 / 4
PAGE = np.array([210, 297])  # mm; what is drawn also fits a page of 8.5 by 11 inches
HOLE, EDGE = 1.5, 7  # radius of a hole, and how much card is left about its centre, in mm
STYLE: Any = {"facecolor": "none", "edgecolor": "black", "linewidth": 1}


def card(theta: ArrayLike) -> Figure:
    """A page of ``rrr.RRR`` at a quarter of its size: base, platform, driven and distal links, with their holes.

    The base has holes for the elbows, too, at motor angles ``theta``, (3,) in radians: fastened there, the motors
    are locked.

    >>> fig = drawing.card(np.deg2rad([257.07, 17.07, 137.07]))
    >>> len(fig.axes[0].patches)  # eight outlines and 22 holes
    30
    """
    fig = plt.figure(figsize=tuple(PAGE / 25.4), layout="none")
    ax = fig.add_axes((0, 0, 1, 1), xlim=(0, PAGE[0]), ylim=(0, PAGE[1]))
    ax.axis("off")
    base, elbows = SCALE * rrr.base_joints(), SCALE * rrr.elbows(theta)
    joints = SCALE * rrr.platform_joints([0, 0, 0])
    _plate(ax, "base", np.concatenate([base, elbows]) + [105, 75], _legs("PB") + _legs("M"))
    _plate(ax, "platform", np.concatenate([joints, np.zeros((1, 2))]) + [60, 205], [*_legs("PP"), "$C$"])
    for name, length, bottom in (("driven", rrr.RRR.S_A, 180), ("distal", rrr.RRR.L, 228)):
        for leg in range(3):
            _link(ax, name, np.array([120, bottom + 16 * leg]), SCALE * length)
    ax.plot([150, 200], [22, 22], color="black", linewidth=1)
    ax.text(175, 24, "50 mm", ha="center")
    return fig


def _legs(letter: str) -> list[str]:
    return [f"${letter}_{leg}$" for leg in (1, 2, 3)]


def _plate(ax: Axes, part: str, holes: np.ndarray, names: list[str]) -> None:
    """A triangle with room about its first three holes, and all its holes with their names."""
    corners = holes[:3]
    away = corners - corners.mean(axis=0)
    away /= np.linalg.norm(away, axis=1, keepdims=True)
    ax.add_patch(Polygon(corners + 2 * EDGE * away, label=part, **STYLE))
    for hole, name in zip(holes, names, strict=True):
        _hole(ax, part, hole)
        ax.text(hole[0], hole[1] + 4.5, name, ha="center", va="center", fontsize=9)


def _link(ax: Axes, part: str, start: np.ndarray, length: float) -> None:
    """A strip with a hole at each end."""
    box = FancyBboxPatch(
        tuple(start), length, 0, boxstyle=f"round,pad={EDGE},rounding_size={EDGE}", label=part, **STYLE
    )
    ax.add_patch(box)
    for end in (start, start + [length, 0]):
        _hole(ax, part, end)
    ax.text(start[0] + length / 2, start[1], part, ha="center", va="center", fontsize=9)


def _hole(ax: Axes, part: str, centre: np.ndarray) -> None:
    ax.add_patch(Circle(tuple(centre), HOLE, label=f"{part} hole", **STYLE))
