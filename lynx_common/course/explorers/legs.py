"""Stage of Part 2: a platform on three legs, its workspace, working modes, and where the motors do not hold it."""

from collections.abc import Sequence

import numpy as np
import sympy as sp
from IPython.display import HTML

from ... import rrr
from ...rrr import formulas
from ...rrr.formulas import THETA
from ...symbolic import DESIGN, POSE, XYZ
from ..stage import (
    Body,
    Challenge,
    Choice,
    Control,
    Handle,
    Item,
    Level,
    Line,
    Motion,
    Plane,
    Slider,
    Words,
    largest,
    least,
    magnitude,
    stage,
)
from .solids import DEGREES, about, room, values_of

SIGMA, ANGLES = sp.symbols("sigma_1:4", real=True), sp.symbols("motor_1:4", real=True)
SPANS, ROOMS = sp.symbols("span_1:4", real=True), sp.symbols("room_1:4", real=True)
CLOSES, DET = sp.symbols("closes det_A", real=True)
START = (55.04, 82.43, 0.5726)  # mm, mm, rad; of notebook Part2, section 9: one of four poses of its motor angles
MODE = (1, 1, -1)
LOOSE = 0.01  # of det A, for links of unit length and a platform of unit radius: the motors hardly hold it


def legs_and_modes(geometry: rrr.Geometry = rrr.RRR) -> HTML:
    """The platform to be dragged and turned, and a side for each leg to bend to; workspace, and where det A = 0.

    The formulas are those of ``rrr.inverse_kinematics`` and ``rrr.jacobians``; notebook Part2.
    """
    poses = _assembly_modes(geometry)
    home = poses[0] if poses else np.zeros(3)
    held = sp.Piecewise((DET, CLOSES >= 0), (sp.nan, True))
    items: list[Item] = [Level(CLOSES, POSE[:2], "right", 0.16), Level(held, POSE[:2], "x", 0.08, 2, dashed=True)]
    items += [Line(_platform(pose), "aid", 1.5, dashed=True) for pose in poses[1:]]
    items += _robot(ANGLES, ROOMS)
    reach, far = round(geometry.r_base + 0.35 * geometry.S_A), round(0.8 * geometry.r_base)
    view = Plane("X [mm]", "Y [mm]", (-reach, -reach), (reach, reach), 100, items, _handles())
    facts = zip(POSE, ("X", "Y", "alpha"), (far, far, 180), _in_degrees(home), ("mm", "mm", "°"), strict=True)
    controls: list[Control] = [Slider(s, name, -high, high, at, 1, unit) for s, name, high, at, unit in facts]
    sides = {"left": 1, "right": -1}
    controls += [Choice(s, f"leg {i}", sides, side) for i, s, side in zip((1, 2, 3), SIGMA, MODE, strict=True)]
    title = "The 3-RRR robot from above; sliders for the pose of its platform, choices for the bend of each leg"
    challenges = [_loose(), *(_other_mode(pose) for pose in poses[1:])]
    fixed, let = values_of(DESIGN, geometry), _names()
    return stage([view], controls, _words(), fixed, title, challenges=challenges, let=let)


def _names() -> dict[sp.Symbol, sp.Expr]:
    """For the bends SIGMA: lengths and slack of the legs, motor angles, det A without its units, by name."""
    S_A, L, r_platform, *_ = DESIGN
    legs = formulas.legs().tolist()
    let = {span: sp.sqrt(x**2 + y**2) for span, (x, y) in zip(SPANS, legs, strict=True)}
    let |= {slack: room(span, S_A, L) for slack, span in zip(ROOMS, SPANS, strict=True)} | {CLOSES: least(*ROOMS)}
    let |= {q: formulas.motor_angle(s, *leg) for q, s, leg in zip(ANGLES, SIGMA, legs, strict=True)}
    rows = formulas.velocity_rows()[:, :3].xreplace(dict(zip(THETA, ANGLES, strict=True)))
    entries = sp.symbols("A_1:10", real=True)
    return (
        let | dict(zip(entries, rows, strict=True)) | {DET: sp.Matrix(3, 3, entries).det() / (L**3 * r_platform)}
    )


def platform_on_legs(
    poses: np.ndarray, theta: np.ndarray, seconds: float, title: str, geometry: rrr.Geometry
) -> HTML:
    """The robot at given poses and motor angles, one after the other."""
    reach = round(geometry.r_base + 0.55 * geometry.S_A)
    items = [*_robot(ANGLES, [sp.Integer(1)] * 3), Line(sp.Matrix([POSE[:2]]), "z", 2, trail=True)]
    view = Plane("X [mm]", "Y [mm]", (-reach, -reach), (reach, reach), 100, items)
    words = [Words("motors at {}°, {}°, {}°", [DEGREES * angle for angle in ANGLES], 1)]
    words.append(Words("platform at {} mm, {} mm, {}°", [*POSE[:2], DEGREES * POSE[2]], 1))
    columns = dict(zip([*POSE, *ANGLES], np.concatenate([poses, theta], axis=1).T, strict=True))
    return stage([view], [], words, values_of(DESIGN, geometry), title, Motion(columns, seconds, title))


def _assembly_modes(geometry: rrr.Geometry) -> list[np.ndarray]:
    """The start, and another pose of the same motor angles, mode and sign of det A; or nothing."""
    start, mode = np.array(START), rrr.WORKING_MODES.index(MODE)
    theta = rrr.inverse_kinematics(start, geometry)[mode]
    if np.isnan(theta).any():
        return []
    for pose in rrr.forward_kinematics(theta, geometry):
        far = np.abs(pose[2] - start[2]) > 0.1
        if far and np.allclose(rrr.inverse_kinematics(pose, geometry)[mode], theta):
            A, here = (rrr.jacobians(p, theta, geometry)[0] for p in (pose, start))
            if np.linalg.det(A) * np.linalg.det(here) > 0:
                return [start, pose]
    return []


