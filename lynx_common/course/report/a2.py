"""Section 1.2 of the report, workspace: its figures and claims."""

from .item import claim, numbers

# A figure of the workspace is read by its extent: lowest and highest x, y and z in metres.
NOTEBOOK = "A2_workspace"
PRINTED = {
    "1.2, p. 4": {
        "Fig. 1.3": numbers(
            "the points of the wrist in steps of 10 deg: x and y from -0.4 to 0.4 m, z from -0.3 to 0.5 m",
            [-0.4, 0.4, -0.4, 0.4, -0.3, 0.5],
            2,
        ),
        "Fig. 1.4": numbers(
            "the points of the gripper, theta_2 from 0 to 180 deg: x and y from -0.5 to 0.5 m, "
            "z from -0.2 to 0.6 m",
            [-0.5, 0.5, -0.5, 0.5, -0.2, 0.6],
            2,
        ),
    },
    "1.2, pp. 4-5": {
        "claim A2.1": claim("theta_5 does not move the wrist"),
        "claim A2.2": claim("the wrist's workspace can be obtained by a sweep over the first four joints"),
        "claim A2.3": claim(
            "in steps of 1 deg more than four billion points have to be computed, which do not fit into memory",
            "holds, if every combination of the four joints is stored; the points that differ take 135 MB",
            "theta_4 only repeats each point 361 times; 20,566 points differ in the arm's plane, and 5,880,332 in "
            "space",
        ),
        "claim A2.4": claim("the workspace of the wrist is like a spherical shell"),
        "claim A2.5": claim(
            "the wrist cannot reach the position directly above or below the base",
            "holds, if the hollow of the shell is meant, from 0.18 m below the base to 0.38 m above it",
            "farther up, to 0.50 m, and farther down, to 0.30 m, it does reach the base axis",
        ),
        "claim A2.6": claim(
            "its horizontal extent is determined by L_1 + L_2 + L_3",
            "holds, if the gripper is meant; for the wrist, whose workspace it is, it is L_1 + L_2 = 0.4 m",
            "L_3 is the part beyond the wrist, and the report's own figure ends at 0.4 m",
        ),
        "claim A2.7": claim(
            "the dense inner ring of Fig. 1.3b is near the base",
            "holds, if near the base axis is meant; its points are 0.38 m or more above the base, or 0.18 m or "
            "more below",
            "a view from above hides heights, and no point of the ring is within 0.1 m of the base's height",
        ),
        "claim A2.8": claim("the gaps are caused by the step of 10 deg"),
        "claim A2.9": claim("another range of one joint can make a large difference to the workspace"),
        "claim A2.10": claim(
            "the workspace extends in the horizontal plane like a cylinder",
            "holds, if it means equally far all round the base axis; the higher or lower, the less far out",
            "it goes out to 0.400 m at z = 0.1 m, but only to 0.265 m at z = 0.4 m",
        ),
        "claim A2.11": claim("the outermost points are those of the stretched arm"),
    },
}
