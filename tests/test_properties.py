"""Laws that hold for every input, looked for in places that nobody thought of; hypothesis chooses the examples."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from lynx_common import arm, certify, motion, obstacles, rrr, screws

few = settings(max_examples=15)


def numbers(low: float, high: float, n: int) -> st.SearchStrategy[np.ndarray]:
    """Arrays (n,), with the hard places: the ends, zero, and quarter turns."""
    special = [x for x in (low, high, 0.0, np.pi / 2, -np.pi / 2, np.pi, -np.pi) if low <= x <= high]
    return st.tuples(*[st.sampled_from(special) | st.floats(low, high)] * n).map(np.array)


configurations = numbers(-2 * np.pi, 2 * np.pi, 5)
lengths = st.tuples(*[st.floats(0.02, 2)] * 4).map(lambda p: arm.Geometry(*p))
poses = numbers(-1, 1, 3).map(lambda x: x * [200, 200, np.pi])
near_poses = numbers(-1, 1, 3).map(lambda x: x * [60, 60, 0.7])  # most of which all legs reach
modes = st.integers(0, 7)
shares = numbers(0, 1, 9).map(np.sort)


def turned(angle: float) -> np.ndarray:
    """A rotation about z, (4, 4)."""
    T = np.eye(4)
    T[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    return T


def same_angles(a: np.ndarray, b: np.ndarray, within: float) -> np.ndarray:
    """Whether angles are equal but for full turns, all along the last axis."""
    return (np.abs(np.exp(1j * np.asarray(a)) - np.exp(1j * np.asarray(b))) <= within).all(axis=-1)


# The arm.


@few
@given(configurations, lengths)
def test_both_elbows_of_what_a_posture_reaches_reach_it(q, geometry):
    found = arm.joint_angles(arm.task_coordinates(q, geometry), geometry)
    pose = arm.forward_kinematics(q, geometry)
    np.testing.assert_allclose(arm.forward_kinematics(found, geometry), [pose, pose], atol=1e-7)


@few
@given(configurations, lengths)
def test_a_posture_is_among_its_own_inverse_kinematics(q, geometry):
    _, L_1, L_2, _ = geometry
    assume(abs(np.sin(q[2])) > 1e-4)  # nearly stretched or folded, rounding moves the elbow by its square root
    found = arm.joint_angles(arm.task_coordinates(q, geometry), geometry)
    folded = np.hypot(L_1 + L_2 * np.cos(q[2]), L_2 * np.sin(q[2])) / (L_1 + L_2)
    assume(folded > 1e-3)  # the wrist at the shoulder: theta_2 is free
    assert same_angles(found, q, 1e-6).any()


@few
@given(numbers(-0.5, 0.5, 3), numbers(-np.pi, np.pi, 2))
def test_every_branch_reaches_position_and_pitch_or_says_nan(position, angles):
    q = arm.inverse_kinematics(position, *angles)
    finite = np.isfinite(q).all(axis=-1)
    assert (finite == np.isfinite(q).any(axis=-1)).all()
    pose = arm.forward_kinematics(q[finite])
    np.testing.assert_allclose(pose[:, :3, 3], np.broadcast_to(position, (finite.sum(), 3)), atol=1e-8)
    np.testing.assert_allclose(pose[:, 2, 2], np.sin(angles[0]), atol=1e-8)
    if finite.any():
        np.testing.assert_allclose(pose, np.broadcast_to(pose[0], pose.shape), atol=1e-7)


@few
@given(configurations, st.floats(-7, 7), lengths)
def test_turning_the_base_turns_the_robot(q, angle, geometry):
    moved = q + [angle, 0, 0, 0, 0]
    expected = turned(angle) @ arm.forward_kinematics(q, geometry)
    np.testing.assert_allclose(arm.forward_kinematics(moved, geometry), expected, atol=1e-12)


@few
@given(configurations, numbers(-1, 1, 5), lengths)
def test_the_jacobian_is_the_derivative_of_the_pose(q, q_dot, geometry):
    h = 1e-5
    after, before = (arm.forward_kinematics(q + sign * h * q_dot, geometry) for sign in (1, -1))
    change = (after - before) / (2 * h)
    spin = change[:3, :3] @ arm.forward_kinematics(q, geometry)[:3, :3].T
    expected = [*change[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]]
    np.testing.assert_allclose(arm.jacobian(q, geometry) @ q_dot, expected, atol=1e-7)


@few
@given(configurations, configurations, numbers(-0.5, 0.5, 3), st.floats(0, 0.3), st.floats(0, 0.05))
def test_clearance_changes_no_faster_than_its_lipschitz_constant(p, q, centre, radius, link_radius):
    sphere = obstacles.Sphere(tuple(centre), radius)
    a, b = obstacles.clearance(np.array([p, q]), sphere, link_radius=link_radius)
    assert abs(a - b) <= obstacles.lipschitz_constant() * np.linalg.norm(p - q) + 1e-12


@few
@given(configurations, numbers(-0.6, 0.6, 3))
def test_clearance_is_that_of_the_nearest_point_of_the_links(q, centre):
    points, share = arm.joint_positions(q), np.linspace(0, 1, 201)[:, None, None]
    nearest = obstacles.Sphere(tuple(centre), 0.1).distance((1 - share) * points[:-1] + share * points[1:]).min()
    found = obstacles.clearance(q, obstacles.Sphere(tuple(centre), 0.1))
    assert nearest - 5e-4 <= found <= nearest + 1e-12  # samples are 1 mm apart, at most


@few
@given(configurations, configurations, numbers(-0.5, 0.5, 3), st.floats(0, 0.3))
def test_no_sample_of_a_motion_is_nearer_than_its_certificate(p, q, centre, minimum):
    def f(q):
        return obstacles.clearance(q, obstacles.Sphere(tuple(centre), 0.1))

    found = certify.along(f, obstacles.lipschitz_constant(), [p, q], minimum - 0.1, budget=3000)
    between = f(p + np.linspace(0, 1, 201)[:, None] * (q - p))
    assert between.min() >= found.bound
    assert found.verdict != "certified" or between.min() >= minimum - 0.1
    if found.verdict == "refuted":
        assert f(found.witness[None])[0] < minimum - 0.1


# The 3-RRR.


@few
@given(near_poses | poses)
def test_every_leg_that_closes_has_its_lengths(pose):
    theta = rrr.inverse_kinematics(pose)
    assert np.isfinite(theta).all() == rrr.reachable(pose)
    distal = np.linalg.norm(rrr.platform_joints(pose) - rrr.elbows(theta), axis=-1)
    driven = np.linalg.norm(rrr.elbows(theta) - rrr.base_joints(), axis=-1)
    closes = np.isfinite(theta)
    sines = np.diagonal(rrr.jacobians(pose, theta)[1], axis1=-2, axis2=-1) / (rrr.RRR.S_A * rrr.RRR.L)
    known = np.isfinite(sines)  # where all three close
    assert (sines[known] * np.array(rrr.WORKING_MODES)[known] >= -1e-5).all()
    np.testing.assert_allclose(distal[closes], rrr.RRR.L, atol=1e-4)  # stretched: REACH_TOLERANCE's square root
    np.testing.assert_allclose(driven[closes], rrr.RRR.S_A, atol=1e-9)


@few
@given(near_poses, modes)
def test_a_pose_is_among_its_own_forward_kinematics(pose, mode):
    theta = rrr.inverse_kinematics(pose)[mode]
    assume(np.isfinite(theta).all())
    A, _ = rrr.jacobians(pose, theta)
    assume(abs(np.linalg.det(A / [130, 130, 130**2])) > 1e-3)  # where det A = 0 two poses meet
    found = rrr.forward_kinematics(theta)
    near = np.abs(found[:, :2] - pose[:2]).max(axis=1) <= 1e-5
    assert (near & same_angles(found[:, 2:], pose[2:], 1e-7)).any()
    assert np.linalg.norm(rrr.assemble(theta, pose)[:2] - pose[:2]) <= 1e-5


@few
@given(poses, modes)
def test_a_third_of_a_turn_renames_the_legs(pose, mode):
    """The robot looks the same after 120 deg; leg 1 then stands where leg 2 stood."""
    third = 2 * np.pi / 3
    other = np.append(turned(third)[:2, :2] @ pose[:2], pose[2])
    renamed = rrr.WORKING_MODES.index(tuple(np.roll(rrr.WORKING_MODES[mode], 1)))
    theta, moved = rrr.inverse_kinematics(pose)[mode], rrr.inverse_kinematics(other)[renamed]
    expected = np.roll(theta, 1) + third
    assert (np.isfinite(moved) == np.isfinite(expected)).all()
    closes = np.isfinite(moved)
    assert same_angles(moved[closes], expected[closes], 1e-6)


@few
@given(near_poses, modes, numbers(-1, 1, 3))
def test_a_and_b_tie_the_velocities_of_motors_and_platform(pose, mode, direction):
    x_dot, h = direction * [100, 100, 1], 1e-6
    steps = pose + h * np.outer([-1, 0, 1], x_dot)
    before, theta, after = rrr.inverse_kinematics(steps)[:, mode]
    A, B = rrr.jacobians(pose, theta)
    sines = np.diagonal(B) / (rrr.RRR.S_A * rrr.RRR.L)
    assume(np.isfinite([before, after]).all())
    assume(np.abs(sines).min() > 0.05)  # where a leg is stretched theta has no derivative
    theta_dot = np.angle(np.exp(1j * (after - before))) / (2 * h)
    np.testing.assert_allclose(A @ x_dot, B @ theta_dot, atol=0.5)  # of some 10,000 mm^2/s


# Screws.

sixes = numbers(-3, 3, 6)
motions = sixes.map(screws.exp)
systems = st.lists(st.lists(st.integers(-2, 2), min_size=6, max_size=6), min_size=1, max_size=7)


@few
@given(sixes)
def test_half_a_motion_twice_is_the_motion_and_the_opposite_twist_undoes_it(twist):
    T = screws.exp(twist)
    np.testing.assert_allclose(screws.exp(twist / 2) @ screws.exp(twist / 2), T, atol=1e-11)
    np.testing.assert_allclose(screws.exp(-twist) @ T, np.eye(4), atol=1e-10)


@few
@given(motions, motions, sixes, sixes)
def test_a_change_of_frame_moves_screws_and_keeps_the_power(S, T, twist, wrench):
    """And two changes are one: their matrices multiply as the motions do."""
    moved = screws.adjoint(T) @ twist
    np.testing.assert_allclose(screws.exp(moved), T @ screws.exp(twist) @ np.linalg.inv(T), atol=1e-9)
    there = screws.adjoint(np.linalg.inv(T)).T @ wrench
    power = screws.reciprocal_product(twist, wrench)
    assert screws.reciprocal_product(moved, there) == pytest.approx(power, abs=1e-9)
    np.testing.assert_allclose(screws.adjoint(S @ T), screws.adjoint(S) @ screws.adjoint(T), atol=1e-10)


@few
@given(sixes)
def test_a_twist_is_its_line_pitch_and_magnitude(twist):
    assume(twist.any())
    line = screws.screw_axis(twist)
    assert np.linalg.norm(line.axis) == pytest.approx(1)
    assert abs(line.axis @ line.point) <= 1e-9 * (1 + np.linalg.norm(line.point))
    slides = np.isinf(line.pitch)
    assert slides == (np.linalg.norm(twist[3:]) <= 1e-12 * np.linalg.norm(twist[:3]))
    again = screws.prismatic(line.axis) * (1 if slides else line.pitch)
    again = again if slides else again + screws.revolute(line.axis, line.point)
    np.testing.assert_allclose(line.magnitude * again, twist, atol=1e-9)


@few
@given(sixes, numbers(-3, 3, 3), numbers(-3, 3, 3))
def test_the_power_of_a_force_is_that_on_the_point_it_acts_on(twist, direction, point):
    assume(np.linalg.norm(direction) > 0.1)
    axis = direction / np.linalg.norm(direction)
    velocity = twist[:3] + np.cross(twist[3:], point)
    power = screws.reciprocal_product(twist, screws.force(axis, point))
    assert power == pytest.approx(velocity @ axis, abs=1e-9)


@few
@given(systems.map(lambda columns: np.array(columns, float).T), motions)
def test_twists_and_the_wrenches_that_do_no_work_on_them_are_six_together_in_any_frame(twists, T):
    wrenches = screws.reciprocal_system(twists)
    rank = np.linalg.matrix_rank(twists)
    assert screws.order(twists) == screws.order(screws.adjoint(T) @ twists) == rank
    assert wrenches.shape == (6, 6 - rank)
    assert np.linalg.matrix_rank(wrenches) == 6 - rank
    np.testing.assert_allclose(twists.T @ wrenches, 0, atol=1e-9)


# Motion.

SCALINGS = [
    motion.cubic,
    motion.quintic,
    motion.from_stretch,
    motion.to_stretch,
    motion.trapezoidal,
]
tasks = numbers(-1, 1, 5).map(lambda x: x * [2, 0.4, 0.4, 3, 3])


@pytest.mark.parametrize("scaling", SCALINGS)
@few
@given(shares)
def test_a_scaling_goes_from_0_to_1_and_never_back(scaling, tau):
    s, s_dot, _ = scaling(tau)
    np.testing.assert_allclose(np.append(scaling(0.0)[0], scaling(1.0)[0]), [0, 1], atol=1e-12)
    assert (np.diff(s) >= -1e-12).all()
    assert (s_dot >= -1e-12).all()
    h = 1e-4
    corners = np.array([0, 0.25, 0.75, 1])[:, None]
    smooth = tau[(np.abs(tau - corners) > h).all(axis=0)]
    before, at, after = (np.array(scaling(smooth + step)) for step in (-h, 0, h))
    np.testing.assert_allclose((after - before)[:2] / (2 * h), at[1:], atol=1e-5)


@few
@given(numbers(0, 1, 5), numbers(0, 1, 5), st.sampled_from(["cubic", "quintic"]))
def test_what_follows_a_path_is_on_it_and_within_limits(a, b, scaling):
    """Between two postures that the arm may take; the line between them may still lead out of reach."""
    lower, upper = arm.JOINT_LIMITS.T
    start, end = (arm.task_coordinates(lower + x * (upper - lower)) for x in (a, b))
    assume((start != end).any())
    s, *_ = getattr(motion, scaling)(np.linspace(0, 1, 60))
    task = motion.line(start, end)(s)
    found = motion.follow(task)
    good = found.reached & found.allowed & found.continuous
    assert found.ok == good.all()
    assert (np.isfinite(found.q).all(axis=1) == good).all()
    there = arm.task_coordinates(found.q[good])
    np.testing.assert_allclose(there[:, 1:3], task[good, 1:3], atol=1e-8)
    assert same_angles(there[:, [0, 3, 4]], task[good][:, [0, 3, 4]], 1e-8).all()
    assert ((found.q[good] >= lower - 1e-8) & (found.q[good] <= upper + 1e-8)).all()
    if found.ok:
        assert np.abs(np.diff(found.q, axis=0)).max() <= np.pi / 2


@few
@given(numbers(0, 1, 5), numbers(0, 1, 5))
def test_a_motion_that_exists_is_found_or_a_shorter_one(a, b):
    """The path of a straight motion in joint space, within limits and on one elbow, can be followed."""
    b[2] = b[2] if (a[2] < 0.5) == (b[2] < 0.5) else 1 - b[2]
    assume(min(abs(a[2] - 0.5), abs(b[2] - 0.5)) > 1e-3)
    lower, upper = arm.JOINT_LIMITS.T
    q = lower + (a + np.linspace(0, 1, 60)[:, None] * (b - a)) * (upper - lower)
    found = motion.follow(arm.task_coordinates(q))
    assert found.ok
    travelled, straight = (np.linalg.norm(np.diff(x, axis=0), axis=1).sum() for x in (found.q, q))
    assert travelled <= straight + 1e-6


@few
@given(numbers(-1, 1, 5), numbers(-1, 1, 5), st.floats(0.1, 10), st.floats(0.1, 10))
def test_steady_acceleration_from_rest_takes_the_time_that_it_takes(start, change, speed, acceleration):
    q = start + np.linspace(0, 1, 20)[:, None] ** 2 * change
    most = 2 * np.abs(change).max()
    expected = max(most / speed, np.sqrt(most / acceleration))
    assert motion.duration(q, speed, acceleration) == pytest.approx(expected, abs=1e-6)


@few
@given(numbers(-1, 1, 5), numbers(-1, 1, 5), st.floats(0.1, 10))
def test_a_motion_k_times_as_fast_takes_a_kth_of_the_time(start, end, k):
    s, *_ = motion.quintic(np.linspace(0, 1, 50))
    q = start + s[:, None] * (end - start)
    T = motion.duration(q, 1.0, 2.0)
    assert motion.duration(q, k * 1.0, k**2 * 2.0) == pytest.approx(T / k)
    assert motion.duration(q[::-1], 1.0, 2.0) == pytest.approx(T)
