"""Stage of Part 2: a platform on three legs, its workspace, its working modes and where the motors do not hold it."""

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
    Handle,
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

SIGMA = sp.symbols("sigma_1:4", real=True)
START = (55.04, 82.43, 0.5726)  # mm, mm, rad; of notebook Part2, section 10: one of four poses of its motor angles
MODE = (1, 1, -1)
LOOSE = 0.01  # of det A, for links of unit length and a platform of unit radius: the motors hardly hold it


def legs_and_modes(geometry: rrr.Geometry = rrr.RRR) -> HTML:
    """The platform to be dragged and turned, and a side for each leg to bend to; workspace, and where det A = 0.

    The formulas are those of ``rrr.inverse_kinematics`` and ``rrr.jacobians``: notebook Part2, sections 2, 4 and 7.
    """
    bends = dict(zip(SIGMA, MODE, strict=True))
    poses = _assembly_modes(geometry)
    home = poses[0] if poses else np.zeros(3)
    closes, det = _closes(), _determinant()
    items = [
        Level(closes, POSE[:2], "right", 0.16),
        Level(sp.Piecewise((det, closes >= 0), (sp.nan, True)), POSE[:2], "x", 0.08, 2, dashed=True),
        *_robot(_angles(), _rooms()),
    ]
    if poses:
        items.insert(2, Line(_platform(poses[1]), "aid", 1.5, dashed=True))
    reach = round(1.0 * (geometry.r_base + 0.55 * geometry.S_A))
    view = Plane("X [mm]", "Y [mm]", (-reach, -reach), (reach, reach), 100, items, _handles(closes))
    far = round(0.8 * geometry.r_base)
    facts = zip(POSE, ("X", "Y", "α"), (far, far, 180), _in_degrees(home), ("mm", "mm", "°"), strict=True)
    controls = [Slider(symbol, name, -high, high, value, 1, unit) for symbol, name, high, value, unit in facts]
    sides = {"left": 1, "right": -1}
    controls += [Choice(s, f"leg {i} bends", sides, bends[s]) for i, s in enumerate(SIGMA, start=1)]
    title = "The 3-RRR robot from above; sliders for the pose of its platform, choices for the bend of each leg"
    challenges = [_loose(closes, det), *([_other_mode(closes, det, poses[1])] if poses else [])]
    return stage([view], controls, _words(closes, det), values_of(DESIGN, geometry), title, challenges=challenges)


def platform_on_legs(
    poses: np.ndarray, theta: np.ndarray, seconds: float, title: str, geometry: rrr.Geometry
) -> HTML:
    """The robot at given poses and motor angles, one after the other."""
    free = dict(zip(sp.symbols("motor_1:4", real=True), THETA, strict=True))
    symbols = list(free)
    reach = round(geometry.r_base + 0.55 * geometry.S_A)
    items = [*_robot(symbols, [sp.Integer(1)] * 3), Line(sp.Matrix([POSE[:2]]), "z", 2, trail=True)]
    view = Plane("X [mm]", "Y [mm]", (-reach, -reach), (reach, reach), 100, items)
    words = [Words("motors at {}°, {}°, {}°", [DEGREES * angle for angle in symbols], 1)]
    words.append(Words("platform at {} mm, {} mm, {}°", [*POSE[:2], DEGREES * POSE[2]], 1))
    columns = dict(zip([*POSE, *symbols], np.concatenate([poses, theta], axis=1).T, strict=True))
    return stage([view], [], words, values_of(DESIGN, geometry), title, Motion(columns, seconds, title))


def _assembly_modes(geometry: rrr.Geometry) -> list[np.ndarray]:
    """The start, and another pose of the same motor angles, mode and sign of det A; nothing where there is none."""
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


def _angles() -> list[sp.Expr]:
    """Motor angles for the bends SIGMA; valid where the leg closes."""
    return [formulas.motor_angle(s, *leg) for s, leg in zip(SIGMA, formulas.legs().tolist(), strict=True)]


def _rooms() -> list[sp.Expr]:
    """For each leg not negative where it closes, in mm."""
    S_A, L, *_ = DESIGN
    return [room(sp.sqrt(x**2 + y**2), S_A, L) for x, y in formulas.legs().tolist()]


def _closes() -> sp.Expr:
    return least(*_rooms())


def _determinant() -> sp.Expr:
    """det A for links of unit length and a platform of unit radius, for the bends SIGMA."""
    _, L, r_platform, *_ = DESIGN
    A = sp.Matrix(3, 3, sp.symbols("A_1:10", real=True))
    det = A.det().xreplace(dict(zip(A, formulas.velocity_rows()[:, :3], strict=True)))
    return (det / (L**3 * r_platform)).xreplace(dict(zip(THETA, _angles(), strict=True)))


def _platform(pose: np.ndarray) -> sp.Matrix:
    corners = formulas.platform_joints().xreplace(dict(zip(POSE, np.round(pose, 6).tolist(), strict=True)))
    return corners.col_join(corners[0, :])


