"""Interactive views: sliders beside a picture that follows them.

Each keeps one Matplotlib figure, moves its lines over a background that is drawn once, and hands the picture over
as PNG bytes; that is several times faster than drawing anew, and a notebook that holds one can be re-executed.
The pages (``arm_page`` and its like) need no kernel: they move on the static site, too.
"""

from .arm import arm_explorer
from .detour import detour_explorer
from .joints import joints_and_frames
from .limits import limits_explorer
from .motion import motion_explorer
from .pages import arm_page, reach_page, rrr_page
from .parallel import parallel_explorer
from .reach import reach_explorer
from .singularity import singularity_explorer

__all__ = [
    "arm_explorer",
    "arm_page",
    "detour_explorer",
    "joints_and_frames",
    "limits_explorer",
    "motion_explorer",
    "parallel_explorer",
    "reach_explorer",
    "reach_page",
    "rrr_page",
    "singularity_explorer",
]
