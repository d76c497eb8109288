"""The cell put back to how it was at the start: in the real world and database, never under a run."""
import unittest

import models
from client import PROJECT, Server
from component_process import LONG_HEARTBEAT, ComponentProcess, wait_available

DEMO = PROJECT / "deploy/demo"
NO_HANDS = {"hands": [], "absent": []}


def lifting(name="lifting", height=0.05):
    """Moves the tool up; ends at `up`, with where it was before as result."""
    return models.document(name, {
        "state": "Root", "results": [{"name": "q"}],
        "entry": f'svc.robot.move({{"offset": [0, 0, {height}]}})',
        "actions": [{"when": "svc.robot.move.result", "do": "res.q = svc.robot.move.result.q"}],
        "ports": [{"name": "up", "when": "available(res.q)"}, {"name": "failed", "when": "svc.robot.move.error"}]})


class ResetCell(unittest.TestCase):
    def setUp(self):
        self.server = Server("--demo", str(DEMO))
        self.addCleanup(self.server.stop)

    def pose(self):
        """Where everything in the cell is now."""
        with self.server.stream() as stream:
            stream.subscribe("cell/pose")
            data = stream.until(lambda m: m["channel"] == "cell/pose")[-1]["data"]
        return {"joints": data["joints"], "bodies": data["bodies"]}

    def assert_near(self, poses, others):
        for joint, value in others["joints"].items():
            self.assertAlmostEqual(poses["joints"][joint], value, delta=1e-3, msg=joint)
        for body, pose in others["bodies"].items():
            for value, other in zip(poses["bodies"][body]["position"], pose["position"], strict=True):
                self.assertAlmostEqual(value, other, delta=1e-3, msg=body)

    def run_to_end(self, document, arguments=None):
        return self.server.ended(self.server.core(document, arguments))

    def test_the_task_runs_again_as_it_did_and_everything_is_where_it_was(self):
        before = self.pose()
        first = self.run_to_end(lifting())
        self.assertEqual(first["outcome"], "up")
        self.server.post("/cell/person", {"act": "take", "part": "cube_red"}, "person")
        self.server.post("/cell/person", {"act": "grab", "body": "cube_blue", "keep": 60}, "person")
        self.assertEqual(self.server.post("/cell/reset", None, "person"), NO_HANDS)
        self.assert_near(self.pose(), before)
        again = self.run_to_end(lifting())
        self.assertEqual(again["outcome"], "up")
        for value, other in zip(again["results"]["q"], first["results"]["q"], strict=True):
            self.assertAlmostEqual(value, other, delta=1e-4)

    def test_a_motion_that_a_stopped_run_has_left_ends_with_it(self):
        before = self.pose()
        core = self.server.core(lifting(height=0.3))
        self.server.wait(core, lambda c: c["step"] > 0)
        self.server.post("/cores/" + core + "/stop", None, "core")
        self.server.post("/cell/reset", {"database": False}, "person")
        self.assert_near(self.pose(), before)
        self.server.wait_for(lambda: self.server.get("/health", "health")["time"] > 1)
        self.assert_near(self.pose(), before)

    def test_it_is_refused_while_a_run_is_not_over(self):
        core = self.server.core(models.ticking(last=10**6))
        for command in (None, "pause"):
            if command:
                self.server.post(f"/cores/{core}/{command}", None, "core")
            error = self.server.post("/cell/reset", None, status=409)["errors"][0]
            self.assertEqual((error["code"], error["message"]),
                             ("conflict", f"run {core} of ticking is not over; stop it before the cell is reset"))
        self.server.post(f"/cores/{core}/stop", None, "core")
        self.server.core(models.ticking(), start=False)
        self.assertEqual(self.server.post("/cell/reset", None, "person"), NO_HANDS)

    def test_the_database_has_the_values_of_the_start_alone_unless_they_are_kept(self):
        self.run_to_end(models.storing(), {"key": "own", "value": 7})
        self.run_to_end(models.storing(), {"key": "object_pose", "value": 8})
        read = lambda key: self.run_to_end(models.reading(), {"key": key})
        self.server.post("/cell/reset", {"database": False}, "person")
        self.assertEqual(read("own")["results"]["value"], 7)
        self.server.post("/cell/reset", {"database": True}, "person")
        self.assertEqual(read("own")["outcome"], "missing")
        self.assertEqual(read("object_pose")["results"]["value"]["position"], [0.55, -0.15, 0.02])

    def test_a_wrong_body_resets_nothing(self):
        self.server.post("/cell/person", {"act": "take", "part": "cube_red"}, "person")
        for body in ([], {"database": 1}, {"parts": True}):
            self.server.post("/cell/reset", body, status=422)
        self.assertEqual(self.server.get("/cell/person", "person")["absent"], ["cube_red"])


class WithoutACell(unittest.TestCase):
    def test_there_is_nothing_to_reset(self):
        with Server() as server:
            server.post("/cell/reset", None, status=404)

    def test_a_cell_of_its_own_process_is_reset_by_a_new_process(self):
        with Server("--remote", "cell", *LONG_HEARTBEAT) as server:
            with ComponentProcess(server, "cell", "--folder", str(DEMO)):
                wait_available(server, "robot")
                error = server.post("/cell/reset", None, status=409)["errors"][0]
        self.assertEqual(error["code"], "conflict")
        self.assertIn("race service cell", error["message"])


if __name__ == "__main__":
    unittest.main()
