"""Bounds that hold between samples: proofs that a quantity stays above a minimum, along a motion or over a box.

Nothing here knows a robot or an obstacle. Along a motion the quantity is a function of joint angles with a known
Lipschitz constant; over a box it is whatever ``symbolic.enclose`` gives bounds of.
"""

from .boxes import holds, over
from .motion import Certificate, along

__all__ = ["Certificate", "along", "holds", "over"]
