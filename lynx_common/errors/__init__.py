"""Errors that say what was given, what is allowed, and by how much it is missed.

Each but InputError takes the facts, keeps them as attributes and writes the sentence itself.
"""

from .arm import JointLimitError, NotAchievableError, OutOfReachError
from .general import GeometryError, InputError, LedgerError, LynxError, ScrewError, UnknownNameError
from .motion import (
    CollisionError,
    EndpointError,
    JumpError,
    NoPathError,
    NotFreeError,
    PathError,
)
from .parallel import AssemblyError, NoPoseError, SelfMotionError

__all__ = [
    "AssemblyError",
    "CollisionError",
    "EndpointError",
    "GeometryError",
    "InputError",
    "JointLimitError",
    "JumpError",
    "LedgerError",
    "LynxError",
    "NoPathError",
    "NoPoseError",
    "NotAchievableError",
    "NotFreeError",
    "OutOfReachError",
    "PathError",
    "ScrewError",
    "SelfMotionError",
    "UnknownNameError",
]
