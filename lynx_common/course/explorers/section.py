"""Stage of A2: the section of the wrist's workspace that the limits of shoulder and elbow leave."""

import sympy as sp
from IPython.display import HTML

from ... import arm
from ...arm import formulas
from ...symbolic import TASK, WRIST, P, Q
from ..stage import Body, Challenge, Handle, Level, Line, Plane, Slider, Words, largest, least, magnitude, stage
from .solids import about, circle, room, values_of

LIMITS = sp.symbols("low_2 high_2 low_3 high_3", real=True)
HOME_DEG = (0, 120, -90, 90)


def section_of_limits(geometry: arm.Geometry = arm.LYNX) -> HTML:
    """Sliders for the limits of theta_2 and theta_3; the section that is left, where both elbows reach it darker.

    The wrist is a handle that stops at the border of the section.
    """
    (low_2, high_2, low_3, high_3), (d_1, L_1, L_2, _) = LIMITS, P
    r, z = TASK[1:3]
    theta_2, theta_3 = (largest(low, least(high, q)) for low, high, q in ((low_2, high_2, Q[1]), (low_3, high_3, Q[2])))
    elbow = sp.Matrix([[L_1 * sp.cos(theta_2), d_1 + L_1 * sp.sin(theta_2)]])
    wrist = elbow + L_2 * sp.Matrix([[sp.cos(theta_2 + theta_3), sp.sin(theta_2 + theta_3)]])
    shoulder, size = sp.Matrix([[0, d_1]]), sum(geometry)
    items = [Level(_left(sign), (r, z), "right", 0.3) for sign in (1, -1)]
    items += [circle((0, d_1), L_1 + L_2, "aid"), Line(sp.Matrix([[0, -9], [0, 9]]), "aid", 1)]
    for start, end, colour, radius in (
        (sp.zeros(1, 2), shoulder, "joint", 0.035),
        (shoulder, elbow, "steel", 0.026),
        (elbow, wrist, "steel", 0.022),
    ):
        items.append(Body(sp.Matrix.vstack(start, end), radius * size, colour))
    items += [Body(point, 0.03 * size, "joint") for point in (shoulder, elbow)]
    far = 1.15 * (geometry.L_1 + geometry.L_2)
    handle = _wrist(wrist)
    view = Plane("r [m]", "z [m]", (-far, geometry.d_1 - far), (far, geometry.d_1 + far), round(far / 4.6, 2), items, [handle])
    facts = zip(LIMITS, ("θ₂ from", "θ₂ to", "θ₃ from", "θ₃ to"), (-180, -180, -180, -180), HOME_DEG, strict=True)
    sliders = [Slider(symbol, name, low, 180, home, 5) for symbol, name, low, home in facts]
    sliders += [Slider(Q[1], "θ₂", -180, 180, 40), Slider(Q[2], "θ₃", -180, 180, -50)]
    equal = geometry.L_1 == geometry.L_2
    area = _area() if equal else sp.nan
    left = least(high_2 - low_2, high_3 - low_3)
    words = [
        Words("The section of the wrist has {} cm².", [1e4 * area], 1, left if equal else -sp.Integer(1)),
        Words("No posture is left: each range has to begin before it ends.", when=-left - sp.Float(1e-9)),
    ]
    challenges = [
        Challenge(
            "Close the hole about the shoulder.",
            "Closed: folded back to 180°, the wrist touches the shoulder.",
            least(_left(1).subs({r: 0.004, z: d_1 + 0.001}), left),
        ) if equal else None,
        Challenge(
            "Let the wrist pass through the floor without letting the elbow bend upwards (θ₃ > 0).",
            "Below the floor, with the elbow bent one way only.",
            least(-wrist[1], -high_3, left),
        ),
    ]  # fmt: skip
    title = "The arm in its own plane and what its wrist reaches; sliders for the limits of shoulder and elbow"
    challenges = [challenge for challenge in challenges if challenge]
    return stage([view], sliders, words, values_of(P, geometry), title, challenges=challenges)


def _posture(sign: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """theta_2 and theta_3 of the wrist at (r, z), with theta_3 of this sign; clamped beyond the reach."""
    place = {WRIST[0]: TASK[1], WRIST[1]: TASK[2] - P[0]}
    angles = formulas.joint_angles().xreplace({formulas.SIGMA: sign})
    return angles[1].xreplace(place), angles[2].xreplace(place)


def _left(sign: sp.Expr) -> sp.Expr:
    """Not negative where the wrist can be at (r, z), within the limits, with theta_3 of this sign."""
    low_2, high_2, low_3, high_3 = LIMITS
    theta_2, theta_3 = _posture(sign)
    half, middle = (high_2 - low_2) / 2, (high_2 + low_2) / 2
    reach = room(sp.sqrt(TASK[1] ** 2 + (TASK[2] - P[0]) ** 2), P[1], P[2])
    turned = half + sp.Float(1e-9) - magnitude(about(theta_2, middle))
    return least(10 * reach, turned, theta_3 - low_3 + sp.Float(1e-9), high_3 - theta_3 + sp.Float(1e-9))


def _wrist(at: sp.Matrix) -> Handle:
    """The wrist as a handle: the elbow stays bent to its side, and the limits hold."""
    sign = sp.Piecewise((1, largest(LIMITS[2], least(LIMITS[3], Q[2])) > 0), (-1, True))
    within = _left(sign) >= -sp.Float(1e-6)
    moves = {
        symbol: sp.Piecewise((value, within), (sp.nan, True))
        for symbol, value in zip(Q[1:3], _posture(sign), strict=True)
    }
    text = "Here the section ends: a limit of a joint, or full stretch."
    return Handle(at, TASK[1:3], moves, [Words(text, when=-_left(sign))])


def _area() -> sp.Expr:
    r"""The area of the wrist's section, in m^2, for two links of one length.

    At the distance rho the wrist's direction has a range of the width w of theta_2, turned by theta_3/2 to one side
    for theta_3 > 0 and to the other for theta_3 < 0; together they cover w + min(w, |theta_3|), and at most a full
    turn. With rho d rho = L^2 sin(theta_3) d theta_3 the integral is elementary.
    """
    low_2, high_2, low_3, high_3 = LIMITS
    w, zero = high_2 - low_2, sp.Integer(0)
    first, last = largest(zero, low_3), largest(zero, high_3)  # theta_3 > 0
    other, end = largest(zero, -high_3), largest(zero, -low_3)  # theta_3 < 0, turned about
    both = largest(first, other), largest(largest(first, other), least(last, end))

    def swept(start: sp.Expr, stop: sp.Expr) -> sp.Expr:
        return sp.cos(start) - sp.cos(stop)

    def beyond(threshold: sp.Expr) -> sp.Expr:
        """Integral of max(0, t - threshold) sin t over ``both``."""
        start = largest(both[0], least(both[1], threshold))
        value = [-(t - threshold) * sp.cos(t) + sp.sin(t) for t in (start, both[1])]
        return value[1] - value[0]

    alone = w * (swept(first, last) + swept(other, end) - 2 * swept(*both))
    full = 2 * sp.pi * swept(*both) - beyond(w) - beyond(2 * sp.pi - w)
    return P[1] * P[2] * (alone + full)
