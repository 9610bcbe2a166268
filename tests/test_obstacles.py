"""Laws of obstacles: clearance is the distance of the nearest point of the arm, and a proof is never wrong."""

import numpy as np
import pytest

from lynx_common import arm, certify, motion, obstacles
from lynx_common.errors import InputError

REPORT = obstacles.Sphere((-0.2, 0.0, 0.6), 0.15)  # report section 1.6
GEOMETRIES = [arm.LYNX, arm.Geometry(0.07, 0.3, 0.15, 0.0), arm.Geometry(0.0, 0.1, 0.25, 0.2)]
L = obstacles.lipschitz_constant()


def sphere(rng):
    return obstacles.Sphere(rng.uniform(-0.5, 0.5, 3), rng.uniform(0, 0.2))


def along_the_links(q, geometry=arm.LYNX, n=201):
    """Points on all links, n on each: (..., 5) to (..., 4 n, 3)."""
    points, share = arm.joint_positions(q, geometry), np.linspace(0, 1, n)[:, None]
    dense = points[..., :-1, None, :] * (1 - share) + points[..., 1:, None, :] * share
    return dense.reshape(*points.shape[:-2], -1, 3)


# Clearance


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_clearance_is_the_distance_of_the_nearest_of_many_points_on_the_links(geometry, rng):
    """Points a distance d apart miss the nearest one by at most d/2."""
    q = rng.uniform(-np.pi, np.pi, (300, 5))
    for _ in range(10):
        ball, thickness = sphere(rng), rng.uniform(0, 0.05)
        sampled = ball.distance(along_the_links(q, geometry)).min(axis=-1) - thickness
        exact = obstacles.clearance(q, ball, thickness, geometry=geometry)
        assert (exact <= sampled + 1e-12).all()
        assert (exact >= sampled - max(geometry) / 400 - 1e-12).all()
        assert np.median(sampled - exact) < 1e-4


@pytest.mark.committed_lengths
def test_clearance_of_known_postures():
    """Upright: from the base to 0.6 m above it."""
    upright = np.array([0.3, np.pi / 2, 0, np.pi / 2, 0])
    for centre, radius, expected in (
        ((0.2, 0, 0.3), 0.05, 0.15),  # beside
        ((0, 0, 0.9), 0.1, 0.2),  # above
        ((0, 0.3, -0.4), 0.1, 0.4),  # below, at an angle
        ((0, 0.02, 0.2), 0.05, -0.03),  # in it
        ((0.3, 0.4, 0.05), 0.0, 0.5),  # beside the base
    ):
        ball = obstacles.Sphere(centre, radius)
        assert obstacles.clearance(upright, ball) == pytest.approx(expected)
        assert obstacles.clearance(upright, ball, link_radius=0.01) == pytest.approx(expected - 0.01)


def test_the_whole_arm_counts_and_not_its_tip_alone():
    """Over the report's obstacle the elbow's way is not the tip's."""
    q = np.array([np.pi, 2.0, -1.8, 1.2, 0])
    ball = obstacles.Sphere(arm.joint_positions(q)[2], 0.05)
    assert obstacles.clearance(q, ball) == pytest.approx(-0.05)
    assert ball.distance(arm.joint_positions(q)[4]) > 0.1


def test_the_distance_of_points_is_signed():
    np.testing.assert_allclose(
        REPORT.distance([[-0.2, 0, 0.6], [-0.2, 0.15, 0.6], [0.2, 0, 0.9]]), [-0.15, 0, 0.35]
    )
    assert REPORT.distance(np.zeros((2, 0, 3))).shape == (2, 0)


@pytest.mark.parametrize("batch", [(), (1,), (0,), (3, 1, 2), (5000,)])
def test_any_batch(batch, rng):
    q = rng.uniform(-np.pi, np.pi, (*batch, 5))
    clear = obstacles.clearance(q, REPORT)
    assert clear.shape == batch
    if clear.size:
        assert clear.flat[-1] == pytest.approx(obstacles.clearance(q.reshape(-1, 5)[-1], REPORT))


