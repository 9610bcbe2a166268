"""The exercises of the notebooks: immediate, specific feedback, hints, worked solutions.

    exercises.student("Ada")            a name for this process; some exercises then have numbers of their own
    exercises.numbers("A1.3")           those numbers, or the ones that are printed
    exercises.check("A1.1", answer)     says whether ``answer`` is right, and if not, what is wrong with it first
    exercises.hint("A1.1")              a hint; ``exercises.hint("A1.1", 2)`` the next
    exercises.solution("A1.1")          the way there, and code that gets there
    exercises.progress()                what was tried and done under this name
    exercises.assert_right("A1.1", answer)    raises unless ``answer`` is right

But for ``numbers`` and ``assert_right`` none of them raises, whatever it is given, so that a notebook with open
exercises runs to its end.
"""

import functools
from collections.abc import Callable
from importlib import import_module
from numbers import Integral

from IPython.display import Markdown

from ...errors import InputError, UnknownNameError, WrongAnswerError
from . import reader
from .exercise import NOT_ATTEMPTED, RIGHT, Exercise

MODULES = ("a1", "a2", "a3", "b1", "b2", "b3", "part2", "part3")


def student(name: str = "") -> None:
    """Set the reader's name for this process. Empty: the printed numbers, and nothing is read or stored."""
    print(reader.student(name))


def numbers(name: str) -> tuple:
    """The numbers that the task of exercise ``name`` takes from the reader's name, as a named tuple."""
    if not (found := find(name).numbers):
        known = [key for key, exercise in catalogue().items() if exercise.numbers]
        raise UnknownNameError("exercise with numbers of your own called", _key(name), known)
    return found


def check(name: str, answer: object = ...) -> None:
    """Print whether ``answer`` is right for exercise ``name``, or the first thing that is wrong with it."""

    def said(key: str, exercise: Exercise) -> str:
        verdict = exercise.judge(answer)
        if verdict != NOT_ATTEMPTED:
            reader.note(key, done=verdict == RIGHT, tries=1)
        return f"{key}: {verdict}"

    _say(name, said)


def assert_right(name: str, answer: object) -> None:
    """Raise WrongAnswerError, with the sentence that ``check`` prints, unless ``answer`` is right."""
    if (said := find(name).judge(answer)) != RIGHT:
        raise WrongAnswerError(_key(name), said)


def hint(name: str, number: int = 1) -> None:
    """Print hint ``number`` (from 1) of exercise ``name``."""

    def said(key: str, exercise: Exercise) -> str:
        count = len(exercise.hints)
        if not isinstance(number, Integral) or isinstance(number, bool) or not 1 <= number <= count:
            return f'{key} has hints 1 to {count}; beyond them there is exercises.solution("{key}").'
        more = f' (More: exercises.hint("{key}", {number + 1}))' if number < count else ""
        reader.note(key, hint=int(number))
        return f"{key}, hint {number} of {count}: {exercise.hints[number - 1]}{more}"

    _say(name, said)


def solution(name: str) -> Markdown:
    """The worked solution of exercise ``name``: why, and code that sets the answer."""
    try:
        exercise = find(name)
    except UnknownNameError as fault:
        return Markdown(str(fault))
    return Markdown(f"{exercise.explanation}\n\n```python\n{exercise.code}\n```")


def progress() -> Markdown:
    """The reader's own state, of every exercise tried or looked up, as a table. It is told to nobody else."""
    if not reader.name:
        return Markdown('No name is set, so nothing is kept; `exercises.student("...")` at the top sets one.')
    known, sentence = reader.progress()
    rows = [
        f"| {key} | {'yes' if of['done'] else 'no'} | {of['tries']} | {of['hints']} |"
        for key in catalogue()
        if (of := known.get(key))
    ]
    table = "\n".join(["| exercise | done | tries | hints seen |", "|:--|:--|--:|--:|", *rows])
    return Markdown(f"{table}\n\n{sentence}".strip())


def find(name: str, student: str | None = None) -> Exercise:
    """The exercise of this name (small letters will do), with the numbers of a student.

    None is the reader of this process; an empty name stands for the numbers that are printed. Raises
    UnknownNameError, and InputError for a student whose name is no text.
    """
    if not isinstance(student, str | None):
        raise InputError(f"A student's name is text; an object of type {type(student).__name__:.40} was given.")
    if not isinstance(name, str):
        raise UnknownNameError("exercise with a name of type", type(name).__name__, list(catalogue()))
    # What is right and wrong is computed on import, which takes time; so a notebook imports its own only.
    notebook = _key(name).partition(".")[0].lower().replace("p", "part")
    known = _of(notebook) if notebook in MODULES else {}
    if _key(name) not in known:
        raise UnknownNameError("exercise", name[:20], list(catalogue()))
    return _made(_key(name), reader.name if student is None else reader.normalised(student))


@functools.cache
def catalogue() -> dict[str, Exercise]:
    """Every exercise of the course, by name, with the numbers that are printed."""
    return {name: _made(name, "") for module in MODULES for name in _of(module)}


@functools.lru_cache(100)
def _made(key: str, student: str) -> Exercise:
    entry = _of(key.partition(".")[0].lower().replace("p", "part"))[key]
    return entry.exercise(key, student) if isinstance(entry, reader.Own) else entry


def _of(module: str) -> dict[str, Exercise | reader.Own]:
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
