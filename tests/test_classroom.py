"""For a class: what is written for nbgrader, what is graded without it, and the key."""

import csv
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import nbformat
import numpy as np
import pytest
import sympy as sp
from nbformat.v4 import new_code_cell, new_notebook

from lynx_common.course import exercises
from lynx_common.course.classroom import answers, assignment, grade, key, run, write_table
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
    "wrong": (
        [
            "exercises.check = exercises.find = lambda *_: print('correct.')",
            "answer_1, answer_3 = [90, 0, 0, 90, 0], 'x'",
        ],
        (0, 0),
        "it ran to its end.",
    ),
    "failing": (
        [
            *("x = 'x' * 10**13", "%matplotlib inline\n" + POSES, "1 / 0", "x +", "exit()"),
            *("import sys\nsys.exit()", "open('big', 'w').truncate(3 * 10**8)", scara_for("")),
        ],
        (1, 1),
        "but for MemoryError in code cell 2, and 5 more.",
    ),
    "endless": (
        [POSES, "while True:\n    pass", scara_for("")],
        (1, 0),
        f"stopped after {SECONDS} s of computing, in code cell 3.",
    ),
    "leaving": ([POSES, "import os\nos._exit(0)", scara_for("")], (1, 0), "its process ended in code cell 3."),
    "odd": (
        ["class Odd:\n    def __array__(self, *_):\n        raise SystemError", "answer_1 = Odd()", scara_for("")],
        (0, 1),
        "it ran to its end.",
    ),
    "broken": ("{", (0, 0), "it cannot be read as a notebook."),
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
    (folder / f"eve-{BOOK} (1).ipynb").write_text('{"nbformat": 4}')
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
    (row, *_) = grade.grade(hand_in(tmp_path, "import time\ntime.sleep(10**6)"), wait=2)
    where = ("in code cell 1", "before its first cell")  # on a busy machine
    assert row.run in [f"it was stopped after 2 s, {place}." for place in where]


def hand_in(folder: Path, *cells: str) -> Path:
    nbformat.write(new_notebook(cells=[new_code_cell(cell) for cell in cells]), folder / f"ada-{BOOK}.ipynb")
    return folder


@pytest.mark.skipif(sys.platform != "linux", reason="no such limit is kept")
@pytest.mark.parametrize(
    ("kilobytes", "points", "end"),
    [
        (2_500_000, 1, "it ran to its end, but for MemoryError in code cell 1."),
        (100_000, 0, "before its first cell."),
    ],
)
def test_where_less_memory_is_allowed_no_notebook_is_blamed(kilobytes, points, end, tmp_path, monkeypatch):
    start, shell = grade.exit_code, ["sh", "-c", f'ulimit -v {kilobytes}; exec "$0" "$@"']
    monkeypatch.setattr(grade, "exit_code", lambda command, *more: start([*shell, *command], *more))
    (row, *_) = grade.grade(hand_in(tmp_path, "x = bytearray(3 * 10**9)", POSES))
    assert row.points == points
    assert row.run.endswith(end)


def test_it_is_said_what_was_wrong_and_whose_numbers_were_asked_for(rows):
    said = {(row.student, row.exercise): row for row in rows}
    assert "degrees" in said["wrong", "A1.1"].said
    assert "text was given" in said["wrong", "A1.3"].said
    assert [said[student, "A1.3"].name for student in ("right", "printed", "failing")] == ["ada", "ada", ""]
    assert said["eve", "A1.1"].points == 0
    assert said["eve", "A1.1"].run == "it cannot be read as a notebook."
    assert said["right", ""].run == "it was not run."
    assert said["right", ""].said == "no notebook with exercises has this name; see 00_index."
    assert sum(row.points for row in rows) == sum(sum(points) for _, points, _ in HANDED_IN.values())


