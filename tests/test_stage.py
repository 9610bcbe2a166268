"""The stage: its formulas, its geometry, its drags, its challenges, its page."""

import json
import re

import numpy as np
import pytest
import sympy as sp
from fake_browser import FakePage, compute, page_in

from lynx_common.course.stage import (
    Body,
    Challenge,
    Choice,
    Handle,
    Level,
    Line,
    Motion,
    Plane,
    Slider,
    Space,
    Words,
    before,
    javascript,
    largest,
    least,
    magnitude,
    stage,
)
from lynx_common.errors import InputError
from lynx_common.symbolic import numeric

X, Y, A = sp.symbols("x y a", real=True)
SAMPLES = 1000
FUNCTIONS = [
    sp.atan2(X, Y) + sp.pi * A,
    sp.sqrt(X) / 3,  # NaN where x is negative
    sp.Max(X, Y, A) - sp.Min(X, sp.Rational(1, 3)),
    sp.Abs(X) ** 3 + sp.ceiling(Y) * sp.floor(A),
    (X + Y) ** 2 + sp.sin(X + Y) * sp.cos(X + Y),
    sp.asin(X / 3) - sp.acos(Y / 2),
    sp.tan(X) + sp.exp(-Y),
    sp.Piecewise((X, Y > 0), (sp.nan, True)),
    sp.Piecewise((X, sp.And(Y > 0, X > 0)), (Y, sp.Or(X > 1, Y < -1)), (A, True)),
]


@pytest.fixture
def rng():
    return np.random.default_rng(11)


ONE = (Slider(X, "x", 0, 1, 0.5, 0.1, "m"),)


def plane(*items, low=(0, 0), high=(1, 1), handles=()):
    return Plane("x [m]", "y [m]", low, high, 0.5, items, handles)


def space(*items, handles=(), turn=0, tilt=0):
    return Space((0, 0, 0), 1, 0.5, items, handles, turn=turn, tilt=tilt)


def opened(views=(), controls=ONE, words=(), fixed=None, title="a stage", **more):
    views = views if isinstance(views, list | tuple) else [views]
    return FakePage(stage(views, controls, words, fixed or {}, title, **more))


# Formulas


def test_javascript_gives_what_numpy_gives(rng):
    inputs = rng.uniform(-3, 3, (SAMPLES, 2))
    found = compute(javascript(FUNCTIONS, (X, Y), (A,)), inputs, [0.7])
    expected = numeric(sp.Matrix(FUNCTIONS), (X, Y), (A,))(inputs, [0.7])
    np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)
    assert np.isnan(expected).any()


def test_the_smallest_the_largest_and_the_size_are_those_of_numpy_and_nan_is_passed_on(rng):
    inputs = rng.uniform(-3, 3, (SAMPLES, 2))
    functions = [least(X, Y, A), largest(X, Y, A), magnitude(X), least(X, sp.sqrt(Y))]
    found = compute(javascript(functions, (X, Y), (A,)), inputs, [0.7])
    x, y = inputs.T
    with np.errstate(invalid="ignore"):
        rows = [
            np.minimum(np.minimum(x, y), 0.7),
            np.maximum(np.maximum(x, y), 0.7),
            abs(x),
            np.minimum(x, np.sqrt(y)),
        ]
    np.testing.assert_allclose(found.T, rows)


def test_what_no_vector_lists_is_refused():
    with pytest.raises(InputError, match="also hold a, y"):
        javascript([X + Y * A], (X,))


@pytest.mark.parametrize("name", ["theta'", "2x", "part0", "x;alert(1)", "θ", "var", "Math", "NaN"])
def test_a_name_that_is_none_in_javascript_is_refused(name):
    with pytest.raises(InputError, match="JavaScript"):
        javascript([sp.Symbol(name)], (sp.Symbol(name),))


@pytest.mark.parametrize("name", ["variable", "party", "part", "inside", "mathematics"])
def test_a_name_that_only_begins_like_one_will_do(name):
    symbol = sp.Symbol(name)
    assert javascript([symbol + 1], (symbol,)) == f"([{name}]) => {{ return [{name} + 1]; }}"


