"""Explorer of A2: limits of shoulder and elbow, and the exact section and volume that they leave."""

from base64 import b64encode
from collections.abc import Callable, Sequence
from io import BytesIO
from typing import Any

import ipywidgets as widgets
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from PIL import Image

from ... import arm, drawing, workspace
from ...arcs import Region

POINTS = ("wrist", "gripper")
LIGHT, DARK = 0.3, 1.0  # what theta_1 adds as it turns the arm's plane, and the section in that plane itself
NARROWEST = 5  # degrees between the two limits of a joint


def limits_explorer(geometry: arm.Geometry = arm.LYNX) -> widgets.Widget:
    """Range sliders (deg) for theta_2 and theta_3; the section of wrist and gripper, areas and volumes follow."""
    sliders = [_range("θ₂ [°]", (-180, 180), (-90, 90)), _range("θ₃ [°]", (-180, 180), (-90, 90))]
    words, picture = widgets.HTML(), _section_view(geometry)
    image = widgets.Image(layout=widgets.Layout(width="800px", height="400px"))

    def update(_: object = None) -> None:
        for control in sliders:
            low, high = control.value
            if high - low < NARROWEST:
                low = min(low, control.max - NARROWEST)
                control.value = (low, low + NARROWEST)
        turn = np.array([0, 360])
        limits = np.deg2rad([turn, *(control.value for control in sliders), turn])
        own = {point: workspace.section(limits, point, geometry=geometry) for point in POINTS}
        regions = {point: (region, region | region.mirror()) for point, region in own.items()}
        image.value = picture(regions)
        words.value = _in_words(regions)

    for control in sliders:
        control.observe(update, "value")
    update()
    return Explorer([widgets.VBox([*sliders, words]), image], layout=widgets.Layout(max_width="920px"))


class Explorer(widgets.VBox):
    """Controls above a picture; where widgets are not drawn, the picture as it was when the explorer was shown."""

    def _repr_mimebundle_(self, **kwargs: object) -> tuple[dict, dict]:
        still = {"image/png": b64encode(self.children[-1].value).decode()}
        words = (
            "The section that limits of two joints leave, of the wrist and of the gripper; two sliders move it."
        )
        return super()._repr_mimebundle_(**kwargs) | still | {"text/plain": words}, {"image/png": {"alt": words}}


def _range(name: str, limits: tuple[int, int], value: tuple[int, int]) -> widgets.FloatRangeSlider:
    low, high = limits
    control = widgets.FloatRangeSlider(
        value=value, min=low, max=high, step=5, description=name, readout_format=".0f"
    )
    control.style.description_width, control.layout.width = "50px", "640px"
    return control


def _section_view(geometry: arm.Geometry) -> Callable[[dict[str, tuple[Region, Region]]], bytes]:
    d_1, *links = geometry
    reach = 1.1 * sum(links)
    fig, axes = plt.subplots(1, 2, figsize=(8, 4), layout="constrained")
    patches = []
    for ax, point in zip(axes, POINTS, strict=True):
        ax.set(xlim=(-reach, reach), ylim=(d_1 - reach, d_1 + reach), aspect="equal", title=point)
        ax.set(xlabel="r, from the base axis [m]", ylabel="z [m]")
        for alpha in (LIGHT, DARK):
            patches.append(
                PathPatch(Path(np.zeros((1, 2))), color=drawing.COLOURS["right"], alpha=alpha, linewidth=0)
            )
            ax.add_patch(patches[-1])
    redraw = _over_a_background(fig, [*patches, *(ax.title for ax in axes)])

    def picture(regions: dict[str, tuple[Region, Region]]) -> bytes:
        shown = [region for point in POINTS for region in regions[point][::-1]]
        for patch, region in zip(patches, shown, strict=True):
            patch.set_path(drawing.region_path(region))
        for ax, point in zip(axes, POINTS, strict=True):
            ax.set_title(f"{point}: {1e3 * regions[point][1].volume:z.2f} litres")
        return redraw()

    return picture


def _in_words(regions: dict[str, tuple[Region, Region]]) -> str:
    rows = [
        f"<tr><td>{point}</td><td>{own.area * 1e4:z.1f} cm²</td><td>{turned.volume * 1e3:z.2f} litres</td></tr>"
        for point, (own, turned) in regions.items()
    ]
    return f"<table><tr><td></td><td>section</td><td>volume</td></tr>{''.join(rows)}</table>"


def _over_a_background(fig: Figure, moving: Sequence[Any]) -> Callable[[], bytes]:
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
