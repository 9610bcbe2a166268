"""Paths through what is free: RRT* in joint space, and shortcuts. Knows no robot and no obstacle.

What is free is said by a function: ``free(q)`` takes postures (k, m) and gives (k,) of bool. The *joint travel* of
a path is the sum of the Euclidean lengths of its straight pieces, in radians where all joints turn. Pieces are
*checked*, at postures no farther apart than ``resolution``; for a proof there is ``certify.along``.

    found = planner.plan(free, limits, start, goal, iterations=2000, seed=0)
    path = planner.shortcut(free, found.path)
"""

from ._paths import joint_travel, shortcut
from ._search import Plan, plan
from ._tree import Tree
