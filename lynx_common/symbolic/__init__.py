"""The course's symbols, each made once, and the one door from SymPy to NumPy.

Symbols and numbers never share a name: ``theta_2`` and ``L_1`` are symbols, ``q`` and
``geometry`` are arrays and records of numbers.
"""

from .door import CHUNK, compiled, numeric
from .enclosing import enclose
from .symbols import ANGLES, DESIGN, POSE, ROW, TASK, WRIST, XYZ, P, Q
from .tidying import tidy

__all__ = [
    "ANGLES",
    "CHUNK",
    "DESIGN",
    "POSE",
    "ROW",
    "TASK",
    "WRIST",
    "XYZ",
    "P",
    "Q",
    "compiled",
    "enclose",
    "numeric",
    "tidy",
]
