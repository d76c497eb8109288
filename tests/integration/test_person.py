"""A person at the cell: hands that the robot feels, parts that are moved, refused commands; operator scripts."""
import json
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import models
from client import TIMEOUT, PROGRAM, PROJECT, Server, check

DEMO = PROJECT / "deploy/demo"


def feeling(name="feeling", force=15):
    """Ends at `felt` when the robot feels `force` [N] along y at its tool; the result is the force."""
    return models.document(name, {
        "state": "Root", "results": [{"name": "force"}],
        "actions": [{"when": "svc.robot.robot_state", "do": "res.force = svc.robot.robot_state.f_ext_hat"}],
        "ports": [{"name": "felt", "when": f"svc.robot.robot_state and svc.robot.robot_state.f_ext_hat[1] > {force}"}]})


class Person(unittest.TestCase):
    def setUp(self):
        self.server = Server("--demo", str(DEMO))
        self.addCleanup(self.server.stop)
        scene = self.server.get("/cell", "scene")
        self.part = next(body["name"] for body in scene["bodies"] if not body["fixed"])

    def act(self, status=200, **act):
        if status == 200:
            check("person_command", act)
        return self.server.post("/cell/person", act, "person" if status == 200 else None, status)

    def hands(self):
        return self.server.get("/cell/person", "person")["hands"]

    def pose(self, stream, condition):
        """The first pose of the cell for which condition(pose) holds."""
        return stream.until(lambda m: condition(m["data"]))[-1]["data"]

    def test_the_robot_feels_a_hand_that_drags_it(self):
        core = self.server.core(feeling())
        self.act(act="grab", body="gripper", point=[0, 0, 0.15], keep=60)
        self.act(act="drag", by=[0, 0.06, 0], speed=0.5, keep=60)
        felt = self.server.ended(core)
        self.assertEqual(felt["outcome"], "felt")
        self.assertGreater(felt["results"]["force"][1], 12)  # the sample before the one that ended it
        with self.server.stream() as stream:
            stream.subscribe("cell/pose")
            pose = self.pose(stream, lambda p: p["hands"][0]["force"][1] > 20)
        hand = pose["hands"][0]
        self.assertEqual((hand["hand"], hand["body"]), ("hand", "gripper"))
        self.assertAlmostEqual(hand["target"][1] - hand["at"][1], hand["force"][1] / 500, delta=0.02)
        self.assertEqual(self.act(act="release")["hands"], [])

    def test_the_robot_feels_a_push(self):
        core = self.server.core(feeling(force=25))
        self.act(act="push", body="gripper", point=[0, 0, 0.15], force=[0, 40, 0], duration=1, rise=0.2)
        self.assertEqual(self.server.ended(core)["outcome"], "felt")

    def test_a_hand_carries_a_part_and_lets_it_go(self):
        self.act(act="grab", hand="left", body=self.part, keep=60)
        self.act(act="drag", hand="left", path=[[0.7, -0.3, 0.3], [0.75, -0.35, 0.3]], speed=1, keep=60)
        with self.server.stream() as stream:
            stream.subscribe("cell/pose")
            self.pose(stream, lambda p: abs(p["bodies"][self.part]["position"][0] - 0.75) < 0.01)
            self.act(act="release", hand="left")
            pose = self.pose(stream, lambda p: p["bodies"][self.part]["position"][2] < 0.1)
        self.assertNotIn("hands", pose)

    def test_a_hand_without_requests_lets_go(self):
        self.assertEqual(len(self.act(act="grab", body="link_5")["hands"]), 1)
        end = time.monotonic() + TIMEOUT
        while self.hands() and time.monotonic() < end:
            pass
        self.assertEqual(self.hands(), [])

    def test_a_part_is_placed_taken_and_put_back(self):
        place = {"position": [0.8, -0.4, 0.2], "orientation": [0, 0, 0, 1]}
        with self.server.stream() as stream:
            stream.subscribe("cell/pose")
            self.act(act="place", part=self.part, pose=place)
            self.pose(stream, lambda p: abs(p["bodies"][self.part]["position"][0] - 0.8) < 0.01)
            self.assertEqual(self.act(act="take", part=self.part)["absent"], [self.part])
            self.pose(stream, lambda p: self.part not in p["bodies"])
            self.act(409, act="take", part=self.part)
            self.act(409, act="grab", body=self.part)
            self.assertEqual(self.act(act="place", part=self.part)["absent"], [])
            self.pose(stream, lambda p: self.part in p["bodies"])

    def test_invalid_commands_are_refused_by_field_and_move_nothing(self):
        in_the_table = {"position": [0.7, -0.2, 0], "orientation": [0, 0, 0, 1]}
        not_unit = {"position": [0.7, -0.2, 0.1], "orientation": [0, 0, 1, 1]}
        for status, path, act in (
                (404, "body", {"act": "grab", "body": "link_9"}),
                (422, "body", {"act": "grab", "body": "table"}),
                (422, "body", {"act": "push", "body": "base_link", "force": [0, 1, 0], "duration": 1}),
                (400, "limit", {"act": "grab", "body": "link_5", "limit": 251}),
                (400, "stiffness", {"act": "grab", "body": "link_5", "stiffness": -1}),
                (400, "point", {"act": "grab", "body": "link_5", "point": [0, 0, 2]}),
                (400, "force", {"act": "push", "body": "link_5", "force": [0, 300, 0], "duration": 1}),
                (400, "duration", {"act": "push", "body": "link_5", "force": [0, 30, 0], "duration": -1}),
                (400, "rise", {"act": "push", "body": "link_5", "force": [0, 30, 0], "duration": 1, "rise": 0.6}),
                (409, "hand", {"act": "drag", "to": [0, 0, 1]}),
                (409, "pose", {"act": "place", "part": self.part, "pose": in_the_table}),
                (422, "part", {"act": "place", "part": "link_5", "pose": in_the_table}),
                (422, "part", {"act": "take", "part": "table"}),
                (404, "part", {"act": "take", "part": "nothing"})):
            answer = self.act(status, **act)
            self.assertEqual(answer["errors"][0]["path"], path, act)
        for act in ({}, {"act": "kick"}, {"act": "grab"}, {"act": "grab", "body": "link_5", "strength": 1},
                    {"act": "drag"}, {"act": "drag", "to": [0, 0, 1], "by": [0, 0, 1]}, {"act": "drag", "to": [0, 1]},
                    {"act": "grab", "body": "link_5", "hand": ""}, {"act": "push", "body": "link_5", "duration": 1},
                    {"act": "push", "body": "link_5", "force": ["1", 0, 0], "duration": 1}):
            self.act(422, **act)
        self.act(400, act="place", part=self.part, pose=not_unit)
        self.act(400, act="grab", body="link_5", keep=-1)
        for number in ("1e999", "NaN"):
            status, _ = self.server.request(
                "POST", "/api/v1/cell/person",
                '{"act": "push", "body": "link_5", "force": [0, ' + number + ', 0], "duration": 1}')
            self.assertIn(status, (400, 422))
        self.assertEqual(self.hands(), [])

    def test_a_server_without_a_cell_has_no_person_route(self):
        with Server() as plain:
            plain.get("/cell/person", status=404)
            plain.post("/cell/person", {"act": "release"}, status=404)


