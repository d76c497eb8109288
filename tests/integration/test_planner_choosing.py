"""The example planner as the service Oracle, without a cell: what it decides, the task that asks it, and where an answer leads there."""
import contextlib
import dataclasses
import itertools
import json
import tempfile
import unittest
from pathlib import Path

import planners  # noqa: F401  (where the planner is)
from planner_models import HERE, SKILLS, lying, scene
from played_server import PlayedServer
from test_commands import race
from test_planner import truth

from planner import choosing, repair, tasks
from planner.compose import document_of
from planner.goal import GRID, Goal
from planner.oracle import MAX_MOVES, Oracle, all_moves, next_child
from planner.refusal import Refused
from planner.scene import Part
from planner.table import table_by_seed
from race_client import Client
from race_client.service import ServiceFailure
from race_client.service.declaration import Declaration

CUBE = Goal({"Cube": "A1"})
PLACES = {name: list(at) for name, at in GRID.items()}


def moved(here, move):
    """The scene after a move."""
    return dataclasses.replace(here, parts={**here.parts, move.label: Part(move.label, move.at, 0.02, True, 0.9)})


def moves_until_sorted(goal, here):
    """The names that are chosen one after the other, each of which the task has that was made of the first scene."""
    choices, names = {tasks.choice_name(move): move for move in all_moves(goal, here)}, []
    while (name := next_child(goal, here, len(names))) != choosing.SORTED:
        here = moved(here, choices[name])
        names.append(name)
    return names


class Deciding(unittest.TestCase):
    def refusal(self, here, moves=0):
        with self.assertRaises(Refused) as refused:
            next_child(CUBE, here, moves)
        return str(refused.exception)

    def test_the_first_move_of_the_plan_is_next_until_there_is_none(self):
        self.assertEqual(next_child(CUBE, scene(Cube=(0.5, -0.2)), 0), "Move_Cube_to_A1")
        self.assertEqual(next_child(CUBE, scene(Cube="A1"), 0), "Sorted")
        first, then = moves_until_sorted(CUBE, scene(Cube=(0.5, -0.2), Box="A1"))
        self.assertRegex(first, "^Move_Box_to_(A[23]|B[123])$")
        self.assertEqual(then, "Move_Cube_to_A1")

    def test_what_cannot_be_is_refused(self):
        here = scene(Cube=(0.5, -0.2))
        self.assertEqual(self.refusal(scene()), "there is no Cube on the table")
        self.assertEqual(self.refusal(lying(here, "Cube")), "the Cube lies on its side")
        self.assertEqual(self.refusal(scene(holds=True, Cube=(0.5, -0.2))), "there is a part in the gripper")

    def test_moves_are_bounded_but_not_what_they_have_reached(self):
        here = scene(Cube=(0.5, -0.2))
        self.assertEqual(next_child(CUBE, here, MAX_MOVES - 1), "Move_Cube_to_A1")
        self.assertEqual(self.refusal(here, MAX_MOVES), f"{MAX_MOVES} moves were not enough")
        self.assertEqual(next_child(CUBE, scene(Cube="A1"), MAX_MOVES), "Sorted")

    def test_every_table_is_sorted_with_the_moves_that_its_task_has(self):
        for seed in range(1, 41):
            table = table_by_seed(seed)
            if table.flaw == "none":
                with self.subTest(seed=seed):
                    self.assertLess(len(moves_until_sorted(table.goal, truth(table))), MAX_MOVES)

    def test_five_parts_that_change_places_need_seven_moves(self):
        here = scene(Cube="A1", Box="A2", Block="A3", Tape="B1", Bar="B2")
        goal = Goal({"Cube": "A2", "Box": "A1", "Block": "B1", "Tape": "B2", "Bar": "A3"})
        self.assertEqual(len(moves_until_sorted(goal, here)), 7)


