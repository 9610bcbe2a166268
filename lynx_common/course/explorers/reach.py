"""Explorer of A3: a target and a pitch, and the four branches that reach it, or why none does."""

from collections.abc import Callable

import ipywidgets as widgets
import matplotlib.pyplot as plt
import numpy as np

from ... import arm, drawing
from ...errors import LynxError, OutOfReachError
from .panel import beside, over_a_background, picture_frame, slider

SHADES = (1, 0.4)  # of the two shapes, elbow up and elbow down


def reach_explorer(geometry: arm.Geometry = arm.LYNX) -> widgets.Widget:
    """Sliders for the target's position (m) and pitch (deg); both shapes of the arm and all angles follow."""
    d_1, *links = geometry
    reach = sum(links)
    ranges = ((-reach, reach), (-reach, reach), (d_1 - reach, d_1 + reach))
    homes = np.array([0.6, 0.2, 0.1]) * reach + [0, 0, d_1]
    sliders = [slider(*facts, step=0.01) for facts in zip("xyz", ranges, homes, strict=True)]
    sliders.append(slider("pitch", (-180, 180), 0))
    words, image, picture = widgets.HTML(), picture_frame(), _reach_view(geometry)

    def update(_: object = None) -> None:
        *position, pitch = (control.value for control in sliders)
        q = arm.inverse_kinematics(position, np.deg2rad(pitch), geometry=geometry)
        image.value = picture(np.array(position), np.deg2rad(pitch), q)
        words.value = _in_words(position, np.deg2rad(pitch), q, geometry)

    for control in sliders:
        control.observe(update, "value")
    update()
    return beside([*sliders, words], image)


def _reach_view(geometry: arm.Geometry) -> Callable[[np.ndarray, float, np.ndarray], bytes]:
    d_1, L_1, L_2, L_3 = geometry
    reach, home = L_1 + L_2 + L_3, np.zeros(5)
    fig, space, plane = drawing.two_views(8, 4)
    drawing.space_3d(space, 0.8 * reach * np.array([[-1, -1, 0], [1, 1, 1]]) + [0, 0, d_1])
    plane.set(xlim=(-1.1 * reach, 1.1 * reach), ylim=(d_1 - 1.1 * reach, d_1 + 1.1 * reach))
    for radius in (abs(L_1 - L_2), L_1 + L_2):
        plane.add_patch(plt.Circle((0, d_1), radius, fill=False, linestyle=":", color=drawing.COLOURS["aid"]))
    shapes = [drawing.arm_views(space, plane, home, geometry, alpha=shade) for shade in SHADES]
    mark = {"markersize": 14, "linewidth": 2.5}
    in_space, in_plane = drawing.target(space, np.zeros(3), **mark), drawing.target(plane, np.zeros(2), **mark)
    redraw = over_a_background(fig, [*(line for a, b in shapes for line in (*a, *b)), in_space, in_plane])

    def picture(position: np.ndarray, pitch: float, q: np.ndarray) -> bytes:
        for lines, posture in zip(shapes, q, strict=False):
            for line in (*lines[0], *lines[1]):
                line.set_visible(bool(np.isfinite(posture).all()))
            if np.isfinite(posture).all():
                drawing.move(*lines, posture, geometry)
        azimuth = np.arctan2(position[1], position[0])
        axis = np.array([np.cos(pitch), np.sin(pitch)])
        tip = np.array([np.hypot(*position[:2]), position[2]])
        r, z = np.transpose([tip, tip - L_3 * axis])  # from the target back to where the wrist has to be
        in_space.set_data_3d(r * np.cos(azimuth), r * np.sin(azimuth), z)
        in_plane.set_data(r, z)
        return redraw()

    return picture


def _in_words(position: list[float], pitch: float, q: np.ndarray, geometry: arm.Geometry) -> str:
    try:
        arm.solve(position, pitch, geometry=geometry)
    except OutOfReachError as fault:
        return f"<p>{fault}</p>"
    except LynxError:
        pass  # the joint limits are reported branch by branch
    rows = [
        f"<tr><td>{side}, {elbow}</td><td>{' '.join(f'{angle:z.0f}°' for angle in angles)}</td>"
        f"<td>{'' if inside else 'beyond a limit'}</td></tr>"
        for (side, elbow), angles, inside in zip(arm.BRANCHES, np.rad2deg(q), arm.within_limits(q), strict=True)
    ]
    return f"<table>{''.join(rows)}</table>"
