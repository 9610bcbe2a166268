"""The explorers: the picture and the numbers follow the controls."""

import io

import ipywidgets as widgets
import numpy as np
import pytest
from PIL import Image

from lynx_common import arm
from lynx_common.course import explorers


@pytest.fixture
def controls() -> dict[str, object]:
    """The parts of the arm's explorer by kind."""
    panel, image = explorers.arm_explorer().children
    kinds = {
        "sliders": widgets.FloatSlider,
        "frames": widgets.Checkbox,
        "reset": widgets.Button,
        "text": widgets.HTML,
    }
    parts = {name: [w for w in panel.children if isinstance(w, kind)] for name, kind in kinds.items()}
    return parts | {"image": image}


def pixels(controls) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(controls["image"].value)))


def test_it_opens_on_table_1_3(controls):
    assert [slider.value for slider in controls["sliders"]] == [60, 45, -30, 60, 30]
    assert "(0.2156, 0.3734, 0.2673) m" in controls["text"][0].value


@pytest.mark.parametrize("joint", range(5))
def test_each_slider_moves_the_picture_and_the_pose(controls, joint):
    before = pixels(controls)
    controls["sliders"][joint].value += 25
    assert (pixels(controls) != before).any()
    q = np.deg2rad([slider.value for slider in controls["sliders"]])
    x, y, z = arm.forward_kinematics(q)[:3, 3]
    assert f"({x:.4f}, {y:.4f}, {z:.4f}) m" in controls["text"][0].value


def test_the_base_leaves_the_side_view_alone(controls):
    before = pixels(controls)
    controls["sliders"][0].value += 25
    middle = before.shape[1] // 2 + 30
    assert (pixels(controls)[:, middle:] == before[:, middle:]).all()


def test_frames_come_and_go_and_reset_brings_the_first_picture_back(controls):
    first = pixels(controls)
    controls["frames"][0].value = True
    assert (pixels(controls) != first).any()
    controls["frames"][0].value = False
    assert (pixels(controls) == first).all()
    for slider in controls["sliders"]:
        slider.value += 10
    controls["reset"][0].click()
    assert (pixels(controls) == first).all()


def test_sliders_stay_within_the_joint_limits(controls):
    limits = np.deg2rad([(slider.min, slider.max) for slider in controls["sliders"]])
    np.testing.assert_allclose(limits, arm.JOINT_LIMITS, atol=1e-12)


def test_another_arm_can_be_explored():
    panel, _ = explorers.arm_explorer(arm.Geometry(1, 2, 1, 0.5)).children
    assert "T_0_5" in panel.children[-1].value
