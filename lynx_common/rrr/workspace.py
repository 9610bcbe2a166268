"""Which poses the platform can take."""

import numpy as np

from .. import arcs
from ..errors import InputError
from ..reading import real
from .geometry import RRR, Geometry, base_joints, checked, platform_joints
from .inverse import spans, squared_lengths


def reachable(pose: np.ndarray, geometry: Geometry = RRR) -> np.ndarray:
    """Whether all three legs close at a pose, in some working mode: (..., 3) to (...) of bool; NaN is not."""
    legs = spans(squared_lengths(checked(pose), geometry), geometry)
    return legs[..., 0] & legs[..., 1] & legs[..., 2]


def constant_orientation_workspace(alpha: float, geometry: Geometry = RRR) -> arcs.Region:
    """Where the platform's centre can be at a fixed alpha (radians): a region in mm, bounded by arcs.

    Leg i allows the centre a ring about PB_i - R(alpha) r_i, from |S_A - L| to S_A + L, with r_i the
    platform's joint seen from its centre. The workspace is what the three rings have in common; it may be empty.

    Raises InputError unless alpha is one finite number. Source: notebook Part2, section 5.
    """
    alpha = real(alpha, "the angle alpha")
    if alpha.shape != () or not np.isfinite(alpha):
        raise InputError(f"One finite angle alpha in radians is expected; {alpha!s} was given.")
    S_A, L, *_ = geometry
    centres = base_joints(geometry) - platform_joints(np.array([0, 0, alpha]), geometry)
    rings = [arcs.annulus(x, y, abs(S_A - L), S_A + L) for x, y in centres]
    return rings[0] & rings[1] & rings[2]
