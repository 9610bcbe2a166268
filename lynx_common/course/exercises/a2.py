"""Exercises of A2, workspace: the inner radius, an elbow that bends one way, another arm."""

import numpy as np

from ... import arm, workspace
from .exercise import TOLERANCE, Exercise, numbers

d_1, L_1, L_2, L_3 = arm.LYNX


def _near(a: float, b: float) -> bool:
    return bool(abs(a - b) <= TOLERANCE * max(1, abs(b)))


def _distance(theta_3_deg: float) -> float:
    """Of the wrist from the shoulder."""
    return float(np.sqrt(L_1**2 + L_2**2 + 2 * L_1 * L_2 * np.cos(np.deg2rad(theta_3_deg))))


INNER = _distance(120)

# A2.2: the elbow bends one way.
FULL = np.pi * np.array([0, 2])
HALF_DEG, ONE_WAY_DEG = (-90, 90), (0, 90)


def _section(theta_2_deg: tuple, theta_3_deg: tuple, geometry: arm.Geometry = arm.LYNX):
    limits = np.array([FULL, np.deg2rad(theta_2_deg), np.deg2rad(theta_3_deg), FULL])
    return workspace.section(limits, geometry=geometry)


ONE_WAY, SHELL = _section(HALF_DEG, ONE_WAY_DEG), _section(HALF_DEG, HALF_DEG)
VOLUME, SHELL_VOLUME = ((region | region.mirror()).volume for region in (ONE_WAY, SHELL))

# A2.3: the SCARA arm, seen from above; its first joint is the shoulder of ours, lying down.
SLIDE, FIRST, SECOND = 0.15, 0.3, 0.25
SCARA = _section((-130, 130), (-145, 145), arm.Geometry(0, FIRST, SECOND, 0))
RING = np.pi * ((FIRST + SECOND) ** 2 - (FIRST**2 + SECOND**2 + 2 * FIRST * SECOND * np.cos(np.deg2rad(145))))


def _about(x: float, right: float) -> bool:
    """Small volumes are compared by their share."""
    return bool(abs(x - right) <= 1e-3 * right)


def _off(x: float, right: float, unit: str) -> str:
    return f"this is {'more' if x > right else 'less'} than it should be, by {abs(x - right):.4f} {unit}."


EXERCISES = {
    "A2.1": Exercise(
        read=numbers(()),
        right=lambda x: _near(x, INNER),
        misconceptions=(
            (lambda x: _near(x, _distance(90)), "this is the radius for 90 deg."),
            (lambda x: _near(x, _distance(60)), "mind the sign of cos(120 deg): it is negative."),
            (
                lambda x: _near(x, _distance(np.rad2deg(120))),
                "the cosine was taken of 120 rad; 120 deg are meant.",
            ),
            (lambda x: _near(x, INNER**2), "this is its square."),
            (lambda x: _near(x, INNER - L_3), "L_3 lies beyond the wrist; it does not matter here."),
            (lambda x: _near(x, 0), "the wrist comes back to the shoulder only if the elbow folds by 180 deg."),
        ),
        describe=lambda x: _off(x, INNER, "m"),
        hints=(
            "Which value of theta_3 brings the wrist nearest to the shoulder?",
            "By the law of cosines the square is L_1**2 + L_2**2 + 2 L_1 L_2 cos(theta_3).",
        ),
        explanation="The wrist is nearest where $\\theta_3$ is farthest from 0. With equal links and "
        "$\\cos 120° = -\\frac{1}{2}$ the distance is $L_1$ itself: an equilateral triangle.",
        code="L = arm.LYNX\nanswer_1 = np.sqrt(L.L_1**2 + L.L_2**2 + 2 * L.L_1 * L.L_2 * np.cos(np.deg2rad(120)))",
    ),
    "A2.2": Exercise(
        read=numbers(()),
        right=lambda x: _about(x, VOLUME),
        misconceptions=(
            (
                lambda x: _about(x, SHELL_VOLUME / 2),
                "this is half of the shell. But theta_1 brings the arm's plane round, so what is lost on one side "
                "can be reached from the other.",
            ),
            (
                lambda x: _about(x, SHELL_VOLUME),
                "this is the whole shell, or twice the section's volume; what both sides reach counts once.",
            ),
            (lambda x: _about(x, VOLUME * 1000), "this is in litres; cubic metres are expected."),
            (
                lambda x: _about(x, (ONE_WAY | ONE_WAY.mirror()).area),
                "this is an area; the volume of the region turned about the axis is expected.",
            ),
        ),
        describe=lambda x: _off(x, VOLUME, "m^3"),
        hints=(
            "workspace.section(limits) gives what the wrist reaches for one theta_1; limits is as in section 1.",
            "Turned half round, that region becomes its mirror image: region | region.mirror().",
        ),
        explanation="Half of the postures are lost, and a quarter of the section's area. "
        "But $\\theta_1 + 180°$ puts the mirror image beside it, and both together are 94 % of the shell. "
        "Turning the base makes up for most of the elbow.",
        code="one_way = np.deg2rad([[0, 360], [-90, 90], [0, 90], [0, 360]])\n"
        "region = workspace.section(one_way)\n"
        "answer_2 = (region | region.mirror()).volume",
    ),
    "A2.3": Exercise(
        read=numbers(()),
        right=lambda x: _about(x, SCARA.area * SLIDE),
        misconceptions=(
            (
                lambda x: _about(x, RING * SLIDE),
                "this is for a first joint that turns fully; with its limits a part of the ring is lost.",
            ),
            (
                lambda x: _about(x, RING * 260 / 360 * SLIDE),
                "this is a sector of the ring; at its sides the second link reaches further round.",
            ),
            (
                lambda x: _about(x, SCARA.area),
                "this is the area, seen from above; the slide makes a volume of it.",
            ),
            (
                lambda x: any(_about(x, region.volume) for region in (SCARA, SCARA | SCARA.mirror())),
                "here nothing turns about the axis r = 0: the plane is seen from above, and the slide moves it.",
            ),
            (lambda x: _about(x, SCARA.area * SLIDE * 1000), "this is in litres; cubic metres are expected."),
        ),
        describe=lambda x: _off(x, SCARA.area * SLIDE, "m^3"),
        hints=(
            "Seen from above, its two joints are our joints 2 and 3, lying down.",
            "workspace.section takes another arm: arm.Geometry(0, 0.3, 0.25, 0). The volume is area times slide.",
        ),
        explanation="Lay our arm on its side: shoulder and elbow become the two joints of the SCARA arm, and its "
        "section the area seen from above. The slide adds height, so the volume is area times 0.15 m.",
        code="of_scara = np.deg2rad([[0, 360], [-130, 130], [-145, 145], [0, 360]])\n"
        "region = workspace.section(of_scara, geometry=arm.Geometry(0, 0.3, 0.25, 0))\n"
        "answer_3 = region.area * 0.15",
    ),
}
