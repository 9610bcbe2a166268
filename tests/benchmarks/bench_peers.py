"""The arm's kinematics against other packages: first that all give the same answer, then how long each takes.

A peer that takes one configuration at a time gets fewer in a loop, and its time is scaled to the whole batch.
"""

import numpy as np
import pinocchio
import pytest
from peers import PEERS, TOLERANCE, Peer
from timing import OURS, Tables, side_by_side

from lynx_common import arm, workspace

DEGREE = np.pi / 180
RANGES = DEGREE * np.array([[0, 360], [-90, 90], [-90, 90], [0, 360]])  # report section 1.2
MANY, HUNDRED_THOUSAND = 1_000_000, 100_000

rng = np.random.default_rng(0)
Q = rng.uniform(-np.pi, np.pi, (2 * MANY + 10_000, 5))
# The shoulder faces the gripper, so that its pitch and roll are those that `inverse_kinematics` takes.
Q = Q[arm.task_coordinates(Q)[:, 1] > 0][:MANY]
POSES = arm.forward_kinematics(Q[:2000])
START = Q[:2000] + rng.uniform(-0.1, 0.1, (2000, 5))  # near a solution, which helps the peers' search
TASK = arm.task_coordinates(Q[:HUNDRED_THOUSAND])
POSITION = arm.forward_kinematics(Q[:HUNDRED_THOUSAND])[:, :3, 3].copy()
# How many configurations keep the loop over a peer's function short.
FEW = {"Robotics Toolbox": 2000, "Pinocchio": 2000, "ikpy": 200, "Modern Robotics": 20}

each_peer = pytest.mark.parametrize("peer", PEERS, ids=lambda peer: peer.name)


@pytest.mark.parametrize("geometry", [arm.LYNX, arm.Geometry(0.15, 0.25, 0.18, 0.07)], ids=str)
def test_pinocchio_reads_the_urdf_and_has_the_same_poses(geometry):
    model = pinocchio.buildModelFromXML(arm.urdf(geometry))
    data, gripper = model.createData(), model.getFrameId("gripper")
    assert list(model.names)[1:] == [f"theta_{i}" for i in range(1, 6)]
    assert np.array_equal(np.column_stack([model.lowerPositionLimit, model.upperPositionLimit]), arm.JOINT_LIMITS)
    for q in Q[:1000]:
        pinocchio.framesForwardKinematics(model, data, q)
        assert np.abs(data.oMf[gripper].homogeneous - arm.forward_kinematics(q, geometry)).max() <= 1e-9


@each_peer
def test_the_same_poses(peer: Peer):
    for q, pose in zip(Q[:20], POSES[:20], strict=True):
        assert np.abs(peer.pose(q) - pose).max() <= TOLERANCE
    if peer.poses:
        assert np.abs(peer.poses(Q[:2000]) - POSES).max() <= TOLERANCE
    if peer.wrists:
        assert np.abs(peer.wrists(Q[:20, :4])[:, :3, 3] - arm.joint_positions(Q[:20])[:, 3]).max() <= TOLERANCE


@each_peer
def test_the_same_jacobian(peer: Peer):
    if peer.jacobian is None:
        pytest.skip(f"{peer.name} has none")
    for q, pose in zip(Q[:20], POSES[:20], strict=True):
        assert np.abs(peer.velocity(peer.jacobian(q), pose) - arm.jacobian(q)).max() <= TOLERANCE


@each_peer
def test_a_search_from_nearby_finds_joint_angles_of_the_pose(peer: Peer):
    found = np.array([peer.inverse(POSES[i], START[i]) for i in range(FEW[peer.name])])
    assert np.abs(arm.forward_kinematics(found) - POSES[: len(found)]).max() <= 2 * TOLERANCE


def test_ours_are_four_for_each_pose():
    found = arm.inverse_kinematics(POSITION[:2000], TASK[:2000, 3], TASK[:2000, 4])
    assert np.abs(arm.forward_kinematics(found) - POSES[:, None]).max() <= TOLERANCE


