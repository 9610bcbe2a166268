"""The stages of the course: they compute what the package computes, and their challenges can be met."""

import contextlib
import functools
import re

import numpy as np
import pytest
import sympy as sp
from fake_browser import FakePage, page_in

from lynx_common import arm, dh, motion, obstacles, rrr, workspace
from lynx_common.course import explorers
from lynx_common.drawing import gripper
from lynx_common.errors import InputError, LynxError
from lynx_common.symbolic import TASK, WRIST, P, Q, tidy

SAMPLES = 1000
LONG = arm.Geometry(0.15, 0.25, 0.18, 0.07)


@pytest.fixture
def rng():
    return np.random.default_rng(11)


@functools.cache
def shown(make, *arguments):
    return make(*arguments)


class Stage(FakePage):
    """A stage with its items by kind and colour, and what they compute."""

    def items(self, view: int = 0, **wanted) -> list[dict]:
        items = self.facts["views"][view]["items"]
        return [item for item in items if all(item.get(name) == value for name, value in wanted.items())]

    def points(self, item: dict, inputs: np.ndarray) -> np.ndarray:
        """(samples, n, size), for inputs in radians."""
        start, count = item["points"]
        return self.at(inputs)[:, start : start + count].reshape(len(inputs), -1, item["size"])

    def at(self, inputs: np.ndarray) -> np.ndarray:
        """All numbers, computed once for the same inputs; inputs beyond those given, lengths, are at home."""
        if self.known is None or self.known[0] is not inputs:
            lengths = np.array(self.run("home")[inputs.shape[1] :])
            self.known = inputs, self.numbers(np.column_stack([inputs, np.tile(lengths, (len(inputs), 1))]))
        return self.known[1]

    known = None

    @property
    def drawn(self) -> str:
        """What is on all canvases."""
        return self.engine.eval("JSON.stringify(canvasesMade.map(canvas => canvas.getContext().calls))")

    def said(self, start: str) -> str:
        """The line of words that begins so."""
        (line,) = [text for text in self.text if text.startswith(start)]
        return line

    def set(self, *values: float) -> None:
        """All inputs at once, as a handle would, in the units of the sliders; those beyond, lengths, at home."""
        self.run(f"go({[float(v) for v in [*values, *self.run('home')[len(values) :]]]})")

    @property
    def met(self) -> list[bool]:
        return [one["met"] for one in self.run("tally")]


def opened(make, *arguments) -> Stage:
    return Stage(shown(make, *arguments))


def shown_numbers(text: str) -> list[float]:
    return [float(n) for n in re.findall(r"-?\d+\.\d+|-?\d+", text.replace("\N{MINUS SIGN}", "-"))]


# A1


def the_arm(geometry=arm.LYNX):
    return explorers.joints_and_frames([tidy(T) for T in dh.chain(arm.dh_table())], geometry)


@pytest.mark.parametrize("geometry", [arm.LYNX, LONG])
def test_the_arm_stands_where_the_package_says(geometry, rng):
    q = rng.uniform(-np.pi, np.pi, (SAMPLES, 5))
    page = opened(the_arm, geometry)
    inputs = np.column_stack([q, -np.ones(SAMPLES)])
    joints, T = arm.joint_positions(q, geometry), arm.forward_kinematics(q, geometry)
    rods = [item for item in page.items(kind="body", colour="steel") if not item.get("flat")]
    for rod, start, end in zip(rods[:2], (1, 2), (2, 3), strict=True):
        np.testing.assert_allclose(page.points(rod, inputs), joints[:, [start, end]], atol=1e-7)
    fingers = [page.points(item, inputs) for item in page.items(kind="body", colour="x")]
    forks = np.array([gripper(pose, 0.05 / 0.6 * sum(geometry)) for pose in T])
    width = 2 * 0.026 / 0.05 * (forks[:, [0, -1]] - T[:, None, :3, 3]) + T[:, None, :3, 3]
    ends = sorted(
        [finger[:, 1] for finger in fingers], key=lambda p: -np.linalg.norm(p - width[:, 0], axis=1).max()
    )
    np.testing.assert_allclose(np.stack(ends[::-1], axis=1), width, atol=1e-7)
    frames = arm.link_frames(q, geometry)
    axes = page.items(kind="line")
    for i, line in enumerate(axes[3:]):  # the first three are those of the base
        frame, name = divmod(i, 3)
        end, at = np.moveaxis(page.points(line, inputs), 1, 0)
        np.testing.assert_allclose(at, frames[:, frame + 1, :3, 3], atol=1e-7)
        length = np.linalg.norm(end - at, axis=1, keepdims=True)
        np.testing.assert_allclose((end - at) / length, frames[:, frame + 1, :3, name], atol=1e-6)


@pytest.mark.committed_lengths
def test_the_pose_is_said_in_words():
    page = opened(the_arm)
    assert page.said("gripper at") == "gripper at 0.216, 0.373, 0.267 m"
    page.slide("θ₁", -90)
    rows = [shown_numbers(text) for text in page.text if len(shown_numbers(text.replace("T₀₅", ""))) == 4]
    q = np.deg2rad([-90, 45, -30, 60, 30])
    np.testing.assert_allclose(rows, arm.forward_kinematics(q), atol=5.1e-4)


def test_all_frames_are_shown_on_request():
    page = opened(the_arm)
    names = [text for text, *_ in page.drawings[0].words]
    assert sorted(names) == ["x", "y", "z"]
    page.choose("frames", "all")
    assert len(page.drawings[0].words) == 18


