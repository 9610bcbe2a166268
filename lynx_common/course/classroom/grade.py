"""Grade what was handed in, without nbgrader: `python -m lynx_common.course.classroom.grade FOLDER`.

FOLDER holds one folder a student; a notebook lying loose is told by its file's name, as in
ada-A1_forward_kinematics.ipynb. Each notebook runs in a fresh process, in a temporary copy of its folder, with
limits on time and, on Linux, on memory. There its answers become plain numbers, which are checked and judged here,
so that what it has made of its check cells does not matter. It is no sandbox: a notebook does what it says.
"""

import contextlib
import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from .. import exercises
from ..execute import NOTEBOOKS, ROOT
from ..exercises import reader
from ..exercises.exercise import NOT_ATTEMPTED, RIGHT, Exercise
from ..kernel import kernel_environment
from . import answers, write_table

FILE = ROOT / "build" / "grades.csv"
SECONDS = 60  # of computing, for a notebook; the slowest needs 14
WAIT = 300  # seconds in all: for one that sleeps, and on Windows
BYTES = 4 * 2**30
LARGEST, LONGEST = 10**6, 300  # bytes that a notebook's process writes down, characters of a sentence there
NOT_RUN: tuple[dict, str] = ({}, "it was not run.")
UNREAD = "its answer cannot be read."
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
        runs = pool.map(lambda path, own: run(path, folder, own, seconds, wait) if own else NOT_RUN, paths, names)
        for path, stem, own, (state, end) in zip(paths, stems, names, runs, strict=True):
            place = path.relative_to(folder)
            loose = path.stem.partition(stem)[0].strip("-_ ") if stem else path.stem
            yield from rows(place.parts[0] if place.parts[1:] else loose, str(place), own, state, end)


def rows(student: str, place: str, names: dict[str, str], state: dict[str, Any], end: str) -> Iterator[Row]:
    """A row for each exercise; one for a notebook that is none of the course's."""
    name = state.get("student", "")
    if not names:
        yield Row(student, name, place, "", 0, "no notebook with exercises has this name; see 00_index.", end)
    for key in names:
        try:
            said = judged(exercises.find(key, name), state.get("answers", {}).get(key))
        except Exception:  # a notebook can have written what it likes
            said = UNREAD
        yield Row(student, name, place, key, int(said == RIGHT), said, end)


def judged(exercise: Exercise, answer: Any) -> str:
    """What to say about an answer as `run` has read it, or about anything else in its place."""
    if answer is None:
        return NOT_ATTEMPTED
    if isinstance(answer, str):
        return answer[:LONGEST] if answer.startswith(exercise.form.wanted) else UNREAD
    x = np.array(answer)
    sound = x.dtype == float and x.shape == exercise.form.read(exercise.right).shape and np.isfinite(x).all()
    return exercise.judge_read(x) if sound else UNREAD


def run(path: Path, folder: Path, names: dict[str, str], seconds: int, wait: float) -> tuple[dict[str, Any], str]:
    """What a notebook's process wrote down, and a sentence on how it ended."""
    end = "its folder cannot be copied."
    try:
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as temporary:
            work, file = Path(temporary, "work"), Path(temporary, "state.json")
            if path.parent == folder:  # beside it are other students' notebooks
                work.mkdir()
                shutil.copy(path, work, follow_symlinks=False)
            else:
                shutil.copytree(path.parent, work, symlinks=True)
            end = "what it left cannot be read."
            command = [sys.executable, "-P", "-m", f"{__package__}.run", str(work / path.name), str(file)]
            code = exit_code([*command, json.dumps(names), str(seconds), str(BYTES)], work, wait)
            state = left(file)
            return state, ending(state, code, seconds, wait)
    except Exception:  # a notebook can leave what it likes, even a folder that cannot be removed
        return {}, end


def left(file: Path) -> dict[str, Any]:
    """What `run` wrote down. Raises where something else lies there, be it a pipe or a link to what has no end."""
    if not os.path.lexists(file):
        return {"ended": False, "said": "before its first cell"}
    flags = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    with open(file, "rb", opener=lambda path, own: os.open(path, own | flags)) as opened:
        regular = stat.S_ISREG(os.fstat(opened.fileno()).st_mode)
        state = json.loads(opened.read(LARGEST) if regular else b"")
    match state:
        case {"student": str(name), "answers": dict(), "ended": bool(), "said": str(said)}:
            if len(name) <= reader.LONGEST and len(said) <= LONGEST:
                return state
    raise ValueError("not what run writes")


def exit_code(command: list[str], work: Path, wait: float) -> int | None:
    """Run the command; None where it did not come to its end in time.

    What it has started ends with it, unless that has left for a session or group of its own.
    """
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
    if state["ended"]:
        return f"it {state['said']}."
    if code is None:
        return f"it was stopped after {wait:g} s, {state['said']}."
    if code and -code == getattr(signal, "SIGXCPU", None):
        return f"it was stopped after {seconds} s of computing, {state['said']}."
    return f"its process ended {state['said']}."


def main(folder: str = "") -> None:
    if not os.path.isdir(folder):
        sys.exit(f"There is no folder '{folder}'. Name one, as in: make grade DIR=submissions")
    print(WARNING)
    write_table(FILE, chain([Row._fields], grade(Path(folder).resolve())))
    print(f"The grades are in {FILE}")


if __name__ == "__main__":
    main(*sys.argv[1:2])
