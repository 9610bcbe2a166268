"""The checks on the notebooks can fail, and the executor's work is the same every time."""

import base64
import io
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import nbformat
import numpy as np
import pytest
from nbformat.v4 import new_code_cell, new_notebook, new_output
from PIL import Image
from strict_nbval import code_cells

from lynx_common.course.execute import NOTEBOOKS, ROOT
from lynx_common.course.kernel import METADATA, execute
from lynx_common.course.pictures import pixels

SMALL = [
    "import matplotlib.pyplot as plt\nfrom IPython.display import Math\nfrom ipywidgets import Image",
    "print(0.2156, 0.373429)",
    "Math(r'$\\sqrt{x}$')",
    "plt.plot([0, 1], [0, 2], 'o')\nplt.show()",
    "plt.title('no text from this cell');",
    "Image(value=b'', alt='a widget')",
    "",
    "1 + 1",
]


@pytest.fixture(scope="module")
def small(tmp_path_factory) -> Path:
    """A notebook with one cell of each kind, executed."""
    path = tmp_path_factory.mktemp("small") / "small.ipynb"
    cells = [new_code_cell(source, id=f"cell-{number}") for number, source in enumerate(SMALL)]
    nbformat.write(new_notebook(cells=cells), path)
    path.write_text(execute(path))
    return path


class Outcome(NamedTuple):
    """What pytest said of the copies of a notebook."""

    changed: set[int]  # cells that hold a changed output
    failed: dict[str, set]  # by copy: the cells that failed, or {"all"} where the notebook was refused
    output: str


BOOKS = "small", "course"


@pytest.fixture(scope="module")
def outcomes(small, tmp_path_factory) -> dict[str, Outcome]:
    """Copies of the small notebook and of one of the course's, each spoiled in one way; pytest run on all."""
    paths = dict(zip(BOOKS, (small, NOTEBOOKS / "A1_forward_kinematics.ipynb"), strict=True))
    folder = tmp_path_factory.mktemp("copies")
    changed = {book: spoiled_copies(path, folder, book) for book, path in paths.items()}
    failed, output = check(folder)
    return {book: Outcome(changed[book], failed[book], output) for book in BOOKS}


def spoiled_copies(path: Path, folder: Path, book: str) -> set[int]:
    """Write copies of a notebook, spoiled in one way each; returns the cells of `changed` that are."""
    copies = {name: nbformat.read(path, as_version=4) for name in ("changed", *SPOILS)}
    cells = {change_one(copies["changed"], change) for change in (change_digit, change_equation, change_picture)}
    if book == "small":
        copies["noisy"] = nbformat.read(path, as_version=4)
        change_one(copies["noisy"], add_noise)
    else:
        end_after(copies["changed"], max(cells))  # what follows is not changed, and takes seconds
    for name, (spoil, _) in SPOILS.items():
        spoil(copies[name])
    for name, copy in copies.items():
        nbformat.write(copy, folder / f"{book}-{name}.ipynb")
    return cells


def check(folder: Path) -> tuple[dict[str, dict[str, set]], str]:
    """Run pytest on all copies, as `make test` does; the cells of each that failed, and its output."""
    failed = {book: {name: set() for name in ("changed", "noisy", *SPOILS)} for book in BOOKS}
    command = [sys.executable, "-m", "pytest", "-n0", "-rA", "--color=no", "-c", ROOT / "pyproject.toml"]
    run = subprocess.run([*command, "--rootdir", ROOT, folder], capture_output=True, text=True, cwd=folder)
    lines = re.compile(r"^(?:FAILED|ERROR) \S*?(\w+)-(\w+)\.ipynb(?:::Cell (\d+))?", re.MULTILINE)
    for book, name, cell in lines.findall(run.stdout):
        failed[book][name].add(int(cell) if cell else "all")
    return failed, run.stdout


def test_what_holds_passes_with_noise_that_nobody_sees(outcomes):
    passed = re.findall(r"^PASSED .*small-noisy\.ipynb::Cell", outcomes["small"].output, re.MULTILINE)
    assert len(passed) == len(SMALL)
    assert outcomes["small"].failed["noisy"] == set()


@pytest.mark.parametrize("book", BOOKS)
def test_a_changed_output_fails_in_its_own_cell_only(book, outcomes):
    outcome = outcomes[book]
    assert len(outcome.changed) == 3
    assert outcome.failed["changed"] == outcome.changed
    assert "picture differs: " in outcome.output


@pytest.mark.parametrize("book", BOOKS)
def test_a_notebook_not_as_made_is_refused(book, outcomes):
    for name, (_, fault) in SPOILS.items():
        assert outcomes[book].failed[name] == {"all"}
        assert f"{book}-{name}.ipynb {fault}; run `make notebooks`." in outcomes[book].output


def change_one(notebook, change) -> int:
    """Change the first output that can be changed in this way; returns the number of its cell."""
    for number, cell in enumerate(code_cells(notebook)):
        compared = "nbval-ignore-output" not in cell.metadata.get("tags", [])
        if compared and any(map(change, cell.outputs)):
            return number
    raise ValueError(f"no output for {change.__name__}")


def end_after(notebook, number: int):
    last = notebook.cells.index(code_cells(notebook)[number])
    del notebook.cells[last + 3 :]  # at least one code cell more, which must pass


def change_digit(output) -> bool:
    """In what a cell prints, or in a result that is shown as plain text."""
    holder, key = (output, "text") if output.output_type == "stream" else (output.data, "text/plain")
    before = holder[key]
    if output.output_type == "stream" or list(output.data) == ["text/plain"]:
        holder[key] = re.sub(r"\d(?=\D*$)", lambda digit: str((int(digit[0]) + 1) % 10), before)
    return holder[key] != before


def change_equation(output) -> bool:
    return replace_data(output, "text/latex", lambda latex: latex.replace("$", "$-", 1))


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


SPOILS = {
    "stripped": (strip, "was never run"),
    "disordered": (disorder, "was not run from top to bottom in a fresh kernel"),
    "warned": (warn, "stores a message on stderr"),
    "failed": (fail, "stores an error"),
    "with_widgets": (keep_widgets, "stores the state of widgets"),
    "with_times": (keep_times, "stores the times of its execution"),
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


def test_a_second_run_changes_no_byte(small):
    assert execute(small).encode() == small.read_bytes()
    assert nbformat.read(small, as_version=4).metadata == METADATA
