"""Which poses the platform can take."""

import numpy as np
from numpy.typing import ArrayLike

from .. import arcs, reading
from ._geometry import RRR, Geometry, base_joints, platform_joints
from ._inverse import closing


def reachable(pose: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    """Whether all three legs close at a pose, in some working mode: (..., 3) to (...) of bool; NaN is not.

    >>> reachable([[0, 0, 0], [300, 0, 0]])
    array([ True, False])
    """
    legs = np.isfinite(closing(pose, geometry))
    return legs[..., 0] & legs[..., 1] & legs[..., 2]


def constant_orientation_workspace(alpha: float, geometry: Geometry = RRR) -> arcs.Region:
    """Where the platform's centre can be at a fixed alpha (radians): a region in mm, bounded by arcs.

    Leg i allows the centre a ring about PB_i - R(alpha) r_i, from |S_A - L| to S_A + L, with r_i the
    platform's joint seen from its centre. The workspace is what the three rings have in common; it may be empty.

    Raises InputError unless alpha is one finite number. Source: notebook Part2, section 4.

    >>> round(constant_orientation_workspace(0.0).area)  # mm^2
    64786
    """
    alpha = reading.number(alpha, "angle alpha")
    S_A, L, *_ = geometry
    centres = base_joints(geometry) - platform_joints(np.array([0, 0, alpha]), geometry)
    rings = [arcs.annulus(x, y, abs(S_A - L), S_A + L) for x, y in centres]
    return rings[0] & rings[1] & rings[2]
