"""The stages of the course: they compute what the package computes, and their challenges can be met."""

import functools
import re

import numpy as np
import pytest
from fake_browser import FakePage, page_in

from lynx_common import arm, dh
from lynx_common.course import explorers
from lynx_common.drawing.arm import gripper
from lynx_common.symbolic import tidy

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
        """All numbers, computed once for the same inputs."""
        if self.known is None or self.known[0] is not inputs:
            self.known = inputs, self.numbers(inputs)
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
        """All inputs at once, as a handle would, in the units of the sliders."""
        self.run(f"go({[float(v) for v in values]})")

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
    ends = sorted([finger[:, 1] for finger in fingers], key=lambda p: -np.linalg.norm(p - width[:, 0], axis=1).max())
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


# All of them

STAGES = [the_arm]


@pytest.mark.parametrize("make", STAGES, ids=lambda make: make.__name__)
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
def test_every_control_changes_the_picture_or_the_words(make):
    page = opened(make)
    for control in page.facts["controls"]:
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
