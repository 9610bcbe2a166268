"""The door from SymPy to NumPy: shapes as promised, any batch, no plausible answer to bad input."""

import time
import tracemalloc

import numpy as np
import pytest
import sympy as sp

from lynx_common import symbolic
from lynx_common.errors import InputError
from lynx_common.symbolic import numeric, tidy

a, b, c = sp.symbols("a b c", real=True)
CONSTANT_INSIDE = sp.Matrix([[sp.cos(a), 0, b], [0, 1, a * b]])


@pytest.mark.parametrize("batch", [(), (1,), (0,), (7,), (3, 1, 2), (2, 0, 3)])
@pytest.mark.parametrize(
    ("expr", "shape"),
    [(a * b, ()), (sp.Integer(3), ()), (sp.Matrix([a, 0, b]), (3,)), (CONSTANT_INSIDE, (2, 3))],
)
def test_shapes_are_as_promised(expr, shape, batch, rng):
    result = numeric(expr, (a, b))(rng.uniform(size=(*batch, 2)))
    assert result.shape == batch + shape
    assert result.dtype == np.float64


def test_each_sample_of_a_batch_is_what_sympy_gives(rng):
    values = rng.uniform(-3, 3, (4, 3, 2))
    result = numeric(CONSTANT_INSIDE, (a, b))(values)
    for index in np.ndindex(4, 3):
        exact = CONSTANT_INSIDE.subs(dict(zip((a, b), values[index], strict=True)))
        np.testing.assert_allclose(result[index], np.array(exact, float), atol=1e-14)


def test_vectors_broadcast_against_each_other(rng):
    f = numeric(a * b + c, (a, b), (c,))
    x, y = rng.uniform(size=(5, 1, 2)), rng.uniform(size=(4, 1))
    np.testing.assert_allclose(f(x, y), x[..., 0] * x[..., 1] + y[:, 0], atol=1e-15)
    np.testing.assert_array_equal(f(x, [2.0]), f(x, np.full((5, 1, 1), 2.0)))


def test_chunks_do_not_show(rng, monkeypatch):
    values = rng.uniform(size=(101, 2))
    whole = numeric(CONSTANT_INSIDE, (a, b))(values)
    monkeypatch.setattr(symbolic._door, "CHUNK", 10)
    np.testing.assert_array_equal(numeric(CONSTANT_INSIDE, (a, b))(values), whole)


def test_integers_are_read_as_numbers():
    assert numeric(a / b, (a, b))([1, 2]) == 0.5


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_a_row_that_is_not_finite_is_nan_throughout_and_spoils_no_other(bad):
    result = numeric(CONSTANT_INSIDE, (a, b))([[0.1, 0.2], [bad, 0.2], [0.3, 0.4]])
    assert np.isnan(result[1]).all()
    assert np.isfinite(result[[0, 2]]).all()
    assert np.isnan(numeric(CONSTANT_INSIDE, (a,), (b,))([[0.1], [0.2]], [bad])).all()


@pytest.mark.filterwarnings("error")
def test_outside_its_domain_a_function_is_nan():
    assert np.isnan(numeric(sp.acos(a), (a,))([2.0]))


@pytest.mark.parametrize("bad", [[1 + 0j, 2], np.array([1j, 0])])
def test_complex_input_is_refused(bad):
    with pytest.raises(InputError, match=r"Real numbers are expected for \(a, b\)"):
        numeric(a * b, (a, b))(bad)


@pytest.mark.parametrize("bad", [[1.0], [1.0, 2.0, 3.0], 1.0, np.zeros((2, 3))])
def test_a_last_axis_of_another_length_is_refused(bad):
    with pytest.raises(InputError, match=r"must hold the 2 values \(a, b\)"):
        numeric(a * b, (a, b))(bad)


def test_a_symbol_that_no_vector_lists_is_named():
    with pytest.raises(InputError, match="also holds c,"):
        numeric(a * b + c, (a, b))


