"""Showing a figure in a notebook, with its caption in words, and saving the report's figures as files."""

import os
import re
from collections.abc import Callable
from io import BytesIO
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import sympy as sp
from IPython.display import Image, Markdown, display
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike
from PIL import Image as Picture

from ..errors import InputError

FIGURE = r"\*\*Fig\. (\d\.\d+[a-h]?)\.\*\*"  # how the caption of a figure of the report begins
ROW = 0.3  # of a drawn table, in inches


def publish(fig: Figure, number: str, caption: str = "") -> None:
    """Show ``fig`` as figure ``number`` of the report, e.g. "1.2", and save it where ``make figures`` asks for it.

    A figure of the course's own has a name in place of the number, in small letters, e.g. "card".

    ``make figures`` names the folder in LYNX_FIGURES and may name some figures in LYNX_FIGURE. The files are
    fig-1.2.pdf, .svg and .png (300 dots an inch); they hold no date, so that they can be compared. Raises
    InputError where ``number`` is neither.
    """
    if stem := _stem(number):
        _save(fig, stem)
    heading = f"Fig. {number}" if number[0].isdigit() else number.capitalize()
    show(fig, f"**{heading}.** {caption}".rstrip())


def _save(fig: Figure, stem: Path) -> None:
    fig.savefig(f"{stem}.pdf", dpi=300, metadata={"CreationDate": None})
    fig.savefig(f"{stem}.svg", dpi=300, metadata={"Date": None})
    fig.savefig(f"{stem}.png", dpi=300)


def is_called(number: str, name: str) -> bool:
    """Whether figure ``number`` is meant by ``name``; 1.3 means all of 1.3a to 1.3d, and fig-1.2 is 1.2."""
    return name.removeprefix("fig-") in (number, re.sub(r"(?<=\d)[a-h]$", "", number))


def movie(fig: Figure, draw: Callable[[int], None], frames: int, number: str, seconds: float = 6) -> None:
    """Save ``fig`` in motion as fig-1.8.gif, where ``make figures`` asks for figure ``number``, and close it.

    ``draw(i)`` brings the figure to frame i. Nothing is shown, and elsewhere nothing is drawn.
    """
    if stem := _stem(number):
        canvas, pictures = FigureCanvasAgg(fig), []
        for i in range(frames):
            draw(i)
            canvas.draw()
            pictures.append(Picture.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB").quantize(32))
        pause = round(1000 * seconds / frames)
        pictures[0].save(f"{stem}.gif", save_all=True, append_images=pictures[1:], duration=pause, loop=0)
    plt.close(fig)


def _stem(number: str) -> Path | None:
    """Where files of figure ``number`` belong, without a suffix; None where they are not asked for."""
    if not re.fullmatch(r"\d\.\d+[a-h]?|[a-z]+", number):
        expected = "a number, such as 1.2 or 1.3a, or a name, such as card"
        raise InputError(f"A figure has {expected}; {number!r} was given.")
    folder = os.environ.get("LYNX_FIGURES")
    wanted = os.environ.get("LYNX_FIGURE", number).split()
    if not folder or not any(is_called(number, name) for name in wanted):
        return None
    return Path(folder) / f"fig-{number}"


def show(fig: Figure, caption: str) -> None:
    """Show ``fig`` with ``caption`` below it, which says in words what it shows, and close it."""
    buffer = BytesIO()
    fig.savefig(buffer, format="png", metadata={"Software": None})
    plt.close(fig)
    display(Image(buffer.getvalue(), alt=caption), Markdown(caption))


def table(header: list[str], rows: list[list], caption: str) -> None:
    """Show a table with ``caption`` below it: counts and formulas as they are, other numbers to four decimals.

    Where the caption begins as that of a figure of the report, it is one, and is drawn for ``make figures``.
    """
    lines = [header, *([_text(entry) for entry in row] for row in rows)]
    if (named := re.match(FIGURE, caption)) and (stem := _stem(named[1])):
        _save(fig := drawn(lines), stem)
        plt.close(fig)
    lines.insert(1, [":--"] * len(header))
    display(Markdown("\n".join(f"| {' | '.join(line)} |" for line in lines)), Markdown(caption))


def drawn(lines: list[list[str]]) -> Figure:
    """A table as a figure: one line of entries a row, the first one above a rule."""
    fig = plt.figure(figsize=(1, 1), layout="none")
    weights = ["bold", *["normal"] * (len(lines) - 1)]
    texts = [
        [fig.text(0, 0, entry, va="center", size=11, weight=weight) for entry in line]
        for line, weight in zip(lines, weights, strict=True)
    ]
    renderer = FigureCanvasAgg(fig).get_renderer()
    inches = [[text.get_window_extent(renderer).width / fig.dpi for text in line] for line in texts]
    starts = np.cumsum([0.15, *(max(column) + 0.35 for column in zip(*inches, strict=True))])
    width, height = float(starts[-1]) - 0.2, ROW * (len(lines) + 0.6)
    fig.set_size_inches(width, height)
    for i, line in enumerate(texts):
        for text, start in zip(line, starts[:-1], strict=True):
            text.set_position((start / width, 1 - ROW * (i + 0.8) / height))
    for place, thick in ((0.3, 1.5), (1.3, 0.8), (len(lines) + 0.3, 1.5)):
        y = 1 - ROW * place / height
        fig.add_artist(Line2D([0.05 / width, 1 - 0.05 / width], [y, y], color="black", linewidth=thick))
    return fig


def _text(entry: str | sp.Basic | ArrayLike) -> str:
    if isinstance(entry, str | int):
        return str(entry)
    if isinstance(entry, sp.Basic):
        return f"${sp.latex(entry)}$"
    return ", ".join(f"{value:.4f}" for value in np.round(np.atleast_1d(entry), 4) + 0.0)
