"""Fixtures shared by the tests."""

import numpy as np
import pytest
from hypothesis import settings

# The same examples in every run: a failure is one that everybody sees.
settings.register_profile("course", derandomize=True, deadline=None)
settings.load_profile("course")


@pytest.fixture
def rng() -> np.random.Generator:
    """Random numbers that are the same in every run."""
    return np.random.default_rng(0)
