"""Regions: bounded by arcs, such as sections of a workspace, or known by points or squares within them."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from numpy.typing import ArrayLike

from ..arcs import Region
from ..reading import finite, real
from ._style import COLOURS


def region_path(region: Region) -> Path:
    """The boundary of ``region`` as one path, to be filled; empty where the region is.

    >>> len(drawing.region_path(arcs.annulus(0, 0, 0, 1)).vertices)  # a point a degree, and both ends
    363
    """
    loops = region.boundary()
    if not loops:
        return Path(np.zeros((1, 2)))
    codes = [[Path.MOVETO, *[Path.LINETO] * (len(loop) - 2), Path.CLOSEPOLY] for loop in loops]
    return Path(np.vstack(loops), np.concatenate(codes))


def region_2d(ax: Axes, region: Region, **style: Any) -> PathPatch:
    """Fill ``region`` and draw its boundary.

    >>> patch = drawing.region_2d(plt.figure().gca(), arcs.annulus(0, 0, 1, 2), facecolor="none")
    """
    patch = PathPatch(region_path(region), **{"linewidth": 1.5} | style)
    ax.add_patch(patch)
    ax.autoscale_view()
    return patch


def cloud(ax: Axes, points: ArrayLike, size: float = 2, **style: Any) -> Line2D:
    """Dots at ``points``, (n, 2), or (n, 3) in space, of ``size`` points; of many of them files stay small.

    >>> dots = drawing.cloud(plt.figure().gca(), [[0, 0], [1, 2]])
    """
    points = real(points, "points", None, None)
    of_dots: dict[str, Any] = {"color": COLOURS["aid"], "markersize": size, "rasterized": True}
    return ax.plot(*points.T, ".", **of_dots | style)[0]


def squares(ax: Axes, values: ArrayLike, first: ArrayLike, edge: float, **style: Any) -> AxesImage:
    """A grid of squares of one edge, the darker the higher their ``values``, (nx, ny); ``first`` is the centre
    of the first of them, (2,).

    >>> image = drawing.squares(plt.figure().gca(), [[0, 1], [2, 3]], first=[0, 0], edge=0.1)
    """
    values = np.asarray(values)
    low = finite(first, "the centre of the first square", 2) - edge / 2
    (left, bottom), (right, top) = low, low + edge * np.array(values.shape)
    ax.grid(False)
    style = {"cmap": "Blues", "extent": (left, right, bottom, top)} | style
    return ax.imshow(values.T, origin="lower", **style)
