"""The player: one self-contained page that holds the positions it was given, the same at every call."""

import json
import re

import numpy as np
import pytest
from fake_browser import FakePage, page_in

from lynx_common.course.player import player
from lynx_common.errors import InputError

POINTS = np.random.default_rng(0).uniform(-0.5, 0.5, (30, 5, 3))
ITEMS = POINTS[:, :2]
LINE = np.array([[0, 0, 0.1], [0.3, 0, 0.1]])


def page(shown) -> str:
    return page_in(shown.data)


def held(shown) -> dict:
    return json.loads(re.search("const data = (.*);", page(shown)).group(1))


def test_it_holds_the_positions_to_a_tenth_of_a_millimetre():
    data = held(player(POINTS, [LINE], ITEMS, seconds=3))
    assert np.allclose(data["arm"], POINTS, atol=0.51e-4)
    assert np.allclose(data["items"], ITEMS, atol=0.51e-4)
    assert np.allclose(data["lines"], [LINE])
    assert data["seconds"] == 3


def test_without_items_and_lines_there_are_none():
    data = held(player(POINTS))
    assert data["items"] == [[]] * 30
    assert data["lines"] == []


def test_items_are_squares_or_balls_of_a_radius():
    assert held(player(POINTS, moving=ITEMS))["radius"] == 0
    assert held(player(POINTS, moving=ITEMS, radius=0.15))["radius"] == 0.15
    for radius in (-0.1, np.nan, np.inf):
        with pytest.raises(InputError, match="radius of the items"):
            player(POINTS, moving=ITEMS, radius=radius)


def test_two_calls_give_the_same_page_and_minus_zero_is_zero():
    assert player(POINTS).data == player(POINTS.copy()).data
    assert player(0 * POINTS).data == player(-0.0 * POINTS).data


def test_it_is_small_and_asks_for_nothing_from_elsewhere():
    shown = player(POINTS)
    assert len(shown.data) < 40_000
    assert len(player(np.tile(POINTS, (7, 1, 1))).data) < 1_000_000  # 210 frames, as many as a notebook has
    assert not re.search(r"https?:|src=|import|fetch|random|Date", page(shown))


def test_quotes_cannot_end_the_page_early():
    assert player(POINTS).data.count('"') == 6  # srcdoc, title and style


@pytest.mark.parametrize(
    ("points", "items"),
    [(POINTS * np.nan, None), (POINTS[0], None), (POINTS[..., :2], None), (POINTS, ITEMS[1:]), (POINTS[:0], None)],
)
def test_what_cannot_be_shown_is_refused(points, items):
    with pytest.raises(InputError):
        player(points, moving=items)


LINK, TRACE, STILL = ("#4d4d4d", 5), ("#0072b2", 1.5), ("#c4c4c4", 4)


def drawn(shown: FakePage, kind: tuple = LINK) -> np.ndarray:
    """The one polyline of a kind, in pixels."""
    (line,) = shown.drawings[0].of(*kind)
    return line


def test_a_view_from_above_has_x_to_the_right_and_y_up():
    opened = FakePage(player(POINTS, from_above=True).data)
    for frame in (0, 17):
        opened.slide("time", frame)
        away = drawn(opened) - drawn(opened)[0]
        scale = away[1, 0] / (POINTS[frame, 1, 0] - POINTS[frame, 0, 0])
        assert scale > 0
        np.testing.assert_allclose(away, (POINTS[frame] - POINTS[frame, 0])[:, :2] * [scale, -scale], atol=0.1)


def test_a_view_from_the_side_has_z_up_and_what_is_nearer_lower():
    corners = np.array([[[0, 0, 0], [0, 0, 0.5], [0.5, 0, 0], [0, 0.5, 0]]])
    origin, up, x, y = drawn(FakePage(player(corners).data))
    assert up[0] == pytest.approx(origin[0])
    assert up[1] < origin[1]
    assert x[0] > y[0] > origin[0]  # seen from the front right
    assert x[1] > origin[1]
    assert y[1] < origin[1]
    lengths = np.linalg.norm(np.array([up, x, y]) - origin, axis=1)
    scale = np.sqrt((lengths**2).sum() / 2) / 0.5  # so it is in any parallel projection
    assert lengths[0] / 0.5 == pytest.approx(scale * np.cos(0.35))


