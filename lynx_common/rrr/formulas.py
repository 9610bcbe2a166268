"""The robot's closed forms, in the symbols of ``symbolic``: each stands here once, and becomes NumPy from here.

Rows are the legs 1 to 3. The notebooks derive them anew, and assert that both are the same.
"""

from collections.abc import Sequence
from itertools import product

import sympy as sp

from ..symbolic import DESIGN, POSE, Q

THETA = Q[:3]

# Sign of (M_i - PB_i) x (PP_i - M_i), leg by leg: +1 where the leg bends to the left on its way to the platform.
WORKING_MODES = tuple(product((1, -1), repeat=3))

# Room for rounding where a leg is stretched or folded, as a share of its length. The loop then stays open by less.
# It is smaller than the arm's, whose targets are printed with few digits; here a leg bends by the root of it.
REACH_TOLERANCE = 1e-12
ELBOWS = sp.symbols("M_1x M_1y M_2x M_2y M_3x M_3y", real=True)


def base_joints() -> sp.Matrix:
    """PB_i, (3, 2), in DESIGN.

    >>> base_joints()[0, :]
    Matrix([[r_base*cos(beta_1), r_base*sin(beta_1)]])
    """
    _, _, _, r_base, *angles = DESIGN
    return sp.Matrix([[r_base * sp.cos(beta), r_base * sp.sin(beta)] for beta in angles[:3]])


def platform_joints() -> sp.Matrix:
    """PP_i, (3, 2), in POSE and DESIGN; report eqs. (2.1) and (2.2).

    >>> platform_joints()[0, 0].subs(POSE[2], 0)
    X_c + r_platform*cos(gamma_1)
    """
    (X_c, Y_c, alpha), (_, _, r_platform, *_) = POSE, DESIGN
    R = sp.Matrix([[sp.cos(alpha), -sp.sin(alpha)], [sp.sin(alpha), sp.cos(alpha)]])
    corners = [r_platform * sp.Matrix([sp.cos(gamma), sp.sin(gamma)]) for gamma in DESIGN[7:]]
    return sp.Matrix([(R * corner + sp.Matrix([X_c, Y_c])).T for corner in corners])


def driven_links() -> sp.Matrix:
    """M_i - PB_i, (3, 2), in THETA and DESIGN.

    >>> driven_links()[0, :]
    Matrix([[S_A*cos(theta_1), S_A*sin(theta_1)]])
    """
    S_A = DESIGN[0]
    return sp.Matrix([[S_A * sp.cos(theta), S_A * sp.sin(theta)] for theta in THETA])


def legs() -> sp.Matrix:
    """PP_i - PB_i, (3, 2), in POSE and DESIGN.

    >>> legs() == platform_joints() - base_joints()
    True
    """
    return platform_joints() - base_joints()


def squared_lengths() -> sp.Matrix:
    """|PP_i - PB_i|^2, (3, 1), in POSE and DESIGN.

    >>> squared_lengths()[0] == legs()[0, :].dot(legs()[0, :])
    True
    """
    return sp.Matrix([x**2 + y**2 for x, y in legs().tolist()])


def motor_angle(sigma: sp.Expr, x: sp.Expr, y: sp.Expr) -> sp.Expr:
    """Angle of the motor whose leg spans (x, y) and bends to the side ``sigma``; valid where the leg closes.

    >>> x, y = sp.symbols("x y", real=True)
    >>> motor_angle(1, x, y).subs(dict(zip((*DESIGN[:2], x, y), (3, 4, 5, 0))))  # a triangle of sides 3, 4, 5
    -atan(4/3)
    """
    S_A, L, *_ = DESIGN
    squared = x**2 + y**2
    k = squared + S_A**2 - L**2
    below_root = ((S_A + L) ** 2 - squared) * (squared - (S_A - L) ** 2)  # (2 S_A |u|)^2 - k^2
    root = sp.sqrt((below_root + sp.Abs(below_root)) / 2)  # not negative, whatever rounding does
    return sp.atan2(y * k - sigma * x * root, x * k + sigma * y * root)


def motor_angles() -> sp.Matrix:
    """Those of the three legs for the sign +1, then for -1: (2, 3), in POSE and DESIGN.

    >>> motor_angles().shape
    (2, 3)
    """
    angles = [motor_angle(sigma, x, y) for sigma, (x, y) in product((1, -1), legs().tolist())]
    return sp.Matrix(2, 3, angles)


def closing() -> sp.Matrix:
    """1 for a leg that spans from base to platform, NaN for one that cannot, (3, 1), in POSE and DESIGN.

    >>> closing().shape
    (3, 1)
    """
    S_A, L, *_ = DESIGN
    slack = REACH_TOLERANCE * (S_A + L)
    least, most = sp.Max(sp.Abs(S_A - L) - slack, 0) ** 2, (S_A + L + slack) ** 2
    spans = [sp.And(squared >= least, squared <= most) for squared in squared_lengths()]
    return sp.Matrix([sp.Piecewise((1, span), (sp.nan, True), evaluate=False) for span in spans])


