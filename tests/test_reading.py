"""What is given is read alike everywhere: real numbers of the right shape, or a sentence and never a number."""

import contextlib
import tracemalloc
import warnings

import numpy as np
import pytest
import sympy as sp

from lynx_common import arcs, arm, dh, motion, obstacles, planner, reading, rrr, screws, symbolic, workspace
from lynx_common.course import exercises, report
from lynx_common.course.stage import Words, javascript, stage
from lynx_common.errors import GeometryError, InputError, LynxError, NotAchievableError
from lynx_common.symbolic import Q

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


NO_NUMBERS = {
    "complex": [sp.I, 1],
    "a symbol": [sp.Symbol("x"), 1],
    "text": ["1", "2"],
    "text among numbers": np.array(["1", 2.0], dtype=object),
    "a dict": [{}, 1],
    "one complex": 1j,
    "None": [1.0, None],
    "only None": np.array([None, None]),
    "truth values": [True, False],
    "a truth value": np.array([True, 2.0], dtype=object),
    "rows of different lengths": [[1, 2], [3]],
    "masked": np.ma.array([1.0, 2.0], mask=[False, True]),
    "bytes": [b"1", 2],
    "a date": np.datetime64("2026-01-01"),
}


@pytest.mark.parametrize("kind", NO_NUMBERS)
def test_what_is_no_real_number_is_named(kind):
    with pytest.raises(InputError, match=r"Real numbers are expected for lengths; .*(given|masked)\."):
        reading.real(NO_NUMBERS[kind], "lengths")


def test_an_array_with_nothing_masked_is_read():
    np.testing.assert_array_equal(reading.real(np.ma.array([1.0, 2.0]), "x"), [1, 2])
    with pytest.raises(InputError, match="masked"):
        obstacles.clearance(np.ma.array(np.zeros(5), mask=[1, 0, 0, 0, 0]), BALL)


@pytest.mark.parametrize("geometry", [arm.Geometry, rrr.Geometry])
@pytest.mark.parametrize("length", [True, np.True_, "0.2", None, 1j, [0.2], np.nan])
def test_a_length_is_a_number(geometry, length):
    name = next(iter(geometry.__dataclass_fields__))
    with pytest.raises(GeometryError, match=f"Geometry: {name} is "):
        geometry(**{name: length})


@pytest.mark.parametrize("robot", [arm, rrr])
def test_a_length_of_another_name_is_told_the_names_there_are(robot):
    known = ", ".join(robot.Geometry.__dataclass_fields__)
    with pytest.raises(GeometryError, match=f"Geometry: L1 is 0.2; there are {known}"):
        robot.Geometry(L1=0.2)


@pytest.mark.parametrize(
    "call",
    [
        lambda: arm.inverse_kinematics([0.2, 0.1, 0.3], 0.0, arm.LYNX),
        lambda: arm.solve([0.2, 0.1, 0.3], 0.0, arm.LYNX),
        lambda: obstacles.clearance(np.zeros(5), BALL, arm.LYNX),
    ],
)
def test_a_geometry_is_not_read_as_numbers(call):
    with pytest.raises(InputError, match="geometry="):
        call()


def test_a_pose_given_for_a_position_is_told_the_way():
    for arguments in ((np.eye(4),), (np.eye(4), arm.LYNX)):
        with pytest.raises(InputError, match=r"task_of_pose\(T\) .* joint_angles"):
            arm.inverse_kinematics(*arguments)


# Degrees given for radians.

FORTY = {  # calls in which an angle is 40
    "forward_kinematics": lambda: arm.forward_kinematics([0, 40, 0, 0, 0]),
    "jacobian": lambda: arm.jacobian([[0, 40, 0, 0, 0]] * 2),
    "task_coordinates": lambda: arm.task_coordinates([0, -40, 0, 0, 0]),
    "joint_angles": lambda: arm.joint_angles([40, 0.2, 0.2, 0, 0]),
    "inverse_kinematics": lambda: arm.inverse_kinematics([0.2, 0.2, 0.2], 40),
    "solve": lambda: arm.solve([0.2, 0, 0.1], 0, 40),
    "within_limits": lambda: arm.within_limits([0, 40, 0, 0, 0]),
    "clearance": lambda: obstacles.clearance([0, 40, 0, 0, 0], BALL),
    "sweep": lambda: workspace.sweep([[0, 0], [0, 40], [0, 0], [0, 0]], 10),
    "section": lambda: workspace.section([[0, 0], [0, 40], [0, 1], [0, 0]]),
    "rrr.elbows": lambda: rrr.elbows([0, 40, 0]),
    "rrr.forward_kinematics": lambda: rrr.forward_kinematics([0, 40, 0]),
    "rrr.inverse_kinematics": lambda: rrr.inverse_kinematics([0, 0, 40]),
    "rrr.Geometry": lambda: rrr.Geometry(base_angles=(40, 160, 280)),
}


def attempt(call):
    """Some of the calls cannot be answered; what counts here is what is said on the way."""
    with contextlib.suppress(LynxError):
        call()


def line_of(call) -> int:
    return call.__code__.co_firstlineno


@pytest.mark.parametrize("name", FORTY)
def test_degrees_given_for_radians_get_a_warning_in_the_callers_line(name):
    with pytest.warns(UserWarning, match=r"= -?(40|280) rad is more than .*; were degrees meant\?") as said:
        attempt(FORTY[name])
    assert {(warning.filename, warning.lineno) for warning in said} == {(__file__, line_of(FORTY[name]))}


def test_two_turns_nan_and_what_is_no_angle_get_no_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        arm.forward_kinematics([4 * np.pi, -4 * np.pi, np.nan, 0, 0])
        arm.forward_kinematics([np.inf, 0, 0, 0, 0])
        arm.joint_angles([0, 40, 40, 0, 0])
        arm.forward_kinematics(np.zeros((0, 5)))


