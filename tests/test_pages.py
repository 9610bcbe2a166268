"""The pages that need no kernel: their JavaScript gives what the package gives, and they ask for nothing else."""

import functools
import json
import re

import numpy as np
import pytest
import sympy as sp
from fake_browser import FakePage, compute, page_in

from lynx_common import arm, dh, rrr
from lynx_common.course.explorers import arm_page, reach_page, rrr_page
from lynx_common.course.script import Line, Slider, View, Words, javascript
from lynx_common.course.script import page as page_of
from lynx_common.drawing import COLOURS, gripper
from lynx_common.errors import InputError
from lynx_common.symbolic import TASK, WRIST, P, Q, numeric, tidy

SAMPLES = 400
LONG = arm.Geometry(0.15, 0.25, 0.18, 0.07)
CROOKED = rrr.Geometry(180, 120, 90, 260, base_angles=(1.5, 3.7, 5.6), platform_angles=(1.4, 3.6, 5.9))


@pytest.fixture
def rng():
    return np.random.default_rng(11)


@functools.cache
def the_arm(geometry=arm.LYNX):
    return arm_page([tidy(T) for T in dh.chain(arm.dh_table())], geometry)


@functools.cache
def the_reach(geometry=arm.LYNX):
    """With the three formulas of notebook A3, sections 1 and 3."""
    (_, r, z, pitch, _), (d_1, L_1, L_2, L_3), (r_wrist, h), theta_3 = TASK, P, WRIST, Q[2]
    wrist = sp.Matrix([r - L_3 * sp.cos(pitch), z - d_1 - L_3 * sp.sin(pitch)])
    cosine = (r_wrist**2 + h**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)
    shoulder = sp.atan2(h, r_wrist) - sp.atan2(L_2 * sp.sin(theta_3), L_1 + L_2 * sp.cos(theta_3))
    return reach_page(wrist, cosine, shoulder, geometry)


the_robot = functools.cache(rrr_page)


def source(shown) -> str:
    return page_in(shown.data)


def facts(shown) -> dict:
    return json.loads(re.search("^const facts = (.*);$", source(shown), re.MULTILINE).group(1))


def computed(shown, inputs: np.ndarray) -> tuple[list[dict], list[dict]]:
    """The page's lines and words, each with its "numbers" (samples, ...) and whether it is "shown"."""
    function = re.search("^const compute = (.*);$", source(shown), re.MULTILINE).group(1)
    given = facts(shown)
    numbers = compute(function, inputs, given["fixed"])
    lines = [line for view in given["views"] for line in view["lines"]]
    for item, (start, count) in [(i, i["points"]) for i in lines] + [(w, w["values"]) for w in given["words"]]:
        item["numbers"] = numbers[:, start : start + count]
        item["shown"] = numbers[:, item["when"]] >= 0
    for line in lines:
        line["numbers"] = line["numbers"].reshape(len(inputs), -1, 2)
    return lines, given["words"]


@pytest.mark.parametrize("geometry", [arm.LYNX, LONG])
def test_the_arm_stands_where_the_package_says(geometry, rng):
    q = rng.uniform(-np.pi, np.pi, (SAMPLES, 5))
    lines, words = computed(the_arm(geometry), q)
    joints, T = arm.joint_positions(q, geometry), arm.forward_kinematics(q, geometry)
    along = np.cos(q[:, :1]) * joints[..., 0] + np.sin(q[:, :1]) * joints[..., 1]
    side, above = lines[0]["numbers"], lines[5]["numbers"]
    order = [0, 1, 2, 3, 3, 4]  # frames 3 and 4 share the wrist
    np.testing.assert_allclose(side, np.stack([along, joints[..., 2]], axis=-1)[:, order], atol=1e-8)
    np.testing.assert_allclose(above, joints[:, order, :2], atol=1e-8)
    np.testing.assert_allclose(np.stack([w["numbers"] for w in words], axis=1), T, atol=1e-8)
    forks = [gripper(pose, 0.08 * sum(geometry))[:, :2] for pose in T]
    np.testing.assert_allclose(lines[6]["numbers"], forks, atol=1e-8)
    for i, line in enumerate(lines[7:10]):
        axis = np.diff(line["numbers"], axis=1)[:, 0]
        np.testing.assert_allclose(axis, 0.16 * sum(geometry) * T[:, :2, i], atol=1e-8)


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
    assert 0.1 < reached.mean() < 0.9
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


