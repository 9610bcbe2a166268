"""The planar 3-RRR robot: its legs close, its kinematics undo each other, its Jacobians are derivatives."""

import warnings
from itertools import combinations, pairwise

import numpy as np
import pytest

from lynx_common import rrr
from lynx_common.errors import AssemblyError, GeometryError, InputError, NoPoseError, SelfMotionError

OTHER = rrr.Geometry(120, 150, 60, 250, (0.1, 2.0, 4.5), (-0.2, 2.4, 4.0))
LONG_DISTAL = rrr.Geometry(100, 100, 80, 160, platform_angles=(1.2, 3.3, 5.6))
ROBOTS = pytest.mark.parametrize("geometry", [rrr.RRR, OTHER, LONG_DISTAL], ids=["report", "other", "equal links"])
# The elbows lie as the platform's joints do, 130 mm from the origin: the platform travels on a circle.
TURN = np.arccos((290**2 + 130**2 - 170**2) / (2 * 290 * 130))
FREE = np.mod(
    np.array(rrr.RRR.base_angles) + np.pi - np.arccos((290**2 + 170**2 - 130**2) / (2 * 290 * 170)), 2 * np.pi
)
# r_base = S_A + L + r_platform: at the origin all legs are straight, along lines through C.
STRETCHED = np.array(rrr.RRR.base_angles) - np.pi, rrr.Geometry(100, 60, 50, 210)


def poses(rng, n, geometry=rrr.RRR):
    """``n`` poses at which the robot can be assembled."""
    reach = geometry.r_base + geometry.r_platform + geometry.S_A + geometry.L
    found = np.empty((0, 3))
    while len(found) < n:
        pose = rng.uniform(-1, 1, (20 * n, 3)) * [reach / 2, reach / 2, np.pi]
        found = np.vstack([found, pose[rrr.reachable(pose, geometry)]])
    return found[:n]


def with_modes(rng, n, geometry=rrr.RRR):
    pose = poses(rng, n, geometry)
    return pose, rrr.inverse_kinematics(pose, geometry)[np.arange(n), rng.integers(0, 8, n)]


def misses(pose, theta, geometry=rrr.RRR):
    """How far each distal link is from its length."""
    M = rrr.elbows(theta, geometry)
    return np.abs(np.linalg.norm(rrr.platform_joints(pose, geometry) - M, axis=-1) - geometry.L)


def apart(a, b):
    """Largest difference of poses, alpha modulo full turns."""
    off = np.abs(a - b)
    off[..., 2] = np.minimum(off[..., 2], 2 * np.pi - off[..., 2])
    return off.max(axis=-1)


# The robot


def test_the_joints_of_the_report_are_where_its_tables_put_them():
    side = 290 * np.sqrt(3) / 2
    np.testing.assert_allclose(rrr.base_joints(), [[0, 290], [-side, -145], [side, -145]], atol=1e-12)
    joints = rrr.platform_joints([10, 20, np.pi / 2])
    np.testing.assert_allclose(joints, 130 * np.array([[-1, 0], [0.5, -(0.75**0.5)], [0.5, 0.75**0.5]]) + [10, 20])
    np.testing.assert_allclose(rrr.elbows([0, np.pi / 2, np.pi])[:, 0], [170, -side, side - 170], atol=1e-12)


@pytest.mark.parametrize("name", ["S_A", "L", "r_platform", "r_base"])
@pytest.mark.parametrize("value", [0, -1, np.nan, np.inf, "130", 1j, None, np.complex128(3)])
def test_a_length_is_a_positive_number(name, value):
    with pytest.raises(GeometryError, match=f"{name} is"):
        rrr.Geometry(**{name: value})


@pytest.mark.parametrize("angles", [(0, 1), (0, 1, np.nan), 3, (1j, 2, 3)])
@pytest.mark.parametrize("name", ["base_angles", "platform_angles"])
def test_angles_of_joints_are_three_finite_numbers(name, angles):
    with pytest.raises(GeometryError, match=name):
        rrr.Geometry(**{name: angles})


@pytest.mark.parametrize(
    ("lengths", "closes"),
    [
        ((50, 50, 130, 290), False),  # too short: the nearest pose leaves 160 mm, the legs span 100
        ((50, 109, 130, 290), False),
        ((50, 110.1, 130, 290), True),
        ((10, 500, 10, 290), False),  # about 500 mm from three points on a circle of 290
        ((10, 10, 100, 110), True),
    ],
)
def test_a_robot_that_closes_no_loop_is_refused(lengths, closes):
    if closes:
        assert tuple(rrr.Geometry(*lengths))[:4] == lengths
    else:
        with pytest.raises(GeometryError, match="no pose lets all three close"):
            rrr.Geometry(*lengths)


