"""One exercise: its right answer, what is commonly mistaken for it, and judging an answer.

An answer is judged to four significant digits, relative to its largest entry. Its author is told which kind of
slip it shows, or that it is nearly right; never by how much it is off, nor in which direction, which would give
the answer away.
"""

import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import permutations, product
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .answers import Form, UnreadableAnswerError

TOLERANCE = 5e-4  # half a unit of the fourth digit, where the first is 1
RIGHT = "correct."
NOT_ATTEMPTED = "not attempted yet; put your answer in place of the dots."
NEARLY = "nearly: three digits are right, and four are expected; keep more of them on the way."
MOST_TURNS = 1e6  # beyond, nothing is left of an angle's digits

# What a unit is mistaken for, with the factor from the one to the other.
UNITS = {
    "radians": {"degrees": 180 / np.pi},
    "degrees": {"radians": np.pi / 180},
    "metres": {"millimetres": 1e3, "centimetres": 1e2},
    "millimetres": {"metres": 1e-3, "centimetres": 1e-1},
    "cubic metres": {"litres": 1e3, "cubic millimetres": 1e9},
}


def to_four_digits(x: np.ndarray, known: np.ndarray) -> bool:
    """Whether ``x`` is ``known`` to four significant digits of its largest entry."""
    return bool(np.max(np.abs(x - known)) <= TOLERANCE * np.max(np.abs(known)))


def to_three_digits(x: np.ndarray, known: np.ndarray) -> bool:
    """Whether both are the same to four digits, or when rounded to three digits of the largest entry.

    The limits of this are round numbers, whatever the further digits of ``known`` are: trying does not tell them.
    """
    size = np.max(np.abs(known))
    unit = 10.0 ** (np.floor(np.log10(size)) - 2) if size else np.finfo(float).tiny
    return to_four_digits(x, known) or bool((np.round(x / unit) == np.round(known / unit)).all())


@dataclass(frozen=True, eq=False)
class Exercise:
    """An exercise and what can be said about an answer to it.

    form : how an answer is read
    right : a right answer, in any form that is read; ``also`` holds others that are as right
    misconceptions : pairs of a wrong answer, or of a test of an answer as read, and what to tell its author
    hints, explanation, code : the way there; ``code`` sets the answer, as its last line
    unit : that of every entry, or of each; a key of UNITS, or empty
    counts : what of an answer counts, such as the first four of five joint angles; the next two are about this
    period : by how much every entry, or each, may differ without a difference; 0 for not at all
    parts : what is judged by itself, relative to its own size, and told by itself: index by words such as "x is"
    choices : the only numbers that may be entries; told is only how many of them are wrong
    numbers : those that the task takes from the reader's name; empty for a task that takes none

    >>> Exercise(Form(()), 0.5, ((2, "this is its inverse."),), (), "", "").judge(2)
    'not yet: this is its inverse.'
    """

    form: Form
    right: object
    misconceptions: tuple[tuple[object | Callable[[np.ndarray], bool], str], ...]
    hints: tuple[str, ...]
    explanation: str
    code: str
    unit: ArrayLike = ""
    counts: Callable[[np.ndarray], np.ndarray] = np.asarray
    period: ArrayLike = 0.0
    parts: Mapping[str, Any] = field(default_factory=lambda: {"": ...})
    choices: tuple[float, ...] = ()
    also: tuple = ()
    numbers: tuple = ()

    def judge(self, answer: object) -> str:
        """What to say about ``answer``: RIGHT, or one sentence."""
        if answer is ... or answer is None:
            return NOT_ATTEMPTED
        try:
            x = self.form.read(answer)
        except UnreadableAnswerError as fault:
            return str(fault)
        return self.judge_read(x)

    def judge_read(self, x: np.ndarray) -> str:
        """What to say about an answer as ``form.read`` gave it."""
        with np.errstate(all="ignore"), warnings.catch_warnings(action="ignore"):  # degrees it names itself
            if self._is_right(x):
                return RIGHT
            said = self._choice(x) if self.choices else self._slip(x) or self._other_unit(x) or self._rest(x)
            return f"not yet: {said}"

    @cached_property
    def _right(self) -> list[np.ndarray]:
        return [self.form.read(answer) for answer in (self.right, *self.also)]

    @cached_property
    def _wrong(self) -> list[tuple[np.ndarray, str]]:
        return [(self.form.read(known), said) for known, said in self.misconceptions if not callable(known)]

    def _is_right(self, x: np.ndarray, agree: Callable = to_four_digits) -> bool:
        return any(all(self._agreement(x, right, agree)) for right in self._right)

    def _agreement(self, x: np.ndarray, known: np.ndarray, agree: Callable) -> Iterator[bool]:
        """Of every part, whether it is that of ``known``, up to periods."""
        known, away = self.counts(known), self.counts(x) - self.counts(known)
        turns = np.round(away / np.where(self.period, self.period, np.inf))
        away = away - self.period * np.where(np.abs(turns) < MOST_TURNS, turns, 0)
        return (agree(known[part] + away[part], known[part]) for part in self.parts.values())

    def _slip(self, x: np.ndarray) -> str | None:
        """What is recognised; nearly right comes before all but a misconception that gives just this answer."""
        patterns = (said for fits, said in self.misconceptions if callable(fits) and fits(x))
        return (
            self._named(x, to_four_digits)
            or (NEARLY if self._is_right(x, to_three_digits) else None)
            or self._named(x, to_three_digits)
            or next(patterns, None)
            or self._arrangement(x)
        )

    def _named(self, x: np.ndarray, agree: Callable) -> str | None:
        return next((said for known, said in self._wrong if all(self._agreement(x, known, agree))), None)

    def _arrangement(self, x: np.ndarray) -> str | None:
        """Whether the numbers are right, but for their signs or their order."""
        entries = np.atleast_1d(x).shape[-1]
        signs = np.array([*product((1, -1), repeat=entries)])
        if any(self._is_right((x * sign).reshape(x.shape)) for sign in signs):
            return "but for a sign this is right."
        if x.ndim and any(self._is_right(x[..., [*order]]) for order in permutations(range(entries))):
            return "the numbers are right, but not their order."
        return None

    def _other_unit(self, x: np.ndarray) -> str | None:
        unit = np.asarray(self.unit)
        for own in sorted({*unit.flat} & UNITS.keys()):
            for other, factor in UNITS[own].items():
                converted = np.where(unit == own, x / factor, x)
                slip = self._slip(converted)
                if self._is_right(converted) or slip == NEARLY:
                    return f"this is right in {other}; {own} are expected."
                if slip:
                    return f"this is in {other}, and {own} are expected. Besides, {slip}"
        return None

    def _rest(self, x: np.ndarray) -> str:
        agreed = dict(zip(self.parts, self._agreement(x, self._right[0], to_four_digits), strict=True))
        if any(agreed.values()):
            return ", ".join(f"{part} {'right' if fits else 'not right'}" for part, fits in agreed.items()) + "."
        return "this is not right, and it is none of the usual slips; a hint may help."

    def _choice(self, x: np.ndarray) -> str:
        for known, said in self.misconceptions:
            if known(x) if callable(known) else (x == self.form.read(known)).all():
                return said
        if not np.isin(x, self.choices).all():
            return f"each of the numbers is expected to be one of {', '.join(map(str, self.choices))}."
        wrong = (x != self._right[0]).sum()
        return f"{wrong} of the {x.size} numbers {'is' if wrong == 1 else 'are'} wrong."
