"""What the notebooks of the robot kinematics course share: two robots, and the course around them."""
