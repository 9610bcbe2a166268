"""What nbval leaves out, so that a notebook passes only if every output still holds.

nbval re-runs each notebook and compares text, equations and tables. This plugin (loaded by pyproject.toml, so
that it holds wherever a notebook lies) adds three things: pictures are compared too; a trailing `;` silences
a cell, as in JupyterLab; and a notebook that is not as `make notebooks` leaves it is refused when collected.
nbval offers no hooks for these, hence the replacements at the end.
"""

import base64
import functools
import io

import nbformat
import nbval.kernel
import numpy as np
from nbval.plugin import IPyNbCell, IPyNbFile
from PIL import Image

from lynx_common.course.kernel import KERNEL_ARGUMENTS, code_cells, kernel_environment

# On one machine a picture is the same to the byte. Between processors, rounding shades a few pixels at the
# edge of a line a little. One changed digit, in print as small as 7 points, is 19 pixels or more.
LEVELS = 16  # of 255, in any channel: less cannot be seen
PIXELS = 20_000  # one in so many may differ by more,
MOST = 15  # but a digit does not grow with the picture


def picture_difference(stored: str, drawn: str) -> str:
    """How two base64 PNGs differ, in a sentence; empty if they are the same picture."""
    stored, drawn = pixels(stored), pixels(drawn)
    if stored.shape != drawn.shape:
        return f"picture differs: {size(stored)} pixels stored, {size(drawn)} drawn"
    allowed = min(MOST, stored.shape[0] * stored.shape[1] // PIXELS)
    differing = np.count_nonzero((abs(stored - drawn) > LEVELS).any(axis=-1))
    if differing <= allowed:
        return ""
    return f"picture differs: {differing} pixels of {size(stored)}, where at most {allowed} may"


def pixels(png: str) -> np.ndarray:
    """Height, width, RGBA of a base64 PNG; signed, so that levels can be subtracted."""
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(png))).convert("RGBA"), dtype=int)


def size(picture: np.ndarray) -> str:
    return f"{picture.shape[1]} x {picture.shape[0]}"


def pictures(outputs: list) -> list[str]:
    return [output["data"]["image/png"] for output in outputs if "image/png" in output.get("data", {})]


def compare_outputs(cell: IPyNbCell, drawn: list, stored: list, skip_compare=None) -> bool:
    """nbval's comparison, which skips PNGs, and then the PNGs."""
    if not nbval_compare_outputs(cell, drawn, stored, skip_compare):
        return False
    drawn, stored = pictures(drawn), pictures(stored)
    if len(drawn) != len(stored):
        differences = [f"{len(stored)} pictures stored, {len(drawn)} drawn"]
    else:
        differences = list(filter(None, map(picture_difference, stored, drawn)))
    cell.comparison_traceback += differences
    return not differences


def execute_cell_input(kernel: nbval.kernel.RunningKernel, source: str, allow_stdin=None) -> str:
    """Run a cell as JupyterLab does: IPython honours a trailing `;` only in cells that enter the history."""
    return kernel.kc.execute(source, store_history=True, allow_stdin=allow_stdin, stop_on_error=False)


def collect(file: IPyNbFile):
    """nbval's collection, for a notebook that can be trusted to hold outputs at all."""
    if faults := stored_faults(nbformat.read(file.path, as_version=4)):
        raise file.CollectError(f"{file.path.name} {' and '.join(faults)}; run `make notebooks`.")
    yield from nbval_collect(file)


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
    }
    return [fault for fault, found in faults.items() if found]


def stores_error(cell: nbformat.NotebookNode) -> bool:
    expected = "raises-exception" in cell.metadata.get("tags", [])
    return not expected and any(output.output_type == "error" for output in cell.outputs)


nbval_collect, nbval_compare_outputs = IPyNbFile.collect, IPyNbCell.compare_outputs
IPyNbFile.collect, IPyNbCell.compare_outputs = collect, compare_outputs
nbval.kernel.RunningKernel.execute_cell_input = execute_cell_input
nbval.kernel.start_new_kernel = functools.partial(
    nbval.kernel.start_new_kernel, env=kernel_environment(), extra_arguments=KERNEL_ARGUMENTS
)
