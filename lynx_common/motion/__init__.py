"""Motion of the arm: paths in task coordinates, time scalings, and the joint angles that follow them.

A *path* is geometry: task coordinates as a function of a parameter s from 0 to 1. A *time scaling* says when: s as
a function of tau = t/T, the share of the motion's duration T that has gone by. Both together are a trajectory.

    s, s_dot, s_ddot = motion.quintic(np.linspace(0, 1, 200))
    followed = motion.follow(path(s))
    T = motion.duration(followed.q, speed_limits, acceleration_limits)

Metres and radians; joint angles and task coordinates are those of ``arm``, and are not wrapped.
"""

from .detour import detour
from .following import Followed, follow
from .paths import Path, joined, line, space_line
from .timing import cubic, duration, from_stretch, quintic, to_stretch, trapezoidal

__all__ = [
    "Followed",
    "Path",
    "cubic",
    "detour",
    "duration",
    "follow",
    "from_stretch",
    "joined",
    "line",
    "quintic",
    "space_line",
    "to_stretch",
    "trapezoidal",
]
