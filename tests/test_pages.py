"""The pages that need no kernel: their JavaScript gives what the package gives, and they ask for nothing else."""

import html
import json
import re
import shutil
import subprocess

import numpy as np
import pytest
import sympy as sp

from lynx_common import arm, dh, rrr
from lynx_common.course.explorers import arm_page, reach_page, rrr_page
from lynx_common.course.script import Slider, Words, javascript, page
from lynx_common.drawing.arm import gripper
from lynx_common.errors import InputError
from lynx_common.symbolic import TASK, WRIST, P, Q, numeric, tidy

SAMPLES = 1000
NODE = shutil.which("node")
needs_node = pytest.mark.skipif(NODE is None, reason="Node is not installed")
LONG = arm.Geometry(0.15, 0.25, 0.18, 0.07)
CROOKED = rrr.Geometry(180, 120, 90, 260, base_angles=(1.5, 3.7, 5.6), platform_angles=(1.4, 3.6, 5.9))


@pytest.fixture
def rng():
    return np.random.default_rng(11)


def the_arm(geometry=arm.LYNX):
    return arm_page([tidy(T) for T in dh.chain(arm.dh_table())], geometry)


def the_reach(geometry=arm.LYNX):
    """With the three formulas of notebook A3, sections 1 and 3."""
    (_, r, z, pitch, _), (d_1, L_1, L_2, L_3), (r_wrist, h), theta_3 = TASK, P, WRIST, Q[2]
    wrist = sp.Matrix([r - L_3 * sp.cos(pitch), z - d_1 - L_3 * sp.sin(pitch)])
    cosine = (r_wrist**2 + h**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)
    shoulder = sp.atan2(h, r_wrist) - sp.atan2(L_2 * sp.sin(theta_3), L_1 + L_2 * sp.cos(theta_3))
    return reach_page(wrist, cosine, shoulder, geometry)


def source(shown) -> str:
    return html.unescape(re.search('srcdoc="([^"]*)"', shown.data).group(1))


def facts(shown) -> dict:
    return json.loads(re.search("^const facts = (.*);$", source(shown), re.MULTILINE).group(1))


def run(function: str, inputs: np.ndarray, *fixed: list) -> np.ndarray:
    """What the JavaScript function gives for each row of inputs; null stands for NaN."""
    program = f"""
        const compute = {function}, rows = JSON.parse(require("fs").readFileSync(0));
        console.log(JSON.stringify(rows.map(row => compute(row, ...{json.dumps(fixed)}))));"""
    text = json.dumps(inputs.tolist())
    out = subprocess.run([NODE, "-e", program], input=text, capture_output=True, text=True, check=True).stdout
    return np.array(json.loads(out), dtype=float)


def computed(shown, inputs: np.ndarray) -> tuple[list[dict], list[dict]]:
    """The page's lines and words, each with its "numbers" (samples, ...) and whether it is "shown"."""
    compute = re.search("^const compute = (.*);$", source(shown), re.MULTILINE).group(1)
    given = facts(shown)
    numbers = run(compute, inputs, given["fixed"])
    lines = [line for view in given["views"] for line in view["lines"]]
    for item, (start, count) in [(i, i["points"]) for i in lines] + [(w, w["values"]) for w in given["words"]]:
        item["numbers"] = numbers[:, start : start + count]
        item["shown"] = numbers[:, item["when"]] >= 0
    for line in lines:
        line["numbers"] = line["numbers"].reshape(len(inputs), -1, 2)
    return lines, given["words"]


@needs_node
@pytest.mark.parametrize("geometry", [arm.LYNX, LONG])
def test_the_arm_stands_where_the_package_says(geometry, rng):
    q = rng.uniform(-np.pi, np.pi, (SAMPLES, 5))
    lines, words = computed(the_arm(geometry), q)
    joints, T = arm.joint_positions(q, geometry), arm.forward_kinematics(q, geometry)
    along = np.cos(q[:, :1]) * joints[..., 0] + np.sin(q[:, :1]) * joints[..., 1]
    side, above = lines[0]["numbers"], lines[5]["numbers"]
    order = [0, 1, 2, 3, 3, 4]  # frames 3 and 4 share the wrist
    np.testing.assert_allclose(side, np.stack([along, joints[..., 2]], axis=-1)[:, order], atol=1e-12)
    np.testing.assert_allclose(above, joints[:, order, :2], atol=1e-12)
    np.testing.assert_allclose(np.stack([w["numbers"] for w in words], axis=1), T, atol=1e-12)
    forks = [gripper(pose, 0.08 * sum(geometry))[:, :2] for pose in T]
    np.testing.assert_allclose(lines[6]["numbers"], forks, atol=1e-12)
    for i, line in enumerate(lines[7:10]):
        axis = np.diff(line["numbers"], axis=1)[:, 0]
        np.testing.assert_allclose(axis, 0.16 * sum(geometry) * T[:, :2, i], atol=1e-12)


