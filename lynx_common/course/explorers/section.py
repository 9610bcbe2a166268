"""Stage of A2: the section of the wrist's workspace that the limits of shoulder and elbow leave."""

import sympy as sp
from IPython.display import HTML

from ... import arm
from ...arm import formulas
from ...symbolic import TASK, WRIST, P, Q
from ..stage import Challenge, Handle, Item, Level, Plane, Slider, Words, largest, least, magnitude, stage
from .branches import arm_from_the_side, side_view
from .solids import about, circle, light, room, values_of

LIMITS = sp.symbols("low_2 high_2 low_3 high_3", real=True)
CLAMPED, LEFT = sp.symbols("clamped_2 clamped_3", real=True), sp.Symbol("left", real=True)
HOME_DEG = (0, 120, -90, 90)


def section_of_limits(geometry: arm.Geometry = arm.LYNX) -> HTML:
    """Sliders for the limits of theta_2 and theta_3; the section that is left, where both elbows reach it darker.

    The wrist is a handle that stops at the border of the section.
    """
    (low_2, high_2, low_3, high_3), (d_1, L_1, L_2, _), size = LIMITS, P, sum(geometry)
    let = {CLAMPED[0]: largest(low_2, least(high_2, Q[1])), CLAMPED[1]: largest(low_3, least(high_3, Q[2]))}
    let[LEFT] = least(high_2 - low_2, high_3 - low_3)
    points = side_view([0, *CLAMPED, sp.pi / 2, 0])
    items: list[Item] = [Level(_within(sign), TASK[1:3], "right", 0.3) for sign in (1, -1)]
    items += [
        circle((0, d_1), L_1 + L_2, "aid"),
        *arm_from_the_side([0, *CLAMPED, sp.pi / 2, 0], size, LEFT, hand=False),
    ]
    far = 1.15 * (geometry.L_1 + geometry.L_2)
    low, high = (-far, geometry.d_1 - far), (far, geometry.d_1 + far)
    view = Plane("r [m]", "z [m]", low, high, round(far / 4.6, 2), items, [_wrist(points[3, :])])
    facts = zip(LIMITS, ("θ₂ from", "θ₂ to", "θ₃ from", "θ₃ to"), HOME_DEG, strict=True)
    sliders = [Slider(symbol, name, -180, 180, home, 5) for symbol, name, home in facts]
    sliders += [Slider(Q[1], "θ₂", -180, 180, 40), Slider(Q[2], "θ₃", -180, 180, -50)]
    words = [Words("No posture is left: each range has to begin before it ends.", when=-LEFT - 1e-9)]
    if geometry.L_1 == geometry.L_2:
        words.append(Words("The section of the wrist has {} cm².", [1e4 * _area()], 1, LEFT))
    title = "The arm in its own plane and what its wrist reaches; sliders for the limits of shoulder and elbow"
    challenges = _challenges(points[3, 1], geometry)
    return stage([view], sliders, words, values_of(P, geometry), title, challenges=challenges, let=let)


def _challenges(height: sp.Expr, geometry: arm.Geometry) -> list[Challenge]:
    _, _, low_3, high_3 = LIMITS
    folded = Challenge(
        "Close the hole about the shoulder.",
        "Closed: with the elbow folded to 180° the wrist touches the shoulder.",
        least(largest(high_3, -low_3) - sp.pi + sp.Float(1e-6), LEFT),
    )
    below = Challenge(
        "Bring the wrist below the floor, with limits that never let the elbow bend upwards (θ₃ > 0).",
        "Below the floor, with the elbow bent one way only.",
        least(-height, -high_3, LEFT),
    )
    return [folded, below] if geometry.L_1 == geometry.L_2 else [below]


def _posture(sign: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """theta_2 and theta_3 of the wrist at (r, z), with theta_3 of this sign; clamped beyond the reach."""
    place = {WRIST[0]: TASK[1], WRIST[1]: TASK[2] - P[0]}
    angles = light(formulas.joint_angles()).xreplace({formulas.SIGMA: sp.sympify(sign)})
    return angles[1].xreplace(place), angles[2].xreplace(place)


def _within(sign: sp.Expr) -> sp.Expr:
    """Not negative where the wrist can be at (r, z), within the limits, with theta_3 of this sign."""
    low_2, high_2, low_3, high_3 = LIMITS
    theta_2, theta_3 = _posture(sign)
    half, middle, rounding = (high_2 - low_2) / 2, (high_2 + low_2) / 2, sp.Float(1e-9)
    reach = room(sp.sqrt(TASK[1] ** 2 + (TASK[2] - P[0]) ** 2), P[1], P[2])
    turned = half + rounding - magnitude(about(theta_2, middle))
    return least(10 * reach, turned, theta_3 - low_3 + rounding, high_3 - theta_3 + rounding)


def _wrist(at: sp.Matrix) -> Handle:
    """The wrist as a handle: the elbow stays bent to its side, and the limits hold."""
    sign = sp.Piecewise((1, CLAMPED[1] > 0), (-1, True))
    slack = _within(sign)
    pairs = zip(Q[1:3], _posture(sign), strict=True)
    moves = {symbol: sp.Piecewise((value, slack >= -sp.Float(1e-6)), (sp.nan, True)) for symbol, value in pairs}
    text = "Here the section ends: a limit of a joint, or full stretch."
    return Handle(at, TASK[1:3], moves, [Words(text, when=-slack)])


def _area() -> sp.Expr:
    r"""The area of the wrist's section, in m^2, for two links of one length.

    At the distance rho the wrist's direction has a range as wide as w, that of theta_2, turned by theta_3/2 to
    one side for theta_3 > 0 and to the other for theta_3 < 0. Together they cover a full turn, less a gap between
    them of |theta_3| - w and one behind of a full turn less w + |theta_3|, where these are not negative. With
    rho d rho = L^2 sin(theta_3) d theta_3 the integral is elementary.
    """
    low_2, high_2, low_3, high_3 = LIMITS
    w, zero = high_2 - low_2, sp.Integer(0)
    first, last = largest(zero, low_3), largest(zero, high_3)  # theta_3 > 0
    other, end = largest(zero, -high_3), largest(zero, -low_3)  # theta_3 < 0, turned about
    both = largest(first, other), largest(largest(first, other), least(last, end))

    def swept(start: sp.Expr, stop: sp.Expr) -> sp.Expr:
        return sp.cos(start) - sp.cos(stop)

    def gap(start: sp.Expr, stop: sp.Expr, threshold: sp.Expr) -> sp.Expr:
        """Integral of (t - threshold) sin t."""
        first, last = (sp.sin(t) - (t - threshold) * sp.cos(t) for t in (start, stop))
        return last - first

    alone = w * (swept(first, last) + swept(other, end) - 2 * swept(*both))
    apart = largest(both[0], least(both[1], w))  # from there on the two ranges leave a gap between them
    round_ = largest(both[0], least(both[1], 2 * sp.pi - w))  # up to there they leave one behind
    full = 2 * sp.pi * swept(*both) - gap(apart, both[1], w) + gap(both[0], round_, 2 * sp.pi - w)
    return P[1] * P[2] * (alone + full)
