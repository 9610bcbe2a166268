"""What any part of the package can refuse."""

from collections.abc import Iterable
from difflib import get_close_matches
from math import degrees

MANY = 30  # known names; of more, only the nearest are said


def in_degrees(angles: Iterable[float]) -> str:
    """Angles in radians as text, in degrees to two decimals."""
    return ", ".join(f"{degrees(angle):.2f}" for angle in angles)


class LynxError(Exception):
    """Base class of the errors that this package raises on purpose."""


class InputError(LynxError, ValueError):
    """What cannot be meant: complex numbers, a wrong shape, a step of zero; the sentence says what is expected."""


class GeometryError(LynxError, ValueError):
    """Lengths that no robot can have."""

    def __init__(self, name: str, value: object, allowed: str):
        self.name, self.value, self.allowed = name, value, allowed
        super().__init__(f"Geometry: {name} is {value}; {allowed}.")


class ScrewError(LynxError, ValueError):
    """A screw that is no unit screw, or none at all; ``length`` is that of its axis."""

    def __init__(self, expected: str, length: float):
        self.expected, self.length = expected, length
        super().__init__(f"{expected}; the one given has length {length:.6g}.")


class UnknownNameError(LynxError, KeyError):
    """A name that is not in the table it was looked up in."""

    def __init__(self, kind: str, name: object, known: list[str]):
        self.kind, self.name, self.known = kind, name, known
        few = len(known) <= MANY
        near = known if few else sorted(get_close_matches(str(name), known, 5, 0), key=known.index)
        there_is = "There is" if few else "Near it there is"
        super().__init__(f"There is no {kind} {name!r}. {there_is}: {', '.join(near)}.")

    def __str__(self) -> str:
        return self.args[0]  # KeyError would put the sentence in quotation marks


class LedgerError(LynxError):
    """A printed item whose recorded verdict is not the one that was found."""

    def __init__(self, key: str, recorded: str, found: str):
        self.key, self.recorded, self.found = key, recorded, found
        super().__init__(
            f"{key}: compared with what is printed, {found}; but the ledger says {recorded!r}. "
            "If you changed something above, undo it and run the notebook again from the top."
        )