@pytest.mark.parametrize("geometry", [arm.LYNX, LONG])
def test_the_gripper_can_be_led_and_the_joints_follow(geometry, rng):
    """The joints are those of the inverse for the finger's place, with pitch, roll and branch as they were."""
    page = opened(the_arm, geometry)
    for turn in (0, -40, 30):
        page.run(f"Object.assign(angles[0], {{turn: {turn}, tilt: 15}})")
        page.set(60, 45, -30, 60, 30, -1)
        before = np.deg2rad(page.run("inputs")[:5])
        tip, size = arm.forward_kinematics(before, geometry)[:3, 3], sum(geometry)
        a, b = page.place(tip)
        x, y = page.run(f"cameraOf(views[0], 0).place({tip.tolist()})")[:2]
        page.drag(0, (a, b), (x - 20, y + 10))
        q = np.deg2rad(page.run("inputs")[:5])
        found = page.place(arm.forward_kinematics(q, geometry)[:3, 3])
        np.testing.assert_allclose(found, [x - 20, y + 10], atol=0.3)
        task = arm.task_coordinates(q, geometry)
        np.testing.assert_allclose(task[3:], arm.task_coordinates(before, geometry)[3:], atol=1e-6)
        assert q[2] < 0
        np.testing.assert_allclose(arm.joint_angles(task, geometry)[0], q, atol=1e-6)
        assert np.linalg.norm(arm.forward_kinematics(q, geometry)[:3, 3] - tip) < size / 2


def test_led_from_behind_the_gripper_stays_on_that_side():
    page = opened(the_arm)
    page.set(20, 130, -20, 70, 0, -1)
    before = arm.task_coordinates(np.deg2rad(page.run("inputs")[:5]))
    assert before[1] < 0
    at = page.place(arm.forward_kinematics(np.deg2rad(page.run("inputs")[:5]))[:3, 3])
    page.drag(0, at, at + [8, 6])
    q = np.deg2rad(page.run("inputs")[:5])
    np.testing.assert_allclose(page.place(arm.forward_kinematics(q)[:3, 3]), at + [8, 6], atol=0.3)
    assert arm.task_coordinates(q)[1] < 0


def test_beyond_the_reach_the_arm_points_at_the_finger_and_says_why():
    page = opened(the_arm)
    page.set(0, 45, -30, 75, 0, -1)
    page.run("Object.assign(angles[0], {turn: 0, tilt: 0})")
    page.lead([5 * x for x in arm.forward_kinematics(np.deg2rad([0, 45, -30, 75, 0]))[:3, 3]])
    q = np.deg2rad(page.run("inputs")[:5])
    assert q[2] == pytest.approx(0, abs=1e-6)
    assert page.run("reason").startswith("Out of reach: the wrist would be ")
    page.set(0, 10, 40, 40, 0, -1)
    page.lead([0.3, 0, -0.2])
    assert page.run("reason") == "θ₂ is at its limit, 0°."
    assert page.run("inputs")[1] == pytest.approx(0, abs=0.05)


@pytest.mark.parametrize("geometry", [arm.LYNX, LONG])
def test_the_ball_can_be_gripped_from_above_and_the_base_axis_be_reached(geometry):
    page = opened(the_arm, geometry)
    assert page.met == [False, False]
    (ball,) = page.items(kind="body", colour="target")
    at = page.points(ball, np.zeros((1, 6)))[0, 0]
    q = arm.inverse_kinematics(at, -np.pi / 2, geometry=geometry)
    q = q[arm.within_limits(q)][0]
    page.set(*np.rad2deg(q).round(), -1)
    assert page.met == [True, False]
    page.set(*np.rad2deg(arm.joint_angles([0, 0, 0.9 * sum(geometry), np.pi / 2, 0], geometry)[0]).round(), -1)
    assert page.met == [True, True]


def shorter(geometry, rng, samples: int) -> np.ndarray:
    """Lengths L_1 to L_3 that the sliders can be set to, (samples, 3), the shortest and the longest among them."""
    longest = np.array(geometry)[1:]
    lengths = longest * rng.uniform(0.5, 1, (samples, 3))
    lengths[:2] = longest, longest - np.array([int(50 * x) for x in longest]) / 100
    return lengths


@pytest.mark.parametrize("geometry", [arm.LYNX, LONG])
def test_the_arm_with_other_lengths_stands_where_the_package_says_and_its_ball_can_be_gripped(geometry, rng):
    for L in shorter(geometry, rng, 8):
        page = opened(the_arm, geometry)
        (upper, fore), (ball,) = rods(page)[:2], page.items(kind="body", colour="target")
        own, q = arm.Geometry(geometry.d_1, *L), rng.uniform(-np.pi, np.pi, (1, 5))
        inputs = np.array([[*q[0], -1, *L]])
        joints = arm.joint_positions(q, own)
        np.testing.assert_allclose(page.points(upper, inputs), joints[:, 1:3], atol=1e-7)
        np.testing.assert_allclose(page.points(fore, inputs), joints[:, 2:4], atol=1e-7)
        page.set(*page.run("home")[:6], *L)
        assert page.met == [False, False]
        gripping = arm.inverse_kinematics(page.points(ball, inputs)[0, 0], -np.pi / 2, geometry=own)
        gripping = gripping[arm.within_limits(gripping)][0]
        page.set(*np.rad2deg(gripping).round(), -1, *L)
        assert page.met == [True, False]