@pytest.mark.filterwarnings("error")
def test_bad_numbers_never_give_a_plausible_clearance():
    q = np.array([[0, 0, 0, 0, 0], [0, 0, np.nan, 0, 0], [np.inf, 0, 0, 0, 0]])
    np.testing.assert_array_equal(np.isnan(obstacles.clearance(q, REPORT)), [False, True, True])
    for bad in (np.zeros(4), np.zeros(5) * 1j):
        with pytest.raises(InputError):
            obstacles.clearance(bad, REPORT)
    for thickness in (-0.1, np.nan, np.inf):
        with pytest.raises(InputError, match="radius of the links"):
            obstacles.clearance(q, REPORT, link_radius=thickness)


@pytest.mark.parametrize(
    ("centre", "radius"),
    [
        ((0, 0, 0), -0.1),
        ((0, 0, 0), np.nan),
        ((0, 0, 0), np.inf),
        ((0, 0, 0), [0.1, 0.2]),
        ((0, 0, np.nan), 0.1),
        ((0, 0), 0.1),
        ((0, 0, 1j), 0.1),
    ],
)
def test_a_ball_that_is_none_is_refused(centre, radius):
    with pytest.raises(InputError, match="of a sphere"):
        obstacles.Sphere(centre, radius)


def test_equal_spheres_are_equal():
    assert obstacles.Sphere(np.array([-0.2, 0, 0.6]), np.float64(0.15)) == REPORT


# The Lipschitz constant


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_no_clearance_changes_faster_than_its_lipschitz_constant(geometry, rng):
    """Over steps of all sizes, and nearly as fast where the arm is stretched towards the sphere."""
    constant = obstacles.lipschitz_constant(geometry)
    for size in (1e-4, 1e-2, 1.0):
        q = rng.uniform(-np.pi, np.pi, (20_000, 5))
        q[:10_000, 2:4] = 0, np.pi / 2
        step = size * rng.normal(size=q.shape)
        for _ in range(3):
            ball = sphere(rng)
            here, there = (obstacles.clearance(x, ball, geometry=geometry) for x in (q, q + step))
            change = there - here
            assert (np.abs(change) <= constant * np.linalg.norm(step, axis=1) + 1e-12).all()


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_the_lipschitz_constant_is_met_where_the_stretched_arm_swings(geometry):
    """All three joints of the plane turn it towards a sphere above its tip; so a smaller one would be wrong."""
    d_1, L_1, L_2, L_3 = geometry
    levers = np.array([0, L_1 + L_2 + L_3, L_2 + L_3, L_3, 0])
    q, step = np.array([0, 0, 0, np.pi / 2, 0]), 1e-6 * levers / np.linalg.norm(levers)
    ball = obstacles.Sphere((levers[1], 0, d_1 + 1), 0.1)
    here, there = (obstacles.clearance(x, ball, geometry=geometry) for x in (q, q + step))
    change = here - there
    assert change / 1e-6 == pytest.approx(obstacles.lipschitz_constant(geometry), rel=1e-4)


# Proofs


def dense(f, q, n=400):
    """Least value at n points of each segment."""
    share = np.linspace(0, 1, n)[:, None, None]
    return f(((1 - share) * q[:-1] + share * q[1:]).reshape(-1, q.shape[1])).min()


def test_what_is_certified_no_dense_sampling_refutes(rng):
    """Random motions and spheres, with a minimum just above or below what is kept; the proven bound, too."""
    verdicts = []
    for _ in range(300):
        ball, q = sphere(rng), rng.uniform(-3, 3, 5) + rng.normal(0, 0.3, (rng.integers(2, 6), 5))

        def f(q, ball=ball):
            return obstacles.clearance(q, ball)

        sampled = dense(f, q)
        minimum = sampled + rng.choice([-1, 1]) * 10 ** rng.uniform(-7, -1)
        found = certify.along(f, L, q, minimum, budget=5000)
        verdicts.append(found.verdict)
        assert found.bound <= sampled
        assert found.evaluations <= 5000
        if found.verdict == "certified":
            assert minimum <= found.bound
        if found.verdict == "refuted":
            assert f(found.witness) < minimum
        if sampled < minimum:
            assert found.verdict != "certified"
        if sampled > minimum + 0.01:
            assert found.verdict == "certified"
        if sampled < minimum - 0.01:
            assert found.verdict == "refuted"
    assert min(verdicts.count(verdict) for verdict in ("certified", "refuted", "undecided")) > 20


