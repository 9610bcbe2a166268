"""A formula as text in another language computes what the package computes, and needs nothing of it."""

import re
import shutil
import subprocess

import numpy as np
import pytest
import sympy as sp

from lynx_common import arm, rrr
from lynx_common.errors import InputError
from lynx_common.symbolic import DESIGN, POSE, TASK, XYZ, P, Q, code, numeric

OCTAVE, CC = shutil.which("octave-cli"), shutil.which("cc") or shutil.which("gcc")
LANGUAGES = [
    pytest.param("matlab", marks=pytest.mark.skipif(not OCTAVE, reason="Octave is not installed here")),
    "python",
    pytest.param("c", marks=pytest.mark.skipif(not CC, reason="no C compiler is installed here")),
]
SAMPLES = 1000


def in_matlab(text: str, name: str, arrays: list[np.ndarray], size: int, folder) -> np.ndarray:
    (folder / f"{name}.m").write_text(text)
    np.savetxt(folder / "in.txt", np.hstack(arrays), fmt="%.17g")
    ends = np.cumsum([x.shape[1] for x in arrays])
    given = ", ".join(f"in(i, {end - x.shape[1] + 1}:{end})" for x, end in zip(arrays, ends, strict=True))
    program = f"""in = load("in.txt"); file = fopen("out.txt", "w");
    for i = 1:rows(in)
      out = {name}({given});
      if !isreal(out), error("complex"); end
      fprintf(file, "%.17g ", out.'); fprintf(file, "\\n");
    end
    fclose(file);"""
    command = [OCTAVE, "--no-init-file", "--no-history", "--quiet", "--eval", program]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return np.loadtxt(folder / "out.txt", ndmin=2).reshape(-1, size)


def in_python(text: str, name: str, arrays: list[np.ndarray], size: int, folder) -> np.ndarray:
    fresh: dict = {}
    exec(compile(text, name, "exec"), fresh)
    rows = zip(*(x.tolist() if x.shape[1] > 1 else x[:, 0].tolist() for x in arrays), strict=True)
    return np.array([np.ravel(fresh[name](*row)) for row in rows])


def in_c(text: str, name: str, arrays: list[np.ndarray], size: int, folder) -> np.ndarray:
    width = sum(x.shape[1] for x in arrays)
    ends = np.cumsum([x.shape[1] for x in arrays])
    given = [
        f"in[{end - 1}]" if x.shape[1] == 1 else f"in + {end - x.shape[1]}"
        for x, end in zip(arrays, ends, strict=True)
    ]
    call = f"out[0] = {name}({', '.join(given)});"
    if f"void {name}" in text:
        call = f"{name}({', '.join([*given, '(void *)out'])});"
    program = f"""{text}
    #include <stdio.h>
    int main(void) {{
      double in[{width}], out[{size}];
      while (1) {{
        for (int i = 0; i < {width}; i++) if (scanf("%lf", in + i) != 1) return 0;
        {call}
        for (int i = 0; i < {size}; i++) printf("%.17g ", out[i]);
      }}
    }}"""
    (folder / "run.c").write_text(program)
    subprocess.run([CC, "-Wall", "-Werror", "run.c", "-o", "run", "-lm"], cwd=folder, check=True)
    numbers = "\n".join(" ".join(map("{:.17g}".format, row)) for row in np.hstack(arrays))
    run = subprocess.run([folder / "run"], input=numbers, capture_output=True, text=True, check=True)
    return np.array(run.stdout.split(), float).reshape(-1, size)


RUN = {"matlab": in_matlab, "python": in_python, "c": in_c}


def computed(expr, vectors, arrays, language, folder) -> np.ndarray:
    text = code(expr, *vectors, name="the_formula", language=language, about="What it is.\nUnits.")
    size = len(expr) if isinstance(expr, sp.MatrixBase) else 1
    return RUN[language](text, "the_formula", arrays, size, folder)


def lengths(rng, n: int = SAMPLES) -> np.ndarray:
    """Of arms of all kinds, the committed one first."""
    return np.vstack([arm.LYNX, rng.uniform(0.05, 0.4, (n - 1, 4))])


def close(found: np.ndarray, expected: np.ndarray, turn: float = np.inf) -> None:
    """The same to 1e-9, NaN in the same places; angles by full turns: at a half turn rounding takes either."""
    expected = expected.reshape(found.shape)
    np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
    np.testing.assert_array_equal(np.isinf(found), np.isinf(expected))
    some = np.isfinite(found)
    np.testing.assert_allclose(np.mod(found[some] - expected[some] + 1, turn), 1, rtol=0, atol=1e-9)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("formula", ["pose", "jacobian", "task_coordinates"])
