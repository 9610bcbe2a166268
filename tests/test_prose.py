"""What the notebooks say in words: numbers stand in an output, captions name what they show, answers are open."""

import re
from functools import cache
from pathlib import Path

import nbformat
import pytest

from lynx_common.course import exercises, report
from lynx_common.course.kernel import code_cells

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("*.ipynb"))
every_notebook = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)

NUMBER = re.compile(r"(?<![\w.])\d[\d,]*(?:\.\d+)?")
# Numbers that name a place, a year or a document: nothing measured.
PLACE = r"\(?[A-C]?\d+(?:\.\d+)*[a-h]?\)?"
KINDS = r"eqs?\.|equations?|Tables?|Figs?\.|sections?|chapters?|pp?\.|pages?|claims?"
NAMES = re.compile(
    rf"\b(?:{KINDS}) {PLACE}(?:(?:,| and| to|\N{{EN DASH}}) ?{PLACE})*|\([1-3]\.\d{{1,2}}\)"
    r"|https?://\S+|\bdoi\S*\s?\S+|\b(?:1[89]|20)\d\d\b",
    re.IGNORECASE,
)
UNITS = 1, 1e2, 1e3, 1e-2, 1e-3  # metres may be told in cm or mm, cubic metres in litres, shares in per cent


def numbers_in_prose(text: str) -> list[str]:
    """Those of three digits or more that do not name a place."""
    found = (number.rstrip(",") for number in NUMBER.findall(NAMES.sub("", text)))
    return [number for number in found if len(re.sub(r"\D", "", number).lstrip("0")) >= 3]


def stands_in(number: str, shown: list[float]) -> bool:
    """Whether one of the numbers shown, rounded as ``number`` is, is that number, in any of UNITS."""
    value, decimals = float(number.replace(",", "")), len(number.partition(".")[2])
    return any(abs(round(unit * other, decimals) - value) < 1e-9 * value for other in shown for unit in UNITS)


def shown_in(notebook: nbformat.NotebookNode) -> list[float]:
    """The numbers in its code, its outputs, and the solutions of its exercises."""
    texts = []
    for cell in code_cells(notebook):
        texts.append(re.sub(r"(?<=\d)_(?=\d)", "", cell.source))
        texts += [output.get("text", "") for output in cell.outputs]
        data = [output.get("data", {}) for output in cell.outputs]
        texts += [of.get(kind, "") for of in data for kind in ("text/plain", "text/latex", "text/markdown")]
    for name in re.findall(r'exercises\.check\("([^"]+)"', "\n".join(texts)):
        exercise = exercises.catalogue()[name]
        texts += [exercise.explanation, exercise.code, *exercise.hints]
    found = re.findall(r"\d[\d,]*\.?\d*(?:e[-+]?\d+)?", "\n".join(texts))
    return sorted({float(number.replace(",", "")) for number in found})


def prose_faults(notebook: nbformat.NotebookNode) -> list[str]:
    """Numbers in its prose that no cell and no output shows."""
    shown = shown_in(notebook)
    return [
        f"{cell.id}: {number}"
        for cell in notebook.cells
        if cell.cell_type == "markdown"
        for number in numbers_in_prose(cell.source)
        if not stands_in(number, shown)
    ]


def captions(cell: nbformat.NotebookNode) -> list[str]:
    texts = (output.get("data", {}).get("text/markdown", "") for output in cell.outputs)
    return [text for text in texts if "figures." in cell.source and text and not text.startswith("|")]


def keys_in(text: str) -> list[str]:
    """Keys of the ledger: Fig. 1.3 for Figs. 1.3a and 1.3b."""
    return [f"{kind} {number}" for kind, number in re.findall(r"(Fig\.|Table) (\d\.\d+)", text)]


