"""Laws of the planner: a path is free and within limits, costs what it says, and gets shorter with the budget."""

from itertools import pairwise

import numpy as np
import pytest

from lynx_common import planner
from lynx_common.errors import EndpointError, InputError, JointLimitError, NoPathError, NotFreeError
from lynx_common.planner import Tree
from lynx_common.planner import _paths as paths
from lynx_common.planner import _search as search

SQUARE = np.array([[-1.0, 1.0], [-1.0, 1.0]])
LEFT, RIGHT = np.array([-0.8, 0.0]), np.array([0.8, 0.0])
RESOLUTION = 0.05


def everywhere(q):
    return np.ones(len(q), bool)


def outside_disc(q, radius=0.4):
    return np.linalg.norm(q, axis=1) >= radius


def gap(q):
    """A wall at x = 0 with a hole 0.08 high at y = 0.7."""
    return (np.abs(q[:, 0]) > 0.05) | (np.abs(q[:, 1] - 0.7) < 0.04)


def closed(q):
    return np.abs(q[:, 0]) > 0.05


def around_the_disc(radius=0.4, reach=0.8):
    """The shortest way past the disc: tangent, arc, tangent."""
    return 2 * (np.sqrt(reach**2 - radius**2) + radius * (np.pi / 2 - np.arccos(radius / reach)))


def dense(path, n=40):
    """Points of all straight pieces of a path, ends included."""
    share = np.linspace(0, 1, n + 1)[:, None, None]
    return ((1 - share) * path[:-1] + share * path[1:]).reshape(-1, path.shape[1])


def at_resolution(a, b):
    n = max(1, int(np.ceil(np.linalg.norm(b - a) / RESOLUTION)))
    return np.array([a + (b - a) * k / n for k in range(n + 1)])


def assert_free(free, path, limits):
    for a, b in pairwise(path):
        assert free(at_resolution(a, b)).all()
    assert (path >= limits[:, 0]).all()
    assert (path <= limits[:, 1]).all()


# A path


@pytest.mark.parametrize("free", [outside_disc, gap])
@pytest.mark.parametrize("seed", [0, 1])
def test_a_path_is_free_and_costs_its_travel(free, seed):
    found = planner.plan(free, SQUARE, LEFT, RIGHT, 1500, seed)
    np.testing.assert_array_equal(found.path[[0, -1]], [LEFT, RIGHT])
    assert_free(free, found.path, SQUARE)
    assert found.cost == pytest.approx(planner.joint_travel(found.path), rel=1e-12)
    assert found.cost == found.history[-1]
    assert found.history.shape == (1500,)


@pytest.mark.parametrize("m", [1, 2, 3, 5])
@pytest.mark.parametrize("seed", [0, 1])
def test_any_number_of_joints(m, seed, rng):
    limits = np.tile([-1.0, 1.0], (m, 1))
    start, goal = np.zeros((2, m))
    start[0], goal[0] = -0.9, 0.9
    free = everywhere if m == 1 else outside_disc
    found = planner.plan(free, limits, start, goal, 600, seed)
    assert_free(free, found.path, limits)
    assert found.cost == pytest.approx(1.8) if m == 1 else found.cost > 1.8


def test_limits_of_all_joints_are_kept_though_the_ellipsoid_goes_beyond():
    """The disc touches the lower edge, and the way over it would like to go above the upper one."""
    limits = np.array([[-1.0, 1.0], [-0.1, 0.45]])
    found = planner.plan(outside_disc, limits, LEFT, RIGHT, 2000)
    assert (found.tree.q >= limits[:, 0]).all()
    assert (found.tree.q <= limits[:, 1]).all()
    assert_free(outside_disc, found.path, limits)
    assert found.path[:, 1].max() > 0.4


def test_the_straight_line_is_the_path_where_it_is_free():
    calls = []
    found = planner.plan(lambda q: (calls.append(len(q)), everywhere(q))[1], SQUARE, LEFT, RIGHT, 30)
    assert len(calls) == 3  # start, goal, the line
    np.testing.assert_array_equal(found.path, [LEFT, RIGHT])
    np.testing.assert_array_equal(found.history, np.full(30, 1.6))
    np.testing.assert_array_equal(found.tree.parent, [-1, 0])