@needs_node
@pytest.mark.parametrize("geometry", [arm.LYNX, LONG])
def test_both_elbows_are_those_of_the_package_or_none_is_shown(geometry, rng):
    far = sum(geometry)
    r, z, pitch = rng.uniform([-far, -far, -np.pi], [far, far, np.pi], (SAMPLES, 3)).T
    d_1, L_1, L_2, L_3 = geometry
    r[:3], z[:3], pitch[:3] = [L_1 + L_2 + L_3, 0.02, 0], d_1, [0, 0.3, np.pi]  # full stretch; near; ...
    q = arm.joint_angles(np.stack([0 * r, r, z, pitch, 0 * r], axis=-1), geometry)
    lines, words = computed(the_reach(geometry), np.stack([r, z, pitch], axis=-1))
    light, dark = lines[2:4]
    reached = np.isfinite(q).all(axis=(1, 2))
    assert reached[0]
    assert 100 < reached.sum() < 900
    refusal, heading, *angles = words
    for item in (light, dark, heading, *angles):
        assert (item["shown"] == reached).all()
    assert (refusal["shown"] == ~reached).all()
    for sign, line, row in ((1, light, angles[0]), (-1, dark, angles[1])):
        which = (np.sign(q[..., 2]) == sign).argmax(axis=1)  # elbow up or down
        own = q[np.arange(SAMPLES), which][reached]
        joints = arm.joint_positions(own, geometry)[..., [0, 2]]
        np.testing.assert_allclose(line["numbers"][reached], joints, atol=1e-7)
        turns = np.deg2rad(row["numbers"][reached]) - own[:, 1:4]
        np.testing.assert_allclose(np.exp(1j * turns), 1, atol=1e-6)
    assert (refusal["numbers"][~reached, 0] > L_1 + L_2).any()
    for circle, radius in zip(lines[:2], (L_1 + L_2, abs(L_1 - L_2)), strict=True):
        np.testing.assert_allclose(np.hypot(*(circle["numbers"][0] - [0, d_1]).T), radius, atol=1e-4)
    back, target = lines[4:]
    np.testing.assert_allclose(back["numbers"][reached], joints[:, [4, 3]], atol=1e-7)
    np.testing.assert_allclose(target["numbers"][:, 0], np.stack([r, z], axis=-1))


@needs_node
@pytest.mark.parametrize("geometry", [rrr.RRR, CROOKED])
def test_the_legs_are_those_of_the_package_or_the_leg_is_named(geometry, rng):
    pose = rng.uniform([-200, -200, -np.pi / 2], [200, 200, np.pi / 2], (SAMPLES, 3))
    mode = rng.integers(0, 8, SAMPLES)
    bends = np.array(rrr.WORKING_MODES)[mode]
    theta = rrr.inverse_kinematics(pose, geometry)[np.arange(SAMPLES), mode]
    lines, words = computed(rrr_page(geometry), np.concatenate([pose, bends], axis=1))
    base, platform, *legs, needle = lines
    PB, PP, M = rrr.base_joints(geometry), rrr.platform_joints(pose, geometry), rrr.elbows(theta, geometry)
    corners = [0, 1, 2, 0]
    np.testing.assert_allclose(base["numbers"], np.broadcast_to(PB[corners], (SAMPLES, 4, 2)), atol=1e-9)
    np.testing.assert_allclose(platform["numbers"], PP[:, corners], atol=1e-9)
    np.testing.assert_allclose(needle["numbers"][:, 0], pose[:, :2], atol=1e-9)
    closes = np.isfinite(theta)
    assert (closes.mean(axis=0) > 0.2).all()
    assert (closes.mean(axis=0) < 0.9).all()
    for i in range(3):
        passive, active, gap, name = legs[4 * i : 4 * i + 4]
        angle, refusal = words[2 * i : 2 * i + 2]
        for item, expected in ((passive, True), (active, True), (angle, True), (gap, False), (refusal, False)):
            assert (item["shown"] == (closes[:, i] == expected)).all()
        ok = closes[:, i]
        ends = np.stack([M[:, i], PP[:, i]], axis=1)
        np.testing.assert_allclose(passive["numbers"][ok], ends[ok], atol=1e-6)
        np.testing.assert_allclose(active["numbers"][ok, 0], np.broadcast_to(PB[i], (ok.sum(), 2)), atol=1e-9)
        np.testing.assert_allclose(active["numbers"][ok, 1], M[ok, i], atol=1e-6)
        np.testing.assert_allclose(gap["numbers"], np.stack([0 * PP[:, i] + PB[i], PP[:, i]], axis=1), atol=1e-9)
        turns = np.deg2rad(angle["numbers"][ok, 0]) - theta[ok, i]
        np.testing.assert_allclose(np.exp(1j * turns), 1, atol=1e-6)
        np.testing.assert_allclose(refusal["numbers"][:, 0], rrr.leg_lengths(pose, geometry)[:, i], atol=1e-9)
        spans = [abs(geometry.S_A - geometry.L), geometry.S_A + geometry.L]
        np.testing.assert_allclose(refusal["numbers"][0, 1:], spans)
        assert name["label"] in refusal["text"]
        assert name["label"] == str(i + 1)


