"""The exercises at the end of each notebook: immediate, specific feedback, hints, worked solutions.

    exercises.check("A1.1", answer)     says whether ``answer`` is right, and if not, what is wrong with it first
    exercises.hint("A1.1")              a hint; ``exercises.hint("A1.1", 2)`` the next
    exercises.solution("A1.1")          the way there, and code that gets there

None of them raises for a wrong answer, so that a notebook with open exercises runs to its end.
"""

import functools
from importlib import import_module

from IPython.display import Markdown

from ...errors import UnknownNameError
from .exercise import Exercise

MODULES = ("a1", "a2", "a3", "b1", "b2", "b3", "part2", "part3")


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


@functools.cache
def catalogue() -> dict[str, Exercise]:
    """Every exercise of the course, by name."""
    return {name: exercise for module in MODULES for name, exercise in _of(module).items()}


def _find(name: str) -> Exercise:
    # Right answers are computed on import, which takes time; so a notebook imports its own only.
    notebook = str(name).partition(".")[0].lower().replace("p", "part")
    known = _of(notebook) if notebook in MODULES else {}
    if name not in known:
        raise UnknownNameError("exercise", name, list(catalogue()))
    return known[name]


def _of(module: str) -> dict[str, Exercise]:
    return import_module(f".{module}", __package__).EXERCISES
