"""What stands around an arm: a ball, a screw's line, a planner's tree, and the map of where it is singular."""

from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.lines import Line2D
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.art3d import Line3D, Poly3DCollection
from numpy.typing import ArrayLike

from .. import arm, obstacles, planner, screws
from ._style import COLOURS


def ball_3d(ax: Axes3D, ball: obstacles.Sphere, **style: Any) -> Poly3DCollection:
    """A ball that one can see through.

    >>> fig, space, plane = drawing.two_views()
    >>> shell = drawing.ball_3d(space, obstacles.Sphere((0, 0, 0.5), 0.1))
    """
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 25), np.linspace(0, np.pi, 13))
    shell = np.array([np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)])
    surface = np.reshape(ball.centre, (3, 1, 1)) + ball.radius * shell
    return ax.plot_surface(*surface, **{"color": COLOURS["printed"], "alpha": 0.3} | style)


def screw_3d(ax: Axes3D, twist: ArrayLike, half: float, middle: float = 0.0, **style: Any) -> Line3D:
    """A piece of a twist's line, ``half`` to either side of a point of it.

    That is the point nearest to the origin, or the one ``middle`` further along the line.

    >>> fig, space, plane = drawing.two_views()
    >>> line = drawing.screw_3d(space, screws.revolute([0, 0, 1], [1, 0, 0]), half=0.5)
    """
    line = screws.screw_axis(twist)
    ends = line.point + np.array([[middle - half], [middle + half]]) * line.axis
    return ax.plot(*ends.T, **style)[0]


def tree_2d(ax: Axes, tree: planner.Tree, joints: tuple[int, int], **style: Any) -> Line2D:
    """The edges of a planner's tree over two of its joints, counted from 0, in degrees.

    >>> tree = planner.plan(lambda q: np.ones(len(q), bool), [[-1, 1]] * 2, [0, 0], [0.5, 0.5]).tree
    >>> line = drawing.tree_2d(plt.figure().gca(), tree, (0, 1))
    """
    ends = np.stack([tree.q[1:], tree.q[tree.parent[1:]], np.full_like(tree.q[1:], np.nan)], axis=1)
    edges = np.rad2deg(ends).reshape(-1, tree.q.shape[1])  # one line, broken by NaN
    of_edges: dict[str, Any] = {"color": COLOURS["aid"], "linewidth": 0.4}
    return ax.plot(*edges[:, list(joints)].T, **of_edges | style)[0]


def determinant_map(ax: Axes, geometry: arm.Geometry, samples: int = 121) -> QuadMesh:
    """The determinant of the wrist's position Jacobian over theta_2 and theta_3, in degrees, and where it is zero.

    Its elbow factor is zero on the horizontal lines, its shoulder factor on the curves. Returns the shading.

    >>> shading = drawing.determinant_map(plt.figure().gca(), arm.LYNX, samples=21)
    """
    angles = np.linspace(-1, 1, samples) * (np.pi - 1e-6)  # fully folded, r may be 0 for every theta_2
    postures = np.zeros((samples, samples, 5))
    postures[..., 1], postures[..., 2] = np.meshgrid(angles, angles)
    J, degrees = arm.jacobian(postures, replace(geometry, L_3=0))[..., :3, :3], np.rad2deg(angles)
    shading = ax.pcolormesh(degrees, degrees, np.linalg.det(J), cmap="PuOr", rasterized=True)
    ax.contour(degrees, degrees, J[..., 2, 1], [0], colors=COLOURS["x"])  # dz/dtheta_2 is the distance r
    for bend in (-180, 0, 180):
        ax.axhline(bend, color=COLOURS["z"], linewidth=4 if bend else 2)  # half of an edge is cut off
    ticks = range(-180, 181, 90)
    ax.set(xlabel="θ₂ [deg]", ylabel="θ₃ [deg]", xticks=ticks, yticks=ticks, xlim=(-180, 180), ylim=(-180, 180))
    return shading
