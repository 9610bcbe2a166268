"""Explorer of Part 3: shoulder and elbow on the map of the determinant, and what the arm can still do there."""

from collections.abc import Callable
from dataclasses import replace

import ipywidgets as widgets
import matplotlib.pyplot as plt
import numpy as np

from ... import arm, drawing
from .panel import beside, over_a_background, picture_frame, slider

PART_3 = arm.Geometry(5, 10, 10, 0)
HOME_DEG = (30, -80)
SPEED = 0.3  # joint speed, in rad/s, whose velocities of the wrist are drawn
AT_FACTOR = 1e-9  # below this, relative to the links, a factor of the determinant counts as zero
ROUND = np.linspace(0, 2 * np.pi, 61)


def singularity_explorer(geometry: arm.Geometry = PART_3) -> widgets.Widget:
    """Sliders (degrees) for theta_2 and theta_3; map, arm, velocity ellipse and singular values follow.

    All is about the wrist; the gripper is left out. theta_1 only turns the picture.
    """
    geometry = replace(geometry, L_3=0)
    sliders = [slider(name, (-180, 180), home) for name, home in zip(("θ₂", "θ₃"), HOME_DEG, strict=True)]
    words, image, picture = widgets.HTML(), picture_frame(), _views(geometry)

    def update(_: object = None) -> None:
        q = np.deg2rad([control.value for control in sliders])
        J = _jacobian(q, geometry)
        image.value = picture(q, J)
        words.value = _in_words(J, geometry)

    for control in sliders:
        control.observe(update, "value")
    update()
    return beside([*sliders, words], image)


def _jacobian(q: np.ndarray, geometry: arm.Geometry) -> np.ndarray:
    """Position Jacobian of the wrist for (theta_2, theta_3), with theta_1 = 0: (..., 2) to (..., 3, 3)."""
    whole = np.zeros((*q.shape[:-1], 5))
    whole[..., 1:3] = q
    return arm.jacobian(whole, geometry)[..., :3, :3]


def _views(geometry: arm.Geometry) -> Callable[[np.ndarray, np.ndarray], bytes]:
    d_1, *links = geometry
    reach = 1.2 * sum(links)
    fig, (chart, plane) = plt.subplots(1, 2, figsize=(8, 4), layout="constrained")
    drawing.determinant_map(chart, geometry)
    (here,) = chart.plot(0, 0, "o", color=drawing.COLOURS["target"], markeredgecolor="black", markersize=11)
    home = np.zeros(5)
    (shape,) = drawing.arm_side_view(plane, home, geometry, with_gripper=False)
    (ellipse,) = plane.plot(0, 0, color=drawing.COLOURS["target"], linewidth=2.5)
    for radius in (sum(links), abs(links[0] - links[1])):
        plane.add_patch(plt.Circle((0, d_1), radius, fill=False, color=drawing.COLOURS["z"]))
    plane.axvline(0, color=drawing.COLOURS["x"], zorder=0)
    plane.set(xlim=(-reach, reach), ylim=(d_1 - reach, d_1 + reach), xlabel="r", ylabel="z")
    redraw = over_a_background(fig, [here, shape, ellipse])

    def picture(q: np.ndarray, J: np.ndarray) -> bytes:
        here.set_data(np.rad2deg(q[:1]), np.rad2deg(q[1:]))
        joints = arm.joint_positions(np.array([0, *q, 0, 0]), geometry)[:4, [0, 2]]
        shape.set_data(*joints.T)
        turns = SPEED * np.array([np.cos(ROUND), np.sin(ROUND)])
        ellipse.set_data(*(joints[-1][:, None] + J[[0, 2], 1:] @ turns))
        return redraw()

    return picture


def _in_words(J: np.ndarray, geometry: arm.Geometry) -> str:
    values, reach = np.linalg.svd(J, compute_uv=False), geometry.L_1 + geometry.L_2
    r, in_plane = J[2, 1], np.linalg.det(J[[0, 2], 1:])
    zero = [
        name
        for name, factor in (("shoulder", r / reach), ("elbow", in_plane / reach**2))
        if abs(factor) < AT_FACTOR
    ]
    slowest = "no joint speed will do" if zero else f"{1 / values[-1]:z.2f} rad/s"
    rows = [
        ("determinant", f"{np.linalg.det(J):z.1f}" if not zero else "0"),
        ("singular values", " ".join(f"{value:z.2f}" for value in values)),
        ("square to the plane", f"{abs(r):z.2f}"),
        ("speed 1 in the worst direction", slowest),
        ("singular", ", ".join(zero) or "no"),
    ]
    return f"<table>{''.join(f'<tr><td>{name}</td><td>{value}</td></tr>' for name, value in rows)}</table>"
