"""The explorers: the picture and the numbers follow the controls."""

import functools
import io
import re
from pathlib import Path

import ipywidgets as widgets
import numpy as np
import pytest
from PIL import Image

from lynx_common import arm, rrr, workspace
from lynx_common.course import explorers
from lynx_common.course.explorers.parallel import determinants
from lynx_common.errors import InputError

PART_3 = arm.Geometry(5, 10, 10, 0)


def opened(make, *arguments) -> widgets.Widget:
    """An explorer as it opens. One of each serves all tests, which saves seconds."""
    explorer, controls = made(make, *arguments)
    for control, value in controls:
        control.value = value
    return explorer


@functools.cache
def made(make, *arguments) -> tuple[widgets.Widget, list[tuple[widgets.Widget, object]]]:
    explorer = make(*arguments)
    valued = [widget for widget in explorer.children[0].children if hasattr(widget, "value")]
    return explorer, [(control, control.value) for control in valued if not isinstance(control, widgets.HTML)]


def pixels(controls) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(controls["image"].value)))


def parts(explorer: widgets.Widget) -> tuple[list[widgets.Widget], widgets.HTML, widgets.Image]:
    """Sliders, words and picture of an explorer that has nothing else."""
    panel, image = explorer.children
    *sliders, words = panel.children
    return sliders, words, image


def test_reach_shows_four_branches_and_which_keep_to_the_limits():
    sliders, words, _ = parts(opened(explorers.reach_explorer))
    position, pitch = [s.value for s in sliders[:3]], np.deg2rad(sliders[3].value)
    q = arm.inverse_kinematics(position, pitch)
    rows = words.value.split("<tr>")[1:]
    assert len(rows) == 4
    for row, (side, elbow), angles in zip(rows, arm.BRANCHES, q, strict=True):
        assert f"{side}, {elbow}" in row
        assert " ".join(f"{a:.0f}°" for a in np.rad2deg(angles).round() + 0.0) in row
        assert ("beyond a limit" in row) == (not arm.within_limits(angles))


@pytest.mark.parametrize("number", range(4))
def test_reach_each_slider_moves_the_picture(number):
    sliders, words, image = parts(opened(explorers.reach_explorer))
    picture, text = image.value, words.value
    sliders[number].value -= 5 * sliders[number].step
    assert image.value != picture
    assert words.value != text


@pytest.mark.committed_lengths
def test_reach_says_in_words_what_cannot_be_reached_and_recovers():
    sliders, words, image = parts(opened(explorers.reach_explorer))
    picture, home = image.value, sliders[0].value
    sliders[0].value = 0.5
    sliders[1].value = 0.5
    assert "0.6092 m from the shoulder, where the links reach from 0.0000 m to 0.4000 m" in words.value
    sliders[1].value, sliders[0].value = 0.1, home
    assert image.value == picture


@pytest.mark.committed_lengths
def test_reach_can_leave_the_joint_limits_without_an_error():
    sliders, words, _ = parts(opened(explorers.reach_explorer))
    for slider, value in zip(sliders, (0.1, 0, 0.15, 0), strict=True):
        slider.value = value
    assert words.value.count("beyond a limit") == 4


def volumes(words: widgets.HTML) -> list[float]:
    return [float(row.split("<td>")[-1].split()[0]) for row in words.value.split("<tr>")[2:]]


@pytest.mark.committed_lengths
def test_limits_opens_on_the_reports_ranges_with_the_volume_of_the_shell():
    _, words, _ = parts(opened(explorers.limits_explorer))
    assert volumes(words)[0] == 173.30


def test_limits_follow_the_sliders():
    sliders, words, image = parts(opened(explorers.limits_explorer))
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
    sliders, words, _ = parts(opened(explorers.limits_explorer))
    sliders[1].value = value
    low, high = sliders[1].value
    assert high - low >= 5
    assert all(volume > 0 for volume in volumes(words))