def test_a_robot_that_closes_at_one_angle_only_is_not_refused():
    """All legs stretched towards the centre, at an alpha between those that are tried."""
    off = np.deg2rad(0.2)
    geometry = rrr.Geometry(100, 60, 50, 210, platform_angles=tuple(np.array(rrr.RRR.platform_angles) + off))
    assert rrr.reachable([0, 0, -off], geometry)


def test_no_robot_that_closes_is_refused(rng):
    """Random robots that close at one pose at least, where legs are stretched or folded."""
    for _ in range(200):
        S_A, L, r_platform = rng.uniform(20, 200, 3)
        gamma = rng.uniform(-np.pi, np.pi, 3)
        C, alpha = rng.uniform(-100, 100, 2), rng.uniform(-np.pi, np.pi)
        PP = C + r_platform * np.c_[np.cos(alpha + gamma), np.sin(alpha + gamma)]
        r_base = 300.0
        span = np.where(rng.random(3) < 0.5, S_A + L, abs(S_A - L))
        away = np.linalg.norm(PP, axis=1)
        cosine = (away**2 + r_base**2 - span**2) / (2 * away * r_base)
        if np.abs(cosine).max() < 1:
            beta = np.arctan2(PP[:, 1], PP[:, 0]) + np.arccos(cosine)
            geometry = rrr.Geometry(S_A, L, r_platform, r_base, tuple(beta), tuple(gamma))
            np.testing.assert_allclose(rrr.leg_lengths([*C, alpha], geometry), span, atol=1e-9)


def test_rings_that_coincide_do_not_hide_the_others():
    assert rrr.reachable([50, 0, 0], rrr.Geometry(100, 50, 30, 30))


# Inverse kinematics


def test_working_modes_are_listed_with_plus_first():
    assert rrr.WORKING_MODES[:3] == ((1, 1, 1), (1, 1, -1), (1, -1, 1))
    assert len(set(rrr.WORKING_MODES)) == 8


@ROBOTS
def test_every_finite_angle_closes_its_leg_on_the_side_of_its_mode(rng, geometry):
    pose = np.vstack([poses(rng, 10_000, geometry), rng.uniform(-400, 400, (2000, 3)) * [1, 1, 0.005]])
    theta = rrr.inverse_kinematics(pose, geometry)
    assert theta.shape == (12_000, 8, 3)
    finite = np.isfinite(theta)
    assert misses(pose[:, None], theta, geometry)[finite].max() < 1e-9
    assert finite[:10_000].all()
    assert np.abs(theta[finite]).max() <= np.pi
    M = rrr.elbows(theta, geometry)
    proximal, distal = M - rrr.base_joints(geometry), rrr.platform_joints(pose, geometry)[:, None] - M
    sign = np.sign(proximal[..., 0] * distal[..., 1] - proximal[..., 1] * distal[..., 0])
    expected = np.broadcast_to(rrr.WORKING_MODES, sign.shape)
    np.testing.assert_array_equal(sign[finite], expected[finite])


@ROBOTS
def test_a_leg_is_nan_exactly_where_it_is_too_long_or_too_short(rng, geometry):
    pose = rng.uniform(-400, 400, (5000, 3)) * [1, 1, 0.007]
    length = np.linalg.norm(rrr.platform_joints(pose, geometry) - rrr.base_joints(geometry), axis=-1)
    np.testing.assert_allclose(rrr.leg_lengths(pose, geometry), length, rtol=1e-12)
    closes = (length >= abs(geometry.S_A - geometry.L)) & (length <= geometry.S_A + geometry.L)
    theta = rrr.inverse_kinematics(pose, geometry)
    np.testing.assert_array_equal(np.isfinite(theta), np.repeat(closes[:, None], 8, axis=1))
    np.testing.assert_array_equal(rrr.reachable(pose, geometry), closes.all(axis=-1))


