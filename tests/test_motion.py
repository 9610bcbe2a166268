"""Laws of motion: what is followed is the path, nothing jumps, limits are kept."""

from itertools import pairwise, product

import numpy as np
import pytest

from lynx_common import arm, motion
from lynx_common.errors import InputError, JointLimitError, JumpError, OutOfReachError, PathError

# Report Table 1.5 in task coordinates, which run on over the top: c is at full stretch, on the base axis.
TABLE_1_5 = np.array(
    [
        [0, 0.32, 0.2, -np.pi / 2, 0],
        [0, 0.2, 0.4, 0, 0],
        [0, 0, 0.6, np.pi / 2, 0],
        [0, -0.2, 0.4, np.pi, 0],
        [0, -0.32, 0.2, 3 * np.pi / 2, 0],
    ]
)
OVER_THE_TOP = TABLE_1_5[1:4]
A, B = np.array([0.1, 0.2, 0.3, -0.4, 0.5]), np.array([-0.6, 0.25, 0.35, 0.4, 1.5])
UNLIMITED = np.array([[-30.0, 30.0]] * 5)

PATHS = {
    "line": motion.line(A, B),
    "made by hand": motion.Path(lambda s: A + s * (B - A) + np.sin(np.pi * s) * [0.2, 0.1, -0.3, 0.4, 0.05]),
    "space_line": motion.space_line([0.2, 0.1, 0.3], [-0.15, 0.2, 0.4], (0.1, -0.3), roll=0.2),
    "space_line through the axis": motion.space_line([0.2, 0.1, 0.3], [-0.4, -0.2, 0.4], (0.1, -0.3)),
    "joined": motion.joined(motion.line(A, B), motion.line(B, B + 0.1), motion.line(B + 0.1, A)),
}


def linear(tau):
    return tau, 1 + 0 * tau, 0 * tau


def polyline(points):
    return motion.joined(*(motion.line(*pair) for pair in pairwise(points)))


SCALINGS = {
    "cubic": motion.cubic,
    "quintic": motion.quintic,
    "from_stretch": motion.from_stretch,
    "to_stretch": motion.to_stretch,
    "trapezoidal": motion.trapezoidal,
    "triangular": lambda tau: motion.trapezoidal(tau, 0.5),
}


def position(task):
    """Where the gripper is in space: (..., 5) to (..., 3)."""
    azimuth, r, z, _, _ = np.moveaxis(task, -1, 0)
    return np.stack([r * np.cos(azimuth), r * np.sin(azimuth), z], axis=-1)


def travel(q):
    return np.linalg.norm(np.diff(q, axis=0), axis=-1).sum()


# Paths


@pytest.mark.parametrize("path", PATHS.values(), ids=PATHS)
@pytest.mark.parametrize("batch", [(), (0,), (7,), (3, 1, 2)])
def test_a_path_takes_any_batch_and_its_rows_do_not_depend_on_it(path, batch, rng):
    s = rng.uniform(0, 1, batch)
    assert path(s).shape == (*batch, 5)
    for index in np.ndindex(batch):
        np.testing.assert_array_equal(path(s)[index], path(s[index]))


@pytest.mark.parametrize("path", PATHS.values(), ids=PATHS)
@pytest.mark.parametrize("s", [-0.1, 1.1, [0.5, np.nan], np.inf, 0.5j])
def test_a_path_has_no_points_beyond_its_ends(path, s):
    with pytest.raises(InputError, match="path's parameter s"):
        path(s)


def test_a_line_meets_both_ends_exactly():
    straight = motion.line(A, B)
    np.testing.assert_array_equal(straight([0, 1]), [A, B])
    np.testing.assert_allclose(straight(0.25), 0.75 * A + 0.25 * B)


def test_joined_lines_go_through_their_points_in_equal_shares():
    path = polyline(TABLE_1_5)
    np.testing.assert_allclose(path(np.linspace(0, 1, 5)), TABLE_1_5, atol=1e-15)
    np.testing.assert_allclose(path(1 / 8), TABLE_1_5[:2].mean(axis=0))


