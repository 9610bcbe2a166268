"""Drawings put things where the robot's module says they are."""

from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.path import Path

from lynx_common import arm, drawing, obstacles, screws
from lynx_common.arcs import annulus

Q = np.array([1.0, 0.8, -0.5, 1.2, 0.4])


@pytest.fixture
def views():
    fig, space, plane = drawing.two_views()
    yield space, plane
    plt.close(fig)


def in_plane(points, q=Q):
    return np.stack([points[..., 0] * np.cos(q[0]) + points[..., 1] * np.sin(q[0]), points[..., 2]])


def test_the_links_join_the_joints_in_both_views(views):
    space, plane = views
    links, _ = drawing.arm_3d(space, Q)
    flat, _ = drawing.arm_side_view(plane, Q)
    np.testing.assert_allclose(np.transpose(links.get_data_3d()), arm.joint_positions(Q))
    np.testing.assert_allclose(flat.get_data(), in_plane(arm.joint_positions(Q)))
    assert plane.get_aspect() == 1


def test_the_view_from_above_leaves_out_the_height(views):
    flat, _ = drawing.arm_top_view(views[1], Q)
    np.testing.assert_allclose(flat.get_data(), arm.joint_positions(Q)[:, :2].T)


def test_the_side_view_shows_links_at_full_length(views):
    flat, _ = drawing.arm_side_view(views[1], Q)
    np.testing.assert_allclose(np.hypot(*np.diff(flat.get_data())), list(arm.LYNX))


def test_the_fork_points_along_z_and_opens_along_x():
    T = arm.forward_kinematics(Q)
    tip_1, palm_1, palm, palm_2, tip_2 = drawing.gripper(T, 0.03)
    np.testing.assert_allclose((tip_1 + tip_2) / 2, T[:3, 3])
    np.testing.assert_allclose(tip_2 - tip_1, 0.03 * T[:3, 0])
    np.testing.assert_allclose([tip_1 - palm_1, tip_2 - palm_2, T[:3, 3] - palm], [0.03 * T[:3, 2]] * 3)


def test_frames_are_drawn_in_the_colours_of_their_axes(views):
    T = arm.link_frames(Q)
    lines = drawing.frames_3d(views[0], T, length=0.1)
    for i, (axis, line) in enumerate(zip("xyz", lines, strict=True)):
        assert line.get_color() == drawing.COLOURS[axis]
        points = np.transpose(line.get_data_3d()).reshape(6, 3, 3)
        np.testing.assert_allclose(points[:, 1] - points[:, 0], 0.1 * T[:, :3, i], atol=1e-12)
        assert np.isnan(points[:, 2]).all()


def test_moving_lines_is_drawing_them_anew(views):
    space, plane = views
    other = Q + 0.3
    moved = drawing.arm_3d(space, Q), drawing.arm_side_view(plane, Q)
    drawing.move(*moved, other)
    fresh = drawing.arm_3d(space, other), drawing.arm_side_view(plane, other)
    for a, b in zip(moved[0], fresh[0], strict=True):
        np.testing.assert_array_equal(a.get_data_3d(), b.get_data_3d())
    for a, b in zip(moved[1], fresh[1], strict=True):
        np.testing.assert_array_equal(a.get_data(), b.get_data())


def test_both_views_are_drawn_at_once(views):
    lines, flat = drawing.arm_views(*views, Q, color="red")
    np.testing.assert_allclose(np.transpose(lines[0].get_data_3d()), arm.joint_positions(Q))
    np.testing.assert_allclose(flat[0].get_data(), in_plane(arm.joint_positions(Q)))
    assert {line.get_color() for line in (*lines, *flat)} == {"red"}


def test_a_target_is_a_star_with_a_line_back_to_the_wrist(views):
    space, plane = views
    star = drawing.target(space, [0.1, 0.2, 0.3])
    np.testing.assert_allclose(np.ravel(star.get_data_3d()), [0.1, 0.2, 0.3])
    pitch = arm.task_coordinates(Q)[3]
    _, _, _, wrist, gripper = in_plane(arm.joint_positions(Q)).T
    line = drawing.target(plane, gripper, pitch, markersize=9)
    np.testing.assert_allclose(np.transpose(line.get_data()), [gripper, wrist])
    assert [line.get_marker(), line.get_markevery(), line.get_markersize()] == ["*", [0], 9]
    np.testing.assert_allclose(np.ravel(drawing.target(plane, gripper).get_data()), gripper)


