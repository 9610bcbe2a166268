"""Laws of intervals: bounds contain every value, and get tight as boxes shrink; proofs over boxes."""

import mpmath
import numpy as np
import pytest
import sympy as sp

from lynx_common import certify, rrr
from lynx_common.errors import InputError
from lynx_common.symbolic import DESIGN, POSE, enclose

x, y = sp.symbols("x y", real=True)
FORMULAS = {
    "sum": x + y,
    "difference": x - y - 3,
    "product": x * y,
    "square": x**2,
    "cube": x**3,
    "fourth power": (x - 1) ** 4,
    "seventh power": x**7,
    "quotient": x / (y + 7),
    "inverse square": (x + 9) ** -2,
    "root": sp.sqrt(x + 9),
    "inverse root": 1 / sp.sqrt(x + 9),
    "root cubed": sp.sqrt(x + 9) ** 4,
    "sine": sp.sin(x),
    "cosine": sp.cos(3 * x - y),
    "constants": sp.pi * x / 3 + sp.Rational(1, 7) - sp.Float("0.1"),
    "large angles": sp.sin(1000 * x) + sp.cos(10**6 * y),
    "large numbers": x + 2**60 + 1,
    "all": sp.sqrt(x**2 + y**2 + 1) * sp.cos(x * y) / (2 + sp.sin(y)) ** 3,
}


@pytest.mark.parametrize("name", FORMULAS)
def test_bounds_contain_the_value_at_both_ends_and_in_the_middle(name, rng):
    """Values are computed with 60 digits; boxes of no width are the hardest, for there only rounding has room."""
    formula = FORMULAS[name]
    exactly, bounds = sp.lambdify((x, y), formula, "mpmath"), enclose(formula, (x,), (y,))
    with mpmath.workdps(60):
        for width in (0.0, 1e-9, 1e-3, 1.0):
            low = rng.uniform(-5, 5, (40, 2))
            low[:8] = np.round(low[:8] * 2) / 2
            ends = np.stack([low, low + width], axis=-1)
            lower, upper = bounds(ends[:, :1], ends[:, 1:])
            for box, least, most in zip(ends, lower, upper, strict=True):
                for share in (0.0, 0.5, 1.0):
                    a, b = (mpmath.mpf(one[0]) + share * (mpmath.mpf(one[1]) - one[0]) for one in box)
                    assert least <= exactly(a, b) <= most


@pytest.mark.parametrize("name", [name for name in FORMULAS if "large" not in name])
def test_bounds_shrink_with_the_box(name, rng):
    at = rng.uniform(-4, 4, (20, 2))
    bounds = enclose(FORMULAS[name], (x, y))
    widths = [np.subtract(*bounds(np.stack([at - w, at + w], axis=-1))[::-1]) for w in (1e-4, 1e-7)]
    assert (widths[1] <= 1e-2 * widths[0] + 1e-11).all()


@pytest.mark.parametrize("number", [sp.Rational(1, 3), sp.Rational(1, 10), sp.pi, sp.Integer(2**60 + 1)])
def test_what_no_float_holds_lies_between_its_bounds(number):
    lower, upper = enclose(number, (x,))([[0, 1]])
    assert sp.Rational(float(lower)) < number < sp.Rational(float(upper))
    assert float(upper - lower) <= 3 * np.spacing(float(number))


def test_crests_and_troughs_are_seen():
    for wave, crest in ((sp.cos(x), 0), (sp.sin(x), np.pi / 2)):
        bounds = enclose(wave, (x,))
        for turn in (-3, 0, 5):
            around = crest + 2 * np.pi * turn + np.array([[[-0.1, 0.1]], [[np.pi - 0.1, np.pi + 0.1]]])
            lower, upper = bounds(around)
            assert (upper[0], lower[1]) == (1, -1)
            np.testing.assert_allclose([lower[0], upper[1]], [np.cos(0.1), -np.cos(0.1)], atol=1e-13)


@pytest.mark.parametrize(
    ("formula", "box"),
    [
        (1 / x, [-1, 1]),
        (1 / x, [0, 1]),
        (sp.sqrt(x), [-1e-300, 1]),
        (1 / (1 + 1 / x**2), [-1, 1]),
        (sp.cos(1 / x), [-1, 1]),
        (x / (x - 1), [0, 2]),
        (sp.sqrt(x) ** 4 - 1 / (x - 2), [1, 3]),
    ],
)
def test_outside_of_the_domain_no_bounds_are_given(formula, box):
    assert not np.isfinite(enclose(formula, (x,))([box])).all()


def test_shapes_are_those_of_numeric(rng):
    box = np.stack([np.zeros((4, 1, 2)), rng.uniform(0, 1, (4, 1, 2))], axis=-1)
    for formula, shape in ((x * y, ()), (sp.Matrix([x, y, 1]), (3,)), (sp.Matrix([[x, 0, 2]] * 2), (2, 3))):
        lower, upper = enclose(formula, (x, y))(box)
        assert lower.shape == upper.shape == (4, 1, *shape)
        assert enclose(formula, (x, y))(box[:0])[0].shape == (0, 1, *shape)


def test_what_cannot_be_enclosed_is_refused():
    for formula, sentence in (
        (sp.atan2(y, x), "atan2"),
        (sp.Abs(x), "Abs"),
        (x ** sp.Rational(1, 3), "cannot be"),
    ):
        with pytest.raises(InputError, match=sentence):
            enclose(formula, (x, y))
    with pytest.raises(InputError, match="One box for each of 1 vectors is expected, not 2"):
        enclose(x, (x,))([[0, 1]], [[0, 1]])
    with pytest.raises(InputError, match="listed twice"):
        enclose(x, (x,), (x,))
    with pytest.raises(InputError, match="also holds y"):
        enclose(x + y, (x,))
    with pytest.raises(InputError, match=r"lower end above its upper"):
        enclose(x, (x,))([[1, 0]])
    with pytest.raises(InputError, match=r"must be \(1, 2\)"):
        enclose(x, (x,))([1, 0, 3])


