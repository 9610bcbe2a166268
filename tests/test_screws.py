"""Laws of screws: what an exponential does to its axis, what a change of frame does, and who does work on whom."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lynx_common import arm, screws
from lynx_common.errors import InputError, ScrewError

PART_3 = arm.Geometry(5, 10, 10, 0)
BATCHES = [(), (1,), (3, 1, 2), (0,)]
ANGLES = [0, 1e-300, 1e-12, 1e-6, 0.9999e-4, 1e-4, 1.0001e-4, 0.001, 0.01, 1, 3, np.pi - 1e-9, np.pi]
number = st.floats(-3, 3).filter(lambda x: x == 0 or abs(x) > 1e-100)
sixes = st.tuples(*[number] * 6).map(np.array)


def unit(rng, *shape):
    vector = rng.normal(size=(*shape, 3))
    return vector / np.linalg.norm(vector, axis=-1, keepdims=True)


def hat(twist):
    """The matrix of a twist, (..., 6) to (..., 4, 4): it maps points (x, y, z, 1) to their velocities."""
    matrix = np.zeros((*twist.shape[:-1], 4, 4))
    matrix[..., :3, :3] = np.cross(np.eye(3), twist[..., None, 3:])
    matrix[..., :3, 3] = twist[..., :3]
    return matrix


def helical(axis, point, pitch):
    """The unit twist about a line that also advances along it."""
    return screws.revolute(axis, point) + np.asarray(pitch)[..., None] * screws.prismatic(axis)


def series(A):
    """The exponential of a matrix by its power series: slow, and without any thought of screws."""
    total, term = np.eye(4), np.eye(4)
    for n in range(1, 80):
        term = term @ A / n
        total = total + term
    return total


def random_pose(rng, *shape):
    return screws.exp(rng.normal(size=(*shape, 6)) * 2)


def joint_screws(geometry):
    """Screws of the five joints at angles 0, read off the link frames, and the gripper's pose there."""
    frames = arm.link_frames(np.zeros(5), geometry)
    return screws.revolute(frames[:5, :3, 2], frames[:5, :3, 3]).T, frames[5]


@given(sixes)
def test_exp_is_the_power_series_of_hat(twist):
    np.testing.assert_allclose(screws.exp(twist), series(hat(twist)), atol=1e-11, rtol=1e-11)


@pytest.mark.parametrize("angle", ANGLES)
def test_exp_keeps_all_digits_at_small_angles(angle, rng):
    """Where the quotients are 0/0: against the power series, to a few units of the last place."""
    twist = np.concatenate([rng.normal(size=3), unit(rng) * angle])
    np.testing.assert_allclose(screws.exp(twist), series(hat(twist)), rtol=0, atol=4e-15)


def test_a_unit_screw_turns_about_its_axis_and_advances_by_its_pitch(rng):
    """Points of the axis slide along it; all others go round it by the angle, at an unchanged distance."""
    axis, point = unit(rng, 50), rng.normal(size=(50, 3))
    pitch, angle = rng.normal(size=50), rng.uniform(-3, 3, 50)
    T = screws.exp(helical(axis, point, pitch) * angle[:, None])
    advance = (pitch * angle)[:, None] * axis

    def moved(x):
        return (T[:, :3, :3] @ x[..., None])[..., 0] + T[:, :3, 3]

    np.testing.assert_allclose(moved(point + 2 * axis), point + 2 * axis + advance, atol=1e-13)
    across = np.cross(axis, unit(rng, 50))
    turned = np.cos(angle)[:, None] * across + np.sin(angle)[:, None] * np.cross(axis, across)
    np.testing.assert_allclose(moved(point + across), point + turned + advance, atol=1e-13)


def test_a_revolute_joint_turns_a_right_handed_quarter_and_a_prismatic_one_slides():
    quarter = screws.exp(screws.revolute([0, 0, 1], [1, 0, 0]) * np.pi / 2)
    np.testing.assert_allclose(quarter @ [2, 0, 5, 1], [1, 1, 5, 1], atol=1e-15)
    slide = screws.exp(screws.prismatic([0, 1, 0]) * 3)
    np.testing.assert_array_equal(slide, [[1, 0, 0, 0], [0, 1, 0, 3], [0, 0, 1, 0], [0, 0, 0, 1]])