KINDS = {  # of formulas, and the shape of one value
    "a list": ([a, b], (2,)),
    "a tuple": ((a, b), (2,)),
    "a SymPy tuple": (sp.Tuple(a, b), (2,)),
    "nested lists": ([[a, 1], [0, b], [b, a]], (3, 2)),
    "an array": (sp.Array([a, b, 1]), (3,)),
    "an array of two axes": (sp.Array([[a, b, 1]]), (1, 3)),
    "an object array": (np.array([a, b]), (2,)),
    "a row": (sp.Matrix([[a, b]]), (1, 2)),
    "one by one": (sp.Matrix([[a]]), (1,)),
    "an immutable matrix": (sp.ImmutableMatrix([a, b]), (2,)),
    "a product not multiplied out": (sp.MatMul(sp.Matrix([[a, 1], [0, b]]), sp.Matrix([b, 1])), (2,)),
    "a number": (2.5, ()),
    "infinity": (sp.oo, ()),
    "real though written with I": (sp.exp(sp.I * a) + sp.exp(-sp.I * a), ()),
    "a derivative": (sp.Derivative(sp.sin(a) * b, a).doit(), ()),
}


@pytest.mark.parametrize("kind", KINDS)
def test_formulas_of_any_kind_become_functions_of_any_batch(kind, rng):
    expr, shape = KINDS[kind]
    values = rng.uniform(0.5, 1, (4, 2))
    f = numeric(expr, (a, b))
    assert f(values).shape == (4, *shape)
    np.testing.assert_allclose(f(values)[2], f(values[2]))
    as_list = [expr] if shape == () else list(sp.Matrix(expr) if not isinstance(expr, np.ndarray) else expr)
    exact = [complex(sp.sympify(e).subs(dict(zip((a, b), values[2], strict=True)))) for e in as_list]
    np.testing.assert_allclose(f(values[2]).ravel(), exact)


z = sp.Symbol("z")  # not said to be real
REFUSED = {
    "complex": (lambda: numeric(sp.Matrix([sp.exp(sp.I * z), z]), (z,)), r"complex: exp\(I\*z\)"),
    "a complex number": (lambda: numeric(sp.sqrt(-3)), r"complex: sqrt\(3\)\*I"),
    "a complex root": (lambda: numeric(sp.root(-8, 3) * z, (z,))([1.0]), "complex"),
    "a division by zero": (lambda: numeric([z, sp.zoo], (z,)), "division by zero"),
    "nothing": (lambda: numeric(sp.Matrix([]), (z,)), "no entries"),
    "no list": (lambda: numeric([], (z,)), "no entries"),
    "ragged": (lambda: numeric([[z], [z, z]], (z,)), "different lengths"),
    "three axes": (lambda: numeric(sp.Array([[[z]]]), (z,)), "no formula of SymPy"),
    "an equation": (lambda: numeric(sp.Eq(z, 1), (z,)), "no formula of SymPy"),
    "None": (lambda: numeric(None, (z,)), "holds None"),
    "a matrix without entries": (lambda: numeric(sp.MatrixSymbol("A", 2, 2), ()), "also holds A"),
    "a symbol without a comma": (lambda: numeric(z, z), r"such as \(x,\), are expected, not z"),
    "a name": (lambda: numeric(z, "z"), "are expected, not 'z'"),
    "no symbol": (lambda: numeric(z, (z, z + 1)), "one of them holds z \\+ 1"),
    "a symbol twice": (lambda: numeric(z, (z,), (z,)), "z is listed twice"),
    "too few arrays": (
        lambda: numeric(a * z, (a,), (z,))([1.0]),
        "each of a and z is expected; the number given is 1",
    ),
    "too many arrays": (lambda: numeric(z, (z,))([1.0], [2.0]), "each of z is expected; the number given is 2"),
    "an unknown function": (lambda: numeric(sp.Function("f")(z), (z,))([1.0]), "no NumPy function"),
    "an open derivative": (lambda: numeric(sp.Derivative(sp.gamma(z), z), (z,))([1.0]), "no NumPy function"),
}


@pytest.mark.parametrize("kind", REFUSED)
def test_what_cannot_become_a_function_gets_a_sentence(kind):
    call, sentence = REFUSED[kind]
    with pytest.raises(InputError, match=sentence):
        call()


