"""Explorers that need no kernel: formulas as they were derived, compiled to JavaScript for the page to draw."""

from collections.abc import Sequence

import numpy as np
import sympy as sp
from IPython.display import HTML

from ... import arm, rrr
from ...drawing import COLOURS
from ...rrr.formulas import THETA, base_joints, driven_links, legs, motor_angle, platform_joints
from ...symbolic import DESIGN, POSE, TASK, WRIST, P, Q
from ..script import Line, Slider, View, Words, page
from .arm import HOME_DEG
from .parallel import HOME

SIGMA = sp.symbols("sigma_1:4", real=True)
DEGREES = 180 / sp.pi
ROUNDING = 1e-8  # of the reach: full stretch counts as reached; a page keeps nine digits of 1 + ROUNDING
PALE = "#b8b8b8"  # the second of two shapes


def arm_page(frames: Sequence[sp.Matrix], geometry: arm.Geometry = arm.LYNX) -> HTML:
    """Sliders for the five joint angles; the arm from the side and from above, and the pose of its gripper.

    ``frames`` : T_0_1 to T_0_5, in the symbols ``arm.Q`` and ``arm.P``, as derived in notebook A1.
    """
    reach = sum(geometry) - geometry.d_1
    shapes = _arm_in_space(frames, 0.08 * sum(geometry))
    side = sp.Matrix([[sp.cos(Q[0]), 0], [sp.sin(Q[0]), 0], [0, 1]])
    above = sp.Matrix([[1, 0], [0, 1], [0, 0]])
    views = []
    for names, seen, middle in (("r [m]", "z [m]"), side, geometry.d_1), (("x [m]", "y [m]"), above, 0):
        lines = [Line(points * seen, colour, width, dots) for points, colour, width, dots in shapes]
        views.append(_square(names, middle, 1.15 * reach, 0.2, lines))
    limits = np.rad2deg(arm.JOINT_LIMITS).round().tolist()
    facts = zip(Q, "₁₂₃₄₅", limits, HOME_DEG, strict=True)
    sliders = [Slider(symbol, f"θ{i}", *limit, home) for symbol, i, limit, home in facts]
    starts = ["T =", *["   "] * 3]
    words = [Words(start + " [{} {} {} {} ]", list(frames[-1][i, :])) for i, start in enumerate(starts)]
    title = "The arm from the side and from above; sliders for its five joint angles"
    return page(views, sliders, words, _values(P, geometry), title, 560)


def _arm_in_space(frames: Sequence[sp.Matrix], size: float) -> list[tuple[sp.Matrix, str, float, float]]:
    """Links, fork and the gripper's axes: points (n, 3), colour, width and dots of each."""
    links = sp.Matrix.vstack(sp.zeros(1, 3), *(T[:3, 3].T for T in frames))
    x, y, z, tip = (frames[-1][:3, i] for i in range(4))
    half, palm = size / 2 * x, tip - size * z
    fork = sp.Matrix.hstack(tip - half, palm - half, palm, palm + half, tip + half).T
    shapes = [(links, COLOURS["link"], 5, 4), (fork, COLOURS["link"], 3, 0)]
    for name, axis in zip("xyz", (x, y, z), strict=True):
        shapes.append((sp.Matrix.hstack(tip, tip + 2 * size * axis).T, COLOURS[name], 2, 0))
    return shapes


def reach_page(wrist: sp.Matrix, cosine: sp.Expr, shoulder: sp.Expr, geometry: arm.Geometry = arm.LYNX) -> HTML:
    """Sliders for r, z and pitch of the gripper; the arm from the side with either elbow, or why there is none.

    The three formulas are those of notebook A3: ``wrist`` is (r_wrist, h) in the symbols of task coordinates,
    ``cosine`` that of theta_3 in r_wrist and h, ``shoulder`` theta_2 in r_wrist, h and theta_3.
    """
    (_, r, z, pitch, _), (d_1, L_1, L_2, _) = TASK, P
    distance = sp.sqrt(wrist.dot(wrist))
    room = _room(distance, L_1, L_2)
    lines = [
        Line(_circle(radius, d_1), COLOURS["aid"], 1, dashed=True) for radius in (L_1 + L_2, sp.Abs(L_1 - L_2))
    ]
    text = "Out of reach: the wrist would be{} m from the shoulder; the links reach from{} to{} m."
    words = [Words(text, [distance, sp.Abs(L_1 - L_2), L_1 + L_2], when=-room), Words("θ₂, θ₃, θ₄", when=room)]
    for sigma, colour, name in ((1, PALE, "light"), (-1, COLOURS["link"], "dark")):
        line, angles = _arm_from_the_side(sigma, wrist, cosine, shoulder, colour, room)
        lines.append(line)
        words.append(Words(f"{name:5} {{}}°, {{}}°, {{}}°", angles, 1, room))
    back = sp.Matrix([[r, z], [wrist[0], d_1 + wrist[1]]])
    lines += [Line(back, COLOURS["target"], 2, dashed=True), Line(back[0, :], COLOURS["target"], 0, dots=6)]
    far = round(sum(geometry) - geometry.d_1, 2)
    sliders = [Slider(r, "r", -far, far, round(0.6 * far, 2), 0.01, "m")]
    home = geometry.d_1 + round(0.2 * far, 2)
    sliders.append(Slider(z, "z", geometry.d_1 - far, geometry.d_1 + far, home, 0.01, "m"))
    sliders.append(Slider(pitch, "pitch", -180, 180, -30))
    view = _square(("r [m]", "z [m]"), geometry.d_1, 1.15 * far, 0.2, lines)
    title = "The arm from the side, with either elbow; sliders for r, z and pitch of its gripper"
    return page([view], sliders, words, _values(P, geometry), title, 400)


