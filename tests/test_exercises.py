"""The exercises: right answers in any form pass, typical wrong ones are told what is wrong, nothing raises."""

import re
import subprocess
import sys
from collections import Counter

import numpy as np
import pytest
import sympy as sp

from lynx_common import arm, dh, rrr, screws, workspace
from lynx_common.course import exercises
from lynx_common.course.exercises import a2, b1, b2, b3, part2, part3
from lynx_common.course.exercises.a1 import ANGLES, CAMERA
from lynx_common.errors import UnknownNameError
from lynx_common.symbolic import P, Q, numeric, tidy

pi = np.pi
theta_1, theta_2 = Q[:2]
d_1, L_1, L_2, _ = P
d_3 = sp.Symbol("d_3")  # without the assumptions of the course's symbols: known by its name
c1, s1, c12, s12 = sp.cos(theta_1), sp.sin(theta_1), sp.cos(theta_1 + theta_2), sp.sin(theta_1 + theta_2)
forearm, gripper = arm.link_frames(ANGLES)[[3, 5]]
in_degrees = arm.link_frames(np.rad2deg(ANGLES))[3]
scara = [dh.Row(L_1, 0, d_1, theta_1), dh.Row(L_2, sp.pi, 0, theta_2), dh.Row(0, 0, d_3, 0)]
quarter = sp.pi / 2
proximal = [dh.Row(0, 0, d_1, Q[0]), dh.Row(0, quarter, 0, Q[1]), dh.Row(L_1, 0, 0, Q[2])]

x, y, z = sp.symbols("x y z")
C = (x**2 + y**2 - L_1**2 - L_2**2) / (2 * L_1 * L_2)


def scara_inverse(C, sign=1):
    """theta_1 and theta_2 of the SCARA arm, with the elbow on one side."""
    q_2 = sign * sp.acos(C)
    return [sp.atan2(y, x) - sp.atan2(L_2 * sp.sin(q_2), L_1 + L_2 * sp.cos(q_2)), q_2]


behind = arm.inverse_kinematics([-0.2, 0.1, 0.3], 0.0)

legs = rrr.inverse_kinematics(part2.POSE)


def span(*pose):
    """Of leg 2, in mm."""
    return rrr.leg_lengths(np.array(pose))[1]