def test_a_line_in_space_is_straight_in_space(rng):
    s = np.linspace(0, 1, 100)
    for _ in range(100):
        start, end = rng.uniform(-0.3, 0.3, (2, 3))
        path = motion.space_line(start, end, (0.2, -0.7), roll=0.4)
        np.testing.assert_allclose(position(path(s)), start + s[:, None] * (end - start), atol=1e-12)
        np.testing.assert_allclose(path(s)[:, 3:], np.stack([0.2 - 0.9 * s, 0 * s + 0.4], -1))
        assert np.abs(np.diff(path(s)[:, 0])).max() < np.pi  # not wrapped on the way


@pytest.mark.parametrize(
    ("start", "end", "azimuth"),
    [
        ([0.3, 0.3, 0.2], [-0.1, -0.1, 0.4], np.pi / 4),  # over the base axis
        ([0, 0, 0.2], [-0.1, 0, 0.4], np.pi),  # from it
        ([-0.1, 0, 0.2], [0, 0, 0.4], np.pi),  # to it
        ([0, -0.1, 0.2], [0, -0.1, 0.4], -np.pi / 2),  # beside it
        ([0, 0, 0.2], [0, 0, 0.4], 0),  # on it
    ],
)
def test_a_line_in_space_that_meets_the_base_axis_keeps_its_azimuth(start, end, azimuth):
    path, s = motion.space_line(start, end, (0, 1)), np.linspace(0, 1, 21)
    np.testing.assert_allclose(path(s)[:, 0], azimuth)
    np.testing.assert_allclose(position(path(s)), np.outer(1 - s, start) + np.outer(s, end), atol=1e-15)


def test_the_sides_of_a_star_join_without_a_jump_and_wind_twice_round_the_base():
    """Report Fig. 1.9. Two turns are more than theta_1 has: the star cannot be drawn in one go."""
    azimuth = 4 * np.pi / 5 * np.arange(6)
    corners = np.stack([0.2 * np.cos(azimuth), 0.2 * np.sin(azimuth), 0.4 + 0 * azimuth], -1)
    star = motion.joined(*(motion.space_line(*ends, (0, 0)) for ends in pairwise(corners)))
    task = star(np.linspace(0, 1, 501))
    assert np.abs(np.diff(task, axis=0)).max() < 0.1
    assert task[-1, 0] - task[0, 0] == pytest.approx(4 * np.pi)
    np.testing.assert_allclose(position(task[::100]), corners, atol=1e-12)
    failure = motion.follow(task).failure
    assert isinstance(failure.cause, JointLimitError)
    assert failure.cause.joint == 1


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: motion.line(A, A), "both are .* its length is zero"),
        (lambda: polyline([A, B, B]), "its length is zero"),
        (lambda: motion.space_line([0.1, 0, 0], [0.1, 0, 0], (0, 1)), "its length is zero"),
        (motion.joined, "none was given"),
        (lambda: motion.joined(motion.line(A, B), motion.line(A, B)), "where the one before ends"),
        (
            lambda: motion.joined(motion.line(B, A), motion.line(A + [0, 2 * np.pi, 0, 0, 0], B)),
            "Path 1 begins with r 6.483185, where the one before ends with 0.2",
        ),
        (lambda: motion.line(A, [*B[:4], np.inf]), "Finite numbers.* are expected for task coordinates"),
        (lambda: motion.line(A, B * 1j), "Real numbers are expected"),
        (lambda: motion.line(A[:4], B[:4]), r"of shape \(5,\) are expected for task coordinates"),
        (
            lambda: motion.space_line([0.1, 0, np.nan], [0.1, 0, 0], (0, 1)),
            "Finite numbers are expected for a position",
        ),
        (lambda: motion.space_line(np.array([0.1j, 0, 0]), [0.1, 0, 0], (0, 1)), "Real numbers are expected"),
    ],
)
def test_a_path_that_is_none_is_refused(make, message):
    with pytest.raises(InputError, match=message):
        make()


# Time scalings


