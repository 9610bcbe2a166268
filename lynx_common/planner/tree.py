"""The tree that RRT* grows, in preallocated arrays."""

from dataclasses import dataclass

import numpy as np

START, GOAL = 0, 1  # their rows


@dataclass(frozen=True)
class Tree:
    """What was searched.

    q : (n, m), postures; start and goal are the first two.
    parent : (n,), the row of the one that each is reached from; -1 for the start.
    cost : (n,), the joint travel from the start to each.
    """

    q: np.ndarray
    parent: np.ndarray
    cost: np.ndarray


class Growing:
    """A tree that grows. The goal is in it from the beginning, at infinite cost until it is attached."""

    def __init__(self, start: np.ndarray, goal: np.ndarray, capacity: int):
        self.q, self.squared = np.empty((capacity, len(start))), np.full(capacity, np.inf)
        self.parent, self.cost, self.edge = np.full(capacity, -1), np.full(capacity, np.inf), np.zeros(capacity)
        self.children = [[], []]
        self.q[START], self.q[GOAL] = start, goal
        self.cost[START], self.squared[START], self.size = 0, start @ start, 2

    def add(self, q: np.ndarray, parent: int, edge: float) -> int:
        """A new posture, reached from ``parent`` by a line of length ``edge``; returns its row."""
        new, self.size = self.size, self.size + 1
        self.q[new] = q
        self.children.append([])
        self.attach(new, parent, edge)
        return new

    def attach(self, node: int, parent: int, edge: float) -> None:
        """Lead to ``node`` through ``parent``, and bring the costs of all that follows it up to date."""
        if self.parent[node] >= 0:
            self.children[self.parent[node]].remove(node)
        self.children[parent].append(node)
        self.parent[node], self.edge[node], self.squared[node] = parent, edge, self.q[node] @ self.q[node]
        stack = [node]
        while stack:
            below = stack.pop()
            self.cost[below] = self.cost[self.parent[below]] + self.edge[below]
            stack += self.children[below]

    def near(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Rows of the k nearest postures that are attached, and their distances."""
        n, m = self.size, len(q)
        k = min(n, int(np.e * (1 + 1 / m) * np.log(n)) + 1)
        order = self.squared[:n] - 2 * (self.q[:n] @ q)  # squared distances, but for a constant
        near = np.argpartition(order, k - 1)[:k] if k < n else np.arange(n)
        near = near[np.isfinite(self.cost[near])]
        return near, np.linalg.norm(self.q[near] - q, axis=1)

    def distance_left(self) -> float:
        attached = np.isfinite(self.cost)
        return float(np.linalg.norm(self.q[attached] - self.q[GOAL], axis=1).min())

    def path(self) -> np.ndarray:
        rows = [GOAL]
        while rows[-1] != START:
            rows.append(self.parent[rows[-1]])
        return self.q[rows[::-1]]

    def frozen(self) -> Tree:
        return Tree(*(values[: self.size].copy() for values in (self.q, self.parent, self.cost)))
