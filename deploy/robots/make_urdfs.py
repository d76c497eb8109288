#!/usr/bin/env python3
"""Makes the URDFs of arm6 and arm7, alone and with the gripper of the demo's cell. With --check it compares them."""
import sys
from math import pi
from pathlib import Path

from generator import arm6, arm7
from generator.urdf import urdf_of, with_gripper
from generator.written import write_or_check

HERE = Path(__file__).resolve().parent
CELL = HERE.parent / "demo" / "lwr_wsg50.urdf"
# How the gripper is turned at the flange [rad]: chosen so that a tool that points down in front of the robot has the orientation
# [1, 0, 0, 0] where the last joint is in the middle of its range, as in the demo's cell.
MOUNTS = {"arm6": -pi / 2, "arm7": 0.0}


def urdfs() -> dict[Path, bytes]:
    files = {}
    for robot in (arm6.robot(), arm7.robot()):
        text = urdf_of(robot)
        files[HERE / robot.name / "urdf" / f"{robot.name}.urdf"] = text.encode()
        files[HERE / f"{robot.name}_gripper.urdf"] = with_gripper(text, CELL.read_text(), MOUNTS[robot.name]).encode()
    return files


if __name__ == "__main__":
    sys.exit(write_or_check(urdfs(), __doc__))
