"""Both Denavit-Hartenberg conventions against their definitions."""

import sympy as sp

from lynx_common import dh
from lynx_common.symbolic import ROW, numeric

a, alpha, d, theta = ROW


def test_the_standard_link_is_report_equation_1_1():
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    printed = sp.Matrix([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])
    assert dh.standard(dh.Row(*ROW)) == printed


def test_the_modified_link_is_craig_equation_3_6():
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    printed = sp.Matrix(
        [[c, -s, 0, a], [s * ca, c * ca, -sa, -sa * d], [s * sa, c * sa, ca, ca * d], [0, 0, 0, 1]]
    )
    assert dh.modified(dh.Row(*ROW)) == printed


def test_the_two_conventions_are_one_row_shifted():
    """Rx(alpha) Tx(a) moved from the end of a standard link to the start of the next modified one."""
    a_2, alpha_2, d_2, theta_2 = sp.symbols("a_2 alpha_2 d_2 theta_2", real=True)
    standard = [dh.Row(a, alpha, d, theta), dh.Row(a_2, alpha_2, d_2, theta_2)]
    modified = [dh.Row(0, 0, d, theta), dh.Row(a, alpha, d_2, theta_2)]
    tail = dh.trans(a_2, 0, 0) * dh.rot_x(alpha_2)
    difference = dh.chain(standard)[-1] - dh.chain(modified, link=dh.modified)[-1] * tail
    assert sp.expand(difference) == sp.zeros(4, 4)


def test_a_chain_holds_every_partial_product():
    rows = [dh.Row(*ROW), dh.Row(1, 0, 0, theta), dh.Row(0, sp.pi / 2, 2, 0)]
    links = [dh.standard(row) for row in rows]
    assert dh.chain(rows) == [links[0], links[0] * links[1], links[0] * links[1] * links[2]]


def test_elementary_rotations_turn_the_right_way():
    """A quarter turn about x takes y to z; about z it takes x to y."""
    assert dh.rot_x(sp.pi / 2) * sp.Matrix([0, 1, 0, 1]) == sp.Matrix([0, 0, 1, 1])
    assert dh.rot_z(sp.pi / 2) * sp.Matrix([1, 0, 0, 1]) == sp.Matrix([0, 1, 0, 1])
    assert dh.trans(1, 2, 3) * sp.Matrix([0, 0, 0, 1]) == sp.Matrix([1, 2, 3, 1])


def test_links_are_rigid(rng):
    """R^T R = I and det R = 1 for random rows of either convention."""
    for link in (dh.standard, dh.modified):
        T = numeric(link(dh.Row(*ROW)), ROW)(rng.uniform(-3, 3, (100, 4)))
        R = T[:, :3, :3]
        assert abs(R.transpose(0, 2, 1) @ R - [[1, 0, 0], [0, 1, 0], [0, 0, 1]]).max() < 1e-14
        assert (T[:, 3] == [0, 0, 0, 1]).all()
