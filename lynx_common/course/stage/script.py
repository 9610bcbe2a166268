"""Formulas of SymPy as JavaScript: the counterpart of ``symbolic.numeric`` for a page."""

import re
from collections.abc import Sequence

import sympy as sp
from sympy.printing.jscode import JavascriptCodePrinter

from ...errors import InputError
from ...reading import formulas

KEPT = (
    "await|break|case|catch|class|const|continue|debugger|default|delete|do|else|enum|export|extends|false|finally"
    "|for|function|if|import|in|instanceof|let|new|null|return|static|super|switch|this|throw|true|try|typeof|var"
    "|void|while|with|yield|Math|NaN|part\\d+"  # by JavaScript, and by what is written here
)
NAME = re.compile(rf"(?!(?:{KEPT})$)[A-Za-z]\w*", re.ASCII)
DIGITS = 9  # significant ones of each number in a page; more would differ between processors


class least(sp.Function):  # noqa: N801, as SymPy's own
    """The smallest of its arguments, as ``sp.Min``, which compares long expressions with each other for seconds."""


class largest(sp.Function):  # noqa: N801
    """The largest of its arguments."""


class magnitude(sp.Function):  # noqa: N801
    """The absolute value of its argument, as ``sp.Abs``, which thinks about long ones for seconds."""


class Printer(JavascriptCodePrinter):
    """SymPy's, which also knows NaN, and keeps a case to one line."""

    def _print_least(self, expr: sp.Expr) -> str:
        return f"Math.min({', '.join(map(self._print, expr.args))})"

    def _print_largest(self, expr: sp.Expr) -> str:
        return f"Math.max({', '.join(map(self._print, expr.args))})"

    def _print_magnitude(self, expr: sp.Expr) -> str:
        return f"Math.abs({self._print(expr.args[0])})"

    def _print_NaN(self, _: sp.Expr) -> str:
        return "NaN"

    def _print_Piecewise(self, expr: sp.Expr) -> str:
        return re.sub(r"\s+", " ", super()._print_Piecewise(expr))


def javascript(entries: Sequence[sp.Expr], *vectors: Sequence[sp.Symbol]) -> str:
    """The source of a JavaScript function of one array per vector of symbols, which returns an array of numbers.

    Common parts are computed once. Raises InputError for symbols that no vector lists, and for names that
    JavaScript does not allow.

    >>> x = sp.Symbol("x", real=True)
    >>> javascript([x + 1], (x,))
    '([x]) => { return [x + 1]; }'
    """
    symbols = [symbol for vector in vectors for symbol in vector]
    matrix = formulas(entries) if len(entries) else sp.Matrix([])
    if names := sorted(map(str, matrix.free_symbols.difference(symbols))):
        raise InputError(f"The expressions also hold {', '.join(names)}, which no vector lists.")
    if unfit := [str(s) for s in symbols if not NAME.fullmatch(str(s))]:
        raise InputError(f"{', '.join(unfit)} cannot be the name of a variable in JavaScript.")
    matrix = matrix.xreplace({number: sp.Float(number, DIGITS) for number in matrix.atoms(sp.Float)})
    parts, (results, *_) = sp.cse([matrix], symbols=sp.numbered_symbols("part", real=True))
    code = Printer().doprint
    steps = "".join(f"const {name} = {code(part)}; " for name, part in parts)
    arguments = ", ".join(f"[{', '.join(map(str, vector))}]" for vector in vectors)
    return f"({arguments}) => {{ {steps}return [{', '.join(map(code, results))}]; }}"