def waiting(name="waiting"):
    """Waits for two pushes of 15 N along y with rest in between, then ends at `done`."""
    y = "svc.robot.robot_state.f_ext_hat[1]"
    return models.document(name, {
        "state": "Root", "children": [
            {"state": "First", "ports": [{"name": "felt", "when": f"svc.robot.robot_state and {y} > 15", "to": "Rest"}]},
            {"state": "Rest", "ports": [{"name": "calm", "when": f"svc.robot.robot_state and {y} < 3", "to": "Second"}]},
            {"state": "Second", "ports": [{"name": "felt", "when": f"svc.robot.robot_state and {y} > 15"}]}],
        "first": "First", "ports": [{"name": "done", "when": "chi.Second.port.felt"}]})


PUSH = {"act": "push", "body": "gripper", "point": [0, 0, 0.15], "force": [0, 30, 0], "duration": 0.4, "rise": 0.05}
PUSHES = {"operator": 1, "acts": [
    {"doc": "bump", "when": {"time": 0.5}, "do": PUSH},
    {"when": {"active": "Root/Rest"}, "do": []},
    {"doc": "again", "when": {"inactive": "Root/Rest", "after": 0.25}, "do": [PUSH]},
    {"doc": "too late", "when": {"event": {"service": "timer", "event": "tick"}, "count": 1000}, "do": PUSH}]}


