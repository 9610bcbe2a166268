"""Sections 2.1 and 2.2 of the report: their tables, figures and claims."""

import numpy as np

from .item import claim, numbers

TWO_CLOSE = "wrong: of the four poses only the first and the third can be assembled, in the mode (1, 1, 1) at "
AT_THE_ORIGIN = "these are angles of legs that all begin at the origin, where none of the motors is"

# Positions 1 to 4: X_c, Y_c in mm, alpha in degrees; then the three motor angles in degrees.
TABLE_2_3 = np.array([[0, 100, 0], [50, 150, 30], [-50, 50, -30], [100, 200, 45]])
DRAWN = np.array([[50, 100, 0], [50, 150, 30], [-50, 50, -30], [100, 150, 45]])
TABLE_2_4 = np.array(
    [
        [110.36, -163.893, 57.613],
        [118.073, 118.073, 72.69],
        [130.591, -153.118, -118.985],
        [119.024, 65.211, 51.503],
    ]
)
FIG_2_2 = np.array(
    [
        [110.3598, -163.8932, 57.6125],
        [118.0725, 118.0725, 72.6896],
        [130.5913, -153.1179, -118.9854],
        [119.0236, 65.2114, 51.5026],
    ]
)
# What closes: the first and the third position of Table 2.3, and of Fig. 2.1.
POSITION_3 = [-132.5599, 31.2654, 132.0131]
TABLE_2_4_RIGHT = np.array([[-130.1192, 17.8457, 93.0238], POSITION_3])
FIG_2_2_RIGHT = np.array([[-97.2250, 18.1056, 76.1906], POSITION_3])
DISTAL_LINKS = np.array(
    [[245.03, 418.84, 183.28], [188.95, 317.80, 180.08], [285.61, 351.48, 277.60], [216.57, 246.69, 235.64]]
)
# Fig. 2.4, on its grid of 10 mm: least and largest X_c, least and largest Y_c, at 0, 30, 45 and 60 deg.
EXTENTS = np.array(
    [[-180, 180, -210, 170], [-210, 170, -180, 180], [-200, 170, -170, 200], [-180, 180, -170, 210]]
)
EXTENTS_RIGHT = np.array(
    [[-150, 150, -140, 160], [-140, 110, -120, 140], [-120, 80, -100, 110], [-70, 40, -60, 60]]
)

NOTEBOOK = "Part2_parallel_robot"
PRINTED = {
    "2.1, pp. 14-17": {
        "Table 2.1": numbers("S_A, L, r_platform and r_base in mm", np.array([170, 130, 130, 290]), 3),
        "Table 2.2": numbers(
            "angles of the joints of base (first row) and platform", np.array([[3, 7, 11]] * 2) * np.pi / 6, 9
        ),
        "Table 2.3": numbers(
            "positions 1 to 4 of the platform: X_c, Y_c in mm, alpha in deg",
            TABLE_2_3,
            1,
            "wrong: the angles and the figures belong to (50, 100, 0) and (100, 150, 45) at positions 1 and 4",
            "the angles of Table 2.4 do not fit (0, 100, 0), and at (100, 200, 45) leg 3 has no real root",
            right=DRAWN,
        ),
        "Fig. 2.1": numbers(
            "the robot in four positions, each with three distal links of 130 mm",
            np.full((4, 3), 130.0),
            2,
            "wrong: the distal links as drawn measure 180.08 to 418.84 mm, none 130",
            "at the angles of Fig. 2.2 no elbow is 130 mm from its platform joint",
            right=DISTAL_LINKS,
        ),
        "Fig. 2.2": numbers(
            "motor angles in deg for the positions of Fig. 2.1",
            FIG_2_2,
            4,
            f"{TWO_CLOSE}-97.2250, 18.1056, 76.1906 and -132.5599, 31.2654, 132.0131 deg",
            AT_THE_ORIGIN,
            right=FIG_2_2_RIGHT,
        ),
    },
    "2.1, p. 17": {
        "Table 2.4": numbers(
            "motor angles in deg for the positions of Table 2.3",
            TABLE_2_4,
            3,
            f"{TWO_CLOSE}-130.119, 17.846, 93.024 and -132.560, 31.265, 132.013 deg",
            AT_THE_ORIGIN,
            right=TABLE_2_4_RIGHT.round(3),
        ),
        "claim P2.1": claim(
            "Table 2.4 gives the angles to three decimals",
            "wrong: three of them are 0.001 deg too large",
            "they were rounded twice: 57.61248 to the 57.6125 of Fig. 2.2, and that to 57.613",
        ),
        "claim P2.2": claim(
            "the robot adapts to all four positions",
            "wrong: at positions 2 and 4 it cannot be assembled, whichever poses are meant",
            "a leg spans 40 to 300 mm; at position 2 leg 1 would have to span 31.25 mm, and leg 3 303.46 mm",
        ),
        "claim P2.3": claim(
            "the configurations are feasible",
            "wrong: no leg of the twelve closes; the gaps are 50 to 289 mm",
            "the distal link is 130 mm long, and has 180 mm or more to bridge in every leg",
        ),
        "claim P2.4": claim(
            "the configurations are smooth from one position to the next",
            "wrong: leg 3 changes sides from position 2 to 3, and back",
            "to change sides a leg has to pass through stretched or folded, where it is singular",
        ),
        "claim P2.5": claim(
            "the pictures confirm the kinematic model",
            "wrong: they refute it, by the lengths of the distal links",
            "a line is drawn from elbow to platform joint, however far apart they are",
        ),
    },
    "2.2, pp. 17-19": {
        "Fig. 2.3": numbers(
            "13 layers of workspace, from 0 to 60 deg in steps of 5, each as large as the first",
            np.ones(13),
            2,
            "wrong: they shrink; the last has 0.17 times the area of the first",
            "without the base joints every layer is the first one, only turned",
            right=np.array([1, 0.99, 0.97, 0.94, 0.9, 0.84, 0.77, 0.66, 0.55, 0.44, 0.34, 0.24, 0.17]),
        ),
        "Fig. 2.4": numbers(
            "workspace at 0, 30, 45 and 60 deg: least and largest X_c and Y_c on a grid of 10 mm",
            EXTENTS,
            0,
            "wrong: at 0 deg it is -150 to 150 and -140 to 160 mm, at 60 deg -70 to 40 and -60 to 60 mm",
            "it is drawn for legs that all begin at the origin: one region, turned by 0, 30, 45 and 60 deg",
            right=EXTENTS_RIGHT,
        ),
        "claim P2.6": claim("the discriminant of the quadratic decides whether a leg can close"),
        "claim P2.7": claim(
            "the workspace has voids inside",
            "wrong: none at any alpha; the circles cut off its corners up to 32.17 deg, and beyond that miss it",
            "its boundary is one closed line at every whole degree, without a second one for a void",
        ),
        "claim P2.8": claim(
            "the voids are singular configurations, or points where the inverse kinematics has no real solution"
        ),
        "claim P2.9": claim(
            "with alpha the workspace shifts",
            "wrong: its centroid stays in the middle; it shrinks and turns about it",
            "turned by 120 deg the region is its own image, so its centroid can only be the centre",
        ),
        "claim P2.10": claim(
            "with alpha its shape alters slightly",
            "wrong: its area falls to a sixth from 0 to 60 deg, and to nothing at 81.61 deg",
            "the area at 0 deg is 6.06 times that at 60 deg",
        ),
    },
}