@pytest.mark.parametrize("span", [300, 40])
def test_a_leg_that_is_stretched_or_folded_still_closes(span):
    """Leg 1 along the y axis at its two ends, up to rounding; a nanometre beyond does not close."""
    at = np.array([0, 290 - span - 130, 0.0])
    theta = rrr.inverse_kinematics(at)[:, 0]
    np.testing.assert_allclose(theta, -np.pi / 2, atol=1e-6)
    beyond = at - [0, np.sign(span - 100) * 1e-7, 0]
    assert np.isnan(rrr.inverse_kinematics(beyond)[:, 0]).all()


def test_rounding_does_not_open_a_stretched_leg():
    direction = np.linspace(-np.pi, 0, 400)
    at = np.c_[300 * np.cos(direction), 160 + 300 * np.sin(direction), np.zeros(400)]
    assert np.isfinite(rrr.inverse_kinematics(at)[..., 0]).all()


def test_where_platform_and_base_joint_meet_equal_links_close_at_any_angle():
    pose = np.array([0, 160 - 80 * np.sin(1.2), 0]) - [80 * np.cos(1.2), 0, 0]
    theta = rrr.inverse_kinematics(pose, LONG_DISTAL)[:, 0]
    assert misses(pose, np.array([theta[0], 0, 0]), LONG_DISTAL)[0] < 1e-9
    small = rrr.Geometry(100, 100, 40, 50)
    assert rrr.reachable([0, 10, 0], small)
    assert rrr.leg_lengths([0, 10, 0], small)[0] < 1e-9


def test_one_target_one_mode_or_a_sentence():
    pose = np.array([0, 100, 0])
    theta = rrr.solve(pose, 3)
    np.testing.assert_allclose(theta, rrr.inverse_kinematics(pose)[3], rtol=1e-14)
    with pytest.raises(AssemblyError, match=r"leg 1 would span 31.25 mm and leg 3 would span 303.46 mm") as caught:
        rrr.solve([50, 150, np.pi / 6])
    assert caught.value.legs == [1, 3]
    assert (caught.value.nearest, caught.value.farthest) == (40, 300)


# Forward kinematics


@ROBOTS
def test_forward_kinematics_finds_the_pose_that_gave_the_angles(rng, geometry):
    n = 10_000 if geometry == rrr.RRR else 3000
    pose, theta = with_modes(rng, n, geometry)
    found = rrr.forward_kinematics(theta, geometry)
    assert found.shape == (n, 6, 3)
    assert np.nanmin(apart(found, pose[:, None]), axis=1).max() < 1e-6
    assert np.nanmax(misses(found, theta[:, None], geometry)) < 1e-8
    count = np.isfinite(found[..., 0]).sum(axis=1)
    assert set(count) <= {2, 4, 6}
    assert (np.diff(found[..., 2], axis=1)[np.isfinite(found[:, 1:, 2])] >= -1e-9).all()
    assert np.isfinite(found).all(axis=-1).sum() == count.sum()


@ROBOTS
def test_forward_kinematics_finds_what_newton_finds_from_many_starts(rng, geometry):
    """An independent search: plain Newton on the loop closure with a Jacobian by differences."""
    _, theta = with_modes(rng, 6, geometry)
    for angles, found in zip(theta, rrr.forward_kinematics(theta, geometry), strict=True):
        M = rrr.elbows(angles, geometry)

        def loops(x, M=M):
            return ((rrr.platform_joints(x, geometry) - M) ** 2).sum(axis=-1) - geometry.L**2

        x = rng.uniform(-1, 1, (400, 3)) * [300, 300, np.pi]
        for _ in range(50):
            step = np.diag([1e-4, 1e-4, 1e-6])
            J = np.stack([(loops(x + d) - loops(x - d)) / (2 * d.sum()) for d in step], axis=-1)
            move = np.linalg.solve(J, loops(x)[..., None])[..., 0]
            x = x - np.clip(move, [-50, -50, -0.5], [50, 50, 0.5])
            x[:, 2] = np.angle(np.exp(1j * x[:, 2]))
        x = x[np.abs(loops(x)).max(axis=-1) < 1e-6]
        found = found[np.isfinite(found[:, 0])]
        away = apart(x[:, None], found[None])
        assert away.min(axis=1).max() < 1e-4
        assert away.min(axis=0).max() < 1e-4


