"""Pictures of the robots, each drawn on the Axes that it is given.

A function that draws computes nothing: it asks the robot's module where things are.
"""

from .arm import arm_3d, arm_side_view, arm_top_view, frames_3d, frames_side_view, gripper, label_joints, move
from .region import region_2d, region_path
from .rrr import label_rrr, move_rrr, rrr_2d
from .scene import ball_3d, determinant_map, screw_3d, tree_2d
from .schema import dh_schema, link_schema, wrist_schema
from .style import COLOURS, space_3d, two_views, use_style

__all__ = [
    "COLOURS",
    "arm_3d",
    "arm_side_view",
    "arm_top_view",
    "ball_3d",
    "determinant_map",
    "dh_schema",
    "frames_3d",
    "frames_side_view",
    "gripper",
    "label_joints",
    "label_rrr",
    "link_schema",
    "move",
    "move_rrr",
    "region_2d",
    "region_path",
    "rrr_2d",
    "screw_3d",
    "space_3d",
    "tree_2d",
    "two_views",
    "use_style",
    "wrist_schema",
]
