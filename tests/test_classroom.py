"""For a class: what is written for nbgrader, what is graded without it, and the key."""

import csv
import json
import re
import subprocess
import sys

import nbformat
import numpy as np
import pytest
import sympy as sp
from nbformat.v4 import new_code_cell, new_notebook

from lynx_common.course import exercises
from lynx_common.course.classroom import answers, assignment, grade, key, plain
from lynx_common.course.execute import NOTEBOOKS
from lynx_common.course.exercises.exercise import NOT_ATTEMPTED, RIGHT
from lynx_common.course.kernel import code_cells

BOOK = "A1_forward_kinematics"
POSES = "answer_1 = [1.5708, 0, 0, 1.5708, 0]"
CATALOGUE = exercises.catalogue()
SECONDS = 4  # of computing, of which a notebook needs one to begin


def scara_for(name: str) -> str:
    return "\n".join(
        [
            "import sympy as sp",
            "from lynx_common import dh",
            "from lynx_common.symbolic import Q, tidy",
            "theta_1, theta_2, d_3 = *Q[:2], sp.Symbol('d_3', real=True)",
            exercises.find("A1.3", name).code,
        ]
    )


# What students hand in, as cells, or as text; the points for A1.1 and A1.3 (A1.2 nobody does); how the run ended.
HANDED_IN = {
    "right": (['exercises.student("Ada")', POSES, scara_for("ada")], (1, 1), "it ran to its end."),
    "printed": (['exercises.student("Ada")', POSES, scara_for("")], (1, 0), "it ran to its end."),
    "wrong": (["answer_1 = [90, 0, 0, 90, 0]", "answer_3 = 'x'"], (0, 0), "it ran to its end."),
    "empty": (["answer_1 = ..."], (0, 0), "it ran to its end."),
    "cheat": (
        ["exercises.check = exercises.assert_right = lambda *_: print('correct.')", "answer_1 = 1"],
        (0, 0),
        "it ran to its end.",
    ),
    "failing": ([POSES, "1 / 0", "x +", scara_for("")], (1, 1), "but for ZeroDivisionError in code cell 3, and 1"),
    "greedy": (["answer_1 = 'x' * 10**13", POSES], (1, 0), "but for MemoryError in code cell 2."),
    "endless": (
        [POSES, "while True:\n    pass", scara_for("")],
        (1, 0),
        f"stopped after {SECONDS} s of computing, in code cell 3.",
    ),
    "leaving": ([POSES, "import os\nos._exit(0)", scara_for("")], (1, 0), "its process ended in code cell 3."),
    "exit": ([POSES, "exit()", "import sys\nsys.exit()"], (1, 0), "code cell"),
    "odd": (
        ["class Odd:\n    def __array__(self, *_):\n        raise SystemError", "answer_1 = Odd()", scara_for("")],
        (0, 1),
        "it ran to its end.",
    ),
    "broken": ("{", (0, 0), "it cannot be read as a notebook."),
    "bare": ('{"nbformat": 4}', (0, 0), "it cannot be read as a notebook."),
}


@pytest.fixture(scope="module")
def rows(tmp_path_factory) -> list[grade.Row]:
    folder = tmp_path_factory.mktemp("handed in")
    for student, (cells, _, _) in HANDED_IN.items():
        (folder / student).mkdir()
        if not isinstance(cells, str):
            cells = ["from lynx_common.course import exercises", *cells]
            cells = nbformat.writes(new_notebook(cells=[new_code_cell(cell) for cell in cells]))
        (folder / student / f"{BOOK}.ipynb").write_text(cells, encoding="utf-8")
    (folder / "right" / "random.py").write_text("1 / 0")  # her own module keeps nothing from being read
    (folder / f"eve-{BOOK} (1).ipynb").write_text("[]")
    (folder / "right" / "notes.ipynb").write_text("[]")
    return list(grade.grade(folder, seconds=SECONDS))


