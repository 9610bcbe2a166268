"""The same formula as text in another language: MATLAB (which Octave reads, too), Python or C."""

import re
from collections.abc import Sequence
from itertools import count

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.codeprinter import CodePrinter
from sympy.printing.octave import OctaveCodePrinter
from sympy.printing.pycode import PythonCodePrinter

from ..errors import InputError
from ..reading import shortened
from ._door import read
from ._symbols import ARGUMENTS

# Outside of these MATLAB would compute a complex number, and Python would stop; C gives NaN, as NumPy does.
INSIDE = {"sqrt": "x >= 0", "acos": "abs(x) <= 1", "asin": "abs(x) <= 1"}
GUARDED = {"matlab": INSIDE, "python": INSIDE | {"ceil": "math.isfinite(x)"}, "c": {}}
GUARD = {
    "matlab": "\nfunction y = real_{f}(x)\n  if {inside}, y = {f}(x); else, y = NaN; end\nend\n",
    "python": "\n\ndef real_{f}(x):\n    return math.{f}(x) if {inside} else math.nan\n",
}
GUARDS = {f"real_{f}": f"real_{f}" for f in GUARDED["python"]}
FUNCTIONS = {sp.acos: "acos", sp.asin: "asin", sp.ceiling: "ceil"}
# All that is written. Others are computed otherwise at the edges of their domains, or for negative numbers.
CHOICES = sp.Max, sp.Min, sp.sign  # of NaN they make a number
WRITABLE = *FUNCTIONS, *CHOICES, sp.sin, sp.cos, sp.tan, sp.atan, sp.atan2, sp.Abs, sp.Piecewise
LARGEST = 2**31  # beyond, C would take a whole number for another one

NAME = re.compile("[A-Za-z][A-Za-z0-9_]*")
# What the texts call by name, besides the reserved words of each language.
CALLED = {*GUARDS, "pi", "i", "j", "math", "isfinite", "nan", "NAN", "NaN", "inf", "Inf", "INFINITY", "M_PI"}
CALLED |= {"sqrt", "sin", "cos", "tan", "acos", "asin", "atan", "atan2", "ceil", "abs", "max", "min", "sign"}
CALLED |= {"pow", "fabs", "fmax", "fmin", "copysign", "M_SQRT2", "M_PI_2"}

PRINTERS: dict[str, CodePrinter] = {
    "matlab": OctaveCodePrinter({"inline": False, "user_functions": GUARDS}),
    "python": PythonCodePrinter({"user_functions": GUARDS}),
    "c": C99CodePrinter(),
}


def code(
    expr: sp.Expr | sp.MatrixBase,
    *vectors: Sequence[sp.Symbol],
    name: str,
    language: str = "matlab",
    about: str = "",
) -> str:
    """``expr`` as a function called ``name`` in "matlab", "python" or "c": text that needs nothing else.

    Parameters
    ----------
    expr, *vectors : as for ``numeric``
        Each vector is one argument, an array; a vector of one symbol is a number.
    about : str
        The first comment: what is computed, in which units, and by which equation.

    The function takes one sample of finite numbers and gives what ``numeric`` gives: a number, a row of n, or a
    matrix, with NaN outside a function's domain; in C as its last argument, unless it is a number. In Python a
    division by zero raises. Written are whole powers, square roots and the functions that kinematics needs;
    InputError for all else, for another language, and for names that are none there.

    >>> x, y = sp.symbols("x y", real=True)
    >>> print(code(sp.sqrt(x**2 + y**2), (x, y), name="far", about="In the unit of x and y."))
    function out = far(vector_1)
      % In the unit of x and y.
      x = vector_1(1); y = vector_1(2);
      out = sqrt(x.^2 + y.^2);
    end
    <BLANKLINE>
    """
    if not isinstance(language, str) or language not in PRINTERS:
        raise InputError(f"A formula is written in {', '.join(PRINTERS)}; {shortened(language)} was given.")
    if not isinstance(about, str) or "*/" in about:
        raise InputError(f"A comment is text without */; {shortened(about)} was given.")
    read_vectors, matrix, shape = read(expr, vectors)
    arguments, entries = _arguments(read_vectors, matrix.free_symbols)
    names = [name, "out", *entries, *(str(symbol) for vector in read_vectors for symbol in vector)]
    _check_names(names, language)
    steps, results = _steps(_guarded(_writable(matrix), GUARDED[language]), set(names))
    assigned = [_assigned(symbol, step, language) for step, symbol in steps.items()]
    printed = [_flat(PRINTERS[language].doprint(entry)) for entry in results]
    columns = len(printed) // shape[0] if len(shape) == 2 else len(printed)
    rows = [printed[i : i + columns] for i in range(0, len(printed), columns)]
    head = name, about.splitlines(), arguments
    text = WRITTEN[language](head, entries, assigned, rows, shape)
    guards = {f: inside for f, inside in GUARDED[language].items() if f"real_{f}(" in text}
    return text + "".join(GUARD[language].format(f=f, inside=inside) for f, inside in guards.items())