def test_both_elbows_are_those_of_the_package_with_other_lengths_too(rng):
    page = opened(the_branches)
    chain, hand, *_ = rods(page, 1)
    for L in shorter(arm.LYNX, rng, 30):
        task, own = a_thousand_targets(rng, arm.LYNX)[:50, :4], arm.Geometry(arm.LYNX.d_1, *L)
        q = arm.joint_angles(np.pad(task, ((0, 0), (0, 1))), own)[:, 0]
        reached = np.isfinite(q).all(axis=1)
        inputs = np.column_stack([task, np.ones(50), np.tile(L, (50, 1))])
        joints = arm.joint_positions(np.column_stack([0 * q[:, 0], q[:, 1:]]), own)[..., [0, 2]]
        assert ((page.at(inputs)[:, chain["when"]] >= 0) == reached).all()
        np.testing.assert_allclose(page.points(chain, inputs)[reached], joints[reached, :4], atol=1e-6)
        np.testing.assert_allclose(page.points(hand, inputs)[reached], joints[reached, 3:], atol=1e-6)


# A2


the_section = explorers.section_of_limits


def rods(page: Stage, view: int = 0) -> list[dict]:
    """Links of an arm in a plane, in steel."""
    return [item for item in page.items(view, kind="body", colour="steel") if not item.get("flat")]


def test_the_section_is_that_of_the_package(rng):
    page = opened(the_section)
    for _ in range(6):
        low, high = np.sort(rng.integers(-36, 37, (2, 2)) * 5, axis=0)
        page.set(low[0], high[0], low[1], high[1], 0, 0)
        region = workspace.section(np.deg2rad([[0, 360], *np.transpose([low, high]), [0, 360]]), "wrist")
        points = rng.uniform([-0.45, -0.35], [0.45, 0.55], (SAMPLES, 2))
        at = page.run("given(inputs)")
        values = [page.run(f"{points.tolist()}.map(p => levels[{k}](p, {at}, fixed)[0])") for k in (0, 1)]
        inside = np.max(np.array(values, float), axis=0) >= 0
        away = region.distances(points)[0] > 1e-6
        assert (inside == region.contains(points))[away].all()
        if (high > low).all() and arm.LYNX.L_1 == arm.LYNX.L_2:
            assert shown_numbers(page.said("The section of the wrist"))[0] == pytest.approx(
                region.area * 1e4, abs=0.06
            )


def test_the_wrist_is_where_its_angles_put_it_within_the_limits(rng):
    page = opened(the_section)
    limits = np.sort(rng.uniform(-np.pi, np.pi, (SAMPLES, 2, 2)), axis=1)
    q = rng.uniform(-np.pi, np.pi, (SAMPLES, 2))
    inputs = np.column_stack([limits[:, 0, 0], limits[:, 1, 0], limits[:, 0, 1], limits[:, 1, 1], q])
    clamped = np.clip(q, limits[:, 0], limits[:, 1])
    joints = arm.joint_positions(np.pad(clamped, ((0, 0), (1, 2))))[..., [0, 2]]
    (chain,) = rods(page)
    np.testing.assert_allclose(page.points(chain, inputs), joints[:, :4], atol=1e-7)


def test_the_wrist_can_be_led_and_stops_at_the_border_of_the_section():
    page = opened(the_section)
    q = np.deg2rad([0, 70, -60, 0, 0])
    page.lead(arm.joint_positions(q)[3, [0, 2]])
    np.testing.assert_allclose(page.run("inputs")[4:], [70, -60], atol=0.05)
    page.lead([-0.3, -0.2])
    assert page.run("reason") == "Here the section ends: a limit of a joint, or full stretch."
    theta_2, theta_3 = page.run("inputs")[4:]
    assert min(abs(theta_2 - np.array([0, 120]).min()), abs(theta_3 + 90), abs(theta_2 - 120)) < 0.2


@pytest.mark.committed_lengths
def test_the_hole_closes_at_a_half_turn_and_the_wrist_gets_below_the_floor():
    page = opened(the_section)
    page.slide("θ₃ from", -180)
    page.slide("θ₃ to", 180)
    assert page.met == [True, False]
    page.click("reset")
    for name, value in (("θ₂ from", -45), ("θ₃ to", 0), ("θ₂", -45), ("θ₃", 0)):
        page.slide(name, value)
    assert page.met == [True, True]


# A3


@functools.cache
def three_formulas():
    """Those of notebook A3, sections 1 and 3."""
    (_, r, z, pitch, _), (d_1, L_1, L_2, L_3), (r_wrist, h), theta_3 = TASK, P, WRIST, Q[2]
    wrist = sp.Matrix([r - L_3 * sp.cos(pitch), z - d_1 - L_3 * sp.sin(pitch)])
    cosine = (r_wrist**2 + h**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)
    shoulder = sp.atan2(h, r_wrist) - sp.atan2(L_2 * sp.sin(theta_3), L_1 + L_2 * sp.cos(theta_3))
    return wrist, cosine, shoulder


def the_branches(geometry=arm.LYNX):
    return explorers.branches_of_a_target(*three_formulas(), geometry)