def test_other_arms_can_be_explored():
    geometry = arm.Geometry(1, 2, 1, 0.5)
    assert "front, up" in parts(opened(explorers.reach_explorer, geometry))[1].value
    assert volumes(parts(opened(explorers.limits_explorer, geometry))[1])[0] > 1000


@pytest.fixture
def over_there() -> np.ndarray:
    """Joint angles of a motion of 21 samples."""
    start, end = np.deg2rad([[0, 60, -30, 60, 0], [90, 100, -60, 90, 45]])
    return start + np.linspace(0, 1, 21)[:, None] * (end - start)


def test_motion_follows_slider_and_play(over_there):
    panel, image = explorers.motion_explorer(over_there).children
    play, slider, words = panel.children
    pictures = [image.value]
    for control, value in ((slider, 10), (play, 20)):
        control.value = value
        assert slider.value == play.value == value
        x, y, z = np.round(arm.forward_kinematics(over_there[value])[:3, 3], 3) + 0.0
        assert f"({x:.3f}, {y:.3f}, {z:.3f}) m" in words.value
        assert f"θ₁ {np.rad2deg(over_there[value, 0]):7.1f}°" in words.value
        pictures.append(image.value)
    assert len(set(pictures)) == 3
    play.value = 0
    assert image.value == pictures[0]


def test_motion_ends_with_its_last_sample(over_there):
    play, slider, _ = explorers.motion_explorer(over_there).children[0].children
    assert play.max == slider.max == 20


@pytest.mark.parametrize("spoil", [lambda q: q[0], lambda q: q[:, :4], lambda q: q * np.nan, lambda q: q[:0]])
def test_motion_needs_finite_joint_angles(over_there, spoil):
    with pytest.raises(InputError, match="finite joint angles"):
        explorers.motion_explorer(spoil(over_there))


def facts(words: widgets.HTML) -> list[float]:
    """Length of the way, and least clearance of gripper and arm."""
    return [float(row.split("<td>")[-1].split()[0]) for row in words.value.split("<tr>")[1:]]


@pytest.mark.committed_lengths
def test_detour_opens_on_the_shortest_way_around_the_reports_obstacle():
    sliders, words, _ = parts(opened(explorers.detour_explorer))
    assert [s.value for s in sliders] == [-0.2, 0.6, 0.15, 0.03]
    assert facts(words) == [0.295, 0.03, 0.03]


@pytest.mark.parametrize(("number", "change"), list(enumerate((0.03, -0.06, -0.02, 0.01))))
def test_detour_each_slider_moves_the_picture_and_the_numbers(number, change):
    sliders, words, image = parts(opened(explorers.detour_explorer))
    picture, text, home = image.value, words.value, sliders[number].value
    sliders[number].value = home + change
    assert image.value != picture
    assert words.value != text
    sliders[number].value = home
    assert image.value == picture


@pytest.mark.parametrize(
    ("number", "value", "sentence"),
    [
        (3, 0.06, "The start of the motion cannot be used. It is 0.0500 m from the obstacle, where the margin"),
        (1, 0.5, "The end of the motion cannot be used. It is 0.0500 m deep in the obstacle."),
    ],
)
def test_detour_says_which_end_it_cannot_use(number, value, sentence):
    sliders, words, _ = parts(opened(explorers.detour_explorer))
    sliders[number].value = value
    assert sentence in words.value


@pytest.mark.committed_lengths
def test_detour_says_when_the_links_collide():
    sliders, words, _ = parts(opened(explorers.detour_explorer))
    for slider, value in zip(sliders, (0.02, 0.3, 0.04, 0.0), strict=True):
        slider.value = value
    assert facts(words)[1] > 0 > facts(words)[2]
    assert "the links collide" in words.value


