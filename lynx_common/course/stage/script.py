"""Formulas of SymPy as JavaScript: the counterpart of ``symbolic.numeric`` for a page."""

import re
from collections.abc import Mapping, Sequence

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


class least(sp.Function):
    """The smallest of its arguments, as ``sp.Min``, which compares long expressions for seconds."""


class largest(sp.Function):
    """The largest of its arguments."""


class magnitude(sp.Function):
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

    def _print_Pow(self, expr: sp.Expr) -> str:
        if expr.exp in (2, 3) and expr.base.is_Symbol:
            return f"({expr.base}**{expr.exp})"  # shorter than Math.pow, and the same
        return super()._print_Pow(expr)

    def _print_Piecewise(self, expr: sp.Expr) -> str:
        return re.sub(r"\s+", " ", super()._print_Piecewise(expr))


def javascript(
    entries: Sequence[sp.Expr], *vectors: Sequence[sp.Symbol], let: Mapping[sp.Symbol, sp.Expr] | None = None
) -> str:
    """The source of a JavaScript function of one array per vector of symbols, which returns an array of numbers.

    ``let`` gives names to intermediate results, each in terms of those before it; those that the entries need are
    computed. Common parts are computed once. Raises InputError for symbols that nothing lists, and for names that
    JavaScript does not allow.

    >>> x, y = sp.symbols("x y", real=True)
    >>> javascript([y + 1], (x,), let={y: 2 * x})
    '([x]) => { const y = 2*x; return [y + 1]; }'
    """
    symbols = [symbol for vector in vectors for symbol in vector]
    matrix = formulas(entries) if len(entries) else sp.Matrix([])
    named = _needed(matrix.free_symbols, {s: expr for s, expr in (let or {}).items() if s not in symbols})
    held = matrix.free_symbols.union(*(expr.free_symbols for expr in named.values()))
    if names := sorted(map(str, held.difference(symbols, named))):
        raise InputError(f"The expressions also hold {', '.join(names)}, which no vector lists.")
    if unfit := [str(s) for s in (*symbols, *named) if not NAME.fullmatch(str(s))]:
        raise InputError(f"{', '.join(unfit)} cannot be the name of a variable in JavaScript.")
    steps, results = _steps(named, list(matrix))
    arguments = ", ".join(f"[{', '.join(map(str, vector))}]" for vector in vectors)
    return f"({arguments}) => {{ {''.join(steps)}return [{', '.join(results)}]; }}"


def _needed(wanted: set[sp.Symbol], let: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """Those of the intermediate results on which the wanted symbols depend, in their order."""
    needed: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expr in reversed(list(let.items())):
        if symbol in wanted:
            needed[symbol], wanted = sp.sympify(expr, strict=True), wanted | expr.free_symbols
    return dict(reversed(needed.items()))


def _steps(named: Mapping[sp.Symbol, sp.Expr], entries: list[sp.Expr]) -> tuple[list[str], list[str]]:
    """The statements that compute common parts and what has a name, each before it is used; and the entries."""
    code, steps = Printer().doprint, []
    rounded = [
        e.xreplace({x: sp.Float(x, DIGITS) for x in e.atoms(sp.Float)}) for e in (*named.values(), *entries)
    ]
    parts, reduced = sp.cse(rounded, symbols=sp.numbered_symbols("part", real=True))
    waiting = dict(parts)

    def state(expr: sp.Expr) -> str:
        for symbol in sorted(expr.free_symbols.intersection(waiting), key=lambda part: int(part.name[4:])):
            if symbol in waiting:
                steps.append(f"const {symbol} = {state(waiting.pop(symbol))}; ")
        return code(expr)

    for symbol, expr in zip(named, reduced, strict=False):
        steps.append(f"const {symbol} = {state(expr)}; ")
    return steps, [state(expr) for expr in reduced[len(named) :]]
