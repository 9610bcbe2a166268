"""One printed item of the report, and when two statements of it differ."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from ... import reading
from ...errors import InputError
from ...symbolic import numeric, tidy

Facts = dict[str, object]  # fields of an item, all but its key and its place
KINDS = ("holds, if ", "wrong: ", "holds")  # the verdicts, the longer beginning first


@dataclass(frozen=True)
class Item:
    """A printed item, its place, and the verdict of this course.

    key : "eq. 1.1", "Table 1.3", "Fig. 1.2" or "claim A1.1"
    where : section and page of the report
    notebook : the notebook that checks it
    says : what it says, in the course's own words, for the tables of the ledger
    printed : an ``sp.Eq`` or ``sp.Matrix``, an array of numbers, or True for a claim
    verdict : "holds", "holds, if ..." or "wrong: ..." with what holds instead
    because : why what is printed cannot be as it stands; needed unless it holds
    meaning : what the symbols in ``printed`` stand for, where the report defines them elsewhere
    digits : decimals to which printed numbers are compared
    condition : substitution under which an item holds that does not hold in general; a claim has none
    right : what stands in place of an item that is wrong; a claim is simply not true
    """

    key: str
    where: str
    notebook: str
    says: str
    printed: sp.Basic | np.ndarray | bool
    verdict: str
    because: str = ""
    meaning: Mapping = field(default_factory=dict)
    digits: int | None = None
    condition: Mapping | None = None
    right: sp.Basic | np.ndarray | None = None

    def __post_init__(self) -> None:
        if not self.verdict.startswith(KINDS):
            raise ValueError(f"{self.key}: a verdict begins with one of {KINDS}, not {self.verdict!r}.")
        if self.kind != "holds" and not self.because:
            raise ValueError(f"{self.key}: an item that does not hold says why.")
        if self.printed is True:
            return
        if self.kind == "holds, if" and self.condition is None:
            raise ValueError(f"{self.key}: an item that holds under a condition states it as a substitution.")
        if self.kind == "wrong" and self.right is None:
            raise ValueError(f"{self.key}: a wrong item says what is right.")

    @property
    def kind(self) -> str:
        """The verdict without its explanation."""
        return next(kind for kind in KINDS if self.verdict.startswith(kind)).rstrip(" :")

    @property
    def value(self) -> sp.Basic | np.ndarray | bool:
        """What ``printed`` amounts to: the right side of an equation, with its symbols filled in."""
        if not isinstance(self.printed, sp.Basic | sp.MatrixBase):
            return self.printed
        side = self.printed.rhs if isinstance(self.printed, sp.Eq) else self.printed
        return side.subs(self.meaning).doit()


def formula(says: str, printed: sp.Basic, verdict: str = "holds", because: str = "", **more) -> Facts:
    """An equation or a table of symbols; ``more`` may be its meaning, condition or right."""
    return {"says": says, "printed": printed, "verdict": verdict, "because": because, **more}


def numbers(
    says: str, printed: ArrayLike, digits: int, verdict: str = "holds", because: str = "", **more
) -> Facts:
    """A table or a figure by its numbers, to so many ``digits``; ``more`` may be what is right."""
    return formula(says, np.asarray(printed), verdict, because, digits=digits, **more)


def claim(says: str, verdict: str = "holds", because: str = "") -> Facts:
    """A sentence that can be true or false."""
    return formula(says, True, verdict, because)


def equation(left: sp.Basic, right: sp.Basic) -> sp.Eq:
    """An equation as it is printed; SymPy does not ask whether it holds, which would take time."""
    return sp.Eq(left, right, evaluate=False)


def judged_otherwise(kind: str, found: object) -> str:
    """How a claim was ``found`` other than ``kind`` says, as a clause; empty where they agree.

    It is found true or not or, where it holds under a condition: whether as it stands, and under the condition.
    """
    truths = tuple(found) if isinstance(found, tuple) else (found,)
    if not all(isinstance(truth, bool | np.bool_ | sp.logic.boolalg.BooleanAtom) for truth in truths):
        raise InputError(f"A claim is checked by True or False, or by a pair of these, not by {found!r}.")
    expected = {"holds": (True,), "holds, if": (False, True), "wrong": (False,)}[kind]
    words = "it is " + ", and under a condition ".join(str(bool(truth)) for truth in truths)
    return "" if tuple(map(bool, truths)) == expected else words


def differs(printed: sp.Basic | np.ndarray, derived: Any, digits: int | None = None) -> str:
    """How ``derived`` differs from ``printed``, as a clause; empty where they agree."""
    if isinstance(printed, np.ndarray) and digits is not None:
        return _numbers_differ(printed, _numbers(derived), digits)
    return _expressions_differ(printed, derived)


def _numbers(derived: Any) -> np.ndarray:
    """As an array of real or complex numbers; InputError where it is neither."""
    array = np.asarray(derived)
    return array if array.dtype.kind in "iufc" else reading.real(derived, "what was derived")


def _numbers_differ(printed: np.ndarray, derived: np.ndarray, digits: int) -> str:
    if printed.shape != derived.shape:
        return f"the shape is {derived.shape}, not {printed.shape}"
    off = np.abs(derived.astype(complex) - printed).max()
    # Half a unit of the last digit printed; the hair on top is for decimals that binary cannot hold.
    return "" if off <= 0.5 * 10.0**-digits * (1 + 1e-6) else f"it is off by {off:.3g}"


def _expressions_differ(printed: sp.Basic, derived: sp.Basic) -> str:
    derived = derived.rhs if isinstance(derived, sp.Eq) else derived
    a, b = reading.formulas(printed), reading.formulas(derived, "What was derived")
    if a.shape != b.shape:
        return f"the shape is {b.shape}, not {a.shape}"
    different = [i for i, entry in enumerate(a - b) if not is_zero(entry)]
    return (
        f"entry {divmod(different[0], a.shape[1])} is {b[different[0]]}, not {a[different[0]]}"
        if different
        else ""
    )


@cache
def is_zero(expr: sp.Expr) -> bool:
    """Whether ``expr`` is identically zero: disproved by numbers where they suffice, else proven by SymPy."""
    if tidy(expr) == 0:
        return True
    symbols = sorted(expr.free_symbols, key=str)
    samples = np.random.default_rng(0).uniform(0.1, 1.0, (5, len(symbols)))
    if symbols and np.nanmax(np.abs(numeric(expr, symbols)(samples))) > 1e-9:
        return False
    return sp.simplify(expr) == 0
