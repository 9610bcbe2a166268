"""The examples in docstrings run, and give what they say."""

import doctest
import importlib
import pkgutil

import numpy as np
import pytest
import sympy as sp

import lynx_common


@pytest.mark.committed_lengths
def test_every_example_gives_what_it_says():
    tried = 0
    for module in pkgutil.walk_packages(lynx_common.__path__, "lynx_common."):
        found = doctest.testmod(importlib.import_module(module.name), extraglobs={"np": np, "sp": sp})
        assert found.failed == 0, module.name
        tried += found.attempted
    assert tried >= 10
