"""Figures are shown with a caption, closed, and saved where and when they are asked for."""

import matplotlib.pyplot as plt
import pytest
import sympy as sp
from PIL import Image

from lynx_common.course import figures
from lynx_common.errors import InputError


def line():
    fig, ax = plt.subplots(figsize=(2, 1))
    ax.plot([0, 1])
    return fig


@pytest.fixture
def fig():
    yield line()
    plt.close("all")


@pytest.fixture
def shown(monkeypatch):
    outputs = []
    monkeypatch.setattr(figures, "display", lambda *things: outputs.extend(things))
    return outputs


def test_a_figure_is_shown_once_with_its_words_and_closed(fig, shown, monkeypatch):
    monkeypatch.delenv("LYNX_FIGURES", raising=False)
    figures.publish(fig, "1.2", "A line.")
    picture, caption = shown
    assert picture.data.startswith(b"\x89PNG")
    assert picture.alt == caption.data == "**Fig. 1.2.** A line."
    assert not plt.get_fignums()


@pytest.mark.parametrize("number", ["The arm.", "", "12", "1.2 ", "1.2aa"])
def test_a_figure_of_the_report_has_a_number(number, fig):
    for call in (lambda: figures.publish(fig, number, "A line."), lambda: figures.movie(fig, print, 1, number)):
        with pytest.raises(InputError, match="A figure has a number"):
            call()


def test_a_figure_of_the_courses_own_has_a_name(fig, shown, monkeypatch, tmp_path):
    monkeypatch.setenv("LYNX_FIGURES", str(tmp_path))
    monkeypatch.setenv("LYNX_FIGURE", "card")
    figures.publish(fig, "card", "Cut out.")
    assert shown[1].data == "**Card.** Cut out."
    assert sorted(path.name for path in tmp_path.iterdir()) == ["fig-card.pdf", "fig-card.png", "fig-card.svg"]
    assert not figures.is_called("card", "car")


def test_files_are_written_where_make_figures_asks_and_are_the_same_each_time(fig, shown, monkeypatch, tmp_path):
    monkeypatch.setenv("LYNX_FIGURES", str(tmp_path))
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "0")
    monkeypatch.setitem(plt.rcParams, "svg.hashsalt", "lynx")
    figures.publish(fig, "1.2")
    first = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert sorted(first) == ["fig-1.2.pdf", "fig-1.2.png", "fig-1.2.svg"]
    assert Image.open(tmp_path / "fig-1.2.png").size == (600, 300)
    figures.publish(line(), "1.2")
    assert first == {path.name: path.read_bytes() for path in tmp_path.iterdir()}


def test_a_movie_is_written_where_asked_for_and_is_the_same_each_time(fig, monkeypatch, tmp_path):
    def draw(i):
        drawn.append(i)
        fig.axes[0].lines[0].set_ydata([0, i])

    drawn = []
    fig.set_layout_engine("none")  # whatever style another test has set
    monkeypatch.delenv("LYNX_FIGURES", raising=False)
    figures.movie(fig, draw, 3, "1.2")
    assert drawn == []
    assert not plt.get_fignums()
    monkeypatch.setenv("LYNX_FIGURES", str(tmp_path))
    figures.movie(fig, draw, 3, "1.2", seconds=0.6)
    assert drawn == [0, 1, 2]
    first = (tmp_path / "fig-1.2.gif").read_bytes()
    with Image.open(tmp_path / "fig-1.2.gif") as film:
        assert (film.n_frames, film.size, film.info["duration"]) == (3, (200, 100), 200)
    figures.movie(fig, draw, 3, "1.2", seconds=0.6)
    assert (tmp_path / "fig-1.2.gif").read_bytes() == first


def test_only_the_figure_asked_for_is_written(fig, shown, monkeypatch, tmp_path):
    monkeypatch.setenv("LYNX_FIGURES", str(tmp_path))
    monkeypatch.setenv("LYNX_FIGURE", "1.1")
    figures.publish(fig, "1.2")
    assert not list(tmp_path.iterdir())
    figures.publish(fig, "1.1")
    assert len(list(tmp_path.iterdir())) == 3


def test_a_table_shows_numbers_to_four_digits_without_negative_zeros(shown):
    figures.table(["what", "value"], [["angles", [1.23456, -1e-9]], ["length", 0.1]], "**Fig. 9.**")
    table, caption = shown
    assert table.data == "| what | value |\n| :-- | :-- |\n| angles | 1.2346, 0.0000 |\n| length | 0.1000 |"
    assert caption.data == "**Fig. 9.**"


def test_a_table_shows_counts_and_formulas_as_they_are(shown):
    figures.table(["$i$", "$d_i$"], [[1, sp.pi / 2], [2, sp.Symbol("d_1")]], "Two rows.")
    assert shown[0].data.splitlines()[2:] == [r"| 1 | $\frac{\pi}{2}$ |", "| 2 | $d_{1}$ |"]


@pytest.mark.parametrize(
    ("name", "written"), [("1.3", True), ("1.3b", True), ("1.3a", False), ("1", False), ("1.33", False)]
)
def test_the_number_alone_means_all_panels(name, written, fig, shown, monkeypatch, tmp_path):
    monkeypatch.setenv("LYNX_FIGURES", str(tmp_path))
    monkeypatch.setenv("LYNX_FIGURE", name)
    figures.publish(fig, "1.3b")
    assert bool([*tmp_path.iterdir()]) == written


def test_a_table_that_is_a_figure_of_the_report_is_drawn_where_asked_for(shown, monkeypatch, tmp_path):
    monkeypatch.setenv("LYNX_FIGURES", str(tmp_path))
    monkeypatch.setenv("LYNX_FIGURE", "fig-2.1 2.2")
    rows = [["leg", 1.0], ["another, longer one", [1.0, 2.0]]]
    figures.table(["$\\theta_1$", "value"], rows, "**Table 2.2.** No figure.")
    figures.table(["$\\theta_1$", "value"], rows, "**Fig. 2.3.** Not asked for.")
    assert not list(tmp_path.iterdir())
    figures.table(["$\\theta_1$", "value"], rows, "**Fig. 2.2.** A table.")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["fig-2.2.pdf", "fig-2.2.png", "fig-2.2.svg"]
    assert not plt.get_fignums()


def test_a_drawn_table_holds_every_entry_within_it_and_none_upon_another():
    fig = figures.drawn([["$\\theta_1$ [deg]", "b"], ["a much longer entry", "-1.0000"], ["", "last"]])
    fig.canvas.draw()
    boxes = [text.get_window_extent() for text in fig.texts if text.get_text()]
    assert [text.get_text() for text in fig.texts][2:] == ["a much longer entry", "-1.0000", "", "last"]
    for box in boxes:
        assert 0 < box.x0 < box.x1 < fig.bbox.width
        assert 0 < box.y0 < box.y1 < fig.bbox.height
        assert sum(box.overlaps(other) for other in boxes) == 1
    plt.close(fig)
