"""What nbval leaves out, so that a notebook passes only if every output still holds.

nbval re-runs each notebook and compares text, equations and tables. This plugin (loaded by pyproject.toml, so
that it holds wherever a notebook lies) adds five things: pictures are compared too; a trailing `;` silences a
cell, as in JupyterLab; a notebook that is not as `make notebooks` leaves it is refused when collected; cells have
the numbers that JupyterLab shows; and a notebook stops at the first cell that fails, since one cause would make
many more fail. nbval offers no hooks for these, hence the replacements at the end.
"""

import functools
import os
from collections.abc import Iterator
from pathlib import Path

import nbformat
import nbval.kernel
import pytest
from nbval.plugin import IPyNbCell, IPyNbFile, comment_markers, metadata_tags

from lynx_common.course import pictures
from lynx_common.course.kernel import FIXED, KERNEL_ARGUMENTS, PERSONAL, code_cells, kernel_environment

# What can be said in a cell so that nbval asks nothing of it.
EXEMPTIONS = {
    name for name in (*comment_markers, *metadata_tags) if "ignore" in name.lower() or "skip" in name.lower()
}


def compare_outputs(cell: IPyNbCell, drawn: list, stored: list, skip_compare=None) -> bool:
    """nbval's comparison, which skips PNGs, and then the PNGs."""
    if not nbval_compare_outputs(cell, drawn, stored, skip_compare):
        return False
    drawn, stored = pictures.of(drawn), pictures.of(stored)
    if len(drawn) != len(stored):
        differences = [f"{len(stored)} pictures stored, {len(drawn)} drawn"]
    else:
        differences = list(filter(None, map(pictures.difference, stored, drawn)))
    cell.comparison_traceback += differences
    return not differences


def execute_cell_input(kernel: nbval.kernel.RunningKernel, source: str, allow_stdin=None) -> str:
    """Run a cell as JupyterLab does: IPython honours a trailing `;` only in cells that enter the history."""
    return kernel.kc.execute(source, store_history=True, allow_stdin=allow_stdin, stop_on_error=False)


def collect(file: IPyNbFile) -> Iterator[IPyNbCell]:
    """nbval's collection, for a notebook that can be trusted to hold outputs at all."""
    if faults := stored_faults(nbformat.read(file.path, as_version=4)):
        raise file.CollectError(f"{file.path.name} {' and '.join(faults)}; run `make notebooks`.")
    for cell in nbval_collect(file):
        number = cell.cell.execution_count or 0  # an empty cell has none
        name = f"cell [{number}]" if number else f"empty cell {cell.cell_num + 1}"
        yield IPyNbCell.from_parent(file, name=name, cell_num=number, cell=cell.cell, options=cell.options)


def runtest(cell: IPyNbCell) -> None:
    """nbval's test, unless a cell before has failed: what follows from that says nothing new."""
    first = getattr(cell.parent, "first_failure", None)
    if first:
        pytest.skip(f"{first} has failed")
    try:
        nbval_runtest(cell)
    except Exception:
        cell.parent.first_failure = cell.name
        raise


def stored_faults(notebook: nbformat.NotebookNode) -> list[str]:
    """What shows that the notebook is not as `make notebooks` leaves it."""
    cells = [cell for cell in code_cells(notebook) if cell.source.strip()]
    counts = [cell.execution_count for cell in cells]
    in_order = counts == list(range(1, len(cells) + 1))
    faults = {
        "was never run": cells and not any(counts),
        "was not run from top to bottom in a fresh kernel": any(counts) and not in_order,
        "stores an error": any(map(stores_error, cells)),
        "stores a message on stderr": any(o.get("name") == "stderr" for cell in cells for o in cell.outputs),
        "stores the state of widgets": "widgets" in notebook.metadata,
        "stores the times of its execution": any("execution" in cell.metadata for cell in notebook.cells),
        "exempts a cell from being compared": any(map(is_exempt, cells)),
    }
    return [fault for fault, found in faults.items() if found]


def stores_error(cell: nbformat.NotebookNode) -> bool:
    expected = "raises-exception" in cell.metadata.get("tags", [])
    return not expected and any(output.output_type == "error" for output in cell.outputs)


def is_exempt(cell: nbformat.NotebookNode) -> bool:
    said = {*cell.metadata.get("tags", []), *(line.strip("# \t") for line in cell.source.splitlines())}
    return not said.isdisjoint(EXEMPTIONS)


def pytest_unconfigure(config: pytest.Config) -> None:
    """The last line of a run in which a cell failed."""
    reporter = config.pluginmanager.get_plugin("terminalreporter")
    failed = [report.nodeid for report in reporter.stats.get("failed", [])] if reporter else []
    cells = [nodeid.split("::") for nodeid in failed if ".ipynb::" in nodeid]
    if cells and not hasattr(config, "workerinput"):
        where = ", ".join(f"{name} of {Path(path).stem}" for path, name in cells)
        print(
            f"What to do: look at {where} (JupyterLab shows these numbers) and mend what is wrong there or above; "
            "if the new output is meant, run `make notebooks` and look at its diff."
        )


# The tests themselves draw, too, and start processes; what is the reader's own stays out of all of them.
for name in PERSONAL:
    os.environ.pop(name, None)
os.environ.update(FIXED)

nbval_collect, nbval_compare_outputs, nbval_runtest = (
    IPyNbFile.collect,
    IPyNbCell.compare_outputs,
    IPyNbCell.runtest,
)
IPyNbFile.collect, IPyNbCell.compare_outputs, IPyNbCell.runtest = collect, compare_outputs, runtest
nbval.kernel.RunningKernel.execute_cell_input = execute_cell_input
nbval.kernel.start_new_kernel = functools.partial(
    nbval.kernel.start_new_kernel, env=kernel_environment(), extra_arguments=KERNEL_ARGUMENTS
)