@pytest.mark.parametrize("student", HANDED_IN)
def test_each_notebook_costs_only_itself(rows, student):
    _, points, end = HANDED_IN[student]
    mine = {row.exercise: row for row in rows if row.student == student and BOOK in row.notebook}
    assert list(mine) == ["A1.1", "A1.2", "A1.3"]
    assert (mine["A1.1"].points, mine["A1.3"].points) == points
    assert mine["A1.2"].said == NOT_ATTEMPTED
    assert all(row.run.endswith(end) or end in row.run for row in mine.values())


def test_one_that_sleeps_is_stopped_too(tmp_path):
    cells = [new_code_cell("import time\ntime.sleep(10**6)")]
    nbformat.write(new_notebook(cells=cells), tmp_path / f"ada-{BOOK}.ipynb")
    (row, *_) = grade.grade(tmp_path, wait=3)  # or else it has not even begun by then
    assert row.run in ("it was stopped after 3 s, in code cell 1.", "it cannot be read as a notebook.")


def test_it_is_said_what_was_wrong_and_whose_numbers_were_asked_for(rows):
    said = {(row.student, row.exercise): row for row in rows}
    assert "degrees" in said["wrong", "A1.1"].said
    assert "str was given" in said["wrong", "A1.3"].said
    assert [said[student, "A1.3"].name for student in ("right", "printed", "failing")] == ["ada", "ada", ""]
    assert said["eve", "A1.1"].points == 0
    assert said["right", ""].said == "no notebook with exercises has this name; see 00_index."
    assert sum(row.points for row in rows) == sum(sum(points) for _, points, _ in HANDED_IN.values())