@pytest.mark.parametrize("geometry", [rrr.RRR, CROOKED])
def test_the_legs_are_those_of_the_package_or_the_leg_is_named(geometry, rng):
    pose = rng.uniform([-200, -200, -np.pi / 2], [200, 200, np.pi / 2], (SAMPLES, 3))
    mode = rng.integers(0, 8, SAMPLES)
    bends = np.array(rrr.WORKING_MODES)[mode]
    theta = rrr.inverse_kinematics(pose, geometry)[np.arange(SAMPLES), mode]
    lines, words = computed(the_robot(geometry), np.concatenate([pose, bends], axis=1))
    base, platform, *legs, needle = lines
    PB, PP, M = rrr.base_joints(geometry), rrr.platform_joints(pose, geometry), rrr.elbows(theta, geometry)
    corners = [0, 1, 2, 0]
    np.testing.assert_allclose(base["numbers"], np.broadcast_to(PB[corners], (SAMPLES, 4, 2)), atol=1e-5)
    np.testing.assert_allclose(platform["numbers"], PP[:, corners], atol=1e-5)
    np.testing.assert_allclose(needle["numbers"][:, 0], pose[:, :2], atol=1e-5)
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
        np.testing.assert_allclose(passive["numbers"][ok], ends[ok], atol=1e-4)
        np.testing.assert_allclose(active["numbers"][ok, 0], np.broadcast_to(PB[i], (ok.sum(), 2)), atol=1e-5)
        np.testing.assert_allclose(active["numbers"][ok, 1], M[ok, i], atol=1e-4)
        np.testing.assert_allclose(gap["numbers"], np.stack([0 * PP[:, i] + PB[i], PP[:, i]], axis=1), atol=1e-5)
        turns = np.deg2rad(angle["numbers"][ok, 0]) - theta[ok, i]
        np.testing.assert_allclose(np.exp(1j * turns), 1, atol=1e-6)
        np.testing.assert_allclose(refusal["numbers"][:, 0], rrr.leg_lengths(pose, geometry)[:, i], atol=1e-5)
        spans = [abs(geometry.S_A - geometry.L), geometry.S_A + geometry.L]
        np.testing.assert_allclose(refusal["numbers"][0, 1:], spans)
        assert name["label"] in refusal["text"]
        assert name["label"] == str(i + 1)


def in_data(drawing, points: np.ndarray) -> np.ndarray:
    """Pixels of a view, (n, 2), as the numbers that its own labels give them; scales must be equal."""
    labels = [
        (float(text.replace("\N{MINUS SIGN}", "-")), x, y) for text, x, y, _ in drawing.words if text[-1].isdigit()
    ]
    assert all(len(text) < 6 for text, *_ in drawing.words if text[-1].isdigit())
    assert {colour for *_, colour in drawing.words} <= {"#202020", *COLOURS.values()}
    along = [label for label in labels if label[2] == max(y for _, _, y in labels)]  # below the drawing
    beside = [label for label in labels if label[1] == min(x for _, x, _ in labels)]  # left of it
    (right, at_x), (up, at_y) = (
        np.polyfit(*np.transpose(along)[[1, 0]], 1),
        np.polyfit(*np.transpose(beside)[[2, 0]], 1),
    )
    assert right > 0
    assert right == pytest.approx(-up)
    return points * [right, up] + [at_x, at_y]


LINK, THICK = COLOURS["link"], 5


def test_the_arm_is_drawn_where_its_sliders_put_it(rng):
    page = FakePage(the_arm().data)
    for degrees in np.rint(np.rad2deg(rng.uniform(*arm.JOINT_LIMITS.T, (10, 5)))):
        for i, value in zip("₁₂₃₄₅", degrees, strict=True):
            page.slide(f"θ{i}", value)
        q = np.deg2rad(degrees)
        joints = arm.joint_positions(q)[[0, 1, 2, 3, 3, 4]]
        along = joints @ [np.cos(q[0]), np.sin(q[0]), 0]
        for drawing, seen in zip(page.drawings, (np.c_[along, joints[:, 2]], joints[:, :2]), strict=True):
            (links,) = drawing.of(LINK, THICK)
            np.testing.assert_allclose(in_data(drawing, links), seen, atol=1e-6)
            assert len([disc for disc in drawing.discs if disc[3] == LINK]) == 6
        assert [f"{value:.0f}°".replace("-", "\N{MINUS SIGN}") for value in degrees] == page.text[:5]
        rows = arm.forward_kinematics(q).round(3) + 0.0
        numbers = re.findall(r"[\N{MINUS SIGN} ]\d\.\d{3}", page.text[5])
        shown = [float(n.replace("\N{MINUS SIGN}", "-")) for n in numbers]
        np.testing.assert_allclose(np.reshape(shown, (4, 4)), rows, atol=1.1e-3)


def test_both_elbows_are_drawn_or_the_reason_why_none_is():
    page = FakePage(the_reach().data)
    for name, value in {"r": -0.2, "z": 0.3, "pitch": 90}.items():
        page.slide(name, value)
    (drawing,) = page.drawings
    up, down = arm.joint_angles([0, -0.2, 0.3, np.pi / 2, 0])
    dark, light = (up, down) if up[2] < 0 else (down, up)
    for colour, q in ((LINK, dark), ("#b8b8b8", light)):
        (links,) = drawing.of(colour, THICK)
        np.testing.assert_allclose(in_data(drawing, links), arm.joint_positions(q)[:, [0, 2]], atol=1e-6)
    assert all(f"{angle:.1f}" in page.text[-1] for angle in np.abs(np.rad2deg(dark[1:4])))
    assert "Out of reach" not in page.text[-1]
    page.slide("r", -0.6)
    assert page.drawings[0].of(LINK, THICK) == []
    assert page.text[-1].startswith("Out of reach: the wrist would be")


