"""RRT*: a tree of postures that grows from the start, and whose paths get shorter."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from ..errors import EndpointError, InputError, JointLimitError, NoPathError, NotFreeError
from ..reading import finite, number, whole
from ._paths import LARGEST_BUDGET, Free, asked, fine_enough, lines_free
from ._tree import GOAL, START, Tree

AT_LIMIT = 1e-9  # room for rounding where a start or a goal stands exactly at a limit, as in ``arm``
GOAL_SHARE = 0.05  # of the postures drawn, until there is a path
DRAWS = 16  # postures drawn at a time, of which the first that is free and within the limits is taken

AreFree = Callable[[np.ndarray, np.ndarray], np.ndarray]  # whether lines from a to b are: ``lines_free``


@dataclass(frozen=True)
class Plan:
    """What ``plan`` found.

    path : (n, m), its corners, from start to goal.
    cost : its joint travel.
    history : (iterations,), the joint travel of the best path after each iteration; infinite before the first.
    tree : all that was searched.
    """

    path: np.ndarray
    cost: float
    history: np.ndarray
    tree: Tree


def plan(
    free: Free,
    limits: ArrayLike,
    start: ArrayLike,
    goal: ArrayLike,
    iterations: int = 2000,
    seed: int = 0,
    step: float = 0.5,
    resolution: float = 0.05,
) -> Plan:
    """A path of little joint travel from start to goal, by RRT*.

    Each iteration draws a free posture at random and goes from the nearest of the tree towards it, by ``step`` at
    most. What it reaches it joins to that one of the nearest k > 2^(m + 1) e (1 + 1/m) log n from which the travel
    is least, and leads others of these through it, and to the goal, where that is shorter. Once there is a path,
    postures are drawn only from the ellipsoid of those that may lie on a better one. Where the straight line from
    start to goal is free it is the path, and nothing is searched.

    Parameters
    ----------
    free : callable, (k, m) to (k,) of bool
    limits : array, shape (m, 2)
        Lower and upper limit of each joint.
    start, goal : arrays, shape (m,)
    iterations : int
        The budget. All of it is used, and equal input gives equal output.
    step, resolution : floats
        In the units of q.

    Returns
    -------
    plan : Plan
        Raises EndpointError where the start or the goal is outside its limits (cause: JointLimitError) or not free
        (NotFreeError); NoPathError where no path was found; InputError where a number or a shape is not as above.

    Source: Karaman and Frazzoli 2011, k-nearest RRT*; the ellipsoid: Gammell, Srinivasa and Barfoot 2014.

    >>> outside_disc = lambda q: np.linalg.norm(q, axis=1) >= 0.4
    >>> plan(outside_disc, [[-1, 1], [-1, 1]], [-0.8, 0], [0.8, 0]).path[[0, -1]]
    array([[-0.8,  0. ],
           [ 0.8,  0. ]])
    """
    limits = _limits(limits)
    start, goal = (_endpoint(q, name, limits, free) for q, name in ((start, "start"), (goal, "goal")))
    iterations, step = whole(iterations, "number of iterations", 1, LARGEST_BUDGET), number(step, "step", above=0)
    resolution = fine_enough(resolution, float(np.linalg.norm(np.diff(limits))))
    are_free = partial(lines_free, free, resolution=resolution)
    tree, rng, history = Tree(start, goal, iterations + 2), np.random.default_rng(seed), np.empty(iterations)
    if are_free(start[None], goal)[0]:
        history[:] = np.linalg.norm(goal - start)
        tree.attach(GOAL, START, history[0])
        iterations = 0
    for i in range(iterations):
        _grow(tree, are_free, _draw(tree, free, limits, rng), step)
        history[i] = tree.cost[GOAL]
    tree.trim()
    reached = np.isfinite(tree.cost)
    if not reached[GOAL]:
        left = float(np.linalg.norm(tree.q[reached] - goal, axis=1).min())
        raise NoPathError(iterations, int(reached.sum()), left)
    return Plan(tree.to_goal(), float(tree.cost[GOAL]), history, tree)


def _limits(limits: ArrayLike) -> np.ndarray:
    limits = finite(limits, "limits, a lower and an upper one a joint", None, 2)
    if not limits.size or (limits[:, 0] >= limits[:, 1]).any():
        raise InputError(f"A joint's lower limit must be below its upper one; {limits.tolist()} was given.")
    return limits


def _endpoint(q: ArrayLike, name: str, limits: np.ndarray, free: Free) -> np.ndarray:
    """The start or the goal, (m,): within the limits, and free."""
    q = finite(q, f"the {name}", len(limits))
    for joint in np.flatnonzero((q < limits[:, 0] - AT_LIMIT) | (q > limits[:, 1] + AT_LIMIT)):
        raise EndpointError(name, JointLimitError(int(joint) + 1, float(q[joint]), *map(float, limits[joint])))
    if not asked(free, q[None].copy())[0]:  # a copy: it may write into what it is given
        raise EndpointError(name, NotFreeError(q.tolist()))
    return q


def _draw(tree: Tree, free: Free, limits: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """A free posture within limits: any, or the goal, or one that may lie on a path better than the best."""
    (low, high), best = limits.T, tree.cost[GOAL]
    if np.isinf(best) and rng.random() < GOAL_SHARE:
        return tree.q[GOAL]
    drawn = rng.uniform(low, high, (DRAWS, len(limits)))
    if np.isfinite(best):
        inside = _in_ellipsoid(tree.q[START], tree.q[GOAL], best, rng)
        within = ((inside >= low) & (inside <= high)).all(axis=1)
        drawn = inside[within] if within.any() else drawn
    return drawn[asked(free, drawn.copy()).argmax()]  # where none is free the first, to which no line is free


def _in_ellipsoid(start: np.ndarray, goal: np.ndarray, travel: float, rng: np.random.Generator) -> np.ndarray:
    """DRAWS postures, spread evenly over those through which a path from start to goal may have this travel."""
    m, apart = len(start), np.linalg.norm(goal - start)
    # Evenly over the unit ball: any direction, and a radius whose m-th power is even.
    direction, radius = rng.normal(size=(DRAWS, m)), rng.random(DRAWS) ** (1 / m)
    ball = direction * (radius / np.linalg.norm(direction, axis=1))[:, None]
    # Stretched to the ellipsoid's half axes, the long one first.
    half_across = np.sqrt(np.maximum(travel**2 - apart**2, 0)) / 2
    ellipsoid = ball * np.append(travel / 2, np.full(m - 1, half_across))
    # Mirrored so that the first axis comes to point from start to goal.
    normal = np.eye(m)[0] - (goal - start) / apart
    if squared := normal @ normal:
        ellipsoid -= np.outer(ellipsoid @ normal, 2 / squared * normal)
    return (start + goal) / 2 + ellipsoid


def _grow(tree: Tree, are_free: AreFree, q: np.ndarray, step: float) -> None:
    """Add the posture ``q``, or the one a step towards it, where it can be reached and may help."""
    near, distance = tree.near(q)
    if (far := distance.min()) > step:
        nearest = tree.q[near[distance.argmin()]]
        q = nearest + step / far * (q - nearest)
        near, distance = tree.near(q)
    travel, to_goal = tree.cost[near] + distance, np.linalg.norm(tree.q[GOAL] - q)
    best_first = np.argsort(travel, kind="stable")
    best_first = best_first[travel[best_first] + to_goal < tree.cost[GOAL]]  # no other leads to a better path
    for parents in (best_first[:1], best_first[1:]):  # mostly the line from the best is free: it is asked alone
        reached = are_free(tree.q[near[parents]], q)
        if reached.any():
            parent = parents[reached.argmax()]
            new = tree.add(q, near[parent], distance[parent])
            _rewire(tree, are_free, new, near, distance)
            return


def _rewire(tree: Tree, are_free: AreFree, new: int, near: np.ndarray, distance: np.ndarray) -> None:
    """Lead to the postures near by, and to the goal, through the new one where that is shorter and free."""
    near = np.append(near, GOAL)
    distance = np.append(distance, np.linalg.norm(tree.q[GOAL] - tree.q[new]))
    travel = tree.cost[new] + distance
    onward = np.linalg.norm(tree.q[GOAL] - tree.q[near], axis=1)
    shorter = (travel < tree.cost[near]) & (travel + onward < tree.cost[GOAL])
    near, distance = near[shorter], distance[shorter]
    reached = are_free(tree.q[new], tree.q[near])
    for node, edge in zip(near[reached], distance[reached], strict=True):
        if tree.cost[new] + edge < tree.cost[node]:  # still: one before it may have led here
            tree.attach(node, new, edge)