@pytest.mark.filterwarnings("error")
def test_a_start_that_is_the_goal_costs_nothing():
    found = planner.plan(everywhere, SQUARE, LEFT, LEFT, 3)
    assert found.cost == 0
    np.testing.assert_array_equal(found.path, [LEFT, LEFT])


def test_the_cost_never_rises_and_is_infinite_until_there_is_a_path():
    history = planner.plan(gap, SQUARE, LEFT, RIGHT, 1500, 3).history
    first = np.isfinite(history).argmax()
    assert first > 10
    assert np.isinf(history[:first]).all()
    assert (np.diff(history[first:]) <= 0).all()
    assert history[-1] < history[first]


@pytest.mark.parametrize("seed", range(2))
def test_the_cost_tends_to_the_shortest_way_and_is_never_below_it(seed):
    """The pieces are chords: between two postures that are checked they may dip into the disc a little."""
    shortest = around_the_disc()
    found = planner.plan(outside_disc, SQUARE, LEFT, RIGHT, 3000, seed, resolution=0.01)
    assert 0.999 * shortest < found.cost < 1.01 * shortest
    assert found.history[300] > found.cost


def test_a_better_way_around_is_found_though_the_first_was_the_other():
    """The disc is a little above the line: below it is shorter, and all seeds end there."""
    lowered = np.array([0, 0.15])

    def free(q):
        return outside_disc(q - lowered)

    for seed in range(4):
        found = planner.plan(free, SQUARE, LEFT, RIGHT, 600, seed)
        assert found.path[:, 1].min() < -0.2
        assert found.path[:, 1].max() < 0.01


def test_equal_input_gives_equal_output_and_another_seed_another_path():
    first, again, other = (planner.plan(gap, SQUARE, LEFT, RIGHT, 800, seed) for seed in (7, 7, 8))
    np.testing.assert_array_equal(first.path, again.path)
    np.testing.assert_array_equal(first.tree.q, again.tree.q)
    np.testing.assert_array_equal(first.history, again.history)
    assert first.cost != other.cost


def test_a_larger_budget_goes_on_from_the_same_search():
    short, long = (planner.plan(gap, SQUARE, LEFT, RIGHT, n, 1) for n in (800, 1200))
    np.testing.assert_array_equal(short.history, long.history[:800])


def test_the_step_bounds_how_far_the_tree_reaches_at_first():
    """With a budget of one, the new posture is a step from the start, in the direction of what was drawn."""
    with pytest.raises(NoPathError, match="in 1 iteration: of the 2 postures") as caught:
        planner.plan(closed, SQUARE, LEFT, RIGHT, 1, 5, step=0.125)
    assert caught.value.postures == 2
    steps = [planner_first_step(seed, 0.125) for seed in range(20)]
    assert max(steps) == pytest.approx(0.125)
    assert min(steps) > 0.05


def grow(tree, free, q, step):
    search._grow(tree, lambda a, b: paths.lines_free(free, a, b, RESOLUTION), q, step)


def planner_first_step(seed, step):
    grown = Tree(LEFT, RIGHT, 4)
    drawn = search._draw(grown, everywhere, SQUARE, np.random.default_rng(seed))
    grow(grown, everywhere, drawn, step)
    new = grown.q[2] - LEFT
    away = drawn - LEFT
    assert new @ away == pytest.approx(np.linalg.norm(new) * np.linalg.norm(away))
    return np.linalg.norm(new)


def test_a_step_goes_from_the_nearest_posture_of_the_tree():
    grown = Tree(np.zeros(2), np.array([9.0, 9.0]), 5)
    for y in (1.0, 2.0):
        grown.add(np.array([0.0, y]), 0, y)
    grow(grown, everywhere, np.array([0.0, 3.0]), 0.25)
    assert grown.q[4].tolist() == [0, 2.25]


