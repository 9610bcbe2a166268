"""The picture of the 3-RRR robot shows links at their lengths, and gaps where a leg does not close."""

from itertools import combinations

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.path import Path

from lynx_common import drawing, rrr
from lynx_common.drawing._rrr import STYLES

OTHER = rrr.Geometry(90.0, 140.0, 60.0, 200.0, base_angles=(0.1, 2.0, 4.5), platform_angles=(0.3, 2.2, 4.0))
POSE, MODE = np.array([20.0, 30.0, 0.3]), 5


@pytest.fixture
def ax():
    fig, ax = plt.subplots()
    yield ax
    plt.close(fig)


def lines_of(artists):
    """Points of each line by name; legs as (3, 2, 2): leg, end, coordinate."""
    lines = dict(zip(STYLES, (np.transpose(line.get_data()) for line in artists), strict=False))
    return {name: line.reshape(3, 3, 2)[:, :2] if len(line) == 9 else line for name, line in lines.items()}


def gaps_of(artists):
    return [text.get_text() for text in artists[len(STYLES) :]]


def poses(rng, n=25):
    """Poses of which about half can be assembled."""
    return rng.uniform([-150, -150, -2], [150, 150, 2], (n, 3))


@pytest.mark.parametrize("geometry", [rrr.RRR, OTHER])
def test_links_have_their_lengths_whether_legs_close_or_not(geometry, ax, rng):
    for pose in poses(rng):
        theta = rrr.inverse_kinematics(pose, geometry)[rng.integers(8)]
        lines = lines_of(drawing.rrr_2d(ax, pose, theta, geometry))
        driven, distal = lines["driven link $S_A$"], lines["distal link $L$"]
        np.testing.assert_allclose(np.linalg.norm(np.diff(driven, axis=1), axis=-1)[:, 0], geometry.S_A)
        np.testing.assert_allclose(np.linalg.norm(np.diff(distal, axis=1), axis=-1)[:, 0], geometry.L)
        np.testing.assert_allclose(driven[:, 0], rrr.base_joints(geometry))
        np.testing.assert_allclose(driven[:, 1], distal[:, 0])


@pytest.mark.parametrize("geometry", [rrr.RRR, OTHER])
def test_a_leg_ends_at_its_platform_joint_or_as_near_as_it_can(geometry, ax, rng):
    open_legs = 0
    nearest, farthest = abs(geometry.S_A - geometry.L), geometry.S_A + geometry.L
    for pose in poses(rng):
        theta = rrr.inverse_kinematics(pose, geometry)[0]
        artists = drawing.rrr_2d(ax, pose, theta, geometry)
        ends, PP = lines_of(artists)["distal link $L$"][:, 1], rrr.platform_joints(pose, geometry)
        span = np.linalg.norm(PP - rrr.base_joints(geometry), axis=1)
        missing = np.maximum(nearest - span, 0) + np.maximum(span - farthest, 0)
        np.testing.assert_allclose(np.linalg.norm(PP - ends, axis=1), missing, atol=1e-9)
        assert gaps_of(artists) == [f"{gap:.1f} mm" for gap in missing if gap]
        open_legs += np.count_nonzero(missing)
    assert open_legs > 10


def test_elbows_bend_as_the_working_mode_says(ax):
    for signs, theta in zip(rrr.WORKING_MODES, rrr.inverse_kinematics(POSE), strict=True):
        lines = lines_of(drawing.rrr_2d(ax, POSE, theta))
        (ux, uy), (vx, vy) = (np.diff(lines[n], axis=1)[:, 0].T for n in ("driven link $S_A$", "distal link $L$"))
        assert tuple(np.sign(ux * vy - uy * vx)) == signs


def test_angles_of_another_pose_leave_gaps_that_are_drawn_and_measured(ax):
    theta = rrr.inverse_kinematics(POSE)[MODE] + [0, 0.5, -0.9]
    artists = drawing.rrr_2d(ax, POSE, theta)
    lines, M, PP = lines_of(artists), rrr.elbows(theta), rrr.platform_joints(POSE)
    np.testing.assert_allclose(lines["driven link $S_A$"][:, 1], M)
    apart = np.linalg.norm(PP - M, axis=1)
    assert gaps_of(artists) == [f"{gap:.1f} mm" for gap in abs(apart - rrr.RRR.L)[1:]]
    assert min(abs(apart - rrr.RRR.L)[1:]) > 1
    gaps = lines["gap"]
    assert np.isnan(gaps[0]).any()
    np.testing.assert_allclose(gaps[1:, 1], PP[1:])
    np.testing.assert_allclose(gaps[1:, 0], lines["distal link $L$"][1:, 1])
    beside = [text.get_position() for text in artists[len(STYLES) :]]
    offset = beside - gaps[1:].mean(axis=1)
    np.testing.assert_allclose(np.linalg.norm(offset, axis=1), rrr.RRR.r_platform / 8)
    np.testing.assert_allclose((offset * np.diff(gaps[1:], axis=1)[:, 0]).sum(axis=1), 0, atol=1e-9)
    away_from_the_needle = np.linalg.norm(beside - POSE[:2], axis=1)
    assert (away_from_the_needle > np.linalg.norm(gaps[1:].mean(axis=1) - POSE[:2], axis=1)).all()