RIGHT = {
    "A2.1": [0.2, [0.2], sp.Rational(1, 5), np.float64(0.20004)],
    "A2.2": [a2.VOLUME, 0.16205, [0.1621]],
    "A2.3": [a2.SCARA.area * 0.15, 0.11815],
    "B1.1": [
        [-1.4455, 1.4455],
        [-np.arccos(0.125), np.arccos(0.125)],
        sp.Matrix([-sp.acos(sp.Rational(1, 8)), sp.acos(sp.Rational(1, 8))]),
    ],
    "B1.2": [b1.ROLL, b1.ROLL + pi, sp.atan2(1, 2.5) - 2 * sp.pi / 3, [-1.7139]],
    "B1.3": [8.36, 8.364, [np.sqrt(8.6**2 - 4)]],
    "B2.1": [
        [0, 0.1, 0.27321],
        sp.Matrix([0, sp.Rational(1, 10), sp.Rational(1, 10) + sp.sqrt(3) / 10]),
        arm.joint_positions(b2.POSTURE)[2],
    ],
    "B2.2": [[0, 1, 0, 1, 1, 1], [False, True, False, True, True, True], np.eye(6)[[1, 3, 4, 5]].sum(axis=0)],
    "B2.3": [
        [-2.2143, 4.4286],
        sp.Matrix([-sp.acos(sp.Rational(-3, 5)), 2 * sp.acos(sp.Rational(-3, 5))]),
        np.deg2rad([-126.8699, 253.7398]),
    ],
    "B3.1": [0.2162, [b3.CLEARANCE], sp.sqrt(10) / 10 - sp.Rational(1, 10)],
    "B3.2": [0.1852, b3.KEEP, sp.sqrt(2) / 20 * (1 + sp.sqrt(1 + 16 / sp.pi**2))],
    "B3.3": [2.06, [2.064], b3.SHORTEST],
    "P2.1": [165.24, [165.237], rrr.leg_lengths(part2.POSE)[1]],
    "P2.2": [
        np.deg2rad([-91.2418, 3.7697, 153.3632]),
        np.round(legs[5], 4).tolist(),
        sp.Matrix(legs[5] + np.array([2, -4, 0]) * pi),
    ],
    "P2.3": [230, [230.0], sp.Integer(230)],
    "P2.4": [np.arccos(0.75), 0.7227, sp.acos(sp.Rational(3, 4))],
    "P3.1": [
        [[2, 2, 1, 1, 3], [3, 4, 3, 3, 4]],
        np.array([[2, 2, 1, 1, 3], [3, 4, 3, 3, 4]]),
        sp.Matrix([[2, 2, 1, 1, 3], [3, 4, 3, 3, 4]]),
        [(2.0, 2, 1, 1, 3), np.array([3, 4, 3, 3, 4])],
    ],
    "P3.2": [[3, 2, 1, 4], np.array([3, 2, 1, 4]), sp.Matrix([3, 2, 1, 4]), (3.0, 2, 1, 4)],
    "P3.4": [[0, 0, 0, 1, 0, 0], [0, 0, 0, 0, -2.5, 0], sp.Matrix([0, 0, 0, 3, 4, 0]), [[0, 0, 0, 0.6, 0.8, 0]]],
    "P3.3": [0.8763, [0.87630], sp.acos(sp.Rational(16, 25))],
    "A3.1": [[0.25, 0, 0.15], sp.Matrix([0.25, 0, 0.15]), [[0.25, 0, 0.15]]],
    "A3.2": [
        behind[2],
        behind[2] + [2 * pi, 0, 0, 0, 1.2],
        np.round(behind[2], 5).tolist(),
    ],
    "A3.3": [
        [*scara_inverse(C), d_1 - z],
        sp.Matrix([*scara_inverse((x * x + y * y - L_1**2 - L_2**2) / L_1 / L_2 / 2), d_1 - z]),
        [
            sp.atan2(y, x) - sp.acos((x**2 + y**2 + L_1**2 - L_2**2) / (2 * L_1 * sp.sqrt(x**2 + y**2))),
            sp.atan2(sp.sqrt(1 - C**2), C),
            d_1 - z,
        ],
    ],
    "A1.1": [
        [pi / 2, 0, 0, pi / 2, 0],
        (pi / 2, 0, 0, pi / 2, 1.234),
        np.array([[-pi / 2, pi, 0, pi / 2, 0]]),
        sp.Matrix([sp.pi / 2, 0, 0, sp.pi / 2, 0]),
        [1.5708, 0, 2 * pi, 1.5708, 0],
    ],
    "A1.2": [
        forearm @ CAMERA,
        (forearm @ CAMERA).tolist(),
        sp.Matrix(dh.chain(arm.dh_table())[2] * dh.trans(-0.1, 0.03, 0)).subs(
            dict(zip((*Q, *P), (*ANGLES, *arm.LYNX), strict=True))
        ),
    ],
    "A1.3": [
        [L_1 * c1 + L_2 * c12, L_1 * s1 + L_2 * s12, d_1 - d_3],
        sp.Matrix([[L_1 * c1 + L_2 * c12, L_1 * s1 + L_2 * s12, d_1 - d_3]]),
        dh.chain(scara)[-1],
        [L_1 * c1 + L_2 * c12, L_1 * s1 + L_2 * s12, d_1 - d_3, 1],
        sp.expand_trig(tidy(dh.chain(scara)[-1][:3, 3])),
    ],
}

