"""Open the reader's own copies of the notebooks in JupyterLab: `python -m lynx_common.course.lab FOLDER`.

An existing file is never overwritten. What has just been copied, or equals the original, is trusted, so that its
pages show before a cell is run; no other notebook is. Nothing is written outside the folder and the virtual
environment, but for the settings that JupyterLab keeps in its own places where these can be written.
"""

import os
import shutil
import sys
import tempfile
from pathlib import Path

import jupyter_core.paths
import nbformat
import zmq
from nbformat.sign import NotebookNotary

from .execute import NOTEBOOKS, ROOT

INDEX = "00_index.ipynb"
NO_NEWS = '{"@jupyterlab/apputils-extension:notification": {"fetchNews": "false"}}\n'


def copy(folder: Path) -> list[Path]:
    """Copy the notebooks that are not in ``folder`` yet; those in it that equal the originals."""
    folder.mkdir(parents=True, exist_ok=True)
    pairs = [(original, folder / original.name) for original in sorted(NOTEBOOKS.glob("*.ipynb"))]
    for original, own in pairs:
        if not own.exists():
            shutil.copyfile(original, own)
    return [own for original, own in pairs if own.read_bytes() == original.read_bytes()]


def trust(notebooks: list[Path], store: Path) -> dict[str, str]:
    """Sign the notebooks; what JupyterLab has to be told so that it finds the signatures."""
    files = {"db_file": str(store / "signatures.db"), "secret_file": str(store / "secret")}
    with NotebookNotary(**files) as notary:
        for path in notebooks:
            notary.sign(nbformat.read(path, as_version=4))
    return {f"NotebookNotary.{name}": value for name, value in files.items()}


def writable(folder: Path) -> bool:
    """Whether files can be made in ``folder``, or in what there is of it."""
    while not folder.exists():
        folder = folder.parent
    return folder.is_dir() and os.access(folder, os.W_OK)


def state() -> Path:
    """A folder for signatures: in the virtual environment, or a temporary one where that cannot be written."""
    own = Path(sys.prefix, "lab")
    if not writable(own):
        return Path(tempfile.mkdtemp(prefix="lynx-lab-"))
    own.mkdir(exist_ok=True)
    return own


def without_news() -> None:
    """Have JupyterLab, as installed in the virtual environment, not ask whether news may be fetched."""
    settings = Path(sys.prefix, "share", "jupyter", "lab", "settings")
    if writable(settings):
        settings.mkdir(parents=True, exist_ok=True)
        (settings / "overrides.json").write_text(NO_NEWS, encoding="utf-8")


def environment(store: Path) -> dict[str, str]:
    """That of JupyterLab: kernels are this environment's, and a home that cannot be written is no hindrance."""
    more = {"JUPYTER_PREFER_ENV_PATH": "1"}
    places = {
        "JUPYTER_CONFIG_DIR": jupyter_core.paths.jupyter_config_dir,
        "JUPYTER_DATA_DIR": jupyter_core.paths.jupyter_data_dir,
        "JUPYTER_RUNTIME_DIR": jupyter_core.paths.jupyter_runtime_dir,
        "IPYTHONDIR": lambda: Path.home() / ".ipython",
    }
    more |= {name: str(store / name.lower()) for name, place in places.items() if not writable(Path(place()))}
    return {name: value for name, value in os.environ.items() if name != "JUPYTER_PATH"} | more


def main(folder: str) -> int:
    """Copy, trust, and become JupyterLab, rooted in the folder."""
    place = (ROOT / folder).resolve() if folder == "work" else Path(folder).expanduser().resolve()
    if not writable(place):
        print(f"{place} cannot be written. Name another folder, as in: make lab DIR=~/robots", file=sys.stderr)
        return 1
    store = state()
    options = trust(copy(place), store) | {
        "ServerApp.root_dir": str(place),
        "LabApp.default_url": f"/lab/tree/{INDEX}",
        "LabApp.news_url": "None",
    }
    if zmq.has("curve"):
        options["KernelManager.transport_encryption"] = "auto"
    without_news()
    command = [sys.executable, "-m", "jupyterlab", "--log-level=WARN"]
    command += [f"--{name}={value}" for name, value in options.items()]
    if getattr(os, "geteuid", lambda: 1)() == 0:
        command.append("--allow-root")
    os.chdir(place)
    os.execve(sys.executable, command, environment(store))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
