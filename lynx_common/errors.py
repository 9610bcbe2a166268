"""Errors that say what was given, what is allowed, and by how much it is missed.

Each takes the facts, keeps them as attributes and writes the sentence itself.
"""

from collections.abc import Sequence
from math import degrees


class LynxError(Exception):
    """Base class of the errors that this package raises on purpose."""


class InputError(LynxError, ValueError):
    """An array that cannot be meant: complex numbers, or a last axis of the wrong length."""


class GeometryError(LynxError, ValueError):
    """Lengths that no robot can have."""

    def __init__(self, name: str, value: object, allowed: str):
        self.name, self.value, self.allowed = name, value, allowed
        super().__init__(f"Geometry: {name} is {value}; {allowed}.")


class OutOfReachError(LynxError):
    """A target whose wrist position the links cannot reach; distances in metres from the shoulder."""

    def __init__(self, distance: float, nearest: float, farthest: float):
        self.distance, self.nearest, self.farthest = distance, nearest, farthest
        super().__init__(
            f"Target position is out of reach: its wrist would be {distance:.4f} m from the shoulder, "
            f"where the links reach from {nearest:.4f} m to {farthest:.4f} m."
        )


class JointLimitError(LynxError):
    """A posture with a joint outside its limits; ``joint`` counts from 1, angles in radians."""

    def __init__(self, joint: int, value: float, lower: float, upper: float):
        self.joint, self.value, self.limits = joint, value, (lower, upper)
        super().__init__(
            f"Joint {joint} would stand at {degrees(value):.2f} deg, outside its limits "
            f"of {degrees(lower):.0f} to {degrees(upper):.0f} deg."
        )


class NotAchievableError(LynxError):
    """A pose whose tool axis does not lie in a vertical plane through the base axis; ``angle`` in radians."""

    def __init__(self, angle: float):
        self.angle = angle
        super().__init__(
            f"Five joints cannot take this pose: its tool axis leaves the arm's plane by {degrees(angle):.2f} deg."
        )


class LedgerError(LynxError):
    """A printed item whose recorded verdict is not the one that was found."""

    def __init__(self, key: str, recorded: str, found: str):
        self.key, self.recorded, self.found = key, recorded, found
        super().__init__(
            f"{key}: compared with what is printed, {found}; but the ledger says {recorded!r}. "
            "If you changed something above, undo it and run the notebook again from the top."
        )


class UnknownNameError(LynxError, KeyError):
    """A name that is not in the table it was looked up in."""

    def __init__(self, kind: str, name: object, known: list[str]):
        self.kind, self.name, self.known = kind, name, known
        super().__init__(f"There is no {kind} {name!r}. There is: {', '.join(known)}.")

    def __str__(self) -> str:
        return self.args[0]  # KeyError would put the sentence in quotation marks


class JumpError(LynxError):
    """A joint that moves too far between two neighbouring samples; ``joint`` counts from 1, angles in radians."""

    def __init__(self, sample: int, joint: int, step: float, largest: float):
        self.sample, self.joint, self.step, self.largest = sample, joint, step, largest
        super().__init__(
            f"Between samples {sample - 1} and {sample} joint {joint} would move by {degrees(step):.2f} deg; "
            f"more than {degrees(largest):.0f} deg is a jump, or too few samples."
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
        super().__init__(
            f"It is {-distance:.4f} m deep in the obstacle."
            if distance < 0
            else f"It is {distance:.4f} m from the obstacle, where the margin asks for {margin:.4f} m."
        )


class EndpointError(LynxError):
    """A start or an end (``which``) that a motion cannot have; ``cause`` is the error that says why."""

    def __init__(self, which: str, cause: LynxError):
        self.which, self.cause = which, cause
        super().__init__(f"The {which} of the motion cannot be used. {cause}")


class AssemblyError(LynxError):
    """A pose that a leg cannot close; ``legs`` count from 1, ``distances`` in mm from base to platform joint."""

    def __init__(self, legs: list[int], distances: list[float], nearest: float, farthest: float):
        self.legs, self.distances, self.nearest, self.farthest = legs, distances, nearest, farthest
        ends = " and ".join(f"leg {leg} would span {d:.2f} mm" for leg, d in zip(legs, distances, strict=True))
        super().__init__(
            f"The robot cannot be assembled at this pose: {ends}, where a leg spans from {nearest:.2f} mm "
            f"to {farthest:.2f} mm."
        )


class NoPoseError(LynxError):
    """Motor angles, in radians, at which no pose of the platform closes the three legs."""

    def __init__(self, theta: list[float]):
        self.theta = theta
        angles = ", ".join(f"{degrees(angle):.2f}" for angle in theta)
        super().__init__(f"With the motors at {angles} deg there is no pose of the platform that all legs reach.")


class SelfMotionError(LynxError):
    """Motor angles, in radians, at which the platform can still move, so that they fix no pose."""

    def __init__(self, theta: list[float]):
        self.theta = theta
        angles = ", ".join(f"{degrees(angle):.2f}" for angle in theta)
        super().__init__(
            f"With the motors locked at {angles} deg the platform can still move: they do not fix its pose."
        )


class ScrewError(LynxError, ValueError):
    """A screw that is no unit screw, or none at all; ``length`` is that of its axis."""

    def __init__(self, expected: str, length: float):
        self.expected, self.length = expected, length
        super().__init__(f"{expected}; the one given has length {length:.6g}.")


class NotFreeError(LynxError):
    """A posture, ``q`` in radians, that a planner was told is not free."""

    def __init__(self, q: Sequence[float]):
        self.q = q
        angles = ", ".join(f"{degrees(angle):.2f}" for angle in q)
        super().__init__(f"The posture ({angles}) deg is not free.")


class NoPathError(LynxError):
    """No path within the budget; the nearest of the ``postures`` reached is ``distance`` radians from the goal."""

    def __init__(self, iterations: int, postures: int, distance: float):
        self.iterations, self.postures, self.distance = iterations, postures, distance
        super().__init__(
            f"No path was found in {iterations} iteration{'s' * (iterations > 1)}: "
            f"of the {postures} postures reached, the nearest to the goal is {degrees(distance):.2f} deg away "
            "from it. A larger budget may find one."
        )


class MarginError(LynxError):
    """A smallest singular value that is ``asked`` for where (``where``) no more than ``best`` is possible."""

    def __init__(self, asked: float, best: float, where: str):
        self.asked, self.best, self.where = asked, best, where
        super().__init__(
            f"A smallest singular value of {asked:.2f} cannot be kept: {where} allows {best:.2f} at most."
        )


class SingularError(LynxError):
    """A place too near to a singularity: its smallest singular ``value`` is below what is ``asked``, because of
    ``factors`` (their names); ``nearest`` is the nearest place (x, y, z) that keeps it."""

    def __init__(self, factors: Sequence[str], value: float, asked: float, nearest: Sequence[float]):
        self.factors, self.value, self.asked, self.nearest = tuple(factors), value, asked, tuple(nearest)
        place = ", ".join(f"{x:.2f}" for x in nearest)
        super().__init__(
            f"Too near to a singularity ({' and '.join(factors)}): smallest singular value {value:.2f}, where "
            f"{asked:.2f} is asked for. The nearest place that has it is ({place})."
        )
