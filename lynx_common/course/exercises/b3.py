"""Exercises of B3, trajectories: distance to a segment, how far the rule of the bump goes, a robot on wheels."""

import numpy as np

from .answers import Form
from .exercise import Exercise
from .reader import Own

# B3.1: a straight motion in the arm's plane, and an obstacle beyond its end.
START, END, CENTRE, RADIUS = np.array([0.2, 0.1]), np.array([0.3, 0.3]), np.array([0.4, 0.6]), 0.1
TO_START, TO_END = (float(np.hypot(*(CENTRE - point))) for point in (START, END))
(ALONG_R, ALONG_Z), (TO_R, TO_Z) = END - START, CENTRE - START
TO_LINE = float(abs(ALONG_R * TO_Z - ALONG_Z * TO_R) / np.hypot(ALONG_R, ALONG_Z))

# B3.2: the line from point 3 to point 4, its distance from the centre, and the margin about an obstacle of 0.15 m.
LINE = 0.2 * np.sqrt(2)
APART = LINE / 2


def largest(share: float) -> float:
    """The largest keep with keep (keep - APART) <= LINE^2 / share."""
    return float((APART + np.sqrt(APART**2 + 4 * LINE**2 / share)) / 2)


KEEP = largest(np.pi**2)


def vacuum_cleaner(distance: float, pillar: float, robot: float, margin: float, aside: float) -> Exercise:
    """B3.3: from start to goal, two radii, the margin, and how far the pillar is beside the line, in metres."""
    half, keep = distance / 2, pillar + robot + margin
    far, seen = float(np.hypot(half, aside)), 2 * float(np.arctan2(half, aside))

    def around(keep: float, angle: float = seen) -> float:
        """Length of tangent, arc, tangent; ``angle`` is that between start and end, seen from the centre."""
        return float(2 * np.sqrt(far**2 - keep**2) + keep * (angle - 2 * np.arccos(keep / far)))

    corner = distance / float(np.cos(np.arcsin(keep / far) - np.arctan2(aside, half)))
    by_the_edge = 2 * float(np.hypot(half, keep - aside))
    return Exercise(
        form=Form(()),
        unit="metres",
        right=around(keep),
        misconceptions=(
            (distance, "that is the straight line; the robot would run into the pillar."),
            (around(pillar + margin), "this brings the robot's centre to the margin; it has a radius."),
            (around(pillar + robot), "this leaves out the margin."),
            (around(pillar), "this leaves out the robot's radius and the margin."),
            (
                around(keep, 2 * np.pi - seen),
                "this is the way round the far side of the pillar; the other is shorter.",
            ),
            (corner, "these are two tangents that meet in a corner; along the circle it is shorter."),
            (by_the_edge, "this is a V to the nearest edge of the circle; its sides cut through the circle."),
        ),
        hints=(
            "Shrink the robot to its centre. By how much has the pillar to grow for that?",
            "A taut thread from start to end: tangent, arc, tangent. How long is a tangent, and which part of the "
            "angle at the centre is left for the arc?",
        ),
        explanation=f"The centre of the robot has to stay $\\rho = {pillar} + {robot} + {margin} = {keep:.2f}$ m "
        f"from that of the pillar. Both ends are $D = \\sqrt{{{half:g}^2 + {aside}^2}}$ m from it, and are seen "
        f"from it under $\\Delta = 2 \\arctan({half:g}/{aside}) = {np.rad2deg(seen):.1f}°$. So the length is "
        f"$2 \\sqrt{{D^2 - \\rho^2}} + \\rho\\,(\\Delta - 2 \\arccos\\frac{{\\rho}}{{D}}) = "
        f"{around(keep):.3f}$ m.",
        code=f"rho, D = {pillar} + {robot} + {margin}, np.hypot({half:g}, {aside})\n"
        f"delta = 2 * np.arctan2({half:g}, {aside})\n"
        "answer_3 = 2 * np.sqrt(D**2 - rho**2) + rho * (delta - 2 * np.arccos(rho / D))",
    )


EXERCISES = {
    "B3.1": Exercise(
        form=Form(()),
        unit="metres",
        right=TO_END - RADIUS,
        misconceptions=(
            (TO_END, "this is the distance from the centre; the obstacle has a radius."),
            (TO_LINE - RADIUS, "this is measured to the infinite line, which runs on beyond the end."),
            (
                TO_LINE,
                "this is measured to the infinite line, which runs on beyond the end, and from the centre.",
            ),
            (TO_START - RADIUS, "this is measured to the start; another point of the segment is nearer."),
        ),
        hints=(
            "How far along the line, as a share of the segment, is the foot of the perpendicular? Is it on it?",
            "The foot lies beyond the end. Which point of the segment is then the nearest?",
        ),
        explanation="The foot of the perpendicular is at $u = 2.4$, beyond the end; limited to 1 it is the end "
        "itself. From there to the centre it is $\\sqrt{0.1^2 + 0.3^2} = 0.3162$ m; less the radius, 0.2162 m. "
        "The infinite line runs right through the obstacle.",
        code="start, end, centre = np.array([0.2, 0.1]), np.array([0.3, 0.3]), np.array([0.4, 0.6])\n"
        "along = end - start\n"
        "share = np.clip((centre - start) @ along / (along @ along), 0, 1)\n"
        "answer_1 = np.linalg.norm(start + share * along - centre) - 0.1",
    ),
    "B3.2": Exercise(
        form=Form(()),
        unit="metres",
        right=KEEP,
        misconceptions=(
            (KEEP - 0.15, "this is the largest margin; the sum of radius and margin is asked for."),
            (KEEP - APART, "this is the largest height h; the sum of radius and margin is asked for."),
            (largest(8), "this is the answer for the spline; its curvature in the middle is another."),
            (0.2, "at 0.2 m the ends are at the margin; the rule fails before."),
        ),
        hints=(
            "The middle is the nearest place while the second derivative of the squared distance is positive.",
            "With h = rho - d_0 the condition reads pi^2 rho (rho - d_0) <= l^2. Solve it for rho.",
        ),
        explanation="The second derivative is $2 l^2 - 2 \\rho h \\pi^2$ with $h = \\rho - d_0$. It is zero at "
        "$\\rho = \\frac{1}{2}\\left(d_0 + \\sqrt{d_0^2 + 4 l^2 / \\pi^2}\\right) = 0.1852$ m. Beyond, the bump "
        "comes nearest at two places beside its middle.",
        code="l, d_0 = 0.2 * np.sqrt(2), 0.1 * np.sqrt(2)\n"
        "answer_2 = (d_0 + np.sqrt(d_0**2 + 4 * l**2 / np.pi**2)) / 2",
    ),
    "B3.3": Own(
        vacuum_cleaner,
        {
            "distance": (2.0, 1.8, 2.2, 0.1),
            "pillar": (0.25, 0.28, 0.34, 0.01),
            "robot": (0.17, 0.16, 0.19, 0.01),
            "margin": (0.03, 0.05, 0.07, 0.01),
            "aside": (0.2, 0.1, 0.16, 0.01),
        },
    ),
}
