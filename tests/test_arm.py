"""Laws of the Lynxmotion arm's forward kinematics."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from lynx_common import arm
from lynx_common.errors import GeometryError, InputError

OTHER = arm.Geometry(0.07, 0.3, 0.15, 0.0)
FUNCTIONS = {
    arm.forward_kinematics: (4, 4),
    arm.link_frames: (6, 4, 4),
    arm.joint_positions: (5, 3),
    arm.task_coordinates: (5,),
    arm.jacobian: (6, 5),
}
angle = st.floats(-2 * np.pi, 2 * np.pi)
configurations = st.tuples(*[angle] * 5).map(np.array)
HARD_PLACES = {
    "full stretch": [0.3, 0.4, 0.0, 0.2, 0.1],
    "folded": [0.3, 0.4, np.pi, 0.2, 0.1],
    "gripper on the base axis": [0.3, np.pi / 2, 0, np.pi / 2, 0.1],
    "half turns": [np.pi, -np.pi, np.pi, -np.pi, np.pi],
    "all zero": [0.0] * 5,
}


def plane_geometry(q, geometry):
    """The gripper's pose from angles above the horizontal in the arm's own plane, without any DH table."""
    d_1, L_1, L_2, L_3 = geometry
    azimuth, upper, fore = q[..., 0], q[..., 1], q[..., 1] + q[..., 2]
    pitch = fore + q[..., 3] - np.pi / 2
    outward = np.stack([np.cos(azimuth), np.sin(azimuth), 0 * azimuth], -1)
    left = np.stack([-np.sin(azimuth), np.cos(azimuth), 0 * azimuth], -1)
    up = np.array([0.0, 0.0, 1.0])

    def along(angle):
        return np.cos(angle)[..., None] * outward + np.sin(angle)[..., None] * up

    position = d_1 * up + L_1 * along(upper) + L_2 * along(fore) + L_3 * along(pitch)
    x_unrolled, roll = along(pitch + np.pi / 2), q[..., 4, None]
    x_axis = np.cos(roll) * x_unrolled - np.sin(roll) * left
    y_axis = -np.sin(roll) * x_unrolled - np.cos(roll) * left
    return np.stack([x_axis, y_axis, along(pitch), position], -1)


@pytest.mark.parametrize("geometry", [arm.LYNX, OTHER])
def test_the_dh_product_is_plane_geometry(geometry, rng):
    """Two derivations of one pose."""
    q = np.concatenate([rng.uniform(-7, 7, (1000, 5)), list(HARD_PLACES.values())])
    pose = arm.forward_kinematics(q, geometry)
    np.testing.assert_allclose(pose[:, :3], plane_geometry(q, geometry), atol=1e-12)
    np.testing.assert_array_equal(pose[:, 3], np.broadcast_to([0, 0, 0, 1], (len(q), 4)))


def test_the_report_s_angles_give_the_report_s_position():
    """Table 1.3 and the data tip of Fig. 1.2, to its last digit."""
    q = np.pi / 180 * np.array([60, 45, -30, 60, 30])
    position = arm.forward_kinematics(q, arm.Geometry(0.1, 0.2, 0.2, 0.1))[:3, 3]
    np.testing.assert_array_equal(np.round(position, 6), [0.2156, 0.373429, 0.267303])


@given(configurations)
def test_a_pose_is_a_rigid_motion(q):
    R = arm.forward_kinematics(q)[:3, :3]
    np.testing.assert_allclose(R.T @ R, np.eye(3), atol=1e-12)
    assert np.linalg.det(R) == pytest.approx(1)


@given(configurations)
def test_links_keep_their_lengths(q):
    points = arm.joint_positions(q, OTHER)
    np.testing.assert_allclose(np.linalg.norm(np.diff(points, axis=0), axis=1), list(OTHER), atol=1e-12)


@given(configurations)
def test_joint_positions_are_the_origins_of_the_link_frames(q):
    frames = arm.link_frames(q)
    np.testing.assert_allclose(arm.joint_positions(q), frames[[0, 1, 2, 3, 5], :3, 3], atol=1e-12)
    np.testing.assert_allclose(frames[4, :3, 3], frames[3, :3, 3], atol=1e-12)
    np.testing.assert_allclose(frames[5], arm.forward_kinematics(q), atol=1e-12)
    np.testing.assert_array_equal(frames[0], np.eye(4))


def test_each_joint_turns_about_the_z_axis_of_the_frame_before_it(rng):
    """The rotation from one frame to the next, seen in the frame before, turns z by alpha and x by theta."""
    q = rng.uniform(-np.pi, np.pi, (200, 5))
    frames = arm.link_frames(q)
    for i in range(5):
        x_next = np.einsum("nji,nj->ni", frames[:, i, :3, :3], frames[:, i + 1, :3, 0])
        expected = np.stack([np.cos(q[:, i]), np.sin(q[:, i]), 0 * q[:, i]], -1)
        np.testing.assert_allclose(x_next, expected, atol=1e-12)


def test_only_the_first_three_joints_move_the_wrist(rng):
    q = rng.uniform(-np.pi, np.pi, (100, 5))
    turned = q + [0, 0, 0, 1.0, 2.0]
    before, after = arm.joint_positions(q), arm.joint_positions(turned)
    np.testing.assert_array_equal(before[:, :4], after[:, :4])
    assert (np.linalg.norm(before[:, 4] - after[:, 4], axis=-1) > 0.9 * arm.LYNX.L_3).all()


@pytest.mark.parametrize("geometry", [arm.LYNX, OTHER])
def test_task_coordinates_are_a_chart_of_the_pose(geometry, rng):
    """Position and gripper axis follow from azimuth, signed r, z and pitch, also on the base axis."""
    q = np.concatenate([rng.uniform(-7, 7, (1000, 5)), list(HARD_PLACES.values())])
    azimuth, r, z, pitch, roll = np.moveaxis(arm.task_coordinates(q, geometry), -1, 0)
    pose = arm.forward_kinematics(q, geometry)
    position = np.stack([r * np.cos(azimuth), r * np.sin(azimuth), z], -1)
    axis = np.stack([np.cos(pitch) * np.cos(azimuth), np.cos(pitch) * np.sin(azimuth), np.sin(pitch)], -1)
    np.testing.assert_allclose(pose[:, :3, 3], position, atol=1e-12)
    np.testing.assert_allclose(pose[:, :3, 2], axis, atol=1e-12)
    np.testing.assert_array_equal(azimuth, q[:, 0])
    np.testing.assert_array_equal(roll, q[:, 4])


def test_task_coordinates_are_smooth_over_the_base_axis():
    """The arm swings over the top: r changes sign, and nothing jumps."""
    swing = np.linspace(np.pi / 2 - 0.1, np.pi / 2 + 0.1, 2001)
    q = np.stack([np.full(2001, 0.3), swing, 0 * swing, np.full(2001, np.pi / 2), 0 * swing], -1)
    task = arm.task_coordinates(q)
    assert task[0, 1] > 0 > task[-1, 1]
    assert abs(np.diff(task, axis=0)).max() < 1.1e-4
    assert abs(np.diff(task, n=2, axis=0)).max() < 1e-8


@pytest.mark.parametrize("geometry", [arm.LYNX, OTHER])
def test_the_jacobian_is_the_finite_difference_of_the_pose(geometry, rng):
    q, step = rng.uniform(-np.pi, np.pi, (100, 5)), 1e-6
    J = arm.jacobian(q, geometry)
    for i in range(5):
        ahead, behind = (arm.forward_kinematics(q + s * step * np.eye(5)[i], geometry) for s in (1, -1))
        rate = (ahead - behind) / (2 * step)
        spin = rate[:, :3, :3] @ arm.forward_kinematics(q, geometry)[:, :3, :3].transpose(0, 2, 1)
        omega = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], -1)
        np.testing.assert_allclose(J[:, :, i], np.concatenate([rate[:, :3, 3], omega], -1), atol=1e-8)


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: f.__name__)
@pytest.mark.parametrize("batch", [(), (1,), (3, 1, 2), (0,), (2, 0)])
def test_kinematics_broadcast_over_leading_axes(function, batch, rng):
    q = rng.uniform(-np.pi, np.pi, (*batch, 5))
    result = function(q)
    assert result.shape == batch + FUNCTIONS[function]
    for index in np.ndindex(*batch):
        np.testing.assert_allclose(result[index], function(q[index]), atol=1e-14)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: f.__name__)
@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_angles_that_are_not_finite_give_nan_throughout(function, bad):
    for joint in range(5):
        q = np.full((2, 5), 0.3)
        q[0, joint] = bad
        result = function(q)
        assert np.isnan(result[0]).all()
        assert np.isfinite(result[1]).all()


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: f.__name__)
def test_complex_and_wrongly_shaped_angles_are_refused(function):
    with pytest.raises(InputError, match="complex"):
        function(np.zeros(5, complex))
    for shape in [(4,), (6,), (5, 4), ()]:
        with pytest.raises(InputError, match="5 values"):
            function(np.zeros(shape))


def test_table_1_2_has_one_row_a_joint_and_every_length_once():
    a, _, d, theta = zip(*arm.dh_table(), strict=True)
    assert theta == arm.Q
    assert (sum(d), sum(a)) == (arm.P[0] + arm.P[3], arm.P[1] + arm.P[2])


@pytest.mark.committed_lengths
def test_geometry_unpacks_in_the_order_of_table_1_3():
    d_1, L_1, L_2, L_3 = arm.Geometry(1, 2, 3, 4)
    assert (d_1, L_1, L_2, L_3) == (1.0, 2.0, 3.0, 4.0)
    np.testing.assert_array_equal(np.asarray(OTHER), [0.07, 0.3, 0.15, 0.0])
    assert tuple(arm.LYNX) == (0.1, 0.2, 0.2, 0.1)


@pytest.mark.parametrize(
    ("lengths", "name", "sentence"),
    [
        ((-0.1, 0.2, 0.2, 0.1), "d_1", "not negative"),
        ((0.1, 0.2, 0.2, -1e-9), "L_3", "not negative"),
        ((0.1, np.nan, 0.2, 0.1), "L_1", "finite"),
        ((0.1, 0.2, np.inf, 0.1), "L_2", "finite"),
        ((0.0, 0.0, 0.0, 0.0), "L_1", "longer than zero"),
        ((0.1, 0.2, 0.0, 0.1), "L_2", "longer than zero"),
        ((0.1, 0.2 + 1j, 0.2, 0.1), "L_1", "real number"),
        (("long", 0.2, 0.2, 0.1), "d_1", "real number"),
    ],
)
def test_lengths_that_no_arm_can_have_are_named(lengths, name, sentence):
    with pytest.raises(GeometryError, match=sentence) as error:
        arm.Geometry(*lengths)
    assert error.value.name == name


def test_a_geometry_and_the_limits_cannot_be_changed_by_accident():
    with pytest.raises(AttributeError):
        arm.LYNX.d_1 = 0.2
    with pytest.raises(ValueError, match="read-only"):
        arm.JOINT_LIMITS[0, 0] = 0
    with pytest.raises(ValueError, match="read-only"):
        arm.SERVO_LIMITS[0, 0] = 0


def test_joint_limits_hold_the_angles_of_table_1_3():
    q = np.pi / 180 * np.array([60, 45, -30, 60, 30])
    assert ((arm.JOINT_LIMITS[:, 0] <= q) & (q <= arm.JOINT_LIMITS[:, 1])).all()
    assert arm.JOINT_LIMITS.shape == (5, 2)


def test_servos_turn_90_deg_to_either_side_of_the_arm_straight_up_within_the_joint_limits():
    upright = arm.SERVO_LIMITS.mean(axis=1)
    np.testing.assert_allclose(arm.joint_positions(upright)[-1], [0, 0, sum(arm.LYNX)], atol=1e-12)
    np.testing.assert_allclose(np.ptp(arm.SERVO_LIMITS, axis=1), np.pi)
    assert (arm.SERVO_LIMITS[:, 0] >= arm.JOINT_LIMITS[:, 0]).all()
    assert (arm.SERVO_LIMITS[:, 1] <= arm.JOINT_LIMITS[:, 1]).all()


def test_the_symbols_of_the_table_are_the_course_s():
    assert sp.Matrix(arm.dh_table()).free_symbols == {*arm.Q, *arm.P}