def test_forward_and_jacobian_of_the_arm(formula, language, rng, tmp_path):
    q, p = rng.uniform(-np.pi, np.pi, (SAMPLES, 5)), lengths(rng)
    q[:2] = [0, 0, 0, np.pi / 2, 0], [0, np.pi / 2, 0, np.pi / 2, 0]  # stretched out, upright
    expr = getattr(arm.formulas, formula)()
    given = {"pose": arm.forward_kinematics, "jacobian": arm.jacobian, "task_coordinates": arm.task_coordinates}
    expected = np.array([given[formula](a, arm.Geometry(*b)) for a, b in zip(q, p, strict=True)])
    close(computed(expr, (Q, P), [q, p], language, tmp_path), expected)


@pytest.mark.parametrize("language", LANGUAGES)
def test_all_branches_of_the_arm(language, rng, tmp_path):
    """Out of reach too, at full stretch, at a hair beyond it, and over the base axis."""
    p = lengths(rng)
    position, angles = rng.uniform(-0.5, 0.5, (SAMPLES, 3)), rng.uniform(-np.pi, np.pi, (SAMPLES, 2))
    p[:8], angles[:8], far = arm.LYNX, 0, sum(arm.LYNX) - arm.LYNX.d_1
    position[:4] = [[far, 0, 0.1], [far * (1 + 1e-10), 0, 0.1], [far * (1 + 1e-6), 0, 0.1], [0, 0, 0.4]]
    position[4:8] = [[0, 0.3, 0.2], [-0.3, 0, 0.2], [-far, 0, 0.1], [0, 0, 0.7]]
    angles[[3, 7], 0] = np.pi / 2
    vectors = XYZ, TASK[3:4], TASK[4:], P
    found = computed(
        arm.formulas.branches(), vectors, [position, *np.split(angles, 2, axis=1), p], language, tmp_path
    )
    expected = np.array(
        [
            arm.inverse_kinematics(at, *turn, geometry=arm.Geometry(*b))
            for at, turn, b in zip(position, angles, p, strict=True)
        ]
    )
    close(found, expected, 2 * np.pi)
    assert 0.2 < np.isnan(found).any(axis=1).mean() < 0.8
    assert np.isfinite(found[[0, 1, 3]]).all()
    assert np.isnan(found[[2, 7]]).all()


@pytest.mark.parametrize("language", LANGUAGES)
def test_all_working_modes_of_the_parallel_robot(language, rng, tmp_path):
    pose = rng.uniform([-300, -300, -np.pi], [300, 300, np.pi], (SAMPLES, 3))
    span = np.array([300, 40, 300 + 1e-6, 40 - 1e-6])  # leg 1 stretched, folded, and a hair beyond
    pose[:4] = np.column_stack([np.zeros(4), 160 - span, np.zeros(4)])
    design = np.broadcast_to(np.array(rrr.RRR), (SAMPLES, len(DESIGN)))
    found = computed(rrr.formulas.working_modes(), (POSE, DESIGN), [pose, design], language, tmp_path)
    close(found, rrr.inverse_kinematics(pose), 2 * np.pi)
    assert (np.isnan(found).any(axis=0) & np.isfinite(found).any(axis=0)).all()
    assert np.isfinite(found[:2, 0]).all()
    assert np.isnan(found[2:4, 0]).all()


x, y = sp.symbols("x y", real=True)
HARD = [
    (sp.sqrt(x), 1),
    (sp.acos(x) + sp.asin(y), 1),
    (1 / sp.sqrt(x - y) ** 3, 1),
    (10**30 * x + 2**53 * y, 1),
    (sp.Matrix([sp.atan2(y, x), sp.sign(x), sp.ceiling(y), sp.Max(x, y, 0)]), 4),
    (sp.Piecewise((sp.sqrt(x), x > 0), (y, y > 1)) * sp.Piecewise((1, x < 2), (2, True)), 1),
    (sp.Piecewise((sp.Piecewise((1, y > 0), (2, True)), x > 0), (sp.ceiling(y), True)), 1),
]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("expr", "size"), HARD, ids=lambda it: str(it)[:40])
def test_nan_and_never_complex_outside_a_domain(expr, size, language, tmp_path):
    points = np.array(np.meshgrid(*2 * [[-2.5, -1, -0.0, 0.5, 1, 3]])).reshape(2, -1).T
    points = points[points[:, 0] != points[:, 1]]
    text = code(expr, (x, y), name="f", language=language)
    found = RUN[language](text, "f", [points], size, tmp_path)
    close(found, numeric(expr, (x, y))(points))


