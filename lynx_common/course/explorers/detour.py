"""Explorer of B3: an obstacle to be moved, the shortest way around it, and the clearance of gripper and arm."""

from collections.abc import Callable
from typing import NamedTuple

import ipywidgets as widgets
import matplotlib.pyplot as plt
import numpy as np

from ... import arm, drawing, motion
from ...errors import LynxError
from ...obstacles import Sphere, clearance
from .panel import beside, over_a_background, picture_frame, slider

# Points 3 and 4 of the report's Fig. 1.10, in task coordinates, and its obstacle.
START = np.array([0, 0, 0.6, np.pi / 2, 0])
END = np.array([0, -0.2, 0.4, np.pi, 0])
HOME = (-0.2, 0.6, 0.15, 0.03)
RANGES = ((-0.4, 0.2), (0.2, 0.7), (0.02, 0.2), (0.0, 0.08))
SAMPLES = np.linspace(0, 1, 101)


class Way(NamedTuple):
    """A way around the obstacle: task coordinates and joint angles, (n, 5); clearance of gripper and arm, (n,)."""

    task: np.ndarray
    q: np.ndarray
    tip: np.ndarray
    whole: np.ndarray


def detour_explorer() -> widgets.Widget:
    """Sliders (m) for the obstacle's place, its radius and the margin; the way around and its clearance follow."""
    names = ("r", "z", "radius", "margin")
    sliders = [slider(*facts, step=0.01) for facts in zip(names, RANGES, HOME, strict=True)]
    for control in sliders:
        control.style.description_width = "50px"
    words, image, picture = widgets.HTML(), picture_frame(), _detour_view()

    def update(_: object = None) -> None:
        r, z, radius, margin = (control.value for control in sliders)
        try:
            way = _find_way((r, z), radius, margin)
            words.value = _in_words(way)
        except LynxError as fault:
            way, words.value = None, f"<p>{fault}</p>"
        image.value = picture((r, z), radius, margin, way)

    for control in sliders:
        control.observe(update, "value")
    update()
    return beside([*sliders, words], image)


def _find_way(centre: tuple[float, float], radius: float, margin: float) -> Way:
    """The shortest way; raises LynxError where an end cannot be used or the arm cannot follow."""
    task = motion.detour(START, END, centre, radius, margin)(SAMPLES)
    followed, sphere = motion.follow(task), Sphere((centre[0], 0, centre[1]), radius)
    if followed.failure:
        raise followed.failure
    tip = sphere.distance(arm.joint_positions(followed.q)[:, 4])
    return Way(task, followed.q, tip, clearance(followed.q, sphere))


def _detour_view() -> Callable[[tuple[float, float], float, float, Way | None], bytes]:
    fig, (plane, plot) = plt.subplots(1, 2, figsize=(8, 4), layout="constrained")
    links = drawing.arm_side_view(plane, motion.follow(START[None]).q[0])
    plane.set(xlim=(-0.62, 0.42), ylim=(-0.02, 0.92))
    plane.plot(*np.transpose([START[1:3], END[1:3]]), "*", markersize=12, color=drawing.COLOURS["target"])
    ball = plane.add_patch(plt.Circle((0, 0), 0.1, color=drawing.COLOURS["printed"], alpha=0.6))
    ring = plane.add_patch(plt.Circle((0, 0), 0.1, fill=False, linestyle=":", color=drawing.COLOURS["link"]))
    track = plane.plot([], [], color=drawing.COLOURS["z"])[0]
    plot.set(xlim=(0, 1), ylim=(-0.1, 0.4), xlabel="share of the way", ylabel="clearance [m]")
    plot.axhline(0, color=drawing.COLOURS["link"], linewidth=1)
    curves = [plot.plot([], [], style, color=drawing.COLOURS["z"])[0] for style in ("--", "-")]
    asked = plot.plot([0, 1], [0, 0], ":", color=drawing.COLOURS["link"])[0]
    plot.legend([*curves, asked], ["gripper", "whole arm", "margin"], loc="upper right")
    redraw = over_a_background(fig, [ball, ring, track, *links, *curves, asked])

    def picture(centre: tuple[float, float], radius: float, margin: float, way: Way | None) -> bytes:
        for patch, size in ((ball, radius), (ring, radius + margin)):
            patch.set(center=centre, radius=size)
        asked.set_ydata([margin, margin])
        for artist in (track, *links, *curves):
            artist.set_visible(way is not None)
        if way is not None:
            track.set_data(way.task[:, 1], way.task[:, 2])
            for curve, values in zip(curves, (way.tip, way.whole), strict=True):
                curve.set_data(SAMPLES, values)
            drawing.move([], links, way.q[way.whole.argmin()])
        return redraw()

    return picture


def _in_words(way: Way) -> str:
    length = np.hypot(*np.diff(way.task[:, 1:3], axis=0).T).sum()
    facts = (("length of the way", length), ("least clearance, gripper", way.tip.min()))
    rows = [f"<tr><td>{name}</td><td>{value:z.3f} m</td></tr>" for name, value in facts]
    whole = way.whole.min()
    collides = " (the links collide)" if whole < 0 else ""
    rows.append(f"<tr><td>whole arm</td><td>{whole:z.3f} m{collides}</td></tr>")
    return f"<table>{''.join(rows)}</table>"
