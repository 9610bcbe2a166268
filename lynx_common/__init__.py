"""What the notebooks of the robot kinematics course share: two robots, and the course around them.

`arm` and `rrr` are the robots. `workspace` finds what the arm reaches, `arcs` regions with exact areas, `motion`
paths and how to follow them, `obstacles` clearance and its certificate, `planner` ways round what is not free;
`screws` has twists and wrenches, `dh` link frames, `symbolic` leads from SymPy to NumPy, `drawing` draws, and
`course` holds ledger, figures, explorers and exercises.
"""