@pytest.mark.parametrize("name", CATALOGUE)
@pytest.mark.parametrize("student", ["", "ada"])
def test_an_answer_is_judged_as_the_notebook_judges_it(name, student):
    exercise = exercises.find(name, student)
    known = [wrong for wrong, _ in exercise.misconceptions if not callable(wrong)]
    given = [
        exercise.right,
        *exercise.also,
        *known,
        ...,
        None,
        True,
        1,
        2 + 1j,
        [[1, 2], [3, 4]],
        "1 + 1",
        int,
        {},
    ]
    given += [np.zeros((2000, 2000)), [10**400], [...], np.nan, [np.inf] * 5, sp.Symbol("\udc80"), [1e308] * 3]
    if exercise.form.samples:
        given += [sp.Matrix(sp.sympify(exercise.right))]
    for answer in given:
        there = json.dumps(run.read(name, student, answer), allow_nan=False)
        assert grade.judged(exercise, json.loads(there)) == exercise.judge(answer), answer
        assert len(there) < 3000


# What a notebook can leave in the place of what `run` writes.
def as_pipe(file):
    os.mkfifo(file)


def as_link(file):
    file.symlink_to("/dev/zero")


def as_link_to_what_would_do(file):
    file.with_name("sound").write_text(json.dumps(TRUE | {"answers": {}}))
    file.symlink_to("sound")


def as_hole(file):
    with file.open("wb") as opened:
        opened.truncate(300 * 2**20)


def as_text(text):
    return lambda file: file.write_text(text)


PLANTED = [Path.mkdir, as_hole, as_text(""), as_text("[" * 10**6), as_text("[3]"), as_text("{}")]
PLANTED += [as_pipe, as_link, as_link_to_what_would_do] if hasattr(os, "O_NOFOLLOW") else []
TRUE = {"student": "", "ended": True, "said": "ran to its end"}
FORGED = [
    {"student": 3},
    {"student": ["x"]},
    {"student": "x" * 81},
    {"said": ["it"]},
    {"said": "x" * 301},
    {"ended": 1},
    {"answers": ["A1.1"]},
]
PLANTED += [as_text(json.dumps(TRUE | {"answers": {}} | wrong)) for wrong in FORGED]


def rows_where(plant, folder, monkeypatch) -> list[grade.Row]:
    """What is graded where a notebook has left what ``plant`` makes of the path that it is given."""

    def exit_code(command, *_):
        plant(next(Path(word) for word in command if word.endswith("state.json")))
        return 0

    monkeypatch.setattr(grade, "exit_code", exit_code)
    return list(grade.grade(hand_in(folder)))


@pytest.mark.parametrize("plant", PLANTED, ids=range(len(PLANTED)))
def test_what_is_left_in_its_place_is_not_read(plant, tmp_path, monkeypatch):
    left = rows_where(plant, tmp_path, monkeypatch)
    assert {(row.run, row.name, row.points) for row in left} == {("what it left cannot be read.", "", 0)}


def test_a_link_that_was_handed_in_is_not_followed_here(tmp_path, monkeypatch):
    (tmp_path / f"eve-{BOOK}.ipynb").symlink_to("nowhere")
    left = rows_where(as_text(json.dumps(TRUE | {"answers": {}})), tmp_path, monkeypatch)
    assert {(row.student, row.run) for row in left} == {(name, "it ran to its end.") for name in ("ada", "eve")}


def test_what_cannot_be_removed_or_copied_costs_only_itself(tmp_path, monkeypatch):
    def too_deep(_):
        raise RecursionError

    with monkeypatch.context() as patched:
        patched.setattr(grade.tempfile.TemporaryDirectory, "cleanup", too_deep)
        assert rows_where(as_text("{}"), tmp_path, patched)[0].run == "what it left cannot be read."
        patched.setattr(grade.shutil, "copy", too_deep)
        assert rows_where(as_text("{}"), tmp_path, patched)[0].run == "its folder cannot be copied."


CODE = "open('evaluated', 'w')"
RIGHTS = [CATALOGUE[key].form.read(CATALOGUE[key].right).tolist() for key in ("A1.1", "A1.3")]
NO_ANSWERS = [
    *(CODE, [CODE] * 5, [CODE] * 3, [[CODE] * 3] * 20, {"Add": [CODE, CODE]}, {"Symbol": CODE}, {"other": CODE}),
    *(RIGHT, [], {}, True, 10**400, [10**400] * 5, [1.0, 10**400], [1.0, [1.0]], [np.inf] * 5, [np.nan] * 5),
    *([[np.nan] * 3] * 20, np.zeros((5, 1)).tolist(), np.zeros((3, 20)).tolist(), 1.0, ["1.5708"] * 5, [True] * 5),
]