def test_the_table_is_no_program_of_a_spreadsheet(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(grade, "FILE", tmp_path / "build" / "grades.csv")
    row = grade.Row("=1+1", "@\udc80", "notebook", "A1.1", 1, RIGHT, "-")
    monkeypatch.setattr(grade, "grade", lambda folder: iter([row]))
    assert grade.main(tmp_path) == 0
    with grade.FILE.open(encoding="utf-8", newline="") as file:
        assert list(csv.reader(file))[1] == ["'=1+1", "'@\\udc80", "notebook", "A1.1", "1", RIGHT, "'-"]
    assert grade.WARNING in capsys.readouterr().out
    assert grade.main(tmp_path / "nowhere") == 1


@pytest.mark.parametrize("name", CATALOGUE)
def test_an_answer_is_judged_the_same_on_the_other_side(name):
    exercise = CATALOGUE[name]
    known = [wrong for wrong, _ in exercise.misconceptions if not callable(wrong)]
    given = [exercise.right, *exercise.also, *known, ..., None, True, 1, 2 + 1j, [[1, 2], [3, 4]]]
    if exercise.form.samples:
        formulas = [*map(sp.sympify, exercise.right)]
        bare = [entry.xreplace({s: sp.Symbol(s.name) for s in entry.free_symbols}) for entry in formulas]
        turned = [sp.Piecewise((sp.Max(entry, entry - 1), x > 0), (entry, True)) for entry in formulas]
        given += [sp.Matrix(formulas), bare, [sp.Mul(entry, sp.I, -sp.I, evaluate=False) for entry in bare]]
        given += [[sp.log(sp.exp(entry)) for entry in bare], [*bare, 1], turned, [*map(sp.acos, bare)]]
    else:
        given += [np.array(exercise.right), np.float32(exercise.right), sp.sympify(exercise.right)]
    for answer in given:
        there = plain.decode(json.loads(json.dumps(plain.encode(answer))))
        assert exercise.judge(there) == exercise.judge(answer), answer


x = sp.Symbol("x")
ODD = [np.zeros((2000, 2000)), "1 + 1", {1: 2}, sp.Function("f")(x), x.diff, sp.Integral(x, x), [10**400], [...]]
ODD += [np.ma.masked_all(5)]
ODD += [sum(x**n for n in range(2000)), sp.Pow(9, sp.Pow(9, 9 ** sp.Symbol("n"))), sp.zoo, int]


@pytest.mark.parametrize("answer", ODD, ids=range(len(ODD)))
def test_whatever_is_answered_goes_over_and_gets_a_sentence(answer):
    data = json.loads(json.dumps(plain.encode(answer)))
    assert len(json.dumps(data)) < 50_000
    for exercise in (CATALOGUE["A1.1"], CATALOGUE["A1.3"]):
        assert exercise.judge(plain.decode(data)).endswith(".")


@pytest.mark.parametrize("state", [{}, {"answers": 3}, {"answers": {"answer_1": {"eval": ["1"]}}}])
def test_a_forged_state_is_no_answer(state):
    made = list(grade.rows("eve", BOOK, {"A1.1": "answer_1"}, state, ""))
    assert [row.points for row in made] == [0]


def test_every_exercise_is_found_in_a_notebook():
    found = [name for path in sorted(NOTEBOOKS.glob("*.ipynb")) for name in answers(path)]
    assert sorted(found) == sorted(CATALOGUE)


def test_the_source_notebooks_hold_what_nbgrader_wants(tmp_path):
    names = assignment.write(tmp_path)
    assert names == assignment.write(tmp_path) != []
    for name in names:
        notebook = nbformat.read(tmp_path / "source" / name / f"{name}.ipynb", as_version=4)
        nbformat.validate(notebook)
        committed = code_cells(nbformat.read(NOTEBOOKS / f"{name}.ipynb", as_version=4))
        marked, points = [], 0
        for before, cell in zip(committed, code_cells(notebook), strict=True):
            if not (about := cell.metadata.get("nbgrader")):
                assert cell == before
                continue
            marked.append(about.grade_id)
            points += about.get("points", 0)
            assert about.grade == about.locked == (not about.solution)
            stripped = re.sub(r"\n### BEGIN SOLUTION\n.*\n### END SOLUTION", "", cell.source, flags=re.S)
            assert stripped.replace("assert_right(", "check(") == before.source
        own = answers(NOTEBOOKS / f"{name}.ipynb")
        expected = [one for key in own for one in (f"{key}-answer".replace(".", "-"), key.replace(".", "-"))]
        assert (marked, points) == (expected, len(own))


def test_the_key_opens_every_exercise():
    table = list(key.rows(["", "Ada"]))
    assert [name for _, name, _, _ in table] == 2 * list(CATALOGUE)
    for student, name, numbers, _ in table:
        exercise = exercises.find(name, student)
        assert {exercise.judge(answer) for answer in key.right(exercise)} == {RIGHT}
        assert bool(numbers) == bool(exercise.numbers)
    printed, hers = ({row[1:] for row in table if row[0] == student} for student in ("", "Ada"))
    own = {name for name, exercise in CATALOGUE.items() if exercise.numbers}
    assert {name for name, *_ in printed - hers} == own != set()


def test_names_are_those_of_a_file_or_those_given(tmp_path):
    (tmp_path / "names.txt").write_text("Ada Lovelace\n\nBlaise\n", encoding="utf-8")
    for given in (str(tmp_path / "names.txt"), "Ada Lovelace, Blaise"):
        assert key.names(given) == ["Ada Lovelace", "Blaise"]
    assert key.names("") == [""]


def test_no_notebook_leads_to_the_key():
    program = "from lynx_common.course import exercises as e; import sys; e.check('A1.1', 1); print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert "lynx_common.course.exercises.a1" in run.stdout
    assert "classroom" not in run.stdout
    cells = [cell.source for path in NOTEBOOKS.glob("*.ipynb") for cell in code_cells(nbformat.read(path, 4))]
    assert len(cells) > 100
    assert not [source for source in cells if "classroom" in source]
