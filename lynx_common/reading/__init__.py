"""The one reader of input: numbers, angles, limits, poses, formulas; or a sentence that says what is wrong.

Text is never taken for a number or a formula, and never evaluated.
"""

from ._kinds import POSE_TOLERANCE, formulas, limits, pose, warn_of_degrees
from ._numbers import batch, finite, named, number, real, shortened, whole
from ._records import Record, length