def test_adjoint_changes_the_frame_of_a_twist(rng):
    """The same motion seen from another frame, three ways: conjugation, matrices, exponentials."""
    T, twist = random_pose(rng, 40), rng.normal(size=(40, 6))
    seen = (screws.adjoint(T) @ twist[..., None])[..., 0]
    back = np.linalg.inv(T)
    np.testing.assert_allclose(hat(seen), T @ hat(twist) @ back, atol=1e-12)
    np.testing.assert_allclose(screws.exp(seen), T @ screws.exp(twist) @ back, atol=1e-11)
    np.testing.assert_allclose(
        screws.adjoint(T) @ screws.adjoint(back), np.broadcast_to(np.eye(6), (40, 6, 6)), atol=1e-12
    )


def test_adjoint_carries_axis_and_point_along_and_keeps_the_pitch(rng):
    T, axis, point, pitch = random_pose(rng, 9), unit(rng, 9), rng.normal(size=(9, 3)), rng.normal(size=9)
    carried = helical(
        (T[:, :3, :3] @ axis[..., None])[..., 0], (T[:, :3, :3] @ point[..., None])[..., 0] + T[:, :3, 3], pitch
    )
    seen = screws.adjoint(T) @ helical(axis, point, pitch)[..., None]
    np.testing.assert_allclose(seen[..., 0], carried, atol=1e-12)


def test_power_does_not_depend_on_the_frame(rng):
    T, twist, wrench = random_pose(rng, 40), rng.normal(size=(40, 6)), rng.normal(size=(40, 6))
    seen = (screws.adjoint(T) @ twist[..., None])[..., 0]
    carried = (np.swapaxes(screws.adjoint(np.linalg.inv(T)), -1, -2) @ wrench[..., None])[..., 0]
    np.testing.assert_allclose(
        screws.reciprocal_product(seen, carried), screws.reciprocal_product(twist, wrench), atol=1e-11
    )


def test_axis_point_and_pitch_of_a_twist_and_back(rng):
    twist = rng.normal(size=(3, 7, 6)) * 5
    found = screws.screw_axis(twist)
    again = found.magnitude[..., None] * helical(found.axis, found.point, found.pitch)
    np.testing.assert_allclose(again, twist, atol=1e-13)
    np.testing.assert_allclose((found.axis * found.point).sum(axis=-1), 0, atol=1e-13)
    axis, point = unit(rng, 8), rng.normal(size=(8, 3))
    found = screws.screw_axis(-3 * helical(axis, point, 0.7))
    np.testing.assert_allclose(found.axis, -axis, atol=1e-14)
    np.testing.assert_allclose(found.pitch, 0.7, atol=1e-14)
    np.testing.assert_allclose(found.magnitude, 3, atol=1e-14)
    np.testing.assert_allclose(np.cross(found.point - point, axis), 0, atol=1e-13)


def test_a_translation_has_an_infinite_pitch():
    found = screws.screw_axis([0, 0, 2, 0, 0, 0])
    assert found.pitch == np.inf
    assert found.magnitude == 2
    np.testing.assert_array_equal(found.axis, [0, 0, 1])
    np.testing.assert_array_equal(found.point, [0, 0, 0])
    np.testing.assert_array_equal(screws.prismatic(found.axis), [0, 0, 1, 0, 0, 0])
    mixed = screws.screw_axis([[0, 0, 2, 0, 0, 0], [0, 0, 0, 0, 3, 0]])
    np.testing.assert_array_equal(mixed.pitch, [np.inf, 0])
    far = screws.screw_axis([1, 0, 0, 0, 0, 1e-9])  # still a turn, about an axis 10^9 away
    np.testing.assert_allclose(far.point, [0, 1e9, 0])


def test_a_force_has_a_line_of_action(rng):
    axis, point = unit(rng, 9), rng.normal(size=(9, 3))
    wrench = screws.force(axis, point)
    np.testing.assert_allclose(wrench[:, 3:], np.cross(point, axis), atol=1e-15)
    np.testing.assert_array_equal(wrench[:, :3], axis)
    # The force does no work on a turn about a line that meets it, and force times distance on one square to it.
    through = screws.revolute(unit(rng, 9), point + 3 * axis)
    np.testing.assert_allclose(screws.reciprocal_product(through, wrench), 0, atol=1e-13)
    np.testing.assert_array_equal(screws.reciprocal_product(screws.prismatic([0, 0, 1]), [1, 2, 3, 4, 5, 6]), 3)
    np.testing.assert_array_equal(
        screws.reciprocal_product(screws.revolute([0, 1, 0], [0, 0, 0]), [1, 2, 3, 4, 5, 6]), 5
    )


