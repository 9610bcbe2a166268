"""Motions that were computed in a notebook, as stages: of the arm, of two arms side by side, of the platform."""

from collections.abc import Mapping, Sequence

import numpy as np
import sympy as sp
from IPython.display import HTML

from ... import arm, rrr
from ...errors import InputError
from ...reading import finite
from ...symbolic import P, Q
from ..stage import Body, Line, Motion, Space, Words, stage
from .legs import platform_on_legs
from .solids import DEGREES, NAMES, arm_in_space, frames_of, values_of

OTHER = sp.symbols("other_1:6", real=True)


def arm_in_motion(
    q: np.ndarray,
    still: Sequence[np.ndarray] = (),
    items: np.ndarray | None = None,
    radius: float = 0.02,
    seconds: float = 6,
    title: str = "The arm in motion",
    geometry: arm.Geometry = arm.LYNX,
    unit: str = "m",
) -> HTML:
    """A motion of the arm that plays, can be held and turned; the gripper leaves its way behind.

    Parameters
    ----------
    q : array, shape (n, 5)
        Joint angles in radians.
    still : arrays, shape (m, 3)
        Lines that do not move, in the unit of the lengths: belts, a planned path.
    items : array, shape (n, j, 3)
        Where balls of this ``radius`` are at the same instants.
    """
    q, size = _motion(q), sum(geometry)
    frames, gripper = frames_of(Q), geometry.L_3 > 0
    tip = frames[4][:3, 3].T
    parts = [*arm_in_space(frames, size, gripper=gripper), Line(tip, "z", 2, trail=True)]
    parts += [Line(sp.Matrix(np.round(line, 4).tolist()), "aid", 4) for line in still]
    columns = dict(zip(Q, q.T, strict=True))
    for number, track in enumerate(np.moveaxis(np.empty((len(q), 0, 3)) if items is None else items, 1, 0)):
        at = sp.symbols(f"item_{number}x item_{number}y item_{number}z", real=True)
        columns |= dict(zip(at, track.T, strict=True))
        parts.append(Body(sp.Matrix([at]), radius, "target" if gripper else "printed", clear=not gripper))
    words = _angles(Q) + [
        Words(f"{'gripper' if gripper else 'end'} at {{}}, {{}}, {{}} {unit}".rstrip(), list(tip))
    ]
    view = _seen([arm.joint_positions(q, geometry), *still, *([] if items is None else [items])], size, parts)
    motion = Motion(columns, seconds, title)
    return stage([view], [], words, values_of(P, geometry), title, motion)


def two_motions(motions: Mapping[str, np.ndarray], seconds: float = 8, geometry: arm.Geometry = arm.LYNX) -> HTML:
    """Two motions of the arm side by side, under their names, at the same instants; (n, 5) radians each."""
    if len(motions) != 2:
        raise InputError(f"Two motions are shown side by side; {len(motions)} were given.")
    columns: dict[sp.Symbol, np.ndarray] = {}
    views, words, size = [], [], sum(geometry)
    for (name, q), symbols in zip(motions.items(), (Q, OTHER), strict=True):
        q = _motion(q)
        columns |= dict(zip(symbols, q.T, strict=True))
        frames = frames_of(symbols)
        parts = [*arm_in_space(frames, size), Line(frames[4][:3, 3].T, "z", 2, trail=True)]
        views.append(_seen([arm.joint_positions(q, geometry)], size, parts, name))
        words += [Words(name), *_angles(symbols)]
    title = "Two motions of the arm side by side: " + " and ".join(motions)
    return stage(views, [], words, values_of(P, geometry), title, Motion(columns, seconds, "both motions"))


def platform_in_motion(
    poses: np.ndarray,
    theta: np.ndarray,
    seconds: float = 6,
    title: str = "The parallel robot in motion",
    geometry: rrr.Geometry = rrr.RRR,
) -> HTML:
    """A motion of the 3-RRR that plays: poses (n, 3) in mm and radians, and motor angles (n, 3) in radians."""
    poses, theta = finite(poses, "poses", None, 3), finite(theta, "motor angles", None, 3)
    return platform_on_legs(poses, theta, seconds, title, geometry)


def _motion(q: np.ndarray) -> np.ndarray:
    q = finite(q, "joint angles", None, 5)
    if not len(q):
        raise InputError("A motion has one posture at least; none was given.")
    return q


def _seen(points: Sequence[np.ndarray], size: float, parts: list, title: str = "") -> Space:
    """A view that holds all the points, (..., 3), of a motion of an arm of this size."""
    all_points = np.concatenate([np.reshape(some, (-1, 3)) for some in points])
    low, high = all_points.min(axis=0), all_points.max(axis=0)
    middle = np.append((low + high)[:2] / 2, 0.3 * size)
    far = max(0.65 * size, 1.15 * np.linalg.norm(all_points - middle, axis=1).max())
    return Space(tuple(np.round(middle, 4).tolist()), round(float(far), 4), round(size / 6, 4), parts, title=title)


def _angles(symbols: Sequence[sp.Symbol]) -> list[Words]:
    text = "  ".join(f"{name} {{}}°" for name in NAMES)
    return [Words(text, [DEGREES * angle for angle in symbols], 0)]
