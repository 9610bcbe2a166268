"""Two pictures are the same where nobody can see a difference, and not where one digit is another."""

import base64
import functools
import io

import matplotlib.pyplot as plt
import numpy as np
import pytest
from PIL import Image

from lynx_common import drawing
from lynx_common.course import pictures


@functools.cache
def drawn(label="0.36", *, colour="x", shift=0.0, lines=3, size=(6.4, 4.8)) -> str:
    """A figure as the notebooks have it, as a base64 PNG; its smallest print is of 8 points."""
    with plt.rc_context():
        drawing.use_style()
        fig, ax = plt.subplots(figsize=size)
        for i, name in zip(range(lines), ("z", colour, "link"), strict=False):
            ax.plot([0, 1, 2], [i, i + 1, i], color=drawing.COLOURS[name], linewidth=1.5)
        ax.set_xticks([1], [label], fontsize=8)
        ax.text(0.5, 2.5 + shift, "elbow", fontsize=8)
        ax.set(xlabel="time [s]", xlim=(0, 2), ylim=(0, 3.2))
        buffer = io.BytesIO()
        fig.savefig(buffer, format="png")
        plt.close(fig)
    return base64.b64encode(buffer.getvalue()).decode()


@functools.cache
def kept(png: str, before: str | None = None) -> str:
    """What is stored of a picture."""
    outputs = [{"data": {pictures.PNG: png}}]
    pictures.settle(outputs, [before] if before else [])
    return pictures.of(outputs)[0]


def test_a_fresh_drawing_is_the_same_as_the_stored_one_of_256_colours():
    stored = kept(drawn())
    picture = Image.open(io.BytesIO(base64.b64decode(stored)))
    assert picture.mode == "P"
    assert len(picture.getcolors()) <= 256
    assert len(stored) < 0.6 * len(drawn())
    assert pictures.difference(stored, drawn()) == ""


def test_noise_as_of_another_processor_is_not_seen():
    levels = pictures.pixels(drawn())
    noise = np.random.default_rng(0).integers(-2, 3, levels.shape)
    noise[np.abs(levels - 128).max(axis=-1) < 128] *= 12  # at the edges of lines and letters
    picture = Image.fromarray((levels + noise).clip(0, 255).astype(np.uint8))
    buffer = io.BytesIO()
    picture.save(buffer, "png")
    assert pictures.difference(kept(drawn()), base64.b64encode(buffer.getvalue()).decode()) == ""


@pytest.mark.parametrize(
    "other",
    [
        {"label": "0.38"},
        {"label": "0.35"},
        {"label": "\N{MINUS SIGN}0.36"},
        {"label": "036"},
        {"colour": "target"},  # of all pairs of colours those two are the nearest
        {"shift": 0.02},
        {"lines": 2},
        {"size": (6.4, 4.81)},
    ],
    ids=str,
)
@pytest.mark.parametrize("size", [(6.4, 4.8), (12, 6)])
def test_what_can_be_seen_is_a_difference(other, size):
    stored = kept(drawn(size=size))
    assert pictures.difference(stored, drawn(**{"size": size} | other)).startswith("picture differs: ")


def test_any_two_colours_of_the_course_differ_by_more_than_is_allowed():
    colours = [np.array(plt.matplotlib.colors.to_rgb(c)) * 255 for c in drawing.COLOURS.values()]
    apart = [np.abs(a - b).max() for i, a in enumerate(colours) for b in colours[:i]]
    assert min(apart) > 1.5 * pictures.LEVELS


def test_a_stored_picture_is_kept_until_a_difference_can_be_seen():
    stored = kept(drawn())
    assert kept(drawn(), before=stored) == stored
    changed = kept(drawn(label="0.38"), before=stored)
    assert changed == kept(drawn(label="0.38"))
    assert changed != stored
    assert kept(drawn(), before=drawn()) == stored  # all colours: not as it is stored


def test_transparency_is_kept():
    picture = Image.new("RGBA", (20, 20), (255, 255, 255, 0))
    picture.paste((200, 0, 0, 255), (5, 5, 12, 12))
    buffer = io.BytesIO()
    picture.save(buffer, "png")
    png = base64.b64encode(buffer.getvalue()).decode()
    np.testing.assert_array_equal(pictures.pixels(kept(png))[..., 3], pictures.pixels(png)[..., 3])