# The tree


@pytest.mark.parametrize("free", [outside_disc, gap])
def test_each_posture_of_the_tree_is_reached_by_free_lines_at_its_cost(free):
    found = planner.plan(free, SQUARE, LEFT, RIGHT, 1500, 4)
    q, parent, cost = found.tree.q, found.tree.parent, found.tree.cost
    np.testing.assert_array_equal(q[:2], [LEFT, RIGHT])
    assert len(q) == len(parent) == len(cost) > 100
    assert (parent[0], cost[0]) == (-1, 0)
    assert (parent[1:] >= 0).all()
    np.testing.assert_allclose(
        cost[1:], cost[parent[1:]] + np.linalg.norm(q[1:] - q[parent[1:]], axis=1), rtol=1e-12
    )
    assert len(np.unique(q, axis=0)) == len(q)
    for node in range(1, len(q)):
        assert_free(free, q[[parent[node], node]], SQUARE)
    rows = np.arange(len(q))
    for _ in rows:
        rows = np.where(parent[rows] >= 0, parent[rows], rows)
    assert (rows == 0).all()  # no cycles


def test_no_posture_of_the_tree_is_better_reached_through_its_near_ones_than_it_is():
    """RRT*'s own law, of the last posture added: its parent is the best near it, and it leads where it helps."""
    found = planner.plan(gap, SQUARE, LEFT, RIGHT, 1500, 4)
    q, cost = found.tree.q[:-1], found.tree.cost[:-1]
    last, last_cost = found.tree.q[-1], found.tree.cost[-1]
    distance = np.linalg.norm(q - last, axis=1)
    near = np.argsort(distance)[: int(np.ceil(2**3 * np.e * 1.5 * np.log(len(found.tree.q) - 1)))]
    for node in near:
        if gap(at_resolution(q[node], last)).all():
            assert last_cost <= cost[node] + distance[node] + 1e-12
        if gap(at_resolution(last, q[node])).all():
            assert cost[node] <= last_cost + distance[node] + 1e-12


def grown_at_random(rng, n=300, m=3):
    grown = Tree(rng.uniform(-1, 1, m), rng.uniform(-1, 1, m), n)
    for _ in range(n - 2):
        grown.add(rng.uniform(-1, 1, m), 0, 1.0)
    return grown


def test_the_near_ones_are_the_nearest_that_are_attached(rng):
    for m in (2, 3):
        grown = grown_at_random(rng, m=m)
        for _ in range(30):
            q = rng.uniform(-1, 1, m)
            near, distance = grown.near(q)
            exact = np.linalg.norm(grown.q - q, axis=1)
            np.testing.assert_allclose(distance, exact[near])
            exact[1] = np.inf  # the goal is not attached
            assert len(near) == min(299, int(np.ceil(2 ** (m + 1) * np.e * (1 + 1 / m) * np.log(300))))
            np.testing.assert_allclose(np.sort(exact)[: len(near)], np.sort(distance))
    few = Tree(np.zeros(2), np.ones(2), 5)
    assert few.near(np.ones(2))[0].tolist() == [0]


def test_what_is_led_another_way_takes_all_that_follows_it_along():
    grown = Tree(np.zeros(2), np.ones(2), 6)
    a = grown.add(np.array([0.0, 1]), 0, 5.0)
    b = grown.add(np.array([0.0, 2]), a, 1.0)
    c = grown.add(np.array([0.0, 3]), b, 2.0)
    d = grown.add(np.array([1.0, 0]), 0, 0.5)
    np.testing.assert_array_equal(grown.cost[[a, b, c, d]], [5, 6, 8, 0.5])
    grown.attach(a, d, 0.25)
    np.testing.assert_array_equal(grown.cost[[a, b, c, d]], [0.75, 1.75, 3.75, 0.5])
    grown.attach(d, 0, 0.125)
    np.testing.assert_array_equal(grown.cost[[a, b, c]], [0.375, 1.375, 3.375])
    grown.attach(1, c, 1.0)
    assert grown.cost[1] == 4.375
    assert grown.children[0] == [d]
    assert grown.to_goal().tolist() == [[0, 0], [1, 0], [0, 1], [0, 2], [0, 3], [1, 1]]


