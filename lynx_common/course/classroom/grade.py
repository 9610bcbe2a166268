"""Grade what was handed in, without nbgrader: `python -m lynx_common.course.classroom.grade FOLDER`.

FOLDER holds one folder a student; a notebook lying loose is told by its file's name, as in
ada-A1_forward_kinematics.ipynb. Each notebook runs in a fresh process, in a temporary copy of its folder, with
limits on time and, on Linux, on memory. Its answers are taken by name, as plain data, and judged in this process,
so that what it has made of its check cells does not matter. It is no sandbox: a notebook does what it says.
"""

import contextlib
import csv
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

from .. import exercises
from ..execute import NOTEBOOKS, ROOT
from ..exercises.exercise import RIGHT
from ..kernel import kernel_environment
from . import answers
from .plain import decode

FILE = ROOT / "build" / "grades.csv"
SECONDS = 60  # of computing, for a notebook; the slowest needs 14
WAIT = 300  # seconds in all: for one that sleeps, and on Windows
BYTES = 4 * 2**30
WARNING = "This is no sandbox: each notebook runs with your rights, and can read and change what you can."


class Row(NamedTuple):
    """One line of the table: an exercise of a notebook, or a notebook of which nothing can be said by exercise."""

    student: str
    name: str  # that the notebook sets with exercises.student, whose numbers it is judged by
    notebook: str
    exercise: str
    points: int
    said: str
    run: str  # how the notebook's run ended


def grade(folder: Path, seconds: int = SECONDS, wait: float = WAIT) -> Iterator[Row]:
    """The rows of all notebooks in ``folder``, by student."""
    known = {path.stem: answers(path) for path in sorted(NOTEBOOKS.glob("*.ipynb"))}
    paths = sorted(path for path in folder.rglob("*.ipynb") if ".ipynb_checkpoints" not in path.parts)
    stems = [next((stem for stem in known if stem in path.stem), "") for path in paths]
    names = [known.get(stem, {}) for stem in stems]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        runs = pool.map(lambda path, own: run(path, folder, [*own.values()], seconds, wait), paths, names)
        for path, stem, own, (state, end) in zip(paths, stems, names, runs, strict=True):
            place = path.relative_to(folder)
            loose = path.stem.partition(stem)[0].strip("-_ ") if stem else path.stem
            yield from rows(place.parts[0] if place.parts[1:] else loose, str(place), own, state, end)


def rows(student: str, place: str, names: dict[str, str], state: dict, end: str) -> Iterator[Row]:
    """A row for each exercise; one for a notebook that is none of the course's."""
    name = str(state.get("student", ""))
    if not names:
        yield Row(student, name, place, "", 0, "no notebook with exercises has this name; see 00_index.", end)
    for key, answer in names.items():
        try:
            said = exercises.find(key, name).judge(decode(state.get("answers", {}).get(answer)))
        except Exception:  # a notebook can have written what it likes
            said = "its answer cannot be read."
        yield Row(student, name, place, key, int(said == RIGHT), said, end)


def run(path: Path, folder: Path, names: list[str], seconds: int, wait: float) -> tuple[dict[str, Any], str]:
    """What a notebook's process wrote down, and a sentence on how it ended."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as temporary:
        work, file = Path(temporary, "work"), Path(temporary, "state.json")
        runner = [sys.executable, "-P", "-m", f"{__package__}.run", str(work / path.name), str(file)]
        try:
            if path.parent == folder:  # beside it are other students' notebooks
                work.mkdir()
                shutil.copy(path, work)
            else:
                shutil.copytree(path.parent, work, symlinks=True)
            code = exit_code([*runner, str(seconds), str(BYTES), *names], work, wait)
            state = json.loads(file.read_text(encoding="utf-8"))
            return state, ending(state, code, seconds, wait)
        except OSError:  # not to be copied, or left before its first cell
            return {}, "it cannot be read as a notebook."
        except Exception:  # a notebook can have written what it likes
            return {}, "what it left cannot be read."


def exit_code(command: list[str], work: Path, wait: float) -> int | None:
    """Run the command, and end all that it has started; None where it did not come to its end in time."""
    process = subprocess.Popen(
        command,
        cwd=work,
        env=kernel_environment(MPLBACKEND="agg", IPYTHONDIR=str(work.parent)),
        start_new_session=True,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        return process.wait(wait)
    except subprocess.TimeoutExpired:
        return None
    finally:
        with contextlib.suppress(OSError):
            os.killpg(process.pid, signal.SIGKILL) if hasattr(os, "killpg") else process.kill()
        process.wait()


def ending(state: dict[str, Any], code: int | None, seconds: int, wait: float) -> str:
    """How the run ended, in a sentence."""
    failed = [f"{error} in code cell {number}" for number, error in state["failed"]]
    if state["ended"]:
        rest = f", and {len(failed) - 1} more" if failed[1:] else ""
        return f"it ran to its end, but for {failed[0]}{rest}." if failed else "it ran to its end."
    where = f"in code cell {state['cell']}" + (f"; before that, {failed[0]}" if failed else "")
    if code is None:
        return f"it was stopped after {wait:g} s, {where}."
    if code and -code == getattr(signal, "SIGXCPU", None):
        return f"it was stopped after {seconds} s of computing, {where}."
    return f"its process ended {where}."


def shown(entry: object) -> object:
    """What a spreadsheet does not take for a formula."""
    return f"'{entry}" if isinstance(entry, str) and entry.startswith(("=", "+", "-", "@")) else entry


def main(folder: Path) -> int:
    if not folder.is_dir():
        print(f"There is no folder {folder}. Name one, as in: make grade DIR=submissions", file=sys.stderr)
        return 1
    print(WARNING)
    FILE.parent.mkdir(exist_ok=True)
    with FILE.open("w", encoding="utf-8", errors="backslashreplace", newline="") as file:
        table = csv.writer(file)
        table.writerow(Row._fields)
        table.writerows(map(shown, row) for row in grade(folder.resolve()))
    print(f"The grades are in {FILE}")
    return 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
