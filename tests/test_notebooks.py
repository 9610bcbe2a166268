"""The checks on the notebooks can fail, and the executor's work is the same every time."""

import ast
import base64
import io
import json
import os
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path
from typing import NamedTuple

import nbformat
import numpy as np
import pytest
from nbformat.v4 import new_code_cell, new_notebook, new_output
from PIL import Image

from lynx_common.course import pictures
from lynx_common.course.execute import NOTEBOOKS, ROOT
from lynx_common.course.kernel import METADATA, code_cells, execute
from lynx_common.course.pictures import pixels

SMALL = [
    "print(0.2156, 0.373429)",
    "from IPython.display import HTML, Math\nMath(r'$\\sqrt{x}$')",
    "HTML('<p>12</p>')",
    "import matplotlib.pyplot as plt",
    "plt.plot([0, 1], [0, 2], 'o')\nplt.show()",
    "plt.title('no text from this cell');",
    "from ipywidgets import Image\nImage(value=b'', alt='a widget')",
    "",
    "try:\n    assert False\nexcept AssertionError:\n    print('asserts count')",
    "1 + 1",
]


@pytest.fixture(scope="module")
def small(tmp_path_factory) -> Path:
    """A notebook with one cell of each kind, executed."""
    path = tmp_path_factory.mktemp("small") / "small.ipynb"
    cells = [new_code_cell(source, id=f"cell-{number}") for number, source in enumerate(SMALL)]
    nbformat.write(new_notebook(cells=cells), path)
    path.write_text(execute(path), encoding="utf-8")
    return path


class Outcome(NamedTuple):
    """What pytest said of the copies of a notebook."""

    changed: dict[str, str]  # by copy with one changed output: the cell that holds it
    failed: dict[str, list[str]]  # by copy: the cells that failed, or [""] where the notebook was refused
    passed: dict[str, list[str]]
    output: str


@pytest.fixture(scope="module")
def outcome(small, tmp_path_factory) -> Outcome:
    """Copies of the small notebook, each spoiled in one way, in a folder and an environment that are not ours."""
    folder = tmp_path_factory.mktemp("copies") / "Übung 3" / "Robot course"
    folder.mkdir(parents=True)
    changed = {}
    for name, spoil in (CHANGES | SPOILS).items():
        copy = nbformat.read(small, as_version=4)
        if name in CHANGES:
            changed[name] = change_one(copy, spoil)
        else:
            spoil[0](copy)
        nbformat.write(copy, folder / f"{name}.ipynb")
    noise = nbformat.read(small, as_version=4)
    change_one(noise, add_noise)
    nbformat.write(noise, folder / "noisy.ipynb")
    return Outcome(changed, *check(folder, personal(tmp_path_factory.mktemp("home"))))


def personal(home: Path) -> dict[str, str]:
    """The environment of somebody who has settings of his own, each of which would change an output."""
    for folder in (home / "config" / "matplotlib", home / "other"):
        folder.mkdir(parents=True)
        (folder / "matplotlibrc").write_text("lines.markersize: 30\naxes.facecolor: black\n")
    kernel = home / "jupyter" / "kernels" / "python3"
    kernel.mkdir(parents=True)
    spec = {"argv": ["false", "{connection_file}"], "display_name": "another", "language": "python"}
    (kernel / "kernel.json").write_text(json.dumps(spec))
    return {
        "HOME": str(home),
        "XDG_CONFIG_HOME": str(home / "config"),
        "MPLCONFIGDIR": str(home / "other"),
        "MATPLOTLIBRC": str(home / "other" / "matplotlibrc"),
        "PYTHONOPTIMIZE": "1",
        "JUPYTER_PATH": str(home / "jupyter"),
        "TZ": "Pacific/Kiritimati",
        "LANG": "de_DE.ISO-8859-1",
    }


RECORDER = """
import json, sys
import pytest

class Recorder:
    def __init__(self):
        self.reports = []
    def pytest_collectreport(self, report):
        if report.failed:
            self.reports.append((report.nodeid, "failed"))
    def pytest_runtest_logreport(self, report):
        if report.when == "call" or report.failed:
            self.reports.append((report.nodeid, report.outcome))

recorder = Recorder()
pytest.main(sys.argv[2:], plugins=[recorder])
with open(sys.argv[1], "w", encoding="utf-8") as file:
    json.dump(recorder.reports, file)
"""