# Where things stand


def test_a_plane_has_equal_scales_x_to_the_right_and_y_up():
    page = opened(plane(Line(sp.Matrix([[0, 0], [1, 0], [0, 1]]), "x", 3)))
    (line,) = [s.points for s in page.drawings[0].strokes if s.width == 3]
    right, up = line[1] - line[0], line[2] - line[0]
    assert right[0] > 100
    assert right[1] == pytest.approx(0)
    np.testing.assert_allclose(up, [0, -right[0]], atol=1e-9)


def test_a_plane_says_what_its_numbers_and_axes_are():
    drawing = opened(plane(low=(-1, -1), high=(1, 1))).drawings[0]
    words = {text: (x, y) for text, x, y, _ in drawing.words}
    assert {"x [m]", "y [m]", "\N{MINUS SIGN}1", "0", "1"} <= set(words)
    page = opened(plane(low=(-1, -1), high=(1, 1)))
    x_of = {text: x for text, x, y, _ in drawing.words if y == max(y for t, _, y, _ in drawing.words if t == "1")}
    for text, x in x_of.items():
        if text != "x [m]":
            assert page.place([float(text.replace("\N{MINUS SIGN}", "-")), 0])[0] == pytest.approx(x)


def test_in_space_z_is_up_x_to_the_right_and_what_is_nearer_is_larger():
    page = opened(space())
    centre, x, y, z = (page.place(p) for p in ([0, 0, 0], [0.5, 0, 0], [0, 0.5, 0], [0, 0, 0.5]))
    assert x[0] > centre[0]
    assert z[1] < centre[1]
    np.testing.assert_allclose([x[1], z[0], y[0]], [centre[1], centre[0], centre[0]], atol=1e-9)
    near, far = (np.diff([page.place([-0.5, y, 0])[0], page.place([0.5, y, 0])[0]]) for y in (-0.5, 0.5))
    assert near > far


def test_from_above_y_is_up_and_tilting_lifts_what_is_far():
    above = opened(space(tilt=90))
    assert above.place([0, 0.5, 0])[1] < above.place([0, 0, 0])[1]
    assert above.place([0.5, 0, 0])[0] > above.place([0, 0, 0])[0]
    tilted = opened(space(tilt=30))
    assert tilted.place([0, 0.5, 0])[1] < tilted.place([0, -0.5, 0])[1]


def test_a_point_on_the_canvas_leads_back_to_the_point_in_space(rng):
    page = opened(space(turn=-40, tilt=25))
    for point in rng.uniform(-1, 1, (20, 3)):
        camera = "space(views[0], 500, 400, -40, 25)"
        back = page.run(f"(([x, y, depth]) => {camera}.back([x, y], depth))({camera}.place({point.tolist()}))")
        np.testing.assert_allclose(back, point, atol=1e-12)


@pytest.mark.parametrize(("turn", "tilt"), [(0, 10), (35, 60), (200, 90)])
def test_turning_keeps_distances_apart_from_perspective(turn, tilt, rng):
    page = opened(space())
    points = rng.uniform(-1, 1, (2, 3))
    seen = page.run(f"{points.tolist()}.map(space(views[0], 500, 400, {turn}, {tilt}).axes)")
    assert np.linalg.norm(np.subtract(*seen)) == pytest.approx(np.linalg.norm(np.subtract(*points)))


def test_what_is_farther_is_drawn_first():
    balls = [Body(sp.Matrix([[0, y, 0]]), 0.1, colour) for y, colour in ((-0.5, "x"), (0.5, "y"), (0, "z"))]
    discs = opened(space(*balls)).drawings[0].discs
    assert [disc[2] for disc in discs] == sorted(disc[2] for disc in discs)
    assert len(discs) == 3


