"""One notebook in one fresh kernel, prepared so that every run gives the same outputs.

The kernel is the interpreter that runs this module, whatever kernels are installed elsewhere. The tests start
theirs with the same environment and arguments (tests/strict_nbval.py).
"""

import os
import sys
from pathlib import Path

import nbformat
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient
from nbval.kernel import CURRENT_ENV_KERNEL_NAME, NbvalKernelspecManager

from . import pictures

WIDGET = "application/vnd.jupyter.widget-view+json"
CELL_TIMEOUT = 300  # seconds
FIXED = {
    "PYTHONHASHSEED": "0",
    "SOURCE_DATE_EPOCH": "0",
    "OPENBLAS_NUM_THREADS": "1",
    "COLUMNS": "80",
    "IPYTHONDIR": str(Path(sys.prefix, "ipython")),  # the reader's own start-up files stay out,
    "MPLCONFIGDIR": str(Path(sys.prefix, "matplotlib")),  # and so does a matplotlibrc
    "PYDEVD_DISABLE_FILE_VALIDATION": "1",  # the debugger's advice does not belong in the log
}
PERSONAL = {"MPLBACKEND", "MATPLOTLIBRC", "PYTHONOPTIMIZE", "PYTHONPATH", "LYNX_FIGURES", "LYNX_FIGURE"}
# Widgets, SVG files and animations take their identifiers from uuid4.
STABLE_IDS = """exec('''
import random, uuid
bits = random.Random(0).getrandbits
uuid.uuid4 = lambda: uuid.UUID(int=bits(128), version=4)
''', {})"""
KERNEL_ARGUMENTS = [
    f"--IPKernelApp.exec_lines={STABLE_IDS}",
    "--HistoryManager.hist_file=:memory:",
    "--log-level=ERROR",
]
METADATA = {
    "kernelspec": {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def kernel_environment(**more: str) -> dict[str, str]:
    """The environment of a kernel, here and under nbval: nothing in it that would change an output."""
    inherited = {name: value for name, value in os.environ.items() if name not in PERSONAL}
    return inherited | FIXED | more


def execute(path: Path, **environment: str) -> str:
    """Run the notebook in a fresh kernel; return the text to store, the same every time.

    A picture that looks as the stored one does is kept as it is, so that another processor changes nothing.
    """
    notebook = nbformat.read(path, as_version=4)
    before = {cell.id: pictures.of(cell.outputs) for cell in code_cells(notebook)}
    for cell in code_cells(notebook):
        cell.update(outputs=[], execution_count=None)
        cell.metadata.pop("execution", None)
    client = NotebookClient(
        notebook,
        timeout=CELL_TIMEOUT,
        record_timing=False,
        store_widget_state=False,
        coalesce_streams=True,
        extra_arguments=KERNEL_ARGUMENTS,
    )
    client.km = AsyncKernelManager(
        kernel_name=CURRENT_ENV_KERNEL_NAME, kernel_spec_manager=NbvalKernelspecManager()
    )
    client.execute(cwd=str(path.parent), env=kernel_environment(**environment))
    for cell in code_cells(notebook):
        for output in cell.outputs:
            if "image/png" in output.get("data", {}):  # shown until the cell is run again
                output.data.pop(WIDGET, None)
        pictures.settle(cell.outputs, before[cell.id])
    notebook.metadata = nbformat.from_dict(METADATA)
    return nbformat.writes(notebook).rstrip("\n") + "\n"


def code_cells(notebook: nbformat.NotebookNode) -> list[nbformat.NotebookNode]:
    """Its code cells, in order."""
    return [cell for cell in notebook.cells if cell.cell_type == "code"]
