"""The index explains words that the notebooks use, in alphabetical order."""

import re

import nbformat
import pytest

from lynx_common.course.execute import NOTEBOOKS

INDEX = nbformat.read(NOTEBOOKS / "00_index.ipynb", 4)
ENTRIES = re.findall(r"^\| (.+?) \| (.+) \|$", INDEX.cells[-1].source, flags=re.M)[1:]
WORDS = [word for word, _ in ENTRIES]


@pytest.fixture(scope="module")
def texts() -> str:
    """All words of all other notebooks, in small letters, with single spaces."""
    paths = [path for path in NOTEBOOKS.glob("*.ipynb") if path.name != "00_index.ipynb"]
    cells = [cell for path in paths for cell in nbformat.read(path, 4).cells]
    return " ".join(" ".join(cell.source for cell in cells if cell.cell_type == "markdown").lower().split())


def test_the_glossary_is_in_alphabetical_order():
    assert len(WORDS) > 50
    assert sorted(WORDS, key=str.lower) == WORDS


def test_a_word_of_the_glossary_is_used_in_a_notebook(texts):
    words = [word for entry in WORDS for word in re.sub(r" \$.*\$", "", entry).split(", ")]
    assert [word for word in words if not re.search(rf"\b{re.escape(word.lower())}", texts)] == []