WRONG = {
    "A2.1": [
        (..., "not attempted"),
        (0.2 * 2**0.5, "for 90 deg"),
        (0.2 * 3**0.5, "sign of cos"),
        (a2._distance(np.rad2deg(120)), "of 120 rad"),
        (0.04, "its square"),
        (0.1, "L_3 lies beyond"),
        (0, "comes back to the shoulder"),
        (0.3, "more than it should be, by 0.1000 m"),
        ([0.2, 0.2], "shape (2,), where one number is expected"),
    ],
    "A2.2": [
        (..., "not attempted"),
        (a2.SHELL_VOLUME / 2, "half of the shell"),
        (a2.SHELL_VOLUME, "whole shell"),
        (a2.ONE_WAY.volume, "half of the shell"),
        (a2.VOLUME * 1000, "in litres"),
        ((a2.ONE_WAY | a2.ONE_WAY.mirror()).area, "this is an area"),
        (0.15, "less than it should be, by 0.0120 m^3"),
    ],
    "A2.3": [
        (..., "not attempted"),
        (pi * (0.55**2 - 0.3**2 - 0.25**2 - 0.15 * np.cos(145 * pi / 180)) * 0.15, "turns fully"),
        (a2.RING * 260 / 360 * 0.15, "further round"),
        (a2.SCARA.area, "slide makes a volume"),
        (a2.SCARA.volume, "nothing turns about the axis"),
        (a2.SCARA.area * 150, "in litres"),
        (0.2, "more than it should be"),
    ],
    "B1.1": [
        (..., "not attempted"),
        ([-82.82, 82.82], "right in degrees"),
        ([1.4455, -1.4455], "lowest comes first"),
        ([pi / 2 - 1.4455, pi / 2 + 1.4455], "the pitch is 90 deg less"),
        ([-b1.AT_THE_ELBOW, b1.AT_THE_ELBOW], "angle at the shoulder"),
        ([1.4, 1.4], "an interval is expected"),
        ([-1.3455, 1.4455], "the lowest is off by 0.100 rad, the highest by 0.000 rad"),
        (1.4455, "shape (), where (2,) is expected"),
    ],
    "B1.2": [
        (..., "not attempted"),
        (-98.2, "right in degrees"),
        (b1.AZIMUTH - np.deg2rad(30), "along the belt"),
        (-b1.ACROSS, "leaves out theta_1"),
        (b1.ACROSS, "leaves out theta_1"),
        (b1.AZIMUTH, "theta_1 alone"),
        (-b1.ROLL, "the sign"),
        (b1.ROLL + 0.5, "29 deg off"),
    ],
    "B1.3": [
        (..., "not attempted"),
        (np.sqrt(8.6**2 - 3.5**2), "a bucket's length above"),
        (np.sqrt(10.1**2 - 3.5**2), "stretches the bucket"),
        (np.sqrt(8.6**2 - 0.5**2), "counts the depth from the boom's joint"),
        (8.6, "only at the height"),
        (9, "0.64 m too much"),
    ],
    "B2.1": [
        (..., "not attempted"),
        (arm.joint_positions(b2.POSTURE)[3], "this is the wrist"),
        (arm.joint_positions(b2.POSTURE)[4], "this is the gripper"),
        ([0.1, 0, 0.2732], "leaves out theta_1"),
        ([0, 0.1, 0.1732], "d_1 is missing"),
        ([0, 0.1732, 0.2], "sine and cosine are swapped"),
        ([0, 100, 273.2], "right in millimetres"),
        (arm.joint_positions(np.array([90.0, 60, 0, 0, 0]))[2], "cos and sin take radians"),
        ([0, 0.1, 0.2], "0.073 m from the elbow"),
        ([0.1, 0.2], "shape (2,), where (3,) is expected"),
    ],
    "B2.2": [
        (..., "not attempted"),
        ([0, 1, 1, 1, 1, 1], "look at the acceleration for n = 3"),
        ([0, 0, 0, 1, 1, 1], "Look at n = 2"),
        ([1] * 6, "square root"),
        ([1, 0, 1, 0, 0, 0], "swapped"),
        ([2, 4, 5, 6, 0, 0], "each 1 (yes) or 0 (no)"),
        ([2, 4, 5, 6], "shape (4,), where (6,) is expected"),
        ([0, 1, 0, 0, 1, 0], "look again at n = 4, 6"),
    ],
    "B2.3": [
        (..., "not attempted"),
        ([-126.87, 253.74], "right in degrees"),
        ([2.2143, 1.8546], "jumped by half a turn"),
        ([-2.2143, 4.4286 - 2 * pi], "an angle is wrapped"),
        ([-0.9273, 1.8546], "where it starts"),
        ([4.4286, -2.2143], "theta_1 comes first"),
        ([0.9273, -1.8546], "the other elbow"),
        ([0, 0], "this puts the gripper at (0.500, 0.000) m"),
    ],
    "B3.1": [
        (..., "not attempted"),
        (0.3162, "the obstacle has a radius"),
        (b3.TO_LINE - 0.1, "to the infinite line, which runs on beyond the end."),
        (b3.TO_LINE, "beyond the end, and from the centre"),
        (np.sqrt(0.29) - 0.1, "measured to the start"),
        (216.2, "in millimetres"),
        (0.25, "0.0338 m too much"),
    ],
    "B3.2": [
        (..., "not attempted"),
        (b3.KEEP - 0.15, "the largest margin"),
        (b3.KEEP - 0.1 * np.sqrt(2), "the largest height"),
        (0.1932, "for the spline"),
        (0.2, "the ends are at the margin"),
        (185.2, "right in millimetres"),
        (0.18, "0.0052 m too little"),
    ],
    "B3.3": [
        (..., "not attempted"),
        (b3._around(0.28), "it has a radius"),
        (b3._around(0.42), "leaves out the margin"),
        (b3._around(0.25), "leaves out the robot's radius and the margin"),
        (b3._around(0.45, 2 * pi - b3.SEEN), "the far side"),
        (2, "run into the pillar"),
        (3, "0.94 m too much"),
    ],
    "P2.1": [
        (..., "not attempted"),
        (np.linalg.norm(rrr.platform_joints(part2.POSE)[1]), "the leg begins at PB_2"),
        (span(-60, 80, 20 - 6 * pi), "went in as radians"),
        (span(-60, 80, 0), "the span at alpha = 0"),
        (span(-60, 80, -np.deg2rad(20)), "turned the other way"),
        (rrr.leg_lengths(part2.POSE)[0], "this is leg 1"),
        (rrr.leg_lengths(part2.POSE)[2], "this is leg 3"),
        (0.16524, "right in metres"),
        (170, "4.76 mm too much"),
        ([1, 2], "shape (2,), where one number is expected"),
    ],
    "P2.2": [
        (..., "not attempted"),
        (np.rad2deg(legs[5]), "right in degrees"),
        (legs[0], "one elbow for all"),
        (legs[7], "one elbow for all"),
        (legs[2], "every leg bends to the other side"),
        (rrr.inverse_kinematics(part2.POSE, rrr.Geometry(r_base=1e-9))[5], "the base joints are left out"),
        (rrr.inverse_kinematics(part2.POSE, rrr.Geometry(130, 170))[5], "the links are exchanged"),
        (rrr.inverse_kinematics([-60, 80, 0])[5], "alpha is left out"),
        (legs[4], "not yet: leg 3 bends to the other side."),
        (legs[5] + [0.1, 0, 0], "not yet: leg 1 is off."),
        (legs[5][:2], "shape (2,), where (3,) is expected"),
    ],
    "P2.3": [
        (..., "not attempted"),
        (30, "enough at alpha = 0"),
        (350, "S_A is a part of it"),
        (20, "the base joints are left out"),
        (270, "the longest that still folds"),
        (np.hypot(250, 100) - 120, "up to alpha = 90 deg"),
        (0.23, "right in metres"),
        (200, "does not get round"),
        (240, "a shorter link does, too"),
    ],
    "P2.4": [
        (..., "not attempted"),
        (41.41, "right in degrees"),
        (-np.arccos(0.75), "everything mirrored"),
        (np.arccos(-0.375), "that is type 1"),
        (np.arccos(0.875), "the links are exchanged"),
        (0.6193, "the report's robot"),
        (1, "0.2773 rad too much"),
    ],
    "P3.1": [
        (..., "not attempted"),
        ([[2, 2, 1, 1, 3], [2, 2, 1, 1, 3]], "position-singular is taken for singular"),
        ([[2, 2, 1, 1, 3], [3, 3, 2, 2, 4]], "position-singular is taken for singular"),
        ([[2, 2, 1, 1, 3], [3, 3, 3, 3, 4]], "position-singular is taken for singular"),
        ([[2, 3, 2, 2, 3], [3, 4, 3, 3, 4]], "a regular arm is taken for a regular position"),
        ([[2, 2, 2, 2, 3], [3, 4, 3, 3, 4]], "may lose more than one direction"),
        ([[3, 4, 3, 3, 4], [2, 2, 1, 1, 3]], "the rows are exchanged"),
        ([[1, 1, 2, 2, 0], [1, 0, 1, 1, 0]], "the directions lost"),
        ([[2, 2, 1, 2, 3], [3, 4, 3, 4, 4]], "look again at posture 4;"),
        ([[2, 2, 1, 1, 3], [4, 4, 3, 3, 4]], "look again at posture 1;"),
        ([2, 2, 1, 1, 3], "shape (5,), where (2, 5) is expected"),
    ],
    "P3.2": [
        (..., "not attempted"),
        ([4, 1, 2, 3], "backwards"),
        ([2, 1, 0, 3], "counted from 1"),
        ([1, 3, 2, 4], "the sign of the determinant is taken for its size"),
        ([4, 2, 3, 1], "the sign of the determinant is taken for its size"),
        ([2, 3, 4, 1], "the determinant's magnitude"),
        ([1, 4, 3, 2], "the determinant's magnitude"),
        ([2, 4, 1, 3], "the shoulder's value"),
        ([3, 3, 1, 4], "each of the numbers 1 to 4"),
        ([2, 3, 1, 4], "posture 2 is not the nearest"),
        ([3, 1, 2, 4], "the nearest is right"),
        ([3, 2, 1], "shape (3,), where (4,) is expected"),
    ],
    "P3.3": [
        (..., "not attempted"),
        (50.21, "right in degrees"),
        (np.arcsin(0.6), "makes the determinant 0.6"),
        (np.arccos(0.4), "its square root"),
        (pi - part3.LEAN, "the least lean"),
        (0.9763, "0.1000 rad too much"),
    ],
    "P3.4": [
        (..., "not attempted"),
        ([0] * 6, "a wrench of zeros"),
        ([0, 0, 1, 0, 0, 0], "the slide can move along z"),
        ([0, 0, 1, 1, 0, 0], "the slide can move along z"),
        ([0, 0, 0, 0, 0, 1], "turn its gripper about z"),
        ([0, 0, 0, 1, 0, 1], "turn its gripper about z"),
        ([1, 0, 0, 0, 0, 0], "The force comes first"),
        ([0, 1, 0, 1, 0, 0], "a level force"),
        ([1, 0, 0], "shape (3,), where (6,) is expected"),
    ],
    "A3.1": [
        (..., "not attempted"),
        ([0.25, 0, 0.05], "the gripper, not the wrist"),
        ([0.25, 0, -0.05], "the wrist is above"),
        ([0.15, 0, 0.05], "level and outwards"),
        ([0.25, 0, 0.15 - 0.1 + 1e-5], "the gripper, not the wrist"),
        ([0.35, 0, 0.15], "0.100 m from the wrist"),
        ([0.25, 0.2], "shape (2,)"),
    ],
    "A3.2": [
        (..., "not attempted"),
        (np.rad2deg(behind[2]), "right in degrees"),
        (behind[2] - [0, 0, 0, pi / 2, 0], "theta_4 of Table 1.1"),
        (behind[0], "the cable does not allow"),
        (behind[3], "elbow down"),
        (arm.joint_angles([behind[2][0], -np.hypot(0.2, 0.1), 0.3, 0, 0])[0], "seen from the front"),
        ([0, 0, 0, 0, 0], "0.678 m from the object, and its axis is 90 deg off"),
    ],
    "A3.3": [
        (..., "not attempted"),
        ([*scara_inverse(C, -1), d_1 - z], "the other elbow"),
        ([*scara_inverse(C), z - d_1], "d_3 is d_1 - z"),
        ([scara_inverse(C)[0].replace(sp.atan2, lambda b, a: sp.atan(b / a)), sp.acos(C), d_1 - z], "quadrant"),
        ([2 * sp.atan2(y, x) - scara_inverse(C)[0], sp.acos(C), d_1 - z], "taken off, not added"),
        ([scara_inverse(C)[0], sum(scara_inverse(C)), d_1 - z], "counted from the first link"),
        ([scara_inverse(C)[0], sp.acos(3 + C), d_1 - z], "it gives no number"),
        ([scara_inverse(C)[0], 0, z], "seen from above it is off, its height is off"),
        ([Q[0], 0, 0], "holds theta_1"),
    ],
    "A1.1": [
        (..., "not attempted"),
        ([90, 0, 0, 90, 0], "right in degrees"),
        ([pi / 2, 0, 0, 0, 0], "theta_4 of Table 1.1"),
        ([90, 0, 0, 0, 0], "degrees, and theta_4 of Table 1.1"),
        ([0, 0, 0, pi / 2, 0], "theta_1 turns it"),
        ([-pi / 2, 0, 0, pi / 2, 0], "along -y"),
        ([pi / 2, 0, 0], "shape (3,), where (5,)"),
        ([np.nan] * 5, "real and finite"),
        ([1j] * 5, "real and finite"),
        ("up", "numbers are expected"),
        ([Q[0], 0, 0, 0, ...], "numbers are expected"),
        (None, "not attempted"),
        ([1.57, 0, 0, 1.57, 0], "nearly; use np.pi / 2"),
        ([pi / 2, 0, 0, -pi / 2, 0], "0.200 m from its place, and its axis is 180 deg off +y"),
    ],
    "A1.2": [
        (..., "not attempted"),
        (CAMERA @ forearm, "mind the order"),
        (in_degrees @ CAMERA, "as degrees"),
        (gripper @ CAMERA, "sits on the gripper"),
        (arm.link_frames(ANGLES)[4] @ CAMERA, "link before the forearm or after it"),
        (np.linalg.inv(forearm @ CAMERA), "base seen from the camera"),
        ((forearm @ CAMERA).T, "transpose"),
        (numeric(dh.chain(proximal, dh.modified)[2], Q, P)(ANGLES, arm.LYNX) @ CAMERA, "proximal"),
        ((forearm @ CAMERA)[:3, 3], "shape (3,), where (4, 4)"),
        (forearm, "this is frame 3 itself"),
        (forearm @ CAMERA @ CAMERA, "the axes are right, and the origin is 0.104 m from its place"),
        (np.eye(4), "the axes are not right"),
    ],
    "A1.3": [
        (..., "not attempted"),
        (
            [L_1 * c1 + L_2 * sp.cos(theta_2), L_1 * s1 + L_2 * sp.sin(theta_2), d_1 - d_3],
            "counted from the first",
        ),
        ([L_1 * c1 + L_2 * c12, L_1 * s1 + L_2 * s12, d_1 + d_3], "lowers the gripper"),
        (dh.chain(scara, dh.modified)[-1], "in the proximal way"),
        ([L_1 * s1 + L_2 * s12, L_1 * c1 + L_2 * c12, d_1 - d_3], "swapped"),
        (
            [L_1 * c1 + L_2 * c12, L_1 * s1 + L_2 * s12, d_1 + L_2 * sp.sin(theta_2) - d_3],
            "joint axes are vertical",
        ),
        ([L_1 * c1, L_1 * s1], "2 entries, where 3"),
        ([Q[2], 0, 0], "holds theta_3"),
        (lambda q: q, "3 real expressions is expected; one entry is none"),
        ([sp.I * L_1, 0, 0], "one entry is none"),
        ([0, L_1 * s1 + L_2 * s12, d_1], "x is not right, y is right, z is not right"),
    ],
}