def test_time_of_one_pose(tables: Tables):
    calls = {OURS: lambda: arm.forward_kinematics(Q[0])}
    calls |= {peer.name: lambda peer=peer: peer.pose(Q[0]) for peer in PEERS}
    tables.compare("forward kinematics, one pose", side_by_side(calls))


def test_time_of_a_million_poses(tables: Tables):
    calls, scale = {OURS: lambda: arm.forward_kinematics(Q)}, {}
    for peer in PEERS:
        n = MANY if peer.poses else FEW[peer.name]
        calls[peer.name] = lambda peer=peer, n=n: peer.poses(Q) if peer.poses else looped(peer.pose, Q[:n])
        scale[peer.name] = MANY / n
    tables.compare("forward kinematics, 1,000,000 poses", side_by_side(calls, rounds=5), scale)


def test_time_of_one_inverse(tables: Tables):
    calls = {OURS: lambda: arm.inverse_kinematics(POSITION[0], TASK[0, 3], TASK[0, 4])}
    calls |= {peer.name: lambda peer=peer: peer.inverse(POSES[0], START[0]) for peer in PEERS}
    tables.compare("inverse kinematics, one pose", side_by_side(calls))


def test_time_of_100_000_inverses(tables: Tables):
    calls = {OURS: lambda: arm.inverse_kinematics(POSITION, TASK[:, 3], TASK[:, 4])}
    for peer in PEERS:
        n = FEW[peer.name]
        calls[peer.name] = lambda peer=peer, n=n: [peer.inverse(POSES[i], START[i]) for i in range(n)]
    times = side_by_side(calls, rounds=5)
    scale = {peer.name: HUNDRED_THOUSAND / FEW[peer.name] for peer in PEERS}
    tables.compare("inverse kinematics, 100,000 poses", times, scale)
    for name, factor in scale.items():
        assert factor * np.median(times[name]) > np.median(times[OURS])


def test_time_of_one_jacobian(tables: Tables):
    calls = {OURS: lambda: arm.jacobian(Q[0])}
    calls |= {peer.name: lambda peer=peer: peer.jacobian(Q[0]) for peer in PEERS if peer.jacobian}
    tables.compare("Jacobian, one", side_by_side(calls))


def test_time_of_100_000_jacobians(tables: Tables):
    calls = {OURS: lambda: arm.jacobian(Q[:HUNDRED_THOUSAND])}
    for peer in PEERS:
        if peer.jacobian:
            q = Q[: FEW[peer.name]]
            calls[peer.name] = lambda peer=peer, q=q: looped(peer.jacobian, q)
    scale = {peer.name: HUNDRED_THOUSAND / FEW[peer.name] for peer in PEERS}
    tables.compare("Jacobian, 100,000", side_by_side(calls, rounds=5), scale)


def test_time_of_the_sweep(tables: Tables):
    """Ours at 1 deg, 4,269,446,281 positions of the wrist; a peer's at 10 deg, as in the report, 494,209."""
    turn, half = DEGREE * np.arange(0, 361, 10), DEGREE * np.arange(-90, 91, 10)
    q = np.stack(np.meshgrid(turn, half, half, turn, indexing="ij"), axis=-1).reshape(-1, 4)
    calls, scale = {OURS: lambda: workspace.sweep(RANGES, DEGREE)}, {}
    for peer in PEERS:
        n = len(q) if peer.wrists else FEW[peer.name]
        some = np.column_stack([q[:n], np.zeros(n)])
        calls[peer.name] = lambda peer=peer, some=some: (
            peer.wrists(q)[:, :3, 3] if peer.wrists else looped(peer.pose, some)
        )
        scale[peer.name] = len(q) / n
    tables.compare("sweep of the workspace, ours at 1°, peers at 10°", side_by_side(calls, rounds=5), scale)


def looped(function, q: np.ndarray) -> np.ndarray:
    """``function`` of each row, in an array."""
    out = np.empty((len(q), *function(q[0]).shape))
    for i, row in enumerate(q):
        out[i] = function(row)
    return out