def a_thousand_targets(rng, geometry):
    """azimuth, r, z, pitch; among them full stretch, and the wrist near the base axis."""
    far = sum(geometry)
    task = rng.uniform([-np.pi, -far, -far, -np.pi], [np.pi, far, far, np.pi], (SAMPLES, 4))
    task[0, 1:] = geometry.L_1 + geometry.L_2 + geometry.L_3, geometry.d_1, 0
    task[1, 1:] = geometry.L_3 + 1e-6, geometry.d_1 + 0.3 * far, 0
    return task


@pytest.mark.parametrize("geometry", [arm.LYNX, LONG])
def test_both_elbows_are_those_of_the_package_or_none_is_shown(geometry, rng):
    page, task = opened(the_branches, geometry), a_thousand_targets(rng, geometry)
    q = arm.joint_angles(np.pad(task, ((0, 0), (0, 1))), geometry)
    reached = np.isfinite(q).all(axis=(1, 2))
    assert reached[0]
    assert 0.1 < reached.mean() < 0.9
    for elbow, name in ((0, 1), (1, -1)):
        inputs = np.column_stack([task, np.full(SAMPLES, name)])
        chain, hand, *_ = rods(page, 1)
        joints = arm.joint_positions(q[:, elbow], geometry)
        along = joints @ np.stack([np.cos(task[:, 0]), np.sin(task[:, 0]), 0 * task[:, 0]], axis=1)[..., None]
        plane = np.concatenate([along, joints[..., 2:]], axis=2)
        assert ((page.at(inputs)[:, chain["when"]] >= 0) == reached).all()
        np.testing.assert_allclose(page.points(chain, inputs)[reached], plane[reached, :4], atol=1e-6)
        np.testing.assert_allclose(page.points(hand, inputs)[reached], plane[reached, 3:], atol=1e-6)
        upper, fore = rods(page)[:2]
        np.testing.assert_allclose(page.points(upper, inputs)[reached], joints[reached, 1:3], atol=1e-6)
        np.testing.assert_allclose(page.points(fore, inputs)[reached], joints[reached, 2:4], atol=1e-6)


@pytest.mark.parametrize(
    ("azimuth", "r", "z", "pitch"), [(30, 0.3, 0.2, -30), (30, -0.3, 0.2, -150), (-70, 0.1, 0.15, 0)]
)
def test_the_four_branches_are_said_and_which_are_beyond_a_limit(azimuth, r, z, pitch):
    page = opened(the_branches)
    page.set(azimuth, r, z, pitch, 1)
    own = np.deg2rad([azimuth, pitch])
    position = [r * np.cos(own[0]), r * np.sin(own[0]), z]
    facing = own[1] if r >= 0 else np.pi - own[1]
    q = arm.inverse_kinematics(position, facing, 0 if r >= 0 else np.pi)
    for names, angles, inside in zip(arm.BRANCHES, q, arm.within_limits(q), strict=True):
        said = page.said(", ".join(names))
        turns = np.deg2rad(shown_numbers(said)) - angles
        np.testing.assert_allclose(np.exp(1j * turns), 1, atol=0.01)
        assert ("✕" in said) != inside


@pytest.mark.committed_lengths
def test_what_is_out_of_reach_is_said_and_nothing_is_drawn():
    page = opened(the_branches)
    page.set(0, 0.5, 0.5, 0, 1)
    assert page.said("Out of reach") == (
        "Out of reach: the wrist would be 0.566 m from the shoulder; the links reach from 0.000 to 0.400 m."
    )
    assert [s for s in page.drawings[1].strokes if s.dashed]


@pytest.mark.committed_lengths
def test_the_target_can_be_led_in_both_views():
    page = opened(the_branches)
    page.lead([-0.2, 0.25], view=1)
    np.testing.assert_allclose(page.run("inputs")[:5], [30, -0.2, 0.25, -30, 1], atol=1e-6)
    page.click("reset")
    at = page.place([0.3 * np.cos(np.pi / 6), 0.3 * np.sin(np.pi / 6), 0.2])
    page.drag(0, at, at + [25, -10])
    azimuth, r, z, *_ = page.run("inputs")
    there = page.place([r * np.cos(np.deg2rad(azimuth)), r * np.sin(np.deg2rad(azimuth)), z])
    np.testing.assert_allclose(there, at + [25, -10], atol=0.01)
    assert r > 0


@pytest.mark.committed_lengths
def test_up_becomes_down_without_a_jump_at_full_stretch_only():
    page = opened(the_branches)
    page.lead([0.3, 0.45], view=1)
    page.slide("r", -0.3)
    assert page.run("tally[1].lost")  # the elbow flipped as the wrist passed the base
    page.click("reset")
    page.slide("pitch", 90)
    for place in ([0.06, 0.592], [-0.06, 0.592], [-0.2, 0.4]):
        page.lead(place, view=1)
    assert page.met == [True, True]


# B1


the_pitches = explorers.pitches_at_a_point


@pytest.mark.parametrize("geometry", [arm.LYNX, LONG])
def test_an_elbow_is_within_its_limits_where_the_package_says(geometry, rng):
    page, task = opened(the_pitches, geometry), a_thousand_targets(rng, geometry)
    q = arm.joint_angles(np.pad(task[:, 1:], ((0, 0), (1, 1))), geometry)
    inside = arm.within_limits(q)
    for elbow in (0, 1):
        level = page.items(kind="level")[elbow]["value"]
        values = page.run(f"{task[:, 1:].tolist()}.map(t => levels[{level}](t.slice(0, 2), t, fixed)[0])")
        assert ((np.array(values, float) >= 0) == inside[:, elbow]).all()
    assert 0.02 < inside.mean() < 0.9
    chain = rods(page)[2]  # of the elbow up, drawn last
    shapes = page.points(rods(page)[-2], task[:, 1:])
    assert chain["size"] == 2
    joints = arm.joint_positions(q[:, 0], geometry)[..., [0, 2]]
    np.testing.assert_allclose(shapes[inside[:, 0]], joints[inside[:, 0], :4], atol=1e-6)