@pytest.mark.committed_lengths
def test_detour_says_when_the_arm_cannot_follow():
    """A small obstacle between the ends, to be passed above."""
    sliders, words, _ = parts(opened(explorers.detour_explorer))
    for slider, value in zip(sliders, (-0.1, 0.5, 0.05, 0.06), strict=True):
        slider.value = value
    assert "The path fails first at sample 1 of 0 to 100: Target position is out of reach" in words.value


def parallel(
    *values: float, geometry: rrr.Geometry = rrr.RRR
) -> tuple[list[widgets.Widget], widgets.HTML, widgets.Image]:
    """Controls (X_c, Y_c, alpha in degrees, mode), words and picture of the explorer, set to ``values``."""
    controls, words, image = parts(opened(explorers.parallel_explorer, geometry))
    for control, value in zip(controls, values, strict=False):
        control.value = value
    return controls, words, image


OTHER = rrr.Geometry(120, 150, 80, 220)


@pytest.mark.parametrize(("mode", "geometry"), [(0, rrr.RRR), (6, rrr.RRR), (2, OTHER), (5, OTHER)])
def test_parallel_says_what_the_package_says(mode, geometry):
    _, words, _ = parallel(-30, 20, -20, mode, geometry=geometry)
    pose = np.array([-30, 20, np.deg2rad(-20)])
    theta = rrr.inverse_kinematics(pose, geometry)[mode]
    det_A, det_B = determinants(pose, theta, geometry)
    distance = rrr.constant_orientation_workspace(pose[2], geometry).distances(pose[:2])[0]
    expected = [", ".join(f"{a:.1f}°" for a in np.rad2deg(theta)), f"{det_A:.4f}", f"{det_B:.4f}"]
    assert [row.split("<td>")[-1].split("</td>")[0] for row in words.value.split("<tr>")[1:]] == expected
    assert f"{distance:.1f} mm to the boundary" in words.value
    assert "regular" in words.value


def test_parallel_menu_names_the_modes():
    controls, _, _ = parallel()
    signs = [tuple({"+": 1, "-": -1}[sign] for sign in name) for name, _ in controls[3].options]
    assert tuple(signs) == rrr.WORKING_MODES


@pytest.mark.parametrize(("number", "value"), list(enumerate((-40, 70, -25, 3))))
def test_parallel_each_control_moves_picture_and_numbers(number, value):
    controls, words, image = parallel()
    picture, text, home = image.value, words.value, controls[number].value
    controls[number].value = value
    assert image.value != picture
    assert words.value != text
    controls[number].value = home
    assert (image.value, words.value) == (picture, text)


def test_parallel_says_which_leg_fails_and_how_far_outside_it_is():
    _, words, image = parallel(50, 150, 30)
    assert "leg 1 would span 31.25 mm and leg 3 would span 303.46 mm" in words.value
    outside = rrr.constant_orientation_workspace(np.pi / 6).distances(np.array([50, 150]))[0]
    assert f"{outside:.1f} mm outside the boundary" in words.value
    assert "det A" not in words.value
    assert image.value != parallel(50, 150, 31)[2].value


def test_parallel_says_where_there_is_no_workspace():
    assert "no workspace at all" in parallel(0, 0, 82)[1].value
    assert "mm to the boundary" in parallel(0, 0, 81)[1].value


def painted(image: widgets.Image, colour: str, right: bool = False) -> np.ndarray:
    """Columns of the pixels of a colour, in the left or in the right half of the picture."""
    picture = np.asarray(Image.open(io.BytesIO(image.value))).astype(int)
    half = picture[:, 400:] if right else picture[:, :400]
    return np.nonzero(np.abs(half - [int(colour[i : i + 2], 16) for i in (1, 3, 5)]).max(axis=-1) <= 3)[1]


def test_parallel_draws_the_workspace_at_this_turn_and_the_robot_at_this_place():
    light_blue = "#cce8f8"
    sizes = [len(painted(parallel(150, 150, turn)[2], light_blue)) for turn in (0, 60)]
    assert 4 < sizes[0] / sizes[1] < 8  # of areas it is 6; the robot hides some
    platform = [painted(parallel(x, 0, 10)[2], "#d55e00").mean() for x in (-60, 60)]
    assert 25 < platform[1] - platform[0] < 60  # 120 mm, and 0.36 pixels a mm


