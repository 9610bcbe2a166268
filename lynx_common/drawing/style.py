"""What all figures share: one colour for one meaning, sizes that are readable on a slide, equal axes in space."""

import matplotlib as mpl
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d import Axes3D

Limits = tuple[float, float]

# The palette of Okabe and Ito, which readers with any common colour blindness can tell apart.
COLOURS = {
    "link": "#4d4d4d",
    "x": "#d55e00",
    "y": "#009e73",
    "z": "#0072b2",
    "printed": "#cc79a7",
    "right": "#0072b2",
    "target": "#e69f00",
    "aid": "#8c8c8c",
}


def use_style() -> None:
    """Set sizes and colours for every figure that follows."""
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
            "axes.prop_cycle": mpl.cycler(color=["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"]),
            "svg.hashsalt": "lynx",
        }
    )


def two_views(width: float = 10, height: float = 4.6) -> tuple[Figure, Axes3D, Axes]:
    """A figure (inches) with a 3-D view on the left and a plane one on the right."""
    fig = plt.figure(figsize=(width, height), layout="constrained")
    fig.get_layout_engine().set(wspace=0.12)
    return fig, fig.add_subplot(1, 2, 1, projection="3d"), fig.add_subplot(1, 2, 2)


def space_3d(ax: Axes3D, x: Limits, y: Limits, z: Limits, azimuth: float = -60) -> Axes3D:
    """A 3-D view with equal scales of the box ``x``, ``y``, ``z`` (metres), seen from ``azimuth`` (degrees)."""
    ax.set(xlim=x, ylim=y, zlim=z, xlabel="x [m]", ylabel="y [m]", zlabel="z [m]")
    ax.set_box_aspect([high - low for low, high in (x, y, z)], zoom=1.0)
    ax.view_init(elev=22, azim=azimuth)
    ax.locator_params(nbins=4)
    return ax
