"""Whether what is installed is what the course was tested with."""

from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from packaging.requirements import Requirement

LOCK = Path(__file__).parents[2] / "requirements.txt"
PACKAGES = ("numpy", "sympy", "matplotlib", "ipywidgets", "nbval", "jupyter")


def check(lock: Path = LOCK) -> str:
    """One line that says whether the six packages have the versions of ``lock``, or which do not."""
    if not lock.exists():
        return f"There is no lock at {lock.name}: install the course from its own folder, with `make lab`."
    wanted = _locked(lock.read_text(encoding="utf-8"))
    wrong = [
        f"{name} is {_installed(name)}, not {wanted[name]}"
        for name in PACKAGES
        if _installed(name) != wanted[name]
    ]
    if wrong:
        return f"Not as locked: {'; '.join(wrong)}. `make lab` sets it right."
    return f"All {len(PACKAGES)} packages have the locked versions."


def _locked(text: str) -> dict[str, str]:
    lines = (line.partition("#")[0].strip() for line in text.splitlines())
    pins = [Requirement(line) for line in lines if line and not line.startswith("-")]
    return {
        pin.name: str(pin.specifier).removeprefix("==") for pin in pins if not pin.marker or pin.marker.evaluate()
    }


def _installed(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "missing"