@pytest.mark.committed_lengths
def test_all_pitches_of_the_point_are_on_a_circle_about_it():
    page = opened(the_pitches)
    wide = max(s.width for s in page.drawings[0].strokes)
    arcs = np.concatenate([s.points for s in page.drawings[0].strokes if s.width == wide])
    centre, edge = page.place([0.32, 0.2]), page.place([0.42, 0.2])
    np.testing.assert_allclose(np.linalg.norm(arcs - centre, axis=1), edge[0] - centre[0], rtol=1e-6)


@pytest.mark.committed_lengths
def test_a_point_with_one_elbow_is_found_and_the_farthest_with_the_gripper_down():
    page = opened(the_pitches)
    page.set(0.32, 0.2, -90)
    q = arm.joint_angles([0, 0.32, 0.2, -np.pi / 2, 0])
    assert arm.within_limits(q).tolist() == [True, False] or arm.within_limits(q).all()
    page.set(0.34, 0.2, -90)
    assert page.met[1]
    found = False
    for pitch in range(-180, 180, 5):
        page.set(0.3, 0.25, pitch)
        found = found or page.met[0]
        assert page.met[0] == found
    assert found


# B2


the_top = explorers.change_of_branch


@pytest.mark.committed_lengths
def test_over_the_base_each_branch_is_the_packages_and_the_gripper_on_its_line(rng):
    page = opened(the_top)
    x = np.append(rng.uniform(-0.2, 0.2, SAMPLES - 2), [0.2, -0.2])
    for number in (1, 2, 3, 4):
        inputs = np.column_stack([x, np.full(SAMPLES, number)])
        for view in (0, 1):
            fingers = page.items(view, kind="body", colour="x")
            tip = np.mean([page.points(f, inputs)[:, 1] for f in fingers], axis=0)
            np.testing.assert_allclose(tip, np.column_stack([x, 0 * x, np.full(SAMPLES, 0.5)]), atol=1e-7)
        pitch = np.pi / 2 - np.pi / 3 * abs(x) / 0.2
        q = arm.inverse_kinematics(np.column_stack([x, 0 * x, np.full(SAMPLES, 0.5)]), pitch)[:, number - 1]
        joints = arm.joint_positions(q)
        for rod, start in zip(rods(page, 1)[:2], (1, 2), strict=True):
            np.testing.assert_allclose(page.points(rod, inputs), joints[:, [start, start + 1]], atol=1e-6)


@pytest.mark.committed_lengths
def test_the_top_is_passed_without_a_jump_by_changing_the_branch_over_the_base():
    page = opened(the_top)
    page.slide("x", -0.2)
    assert page.run("tally[0]") == {"lost": True, "met": False}
    for wrong in ("front, down", "back, up"):
        page.click("reset")
        page.slide("x", 0)
        page.choose("branch", wrong)
        page.slide("x", -0.2)
        assert not page.met[0]
    page.click("reset")
    page.slide("x", 0)
    page.choose("branch", "back, down")
    page.slide("x", -0.2)
    assert page.met == [True]


# B3


the_thread = explorers.thread_around_a_ball
START, END = np.array([0, 0, 0.6, np.pi / 2, 0]), np.array([0, -0.2, 0.4, np.pi, 0])


def test_the_thread_is_the_packages_detour_and_so_is_the_clearance(rng):
    page, rows = opened(the_thread), []
    while len(rows) < SAMPLES:
        r, z, radius, margin = rng.uniform([-0.4, 0.2, 0.02, 0], [0.2, 0.7, 0.2, 0.08])
        with contextlib.suppress(LynxError):
            way = motion.detour(START, END, (r, z), radius, margin)
            rows += [([share, r, z, radius, margin, bend], way(share), (r, z), radius) for share, bend in zip(
                rng.uniform(0, 1, 10), rng.choice([-1, 1], 10), strict=True)]  # fmt: skip
    inputs, task = np.array([row[0] for row in rows]), np.array([row[1] for row in rows])
    q = arm.joint_angles(task)
    which = (np.sign(q[..., 2]) == inputs[:, 5:]).argmax(axis=1)
    q = q[np.arange(len(q)), which]
    reached = np.isfinite(q).all(axis=1)
    assert reached.mean() > 0.5
    chain, hand = rods(page)
    assert ((page.at(inputs)[:, chain["when"]] >= 0) == reached).all()
    joints = arm.joint_positions(q)[..., [0, 2]]
    np.testing.assert_allclose(page.points(chain, inputs)[reached], joints[reached, :4], atol=1e-5)
    np.testing.assert_allclose(page.points(hand, inputs)[reached, 1], task[reached, 1:3], atol=1e-6)
    start = page.facts["words"][0]["values"][0]
    clear = [
        obstacles.clearance(a, obstacles.Sphere((c[0], 0, c[1]), radius), 0.02)
        for a, (*_, c, radius) in zip(q, rows, strict=True)
    ]
    np.testing.assert_allclose(page.at(inputs)[reached, start + 1], np.array(clear)[reached], atol=1e-5)


