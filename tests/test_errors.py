"""Every error class of the package, by a call that gets it."""

import inspect
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
    errors.UnknownNameError: lambda: exercises.check("A1.9", 0),
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
def test_a_call_gets_this_error_with_its_facts_in_a_sentence(kind):
    error = got(CALLS[kind])
    assert type(error) is kind
    assert str(error)[0].isupper()
    assert str(error).endswith(".")
    facts = vars(error)
    assert facts or kind is errors.InputError
    numbers = [value for value in facts.values() if isinstance(value, int | float)]
    assert np.isfinite(numbers).all()