@pytest.mark.parametrize("geometry", [arm.LYNX, PART_3])
def test_the_exponentials_of_the_joints_make_the_dh_product(geometry, rng):
    q = np.concatenate([rng.uniform(-7, 7, (200, 5)), np.zeros((1, 5)), np.full((1, 5), np.pi)])
    twists, T = joint_screws(geometry)
    for xi, angle in zip(twists.T[::-1], q.T[::-1], strict=True):
        T = screws.exp(xi * angle[:, None]) @ T
    np.testing.assert_allclose(T, arm.forward_kinematics(q, geometry), atol=1e-13 * sum(geometry) * 10)


@pytest.mark.parametrize("geometry", [arm.LYNX, PART_3])
def test_a_jacobian_moved_to_the_origin_is_the_screws_of_the_joints_where_they_are(geometry, rng):
    q = rng.uniform(-3, 3, (20, 5))
    frames = arm.link_frames(q, geometry)[:, :5]
    expected = np.swapaxes(screws.revolute(frames[..., :3, 2], frames[..., :3, 3]), -1, -2)
    p = arm.joint_positions(q, geometry)[:, 4]
    to_origin = screws.adjoint(screws.exp(np.concatenate([p, 0 * p], axis=-1)))
    np.testing.assert_allclose(to_origin @ arm.jacobian(q, geometry), expected, atol=1e-11)


@pytest.mark.parametrize(("q", "expected"), [([0.3, 0.7, 0.9, 0.4, 0.2], 5), ([0.3, 0.7, 0, 0.4, 0.2], 4)])
@pytest.mark.parametrize("length", [0.01, 0.4, 1, 50])
def test_reciprocal_wrenches_do_no_work_and_are_all_of_them(q, expected, length):
    J = arm.jacobian(q)
    wrenches = screws.reciprocal_system(J, length)
    assert wrenches.shape == (6, 6 - expected)
    assert screws.order(J, length) == expected
    np.testing.assert_allclose(wrenches.T @ J, 0, atol=1e-13 / length)
    scaled = wrenches * np.array([length] * 3 + [1] * 3)[:, None]
    np.testing.assert_allclose(scaled.T @ scaled, np.eye(6 - expected), atol=1e-13)


def test_order_counts_independent_columns(rng):
    for expected in range(7):
        system = rng.normal(size=(4, 6, expected)) @ rng.normal(size=(4, expected, 9))
        np.testing.assert_array_equal(screws.order(system), expected)
    np.testing.assert_array_equal(screws.order(np.zeros((6, 3))), 0)
    np.testing.assert_array_equal(screws.order(np.zeros((2, 6, 0))), [0, 0])
    assert screws.reciprocal_system(np.zeros((6, 0))).shape == (6, 6)
    assert screws.reciprocal_system(rng.normal(size=(6, 8))).shape == (6, 0)


def test_order_tells_what_is_small_from_what_is_zero():
    nearly = np.array([[1, 1], [0, 1e-7], [0, 0], [0, 0], [0, 0], [0, 0]])
    assert screws.order(nearly) == 2
    assert screws.order(nearly * [1, 1], length=1) == screws.order(nearly * 1e-20) == 2
    assert screws.order(nearly - [[0, 0], [0, 9.9999e-8], *[[0, 0]] * 4]) == 1
    # v is divided by the length: with a unit that makes it tiny, only the turns are left.
    turn_and_slide = np.array([[0, 1.0], [0, 0], [0, 0], [0, 0], [0, 0], [1, 0]])
    assert screws.order(turn_and_slide) == 2
    assert screws.order(turn_and_slide, length=1e12) == 1
    assert screws.reciprocal_system(turn_and_slide, length=1e12).shape == (6, 5)


