"""The player: one self-contained page that holds the positions it was given, the same at every call."""

import html
import json
import re

import numpy as np
import pytest

from lynx_common.course.player import player
from lynx_common.errors import InputError

POINTS = np.random.default_rng(0).uniform(-0.5, 0.5, (30, 5, 3))
ITEMS = POINTS[:, :2]
LINE = np.array([[0, 0, 0.1], [0.3, 0, 0.1]])


def page(shown) -> str:
    return html.unescape(re.search('srcdoc="([^"]*)"', shown.data).group(1))


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


def test_a_view_from_above_has_x_to_the_right_and_y_up():
    above, aside = (page(player(POINTS, from_above=option)) for option in (True, False))
    assert "let turn = -1.5708, tilt = 1.5708," in above
    assert "let turn = -1.1, tilt = 0.35," in aside


def test_it_says_what_moves():
    assert (
        'title="A &quot;robot&quot; in motion; drag to turn the view"'
        in player(POINTS, title='A "robot" in motion').data
    )
