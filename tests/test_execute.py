"""`make notebooks` and `make figures`: what is run, written and said. The kernel is a stand-in."""

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import nbformat
import pytest
from nbclient.exceptions import DeadKernelError
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from lynx_common.course import execute

BOOKS = {
    "A1_poses": 'figures.publish(fig, "1.2")',
    "A2_reach": "figures.publish(\n    fig, '1.10a')",
    "B1_plan": "1",
    "B2_table": 'figures.table(head, rows, "**Fig. 2.2.** A table.")',
}


@pytest.fixture
def ran(monkeypatch, tmp_path) -> dict[str, dict]:
    """Three notebooks in a folder of their own; what is executed is noted here, with what it was told."""
    calls: dict[str, dict] = {}

    def stand_in(path: Path, **environment: str) -> str:
        calls[path.stem] = environment
        if path.stem == "B1_plan" and not environment:
            raise DeadKernelError("\x1b[31mKernel died\x1b[0m")
        for number in execute.published(path) if environment else []:
            if any(execute.is_called(number, name) for name in environment.get("LYNX_FIGURE", number).split()):
                Path(environment["LYNX_FIGURES"], f"fig-{number}.pdf").write_text("a figure")
        return path.read_text() if path.stem == "A1_poses" else "new outputs"

    monkeypatch.setattr(execute, "execute", stand_in)
    monkeypatch.setattr(execute, "ProcessPoolExecutor", ThreadPoolExecutor)
    monkeypatch.setattr(execute, "ARM", [])
    monkeypatch.setattr(execute, "NOTEBOOKS", tmp_path)
    monkeypatch.setattr(execute, "FIGURES", tmp_path / "figures")
    for name, source in BOOKS.items():
        nbformat.write(new_notebook(cells=[new_code_cell(source, id="cell")]), tmp_path / f"{name}.ipynb")
    return calls


def run(monkeypatch, *arguments: str) -> int:
    monkeypatch.setattr("sys.argv", ["execute", *arguments])
    return execute.main()


def test_notebooks_are_rewritten_where_they_changed_and_kept_where_they_fail(ran, monkeypatch, tmp_path, capsys):
    before = {path.stem: path.read_text() for path in tmp_path.glob("*.ipynb")}
    assert run(monkeypatch, "notebooks") == 1
    after = {path.stem: path.read_text() for path in tmp_path.glob("*.ipynb")}
    assert after == before | {"A2_reach": "new outputs", "B2_table": "new outputs"}
    said = capsys.readouterr()
    first, *lines = said.out.splitlines()
    assert first == "Running A1, A2, B1, B2"
    assert {tuple(line.partition(";")[0].split()[::3]) for line in lines} == {
        ("A1_poses", "unchanged"),
        ("A2_reach", "rewritten"),
        ("B1_plan", "FAILED"),
        ("B2_table", "rewritten"),
    }
    left = [len(line.partition("; left: ")[2].replace(",", "").split()) for line in lines]
    assert left == [3, 2, 1, 0]
    assert said.err == "\nIn B1_plan.ipynb: Kernel died\n\n"
    (tmp_path / "B1_plan.ipynb").unlink()
    assert run(monkeypatch, "notebooks") == 0


@pytest.mark.parametrize(
    ("name", "notebooks", "written"),
    [
        ("", {"A1_poses", "A2_reach", "B2_table"}, {"fig-1.2.pdf", "fig-1.10a.pdf", "fig-2.2.pdf"}),
        ("fig-1.2", {"A1_poses"}, {"fig-1.2.pdf"}),
        ("2.2", {"B2_table"}, {"fig-2.2.pdf"}),
        ("1.2 2.2", {"A1_poses", "B2_table"}, {"fig-1.2.pdf", "fig-2.2.pdf"}),
        ("A2,fig-2.2", {"A2_reach", "B2_table"}, {"fig-1.10a.pdf", "fig-2.2.pdf"}),
        ("A1", {"A1_poses"}, {"fig-1.2.pdf"}),
        ("A2_reach", {"A2_reach"}, {"fig-1.10a.pdf"}),
        ("1.2", {"A1_poses"}, {"fig-1.2.pdf"}),
        ("1.10", {"A2_reach"}, {"fig-1.10a.pdf"}),
    ],
)
def test_figures_come_from_the_notebooks_that_publish_them(name, notebooks, written, ran, monkeypatch, capsys):
    assert run(monkeypatch, "figures", *name.split()) == 0
    assert ran.keys() == notebooks
    assert {path.name for path in execute.FIGURES.iterdir()} == written
    plural = "s" * (len(written) > 1)
    assert f"{len(written)} figure{plural} written to {execute.FIGURES}\n" in capsys.readouterr().out


def test_an_unknown_figure_gets_the_list_of_known_ones(ran, monkeypatch, capsys):
    assert run(monkeypatch, "figures", "1.2", "1.3") == 2
    assert ran == {}
    expected = "No notebook or figure is called '1.3'. Valid: A1, A2, B2, 1.2, 1.10a, 2.2.\n"
    assert capsys.readouterr().err == expected


def test_a_figure_that_nothing_writes_is_a_failure(ran, monkeypatch, capsys):
    monkeypatch.setattr(execute, "execute", lambda path, **environment: path.read_text())
    assert run(monkeypatch, "figures", "1.2") == 1
    assert "0 figures written" in capsys.readouterr().out


def test_another_arm_has_copies_that_say_so_and_the_notebooks_stay(ran, monkeypatch, tmp_path, capsys):
    for path in tmp_path.glob("*.ipynb"):
        notebook = nbformat.read(path, as_version=4)
        notebook.cells.insert(0, new_markdown_cell("# Title\n\nWords.", id="first"))
        nbformat.write(notebook, path)
    (tmp_path / "B1_plan.ipynb").unlink()
    before = {path.name: path.read_text() for path in tmp_path.glob("*.ipynb")}
    monkeypatch.setattr(execute, "ARM", ["L_1=0.25", "L_3=0.12"])
    assert run(monkeypatch, "notebooks") == 2
    assert ran == {}
    assert run(monkeypatch, "copies", str(tmp_path / "copies")) == 0
    assert before == {path.name: path.read_text() for path in tmp_path.glob("*.ipynb")}
    assert sorted(before) == sorted(path.name for path in (tmp_path / "copies").iterdir())
    copy = nbformat.read(tmp_path / "copies" / "A1_poses.ipynb", as_version=4)
    title, _, note, *_, words = copy.cells[0].source.splitlines()
    assert (title, words) == ("# Title", "Words.")
    assert "another arm: L_1=0.25, L_3=0.12 (in metres)" in note


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("L_4=0.1", "L_4 is 0.1; there are d_1, L_1, L_2, L_3."),
        ("L_1=-0.2", "L_1 is -0.2; a length is finite and longer than zero."),
        ("L_1=long", "L_1 is long; lengths are written as in L_1=0.25 L_3=0.12."),
        ("L_1 0.2", "L_1 is not given; lengths are written as in L_1=0.25 L_3=0.12."),
        ("L_1=0.2 L_1=0.3", "L_1 is 0.2 and 0.3; each length is given once."),
        ("cls=1", "cls is 1.0; there are d_1, L_1, L_2, L_3."),
        ("L_1=nan", "L_1 is nan; a length is finite and longer than zero."),
    ],
)
def test_a_wrong_arm_gets_one_sentence(words, sentence):
    command = [sys.executable, "-m", "lynx_common.course.execute", "figures"]
    done = subprocess.run(command, env=os.environ | {"LYNX_ARM": words}, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"Geometry: {sentence}\n")
