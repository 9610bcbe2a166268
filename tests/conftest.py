"""Fixtures shared by the tests."""

import numpy as np
import pytest
from hypothesis import settings

from lynx_common import arm

# The same examples in every run: a failure is one that everybody sees.
settings.register_profile("course", derandomize=True, deadline=None)
settings.load_profile("course")


@pytest.fixture
def rng() -> np.random.Generator:
    """Random numbers that are the same in every run."""
    return np.random.default_rng(0)


LONGEST = ("test_report.py", "test_notebooks.py")  # begun first, so that two workers end together


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Tests of numbers that the report or the prose gives are skipped where ``arm.LYNX`` is another arm."""
    items.sort(key=lambda item: item.path.name not in LONGEST)
    if arm.Geometry() != arm.LYNX:
        for item in items:
            if item.get_closest_marker("committed_lengths"):
                item.add_marker(pytest.mark.skip(reason="for the lengths as committed"))