# A pose that was printed with few digits.


def test_a_rounded_pose_is_told_the_way_on():
    T = arm.forward_kinematics([0.3, 0.8, -0.5, 1.2, 0.4]).round(4)
    with pytest.raises(
        InputError, match=r"off by .*e-0\d. If it was rounded, .* U @ V, of U, _, V = np.linalg.svd"
    ):
        arm.task_of_pose(T)
    U, _, V = np.linalg.svd(T[:3, :3])
    T[:3, :3] = U @ V
    with pytest.raises(NotAchievableError, match="If it was rounded, solve for its position"):
        arm.task_of_pose(T)
    with pytest.raises(InputError, match=r"it is off by 7\.6\.$"):
        arm.task_of_pose(2 * T - np.eye(4))


# Text is never evaluated.


class Trap:
    """Text that would leave a trace if anybody evaluated it."""

    def __init__(self, monkeypatch):
        self.sprung = []
        monkeypatch.setattr(reading, "trap", lambda: self.sprung.append(1) or 0, raising=False)

    text = "__import__('lynx_common.reading').reading.trap()"


@pytest.mark.parametrize("wrap", [str, lambda text: [text], lambda text: [[text, 1]], np.array, lambda t: (1, t)])
def test_text_is_never_evaluated(wrap, monkeypatch, capsys):
    trap = Trap(monkeypatch)
    with contextlib.suppress(AttributeError):
        sp.sympify(trap.text)
    assert trap.sprung, "a trap that cannot spring shows nothing"
    trap.sprung.clear()
    given = wrap(trap.text)
    calls = [
        lambda: symbolic.numeric(given, Q),
        lambda: symbolic.tidy(given),
        lambda: dh.standard(dh.Row(given, 0, 0, given)),
        lambda: dh.rot_x(given),
        lambda: dh.trans(0, 0, given),
        lambda: javascript([given], Q),
        lambda: stage([], [], [Words("{}", [given])], {}, ""),
        *(lambda key=key: report.check(key, given) for key in ("eq. 1.5", "Fig. 1.2", "claim A1.1", "Table 1.1")),
    ]
    for call in calls:
        with pytest.raises((LynxError, TypeError)):
            call()
    for name in exercises.catalogue():
        exercises.check(name, given)
    assert "correct" not in capsys.readouterr().out
    assert not trap.sprung


# Work that cannot be done.

WIDE = [[0, 0], [-3, 3], [-3, 3], [-3, 3]]
PLAN = {"free": lambda q: np.ones(len(q), bool), "limits": [[-1, 1]] * 2, "start": [-0.5, 0], "goal": [0.5, 0]}
PATH = motion.line([0, 0.3, 0.3, 0, 0], [0, 0.2, 0.3, 0, 0])(np.linspace(0, 1, 50))
TOO_MUCH = {
    "resolution": (lambda: planner.plan(**PLAN, resolution=1e-20), r"would try 2\.8e\+20"),
    "resolution of a shortcut": (
        lambda: planner.shortcut(PLAN["free"], [[0, 0], [1, 0]], resolution=1e-9),
        "1e.09",
    ),
    "iterations": (lambda: planner.plan(**PLAN, iterations=10**12), "from 1 to 10000000; 1000000000000"),
    "tries": (lambda: planner.shortcut(PLAN["free"], [[0, 0], [1, 0]], tries=10**12), "from 1 to 10000000"),
    "full turns": (lambda: motion.follow(PATH, limits=[[-1e9, 1e9]] * 5), "GB would be needed; 1 GB is allowed"),
    "turns of a roll": (lambda: motion.follow(PATH, limits=[*arm.JOINT_LIMITS[:4], [-1e12, 1e12]]), "GB"),
    "sweep": (lambda: workspace.sweep(WIDE, 1e-4, "gripper"), r"2\.2e\+14 postures would be computed; 1e\+08"),
    "sweep of the wrist": (lambda: workspace.sweep(WIDE, 1e-5), "postures would be computed"),
    "tiny step": (lambda: workspace.sweep(WIDE, 1e-300), "postures would be computed"),
    "voxels": (lambda: workspace.occupancy(workspace.sweep(WIDE, 0.5), 1e-300), "less than a millionth"),
    "boundary": (lambda: RING.boundary(1e-9), r"1\.3e\+10 points; 1e\+07 are allowed"),
    "no step": (lambda: RING.boundary(0), "positive angle"),
}


@pytest.mark.parametrize("name", TOO_MUCH)
def test_work_that_cannot_be_done_is_refused_before_it_is_begun(name):
    call, sentence = TOO_MUCH[name]
    tracemalloc.start()
    try:
        with pytest.raises(InputError, match=sentence):
            call()
        assert tracemalloc.get_traced_memory()[1] < 1e8
    finally:
        tracemalloc.stop()


def test_a_planner_is_not_moved_by_a_free_that_writes_into_its_argument():
    def careless(q):
        q += 0.3
        return np.ones(len(q), bool)

    found = planner.plan(**PLAN | {"free": careless})
    np.testing.assert_array_equal(found.path, [[-0.5, 0], [0.5, 0]])


def test_joint_travel_reads_its_path():
    assert planner.joint_travel(np.array([[3], [0]], np.uint8)) == 3
    with pytest.raises(InputError, match="a path"):
        planner.joint_travel(["a", "b"])


def test_a_pose_with_nan_is_nan_throughout_and_spoils_no_other():
    poses = np.array([np.eye(4)] * 2)
    poses[0, 0, 3] = np.inf
    read = reading.pose(poses)
    assert np.isnan(read[0]).all()
    np.testing.assert_array_equal(read[1], np.eye(4))