def test_parallel_shows_the_sign_of_det_A_and_where_it_changes():
    """In mode +++ it is negative in the middle, in mode --- positive; more dashed lines mean more dark pixels."""
    for mode, (more, less) in ((0, (0, 2)), (7, (2, 0))):  # orange is below zero, purple above
        picture = np.asarray(Image.open(io.BytesIO(parallel(100, -200, 0, mode)[2].value))).astype(int)
        red_green_blue = picture[190:200, 565:580].mean(axis=(0, 1))
        assert red_green_blue[more] > red_green_blue[less] + 20
    dark = [len(painted(parallel(200, -200, 15, mode)[2], "#4d4d4d", right=True)) for mode in (0, 3)]
    assert dark[1] > dark[0] + 30


@pytest.mark.parametrize(("mode", "kind"), [(0, "type 1: a leg"), (1, "types 1 and 2")])
def test_parallel_names_singularities(mode, kind):
    _, words, _ = parallel(0, 120, 0, mode)  # leg 1 is folded; in mode 1 the others meet on the axis of symmetry
    assert kind in words.value
    assert "0.0 mm to the boundary" in words.value


def test_determinants_have_no_unit():
    pose, doubled = np.array([20.0, 30.0, 0.2]), rrr.Geometry(340, 260, 260, 580)
    theta = rrr.inverse_kinematics(pose)
    large = determinants(pose * [2, 2, 1], theta, doubled)
    np.testing.assert_allclose(determinants(pose, theta, rrr.RRR), large)


def test_determinants_are_largest_where_the_links_are_square_to_each_other_and_to_the_platform():
    corners = np.array(rrr.RRR.platform_angles)
    geometry = rrr.Geometry(110, 80, 60, np.hypot(60 + 110, 80), base_angles=tuple(corners + np.arctan2(80, 170)))
    det_A, det_B = determinants(np.zeros(3), rrr.inverse_kinematics(np.zeros(3), geometry), geometry)
    np.testing.assert_allclose(np.abs(det_A).max(), 1.5 * 3**0.5)
    np.testing.assert_allclose(np.abs(det_B), 1)


def row(words: widgets.HTML, name: str) -> str:
    return words.value.split(f"<td>{name}</td><td>")[1].split("<")[0]


def test_singularity_says_what_the_jacobian_is():
    sliders, words, image = parts(opened(explorers.singularity_explorer))
    assert [s.value for s in sliders] == [30, -80]
    pictures = [image.value]
    for values in ((30, -80), (-100, 33), (150, 170)):
        for slider, value in zip(sliders, values, strict=True):
            slider.value = value
        q = np.deg2rad([0, *values, 0, 0])
        J = arm.jacobian(q, arm.Geometry(5, 10, 10, 0))[:3, :3]
        singular = np.linalg.svd(J, compute_uv=False)
        assert row(words, "determinant") == f"{np.linalg.det(J):.1f}"
        assert row(words, "singular values") == " ".join(f"{value:.2f}" for value in singular)
        assert row(words, "square to the plane") == f"{np.hypot(*arm.joint_positions(q, PART_3)[3, :2]):.2f}"
        assert row(words, "speed 1 in the worst direction") == f"{1 / singular[-1]:.2f} rad/s"
        assert row(words, "singular") == "no"
        pictures.append(image.value)
    assert len(set(pictures)) == 3
    sliders[0].value, sliders[1].value = 30, -80
    assert image.value == pictures[0]


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ((30, 0), "elbow"),
        ((30, 180), "shoulder, elbow"),
        ((30, -180), "shoulder, elbow"),
        ((90, 0), "shoulder, elbow"),
        ((45, 90), "shoulder"),
        ((-45, -90), "shoulder"),
        ((44, 90), "no"),
        ((30, 1), "no"),
    ],
)
def test_singularity_names_the_factors_that_vanish(values, expected):
    sliders, words, _ = parts(opened(explorers.singularity_explorer))
    for slider, value in zip(sliders, values, strict=True):
        slider.value = value
    assert row(words, "singular") == expected
    assert ("no joint speed will do" in words.value) == (expected != "no")