class Script(unittest.TestCase):
    def run_with(self, script, *options):
        """(status, reports, stderr) of `race run` of waiting() with this operator."""
        with tempfile.TemporaryDirectory() as folder:
            model, operator = Path(folder, "model.rcm.json"), Path(folder, "operator.json")
            model.write_text(json.dumps(waiting()))
            operator.write_text(json.dumps(script))
            out = subprocess.run([PROGRAM, "run", model, "--cell", DEMO, "--fast", "--json", "--operator", operator, *options],
                                 capture_output=True, text=True, timeout=120, check=False)
        return out.returncode, out.stdout.splitlines(), out.stderr

    def test_acts_follow_in_order_as_their_conditions_come_true(self):
        check("operator", PUSHES)
        status, lines, errors = self.run_with(PUSHES, "--limit", "10", "--seed", "7")
        self.assertEqual((status, errors), (0, ""))
        reports = [json.loads(line) for line in lines]
        said = [(r["text"], r["time"]) for r in reports if r.get("source") == "operator"]
        self.assertEqual([text for text, _ in said], ["acts/0: bump", "acts/1", "acts/2: again"])
        self.assertAlmostEqual(said[0][1], 0.5, delta=0.0015)
        entered = [r["time"] for r in reports if r.get("active", {}).get("Root/Second")]
        self.assertAlmostEqual(said[2][1], entered[0] + 0.25, delta=0.0025)
        self.assertEqual((reports[-1]["outcome"], reports[-1]["status"]), ("done", "ended"))

    def test_the_same_seed_and_script_give_the_same_run(self):
        runs = [self.run_with(PUSHES, "--limit", "10", "--seed", "7") for _ in range(2)]
        self.assertEqual(runs[0], runs[1])

    def test_without_acts_nothing_happens(self):
        status, lines, _ = self.run_with({"operator": 1, "acts": []}, "--limit", "2")
        self.assertEqual((status, json.loads(lines[-1])["status"]), (1, "running"))

    def test_a_refused_act_is_reported_and_the_script_goes_on(self):
        inside = {"act": "place", "part": "PART", "pose": {"position": [0.7, -0.2, 0], "orientation": [0, 0, 0, 1]}}
        part = next(b["name"] for b in json.loads((DEMO / "scene.json").read_text())["bodies"] if b["mass"] > 0)
        script = {"operator": 1, "acts": [{"do": inside | {"part": part}}, *PUSHES["acts"]]}
        status, lines, _ = self.run_with(script, "--limit", "10")
        self.assertEqual(status, 0)
        self.assertTrue(any("refused" in line and "inside `table`" in line for line in lines))

    def test_an_invalid_script_is_refused_with_path_and_code(self):
        for script, path in (
                ({"acts": []}, "missing"), ({"operator": 2, "acts": []}, "version"), ({"operator": 1}, "missing"),
                ({"operator": 1, "acts": [{"do": {"act": "kick"}}]}, "acts/0/do"),
                ({"operator": 1, "acts": [{"do": PUSH, "when": {"time": -1}}]}, "acts/0/when"),
                ({"operator": 1, "acts": [{"do": PUSH, "when": {"time": 1, "active": "Root"}}]}, "acts/0/when"),
                ({"operator": 1, "acts": [{"do": PUSH, "when": {"active": "Root", "count": 0}}]}, "acts/0/when"),
                ({"operator": 1, "acts": [{"do": PUSH, "always": True}]}, "acts/0"),
                ({"operator": 1, "acts": [{"do": {"act": "answer"}}]}, "acts/0/do"),
                ({"operator": 1, "acts": [{"do": PUSH | {"body": "link_9"}}]}, "acts/0"),
                ({"operator": 1, "displays": ["all"], "acts": []}, "name")):
            status, lines, _ = self.run_with(script)
            self.assertEqual(status, 2, script)
            self.assertIn(path, "\n".join(lines), script)

    def test_the_server_runs_the_script_with_each_run(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "operator.json")
            path.write_text(json.dumps(PUSHES))
            with Server("--demo", str(DEMO), "--operator", str(path)) as server:
                for name in ("once", "twice"):
                    ended = server.ended(server.core(waiting(name)))
                    self.assertEqual((ended["status"], ended["outcome"]), ("ended", "done"))


if __name__ == "__main__":
    unittest.main()
