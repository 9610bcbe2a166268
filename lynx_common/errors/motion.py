"""Motions that cannot be made."""

from collections.abc import Sequence
from math import degrees

from .general import LynxError, in_degrees


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


class NotFreeError(LynxError):
    """A posture, ``q`` in radians, that a planner was told is not free."""

    def __init__(self, q: Sequence[float]):
        self.q = q
        super().__init__(f"The posture ({in_degrees(q)}) deg is not free.")


class NoPathError(LynxError):
    """No path within the budget; the nearest of the ``postures`` reached is ``distance`` radians from the goal."""

    def __init__(self, iterations: int, postures: int, distance: float):
        self.iterations, self.postures, self.distance = iterations, postures, distance
        super().__init__(
            f"No path was found in {iterations} iteration{'s' * (iterations > 1)}: "
            f"of the {postures} posture{'s' * (postures > 1)} reached, the nearest to the goal is "
            f"{degrees(distance):.2f} deg away from it. A larger budget may find one."
        )
