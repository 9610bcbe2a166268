"""For a class: nbgrader's source notebooks (`assignment`), grading without nbgrader (`grade`), answers (`key`).

No notebook imports from here. Which exercises there are, and under which names their answers are looked for, is
read from the committed notebooks, whatever somebody has handed in.
"""

import csv
import re
from collections.abc import Iterable
from pathlib import Path

import nbformat

from ..kernel import code_cells

FORMULA = re.compile(r"[=@\t\r\n]|[-+](?!\d[\d.]*$)")  # what a spreadsheet would compute; a number it may
CHECK = re.compile(r'exercises\.check\("(\w+\.\d+)", (\w+)\)')


def answers(notebook: Path) -> dict[str, str]:
    """Of each exercise of a committed notebook, the name of the answer: {"A1.1": "answer_1", ...}."""
    cells = code_cells(nbformat.read(notebook, as_version=4))
    return {found[1]: found[2] for cell in cells if (found := CHECK.search(cell.source))}


def write_table(file: Path, rows: Iterable[tuple]) -> None:
    """Write the rows as they come; what a spreadsheet would take for a formula gets an apostrophe before it."""
    file.parent.mkdir(exist_ok=True)
    with file.open("w", encoding="utf-8", errors="backslashreplace", newline="") as opened:
        for row in rows:
            csv.writer(opened).writerow(f"'{entry}" if FORMULA.match(str(entry)) else entry for entry in row)