def test_each_frame_has_its_links_trace_items_and_words():
    opened = FakePage(player(POINTS, [LINE], ITEMS, seconds=3).data)
    assert opened.run("elements.time.max") == 29
    for frame in (0, 12, 29):
        opened.slide("time", frame)
        (drawing,) = opened.drawings
        links = drawn(opened)
        assert len(links) == 5
        assert ((links > 0) & (links < [660, 420])).all()
        np.testing.assert_allclose([disc[:2] for disc in drawing.discs], links)
        squares = [(x, y) for x, y, size, colour in drawing.squares if (size, colour) == (14, "#e69f00")]
        np.testing.assert_allclose(squares, links[:2])  # the items are joints here
        trace = drawing.of(*TRACE)[-1]
        assert len(trace) == frame + 1
        assert trace[-1] == pytest.approx(links[-1])
        assert len(drawn(opened, STILL)) == 2
        x, y, z = POINTS[frame, -1]
        said = re.fullmatch(r"tip \((.*), (.*), (.*)\) m", opened.text[-1]).groups()
        assert [float(number) for number in said] == pytest.approx([x, y, z], abs=6e-4)
        names = {text: colour for text, *_, colour in drawing.words}
        assert names == {"x": "#d55e00", "y": "#009e73", "z": "#0072b2"}


def test_items_of_a_radius_are_discs_at_the_scale_of_the_picture():
    corners = np.array([[[0, 0, 0], [0, 0.5, 0]]])
    opened = FakePage(player(corners, moving=corners[:, 1:], radius=0.1, from_above=True).data)
    (x, y, radius, _) = opened.drawings[0].discs[0]
    start, end = drawn(opened)
    assert (x, y) == pytest.approx(end)
    assert radius == pytest.approx(np.linalg.norm(end - start) / 5)


def test_it_plays_pauses_and_is_scrubbed():
    opened = FakePage(player(POINTS, seconds=3).data)
    opened.frames(1000, 1050, 2000)
    assert opened.run("+elements.time.value") == 10  # a second of three, of 30 frames
    opened.frames(3950, 4000)
    assert opened.run("+elements.time.value") == 0  # round again
    opened.fire("play", "onclick")
    opened.frames(4500, 5000)
    assert opened.run("+elements.time.value") == 0
    assert "play" in opened.text
    opened.fire("play", "onclick")
    opened.frames(6000, 6500)
    assert opened.run("+elements.time.value") == 5
    opened.run("seen(false)")
    opened.frames(7000)
    assert opened.run("+elements.time.value") == 5  # nobody looks
    opened.run("seen(true)")
    opened.frames(7000)
    assert opened.run("+elements.time.value") == 10
    opened.slide("time", 3)
    opened.frames(7500)
    assert opened.run("+elements.time.value") == 3  # a hand on the slider stops it


def test_dragging_turns_the_view_and_letting_go_ends_it():
    opened = FakePage(player(POINTS).data)
    opened.fire("play", "onclick")
    before = drawn(opened)
    opened.fire("view", "onpointerdown", clientX=100, clientY=100, pointerId=1)
    opened.fire("view", "onpointermove", clientX=100, clientY=130, pointerId=1)
    tilted = drawn(opened)
    assert tilted[:, 0] == pytest.approx(before[:, 0])
    assert np.abs(tilted[:, 1] - before[:, 1]).max() > 1
    opened.fire("view", "onpointermove", clientX=90, clientY=130, pointerId=1)
    turned = drawn(opened)
    assert np.abs(turned[:, 0] - tilted[:, 0]).max() > 1
    opened.fire("view", "onpointerup")
    opened.fire("view", "onpointermove", clientX=0, clientY=0, pointerId=1)
    assert drawn(opened) == pytest.approx(turned)
    # The floor's near side follows the finger: dragged to the right, it moves to the right.
    opened = FakePage(player(np.array([[[0, 0, 0], [0, -0.5, 0]]])).data)
    opened.fire("play", "onclick")
    before = drawn(opened)
    opened.fire("view", "onpointerdown", clientX=0, clientY=0, pointerId=1)
    opened.fire("view", "onpointermove", clientX=15, clientY=0, pointerId=1)
    after = drawn(opened)
    assert after[1, 0] - after[0, 0] > before[1, 0] - before[0, 0]
    opened.fire("view", "onpointermove", clientX=15, clientY=15, pointerId=1)
    below = drawn(opened)
    assert below[1, 1] - below[0, 1] > after[1, 1] - after[0, 1]


@pytest.mark.parametrize(
    "seconds", ["</script><script>alert(1)</script>", 0, -1, np.nan, np.inf, [1, 2], 1j, None], ids=repr
)
def test_seconds_are_one_number_above_0(seconds):
    with pytest.raises(InputError, match="seconds"):
        player(POINTS, seconds=seconds)


def test_it_says_what_moves():
    assert (
        'title="A &quot;robot&quot; in motion; drag to turn the view"'
        in player(POINTS, title='A "robot" in motion').data
    )