def verdict(name, answer, capsys):
    exercises.check(name, answer)
    return capsys.readouterr().out


def test_every_exercise_is_tested():
    assert exercises.catalogue().keys() == RIGHT.keys() == WRONG.keys()


def test_every_notebook_has_three_exercises_or_more():
    count = Counter(name.partition(".")[0] for name in exercises.catalogue())
    assert {"A1", "A2", "A3", "B1", "B2", "B3", "P2"} <= count.keys()
    assert min(count.values()) >= 3


@pytest.mark.parametrize("name", exercises.catalogue())
@pytest.mark.committed_lengths
def test_every_misconception_is_recognised_and_there_are_three_or_more(name):
    """Each by some wrong answer of the table; and a right answer comes in two forms or more."""
    exercise = exercises.catalogue()[name]
    said = {exercise.judge(answer).removeprefix("not yet: ") for answer, _ in WRONG[name]}
    known = [sentence for _, sentence in exercise.misconceptions]
    assert [sentence for sentence in known if sentence not in said] == []
    assert len(known) >= 3
    assert len(RIGHT[name]) >= 2


@pytest.mark.parametrize("name", RIGHT)
@pytest.mark.committed_lengths
def test_a_right_answer_passes_in_any_form(name, capsys):
    for answer in RIGHT[name]:
        assert verdict(name, answer, capsys) == f"{name}: correct.\n", answer


