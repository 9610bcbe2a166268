"""The planner against OMPL's RRT* and informed RRT*: the same problem, the same time, and the same check after.

All plan with a little more margin than is asked for, and check lines every 0.05 rad; what they find is then
checked every 0.0005 rad at most for the margin itself. OMPL asks about one posture at a time, in C++, of a checker
that is written for one, with `math`; ours asks about many at once, of NumPy. OMPL's searches end by time, so that
no two of its runs are alike.
"""

import math
import time
from itertools import chain, pairwise

import numpy as np
import pytest
from bench_planner import GEOMETRY, LIMITS, MARGIN, SCENES, SEEDS, SMALLEST, free_in, problem
from ompl import base, geometric, util
from timing import Tables, shown

from lynx_common import planner

SPARE, STEP, RESOLUTION = 0.05, 0.5, 0.05
PEERS = {"OMPL RRT*": geometric.RRTstar, "OMPL informed RRT*": geometric.InformedRRTstar}
d_1, L, _, _ = GEOMETRY


def one_at_a_time(balls):
    """What `free_in` says, for one posture: in the arm's plane, where a ball is a disc."""

    def free(q):
        theta_1, theta_2, theta_3 = q[0], q[1], q[2]
        elbow = L * math.cos(theta_2), d_1 + L * math.sin(theta_2)
        end = elbow[0] + L * math.cos(theta_2 + theta_3), elbow[1] + L * math.sin(theta_2 + theta_3)
        trace, det = L**2 * (3 + 2 * math.cos(theta_3)), L**2 * abs(math.sin(theta_3))
        larger = math.sqrt((trace + math.sqrt(max(0.0, trace**2 - 4 * det**2))) / 2)
        if abs(end[0]) < SMALLEST + SPARE or det < (SMALLEST + SPARE) * larger:
            return False
        c, s = math.cos(theta_1), math.sin(theta_1)
        for ball in balls:
            x, y, z = ball.centre
            r, squared = c * x + s * y, (ball.radius + MARGIN + SPARE) ** 2 - (c * y - s * x) ** 2
            if squared > 0 and any(
                to_line(r, z, *link) < squared for link in ((0, 0, 0, d_1), (0, d_1, *elbow), (*elbow, *end))
            ):
                return False
        return True

    return free


def to_line(r, z, r_0, z_0, r_1, z_1):
    """Square of the distance of a point from a piece of a straight line."""
    along_r, along_z = r_1 - r_0, z_1 - z_0
    share = ((r - r_0) * along_r + (z - z_0) * along_z) / (along_r**2 + along_z**2)
    share = min(1.0, max(0.0, share))
    return (r - r_0 - share * along_r) ** 2 + (z - z_0 - share * along_z) ** 2


def ours(scene, iterations, seed):
    """Seconds, and a path."""
    _, limits, start, goal = problem(scene)
    free = free_in(SCENES[scene][1], SPARE)
    began = time.perf_counter()
    found = planner.plan(free, limits, start, goal, iterations, seed, STEP, RESOLUTION)
    return time.perf_counter() - began, found.path


def theirs(name, scene, seconds):
    """A path that is found within so many seconds; OMPL's own settings, but for step and resolution."""
    _, limits, *ends = problem(scene)
    bounds = base.RealVectorBounds(3)
    for joint, (low, high) in enumerate(limits):
        bounds.setLow(joint, low)
        bounds.setHigh(joint, high)
    space = base.RealVectorStateSpace(3)
    space.setBounds(bounds)
    setup = geometric.SimpleSetup(space)
    setup.setStateValidityChecker(one_at_a_time(SCENES[scene][1]))
    setup.getSpaceInformation().setStateValidityCheckingResolution(RESOLUTION / space.getMaximumExtent())
    states = space.allocState(), space.allocState()
    for state, q in zip(states, ends, strict=True):
        state[0], state[1], state[2] = q
    setup.setStartAndGoalStates(*states)
    search = PEERS[name](setup.getSpaceInformation())
    search.setRange(STEP)
    setup.setPlanner(search)
    setup.solve(seconds)
    assert setup.haveExactSolutionPath()
    return np.array([[state[0], state[1], state[2]] for state in setup.getSolutionPath().getStates()])


def assert_keeps_its_margins(path, scene):
    """Start, goal, limits, and both margins at every 0.0005 rad or nearer."""
    free, limits, *ends = problem(scene)
    np.testing.assert_allclose(path[[0, -1]], ends, atol=1e-12)
    assert (path >= limits[:, 0]).all()
    assert (path <= limits[:, 1]).all()
    for a, b in pairwise(path):
        count = int(np.ceil(np.linalg.norm(b - a) / 0.0005)) + 1
        assert free(a + np.linspace(0, 1, count)[:, None] * (b - a)).all()


@pytest.fixture(autouse=True, scope="module")
def silence():
    util.setLogLevel(util.LogLevel.LOG_NONE)


@pytest.mark.parametrize("scene", SCENES)
def test_both_checkers_say_the_same(scene):
    q, balls = np.random.default_rng(0).uniform(*LIMITS.T, (20_000, 3)), SCENES[scene][1]
    free = free_in(balls, SPARE)(q)
    assert [*map(one_at_a_time(balls), q.tolist())] == free.tolist()
    assert 0.05 < free.mean() < 0.95


@pytest.mark.parametrize("iterations", [150, 500])
@pytest.mark.parametrize("scene", SCENES)
def test_length_at_equal_time(scene, iterations, tables: Tables):
    """The budget of OMPL's planners is the median time of ours; medians over ten seeds, or runs."""
    found = [ours(scene, iterations, seed) for seed in SEEDS]
    seconds = float(np.median([time for time, _ in found]))
    paths = {f"ours, {iterations} iterations": [path for _, path in found]}
    paths |= {name: [theirs(name, scene, seconds) for _ in SEEDS] for name in PEERS}
    for path in chain.from_iterable(paths.values()):
        assert_keeps_its_margins(path, scene)
    travel = {name: np.median([planner.joint_travel(path) for path in some]) for name, some in paths.items()}
    told = ", ".join(f"{name} {length:.3f}" for name, length in travel.items())
    tables.facts[f"{scene}: joint travel [rad] after {shown(seconds)}"] = told
