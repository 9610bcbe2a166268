"""What is given is read alike everywhere: real numbers of the right shape, or a sentence and never a number."""

import numpy as np
import pytest
import sympy as sp

from lynx_common import arcs, arm, motion, obstacles, reading, rrr, screws, workspace
from lynx_common.errors import InputError

BALL, RING = obstacles.Sphere((0.2, 0, 0.1), 0.1), arcs.annulus(0, 0, 1, 2)
READERS = {  # a function of an array, and the length of its last axis
    "forward_kinematics": (arm.forward_kinematics, 5),
    "joint_angles": (arm.joint_angles, 5),
    "within_limits": (arm.within_limits, 5),
    "jacobian": (arm.jacobian, 5),
    "clearance": (lambda q: obstacles.clearance(q, BALL), 5),
    "distance": (BALL.distance, 3),
    "contains": (RING.contains, 2),
    "distances": (RING.distances, 2),
    "rrr.inverse_kinematics": (rrr.inverse_kinematics, 3),
    "rrr.forward_kinematics": (rrr.forward_kinematics, 3),
    "reachable": (rrr.reachable, 3),
    "elbows": (rrr.elbows, 3),
    "follow": (motion.follow, 5),
    "duration": (lambda q: motion.duration(q, 1, 1), 5),
    "exp": (screws.exp, 6),
}


@pytest.mark.parametrize("name", READERS)
@pytest.mark.parametrize(
    "spoil", [lambda x: x + 0j, lambda x: x[..., :-1], lambda x: 0.5, lambda x: x.astype(str)]
)
def test_no_function_makes_a_number_of_what_is_not_meant(name, spoil):
    function, n = READERS[name]
    good = np.full((4, n), 0.1)
    function(good)
    with pytest.raises(InputError):
        function(spoil(good))


LIMITED = {
    "within_limits": (lambda limits: arm.within_limits(np.zeros(5), limits), 5),
    "into_limits": (lambda limits: arm.into_limits(np.zeros(5), limits), 5),
    "follow": (lambda limits: motion.follow(np.array([[0, 0.3, 0.3, 0, 0]]), limits=limits), 5),
    "sweep": (lambda limits: workspace.sweep(limits, 0.5), 4),
    "section": (workspace.section, 4),
}


@pytest.mark.parametrize("name", LIMITED)
@pytest.mark.parametrize(
    ("spoil", "sentence"),
    [
        (lambda x: x[:1], r"array of finite angles"),
        (lambda x: x[:, ::-1], r"limits of joint 1 are reversed: 1.0000 is above -1.0000 rad"),
        (lambda x: x * np.inf, r"array of finite angles"),
        (lambda x: x + 0j, "Real numbers are expected for limits; complex ones were given"),
    ],
)
def test_limits_are_finite_pairs_in_order(name, spoil, sentence):
    function, joints = LIMITED[name]
    good = np.array([[-1.0, 1.0]] * joints)
    function(good)
    function(good.tolist())
    with pytest.raises(InputError, match=sentence):
        function(spoil(good))


def test_numbers_of_other_kinds_are_read():
    np.testing.assert_array_equal(reading.real([sp.pi, sp.Rational(1, 2), 3], "x"), [np.pi, 0.5, 3])
    assert reading.real([1, 2], "x").dtype == float
    same = np.zeros(3)
    assert reading.real(same, "x", 3) is same


@pytest.mark.parametrize("given", [[sp.I, 1], [sp.Symbol("x"), 1], ["1", "2"], [{}, 1], 1j])
def test_what_is_no_real_number_is_named(given):
    with pytest.raises(InputError, match=r"Real numbers are expected for lengths; .* given"):
        reading.real(given, "lengths")


def test_a_pose_with_nan_is_nan_throughout_and_spoils_no_other():
    poses = np.array([np.eye(4)] * 2)
    poses[0, 0, 3] = np.inf
    read = reading.pose(poses)
    assert np.isnan(read[0]).all()
    np.testing.assert_array_equal(read[1], np.eye(4))