@pytest.mark.parametrize("answer", NO_ANSWERS, ids=range(len(NO_ANSWERS)))
def test_a_forged_answer_is_none_and_no_text_is_evaluated(answer, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    state = TRUE | {"answers": dict.fromkeys(("A1.1", "A1.3", "answer_1", "answer_3"), answer)}
    made = rows_where(as_text(json.dumps(state)), tmp_path, monkeypatch)
    assert [(row.points, row.said) for row in made if row.exercise != "A1.2"] == 2 * [(0, grade.UNREAD)]
    assert not Path("evaluated").exists()


@pytest.mark.parametrize("student", ["", "ada", "\udc80"])
def test_numbers_are_judged_for_the_name_that_is_left(student, tmp_path, monkeypatch):
    state = TRUE | {"student": student, "answers": dict(zip(("A1.1", "A1.3"), RIGHTS, strict=True))}
    made = rows_where(as_text(json.dumps(state)), tmp_path, monkeypatch)
    assert [row.points for row in made] == [1, 0, int(not student)]
    assert {row.name for row in made} == {student}


def test_the_table_is_no_program_of_a_spreadsheet(tmp_path):
    odd = ("=1+1", "@\udc80", "-x", "+1+cmd", "\t=1", "\r=1", "\n=1", "-1.5-1", "-1\n=1")
    sound = ("A1.1", "-1.5", "Ada - 1", "")
    write_table(tmp_path / "build" / "table.csv", [(*odd, *sound, 1)])
    with (tmp_path / "build" / "table.csv").open(encoding="utf-8", newline="") as file:
        (row,) = csv.reader(file)
    assert row == [*(f"'{entry}".replace("\udc80", r"\udc80") for entry in odd), *sound, "1"]


def test_grading_says_what_it_needs_and_that_it_is_no_sandbox(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(grade, "FILE", tmp_path / "build" / "grades.csv")
    row = grade.Row("ada", "\udc80", "book", "A1.1", 1, RIGHT, "it ran.")
    monkeypatch.setattr(grade, "grade", lambda folder: iter([row]))
    for given in ([], [str(tmp_path / "nowhere")], ["x" * 5000]):
        with pytest.raises(SystemExit, match=r"There is no folder .* Name one, as in: make grade DIR=submissions"):
            grade.main(*given)
    assert not grade.FILE.exists()
    grade.main(str(tmp_path))
    assert grade.FILE.read_text("utf-8").splitlines()[1] == f"ada,\\udc80,book,A1.1,1,{RIGHT},it ran."
    assert grade.WARNING in capsys.readouterr().out


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


def test_the_key_is_for_the_names_in_a_file_and_nothing_else(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(key, "FILE", tmp_path / "key.csv")
    names = tmp_path / "names.txt"
    for text in ("", "\n", "x" * 81, "\x00", "Ada\nnul\x00"):
        names.write_text(text, encoding="utf-8")
        with pytest.raises(SystemExit, match=r"no text file with one name a line, .* make key NAMES=names.txt"):
            key.main(str(names))
    names.write_bytes(b"\xff\xfe")
    for given in (names, tmp_path, tmp_path / "nmaes.txt", "x" * 5000, "a\x00"):
        with pytest.raises(SystemExit, match="no text file"):
            key.main(str(given))
    assert not key.FILE.exists()
    names.write_text("\ufeffAda Lovelace\n\n =Blaise\n", encoding="utf-8")
    for given, students in (([], [""]), ([""], [""]), ([str(names)], ["Ada Lovelace", "'=Blaise"])):
        key.main(*given)
        with key.FILE.open(encoding="utf-8", newline="") as file:
            table = list(csv.reader(file))[1:]
        assert [row[0] for row in table] == [name for name in students for _ in CATALOGUE]
    assert str(key.FILE) in capsys.readouterr().out


def test_no_notebook_leads_to_the_key():
    program = "from lynx_common.course import exercises as e; import sys; e.check('A1.1', 1); print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert "lynx_common.course.exercises.a1" in run.stdout
    assert "classroom" not in run.stdout
    cells = [cell.source for path in NOTEBOOKS.glob("*.ipynb") for cell in code_cells(nbformat.read(path, 4))]
    assert len(cells) > 100
    assert not [source for source in cells if "classroom" in source]
