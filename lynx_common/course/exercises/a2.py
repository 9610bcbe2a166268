"""Exercises of A2, workspace: the inner radius, an elbow that bends one way, another arm."""

import numpy as np

from ... import arcs, arm, workspace
from .answers import Form
from .exercise import Exercise
from .reader import Own

d_1, L_1, L_2, L_3 = arm.LYNX


def inner(theta_3: float) -> float:
    """Distance of the wrist from the shoulder."""
    return float(np.sqrt(L_1**2 + L_2**2 + 2 * L_1 * L_2 * np.cos(theta_3)))


# A2.2: the elbow bends one way.
FULL, HALF, ONE_WAY = (0, 360), (-90, 90), (0, 90)


def section(theta_2: tuple, theta_3: tuple, geometry: arm.Geometry = arm.LYNX) -> arcs.Region:
    """What the wrist reaches for one theta_1; limits in degrees."""
    return workspace.section(np.deg2rad([FULL, theta_2, theta_3, FULL]), geometry=geometry)


def both_sides(region: arcs.Region) -> arcs.Region:
    return region | region.mirror()


REGION, SHELL = both_sides(section(HALF, ONE_WAY)), both_sides(section(HALF, HALF))

# A2.3: a SCARA arm, seen from above; its first joint is the shoulder of ours, lying down.
TURNED = "here nothing turns about the axis r = 0: the plane is seen from above, and the slide moves it."


def scara(L_1: float, L_2: float, first: int, second: int, slide: float) -> Exercise:
    """A2.3: two links and a slide, in metres, and how far the two joints turn to either side, in degrees."""
    region = section((-first, first), (-second, second), arm.Geometry(0, L_1, L_2, 0))
    ring = 2 * np.pi * L_1 * L_2 * (1 - np.cos(np.deg2rad(second)))
    return Exercise(
        form=Form(()),
        unit="cubic metres",
        right=region.area * slide,
        misconceptions=(
            (
                ring * slide,
                "this is for a first joint that turns fully; its limits take a part of the ring.",
            ),
            (
                ring * first / 180 * slide,
                "this is a sector of the ring; at its sides the second link reaches further round.",
            ),
            (region.area, "this is the area, seen from above; the slide makes a volume of it."),
            (region.volume, TURNED),
            (both_sides(region).volume, TURNED),
        ),
        hints=(
            "Seen from above, its two joints are our joints 2 and 3, lying down.",
            f"workspace.section takes another arm: geometry=arm.Geometry(0, {L_1}, {L_2}, 0). What does a slide "
            "make of an area?",
        ),
        explanation="Lay our arm on its side: shoulder and elbow become the two joints of the SCARA arm, and its "
        f"section the area seen from above. The slide adds height, so the volume is area times {slide} m.",
        code=f"of_scara = np.deg2rad([[0, 360], [-{first}, {first}], [-{second}, {second}], [0, 360]])\n"
        f"region = workspace.section(of_scara, geometry=arm.Geometry(0, {L_1}, {L_2}, 0))\n"
        f"answer_3 = region.area * {slide}",
    )


EXERCISES = {
    "A2.1": Exercise(
        form=Form(()),
        unit="metres",
        right=inner(np.deg2rad(120)),
        misconceptions=(
            (inner(np.deg2rad(90)), "this is the radius for 90 deg."),
            (inner(np.deg2rad(60)), "mind the sign of cos(120 deg): it is negative."),
            (inner(120), "the cosine was taken of 120 rad; 120 deg are meant."),
            (inner(np.deg2rad(120)) ** 2, "this is its square."),
            (inner(np.deg2rad(120)) - L_3, "L_3 lies beyond the wrist; it does not matter here."),
            (0, "the wrist comes back to the shoulder only if the elbow folds by 180 deg."),
        ),
        hints=(
            "Which value of theta_3 brings the wrist nearest to the shoulder?",
            "By the law of cosines the square is L_1**2 + L_2**2 + 2 L_1 L_2 cos(theta_3).",
        ),
        explanation="The wrist is nearest where $\\theta_3$ is farthest from 0. With equal links and "
        "$\\cos 120° = -\\frac{1}{2}$ the distance is $L_1$ itself: an equilateral triangle.",
        code="L = arm.LYNX\nanswer_1 = np.sqrt(L.L_1**2 + L.L_2**2 + 2 * L.L_1 * L.L_2 * np.cos(np.deg2rad(120)))",
    ),
    "A2.2": Exercise(
        form=Form(()),
        unit="cubic metres",
        right=REGION.volume,
        misconceptions=(
            (
                SHELL.volume / 2,
                "this is half of the shell. But theta_1 brings the arm's plane round, so what is lost on one side "
                "can be reached from the other.",
            ),
            (
                SHELL.volume,
                "this is the whole shell, or twice the section's volume; what both sides reach counts once.",
            ),
            (REGION.area, "this is an area; the volume of the region turned about the axis is expected."),
        ),
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
    "A2.3": Own(
        scara,
        {
            "L_1": (0.3, 0.25, 0.35, 0.01),
            "L_2": (0.25, 0.2, 0.3, 0.01),
            "theta_1_deg": (130, 115, 135, 5),
            "theta_2_deg": (145, 140, 150, 5),
            "slide": (0.15, 0.1, 0.2, 0.01),
        },
    ),
}
