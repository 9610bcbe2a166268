"""How long one waits: to import, for a first pose, and for the notebooks to be run again by `make test`."""

import os
import subprocess
import sys
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from timing import OURS, Tables, shown, side_by_side

ROOT = Path(__file__).parents[2]
PROGRAMS = {
    "": "pass",
    OURS: "from lynx_common import arm",
    "Robotics Toolbox": "import roboticstoolbox",
    "Pinocchio": "import pinocchio",
    "ikpy": "import ikpy.chain",
    "Modern Robotics": "import modern_robotics",
}


def test_time_of_import(tables: Tables):
    """In a fresh process, less that of Python itself."""

    def process(program: str):
        return lambda: subprocess.run([sys.executable, "-c", program], check=True, capture_output=True)

    first = f"{PROGRAMS[OURS]}\narm.forward_kinematics([0] * 5)"
    calls = {name: process(program) for name, program in (PROGRAMS | {"first": first}).items()}
    times = side_by_side(calls, rounds=4, least=0)
    python = times.pop("")
    with_pose = times.pop("first") - python
    tables.compare("import", {name: t - python for name, t in times.items()})
    tables.facts["import, derivation in SymPy and first pose"] = shown(np.median(with_pose))


def test_time_of_each_notebook(tables: Tables, tmp_path: Path):
    """Run again and compared, as by `make test`; its own time, while another runs on the other core."""
    results = tmp_path / "results.xml"
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    command = [sys.executable, "-m", "pytest", "-q", f"--junitxml={results}", "notebooks"]
    subprocess.run(command, cwd=ROOT, env=environment, capture_output=True)  # whether they pass is not asked here
    seconds = Counter()
    for case in ElementTree.parse(results).iter("testcase"):
        seconds[case.get("classname").split(".")[-2]] += float(case.get("time"))
    assert {path.stem for path in ROOT.glob("notebooks/*.ipynb")} == seconds.keys()
    tables.facts["all notebooks, run again and compared"] = shown(sum(seconds.values()))
    tables.facts |= {f"of these, {name}": shown(time) for name, time in sorted(seconds.items())}
