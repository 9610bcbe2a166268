"""Formulas made short, in hundredths of a second."""

import sympy as sp
from sympy.simplify.fu import TR5, TR10i

from ..reading import formulas


def tidy(expr: sp.Expr | sp.MatrixBase) -> sp.Expr | sp.MatrixBase:
    """``expr``, or each entry of it, with sums of angles joined and common factors taken out.

    Made for products of link transforms, where it takes hundredths of a second and ``simplify``
    takes seconds: cos(a) cos(b) - sin(a) sin(b) becomes cos(a + b), and sin(a)**2 + cos(a)**2 becomes 1.

    >>> x, y = sp.symbols("x y", real=True)
    >>> tidy(sp.cos(x) * sp.cos(y) - sp.sin(x) * sp.sin(y))
    cos(x + y)
    """
    if isinstance(expr, sp.MatrixBase):
        return expr.applyfunc(tidy)
    (expr,) = formulas(expr)
    expanded = sp.expand(expr)
    without_squared_sines = sp.expand(TR5(expanded))
    ways = [expanded] if without_squared_sines == expanded else [expanded, without_squared_sines]
    return sp.factor_terms(min(map(TR10i, ways), key=sp.count_ops))
