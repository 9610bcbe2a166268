"""Explorer of B2: a motion that is played, or moved by hand, with its joint angles."""

from collections.abc import Callable

import ipywidgets as widgets
import numpy as np

from ... import arm, drawing
from ...errors import InputError
from .panel import beside, over_a_background, picture_frame

PACE = 60  # milliseconds from sample to sample


def motion_explorer(q: np.ndarray, geometry: arm.Geometry = arm.LYNX) -> widgets.Widget:
    """A play button and a slider for the sample of a motion q, (n, 5) radians; the arm and its angles follow."""
    q = np.asarray(q, dtype=float)
    if q.ndim != 2 or q.shape[1] != 5 or not len(q) or not np.isfinite(q).all():
        raise InputError(f"A motion has finite joint angles (n, 5); {q.shape} was given.")
    last = len(q) - 1
    play = widgets.Play(value=0, min=0, max=last, interval=PACE)
    slider = widgets.IntSlider(0, min=0, max=last, description="sample")
    slider.style.description_width, slider.layout.width = "50px", "250px"
    words, image, picture = widgets.HTML(), picture_frame(), _motion_view(q, geometry)

    def update(_: object = None) -> None:
        image.value = picture(slider.value)
        words.value = _in_words(q[slider.value], geometry)

    widgets.link((play, "value"), (slider, "value"))
    slider.observe(update, "value")
    update()
    return beside([play, slider, words], image)


def _motion_view(q: np.ndarray, geometry: arm.Geometry) -> Callable[[int], bytes]:
    fig, space, plot = drawing.two_views(8, 4)
    places = arm.joint_positions(q, geometry)
    around = 0.2 * sum(geometry) * np.array([[-1, -1, 0], [1, 1, 0]])  # room, where a motion stays in one plane
    drawing.space_3d(space, np.vstack([places.reshape(-1, 3), around]))
    space.plot(*places[:, -1].T, color=drawing.COLOURS["aid"], linewidth=1)
    for joint, angles in enumerate(np.rad2deg(q).T, start=1):
        plot.plot(angles, label=f"$\\theta_{joint}$")
    plot.set(xlabel="sample", ylabel="joint angle [deg]")
    plot.legend(ncols=5, fontsize=8, handlelength=1, loc="upper center", bbox_to_anchor=(0.5, 1.12))
    lines = drawing.arm_3d(space, q[0], geometry)
    now = plot.axvline(0, color=drawing.COLOURS["link"])
    redraw = over_a_background(fig, [*lines, now])

    def picture(sample: int) -> bytes:
        drawing.move(lines, [], q[sample], geometry)
        now.set_xdata([sample, sample])
        return redraw()

    return picture


def _in_words(q: np.ndarray, geometry: arm.Geometry) -> str:
    rows = "\n".join(f"θ{i} {angle:z7.1f}°" for i, angle in zip("₁₂₃₄₅", np.rad2deg(q), strict=True))
    x, y, z = arm.forward_kinematics(q, geometry)[:3, 3]
    return f"<pre>{rows}\n\ngripper at\n({x:z.3f}, {y:z.3f}, {z:z.3f}) m</pre>"
