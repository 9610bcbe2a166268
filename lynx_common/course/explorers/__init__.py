"""What a reader moves: stages, which need no kernel, and an explorer of ipywidgets for what cannot be compiled.

A stage draws formulas in the page itself, so that it moves on the static site, too. The explorer keeps one
Matplotlib figure, moves its patches over a background that is drawn once, and hands the picture over as PNG bytes.
"""

from .branches import branches_of_a_target
from .freedom import lost_freedom
from .joints import joints_and_frames
from .legs import legs_and_modes
from .limits import limits_explorer
from .moving import arm_in_motion, platform_in_motion, two_motions
from .pitches import pitches_at_a_point
from .section import section_of_limits
from .thread import thread_around_a_ball
from .top import change_of_branch
