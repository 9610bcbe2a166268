"""The examples in docstrings run, and give what they say."""

import doctest
import importlib
import inspect
import pkgutil

import matplotlib.pyplot as plt
import numpy as np
import pytest
import sympy as sp

import lynx_common
from lynx_common import arcs, drawing

KNOWN = {"np": np, "sp": sp, "plt": plt, "arcs": arcs, "drawing": drawing}  # as in a notebook


@pytest.mark.committed_lengths
def test_every_example_gives_what_it_says():
    for module in pkgutil.walk_packages(lynx_common.__path__, "lynx_common."):
        found = doctest.testmod(importlib.import_module(module.name), extraglobs=KNOWN)
        plt.close("all")
        assert found.failed == 0, module.name


def test_every_function_of_the_robotics_has_an_example():
    rooms = [f"lynx_common.{name}" for _, name, _ in pkgutil.iter_modules(lynx_common.__path__)]
    rooms = [*rooms, "lynx_common.arm.formulas", "lynx_common.rrr.formulas"]
    functions = [
        function
        for room in rooms
        for name, function in vars(importlib.import_module(room)).items()
        if inspect.isfunction(inspect.unwrap(function)) and function.__module__.startswith("lynx_common")
        if not name.startswith("_")
    ]
    assert len(functions) > 60
    assert [f"{f.__module__}.{f.__name__}" for f in functions if ">>>" not in (f.__doc__ or "")] == []
