"""The Lynxmotion arm in space and seen square to its own plane.

Each drawing is a few polylines, so that a moving picture can update them (``move``) and need not draw anew.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.art3d import Line3D
from mpl_toolkits.mplot3d.proj3d import proj_transform
from numpy.typing import ArrayLike

from .. import arm
from ..reading import real
from ._style import COLOURS, OUTLINE

# Where the names of the joints are written beside them, in points.
JOINT_LABELS = {
    "base": (-12, -4),
    "shoulder": (12, -14),
    "elbow": (-12, 8),
    "wrist": (0, 12),
    "gripper": (0, -24),
}
AXIS_LENGTH = 0.06  # of a frame, in metres


def arm_3d(
    ax: Axes3D, q: ArrayLike, geometry: arm.Geometry = arm.LYNX, with_gripper: bool = True, **style: Any
) -> list[Line3D]:
    """Links and gripper for joint angles ``q``, (5,) radians; returns the lines, for ``move``.

    >>> fig, space, plane = drawing.two_views()
    >>> links, fork = drawing.arm_3d(space, [0, 1, -1, 1, 0])
    """
    return _draw(ax, _polylines(q, geometry)[: 1 + with_gripper], style)


def arm_side_view(
    ax: Axes, q: ArrayLike, geometry: arm.Geometry = arm.LYNX, with_gripper: bool = True, **style: Any
) -> list[Line2D]:
    """The same, seen square to the arm's own plane: distance along the arm's azimuth, and height, in metres.

    >>> links, fork = drawing.arm_side_view(plt.figure().gca(), [0, 1, -1, 1, 0], color="black")
    """
    ax.set(xlabel="r, from the base axis [m]", ylabel="z [m]", aspect="equal")
    return _draw(ax, [_in_plane(points, q) for points in _polylines(q, geometry)[: 1 + with_gripper]], style)


def arm_top_view(ax: Axes, q: ArrayLike, geometry: arm.Geometry = arm.LYNX, **style: Any) -> list[Line2D]:
    """The same, seen from above.

    >>> links, fork = drawing.arm_top_view(plt.figure().gca(), [0, 1, -1, 1, 0])
    """
    ax.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    return _draw(ax, [points[:, :2] for points in _polylines(q, geometry)], style)


def arm_views(
    space: Axes3D, plane: Axes, q: ArrayLike, geometry: arm.Geometry = arm.LYNX, **style: Any
) -> tuple[list[Line3D], list[Line2D]]:
    """The same, in space and in its own plane at once; returns the lines of both, for ``move``.

    >>> fig, space, plane = drawing.two_views()
    >>> in_space, in_plane = drawing.arm_views(space, plane, [0, 1, -1, 1, 0])
    """
    return arm_3d(space, q, geometry, **style), arm_side_view(plane, q, geometry, **style)


def target(
    ax: Axes, at: ArrayLike, pitch: float | None = None, geometry: arm.Geometry = arm.LYNX, **style: Any
) -> Line2D:
    """A star where the gripper has to be: ``at`` is (x, y, z), or (r, z) in the plane of the arm, in metres.

    With a ``pitch`` (radians; in the plane only) a line leads back to where the wrist has to be.

    >>> star = drawing.target(plt.figure().gca(), [0.3, 0.2], pitch=0.5)
    """
    points = real(at, "a target", None)[None]
    if pitch is not None:
        points = np.vstack([points, points - geometry.L_3 * np.array([np.cos(pitch), np.sin(pitch)])])
    star: dict[str, Any] = {"color": COLOURS["target"], "markersize": 16, "markevery": [0], "zorder": 5}
    return ax.plot(*points.T, "*-", **star | style)[0]


def frames_3d(ax: Axes3D, T: ArrayLike, length: float = AXIS_LENGTH) -> list[Line3D]:
    """The axes of frames ``T``, (n, 4, 4): x, y and z in their colours; returns the three lines, for ``move``.

    >>> fig, space, plane = drawing.two_views()
    >>> x, y, z = drawing.frames_3d(space, [np.eye(4)])
    """
    return _draw_axes(ax, _axes_polylines(T, length))


def move(
    lines_3d: Sequence[Line3D],
    lines_side: Sequence[Line2D],
    q: ArrayLike,
    geometry: arm.Geometry = arm.LYNX,
    frames: ArrayLike | None = None,
) -> None:
    """Bring the lines of an arm, or with ``frames`` those of its frames, to ``q``; either list may be empty.

    >>> lines = drawing.arm_side_view(plt.figure().gca(), [0, 1, -1, 1, 0])
    >>> drawing.move([], lines, [0, 1.5, -1, 1, 0])
    """
    polylines = _polylines(q, geometry) if frames is None else _axes_polylines(frames, AXIS_LENGTH)
    for spatial, points in zip(lines_3d, polylines, strict=bool(lines_3d)):
        spatial.set_data_3d(*points.T)
    for flat, points in zip(lines_side, polylines, strict=bool(lines_side)):
        flat.set_data(*_in_plane(points, q).T)


def label_joints(
    ax: Axes, q: ArrayLike, geometry: arm.Geometry = arm.LYNX, **offsets: tuple[float, float]
) -> None:
    """Write the names of base, shoulder, elbow, wrist and gripper beside them; in 3-D, after the view is set.

    Where a name would cover something, put it elsewhere: ``shoulder=(-12, 4)``, in points from the joint.

    >>> drawing.label_joints(plt.figure().gca(), [0, 1, -1, 1, 0], elbow=(0, 20))
    """
    points = arm.joint_positions(q, geometry)
    if isinstance(ax, Axes3D):
        places = np.transpose(proj_transform(*points.T, ax.get_proj()))[:, :2]
    else:
        places = _in_plane(points, q)
    for (name, offset), place in zip((JOINT_LABELS | offsets).items(), places, strict=True):
        side = {-1: "right", 0: "center", 1: "left"}[np.sign(offset[0])]
        label = ax.annotate(name, place, xytext=offset, textcoords="offset points", horizontalalignment=side)
        label.set_path_effects(OUTLINE)


def gripper(T: np.ndarray, size: float) -> np.ndarray:
    """A fork of two fingers, (5, 3), whose tips lie on either side of the origin of the frame ``T`` (4, 4).

    The fingers point along z and are opened along x, so that the roll shows.

    >>> drawing.gripper(np.eye(4), 0.02)[[0, 4]]
    array([[-0.01,  0.  ,  0.  ],
           [ 0.01,  0.  ,  0.  ]])
    """
    half, tip = size / 2 * T[:3, 0], T[:3, 3]
    palm = tip - size * T[:3, 2]
    return np.array([tip - half, palm - half, palm, palm + half, tip + half])


def _polylines(q: ArrayLike, geometry: arm.Geometry) -> list[np.ndarray]:
    return [
        arm.joint_positions(q, geometry),
        gripper(arm.forward_kinematics(q, geometry), 0.06 * sum(geometry)),
    ]


def _draw(ax: Axes, polylines: list[np.ndarray], style: dict[str, Any]) -> list[Any]:
    """The links, and the fork of the gripper if it is there."""
    links, *fork = polylines
    of_links: dict[str, Any] = {"color": COLOURS["link"], "linewidth": 4, "markersize": 7, **style}
    of_fork = of_links | {"linewidth": 0.625 * of_links["linewidth"], "label": None}
    return [*ax.plot(*links.T, "o-", **of_links), *(ax.plot(*points.T, "-", **of_fork)[0] for points in fork)]


def _axes_polylines(T: ArrayLike, length: float) -> list[np.ndarray]:
    """For x, y and z: the axes of all frames as one polyline, broken by NaN between frames."""
    T = real(T, "frames", None, 4, 4)
    origin = T[:, :3, 3]
    gap = np.full_like(origin, np.nan)
    ends = [origin + length * T[:, :3, i] for i in range(3)]
    return [np.stack([origin, end, gap], axis=1).reshape(-1, 3) for end in ends]


def _draw_axes(ax: Axes, polylines: list[np.ndarray]) -> list[Any]:
    pairs = zip("xyz", polylines, strict=True)
    return [ax.plot(*points.T, color=COLOURS[axis], linewidth=2)[0] for axis, points in pairs]


def _in_plane(points: np.ndarray, q: ArrayLike) -> np.ndarray:
    """(..., 3) to (..., 2): along the azimuth of the arm, and up."""
    azimuth = real(q, "joint angles", 5)[0]
    along = points[..., 0] * np.cos(azimuth) + points[..., 1] * np.sin(azimuth)
    return np.stack([along, points[..., 2]], axis=-1)