def check(folder: Path, environment: dict[str, str]) -> tuple[dict[str, list], dict[str, list], str]:
    """Run pytest on all copies; the cells of each that failed, those that passed, and what it printed."""
    found = folder / "reports.json"
    command = [sys.executable, "-c", RECORDER, found, "-n0", "--color=no", "-c", ROOT / "pyproject.toml"]
    run = subprocess.run(
        [*command, "--rootdir", ROOT, folder], capture_output=True, cwd=folder, env=os.environ | environment
    )
    outcomes = {"failed": defaultdict(list), "passed": defaultdict(list), "skipped": defaultdict(list)}
    for nodeid, outcome in json.loads(found.read_text(encoding="utf-8")):
        path, _, cell = nodeid.partition("::")
        outcomes[outcome][Path(path).stem].append(cell)
    return outcomes["failed"], outcomes["passed"], run.stdout.decode("utf-8", "replace")


def test_what_holds_passes_with_noise_that_nobody_sees(outcome):
    """Whatever settings its reader has."""
    assert outcome.failed["noisy"] == []
    assert len(outcome.passed["noisy"]) == len(SMALL)


def test_a_changed_output_fails_in_its_own_cell_and_what_follows_says_nothing_more(outcome):
    assert {name: outcome.failed[name] for name in CHANGES} == {n: [cell] for n, cell in outcome.changed.items()}
    assert "picture differs: by " in outcome.output


def test_a_failed_run_ends_with_what_to_do(outcome):
    last = outcome.output.rstrip().splitlines()[-1]
    assert last.startswith("What to do: look at ")
    assert all(f"{cell} of {name}" in last for name, cell in outcome.changed.items())
    assert "`make notebooks`" in last


@pytest.mark.parametrize(
    "name", ["stripped", "disordered", "warned", "failed", "with_widgets", "with_times", "exempt"]
)
def test_a_notebook_not_as_made_is_refused(name, outcome):
    assert outcome.failed[name] == [""]
    assert f"{name}.ipynb {SPOILS[name][1]}; run `make notebooks`." in outcome.output


def change_one(notebook, change) -> str:
    """Change the first output that can be changed in this way; returns the name of its cell."""
    for cell in code_cells(notebook):
        if any(map(change, cell.outputs)):
            return f"cell [{cell.execution_count}]"
    raise ValueError(f"no output for {change.__name__}")


def change_digit(output) -> bool:
    """In what a cell prints, or in a result that is shown as plain text."""
    holder, key = (output, "text") if output.output_type == "stream" else (output.data, "text/plain")
    before = holder[key]
    if output.output_type == "stream" or list(output.data) == ["text/plain"]:
        holder[key] = re.sub(r"\d(?=\D*$)", lambda digit: str((int(digit[0]) + 1) % 10), before)
    return holder[key] != before


def change_equation(output) -> bool:
    return replace_data(output, "text/latex", lambda latex: latex.replace("$", "$-", 1))


def change_page(output) -> bool:
    return replace_data(output, "text/html", lambda page: page.replace("2", "3", 1))


def change_picture(output) -> bool:
    """One small marker more."""

    def add_marker(png):
        picture = pixels(png)
        picture[20:27, 30:37] = 0, 0, 0, 255
        return base64_png(picture)

    return replace_data(output, "image/png", add_marker)


def add_noise(output) -> bool:
    """Two levels up or down, everywhere."""

    def add(png):
        picture = pixels(png)
        return base64_png((picture + np.random.default_rng(0).integers(-2, 3, picture.shape)).clip(0, 255))

    return replace_data(output, "image/png", add)


def replace_data(output, kind: str, change) -> bool:
    data = output.get("data", {})
    if found := kind in data:
        data[kind] = change(data[kind])
    return found


def base64_png(picture: np.ndarray) -> str:
    file = io.BytesIO()
    Image.fromarray(picture.astype(np.uint8), "RGBA").save(file, "png")
    return base64.b64encode(file.getvalue()).decode()


def strip(notebook):
    for cell in code_cells(notebook):
        cell.update(outputs=[], execution_count=None)


def disorder(notebook):
    first, second = code_cells(notebook)[:2]
    first.execution_count, second.execution_count = second.execution_count, first.execution_count


def warn(notebook):
    code_cells(notebook)[0].outputs.append(new_output("stream", name="stderr", text="a warning"))


def fail(notebook):
    code_cells(notebook)[0].outputs.append(new_output("error", ename="NameError", evalue="x", traceback=[]))


