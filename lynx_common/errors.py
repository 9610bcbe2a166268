"""Errors that say what was given, what is allowed, and by how much it is missed.

Each but InputError takes the facts, keeps them as attributes and writes the sentence itself. Metres and radians;
the sentences tell angles in degrees.
"""

from collections.abc import Iterable
from difflib import get_close_matches
from math import degrees

ROUNDED = 1e-2  # radians: so much may come from printing few digits
MANY = 40  # where more names are known, only the nearest ones are listed


def told_apart(*values: float, decimals: int = 4) -> list[str]:
    """Numbers as text, to so many decimals, and to more where different ones would look the same, or like zero.

    >>> told_apart(0.4000001, 0.0, 0.4)
    ['0.4000001', '0.0000000', '0.4000000']
    """
    known = {0.0, *map(float, values)}
    while decimals < 17 and len({f"{value:z.{decimals}f}" for value in known}) < len(known):
        decimals += 1
    return [f"{value:z.{decimals}f}" for value in values]


def _short(number: str) -> str:
    """A limit, which is mostly a whole number, without the zeros at its end."""
    return number.rstrip("0").rstrip(".")


def _in_degrees(angles: Iterable[float]) -> str:
    """Angles in radians as text, in degrees to two decimals."""
    return ", ".join(f"{degrees(angle):z.2f}" for angle in angles)


class LynxError(Exception):
    """Base class of the errors that this package raises on purpose."""


class InputError(LynxError, ValueError):
    """What cannot be meant: complex numbers, a wrong shape, a step of zero; the sentence says what is expected."""


class GeometryError(LynxError, ValueError):
    """Lengths that no robot can have."""

    def __init__(self, name: str, value: object, allowed: str):
        self.name, self.value, self.allowed = name, value, allowed
        super().__init__(f"Geometry: {name} is {value}; {allowed}.")


class OutOfReachError(LynxError):
    """A target whose wrist position the links cannot reach; distances in metres from the shoulder."""

    def __init__(self, distance: float, nearest: float, farthest: float):
        self.distance, self.nearest, self.farthest = distance, nearest, farthest
        at, least, most = told_apart(distance, nearest, farthest)
        super().__init__(
            f"Target position is out of reach: its wrist would be {at} m from the shoulder, "
            f"where the links reach from {least} m to {most} m."
        )


class JointLimitError(LynxError):
    """A posture with a joint outside its limits; ``joint`` counts from 1, angles in radians."""

    def __init__(self, joint: int, value: float, lower: float, upper: float):
        self.joint, self.value, self.limits = joint, value, (lower, upper)
        at, least, most = told_apart(*map(degrees, (value, lower, upper)), decimals=2)
        super().__init__(
            f"Joint {joint} would stand at {at} deg, outside its limits of {_short(least)} to {_short(most)} deg."
        )


class NotAchievableError(LynxError):
    """A pose whose gripper's axis does not lie in a vertical plane through the base axis; ``angle`` in radians."""

    def __init__(self, angle: float):
        self.angle = angle
        (off,) = told_apart(degrees(angle), decimals=2)
        super().__init__(
            f"Five joints cannot take this pose: the gripper's axis leaves the arm's plane by {off} deg."
            + " If it was rounded, solve for its position and the pitch that is meant." * (abs(angle) < ROUNDED)
        )


class JumpError(LynxError):
    """A joint that moves too far between two neighbouring samples; ``joint`` counts from 1, angles in radians."""

    def __init__(self, sample: int, joint: int, step: float, largest: float):
        self.sample, self.joint, self.step, self.largest = sample, joint, step, largest
        by, most = told_apart(degrees(step), degrees(largest), decimals=2)
        super().__init__(
            f"Between samples {sample - 1} and {sample} joint {joint} would move by {by} deg; "
            f"more than {_short(most)} deg is a jump, or too few samples."
        )


class PathError(LynxError):
    """A path that the arm cannot follow; ``sample`` is the first that fails, ``cause`` the error that says why."""

    def __init__(self, sample: int, count: int, cause: LynxError):
        self.sample, self.count, self.cause = sample, count, cause
        super().__init__(f"The path fails first at sample {sample} of 0 to {count - 1}: {cause}")


class CollisionError(LynxError):
    """A place that is in an obstacle (distance below 0) or nearer to it than the margin; metres."""

    def __init__(self, distance: float, margin: float):
        self.distance, self.margin = distance, margin
        at, asked = told_apart(abs(distance), margin)
        super().__init__(
            f"It is {at} m deep in the obstacle."
            if distance < 0
            else f"It is {at} m from the obstacle, where the margin asks for {asked} m."
        )


class EndpointError(LynxError):
    """A start or an end (``which``) that a motion cannot have; ``cause`` is the error that says why."""

    def __init__(self, which: str, cause: LynxError):
        self.which, self.cause = which, cause
        super().__init__(f"The {which} of the motion cannot be used. {cause}")


class NotFreeError(LynxError):
    """A posture, ``q`` in radians, that a planner was told is not free."""

    def __init__(self, q: Iterable[float]):
        self.q = q
        super().__init__(f"The posture ({_in_degrees(q)}) deg is not free.")


class NoPathError(LynxError):
    """No path within the budget; the nearest of the ``postures`` reached is ``distance`` radians from the goal."""

    def __init__(self, iterations: int, postures: int, distance: float):
        self.iterations, self.postures, self.distance = iterations, postures, distance
        (away,) = told_apart(degrees(distance), decimals=2)
        super().__init__(
            f"No path was found in {iterations} iteration{'s' * (iterations > 1)}: of the {postures} "
            f"posture{'s' * (postures > 1)} reached, the nearest to the goal is {away} deg away from it. "
            "A larger budget may find one."
        )


class AssemblyError(LynxError):
    """A pose that a leg cannot close; ``legs`` count from 1, ``distances`` in mm from base to platform joint."""

    def __init__(self, legs: list[int], distances: list[float], nearest: float, farthest: float):
        self.legs, self.distances, self.nearest, self.farthest = legs, distances, nearest, farthest
        least, most, *spans = told_apart(nearest, farthest, *distances, decimals=2)
        ends = " and ".join(f"leg {leg} would span {span} mm" for leg, span in zip(legs, spans, strict=True))
        super().__init__(
            f"The robot cannot be assembled at this pose: {ends}, where a leg spans from {least} mm to {most} mm."
        )


class NoPoseError(LynxError):
    """Motor angles, in radians, at which no pose of the platform closes the three legs."""

    def __init__(self, theta: list[float]):
        self.theta = theta
        super().__init__(
            f"With the motors at {_in_degrees(theta)} deg there is no pose of the platform that all legs reach."
        )


class SelfMotionError(LynxError):
    """Motor angles, in radians, at which the platform can still move, so that they fix no pose."""

    def __init__(self, theta: list[float]):
        self.theta = theta
        super().__init__(
            f"With the motors locked at {_in_degrees(theta)} deg the platform can still move: "
            "they do not fix its pose."
        )


class ScrewError(LynxError, ValueError):
    """A screw that is no unit screw, or none at all; ``length`` is that of its axis."""

    def __init__(self, expected: str, length: float):
        self.expected, self.length = expected, length
        given, _ = told_apart(length, 1.0, decimals=6)
        super().__init__(f"{expected}; the one given has length {given}.")


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


class WrongAnswerError(LynxError, AssertionError):
    """An answer that is not the right one for exercise ``name``; ``said`` is what the reader is told about it."""

    def __init__(self, name: str, said: str):
        self.name, self.said = name, said
        super().__init__(f"{name}: {said}")
