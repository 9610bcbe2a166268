"""The arm as a URDF: read by walking the XML, it has the poses, the limits and the links of the package."""

from xml.etree import ElementTree as xml

import numpy as np
import pytest

from lynx_common import arm
from lynx_common.errors import LynxError

ARMS = [arm.Geometry(), arm.LYNX, arm.Geometry(0.15, 0.25, 0.18, 0.07), arm.Geometry(d_1=0, L_3=0)]


def numbers(text: str) -> np.ndarray:
    return np.array(text.split(), float)


def placed(origin: xml.Element) -> np.ndarray:
    """The pose that an origin writes: turns about fixed x, then y, then z."""
    T, (roll, pitch, yaw) = np.eye(4), numbers(origin.get("rpy"))
    T[:3, :3] = about("z", yaw)[:3, :3] @ about("y", pitch)[:3, :3] @ about("x", roll)[:3, :3]
    T[:3, 3] = numbers(origin.get("xyz"))
    return T


def about(axis: str, angle: float) -> np.ndarray:
    T, i = np.eye(4), "xyz".index(axis)
    j, k = (i + 1) % 3, (i + 2) % 3
    T[j, j] = T[k, k] = np.cos(angle)
    T[k, j], T[j, k] = np.sin(angle), -np.sin(angle)
    return T


def frames(robot: xml.Element, q: np.ndarray) -> dict[str, np.ndarray]:
    """The pose of every link in the frame base, at joint angles ``q``, from the joints as they are written."""
    poses = {"base": np.eye(4)}
    angles = {f"theta_{i + 1}": angle for i, angle in enumerate(q)}
    for joint in robot.findall("joint"):
        T = poses[joint.find("parent").get("link")] @ placed(joint.find("origin"))
        if joint.get("type") == "revolute":
            assert joint.find("axis").get("xyz") == "0 0 1"
            T = T @ about("z", angles[joint.get("name")])
        poses[joint.find("child").get("link")] = T
    return poses


@pytest.mark.parametrize("geometry", ARMS, ids=str)
def test_the_gripper_has_the_pose_of_the_package_and_links_join_the_joints(geometry, rng):
    robot = xml.fromstring(arm.urdf(geometry))
    for q in [np.zeros(5), *rng.uniform(-np.pi, np.pi, (100, 5))]:
        poses = frames(robot, q)
        np.testing.assert_allclose(poses["gripper"], arm.forward_kinematics(q, geometry), rtol=0, atol=1e-12)
        joints = arm.joint_positions(q, geometry)
        for i, name in enumerate(["link_1", "link_2", "link_3", "link_5"]):
            parts = robot.findall(f"link[@name='{name}']/*")
            length = np.linalg.norm(joints[i + 1] - joints[i])
            assert [part.tag for part in parts] == ["visual", "collision"] * int(length > 1e-9)
            for part in parts:
                middle, size = poses[name] @ placed(part.find("origin")), part.find("geometry/cylinder")
                ends = [(middle @ [0, 0, side * float(size.get("length")) / 2, 1])[:3] for side in (-1, 1)]
                np.testing.assert_allclose(ends, joints[i : i + 2], rtol=0, atol=1e-12)
                assert float(size.get("radius")) > 0


def test_it_is_a_tree_with_the_limits_of_the_package_and_all_that_a_reader_asks_for():
    robot = xml.fromstring(arm.urdf())
    links = [link.get("name") for link in robot.findall("link")]
    children = [child.get("link") for child in robot.findall("joint/child")]
    assert links == ["base", *children]
    assert len(set(links)) == 7
    limits = [[float(limit.get(name)) for name in ("lower", "upper")] for limit in robot.findall("joint/limit")]
    np.testing.assert_array_equal(limits, arm.JOINT_LIMITS)
    assert {tuple(limit.keys()) for limit in robot.findall("joint/limit")} == {
        ("lower", "upper", "effort", "velocity")
    }
    names = [joint.get("name") for joint in robot.findall("joint")]
    assert names == ["theta_1", "theta_2", "theta_3", "theta_4", "theta_5", "grip"]


@pytest.mark.parametrize(
    "wrong", [[np.nan, 0.2, 0.2, 0.1], [0.1], None, [0.1, -0.2, 0.2, 0.1], ["1", 1, 1, 1]], ids=str
)
def test_lengths_that_no_arm_has_get_a_sentence(wrong):
    with pytest.raises(LynxError, match=r"lengths|Geometry"):
        arm.urdf(wrong)