def test_the_legs_are_drawn_or_the_gap_of_one_that_cannot_close():
    page = FakePage(the_robot().data)
    for name, value in {"X": 40, "Y": -30, "alpha": 20, "bend 2": -1}.items():
        page.slide(name, value)
    pose, (drawing,) = np.array([40, -30, np.deg2rad(20)]), page.drawings
    mode = rrr.WORKING_MODES.index((1, -1, 1))
    M, PP = rrr.elbows(rrr.inverse_kinematics(pose)[mode]), rrr.platform_joints(pose)
    (platform,) = drawing.of(COLOURS["x"], 3)
    np.testing.assert_allclose(in_data(drawing, platform), PP[[0, 1, 2, 0]], atol=1e-4)
    for leg, line in enumerate(drawing.of(COLOURS["y"], 4)):
        np.testing.assert_allclose(in_data(drawing, line), [M[leg], PP[leg]], atol=1e-4)
    assert [text for text, *_ in drawing.words][-3:] == ["1", "2", "3"]
    page.slide("X", 290)
    assert len(page.drawings[0].of(COLOURS["y"], 4)) < 3
    assert any(stroke.dashed for stroke in page.drawings[0].strokes)


def test_a_line_is_dashed_where_it_says_so_and_a_view_names_its_axes():
    lines = [
        Line(sp.Matrix([[0, 0], [X, 1]]), "red", 3, dashed=True),
        Line(sp.Matrix([[0, 1], [1, 0]]), "blue", 1),
    ]
    view = View("time [s]", "way [m]", (0, 0), (1, 1), 0.5, lines)
    page = FakePage(page_of([view], [Slider(X, "x", 0, 1, 0.5, 0.1, "m")], [], {}, "a line", 100).data)
    strokes = {stroke.colour: stroke.dashed for stroke in page.drawings[0].strokes}
    assert strokes["red"]
    assert not strokes["blue"]
    assert {"time [s]", "way [m]"} <= {text for text, *_ in page.drawings[0].words}
    assert page.text[0] == "0.5 m"


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


def test_javascript_gives_what_numpy_gives(rng):
    inputs = rng.uniform(-3, 3, (SAMPLES, 2))
    found = compute(javascript(FUNCTIONS, (X, Y), (A,)), inputs, [0.7])
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
    shown = page_of([], [Slider(X, "x", 0, 1, 0)], [Words("</script>{}", [X])], {}, 'a "title" <b>', 100)
    assert source(shown).count("</script>") == 1
    assert facts(shown)["words"][0]["text"] == "</script>{}"
    assert FakePage(shown.data).text == ["0 °".replace(" ", ""), "</script> 0.000"]
    assert 'title="a &quot;title&quot; &lt;b&gt;"' in shown.data


@pytest.mark.parametrize("name", ["variable", "party", "part", "inside", "mathematics"])
def test_a_name_that_only_begins_like_one_will_do(name):
    symbol = sp.Symbol(name)
    assert javascript([symbol + 1], (symbol,)) == f"([{name}]) => {{ return [{name} + 1]; }}"


PAGES = [the_arm, the_reach, the_robot]


@pytest.mark.parametrize("make", PAGES)
def test_a_page_is_small_the_same_every_time_and_asks_for_nothing(make):
    shown = make()
    assert shown.data == getattr(make, "__wrapped__", make)().data  # made anew
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
        steps = (slider["home"] - slider["low"]) / slider["step"]
        assert steps == pytest.approx(round(steps), abs=1e-6)
    for words in given["words"]:
        assert words["text"].count("{}") == words["values"][1]


@pytest.mark.parametrize("text", ["COMPUTE", "FACTS", "<!--<script>", "</SCRIPT >", "{}COMPUTE"])
def test_no_text_of_the_caller_is_taken_for_the_pages_own(text):
    words = [Words(text, [X])] if "{}" in text else [Words(text)]
    shown = page_of([], [Slider(X, text, 0, 1, 0, unit=text)], words, {}, text, 100)
    page = FakePage(shown.data)
    assert page.run("created.find(e => e.tag === 'label').children[0]") == text
    assert page.text[0] == f"0 {text}"
    assert "<!--" not in source(shown)


@pytest.mark.parametrize("height", ["100px;background:url(x)", 100.5, True, 0, None])
def test_a_height_is_a_number_of_pixels(height):
    with pytest.raises(InputError, match="whole number of pixels"):
        page_of([], [], [], {}, "", height)


@pytest.mark.parametrize("make", PAGES)
def test_the_numbers_of_a_page_are_the_same_on_every_processor(make):
    """They have at most nine significant digits; more would differ in the last."""
    for number in re.findall(r"(?<![\w.])\d+\.?\d*(?:e[+-]\d+)?", source(make())):
        assert len(number.split("e")[0].replace(".", "").strip("0")) <= 9
