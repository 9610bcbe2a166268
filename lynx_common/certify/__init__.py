"""Bounds that hold between samples: proofs that a quantity stays above a minimum, along a motion or over a box.

Nothing here knows a robot or an obstacle. Along a motion the quantity is a function of joint angles with a known
Lipschitz constant; over a box it is whatever ``symbolic.enclose`` gives bounds of.
"""

from ._boxes import holds, over
from ._motions import Certificate, along