@pytest.mark.parametrize("name", WRONG)
@pytest.mark.committed_lengths
def test_a_wrong_answer_is_told_what_is_wrong(name, capsys):
    for answer, sentence in WRONG[name]:
        said = verdict(name, answer, capsys)
        assert sentence in said, answer
        assert "correct" not in said


@pytest.mark.parametrize("name", exercises.catalogue())
def test_the_worked_solution_is_right(name, capsys):
    namespace = dict(np=np, sp=sp, arm=arm, dh=dh, tidy=tidy, numeric=numeric, q=ANGLES, d_3=d_3)
    namespace |= dict(workspace=workspace, rrr=rrr, screws=screws, x=x, y=y, z=z)
    namespace |= {symbol.name: symbol for symbol in (*Q, *P)} | {"T_0_3": dh.chain(arm.dh_table())[2]}
    shown = exercises.solution(name).data
    exec(shown.split("```python\n")[1].removesuffix("\n```"), namespace)
    answer = namespace[f"answer_{name[-1]}"]  # as the notebook calls it
    assert verdict(name, answer, capsys) == f"{name}: correct.\n"


@pytest.mark.parametrize("name", exercises.catalogue())
def test_there_are_two_hints_and_the_first_points_to_the_second(name, capsys):
    exercises.hint(name)
    assert f'exercises.hint("{name}", 2)' in capsys.readouterr().out
    exercises.hint(name, 2)
    last = capsys.readouterr().out
    assert "hint 2 of 2" in last
    assert "More" not in last
    with pytest.raises(UnknownNameError, match="There is: 1, 2"):
        exercises.hint(name, 3)


STRANGE = ["x", [None] * 3, [None] * 5, {}, {1, 2}, object(), np.nan, [[1], [2, 3]], [sp.zoo] * 3, True]
STRANGE += [
    10**400,
    np.float32(1),
    1j,
    [1j, 1, 2],
    [[sp.eye(1), 2, 3]],
    [sp.nan] * 3,
    [sp.sin, 1, 2],
    [sp.Eq(sp.Symbol("x"), 1), 2, 3],
]


@pytest.mark.parametrize("name", exercises.catalogue())
def test_no_answer_however_strange_stops_the_notebook(name, capsys):
    for answer in STRANGE:
        assert "correct" not in verdict(name, answer, capsys), answer


def test_an_unknown_exercise_gets_the_list_of_known_ones():
    for name in ("A1.9", "X", "", 3):
        known = f"There is no exercise {name!r}. There is: A1.1, A1.2, A1.3"
        with pytest.raises(UnknownNameError, match=re.escape(known)):
            exercises.check(name, 0)


def test_a_notebook_computes_the_answers_of_its_own_exercises_only():
    script = "from lynx_common.course import exercises; import sys; exercises.hint('B1.1'); print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert "exercises.b1" in run.stdout
    assert "exercises.a2" not in run.stdout
