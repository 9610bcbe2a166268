"""For a class: nbgrader's source notebooks (`assignment`), grading without nbgrader (`grade`), answers (`key`).

No notebook imports from here. Which exercises there are, and under which names their answers are looked for, is
read from the committed notebooks, whatever somebody has handed in.
"""

import re
from pathlib import Path

import nbformat

from ..kernel import code_cells

CHECK = re.compile(r'exercises\.check\("(\w+\.\d+)", (\w+)\)')


def answers(notebook: Path) -> dict[str, str]:
    """Of each exercise of a committed notebook, the name of the answer: {"A1.1": "answer_1", ...}."""
    cells = code_cells(nbformat.read(notebook, as_version=4))
    return {found[1]: found[2] for cell in cells if (found := CHECK.search(cell.source))}
