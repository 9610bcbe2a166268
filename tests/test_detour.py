"""Laws of the detour: it keeps its distance, has no corner, is the shortest, and says what it cannot do."""

from itertools import pairwise

import numpy as np
import pytest

from lynx_common import arm, motion
from lynx_common.errors import CollisionError, EndpointError, InputError, JointLimitError, OutOfReachError

C = np.array([0, 0, 0.6, np.pi / 2, 0])  # report section 1.6, points 3 and 4
D = np.array([0, -0.2, 0.4, np.pi, 0])
CENTRE, RADIUS, MARGIN = (-0.2, 0.6), 0.15, 0.03
S = np.linspace(0, 1, 2001)
SHORTEST = 2 * np.sqrt(0.2**2 - 0.18**2) + 0.18 * (np.pi / 2 - 2 * np.arccos(0.9))


def length(path):
    return np.hypot(*np.diff(path(S)[:, 1:3], axis=0).T).sum()


def distance(path, centre=CENTRE):
    return np.hypot(*(path(S)[:, 1:3] - centre).T)


def case(rng):
    """A start, an end and a circle that is clear of both; all within reach."""
    while True:
        start, end = (
            np.array([0.4, r, z, np.pi / 2, 0.1]) for r, z in rng.uniform([-0.2, 0.25], [0.2, 0.5], (2, 2))
        )
        centre, radius = rng.uniform([-0.2, 0.2], [0.2, 0.5]), rng.uniform(0.01, 0.15)
        clear = min(np.hypot(*(p[1:3] - centre)) for p in (start, end)) > radius + 1e-3
        if clear and all(motion.follow(p[None]).ok for p in (start, end)):
            return start, end, centre, radius


def test_the_reports_detour_can_be_shortened_to_0_29473_m():
    path = motion.detour(C, D, CENTRE, RADIUS, MARGIN)
    assert length(path) == pytest.approx(SHORTEST, abs=1e-7)
    assert pytest.approx(0.29473, abs=5e-6) == SHORTEST
    assert distance(path).min() == pytest.approx(0.18)
    np.testing.assert_allclose(path([0, 1]), [C, D], atol=1e-12)


@pytest.mark.parametrize("turn", [1, -1, 0])
def test_it_joins_its_ends_keeps_its_distance_and_runs_at_even_speed(turn, rng):
    for _ in range(100):
        start, end, centre, radius = case(rng)
        path = motion.detour(start, end, centre, radius, turn=turn)
        np.testing.assert_allclose(path([0, 1]), [start, end], atol=1e-9)
        assert distance(path, centre).min() >= radius - 1e-9
        pieces = np.hypot(*np.diff(path(S)[:, 1:3], axis=0).T)
        bent = pieces.max() * (pieces.max() / radius) ** 2 / 24  # a chord is that much shorter than its arc
        assert np.ptp(pieces) <= bent + 1e-12
        np.testing.assert_allclose(
            path(S)[:, [0, 3, 4]], (1 - S)[:, None] * start[[0, 3, 4]] + S[:, None] * end[[0, 3, 4]]
        )


def test_it_has_no_corner(rng):
    for _ in range(20):
        start, end, centre, radius = case(rng)
        way = motion.detour(start, end, centre, radius)(S)
        assert np.abs(np.diff(way, 2, axis=0)).max() < 2e-3 / radius * S[1]


def test_no_way_over_one_or_two_other_points_is_shorter(rng):
    """Polylines that stay outside the circle are never shorter."""
    tried = 0
    for _ in range(300):
        start, end, centre, radius = case(rng)
        best = length(motion.detour(start, end, centre, radius))
        for corners in (1, 2):
            points = np.vstack([start[1:3], rng.uniform([-0.4, 0], [0.4, 0.7], (corners, 2)), end[1:3]])
            dense = np.concatenate([p + S[::20, None] * (q - p) for p, q in pairwise(points)])
            if np.hypot(*(dense - centre).T).min() >= radius:
                tried += 1
                assert np.hypot(*np.diff(points, axis=0).T).sum() >= best - 1e-3
    assert tried > 100