def _check_names(names: list[str], language: str) -> None:
    """InputError where one cannot be a name in this language, or stands for two things."""
    for one in names:
        if not (isinstance(one, str) and NAME.fullmatch(one)):
            raise InputError(
                f"{shortened(one)} cannot be a name: a letter, then letters a to z, digits and _, can."
            )
        if one in CALLED or one in PRINTERS[language].reserved_words:
            raise InputError(f"{one} cannot be a name in {language}, where it means something else.")
        if names.count(one) > 1:
            raise InputError(f"Two things would be called {one}.")


def _arguments(vectors: tuple, used: set[sp.Symbol]) -> tuple[dict[str, int], dict[str, dict[str, int]]]:
    """The arguments with their sizes; and of each that is an array, where in it the symbols are that are used."""
    arguments, entries = {}, {}
    for number, vector in enumerate(vectors, start=1):
        name = str(vector[0]) if len(vector) == 1 else ARGUMENTS.get(vector, f"vector_{number}")
        arguments[name] = len(vector)
        if len(vector) > 1:
            entries[name] = {str(symbol): i for i, symbol in enumerate(vector) if symbol in used}
    return arguments, entries


def _writable(matrix: sp.MatrixBase) -> sp.MatrixBase:
    """``matrix`` with large whole numbers as floats; InputError where it holds what is not written."""
    roots = {power for power in matrix.atoms(sp.Pow) if power.exp.is_Rational and power.exp.q == 2}
    may_be_nan = {root for root in roots if not root.base.is_nonnegative} | matrix.atoms(sp.acos, sp.asin)
    for part in matrix.atoms(sp.Function, sp.Pow, *CHOICES):
        fits = isinstance(part, WRITABLE) or (isinstance(part, sp.Pow) and (2 * part.exp).is_Integer)
        if not fits or (isinstance(part, CHOICES) and may_be_nan.intersection(sp.preorder_traversal(part))):
            raise InputError(f"{shortened(part)} cannot be written.")
    return matrix.xreplace({n: sp.Float(n) for n in matrix.atoms(sp.Integer) if abs(n) >= LARGEST})


def _guarded(matrix: sp.MatrixBase, guarded: dict[str, str]) -> sp.MatrixBase:
    """``matrix`` with functions that may leave their domain under the names of their guards."""
    guards = {f: sp.Function(f"real_{f}", real=True) for f in guarded}
    for function, f in FUNCTIONS.items():
        if f in guards:
            matrix = matrix.replace(function, guards[f])
    if "sqrt" not in guards:
        return matrix
    return matrix.replace(
        lambda e: e.is_Pow and e.exp.is_Rational and e.exp.q == 2 and not e.base.is_nonnegative,
        lambda e: guards["sqrt"](e.base) ** (2 * e.exp),
    )


