"""The examples in docstrings run, and give what they say."""

import doctest
import importlib
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
    tried = 0
    for module in pkgutil.walk_packages(lynx_common.__path__, "lynx_common."):
        found = doctest.testmod(importlib.import_module(module.name), extraglobs=KNOWN)
        plt.close("all")
        assert found.failed == 0, module.name
        tried += found.attempted
    assert tried >= 10