def test_it_takes_the_shorter_side_and_the_other_on_request():
    ways = {turn: length(motion.detour(C, D, CENTRE, RADIUS, MARGIN, turn)) for turn in (0, 1, -1)}
    assert ways[0] == ways[-1] < ways[1]
    assert ways[1] - ways[-1] == pytest.approx(0.18 * np.pi)  # the arcs are 90 and 270 deg, less the same


@pytest.mark.parametrize(("centre", "radius"), [((0.3, 0.2), 0.1), ((-0.3, 0.7), 0.1), ((-0.1, 0.5), 0.0)])
def test_a_clear_line_stays_straight(centre, radius):
    """Beside the segment, in line with it or off to a side; and a circle without size."""
    path = motion.detour(C, D, centre, radius)
    np.testing.assert_allclose(path(S), motion.line(C, D)(S), atol=1e-15)


def test_an_end_exactly_at_the_margin_is_allowed():
    path = motion.detour(C, D, CENTRE, RADIUS, 0.05)
    assert length(path) == pytest.approx(0.2 * np.pi / 2)
    assert np.isfinite(path(S)).all()


@pytest.mark.committed_lengths
def test_an_end_that_cannot_be_used_is_named_with_the_reason():
    with pytest.raises(
        EndpointError, match=r"The end of the motion cannot be used. It is 0.0500 m deep"
    ) as caught:
        motion.detour(C + [0, 0, -0.2, 0, 0], D, (-0.2, 0.45), 0.1)
    assert isinstance(caught.value.cause, CollisionError)
    with pytest.raises(
        EndpointError, match=r"The start .* 0.0500 m from the obstacle, where the margin .* 0.0600 m"
    ):
        motion.detour(C, D, CENTRE, RADIUS, 0.06)
    with pytest.raises(EndpointError, match=r"The end .* 0.6325 m from the shoulder") as caught:
        motion.detour(C, [0, -0.2, 0.8, np.pi / 2, 0], CENTRE, 0.05)
    assert isinstance(caught.value.cause, OutOfReachError)
    with pytest.raises(EndpointError, match=r"The start .* Joint") as caught:
        motion.detour([0, 0.1, 0.15, 0, 0], D, CENTRE, 0.05)
    assert isinstance(caught.value.cause, JointLimitError)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"end": C}, "length is zero"),
        ({"radius": -0.1}, "The radius is one finite number, not below 0; -0.1"),
        ({"radius": np.nan}, "The radius is one finite number"),
        ({"margin": -0.01}, "The margin is one finite number, not below 0; -0.01"),
        ({"margin": np.inf}, "The margin is one finite number"),
        ({"turn": 2}, "The turn is a whole number from -1 to 1"),
        ({"centre": (0, 0, 0)}, r"of shape \(2,\)"),
        ({"centre": (np.nan, 0)}, "Finite numbers"),
        ({"end": D + [0.5, 0, 0, 0, 0]}, "azimuths given are 0.00 and 28.65 deg"),
        ({"start": C * np.nan}, "Finite numbers are expected for task coordinates"),
        ({"start": np.stack([C, C])}, r"of shape \(5,\) are expected for task coordinates"),
    ],
)
def test_what_makes_no_sense_is_refused(change, sentence):
    given = {"start": C, "end": D, "centre": CENTRE, "radius": RADIUS, "margin": MARGIN}
    with pytest.raises(InputError, match=sentence):
        motion.detour(**given | change)


def test_another_arm_has_its_own_reach():
    short = arm.Geometry(0.1, 0.1, 0.1, 0.05)
    with pytest.raises(EndpointError, match="start"):
        motion.detour(C, D, CENTRE, RADIUS, geometry=short)


def test_at_a_tie_it_turns_from_r_towards_z():
    """The centre is on the line, give or take rounding."""
    for off in (-1e-15, 0, 1e-15):
        path = motion.detour(C, D, (-0.1 + off, 0.5), 0.05)
        np.testing.assert_allclose(path(S), motion.detour(C, D, (-0.1, 0.5), 0.05, turn=1)(S), atol=1e-9)
