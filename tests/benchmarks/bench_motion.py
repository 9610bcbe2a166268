"""Speed of following a path, of the clearance of the whole arm, and of a proof along a motion."""

import numpy as np
import pytest

from lynx_common import arm, certify, motion, obstacles

SPHERE = obstacles.Sphere((-0.2, 0.0, 0.6), 0.15)  # report section 1.6
FRONT, TOP, BACK = [0, 0.2, 0.4, 0, 0], [0, 0, 0.6, np.pi / 2, 0], [0, -0.2, 0.4, np.pi, 0]
OVER = motion.joined(motion.line(FRONT, TOP), motion.line(TOP, BACK))


@pytest.mark.parametrize("n", [1000, 999], ids=["on one elbow", "changing at full stretch"])
def test_following_1000_samples_at_most_20_milliseconds(benchmark, n):
    task = OVER(np.linspace(0, 1, n))
    assert benchmark.pedantic(motion.follow, [task], rounds=21, warmup_rounds=1).ok
    print(f"\nfollow, {n} samples: {benchmark.stats.stats.median * 1e3:.1f} ms")
    assert benchmark.stats.stats.median <= 20e-3


def test_following_a_straight_arm_at_most_20_milliseconds(benchmark):
    """The elbow free to change at every sample, and two turns of joint 4 to choose from."""
    angle = np.linspace(0, 1, 1000)
    q = np.stack([np.pi + 0 * angle, 1 + angle, 0 * angle, 2 + 4 * angle, np.pi + 0 * angle], -1)
    benchmark.pedantic(motion.follow, [arm.task_coordinates(q)], rounds=21, warmup_rounds=1)
    print(f"\nfollow, at full stretch: {benchmark.stats.stats.median * 1e3:.1f} ms")
    assert benchmark.stats.stats.median <= 20e-3


@pytest.mark.parametrize("link_radius", [0.0, 0.02])
def test_the_clearance_of_100_000_postures_at_most_100_milliseconds(benchmark, link_radius):
    q = np.random.default_rng(0).uniform(-np.pi, np.pi, (100_000, 5))
    benchmark.pedantic(obstacles.clearance, [q, SPHERE, link_radius], rounds=9, warmup_rounds=1)
    print(f"\nclearance of 100,000 postures: {benchmark.stats.stats.median * 1e3:.0f} ms")
    assert benchmark.stats.stats.median <= 100e-3


def test_the_proof_of_a_motion_at_most_50_milliseconds(benchmark):
    """The way over the top, 999 samples, 1 mm from touching a sphere beside it."""
    q = motion.follow(OVER(np.linspace(0, 1, 999))).q
    aside = obstacles.Sphere((0.0, 0.3, 0.4), 0.299)
    arguments = [lambda q: obstacles.clearance(q, aside), obstacles.lipschitz_constant(), q]
    found = benchmark.pedantic(certify.along, arguments, rounds=21, warmup_rounds=1)
    print(f"\ncertify: {benchmark.stats.stats.median * 1e3:.1f} ms, {found.evaluations:,} evaluations")
    assert found.verdict == "certified"
    assert benchmark.stats.stats.median <= 50e-3
