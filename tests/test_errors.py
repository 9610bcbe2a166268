"""Every error class of the package, by a call that gets it."""

import inspect
import re
from collections.abc import Callable

import numpy as np
import pytest

from lynx_common import arm, errors, motion, planner, rrr, screws
from lynx_common.course import exercises, report
from lynx_common.errors import LynxError

NEAR, FAR = np.array([[0, 0.3, 0.3, 0, 0], [0, 0.9, 0.3, 0, 0]])  # task coordinates
PROBLEM = np.array([[-1, 1], [-1, 1]]), np.array([-0.5, 0]), np.array([0.5, 0])  # limits, start, goal
OUTWARDS = np.deg2rad([90, 210, 330])  # motors of the 3-RRR


def tilted() -> np.ndarray:
    """A pose whose gripper's axis leaves the arm's plane by 30 deg."""
    pose = arm.forward_kinematics(np.zeros(5))
    return pose @ arm.link_frames(np.deg2rad([30, 0, 0, 0, 0]))[1]


def self_motion() -> np.ndarray:
    """Motor angles that put the elbows on a circle as large as the platform's, so that it can travel."""
    angle = np.arccos(
        (rrr.RRR.r_platform**2 - rrr.RRR.S_A**2 - rrr.RRR.r_base**2) / (2 * rrr.RRR.S_A * rrr.RRR.r_base)
    )
    return np.array(rrr.RRR.base_angles) + angle


CALLS: dict[type[LynxError], Callable] = {
    errors.InputError: lambda: arm.forward_kinematics([0, 0, 1j, 0, 0]),
    errors.GeometryError: lambda: arm.Geometry(L_1=-0.2),
    errors.OutOfReachError: lambda: arm.solve([0.9, 0, 0.3], 0.0),
    errors.JointLimitError: lambda: arm.solve([0.2, 0, -0.1], 0.0),
    errors.NotAchievableError: lambda: arm.task_of_pose(tilted()),
    errors.LedgerError: lambda: report.check("Fig. 1.2", np.zeros(3)),
    errors.UnknownNameError: lambda: exercises.find("A1.9"),
    errors.JumpError: lambda: motion.duration(np.outer([0, 2, 4, 6], np.ones(5)), 1.0, 1.0),
    errors.PathError: lambda: motion.follow(motion.line(NEAR, FAR)(np.linspace(0, 1, 50))).failure,
    errors.CollisionError: lambda: (
        got(lambda: motion.detour(NEAR, NEAR + [0, 0.05, 0, 0, 0], (0.3, 0.3), 0.1)).cause
    ),
    errors.EndpointError: lambda: motion.detour(NEAR, FAR, (0.3, 0.5), 0.1),
    errors.AssemblyError: lambda: rrr.solve([300, 0, 0]),
    errors.NoPoseError: lambda: rrr.assemble(OUTWARDS, [0, 0, 0]),
    errors.SelfMotionError: lambda: rrr.assemble(self_motion(), [0, 0, 0]),
    errors.ScrewError: lambda: screws.revolute([0, 0, 2], [0, 0, 0]),
    errors.NoPathError: lambda: planner.plan(lambda q: np.abs(q[:, 0]) > 0.1, *PROBLEM, iterations=20),
    errors.WrongAnswerError: lambda: exercises.assert_right("A1.1", [0, 0, 0, 0, 0]),
    errors.NotFreeError: lambda: got(lambda: planner.plan(lambda q: q[:, 0] < 0, *PROBLEM)).cause,
}


def got(call: Callable) -> LynxError:
    """The error that a call raises, or hands back."""
    try:
        return call()
    except LynxError as error:
        return error


def test_no_error_is_missing_here():
    classes = {c for _, c in inspect.getmembers(errors, inspect.isclass) if issubclass(c, LynxError)}
    assert classes - {LynxError} == CALLS.keys()


@pytest.mark.parametrize("kind", CALLS, ids=lambda kind: kind.__name__)
@pytest.mark.committed_lengths
def test_a_call_gets_this_error_with_its_facts_in_a_sentence(kind):
    error = got(CALLS[kind])
    assert type(error) is kind
    assert str(error)[0].isupper()
    assert str(error).endswith(".")
    facts = vars(error)
    assert facts or kind is errors.InputError
    numbers = [value for value in facts.values() if isinstance(value, int | float)]
    assert np.isfinite(numbers).all()


# A sentence does not contradict itself by rounding.

TINY = (1e-3, 1e-6, 1e-9, 1e-12)
LIMIT = np.deg2rad(150)
CLOSE: dict[type[LynxError], Callable[[float], LynxError]] = {
    errors.OutOfReachError: lambda e: errors.OutOfReachError(0.4 + e, 0.0, 0.4),
    errors.JointLimitError: lambda e: errors.JointLimitError(3, LIMIT + e, -LIMIT, LIMIT),
    errors.NotAchievableError: lambda e: errors.NotAchievableError(e),
    errors.JumpError: lambda e: errors.JumpError(4, 1, np.pi / 2 + e, np.pi / 2),
    errors.CollisionError: lambda e: errors.CollisionError(0.03 - e, 0.03),
    errors.AssemblyError: lambda e: errors.AssemblyError([1, 3], [300 + e, 300 + 2 * e], 40, 300),
    errors.NoPathError: lambda e: errors.NoPathError(10, 4, e),
    errors.ScrewError: lambda e: errors.ScrewError("An axis must be a unit vector", 1 + e),
}


@pytest.mark.parametrize("kind", CLOSE, ids=lambda kind: kind.__name__)
@pytest.mark.parametrize("miss", TINY)
def test_numbers_that_differ_look_different(kind, miss):
    """The number that fails is neither shown as its limit, nor as zero."""
    sentence = str(CLOSE[kind](miss))
    numbers = [float(number) for number in re.findall(r"(?<![\w.])-?\d+\.?\d*(?=[ .]\w|\.$)", sentence)]
    told = [float(text) for text in re.findall(r"-?\d+\.\d+", sentence)]
    first = told[0]
    assert first != 0
    assert all(first != other for other in numbers[numbers.index(first) + 1 :] if kind is not errors.AssemblyError)
    if kind is errors.AssemblyError:
        assert len({*told}) == 4


def test_an_obstacle_is_never_0_m_deep():
    assert str(errors.CollisionError(-1e-7, 0.03)) == "It is 0.0000001 m deep in the obstacle."


def test_equal_numbers_look_equal_and_few_digits_suffice_where_they_do():
    assert errors.told_apart(0.1, 0.25, 0.1) == ["0.1000", "0.2500", "0.1000"]
    assert errors.told_apart(-1e-9, decimals=2) == ["-0.000000001"]
    assert errors.told_apart(np.nan, np.inf, 1) == ["nan", "inf", "1.0000"]
    assert errors.told_apart(-0.0) == ["0.0000"]