def test_a_ball_has_its_radius_at_the_scale_of_the_picture():
    page = opened(plane(Body(sp.Matrix([[0.5, 0.5]]), 0.25 * X, "x")))
    (x, y, radius, _), centre = page.drawings[0].discs[0], page.place([0.5, 0.5])
    assert (x, y) == pytest.approx(tuple(centre))
    assert radius == pytest.approx(page.place([0.625, 0.5])[0] - centre[0])


def test_the_shadow_lies_on_the_floor_below_the_body():
    page = opened(space(Body(sp.Matrix([[0.2, 0.3, 0.5]]), 0.1, "x"), tilt=30))
    shadow = [points for points, colour in page.drawings[0].shapes if colour == page.run("look.shadow")]
    assert len(shadow) == 5
    np.testing.assert_allclose(shadow[-1].mean(axis=0), page.place([0.2, 0.3, 0]), atol=2)


def test_a_region_is_where_its_value_is_not_negative_and_its_border_where_it_is_zero():
    page = opened()
    found = page.run("contour((a, b) => 1 - a * a - b * b, [-1.5, -1.5], [1.5, 1.5], 40, 40)")
    area = sum(abs(_area(np.array(polygon))) for polygon in found["region"])
    assert area == pytest.approx(np.pi, rel=2e-3)
    ends = np.array(found["border"]).reshape(-1, 2)
    np.testing.assert_allclose(np.hypot(*ends.T), 1, atol=2e-3)
    nothing = page.run("contour((a, b) => a > 0 ? NaN : -1, [-1, -1], [1, 1], 9, 9)")
    assert nothing == {"region": [], "border": []}
    half = page.run("contour((a, b) => a > 0.01 ? NaN : 1, [-1, -1], [1, 1], 20, 20)")
    assert sum(abs(_area(np.array(polygon))) for polygon in half["region"]) == pytest.approx(2)
    assert half["border"] == []


