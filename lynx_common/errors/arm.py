"""What the Lynxmotion arm cannot do."""

from math import degrees

from .general import LynxError


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
    """A pose whose gripper's axis does not lie in a vertical plane through the base axis; ``angle`` in radians."""

    def __init__(self, angle: float):
        self.angle = angle
        super().__init__(
            "Five joints cannot take this pose: the gripper's axis leaves the arm's plane by "
            f"{degrees(angle):.2f} deg."
        )