def test_the_ball_can_be_led_and_where_an_end_is_too_near_there_is_no_way():
    page = opened(the_thread)
    page.lead([-0.05, 0.5])
    np.testing.assert_allclose(page.run("inputs")[1:3], [-0.05, 0.5], atol=1e-9)
    assert "Point 3 or point 4 is nearer" in " ".join(page.text)
    assert not [s for s in page.drawings[0].strokes if s.width == 2.5]


def test_the_ball_is_passed_with_a_margin_and_a_link_goes_through_a_small_one():
    page = opened(the_thread)
    page.slide("way", 1)
    assert page.run("tally[0]") == {"lost": True, "met": False}
    page.click("reset")
    page.slide("margin", 0.05)
    assert page.run("tally[0].lost") is False
    page.slide("way", 1)
    assert page.met == [True, False]
    page.set(0.5, -0.06, 0.5, 0.05, 0, -1)
    assert page.met == [True, True]


# Part 2


the_legs = explorers.legs_and_modes
CROOKED = rrr.Geometry(180, 120, 90, 260, base_angles=(1.5, 3.7, 5.6), platform_angles=(1.4, 3.6, 5.9))


@pytest.mark.parametrize("geometry", [rrr.RRR, CROOKED])
def test_the_legs_are_those_of_the_package_or_the_leg_is_named(geometry, rng):
    page = opened(the_legs, geometry)
    pose = rng.uniform([-200, -200, -np.pi / 2], [200, 200, np.pi / 2], (SAMPLES, 3))
    mode = rng.integers(0, 8, SAMPLES)
    bends = np.array(rrr.WORKING_MODES)[mode]
    theta = rrr.inverse_kinematics(pose, geometry)[np.arange(SAMPLES), mode]
    inputs, closes = np.column_stack([pose, bends]), np.isfinite(theta)
    PB, PP, M = rrr.base_joints(geometry), rrr.platform_joints(pose, geometry), rrr.elbows(theta, geometry)
    driven, distal = rods(page), page.items(kind="body", colour="pale")
    gaps = page.items(kind="line", colour="printed")
    assert (closes.mean(axis=0) > 0.2).all()
    for i in range(3):
        ok = closes[:, i]
        assert ((page.at(inputs)[:, driven[i]["when"]] >= 0) == ok).all()
        assert ((page.at(inputs)[:, gaps[i]["when"]] >= 0) == ~ok).all()
        base = np.broadcast_to(PB[i], (SAMPLES, 2))
        np.testing.assert_allclose(
            page.points(driven[i], inputs)[ok], np.stack([base, M[:, i]], axis=1)[ok], atol=1e-4
        )
        np.testing.assert_allclose(
            page.points(distal[i], inputs)[ok], np.stack([M[:, i], PP[:, i]], axis=1)[ok], atol=1e-4
        )
        np.testing.assert_allclose(page.points(gaps[i], inputs), np.stack([base, PP[:, i]], axis=1), atol=1e-4)
    outline = page.items(kind="body", colour="x")[0]
    np.testing.assert_allclose(page.points(outline, inputs), PP[:, [0, 1, 2, 0]], atol=1e-4)


def test_workspace_and_determinant_are_the_packages(rng):
    page = opened(the_legs)
    poses = rng.uniform([-200, -200, -1], [200, 200, 1], (SAMPLES, 3))
    bends = np.array(rrr.WORKING_MODES)[rng.integers(0, 8, SAMPLES)]
    rows = np.column_stack([poses, bends]).tolist()
    values = [page.run(f"{rows}.map(p => levels[{k}](p.slice(0, 2), p, fixed)[0])") for k in (0, 1)]
    reachable = rrr.reachable(poses)
    assert ((np.array(values[0], float) >= 0) == reachable).all()
    theta = rrr.inverse_kinematics(poses)[np.arange(SAMPLES), [rrr.WORKING_MODES.index(tuple(b)) for b in bends]]
    A, _ = rrr.jacobians(poses[reachable], theta[reachable])
    expected = np.linalg.det(A / [rrr.RRR.L, rrr.RRR.L, rrr.RRR.L * rrr.RRR.r_platform])
    np.testing.assert_allclose(np.array(values[1], float)[reachable], expected, atol=1e-6)


def test_the_platform_is_led_and_turned_and_stops_where_a_leg_cannot_close():
    page = opened(the_legs)
    page.lead([40, 60])
    np.testing.assert_allclose(page.run("inputs")[:2], [40, 60], atol=1e-6)
    page.lead([40, 60 + 130], handle=1)
    assert page.run("inputs")[2] == pytest.approx(0, abs=1e-6)
    page.lead([40, 300])
    pose = np.array(page.run("inputs")[:3]) * [1, 1, np.pi / 180]
    assert rrr.reachable(pose)
    assert not rrr.reachable(pose + [0, 0.1, 0])
    assert re.match(r"Leg [123] could not close: its ends would be \d+\.\d mm apart", page.run("reason"))