@pytest.mark.parametrize(
    ("mode", "pose"),
    [
        (5, (-62.54525311108877, 113.43908133134136, 0.3260533485622169)),
        (4, (28.956759516912864, -85.47232224860406, -0.548096399584814)),
        (2, (76.68061087221149, -97.8026952904579, 0.09136122781111336)),
        (3, (-75.42604477119076, -43.08625065783022, -0.31609353333690016)),
        (2, (86.77363754241128, -90.68838804313006, -0.18170637388554545)),
    ],
)
def test_a_pose_a_hair_from_another_is_found(mode, pose):
    """det A of unit links is a few millionths there; Newton's method only halves the error in each step."""
    found = rrr.forward_kinematics(rrr.inverse_kinematics(pose)[mode])
    assert np.nanmin(np.abs(found - pose).max(axis=1)) < 2e-3


@pytest.mark.parametrize("eighths", range(-3, 5))
def test_alpha_of_half_a_turn_is_found(rng, eighths):
    """tan(alpha / 2) is infinite there. So it is, in the package, opposite to one of these eight angles."""
    small = rrr.Geometry(200, 180, 50, 150)
    pose = np.insert(rng.uniform(-50, 50, (200, 2)), 2, eighths * np.pi / 4, axis=1)
    theta = rrr.inverse_kinematics(pose, small)[:, 0]
    found = rrr.forward_kinematics(theta, small)
    assert np.nanmin(apart(found, pose[:, None]), axis=1).max() < 1e-6
    assert np.nanmax(found[..., 2]) <= np.pi
    assert np.nanmin(found[..., 2]) > -np.pi


def test_two_poses_that_share_alpha_are_both_found():
    """Where two distal links are parallel, alpha is a double root that belongs to two poses."""
    pose = np.array([20.0, 10, 0.2])
    directions = np.array([-0.33, -0.33, 2.5])
    M = rrr.platform_joints(pose) - 130 * np.c_[np.cos(directions), np.sin(directions)]
    away = np.linalg.norm(M, axis=1)
    bend = np.arccos((away**2 + 290**2 - 170**2) / (2 * away * 290))
    base_angles = np.arctan2(M[:, 1], M[:, 0]) + bend  # so that each M_i is 170 mm from its motor
    geometry = rrr.Geometry(base_angles=tuple(base_angles))
    theta = np.arctan2(*(M - rrr.base_joints(geometry)).T[::-1])
    found = rrr.forward_kinematics(theta, geometry)
    sharing = found[np.abs(found[:, 2] - 0.2) < 1e-9]
    assert len(sharing) == 2
    assert apart(sharing, pose).min() < 1e-9
    assert apart(sharing[0], sharing[1]) > 1
    assert sharing[0, 0] < sharing[1, 0]
    assert np.nanmax(misses(found, theta, geometry)) < 1e-9


def test_poses_that_meet_are_found_once():
    """At a type-2 singularity two poses are one."""
    for pose, theta, geometry in [(*meeting(), rrr.RRR), (np.zeros(3), STRETCHED[0], STRETCHED[1])]:
        found = rrr.forward_kinematics(theta, geometry)
        assert np.isfinite(found[:, 0]).sum() == 1
        assert apart(found[0], pose) < 1e-5
        assert misses(found[0], theta, geometry).max() < 1e-8


def test_there_may_be_no_pose():
    theta = np.array([np.pi / 2, 7 * np.pi / 6, 11 * np.pi / 6])  # all links point away from the platform
    assert np.isnan(rrr.forward_kinematics(theta)).all()
    assert not rrr.self_motion(theta)
    with pytest.raises(NoPoseError, match=r"90.00, 210.00, 330.00 deg"):
        rrr.assemble(theta, [0, 0, 0])


def test_assemble_picks_the_pose_nearest_to_the_one_named(rng):
    pose, theta = with_modes(rng, 20)
    for x, angles in zip(pose, theta, strict=True):
        assert apart(rrr.assemble(angles, x + [0.01, -0.01, 1e-4 - 2 * np.pi * np.sign(x[2])]), x) < 1e-6


def test_two_poses_that_share_their_centre_are_both_found_and_told_apart():
    """Motors that are symmetric about the y axis: the platform turned to the left, or as far to the right."""
    theta = np.deg2rad([-90, 30, 150])
    left, right = rrr.forward_kinematics(theta)[:2]
    np.testing.assert_allclose(left, -right, atol=1e-9)
    assert right[2] > 1
    assert apart(rrr.assemble(theta, [0, 0, 0.5]), right) < 1e-9
    assert apart(rrr.assemble(theta, [0, 0, -0.5]), left) < 1e-9


# Self-motion


