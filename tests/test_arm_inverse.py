"""Laws of the Lynxmotion arm's inverse kinematics: every branch reaches, no branch is missing, limits are kept."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lynx_common import arm
from lynx_common.errors import InputError, JointLimitError, NotAchievableError, OutOfReachError

GEOMETRIES = [arm.LYNX, arm.Geometry(0.07, 0.3, 0.15, 0.0), arm.Geometry(0.0, 0.1, 0.25, 0.2)]
ROUNDING = 1e-7  # of angles near full stretch, where an error e of the wrist makes one of sqrt(e)
angle = st.floats(-np.pi, np.pi)


def chart(q, geometry=arm.LYNX):
    """Position, and pitch and roll as the front branches have them, of joint angles (..., 5)."""
    _, r, _, pitch, roll = np.moveaxis(arm.task_coordinates(q, geometry), -1, 0)
    behind = r < 0
    position = arm.forward_kinematics(q, geometry)[..., :3, 3]
    return position, np.where(behind, np.pi - pitch, pitch), np.where(behind, roll + np.pi, roll)


def apart(q, other):
    """Largest difference of two rows of angles, full turns aside."""
    return np.abs(np.mod(q - other + np.pi, 2 * np.pi) - np.pi).max(axis=-1)


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_every_branch_reaches_the_pose_and_one_of_them_is_where_it_came_from(geometry, rng):
    """FK(IK(x)) = x on all four branches of 100,000 poses, and IK(FK(q)) contains q."""
    q = rng.uniform(-np.pi, np.pi, (100_000, 5))
    branches = arm.inverse_kinematics(*chart(q, geometry), geometry=geometry)
    assert branches.shape == (100_000, 4, 5)
    difference = arm.forward_kinematics(branches, geometry) - arm.forward_kinematics(q, geometry)[:, None]
    assert np.abs(difference).max() < 1e-9
    assert apart(branches, q[:, None]).min(axis=-1).max() < ROUNDING


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_task_coordinates_of_joint_angles_are_the_task_itself(geometry, rng):
    """Also with r < 0 and angles beyond a turn: nothing is wrapped."""
    task = arm.task_coordinates(rng.uniform(-9, 9, (10_000, 5)), geometry)
    q = arm.joint_angles(task, geometry)
    np.testing.assert_allclose(arm.task_coordinates(q, geometry), np.stack([task, task], 1), atol=1e-9)


def test_joint_angles_contain_where_they_came_from_on_the_base_axis_too(rng):
    q = rng.uniform(-np.pi, np.pi, (10_000, 5))
    q[:5000, 1:4] = np.pi / 2, 0, np.pi / 2  # upright: gripper, its axis and wrist on the base axis
    q[:2500, 1] += rng.uniform(-1, 1, 2500)
    q[:2500, 3] -= q[:2500, 1] - np.pi / 2
    rows = arm.joint_angles(arm.task_coordinates(q))
    assert apart(rows, q[:, None]).min(axis=-1).max() < ROUNDING


def test_four_branches_are_different_away_from_the_singular_places(rng):
    q = rng.uniform(-np.pi, np.pi, (1000, 5))
    q = q[np.abs(np.sin(q[:, 2])) > 0.1]
    rows = arm.inverse_kinematics(*chart(q))
    for i in range(4):
        for j in range(i):
            assert (apart(rows[:, i], rows[:, j]) > 0.05).all()


def test_branches_are_named_for_what_they_look_like(rng):
    """Up has the higher elbow; front faces the target, back turns away from it."""
    q = rng.uniform(-np.pi, np.pi, (1000, 5))
    rows = arm.inverse_kinematics(*chart(q))
    height = arm.joint_positions(rows)[:, :, 2, 2]
    assert (height[:, 0] >= height[:, 1]).all()
    assert (height[:, 2] >= height[:, 3]).all()
    r = arm.task_coordinates(rows)[..., 1]
    assert (r[:, :2] >= 0).all()
    assert (r[:, 2:] <= 0).all()


def test_back_is_the_same_shape_as_front_with_the_base_turned_half_round(rng):
    rows = arm.inverse_kinematics(*chart(rng.uniform(-np.pi, np.pi, (1000, 5))))
    points = arm.joint_positions(rows)
    np.testing.assert_allclose(points[:, 2:], points[:, :2], atol=1e-12)
    np.testing.assert_allclose(apart(rows[:, 2:, :1], rows[:, :2, :1]), np.pi, atol=1e-12)


@pytest.mark.committed_lengths
def test_angles_lie_in_one_turn(rng):
    rows = arm.inverse_kinematics(*chart(rng.uniform(-9, 9, (10_000, 5))))
    assert (rows > -np.pi).all()
    assert (rows <= np.pi).all()
    half_turn = arm.inverse_kinematics([-0.3, 0.0, 0.2], 0.0, [np.pi, -np.pi])
    np.testing.assert_array_equal(half_turn[:, :2, [0, 4]], np.pi)


@pytest.mark.parametrize("geometry", GEOMETRIES)
@pytest.mark.parametrize("direction", [-1.2, 0.0, 0.4, np.pi / 2])
def test_reach_ends_where_the_arm_is_straight_or_folded(geometry, direction):
    """A hair inside, or on the boundary up to rounding, is reached; a little beyond is NaN."""
    d_1, L_1, L_2, L_3 = geometry
    for limit, beyond in ((L_1 + L_2, 1), (abs(L_1 - L_2), -1)):
        if limit == 0:
            continue  # equal links reach the shoulder itself

        def target(distance):
            along = np.array([np.cos(direction), 0, np.sin(direction)])
            return (distance + L_3) * along + [0, 0, d_1]

        for distance in (limit, limit * (1 + 1e-13), limit * (1 - 1e-13), limit * (1 - beyond * 1e-3)):
            q = arm.inverse_kinematics(target(distance), direction, 0.0, geometry=geometry)
            miss = arm.forward_kinematics(q, geometry)[:, :3, 3] - target(distance)
            assert np.abs(miss).max() < 1e-9
        assert np.isnan(
            arm.inverse_kinematics(target(limit * (1 + beyond * 1e-6)), direction, 0.0, geometry=geometry)
        ).all()


@pytest.mark.committed_lengths
def test_at_full_stretch_both_elbows_are_one():
    up, down = arm.inverse_kinematics([0.5, 0, 0.1], 0.0)[:2]  # report Table 1.4 b
    np.testing.assert_array_equal(up, down)


@pytest.mark.committed_lengths
def test_with_the_wrist_on_the_shoulder_the_pose_is_still_reached(rng):
    """The upper arm may then point anywhere: the rows are two of infinitely many."""
    pitch = rng.uniform(-np.pi, np.pi, 100)
    task = np.stack([0.3 + 0 * pitch, 0.1 * np.cos(pitch), 0.1 + 0.1 * np.sin(pitch), pitch, 0 * pitch], -1)
    np.testing.assert_allclose(arm.task_coordinates(arm.joint_angles(task)), np.stack([task] * 2, 1), atol=1e-9)


def test_on_the_base_axis_front_takes_azimuth_zero():
    rows = arm.inverse_kinematics([[0.0, 0, 0.4], [-0.0, -0.0, 0.4]], 0.3, 0.2)
    np.testing.assert_array_equal(rows[:, :2, 0], 0)
    np.testing.assert_array_equal(rows[:, 2:, 0], np.pi)
    np.testing.assert_allclose(
        arm.forward_kinematics(rows)[..., :3, 3], np.full((2, 4, 3), [0, 0, 0.4]), atol=1e-12
    )


@pytest.mark.parametrize("batch", [(), (1,), (0,), (3, 1, 2)])
def test_any_batch(batch, rng):
    q = rng.uniform(-np.pi, np.pi, (*batch, 5))
    assert arm.joint_angles(arm.task_coordinates(q)).shape == (*batch, 2, 5)
    assert arm.inverse_kinematics(*chart(q)).shape == (*batch, 4, 5)


def test_position_pitch_and_roll_broadcast(rng):
    rows = arm.inverse_kinematics(rng.uniform(0.1, 0.2, (4, 1, 3)), rng.uniform(size=(1, 3)), 0.1)
    assert rows.shape == (4, 3, 4, 5)


@pytest.mark.filterwarnings("error")
def test_bad_numbers_never_give_a_plausible_answer():
    assert np.isnan(arm.inverse_kinematics([[np.nan, 0, 0.3], [np.inf, 0, 0.3]], 0.0)).all()
    assert np.isnan(arm.inverse_kinematics([0.2, 0.2, 0.3], [np.nan, np.inf])).all()
    assert np.isnan(arm.joint_angles([0, np.nan, 0.3, 0, 0])).all()
    for position, pitch in ([[0.2, 0.3], 0.0], [[0.2, 0.2, 0.3j], 0.0], [[0.2, 0.2, 0.3], 1j]):
        with pytest.raises(InputError):
            arm.inverse_kinematics(position, pitch)
    with pytest.raises(InputError):
        arm.joint_angles(np.zeros(4))


@given(st.tuples(*[angle] * 5).map(np.array))
def test_within_limits_counts_full_turns_out(q):
    inside = ((arm.JOINT_LIMITS[:, 0] <= q) & (q <= arm.JOINT_LIMITS[:, 1])).all()
    turns = np.array([2, -2, 4, 0, -6]) * np.pi
    assert arm.within_limits(q) == arm.within_limits(q + turns)
    if inside:
        assert arm.within_limits(q)


def test_within_limits_at_the_limits_and_beyond():
    middle = arm.JOINT_LIMITS.mean(axis=1)
    for joint, (lower, upper) in enumerate(arm.JOINT_LIMITS):
        for value in (lower, upper, lower + 2 * np.pi):
            assert arm.within_limits(np.where(np.arange(5) == joint, value, middle))
        if upper - lower < 6:
            for value in (lower - 0.01, upper + 0.01):
                assert not arm.within_limits(np.where(np.arange(5) == joint, value, middle))
    assert not arm.within_limits([np.nan] * 5)
    assert arm.within_limits(np.zeros((2, 0, 5))).shape == (2, 0)


@pytest.mark.parametrize(("beyond", "allowed"), [(1e-10, True), (1e-7, False)])
def test_room_at_a_limit_is_for_rounding_only(beyond, allowed):
    for joint, (lower, upper) in enumerate(arm.JOINT_LIMITS):
        if upper - lower > 6.28:
            continue  # a full turn has no outside
        for angle in (lower - beyond, upper + beyond):
            q = arm.JOINT_LIMITS.mean(axis=1)
            q[joint] = angle
            assert arm.within_limits(q) == allowed


def test_a_wrist_bent_back_is_within_limits_a_turn_later():
    """theta_4 = -170 deg is 190 deg, which the wrist can take; `solve` gives it so."""
    q = np.pi / 180 * np.array([0, 90, 60, -170, 0])
    assert arm.within_limits(q)
    position, pitch, roll = chart(q)
    branch = apart(arm.inverse_kinematics(position, pitch, roll), q).argmin()
    found = arm.solve(position, pitch, roll, int(branch))
    assert (arm.JOINT_LIMITS[:, 0] <= found).all()
    assert (found <= arm.JOINT_LIMITS[:, 1]).all()
    np.testing.assert_allclose(arm.forward_kinematics(found)[:3, 3], position, atol=1e-12)


@pytest.mark.committed_lengths
def test_solve_says_how_far_a_target_is_out_of_reach():
    with pytest.raises(OutOfReachError, match=r"wrist would be 0\.6403 m from the shoulder") as error:
        arm.solve([0.5, 0.4, 0.2], np.pi / 2)
    assert (error.value.nearest, error.value.farthest) == (0.0, 0.4)
    assert error.value.distance > 0.4


@pytest.mark.committed_lengths
def test_solve_names_the_joint_that_leaves_its_limits():
    with pytest.raises(
        JointLimitError, match=r"Joint 2 would stand at -\d+\.\d+ deg, outside .* 0 to 180 deg"
    ) as error:
        arm.solve([0.3, 0, -0.1], 0.0, branch=1)
    assert error.value.joint == 2
    assert error.value.limits == tuple(arm.JOINT_LIMITS[1])
    assert error.value.value == pytest.approx(arm.inverse_kinematics([0.3, 0, -0.1], 0.0)[1, 1])


@pytest.mark.parametrize(
    ("position", "pitch", "branch"),
    [
        ([0.2, 0.2, 0.3], np.nan, 0),
        ([[0.2, 0.2, 0.3]], 0.0, 0),
        ([0.2, 0.2, 0.3], [0, 1], 0),
        ([0.2, 0.2, 0.3], 0.0, 4),
    ],
)
def test_solve_takes_one_finite_target_and_a_branch_that_exists(position, pitch, branch):
    with pytest.raises(InputError):
        arm.solve(position, pitch, branch=branch)


def test_task_of_pose_is_the_front_chart_of_every_pose_that_the_arm_takes(rng):
    q = rng.uniform(-np.pi, np.pi, (500, 5))
    for T, position, pitch, roll in zip(arm.forward_kinematics(q), *chart(q), strict=True):
        azimuth, r, z, p, rho = arm.task_of_pose(T)
        np.testing.assert_allclose([r * np.cos(azimuth), r * np.sin(azimuth), z], position, atol=1e-12)
        assert r >= 0
        np.testing.assert_allclose(
            np.exp(1j * np.array([p, rho])), np.exp(1j * np.array([pitch, roll])), atol=1e-9
        )


def test_the_report_s_target_is_taken_with_its_orientation():
    """R = I at (0.2, 0.2, 0.3), which report Fig. 1.5 misses by 0.1 m."""
    T = np.eye(4)
    T[:3, 3] = 0.2, 0.2, 0.3
    q = arm.joint_angles(arm.task_of_pose(T))
    np.testing.assert_allclose(arm.forward_kinematics(q), [T, T], atol=1e-12)


def test_on_the_base_axis_the_azimuth_is_the_gripper_s_own_and_zero_for_an_upright_one():
    for q in ([0.7, np.pi / 2, 0.0, 1.0, 0.3], [0.7, np.pi / 2, 0.0, np.pi / 2, 0.3]):
        shifted = arm.forward_kinematics(q)
        shifted[:2, 3] = 0
        task = arm.task_of_pose(shifted)
        assert task[1] == 0
        again = arm.forward_kinematics(np.concatenate([[task[0]], [0, 0], [task[3] + np.pi / 2], [task[4]]]))
        np.testing.assert_allclose(again[:3, :3], shifted[:3, :3], atol=1e-12)


def test_a_tenth_of_a_micrometre_beside_the_base_axis_has_an_azimuth_of_its_own():
    """The gripper points back over the axis there, so that the two possible azimuths are opposite."""
    task = np.array([0.7, 1e-7, 0.3, 2.8, 0.2])
    for q in arm.joint_angles(task):
        found = arm.task_of_pose(arm.forward_kinematics(q))
        np.testing.assert_allclose(found, task, atol=1e-8)


@pytest.mark.parametrize("leaves", [0.3, -0.02, 1e-4])
def test_a_pose_that_five_joints_cannot_take_says_by_which_angle(leaves):
    """The gripper turned out of the arm's plane about the vertical direction in which it is seen."""
    T = arm.forward_kinematics([0.4, 0.8, -0.5, 1.2, 0.4])
    outward = np.array([np.cos(0.4), np.sin(0.4), 0])
    left = np.array([-np.sin(0.4), np.cos(0.4), 0])
    lift = np.cross(left, T[:3, 2])  # at right angles to the gripper's axis, in the arm's plane
    c, s = np.cos(leaves), np.sin(leaves)
    turn = np.array([T[:3, 2], left, lift]).T @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    T[:3, :3] = turn @ np.array([T[:3, 2], left, lift]) @ T[:3, :3]
    with pytest.raises(NotAchievableError, match=f"{np.rad2deg(leaves):.2f} deg") as error:
        arm.task_of_pose(T)
    assert error.value.angle == pytest.approx(leaves)
    assert abs(np.cross(T[:3, 3], T[:3, 2])[2]) == pytest.approx(abs(np.sin(leaves)) * (T[:3, 3] @ outward))


@pytest.mark.parametrize(
    "bad",
    [
        np.eye(3),
        2 * np.eye(4),
        np.diag([1.0, 1, -1, 1]),
        np.full((4, 4), np.nan),
        np.eye(4) * (1 + 0j),
        np.ones((4, 4)),
    ],
)
def test_what_is_not_a_pose_is_refused(bad):
    with pytest.raises(InputError, match=r"A pose is expected|of a pose must be|expected for a pose"):
        arm.task_of_pose(bad)
