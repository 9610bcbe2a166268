"""The answers to all exercises, in one table: `python -m lynx_common.course.classroom.key [NAMES]`.

NAMES is a file with one student's name a line. Without it the answers are those for the numbers that are printed.
"""

import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from .. import exercises
from ..execute import ROOT
from ..exercises import reader
from ..exercises.exercise import Exercise
from . import write_table

FILE = ROOT / "build" / "key.csv"


def names(file: str) -> list[str]:
    """The names in the file; the empty one if none is given. Raises OSError or ValueError."""
    if not file:
        return [""]
    lines = Path(file).read_text(encoding="utf-8-sig").splitlines()  # some editors write a mark before the first
    students = [line.strip() for line in lines if line.strip()]
    if not students or not all(map(reader.is_name, students)):
        raise ValueError("no names")
    return students


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


def main(file: str = "") -> None:
    try:
        students = names(file)
    except (OSError, ValueError):
        sys.exit(
            f"'{file}' is no text file with one name a line, of at most {reader.LONGEST} characters that can be "
            "printed. Name one, as in: make key NAMES=names.txt"
        )
    write_table(FILE, [("student", "exercise", "numbers", "answer"), *rows(students)])
    print(f"The key is in {FILE}")


if __name__ == "__main__":
    main(*sys.argv[1:2])