def test_the_size_of_a_gap_begins_beside_it_whatever_the_direction(ax, rng):
    """On the left of the gap the text ends there, on the right it begins there; above and below likewise."""
    seen = set()
    for theta in rng.uniform(-np.pi, np.pi, (40, 3)):
        artists = drawing.rrr_2d(ax, POSE, theta)
        (_, ends), PP = np.moveaxis(lines_of(artists)["distal link $L$"], 1, 0), rrr.platform_joints(POSE)
        for text, middle in zip(artists[len(STYLES) :], (ends + PP) / 2, strict=True):
            right, up = (text.get_position() - middle) / (rrr.RRR.r_platform / 8)
            assert text.get_ha() == ("left" if right > 0.3 else "right" if right < -0.3 else "center")
            assert text.get_va() == ("bottom" if up > 0.3 else "top" if up < -0.3 else "center")
            seen.add((text.get_ha(), text.get_va()))
    assert len(seen) == 8


def test_base_platform_and_needle_are_where_the_robot_has_them(ax):
    lines = lines_of(drawing.rrr_2d(ax, POSE, rrr.inverse_kinematics(POSE)[MODE]))
    np.testing.assert_allclose(lines["base"], rrr.base_joints()[[0, 1, 2, 0]])
    np.testing.assert_allclose(lines["platform"], rrr.platform_joints(POSE)[[0, 1, 2, 0]])
    np.testing.assert_allclose(lines["needle"], [POSE[:2]])
    assert ax.get_aspect() == 1
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("X [mm]", "Y [mm]")
    seen = np.vstack([rrr.base_joints(), rrr.elbows(rrr.inverse_kinematics(POSE)[MODE])])
    for limits, values in zip((ax.get_xlim(), ax.get_ylim()), seen.T, strict=True):
        assert limits[0] < values.min()
        assert limits[1] > values.max()


def test_each_part_has_its_colour_and_its_name(ax):
    artists = drawing.rrr_2d(ax, POSE, rrr.inverse_kinematics(POSE)[MODE], alpha=0.4)[: len(STYLES)]
    assert [line.get_label() for line in artists] == list(STYLES)
    assert len({line.get_color() for line in artists}) == len(STYLES)
    assert {line.get_color() for line in artists} <= set(drawing.COLOURS.values())
    assert {line.get_alpha() for line in artists} == {0.4}
    assert [line.get_markersize() for line in artists] == [9, 5, 5, 5, 5, 11]


def test_a_platform_joint_on_its_base_joint_is_drawn_folded(ax):
    pose = [*(rrr.base_joints()[0] - rrr.platform_joints([0, 0, 0])[0]), 0]
    artists = drawing.rrr_2d(ax, pose, rrr.inverse_kinematics(pose)[0])
    assert gaps_of(artists)[0] == "40.0 mm"
    assert np.isfinite(lines_of(artists)["distal link $L$"]).all()


def test_names_stand_at_the_joints(ax):
    theta = rrr.inverse_kinematics(POSE)[MODE]
    drawing.label_rrr(ax, POSE, theta)
    names = {text.get_text(): text.xy for text in ax.texts}
    for name, points in (("PB", rrr.base_joints()), ("M", rrr.elbows(theta)), ("PP", rrr.platform_joints(POSE))):
        np.testing.assert_allclose([names[f"${name}_{i}$"] for i in (1, 2, 3)], points)
    np.testing.assert_allclose(names["$C$"], POSE[:2])
    assert len(names) == 10


def test_on_the_printed_card_holes_are_at_a_quarter_of_the_robots_distances():
    """Measured on paper, in mm; fastened at the base, too, the elbows stand as the locked motors hold them."""
    theta = np.deg2rad([257.07, 17.07, 137.07])
    fig = drawing.card(theta)
    (ax,) = fig.axes
    on_paper = {"base": [], "platform": [], "driven": [], "distal": []}
    for patch in ax.patches:
        if patch.get_label().endswith(" hole"):
            pixel = ax.transData.transform(patch.center)
            on_paper[patch.get_label().removesuffix(" hole")].append(pixel / fig.dpi * 25.4)
    quarter = {part: 4 * np.array(holes) for part, holes in on_paper.items()}
    for part, length in (("driven", rrr.RRR.S_A), ("distal", rrr.RRR.L)):
        links = quarter[part].reshape(3, 2, 2)
        np.testing.assert_allclose(np.linalg.norm(links[:, 1] - links[:, 0], axis=-1), length)
    base, platform = quarter["base"] - quarter["base"][:3].mean(axis=0), quarter["platform"]
    np.testing.assert_allclose(base, np.concatenate([rrr.base_joints(), rrr.elbows(theta)]), atol=1e-9)
    np.testing.assert_allclose(platform[:3] - platform[3], rrr.platform_joints([0, 0, 0]), atol=1e-9)
    np.testing.assert_allclose(fig.get_size_inches() * 25.4, [210, 297])
    plt.close(fig)


def test_every_hole_of_the_card_is_in_its_part_and_parts_do_not_touch():
    fig = drawing.card(np.deg2rad([257.07, 17.07, 137.07]))
    outlines, holes = {}, []
    for patch in fig.axes[0].patches:
        path = patch.get_path().transformed(patch.get_patch_transform()).to_polygons()[0]
        if patch.get_label().endswith("hole"):
            holes.append((patch.get_label().split()[0], path))
        else:
            outlines.setdefault(patch.get_label(), []).append(Path(path))
    for part, hole in holes:
        assert any(outline.contains_points(hole).all() for outline in outlines[part])
    parts = [outline for some in outlines.values() for outline in some]
    assert len(parts) == 8
    assert not any(a.intersects_path(b) for a, b in combinations(parts, 2))
    assert all(((outline.vertices > 5) & (outline.vertices < [205, 275])).all() for outline in parts)
    plt.close(fig)
