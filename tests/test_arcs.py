"""Plane regions of arcs: area, perimeter and volume against closed forms and against a fine grid."""

import numpy as np
import pytest
import sympy as sp

from lynx_common.arcs import Region, annulus, crossings
from lynx_common.errors import InputError

pi = np.pi


def disc(x, y, radius):
    return annulus(x, y, 0, radius)


LENS = disc(0, 0, 1) & disc(1, 0, 1)
SHAPES = {
    "disc": (disc(0.3, -0.2, 0.5), pi / 4, pi),
    "annulus": (annulus(1, 2, 0.3, 0.7), pi * (0.49 - 0.09), 2 * pi),
    "lens": (LENS, 2 * pi / 3 - 3**0.5 / 2, 4 * pi / 3),
    "union": (disc(0, 0, 1) | disc(1, 0, 1), 4 * pi / 3 + 3**0.5 / 2, 8 * pi / 3),
    "two pieces": (disc(-2, 0, 1) | disc(2, 0, 1), 2 * pi, 4 * pi),
    "touching": (disc(-1, 0, 1) | disc(1, 0, 1), 2 * pi, 4 * pi),
    "touching within": (disc(0, 0, 1) | disc(0.5, 0, 0.5), pi, 2 * pi),
    "nothing": (disc(-2, 0, 1) & disc(2, 0, 1), 0, 0),
    "a point": (disc(-1, 0, 1) & disc(1, 0, 1), 0, 0),
    "twice the same": (disc(0, 0, 1) & disc(0, 0, 1), pi, 2 * pi),
    "no radius": (disc(0, 0, 0), 0, 0),
}


@pytest.mark.parametrize("name", SHAPES)
def test_area_and_perimeter_of_known_shapes(name):
    region, area, perimeter = SHAPES[name]
    assert region.area == pytest.approx(area, abs=1e-12)
    assert region.perimeter == pytest.approx(perimeter, abs=1e-12)


def random_region(seed):
    rng = np.random.default_rng(seed)
    a, b, c, d = (annulus(*rng.uniform(-0.5, 0.5, 2), *np.sort(rng.uniform(0.2, 1.2, 2))) for _ in range(4))
    return [a & b & c, a & b | c, (a | b) & (c | d), a & b.mirror()][seed % 4]


def grid_cells(n):
    at = (np.arange(n) + 0.5) / n * 4 - 2
    return np.stack(np.meshgrid(at, at), axis=-1), (4 / n) ** 2


@pytest.mark.parametrize("seed", range(6))
def test_area_and_volume_agree_with_a_fine_grid(seed):
    region = random_region(seed)
    points, cell = grid_cells(1001)
    inside = region.contains(points)
    assert region.area == pytest.approx(inside.sum() * cell, abs=3e-3)
    assert region.volume == pytest.approx(pi * np.abs(points[inside][:, 0]).sum() * cell, abs=9e-3)


@pytest.mark.parametrize("seed", range(6))
def test_area_agrees_with_the_polygon_of_its_boundary(seed):
    region = random_region(seed)
    loops = region.boundary(step=3e-4)
    area = sum(0.5 * np.sum(p[:-1, 0] * p[1:, 1] - p[1:, 0] * p[:-1, 1]) for p in loops)
    length = sum(np.linalg.norm(np.diff(p, axis=0), axis=1).sum() for p in loops)
    assert region.area == pytest.approx(area, rel=1e-7, abs=1e-9)
    assert region.perimeter == pytest.approx(length, rel=1e-7, abs=1e-9)
    assert all((p[0] == p[-1]).all() for p in loops)


@pytest.mark.parametrize("seed", range(5))
def test_the_inside_lies_on_the_left_of_the_boundary(seed):
    region = random_region(seed)
    for loop in region.boundary():
        ahead = np.diff(loop, axis=0)
        ahead = ahead[long := np.linalg.norm(ahead, axis=1) > 1e-3]
        middle = ((loop[1:] + loop[:-1]) / 2)[long]
        left = np.stack([-ahead[:, 1], ahead[:, 0]], axis=-1)
        assert region.contains(middle + 0.1 * left).mean() > 0.97  # all but some next to corners


def test_volumes_of_known_solids():
    ball = disc(0, 1, 0.5)
    assert ball.volume == pytest.approx(4 / 3 * pi * 0.125, rel=1e-12)
    shell = annulus(0, 0, 0.2 * 2**0.5, 0.4)
    assert shell.volume == pytest.approx(4 / 3 * pi * (0.064 - 0.008 * 2**1.5), rel=1e-12)
    ring = disc(2, 0, 0.5)
    torus = 2 * pi * 2 * pi * 0.25  # Pappus: path of the centre times area
    assert (ring | ring.mirror()).volume == pytest.approx(torus, rel=1e-12)
    for half in (ring, ring.mirror()):
        assert half.volume == pytest.approx(torus / 2, rel=1e-12)


@pytest.mark.parametrize("width", [1e-3, 1e-6, 1e-9])
def test_however_thin_a_ring_is_it_is_seen(width):
    ring = annulus(0.3, -0.2, 1 - width, 1)
    assert ring.area == pytest.approx(np.pi * width * (2 - width), rel=1e-5)
    assert ring.perimeter == pytest.approx(2 * np.pi * (2 - width), rel=1e-6)
    slit = annulus(0, 0, 0, 1) & annulus(2 - width, 0, 0, 1)  # a lens, as long as 2 sqrt(width)
    assert slit.area == pytest.approx(4 / 3 * width**1.5, rel=1e-3)