@pytest.mark.parametrize("scaling", SCALINGS.values(), ids=SCALINGS)
def test_a_time_scaling_runs_from_0_to_1_and_never_back(scaling):
    s, s_dot, _ = scaling(np.linspace(0, 1, 1001))
    np.testing.assert_allclose(s[[0, -1]], [0, 1], atol=1e-15)
    assert (np.diff(s) >= 0).all()
    assert (s_dot >= -1e-14).all()


@pytest.mark.parametrize("scaling", SCALINGS.values(), ids=SCALINGS)
def test_the_derivatives_of_a_time_scaling_are_those_of_its_differences(scaling):
    tau, step = np.linspace(0.0105, 0.9895, 90), 1e-5  # beside the corners at 1/4, 1/2, 3/4
    behind, here, ahead = (scaling(tau + shift) for shift in (-step, 0, step))
    np.testing.assert_allclose(here[1], (ahead[0] - behind[0]) / (2 * step), atol=1e-7)
    np.testing.assert_allclose(here[2], (ahead[1] - behind[1]) / (2 * step), atol=1e-7)
    assert [x.shape for x in scaling(0.3)] == [(), (), ()]


@pytest.mark.parametrize(
    ("name", "start", "end"),
    [
        ("cubic", (0, 6), (0, -6)),
        ("quintic", (0, 0), (0, 0)),
        ("from_stretch", (0, 0), (0, 0)),
        ("to_stretch", (0, 0), (0, 0)),
        ("trapezoidal", (0, 16 / 3), (0, -16 / 3)),
    ],
)
def test_how_a_time_scaling_rests_at_its_ends(name, start, end):
    _, s_dot, s_ddot = SCALINGS[name](np.array([0.0, 1.0]))
    np.testing.assert_allclose([s_dot, s_ddot], np.transpose([start, end]), atol=1e-12)


def test_at_full_stretch_s_goes_as_the_fourth_power():
    tau = np.array([1e-3, 2e-3])
    np.testing.assert_allclose(motion.from_stretch(tau)[0] / tau**4, 15, rtol=0.01)
    np.testing.assert_allclose((1 - motion.to_stretch(1 - tau)[0]) / tau**4, 15, rtol=0.01)
    np.testing.assert_allclose(motion.from_stretch(1 - tau)[0], 1 - 20 * tau**3, rtol=0, atol=1e-9)


def test_the_trapezoid_is_constant_acceleration_constant_speed_constant_deceleration():
    s, s_dot, s_ddot = motion.trapezoidal(np.array([0.1, 0.5, 0.95]), 0.2)
    np.testing.assert_allclose(s_dot, [0.625, 1.25, 0.3125])
    np.testing.assert_allclose(s_ddot, [6.25, 0, -6.25])
    np.testing.assert_allclose(s, [0.03125, 0.5, 1 - 0.05**2 * 6.25 / 2])


@pytest.mark.parametrize("scaling", SCALINGS.values(), ids=SCALINGS)
@pytest.mark.parametrize("tau", [-0.1, 1.1, np.nan, 1j])
def test_a_time_scaling_knows_no_time_before_or_after(scaling, tau):
    with pytest.raises(InputError, match="time tau"):
        scaling(tau)


@pytest.mark.parametrize("blend", [0, -0.1, 0.51, np.nan])
def test_a_blend_is_at_most_half_of_the_time(blend):
    with pytest.raises(InputError, match="blend"):
        motion.trapezoidal(0.5, blend)


# Following


def continuous(q):
    """Steps are small, and theta_3 changes its sign only at full stretch."""
    small = (np.abs(np.diff(q, axis=0)) <= np.pi / 2).all(axis=1)
    side = np.where(np.abs(q[:, 2]) <= 1e-6, 0, np.sign(q[:, 2]))
    return bool((small & (side[1:] * side[:-1] >= 0)).all())


def assert_follows(followed, task, limits=arm.JOINT_LIMITS):
    assert followed.ok
    assert followed.failure is None
    assert followed.reached.all()
    assert followed.allowed.all()
    assert followed.continuous.all()
    np.testing.assert_allclose(arm.task_coordinates(followed.q), task, atol=1e-9)
    assert (followed.q >= limits[:, 0] - 1e-9).all()
    assert (followed.q <= limits[:, 1] + 1e-9).all()
    assert continuous(followed.q)