# Proofs over boxes

UNIT = [[-1, 1], [-1, 1]]


def test_a_proof_is_found_refuted_or_left_open():
    bowl = enclose(x**2 + y**2 - x * y + sp.Rational(1, 100), (x, y))
    proof = certify.over(bowl, UNIT)
    assert proof.verdict == "certified"
    assert 0 < proof.bound <= 0.01
    assert certify.holds(bowl, UNIT, proof.boxes)
    shifted = certify.over(enclose(x**2 + y**2 - 0.01, (x, y)), UNIT)
    assert shifted.verdict == "refuted"
    assert (shifted.witness**2).sum() < 0.01
    touching = certify.over(enclose(x**2 + y**2, (x, y)), UNIT, budget=5000)
    assert touching.verdict == "undecided"
    assert -0.1 <= touching.bound <= 0


def test_a_box_without_bounds_proves_nothing():
    assert certify.over(enclose(1 + 1 / x**2, (x,)), [[-1, 1]], budget=1000).verdict == "undecided"


def test_half_a_bound_proves_nothing():
    def half(boxes):
        return np.ones(len(boxes)), np.full(len(boxes), np.nan)

    assert certify.over(half, UNIT, budget=100).verdict == "undecided"
    below = enclose(x - 5, (x, y))
    assert certify.over(below, UNIT, within=lambda boxes: (half(boxes)[1], -half(boxes)[0])).verdict == "undecided"


def test_only_what_is_within_has_to_be_proven():
    disc = enclose(1 - x**2 - y**2, (x, y))
    tilted = enclose(sp.Rational(3, 2) + x + y, (x, y))
    assert certify.over(tilted, UNIT).verdict == "refuted"
    proof = certify.over(tilted, UNIT, within=disc)
    assert proof.verdict == "certified"
    assert proof.bound <= 1.5 - np.sqrt(2)
    assert certify.holds(tilted, UNIT, proof.boxes, within=disc)
    assert not certify.holds(tilted, UNIT, proof.boxes)


def test_what_is_proven_again_has_neither_gap_nor_wrong_box():
    bowl = enclose(x**2 + y**2 - x * y + sp.Rational(1, 100), (x, y))
    boxes = certify.over(bowl, UNIT).boxes
    moved, turned = boxes.copy(), boxes[::-1]
    moved[3] += 1e-9
    assert certify.holds(bowl, UNIT, turned)
    assert not certify.holds(bowl, UNIT, moved)
    assert not certify.holds(bowl, UNIT, boxes[1:])
    assert not certify.holds(bowl, UNIT, [UNIT])
    assert not certify.holds(bowl, [[-1, 1], [-1, 1.1]], boxes)
    assert not certify.holds(enclose(x + y, (x, y)), UNIT, boxes)


def determinant(mode):
    """Bounds of the normalised det A of the 3-RRR in a working mode, over boxes of poses."""
    lengths, corners = map(sp.Integer, (170, 130, 130, 290)), [sp.pi / 2, 7 * sp.pi / 6, 11 * sp.pi / 6]
    exact = dict(zip(DESIGN, (*lengths, *corners, *corners), strict=True))
    entries = sp.symbols("a:9")
    u, v, w = (sp.Matrix(3, 3, entries)[i, :] for i in range(3))
    rows, det = enclose(rrr.formulas.unit_rows(mode).xreplace(exact), POSE), enclose(u.dot(v.cross(w)), entries)
    return lambda box: det(np.stack(rows(box), axis=-1).reshape(*box.shape[:-2], 9, 2))


def region(degrees):
    return [[-60, 60], [-60, 60], np.deg2rad([-degrees, degrees])]


def test_the_determinant_of_a_mode_is_that_of_its_motor_angles(rng):
    poses = rng.uniform([-60, -60, -0.5], [60, 60, 0.5], (500, 3))
    theta = rrr.inverse_kinematics(poses)
    for number, mode in enumerate(rrr.WORKING_MODES):
        lower, upper = determinant(mode)(np.stack([poses, poses], axis=-1))
        A, _ = rrr.jacobians(poses, theta[:, number])
        expected = np.linalg.det(A) / (rrr.RRR.L**3 * rrr.RRR.r_platform)
        np.testing.assert_allclose(lower, expected, atol=1e-10)
        np.testing.assert_allclose(upper, expected, atol=1e-10)


def test_the_3_rrr_keeps_the_sign_of_its_determinant_to_31_degrees_and_not_to_33(rng):
    det = determinant(rrr.WORKING_MODES[0])

    def negative(box):
        lower, upper = det(box)
        return -upper, -lower

    proof = certify.over(negative, region(31))
    assert proof.verdict == "certified"
    assert certify.holds(negative, region(31), proof.boxes)
    poses = rng.uniform(*np.transpose(region(31)), (100_000, 3))
    assert (-det(np.stack([poses, poses], axis=-1))[0] >= proof.bound).all()
    refuted = certify.over(negative, region(33))
    assert refuted.verdict == "refuted"
    theta = rrr.inverse_kinematics(refuted.witness)[0]
    assert np.linalg.det(rrr.jacobians(refuted.witness, theta)[0]) > 0
