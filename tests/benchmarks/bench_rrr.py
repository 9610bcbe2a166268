"""The 3-RRR: assembly modes of many configurations, and the workspace on a grid of 1 mm and 1 deg."""

import itertools
import time

import numpy as np
from timing import peak_memory, shown

from lynx_common import rrr

SIDE = np.linspace(-300, 300, 601)  # mm
ALPHA = np.deg2rad(np.arange(61))
X, Y = np.meshgrid(SIDE, SIDE)


def grid() -> int:
    """Poses of the grid that the platform can take, one alpha at a time."""
    pose = np.stack([X, Y, np.zeros_like(X)], axis=-1)
    count = 0
    for alpha in ALPHA:
        pose[..., 2] = alpha
        count += np.count_nonzero(rrr.reachable(pose))
    return count


def test_a_grid_of_601_by_601_by_61_at_most_1_5_seconds(benchmark, tables):
    count = benchmark.pedantic(grid, rounds=5, warmup_rounds=1)
    seconds = benchmark.stats.stats.median
    print(f"\n{SIDE.size**2 * ALPHA.size:,} poses, {count:,} of them reachable: {seconds:.2f} s")
    tables.facts["which of 22,033,261 poses the 3-RRR can take (no peer tells)"] = shown(seconds)
    assert seconds <= 1.5


def test_a_grid_of_601_by_601_by_61_at_most_100_mb():
    peak = peak_memory(grid)
    print(f"\npeak memory of the grid: {peak / 1e6:.1f} MB")
    assert peak <= 100e6


def test_assembly_modes_at_most_100_microseconds_a_configuration(benchmark):
    rng = np.random.default_rng(0)
    pose = rng.uniform(-1, 1, (60_000, 3)) * [250, 250, np.pi]
    pose = pose[rrr.reachable(pose)]
    theta = rrr.inverse_kinematics(pose)[:, 0]
    found = benchmark.pedantic(rrr.forward_kinematics, (theta,), rounds=7, warmup_rounds=1)
    begin = time.perf_counter()
    rrr.inverse_kinematics(pose)
    inverse = time.perf_counter() - begin
    each = 1e6 * benchmark.stats.stats.median / len(theta)
    modes = np.isfinite(found[..., 0]).sum(axis=1)
    print(f"\n{len(theta):,} configurations: {each:.0f} us each for {modes.mean():.1f} poses on average")
    print(f"the eight working modes of a pose: {1e6 * inverse / len(pose):.2f} us")
    assert each <= 100


def test_assembly_modes_of_one_configuration_at_most_a_millisecond(benchmark):
    """Of many that close, one after the other: how many poses there are makes a difference."""
    pose = np.random.default_rng(2).uniform([-80, -80, -0.6], [80, 80, 0.6], (1000, 3))
    theta = itertools.cycle(rrr.inverse_kinematics(pose)[rrr.reachable(pose), 0])
    benchmark.pedantic(rrr.forward_kinematics, setup=lambda: ((next(theta),), {}), rounds=500, warmup_rounds=5)
    median = benchmark.stats.stats.median
    print(f"\nassembly modes of one configuration: {median * 1e3:.2f} ms")
    assert median <= 1e-3