@pytest.mark.parametrize("language", ["matlab", "python", "c"])
def test_the_comment_comes_first_and_the_text_is_the_same_every_time(language):
    def text():
        return code(
            arm.formulas.branches(), XYZ, TASK[3:4], TASK[4:], P, name="ik", language=language, about="Metres."
        )

    lines = text().splitlines()
    first = next(line for line in lines if line.strip().startswith(("%", "#", "/*")) and "include" not in line)
    assert "Metres." in first
    assert text() == text()
    (head,) = [line for line in lines if "ik(" in line]
    assert re.findall("position|pitch|roll|lengths", head) == ["position", "pitch", "roll", "lengths"]


def test_a_vector_may_stay_unused_and_symbols_keep_their_meaning(tmp_path):
    for language in ("matlab", "python", "c"):
        text = code(arm.formulas.pitch(), Q, P, name="pitch", language=language)
        assert not re.search(r"double ;|^ +$", text, re.M)
    found = in_python(
        code(arm.formulas.pitch(), Q, P, name="f", language="python"),
        "f",
        [np.ones((1, 5)), np.ones((1, 4))],
        1,
        tmp_path,
    )
    np.testing.assert_allclose(found, 3 - np.pi / 2)


@pytest.mark.parametrize(
    "wrong",
    [x ** sp.Rational(1, 3), sp.besselj(0, x), sp.Mod(x, 3), sp.log(x), sp.exp(x), sp.floor(x), sp.cot(x), x**0.4,
     sp.Max(sp.sqrt(x), 0), sp.sign(sp.acos(x)), sp.Min(x, sp.sqrt(x - 1)), sp.Function("f")(x)],
    ids=str,
)  # fmt: skip
def test_what_would_be_computed_otherwise_is_not_written(wrong):
    for language in ("matlab", "python", "c"):
        with pytest.raises(InputError, match="cannot be written"):
            code(wrong, (x,), name="f", language=language)


def test_a_vector_is_taken_apart_in_lines_that_can_be_read():
    lines = code(rrr.formulas.working_modes(), POSE, DESIGN, name="ik").splitlines()
    taken = [line for line in lines if re.search(r"\b(?:pose|design)\(\d+\)", line)]
    assert max(map(len, taken)) <= 115
    entries = re.findall(r"(\w+) = \w+\(\d+\);", " ".join(taken))
    assert entries == [symbol.name for symbol in (*POSE, *DESIGN)]


def test_what_cannot_be_written_gets_a_sentence():
    with pytest.raises(InputError, match="matlab, python, c; 'fortran' was given"):
        code(x, (x,), name="f", language="fortran")
    with pytest.raises(InputError, match=r"matlab, python, c; \['c'\] was given"):
        code(x, (x,), name="f", language=["c"])
    for wrong in ("2 f", "1x", "_f", "theta\u0301", "", 3):
        with pytest.raises(InputError, match="cannot be a name"):
            code(x, (x,), name=wrong)
    for language, wrong in [("python", "lambda"), ("python", "math"), ("c", "sin"), ("matlab", "real_sqrt")]:
        with pytest.raises(InputError, match="something else"):
            code(x, (x,), name=wrong, language=language)
    with pytest.raises(InputError, match="pi cannot be a name"):
        code(sp.Symbol("pi") * sp.pi, (sp.Symbol("pi"),), name="f")
    for twice in [lambda: code(x, (x,), name="x"), lambda: code(Q[0], Q, (sp.Symbol("q"),), name="f")]:
        with pytest.raises(InputError, match=r"Two things would be called [xq]"):
            twice()
    with pytest.raises(InputError, match="also holds y"):
        code(x + y, (x,), name="f")
    with pytest.raises(InputError, match="A comment is text"):
        code(x, (x,), name="f", language="c", about="a */ int evil; /*")
    with pytest.raises(InputError, match="A comment is text"):
        code(x, (x,), name="f", about=3)
    with pytest.raises(InputError, match="text"):
        code("x", (x,), name="f")
