"""The exercises at the end of each notebook: immediate, specific feedback, hints, worked solutions.

    exercises.check("A1.1", answer)     says whether ``answer`` is right, and if not, what is wrong with it first
    exercises.hint("A1.1")              a hint; ``exercises.hint("A1.1", 2)`` the next
    exercises.solution("A1.1")          the way there, and code that gets there

None of them raises for a wrong answer, so that a notebook with open exercises runs to its end.
"""

from IPython.display import Markdown

from ...errors import UnknownNameError
from . import a1, a2, a3, b1, b2, b3, part2, part3
from .exercise import Exercise

NOTEBOOKS = (a1, a2, a3, b1, b2, b3, part2, part3)
EXERCISES: dict[str, Exercise] = {
    name: exercise for notebook in NOTEBOOKS for name, exercise in notebook.EXERCISES.items()
}


def check(name: str, answer: object) -> None:
    """Print whether ``answer`` is right for exercise ``name``, or the first thing that is wrong with it."""
    print(f"{name}: {_find(name).judge(answer)}")


def hint(name: str, number: int = 1) -> None:
    """Print hint ``number`` (from 1) of exercise ``name``."""
    hints = _find(name).hints
    if number not in range(1, len(hints) + 1):
        raise UnknownNameError(f"hint for {name} with number", number, [str(n + 1) for n in range(len(hints))])
    more = f' (More: exercises.hint("{name}", {number + 1}))' if number < len(hints) else ""
    print(f"{name}, hint {number} of {len(hints)}: {hints[number - 1]}{more}")


def solution(name: str) -> Markdown:
    """The worked solution of exercise ``name``: why, and code that sets the answer."""
    exercise = _find(name)
    return Markdown(f"{exercise.explanation}\n\n```python\n{exercise.code}\n```")


def _find(name: str) -> Exercise:
    if name not in EXERCISES:
        raise UnknownNameError("exercise", name, list(EXERCISES))
    return EXERCISES[name]