@pytest.mark.parametrize("n", [101, 401, 1000])
@pytest.mark.parametrize("points", [TABLE_1_5, OVER_THE_TOP, OVER_THE_TOP[::-1]], ids=["all", "top", "back"])
@pytest.mark.committed_lengths
def test_a_path_over_the_top_is_followed_within_limits(points, n):
    task = polyline(points)(np.linspace(0, 1, n))
    assert_follows(motion.follow(task), task)


@pytest.mark.committed_lengths
def test_over_the_top_the_elbow_changes_sides_at_full_stretch():
    """Table 1.5 with the elbow the higher one all along: theta_3 passes through 0 at c, and nothing jumps."""
    task = polyline(TABLE_1_5)(np.linspace(0, 1, 201))
    q = motion.follow(task).q
    assert np.abs(q[100, 2]) < 1e-6
    assert (q[:100, 2] < -0.01).all()
    assert (q[101:, 2] > 0.01).all()
    degrees = np.rad2deg(q).round(1)
    np.testing.assert_allclose(
        [degrees[:, 1].max(), degrees[:, 3].min(), degrees[:, 3].max()], [128.6, -12.6, 192.6]
    )


@pytest.mark.committed_lengths
def test_without_a_sample_at_full_stretch_the_elbow_stays_on_its_side():
    task = polyline(TABLE_1_5)(np.linspace(0, 1, 200))
    theta_3 = motion.follow(task).q[:, 2]
    assert (theta_3 > 0).all() or (theta_3 < 0).all()


def test_nearly_at_full_stretch_is_not_at_full_stretch():
    """With theta_3 at 0.006 deg the elbow has its side: a path that turns back there keeps it, and q is known."""
    q = np.array([0.3, 0.4, 1e-4, 1.2, 0.1])
    task = arm.task_coordinates(np.array([q + [0, 0, 0.5, 0, 0], q, q * [1, 1, -1, 1, 1] - [0, 0, 0.5, 0, 0]]))
    signs = np.sign(motion.follow(task).q[:, 2])
    assert abs(signs.sum()) == 3


def test_room_for_rounding_is_no_more_than_that():
    """A parameter, a join, a line beside the base axis: a tenth of a micrometre is seen, a thousandth is not."""
    start, middle, end = np.zeros(5), np.array([0, 0.1, 0, 0, 0]), np.array([0, 0.1, 0.1, 0, 0])
    path = motion.line(start, middle)
    path(1 + 1e-10)
    motion.joined(path, motion.line(middle + 1e-10, end))
    for refused in (lambda: path(1 + 1e-7), lambda: motion.joined(path, motion.line(middle + 1e-7, end))):
        with pytest.raises(InputError):
            refused()
    for aside, turned in ((1e-10, 0), (1e-7, np.pi)):
        beside = motion.space_line([0.2, aside, 0], [-0.2, aside, 0], (0, 0))
        azimuth, r, *_ = beside(np.array([0.0, 1.0])).T
        assert azimuth[1] - azimuth[0] == pytest.approx(turned, abs=1e-5)
        assert r[1] == pytest.approx(0.2 if turned else -0.2)


@pytest.mark.committed_lengths
def test_the_elbow_may_change_from_the_higher_to_the_lower_where_the_wrist_crosses_the_vertical():
    """There the rows of `arm.joint_angles` change places, and a motion does not."""
    task = motion.line([0, 0.1, 0.4, np.pi / 2, 0], [0, -0.1, 0.4, np.pi / 2, 0])(np.linspace(0, 1, 50))
    followed = motion.follow(task)
    assert_follows(followed, task)
    rows = np.isclose(arm.joint_angles(task), followed.q[:, None], atol=1e-9).all(axis=-1)
    assert {tuple(row) for row in rows} == {(True, False), (False, True)}


