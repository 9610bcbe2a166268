"""Sweeps, voxels and exact sections: each against another way to find the same thing."""

import re

import numpy as np
import pytest

from lynx_common import arm, workspace
from lynx_common.errors import InputError

DEGREE = np.pi / 180
RANGES = DEGREE * np.array([[0, 360], [-90, 90], [-90, 90], [0, 360]])  # report section 1.2
ARMS = [arm.LYNX, arm.Geometry(0, 0.3, 0.2, 0.05), arm.Geometry(0.2, 1.5, 2.5, 0)]
# Gripper of Fig. 1.4; narrow; elbow on one side only; beyond the fold; a fixed joint; more than a turn.
LIMITS = DEGREE * np.array(
    [
        [[0, 360], [-90, 90], [-90, 90], [0, 360]],
        [[0, 360], [0, 180], [-90, 90], [0, 360]],
        [[0, 360], [20, 50], [30, 70], [-180, 180]],
        [[0, 360], [-30, 100], [10, 170], [0, 360]],
        [[0, 360], [0, 180], [120, 250], [0, 360]],
        [[0, 360], [45, 45], [-60, 90], [0, 360]],
        [[0, 360], [-200, 200], [-150, 150], [0, 400]],
    ]
)


def by_brute_force(limits, step, row, geometry):
    """Distinct (r, z), found the plain way: every posture on its own."""
    values = [np.arange(a, b + 1e-9, step) for a, b in limits[1:]]
    q = np.stack(np.meshgrid(0, *values, 0, indexing="ij"), axis=-1).reshape(-1, 5)
    points = arm.joint_positions(q, geometry)[:, row, ::2]
    return np.unique(np.round(points, 8) + 0.0, axis=0)


@pytest.mark.parametrize("geometry", ARMS)
@pytest.mark.parametrize(("point", "row"), workspace.POINTS.items())
def test_a_sweep_finds_what_brute_force_finds(geometry, point, row):
    for limits in (RANGES, LIMITS[1], LIMITS[3]):
        swept = workspace.sweep(limits, 15 * DEGREE, point, geometry=geometry)
        points = np.unique(np.round(np.c_[swept.r, swept.z], 8) + 0.0, axis=0)
        np.testing.assert_allclose(points, by_brute_force(limits, 15 * DEGREE, row, geometry), atol=3e-8)
        assert len(points) == len(swept.r)


@pytest.mark.committed_lengths
def test_the_counts_of_the_reports_sweep():
    fine, coarse = workspace.sweep(RANGES, DEGREE), workspace.sweep(RANGES, 10 * DEGREE)
    assert fine.combinations == 361 * 181 * 181 * 361 == 4_269_446_281
    assert coarse.combinations == 494_209
    assert len(fine.r) == 20_566
    assert len(np.unique(np.round(np.abs(fine.r) + 1j * fine.z, 9))) == 16_426
    assert len(fine.azimuth) == 361


def test_a_fixed_joint_and_a_step_that_does_not_divide_the_range():
    swept = workspace.sweep(LIMITS[5], 40 * DEGREE)
    assert swept.combinations == 10 * 1 * 4 * 10  # theta_3 at -60, -20, 20, 60 deg; 90 is not met
    assert len(swept.r) == 4


def test_occupancy_marks_the_cube_of_each_point_and_no_other():
    limits = RANGES.copy()
    limits[0] = DEGREE * np.array([0, 60])  # so that x and y differ
    swept = workspace.sweep(limits, 15 * DEGREE, "gripper")
    edge = 0.0317
    cubes = workspace.occupancy(swept, edge)
    x, z = np.outer(np.cos(swept.azimuth), swept.r), np.broadcast_to(swept.z, (5, len(swept.z)))
    points = np.stack([x, np.outer(np.sin(swept.azimuth), swept.r), z], axis=-1).reshape(-1, 3)
    marked = np.zeros_like(cubes.grid)
    marked[tuple(np.rint((points - cubes.first) / edge).astype(int).T)] = True
    assert (marked == cubes.grid).all()
    centres = np.stack(np.broadcast_arrays(*cubes.centres), axis=-1)[cubes.grid]
    assert np.abs(centres[:, None] - points[::500]).max(axis=-1).min(axis=0).max() <= edge / 2 * (1 + 1e-9)


def test_the_share_of_wrong_voxels_falls_with_the_edge():
    exact = workspace.section(RANGES)
    exact |= exact.mirror()
    wrong = []
    for edge, step in ((0.06, 6), (0.03, 3), (0.015, 1.5)):
        cubes = workspace.occupancy(workspace.sweep(RANGES, step * DEGREE), edge)
        x, y, z = cubes.centres
        inside = exact.contains(np.stack(np.broadcast_arrays(np.hypot(x, y), z), axis=-1))
        wrong.append((inside != cubes.grid).sum() / inside.sum())
    assert wrong[0] > 1.5 * wrong[1] > 2.25 * wrong[2]


