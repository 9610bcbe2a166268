"""One exercise: reading an answer in any of its forms, and judging it from the plainest fault to the subtlest."""

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from ... import reading
from ...errors import InputError

# Answers rounded to four decimals count as right.
TOLERANCE = 1e-4


class UnreadableAnswerError(Exception):
    """An answer of the wrong kind or shape; holds the sentence that says so."""


@dataclass(frozen=True)
class Exercise:
    """An exercise and what can be said about an answer to it.

    read : turns an answer of any accepted form into one form; raises UnreadableAnswerError
    right : whether that is a right answer
    misconceptions : pairs of a test of an answer that is not right, and what to tell its author
    describe : what to tell where none of them is recognised: which part is off, and by how much
    hints, explanation, code : the way there; ``code`` sets the answer, as its last line
    """

    read: Callable[[object], Any]
    right: Callable[[Any], bool]
    misconceptions: tuple[tuple[Callable[[Any], bool], str], ...]
    describe: Callable[[Any], str]
    hints: tuple[str, ...]
    explanation: str
    code: str

    def judge(self, answer: object) -> str:
        """One sentence about ``answer``."""
        if answer is ... or answer is None:
            return "not attempted yet; put your answer in place of the dots."
        try:
            value = self.read(answer)
        except UnreadableAnswerError as fault:
            return str(fault)
        with warnings.catch_warnings(action="ignore"):  # of degrees, which it says itself
            if self.right(value):
                return "correct."
            recognised = (sentence for test, sentence in self.misconceptions if test(value))
            return f"not yet: {next(recognised, None) or self.describe(value)}"


def numbers(shape: tuple[int, ...]) -> Callable[[object], np.ndarray]:
    """Read lists, arrays and SymPy matrices of real numbers as an array of ``shape``."""

    def read(answer: object) -> np.ndarray:
        try:
            value = np.asarray(answer)
            if value.dtype.kind in "OUS":  # SymPy's numbers; or text, which would be read as one
                entries = [complex(entry) for entry in reading.formulas(value.tolist())]
                value = np.reshape(entries, value.shape)
            value = value.astype(complex)
        except (TypeError, ValueError, OverflowError):
            raise UnreadableAnswerError(
                "numbers are expected; no symbols, words or dots may be left in."
            ) from None
        if value.shape not in (shape, (*shape, 1), (1, *shape)):
            wanted = f"{shape} is expected" if shape else "one number is expected"
            raise UnreadableAnswerError(f"shape {value.shape}, where {wanted}.")
        if not np.isfinite(value).all() or np.abs(value.imag).max() > 0:
            raise UnreadableAnswerError("every number is expected to be real and finite.")
        return value.real.reshape(shape)

    return read


def expressions(symbols: tuple[sp.Symbol, ...], size: int) -> Callable[[object], sp.Matrix]:
    """Read ``size`` expressions in ``symbols`` (known by their names), as a list, a row, a column or a pose."""
    by_name = {symbol.name: symbol for symbol in symbols}

    def read(answer: object) -> sp.Matrix:
        try:
            value = sp.Matrix(reading.formulas(answer))
            readable = not any(e.has(sp.I) or e.is_finite is False for e in value)
        except InputError:
            readable = False
        if not readable:
            raise UnreadableAnswerError(f"a list of {size} real expressions is expected; one entry is none.")
        value = value[:size, 3] if value.shape == (4, 4) else value
        if len(value) == size + 1 and value[size] == 1:
            value = value.reshape(size + 1, 1)[:size, :]
        if len(value) != size:
            raise UnreadableAnswerError(f"{len(value)} entries, where {size} are expected.")
        value = value.reshape(size, 1).subs({s: by_name.get(s.name, s) for s in value.free_symbols})
        if unknown := sorted(map(str, value.free_symbols - {*symbols})):
            raise UnreadableAnswerError(
                f"it holds {', '.join(unknown)}, which may not stand in the answer; use {', '.join(by_name)}."
            )
        return value

    return read