def test_labels_stand_at_the_joints_of_the_picture(views):
    space, plane = views
    drawing.space_3d(space, arm.joint_positions(Q))
    drawing.arm_side_view(plane, Q)
    drawing.label_joints(plane, Q)
    drawing.label_joints(space, Q)
    for ax in views:
        assert [text.get_text() for text in ax.texts] == ["base", "shoulder", "elbow", "wrist", "gripper"]
    np.testing.assert_allclose([text.xy for text in plane.texts], in_plane(arm.joint_positions(Q)).T)


def test_a_label_can_be_put_elsewhere(views):
    drawing.label_joints(views[1], Q, shoulder=(-12, 4))
    by_name = {text.get_text(): text for text in views[1].texts}
    assert [by_name["shoulder"].xyann, by_name["shoulder"].get_horizontalalignment()] == [(-12, 4), "right"]
    assert by_name["wrist"].xyann == (0, 12)


def test_the_fork_is_thinner_than_the_links(views):
    for width in (4, 3):
        links, fork = drawing.arm_side_view(views[1], Q, linewidth=width, label="once")
        assert [links.get_label(), fork.get_label().startswith("_")] == ["once", True]  # in a legend
        assert [links.get_linewidth(), fork.get_linewidth()] == [width, 0.625 * width]


def test_a_zoom_makes_the_box_in_space_larger(views):
    once, zoomed = (drawing.space_3d(views[0], arm.joint_positions(Q), zoom=z).get_box_aspect() for z in (1, 1.2))
    np.testing.assert_allclose(zoomed, 1.2 * np.array(once))


def test_a_box_in_space_has_equal_scales_and_holds_the_points_and_the_floor(views, rng):
    points = rng.uniform([-0.1, -0.2, 0.3], [0.3, 0.4, 0.5], (2, 50, 3))
    ax = drawing.space_3d(views[0], points)
    low, high = np.transpose([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()])
    assert (low <= points.min(axis=(0, 1))).all()
    assert (high >= points.max(axis=(0, 1))).all()
    assert low[2] == 0
    np.testing.assert_allclose(ax.get_box_aspect() / ax.get_box_aspect()[0], (high - low) / (high - low)[0])


def test_the_schema_names_every_joint_angle_length_and_axis():
    fig, (left, right) = plt.subplots(1, 2)
    drawing.dh_schema(left)
    drawing.wrist_schema(right)
    words = " ".join(text.get_text() for text in left.texts)
    for name in [f"\\theta_{i}" for i in range(1, 6)] + ["d_1", "L_1", "L_2", "L_3"]:
        assert f"${name}$" in words
    for axes, frames in ((left, "01235"), (right, "345")):
        words = [text.get_text() for text in axes.texts]
        assert {f"${axis}_{i}$" for axis in "xyz" for i in frames} <= set(words)
    plt.close(fig)


def test_the_link_is_named_and_its_steps_are_marked_where_they_are_taken():
    fig, ax = plt.subplots()
    drawing.link_schema(ax)
    at = {text.get_text(): np.array(getattr(text, "xy", text.get_position())) for text in ax.texts}
    assert {"$d$", "$a$", r"$\theta$", r"$\alpha$", "1", "2", "3", "4"} <= at.keys()
    steps = [np.array(text.xy) for text in ax.texts if text.get_text() == "1"]
    foot, tip = np.transpose(ax.lines[0].get_data())[1:]
    axes = [np.transpose(line.get_data()) for line in ax.lines if line.get_linestyle() == "--"]
    for axis in axes:  # one mark on each joint axis
        assert min(np.abs(axis - step).max(axis=1).min() for step in steps) < 1e-12
    np.testing.assert_allclose(at["3"], tip)
    assert abs(np.linalg.det([at["2"] - foot, tip - foot])) < 1e-12  # on the common normal
    plt.close(fig)