def test_a_dip_between_samples_is_found_where_the_samples_are_clear():
    """A spike 1e-3 rad wide in the middle of nowhere, with slopes as steep as is allowed."""

    def f(q):
        return np.abs(q[:, 0] - 0.2345678) - 5e-4

    ends = np.array([[0.0], [1.0]])
    found = certify.along(f, 1.0, ends)
    assert found.verdict == "refuted"
    assert found.witness == pytest.approx(0.2345678, abs=5e-4)
    assert certify.along(f, 1.0, ends, minimum=-6e-4).verdict == "certified"


def test_the_proof_needs_the_lipschitz_constant_and_halving():
    """f has slopes of 1 and 0.1 to spare at its lowest: the whole segment, of length 1, is not enough."""

    def f(q):
        return 0.1 + np.abs(q[:, 0] - 0.3)

    found = certify.along(f, 1.0, np.array([[0.0], [1.0]]))
    assert (found.verdict, found.witness) == ("certified", None)
    assert 0 <= found.bound <= 0.1
    assert 3 < found.evaluations < 20
    assert certify.along(f, 2.0, np.array([[0.0], [1.0]])).evaluations > found.evaluations


def test_the_bound_of_one_piece_is_the_value_in_its_middle_less_half_its_length():
    found = certify.along(lambda q: 5.5 + 0 * q[:, 0], 2.0, np.array([[0.0, 0.0], [3.0, 4.0]]))
    assert (found.verdict, found.evaluations) == ("certified", 3)
    assert found.bound == pytest.approx(5.5 - 2 * 5 / 2)


def test_the_bound_is_the_least_of_all_rounds():
    """The first piece, where f is lowest, is done with at once; the last one has to be halved."""

    def f(q):
        return np.clip(q[:, 0] - 0.05, 0.15, 0.45)

    found = certify.along(f, 1.0, np.array([[0.0], [0.2], [0.5], [1.5]]))
    assert (found.verdict, found.evaluations) == ("certified", 7 + 2)
    assert found.bound == pytest.approx(0.05)


def test_clear_motions_of_the_arm_are_certified_and_the_report_s_detour_is_not():
    """Table 1.5 c to d, straight in task coordinates, runs through the report's obstacle with the elbow."""
    task = motion.line([0, 0, 0.6, np.pi / 2, 0], [0, -0.2, 0.4, np.pi, 0])(np.linspace(0, 1, 101))
    q = motion.follow(task).q
    hit = certify.along(lambda q: obstacles.clearance(q, REPORT), L, q)
    assert hit.verdict == "refuted"
    assert obstacles.clearance(hit.witness, REPORT) < 0
    aside = obstacles.Sphere((0.0, 0.4, 0.6), 0.15)
    clear = certify.along(lambda q: obstacles.clearance(q, aside), L, q, minimum=0.2)
    assert clear.verdict == "certified"


def test_a_start_in_collision_is_refuted_at_once():
    q = np.array([[0, np.pi / 2, 0, np.pi / 2, 0], [2, np.pi / 2, 0, np.pi / 2, 0]])
    ball = obstacles.Sphere((0, 0, 0.3), 0.1)
    found = certify.along(lambda q: obstacles.clearance(q, ball), L, q)
    assert (found.verdict, found.evaluations) == ("refuted", 3)
    assert obstacles.clearance(found.witness, ball) == pytest.approx(-0.1)


@pytest.mark.parametrize("end", [0, -1])
def test_a_violation_at_one_end_only_is_found(end):
    def f(q):
        return np.abs(q[:, 0] - [0.0, 1.0][end]) - 1e-9

    assert certify.along(f, 1.0, np.array([[0.0], [1.0]])).verdict == "refuted"


