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
    size = np.abs(x).max()
    return np.round(x, 5 - int(np.floor(np.log10(size)))) + 0.0 if size else x


if __name__ == "__main__":
    FILE.parent.mkdir(exist_ok=True)
    with FILE.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([("student", "exercise", "numbers", "answer"), *rows(names(sys.argv[1]))])
    print(f"The key is in {FILE}")