# Where it looks


def test_once_there_is_a_path_only_what_may_lie_on_a_better_one_is_drawn(rng):
    """The drawn postures fill the ellipsoid evenly: of half its radii (in m joints) holds it the share 0.5**m."""
    for start, goal in (
        ([-0.4, 0, 0], [0.4, 0, 0]),
        ([0.3, 0.2, -0.3], [-0.2, -0.3, 0.1]),
        ([0, 0, 0.3], [0, 0, -0.3]),
    ):
        grown, limits = Tree(np.array(start), np.array(goal), 3), np.tile([-1.0, 1.0], (3, 1))
        grown.cost[1] = best = 0.9
        drawn = np.array([search._draw(grown, everywhere, limits, rng) for _ in range(2000)])
        through = sum(np.linalg.norm(drawn - end, axis=1) for end in grown.q[:2])
        assert through.max() <= best + 1e-12
        assert through.max() > 0.99 * best
        axis = grown.q[1] - grown.q[0]
        apart = np.linalg.norm(axis)
        from_middle = drawn - grown.q[:2].mean(axis=0)
        along = from_middle @ axis / apart
        across = np.sqrt((from_middle**2).sum(axis=1) - along**2)
        level = np.hypot(along / (best / 2), across / (np.sqrt(best**2 - apart**2) / 2))
        assert (level < 0.5).mean() == pytest.approx(0.125, abs=0.025)
        assert np.abs(drawn.mean(axis=0) - grown.q[:2].mean(axis=0)).max() < 0.02


def test_what_is_drawn_is_within_limits_where_these_hold_hardly_any_of_the_ellipsoid(rng):
    limits = np.array([[-1.0, 1.0], [-1e-3, 1e-3]])
    grown = Tree(np.array([-0.8, 0]), np.array([0.8, 0]), 3)
    grown.cost[1] = 3.0
    drawn = np.array([search._draw(grown, everywhere, limits, rng) for _ in range(300)])
    assert (np.abs(drawn) <= limits[:, 1]).all()
    assert len(np.unique(drawn, axis=0)) == 300


def test_until_there_is_a_path_anything_within_limits_is_drawn_and_the_goal_now_and_then(rng):
    limits = np.array([[-3.0, 1.0], [2.0, 2.5]])
    grown = Tree(np.array([0.0, 2.2]), np.array([-2.0, 2.4]), 3)
    drawn = np.array([search._draw(grown, everywhere, limits, rng) for _ in range(2000)])
    goals = (drawn == grown.q[1]).all(axis=1)
    assert 0.03 < goals.mean() < 0.1
    others = drawn[~goals]
    np.testing.assert_allclose(others.min(axis=0), limits[:, 0], atol=0.01)
    np.testing.assert_allclose(others.max(axis=0), limits[:, 1], atol=0.01)
    np.testing.assert_allclose(others.mean(axis=0), limits.mean(axis=1), atol=0.06)


def test_what_is_drawn_is_free_where_any_of_sixteen_is(rng):
    for best in (np.inf, 2.0):
        grown = Tree(LEFT, RIGHT, 3)
        grown.cost[1] = best
        drawn = np.array([search._draw(grown, outside_disc, SQUARE, rng) for _ in range(500)])
        assert outside_disc(drawn).all()
        assert len(np.unique(drawn, axis=0)) > 450
        assert (search._draw(grown, lambda q: np.zeros(len(q), bool), SQUARE, rng) <= 1).all()


@pytest.mark.parametrize(("height", "added"), [(0.59, 1), (0.61, 0)])
def test_only_what_may_be_on_a_better_path_is_added(height, added):
    """The best path has length 2, start and goal are 1.6 apart: halfway, 0.6 aside is as long."""
    grown = Tree(LEFT, RIGHT, 4)
    grown.attach(1, 0, 2.0)
    grow(grown, everywhere, np.array([0, height]), 1.0)
    assert grown.size == 2 + added
    assert (grown.cost[1] < 2) == added