def working_modes() -> sp.Matrix:
    """Motor angles, the rows of WORKING_MODES, (8, 3), in POSE and DESIGN; NaN where a leg cannot close.

    >>> working_modes().shape
    (8, 3)
    """
    angles, closed = motor_angles(), closing()
    left, right = ([closed[leg] * angles[side, leg] for leg in range(3)] for side in (0, 1))
    return sp.Matrix(8, 3, lambda i, leg: (left if WORKING_MODES[i][leg] == 1 else right)[leg])


def rows_of_A(elbows: sp.Matrix) -> sp.Matrix:
    """The rows of A, (3, 3), for elbows M_i, (3, 2): the distal link, and the cross product of PP_i - C with it.

    >>> rows_of_A(sp.zeros(3, 2))[:, :2] == platform_joints()
    True
    """
    C = sp.Matrix([POSE[:2]] * 3)
    distal = platform_joints() - elbows
    turning = [cross(*pair) for pair in zip((platform_joints() - C).tolist(), distal.tolist(), strict=True)]
    return distal.row_join(sp.Matrix(turning))


def velocity_rows() -> sp.Matrix:
    """Per leg the row of A, then the diagonal entry of B: (3, 4), in POSE, THETA and DESIGN.

    >>> velocity_rows()[0, :2] == legs()[0, :] - driven_links()[0, :]
    True
    """
    driven = driven_links()
    A = rows_of_A(base_joints() + driven)
    B = [cross(*pair) for pair in zip(driven.tolist(), A[:, :2].tolist(), strict=True)]
    return A.row_join(sp.Matrix(B))


def normalised() -> sp.Matrix:
    """What is zero at a singularity, without units, (4, 1), in POSE, THETA and DESIGN: the sine at each elbow
    (type 1), and det A of distal links of length 1, over r_platform (type 2).

    >>> normalised().shape
    (4, 1)
    """
    S_A, L, r_platform, *_ = DESIGN
    rows = velocity_rows()
    sines = rows[:, 3] / (S_A * L)
    A = rows[:, :3] * sp.diag(1 / L, 1 / L, 1 / (L * r_platform))
    return sines.col_join(sp.Matrix([A[0, :].dot(A[1, :].cross(A[2, :]))]))


def unit_rows(mode: Sequence[int]) -> sp.Matrix:
    """The rows of A for distal links of length 1, moments over r_platform, (3, 3), in POSE and DESIGN.

    Elbow i is where two circles cross, on the side that the sign of ``mode`` says: no motor angle is needed.

    >>> unit_rows((1, 1, -1)).shape
    (3, 3)
    """
    S_A, L, r_platform, *_ = DESIGN
    C, rows = sp.Matrix([POSE[:2]]), []
    for sigma, PP, (x, y) in zip(mode, platform_joints().tolist(), legs().tolist(), strict=True):
        squared = x**2 + y**2
        share = sp.Rational(1, 2) + (S_A**2 - L**2) / (2 * squared)  # of the leg, to the foot of the elbow on it
        height = sp.sqrt(S_A**2 / squared - share**2)
        distal = ((1 - share) * sp.Matrix([[x, y]]) + sigma * height * sp.Matrix([[-y, x]])) / L
        rows.append([*distal, cross(sp.Matrix([PP]) - C, distal) / r_platform])
    return sp.Matrix(rows)


def newton() -> sp.Matrix:
    """(|PP_i - M_i|^2 - L^2) / 2, about L times the miss of each distal link; and the step of Newton's method on
    these, whose derivative is A: two rows, (2, 3), in POSE, ELBOWS and DESIGN.

    >>> newton().shape
    (2, 3)
    """
    A = rows_of_A(sp.Matrix(3, 2, ELBOWS))
    off = sp.Matrix([(x**2 + y**2 - DESIGN[1] ** 2) / 2 for x, y, _ in A.tolist()])
    u, v, w = (A[i, :] for i in range(3))
    step = sp.Matrix.hstack(v.cross(w).T, w.cross(u).T, u.cross(v).T) * off / u.dot(v.cross(w))
    return sp.Matrix.vstack(off.T, step.T)


def condition() -> sp.Matrix:
    """The condition on alpha as two terms that are equal, in alpha, ELBOWS and DESIGN. For the triangle of sides

        a, b, a - b:    |a|^2 |b|^2 |a - b|^2 = 4 L^2 (a x b)^2,

    that is, the radius of the circle about its corners M_i - R(alpha) r_i is L.

    >>> condition().shape
    (2, 1)
    """
    corner = sp.Matrix(3, 2, ELBOWS) - platform_joints().subs({POSE[0]: 0, POSE[1]: 0})
    a, b = corner[1, :] - corner[0, :], corner[2, :] - corner[0, :]
    sides = [v.dot(v) for v in (a, b, a - b)]
    return sp.Matrix([sp.prod(sides), 4 * DESIGN[1] ** 2 * cross(a, b) ** 2])


def cross(u: sp.Matrix, v: sp.Matrix) -> sp.Expr:
    """The third component of the cross product of two plane vectors.

    >>> cross(sp.Matrix([1, 0]), sp.Matrix([0, 1]))
    1
    """
    return u[0] * v[1] - u[1] * v[0]
