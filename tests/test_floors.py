"""A module of lynx_common imports only from lower floors, and none grows too large."""

import ast
import importlib
import inspect
import json
import pkgutil
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import lynx_common
from lynx_common import arcs, arm, certify, drawing, motion, planner, reading, rrr, screws, symbolic
from lynx_common.course import exercises

PACKAGE = Path(lynx_common.__file__).parent
FLOORS = {
    0: ["errors"],
    1: ["reading"],
    2: ["symbolic", "dh", "screws", "arcs", "planner"],
    3: ["arm", "rrr", "certify"],
    4: ["workspace", "motion", "obstacles"],
    5: ["drawing", "course.pictures"],
    6: ["course.report", "course.figures", "course.kernel", "course.stage"],
    7: ["course.explorers", "course.exercises", "course.environment", "course.execute"],
    8: ["course.lab", "course.classroom"],
}
FLOOR = {module: floor for floor, modules in FLOORS.items() for module in modules}
# Where the floor alone does not say it: what a module may import, and nothing else.
ONLY = {
    "certify": {"symbolic", "reading", "errors"},  # it knows no robot and no obstacle
    "planner": {"reading", "errors"},
    "course.report": {"symbolic", "reading", "errors"},  # nothing can compute from an answer
    "course": set(),
    "lynx_common": set(),
}

MODULE_LINES = 250
FUNCTION_LINES = 30
SOURCES = sorted(PACKAGE.rglob("*.py"))
DATA = {f"course.exercises.{notebook}" for notebook in exercises.MODULES}


def dotted(path: Path) -> str:
    """The module's name in lynx_common, as in course.report.a1; a package ends in __init__."""
    return ".".join(path.relative_to(PACKAGE).with_suffix("").parts)


def test_a_module_imports_from_lower_floors():
    assert [fault for path in SOURCES for fault in violations(dotted(path), path.read_text("utf-8"))] == []


def test_a_module_and_its_functions_are_small():
    for path in SOURCES:
        source = path.read_text("utf-8")
        assert len(source.splitlines()) < MODULE_LINES or dotted(path) in DATA, path
        functions = [node for node in ast.walk(ast.parse(source)) if is_code(node)]
        assert [f.name for f in functions if lines_of_code(f, source) > FUNCTION_LINES] == [], path


def is_code(node: ast.AST) -> bool:
    """Whether it is a function; but for those that end in an exercise for their numbers, which is data."""
    return isinstance(node, ast.FunctionDef) and not ast.unparse(node.body[-1]).startswith("return Exercise(")


FOLDERS = [arcs, arm, certify, drawing, motion, planner, reading, rrr, screws, symbolic]


@pytest.mark.parametrize("room", FOLDERS, ids=lambda room: room.__name__)
def test_completion_offers_what_a_room_holds_and_none_of_its_files(room):
    offered = [name for name in dir(room) if not name.startswith("_")]
    assert offered
    assert [name for name in offered if inspect.ismodule(getattr(room, name))] in ([], ["formulas"])


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


NAMES = {"IPython": "ipython", "PIL": "pillow", "mpl_toolkits": "matplotlib", "zmq": "pyzmq"}
TOOLS = {"course.classroom", "course.execute", "course.kernel", "course.lab"}


def test_what_is_imported_is_what_is_declared():
    project = tomllib.loads((PACKAGE.parent / "pyproject.toml").read_text("utf-8"))["project"]
    runtime, tools = set(project["dependencies"]), set(project["optional-dependencies"]["tools"])
    found = {True: set(), False: set()}
    for path in SOURCES:
        found[floor_name(f"lynx_common.{dotted(path)}") in TOOLS] |= third_parties(path.read_text("utf-8"))
    assert found[False] == runtime
    assert found[True] - runtime == tools - {"jupyter"}  # which is what the others come with


def third_parties(source: str) -> set[str]:
    """The packages, by the names under which they are installed, that a source imports."""
    nodes = list(ast.walk(ast.parse(source)))
    names = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    names |= {node.module or "" for node in nodes if isinstance(node, ast.ImportFrom) and not node.level}
    roots = {name.split(".")[0] for name in names} - sys.stdlib_module_names - {"", "lynx_common"}
    return {NAMES.get(root, root.replace("_", "-")) for root in roots}


# Lines of Python, JavaScript and HTML, with docstrings and examples: what somebody has to read.
LARGEST = {"robotics": 5550, "course": 6950}


def test_the_package_stays_small():
    lines = {"robotics": 0, "course": 0}
    for path in PACKAGE.rglob("*"):
        if path.suffix in (".py", ".js", ".html", ".css"):
            half = "course" if path.relative_to(PACKAGE).parts[0] == "course" else "robotics"
            lines[half] += len(path.read_text("utf-8").splitlines())
    assert {half: lines[half] for half in lines if lines[half] > LARGEST[half]} == {}


# Public, though no notebook and no other room calls them: why.
UNUSED = {
    "arm.urdf": "for other programs",
    "certify.Certificate": "what along and over return",
    "motion.Followed": "what follow returns",
    "planner.Plan": "what plan returns",
    "screws.Screw": "what screw_axis returns",
    "workspace.Occupancy": "what occupancy returns",
    "workspace.Sweep": "what sweep returns",
}


def test_what_is_public_is_used():
    cells = [
        "".join(cell["source"])
        for path in (PACKAGE.parent / "notebooks").glob("*.ipynb")
        for cell in json.loads(path.read_text("utf-8"))["cells"]
        if cell["cell_type"] == "code"
    ]
    sources = [(dotted(path).split(".")[0], path.read_text("utf-8")) for path in SOURCES]
    unused = set()
    for _, room, _ in pkgutil.iter_modules([str(PACKAGE)]):
        elsewhere = "\n".join([*cells, *(text for other, text in sources if other != room)])
        unused |= {f"{room}.{name}" for name in offered(room) if not re.search(rf"\b{name}\b", elsewhere)}
    assert unused == UNUSED.keys()


def offered(room: str) -> list[str]:
    """The functions and classes that a room offers under its name."""
    module = importlib.import_module(f"lynx_common.{room}")
    own = f"lynx_common.{room}"
    return [
        name
        for name, thing in vars(module).items()
        if callable(thing) and not name.startswith("_") and (thing.__module__ or "").startswith(own)
    ]
