"""Timing side by side, and the tables of what was found."""

import tracemalloc
from collections.abc import Callable
from dataclasses import dataclass, field
from importlib.metadata import version
from platform import python_version
from time import perf_counter

import numpy as np

OURS = "lynx_common"
PEERS = {  # by their names in the table; what each is installed as
    "Robotics Toolbox": "roboticstoolbox-python",
    "Pinocchio": "pin",
    "ikpy": "ikpy",
    "Modern Robotics": "modern-robotics",
}
PACKAGES = ["numpy", "sympy", *PEERS.values(), "ompl"]


def side_by_side(calls: dict[str, Callable], rounds: int = 15, least: float = 0.01) -> dict[str, np.ndarray]:
    """Seconds that one call takes, in each round, by name.

    A round runs all of them one after the other, each as often as fills ``least`` seconds, so that what slows the
    machine for a while slows all alike, and the ratios within a round hold.
    """
    for call in calls.values():
        call()  # compiled, imported, cached
    often = {name: max(1, round(least / _seconds(call, 1)) if least else 1) for name, call in calls.items()}
    times = {name: np.empty(rounds) for name in calls}
    for i in range(rounds):
        for name, call in calls.items():
            times[name][i] = _seconds(call, often[name])
    return times


def peak_memory(call: Callable) -> int:
    """Bytes that one call takes at most, what it returns included."""
    call()  # compiled, cached
    tracemalloc.start()
    result = call()
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    del result
    return peak


def _seconds(call: Callable, times: int) -> float:
    begin = perf_counter()
    for _ in range(times):
        call()
    return (perf_counter() - begin) / times


@dataclass
class Tables:
    """What the benchmarks found, as rows of two tables."""

    peers: dict[str, dict[str, str]] = field(default_factory=dict)
    facts: dict[str, str] = field(default_factory=dict)

    def compare(self, task: str, times: dict[str, np.ndarray], scale: dict[str, float] | None = None) -> None:
        """A row of medians, and of ratios to ours; ``scale`` by how much a peer had less to do."""
        scale = scale or {}
        times = {name: t * scale.get(name, 1) for name, t in times.items()}
        self.peers[task] = {name: self._cell(name, times) for name in times}

    @staticmethod
    def _cell(name: str, times: dict[str, np.ndarray]) -> str:
        if name == OURS:
            return shown(np.median(times[OURS]))
        ratio = float(np.median(times[name] / times[OURS]))
        text = f"{ratio:.2g}" if ratio < 9.95 else f"{ratio:,.0f}"
        return f"{shown(np.median(times[name]))} ({f'**{text}**' if ratio < 1 else text})"

    def markdown(self) -> str:
        columns = [OURS, *PEERS]
        lines = [f"| | {' | '.join(columns)} |", f"|:--|{'--:|' * len(columns)}"]
        lines += [
            f"| {task} | {' | '.join(row.get(name, '-') for name in columns)} |"
            for task, row in self.peers.items()
        ]
        lines += ["", "| | |", "|:--|--:|", *(f"| {task} | {value} |" for task, value in self.facts.items())]
        versions = ", ".join(f"{name} {version(name)}" for name in PACKAGES)
        return "\n".join([*lines, "", f"Python {python_version()}, {versions}."])


def shown(seconds: float) -> str:
    """Two digits and a unit."""
    unit, factor = next((u, f) for u, f in (("s", 1), ("ms", 1e3), ("µs", 1e6)) if seconds * f >= 1 or u == "µs")
    value = seconds * factor
    return f"{value:,.0f} {unit}" if value >= 9.95 else f"{value:.1f} {unit}"
