"""Plane regions that are bounded by arcs, such as sections of a workspace."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from ..arcs import Region


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
