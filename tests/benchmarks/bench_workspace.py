"""The sweep at 1 deg with its voxels, too large for memory as a whole, against the one at 10 deg pose by pose."""

import time

import numpy as np
from timing import OURS, peak_memory, shown, side_by_side

from lynx_common import arm, workspace

DEGREE = np.pi / 180
RANGES = DEGREE * np.array([[0, 360], [-90, 90], [-90, 90], [0, 360]])  # report section 1.2


def sweep_and_occupancy() -> workspace.Occupancy:
    return workspace.occupancy(workspace.sweep(RANGES, DEGREE), 0.005)


def test_the_sweep_at_1_degree_at_most_1_second(benchmark, tables):
    benchmark.pedantic(sweep_and_occupancy, rounds=9, warmup_rounds=1)
    print(f"\n4,269,446,281 combinations at 1 deg, with voxels of 5 mm: {benchmark.stats.stats.median:.3f} s")
    tables.facts["sweep at 1°, 4,269,446,281 combinations, with voxels of 5 mm"] = shown(
        benchmark.stats.stats.median
    )
    assert benchmark.stats.stats.median <= 1


def test_the_sweep_at_1_degree_at_most_200_mb():
    peak = peak_memory(sweep_and_occupancy)
    print(f"\npeak memory of the sweep at 1 deg and its voxels: {peak / 1e6:.1f} MB")
    assert peak <= 200e6


def link(a: float, alpha: float, d: float, theta: float) -> np.ndarray:
    """Report eq. (1.1)."""
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def test_against_the_same_pose_by_pose_at_10_degrees(tables):
    """494,209 poses, one product of four links each, as in the report; one run, since it is slow."""
    d_1, L_1, L_2, _ = arm.LYNX
    turn, half = DEGREE * np.arange(0, 361, 10), DEGREE * np.arange(-90, 91, 10)
    begin = time.perf_counter()
    points = [
        (
            link(0, np.pi / 2, d_1, theta_1)
            @ link(L_1, 0, 0, theta_2)
            @ link(L_2, 0, 0, theta_3)
            @ link(0, np.pi / 2, 0, theta_4)
        )[:3, 3]
        for theta_1 in turn
        for theta_2 in half
        for theta_3 in half
        for theta_4 in turn
    ]
    one_by_one = time.perf_counter() - begin
    ours = np.median(side_by_side({OURS: sweep_and_occupancy}, rounds=9, least=0)[OURS])
    times = f"{one_by_one / ours:.0f} times the sweep at 1°"
    print(f"\n{len(points):,} poses one by one: {one_by_one:.1f} s, {times}")
    tables.facts["sweep at 10°, 494,209 combinations one by one, as in the report"] = (
        f"{shown(one_by_one)}, {times}"
    )
    assert len(points) == workspace.sweep(RANGES, 10 * DEGREE).combinations
