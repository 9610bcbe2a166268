"""The arm as a URDF, the file in which other programs read a robot."""

from math import atan2, hypot
from xml.etree import ElementTree as xml

import sympy as sp

from .. import reading
from ..symbolic import P
from ._geometry import JOINT_LIMITS, LYNX, Geometry, dh_table

THICKNESS = 0.04  # radius of a link, as a share of the arm's length


def urdf(geometry: Geometry = LYNX) -> str:
    """The arm as URDF text: joints theta_1 to theta_5, links as cylinders, and the frame gripper.

    With its joints at ``q`` the gripper has the pose ``forward_kinematics(q, geometry)`` in the frame base. Limits
    are JOINT_LIMITS. What a joint can bear and how fast it is, both of which URDF asks for, is not known: 1 stands
    there. There are no masses. GeometryError or InputError for lengths that no arm has.

    >>> urdf().count("<cylinder")  # link 4 has no length; each other one is there to be seen, and to collide
    8
    """
    if not isinstance(geometry, Geometry):
        geometry = Geometry(*reading.finite(geometry, "the lengths d_1, L_1, L_2, L_3", 4).tolist())
    robot = xml.Element("robot", name="lynxmotion")
    xml.SubElement(robot, "link", name="base")
    parent, end, twist = "base", (0.0, 0.0), 0.0
    lengths = dict(zip(P, geometry, strict=True))
    limits = JOINT_LIMITS.tolist()
    for i, row in enumerate(dh_table(), start=1):
        joint = _joint(robot, f"theta_{i}", "revolute", parent, f"link_{i}", end, twist)
        xml.SubElement(joint, "axis", xyz="0 0 1")
        lower, upper = map(repr, limits[i - 1])
        xml.SubElement(joint, "limit", lower=lower, upper=upper, effort="1", velocity="1")
        a, twist, d = (float(sp.sympify(entry).subs(lengths)) for entry in row[:3])
        parent, end = f"link_{i}", (a, d)
        _cylinder(xml.SubElement(robot, "link", name=parent), end, THICKNESS * sum(geometry))
    _joint(robot, "grip", "fixed", parent, "gripper", end, twist)
    xml.SubElement(robot, "link", name="gripper")
    xml.indent(robot)
    return f'<?xml version="1.0"?>\n{xml.tostring(robot, encoding="unicode")}\n'


def _joint(robot, name: str, kind: str, parent: str, child: str, end: tuple, twist: float) -> xml.Element:
    """A joint at the end (a, 0, d) of its parent, whose z axis is turned by the twist about x."""
    joint = xml.SubElement(robot, "joint", name=name, type=kind)
    xml.SubElement(joint, "parent", link=parent)
    xml.SubElement(joint, "child", link=child)
    xml.SubElement(joint, "origin", xyz=f"{end[0]!r} 0 {end[1]!r}", rpy=f"{twist!r} 0 0")
    return joint


def _cylinder(link: xml.Element, end: tuple[float, float], radius: float) -> None:
    """From the link's origin to its end, unless it has no length."""
    (a, d), length = end, hypot(*end)
    for use in ("visual", "collision") if length else ():
        part = xml.SubElement(link, use)
        xml.SubElement(part, "origin", xyz=f"{a / 2!r} 0 {d / 2!r}", rpy=f"0 {atan2(a, d)!r} 0")
        shape = xml.SubElement(part, "geometry")
        xml.SubElement(shape, "cylinder", length=repr(length), radius=repr(radius))