def _area(points: np.ndarray) -> float:
    x, y = points.T
    return (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2


@pytest.mark.parametrize("value", [sp.nan, sp.sqrt(X - 2), 1 / (X - X.subs(X, 0.5) + X * 0) * 0 + sp.nan])
def test_nothing_is_drawn_where_a_number_is_missing(value):
    bodies = Body(sp.Matrix([[0, value, 0], [0, 0, 0]]), 0.1, "x"), Body(sp.Matrix([[0, 0, 0]]), value, "x")
    line = Line(sp.Matrix([[0, value], [1, 1]]), "x", 3, dots=4, label="here", filled=True)
    hidden = Line(sp.Matrix([[0, 0], [1, 1]]), "y", 3, when=value)
    handle = Handle(sp.Matrix([[value, 0]]), (X, Y), {X: X})
    page = opened([space(*bodies), plane(line, hidden, Level(value, (Y, A), "x"), handles=[handle])])
    solids, flat = page.drawings
    assert [s for s in solids.shapes if s[1] != page.run("look.shadow")] == []
    assert {s.width for s in flat.strokes} <= {1, 1.5}  # the grid, and the border of nothing
    assert "here" not in [text for text, *_ in flat.words]
    assert page.run("views[1].handles.length") == 1
    assert flat.discs == []


def test_a_curve_has_gaps_where_a_number_is_missing():
    t = sp.Symbol("t", real=True)
    place = sp.Matrix([[t, sp.Piecewise((0, (t - 0.5) ** 2 > 0.011), (sp.nan, True))]])
    page = opened(plane(Line(place, "x", 3, along=(t, 0, 1, 20))))
    runs = [s.points for s in page.drawings[0].strokes if s.width == 3]
    assert len(runs) == 2
    assert len(runs[0]) + len(runs[1]) == 16


# From controls to pictures


def test_a_slider_moves_what_depends_on_it_and_degrees_become_radians():
    line = Line(sp.Matrix([[0, 0], [sp.cos(X), sp.sin(X)]]), "x", 3)
    page = opened(plane(line, low=(-1, -1)), [Slider(X, "θ", -180, 180, 0)], [Words("cos is {}", [sp.cos(X)], 2)])
    page.slide("θ", 90)
    (points,) = [s.points for s in page.drawings[0].strokes if s.width == 3]
    np.testing.assert_allclose(points, [page.place([0, 0]), page.place([0, 1])], atol=1e-9)
    assert "cos is 0.00" in page.text
    assert "90°" in page.text
    page.slide("θ", -120)
    assert "cos is \N{MINUS SIGN}0.50" in page.text
    assert page.run("control('θ').attributes['aria-valuetext']") == "\N{MINUS SIGN}120°"


def test_a_choice_sets_one_of_its_numbers():
    choice = Choice(Y, "side", {"left": 1, "right": -1}, 1)
    page = opened([], [Slider(X, "x", 0, 1, 0.5, 0.1), choice], [Words("{}", [Y], 0)])
    page.choose("side", "right")
    assert page.run("inputs") == [0.5, -1]
    page.click("reset")
    assert page.run("inputs") == [0.5, 1]


def test_words_come_and_go():
    page = opened([], words=[Words("high", when=X - 0.7), Words("low", when=0.3 - X)])
    assert not {"high", "low"} & set(page.text)
    page.slide("x", 0.9)
    assert "high" in page.text


def test_arrow_keys_turn_space_and_a_pointer_does_and_a_finger_leaves_the_tilt_to_the_page():
    page = opened(space(Body(sp.Matrix([[0.5, 0, 0]]), 0.1, "x"), turn=10, tilt=20))
    disc = page.drawings[0].discs[0]
    page.press("ArrowRight")
    assert page.run("angles[0]") == {"turn": 16, "tilt": 20}
    assert page.drawings[0].discs[0] != disc
    page.press("ArrowDown")
    assert page.run("angles[0]")["tilt"] == 25
    page.drag(0, (100, 100), (120, 130))
    assert page.run("angles[0]") == {"turn": 26, "tilt": 37}
    page.drag(0, (100, 100), (120, 130), kind="touch")
    assert page.run("angles[0]") == {"turn": 36, "tilt": 37}
    page.point("move", (200, 200))
    assert page.run("angles[0]") == {"turn": 36, "tilt": 37}
    page.click("reset")
    assert page.run("angles[0]") == {"turn": 10, "tilt": 20}


def test_the_near_side_follows_the_finger():
    page = opened(space(tilt=30))
    near = page.place([0, -0.8, 0])
    page.drag(0, (100, 100), (130, 100))
    assert page.place([0, -0.8, 0])[0] > near[0]


HANDLE = Handle(sp.Matrix([[X, Y]]), (A, sp.Symbol("b", real=True)), {X: A, Y: sp.Symbol("b", real=True)})
PAIR = (Slider(X, "x", 0, 1, 0.5, 0.1, "m"), Slider(Y, "y", -1, 1, 0.25, 0.1, "m"))


def test_a_handle_takes_the_sliders_along_and_stops_at_their_ends_with_the_reason():
    page = opened(plane(handles=[HANDLE], low=(-1, -1), high=(2, 1)), PAIR)
    page.lead([0.125, -0.5])
    np.testing.assert_allclose(page.run("inputs"), [0.125, -0.5], atol=1e-9)
    assert page.run("reason") == ""
    page.lead([1.5, -0.5])
    np.testing.assert_allclose(page.run("inputs"), [1, -0.5], atol=1e-3)
    assert page.run("reason") == "x is at its limit, 1 m."
    page.drag(0, (5, 5), (50, 50))  # not on the handle
    np.testing.assert_allclose(page.run("inputs"), [1, -0.5], atol=1e-3)


def test_no_joint_jumps_by_a_full_turn():
    angle, b = Slider(X, "θ", -180, 180, 170), sp.Symbol("b", real=True)
    handle = Handle(sp.Matrix([[sp.cos(X), sp.sin(X)]]), (A, b), {X: sp.atan2(b, A)})
    page = opened(plane(handles=[handle], low=(-2, -2), high=(2, 2)), [angle])
    page.lead([-1, -0.1])
    assert page.run("inputs")[0] == pytest.approx(180, abs=0.1)
    assert page.run("reason") == "θ is at its limit, 180°."


def test_a_handle_says_why_it_stops_where_its_formula_gives_nothing():
    b = sp.Symbol("b", real=True)
    moves = {X: sp.Piecewise((A, A < 0.8), (sp.nan, True)), Y: b}
    handle = Handle(sp.Matrix([[X, Y]]), (A, b), moves, [Words("{} is too far", [A], 1, A - 0.8)])
    page = opened(plane(handles=[handle], low=(-1, -1), high=(2, 1)), PAIR)
    page.lead([0.95, 0.25])
    assert page.run("inputs")[0] == pytest.approx(0.8, abs=1e-3)
    assert page.run("reason") in ("0.9 is too far", "1.0 is too far")


def test_a_finger_on_a_handle_does_not_scroll_the_page():
    page = opened(plane(handles=[HANDLE]), PAIR)
    x, y = page.place([0.5, 0.25])
    for at, kept in (((x, y), True), ((x + 100, y), False)):
        event = (
            f"{{touches: [{{clientX: {at[0]}, clientY: {at[1]}}}], preventDefault() {{ this.stopped = true; }}}}"
        )
        assert (
            page.run(f"(e => {{ canvasesMade[0].listeners.touchstart(e); return !!e.stopped; }})({event})") == kept
        )


# Challenges


def challenge(**more):
    return Challenge("Go to the end.", "There.", X - 0.95, **more)


def test_a_challenge_is_met_and_stays_so():
    page = opened([], challenges=[challenge()])
    assert "Challenges: 0 of 1" in page.text
    page.slide("x", 1)
    assert "Challenges: 1 of 1" in page.text
    assert "There." in page.text
    page.slide("x", 0)
    page.click("reset")
    assert "Challenges: 1 of 1" in page.text


def test_what_must_not_be_crossed_cannot_be_jumped_over_and_a_reset_begins_anew():
    keep = (X - 0.75) ** 2 - 0.003  # a gap about 0.75, wider than a step of the slider
    page = opened([], challenges=[challenge(keep=keep, lost="Crossed.")])
    page.slide("x", 1)
    assert "Challenges: 0 of 1" in page.text
    assert "Go to the end. Crossed." in page.text
    page.slide("x", 0.5)
    assert page.run("tally") == [{"lost": True, "met": False}]
    page.click("reset")
    assert page.run("tally") == [{"lost": False, "met": False}]


def test_a_way_around_is_found():
    keep = largest(magnitude(X - 0.75) - 0.07, Y - 0.5)
    page = opened([], PAIR, challenges=[challenge(keep=keep)])
    for name, value in (("y", 1), ("x", 1)):
        page.slide(name, value)
    assert page.run("tally") == [{"lost": False, "met": True}]


def test_a_jump_is_measured_against_a_moment_before():
    angle = sp.Piecewise((0, X < 0.7), (1, True))
    jump = magnitude(angle - angle.xreplace({X: before(X)}))
    for keep, lost in ((sp.Rational(1, 2) - jump, True), (2 - jump, False)):
        page = opened([], challenges=[challenge(keep=keep)])
        page.slide("x", 1)
        assert page.run("tally") == [{"lost": lost, "met": not lost}]


def test_the_way_is_walked_in_steps_of_the_sliders():
    page = opened([], PAIR)
    way = np.array(page.run("onTheWay([0, 0], [1, -0.5], [0.1, 0.1])"))
    assert len(way) == 10
    np.testing.assert_allclose(way[:, 0], np.arange(1, 11) / 10)
    assert page.run("onTheWay([0, 0], [0, 0], [1, 1])") == [[0, 0]]


def test_nan_meets_nothing_and_keeps_nothing():
    page = opened([], challenges=[challenge(), challenge(keep=sp.sqrt(0.7 - X))])
    page.slide("x", 1)
    assert page.run("tally") == [{"lost": False, "met": True}, {"lost": True, "met": False}]
    page = opened([], challenges=[Challenge("a", "b", sp.sqrt(X - 2))])
    page.slide("x", 1)
    assert page.run("tally[0].met") is False


# Motions

ROWS = np.linspace(0, 1, 11)


def moving(**more):
    motion = Motion({X: ROWS, A: 10 * ROWS}, 2, "the walk")
    return opened([], words=[Words("{} and {}", [X, A], 2)], motion=motion, **more)


def test_a_motion_plays_pauses_and_is_scrubbed():
    page = moving()
    page.frames(1000, 1500)
    assert page.run("inputs") == pytest.approx([0.25, 2.5])
    assert "0.25 and 2.50" in page.text
    page.frames(2999, 3100)
    assert page.run("inputs")[0] == pytest.approx(0.05)  # round again
    page.click("play")
    page.frames(4000)
    assert page.run("inputs")[0] == pytest.approx(0.05)
    page.click("play")
    page.frames(5000, 5200)
    assert page.run("inputs")[0] == pytest.approx(0.15)
    page.run("observed.IntersectionObserver.forEach(f => f([{isIntersecting: false}]))")
    page.frames(5400)
    assert page.run("inputs")[0] == pytest.approx(0.15)  # nobody looks
    page.run("observed.IntersectionObserver.forEach(f => f([{isIntersecting: true}]))")
    page.frames(5600)
    assert page.run("inputs")[0] == pytest.approx(0.25)
    page.slide("time", 0.5)
    page.frames(6000)
    assert page.run("inputs")[0] == pytest.approx(0.5)  # a hand on the slider stops it
    page.slide("x", 0.1)
    assert page.run("inputs") == pytest.approx([0.1, 5])


def test_the_speed_goes_round():
    page = moving()
    page.frames(0, 200)
    for factor in (2, 0.25, 0.5, 1):
        page.click("speed")
        assert page.run("byName.speed.textContent")[:-1] == str(factor)
        first, stamp = page.run("share"), page.run("waiting.length")
        assert stamp == 1
        page.frames(1000, 1200)
        assert (page.run("share") - first) % 1 == pytest.approx(0.1 * factor)


def test_with_reduced_motion_or_with_challenges_nothing_starts_by_itself():
    motion = Motion({X: ROWS}, 2)
    shown = stage([], [Slider(X, "x", 0, 1, 0, 0.1)], [], {}, "a walk", motion)
    page = FakePage(shown, "media['(prefers-reduced-motion: reduce)'] = {matches: true};")
    page.frames(0, 1000)
    assert page.run("inputs") == [0]
    page = moving(challenges=[challenge(keep=X + 1)])
    page.frames(0, 1000)
    assert page.run("inputs")[0] == 0.5
    page.slide("time", 1)
    page.slide("x", 1)
    assert page.run("tally[0].met") is False  # a motion does nobody's work


def test_angles_of_a_motion_are_in_radians_and_a_trail_is_the_way_so_far():
    motion = Motion({X: np.linspace(0, np.pi, 5)}, 1)
    line = Line(sp.Matrix([[sp.cos(X), sp.sin(X)]]), "z", 3, trail=True)
    page = FakePage(stage([plane(line, low=(-1, -1))], [Slider(X, "θ", 0, 180, 0)], [], {}, "a turn", motion))
    page.slide("time", 0.5)
    assert page.run("inputs") == [90]
    (trail,) = [s.points for s in page.drawings[0].strokes if s.width == 3]
    np.testing.assert_allclose(trail[2], page.place([0, 1]), atol=1e-6)


@pytest.mark.parametrize(
    "values", [{X: [0, np.nan]}, {X: [0, 1], A: [0, 1, 2]}, {X: 3.0}, {X: [[0], [1]]}, {X: [np.inf, 0]}]
)
def test_what_is_no_table_is_no_motion(values):
    with pytest.raises(InputError, match="table of finite numbers"):
        opened([], motion=Motion({s: np.array(column, float) for s, column in values.items()}, 1))


@pytest.mark.parametrize("seconds", [0, -1, np.nan, np.inf, [1, 2], "</script>"], ids=repr)
def test_seconds_are_one_number_above_0(seconds):
    with pytest.raises(InputError):
        opened([], motion=Motion({X: ROWS}, seconds))


# The page

TEXTS = [
    "</script><script>alert(1)</script>",
    "FACTS",
    "<!--<script>",
    "STAGE {} '\"&amp;",
    "</iframe>",
    "GEOMETRY",
]


@pytest.mark.parametrize("text", TEXTS)
def test_no_text_leaves_its_place(text):
    line = Line(sp.Matrix([[0.5, 0.5]]), "x", 0, label=text)
    given = [Slider(X, text, 0, 1, 0, unit=text), Choice(Y, text, {text: 1}, 1)]
    walk, goal = Motion({X: ROWS}, 1, text), Challenge(text, text, X, lost=text)
    shown = stage([plane(line)], given, [Words(text.replace("{}", ""))], {}, text, walk, [goal])
    assert shown.data.count("'") == 2  # those of srcdoc
    assert shown.data.count("</iframe>") == page_in(shown.data).count("</iframe>") + 1
    source = page_in(shown.data)
    assert source.count("</script") == source.count("<script>") == 2
    page = FakePage(shown)
    assert page.facts["title"] == text
    assert page.facts["controls"][0]["name"] == text
    assert text.replace("{}", "") in page.text
    assert page.run("made.find(e => e.tag === 'label').children[0].textContent") == text


def everything():
    views = [space(Body(sp.Matrix([[0, 0, X]]), 0.123456789123, "x")), plane(Line(sp.Matrix([[X, 1]]), "y"))]
    return stage(views, PAIR, [Words("{}", [X / 3])], {A: 1 / 3}, "all", challenges=[challenge()])


def test_it_is_the_same_every_time_and_asks_for_nothing():
    assert everything().data == everything().data
    source = page_in(everything().data)
    assert not re.search(r"https?:|\bsrc=|import|fetch|random|Date|eval|innerHTML", source)


def test_the_numbers_of_a_page_are_the_same_on_every_processor():
    """They have at most nine significant digits; more would differ in the last."""
    source = page_in(everything().data)
    for number in re.findall(r"(?<![\w.])\d+\.?\d*(?:e[+-]\d+)?", source):
        assert len(number.split("e")[0].replace(".", "").strip("0")) <= 9


def test_every_control_has_a_name_and_every_canvas_words_that_follow():
    page = opened([space()], PAIR, [Words("x is {}", [X], 1)])
    assert page.run("made.filter(e => e.tag === 'canvas').map(e => e.attributes.role)") == ["img"]
    page.slide("x", 0.2)
    assert page.run("byName.spoken.textContent") == ""  # not at every step
    page.run("atRestNow()")
    assert page.run("byName.spoken.textContent") == "x is 0.2"
    assert page.run("canvasesMade[0].attributes['aria-label']") == "a stage. Arrow keys turn the view. x is 0.2"


def test_it_is_as_high_as_its_content_and_wears_the_colours_of_the_page_around():
    page = opened([plane()])
    page.run("observed.ResizeObserver.forEach(f => f())")
    assert page.run("frameElement.style.height") == "346px"
    assert page.run("look.ink") == page.run("LOOKS[0].ink")
    page.run("(around.background = 'rgb(19, 20, 22)', observed.MutationObserver[0]())")
    assert page.run("look.ink") == page.run("LOOKS[1].ink")
    assert page.run("document.documentElement.style['--paper']") == "rgb(19, 20, 22)"
    assert page.run("document.documentElement.style.colorScheme") == "dark"
    assert {colour for *_, colour in page.drawings[0].words} == set(page.run("[LOOKS[1].ink, LOOKS[1].muted]"))


def test_colours_are_those_of_the_course():
    with pytest.raises(InputError, match="colours of a stage"):
        opened(plane(Line(sp.Matrix([[0, 0]]), "red")))


def test_text_is_never_evaluated():
    with pytest.raises(InputError):
        opened(words=[Words("{}", ["__import__('os')"])])


def test_the_page_holds_its_facts_as_json():
    assert json.loads(json.dumps(opened([plane()]).facts))["fixed"] == []
