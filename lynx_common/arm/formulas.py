"""The arm's closed forms, in the symbols of ``symbolic``: each stands here once, and becomes NumPy from here.

The notebooks derive them anew, and assert that both are the same.
"""

from functools import cache

import sympy as sp

from .. import dh
from ..symbolic import TASK, WRIST, XYZ, P, Q, tidy
from ._geometry import dh_table

SIGMA = sp.Symbol("sigma", real=True)  # sign of theta_3

# The wrist may miss the reach of the links by this share of their length: a target at full stretch is reached
# even where rounding puts it a hair outside. The gripper then misses it by no more than that.
REACH_TOLERANCE = 1e-9


@cache
def frames() -> list[sp.Matrix]:
    """Poses of the frames 0 to 5 in the base frame; report eq. (1.2), its partial products.

    >>> frames()[1][:3, 3].T  # the shoulder
    Matrix([[0, 0, d_1]])
    """
    return [sp.eye(4), *map(tidy, dh.chain(dh_table()))]


def pose() -> sp.Matrix:
    """T_0_5, (4, 4), in Q and P; report eq. (1.2).

    >>> pose()[2, 2]  # the sine of the pitch
    -cos(theta_2 + theta_3 + theta_4)
    """
    return frames()[-1]


def joint_positions() -> sp.Matrix:
    """Base, shoulder, elbow, wrist and gripper as rows, (5, 3), in Q and P; report eqs. (1.25) to (1.38).

    >>> joint_positions()[1, :]  # the shoulder
    Matrix([[0, 0, d_1]])
    """
    base, shoulder, elbow, wrist, _, gripper = (T[:3, 3].T for T in frames())
    return sp.Matrix.vstack(base, shoulder, elbow, wrist, gripper)


def pitch() -> sp.Expr:
    """The angle of the gripper's axis above the horizontal, in Q; report eq. (1.12), with theta_4 of Table 1.2.

    >>> pitch()
    theta_2 + theta_3 + theta_4 - pi/2
    """
    return Q[1] + Q[2] + Q[3] - sp.pi / 2


def task_coordinates() -> sp.Matrix:
    """Azimuth, signed r, z, pitch and roll, (5, 1), in Q and P.

    >>> task_coordinates()[3] == pitch()
    True
    """
    in_plane = tidy(dh.chain(dh_table()[1:])[-1])  # the gripper in frame 1, whose x and y span the arm's plane
    return sp.Matrix([Q[0], in_plane[0, 3], P[0] + in_plane[1, 3], pitch(), Q[4]])


def jacobian() -> sp.Matrix:
    """The geometric Jacobian, (6, 5), rows (v, omega), in Q and P; report eqs. (3.2) and (3.3).

    >>> jacobian()[3:, 0].T  # joint 1 turns about the vertical
    Matrix([[0, 0, 1]])
    """
    linear = pose()[:3, 3].jacobian(Q)
    angular = sp.Matrix.hstack(*(T[:3, 2] for T in frames()[:-1]))
    return linear.col_join(angular)


def wrist() -> sp.Matrix:
    """The wrist in the arm's plane, from the shoulder: (r_wrist, h) in TASK and P; report eqs. (1.17), (1.18).

    >>> wrist()[0]
    -L_3*cos(pitch) + r
    """
    (_, r, z, pitch, _), (d_1, _, _, L_3) = TASK, P
    return sp.Matrix([r - L_3 * sp.cos(pitch), z - d_1 - L_3 * sp.sin(pitch)])


def reach() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Distance of the wrist from the shoulder, and the least and the largest that the links reach; WRIST and P.

    >>> reach()[2]
    L_1 + L_2
    """
    (r_wrist, h), (_, L_1, L_2, _) = WRIST, P
    return sp.sqrt(r_wrist**2 + h**2), sp.Abs(L_1 - L_2), L_1 + L_2


def joint_angles() -> sp.Matrix:
    """Joint angles, (5, 1), for theta_3 of the sign sigma, in TASK, WRIST and P; report eqs. (1.19) to (1.24).

    >>> joint_angles().shape
    (5, 1)
    """
    (azimuth, _, _, pitch, roll), (r_wrist, h), (_, L_1, L_2, _) = TASK, WRIST, P
    D = (r_wrist**2 + h**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)
    D = sp.Max(-1, sp.Min(1, D))  # beyond lies only what REACH_TOLERANCE lets pass
    S = sp.sqrt((1 - D) * (1 + D))
    theta_3 = SIGMA * sp.atan2(S, D)
    theta_2 = sp.atan2(h, r_wrist) - SIGMA * sp.atan2(L_2 * S, L_1 + L_2 * D)
    return sp.Matrix([azimuth, theta_2, theta_3, pitch + sp.pi / 2 - theta_2 - theta_3, roll])


@cache
def both_elbows() -> sp.Matrix:
    """Elbow up and elbow down as rows, (2, 5), in TASK and P; NaN where the links do not reach.

    >>> both_elbows().shape
    (2, 5)
    """
    distance, nearest, farthest = reach()
    slack = REACH_TOLERANCE * farthest
    reached = sp.And(distance >= nearest - slack, distance <= farthest + slack)
    # Times NaN is NaN: in sigma it goes into theta_2 to theta_4, and beside it into azimuth and roll.
    one = sp.Piecewise((1, reached), (sp.nan, True), evaluate=False)
    up = one * sp.Piecewise((-1, WRIST[0] >= 0), (1, True))  # the sign of theta_3 with the higher elbow
    rows = [joint_angles().xreplace({SIGMA: sign}).T for sign in (up, -up)]
    rows = [row.multiply_elementwise(sp.Matrix([[one, 1, 1, 1, one]])) for row in rows]
    return sp.Matrix.vstack(*rows).xreplace(dict(zip(WRIST, wrist(), strict=True)))


def front() -> sp.Matrix:
    """Task coordinates, (5, 1), of the front branches, in XYZ, pitch and roll; azimuth 0 on the base axis.

    >>> front()[1]
    sqrt(x**2 + y**2)
    """
    x, y, z = XYZ
    r = sp.sqrt(x**2 + y**2)
    azimuth = sp.Piecewise((0, sp.Eq(r, 0)), (sp.atan2(y, x), True))
    return sp.Matrix([azimuth, r, z, TASK[3], TASK[4]])


@cache
def branches() -> sp.Matrix:
    """The rows of BRANCHES, (4, 5), wrapped into (-pi, pi], in XYZ, pitch and roll, and P.

    >>> branches().shape
    (4, 5)
    """
    facing = both_elbows().xreplace(dict(zip(TASK[:3], front()[:3], strict=True)))
    # The shoulder turned half round makes the same shape, seen from behind: what was up stays up.
    back = [
        sp.Matrix([[q_1 + sp.pi, sp.pi - q_2, -q_3, sp.pi - q_4, q_5 + sp.pi]])
        for q_1, q_2, q_3, q_4, q_5 in facing.tolist()
    ]
    rows = sp.Matrix.vstack(facing, *back)
    return rows.applyfunc(lambda q: q - 2 * sp.pi * sp.ceiling((q - sp.pi) / (2 * sp.pi), evaluate=False))