@pytest.mark.committed_lengths
def test_the_wrist_reaches_a_spherical_shell():
    region = workspace.section(RANGES)
    whole = region | region.mirror()
    assert whole.volume == pytest.approx(4 / 3 * np.pi * (0.4**3 - 0.2**3 * 2 * 2**0.5), rel=1e-12)
    assert whole.volume == pytest.approx(0.173301070, abs=5e-10)
    np.testing.assert_allclose(whole.arcs[:, :3], [[0, 0.1, 0.2 * 2**0.5], [0, 0.1, 0.4]], atol=1e-15)


@pytest.mark.committed_lengths
def test_the_gripper_of_fig_1_4():
    region = workspace.section(LIMITS[1], "gripper")
    points = np.vstack(region.boundary())
    np.testing.assert_allclose(points[:, 1].min(), -0.2, atol=1e-12)
    np.testing.assert_allclose(np.abs(points).max(axis=0), [0.5, 0.6], atol=1e-4)


@pytest.mark.parametrize("geometry", ARMS)
@pytest.mark.parametrize(
    ("i", "point"),
    [(i, point) for i in range(len(LIMITS)) for point in workspace.POINTS if (i, point) != (5, "gripper")],
)
def test_the_exact_section_holds_a_dense_sweep_and_is_filled_by_it(geometry, i, point):
    limits = LIMITS[i]
    region = workspace.section(limits, point, geometry=geometry)
    rng = np.random.default_rng(i)
    q = np.zeros((150_000, 5))
    q[:, 1:4] = rng.uniform(*limits[1:].T, (len(q), 3))
    points = arm.joint_positions(q, geometry)[:, workspace.POINTS[point], ::2]
    outside = points[::50][~region.contains(points[::50])]
    if len(outside):
        assert region.distances(outside)[0].max() < 1e-7 * sum(geometry)
    size = np.ptp(points, axis=0).max() / 20
    inner = region.contains(grid := np.stack(np.meshgrid(*2 * [np.arange(-45, 45)]), axis=-1) * size)
    deep = grid[inner & (region.distances(grid)[0] > size)]
    assert set(cells(deep, size)) <= set(cells(points, size))
    low_edge = 0 if i == 5 and point == "wrist" else 1e-4 * sum(geometry) ** 2  # a fixed theta_2: only a line
    assert region.area >= low_edge


def cells(points, size):
    """The cells of a grid that hold points: (..., 2) -> (n,), a number each."""
    return np.unique(np.rint(points / size) @ [1000, 1])


def test_the_gripper_needs_a_wrist_that_turns_fully():
    with pytest.raises(InputError, match="turns fully"):
        workspace.section(arm.JOINT_LIMITS[:4], "gripper")


def bad(**changes):
    arguments = {"limits": RANGES, "step": DEGREE, "point": "wrist"} | changes
    return lambda: workspace.sweep(**arguments)


BAD = [
    (bad(step=0), "The step is one finite number, above 0; 0 was given"),
    (bad(step=-DEGREE), "The step is one finite number, above 0"),
    (bad(step=np.nan), "The step is one finite number, above 0"),
    (bad(step=np.inf), "The step is one finite number, above 0"),
    (bad(step=4), "4.0000 rad is larger than the range of joint 2, 3.1416 rad"),
    (bad(point="elbow"), "one of wrist, gripper; 'elbow' was given"),
    (bad(limits=RANGES[:, ::-1]), "limits of joint 1 are reversed: 6.2832 is above 0.0000"),
    (bad(limits=RANGES * np.nan), "Finite numbers are expected for limits"),
    (bad(limits=arm.JOINT_LIMITS), "of shape (4, 2)"),
    (bad(limits=RANGES + 1j), "Real numbers are expected for limits"),
    (lambda: workspace.section(RANGES, "elbow"), "one of wrist, gripper"),
    (lambda: workspace.section(np.array([[0, 1], [0, 1], [1, 0], [0, 1]])), "joint 3 are reversed"),
    (lambda: workspace.section(LIMITS[5], "gripper"), "one of them stands still"),
    (lambda: workspace.occupancy(workspace.sweep(RANGES, 0.5), 0.0004), "would take 7.8 GB; 1 GB is allowed"),
    (
        lambda: workspace.occupancy(workspace.sweep(RANGES, 0.5), 0),
        "The edge of a cube is one finite number, above 0; 0 was given",
    ),
    (lambda: workspace.occupancy(workspace.sweep(RANGES, 0.5), np.nan), "The edge of a cube is"),
]


@pytest.mark.parametrize(("call", "sentence"), BAD, ids=[sentence for _, sentence in BAD])
@pytest.mark.committed_lengths
def test_bad_input_gets_a_sentence(call, sentence):
    with pytest.raises(InputError, match=re.escape(sentence)):
        call()
