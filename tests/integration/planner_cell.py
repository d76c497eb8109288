"""The cell of the demo in which the example planner sorts: what a test lays there, and where it stands afterwards."""
import contextlib
import functools
import math
import tempfile
import unittest
from pathlib import Path

import planners  # noqa: F401  (where the planner is)
from cell import DATABASE, NAMES, O_T_C, copy_cell
from geometry import rotate

from planner.table import BODIES

THERE = 0.015  # [m]
FOLDER = tempfile.TemporaryDirectory(prefix="race-test-")


@functools.cache
def cell():
    """The demo's folder, but that its camera is calibrated."""
    return str(copy_cell(Path(FOLDER.name, "cell"), {"database.json": {**DATABASE, "o_t_c": O_T_C}}))


def poses(server):
    """Bodies and joints as they are now (cell_pose.json)."""
    with contextlib.closing(server.stream()) as stream:
        stream.subscribe("cell/pose")
        return stream.message()["data"]


class CellAssertions(unittest.TestCase):
    def assert_at(self, bodies, label, place, within=THERE):
        """The part stands at the place."""
        pose = bodies[NAMES[label]]
        self.assertLess(math.dist(pose["position"][:2], place), within, label)
        self.assertAlmostEqual(pose["position"][2], BODIES[label][1], delta=0.004, msg=label)
        if label != "Cube":
            self.assertGreater(rotate(pose["orientation"], [0, 0, 1])[2], 0.98, f"{label} stands")
