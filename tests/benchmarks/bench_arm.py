"""Speed and memory of the arm's forward and inverse kinematics, against what the work must cost at least.

Each ratio compares two medians of one run, since machines differ and are noisy.
"""

import numpy as np
import pytest
from timing import peak_memory

from lynx_common import arm

N = 1_000_000


@pytest.fixture(scope="module")
def q() -> np.ndarray:
    """A million random configurations."""
    return np.random.default_rng(0).uniform(-np.pi, np.pi, (N, 5))


@pytest.fixture(scope="module")
def medians() -> dict[str, float]:
    """Median times of this run, in seconds, by name."""
    return {}


def floor(q: np.ndarray) -> np.ndarray:
    """The least that forward kinematics costs: five sines and cosines, and writing the result."""
    np.sin(q)
    np.cos(q)
    out = np.empty((len(q), 4, 4))
    out[...] = 1.0
    return out


def test_floor_of_a_million_poses(benchmark, q, medians):
    benchmark.pedantic(floor, [q], rounds=9, warmup_rounds=1)
    medians["floor"] = benchmark.stats.stats.median


def test_a_million_poses_at_most_1_8_times_the_floor(benchmark, q, medians):
    benchmark.pedantic(arm.forward_kinematics, [q], rounds=9, warmup_rounds=1)
    ratio = benchmark.stats.stats.median / medians["floor"]
    benchmark.extra_info["ratio to the floor"] = round(ratio, 2)
    print(f"\nforward kinematics of {N:,} poses: {ratio:.2f} times the floor")
    assert ratio <= 1.8


def test_a_million_poses_need_at_most_50_mb_beside_the_result(q):
    beside = peak_memory(lambda: arm.forward_kinematics(q)) - N * 16 * 8
    print(f"\npeak memory beside the result: {beside / 1e6:.1f} MB")
    assert beside <= 50e6


def test_one_pose_at_most_15_microseconds(benchmark, q):
    benchmark(arm.forward_kinematics, q[0])
    assert benchmark.stats.stats.median <= 15e-6


def test_all_branches_of_a_million_poses_at_most_400_nanoseconds_each(benchmark, q):
    task = arm.task_coordinates(q)
    position = arm.forward_kinematics(q)[:, :3, 3].copy()
    benchmark.pedantic(arm.inverse_kinematics, [position, task[:, 3], task[:, 4]], rounds=9, warmup_rounds=2)
    each = benchmark.stats.stats.median / N
    print(f"\nfour branches of a pose: {each * 1e9:.0f} ns")
    assert each <= 400e-9