def test_the_same_expression_is_compiled_once_and_not_before_its_first_call(monkeypatch):
    compiled = []
    original = sp.lambdify
    monkeypatch.setattr(sp, "lambdify", lambda *args, **kwargs: compiled.append(1) or original(*args, **kwargs))
    expr = sp.tan(a) * sp.Integer(time.time_ns())  # an expression that nobody compiled before
    f = numeric(expr, (a,))
    assert not compiled
    f([0.1]), f([0.2]), numeric(expr, (a,))([0.3])
    assert len(compiled) == 1


def test_a_large_batch_needs_little_more_memory_than_its_result():
    values, f = np.zeros((200_000, 2)), numeric(CONSTANT_INSIDE, (a, b))
    f(values[:1])
    tracemalloc.start()
    result = f(values)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak - result.nbytes < 2e6


def test_tidy_joins_angles_takes_out_factors_and_changes_no_value(rng):
    wide = c * sp.cos(a) * sp.cos(b) - c * sp.sin(a) * sp.sin(b) + c * sp.sin(a)
    assert tidy(wide) == c * (sp.sin(a) + sp.cos(a + b))
    assert tidy(sp.Matrix([[wide, 0]])) == sp.Matrix([[tidy(wide), 0]])
    values = rng.uniform(-3, 3, (50, 3))
    f, g = (numeric(e, (a, b, c)) for e in (wide, tidy(wide)))
    np.testing.assert_allclose(f(values), g(values), atol=1e-13)


def test_symbols_carry_the_assumptions_that_simplifying_needs():
    assert all(angle.is_real for angle in symbolic.Q)
    assert all(length.is_nonnegative for length in symbolic.P)
    assert [str(s) for s in (*symbolic.Q, *symbolic.P)] == [
        "theta_1", "theta_2", "theta_3", "theta_4", "theta_5", "d_1", "L_1", "L_2", "L_3",
    ]  # fmt: skip


# One sample is computed with ``math``, a batch with NumPy; nobody can tell.

HARD = [0.0, -0.0, 1.0, -1.0, 1e-300, 1e300, -8.0, 0.5, np.pi, np.nan, np.inf, -np.inf, 710.0]
TRICKY = {
    "a root of what may be negative": sp.cbrt(a),
    "a logarithm": sp.log(a),
    "a power": a**b,
    "a quotient": a / b,
    "an arc cosine": sp.acos(a),
    "the larger": sp.Max(a, b),
    "a sign": sp.sign(a),
    "a choice": sp.Piecewise((a, a > b), (b, a < b)),
    "a choice of two": sp.Piecewise((a, a > b), (sp.nan, True)),
    "an exponential": sp.exp(a),
    "an angle": sp.atan2(a, b),
    "a step": sp.ceiling(a) + sp.floor(b),
    "a tangent": sp.tan(a) * sp.Abs(b),
    "a matrix": sp.Matrix([[a * b, 1], [sp.sqrt(a), 0]]),
}


@pytest.mark.filterwarnings("ignore:divide by zero", "ignore:overflow", "ignore:invalid value")
@pytest.mark.parametrize("kind", TRICKY)
def test_one_sample_gives_what_a_batch_of_one_gives(kind, rng):
    f = numeric(TRICKY[kind], (a, b))
    hard = [[x, y] for x in HARD for y in HARD]
    for values in np.array([*hard, *rng.uniform(-3, 3, (50, 2))]):
        np.testing.assert_allclose(f(values), f(values[None])[0], rtol=1e-13, err_msg=str(values))
        np.testing.assert_array_equal(f(values.tolist()), f(values))


def test_a_formula_that_needs_no_argument_is_compiled_when_it_is_called():
    made = []

    @symbolic.compiled((a,), (b,))
    def product():
        made.append(1)
        return a * b

    assert made == []
    assert product([2.0], [3.0]) == 6
    assert product.formula() == a * b
    np.testing.assert_array_equal(product([[1.0], [2.0]], [3.0]), [3, 6])
    assert made == [1]