def _in_degrees(pose: np.ndarray) -> list[float]:
    return np.round(pose * [1, 1, 180 / np.pi]).tolist()


def _platform(pose: np.ndarray) -> sp.Matrix:
    corners = formulas.platform_joints().xreplace(dict(zip(POSE, np.round(pose, 6).tolist(), strict=True)))
    return corners.col_join(corners[0, :])


def _robot(theta: Sequence[sp.Expr], rooms: Sequence[sp.Expr]) -> list[Item]:
    """Frame, legs, platform and needle; of a leg that cannot close, the gap between its ends."""
    base, platform = formulas.base_joints(), formulas.platform_joints()
    moved = formulas.driven_links().xreplace(dict(zip(THETA, theta, strict=True)))
    closed = platform.col_join(platform[0, :])
    items: list[Item] = [Line(base.col_join(base[0, :]), "aid", 1.2), Line(closed, "x", 0, filled=True)]
    for i, space in enumerate(rooms):
        start, end, elbow = base[i, :], platform[i, :], base[i, :] + moved[i, :]
        items.append(Line(sp.Matrix.vstack(start, end), "printed", 2, dashed=True, when=-space))
        items.append(Body(sp.Matrix.vstack(start, elbow), 9, "steel", when=space))
        items.append(Body(sp.Matrix.vstack(elbow, end), 7, "pale", when=space))
        items += [Body(elbow, 11, "joint", when=space), Body(start, 15, "joint")]
        items.append(Line(start + sp.Matrix([[14, 14]]), "link", 0, label=str(i + 1)))
    items.append(Body(closed, 8, "x"))
    return [
        *items,
        *(Body(platform[i, :], 11, "joint") for i in range(3)),
        Body(sp.Matrix([POSE[:2]]), 8, "target"),
    ]


def _handles() -> list[Handle]:
    """The needle moves the platform, its first corner turns it; where a leg cannot close they stop."""
    (x, y, _), (S_A, L, *_), legs = XYZ, DESIGN, formulas.legs().tolist()

    def handle(at: sp.Matrix, moves: dict[sp.Symbol, sp.Expr]) -> Handle:
        spans = [sp.sqrt(dx**2 + dy**2).xreplace(moves) for dx, dy in legs]
        rooms = [room(span, S_A, L) for span in spans]
        blocked = {
            symbol: sp.Piecewise((value, least(*rooms) >= 0), (sp.nan, True)) for symbol, value in moves.items()
        }
        text = "Leg {} could not close: its ends would be {{}} mm apart, and it spans {{}} to {{}} mm."
        facts = zip((1, 2, 3), spans, rooms, strict=True)
        reasons = [
            Words(text.format(i), [span, magnitude(S_A - L), S_A + L], 1, -r - 1e-9) for i, span, r in facts
        ]
        return Handle(at, (x, y), blocked, reasons)

    turned = sp.atan2(y - POSE[1], x - POSE[0]) - DESIGN[7]
    corner = formulas.platform_joints()[0, :]
    return [handle(sp.Matrix([POSE[:2]]), {POSE[0]: x, POSE[1]: y}), handle(corner, {POSE[2]: turned})]


def _words() -> list[Words]:
    S_A, L, *_ = DESIGN
    words = [Words("motors at {}°, {}°, {}°", [DEGREES * angle for angle in ANGLES], 1, CLOSES)]
    for i, (span, slack) in enumerate(zip(SPANS, ROOMS, strict=True), start=1):
        text = f"leg {i} cannot close: its ends are {{}} mm apart, and it spans {{}} to {{}} mm"
        words.append(Words(text, [span, magnitude(S_A - L), S_A + L], 1, -slack))
    return [
        *words,
        Words("det A / (L³ r_platform) = {}, at most 2.598", [DET], 3, CLOSES),
        Words("{} mm from the leg that is nearest to stretched or folded", [CLOSES], 1, CLOSES),
        Words(
            "type 1: a leg is stretched or folded; the platform has lost a motion", when=least(CLOSES, 1 - CLOSES)
        ),
        Words("type 2: the locked motors do not hold the platform", when=least(CLOSES, LOOSE - magnitude(DET))),
    ]


def _loose() -> Challenge:
    return Challenge(
        "Find a pose at which the locked motors do not hold the platform.",
        "det A = 0: the lines of the three outer links meet, or are parallel.",
        least(CLOSES, LOOSE - magnitude(DET)),
    )


def _other_mode(pose: np.ndarray) -> Challenge:
    """From the start to another pose with the same motor angles, and no singularity on the way."""
    gap = sp.sqrt(sum((symbol - value) ** 2 for symbol, value in zip(POSE[:2], pose[:2].tolist(), strict=True)))
    turn = magnitude(about(POSE[2], sp.Float(float(pose[2]))))
    unbent = -largest(*(magnitude(s - side) for s, side in zip(SIGMA, MODE, strict=True)))
    return Challenge(
        "Bring the platform onto the dashed one without crossing det A = 0, the legs bent as they are.",
        "The motors are where they began, the platform is not: another assembly mode, no singularity between.",
        least(6 - gap, sp.pi / 60 - turn),
        least(CLOSES, DET, unbent),
        "A leg opened or bent to the other side, or det A passed zero: reset, and look for a way around.",
    )
