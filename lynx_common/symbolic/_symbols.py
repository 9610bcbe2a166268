"""The symbols of the robots: those that several modules or notebooks use, each made here."""

from math import pi

import sympy as sp

# The five joint angles and the four lengths of the Lynxmotion arm; report Tables 1.2 and 1.3.
Q = sp.symbols("theta_1:6", real=True)
P = sp.symbols("d_1 L_1:4", nonnegative=True)

# What the five joints of the arm set: azimuth of its plane, signed distance from the base axis, height,
# pitch and roll of the gripper; and the wrist in that plane, seen from the shoulder.
TASK = sp.symbols("azimuth r z pitch roll", real=True)
WRIST = sp.symbols("r_wrist h", real=True)

XYZ = sp.symbols("x y z", real=True)  # a position; its z is that of TASK

# One row of a DH table, in general; report eq. (1.1).
ROW = sp.symbols("a alpha d theta", real=True)

# Pose of the 3-RRR's platform, and the robot's design parameters; report Tables 2.1 to 2.3. The angles beta
# are those of the base joints about the origin, gamma those of the platform's joints about its centre.
POSE = sp.symbols("X_c Y_c alpha", real=True)
DESIGN = (
    *sp.symbols("S_A L r_platform r_base", positive=True),
    *sp.symbols("beta_1:4", real=True),
    *sp.symbols("gamma_1:4", real=True),
)

# Of each angle how much (radians) is hardly meant in radians. Joint angles of a motion run on from turn to turn.
ANGLES = dict.fromkeys([*Q, TASK[0], TASK[3], TASK[4]], 4 * pi) | {POSE[2]: 2 * pi}

# What the vectors of symbols are called as arguments of a function.
ARGUMENTS = {Q: "q", Q[:3]: "theta", P: "lengths", TASK: "task", XYZ: "position", POSE: "pose", DESIGN: "design"}