def _steps(matrix: sp.MatrixBase, taken: set[str]) -> tuple[dict[sp.Expr, sp.Symbol], list[sp.Expr]]:
    """What occurs more than once, and each choice, as steps under new names; and the entries in these."""
    new = (sp.Symbol(f"x{i}", real=True) for i in count() if f"x{i}" not in taken)
    shared, entries = sp.cse(list(matrix), sp.numbered_symbols("shared_", real=True))
    known: dict[sp.Basic, sp.Basic] = {}
    steps: dict[sp.Expr, sp.Symbol] = {}

    def step(expr: sp.Expr) -> sp.Symbol:
        return steps.get(expr) or steps.setdefault(expr, next(new))

    def in_steps(expr: sp.Expr) -> sp.Expr:
        for part in sp.postorder_traversal(expr):
            if isinstance(part, sp.Piecewise) and part not in known:
                known[part] = step(sp.Piecewise(*part.xreplace(known).args, (sp.nan, True), evaluate=False))
        return expr.xreplace(known)

    for symbol, expr in shared:
        found = in_steps(expr)
        plain = not found.free_symbols or found.is_Symbol or (-found).is_Symbol
        known[symbol] = found if plain else step(found)
    return steps, [in_steps(entry) for entry in entries]


def _assigned(symbol: sp.Symbol, expr: sp.Expr, language: str) -> str:
    printer = PRINTERS[language]
    if language == "matlab":
        return _flat(printer.doprint(expr, symbol))
    return f"{symbol} = {_flat(printer.doprint(expr))}"


def _flat(text: str) -> str:
    return " ".join(text.split()).replace("( ", "(").replace(" )", ")")


def _in_fives(statements: list[str]) -> list[list[str]]:
    return [statements[i : i + 5] for i in range(0, len(statements), 5)]


def _matlab(head: tuple, entries: dict, steps: list[str], rows: list[list[str]], shape: tuple[int, ...]) -> str:
    name, about, arguments = head
    unpacked = [
        " ".join(group)
        for argument, of in entries.items()
        for group in _in_fives([f"{x} = {argument}({i + 1});" for x, i in of.items()])
    ]
    values = ";\n         ".join(map(", ".join, rows))
    values = f"[{values}]" if shape else values
    lines = [*(f"% {line}" for line in about), *unpacked, *steps, f"out = {values};"]
    return f"function out = {name}({', '.join(arguments)})\n  " + "\n  ".join(lines) + "\nend\n"


def _python(head: tuple, entries: dict, steps: list[str], rows: list[list[str]], shape: tuple[int, ...]) -> str:
    name, about, arguments = head
    unpacked = [
        "; ".join(f"{x} = {argument}[{i}]" for x, i in of.items()) for argument, of in entries.items() if of
    ]
    lists = [f"[{', '.join(row)}]" for row in rows] if shape else rows[0]
    value = lists[0] if len(shape) < 2 else "[\n        " + ",\n        ".join(lists) + ",\n    ]"
    lines = [*(f"# {line}" for line in about), *unpacked, *steps, f"return {value}"]
    return f"import math\n\n\ndef {name}({', '.join(arguments)}):\n    " + "\n    ".join(lines) + "\n"


def _c(head: tuple, entries: dict, steps: list[str], rows: list[list[str]], shape: tuple[int, ...]) -> str:
    name, about, arguments = head
    declared = [f"const double {one}[{n}]" if one in entries else f"double {one}" for one, n in arguments.items()]
    if shape:
        declared.append("double out" + "".join(f"[{n}]" for n in shape))
    unpacked = [
        ", ".join(f"{x} = {argument}[{i}]" for x, i in of.items()) for argument, of in entries.items() if of
    ]
    lines = [*(f"/* {line} */" for line in about), *(f"const double {step};" for step in [*unpacked, *steps])]
    if not shape:
        lines.append(f"return {rows[0][0]};")
    for i, row in enumerate(rows if shape else []):
        place = f"out[{i}]" if len(shape) == 2 else "out"
        lines.append(" ".join(f"{place}[{j}] = {value};" for j, value in enumerate(row)))
    first = f"{'void' if shape else 'double'} {name}({', '.join(declared)})"
    return f"#include <math.h>\n\n{first}\n{{\n    " + "\n    ".join(lines) + "\n}\n"


WRITTEN = {"matlab": _matlab, "python": _python, "c": _c}
