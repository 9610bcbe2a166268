"""Motion of the arm: paths in task coordinates, time scalings, and the joint angles that follow them.

A *path* is geometry: task coordinates as a function of a parameter s from 0 to 1. A *time scaling* says when: s as
a function of tau = t/T, the share of the motion's duration T that has gone by. Both together are a trajectory.

    s, s_dot, s_ddot = motion.quintic(np.linspace(0, 1, 200))
    followed = motion.follow(path(s))
    T = motion.duration(followed.q, speed_limits, acceleration_limits)

Metres and radians; joint angles and task coordinates are those of ``arm``, and are not wrapped.
"""

from ._detour import detour
from ._following import Followed, follow
from ._paths import Path, joined, line, space_line
from ._timing import cubic, duration, from_stretch, quintic, to_stretch, trapezoidal
