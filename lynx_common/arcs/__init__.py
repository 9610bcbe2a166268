"""Plane regions bounded by circular arcs: membership, exact area and perimeter, volume of revolution, boundary.

Such a region is given by circles that hold its whole boundary, and by a test of membership. The circles cut each
other into pieces; a piece is boundary if one side of it is inside and the other is not. All that is measured
follows from these pieces in closed form, by Green's theorem.
"""

from ._circles import crossings
from ._region import Region, annulus