def _robot(theta: list[sp.Expr], rooms: list[sp.Expr]) -> list[Line | Body]:
    """Frame, legs, platform and needle; of a leg that cannot close, the gap between its ends."""
    base, platform = formulas.base_joints(), formulas.platform_joints()
    moved = formulas.driven_links().xreplace(dict(zip(THETA, theta, strict=True)))
    closed = platform.col_join(platform[0, :])
    items = [Line(base.col_join(base[0, :]), "aid", 1.2), Line(closed, "x", 0, filled=True)]
    for i, space in enumerate(rooms):
        start, end, elbow = base[i, :], platform[i, :], base[i, :] + moved[i, :]
        items.append(Line(sp.Matrix.vstack(start, end), "printed", 2, dashed=True, when=-space))
        items.append(Body(sp.Matrix.vstack(start, elbow), 9, "steel", when=space))
        items.append(Body(sp.Matrix.vstack(elbow, end), 7, "pale", when=space))
        items += [Body(elbow, 11, "joint", when=space), Body(start, 15, "joint")]
        items.append(Line(start + sp.Matrix([[14, 14]]), "link", 0, label=str(i + 1)))
    items.append(Body(closed, 8, "x"))
    return [*items, *(Body(platform[i, :], 11, "joint") for i in range(3)), Body(sp.Matrix([POSE[:2]]), 8, "target")]


def _handles(closes: sp.Expr) -> list[Handle]:
    """The needle moves the platform, its first corner turns it; where a leg cannot close they stop."""
    x, y, _ = XYZ
    text = "Leg {} could not close: its ends would be {} mm apart, and it spans{} to{} mm."

    def handle(at: sp.Matrix, moves: dict) -> Handle:
        open_ = closes.xreplace(moves)
        blocked = {symbol: sp.Piecewise((value, open_ >= 0), (sp.nan, True)) for symbol, value in moves.items()}
        S_A, L, *_ = DESIGN
        reasons = []
        for i, ((dx, dy), space) in enumerate(zip(formulas.legs().tolist(), _rooms(), strict=True), start=1):
            span = [sp.sqrt(dx**2 + dy**2).xreplace(moves), sp.Abs(S_A - L), S_A + L]
            reasons.append(Words(text.replace("{}", str(i), 1), span, 1, -space.xreplace(moves) - sp.Float(1e-9)))
        return Handle(at, (x, y), blocked, reasons)

    corner = formulas.platform_joints()[0, :]
    turned = sp.atan2(y - POSE[1], x - POSE[0]) - DESIGN[7]
    return [handle(sp.Matrix([POSE[:2]]), {POSE[0]: x, POSE[1]: y}), handle(corner, {POSE[2]: turned})]


def _words(closes: sp.Expr, det: sp.Expr) -> list[Words]:
    S_A, L, *_ = DESIGN
    words = [Words("motors at {}°, {}°, {}°", [DEGREES * angle for angle in _angles()], 1, closes)]
    for i, ((x, y), space) in enumerate(zip(formulas.legs().tolist(), _rooms(), strict=True), start=1):
        text = f"leg {i} cannot close: its ends are {{}} mm apart, and it spans {{}} to {{}} mm"
        words.append(Words(text, [sp.sqrt(x**2 + y**2), sp.Abs(S_A - L), S_A + L], 1, -space))
    loose, at_border = LOOSE - magnitude(det), sp.Integer(1) - closes
    words += [
        Words("det A = {} (of 1.5 √3 at most)", [det], 3, closes),
        Words("{} mm of slack in the leg that is nearest to its end", [closes], 1, closes),
        Words("type 1: a leg is stretched or folded; the platform has lost a motion", when=least(closes, at_border)),
        Words("type 2: the locked motors do not hold the platform", when=least(closes, loose)),
    ]
    return words


def _loose(closes: sp.Expr, det: sp.Expr) -> Challenge:
    return Challenge(
        "Find a pose at which the locked motors do not hold the platform.",
        "det A = 0: the lines of the three outer links meet, or are parallel.",
        least(closes, LOOSE - magnitude(det)),
    )


def _other_mode(closes: sp.Expr, det: sp.Expr, pose: np.ndarray) -> Challenge:
    """From the start to another pose with the same motor angles, and no singularity on the way."""
    gap = sp.sqrt(sum((symbol - value) ** 2 for symbol, value in zip(POSE[:2], pose[:2].tolist(), strict=True)))
    turn = magnitude(about(POSE[2], sp.Float(float(pose[2]))))
    unbent = -largest(*(magnitude(s - side) for s, side in zip(SIGMA, MODE, strict=True)))
    return Challenge(
        "Bring the platform onto the dashed one, without crossing det A = 0 and with the legs bent as they are.",
        "The motors are where they began, and the platform is not: another assembly mode, and no singularity passed.",
        least(6 - gap, sp.pi / 60 - turn),
        least(closes, det, unbent),
        "A leg opened or bent to the other side, or det A passed zero: reset, and look for a way around.",
    )