@pytest.mark.committed_lengths
def test_angles_run_on_where_the_wrist_passes_behind_the_shoulder():
    """Where atan2 jumps by a full turn, theta_2 does not."""
    limits = np.array([[-30.0, 30.0]] * 5)
    angle = np.linspace(0.5, 2 * np.pi - 0.5, 200)
    task = np.stack([0 * angle, 0.3 * np.cos(angle), 0.1 + 0.3 * np.sin(angle), angle, 0 * angle], -1)
    assert_follows(motion.follow(task, limits=limits), task, limits)


def test_a_motion_starts_on_the_turn_that_its_limits_need():
    """Azimuth 350 deg is -10 deg; what counts is the whole motion, so 170 to 190 deg does not go."""
    s = np.linspace(0, 1, 30)
    turned = A + np.array([2 * np.pi, 0, 0, 0, -4 * np.pi])
    followed = motion.follow(motion.line(turned, turned + 0.1)(s))
    assert followed.ok
    np.testing.assert_allclose(followed.q[:, [0, 4]], motion.line(A, A + 0.1)(s)[:, [0, 4]])
    seam = np.deg2rad([170, 0, 0, 0, 0]) + A * [0, 1, 1, 1, 1]
    across = motion.follow(motion.line(seam, seam + np.deg2rad([20, 0, 0, 0, 0]))(s))
    assert across.failure.cause.joint == 1
    np.testing.assert_array_equal(across.allowed, s <= 0.5)
    assert np.isfinite(across.q[across.allowed]).all()
    assert np.isnan(across.q[~across.allowed]).all()


def enumerated(task, limits):
    """Least travel of all motions through the two rows of each sample and all turns within limits; inf if none."""
    shifts = 2 * np.pi * np.array(list(product([-1, 0, 1], repeat=4))) @ np.eye(5)[[0, 1, 3, 4]]
    least = {}
    for i, rows in enumerate(arm.joint_angles(task)):
        candidates = (rows[:, None] + shifts).reshape(-1, 5)
        before, least = least, {}
        for q in candidates[((candidates >= limits[:, 0]) & (candidates <= limits[:, 1])).all(axis=1)]:
            costs = [cost + travel([p, q]) for p, cost in before.items() if continuous(np.array([p, q]))]
            least[tuple(q)] = min(costs, default=np.inf) if i else 0.0
    return min(least.values(), default=np.inf)


def short_path(rng):
    """Six samples between random postures; half of the paths pass through full stretch at a sample."""
    q = rng.uniform(*arm.JOINT_LIMITS.T, (3, 5))
    q[1:] = q[0] + rng.uniform(-0.6, 0.6, (2, 5))
    if rng.uniform() < 0.5:
        q[1, 2], q[[0, 2], 2] = 0, rng.uniform(-0.6, 0.6, 2)
    return polyline(arm.task_coordinates(q))(np.linspace(0, 1, 7))


def test_no_motion_travels_less_than_the_one_that_is_followed(rng):
    """Against all sequences of rows and turns, on short random paths, with and without a way through."""
    found = []
    for _ in range(300):
        task = short_path(rng)
        if np.isnan(arm.joint_angles(task)).any():
            continue
        limits = arm.JOINT_LIMITS + rng.uniform(-0.5, 0.5, (5, 1))
        expected, followed = enumerated(task, limits), motion.follow(task, limits=limits)
        assert followed.ok == np.isfinite(expected)
        if followed.ok:
            assert travel(followed.q) == pytest.approx(expected, abs=1e-5)
            assert continuous(followed.q)
        found.append(followed.ok)
    assert min(sum(found), len(found) - sum(found)) > 20  # both happened


