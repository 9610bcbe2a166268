"""Write the course as nbgrader's source notebooks: `python -m lynx_common.course.classroom.assignment`.

build/assignment becomes a course folder of nbgrader, one assignment a notebook. The answer's cell gets the worked
solution, between the marks where nbgrader takes it out again; the cell that checks it is locked, raises unless the
answer is right, and gives one point. All else, stored outputs too, stays as it is.
"""

import shutil
from pathlib import Path

import nbformat

from .. import exercises
from ..execute import NOTEBOOKS, ROOT
from ..kernel import code_cells
from . import CHECK, answers

FOLDER = ROOT / "build" / "assignment"
POINTS = 1  # for each exercise
CONFIG = """\
from nbgrader.converters import GenerateAssignment
from nbgrader.preprocessors import ClearOutput

c = get_config()
c.ClearSolutions.code_stub = {"python": "# Put your answer in place of the dots."}
# Students get the stored pictures; they are those of the unsolved notebooks.
steps = GenerateAssignment.preprocessors.default()
c.GenerateAssignment.preprocessors = [step for step in steps if step is not ClearOutput]
"""


def source(path: Path) -> nbformat.NotebookNode:
    """The committed notebook as one of nbgrader's source notebooks."""
    notebook = nbformat.read(path, as_version=4)
    cells = code_cells(notebook)
    for number, cell in enumerate(cells):
        if not (found := CHECK.search(cell.source)):
            continue
        name, answer = found.groups()
        dots, code = f"{answer} = ...", exercises.find(name, "").code
        place = next(before for before in reversed(cells[:number]) if dots in before.source)
        solved = f"{dots}\n### BEGIN SOLUTION\n{code}\n### END SOLUTION"
        place.source = place.source.replace(dots, solved)
        _mark(place, f"{name}-answer", solution=True)
        cell.source = cell.source.replace("exercises.check(", "exercises.assert_right(")
        cell.outputs, cell.execution_count = [], None
        _mark(cell, name, grade=True, locked=True, points=POINTS)
        cell.metadata["tags"] = ["raises-exception"]  # so that Run All goes on to the next exercise
    return notebook


def _mark(cell: nbformat.NotebookNode, name: str, **more: bool | int) -> None:
    plain = {"grade": False, "solution": False, "locked": False, "task": False, "schema_version": 3}
    cell.metadata["nbgrader"] = plain | {"grade_id": name.replace(".", "-")} | more


def write(folder: Path = FOLDER) -> list[str]:
    """Write the configuration and the source notebooks that hold exercises; the names of the assignments."""
    shutil.rmtree(folder / "source", ignore_errors=True)
    paths = [path for path in sorted(NOTEBOOKS.glob("*.ipynb")) if answers(path)]
    for path in paths:
        place = folder / "source" / path.stem
        place.mkdir(parents=True)
        nbformat.write(source(path), place / path.name)
    (folder / "nbgrader_config.py").write_text(CONFIG, encoding="utf-8")
    return [path.stem for path in paths]


if __name__ == "__main__":
    names = write()
    print(f"{len(names)} assignments are in {FOLDER}. There: nbgrader generate_assignment {names[0]}")
