"""Pictures of the robots, each drawn on the Axes that it is given.

A function that draws computes nothing: it asks the robot's module where things are.
"""

from .arm import (
    arm_3d,
    arm_side_view,
    arm_top_view,
    arm_views,
    frames_3d,
    frames_side_view,
    gripper,
    label_joints,
    move,
    target,
)
from .card import card
from .region import cloud, region_2d, region_path, squares
from .rrr import label_rrr, move_rrr, rrr_2d, rrr_outline
from .scene import ball_3d, determinant_map, screw_3d, tree_2d
from .schema import dh_schema, link_schema, triangle_schema, wrist_schema
from .style import COLOURS, space_3d, two_views, use_style

__all__ = [
    "COLOURS",
    "arm_3d",
    "arm_side_view",
    "arm_top_view",
    "arm_views",
    "ball_3d",
    "card",
    "cloud",
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
    "rrr_outline",
    "screw_3d",
    "space_3d",
    "squares",
    "target",
    "tree_2d",
    "triangle_schema",
    "two_views",
    "use_style",
    "wrist_schema",
]
