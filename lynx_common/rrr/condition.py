"""The condition on alpha for the robot to close at given motor angles, and motor angles that do not fix it."""

import numpy as np

from ..symbolic import DESIGN, POSE, compiled, real
from . import formulas
from .formulas import ELBOWS, THETA
from .geometry import RRR, Geometry, elbows, platform_joints

ALPHAS = np.pi / 4 * np.arange(8)  # a trigonometric polynomial of degree 3 is known by its values at these
LOOSE = 1e-5  # misfit of elbows and platform, as a share of L, below which the platform counts as free


_condition = compiled(POSE[2:], ELBOWS, DESIGN)(formulas.condition)


def self_motion(theta: np.ndarray, geometry: Geometry = RRR) -> np.ndarray:
    """Whether the platform can move although the motors are locked: (..., 3) to (...) of bool.

    It can travel on a circle of radius L where the elbows lie as the platform's joints do, in the same
    triangle: the distal links then are parallel and stay so. It can turn where the condition on alpha holds at
    every alpha, for example about three elbows that coincide, if L = r_platform. Lengths are compared to LOOSE
    times L, which is less than the play of any joint. Motor angles that are NaN or infinite give False.
    """
    theta = real(theta, THETA)
    M = as_complex(elbows(theta, geometry))
    r = as_complex(platform_joints(np.zeros(3), geometry))
    M, r = M - M.mean(axis=-1, keepdims=True), r - r.mean()
    turn = np.exp(1j * np.angle((M * r.conj()).sum(axis=-1, keepdims=True)))
    congruent = np.abs(M - turn * r).max(axis=-1) <= LOOSE * geometry.L
    positive, negative = np.moveaxis(condition_at(ALPHAS, theta[..., None, :], geometry), -1, 0)
    always = np.abs(positive - negative).max(axis=-1) <= LOOSE * (positive + negative).max(axis=-1)
    return congruent | always


def condition_at(alpha: np.ndarray, theta: np.ndarray, geometry: Geometry) -> np.ndarray:
    """Both terms of the condition, (..., 2)."""
    M = elbows(theta, geometry)
    return _condition(alpha[..., None], M.reshape(*M.shape[:-2], 6), geometry)


def as_complex(points: np.ndarray) -> np.ndarray:
    """Points of the plane, (..., 2), as complex numbers, (...)."""
    return points[..., 0] + 1j * points[..., 1]