@pytest.mark.committed_lengths
def test_a_start_out_of_reach_is_named_with_its_distance():
    task = motion.line([0, 0.52, 0.1, 0, 0], [0, 0.4, 0.1, 0, 0])(np.linspace(0, 1, 13))
    followed = motion.follow(task)
    assert not followed.ok
    assert (followed.failure.sample, followed.failure.count) == (0, 13)
    assert isinstance(followed.failure.cause, OutOfReachError)
    assert followed.failure.cause.distance == pytest.approx(0.42)
    assert str(followed.failure).startswith("The path fails first at sample 0 of 0 to 12: Target position is out")
    np.testing.assert_array_equal(followed.reached, np.arange(13) >= 2)
    np.testing.assert_array_equal(np.isnan(followed.q).all(axis=1), ~followed.reached)
    assert followed.allowed.all()
    assert followed.continuous.all()


@pytest.mark.committed_lengths
def test_an_end_out_of_limits_is_named_with_its_joint():
    task = motion.line([0, 0.3, 0.3, 0, 0], [0, 0.3, 0.3, 0, 4])(np.linspace(0, 1, 5))
    failure = motion.follow(task).failure
    assert failure.sample == 4
    assert (failure.cause.joint, failure.cause.value, failure.cause.limits) == (5, 4, tuple(arm.JOINT_LIMITS[4]))
    with pytest.raises(PathError, match=r"sample 4 of 0 to 4: Joint 5 would stand at 229\.18 deg"):
        raise failure


@pytest.mark.committed_lengths
def test_narrower_limits_choose_the_other_elbow_or_none():
    """Table 1.5 a and e need the wrist bent by more than 90 deg, which a hobby servo of +-90 deg does not do."""
    task = motion.line(A * [1, 1, 1, 0, 1], B * [1, 1, 1, 0, 1])(np.linspace(0, 1, 40))
    free = motion.follow(task).q
    for sign in (1, -1):
        limits = arm.JOINT_LIMITS.copy()
        limits[1] = -np.pi, np.pi
        limits[2] = sorted([0, sign * 2.6])
        assert (np.sign(motion.follow(task, limits=limits).q[:, 2]) == sign).all()
    assert np.isfinite(free).all()
    servo = arm.JOINT_LIMITS.copy()
    servo[3] = 0, np.pi
    failure = motion.follow(polyline(TABLE_1_5)(np.linspace(0, 1, 201)), limits=servo).failure
    assert failure.sample == 0
    assert failure.cause.joint == 4


@pytest.mark.committed_lengths
def test_a_jump_of_the_path_is_a_failure_at_the_sample_behind_it():
    """The report's theta_1 = atan2(y, x) over the base axis: from front to back between two samples."""
    s = np.linspace(0, 1, 50)
    before = motion.line(TABLE_1_5[1], [0, 0.02, 0.5, np.pi / 2, 0])(s)
    after = motion.line([np.pi, 0.02, 0.5, np.pi / 2, 0], [np.pi, 0.2, 0.4, 0, 0])(s)
    followed = motion.follow(np.vstack([before, after]))
    np.testing.assert_array_equal(np.flatnonzero(~followed.continuous), [50])
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(followed.q).any(axis=1)), [50])
    cause = followed.failure.cause
    assert isinstance(cause, JumpError)
    assert (cause.sample, cause.joint) == (50, 1)
    assert cause.step == pytest.approx(np.pi)
    assert "Between samples 49 and 50 joint 1 would move by 180.00 deg" in str(followed.failure)


@pytest.mark.committed_lengths
def test_after_a_gap_the_motion_may_begin_anew():
    """Low in front only one elbow keeps theta_2 within limits, and low behind only the other one."""
    s = np.linspace(0, 1, 20)
    first = motion.line([0, 0.3, 0.2, 0, 0], [0, 0.3, 0.22, 0, 0])(s)
    second = motion.line([0, -0.3, 0.2, np.pi, 0], [0, -0.3, 0.22, np.pi, 0])(s)
    followed = motion.follow(np.vstack([first, [[0, 0.9, 0.9, 0, 0]], second]))
    np.testing.assert_array_equal(np.flatnonzero(~followed.reached), [20])
    np.testing.assert_allclose(followed.q[:20], motion.follow(first).q)
    np.testing.assert_allclose(followed.q[21:], motion.follow(second).q)
    assert (followed.q[:20, 2] < 0).all()
    assert (followed.q[21:, 2] > 0).all()


