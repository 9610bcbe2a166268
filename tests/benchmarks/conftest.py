"""`make bench` ends with the tables of what was found, and writes them to build/benchmarks.md."""

from pathlib import Path

import pytest
from timing import Tables

TABLES = Tables()


@pytest.fixture(scope="session")
def tables() -> Tables:
    """Where a benchmark puts what it found."""
    return TABLES


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    if TABLES.peers or TABLES.facts:
        path = Path(terminalreporter.config.rootpath, "build", "benchmarks.md")
        path.parent.mkdir(exist_ok=True)
        path.write_text(TABLES.markdown() + "\n")
        terminalreporter.write_line(f"\n{TABLES.markdown()}\n")