@pytest.mark.parametrize("order", [(0.1, 0.2), (0.2, 0.1)])
@pytest.mark.parametrize("level", [0.0, 0.1, 0.2])
def test_the_parent_is_the_best_from_which_the_line_is_free(order, level):
    """From the start the travel is least, then through 0.1, then 0.2; but only level lines are free."""
    grown = Tree(np.zeros(2), np.array([5.0, 5]), 5)
    for y in order:
        grown.add(np.array([0.0, y]), 0, y)
    corridor = lambda q: (q[:, 0] == 0) | (q[:, 0] > 0.3) | (np.abs(q[:, 1] - level) < 0.04)  # noqa: E731
    grow(grown, corridor, np.array([0.4, level]), 1.0)
    assert grown.q[grown.parent[4]].tolist() == [0, level]
    assert grown.cost[4] == pytest.approx(0.4 + level)


# What is asked of `free`


def test_free_is_asked_about_whole_edges_and_few_times():
    calls = []

    def free(q):
        calls.append(len(q))
        assert q.shape[1:] == (2,)
        return outside_disc(q)

    planner.plan(free, SQUARE, LEFT, RIGHT, 500)
    assert (
        len(calls) <= 4 * 500 + 3
    )  # start, goal, the line between; in each iteration what is drawn, the best, the others, rewiring


def test_lines_are_checked_at_their_ends_and_no_farther_apart_than_the_resolution(rng):
    a, b = rng.uniform(-1, 1, (2, 50, 3))
    b[:3] = a[:3]  # of no length
    b[3] = a[3] + [0.1, 0, 0]  # exactly two pieces, or three by rounding
    seen = []
    paths.lines_free(lambda q: (seen.append(q), everywhere(q))[1], a, b, RESOLUTION)
    (q,) = seen
    for first, last in zip(a, b, strict=True):
        n = max(1, int(np.ceil(np.linalg.norm(last - first) / RESOLUTION)))
        np.testing.assert_allclose(q[: n + 1], at_resolution(first, last), atol=1e-12)
        np.testing.assert_array_equal(q[[0, n]], [first, last])
        q = q[n + 1 :]
    assert not len(q)


def test_one_posture_that_is_not_free_spoils_its_line_and_no_other():
    a, b = np.zeros((3, 2)), np.array([[1.0, 0], [0, 1.0], [-1.0, 0]])
    blocked = lambda q: ~((np.abs(q[:, 0] - 0.5) < 0.026) & (q[:, 1] == 0))  # noqa: E731
    assert paths.lines_free(blocked, a, b, RESOLUTION).tolist() == [False, True, True]
    for end in (0.0, 1.0):
        at_end = lambda q, end=end: q[:, 1] != end  # noqa: E731
        expected = [False, False, False] if end == 0 else [True, False, True]
        assert paths.lines_free(at_end, a, b, RESOLUTION).tolist() == expected
    assert paths.lines_free(lambda q: 1 / 0, a[:0], b[:0], RESOLUTION).tolist() == []  # nothing to ask


def test_a_finer_resolution_finds_a_thin_wall():
    thin = lambda q: np.abs(q[:, 0] - 0.0123) > 1e-3  # noqa: E731
    assert planner.plan(thin, SQUARE, LEFT, RIGHT, 10).cost == pytest.approx(1.6)
    with pytest.raises(NoPathError):
        planner.plan(thin, SQUARE, LEFT, RIGHT, 10, resolution=1e-3)


# Shortcuts


