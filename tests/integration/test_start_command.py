"""race start, stop, services and call at a running server."""
import json
import signal
import unittest

import models
from accounts import PASSWORD, AccountServer
from client import PROJECT, Server
from motions import HOME
from race_command import Person

DEMO = str(PROJECT / "deploy/demo")


class CommandCase(unittest.TestCase):
    def setUp(self):
        self.server = Server("--demo", DEMO)
        self.addCleanup(self.server.stop)
        self.person = Person(self, f"http://127.0.0.1:{self.server.port}")

    def put(self, document):
        self.server.put(f"/documents/{document['name']}", document)


class Start(CommandCase):
    def test_prints_the_id_of_a_core_that_runs(self):
        self.put(models.ticking(last=1000))
        output = self.person.done("start", "ticking", "--arguments", '{"last": 999}')
        core = self.server.get(f"/cores/{output.strip()}")
        self.assertEqual((core["status"], core["arguments"]), ("running", {"last": 999}))
        self.assertEqual(self.person.json("start", "ticking")["status"], "running")

    def test_waits_for_the_end_and_prints_outcome_and_results(self):
        self.put(models.ticking(last=2))
        first, line, results = self.person.done("start", "ticking", "--wait").splitlines()
        self.assertRegex(line, rf"\A +{first}  ticking +ended +\d+  done\Z")
        self.assertEqual(json.loads(results), {"n": 2})
        core = self.person.json("start", "ticking", "--wait")
        self.assertEqual((core["outcome"], core["results"]), ("done", {"n": 2}))

    def test_a_run_that_does_not_end_well_is_1(self):
        self.put(models.faulty())
        status, output, _ = self.person.race("start", "faulty", "--wait")
        self.assertEqual((status, "zero_division" in output), (1, True))
        self.put(models.ticking(last=1000))
        waiting = self.person.start("start", "ticking", "--wait")
        core = waiting.stdout.readline().strip()
        self.assertIn("aborted", self.person.done("stop", core))
        status, output, _ = self.person.finish(waiting)
        self.assertEqual((status, "aborted" in output), (1, True))

    def test_ctrl_c_leaves_the_run(self):
        self.put(models.ticking(last=1000))
        waiting = self.person.start("start", "ticking", "--wait")
        core = waiting.stdout.readline().strip()
        self.server.wait_for(lambda: self.server.get(f"/cores/{core}")["status"] == "running")
        waiting.send_signal(signal.SIGINT)
        self.assertEqual(self.person.finish(waiting), (1, "", f"core {core} goes on; `race stop {core}` ends it\n"))
        self.assertEqual(self.server.get(f"/cores/{core}")["status"], "running")

    def test_what_cannot_be_started_leaves_no_core(self):
        self.put(models.ticking())
        self.assertIn("not_found", self.person.race("start", "nothing")[2])
        self.assertEqual(self.person.race("start", "ticking", "--arguments", '{"colour": 1}')[0], 1)
        self.person.done("stop", "--cell")
        status, output, errors = self.person.race("start", "ticking")
        self.assertEqual((status, output), (1, ""))
        self.assertIn("stopped: ", errors)
        self.assertEqual(self.server.get("/cores")["cores"], [])


class Stop(CommandCase):
    def test_stops_a_run_and_refuses_another_one(self):
        core = self.server.core(models.ticking(last=1000))
        self.assertRegex(self.person.done("stop", core), rf"\A +{core}  ticking +aborted ")
        status, _, errors = self.person.race("stop", core)
        self.assertEqual((status, "conflict: " in errors), (1, True))
        self.assertEqual(self.person.race("stop", "77")[0], 1)
        self.assertEqual(self.person.race("stop")[0], 2)

    def test_of_the_cell_ends_all(self):
        core = self.server.core(models.ticking(last=1000))
        self.assertEqual(self.person.done("stop", "--cell"), "the cell is stopped: nothing moves until it is reset\n")
        self.assertEqual(self.server.ended(core)["status"], "aborted")
        self.assertIn("stopped", self.person.json("stop", "--cell"))

    def test_of_the_cell_needs_no_good_token(self):
        with AccountServer() as server:
            person = Person(self, f"http://127.0.0.1:{server.port}")
            person.done("login", "observer", text=PASSWORD + "\n")
            [file] = person.tokens()
            file.chmod(0o644)
            person.done("stop", "--cell", RACE_TOKEN="race_" + 43 * "x")
            person.done("stop", "--cell", "--token-file", "none")


class Services(CommandCase):
    def test_are_listed_with_their_operations(self):
        lines = self.person.done("services").splitlines()
        self.assertIn("db (database): Ready", lines)
        self.assertIn("  list(prefix=\"\") [reads]  The keys that begin with `prefix`, sorted; error `corrupt`: a key is damaged.", lines)
        self.assertTrue(any(line.startswith("  move(") and "[moves]" in line for line in lines), lines)
        self.assertEqual([each["key"] for each in self.person.json("services")["services"]],
                         [each["key"] for each in self.server.get("/services")["services"]])


class Call(CommandCase):
    def test_prints_the_result(self):
        self.assertEqual(self.person.done("call", "db.add", "key=greeting", 'value={"text": "hello"}'), '"greeting"\n')
        for words in (('["greeting"]',), ('{"key": "greeting"}',), ("key=greeting",)):
            self.assertEqual(json.loads(self.person.done("call", "db.get", *words)), {"text": "hello"})
        self.assertEqual(self.person.json("call", "db.get", "key=greeting"), {"result": {"text": "hello"}})

    def test_an_error_of_the_service_is_1(self):
        status, output, errors = self.person.race("call", "db.get", "key=nothing")
        self.assertEqual((status, output, errors.split(": ")[:2]), (1, "", ["db.get", "not_found"]))
        status, output, _ = self.person.race("call", "db.get", "key=nothing", "--json")
        self.assertEqual((status, json.loads(output)["error"]["code"]), (1, "not_found"))
        self.assertEqual(self.person.race("call", "nobody.get")[0], 1)

    def test_what_moves_needs_the_controls(self):
        status, _, errors = self.person.race("call", "robot.move", json.dumps({"target": {"joints": HOME}, "speed": 0.2}))
        self.assertEqual((status, "leased: " in errors or "not_accepted: " in errors), (1, True), errors)


if __name__ == "__main__":
    unittest.main()