class Answering(unittest.TestCase):
    """The service; what it is asked, tests/integration/test_planner_oracle.py asks it at a server."""

    def error(self, parts, places, connect):
        with self.assertRaises(ServiceFailure) as failure:
            Oracle(connect, lambda _: None).decide(parts, places, 0)
        return failure.exception.error

    def test_it_says_what_it_offers(self):
        decide, = Declaration(Oracle).rsm["operations"]
        self.assertEqual((decide["name"], decide["reads"], decide["result"], "moves" in decide), ("decide", True, "string", False))
        self.assertEqual([(each["name"], each["type"], each.get("value")) for each in decide["parameters"]],
                         [("parts", "any", None), ("places", "any", None), ("moves", "int", 0)])

    def test_it_answers_by_what_the_camera_sees_then(self):
        server, said = PlayedServer({"Cube": (0.5, -0.2)}), []
        oracle = Oracle(lambda: contextlib.nullcontext(server), said.append)
        self.assertEqual(oracle.decide({"Cube": "A1"}, PLACES), "Move_Cube_to_A1")
        server.parts["Cube"] = list(GRID["A1"])
        self.assertEqual(oracle.decide({"Cube": "A1"}, PLACES, 1), "Sorted")
        self.assertEqual(said, ["next: Move_Cube_to_A1", "next: Sorted"])

    def test_errors_have_a_code_and_a_reason(self):
        played = lambda: contextlib.nullcontext(PlayedServer({}))
        self.assertEqual(self.error({"Cube": "A1"}, PLACES, played), {"code": "refused", "message": "there is no Cube on the table"})
        self.assertEqual(self.error({"Cup": "A1"}, PLACES, played), {"code": "refused", "message": "the camera knows no part Cup"})
        for parts, places in ((["Cube"], PLACES), ({"Cube": "A1"}, {"A1": [0.4]}), ({}, PLACES), (None, None)):
            self.assertEqual(self.error(parts, places, played)["code"], "invalid", (parts, places))
        unknown = PlayedServer({"Cube": (0.5, -0.2)})
        del unknown.database["o_t_c"]
        self.assertEqual(self.error({"Cube": "A1"}, PLACES, lambda: contextlib.nullcontext(unknown))["code"], "not_found")
        gone = self.error({"Cube": "A1"}, PLACES, lambda: Client("http://127.0.0.1:1"))
        self.assertEqual(gone["code"], "connection")
        self.assertIn("http://127.0.0.1:1 cannot be reached", gone["message"])


class Composing(unittest.TestCase):
    TABLE = scene(Cube=(0.5, -0.2), Box="A1")

    def mended(self, speed=1.0):
        goal = dataclasses.replace(CUBE, speed=speed)
        draft, told = tasks.asking("sorting", goal, all_moves(goal, self.TABLE)), []
        while errors := repair.errors_of(draft, SKILLS, HERE, PlayedServer({})):
            told += [(error["path"], error["code"]) for error in errors]
            draft = repair.repaired(draft, errors, SKILLS)
        return draft, told

    def test_it_has_each_part_that_stands_there_to_each_place_in_reach(self):
        names = [tasks.choice_name(move) for move in all_moves(CUBE, self.TABLE)]
        self.assertEqual(set(names), {f"Move_{label}_to_{place}" for label, place in itertools.product(("Cube", "Box"), GRID)})
        far = Goal({"Cube": "A1"}, {**GRID, "Far": (0.9, 0.3)})
        self.assertEqual([tasks.choice_name(move) for move in all_moves(far, lying(self.TABLE, "Box"))],
                         [name for name in names if "Cube" in name])

    def test_the_server_accepts_it_as_it_is_mended(self):
        draft, told = self.mended(speed=1.2)
        self.assertIn(("library/PickFound/Grab", "link_unknown"), told)
        self.assertIn(("Sorting/Next/Move_Cube_to_A1/Pick", "out_of_range"), told)
        self.assertEqual({step.values.get("speed", 1.0) for step in tasks.steps_of(draft).values()}, {1.0})
        document = document_of(draft, SKILLS)
        self.assertEqual(document["services"]["Oracle"], "Oracle")
        status, lines, errors = race("check", "DOCUMENT", document=document)
        self.assertEqual(status, 0, (lines, errors))

    def test_a_move_picks_and_places_its_part_where_it_says(self):
        draft, _ = self.mended()
        moves = all_moves(CUBE, self.TABLE)
        poses = tasks.poses_of(moves, {"Cube": 0.02, "Box": 0.025}, {"q": [0.0] * 7})
        for move in moves:
            steps = {step.name: step for step in next(task for task in draft.tasks if task.name == tasks.choice_name(move)).steps}
            self.assertEqual(list(steps), ["Aside", "Search", "Pick", "Place", "Back"])
            self.assertEqual(steps["Search"].values["labels"], [move.label])
            self.assertEqual(poses[f"pose_{steps['Place'].values['pose']}"]["pose"]["position"][:2], [*move.at])

    def test_nothing_follows_a_stop_by_a_person(self):
        root = document_of(self.mended()[0], SKILLS)["root"]
        next_, aside = root["children"]
        for move in next_["children"][2:]:
            stopped = move["ports"][0]
            expected = {f"chi.{step}.port.stopped" for step in ("Aside", "Pick", "Place", "Back")}
            self.assertEqual((stopped["name"], set(stopped["when"].split(" or "))), ("stopped", expected))
        led = [(step["state"], port["name"]) for step in aside["children"] for port in step.get("ports", []) if "to" in port]
        self.assertEqual(led, [("Up", "success")])