def test_a_shortcut_keeps_the_ends_is_free_and_never_longer():
    for seed in range(3):
        path = planner.plan(outside_disc, SQUARE, LEFT, RIGHT, 200, seed).path
        before = path.copy()
        shorter = planner.shortcut(outside_disc, path, seed=seed)
        np.testing.assert_array_equal(path, before)
        np.testing.assert_array_equal(shorter[[0, -1]], path[[0, -1]])
        assert_free(outside_disc, shorter, SQUARE)
        assert planner.joint_travel(shorter) < planner.joint_travel(path)


def test_many_tries_come_near_to_the_shortest_way():
    path = np.array([LEFT, [-0.8, 0.9], [0.8, 0.9], RIGHT])
    shorter = planner.shortcut(outside_disc, path, 2000)
    assert planner.joint_travel(shorter) < 1.01 * around_the_disc()
    np.testing.assert_array_equal(shorter, planner.shortcut(outside_disc, path, 2000))
    assert not np.array_equal(shorter, planner.shortcut(outside_disc, path, 2000, seed=1))


def test_where_all_is_free_a_detour_becomes_nearly_straight():
    path = np.array([[0.0, 0], [0, 1], [1, 1], [1, 0]])
    assert planner.joint_travel(planner.shortcut(everywhere, path, 300)) < 1.001


def test_a_straight_path_stays_as_it_is():
    path = np.array([[0.0, 0], [1, 2]])
    np.testing.assert_array_equal(planner.shortcut(everywhere, path), path)
    same = np.array([[0.0, 1], [0, 1]])
    np.testing.assert_array_equal(planner.shortcut(everywhere, same), same)


def test_nothing_is_cut_where_the_path_is_the_only_free_one():
    """An L of free points, one resolution wide: cutting its corner is never free."""
    ell = lambda q: (np.abs(q[:, 0]) < 1e-9) | (np.abs(q[:, 1]) < 1e-9)  # noqa: E731
    path = np.array([[0.0, 1], [0, 0], [1, 0]])
    np.testing.assert_array_equal(planner.shortcut(ell, path), path)


def test_joint_travel_is_the_sum_of_the_pieces():
    assert planner.joint_travel(np.array([[0.0, 0], [3, 4], [3, 5]])) == 6
    assert planner.joint_travel(np.array([[1.0, 2]])) == 0


# Refusals


def test_a_start_or_goal_that_is_not_free_is_named():
    for which, start, goal in (("start", [0, 0.1], RIGHT), ("goal", LEFT, [0, 0.1])):
        with pytest.raises(
            EndpointError, match=rf"The {which} of the motion .* \(0.00, 5.73\) deg is not free"
        ) as caught:
            planner.plan(outside_disc, SQUARE, start, goal)
        assert (caught.value.which, type(caught.value.cause)) == (which, NotFreeError)
        np.testing.assert_array_equal(caught.value.cause.q, [0, 0.1])


@pytest.mark.parametrize("value", [-1.1, 1.1, 1 + 1e-8])
def test_a_start_or_goal_outside_the_limits_is_named(value):
    for which, start, goal in (("start", [0, value], RIGHT), ("goal", LEFT, [0, value])):
        with pytest.raises(EndpointError, match=rf"The {which} .* Joint 2 would stand at") as caught:
            planner.plan(everywhere, SQUARE, start, goal)
        cause = caught.value.cause
        assert (type(cause), cause.joint, cause.value, cause.limits) == (JointLimitError, 2, value, (-1, 1))


@pytest.mark.parametrize(("beyond", "allowed"), [(1e-10, True), (1e-7, False)])
def test_room_at_a_limit_is_for_rounding_only(beyond, allowed):
    goal = [0, 1 + beyond]
    if allowed:
        assert planner.plan(everywhere, SQUARE, LEFT, goal).cost > 0
    else:
        with pytest.raises(EndpointError):
            planner.plan(everywhere, SQUARE, LEFT, goal)


def test_ends_on_the_limits_are_within_them():
    over = [[-1 - 1e-10, -1], [1, 1 + 1e-10]]
    assert planner.plan(everywhere, SQUARE, *over).cost == pytest.approx(2 * np.sqrt(2))
    assert planner.plan(everywhere, SQUARE, [-1, -1], [1, 1]).cost == pytest.approx(2 * np.sqrt(2))