def test_circles_that_touch_but_for_rounding_meet_once():
    for rounding in (1e-12, -1e-12):
        touching = annulus(0, 0, 0, 1) | annulus(2 + rounding, 0, 0, 1)
        assert touching.area == pytest.approx(2 * np.pi)
        assert touching.arcs[:, 4] == pytest.approx(2 * np.pi, rel=1e-12)


def test_the_closed_forms_agree_with_integrals():
    """A disc that the line x = 0 cuts: its arcs are halved there."""
    x = sp.Symbol("x", real=True)
    chord = 2 * sp.sqrt(1 - (x - sp.Rational(1, 5)) ** 2)
    parts = ((x, sp.Rational(-4, 5), 0), (x, 0, sp.Rational(6, 5)))
    area, volume = (sum(sp.Integral(f * chord, part).n() for part in parts) for f in (1, sp.pi * sp.Abs(x)))
    assert disc(0.2, 0.7, 1).area == pytest.approx(float(area), rel=1e-9)
    assert disc(0.2, 0.7, 1).volume == pytest.approx(float(volume), rel=1e-9)


def test_around_is_what_a_link_reaches_about_every_point():
    assert annulus(0, 0, 1, 2).around(0.3).area == pytest.approx(pi * (2.3**2 - 0.7**2), rel=1e-12)
    assert disc(0, 0, 0.5).around(0.6).area == pytest.approx(pi * (1.1**2 - 0.1**2), rel=1e-12)
    convex = LENS.area + 0.3 * LENS.perimeter + pi * 0.3**2  # Steiner's formula; its circles touch each other
    assert LENS.around(0.3).area == pytest.approx(convex, rel=1e-12)
    rng = np.random.default_rng(4)
    for region in (LENS, LENS & annulus(0.5, 0.3, 0.4, 2), annulus(0, 0, 1, 1.5)):
        for radius in (0.2, 0.9, 1.4):
            grown = region.around(radius)
            points = rng.uniform(-3, 3, (500, 2))
            turn = np.linspace(0, 2 * pi, 2000)
            circle = points[:, None] + radius * np.stack([np.cos(turn), np.sin(turn)], axis=-1)
            sampled = region.contains(circle).any(axis=1)
            near_its_edge = grown.distances(points)[0] < 1e-2
            assert (grown.contains(points) == sampled)[~near_its_edge].all()
            assert 20 < sampled.sum() < 480


def test_distances_to_the_boundary():
    rng = np.random.default_rng(5)
    points = rng.uniform(-2, 3, (20, 2))
    for region in (LENS, annulus(0.3, 0, 0.5, 1)):
        line = np.vstack(region.boundary(step=1e-4))
        gaps = np.linalg.norm(points[:, None] - line, axis=-1)
        near, far = region.distances(points)
        np.testing.assert_allclose(near, gaps.min(axis=1), atol=1e-4)
        np.testing.assert_allclose(far, gaps.max(axis=1), atol=1e-4)


@pytest.mark.parametrize(
    ("circles", "sentence"),
    [
        ([(0, 0)], r"shape \(n, 3\) are expected for circles, rows of x, y and radius"),
        ([(0, 0, -1)], "radius is not negative; -1 was given"),
        ([(0, 0, np.nan)], r"Finite .* circles, rows of x, y and radius; \[0.0, 0.0, nan\]"),
        ([(0, np.inf, 1)], "Finite .* circles"),
    ],
)
def test_bad_circles_are_refused(circles, sentence):
    with pytest.raises(InputError, match=sentence):
        Region(circles, lambda points: points[..., 0] > 0)


@pytest.mark.parametrize(
    ("ring", "sentence"),
    [
        ((0, 0, 0.5, 0.2), "outer radius .* not below 0.5; 0.2 was given"),
        ((0, 0, -0.1, 0.2), "inner radius .* not below 0; -0.1 was given"),
        ((0, 0, np.nan, 1), "inner radius .* finite"),
        ((0, 0, 0, np.inf), "outer radius .* finite"),
        ((0, np.nan, 0, 1), "centre of an annulus"),
    ],
)
def test_bad_annuli_are_refused(ring, sentence):
    with pytest.raises(InputError, match=sentence):
        annulus(*ring)


@pytest.mark.parametrize("radius", [-0.1, np.nan, [1, 2], 1j])
def test_around_asks_for_one_radius(radius):
    with pytest.raises(InputError, match="radius"):
        LENS.around(radius)


def test_circles_cross_at_their_radii_from_both_centres(rng):
    a, b, point = rng.normal(size=(3, 50, 2))
    rho_a, rho_b = (np.linalg.norm(point - centre, axis=-1, keepdims=True) for centre in (a, b))
    both = np.array(crossings(a, rho_a, b, rho_b))
    np.testing.assert_allclose(np.linalg.norm(both - a, axis=-1, keepdims=True), [rho_a] * 2, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(both - b, axis=-1, keepdims=True), [rho_b] * 2, atol=1e-12)
    left = np.cross(np.pad(b - a, [(0, 0), (0, 1)]), np.pad(both[0] - a, [(0, 0), (0, 1)]))[:, 2]
    assert (left > 0).all()
    assert np.isclose(both, point, atol=1e-6).all(axis=-1).any(axis=0).all()