def test_what_stands_within_limits_is_followed_whatever_turns_its_angles_are_named_with(rng):
    """The two elbows may need different turns of theta_4."""
    for q in rng.uniform(*arm.JOINT_LIMITS.T, (500, 5)):
        turns = 2 * np.pi * rng.integers(-2, 3, 5) * [1, 0, 0, 1, 1]
        task = arm.task_coordinates(q) + turns
        followed = motion.follow(np.array([task, task]))
        assert followed.ok
        np.testing.assert_allclose(arm.forward_kinematics(followed.q), [arm.forward_kinematics(q)] * 2, atol=1e-9)


@pytest.mark.parametrize("n", [0, 1, 2])
def test_few_samples(n):
    followed = motion.follow(np.tile(A, (n, 1)))
    assert followed.ok
    assert followed.q.shape == (n, 5)
    assert followed.reached.shape == followed.allowed.shape == followed.continuous.shape == (n,)


def test_a_path_that_is_nowhere_in_reach():
    followed = motion.follow(np.full((3, 5), 2.0))
    assert not followed.reached.any()
    assert np.isnan(followed.q).all()


@pytest.mark.committed_lengths
def test_a_wrist_on_the_shoulder_is_not_within_limits():
    task = motion.line([0, 0.15, 0.1, 0, 0], [0, 0.1, 0.1, 0, 0])(np.linspace(0, 1, 5))
    followed = motion.follow(task)
    assert followed.reached.all()
    assert not followed.allowed[-1]


def test_along_the_boundary_of_its_reach_the_arm_stays_straight():
    angle = np.linspace(0.3, 2.0, 200)
    q = np.stack([0 * angle, angle, 0 * angle, 0 * angle + 0.5, 0 * angle], -1)
    followed = motion.follow(arm.task_coordinates(q))
    assert followed.ok
    np.testing.assert_allclose(followed.q, q, atol=1e-6)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    ("task", "limits", "message"),
    [
        (A, arm.JOINT_LIMITS, r"of shape \(n, 5\) are expected for task coordinates"),
        ([A, A * np.nan], arm.JOINT_LIMITS, "given in row 1"),
        ([A * 1j], arm.JOINT_LIMITS, "Real numbers"),
        ([A], arm.JOINT_LIMITS[:, ::-1], "limits of joint 1 are reversed"),
        ([A], arm.JOINT_LIMITS[:4], r"Finite numbers.* expected for limits"),
        ([A], np.array([[-np.inf, np.inf]] * 5), r"Finite numbers.* expected for limits"),
    ],
)
def test_what_cannot_be_followed_is_refused(task, limits, message):
    with pytest.raises(InputError, match=message):
        motion.follow(task, limits=limits)


# Speeds


REACH = np.array([0.5, -0.4, 0.3, 0.2, -1.0])


def scaled(scaling, n=2001):
    """Samples of a motion from 0 to REACH, straight in joint space; joint 5 moves by 1 rad."""
    return scaling(np.linspace(0, 1, n))[0][:, None] * REACH


@pytest.mark.parametrize(
    ("scaling", "speed", "acceleration"),
    [
        (linear, 1, 0),
        (motion.cubic, 1.5, 6),
        (motion.quintic, 1.875, 10 / np.sqrt(3)),
        (motion.trapezoidal, 4 / 3, 16 / 3),
    ],
)
def test_the_shortest_time_of_a_straight_motion_is_known(scaling, speed, acceleration):
    q = scaled(scaling)
    assert motion.duration(q, 0.5, np.inf) == pytest.approx(speed / 0.5, rel=1e-3)
    assert motion.duration(q, np.inf, 0.5) == pytest.approx(np.sqrt(acceleration / 0.5), rel=1e-3, abs=1e-3)
    limits = np.array([9, 9, 9, 0.1, 9])  # joint 4 alone decides
    assert motion.duration(q, limits, 1e9) == pytest.approx(speed * 0.2 / 0.1, rel=1e-3)


