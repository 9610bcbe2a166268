"""Run the course's notebooks, all at once, so that two runs give the same bytes.

`python -m lynx_common.course.execute notebooks` executes every notebook in place; this is how the outputs in
the repository are made. `... figures [NAME ...]` executes the notebooks that publish figures (or those called by a
NAME, or that publish a figure of that name) without touching them, and leaves the figures' files in figures/.
`... copies FOLDER` leaves executed copies of all notebooks in a folder. LYNX_ARM="L_1=0.25 L_3=0.12" in the
environment sets another arm; its figures have a folder of their own, and the notebooks are not touched.
"""

import argparse
import os
import re
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import NamedTuple

import nbformat
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

import lynx_common
from lynx_common.course.figures import FIGURE, is_called
from lynx_common.course.kernel import code_cells, execute
from lynx_common.errors import LynxError

ROOT = Path(lynx_common.__file__).parents[1]
NOTEBOOKS = ROOT / "notebooks"
ARM = os.environ.get("LYNX_ARM", "").replace(",", " ").split()
FIGURES = ROOT / "figures" / "_".join(ARM)
ANOTHER = (
    "> This page was computed for another arm: {} (in metres). Numbers in its words, and what its exercises and "
    "challenges ask for, are those of the course's own arm."
)
ANSI_COLOUR = re.compile(r"\x1b\[[\d;]*m")


class Run(NamedTuple):
    """What came of executing one notebook: its new text, or else an account of its failure."""

    path: Path
    seconds: float
    text: str = ""
    failure: str = ""


def attempt(path: Path, environment: dict[str, str]) -> Run:
    """Run the notebook, and turn a failing cell into a readable account of it."""
    start = time.perf_counter()
    try:
        text, failure = execute(path, **environment), ""
    except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
        text, failure = "", ANSI_COLOUR.sub("", str(error)).strip()
    return Run(path, time.perf_counter() - start, text, failure)


def run_all(environments: dict[Path, dict[str, str]]) -> Iterator[Run]:
    """Run notebooks in parallel, each with what it is told, and yield them as they come to their end."""
    with ProcessPoolExecutor(max(2, os.cpu_count() or 2)) as pool:
        runs = [pool.submit(attempt, path, environment) for path, environment in environments.items()]
        yield from (run.result() for run in as_completed(runs))


def store(run: Run) -> str:
    """Write the notebook back where it changed, and say whether it did."""
    if run.path.read_bytes() == run.text.encode():
        return "unchanged"
    run.path.write_bytes(run.text.encode())
    return "rewritten"


def report(environments: dict[Path, dict[str, str]], done: Callable[[Run], str]) -> bool:
    """Run the notebooks; a line for each with what is left, and below it what went wrong. Whether nothing did."""
    left = [short_name(path) for path in environments]
    print(f"Running {', '.join(left)}", flush=True)
    fine = True
    for run in run_all(environments):
        left.remove(short_name(run.path))
        verdict = "FAILED" if run.failure else done(run)
        waiting = f"; left: {', '.join(left)}" if left else ""
        print(f"{run.path.stem:<30} {run.seconds:5.1f} s  {verdict}{waiting}", flush=True)
        if run.failure:
            print(f"\nIn {run.path.name}: {run.failure}\n", file=sys.stderr, flush=True)
            fine = False
    return fine


def update_notebooks() -> int:
    """Execute every notebook in place; the exit code says whether all came to their end."""
    if ARM:
        print(
            "The notebooks are stored for the arm as committed; make figures and make site take ARM.",
            file=sys.stderr,
        )
        return 2
    return int(not report({path: {} for path in sorted(NOTEBOOKS.glob("*.ipynb"))}, store))


def make_copies(folder: Path) -> int:
    """Execute copies of all notebooks in ``folder``; those of another arm say so below their title."""
    folder.mkdir(parents=True, exist_ok=True)
    for path in NOTEBOOKS.glob("*.ipynb"):
        notebook = nbformat.read(path, as_version=4)
        if ARM:
            title, _, rest = notebook.cells[0].source.partition("\n")
            notebook.cells[0].source = f"{title}\n\n{ANOTHER.format(', '.join(ARM))}\n{rest}"
        nbformat.write(notebook, folder / path.name)
    return int(not report({path: {} for path in sorted(folder.glob("*.ipynb"))}, store))


def published(path: Path) -> list[str]:
    """Numbers of the figures that the notebook's cells publish, drawn tables among them."""
    source = "\n".join(cell.source for cell in code_cells(nbformat.read(path, as_version=4)))
    shown = re.findall(r"""figures\.publish\(\s*\w+,\s*["'](\d+\.\d+\w*|[a-z]+)["']""", source)
    return shown + re.findall(FIGURE, source)


def needed_for(names: list[str], catalogue: dict[Path, list[str]]) -> dict[Path, dict[str, str]]:
    """The notebooks to run for names of notebooks and figures, and what to tell them."""
    needed: dict[Path, dict[str, str]] = {}
    for path, numbers in catalogue.items():
        wanted = [name for name in names if any(is_called(number, name) for number in numbers)]
        if not names or {path.stem, short_name(path)} & set(names):
            needed[path] = {}
        elif wanted:
            needed[path] = {"LYNX_FIGURE": " ".join(wanted)}
    return needed


def short_name(path: Path) -> str:
    return path.stem.split("_")[0]


def make_figures(names: list[str]) -> int:
    """Run what publishes the figures asked for; say how many were written, and where."""
    catalogue = {path: numbers for path in sorted(NOTEBOOKS.glob("*.ipynb")) if (numbers := published(path))}
    for name in names:
        if not needed_for([name], catalogue):
            known = {number for numbers in catalogue.values() for number in numbers}
            valid = ", ".join([*map(short_name, catalogue), *sorted(known, key=natural)])
            print(f"No notebook or figure is called {name!r}. Valid: {valid}.", file=sys.stderr)
            return 2
    FIGURES.mkdir(parents=True, exist_ok=True)
    before = times_written()
    needed = needed_for(names, catalogue)
    folder = {"LYNX_FIGURES": str(FIGURES)}
    fine = report({path: folder | more for path, more in needed.items()}, lambda run: "done")
    written = {path.stem for path, when in times_written().items() if before.get(path) != when}
    print(f"{len(written)} figure{'s' * (len(written) != 1)} written to {FIGURES}")
    return int(not (fine and written))


def natural(number: str) -> tuple[list[int], str]:
    return [int(digits) for digits in re.findall(r"\d+", number)], number


def times_written() -> dict[Path, int]:
    return {path: path.stat().st_mtime_ns for path in FIGURES.glob("fig-*")}


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m lynx_common.course.execute", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("notebooks", help="execute every notebook in place")
    copies = commands.add_parser("copies", help="execute copies of all notebooks")
    copies.add_argument("folder", type=Path)
    figures = commands.add_parser("figures", help="write the published figures to figures/")
    figures.add_argument("names", nargs="*", help="notebooks (A1) and figures (1.2); default: all")
    arguments = parser.parse_args()
    try:
        from lynx_common import arm  # noqa: F401  reads the lengths of LYNX_ARM
    except LynxError as fault:
        print(fault, file=sys.stderr)
        return 2
    if arguments.command == "notebooks":
        return update_notebooks()
    if arguments.command == "copies":
        return make_copies(arguments.folder.resolve())
    return make_figures(" ".join(arguments.names).replace(",", " ").split())


if __name__ == "__main__":
    sys.exit(main())
