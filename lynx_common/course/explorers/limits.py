"""Explorer of A2: limits of shoulder and elbow, and the exact section and volume that they leave."""

from collections.abc import Callable

import ipywidgets as widgets
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from ... import arm, drawing, workspace
from ...arcs import Region
from .panel import beside, over_a_background, picture_frame

POINTS = ("wrist", "gripper")
LIGHT, DARK = 0.3, 1.0  # what theta_1 adds as it turns the arm's plane, and the section in that plane itself
NARROWEST = 5  # degrees between the two limits of a joint


def limits_explorer(geometry: arm.Geometry = arm.LYNX) -> widgets.Widget:
    """Range sliders (deg) for theta_2 and theta_3; the section of wrist and gripper, areas and volumes follow."""
    sliders = [_range("θ₂", (-180, 180), (-90, 90)), _range("θ₃", (-180, 180), (-90, 90))]
    words, image, picture = widgets.HTML(), picture_frame(), _section_view(geometry)

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
    return beside([*sliders, words], image)


def _range(name: str, limits: tuple[int, int], value: tuple[int, int]) -> widgets.FloatRangeSlider:
    low, high = limits
    control = widgets.FloatRangeSlider(
        value=value, min=low, max=high, step=5, description=name, readout_format=".0f"
    )
    control.style.description_width, control.layout.width = "25px", "250px"
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
    redraw = over_a_background(fig, patches)

    def picture(regions: dict[str, tuple[Region, Region]]) -> bytes:
        shown = [region for point in POINTS for region in regions[point][::-1]]
        for patch, region in zip(patches, shown, strict=True):
            patch.set_path(drawing.region_path(region))
        return redraw()

    return picture


def _in_words(regions: dict[str, tuple[Region, Region]]) -> str:
    rows = [
        f"<tr><td>{point}</td><td>{own.area * 1e4:z.1f} cm²</td><td>{turned.volume * 1e3:z.2f} litres</td></tr>"
        for point, (own, turned) in regions.items()
    ]
    return f"<table><tr><td></td><td>section</td><td>volume</td></tr>{''.join(rows)}</table>"
