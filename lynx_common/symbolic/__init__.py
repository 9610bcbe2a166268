"""The course's symbols, each made once, and the doors from SymPy: to NumPy, to intervals, to other languages.

Symbols and numbers never share a name: ``theta_2`` and ``L_1`` are symbols, ``q`` and
``geometry`` are arrays and records of numbers.
"""

from ._code import code
from ._door import CHUNK, compiled, numeric
from ._enclosing import enclose
from ._symbols import ANGLES, DESIGN, POSE, ROW, TASK, WRIST, XYZ, P, Q
from ._tidying import tidy
