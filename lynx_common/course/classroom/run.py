"""Run a notebook that was handed in, in this process, and write down after each cell what its answers are by then.

`grade` starts this as a process of its own: NOTEBOOK, the file for what is written down, the answers' names by
exercise, as JSON, the limits on seconds of computing and on bytes of memory. An error in a cell stops no other.
"""

import json
import os
import sys
from pathlib import Path
from typing import Any

from IPython.core.interactiveshell import InteractiveShell

from ..exercises import find, reader
from ..exercises.answers import UnreadableAnswerError

FILE_BYTES = 2**28  # of each file that is written


class Shell(InteractiveShell):
    def enable_gui(self, gui: object = None) -> None:
        """Nothing, so that %matplotlib works."""


def limit(seconds: int, size: int) -> None:
    """Never above what is allowed here. The time that other processes take does not count."""
    if sys.platform != "win32":
        import resource

        limits = {resource.RLIMIT_CPU: seconds, resource.RLIMIT_FSIZE: FILE_BYTES}
        if sys.platform == "linux":  # elsewhere this one is not kept
            limits[resource.RLIMIT_AS] = size
        for kind, soft in limits.items():
            hard = resource.getrlimit(kind)[1]
            top = soft + 1 if hard == resource.RLIM_INFINITY else min(soft + 1, hard)
            resource.setrlimit(kind, (min(soft, top), top))


def code(notebook: Path) -> list[str]:
    """The sources of the code cells. Raises where the file is no notebook."""
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]


def read(exercise: str, student: str, answer: object) -> list | float | str | None:
    """An answer as floats; a sentence where it cannot be read as those; None where there is none.

    >>> read("A2.1", "", 0.25), read("A2.1", "", "1/4")
    (0.25, 'one number is expected; text was given.')
    """
    if answer is None or answer is ...:
        return None
    try:
        return find(exercise, student).form.read(answer).tolist()
    except UnreadableAnswerError as fault:
        return str(fault)


def run(notebook: Path, file: Path, names: dict[str, str]) -> None:
    """Run every cell; ``file`` always holds the answers by then, and how the run would be told of."""
    shell = Shell.instance()
    failed: list[str] = []
    state: dict[str, Any] = {"student": "", "answers": {}, "ended": False}
    try:
        sources = code(notebook)
    except Exception:
        return write(state | {"ended": True, "said": "cannot be read as a notebook"}, file)
    sys.path.insert(0, "")
    for number, source in enumerate(sources, 1):
        write(state | {"said": f"in code cell {number}" + told("; before that, ", failed)}, file)
        error = (outcome := shell.run_cell(source)).error_before_exec or outcome.error_in_exec
        if error is not None:
            failed.append(f"{type(error).__name__:.80} in code cell {number}")
        if plots := sys.modules.get("matplotlib.pyplot"):
            plots.close("all")
        name = str(reader.name)[: reader.LONGEST]
        own = {key: read(key, name, shell.user_ns.get(answer)) for key, answer in names.items()}
        state |= {"student": name, "answers": own}
    write(state | {"ended": True, "said": "ran to its end" + told(", but for ", failed)}, file)


def told(before: str, failed: list[str]) -> str:
    """The first of what failed, and how much more there is."""
    rest = f", and {len(failed) - 1} more" if failed[1:] else ""
    return f"{before}{failed[0]}{rest}" if failed else ""


def write(state: dict[str, Any], file: Path) -> None:
    """At once or not at all, whenever this process ends."""
    part = file.with_suffix(".part")
    part.write_text(json.dumps(state), encoding="utf-8")
    part.replace(file)


if __name__ == "__main__":
    limit(int(sys.argv[4]), int(sys.argv[5]))
    run(Path(sys.argv[1]), Path(sys.argv[2]), json.loads(sys.argv[3]))
    os._exit(0)  # whatever threads are left