def test_differences_are_those_of_the_motion_itself():
    """Exact for a line and for the acceleration of a cubic, however few the samples; at either end."""
    assert motion.duration(scaled(linear, 5), 0.5, np.inf) == pytest.approx(2)
    half = scaled(motion.cubic, 21)[:11]  # the hardest acceleration, 6, is at its start; tau runs to 1/2
    for q in (half, half[::-1]):
        assert motion.duration(q, np.inf, 0.5) == pytest.approx(0.5 * np.sqrt(6 / 0.5))


def test_the_speed_at_the_very_end_counts():
    """At constant acceleration, q = s^2, the speed is 2 there and less at every sample before."""
    q = np.outer(np.linspace(0, 1, 11) ** 2, [1, 0, 0, 0, 0])
    assert motion.duration(q, 1.0, np.inf) == pytest.approx(2)
    assert motion.duration(q[::-1], 1.0, np.inf) == pytest.approx(2)


def test_in_the_shortest_time_a_limit_is_met_and_none_is_exceeded(rng):
    task = motion.line(A, B)(motion.quintic(np.linspace(0, 1, 500))[0])
    q = motion.follow(task, limits=UNLIMITED).q
    for _ in range(20):
        speeds, accelerations = rng.uniform(0.1, 3, (2, 5))
        T = motion.duration(q, speeds, accelerations)
        step = T / (len(q) - 1)
        shares = (
            (np.abs(np.diff(q, axis=0)) / step / speeds).max(),
            (np.abs(np.diff(q, 2, axis=0)) / step**2 / accelerations).max(),
        )
        assert max(shares) == pytest.approx(1, abs=1e-2)
        assert max(shares) <= 1 + 1e-9
        assert motion.duration(q, 2 * speeds, 4 * accelerations) == pytest.approx(T / 2)


@pytest.mark.committed_lengths
def test_towards_full_stretch_only_the_fourth_power_keeps_accelerations_finite():
    """theta_3 goes as the square root of the distance: with finer samples the others show their infinity."""

    def times(scaling, *limits):
        tau = (np.linspace(0, 1, n) for n in (501, 2001))
        samples = (polyline(TABLE_1_5[1:3])(scaling(x)[0]) for x in tau)
        return [motion.duration(motion.follow(task).q, *limits) for task in samples]

    for scaling, speed_grows, acceleration_grows in (
        (linear, True, True),
        (motion.quintic, False, True),
        (motion.to_stretch, False, False),
    ):
        coarse, fine = times(scaling, 1.0, np.inf)
        assert (fine > 1.5 * coarse) == speed_grows
        coarse, fine = times(scaling, np.inf, 1.0)
        assert (fine > 1.15 * coarse) == acceleration_grows


def test_what_stands_still_takes_no_time():
    assert motion.duration(np.tile(A, (4, 1)), 1, 1) == 0


@pytest.mark.parametrize(
    ("q", "speed", "acceleration", "error", "message"),
    [
        (
            np.where(np.arange(20)[:, None] > 17, np.nan, 0.0) * np.ones(5),
            1,
            1,
            InputError,
            "given in row 18",
        ),
        (np.zeros((3, 5)), 1, 1, InputError, "Four samples"),
        (np.zeros(5), 1, 1, InputError, r"of shape \(n, 5\)"),
        (np.zeros((9, 5)), np.ones((5, 1)), 1, InputError, "limit of speed is one positive number"),
        (np.zeros((9, 5)), 1, 1j, InputError, "Real numbers are expected for a limit of acceleration"),
        (np.zeros((9, 5)), 0, 1, InputError, "limit of speed is one positive number"),
        (np.zeros((9, 5)), 1, [1, 1, 1, np.nan, 1], InputError, "limit of acceleration is one positive number"),
        (
            np.where(np.arange(20)[:, None] > 7, 2.0, 0.0) * np.eye(5)[2],
            1,
            1,
            JumpError,
            "samples 7 and 8 joint 3",
        ),
    ],
)
def test_where_no_time_is_enough_it_says_why(q, speed, acceleration, error, message):
    with pytest.raises(error, match=message):
        motion.duration(q, speed, acceleration)