def test_the_triangle_is_named_and_its_arcs_are_the_joints_own_angles():
    fig, ax = plt.subplots()
    drawing.triangle_schema(ax)
    names = [f"\\theta_{i}" for i in (2, 3)] + ["L_1", "L_2", "h", "r_{wrist}"]
    assert {text.get_text() for text in ax.texts} == {f"${name}$" for name in names}
    _, shoulder, elbow, wrist, _ = np.transpose(ax.lines[0].get_data())
    angles = [np.rad2deg(np.arctan2(*(end - start)[::-1])) for start, end in ((shoulder, elbow), (elbow, wrist))]
    first, second = ax.patches
    np.testing.assert_allclose([first.theta1, first.theta2, *first.center], [0, angles[0], *shoulder])
    np.testing.assert_allclose([second.theta1, second.theta2, *second.center], [angles[1], angles[0], *elbow])
    legs, drawn_on = ax.lines[3:5]
    np.testing.assert_allclose(legs.get_data(), np.transpose([shoulder, [wrist[0], shoulder[1]], wrist]))
    np.testing.assert_allclose(ax.lines[2].get_data(), np.transpose([shoulder, wrist]))
    at = {text.get_text(): text.xy for text in ax.texts}
    np.testing.assert_allclose([at["$\\theta_2$"], at["$\\theta_3$"]], [shoulder, elbow])
    np.testing.assert_allclose([at["$L_1$"], at["$L_2$"]], [(shoulder + elbow) / 2, (elbow + wrist) / 2])
    np.testing.assert_allclose([at["$h$"][0], at["$r_{wrist}$"][1]], [wrist[0], shoulder[1]])
    assert np.isclose(np.cross(np.append(elbow - shoulder, 0), np.append(np.diff(drawn_on.get_data()), 0))[2], 0)
    plt.close(fig)


def test_a_set_style_is_what_figures_get():
    with plt.rc_context():
        drawing.use_style()
        assert plt.rcParams["figure.constrained_layout.use"]
        assert plt.rcParams["font.size"] >= 11


