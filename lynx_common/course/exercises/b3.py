"""Exercises of B3, trajectories: distance to a segment, how far the rule of the bump goes, a robot on wheels."""

from collections.abc import Callable

import numpy as np

from .exercise import TOLERANCE, Exercise, numbers

# B3.1: a straight motion in the arm's plane, and an obstacle beyond its end.
START, END, CENTRE, RADIUS = np.array([0.2, 0.1]), np.array([0.3, 0.3]), np.array([0.4, 0.6]), 0.1
TO_END = float(np.hypot(*(CENTRE - END)))
(ALONG_R, ALONG_Z), (TO_R, TO_Z) = END - START, CENTRE - START
TO_LINE = float(abs(ALONG_R * TO_Z - ALONG_Z * TO_R) / np.hypot(ALONG_R, ALONG_Z))
CLEARANCE = TO_END - RADIUS

# B3.2: the line from point 3 to point 4, and its distance from the centre.
LINE = 0.2 * np.sqrt(2)
APART = LINE / 2


def _largest(share: float) -> float:
    """The largest keep with keep (keep - APART) <= LINE^2 / share."""
    return float((APART + np.sqrt(APART**2 + 4 * LINE**2 / share)) / 2)


KEEP = _largest(np.pi**2)

# B3.3: a robot vacuum cleaner and a pillar.
PILLAR, ROBOT, MARGIN = 0.25, 0.17, 0.03
HALF_WAY, ASIDE = 1.0, 0.2
FAR = float(np.hypot(HALF_WAY, ASIDE))
SEEN = 2 * float(np.arctan2(HALF_WAY, ASIDE))


def _around(keep: float, angle: float = SEEN) -> float:
    """Length of tangent, arc, tangent; ``angle`` is that between start and end, seen from the centre."""
    return float(2 * np.sqrt(FAR**2 - keep**2) + keep * (angle - 2 * np.arccos(keep / FAR)))


SHORTEST = _around(PILLAR + ROBOT + MARGIN)


def _near(value: float, tolerance: float = 5 * TOLERANCE) -> Callable[[float], bool]:
    return lambda x: bool(abs(x - value) <= tolerance)


EXERCISES = {
    "B3.1": Exercise(
        read=numbers(()),
        right=_near(CLEARANCE),
        misconceptions=(
            (_near(TO_END), "this is the distance from the centre; the obstacle has a radius."),
            (_near(TO_LINE - RADIUS), "this is measured to the infinite line, which runs on beyond the end."),
            (
                _near(TO_LINE),
                "this is measured to the infinite line, which runs on beyond the end, and from the centre.",
            ),
            (
                _near(float(np.hypot(*(CENTRE - START))) - RADIUS),
                "this is measured to the start; another point of the segment is nearer.",
            ),
            (_near(CLEARANCE * 1000, 0.5), "this is right in millimetres; metres are expected."),
        ),
        describe=lambda x: f"this is {abs(x - CLEARANCE):.4f} m too {'much' if x > CLEARANCE else 'little'}.",
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
        read=numbers(()),
        right=_near(KEEP),
        misconceptions=(
            (_near(KEEP - 0.15), "this is the largest margin; the sum of radius and margin is asked for."),
            (_near(KEEP - APART), "this is the largest height A; the sum of radius and margin is asked for."),
            (_near(_largest(8)), "this is the answer for the spline; its curvature in the middle is another."),
            (_near(0.2), "at 0.2 m the ends are at the margin; the rule fails before."),
            (_near(KEEP * 1000, 0.5), "this is right in millimetres; metres are expected."),
        ),
        describe=lambda x: f"this is {abs(x - KEEP):.4f} m too {'much' if x > KEEP else 'little'}.",
        hints=(
            "The middle is the nearest place while the second derivative of the squared distance is positive.",
            "With A = rho - d_0 the condition reads pi^2 rho (rho - d_0) <= l^2. Solve it for rho.",
        ),
        explanation="The second derivative is $2 l^2 - 2 \\rho A \\pi^2$ with $A = \\rho - d_0$. It is zero at "
        "$\\rho = \\frac{1}{2}\\left(d_0 + \\sqrt{d_0^2 + 4 l^2 / \\pi^2}\\right) = 0.1852$ m. Beyond, the bump "
        "comes nearest at two places beside its middle.",
        code="l, d_0 = 0.2 * np.sqrt(2), 0.1 * np.sqrt(2)\n"
        "answer_2 = (d_0 + np.sqrt(d_0**2 + 4 * l**2 / np.pi**2)) / 2",
    ),
    "B3.3": Exercise(
        read=numbers(()),
        right=_near(SHORTEST, 0.006),
        misconceptions=(
            (_near(2 * HALF_WAY), "that is the straight line; the robot would run into the pillar."),
            (
                _near(_around(PILLAR + MARGIN), 0.003),
                "this brings the robot's centre to the margin; it has a radius.",
            ),
            (_near(_around(PILLAR + ROBOT), 0.003), "this leaves out the margin."),
            (_near(_around(PILLAR), 0.003), "this leaves out the robot's radius and the margin."),
            (
                _near(_around(PILLAR + ROBOT + MARGIN, 2 * np.pi - SEEN), 0.006),
                "this is the way round the far side of the pillar; the other is shorter.",
            ),
        ),
        describe=lambda x: f"this is {abs(x - SHORTEST):.2f} m too {'much' if x > SHORTEST else 'little'}.",
        hints=(
            "Shrink the robot to its centre. By how much has the pillar to grow for that?",
            "Tangent, arc, tangent about a circle of 0.45 m; the angle at its centre is 2 atan2(1, 0.2).",
        ),
        explanation="The centre of the robot has to stay $\\rho = 0.25 + 0.17 + 0.03 = 0.45$ m from that of the "
        "pillar. Both ends are $D = \\sqrt{1 + 0.04}$ m from it, and are seen from it under "
        "$\\Delta = 2 \\arctan 5 = 157.4°$. So the length is $2 \\sqrt{D^2 - \\rho^2} + \\rho\\,(\\Delta - 2 "
        "\\arccos\\frac{\\rho}{D}) = 2.06$ m.",
        code="rho, D, delta = 0.25 + 0.17 + 0.03, np.hypot(1, 0.2), 2 * np.arctan2(1, 0.2)\n"
        "answer_3 = 2 * np.sqrt(D**2 - rho**2) + rho * (delta - 2 * np.arccos(rho / D))",
    ),
}
