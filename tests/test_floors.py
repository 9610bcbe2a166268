"""A module of lynx_common imports only from lower floors, and none grows too large."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import lynx_common

PACKAGE = Path(lynx_common.__file__).parent
FLOORS = {
    0: ["errors", "reading", "symbolic", "dh", "screws", "arcs"],
    1: ["arm", "rrr"],
    2: ["workspace", "motion", "obstacles", "planner", "certify"],
    3: ["drawing", "course.pictures"],
    4: ["course.report", "course.figures", "course.kernel", "course.stage"],
    5: ["course.explorers", "course.exercises", "course.environment", "course.execute"],
    6: ["course.lab"],
}
FLOOR = {module: floor for floor, modules in FLOORS.items() for module in modules}
# Where the floor alone does not say it: what a module may import, and nothing else.
ONLY = {module: {"errors", "reading"} for module in FLOORS[0]} | {
    "course.report": {"symbolic", "reading", "errors"},  # nothing can compute from an answer
    "course": set(),
    "lynx_common": set(),
}

MODULE_LINES = 250
FUNCTION_LINES = 30
SOURCES = sorted(PACKAGE.rglob("*.py"))


def dotted(path: Path) -> str:
    """The module's name in lynx_common, as in course.report.a1; a package ends in __init__."""
    return ".".join(path.relative_to(PACKAGE).with_suffix("").parts)


def test_a_module_imports_from_lower_floors():
    assert [fault for path in SOURCES for fault in violations(dotted(path), path.read_text("utf-8"))] == []


def test_a_module_and_its_functions_are_small():
    for path in SOURCES:
        source = path.read_text("utf-8")
        assert len(source.splitlines()) < MODULE_LINES, path
        functions = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.FunctionDef)]
        assert [f.name for f in functions if lines_of_code(f, source) > FUNCTION_LINES] == [], path


def test_the_arm_needs_no_picture_no_widget_and_no_course():
    program = "import sys, lynx_common.arm; print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert not {"matplotlib", "ipywidgets", "lynx_common.course"} & set(run.stdout.split())


@pytest.mark.parametrize(
    ("module", "source", "expected"),
    [
        ("arm", "from lynx_common import dh, errors\nfrom . import symbolic", []),
        ("arm", "from lynx_common.rrr import elbows", ["arm imports rrr"]),
        ("dh", "from .errors import LynxError", []),
        ("dh", "from .symbolic import tidy", ["dh imports symbolic"]),
        ("symbolic", "def f():\n    import lynx_common.arm as a", ["symbolic imports arm"]),
        ("drawing.__init__", "from . import style\nfrom .. import arm", []),
        ("drawing.style", "from ..course import figures", ["drawing imports course.figures"]),
        ("course.report.a1", "from ...symbolic import Q\nfrom .item import Item", []),
        ("course.report.a1", "from ... import arm", ["course.report imports arm"]),
        ("course.report.__init__", "from ...arm import LYNX", ["course.report imports arm"]),
        ("course.explorers", "from .exercises import check", ["course.explorers imports course.exercises"]),
        ("course.__init__", "from . import report", ["course imports course.report"]),
        ("__init__", "from . import arm", ["lynx_common imports arm"]),
        ("kinematics", "", ["kinematics is on no floor: give it one in tests/test_floors.py"]),
        ("arm", "from . import kinematics", ["arm imports kinematics"]),
    ],
)
def test_a_violation_is_caught(module, source, expected):
    assert violations(module, source) == expected


def test_long_functions_are_caught():
    source = 'def f():\n    """Two\n\n    lines."""\n    # a comment\n\n' + "    pass\n" * 7
    assert lines_of_code(ast.parse(source).body[0], source) == 8


def violations(module: str, source: str) -> list[str]:
    """What the module imports against the rules, a phrase each."""
    own = floor_name(f"lynx_common.{module}")
    if own not in FLOOR and own not in ONLY:
        return [f"{own} is on no floor: give it one in tests/test_floors.py"]
    others = {floor_name(name) for name in imported(f"lynx_common.{module}", source)} - {own, "lynx_common"}
    return [f"{own} imports {other}" for other in sorted(others) if not may_import(own, other)]


def may_import(own: str, other: str) -> bool:
    return other in ONLY[own] if own in ONLY else other in FLOOR and FLOOR[other] < FLOOR[own]


def floor_name(name: str) -> str:
    """The name in the table above of what is imported: that of its module, or of its module's package."""
    _, *parts = [part for part in name.split(".") if part != "__init__"]
    return ".".join(parts[: 2 if parts[:1] == ["course"] else 1]) or "lynx_common"


def imported(module: str, source: str) -> list[str]:
    """Full names of all that the source of a module imports from lynx_common."""
    names = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = module.split(".")[: -node.level] if node.level else []
            base += [node.module] if node.module else []
            names += [".".join([*base, alias.name]) for alias in node.names]
    return [name for name in names if name.split(".")[0] == "lynx_common"]


def lines_of_code(function: ast.FunctionDef, source: str) -> int:
    """Lines of a function that are neither its docstring nor blank nor a comment."""
    lines = source.splitlines()
    if ast.get_docstring(function):
        docstring = function.body[0]
        lines[docstring.lineno - 1 : docstring.end_lineno] = [""] * (docstring.end_lineno - docstring.lineno + 1)
    own = map(str.strip, lines[function.lineno - 1 : function.end_lineno])
    return sum(bool(line) and not line.startswith("#") for line in own)
