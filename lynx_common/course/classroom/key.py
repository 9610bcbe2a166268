"""The answers to all exercises, in one table: `python -m lynx_common.course.classroom.key [NAMES]`.

NAMES is a file with one student's name a line, or names with commas between them. Without it the answers are those
for the numbers that are printed.
"""

import csv
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from .. import exercises
from ..execute import ROOT
from ..exercises.exercise import Exercise

FILE = ROOT / "build" / "key.csv"


def names(given: str) -> list[str]:
    """The names in the file, or in the text, that is given; the empty one if none is."""
    path = Path(given)
    entries = path.read_text(encoding="utf-8").splitlines() if path.is_file() else given.split(",")
    return [name.strip() for name in entries if name.strip()] or [""]


def rows(students: list[str]) -> Iterator[tuple[str, str, str, str]]:
    """Student, exercise, the numbers that its task takes from the name, and the answer."""
    for student in students:
        for key in exercises.catalogue():
            exercise = exercises.find(key, student)
            yield student, key, numbers(exercise), " or ".join(map(str, right(exercise)))


def numbers(exercise: Exercise) -> str:
    own = exercise.numbers
    return ", ".join(f"{field} = {value}" for field, value in zip(getattr(own, "_fields", ()), own, strict=False))


def right(exercise: Exercise) -> list[object]:
    """The right answers: formulas as they are, numbers to six significant digits."""
    every = (exercise.right, *exercise.also)
    if exercise.form.samples:
        return [list(answer) for answer in every]
    return [_rounded(exercise.form.read(answer)).tolist() for answer in every]


def _rounded(x: np.ndarray) -> np.ndarray:
    """Each entry to six significant digits; what is rounding beside the largest entry becomes zero."""
    x = np.where(np.abs(x) > 1e-12 * np.abs(x).max(), x, 0.0)
    unit = 10.0 ** (np.floor(np.log10(np.abs(x), where=x != 0, out=np.zeros_like(x))) - 5)
    return np.round(np.round(x / unit) * unit, 15)


if __name__ == "__main__":
    FILE.parent.mkdir(exist_ok=True)
    with FILE.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([("student", "exercise", "numbers", "answer"), *rows(names(sys.argv[1]))])
    print(f"The key is in {FILE}")
