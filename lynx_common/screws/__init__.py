"""Screws: the twists and wrenches of rigid bodies, the motions they generate, and which do no work on which.

A *twist* is (v, omega) as in report eq. (3.3): omega is the body's angular velocity, and v the velocity of that
point of the body which is just at the origin. A *wrench* is (f, m): the force, and its moment about the origin.
The power of the one on the other is then the plain product f . v + m . omega. Six-vectors are the last axis,
(..., 6); the twists of several joints are the columns of a matrix, (..., 6, n), as in a Jacobian. Angles are in
radians, lengths in any one unit.

Many books write (omega, v) instead; there the blocks of ``adjoint`` change places. A twist, a wrench or a pose
that holds NaN or infinity gives NaN; the screws of a system must be finite. Complex numbers and wrong shapes raise
InputError.

Source: K. Lynch and F. Park, Modern Robotics, chapters 3 to 5, with the halves of the six-vectors exchanged.
"""

from ._lines import Screw, force, prismatic, revolute, screw_axis
from ._motions import adjoint, exp
from ._systems import order, reciprocal_product, reciprocal_system