def test_a_region_is_filled_within_its_boundary_and_not_in_its_holes(views):
    ring = annulus(0.1, 0.2, 0.3, 0.5)
    path = drawing.region_2d(views[1], ring).get_path()
    rng = np.random.default_rng(0)
    points = rng.uniform(-0.5, 0.8, (1000, 2))
    points = points[ring.distances(points)[0] > 1e-3]
    outer, hole = np.split(path.vertices, [len(path.vertices) // 2])
    inside = Path(outer).contains_points(points) ^ Path(hole).contains_points(points)
    assert (inside == ring.contains(points)).all()
    assert np.flatnonzero(path.codes == Path.MOVETO).tolist() == [0, len(outer)]


def test_an_empty_region_draws_nothing():
    assert drawing.region_path(annulus(-2, 0, 0, 1) & annulus(2, 0, 0, 1)).vertices.tolist() == [[0, 0]]


def test_a_cloud_has_a_dot_at_each_point_in_the_plane_and_in_space(views, rng):
    space, plane = views
    points = rng.uniform(0, 1, (20, 3))
    np.testing.assert_array_equal(np.transpose(drawing.cloud(space, points).get_data_3d()), points)
    dots = drawing.cloud(plane, points[:, :2], 3, color="red")
    np.testing.assert_array_equal(np.transpose(dots.get_data()), points[:, :2])
    assert [dots.get_marker(), dots.get_linestyle(), dots.get_markersize()] == [".", "None", 3]
    assert [dots.get_color(), dots.get_rasterized()] == ["red", True]


def test_each_square_stands_where_its_centre_is(views):
    values = np.arange(6).reshape(3, 2)
    image = drawing.squares(views[1], values, [0.1, -0.2], 0.5, vmax=9)
    left, right, bottom, top = image.get_extent()
    x, y = np.arange(left, right, 0.5) + 0.25, np.arange(bottom, top, 0.5) + 0.25
    np.testing.assert_allclose(x, [0.1, 0.6, 1.1])
    np.testing.assert_allclose(y, [-0.2, 0.3])
    np.testing.assert_array_equal(image.get_array()[0], values[:, 0])  # the lowest row
    assert [image.origin, image.get_clim()] == ["lower", (0, 9)]
    drawing.squares(views[1], values > 2, [0.1, -0.2], 0.5)  # truth values, too
    few, many = image.cmap([0.0, 1.0])[:, :3].sum(axis=1)
    assert many < few  # darker
    views[1].get_figure().draw_without_rendering()
    assert not any(line.get_visible() for line in views[1].get_xgridlines())


def test_an_arm_without_its_gripper_is_its_links_only(views):
    space, plane = views
    (links,) = drawing.arm_3d(space, Q, with_gripper=False)
    (flat,) = drawing.arm_side_view(plane, Q, with_gripper=False, color="red")
    np.testing.assert_allclose(np.transpose(links.get_data_3d()), arm.joint_positions(Q))
    np.testing.assert_allclose(flat.get_data(), in_plane(arm.joint_positions(Q)))
    assert flat.get_color() == "red"


def test_a_view_in_space_names_the_unit(views):
    corners = np.array([[0, 0, 0], [1, 2, 3.0]])
    space = drawing.space_3d(views[0], corners, unit="units")
    assert (space.get_xlabel(), space.get_ylabel(), space.get_zlabel()) == ("x [units]", "y [units]", "z [units]")
    assert drawing.space_3d(space, corners).get_zlabel() == "z [m]"


def test_a_ball_has_its_centre_and_its_radius(views):
    ball = obstacles.Sphere((1.0, -2.0, 3.0), 0.5)
    space, _ = views
    shell = drawing.ball_3d(space, ball, alpha=0.7)
    bounds = [*space.xy_dataLim.get_points().T, space.zz_dataLim.get_points()[:, 0]]
    np.testing.assert_allclose(bounds, [[0.5, 1.5], [-2.5, -1.5], [2.5, 3.5]])
    assert shell.get_alpha() == 0.7
    recorder = SimpleNamespace(plot_surface=lambda *points, **_: np.stack(points, axis=-1))
    np.testing.assert_allclose(ball.distance(drawing.ball_3d(recorder, ball)), 0, atol=1e-12)


def test_the_line_of_a_screw_is_drawn_about_the_point_asked_for(views):
    twist = screws.revolute([0, 0.6, 0.8], [1, 2, 3])
    line = drawing.screw_3d(views[0], twist, half=2, middle=5, color="red")
    ends = np.transpose(line.get_data_3d())
    assert line.get_color() == "red"
    axis = np.array([0, 0.6, 0.8])
    foot = np.array([1, 2, 3]) - axis * (axis @ [1, 2, 3])  # the point of the line that is nearest to the origin
    np.testing.assert_allclose(ends, [foot + 3 * axis, foot + 7 * axis], atol=1e-12)


def test_a_tree_is_drawn_edge_by_edge_in_degrees(views):
    q = np.deg2rad([[0, 0, 5], [10, 0, 6], [10, 20, 7]])
    line = drawing.tree_2d(views[1], SimpleNamespace(q=q, parent=np.array([-1, 0, 0])), (0, 2), color="red")
    nan = np.nan
    np.testing.assert_allclose(line.get_data(), [[10, 0, nan, 10, 0, nan], [6, 5, nan, 7, 5, nan]])
    assert line.get_color() == "red"


def test_the_determinant_map_is_that_of_the_wrist_with_its_zero_lines(views):
    geometry = arm.Geometry(0.1, 0.3, 0.2, 0.15)
    shading = drawing.determinant_map(views[1], geometry, samples=7)
    values = np.reshape(shading.get_array(), (7, 7))
    for row, bend in ((1, -120), (4, 60)):  # of seven
        q = np.deg2rad([0, 60, bend, 0, 0])  # column 4
        J = arm.jacobian(q, arm.Geometry(0.1, 0.3, 0.2, 0))[:3, :3]
        np.testing.assert_allclose(values[row, 4], np.linalg.det(J), atol=1e-6)
    assert values[4, 4] < -1e-3 < 1e-3 < values[1, 4]
    assert sorted({line.get_ydata()[0] for line in views[1].lines}) == [-180, 0, 180]
    drawing.determinant_map(views[1], geometry)
    curves = views[1].collections[-1]
    theta_2, theta_3 = np.deg2rad(np.concatenate([path.vertices for path in curves.get_paths()]).T)
    assert len(theta_2) > 100
    np.testing.assert_allclose(0.3 * np.cos(theta_2) + 0.2 * np.cos(theta_2 + theta_3), 0, atol=1e-3)
