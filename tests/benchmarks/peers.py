"""The same arm in other packages, each built from its DH table and used in the fastest way that is documented.

None has this arm's inverse kinematics in closed form: each searches, from a start within 0.1 rad of one, for one
solution of one pose, which it is told as a matrix; ours is told position, pitch and roll, and finds all four. All
are asked for the same tolerance.
"""

from collections.abc import Callable
from dataclasses import dataclass

import ikpy.chain
import ikpy.link
import modern_robotics
import numpy as np
import pinocchio
import roboticstoolbox
import sympy as sp

from lynx_common import arm
from lynx_common.symbolic import P

TOLERANCE = 1e-6  # of a pose found by a search; m and rad

# a, alpha, d of each joint
LENGTHS = dict(zip(P, arm.LYNX, strict=True))
TABLE = [[float(sp.sympify(entry).subs(LENGTHS)) for entry in row[:3]] for row in arm.dh_table()]


@dataclass(frozen=True)
class Peer:
    """What a package offers; ``poses`` and ``wrists`` take a whole batch, and are there only where it does.

    ``velocity`` turns its Jacobian, and the pose that goes with it, into the one of (v, omega) at the gripper.
    """

    name: str
    pose: Callable[[np.ndarray], np.ndarray]
    inverse: Callable[[np.ndarray, np.ndarray], np.ndarray]
    jacobian: Callable[[np.ndarray], np.ndarray] | None = None
    poses: Callable[[np.ndarray], np.ndarray] | None = None
    wrists: Callable[[np.ndarray], np.ndarray] | None = None
    velocity: Callable[[np.ndarray, np.ndarray], np.ndarray] = lambda jacobian, pose: jacobian


def robotics_toolbox() -> Peer:
    """Elementary transforms, compiled in C++; its tolerance is on half the squared error."""

    def chain(table: list[list[float]]) -> roboticstoolbox.ETS:
        links = [roboticstoolbox.RevoluteDH(a=a, alpha=alpha, d=d) for a, alpha, d in table]
        return roboticstoolbox.DHRobot(links).ets().compile()

    arm_ets, wrist_ets = chain(TABLE), chain(TABLE[:4])
    return Peer(
        "Robotics Toolbox",
        pose=arm_ets.eval,
        poses=arm_ets.eval,
        wrists=wrist_ets.eval,
        jacobian=arm_ets.jacob0,
        inverse=lambda pose, start: arm_ets.ik_LM(pose, q0=start, tol=TOLERANCE**2).q,
    )


def pinocchio_() -> Peer:
    """One model and its data for all calls; inverse kinematics as in its example, but in full steps."""
    model, joint, place = pinocchio.Model(), 0, pinocchio.SE3.Identity()
    for i, (a, alpha, d) in enumerate(TABLE):
        joint = model.addJoint(joint, pinocchio.JointModelRZ(), place, f"joint {i + 1}")
        place = pinocchio.SE3(pinocchio.utils.rotate("x", alpha), np.array([a, 0, d]))
    tool = model.addFrame(pinocchio.Frame("tool", joint, 0, place, pinocchio.FrameType.OP_FRAME))
    data = model.createData()

    def placement(q: np.ndarray) -> pinocchio.SE3:
        pinocchio.forwardKinematics(model, data, q)
        return pinocchio.updateFramePlacement(model, data, tool)

    def jacobian(q: np.ndarray) -> np.ndarray:
        return pinocchio.computeFrameJacobian(model, data, q, tool, pinocchio.LOCAL_WORLD_ALIGNED)

    def inverse(pose: np.ndarray, q: np.ndarray) -> np.ndarray:
        target = pinocchio.SE3(pose)
        for _ in range(100):
            to_target = placement(q).actInv(target)
            error = pinocchio.log6(to_target).vector
            if np.linalg.norm(error) < TOLERANCE:
                break
            J = pinocchio.computeFrameJacobian(model, data, q, tool, pinocchio.LOCAL)
            J = -pinocchio.Jlog6(to_target.inverse()) @ J
            q = q - J.T @ np.linalg.solve(J @ J.T + 1e-12 * np.eye(6), error)
        return q

    return Peer("Pinocchio", pose=lambda q: placement(q).homogeneous, jacobian=jacobian, inverse=inverse)


def ikpy_() -> Peer:
    """With NumPy and SciPy, which are faster here than its JAX backend; it has no Jacobian for the user."""
    links = [ikpy.link.DHLink(a=a, alpha=alpha, d=d) for a, alpha, d in TABLE]
    chain = ikpy.chain.Chain(links, active_links_mask=[True] * len(links))

    def inverse(pose: np.ndarray, start: np.ndarray) -> np.ndarray:
        return chain.inverse_kinematics_frame(pose, initial_position=start, orientation_mode="all")

    return Peer("ikpy", pose=chain.forward_kinematics, inverse=inverse)


def modern_robotics_() -> Peer:
    """Screws in the base frame; its Jacobian maps to the twist (omega, v) at the base's origin."""
    frames = arm.link_frames(np.zeros(5))
    axes, origins, home = frames[:5, :3, 2], frames[:5, :3, 3], frames[5]
    screws = np.hstack([axes, np.cross(origins, axes)]).T

    def velocity(jacobian: np.ndarray, pose: np.ndarray) -> np.ndarray:
        omega, v = jacobian[:3], jacobian[3:]
        return np.vstack([v + np.cross(omega.T, pose[:3, 3]).T, omega])

    return Peer(
        "Modern Robotics",
        pose=lambda q: modern_robotics.FKinSpace(home, screws, q),
        jacobian=lambda q: modern_robotics.JacobianSpace(screws, q),
        inverse=lambda pose, start: modern_robotics.IKinSpace(screws, home, pose, start, TOLERANCE, TOLERANCE)[0],
        velocity=velocity,
    )


PEERS = [robotics_toolbox(), pinocchio_(), ikpy_(), modern_robotics_()]
