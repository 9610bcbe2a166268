"""Set two notebooks to a class with the real nbgrader: generate, three submissions each, autograde, export.

Run by `make nbgrader`, not by pytest: it needs an environment with nbgrader.
"""

import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import nbformat

from lynx_common.course import exercises
from lynx_common.course.classroom import answers, assignment
from lynx_common.course.execute import NOTEBOOKS
from lynx_common.course.kernel import code_cells

ASSIGNMENTS = ("A1_forward_kinematics", "B1_task_planning")
NAME = "Ada Lovelace"


def nbgrader(course: Path, *arguments: str) -> None:
    """Run nbgrader in the course's folder, out of reach of anybody's settings."""
    names = ("HOME", "JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "IPYTHONDIR")
    places = dict.fromkeys(names, str(course / "home"))
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])  # it calls alembic by name
    more = {"JUPYTER_PREFER_ENV_PATH": "1", "PATH": path} | places
    command = [sys.executable, "-m", "nbgrader", *arguments]
    run = subprocess.run(command, cwd=course, env=os.environ | more, capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"nbgrader {' '.join(arguments)}:\n{run.stdout}{run.stderr}")


def check_release(name: str, course: Path) -> None:
    """What students get: the committed notebook, and no line of a solution."""
    committed = code_cells(nbformat.read(NOTEBOOKS / f"{name}.ipynb", as_version=4))
    released = code_cells(nbformat.read(course / "release" / name / f"{name}.ipynb", as_version=4))
    everything = "\n".join(cell.source for cell in released)
    known = "\n".join(cell.source for cell in committed)
    for exercise in answers(NOTEBOOKS / f"{name}.ipynb"):
        lines = exercises.find(exercise, "").code.splitlines()
        assert lines[-1] not in everything, exercise
        assert [line for line in lines if line in everything and line not in known] == [], exercise
    marked = 0
    for before, cell in zip(committed, released, strict=True):
        if "nbgrader" not in cell.metadata:
            assert (cell.source, cell.outputs) == (before.source, before.outputs), cell.id
        elif cell.metadata.nbgrader.grade:
            assert cell.source == before.source.replace("check(", "assert_right("), cell.id
            marked += 1
        else:
            dots = "= ...\n# Put your answer in place of the dots."
            assert cell.source == before.source.replace("= ...", dots), cell.id
    assert marked == len(answers(NOTEBOOKS / f"{name}.ipynb"))


def submit(name: str, course: Path, who: str) -> int:
    """Put in what ``who`` hands in; returns the points for it.

    "right" has everything right, for numbers of her own. "wrong" has nothing for the first exercise, where he
    made the check pass, answers those of own numbers with the printed ones, and has the rest right.
    """
    notebook = nbformat.read(course / "release" / name / f"{name}.ipynb", as_version=4)
    cells, points = code_cells(notebook), 0
    for cell in cells if who != "empty" else []:
        cell.source = cell.source.replace('exercises.student("")', f'exercises.student("{NAME}")')
    assert who == "empty" or any(f'student("{NAME}")' in cell.source for cell in cells), "no cell for a name"
    for number, (key, answer) in enumerate(answers(NOTEBOOKS / f"{name}.ipynb").items()):
        place = next(cell for cell in cells if f"{answer} = ..." in cell.source)
        own = exercises.find(key, NAME)
        if who == "right":
            place.source += f"\n{own.code}"
            points += 1
        elif who == "wrong" and number:
            place.source += f"\n{exercises.find(key, '').code}"
            points += not own.numbers
        elif who == "wrong":
            test = next(cell for cell in cells if cell.source == f'exercises.assert_right("{key}", {answer})')
            test.source = "pass"
    folder = course / "submitted" / who / name
    folder.mkdir(parents=True)
    nbformat.write(notebook, folder / f"{name}.ipynb")
    return points


def main() -> None:
    expected = {}
    with tempfile.TemporaryDirectory() as temporary:
        course = Path(temporary, "robot course")  # nobody's folders are without spaces
        written = assignment.write(course)
        assert len(written) == 8, written
        for name in ASSIGNMENTS:
            nbgrader(course, "generate_assignment", name)
            check_release(name, course)
            most = float(len(answers(NOTEBOOKS / f"{name}.ipynb")))
            for who in ("right", "wrong", "empty"):
                expected[name, who] = (float(submit(name, course, who)), most)
            nbgrader(course, "autograde", name)
            assert expected[name, "empty"][0] < expected[name, "wrong"][0] < expected[name, "right"][0] == most
        nbgrader(course, "export", "--to", "grades.csv")
        with open(course / "grades.csv", encoding="utf-8", newline="") as file:
            rows = {(row["assignment"], row["student_id"]): row for row in csv.DictReader(file)}
    found = {key: (float(row["score"]), float(row["max_score"])) for key, row in rows.items()}
    for key in sorted({*found, *expected}):
        print(*key, *found.get(key, ["missing"]), "" if found.get(key) == expected.get(key) else "FAILED")
    if found != expected:
        sys.exit(f"FAILED: {expected} was expected")


if __name__ == "__main__":
    main()