def test_where_no_path_is_found_it_says_how_far_it_came():
    with pytest.raises(
        NoPathError, match=r"in 300 iterations: of the \d+ postures reached, .* (48|49|50|51)\.\d\d deg away"
    ) as caught:
        planner.plan(closed, SQUARE, LEFT, RIGHT, 300)
    fault = caught.value
    assert fault.iterations == 300
    assert 100 < fault.postures <= 301
    assert 0.85 <= fault.distance < 0.9  # the wall's near side


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"start": [0.0, np.nan]}, "Finite numbers are expected for the start"),
        ({"goal": [0.0, np.inf]}, "Finite numbers are expected for the goal"),
        ({"start": [0.0, 1j]}, "the start; complex"),
        ({"start": [[0.0, 0.0]]}, r"Finite numbers of shape \(2,\) are expected for the start"),
        ({"goal": "up"}, "Real numbers are expected for the goal; 'up' was given"),
        ({"start": [0.0]}, r"Finite numbers of shape \(2,\) are expected for the start; \[0.0\] was given"),
        ({"goal": [0.0, 0, 0]}, r"Finite numbers of shape \(2,\) are expected for the goal"),
        ({"limits": [-1, 1]}, r"Finite numbers of shape \(n, 2\) are expected for limits"),
        ({"limits": np.zeros((0, 2))}, "lower limit must be below"),
        ({"limits": [[-1, np.nan], [-1, 1]]}, "Finite numbers are expected for limits"),
        ({"limits": [[-1, 1, 2], [-1, 1, 2]]}, r"of shape \(n, 2\) are expected for limits"),
        ({"limits": [[-1, 1], [1, -1]]}, "lower limit must be below its upper one"),
        ({"limits": [[-1, 1], [0, 0]]}, "lower limit must be below its upper one"),
        ({"iterations": 0}, "number of iterations is a whole number from 1 to 10000000; 0 was given"),
        ({"iterations": 1e3}, "number of iterations"),
        ({"iterations": True}, "number of iterations"),
        ({"step": 0}, "The step is one finite number, above 0; 0 was given"),
        ({"step": np.nan}, "The step is"),
        ({"step": 1j}, "the step; complex"),
        ({"resolution": -0.1}, "The resolution is"),
        ({"resolution": np.inf}, "The resolution is"),
        ({"resolution": [0.1, 0.1]}, "The resolution is"),
        (
            {"free": lambda q: np.ones(len(q))},
            r"must return one bool a posture, shape \(1,\); it returned float64 of shape \(1,\)",
        ),
        ({"free": lambda q: np.full(len(q), np.nan)}, "free"),
        ({"free": lambda q: np.True_}, r"it returned bool of shape \(\)"),
        ({"free": lambda q: np.ones((len(q), 1), bool)}, "of shape"),
    ],
)
def test_input_that_is_not_as_asked_is_refused(change, message):
    problem = {"free": everywhere, "limits": SQUARE, "start": LEFT, "goal": RIGHT}
    with pytest.raises(InputError, match=message):
        planner.plan(**problem | change)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"path": [0.0, 1.0]}, r"of shape \(n, m\) are expected for a path"),
        ({"path": [[0.0, 1.0]]}, "two corners or more; 1 were given"),
        ({"path": [[0.0, 1.0], [0, np.nan]]}, "Finite numbers are expected for a path"),
        ({"path": [[0.0, 1.0], [0, 1j]]}, "a path; complex"),
        ({"tries": 0}, "number of tries"),
        ({"tries": 2.5}, "number of tries"),
        ({"resolution": 0}, "The resolution is"),
        ({"free": lambda q: 1.0 * everywhere(q)}, "it returned float64"),
    ],
)
def test_what_cannot_be_shortened_is_refused(change, message):
    with pytest.raises(InputError, match=message):
        planner.shortcut(**{"free": everywhere, "path": [[0.0, 1], [0, 0], [1, 0]]} | change)
