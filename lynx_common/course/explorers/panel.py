"""What all explorers share: sliders, a picture beside them, and drawing over a stored background."""

from collections.abc import Callable
from io import BytesIO

import ipywidgets as widgets
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.artist import Artist
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image


def slider(name: str, limits: np.ndarray, value: float, step: float = 1) -> widgets.FloatSlider:
    """A slider as all explorers have it; with a step below 1 it shows two decimals."""
    low, high = limits
    digits = 0 if step >= 1 else 2
    control = widgets.FloatSlider(
        value, min=low, max=high, step=step, description=name, readout_format=f".{digits}f"
    )
    control.style.description_width, control.layout.width = "40px", "250px"
    return control


def beside(controls: list[widgets.Widget], image: widgets.Image) -> widgets.Widget:
    """The controls in a column, and the picture to their right, or below them where there is no room."""
    column = widgets.VBox(controls, layout=widgets.Layout(flex="0 0 260px"))
    return widgets.HBox([column, image], layout=widgets.Layout(flex_flow="row wrap"))


def picture_frame() -> widgets.Image:
    """Where an explorer shows its picture."""
    return widgets.Image(layout=widgets.Layout(width="680px", height="340px"))


def over_a_background(fig: Figure, moving: list[Artist]) -> Callable[[], bytes]:
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
