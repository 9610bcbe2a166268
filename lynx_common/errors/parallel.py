"""What the 3-RRR robot cannot do."""

from .general import LynxError, in_degrees


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
        super().__init__(
            f"With the motors at {in_degrees(theta)} deg there is no pose of the platform that all legs reach."
        )


class SelfMotionError(LynxError):
    """Motor angles, in radians, at which the platform can still move, so that they fix no pose."""

    def __init__(self, theta: list[float]):
        self.theta = theta
        super().__init__(
            f"With the motors locked at {in_degrees(theta)} deg the platform can still move: "
            "they do not fix its pose."
        )
