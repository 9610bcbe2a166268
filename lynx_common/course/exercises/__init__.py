"""The exercises of the notebooks: immediate, specific feedback, hints, worked solutions.

    exercises.check("A1.1", answer)     says whether ``answer`` is right, and if not, what is wrong with it first
    exercises.hint("A1.1")              a hint; ``exercises.hint("A1.1", 2)`` the next
    exercises.solution("A1.1")          the way there, and code that gets there

None of them raises, whatever it is given, so that a notebook with open exercises runs to its end.
"""

import functools
from collections.abc import Callable
from importlib import import_module

from IPython.display import Markdown

from ...errors import UnknownNameError
from .exercise import Exercise

MODULES = ("a1", "a2", "a3", "b1", "b2", "b3", "part2", "part3")


def check(name: str, answer: object = ...) -> None:
    """Print whether ``answer`` is right for exercise ``name``, or the first thing that is wrong with it."""
    _say(name, lambda key, exercise: f"{key}: {exercise.judge(answer)}")


def hint(name: str, number: int = 1) -> None:
    """Print hint ``number`` (from 1) of exercise ``name``."""

    def said(key: str, exercise: Exercise) -> str:
        count = len(exercise.hints)
        if not isinstance(number, int) or not 1 <= number <= count:
            return f'{key} has hints 1 to {count}; beyond them there is exercises.solution("{key}").'
        more = f' (More: exercises.hint("{key}", {number + 1}))' if number < count else ""
        return f"{key}, hint {number} of {count}: {exercise.hints[number - 1]}{more}"

    _say(name, said)


def solution(name: str) -> Markdown:
    """The worked solution of exercise ``name``: why, and code that sets the answer."""
    try:
        exercise = find(name)
    except UnknownNameError as fault:
        return Markdown(str(fault))
    return Markdown(f"{exercise.explanation}\n\n```python\n{exercise.code}\n```")


def find(name: str) -> Exercise:
    """The exercise of this name; small letters will do. Raises UnknownNameError."""
    if not isinstance(name, str):
        raise UnknownNameError("exercise with a name of type", type(name).__name__, list(catalogue()))
    # What is right and wrong is computed on import, which takes time; so a notebook imports its own only.
    notebook = _key(name).partition(".")[0].lower().replace("p", "part")
    known = _of(notebook) if notebook in MODULES else {}
    if _key(name) not in known:
        raise UnknownNameError("exercise", name[:20], list(catalogue()))
    return known[_key(name)]


@functools.cache
def catalogue() -> dict[str, Exercise]:
    """Every exercise of the course, by name."""
    return {name: exercise for module in MODULES for name, exercise in _of(module).items()}


def _of(module: str) -> dict[str, Exercise]:
    return import_module(f".{module}", __package__).EXERCISES


def _key(name: str) -> str:
    return name.strip().upper()


def _say(name: str, said: Callable[[str, Exercise], str]) -> None:
    try:
        exercise = find(name)
    except UnknownNameError as fault:
        print(fault)
    else:
        print(said(_key(name), exercise))
