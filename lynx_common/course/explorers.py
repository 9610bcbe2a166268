"""Interactive views: sliders beside a picture that follows them.

Each keeps one Matplotlib figure, moves its lines over a background that is drawn once, and hands the picture over
as PNG bytes; that is several times faster than drawing anew, and a notebook that holds one can be re-executed.
"""

from collections.abc import Callable
from io import BytesIO

import ipywidgets as widgets
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.artist import Artist
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from .. import arm, drawing

HOME_DEG = (60, 45, -30, 60, 30)  # report Table 1.3


def arm_explorer(geometry: arm.Geometry = arm.LYNX) -> widgets.Widget:
    """Five sliders (degrees) for the joints; the arm in space and in its own plane and its pose follow."""
    names = [f"θ{i}" for i in "₁₂₃₄₅"]
    sliders = [
        _slider(*facts) for facts in zip(names, np.rad2deg(arm.JOINT_LIMITS).round(), HOME_DEG, strict=True)
    ]
    with_frames = widgets.Checkbox(description="link frames", indent=False)
    reset = widgets.Button(description="reset")
    readout, image = widgets.HTML(), widgets.Image(layout=widgets.Layout(width="680px", height="340px"))
    picture = _arm_view(geometry)

    def update(_: object = None) -> None:
        q = np.deg2rad([slider.value for slider in sliders])
        image.value = picture(q, with_frames.value)
        readout.value = _pose_as_text(arm.forward_kinematics(q, geometry))

    def home(_: object) -> None:
        for slider, value in zip(sliders, HOME_DEG, strict=True):
            slider.value = value

    for control in (*sliders, with_frames):
        control.observe(update, "value")
    reset.on_click(home)
    update()
    controls = widgets.VBox([*sliders, with_frames, reset, readout], layout=widgets.Layout(flex="0 0 260px"))
    return widgets.HBox([controls, image], layout=widgets.Layout(flex_flow="row wrap"))


def _slider(name: str, limits: np.ndarray, value: float) -> widgets.FloatSlider:
    low, high = limits
    slider = widgets.FloatSlider(value, min=low, max=high, step=1, description=name, readout_format=".0f")
    slider.style.description_width, slider.layout.width = "25px", "250px"
    return slider


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
    redraw = _over_a_background(fig, [line for pair in (links, axes) for lines in pair for line in lines])

    def picture(q: np.ndarray, with_frames: bool) -> bytes:
        drawing.move(*links, q, geometry)
        drawing.move(*axes, q, geometry, frames=arm.link_frames(q, geometry))
        for line in (*axes[0], *axes[1]):
            line.set_visible(with_frames)
        return redraw()

    return picture


def _over_a_background(fig: Figure, moving: list[Artist]) -> Callable[[], bytes]:
    """A function that draws only the ``moving`` artists, over all the rest drawn once, and returns PNG bytes."""
    plt.close(fig)  # so that the notebook does not show it a second time
    for artist in moving:
        artist.set_animated(True)
    canvas = FigureCanvasAgg(fig)
    canvas.draw()
    background = canvas.copy_from_bbox(fig.bbox)

    def redraw() -> bytes:
        canvas.restore_region(background)
        for artist in moving:
            artist.axes.draw_artist(artist)
        buffer = BytesIO()
        Image.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB").save(buffer, "png", compress_level=1)
        return buffer.getvalue()

    return redraw


def _pose_as_text(pose: np.ndarray) -> str:
    rows = "\n".join(" ".join(f"{value:6.3f}" for value in np.round(row, 3) + 0.0) for row in pose)
    x, y, z = np.round(pose[:3, 3], 4) + 0.0
    return f"<pre>T_0_5 =\n{rows}\n\ngripper at\n({x:.4f}, {y:.4f}, {z:.4f}) m</pre>"