def test_the_platform_can_travel_on_a_circle_with_the_motors_locked():
    assert rrr.self_motion(FREE)
    assert np.isnan(rrr.forward_kinematics(FREE)).all()
    with pytest.raises(SelfMotionError, match=r"257.07, 17.07, 137.07 deg"):
        rrr.assemble(FREE, [0, 130, 0.3])
    turn = np.linspace(0, 2 * np.pi, 50)
    pose = np.c_[130 * np.cos(turn), 130 * np.sin(turn), np.full(50, TURN)]
    assert np.rad2deg(TURN) == pytest.approx(17.014, abs=5e-4)
    assert misses(pose, FREE).max() < 1e-9
    types = rrr.singularity_type(pose, FREE)
    A = np.linalg.svd(rrr.jacobians(pose, FREE)[0])[1]
    assert (A[:, 2] < 1e-5 * A[:, 0]).all()
    assert set(types) <= {2, 3}


def test_the_self_motion_is_detected_from_angles_rounded_to_a_thousandth_of_a_degree():
    rounded = np.deg2rad([257.070, 17.070, 137.070])
    assert np.abs(rounded - FREE).max() > 1e-7
    assert rrr.self_motion(rounded)


def test_the_self_motion_is_told_from_its_neighbours():
    for step in np.deg2rad(0.01) * np.eye(3):
        assert not rrr.self_motion(FREE + step)
        assert not rrr.self_motion(FREE - step)


def test_the_same_triangle_turned_over_is_no_self_motion():
    """Elbows as far from each other as the platform's joints, but the other way round."""
    gamma = np.array([1.5, 3.4, 6.0])
    turn = np.arccos((290**2 + 130**2 - 250**2) / (2 * 290 * 130))
    for mirror in (1, -1):
        base_angles = mirror * gamma + turn
        geometry = rrr.Geometry(250, 250, 130, 290, tuple(base_angles), tuple(gamma))
        M = 130 * np.c_[np.cos(mirror * gamma), np.sin(mirror * gamma)]
        theta = np.arctan2(*(M - rrr.base_joints(geometry)).T[::-1])
        np.testing.assert_allclose(rrr.elbows(theta, geometry), M)
        assert rrr.self_motion(theta, geometry) == (mirror == 1)


def test_elbows_that_coincide_let_a_platform_of_that_radius_turn():
    loose = rrr.Geometry(200, 90, 90, 200)
    theta = np.array(rrr.RRR.base_angles) + np.pi
    assert rrr.self_motion(theta, loose)
    assert np.isnan(rrr.forward_kinematics(theta, loose)).all()
    for alpha in (0, 1, 2.5):
        assert misses(np.array([0, 0, alpha]), theta, loose).max() < 1e-9
    assert not rrr.self_motion(theta, rrr.Geometry(200, 95, 90, 200))


def test_self_motion_is_rare(rng):
    assert not rrr.self_motion(rng.uniform(-np.pi, np.pi, (20_000, 3))).any()


# Velocities


@ROBOTS
@pytest.mark.parametrize("mode", range(8), ids=map(str, rrr.WORKING_MODES))
def test_jacobians_against_finite_differences(rng, mode, geometry):
    """A x_dot = B theta_dot, with theta_dot from central differences of the inverse kinematics."""
    for pose in poses(rng, 30, geometry):
        theta = rrr.inverse_kinematics(pose, geometry)[mode]
        A, B = rrr.jacobians(pose, theta, geometry)
        if np.abs(np.diag(B)).min() < 0.2 * geometry.S_A * geometry.L:
            continue  # too near a stretched leg for a step of this size
        step = np.diag([1e-4, 1e-4, 1e-6])
        ahead, behind = (rrr.inverse_kinematics(pose + s * step, geometry)[:, mode] for s in (1, -1))
        dtheta = np.angle(np.exp(1j * (ahead - behind)))
        np.testing.assert_allclose(A @ step * 2, B @ dtheta.T, atol=1e-5 * 2e-4 * geometry.L, rtol=0)


def test_the_sign_of_each_entry_of_B_is_the_working_mode(rng):
    pose = poses(rng, 100)
    _, B = rrr.jacobians(pose[:, None], rrr.inverse_kinematics(pose))
    signs = np.sign(np.diagonal(B, axis1=-2, axis2=-1))
    np.testing.assert_array_equal(signs, np.broadcast_to(rrr.WORKING_MODES, signs.shape))
    assert (B[..., ~np.eye(3, dtype=bool)] == 0).all()


