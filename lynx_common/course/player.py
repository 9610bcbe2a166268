"""A moving picture of the arm that plays in the notebook's page, without a kernel and without a network."""

import html
import json
from pathlib import Path

import numpy as np
from IPython.display import HTML

from ..errors import InputError
from ..reading import real

PAGE = Path(__file__).with_name("player.html").read_text(encoding="utf-8")
FROM_THE_SIDE, FROM_ABOVE = (-1.1, 0.35), (-1.5708, 1.5708)  # turn and tilt of the view, in radians
DIGITS = 4  # decimals of a metre: a tenth of a millimetre


def player(
    points: np.ndarray,
    still: list[np.ndarray] | None = None,
    moving: np.ndarray | None = None,
    seconds: float = 6,
    from_above: bool = False,
    title: str = "The arm in motion",
    radius: float = 0.0,
) -> HTML:
    """A player with a play button, a slider for the time, and a view that is turned by dragging.

    The same input gives the same page, to the letter.

    Parameters
    ----------
    points : array, shape (n, k, 3)
        What to connect in each of n frames, in metres: ``arm.joint_positions(q)``. The last one leaves a trace.
    still : arrays, shape (m, 3)
        Lines that do not move: belts, a planned path.
    moving : array, shape (n, j, 3)
        Items that are drawn as squares; as balls where ``radius``, in metres, is not 0.
    from_above : whether the view opens against z, x to the right and y up, for a robot in the plane
    title : what a reader hears who cannot see it

    Raises InputError where a number is not finite, the shapes do not match, the radius is negative or ``seconds``
    is not above 0.
    """
    points = _finite(points)
    moving = _finite(np.empty((len(points), 0, 3)) if moving is None else moving)
    if points.ndim != 3 or len(moving) != len(points) or not len(points):
        raise InputError(f"Frames (n, k, 3) are expected; {points.shape} and {moving.shape} were given.")
    radius, seconds = real(radius, "the radius of the items"), real(seconds, "the seconds")
    if radius.shape or not 0 <= radius < np.inf:
        raise InputError(f"The radius of the items is finite and not negative; {radius} was given.")
    if seconds.shape or not 0 < seconds < np.inf:
        raise InputError(f"The seconds are a finite number above 0; {seconds} was given.")
    lines = [] if still is None else list(map(_finite, still))
    data = {"radius": radius, "arm": points, "items": moving, "lines": lines, "seconds": seconds}
    numbers = json.dumps(data, default=np.ndarray.tolist, separators=(",", ":"))
    turn, tilt = FROM_ABOVE if from_above else FROM_THE_SIDE
    page = html.escape(PAGE.replace("DATA", numbers).replace("TURN", str(turn)).replace("TILT", str(tilt)))
    return HTML(
        f'<div><iframe srcdoc="{page}" title="{html.escape(title)}; drag to turn the view" '
        'style="width:100%;max-width:680px;height:470px;border:0"></iframe></div>'
    )


def _finite(values: np.ndarray) -> np.ndarray:
    values = real(values, "positions")
    if values.shape[-1:] != (3,) or not np.isfinite(values).all():
        raise InputError("A player needs finite positions, three coordinates each.")
    return np.round(values, DIGITS) + 0.0