def test_a_motion_that_touches_the_minimum_is_neither_certified_nor_refuted():
    found = certify.along(lambda q: np.abs(q[:, 0] - 1 / 3), 1.0, np.array([[0.0], [1.0]]))
    assert found.verdict == "undecided"
    assert -1e-11 < found.bound <= 0
    assert found.evaluations < 1000


def test_when_the_budget_is_spent_it_says_so():
    q = np.array([[0.0], [1.0]])
    f = lambda q: 0.001 + np.abs(q[:, 0] - 1 / 3)  # noqa: E731
    for budget in (0, 2, 3, 10):
        found = certify.along(f, 1.0, q, budget=budget)
        assert (found.verdict, found.witness) == ("undecided", None)
        assert found.evaluations <= budget
        assert found.bound == -np.inf if budget < 3 else -0.5 < found.bound < 0
    assert certify.along(f, 1.0, q, budget=100).verdict == "certified"


def test_rounding_is_taken_off_the_bound():
    def f(q):
        return 1e-9 + 0 * q[:, 0]

    assert certify.along(f, 0.0, np.zeros((2, 1))).verdict == "certified"
    assert certify.along(f, 0.0, np.zeros((2, 1)), rounding=1e-8).verdict == "undecided"
    assert certify.along(f, 1.0, np.full((2, 1), 1e8)).verdict == "undecided"  # q itself is known to 1e-8 only


@pytest.mark.parametrize("samples", [np.zeros((1, 3)), np.zeros((4, 3)), np.repeat(np.eye(3), 2, axis=0)])
def test_single_samples_and_pieces_of_no_length(samples):
    assert certify.along(lambda q: 2 - q.sum(axis=1), 2.0, samples).verdict == "certified"
    assert certify.along(lambda q: -1 - q.sum(axis=1), 2.0, samples).verdict == "refuted"


@pytest.mark.parametrize(
    ("f", "lipschitz", "q", "minimum", "message"),
    [
        (np.sum, 1, np.zeros(5), 0, r"shape \(n, m\) are expected for the samples of a motion"),
        (np.sum, 1, np.zeros((0, 5)), 0, r"shape \(0, 5\)"),
        (np.sum, 1, np.zeros((2, 0)), 0, r"shape \(2, 0\)"),
        (
            np.sum,
            1,
            np.array([[0, 1], [np.nan, 0]]),
            0,
            r"Finite numbers are expected for the samples of a motion; \[nan, 0.0\] was given in row 1",
        ),
        (np.sum, 1, np.zeros((2, 5)) * 1j, 0, "Real numbers are expected for the samples of a motion"),
        (lambda q: q[:, 0] * 1j, 1, np.zeros((2, 5)), 0, "Real numbers are expected for the quantity"),
        (np.sum, 1, np.zeros((2, 5)), 1j, "Real numbers are expected for the minimum"),
        (np.sum, -1, np.zeros((2, 5)), 0, "Lipschitz constant is one finite number, not below 0; -1 was given"),
        (np.sum, np.nan, np.zeros((2, 5)), 0, "Lipschitz constant"),
        (np.sum, 1, np.zeros((2, 5)), np.nan, "minimum"),
        (lambda q: np.log(q[:, 0] - 1), 1, np.array([[0.0], [1.5]]), 0, r"quantity is nan at q = \[0.0\]"),
        (lambda q: np.inf + q[:, 0], 1, np.array([[0.0], [1.5]]), 0, "quantity is inf"),
    ],
)
@pytest.mark.filterwarnings("ignore:invalid value")
def test_what_cannot_be_proven_about_is_refused(f, lipschitz, q, minimum, message):
    with pytest.raises(InputError, match=message):
        certify.along(f, lipschitz, q, minimum)


@pytest.mark.parametrize("f", [lambda q: 1.0, lambda q: np.ones((len(q), 1))])
def test_one_value_a_posture_is_expected(f):
    with pytest.raises(InputError, match=r"one number a posture, shape \(3,\); its shape is \("):
        certify.along(f, 1.0, np.zeros((2, 5)))