@pytest.mark.parametrize("span", [300, 40])
def test_a_stretched_or_folded_leg_is_type_1(span):
    pose = np.array([span * np.cos(-1.8), 290 + span * np.sin(-1.8) - 130, 0])
    theta = rrr.inverse_kinematics(pose)
    np.testing.assert_array_equal(rrr.singularity_type(pose, theta), np.ones(8))
    _, B = rrr.jacobians(pose, theta)
    assert np.abs(B[:, 0, 0]).max() < 1e-4 * np.abs(B[:, 1, 1]).min()


def test_symmetric_legs_beside_a_stretched_one_are_type_3():
    """Legs 2 and 3 are mirror images, so that their lines meet on the line of leg 1."""
    theta = rrr.inverse_kinematics([0, -140, 0])
    mirrored = [mode[1] == -mode[2] for mode in rrr.WORKING_MODES]
    np.testing.assert_array_equal(rrr.singularity_type([0, -140, 0], theta), np.where(mirrored, 3, 1))


def meeting(geometry=rrr.RRR):
    """The pose at the origin at which all distal links point away from the platform's centre, and theta there."""
    reach = geometry.r_platform + geometry.L
    cosine = (geometry.r_base**2 + reach**2 - geometry.S_A**2) / (2 * geometry.r_base * reach)
    alpha = np.arccos(cosine)
    direction = alpha + np.array(geometry.base_angles)
    away = reach * np.c_[np.cos(direction), np.sin(direction)] - rrr.base_joints(geometry)
    return np.array([0, 0, alpha]), np.arctan2(away[:, 1], away[:, 0])


def test_distal_lines_that_meet_in_a_point_are_type_2():
    pose, theta = meeting()
    assert misses(pose, theta).max() < 1e-9
    assert rrr.singularity_type(pose, theta) == 2
    A, B = rrr.jacobians(pose, theta)
    np.testing.assert_allclose(A @ [0, 0, 1], 0, atol=1e-9)  # the platform can turn about that point
    assert np.abs(np.linalg.det(B)) > 1e9
    beside = pose + [0, 0, 1e-4]
    assert rrr.singularity_type(beside, rrr.inverse_kinematics(beside)[0]) == 0


def test_both_at_once_are_type_3():
    theta, geometry = STRETCHED
    assert rrr.singularity_type([0, 0, 0], theta, geometry) == 3


@ROBOTS
def test_ordinary_poses_are_regular(rng, geometry):
    pose, theta = with_modes(rng, 1000, geometry)
    assert (rrr.singularity_type(pose, theta, geometry) == 0).mean() > 0.99


@pytest.mark.parametrize("scale", [1e-7, 1e7])
def test_the_type_does_not_depend_on_the_unit(scale):
    geometry = rrr.Geometry(*(scale * np.array(tuple(rrr.RRR)[:4])))
    pose, theta = meeting()
    assert rrr.singularity_type(pose * [scale, scale, 1], theta, geometry) == 2
    beside = pose * [scale, scale, 1] + [0, 0, 0.01]
    assert rrr.singularity_type(beside, rrr.inverse_kinematics(beside, geometry)[0], geometry) == 0


# Workspace


@pytest.mark.parametrize(
    ("degrees", "area"), [(0, 64_785.99), (30, 49_662.29), (45, 28_413.01), (60, 10_690.54), (90, 0)]
)
def test_areas_of_the_constant_orientation_workspace(degrees, area):
    assert rrr.constant_orientation_workspace(np.deg2rad(degrees)).area == pytest.approx(area, abs=0.005)


@ROBOTS
@pytest.mark.parametrize("alpha", [0.0, 0.3, -0.7, 1.0])
def test_area_and_perimeter_by_a_second_method(geometry, alpha):
    """Area: lengths of chords, integrated. Perimeter: parts of each circle that lie in the other two rings."""
    region = rrr.constant_orientation_workspace(alpha, geometry)
    centres = rrr.base_joints(geometry) - rrr.platform_joints([0, 0, alpha], geometry)
    radii = np.array([abs(geometry.S_A - geometry.L), geometry.S_A + geometry.L])
    assert region.area == pytest.approx(area_by_chords(centres, radii), rel=1e-9, abs=1e-9)
    assert region.perimeter == pytest.approx(perimeter_by_circles(centres, radii), rel=1e-9, abs=1e-9)


