"""Run a notebook that was handed in, in this process, and write down after each cell what its answers are by then.

`grade` starts this as a process of its own: NOTEBOOK, the file for what is written down, the limits on seconds of
computing and on bytes of memory, and the names of the answers. An error in a cell stops that cell only.
"""

import json
import os
import sys
from pathlib import Path
from typing import Any

from IPython.core.interactiveshell import InteractiveShell

from ..exercises import reader
from .plain import encode


def limit(seconds: int, size: int) -> None:
    """Memory on Linux only: elsewhere no such limit is kept. The time that other processes take does not count."""
    if sys.platform != "win32":
        import resource

        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        if sys.platform == "linux":
            resource.setrlimit(resource.RLIMIT_AS, (size, size))


def code(notebook: Path) -> list[str]:
    """The sources of the code cells. Raises where the file is no notebook."""
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]


def run(notebook: Path, file: Path, names: list[str]) -> None:
    """Run every cell; ``file`` always holds how far it is, which cells failed, and the answers by then."""
    state: dict[str, Any] = {"cell": 0, "failed": [], "answers": {}, "student": "", "ended": False}
    sources = code(notebook)
    shell = InteractiveShell.instance()
    sys.path.insert(0, "")
    for number, source in enumerate(sources, 1):
        write(state | {"cell": number}, file)
        error = (outcome := shell.run_cell(source)).error_before_exec or outcome.error_in_exec
        if error is not None:
            state["failed"].append([number, type(error).__name__[:80]])
        if plots := sys.modules.get("matplotlib.pyplot"):
            plots.close("all")
        state["answers"] = {name: encode(shell.user_ns.get(name)) for name in names}
        state["student"] = str(reader.name)[:200]
    write(state | {"ended": True}, file)


def write(state: dict[str, Any], file: Path) -> None:
    """At once or not at all, whenever this process ends."""
    part = file.with_suffix(".part")
    part.write_text(json.dumps(state), encoding="utf-8")
    part.replace(file)


if __name__ == "__main__":
    limit(int(sys.argv[3]), int(sys.argv[4]))
    run(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[5:])
    os._exit(0)  # whatever threads are left
