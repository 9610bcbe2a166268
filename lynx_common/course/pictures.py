"""Stored pictures: 256 colours each, and the same picture as long as nobody could see a difference."""

import base64
import io
from collections.abc import Iterable
from itertools import chain, repeat

import numpy as np
from PIL import Image

PNG = "image/png"
COLOURS = 256

# Grey levels, of 255, by which the mean over 3 x 3 pixels may differ, anywhere and in any channel. Measured over
# all figures of the course: 256 colours in place of all, and other processors, make up to 14. A digit changed in
# black print of 8 points makes 68 or more, and the two nearest colours of the course are 63 apart.
LEVELS = 28


def of(outputs: Iterable[dict]) -> list[str]:
    """The base64 PNGs among the outputs of a cell, in order."""
    return [output["data"][PNG] for output in outputs if PNG in output.get("data", {})]


def settle(outputs: Iterable[dict], before: Iterable[str]) -> None:
    """Make pictures just drawn ready to be stored, in place of those that were stored ``before``."""
    shown = [output for output in outputs if PNG in output.get("data", {})]
    for output, old in zip(shown, chain(before, repeat(None)), strict=False):
        output["data"][PNG] = _to_store(output["data"][PNG], old)


def difference(stored: str, drawn: str) -> str:
    """How two base64 PNGs differ, in a sentence; empty if they are the same picture."""
    a, b = pixels(stored), pixels(drawn)
    if a.shape != b.shape:
        return f"picture differs: {_size(a)} pixels stored, {_size(b)} drawn"
    off = np.abs(_means(a - b)).max(axis=-1)
    if (largest := off.max()) <= LEVELS:
        return ""
    y, x = np.unravel_index(off.argmax(), off.shape)
    return (
        f"picture differs: by {largest:.0f} grey levels at x = {x + 1}, y = {y + 1} of {_size(a)} pixels, "
        f"where {LEVELS} are allowed"
    )


def pixels(png: str) -> np.ndarray:
    """Height, width, RGBA of a base64 PNG; signed, so that levels can be subtracted."""
    return np.asarray(_opened(png).convert("RGBA"), dtype=np.int16)


def _to_store(drawn: str, before: str | None) -> str:
    """What to store for the base64 PNG ``drawn``: the picture that is stored already, unless it differs."""
    if before and _opened(before).mode == "P" and not difference(before, drawn):
        return before
    picture = _opened(drawn).convert("RGBA")
    if picture.getchannel("A").getextrema() == (255, 255):
        picture = picture.convert("RGB")
    # Of Pillow's methods this one moves colours the least; without dither, so that flat areas stay flat.
    few = picture.quantize(COLOURS, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    file = io.BytesIO()
    few.save(file, "png", optimize=True)
    return base64.b64encode(file.getvalue()).decode()


def _opened(png: str) -> Image.Image:
    return Image.open(io.BytesIO(base64.b64decode(png)))


def _means(levels: np.ndarray) -> np.ndarray:
    """Means over every 3 x 3 pixels: (h, w, n) to (h - 2, w - 2, n)."""
    rows = levels[:-2] + levels[1:-1] + levels[2:]
    return (rows[:, :-2] + rows[:, 1:-1] + rows[:, 2:]) / 9


def _size(picture: np.ndarray) -> str:
    return f"{picture.shape[1]} x {picture.shape[0]}"