def circles_and_crossings(centres, radii):
    circles = [(c[0] + 1j * c[1], rho) for c in centres for rho in radii if rho > 0]
    points = []
    for (c, rho), (d, sigma) in combinations(circles, 2):
        span = abs(d - c)
        along = (span**2 + rho**2 - sigma**2) / (2 * span) if span else np.inf
        if abs(along) <= rho:
            points += [c + (along + s * 1j * np.sqrt(rho**2 - along**2)) * (d - c) / span for s in (1, -1)]
    return circles, np.array(points)


def area_by_chords(centres, radii):
    circles, points = circles_and_crossings(centres, radii)
    ends = np.unique(np.r_[[c.imag + s * rho for c, rho in circles for s in (1, -1)], points.imag])
    node, weight = np.polynomial.legendre.leggauss(60)
    total = 0.0
    for low, high in pairwise(ends):
        for u, w in zip(
            np.pi / 2 * node, np.pi / 2 * weight, strict=True
        ):  # y = sin u takes the root off the ends
            y = (low + high) / 2 + (high - low) / 2 * np.sin(u)
            cuts = [
                c.real + s * np.sqrt(rho**2 - (y - c.imag) ** 2)
                for c, rho in circles
                if rho > abs(y - c.imag)
                for s in (1, -1)
            ]
            cuts = np.sort(cuts)
            middle = (cuts[1:] + cuts[:-1]) / 2
            inside = in_rings(middle + 1j * y, centres, radii)
            total += w * (high - low) / 2 * np.cos(u) * np.diff(cuts)[inside].sum()
    return total


def perimeter_by_circles(centres, radii):
    circles, points = circles_and_crossings(centres, radii)
    total = 0.0
    for c, rho in circles:
        on = points[abs(abs(points - c) - rho) < 1e-9]
        angle = np.sort(np.angle(on - c))
        angle = np.r_[angle, angle[:1] + 2 * np.pi] if len(angle) else np.array([0, 2 * np.pi])
        middle = c + rho * np.exp(1j * (angle[1:] + angle[:-1]) / 2)
        others = centres[abs(centres @ [1, 1j] - c) > 1e-9]
        total += rho * np.diff(angle)[in_rings(middle, others, radii)].sum()
    return total


def in_rings(points, centres, radii):
    span = abs(points[:, None] - (centres[:, 0] + 1j * centres[:, 1]))
    return ((span >= radii[0]) & (span <= radii[1])).all(axis=-1)


@ROBOTS
def test_region_and_inverse_kinematics_agree_on_what_is_reachable(rng, geometry):
    for alpha in (0.0, 0.4, -1.1):
        pose = np.insert(rng.uniform(-300, 300, (4000, 2)), 2, alpha, axis=1)
        inside = rrr.constant_orientation_workspace(alpha, geometry).contains(pose[:, :2])
        np.testing.assert_array_equal(inside, rrr.reachable(pose, geometry))
        closes = np.isfinite(rrr.inverse_kinematics(pose, geometry)).all(axis=(1, 2))
        np.testing.assert_array_equal(inside, closes)


# Batches and bad input

FUNCTIONS = {
    "inverse_kinematics": (rrr.inverse_kinematics, (8, 3)),
    "forward_kinematics": (rrr.forward_kinematics, (6, 3)),
    "leg_lengths": (rrr.leg_lengths, (3,)),
    "platform_joints": (rrr.platform_joints, (3, 2)),
    "elbows": (rrr.elbows, (3, 2)),
    "reachable": (rrr.reachable, ()),
    "self_motion": (rrr.self_motion, ()),
    "jacobians": (lambda x: rrr.jacobians(x, x)[0], (3, 3)),
    "singularity_type": (lambda x: rrr.singularity_type(x, x), ()),
}
EACH = pytest.mark.parametrize(("function", "shape"), FUNCTIONS.values(), ids=FUNCTIONS)


@EACH
@pytest.mark.parametrize("batch", [(), (1,), (3, 1, 2), (0,), (2, 0)])
def test_functions_broadcast_over_leading_axes(rng, function, shape, batch):
    rows = rng.uniform(-1, 1, (*batch, 3))
    result = function(rows)
    assert result.shape == (*batch, *shape)
    if rows.size:
        each = np.reshape([function(row) for row in rows.reshape(-1, 3)], (*batch, *shape))
        np.testing.assert_allclose(result, each, atol=1e-9)


