"""The reader: a name for this process, numbers drawn from it, and what was done under it, in one small file.

Without a name nothing is read or stored. The file lies in the kernel's working folder, beside the reader's work.
What is found there that was not written here is left as it is.
"""

import hashlib
import json
import os
import unicodedata
from collections import namedtuple
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from .exercise import Exercise

FILE = "exercises.json"
LONGEST, LARGEST = 80, 1_000_000  # characters of a name, bytes of the file
UNREAD = f"{FILE}, in this folder, was not written by this course; it is left as it is, and nothing is stored."
UNWRITTEN = f"{FILE} cannot be written in this folder, so this table is kept until the kernel stops."

name = ""  # of the reader, as normalised; empty for none
_record: dict[str, dict[str, dict]] = {}  # by name and by exercise; as far as it is known here


def normalised(given: str) -> str:
    """A name without what nobody means by it: capitals, and blanks around it.

    >>> normalised("  Ada  LOVELACE ")
    'ada lovelace'
    """
    return " ".join(unicodedata.normalize("NFKC", given).casefold().split())


def is_name(given: str) -> bool:
    """Whether exercises are made for this name; the empty one too."""
    return max(len(given), len(normalised(given))) <= LONGEST and normalised(given).isprintable()


def student(given: str = "") -> str:
    """Set the reader's name for this process; the line to say about it."""
    global name
    if not isinstance(given, str):
        return f"A name is expected, as text; an object of type {type(given).__name__:.40} was given."
    if not is_name(given):
        return f"A name is expected, of at most {LONGEST} characters that can be printed."
    name = normalised(given)
    if not name:
        return "No name: the exercises have the numbers that are printed, and nothing is stored."
    return f"{' '.join(given.split())}: some exercises have numbers of your own; progress is kept in {FILE}."


@dataclass(frozen=True)
class Own:
    """An exercise that takes numbers from the reader's name.

    make : the exercise for such numbers
    drawn : by the name of each number: as it is printed, the least and the largest, the step from one to the next

    >>> Own(None, {"L_1": (0.3, 0.2, 0.4, 0.01)}).numbers("A1.3", "")
    Numbers(L_1=0.3)
    """

    make: Callable[..., Exercise]
    drawn: Mapping[str, tuple[float, float, float, float]]

    def numbers(self, key: str, of: str) -> tuple:
        """The numbers for a reader's name, the same on every machine; those that are printed where it is empty."""
        digest = hashlib.sha256(f"{key} {of}".encode()).digest()
        words = [int.from_bytes(digest[i : i + 4]) for i in range(0, 4 * len(self.drawn), 4)]
        values = [
            round(least + step * (word % (round((largest - least) / step) + 1)), 6) if of else printed
            for word, (printed, least, largest, step) in zip(words, self.drawn.values(), strict=True)
        ]
        return namedtuple("Numbers", self.drawn)._make(values)  # type: ignore[misc, attr-defined]

    def exercise(self, key: str, of: str) -> Exercise:
        numbers = self.numbers(key, of)
        return replace(self.make(*numbers), numbers=numbers)


def note(key: str, done: bool = False, tries: int = 0, hint: int = 0) -> None:
    """Add to what is known of an exercise; what was done stays done, and needs no more tries."""
    if not name:
        return
    fault = _read()
    known = _record.setdefault(name, {}).setdefault(key, {"done": False, "tries": 0, "hints": 0})
    known["tries"] += 0 if known["done"] else tries
    known.update(done=known["done"] or done, hints=max(known["hints"], hint))
    if not fault:
        _write()


def progress() -> tuple[dict[str, dict], str]:
    """What is known of the reader's exercises, and a sentence about the file, if there is one to be said."""
    fault = _read()
    return _record.get(name, {}), fault or ("" if not _record.get(name) else _write())


def _read() -> str:
    """Take over what the file holds; a sentence if that cannot be."""
    path = Path(FILE)
    try:
        if not os.path.lexists(path):
            return ""
        if not path.is_file() or path.stat().st_size > LARGEST:
            return UNREAD
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return UNREAD
    if not _is_ours(found):
        return UNREAD
    for of, entries in found.items():
        for key, there in entries.items():
            here = _record.setdefault(of, {}).setdefault(key, dict(there))
            here.update({field: max(here[field], there[field]) for field in here})
    return ""


def _is_ours(found: object) -> bool:
    kinds = {"done": bool, "tries": int, "hints": int}
    return isinstance(found, dict) and all(
        isinstance(of, dict)
        and all(
            isinstance(entry, dict) and {field: type(value) for field, value in entry.items()} == kinds
            for entry in of.values()
        )
        for of in found.values()
    )


def _write() -> str:
    """Put the file in the place of the one there is, all at once; a sentence if that cannot be."""
    own = Path(f"{FILE}.{os.getpid()}")
    try:
        own.write_text(json.dumps(_record, indent=1) + "\n", encoding="utf-8")
        own.replace(FILE)
    except OSError:
        return UNWRITTEN
    return ""
