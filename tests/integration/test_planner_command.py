"""The example planner as a program: what is wrong with its command line or with its cell, and what ends it."""
import tempfile
import time
import unittest
from pathlib import Path

import planners
from cell import DATABASE, copy_cell
from client import Server
from planner_cell import FOLDER, CellAssertions, cell, poses
from python_clients import race_client

from planner.goal import Goal
from planner.table import Table, lay


def goal_file(text):
    path = Path(tempfile.mkdtemp(dir=FOLDER.name), "goal.json")
    path.write_text(text)
    return str(path)


CUBE = '{"parts": {"Cube": "A1"}}'


class CommandLine(unittest.TestCase):
    def test_says_what_is_wrong_with_it(self):
        for options, expected in ((["--goal", goal_file("{}")], "goal.json: parts: an object"), ([], "one of the arguments"),
                                  (["--goal", goal_file("[")], "goal.json: Expecting value"), (["--goal", "/none.json"], "No such file"),
                                  (["--seed", "1", "--server", "http://example.com"], "another machine is reached by https")):
            with self.subTest(options):
                status, lines = planners.plan(None, *options)
                self.assertEqual(status, 2, lines)
                self.assertIn(expected, lines[-1])

    def test_without_a_server_it_is_refused(self):
        status, lines = planners.plan(1, "--goal", goal_file(CUBE))
        self.assertEqual(status, 1)
        self.assertRegex(lines[-1], "^refused: connection: http://127.0.0.1:1 cannot be reached")


class Refusals(unittest.TestCase):
    def refused(self, server, goal, expected):
        status, lines = planners.plan(server.port, "--goal", goal_file(goal))
        self.assertEqual(status, 1)
        self.assertRegex(lines[-1], f"^refused: {expected}")
        self.assertEqual(server.get("/cores")["cores"], [])

    def test_a_cell_without_recognition_or_a_taught_home_is_refused(self):
        unknown = {key: value for key, value in DATABASE.items() if key != "pose_home"}
        for changes, expected in (({"files": {"database.json": unknown}}, "db.get: not_found"), ({"without": ["parts.json"]}, "obj_rec")):
            folder = copy_cell(tempfile.mkdtemp(dir=FOLDER.name), **changes)
            with self.subTest(expected), Server("--demo", str(folder)) as server:
                self.refused(server, CUBE, expected)

    def test_an_unknown_part_and_a_document_of_somebody_else_are_refused(self):
        with Server("--demo", cell()) as server:
            self.refused(server, '{"parts": {"Cup": "A1"}}', "the camera knows no part Cup")
            server.put("/documents/sorting", {"rcm": 1, "name": "sorting", "root": {"state": "Sorting"}}, "document_entry")
            self.refused(server, CUBE, "the document sorting is not the planner's")


class Interrupted(CellAssertions):
    def test_a_planner_that_is_ended_stops_the_arm(self):
        with Server("--demo", cell()) as server, race_client.Client(f"http://127.0.0.1:{server.port}") as race:
            lay(race, Table({"Cube": ((0.5, -0.3), 0.0)}, Goal({}), "none"))
            with planners.start(server.port, "--goal", goal_file(CUBE)) as process:
                try:
                    said = iter(process.stdout.readline, "")
                    self.assertTrue(any("Search: A part was found" in line for line in said))
                    joints = lambda: [poses(server)["joints"][f"a{i}"] for i in range(1, 8)]
                    begun, end = joints(), time.monotonic() + 10
                    while max(abs(a - b) for a, b in zip(joints(), begun, strict=True)) < 0.02 and time.monotonic() < end:
                        time.sleep(0.02)
                    process.terminate()
                    lines = list(said)
                    self.assertEqual((process.wait(10), lines[-1]), (1, "refused: it was interrupted\n"))
                finally:
                    process.kill()
            self.assertEqual(server.get("/cores")["cores"], [])
            time.sleep(1)  # it brakes
            before = joints()
            self.assertGreater(max(abs(a - b) for a, b in zip(before, begun, strict=True)), 0.02, "it was on its way")
            time.sleep(0.5)
            self.assertLess(max(abs(a - b) for a, b in zip(joints(), before, strict=True)), 0.002, "it stands")
            self.assert_at(poses(server)["bodies"], "Cube", (0.5, -0.3))


if __name__ == "__main__":
    unittest.main()
