"""Explorer of A1: five joint angles, and the pose that they make."""

from collections.abc import Callable

import ipywidgets as widgets
import numpy as np

from ... import arm, drawing
from .panel import beside, over_a_background, picture_frame, slider

HOME_DEG = (60, 45, -30, 60, 30)  # report Table 1.3


def arm_explorer(geometry: arm.Geometry = arm.LYNX) -> widgets.Widget:
    """Five sliders (degrees) for the joints; the arm in space and in its own plane and its pose follow."""
    names = [f"θ{i}" for i in "₁₂₃₄₅"]
    sliders = [slider(*facts) for facts in zip(names, np.rad2deg(arm.JOINT_LIMITS).round(), HOME_DEG, strict=True)]
    with_frames = widgets.Checkbox(description="link frames", indent=False)
    reset = widgets.Button(description="reset")
    readout, image = widgets.HTML(), picture_frame()
    picture = _arm_view(geometry)

    def update(_: object = None) -> None:
        q = np.deg2rad([control.value for control in sliders])
        image.value = picture(q, with_frames.value)
        readout.value = _pose_as_text(arm.forward_kinematics(q, geometry))

    def home(_: object) -> None:
        for control, value in zip(sliders, HOME_DEG, strict=True):
            control.value = value

    for control in (*sliders, with_frames):
        control.observe(update, "value")
    reset.on_click(home)
    update()
    return beside([*sliders, with_frames, reset, readout], image)


def _arm_view(geometry: arm.Geometry) -> Callable[[np.ndarray, bool], bytes]:
    """The picture of ``arm_explorer`` as a function of the joint angles and of whether frames are shown."""
    d_1, *links = geometry
    reach, q = sum(links), np.deg2rad(HOME_DEG)
    fig, space, plane = drawing.two_views(8, 4)
    drawing.space_3d(space, 0.8 * reach * np.array([[-1, -1, 0], [1, 1, 1]]) + [0, 0, d_1])
    plane.set(xlim=(-1.1 * reach, 1.1 * reach), ylim=(d_1 - 1.1 * reach, d_1 + 1.1 * reach))
    frames = arm.link_frames(q, geometry)
    links = drawing.arm_3d(space, q, geometry), drawing.arm_side_view(plane, q, geometry)
    axes = drawing.frames_3d(space, frames), drawing.frames_side_view(plane, frames, q)
    redraw = over_a_background(fig, [line for pair in (links, axes) for lines in pair for line in lines])

    def picture(q: np.ndarray, with_frames: bool) -> bytes:
        drawing.move(*links, q, geometry)
        drawing.move(*axes, q, geometry, frames=arm.link_frames(q, geometry))
        for line in (*axes[0], *axes[1]):
            line.set_visible(with_frames)
        return redraw()

    return picture


def _pose_as_text(pose: np.ndarray) -> str:
    rows = "\n".join(" ".join(f"{value:z6.3f}" for value in row) for row in pose)
    x, y, z = pose[:3, 3]
    return f"<pre>T_0_5 =\n{rows}\n\ngripper at\n({x:z.4f}, {y:z.4f}, {z:z.4f}) m</pre>"