def test_the_platform_gets_loose_and_reaches_another_assembly_mode_without_a_singularity():
    page = opened(the_legs)
    home = np.array(page.run("inputs"))
    (dashed,) = [line for line in page.items(kind="line", colour="aid") if line.get("dashed")]
    corners = page.points(dashed, home[None])[0]
    there = np.append(corners[:3].mean(axis=0), 0)
    there[2] = np.rad2deg(np.arctan2(*(corners[0] - there[:2])[::-1])) - 90
    there[2] = (there[2] + 180) % 360 - 180
    straight = rrr.inverse_kinematics(home[:3] * [1, 1, np.pi / 180])[1]
    np.testing.assert_allclose(rrr.inverse_kinematics(there * [1, 1, np.pi / 180])[1], straight, atol=0.02)
    page.set(-100, 0, home[2], 1, 1, -1)
    assert page.run("tally[1].lost")
    page.click("reset")
    page.set(*there, 1, 1, -1)
    assert page.met == [False, True]
    meeting = rrr.RRR.r_base**2 + (rrr.RRR.r_platform + rrr.RRR.L) ** 2 - rrr.RRR.S_A**2
    alpha = np.arccos(meeting / (2 * rrr.RRR.r_base * (rrr.RRR.r_platform + rrr.RRR.L)))
    page.set(0, 0, np.rad2deg(alpha), 1, 1, 1)
    assert page.met == [True, True]
    assert "type 2: the locked motors do not hold the platform" in page.text


# Part 3


the_freedom = explorers.lost_freedom
PART_3 = arm.Geometry(5, 10, 10, 0)


def test_words_and_map_are_those_of_the_jacobian(rng):
    page = opened(the_freedom)
    q = rng.uniform(-np.pi, np.pi, (SAMPLES, 3))
    J = arm.jacobian(np.pad(q, ((0, 0), (0, 2))), PART_3)[:, :3, :3]
    singular, det = np.linalg.svd(J, compute_uv=False), np.linalg.det(J)
    words = {
        w["text"].split(" ")[0]: page.at(q)[:, w["values"][0] : sum(w["values"])] for w in page.facts["words"][:4]
    }
    np.testing.assert_allclose(words["determinant"][:, 0], det, atol=1e-5)
    np.testing.assert_allclose(words["singular"], singular, atol=1e-6)
    np.testing.assert_allclose(
        words["{}"][:, 0],
        np.hypot(*arm.joint_positions(np.pad(q, ((0, 0), (0, 2))), PART_3)[:, 3, :2].T),
        atol=1e-6,
    )
    np.testing.assert_allclose(words["speed"][:, 0], 1 / singular[:, 2], rtol=1e-5)
    level = page.items(1, kind="level")[0]["value"]
    shaded = page.run(f"{np.rad2deg(q[:, 1:]).tolist()}.map(p => levels[{level}](p, [0, 0, 0], fixed)[0])")
    assert (np.sign(np.array(shaded, float)) == np.sign(det)).all()


def test_the_ellipse_holds_the_velocities_and_the_pink_line_is_the_weakest_direction(rng):
    page = opened(the_freedom)
    ellipse = page.items(kind="line", colour="target")[0]["along"][0]
    for q in rng.uniform(-np.pi, np.pi, (20, 3)):
        whole = np.pad(q, (0, 2))
        J, end = arm.jacobian(whole, PART_3)[:3, :3], arm.joint_positions(whole, PART_3)[3]
        turns = np.linspace(0, 6, 7)
        found = page.run(f"{turns.tolist()}.map(t => curves[{ellipse}]([t], {q.tolist()}, fixed))")
        np.testing.assert_allclose(found, end + (0.3 * J[:, 1:] @ [np.cos(turns), np.sin(turns)]).T, atol=1e-6)
        lines = page.items(kind="body", colour="printed")
        (shown_line,) = [line for line in lines if page.at(q[None])[0, line["when"]] >= 0]
        ends = page.points(shown_line, q[None])[0]
        weakest = np.linalg.svd(J)[0][:, 2]
        assert abs((ends[1] - ends[0]) @ weakest) == pytest.approx(np.linalg.norm(ends[1] - ends[0]), rel=1e-6)


def test_the_end_is_led_by_the_inverse_and_the_dot_on_the_map_too():
    page = opened(the_freedom)
    end = arm.joint_positions(np.deg2rad([20, 30, -80, 0, 0]), PART_3)[3]
    at = page.place(end)
    page.drag(0, at, at + [-20, -30])
    q = np.deg2rad(page.run("inputs"))
    np.testing.assert_allclose(
        page.place(arm.joint_positions(np.pad(q, (0, 2)), PART_3)[3]), at + [-20, -30], atol=0.01
    )
    assert q[2] < 0
    page.lead([50, 60], view=1)
    np.testing.assert_allclose(page.run("inputs")[1:], [50, 60], atol=1e-9)


def test_a_freedom_is_lost_with_the_elbow_bent_and_the_best_posture_is_found():
    page = opened(the_freedom)
    page.set(20, 45, 90)
    assert page.met == [True, False]
    assert page.said("shoulder singularity")
    page.set(20, 30, -120)
    assert page.met == [True, True]
    page.set(20, 30, 0)
    assert page.said("elbow singularity")
    assert page.said("speed 1 in the worst direction") == "speed 1 in the worst direction: no joint speed will do"


# Motions from the notebooks


def over_there(n: int = 21) -> np.ndarray:
    start, end = np.deg2rad([[0, 60, -30, 60, 0], [90, 100, -60, 90, 45]])
    return start + np.linspace(0, 1, n)[:, None] * (end - start)


def a_motion():
    cubes = np.linspace([[0.1, 0, 0.1]], [[0.2, 0.1, 0.3]], 21)
    return explorers.arm_in_motion(
        over_there(), [np.array([[0, 0.2, 0], [0.2, 0.2, 0]])], cubes, title="Over there"
    )


