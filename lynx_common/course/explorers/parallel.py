"""Explorer of Part 2: the 3-RRR robot at a pose, in a working mode, and where in its workspace it is singular."""

from collections.abc import Callable

import contourpy
import ipywidgets as widgets
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D

from ... import drawing, rrr
from ...arcs import Region
from ...errors import AssemblyError
from .panel import beside, over_a_background, picture_frame, slider

HOME = (20, 30, 15)  # X_c, Y_c in mm, alpha in degrees
KINDS = (
    "regular",
    "singular, type 1: a leg is stretched or folded",
    "singular, type 2: the platform is loose",
    "singular, types 1 and 2",
)
LARGEST = 1.5 * 3**0.5  # of det A, for links of unit length and a platform of unit radius


def parallel_explorer(geometry: rrr.Geometry = rrr.RRR) -> widgets.Widget:
    """Sliders for the pose (mm, deg) and a menu for the working mode; robot, workspace and numbers follow."""
    side = float(round(0.8 * geometry.r_base))
    ranges = ((-side, side), (-side, side), (-180, 180))
    sliders = [slider(*facts) for facts in zip(("X_c", "Y_c", "alpha"), ranges, HOME, strict=True)]
    modes = [("".join("-+"[sign > 0] for sign in signs), i) for i, signs in enumerate(rrr.WORKING_MODES)]
    menu = widgets.Dropdown(options=modes, value=0, description="mode")
    menu.style.description_width, menu.layout.width = "40px", "250px"
    words, image, picture = widgets.HTML(), picture_frame(), _views(geometry, side)

    def update(_: object = None) -> None:
        pose = np.array([control.value for control in sliders]) * [1, 1, np.pi / 180]
        region = rrr.constant_orientation_workspace(pose[2], geometry)
        image.value = picture(pose, menu.value, region)
        words.value = _in_words(pose, menu.value, region, geometry)

    for control in (*sliders, menu):
        control.observe(update, "value")
    update()
    return beside([*sliders, menu, words], image)


def determinants(pose: np.ndarray, theta: np.ndarray, geometry: rrr.Geometry) -> tuple[np.ndarray, np.ndarray]:
    """det A for links of unit length and a platform of unit radius, and det B for links of unit length."""
    A, B = rrr.jacobians(pose, theta, geometry)
    S_A, L, r_platform, *_ = geometry
    with np.errstate(invalid="ignore"):  # NaN where the robot cannot be assembled
        return np.linalg.det(A / [L, L, L * r_platform]), np.linalg.det(B / (S_A * L))


def _views(geometry: rrr.Geometry, side: float) -> Callable[[np.ndarray, int, Region], bytes]:
    """The robot, and det A over its workspace with the places where it is zero."""
    fig, (plane, chart) = plt.subplots(1, 2, figsize=(8, 4), layout="constrained")
    empty = rrr.constant_orientation_workspace(np.pi / 2, geometry)
    soft = {"color": drawing.COLOURS["right"], "alpha": 0.3, "linewidth": 0}
    outline = {"facecolor": "none", "edgecolor": drawing.COLOURS["link"]}
    shapes = [drawing.region_2d(plane, empty, **soft), drawing.region_2d(chart, empty, **outline)]
    robot = drawing.rrr_2d(plane, np.zeros(3), np.zeros(3), geometry)
    reach = geometry.r_base + 0.6 * geometry.S_A
    plane.set(xlim=(-reach, reach), ylim=(-reach, reach))
    places = np.linspace(-side, side, 61)
    field, zeros, needle = _chart(chart, side, len(places))
    redraw = over_a_background(fig, [field, *shapes, zeros, needle, *robot])

    def picture(pose: np.ndarray, mode: int, region: Region) -> bytes:
        for shape in shapes:
            shape.set_path(drawing.region_path(region))
        drawing.move_rrr(robot, pose, rrr.inverse_kinematics(pose, geometry)[mode], geometry)
        poses = np.stack(np.broadcast_arrays(*np.meshgrid(places, places), pose[2]), axis=-1)
        det_A, _ = determinants(poses, rrr.inverse_kinematics(poses, geometry)[..., mode, :], geometry)
        field.set_data(det_A)
        masked = np.ma.masked_invalid(det_A)
        zeros.set_segments(contourpy.contour_generator(places, places, masked).lines(0.0))
        needle.set_data(pose[:1], pose[1:2])
        return redraw()

    return picture


def _chart(ax: Axes, side: float, n: int) -> tuple[AxesImage, LineCollection, Line2D]:
    """What moves on the map of det A: its shading, n by n, the lines where it is zero, and the needle."""
    field = ax.imshow(
        np.zeros((n, n)), "PuOr", extent=(-side, side) * 2, origin="lower", vmin=-LARGEST, vmax=LARGEST
    )
    ax.get_figure().colorbar(field, ax=ax, label="det A", shrink=0.8)
    zeros = ax.add_collection(LineCollection([], colors=drawing.COLOURS["link"], linestyles="--"))
    needle = drawing.target(ax, np.zeros(2), markersize=12, markeredgecolor="black", zorder=2)
    ax.set(xlabel="$X_c$ [mm]", ylabel="$Y_c$ [mm]", xlim=(-side, side), ylim=(-side, side))
    return field, zeros, needle


def _in_words(pose: np.ndarray, mode: int, region: Region, geometry: rrr.Geometry) -> str:
    distance = float(region.distances(pose[:2])[0])
    if not len(region.arcs):
        place = "At this turn of the platform there is no workspace at all."
    else:
        inside = rrr.reachable(pose, geometry)
        place = f"{distance:z.1f} mm {'to' if inside else 'outside'} the boundary of the workspace"
    try:
        theta = rrr.solve(pose, mode, geometry=geometry)
    except AssemblyError as fault:
        return f"<p>{fault}</p><p>{place}</p>"
    det_A, det_B = determinants(pose, theta, geometry)
    kind = KINDS[int(rrr.singularity_type(pose, theta, geometry))]
    rows = (
        ("θ₁, θ₂, θ₃", ", ".join(f"{angle:z.1f}°" for angle in np.rad2deg(theta))),
        ("det A", f"{det_A:z.4f}"),
        ("det B", f"{det_B:z.4f}"),
    )
    table = "".join(f"<tr><td>{name}</td><td>{value}</td></tr>" for name, value in rows)
    return f"<table>{table}</table><p>{place}</p><p>{kind}</p>"
