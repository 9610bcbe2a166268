"""Denavit-Hartenberg tables and link transforms, in both conventions.

Rows are written in the order of the report's Tables 1.1 and 1.2: a, alpha, d, theta.
What the report calls *distal* is the standard convention (report eq. 1.1); what it calls
*proximal* is the modified convention (Craig, Introduction to Robotics, eq. 3.6).
"""

from collections.abc import Callable, Iterable
from itertools import accumulate
from operator import mul
from typing import NamedTuple

import sympy as sp

from .reading import formulas


class Row(NamedTuple):
    """One link of a DH table: lengths ``a`` and ``d`` in metres, angles in radians; symbols or numbers."""

    a: sp.Expr
    alpha: sp.Expr
    d: sp.Expr
    theta: sp.Expr


def standard(row: Row) -> sp.Matrix:
    """Pose of frame i in frame i-1, (4, 4), in the standard (distal) convention; report eq. (1.1).

    >>> standard(Row(a=2, alpha=0, d=1, theta=sp.pi / 2))[:3, 3].T
    Matrix([[0, 2, 1]])
    """
    return rot_z(row.theta) * trans(0, 0, row.d) * trans(row.a, 0, 0) * rot_x(row.alpha)


def modified(row: Row) -> sp.Matrix:
    """Pose of frame i in frame i-1, (4, 4), in the modified (proximal) convention; Craig eq. (3.6).

    >>> modified(Row(a=2, alpha=0, d=1, theta=sp.pi / 2))[:3, 3].T
    Matrix([[2, 0, 1]])
    """
    return rot_x(row.alpha) * trans(row.a, 0, 0) * rot_z(row.theta) * trans(0, 0, row.d)


def chain(table: Iterable[Row], link: Callable[[Row], sp.Matrix] = standard) -> list[sp.Matrix]:
    """Poses T_0_1, T_0_2, ..., T_0_n of every frame in the base frame, not simplified; report eq. (1.2).

    >>> chain([Row(2, 0, 0, sp.pi / 2), Row(1, 0, 0, 0)])[-1][:3, 3].T  # two links, both along y
    Matrix([[0, 3, 0]])
    """
    return list(accumulate(map(link, table), mul))


def rot_x(angle: sp.Expr) -> sp.Matrix:
    """Rotation by ``angle`` (radians) about x, (4, 4).

    >>> (rot_x(sp.pi / 2) * sp.Matrix([0, 1, 0, 1])).T  # takes y to z
    Matrix([[0, 0, 1, 1]])
    """
    (angle,) = formulas(angle, "The angle")
    c, s = sp.cos(angle), sp.sin(angle)
    return sp.Matrix([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def rot_z(angle: sp.Expr) -> sp.Matrix:
    """Rotation by ``angle`` (radians) about z, (4, 4).

    >>> (rot_z(sp.pi / 2) * sp.Matrix([1, 0, 0, 1])).T  # takes x to y
    Matrix([[0, 1, 0, 1]])
    """
    (angle,) = formulas(angle, "The angle")
    c, s = sp.cos(angle), sp.sin(angle)
    return sp.Matrix([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


def trans(x: sp.Expr, y: sp.Expr, z: sp.Expr) -> sp.Matrix:
    """Translation by (x, y, z), (4, 4).

    >>> (trans(1, 2, 3) * sp.Matrix([0, 0, 0, 1])).T
    Matrix([[1, 2, 3, 1]])
    """
    x, y, z = formulas([x, y, z], "The translation")
    return sp.Matrix([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]])