def test_singularity_of_another_arm_is_that_of_its_wrist():
    sliders, words, _ = parts(opened(explorers.singularity_explorer, arm.Geometry(0.1, 0.2, 0.15, 0.1)))
    sliders[1].value = 180
    assert row(words, "singular") == "elbow"
    sliders[0].value = 90
    assert row(words, "singular") == "shoulder, elbow"


def middle(image: widgets.Image, colour: tuple[int, int, int], left: bool) -> np.ndarray:
    """Where the pixels of a colour are in one half of the picture, on average: to the right, and up."""
    picture = pixels({"image": image}).astype(int)
    half = slice(0, picture.shape[1] // 2) if left else slice(picture.shape[1] // 2, None)
    down, right = np.nonzero(abs(picture[:, half, :3] - colour).max(axis=-1) < 3)
    assert right.size > 20
    return np.array([right.mean(), -down.mean()])


def test_singularity_moves_the_point_on_the_map_the_arm_and_the_ellipse():
    sliders, _, image = parts(opened(explorers.singularity_explorer))
    orange, grey = (230, 159, 0), (77, 77, 77)
    sliders[0].value, sliders[1].value = 0, 60
    point, ellipse, links = middle(image, orange, True), middle(image, orange, False), middle(image, grey, False)
    sliders[0].value = 60  # theta_2 is to the right on the map; the arm rises
    right, _ = middle(image, orange, True) - point
    assert right > 30
    assert middle(image, orange, False)[1] > ellipse[1] + 30
    assert middle(image, grey, False)[1] > links[1] + 20
    point = middle(image, orange, True)
    sliders[1].value = 120
    across, up = middle(image, orange, True) - point
    assert abs(across) < 3
    assert up > 30


OPEN = {
    "reach": (explorers.reach_explorer, [0.3, 0, 0.1, 0]),
    "singularity": (explorers.singularity_explorer, [0, -90]),
    "parallel": (explorers.parallel_explorer, [0, 0, 0]),
    "detour": (explorers.detour_explorer, [-0.2, 0.6, 0.15, 0.05]),
}


@pytest.mark.parametrize("name", OPEN)
def test_numbers_are_rounded_and_none_is_minus_zero(name):
    """At places where the exact number is 0, so that rounding errors of either sign are all that is left."""
    make, values = OPEN[name]
    panel, _ = opened(make).children
    sliders = [w for w in panel.children if isinstance(w, widgets.FloatSlider)]
    for slider, value in zip(sliders, values, strict=True):
        slider.value = value
    text = " ".join(widget.value for widget in panel.children if isinstance(widget, widgets.HTML))
    numbers = re.findall(r"-?\d+(?:\.\d+)?", re.sub(r"<[^>]*>|T_0_5", " ", text))
    assert len(numbers) > 2
    assert [number for number in numbers if number.startswith("-") and float(number) == 0] == []
    assert all(len(number.partition(".")[2]) <= 4 for number in numbers)


def test_every_number_that_an_explorer_writes_is_kept_from_minus_zero():
    """By the option z of its format, which no place forgets."""
    sources = [path.read_text(encoding="utf-8") for path in Path(explorers.__file__).parent.glob("*.py")]
    formats = [found for source in sources for found in re.findall(r"\{[^{}\"]*:([^{}\"]*\.\d+f)\}", source)]
    assert len(formats) > 15
    assert all(found.startswith("z") for found in formats)
