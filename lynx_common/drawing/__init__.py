"""Pictures of the robots, each drawn on the Axes that it is given.

Where the parts of a robot are is asked of the robot's module; here is only how they are shown.
"""

from ._arm import (
    arm_3d,
    arm_side_view,
    arm_top_view,
    arm_views,
    frames_3d,
    gripper,
    label_joints,
    move,
    target,
)
from ._card import card
from ._region import cloud, region_2d, region_path, squares
from ._rrr import label_rrr, rrr_2d
from ._scene import ball_3d, determinant_map, screw_3d, tree_2d
from ._schema import dh_schema, link_schema, triangle_schema, wrist_schema
from ._style import COLOURS, space_3d, two_views, use_style