def caption_faults(notebook: nbformat.NotebookNode) -> list[str]:
    """Captions that begin with another number than that of what the cells around them read or check, or that
    mention an item of the report with which the notebook has nothing to do."""
    cells, faults = code_cells(notebook), []
    used = [set(keys_in("\n".join(re.findall(r"(?:printed|check|publish)\(.*", cell.source)))) for cell in cells]
    for i, cell in enumerate(cells):
        published = [f"Fig. {n}" for n in re.findall(r'publish\(\w+, "(\d\.\d+)', cell.source)]
        around = set().union(*used[max(0, i - 4) : i + 5], published)
        for caption in captions(cell):
            first, *others = keys_in(caption) or [None]
            leads = first and re.match(r"\*{0,2}(?:Fig|Table)", caption)
            allowed = set(published) or around
            faults += [f"{cell.id}: {caption[:60]}"] if leads and first not in allowed else []
            mentions = others if leads else [first, *others]
            faults += [f"{cell.id}: {key}" for key in mentions if key and key not in report.LEDGER]
    return faults


def answers_given(notebook: nbformat.NotebookNode) -> list[str]:
    """Exercises whose answer is not just dots."""
    source = "\n".join(cell.source for cell in code_cells(notebook))
    checked = re.findall(r'exercises\.check\("([^"]+)", (\w+)\)', source)
    return [name for name, answer in checked if re.findall(rf"^{answer} = (.*)$", source, re.M) != ["..."]]


@cache
def read(path: Path) -> nbformat.NotebookNode:
    return nbformat.read(path, as_version=4)


@every_notebook
def test_answers_are_open(path):
    assert answers_given(read(path)) == []


@every_notebook
@pytest.mark.committed_lengths
def test_numbers_in_words_stand_in_an_output_or_a_cell(path):
    assert prose_faults(read(path)) == []


@every_notebook
def test_captions_have_the_numbers_of_what_they_show(path):
    assert caption_faults(read(path)) == []


# And each of these is seen to fail.


def with_change(path: Path, kind: str, old: str, new: str) -> nbformat.NotebookNode:
    """A notebook in which ``old`` is ``new`` in all cells of a kind and their outputs."""
    notebook = nbformat.reads(path.read_text(encoding="utf-8"), as_version=4)
    for cell in notebook.cells:
        if cell.cell_type == kind:
            cell.source = re.sub(old, new, cell.source)
            for output in cell.get("outputs", []):
                data = output.get("data", {})
                data.update({k: re.sub(old, new, text) for k, text in data.items() if k == "text/markdown"})
    return notebook


def test_a_wrong_digit_in_words_is_seen():
    """Of all numbers in the course, the last digit one larger: few of these stand somewhere by chance."""
    wrong, seen = 0, 0
    for path in NOTEBOOKS:
        shown = shown_in(read(path))
        words = "\n".join(cell.source for cell in read(path).cells if cell.cell_type == "markdown")
        for number in set(numbers_in_prose(words)):
            wrong += 1
            seen += not stands_in(number[:-1] + str((int(number[-1]) + 1) % 10), shown)
    assert wrong > 80
    assert seen > 0.8 * wrong


def test_a_wrong_number_in_a_caption_is_seen():
    by_stem = {path.stem: path for path in NOTEBOOKS}
    for stem, old, new in (
        ("A1_forward_kinematics", r"\*\*Fig. 1.2.\*\*", "**Fig. 1.3.**"),
        ("A3_inverse_kinematics", r"\*\*Fig. 1.5.\*\*", "**Fig. 1.6.**"),
        ("B1_task_planning", "Table 1.4 of", "Table 1.5 of"),
        ("Part2_parallel_robot", "of Table 2.3. Pink", "of Table 2.7. Pink"),
    ):
        assert len(caption_faults(with_change(by_stem[stem], "code", old, new))) >= 1, stem


def test_an_answer_that_was_left_in_is_seen():
    path = NOTEBOOKS[1]
    assert answers_given(with_change(path, "code", r"answer_2 = \.\.\.", "answer_2 = 0.3")) == ["A1.2"]
