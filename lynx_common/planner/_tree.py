"""The tree of postures that RRT* grows."""

import numpy as np

START, GOAL = 0, 1  # their rows


class Tree:
    """Postures that are reached from a start; the goal is in it from the beginning, at infinite cost.

    q : (n, m), postures; start and goal are the first two.
    parent : (n,), the row of the one that each is reached from; -1 for the start, and where it is not reached yet.
    cost : (n,), the joint travel from the start to each.

    While it grows the arrays have room for ``capacity`` postures, of which the first ``size`` are there; ``trim``
    cuts off the rest.

    >>> tree = Tree(start=[0.0, 0.0], goal=[2.0, 0.0], capacity=3)
    >>> tree.attach(GOAL, tree.add([1.0, 0.0], START, 1.0), 1.0)
    >>> tree.cost
    array([0., 2., 1.])
    """

    def __init__(self, start: np.ndarray, goal: np.ndarray, capacity: int):
        self.q, self.parent = np.empty((capacity, len(start))), np.full(capacity, -1)
        self.cost, self.edge = np.full(capacity, np.inf), np.zeros(capacity)
        self.squared = np.full(capacity, np.inf)  # |q|^2 of what is reached
        self.children: list[list[int]] = [[], []]
        self.q[START], self.q[GOAL], self.size = start, goal, 2
        self.cost[START], self.squared[START] = 0, self.q[START] @ self.q[START]

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
        """Rows of the nearest k > 2^(m + 1) e (1 + 1/m) log n postures that are reached, and their distances."""
        n, m = self.size, len(q)
        k = min(n, int(2 ** (m + 1) * np.e * (1 + 1 / m) * np.log(n)) + 1)
        order = self.squared[:n] - 2 * (self.q[:n] @ q)  # squared distances, but for a constant
        near = np.argpartition(order, k - 1)[:k] if k < n else np.arange(n)
        near = near[np.isfinite(self.cost[near])]
        return near, np.linalg.norm(self.q[near] - q, axis=1)

    def to_goal(self) -> np.ndarray:
        """The postures, (n, m), that lead from the start to the goal."""
        rows = [GOAL]
        while rows[-1] != START:
            rows.append(self.parent[rows[-1]])
        return self.q[rows[::-1]]

    def trim(self) -> None:
        """Cut off the room in which nothing has grown."""
        for name in ("q", "parent", "cost", "edge", "squared"):
            setattr(self, name, getattr(self, name)[: self.size])