def keep_widgets(notebook):
    notebook.metadata.widgets = {}


def keep_times(notebook):
    code_cells(notebook)[0].metadata.execution = {}


def exempt(notebook):
    code_cells(notebook)[1].metadata.tags = ["nbval-ignore-output"]


CHANGES = {
    "digit": change_digit,
    "equation": change_equation,
    "page": change_page,
    "picture": change_picture,
}
SPOILS = {
    "stripped": (strip, "was never run"),
    "disordered": (disorder, "was not run from top to bottom in a fresh kernel"),
    "warned": (warn, "stores a message on stderr"),
    "failed": (fail, "stores an error"),
    "with_widgets": (keep_widgets, "stores the state of widgets"),
    "with_times": (keep_times, "stores the times of its execution"),
    "exempt": (exempt, "exempts a cell from being compared"),
}


@pytest.mark.parametrize("path", sorted(NOTEBOOKS.glob("*.ipynb")), ids=lambda path: path.stem)
def test_a_cell_fits_the_eye_and_links_lead_somewhere(path):
    notebook = nbformat.read(path, as_version=4)
    for cell in code_cells(notebook):
        lines = [line for line in cell.source.splitlines() if line.strip()]
        assert len(lines) <= 10, cell.id
        assert max(map(len, lines), default=0) <= 115, cell.id
    words = "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")
    assert [link for link in re.findall(r"\]\(([^)#:]+)\)", words) if not (NOTEBOOKS / link).exists()] == []


@pytest.mark.parametrize("path", sorted(NOTEBOOKS.glob("*.ipynb")), ids=lambda path: path.stem)
def test_a_cell_that_only_draws_is_tagged_as_a_drawing(path):
    """The site folds the code of those cells, and of no others."""
    cells = code_cells(nbformat.read(path, as_version=4))
    tagged = [cell.id for cell in cells if "drawing" in cell.metadata.get("tags", [])]
    assert tagged == [cell.id for i, cell in enumerate(cells) if only_draws(cell.source, cells[i + 1 :])]


def only_draws(source: str, later: list) -> bool:
    """Whether a cell shows figures, settles nothing, and leaves no name that a later cell reads."""
    tree, kept = ast.parse(source), names(source, ast.Store)
    called = {ast.unparse(node.func) for node in ast.walk(tree) if isinstance(node, ast.Call)}
    if not called & {"figures.show", "figures.publish"} or called & {
        "report.check",
        "report.printed",
        "figures.movie",
    }:
        return False
    for cell in later:
        made = names(cell.source, ast.Store)
        if kept & names(cell.source, ast.Load) - made:
            return False
        kept = kept - made
    return not any(isinstance(node, ast.Assert) for node in ast.walk(tree))


def names(source: str, context: type) -> set[str]:
    """The names that a cell makes (ast.Store) or reads (ast.Load)."""
    nodes = list(ast.walk(ast.parse(source)))
    made = {
        n.name if isinstance(n, ast.FunctionDef) else n.arg
        for n in nodes
        if isinstance(n, ast.FunctionDef | ast.arg)
    }
    found = {n.id for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, context)}
    return found | made if context is ast.Store else found


@pytest.mark.parametrize(
    ("source", "later"),
    [
        ("figures.show(fig, 'x')\nassert True", ""),
        ("report.check('Fig. 1.2', q)\nfigures.publish(fig, '1.2')", ""),
        ("q = 1\nfigures.show(fig, 'x')", "q + 1"),
        ("def f(): ...\nfigures.show(fig, 'x')", "f()"),
        ("q = 1", ""),
    ],
)
def test_a_cell_that_does_more_than_draw_is_no_drawing(source, later):
    assert not only_draws(source, [new_code_cell("1"), new_code_cell(later)])


def test_stored_pictures_have_256_colours_and_the_course_is_small():
    sizes = [path.stat().st_size for path in NOTEBOOKS.glob("*.ipynb")]
    assert sum(sizes) < 4e6
    for path in NOTEBOOKS.glob("*.ipynb"):
        for cell in code_cells(nbformat.read(path, as_version=4)):
            for png in pictures.of(cell.outputs):
                assert Image.open(io.BytesIO(base64.b64decode(png))).mode == "P", cell.id


def test_a_second_run_changes_no_byte(small):
    assert execute(small).encode() == small.read_bytes()
    assert nbformat.read(small, as_version=4).metadata == METADATA