X, Y, A = sp.symbols("x y a", real=True)
FUNCTIONS = [
    sp.atan2(X, Y) + sp.pi * A,
    sp.sqrt(X) / 3,  # NaN where x is negative
    sp.Max(X, Y, A) - sp.Min(X, sp.Rational(1, 3)),
    sp.Abs(X) ** 3 + sp.ceiling(Y) * sp.floor(A),
    (X + Y) ** 2 + sp.sin(X + Y) * sp.cos(X + Y),
    sp.asin(X / 3) - sp.acos(Y / 2),
    sp.tan(X) + sp.exp(-Y),
]


@needs_node
def test_javascript_gives_what_numpy_gives(rng):
    inputs = rng.uniform(-3, 3, (SAMPLES, 2))
    found = run(javascript(FUNCTIONS, (X, Y), (A,)), inputs, [0.7])
    expected = numeric(sp.Matrix(FUNCTIONS), (X, Y), (A,))(inputs, [0.7])
    np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)
    assert np.isnan(expected).any()


def test_what_no_vector_lists_is_refused():
    with pytest.raises(InputError, match="also hold a, y"):
        javascript([X + Y * A], (X,))


@pytest.mark.parametrize("name", ["theta'", "2x", "part0", "x;alert(1)", "θ", "var", "Math"])
def test_a_name_that_is_none_in_javascript_is_refused(name):
    with pytest.raises(InputError, match="JavaScript"):
        javascript([sp.Symbol(name)], (sp.Symbol(name),))


def test_neither_a_title_nor_a_text_ends_the_page():
    shown = page([], [Slider(X, "x", 0, 1, 0)], [Words("</script>{}", [X])], {}, 'a "title" <b>', 100)
    assert source(shown).count("</script>") == 1
    assert facts(shown)["words"][0]["text"] == "</script>{}"
    assert 'title="a &quot;title&quot; &lt;b&gt;"' in shown.data


@pytest.mark.parametrize("name", ["variable", "party", "part", "inside", "mathematics"])
def test_a_name_that_only_begins_like_one_will_do(name):
    symbol = sp.Symbol(name)
    assert javascript([symbol + 1], (symbol,)) == f"([{name}]) => {{ return [{name} + 1]; }}"


PAGES = [the_arm, the_reach, rrr_page]


@pytest.mark.parametrize("make", PAGES)
def test_a_page_is_small_the_same_every_time_and_asks_for_nothing(make):
    shown = make()
    assert shown.data == make().data
    assert len(shown.data) < 20_000
    assert not re.search(r"https?:|src=|import|fetch|random|Date", source(shown))
    assert shown.data.count('"') == 6  # srcdoc, title and style


@pytest.mark.parametrize("make", PAGES)
def test_it_opens_within_its_views_and_its_sliders(make):
    given = facts(make())
    for view in given["views"]:
        assert np.ptp([view["low"], view["high"]], axis=0) == pytest.approx(view["high"][0] - view["low"][0])
    for slider in given["sliders"]:
        assert slider["low"] < slider["high"]
        assert slider["low"] <= slider["home"] <= slider["high"]
        assert (slider["home"] - slider["low"]) / slider["step"] % 1 == pytest.approx(0, abs=1e-6)
    for words in given["words"]:
        assert words["text"].count("{}") == words["values"][1]
