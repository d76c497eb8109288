"""The example planner when somebody interferes: it looks, plans and sorts again, or says why not. RACE_PLANNER_SEEDS=all: in every way."""
import unittest

import planners
from cell import NAMES
from client import Server
from planner_cell import CellAssertions, cell, poses
from python_clients import race_client

from planner.goal import GRID, Goal
from planner.refusal import Refused
from planner.sorter import PLANS, Sorter
from planner.table import BODIES, Table, lay

long = unittest.skipUnless(planners.IS_LONG, "deploy/soak tries it")


def put(label, x, y):
    """A person puts the part there."""
    return {"act": "place", "part": NAMES[label], "pose": {"position": [x, y, BODIES[label][1]], "orientation": [0, 0, 0, 1]}}


def plans(lines):
    return [line for line in lines if line.startswith("plan ")]


class Replanning(CellAssertions):
    """Somebody interferes when a step has ended; the planner is in this process, so that the test hears of it."""

    @classmethod
    def setUpClass(cls):
        cls.server = Server("--demo", cell())
        cls.addClassCleanup(cls.server.stop)
        cls.race = race_client.Client(f"http://127.0.0.1:{cls.server.port}")
        cls.addClassCleanup(cls.race.close)

    def sort(self, parts, goal, acts=(), every=False, plans=PLANS):
        """What the sorter has said. `acts`: (text of a step, commands of a person when it is said first, or every time)."""
        lay(self.race, Table({label: (at, 0.0) for label, at in parts.items()}, Goal(goal), "none"))
        lines, waiting = [], list(acts)

        def say(text):
            lines.append(text)
            for act in [act for act in waiting if act[0] in text]:
                if not every:
                    waiting.remove(act)
                for command in act[1]:
                    self.server.post("/cell/person", command)

        try:
            Sorter(self.race, Goal(goal), say, plans=plans).sort()
            lines.append("sorted")
        except Refused as refused:
            lines.append(f"refused: {refused}")
        return lines

    def test_a_part_that_is_moved_meanwhile_is_looked_for_again(self):
        out = self.sort({"Cube": (0.5, -0.2)}, {"Cube": "A1"}, [("Search: A part was found", [put("Cube", 0.55, -0.35)])])
        self.assertEqual((out[-1], len(plans(out))), ("sorted", 2), out)
        self.assertTrue(any("Pick: No part is between the fingers" in line for line in out), out)
        self.assert_at(poses(self.server)["bodies"], "Cube", GRID["A1"])

    @long
    def test_a_part_that_is_taken_away_is_refused(self):
        out = self.sort({"Cube": (0.5, -0.2)}, {"Cube": "A1"}, [("Search: A part was found", [{"act": "take", "part": NAMES["Cube"]}])])
        self.assertEqual((out[-1], len(plans(out))), ("refused: there is no Cube on the table", 1), out)

    @long
    def test_a_place_that_is_taken_after_it_was_planned_is_cleared(self):
        """The part meets another one that was put there; it is still held, put down elsewhere or brought there later."""
        out = self.sort({"Cube": (0.5, -0.2), "Box": (0.5, -0.4)}, {"Cube": "A1"},
                        [("Pick: The part is in the gripper", [put("Box", *GRID["A1"])])])
        self.assertEqual(out[-1], "sorted", out)
        self.assertGreater(len(plans(out)), 1, out)
        self.assert_at(poses(self.server)["bodies"], "Cube", GRID["A1"])

    @long
    def test_plans_are_bounded(self):
        out = self.sort({"Cube": (0.5, -0.2)}, {"Cube": "A1"}, every=True, plans=2, acts=[
            ("Search: A part was found", [put("Cube", 0.55, -0.35)]), ("Pick: No part", [put("Cube", 0.5, -0.2)])])
        self.assertTrue(out[-1].startswith("refused: 2 plans were not enough; the last was stopped: Move1_Cube/Pick: No part"), out)
        self.assertEqual(len(plans(out)), 2)


if __name__ == "__main__":
    unittest.main()