@EACH
@pytest.mark.parametrize(("where", "bad"), [(0, np.nan), (1, np.inf), (2, -np.inf)])
def test_what_is_not_finite_gives_no_plausible_answer(function, shape, bad, where):
    row = np.array([0.0, 5.0, 0.2])
    good = function(row)
    row[where] = bad
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        both = function(np.stack([row, [0.0, 5.0, 0.2]]))
    empty = False if both.dtype == bool else np.nan
    np.testing.assert_array_equal(both[0] if function is not rrr.elbows else both[0, where], empty)
    np.testing.assert_array_equal(both[1], good)


@EACH
@pytest.mark.parametrize("given", [[1.0, 2.0], 3.0, [1j, 2, 3], np.zeros((3, 2))])
def test_wrong_shapes_and_complex_numbers_are_refused(function, shape, given):
    with pytest.raises(InputError):
        function(given)


@pytest.mark.parametrize("mode", [-1, 8, None, True, 1.5, "+++"])
def test_a_working_mode_is_one_of_eight(mode):
    with pytest.raises(InputError, match=r"working mode is a whole number from 0 to 7; .* was given"):
        rrr.solve([0, 0, 0], mode)


STRANGE_POSES = [[np.nan] * 3, [0, np.inf, 0], [0, 0], np.zeros((2, 3)), [1j, 0, 0], None, "abc"]


@pytest.mark.parametrize("given", STRANGE_POSES, ids=range(len(STRANGE_POSES)))
def test_what_is_not_one_finite_pose_is_refused(given):
    for call in (lambda: rrr.solve(given), lambda: rrr.assemble(given, [0, 0, 0])):
        with pytest.raises(InputError):
            call()
    with pytest.raises(InputError):
        rrr.assemble([0.3, 0.2, 0.1], given)


@pytest.mark.parametrize("alpha", [np.nan, np.inf, 1j, [0.1, 0.2]])
def test_a_workspace_has_one_finite_alpha(alpha):
    with pytest.raises(InputError, match=r"angle alpha is one finite number|expected for the angle alpha"):
        rrr.constant_orientation_workspace(alpha)


@pytest.mark.parametrize(
    "call",
    [
        lambda a: rrr.inverse_kinematics([0, 100, a]),
        lambda a: rrr.leg_lengths([[0, 0, 0], [0, 100, a]]),
        lambda a: rrr.platform_joints([0, 100, a]),
        lambda a: rrr.reachable([0, 100, a]),
        lambda a: rrr.jacobians([0, 100, a], [0, 0, 0]),
        lambda a: rrr.constant_orientation_workspace(a),
    ],
)
def test_degrees_for_alpha_are_noticed(call):
    with pytest.warns(UserWarning, match="30 rad is more than a full turn; were degrees meant"):
        call(30)
    with pytest.warns(UserWarning, match="6.5 rad is more"):
        call(6.5)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        call(-2 * np.pi)


def test_two_poses_that_nearly_meet_are_still_two():
    """Where det A is zero, in the middle at 35.4795 deg, two poses meet; a motor's turn by 1e-10 parts them."""
    low, high = np.deg2rad([30.0, 40.0])
    for _ in range(60):
        middle = np.array([0, 0, (low + high) / 2])
        A, _ = rrr.jacobians(middle, rrr.inverse_kinematics(middle)[0])
        low, high = (middle[2], high) if np.linalg.det(A) < 0 else (low, middle[2])
    assert np.rad2deg(low) == pytest.approx(35.4795, abs=1e-4)
    for turn, parted in ((1e-8, 2.3e-4), (1e-10, 2.3e-5)):
        poses = rrr.forward_kinematics(rrr.inverse_kinematics(middle)[0] + turn)
        near = poses[np.abs(poses[:, 2] - low) < 1e-2]
        assert len(near) == 2
        assert np.ptp(near[:, 2]) == pytest.approx(parted, rel=0.05)


def test_a_robot_that_closes_only_with_a_leg_folded_to_its_inner_circle_is_one():
    """Where its three rings meet, no two outer circles cross within the third ring."""
    corners = {"base_angles": (2.52, 4.8, 0.91), "platform_angles": (2.7, 3.86, 1.51)}
    robot = rrr.Geometry(245, 78, 69, 179, **corners)
    pose = np.stack(np.meshgrid(*[np.linspace(-200, 200, 81)] * 2, np.linspace(-np.pi, np.pi, 73)), axis=-1)
    assert rrr.reachable(pose, robot).any()