class Flow(unittest.TestCase):
    """What the task does with answers and ends of moves, by `race derive`; a move and Aside are stand-ins that end as `t` says."""

    ENDS = {"success": "done", "stopped": "halt", "error": "fail"}  # port -> event
    EVENTS = [*ENDS.values(), "aside", "stuck"]

    def document(self):
        ports = [{"name": port, "when": f"svc.t.{event}"} for port, event in self.ENDS.items()]
        moves = [{"state": f"Move_Cube_to_{place}", "ports": ports} for place in ("A1", "A2")]
        aside = {"state": "Aside", "ports": [{"name": "success", "when": "svc.t.aside", "to": "Next"},
                                             {"name": "error", "when": "svc.t.stuck"}]}
        return {"rcm": 1, "name": "sorting", "root": choosing.root_of(CUBE, aside, moves)}

    def derived(self, *inputs, services=("Oracle",)):
        """What `race derive` prints of the run; an input is a text (an event), or the answer {"result"} or {"error"} of the planner."""
        steps = [{"events": [{"service": "t", "event": each, "data": None}]} if isinstance(each, str) else
                 {"responses": [{"service": "Oracle", "operation": "decide", **each}]} if each else {} for each in inputs]
        has = {"Oracle": {"operations": [{"name": "decide"}], "events": []},
               "t": {"operations": [], "events": [{"name": name} for name in self.EVENTS]}}
        script = {"services": {key: has[key] for key in (*services, "t")}, "steps": [{}, *steps]}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "script.json")
            path.write_text(json.dumps(script))
            _, lines, errors = race("derive", "DOCUMENT", path, document=self.document())
        self.assertTrue(lines, errors)
        return json.loads("\n".join(lines))

    def assert_ended(self, out, outcome, why):
        """With the outcome, and this result."""
        results = out["steps"][-1]["state"]["results"]["Sorting"]
        self.assertEqual((out["status"], out.get("outcome"), results["why"]), ("ended", outcome, why), out.get("fault"))

    def asked(self, out):
        """The arguments of each call."""
        return [call["args"] for step in out["steps"] for call in step["calls"]]

    def active(self, out):
        return out["steps"][-1]["state"]["active"][-1]

    def test_it_asks_with_goal_places_and_moves_before_each_move(self):
        out = self.derived({"result": "Move_Cube_to_A2"}, "done", {"result": "Move_Cube_to_A1"}, "done", {"result": "Sorted"})
        self.assert_ended(out, "success", "")
        self.assertEqual(self.asked(out), [[{"Cube": "A1"}, PLACES, moves] for moves in range(3)])

    def test_the_child_that_is_named_is_entered(self):
        for name in ("Move_Cube_to_A1", "Move_Cube_to_A2"):
            self.assertEqual(self.active(self.derived({"result": name})), f"Sorting/Next/{name}")

    def test_after_a_move_that_has_failed_the_arm_goes_aside_and_it_asks_again(self):
        failed = [{"result": "Move_Cube_to_A1"}, "fail"]
        self.assertEqual(self.active(self.derived(*failed)), "Sorting/Aside")
        out = self.derived(*failed, "aside", {"result": "Sorted"})
        self.assert_ended(out, "success", "")
        self.assertEqual([moves for _, _, moves in self.asked(out)], [0, 1])
        self.assert_ended(self.derived(*failed, "stuck"), "error", "the arm does not get out of the way")

    def test_after_a_stop_by_a_person_it_ends(self):
        self.assert_ended(self.derived({"result": "Move_Cube_to_A1"}, "halt"), "error", "the robot was stopped")

    def test_without_an_answer_it_ends(self):
        reason = {"code": "refused", "message": "there is no Cube on the table"}
        self.assert_ended(self.derived({"error": reason}), "error", reason["message"])
        self.assert_ended(self.derived({"error": {"code": "unavailable"}}), "error", "planner: unavailable")
        self.assert_ended(self.derived({}, services=()), "error", "planner: unavailable")
        self.assert_ended(self.derived({"result": "Move_Cube_to_A1"}, "done", {"error": reason}), "error", reason["message"])

    def test_an_answer_that_names_no_move_ends_it(self):
        for answer in ("Move_Cup_to_A1", "Next", "Dispatcher", "", 3, None, []):
            with self.subTest(answer):
                self.assert_ended(self.derived({"result": answer}), "error", f"the planner chose {answer}, which is no move of this task")


if __name__ == "__main__":
    unittest.main()
