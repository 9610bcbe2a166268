"""What all figures share: one colour for one meaning, sizes that are readable on a slide, equal axes in space."""

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.patheffects import AbstractPathEffect, withStroke
from mpl_toolkits.mplot3d import Axes3D
from numpy.typing import ArrayLike

from ..reading import real

# The palette of Okabe and Ito, whose colours readers with any common colour blindness can tell apart, and two
# greys, which line style or marker has to tell apart from them.
COLOURS = {
    "link": "#4d4d4d",
    "x": "#d55e00",
    "y": "#009e73",
    "z": "#0072b2",
    "printed": "#cc79a7",
    "right": "#56b4e9",
    "target": "#e69f00",
    "aid": "#8c8c8c",
}
OUTLINE: list[AbstractPathEffect] = [withStroke(linewidth=3, foreground="white")]  # of words upon lines


def use_style() -> None:
    """Set sizes and colours for every figure that follows.

    >>> with plt.rc_context():  # and take them back
    ...     drawing.use_style()
    """
    mpl.rcParams.update(
        {
            "figure.dpi": 100,
            "figure.constrained_layout.use": True,
            "font.size": 11,
            "axes.titlesize": 12,
            "axes.grid": True,
            "axes.axisbelow": True,
            "grid.color": "#e0e0e0",
            "lines.linewidth": 2,
            "axes.prop_cycle": plt.cycler(color=["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"]),
            "svg.hashsalt": "lynx",
        }
    )


def two_views(width: float = 10, height: float = 4.6) -> tuple[Figure, Axes3D, Axes]:
    """A figure (inches) with a 3-D view on the left and a plane one on the right.

    >>> fig, space, plane = drawing.two_views(8, 4)
    """
    fig = plt.figure(figsize=(width, height), layout=ConstrainedLayoutEngine(wspace=0.12))
    return fig, fig.add_subplot(1, 2, 1, projection="3d"), fig.add_subplot(1, 2, 2)


def space_3d(ax: Axes3D, points: ArrayLike, azimuth: float = -60, zoom: float = 1, unit: str = "m") -> Axes3D:
    """A 3-D view with equal scales that holds ``points``, (..., 3), and the floor below them.

    ``azimuth`` is the direction from which it is seen, in degrees from x; ``unit`` that of the lengths. A ``zoom``
    above 1 fills more of the axes; the labels beside them then need room.

    >>> fig, space, plane = drawing.two_views()
    >>> drawing.space_3d(space, [[-0.5, -0.5, 0], [0.5, 0.5, 0.6]]).get_zlabel()
    'z [m]'
    """
    points = real(points, "points in space", 3).reshape(-1, 3)
    low, high = points.min(axis=0), points.max(axis=0)
    pad = 0.1 * (high - low).max() * np.array([1, 1, 0])
    low, high = np.minimum(low - pad, [np.inf, np.inf, 0]), high + pad
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set(xlabel=f"x [{unit}]", ylabel=f"y [{unit}]", zlabel=f"z [{unit}]")
    ax.set_box_aspect(high - low, zoom=zoom)
    ax.view_init(elev=22, azim=azimuth)
    ax.locator_params(nbins=4)
    return ax
