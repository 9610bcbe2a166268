"""The DH schema of the arm: joints as cylinders about their axes, link frames, lengths; report Fig. 1.1.

And two schemas beside it: one link in general, and the triangle that the inverse kinematics solves.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Arc

from .. import arm, dh
from ._arm import arm_side_view
from ._style import COLOURS, OUTLINE

# The pose drawn: upper arm raised, forearm lowered, gripper level.
POSE = np.pi / 180 * np.array([0, 50, -75, 115, 0])

# Orthographic view from in front of the arm's plane, a little from the left and from above.
AZIMUTH, ELEVATION = np.pi / 180 * np.array([-112, 20])
RIGHT = np.array([-np.sin(AZIMUTH), np.cos(AZIMUTH), 0])
UP = np.array([-np.sin(ELEVATION) * np.cos(AZIMUTH), -np.sin(ELEVATION) * np.sin(AZIMUTH), np.cos(ELEVATION)])
VIEW = np.stack([RIGHT, UP], axis=1)

# Where the angles of the first and last joint are written, in points from it; the others have arcs in the plane.
ANGLE_OFFSETS = {0: (-32, -6), 4: (22, 14)}


def dh_schema(ax: Axes) -> Axes:
    """The arm as a chain of five joints, with the frames 0, 1, 2, 3 and 5 of Table 1.2 and its four lengths.

    >>> ax = drawing.dh_schema(plt.figure().gca())
    """
    T, points = arm.link_frames(POSE), arm.joint_positions(POSE)
    ax.plot(*(points @ VIEW).T, color="black", linewidth=4, zorder=1)
    for i, axis_frame in enumerate(T[:5]):
        # Joint i turns about z of the frame before it; the fifth is set a little along the gripper's axis.
        at = axis_frame[:3, 3] + (0.25 * arm.LYNX.L_3 if i == 4 else 0) * axis_frame[:3, 2]
        _cylinder(ax, at, axis_frame[:3, 2], 0.015)
        if i in ANGLE_OFFSETS:
            ax.annotate(f"$\\theta_{i + 1}$", at @ VIEW, xytext=ANGLE_OFFSETS[i], textcoords="offset points")
        else:
            _angle(ax, at, 0.075, axis_frame[:3, 0], axis_frame[:3, 1], POSE[i], f"$\\theta_{i + 1}$")
    for i in (0, 1, 2, 3, 5):
        _triad(ax, T[i], 0.05, str(i))
    sides = (0.07, 0.075, 0.085, -0.055)  # of the line between the joints, clear of the frames
    for name, start, end, side in zip(("d_1", "L_1", "L_2", "L_3"), points[:-1], points[1:], sides, strict=True):
        _dimension(ax, start @ VIEW, end @ VIEW, side, f"${name}$")
    return _bare(ax)


def wrist_schema(ax: Axes) -> Axes:
    """How frame 3 becomes frame 5: turned about z_3 by theta_4, tipped about x_4, moved along z_4 by L_3.

    >>> ax = drawing.wrist_schema(plt.figure().gca())
    """
    T = arm.link_frames(POSE)
    words = (
        "frame 3\n$x_3$ along\nthe forearm",
        "frame 4\n$\\theta_4$ about $z_3$,\n90° about $x_4$",
        "frame 5\n$\\theta_5$ about $z_4$,\n$L_3$ along $z_4$",
    )
    for i, text in zip((3, 4, 5), words, strict=True):
        frame = T[i].copy()
        frame[:3, 3] = (i - 3) * 0.2 * RIGHT
        _triad(ax, frame, 0.09, str(i))
        x, y = frame[:3, 3] @ VIEW
        ax.text(x + 0.02, y - 0.09, text, ha="center", va="top")
    return _bare(ax)


def link_schema(ax: Axes) -> Axes:
    """One link in general: how theta, d, a and alpha lead from frame i-1 to frame i; report eq. (1.1).

    Numbers mark the four steps by which frame i is placed: axes, common normal with x_i, origin, y_i.

    >>> ax = drawing.link_schema(plt.figure().gca())
    """
    a, alpha, d, theta = 0.36, 0.55, 0.24, 0.5
    end = np.array(dh.standard(dh.Row(a, alpha, d, theta)), float)
    tip, z, x_before, x = end[:3, 3], np.array([0, 0, 1.0]), np.array([1.0, 0, 0]), end[:3, 0]
    foot = d * z
    _polyline(ax, [0 * z, foot, tip], color="black", linewidth=3, zorder=1)
    for i, point, axis in (("i", 0 * z, z), ("i+1", tip, end[:3, 2])):
        low, high = point - 0.06 * axis, point + 0.32 * axis
        _polyline(ax, [low, high], color=COLOURS["aid"], linestyle="--", linewidth=1)
        ax.annotate(f"axis of joint ${i}$", high @ VIEW, xytext=(0, 4), textcoords="offset points", ha="center")
    _polyline(ax, [foot, foot + 0.2 * x_before], color=COLOURS["x"], linestyle=":")
    _polyline(ax, [tip, tip + 0.2 * z], color=COLOURS["z"], linestyle=":")
    _triad(ax, np.eye(4), 0.1, "{i-1}")
    _triad(ax, end, 0.1, "i")
    _angle(ax, foot, 0.16, x_before, np.cross(z, x_before), theta, r"$\theta$")
    _angle(ax, tip, 0.17, z, np.cross(x, z), alpha, r"$\alpha$")
    for name, middle in (("$d$", foot / 2), ("$a$", (foot + tip) / 2)):
        ax.annotate(name, middle @ VIEW, xytext=(-20, 10), textcoords="offset points", fontsize=13)
    _number_steps(ax, foot, end)
    return _bare(ax)


def triangle_schema(ax: Axes) -> Axes:
    """The triangle of shoulder, elbow and wrist from the side, with its sides and the angles of its two joints.

    >>> ax = drawing.triangle_schema(plt.figure().gca())
    """
    q = np.pi / 180 * np.array([0, 75, -70, 65, 0])
    _, shoulder, elbow, wrist, _ = arm.joint_positions(q)[:, [0, 2]]
    arm_side_view(ax, q)
    below_wrist, beyond_elbow = np.array([wrist[0], shoulder[1]]), 1.4 * elbow - 0.4 * shoulder
    dotted = [shoulder, below_wrist, wrist], [elbow, beyond_elbow]
    for corners, line in (([shoulder, wrist], "--"), (dotted[0], ":"), (dotted[1], ":")):
        ax.plot(*np.transpose(corners), line, color=COLOURS["aid"])
    for at, start, end in ((shoulder, 0, 75), (elbow, 5, 75)):
        ax.add_patch(Arc(at, 0.09, 0.09, theta1=start, theta2=end))
    names = {
        "$r_{wrist}$": ((shoulder + below_wrist) / 2, (0, -16)),
        "$h$": ((below_wrist + wrist) / 2, (12, 0)),
        "$L_1$": ((shoulder + elbow) / 2, (-18, 6)),
        "$L_2$": ((elbow + wrist) / 2, (16, 14)),
        "$\\theta_2$": (shoulder, (44, 10)),
        "$\\theta_3$": (elbow, (36, 28)),
    }
    for name, (place, offset) in names.items():
        ax.annotate(name, place, xytext=offset, textcoords="offset points", ha="center", va="center", fontsize=14)
    ax.margins(0.12)
    return ax


def _number_steps(ax: Axes, foot: np.ndarray, end: np.ndarray) -> None:
    """The steps of the recipe: 1 at both axes, 2 at the common normal from ``foot``, 3 at the origin, 4 at y."""
    _, y, z, tip = end[:3].T
    marked = (
        (1, [0, 0, -0.06], (16, 0)),
        (1, tip + 0.32 * z, (22, -10)),
        (2, (3 * foot + tip) / 4, (-8, 18)),
        (3, tip, (18, -20)),
        (4, tip + 0.1 * y, (-26, -4)),
    )
    style = {"boxstyle": "circle", "facecolor": "white", "edgecolor": COLOURS["link"]}
    for step, place, offset in marked:
        text = ax.annotate(str(step), tuple(place @ VIEW), xytext=offset, textcoords="offset points", bbox=style)
        text.set(ha="center", va="center")


def _polyline(ax: Axes, points: list[np.ndarray], **style) -> None:
    ax.plot(*np.transpose(np.array(points) @ VIEW), **style)


def _angle(
    ax: Axes, centre: np.ndarray, radius: float, u: np.ndarray, v: np.ndarray, angle: float, name: str
) -> None:
    """An arc about ``centre`` from the direction ``u`` by ``angle`` towards ``v``, with its name beyond it."""
    turn = np.linspace(0, angle, 31)[:, None]
    arc = radius * (np.cos(turn) * u + np.sin(turn) * v)
    _polyline(ax, centre + arc, color="black", linewidth=1)
    head = {"arrowstyle": "-|>", "color": "black", "linewidth": 1, "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", (centre + arc[30]) @ VIEW, xytext=(centre + arc[27]) @ VIEW, arrowprops=head)
    x, y = (centre + 1.2 * arc[15]) @ VIEW
    ax.text(x, y, name, ha="center", va="center", fontsize=13)


def _bare(ax: Axes) -> Axes:
    ax.set(aspect="equal")
    ax.set_axis_off()
    ax.margins(0.08)
    ax.autoscale_view()
    return ax


def _triad(ax: Axes, T: np.ndarray, length: float, index: str) -> None:
    origin = T[:3, 3] @ VIEW
    for i, axis in enumerate("xyz"):
        tip = (T[:3, 3] + length * T[:3, i]) @ VIEW
        arrow = {"arrowstyle": "-|>", "color": COLOURS[axis], "linewidth": 2, "shrinkA": 0, "shrinkB": 0}
        ax.annotate("", tip, xytext=origin, arrowprops=arrow, zorder=5)
        along = (tip - origin) / np.linalg.norm(tip - origin)
        size = len(index)
        beside = 3 * size * along + (11 + 2 * size) * np.array([along[1], -along[0]])  # in points
        name = ax.annotate(f"${axis}_{index}$", tip, xytext=beside, textcoords="offset points", zorder=6)
        name.set(color=COLOURS[axis], ha="center", va="center", path_effects=OUTLINE)
        ax.update_datalim([origin, origin + 1.22 * (tip - origin)])


def _cylinder(ax: Axes, centre: np.ndarray, axis: np.ndarray, radius: float) -> None:
    """A joint: a short cylinder about its axis, drawn as its two ends and the band between them."""
    across = np.cross(axis, [1.0, 0, 0] if abs(axis[0]) < 0.9 else [0, 1.0, 0])
    across /= np.linalg.norm(across)
    turn = np.linspace(0, 2 * np.pi, 61)[:, None]
    circle = radius * (np.cos(turn) * across + np.sin(turn) * np.cross(axis, across))
    toward_reader = np.sign(axis @ np.cross(RIGHT, UP)) or 1
    far, near = ((centre + s * toward_reader * 1.6 * radius * axis + circle) @ VIEW for s in (-1, 1))
    for k in range(60):
        ax.fill(*np.array([far[k], far[k + 1], near[k + 1], near[k]]).T, color="#9ecae1", linewidth=0.5, zorder=2)
    ax.fill(*near.T, facecolor="#deebf7", edgecolor="#3182bd", linewidth=1, zorder=3)


def _dimension(ax: Axes, start: np.ndarray, end: np.ndarray, offset: float, text: str) -> None:
    """A length beside the line from ``start`` to ``end``, ``offset`` to its left."""
    direction = (end - start) / np.linalg.norm(end - start)
    shift = offset * np.array([-direction[1], direction[0]])
    line = {"arrowstyle": "|-|,widthA=0.25,widthB=0.25", "color": COLOURS["aid"], "shrinkA": 0, "shrinkB": 0}
    (x_0, y_0), (x_1, y_1), (x, y) = start + shift, end + shift, (start + end) / 2 + 1.5 * shift
    ax.annotate("", (x_1, y_1), xytext=(x_0, y_0), arrowprops=line)
    ax.text(x, y, text, ha="center", va="center", fontsize=13)
    ax.update_datalim([start + 1.8 * shift, end + shift])
