"""Regions: bounded by arcs, such as sections of a workspace, or known by points or squares within them."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from ..arcs import Region
from .style import COLOURS


def region_path(region: Region) -> Path:
    """The boundary of ``region`` as one path, to be filled; empty where the region is."""
    loops = region.boundary()
    if not loops:
        return Path(np.zeros((1, 2)))
    codes = [[Path.MOVETO, *[Path.LINETO] * (len(loop) - 2), Path.CLOSEPOLY] for loop in loops]
    return Path(np.vstack(loops), np.concatenate(codes))


def region_2d(ax: Axes, region: Region, **style) -> PathPatch:
    """Fill ``region`` and draw its boundary."""
    patch = ax.add_patch(PathPatch(region_path(region), **{"linewidth": 1.5} | style))
    ax.autoscale_view()
    return patch


def cloud(ax: Axes, points: np.ndarray, size: float = 2, **style) -> Line2D:
    """Dots at ``points``, (n, 2), or (n, 3) in space, of ``size`` points; of many of them files stay small."""
    style = {"color": COLOURS["aid"], "markersize": size, "rasterized": True} | style
    return ax.plot(*points.T, ".", **style)[0]


def squares(ax: Axes, values: np.ndarray, first: np.ndarray, edge: float, **style) -> AxesImage:
    """A grid of squares of one edge, the darker the higher their ``values``, (nx, ny); ``first`` is the centre
    of the first of them, (2,).
    """
    low = np.asarray(first) - edge / 2
    (left, bottom), (right, top) = low, low + edge * np.array(values.shape)
    ax.grid(False)
    style = {"cmap": "Blues", "extent": (left, right, bottom, top)} | style
    return ax.imshow(values.T, origin="lower", **style)
