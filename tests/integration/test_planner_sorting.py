"""The example planner from its start to its end, at a server that plays (played_server.py): errors, people who interfere, bounds."""
import math
import unittest

import planners  # noqa: F401  (where the planner is)
from played_server import PlayedServer

from planner.goal import GRID, Goal
from planner.refusal import Refused
from planner.sorter import PLANS, Sorter
from race_client import RaceError


def nothing(server):
    """Nobody interferes."""


class Sorting(unittest.TestCase):
    """The whole planner, at a server that plays."""

    CUBE = {"Cube": (0.5, -0.2)}

    def sort(self, server, parts, **how):
        """What it has said, `sorted` or why not at the end."""
        lines = []
        try:
            Sorter(server, Goal(parts, speed=how.pop("speed", 1.0)), lines.append, **how).sort()
            return [*lines, "sorted"]
        except (Refused, RaceError) as refused:
            return [*lines, f"refused: {refused}"]

    def assert_sorted(self, server, parts, plans, **how):
        out = self.sort(server, parts, **how)
        self.assertEqual((out[-1], sum(line.startswith("plan ") for line in out)), ("sorted", plans), out)
        for label, place in parts.items():
            self.assertLess(math.dist(server.parts[label], GRID[place]), 0.001)
        self.assertEqual((server.held, server.deleted), (None, []))
        return out

    def test_parts_are_brought_to_their_places(self):
        server = PlayedServer({"Cube": GRID["A2"], "Box": GRID["A1"], "Bar": (0.5, -0.3)})
        out = self.assert_sorted(server, {"Cube": "A1", "Box": "A2"}, 1)
        self.assertEqual(len(server.runs), 1)
        told = [line.strip().split(": ")[0] for line in out if "/" in line and "refused" not in line]
        self.assertEqual(told[:2] + told[-1:], ["Tell/Say", "Tell/Wait", "End/Aside"])
        self.assertEqual(len(told), 2 + 3 * 4 + 1, "the ports within skills are not told")
        self.assertIn("  Move1_Cube/Pick: The part is in the gripper", [line.replace("Move1_Box", "Move1_Cube") for line in out])

    def test_what_is_there_already_runs_nothing(self):
        server = PlayedServer({"Cube": GRID["A1"]})
        self.assert_sorted(server, {"Cube": "A1"}, 0)
        self.assertEqual(server.runs, [])

    def test_too_fast_is_as_fast_as_it_goes(self):
        server = PlayedServer(self.CUBE)
        out = self.assert_sorted(server, {"Cube": "A1"}, 1, speed=1.2)
        self.assertIn("  refused: Sorting/Move1_Cube/Pick: out_of_range: `speed` is 0.05 to 1, not 1.2", out)

    def test_after_an_error_it_goes_aside_looks_and_plans_again(self):
        moved = lambda server: server.parts.update(Cube=[0.55, -0.35])
        server = PlayedServer(self.CUBE, {"Sorting/Move1_Cube/Pick": [("no_part", moved)]})
        out = self.assert_sorted(server, {"Cube": "A1"}, 2)
        self.assertIn("  Move1_Cube/Pick: No part is between the fingers (because of no_part)", out)
        self.assertEqual([[task["state"] for task in run["root"]["children"]] for run in server.runs],
                         [["Tell", "Move1_Cube", "End"], ["Aside"], ["Tell", "Move1_Cube", "End"]])

    def test_a_part_in_the_hand_is_put_down_first(self):
        """Somebody has put another part there; its height is known, and is not that at which it is seen between the fingers, if it is."""
        blocked = lambda server: server.parts.update(Box=list(GRID["A1"]))
        for sees_held in (False, True):
            server = PlayedServer({**self.CUBE, "Box": (0.5, -0.4)}, {"Sorting/Move1_Cube/Pick": [(None, blocked)]})
            server.sees_held = sees_held
            out = self.assert_sorted(server, {"Cube": "A1"}, 2)
            self.assertTrue(any(line.endswith("in the gripper: Cube") for line in out), out)
            place, = server.runs[2]["root"]["children"][1]["children"]
            self.assertEqual(place["state"], "Place", "it is not looked for")
            pose = place["parameters"][0]["value"]
            self.assertAlmostEqual(server.database[f"pose_{pose}"]["pose"]["position"][2], 0.022)

    def test_what_it_goes_on_after_is_not_what_has_stopped_it(self):
        fails = {"Sorting/Tell/Say": [("no_display", nothing)] * 2, "Sorting/Move1_Cube/Pick": [("blocked", nothing)]}
        server = PlayedServer(self.CUBE, fails)
        self.assertIn("stopped: Move1_Cube/Pick: ", self.sort(server, {"Cube": "A1"}, plans=1)[-1])
        self.assert_sorted(server, {"Cube": "A1"}, 1)

    def test_a_part_that_has_gone_is_refused(self):
        gone = lambda server: server.parts.clear()
        server = PlayedServer(self.CUBE, {"Sorting/Move1_Cube/Search": [(None, gone)]})
        out = self.sort(server, {"Cube": "A1"})
        self.assertEqual((out[-1], len(server.runs)), ("refused: there is no Cube on the table", 2))
        self.assertTrue(any("No part was found before this step" in line for line in out), out)

    def test_plans_are_bounded(self):
        for plans in (1, PLANS):
            server = PlayedServer(self.CUBE, {"Sorting/Move1_Cube/Pick": [("no_part", nothing)] * 99})
            out = self.sort(server, {"Cube": "A1"}, plans=plans)
            self.assertEqual(out[-1], f"refused: {plans} plans were not enough; the last was stopped: Move1_Cube/Pick: "
                                      "No part is between the fingers (because of no_part)")
            self.assertEqual(sum(line.startswith("plan ") for line in out), plans)

    def test_a_run_that_succeeds_but_leaves_the_part_elsewhere_is_planned_again(self):
        slipped = lambda server: server.parts.update(Cube=[0.5, -0.2])
        server = PlayedServer(self.CUBE, {"Sorting/End/Aside": [(None, slipped)]})
        self.assert_sorted(server, {"Cube": "A1"}, 2)

    def test_an_arm_that_cannot_go_aside_is_refused(self):
        fails = {"Sorting/Move1_Cube/Pick": [("collision", nothing)], "Sorting/Aside/Aside": [("no_robot", nothing)]}
        server = PlayedServer(self.CUBE, fails)
        self.assertRegex(self.sort(server, {"Cube": "A1"})[-1], "^refused: Aside/Aside: The robot does not answer")

    def test_a_run_that_ends_otherwise_is_refused(self):
        server = PlayedServer(self.CUBE, status="faulted")
        self.assertEqual(self.sort(server, {"Cube": "A1"})[-1], "refused: the run is faulted")
        self.assertEqual(server.deleted, ["1"])

    def test_a_robot_that_a_person_has_stopped_is_not_moved_again(self):
        """Not even if the task would go on after an error of this step."""
        fails = {"Sorting/Move1_Cube/Pick": [("no_part", nothing)], "Sorting/Aside/Up": [("stopped", nothing)]}
        server = PlayedServer(self.CUBE, fails)
        self.assertEqual(self.sort(server, {"Cube": "A1"})[-1], "refused: Aside/Up: The robot was stopped (because of stopped)")
        self.assertEqual((len(server.runs), server.deleted), (2, ["2"]))

    def test_a_run_that_is_not_followed_to_its_end_is_ended(self):
        def leave(server):
            raise KeyboardInterrupt

        server = PlayedServer(self.CUBE, {"Sorting/Move1_Cube/Search": [(None, leave)]})
        with self.assertRaises(KeyboardInterrupt):
            self.sort(server, {"Cube": "A1"})
        self.assertEqual(server.deleted, ["1"])

    def test_a_document_of_somebody_else_is_neither_replaced_nor_run(self):
        other = {"root": {"state": "Sorting", "children": []}, "library": []}
        server = PlayedServer(self.CUBE)
        server.stored["sorting"] = [other]
        self.assertEqual(self.sort(server, {"Cube": "A1"})[-1], "refused: the document sorting is not the planner's")
        self.assertEqual((server.stored["sorting"], server.runs), ([other], []))
        self.assert_sorted(server, {"Cube": "A1"}, 1, name="other")

    def test_a_document_that_somebody_changes_meanwhile_is_left_to_them(self):
        edits = lambda server: server.stored["sorting"].append(server.stored["sorting"][-1])
        server = PlayedServer(self.CUBE, {"Sorting/Move1_Cube/Pick": [("no_part", edits)]})
        self.assertEqual(self.sort(server, {"Cube": "A1"})[-1], "refused: sorting: conflict: it has another revision")
        self.assertEqual(len(server.runs), 1)
        server = PlayedServer(self.CUBE)
        server.cores.create = lambda name: {"id": "1", "revision": 2}
        self.assertEqual(self.sort(server, {"Cube": "A1"})[-1], "refused: somebody else has changed the document sorting")
        self.assertEqual((server.deleted, server.runs), (["1"], []))

    def test_an_unknown_camera_is_calibrated_first(self):
        server = PlayedServer(self.CUBE)
        del server.database["o_t_c"]
        self.assert_sorted(server, {"Cube": "A1"}, 1)
        self.assertEqual(server.runs[0]["root"]["meta"]["title"], "Calibrate the camera")

    def test_impossible_goals_run_nothing(self):
        cases = (({"Cube": "A1", "Box": "A1"}, "2 parts are to be at the place A1"), ({"Box": "A1"}, "there is no Box"),
                 ({"Cup": "A1"}, "the camera knows no part Cup"), ({"Cube": "Z1"}, "there is no place Z1"))
        for goal, reason in cases:
            server = PlayedServer(self.CUBE)
            self.assertIn(f"refused: {reason}", self.sort(server, goal)[-1])
            self.assertEqual(server.runs, [])

    def test_a_service_that_is_not_there_is_told_before_anything_moves(self):
        server = PlayedServer(self.CUBE, away=["gripper"])
        self.assertEqual(self.sort(server, {"Cube": "A1"})[-1],
                         "refused: Sorting/Move1_Cube/Pick: unavailable: the service gripper is not there")
        self.assertEqual(server.runs, [])
        server = PlayedServer(self.CUBE, away=["display", "audio"])
        self.assert_sorted(server, {"Cube": "A1"}, 1)


if __name__ == "__main__":
    unittest.main()
