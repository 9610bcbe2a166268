"""Section 1.6 of the report, trajectories between points: its figures and claims."""

from .item import claim, numbers

NOTEBOOK = "B3_trajectories"
PRINTED = {
    "1.6, p. 13": {
        "Fig. 1.10": numbers(
            "the five points of the gripper's path (crosses)",
            [[0.2, 0, 0.2], [0.1, 0, 0.4], [0, 0, 0.6], [-0.2, 0, 0.4], [-0.3, 0, 0.2]],
            2,
        ),
        "Fig. 1.11": numbers(
            "the free motion bulges to x = 0.26 m at z = 0.28 m; at point 3 the arm stands upright, its joints at "
            "heights of 0, 0.1, 0.3, 0.5 and 0.6 m",
            [0.26, 0.28, 0, 0.1, 0.3, 0.5, 0.6],
            2,
        ),
        "Fig. 1.12": numbers(
            "the detour goes straight down from point 3 to z = 0.494949 m, where the pitch is 0.745732 rad, and "
            "from there straight to point 4",
            [0.494949, 0.745732],
            6,
        ),
        "claim B3.1": claim(
            "the motions are those between the points of Table 1.5",
            "wrong: three of the five points in the figures are others",
            "with those of Table 1.5 the free motion leaves the arm's reach",
        ),
        "claim B3.2": claim("the free motion and the linear motion can be done"),
        "claim B3.3": claim(
            "the distance from the obstacle to the line, compared with its radius, tells whether a route is safe",
            "wrong: what counts is how near the whole arm comes to the obstacle, and only during the motion",
            "the line goes on beyond the points and rules out safe routes; and routes pass on which a link "
            "collides",
        ),
        "claim B3.4": claim("the straight line from point 3 to point 4 is blocked"),
        "claim B3.5": claim("the detour is clear of the obstacle"),
    },
}
