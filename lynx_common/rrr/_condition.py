"""The condition on alpha for the robot to close at given motor angles, and motor angles that do not fix it."""

import numpy as np
from numpy.typing import ArrayLike

from ..symbolic import DESIGN, POSE, compiled
from . import formulas
from ._geometry import RRR, Geometry, elbows, platform_joints
from .formulas import ELBOWS

ALPHAS = np.pi / 4 * np.arange(8)  # a trigonometric polynomial of degree 3 is known by its values at these
LOOSE = 1e-5  # misfit of elbows and platform, as a share of L, below which the platform counts as free

_condition = compiled(POSE[2:], ELBOWS, DESIGN)(formulas.condition)


def self_motion(theta: ArrayLike, geometry: Geometry = RRR) -> np.ndarray:
    """Whether the platform can move although the motors are locked: (..., 3) to (...) of bool.

    It can travel on a circle of radius L where the elbows lie as the platform's joints do, in the same
    triangle: the distal links then are parallel and stay so. It can turn where the condition on alpha holds at
    every alpha, for example about three elbows that coincide, if L = r_platform. Lengths are compared to LOOSE
    times L, which is less than the play of any joint. Motor angles that are NaN or infinite give False.

    >>> self_motion(np.deg2rad([[10, 130, 250]]))
    array([False])
    """
    M = elbows(theta, geometry)
    return platform_free(M, condition_at(M, geometry), geometry)


def condition_at(M: np.ndarray, geometry: Geometry) -> np.ndarray:
    """Both terms of the condition for elbows M, (..., 3, 2), at each of ALPHAS: (..., 8, 2)."""
    return _condition(ALPHAS[:, None], M.reshape(*M.shape[:-2], 1, 6), geometry)


def platform_free(M: np.ndarray, condition: np.ndarray, geometry: Geometry) -> np.ndarray:
    """``self_motion``, (...), for elbows (..., 3, 2) and the terms that ``condition_at`` gives for them."""
    r = _complex(platform_joints(np.zeros(3), geometry))
    w = _complex(M)
    w, r = w - w.mean(axis=-1, keepdims=True), r - r.mean()
    turn = np.exp(1j * np.angle((w * r.conj()).sum(axis=-1, keepdims=True)))
    congruent = np.abs(w - turn * r).max(axis=-1) <= LOOSE * geometry.L
    positive, negative = condition[..., 0], condition[..., 1]
    always = np.abs(positive - negative).max(axis=-1) <= LOOSE * (positive + negative).max(axis=-1)
    return congruent | always


def _complex(points: np.ndarray) -> np.ndarray:
    """Points of the plane, (..., 2), as complex numbers, (...)."""
    return points[..., 0] + 1j * points[..., 1]
