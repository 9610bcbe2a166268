"""`make lab`: copies are made once, trusted where they are ours, opened where they are; JupyterLab is not run."""

import os
import shutil
from pathlib import Path

import nbformat
import pytest
from nbformat.sign import NotebookNotary
from nbformat.v4 import new_code_cell, new_notebook, new_output

from lynx_common.course import lab


@pytest.fixture
def originals(monkeypatch, tmp_path) -> Path:
    folder = tmp_path / "originals"
    folder.mkdir()
    page = new_output("display_data", data={"text/html": "<iframe></iframe>"})
    for name in ("00_index", "A1_poses"):
        cell = new_code_cell(name, id="cell", outputs=[page], execution_count=1)
        nbformat.write(new_notebook(cells=[cell]), folder / f"{name}.ipynb")
    monkeypatch.setattr(lab, "NOTEBOOKS", folder)
    monkeypatch.setattr(lab.sys, "prefix", str(tmp_path / "environment"))
    (tmp_path / "environment").mkdir()
    return folder


@pytest.fixture
def opened(monkeypatch) -> list[tuple[list[str], dict[str, str], str]]:
    """What JupyterLab is started with: its command, its environment, and the folder it starts in."""
    calls, here = [], os.getcwd()
    monkeypatch.setattr(lab.os, "execve", lambda _, command, env: calls.append((command, env, os.getcwd())))
    yield calls
    os.chdir(here)


def is_trusted(path: Path, command: list[str]) -> bool:
    """Whether JupyterLab, started with this command, trusts a notebook."""
    options = dict(option[2:].split("=", 1) for option in command if option.startswith("--NotebookNotary"))
    with NotebookNotary(**{name.partition(".")[2]: value for name, value in options.items()}) as notary:
        return notary.check_signature(nbformat.read(path, as_version=4))


def test_copies_are_made_trusted_and_opened(originals, opened, tmp_path):
    place = tmp_path / "Übung 3" / "my copies"
    lab.main(str(place))
    ((command, _, folder),) = opened
    assert folder == str(place)
    assert f"--ServerApp.root_dir={place}" in command
    assert "--LabApp.default_url=/lab/tree/00_index.ipynb" in command
    for original in originals.iterdir():
        assert (place / original.name).read_bytes() == original.read_bytes()
        assert is_trusted(place / original.name, command)


def test_what_is_there_is_kept_and_trusted_only_where_it_is_ours(originals, opened, tmp_path):
    place = tmp_path / "work"
    place.mkdir()
    shutil.copy(originals / "00_index.ipynb", place)
    theirs = (originals / "A1_poses.ipynb").read_text().replace("<iframe>", "<iframe onload='...'>")
    for name in ("A1_poses.ipynb", "mine.ipynb"):
        (place / name).write_text(theirs)
    lab.main(str(place))
    command = opened[0][0]
    assert is_trusted(place / "00_index.ipynb", command)
    for name in ("A1_poses.ipynb", "mine.ipynb"):
        assert (place / name).read_text() == theirs
        assert not is_trusted(place / name, command)


def test_a_folder_that_cannot_be_written_is_named_with_a_way_on(originals, opened, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(lab.os, "access", lambda *_: False)
    assert lab.main(str(tmp_path / "work")) == 1
    assert opened == []
    said = capsys.readouterr().err
    assert said == f"{tmp_path / 'work'} cannot be written. Name another folder, as in: make lab DIR=~/robots\n"


def test_neither_another_kernel_nor_a_home_that_cannot_be_written_gets_in_the_way(
    originals, opened, tmp_path, monkeypatch
):
    monkeypatch.setenv("JUPYTER_PATH", "/somewhere/else")
    lab.main(str(tmp_path / "work"))
    may_write = os.access
    monkeypatch.setattr(lab.os, "access", lambda path, mode: "home" not in str(path) and may_write(path, mode))
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR"):
        monkeypatch.delenv(name, raising=False)
    (tmp_path / "home").mkdir()
    lab.main(str(tmp_path / "work"))
    usual, without_home = (environment for _, environment, _ in opened)
    for environment in (usual, without_home):
        assert "JUPYTER_PATH" not in environment
        assert environment["JUPYTER_PREFER_ENV_PATH"] == "1"
    for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR"):
        assert Path(without_home[name]).is_relative_to(tmp_path / "environment")


def test_no_question_about_news_and_no_line_about_eavesdroppers(originals, opened, tmp_path):
    lab.main(str(tmp_path / "work"))
    settings = tmp_path / "environment/share/jupyter/lab/settings/overrides.json"
    assert '"fetchNews": "false"' in settings.read_text()
    assert "--KernelManager.transport_encryption=auto" in opened[0][0]