def _arm_from_the_side(
    sigma: int, wrist: sp.Matrix, cosine: sp.Expr, shoulder: sp.Expr, colour: str, room: sp.Expr
) -> tuple[Line, list[sp.Expr]]:
    """The arm with theta_3 of the sign sigma, and its angles 2 to 4 in degrees."""
    (_, r, z, pitch, _), (d_1, L_1, *_) = TASK, P
    at_wrist = dict(zip(WRIST, wrist, strict=True))
    theta_3 = sigma * sp.acos(sp.Max(-1, sp.Min(1, cosine)))  # beyond lies only what ROUNDING lets pass
    theta_2 = shoulder.subs(Q[2], theta_3).subs(at_wrist)
    theta_3 = theta_3.subs(at_wrist)
    elbow = [L_1 * sp.cos(theta_2), d_1 + L_1 * sp.sin(theta_2)]
    joints = sp.Matrix([[0, 0], [0, d_1], elbow, [wrist[0], d_1 + wrist[1]], [r, z]])
    angles = [theta_2, theta_3, pitch + sp.pi / 2 - theta_2 - theta_3]
    return Line(joints, colour, 5, dots=4, when=room), [DEGREES * angle for angle in angles]


def rrr_page(geometry: rrr.Geometry = rrr.RRR) -> HTML:
    """Sliders for the platform's pose and for the side to which each leg bends; the legs, or why one cannot close.

    The formulas are those of ``rrr.inverse_kinematics``: notebook Part2, section 2.
    """
    lines = [
        Line(_closed(base_joints()), COLOURS["link"], 1.5),
        Line(_closed(platform_joints()), COLOURS["x"], 3, dots=5),
    ]
    words = []
    for i in range(3):
        more_lines, more_words = _leg(i)
        lines += more_lines
        words += more_words
    lines.append(Line(sp.Matrix([POSE[:2]]), COLOURS["target"], 0, dots=5))
    far = round(geometry.r_base)
    facts = zip(POSE, ("X", "Y", "alpha"), (far, far, 180), HOME, ("mm", "mm", "°"), strict=True)
    sliders = [Slider(symbol, name, -high, high, home, unit=unit) for symbol, name, high, home, unit in facts]
    sliders += [Slider(sigma, f"bend {i}", -1, 1, 1, 2, "") for i, sigma in enumerate(SIGMA, start=1)]
    view = _square(("X [mm]", "Y [mm]"), 0, 1.05 * (geometry.r_base + geometry.S_A), 200, lines)
    title = "The 3-RRR robot from above; sliders for its platform's pose and for the bend of each leg"
    return page([view], sliders, words, _values(DESIGN, geometry), title, 400)


def _leg(i: int) -> tuple[list[Line], list[Words]]:
    S_A, L, *_ = DESIGN
    x, y = legs()[i, :]
    start, end, distance = base_joints()[i, :], platform_joints()[i, :], sp.sqrt(x**2 + y**2)
    angle, room = motor_angle(SIGMA[i], x, y), _room(distance, S_A, L)
    elbow = start + driven_links()[i, :].subs(THETA[i], angle)
    lines = [
        Line(sp.Matrix.vstack(elbow, end), COLOURS["y"], 4, dots=5, when=room),
        Line(sp.Matrix.vstack(start, elbow), COLOURS["z"], 4, dots=5, when=room),
        Line(sp.Matrix.vstack(start, end), COLOURS["printed"], 2, dashed=True, when=-room),
        Line(start, COLOURS["link"], 0, dots=6, label=str(i + 1)),
    ]
    text = f"leg {i + 1} cannot close: its ends are{{}} mm apart, and it spans{{}} to{{}} mm"
    return lines, [
        Words(f"leg {i + 1}: θ ={{}}°", [DEGREES * angle], 1, room),
        Words(text, [distance, sp.Abs(S_A - L), S_A + L], 1, -room),
    ]


def _room(distance: sp.Expr, one: sp.Expr, other: sp.Expr) -> sp.Expr:
    """Not negative where two links of these lengths can span the distance."""
    return sp.Min((one + other) * (1 + ROUNDING) - distance, distance - (1 - ROUNDING) * sp.Abs(one - other))


def _square(names: tuple[str, str], middle: float, half: float, tick: float, lines: list[Line]) -> View:
    return View(*names, (-half, middle - half), (half, middle + half), tick, lines)


def _circle(radius: sp.Expr, height: sp.Expr) -> sp.Matrix:
    turn = 2 * np.pi * np.arange(61) / 60
    rows = np.round([np.cos(turn), np.sin(turn)], 4).T.tolist()
    return sp.Matrix([[radius * cosine, height + radius * sine] for cosine, sine in rows])


def _closed(corners: sp.Matrix) -> sp.Matrix:
    return corners.col_join(corners[0, :])


def _values(symbols: Sequence[sp.Symbol], geometry: Sequence[float]) -> dict[sp.Symbol, float]:
    return dict(zip(symbols, geometry, strict=True))
