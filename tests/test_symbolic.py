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
    monkeypatch.setattr(symbolic, "CHUNK", 10)
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