def a_pair():
    return explorers.two_motions({"one way": over_there(), "back": over_there()[::-1]})


def the_platform():
    turn = np.linspace(0, 2 * np.pi, 41)
    poses = np.stack([60 * np.cos(turn), 60 * np.sin(turn), 0.3 * np.sin(turn)], axis=-1)
    return explorers.platform_in_motion(poses, rrr.inverse_kinematics(poses)[:, 0])


def test_a_motion_of_the_arm_is_that_of_its_table():
    page = opened(a_motion)
    page.click("play")
    for share, row in ((0, 0), (0.5, 10), (1, 20)):
        page.slide("time", share)
        joints = arm.joint_positions(over_there()[row])
        home = page.run("given(inputs)")
        for rod, start in zip(rods(page)[:2], (1, 2), strict=True):
            np.testing.assert_allclose(page.points(rod, np.array([home]))[0], joints[start : start + 2], atol=1e-4)
        assert page.said("gripper at") == "gripper at {:.3f}, {:.3f}, {:.3f} m".format(*joints[4].round(3) + 0.0)
        (cube,) = page.items(kind="body", colour="target")
        there = np.linspace([0.1, 0, 0.1], [0.2, 0.1, 0.3], 21)[row]
        np.testing.assert_allclose(page.points(cube, np.array([home]))[0, 0], there, atol=1e-4)


def test_a_trace_grows_with_the_motion():
    page = opened(a_motion)
    lengths = []
    for share in (0.2, 0.8):
        page.slide("time", share)
        blue = page.run("look.colours.z")
        lengths.append(len([s for s in page.drawings[0].strokes if s.colour == blue]))
    assert 0 < lengths[0] < lengths[1]


def test_two_motions_run_side_by_side():
    page = opened(a_pair)
    page.slide("time", 0)
    home = np.array([page.run("given(inputs)")])
    for view, row in ((0, 0), (1, 20)):
        joints = arm.joint_positions(over_there()[row])
        np.testing.assert_allclose(page.points(rods(page, view)[0], home)[0], joints[1:3], atol=1e-4)
    with pytest.raises(InputError, match="side by side"):
        explorers.two_motions({"one": over_there()})


def test_the_platform_moves_with_its_motors():
    page = opened(the_platform)
    page.slide("time", 0.25)
    pose = np.array([0, 60, 0.3])
    M = rrr.elbows(rrr.inverse_kinematics(pose)[0])
    home = np.array([page.run("given(inputs)")])
    for i, rod in enumerate(rods(page)):
        np.testing.assert_allclose(page.points(rod, home)[0, 1], M[i], atol=0.02)


@pytest.mark.parametrize("spoil", [lambda q: q[0], lambda q: q[:, :4], lambda q: q * np.nan, lambda q: q[:0]])
def test_a_motion_needs_finite_joint_angles(spoil):
    with pytest.raises(InputError):
        explorers.arm_in_motion(spoil(over_there()))


# All of them

STAGES = [the_arm, the_section, the_branches, the_pitches, the_top, the_thread, the_legs, the_freedom]
MOVING = [a_motion, a_pair, the_platform]


@pytest.mark.parametrize("make", STAGES + MOVING, ids=lambda make: make.__name__)
def test_a_stage_is_small_and_the_same_every_time(make):
    data = shown(make).data
    assert make().data == data
    assert len(data.encode()) < 60_000
    assert not re.search(r"https?:|\bsrc=|import|fetch|random|Date|eval|innerHTML", page_in(data))


@pytest.mark.parametrize("make", STAGES, ids=lambda make: make.__name__)
def test_a_stage_opens_within_its_sliders_with_nothing_met(make):
    page = opened(make)
    for control in page.facts["controls"]:
        if "options" in control:
            assert control["home"] in control["options"].values()
            continue
        assert control["low"] <= control["home"] <= control["high"]
        steps = (control["home"] - control["low"]) / control["step"]
        assert steps == pytest.approx(round(steps), abs=1e-6)
    assert not any(page.met)
    assert not any(one["lost"] for one in page.run("tally"))
    for words in page.facts["words"]:
        assert words["text"].count("{}") == words["values"][1]


@pytest.mark.parametrize("make", STAGES, ids=lambda make: make.__name__)
def test_every_control_changes_the_picture(make):
    page = opened(make)
    for control in page.facts["controls"]:
        page.click("reset")
        if make is the_thread and control["name"] == "elbow":
            page.slide("way", 0.5)  # at its ends the arm is stretched
        before = page.drawn
        if "options" in control:
            page.choose(control["name"], next(n for n, v in control["options"].items() if v != control["home"]))
        else:
            step = 5 * control["step"] * (1 if control["home"] < control["high"] else -1)
            page.slide(control["name"], control["home"] + step)
        assert page.drawn != before, control["name"]


@pytest.mark.parametrize("make", STAGES, ids=lambda make: make.__name__)
def test_wherever_its_controls_are_set_a_stage_draws_finite_numbers(make, rng):
    """The recording canvas refuses anything else."""
    page = opened(make)
    for _ in range(20):
        values = [
            rng.choice(list(c["options"].values())) if "options" in c else rng.uniform(c["low"], c["high"])
            for c in page.facts["controls"]
        ]
        hidden = page.run("home")[len(values) :]
        page.set(*values, *hidden)
        assert len(page.drawn) > 1000