@pytest.mark.parametrize("batch", BATCHES)
def test_everything_broadcasts(batch, rng):
    six, T = rng.normal(size=(*batch, 6)), random_pose(rng, *batch)
    axis, point = unit(rng, *batch), rng.normal(size=(*batch, 3))
    assert screws.exp(six).shape == (*batch, 4, 4)
    assert screws.adjoint(T).shape == (*batch, 6, 6)
    assert screws.revolute(axis, [0, 0, 0]).shape == screws.prismatic(axis).shape == (*batch, 6)
    assert screws.force(axis, point).shape == (*batch, 6)
    assert [x.shape for x in screws.screw_axis(six)] == [(*batch, 3), (*batch, 3), batch, batch]
    assert screws.reciprocal_product(six, np.ones(6)).shape == batch
    assert screws.order(np.zeros((*batch, 6, 4))).shape == batch


def test_a_row_of_a_batch_is_the_row_alone(rng):
    six = rng.normal(size=(4, 6))
    T = screws.exp(six)
    for i in range(4):
        np.testing.assert_array_equal(screws.exp(six[i]), T[i])
        np.testing.assert_array_equal(screws.adjoint(T[i]), screws.adjoint(T)[i])


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.filterwarnings("error")
def test_what_is_not_finite_gives_nan_in_its_own_row_only(bad, rng):
    six = rng.normal(size=(3, 6))
    fine = screws.exp(six)
    for i in range(6):
        spoiled = six.copy()
        spoiled[1, i] = bad
        T = screws.exp(spoiled)
        assert np.isnan(T[1]).all()
        np.testing.assert_array_equal(T[[0, 2]], fine[[0, 2]])
        assert all(np.isnan(x[1]).all() for x in screws.screw_axis(spoiled))
        assert np.isnan(screws.adjoint(T)[1]).all()
    T = np.eye(4)
    T[0, 3] = bad
    assert np.isnan(screws.adjoint(T)).all()
    for line in (screws.revolute, screws.force):
        assert np.isnan(line([0, 0, 1], [bad, 0, 0])).all()
        assert np.isnan(line([[0, 0, 1], [bad, 0, 1]], [0, 0, 0])).all(axis=1).tolist() == [False, True]
    assert np.isnan(screws.prismatic([np.nan, 0, 1])).all()
    with pytest.raises(InputError, match="finite"):
        screws.order(np.full((6, 2), bad))


def test_complex_numbers_and_wrong_shapes_are_refused():
    for call in (screws.exp, screws.screw_axis):
        with pytest.raises(InputError, match=r"must be \(6,\); the shape given is \(5,\)"):
            call(np.ones(5))
        with pytest.raises(InputError, match="complex"):
            call(np.ones(6) + 0j)
    with pytest.raises(InputError, match=r"must be \(4, 4\); the shape given is \(3, 3\)"):
        screws.adjoint(np.eye(3))
    with pytest.raises(InputError, match=r"must be \(6, n\)"):
        screws.order(np.ones((5, 6)))
    with pytest.raises(InputError, match=r"shape \(6, n\) are expected for the twists of one system"):
        screws.reciprocal_system(np.ones((2, 6, 3)))
    for length in (0, -1, np.nan, np.inf):
        with pytest.raises(InputError, match="length is one finite number, above 0"):
            screws.order(np.ones((6, 2)), length)


@pytest.mark.parametrize(
    ("T", "off"),
    [
        (2 * np.eye(4), "7"),
        (np.diag([1, 1, -1, 1]), "2"),
        (np.eye(4) + 1e-3 * np.eye(4)[::-1], "0.002"),
        (np.diag([1, 1, 1, 2.0]), "1"),
    ],
)
def test_what_is_not_a_pose_is_refused(T, off):
    with pytest.raises(InputError, match=f"off by {off}"):
        screws.adjoint(T)


def test_axes_of_another_length_and_zero_screws_are_refused():
    for call in (screws.revolute, screws.force):
        with pytest.raises(ScrewError, match=r"must be a unit vector; the one given has length 2\."):
            call([0, 0, 2], [0, 0, 0])
    with pytest.raises(ScrewError, match=r"length 0\."):
        screws.prismatic([0, 0, 0])
    with pytest.raises(ScrewError) as fault:
        screws.prismatic([[0, 0, 1], [0, 0, 1 + 1e-8]])
    assert fault.value.length == 1 + 1e-8
    with pytest.raises(ScrewError, match="A screw must have an axis"):
        screws.screw_axis([[0, 0, 1, 0, 0, 1], [0, 0, 0, 0, 0, 0]])
