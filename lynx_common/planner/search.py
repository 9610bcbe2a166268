"""RRT*: a tree of postures that grows from the start, and whose paths get shorter."""

from dataclasses import dataclass

import numpy as np

from ..errors import NoPathError
from .edges import Free, check_budget, check_lengths, edges_free, problem
from .tree import GOAL, START, Growing, Tree

GOAL_SHARE = 0.05  # of the postures drawn, until there is a path
DRAWS = 16  # postures drawn at a time from the ellipsoid, of which the first within the limits is taken


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
    limits: np.ndarray,
    start: np.ndarray,
    goal: np.ndarray,
    iterations: int = 2000,
    seed: int = 0,
    step: float = 0.5,
    resolution: float = 0.05,
) -> Plan:
    """A path of little joint travel from start to goal, by RRT*.

    Each iteration draws a posture at random and goes from the nearest of the tree towards it, by ``step`` at most.
    What it reaches it joins to that one of the nearest k > e (1 + 1/m) log n from which the travel is least, and
    leads others of these through it, and to the goal, where that is shorter. Once there is a path, postures are
    drawn only from the ellipsoid of those that may lie on a better one. Where the straight line from start to
    goal is free it is the path, and nothing is searched.

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
        (NotFreeError); NoPathError where no path was found; InputError for what makes no problem.

    Source: Karaman and Frazzoli 2011, k-nearest RRT*; the ellipsoid: Gammell, Srinivasa and Barfoot 2014.
    """
    limits, start, goal = problem(free, limits, start, goal)
    check_budget("iterations", iterations)
    check_lengths(float(np.linalg.norm(np.diff(limits))), step=step, resolution=resolution)
    tree, rng, history = Growing(start, goal, iterations + 2), np.random.default_rng(seed), np.empty(iterations)
    if edges_free(free, start[None], goal[None], resolution)[0]:
        history[:] = np.linalg.norm(goal - start)
        tree.attach(GOAL, START, history[0])
        iterations = 0
    for i in range(iterations):
        _grow(tree, free, _draw(tree, limits, rng), step, resolution)
        history[i] = tree.cost[GOAL]
    if np.isinf(tree.cost[GOAL]):
        raise NoPathError(iterations, tree.size - 1, tree.distance_left())
    return Plan(tree.path(), float(tree.cost[GOAL]), history, tree.frozen())


def _draw(tree: Growing, limits: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """A posture within limits: any, or the goal, or one that may lie on a path better than the best."""
    best, (start, goal) = tree.cost[GOAL], tree.q[[START, GOAL]]
    if np.isinf(best):
        return goal if rng.random() < GOAL_SHARE else rng.uniform(*limits.T)
    # The ellipsoid with foci start and goal: a ball, stretched along the first axis, mirrored into place.
    m, apart = len(start), np.linalg.norm(goal - start)
    ball = rng.normal(size=(DRAWS, m))
    ball *= (rng.random(DRAWS) ** (1 / m) / np.linalg.norm(ball, axis=1))[:, None]
    ball *= np.append(best, np.full(m - 1, np.sqrt(max(0.0, best**2 - apart**2)))) / 2
    mirror = np.eye(m)[0] - (goal - start) / apart
    if size := mirror @ mirror:
        ball -= np.outer(ball @ mirror, 2 / size * mirror)
    drawn = (start + goal) / 2 + ball
    inside = ((drawn >= limits[:, 0]) & (drawn <= limits[:, 1])).all(axis=1)
    return drawn[inside.argmax()] if inside.any() else rng.uniform(*limits.T)


def _grow(tree: Growing, free: Free, q: np.ndarray, step: float, resolution: float) -> None:
    """Add the posture ``q``, or the one a step towards it, where it can be reached and may help."""
    near, distance = tree.near(q)
    if (far := distance.min()) > step:
        from_ = tree.q[near[distance.argmin()]]
        q = from_ + step / far * (q - from_)
        near, distance = tree.near(q)
    total = tree.cost[near] + distance
    if total.min() + np.linalg.norm(tree.q[GOAL] - q) >= tree.cost[GOAL]:
        return  # it cannot be on a better path
    order = np.argsort(total, kind="stable")
    for some in (order[:1], order[1:]):  # mostly the first will do
        reached = edges_free(free, tree.q[near[some]], np.broadcast_to(q, (len(some), len(q))), resolution)
        if reached.any():
            parent = some[reached.argmax()]
            _rewire(tree, free, tree.add(q, near[parent], distance[parent]), near, distance, resolution)
            return


def _rewire(
    tree: Growing, free: Free, new: int, near: np.ndarray, distance: np.ndarray, resolution: float
) -> None:
    """Lead to the postures near by, and to the goal, through the new one where that is shorter and free."""
    near = np.append(near, GOAL)
    distance = np.append(distance, np.linalg.norm(tree.q[GOAL] - tree.q[new]))
    better = tree.cost[new] + distance < tree.cost[near]
    near, distance = near[better], distance[better]
    reached = edges_free(
        free, np.broadcast_to(tree.q[new], (len(near), tree.q.shape[1])), tree.q[near], resolution
    )
    for node, edge in zip(near[reached], distance[reached], strict=True):
        if tree.cost[new] + edge < tree.cost[node]:  # still: one before it may have led here
            tree.attach(node, new, edge)
