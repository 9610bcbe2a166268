"""Run the course's notebooks, all at once, so that two runs give the same bytes.

`python -m lynx_common.course.execute notebooks` executes every notebook in place; this is how the outputs in
the repository are made. `python -m lynx_common.course.execute figures [NAME]` executes the notebooks that
publish figures (or the one called NAME, or the one that publishes figure NAME) without touching them, and
leaves the figures' files in figures/.
"""

import argparse
import os
import re
import sys
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import NamedTuple

import nbformat
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

import lynx_common
from lynx_common.course.figures import is_called
from lynx_common.course.kernel import code_cells, execute

ROOT = Path(lynx_common.__file__).parents[1]
NOTEBOOKS = ROOT / "notebooks"
FIGURES = ROOT / "figures"
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


def run_all(paths: Iterable[Path], **environment: str) -> Iterator[Run]:
    """Run the notebooks in parallel, one process each, and yield them as they come to their end."""
    with ProcessPoolExecutor(max(2, os.cpu_count() or 2)) as pool:
        runs = [pool.submit(attempt, path, environment) for path in paths]
        yield from (run.result() for run in as_completed(runs))


def store(run: Run) -> str:
    """Write the notebook back where it changed, and say whether it did."""
    if run.path.read_bytes() == run.text.encode():
        return "unchanged"
    run.path.write_bytes(run.text.encode())
    return "rewritten"


def report(run: Run, verdict: str) -> None:
    """One line for the notebook, and below it what went wrong, if anything did."""
    print(f"{run.path.stem:<30} {run.seconds:5.1f} s  {'FAILED' if run.failure else verdict}", flush=True)
    if run.failure:
        print(f"\nIn {run.path.name}: {run.failure}\n", file=sys.stderr, flush=True)


def update_notebooks() -> int:
    """Execute every notebook in place; the exit code says whether all came to their end."""
    runs = []
    for run in run_all(sorted(NOTEBOOKS.glob("*.ipynb"))):
        report(run, "" if run.failure else store(run))
        runs.append(run)
    return int(any(run.failure for run in runs))


def published(path: Path) -> list[str]:
    """Numbers of the figures that the notebook's cells publish."""
    source = "\n".join(cell.source for cell in code_cells(nbformat.read(path, as_version=4)))
    return re.findall(r"""figures\.publish\(\s*\w+,\s*["'](\d+\.\d+\w*|[a-z]+)["']""", source)


def needed_for(name: str, catalogue: dict[Path, list[str]]) -> tuple[list[Path], dict[str, str]]:
    """The notebooks to run for a notebook's or a figure's name, and what to tell them; none if unknown."""
    if not name:
        return list(catalogue), {}
    if named := [path for path in catalogue if name in (path.stem, short_name(path))]:
        return named, {}
    found = [path for path, numbers in catalogue.items() if any(is_called(number, name) for number in numbers)]
    return found, {"LYNX_FIGURE": name}


def short_name(path: Path) -> str:
    return path.stem.split("_")[0]


def make_figures(name: str) -> int:
    """Run what publishes the figures asked for; say how many were written, and where."""
    catalogue = {path: numbers for path in sorted(NOTEBOOKS.glob("*.ipynb")) if (numbers := published(path))}
    paths, environment = needed_for(name, catalogue)
    if name and not paths:
        known = {number for numbers in catalogue.values() for number in numbers}
        valid = [*map(short_name, catalogue), *sorted(known, key=natural)]
        print(f"No notebook or figure is called {name!r}. Valid: {', '.join(valid)}.", file=sys.stderr)
        return 2
    FIGURES.mkdir(exist_ok=True)
    before = times_written()
    failed = False
    for run in run_all(paths, LYNX_FIGURES=str(FIGURES), **environment):
        report(run, "done")
        failed |= bool(run.failure)
    written = {path.stem for path, when in times_written().items() if before.get(path) != when}
    print(f"{len(written)} figure{'s' * (len(written) != 1)} written to {FIGURES}")
    return int(failed or not written)


def natural(number: str) -> tuple[list[int], str]:
    return [int(digits) for digits in re.findall(r"\d+", number)], number


def times_written() -> dict[Path, int]:
    return {path: path.stat().st_mtime_ns for path in FIGURES.glob("fig-*")}


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m lynx_common.course.execute", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("notebooks", help="execute every notebook in place")
    figures = commands.add_parser("figures", help="write the published figures to figures/")
    figures.add_argument("name", nargs="?", default="", help="notebook (A1) or figure (1.2); default: all")
    arguments = parser.parse_args()
    return update_notebooks() if arguments.command == "notebooks" else make_figures(arguments.name)


if __name__ == "__main__":
    sys.exit(main())
