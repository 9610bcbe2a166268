"""Speed and convergence of the planner, on the scene of the notebook's paths and on one with more in the way."""

import time
from functools import cache

import numpy as np
import pytest

from lynx_common import arm, obstacles, planner

GEOMETRY = arm.Geometry(5, 10, 10, 0)  # report Table 3.1, no units
LIMITS = arm.JOINT_LIMITS[:3]
SMALLEST, MARGIN = 4.0, 0.5  # of the singular values; from obstacles
WAYPOINTS = np.array([[10, 0, 10], [15, 5, 10]])  # report eq. (3.4)
SCENES = {
    "notebook": (WAYPOINTS, [obstacles.Sphere((13.5, 1, 10), 2.5)]),
    "crowded": (
        np.array([[0, -15, 8], [-4, 14, 8]]),
        [obstacles.Sphere((9, -9, 9), 4), obstacles.Sphere((11, 5, 10), 5)],
    ),
}
SEEDS = range(10)


def free_in(balls, spare=0.0):
    def free(q):
        """Smallest singular value, in closed form (notebook Part 3), and clearance of the whole arm."""
        distance = np.abs(10 * np.cos(q[:, 1]) + 10 * np.cos(q[:, 1] + q[:, 2]))
        trace, det = 100 * (3 + 2 * np.cos(q[:, 2])), 100 * np.abs(np.sin(q[:, 2]))
        elbow = det / np.sqrt((trace + np.sqrt(np.maximum(trace**2 - 4 * det**2, 0))) / 2)
        posture = np.concatenate([q, np.zeros((len(q), 2))], axis=1)
        clear = [obstacles.clearance(posture, ball, geometry=GEOMETRY) >= MARGIN + spare for ball in balls]
        return (np.minimum(distance, elbow) >= SMALLEST + spare) & np.logical_and.reduce(clear)

    return free


def problem(scene):
    places, balls = SCENES[scene]
    start, goal = arm.inverse_kinematics(places, 0, geometry=GEOMETRY)[:, 0, :3]
    return free_in(balls), LIMITS, start, goal


@cache
def searches(scene, iterations, seeds):
    """Seconds and plan of each seed."""
    found = []
    for seed in seeds:
        began = time.perf_counter()
        plan = planner.plan(*problem(scene), iterations, seed)
        found.append((time.perf_counter() - began, plan))
    return found


@pytest.mark.parametrize("scene", ["notebook"])
def test_a_path_within_500_iterations_and_2_seconds(scene):
    seconds, plans = zip(*searches(scene, 500, SEEDS), strict=True)
    first = [int(np.isfinite(plan.history).argmax()) + 1 for plan in plans]
    print(f"\n{scene}: first path after {np.median(first):.0f} iterations (at most {max(first)}); ", end="")
    print(f"500 iterations in {np.median(seconds):.2f} s (at most {max(seconds):.2f} s)")
    assert np.median(seconds) <= 2


@pytest.mark.parametrize("scene", SCENES)
def test_within_1_percent_of_the_best_known_after_3000_iterations(scene):
    """The best known: the least travel of ten seeds, 3,000 iterations and 5,000 shortcuts each."""
    free = problem(scene)[0]
    seconds, plans = zip(*searches(scene, 3000, SEEDS), strict=True)
    best = min(planner.joint_travel(planner.shortcut(free, plan.path, 5000)) for plan in plans)
    at = {n: np.median([plan.history[n - 1] for plan in plans]) / best - 1 for n in (300, 1000, 3000)}
    above = ", ".join(f"{share:.2%} after {n:,}" for n, share in at.items())
    print(f"\n{scene}: best {best:.4f} rad; median above it {above}; {np.median(seconds):.1f} s")
    assert at[3000] <= 0.01
