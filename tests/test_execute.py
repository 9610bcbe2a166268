"""`make notebooks` and `make figures`: what is run, written and said. The kernel is a stand-in."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import nbformat
import pytest
from nbclient.exceptions import DeadKernelError
from nbformat.v4 import new_code_cell, new_notebook

from lynx_common.course import execute

BOOKS = {
    "A1_poses": 'figures.publish(fig, "1.2")',
    "A2_reach": "figures.publish(\n    fig, '1.10a')",
    "B1_plan": "1",
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
            if execute.is_called(number, environment.get("LYNX_FIGURE", number)):
                Path(environment["LYNX_FIGURES"], f"fig-{number}.pdf").write_text("a figure")
        return path.read_text() if path.stem == "A1_poses" else "new outputs"

    monkeypatch.setattr(execute, "execute", stand_in)
    monkeypatch.setattr(execute, "ProcessPoolExecutor", ThreadPoolExecutor)
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
    assert after == before | {"A2_reach": "new outputs"}
    said = capsys.readouterr()
    assert {tuple(line.split()[::3]) for line in said.out.splitlines()} == {
        ("A1_poses", "unchanged"),
        ("A2_reach", "rewritten"),
        ("B1_plan", "FAILED"),
    }
    assert said.err == "\nIn B1_plan.ipynb: Kernel died\n\n"
    (tmp_path / "B1_plan.ipynb").unlink()
    assert run(monkeypatch, "notebooks") == 0


@pytest.mark.parametrize(
    ("name", "notebooks", "written"),
    [
        ("", {"A1_poses", "A2_reach"}, {"fig-1.2.pdf", "fig-1.10a.pdf"}),
        ("A1", {"A1_poses"}, {"fig-1.2.pdf"}),
        ("A2_reach", {"A2_reach"}, {"fig-1.10a.pdf"}),
        ("1.2", {"A1_poses"}, {"fig-1.2.pdf"}),
        ("1.10", {"A2_reach"}, {"fig-1.10a.pdf"}),
    ],
)
def test_figures_come_from_the_notebooks_that_publish_them(name, notebooks, written, ran, monkeypatch, capsys):
    assert run(monkeypatch, "figures", name) == 0
    assert ran.keys() == notebooks
    assert {path.name for path in execute.FIGURES.iterdir()} == written
    plural = "s" * (len(written) > 1)
    assert f"{len(written)} figure{plural} written to {execute.FIGURES}\n" in capsys.readouterr().out


def test_an_unknown_figure_gets_the_list_of_known_ones(ran, monkeypatch, capsys):
    assert run(monkeypatch, "figures", "1.3") == 2
    assert ran == {}
    assert capsys.readouterr().err == "No notebook or figure is called '1.3'. Valid: A1, A2, 1.2, 1.10a.\n"


def test_a_figure_that_nothing_writes_is_a_failure(ran, monkeypatch, capsys):
    monkeypatch.setattr(execute, "execute", lambda path, **environment: path.read_text())
    assert run(monkeypatch, "figures", "1.2") == 1
    assert "0 figures written" in capsys.readouterr().out
