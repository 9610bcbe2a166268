"""The explorer of A2: the picture and the numbers follow the sliders."""

import functools

import ipywidgets as widgets
import numpy as np
import pytest

from lynx_common import arm, workspace
from lynx_common.course import explorers


@functools.cache
def made(geometry: arm.Geometry) -> widgets.Widget:
    return explorers.limits_explorer(geometry)


def opened(geometry: arm.Geometry = arm.LYNX) -> tuple[list[widgets.Widget], widgets.HTML, widgets.Image]:
    """Sliders, words and picture as it opens. One explorer serves all tests, which saves seconds."""
    panel, image = made(geometry).children
    *sliders, words = panel.children
    for slider in sliders:
        slider.value = (-90, 90)
    return sliders, words, image


def volumes(words: widgets.HTML) -> list[float]:
    return [float(row.split("<td>")[-1].split()[0]) for row in words.value.split("<tr>")[2:]]


@pytest.mark.committed_lengths
def test_limits_opens_on_the_reports_ranges_with_the_volume_of_the_shell():
    _, words, _ = opened()
    assert volumes(words)[0] == 173.30


def test_limits_follow_the_sliders():
    sliders, words, image = opened()
    picture = image.value
    sliders[0].value = (0, 180)
    limits = np.deg2rad([[0, 360], [0, 180], [-90, 90], [0, 360]])
    for volume, point in zip(volumes(words), workspace.POINTS, strict=True):
        region = workspace.section(limits, point)
        assert volume == pytest.approx((region | region.mirror()).volume * 1000, abs=0.006)
    assert image.value != picture
    sliders[0].value = (-90, 90)
    assert image.value == picture


@pytest.mark.parametrize("value", [(30, 30), (180, 180), (-180, -180), (-180, 180)])
def test_limits_that_meet_are_kept_apart(value):
    sliders, words, _ = opened()
    sliders[1].value = value
    low, high = sliders[1].value
    assert high - low >= 5
    assert all(volume > 0 for volume in volumes(words))


def test_another_arm_can_be_explored():
    assert volumes(opened(arm.Geometry(1, 2, 1, 0.5))[1])[0] > 1000


def test_it_fits_a_page_has_long_tracks_and_its_numbers_have_units():
    _, image = made(arm.LYNX).children
    assert int(image.layout.width.removesuffix("px")) <= 920
    assert made(arm.LYNX).layout.max_width == "920px"
    sliders, words, _ = opened()
    for slider in sliders:
        assert slider.description.endswith("[°]")
        assert int(slider.layout.width.removesuffix("px")) >= 400
    assert "cm²" in words.value
    assert "litres" in words.value
