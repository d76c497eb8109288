"""race test: tests of models as files beside them; those of the demo, wrong files, mocks, coverage, JUnit, watching, tests of runs."""
import json
import os
import signal
import subprocess
import tempfile
import unittest
import urllib.request
import xml.etree.ElementTree as ET
from pathlib import Path

import models
from client import PROGRAM, PROJECT, TIMEOUT, Server, check

DEMO = PROJECT / "deploy/demo"
OVEN = {"rsm": 1, "name": "oven",
        "operations": [{"name": "bake", "result": "int", "error": {"record": {"code": "string"}}}, {"name": "open"}],
        "events": [{"name": "hot", "data": "number"}],
        "states": [{"name": "Cold"}, {"name": "Hot", "events": ["hot"]}], "init": "Cold",
        "transitions": [{"id": "bake", "src": "Cold", "dst": "Hot", "operation": "bake", "defer": ["done", "burn"]},
                        {"id": "done", "src": "Hot", "dst": "Cold"}, {"id": "burn", "src": "Hot", "dst": "Cold", "error": "burnt"},
                        {"id": "open", "dst": "Cold", "operation": "open", "error": "opened"}]}
# Bakes for `minutes`; three outcomes.
BAKING = models.document("baking", {
    "state": "Bake", "parameters": [{"name": "minutes", "value": 3}], "results": [{"name": "loaves"}],
    "entry": "svc.oven.bake(par.minutes, heat='high')",
    "actions": [{"when": "svc.oven.bake.result", "do": "res.loaves = svc.oven.bake.result"}],
    "ports": [{"name": "baked", "when": "available(res.loaves)"},
              {"name": "burnt", "when": "svc.oven.bake.error.code == 'burnt'"}, {"name": "failed", "when": "svc.oven.bake.error"}],
}, library=[{"state": "Open", "parameters": [{"name": "why"}], "entry": "svc.oven.open()",
             "ports": [{"name": "open", "when": "svc.oven.open.result"}]}])


def test_of(name="bakes", answers=(), expect=None, **more):
    mock = {"rsm": "oven.rsm.json", "answers": [{"operation": "bake", **answer} for answer in answers]}
    return {"name": name, "services": {"oven": mock}, "expect": expect or {"outcome": "baked"}, **more}


class TestCase(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name)
        self.write("baking.rcm.json", BAKING)
        self.write("oven.rsm.json", OVEN)

    def write(self, name, value):
        new = self.folder / f"{name}.new"  # nobody reads half of it
        new.write_text(value if isinstance(value, str) else json.dumps(value))
        new.replace(self.folder / name)

    def race(self, *words):
        out = subprocess.run([PROGRAM, "test", *map(str, words)], capture_output=True, text=True, timeout=140, check=False, cwd=self.folder)
        return out.returncode, out.stdout, out.stderr

    def run_tests(self, *tests, words=()):
        """(status, the JSON output) of a file with these tests."""
        self.write("baking.test.json", check("task_test", {"race_test": 1, "tests": list(tests)}))
        status, output, errors = self.race("baking.test.json", "--json", *words)
        self.assertIn(status, (0, 1), errors)
        return status, check("test_report", json.loads(output))

    def findings(self, *tests):
        """The paths at which each test fails."""
        return [[finding["path"] for finding in test["findings"]] for test in self.run_tests(*tests)[1]["tests"]]


class Demo(TestCase):
    def test_passes_and_is_the_same_each_time(self):
        for model in DEMO.glob("*.rcm.json"):
            check("task_test", json.loads(model.with_name(model.name.replace(".rcm.json", ".test.json")).read_text()))
        first = self.race(DEMO)
        self.assertEqual((first[0], first[2]), (0, ""), first[1])
        self.assertEqual(self.race(DEMO), first)


class Expectations(TestCase):
    def test_are_met_or_named_with_what_was_seen(self):
        baked = [{"result": 2, "after": 1.5}]
        right = {"outcome": "baked", "order": ["Bake.baked"], "fired": ["Bake.baked"], "not_fired": ["Bake.burnt"],
                 "calls": [{"service": "oven", "operation": "bake", "args": [3], "kwargs": {"heat": "high"}}],
                 "not_called": [{"service": "oven", "operation": "open"}], "results": {"loaves": 2}, "within": 1.6}
        self.assertEqual(self.findings(test_of(answers=baked, expect=right)), [[]])
        for key, wrong, where in (
                ("outcome", "burnt", ""), ("order", ["Bake.baked", "Bake.baked"], "/1"), ("fired", ["Bake.burnt"], "/0"),
                ("not_fired", ["Bake.baked"], "/0"), ("results", {"loaves": 3}, "/loaves"), ("within", 1.4, ""),
                ("calls", [{"service": "oven", "operation": "bake", "args": [4]}], "/0"),
                ("not_called", [{"service": "oven", "operation": "bake"}], "/0")):
            with self.subTest(key=key):
                self.assertEqual(self.findings(test_of(answers=baked, expect={key: wrong})), [[f"tests/0/expect/{key}{where}"]])

    def test_a_failure_is_one_line_below_its_test(self):
        self.write("baking.test.json", {"race_test": 1, "tests": [test_of(answers=[{"error": {"code": "burnt"}}])]})
        status, output, _ = self.race("baking.test.json")
        first, second, last = output.splitlines()
        self.assertEqual((status, last), (1, "1 tests, 1 failed"))
        self.assertRegex(first, r"^FAIL  baking\.test\.json: bakes  \(0\.1\d\d s of world time, seed 1\)$")
        self.assertIn("tests/0/expect/outcome: expected `baked`, but it ended at `burnt` at 0.1", second)

    def test_a_run_that_goes_on_or_faults_has_a_status(self):
        self.assertEqual(self.findings(test_of(answers=[{"never": True}], expect={"status": "running"}, limit=5),
                                       test_of("b", [{"never": True}], limit=5)), [[], ["tests/1/expect/outcome"]])


class Mocks(TestCase):
    def test_give_each_answer_that_the_rsm_allows(self):
        for answer, outcome in (({"result": 1}, "baked"), ({"error": {"code": "burnt"}}, "burnt"), ({"error": {"code": "out"}}, "failed"),
                                ({"error": {"code": "unavailable"}}, "failed"), ({"error": {"code": "not_accepted"}}, "failed")):
            self.assertEqual(self.findings(test_of(answers=[answer], expect={"outcome": outcome})), [[]], answer)

    def test_choose_by_the_seed_where_nothing_is_listed(self):
        seen = {}
        for seed in range(12):
            paths = {outcome: self.findings(test_of(expect={"outcome": outcome}, seed=seed)) for outcome in ("baked", "burnt", "failed")}
            [seen[seed]] = [outcome for outcome, found in paths.items() if found == [[]]]
        self.assertEqual(set(seen.values()), {"baked", "burnt", "failed"})
        for seed, outcome in seen.items():
            status, output = self.run_tests(test_of(expect={"outcome": outcome}), words=("--seed", seed))
            self.assertEqual((status, output["tests"][0]["seed"]), (0, seed))

    def test_a_state_of_the_library_is_tested_by_itself(self):
        test = test_of(state="Open", arguments={"why": "hungry"}, expect={"outcome": "open"})
        self.assertEqual(self.findings(test), [[]])


    def test_a_service_is_no_timer_because_its_rsm_is_called_so(self):
        self.write("cell.json", {"cell": 1, "services": {}, "expects": {"oven": {"type": "oven", "rsm": "oven.rsm.json"}}})
        for name in ("oven", "timer", "database"):
            with self.subTest(name=name):
                self.write("oven.rsm.json", {**OVEN, "name": name})
                test = {"name": "opens", "state": "Open", "arguments": {"why": 1}, "expect": {"outcome": "open"}}
                self.assertEqual(self.findings(test), [[]])


class Output(TestCase):
    def test_coverage_names_what_no_test_has_come_to(self):
        _, output = self.run_tests(test_of(answers=[{"result": 1}]), words=("--coverage",))
        coverage = output["coverage"]["baking.rcm.json"]
        self.assertEqual(coverage["states"], {"covered": 1, "all": 2, "reached": ["Bake"], "missing": ["library/Open"]})
        self.assertEqual(coverage["ports"]["missing"], ["Bake.burnt", "Bake.failed", "library/Open.open"])
        self.assertEqual(coverage["conditions"]["missing"], [
            {"at": "Bake.burnt", "value": True}, {"at": "Bake.failed", "value": True},
            {"at": "library/Open.open", "value": True}, {"at": "library/Open.open", "value": False}])
        self.assertIn({"at": "Bake.burnt", "value": False}, coverage["conditions"]["reached"])
        _, output = self.run_tests(
            test_of(answers=[{"result": 1}]), test_of("b", [{"error": {"code": "burnt"}}], {"outcome": "burnt"}),
            test_of("c", [{"error": {"code": "x"}}], {"outcome": "failed"}),
            test_of("d", state="Open", arguments={"why": 1}, expect={"outcome": "open"}), words=("--coverage",))
        coverage = output["coverage"]["baking.rcm.json"]
        self.assertEqual([(each["covered"], each["missing"]) for each in coverage.values()][:2], [(2, []), (4, [])])
        self.assertEqual([each for each in coverage["conditions"]["missing"] if each["at"].startswith("Bake")], [])
        self.assertIn("coverage of baking.rcm.json: states 2 of 2 (100 %), ports 4 of 4 (100 %)",
                      self.race("baking.test.json", "--coverage")[1])

    def test_coverage_is_of_states_and_actions_of_the_document(self):
        self.write("late.rcm.json", models.document("late", {
            "state": "Root", "results": [{"name": "n", "initial": 0}], "actions": [{"when": "res.n == 0", "do": "res.n = 1"}],
            "ports": [{"name": "late", "after": "0.1"}]}))
        self.write("late.test.json", {"race_test": 1, "tests": [{"name": "a", "expect": {"outcome": "late"}}]})
        output = check("test_report", json.loads(self.race("late.test.json", "--coverage", "--json")[1]))
        coverage = output["coverage"]["late.rcm.json"]
        self.assertEqual(coverage["states"], {"covered": 1, "all": 1, "reached": ["Root"], "missing": []})
        self.assertEqual(coverage["ports"]["reached"], ["Root.late"])
        self.assertIn({"at": "Root", "action": 1, "value": True}, coverage["conditions"]["reached"])
        self.assertNotIn("never active", self.race("late.test.json", "--coverage")[1])

    def test_junit_has_each_test_and_why_it_fails(self):
        status, _ = self.run_tests(test_of('<"one">', [{"result": 1}]), test_of("two", [{"error": {"code": "burnt"}}]),
                                   words=("--junit", "out.xml"))
        root = ET.parse(self.folder / "out.xml").getroot()
        self.assertEqual((status, root.get("tests"), root.get("failures")), (1, "2", "1"))
        cases = root.findall("testsuite/testcase")
        self.assertEqual([(case.get("classname"), case.get("name"), case.find("failure") is None) for case in cases],
                         [("baking.test.json", '<"one">', True), ("baking.test.json", "two", False)])
        self.assertIn("tests/1/expect/outcome: expected `baked`", cases[1].find("failure").get("message"))


class OfRuns(TestCase):
    """--from makes a test of a run, which passes at once."""

    def exported(self, document, arguments=None, *options):
        """The file of a run, which is over, and its model beside."""
        with Server(*options) as server:
            core = server.core(document, arguments)
            server.ended(core, 3 * TIMEOUT)
            self.write("run.json", server.get(f"/runs/{core}/export", "run_file"))
        name = document["name"]
        self.write(f"{name}.rcm.json", document)
        return f"{name}.test.json"

    def made(self, name):
        """The one test of a file that --from made."""
        content = check("task_test", json.loads(self.folder.joinpath(name).read_text()))
        [test] = content["tests"]
        return test

    def test_its_inputs_are_listed_and_what_came_of_them_is_expected(self):
        name = self.exported(models.storing(), {"key": "k", "value": [1, 2.5, None]})
        status, output, errors = self.race(name, "--from", "run.json")
        self.assertEqual((status, errors, output.splitlines()[-1]), (0, "", "1 tests, 0 failed"), output)
        test = self.made(name)
        self.assertEqual((test["name"], test["arguments"]), ("as run run.json", {"key": "k", "value": [1, 2.5, None]}))
        self.assertEqual([answer["operation"] for answer in test["services"]["db"]["answers"]], ["add", "get"])
        self.assertEqual(test["expect"], {
            "outcome": "success", "order": ["Root/Add.success", "Root/Get.success", "Root.success"], "results": {"read": [1, 2.5, None]},
            "calls": [{"service": "db", "operation": "add", "args": ["k", [1, 2.5, None]], "kwargs": {}},
                      {"service": "db", "operation": "get", "args": [], "kwargs": {"key": "k"}}], "tolerance": 1e-9})
        test["services"]["db"]["answers"][1]["result"] = [1, 2.5, 0]
        self.write(name, {"race_test": 1, "tests": [test]})
        self.assertEqual(self.race(name)[0], 1)

    def test_events_and_faults_are_those_of_the_run(self):
        for document, status in ((models.ticking(last=4), "ended"), (models.faulty(), "faulted")):
            name = self.exported(document)
            self.assertEqual(self.race(name, "--from", "run.json")[0], 0, document["name"])
            self.assertEqual(self.made(name)["expect"].get("status", "ended"), status)

    def test_a_run_in_the_simulated_cell_passes_with_mocks(self):
        for path in DEMO.iterdir():
            if path.name != "README.md" and not path.name.endswith((".rcm.json", ".test.json")):
                os.symlink(path, self.folder / path.name)
        name = self.exported(json.loads(DEMO.joinpath("pick.rcm.json").read_text()), None, "--demo", str(DEMO))
        status, output, errors = self.race(name, "--from", "run.json")
        self.assertEqual((status, errors), (0, ""), output)
        test = self.made(name)
        self.assertEqual(test["expect"]["outcome"], "success")
        self.assertLessEqual({"robot", "gripper", "db"}, set(test["services"]))

    def test_of_a_data_folder_by_number(self):
        data = self.folder / "data"
        data.mkdir()
        with Server(data=str(data)) as server:
            core = server.core(models.storing(), {"value": 7})
            server.ended(core)
            self.write("storing.rcm.json", models.storing())
            self.assertEqual(self.race("storing.test.json", "--from", core, "--data", "data")[:1], (0,))
        for words, error in ((("--from", "77"), "not_found: "), (("--from", "x"), "--from: type: ")):
            status, _, errors = self.race("other.test.json", *words, "--data", "data")
            self.assertEqual((status, error in errors), (2, True), errors)

    def test_a_server_makes_the_same_file(self):
        data = self.folder / "data"
        data.mkdir()
        for name in ("storing", "other"):
            self.write(f"{name}.rcm.json", models.storing())
        with Server(data=str(data)) as server:
            core = server.core(models.storing(), {"value": 7})
            server.ended(core)
            server.get(f"/runs/{core}/test", "task_test")
            with urllib.request.urlopen(f"http://127.0.0.1:{server.port}/api/v1/runs/{core}/test", timeout=TIMEOUT) as answer:
                text, disposition = answer.read(), answer.headers["Content-Disposition"]
        self.assertEqual(disposition, 'attachment; filename="storing.test.json"')
        self.write("storing.test.json", text.decode())
        self.assertEqual(self.race("storing.test.json")[::2], (0, ""))
        self.assertEqual(self.race("other.test.json", "--from", core, "--data", "data")[0], 0)
        self.assertEqual(self.folder.joinpath("other.test.json").read_bytes(), text)

    def test_a_server_says_why_a_run_makes_no_test(self):
        def refused(run, status):
            [error] = server.get(f"/runs/{run}/test", status=status)["errors"]
            return error["code"], error["message"]
        with Server() as server:
            running = server.core(models.ticking(last=100000))
            self.assertEqual(refused(running, 422), ("not_accepted", "the run is not over"))
            server.post(f"/cores/{running}/stop", None, "core")
            server.ended(running)
            self.assertEqual(refused(running, 422), ("not_accepted", "somebody has edited, forced or aborted the run, as no test can"))
            self.assertEqual(refused("77", 404)[0], "not_found")
            large = server.core(models.storing(), {"value": ["\n" * 1000] * 900})
            self.assertEqual(server.ended(large)["status"], "ended")
            self.assertEqual(refused(large, 413)[0], "too_large")

    def test_of_deep_data_is_no_longer_than_the_data(self):
        """Each level in a line of its own would make it many times as long."""
        deep = 1
        for _ in range(40):
            deep = [deep]
        value = [deep] * 2000
        with Server() as server:
            run = server.core(models.storing(), {"value": value})
            self.assertEqual(server.ended(run)["status"], "ended")
            with urllib.request.urlopen(f"http://127.0.0.1:{server.port}/api/v1/runs/{run}/test", timeout=TIMEOUT) as answer:
                text = answer.read()
        self.assertLess(len(text), 5 * len(json.dumps(value)))

    def test_what_makes_no_test_leaves_no_file(self):
        name = self.exported(models.storing(), {"value": 7})
        self.folder.joinpath("storing.rcm.json").unlink()
        with Server() as server:
            core = server.core(models.ticking(last=1000))
            server.post(f"/cores/{core}/stop", None, "core")
            server.ended(core)
            self.write("aborted.json", server.get(f"/runs/{core}/export"))
        for words, error in (
                ((name, "--from", "run.json"), "io: storing.rcm.json: "),  # no model
                (("baking.test.json", "--from", "run.json"), "not_found: "),  # another model
                (("baking.test.json", "--from", "aborted.json"), "aborted.json: not_accepted: "),
                (("baking.json", "--from", "run.json"), "baking.json: name: "),
                (("baking.test.json", "--from", "oven.rsm.json"), "oven.rsm.json: "),
                (("a.test.json", "b.test.json", "--from", "run.json"), "FILE: syntax: "),
                (("baking.test.json", "--data", "data"), "--data: conflict: "),
                (("baking.test.json", "--watch", "--from", "run.json"), "--watch: conflict: ")):
            with self.subTest(words=words):
                status, _, errors = self.race(*words)
                self.assertEqual((status, error in errors), (2, True), errors)
                self.assertEqual(list(self.folder.glob("*.test.json")), [])
                self.assertFalse(self.folder.joinpath("baking.json").exists())
        self.write("baking.test.json", "mine")
        self.assertIn("baking.test.json: conflict: ", self.race("baking.test.json", "--from", "run.json")[2])
        self.assertEqual(self.folder.joinpath("baking.test.json").read_text(), "mine")


class Watch(TestCase):
    def setUp(self):
        super().setUp()
        self.write("a.test.json", {"race_test": 1, "model": "baking.rcm.json", "tests": [test_of("a", [{"result": 1}])]})
        self.write("b.test.json", {"race_test": 1, "model": "open.rcm.json", "tests": [test_of("b", expect={"outcome": "open"})]})
        self.write("open.rcm.json", models.document("open", {
            "state": "Open", "entry": "svc.oven.open()", "ports": [{"name": "open", "when": "svc.oven.open.result is None"}]}))
        self.process = subprocess.Popen([PROGRAM, "test", "--watch", "--junit", "out.xml", "."], cwd=self.folder, text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.addCleanup(self.process.stdout.close)
        self.addCleanup(self.process.wait, TIMEOUT)
        self.addCleanup(self.process.kill)

    def round(self):
        """The first words of each line of a round."""
        lines = []
        while line := self.process.stdout.readline():
            if line.startswith("waiting "):
                return lines
            lines.append(line.rstrip().split("  (")[0])
        raise AssertionError(f"it has ended: {lines}")

    def ended(self, how=signal.SIGINT):
        self.process.send_signal(how)
        return self.process.wait(TIMEOUT)

    def test_what_a_changed_file_concerns_runs_again(self):
        self.assertEqual(self.round(), ["ok    ./a.test.json: a", "ok    ./b.test.json: b", "2 tests, 0 failed"])
        self.write("b.test.json", {"race_test": 1, "model": "open.rcm.json", "tests": [test_of("c", expect={"outcome": "open"})]})
        self.assertEqual(self.round(), ["ok    ./b.test.json: c", "1 tests, 0 failed"])
        self.write("baking.rcm.json", json.dumps(BAKING).replace("'burnt'", "'charred'"))
        self.assertEqual(self.round(), ["ok    ./a.test.json: a", "1 tests, 0 failed"])
        self.write("oven.rsm.json", {**OVEN, "operations": [*OVEN["operations"], {"name": "close"}]})
        self.assertEqual(len(self.round()), 3)
        self.write("database.json", {"x": 1})
        self.assertEqual(len(self.round()), 3)
        self.assertEqual(self.ended(), 0)

    def test_it_ends_with_the_last_code_of_each_file(self):
        self.round()
        self.write("a.test.json", {"race_test": 1, "model": "baking.rcm.json", "tests": [test_of("a", [{"error": {"code": "burnt"}}])]})
        self.assertEqual(self.round()[-1], "1 tests, 1 failed")
        self.write("open.rcm.json", self.folder.joinpath("open.rcm.json").read_text() + "\n")
        self.assertEqual(self.round()[-1], "1 tests, 0 failed")
        self.assertEqual(self.ended(signal.SIGTERM), 1)

    def junit(self):
        """(name, whether it passed) of each test in the file of --junit."""
        cases = ET.parse(self.folder / "out.xml").getroot().findall("testsuite/testcase")
        return [(case.get("name"), case.find("failure") is None) for case in cases]

    def test_each_file_counts_with_its_own_last_result(self):
        self.round()
        self.write("a.test.json", {"race_test": 1, "model": "baking.rcm.json", "tests": [test_of("a", [{"error": {"code": "burnt"}}])]})
        self.round()
        self.write("oven.rsm.json", json.dumps(OVEN) + "\n")  # both run, and one fails
        self.assertEqual(self.round()[-1], "2 tests, 1 failed")
        self.assertEqual(self.junit(), [("a", False), ("b", True)])
        self.write("a.test.json", {"race_test": 1, "model": "baking.rcm.json", "tests": [test_of("a", [{"result": 1}])]})
        self.assertEqual(self.round()[-1], "1 tests, 0 failed")
        self.assertEqual(self.junit(), [("a", True), ("b", True)])
        self.assertEqual(self.ended(), 0)

    def test_what_a_wrong_file_has_kept_from_running_runs_when_it_is_right(self):
        self.round()
        self.write("oven.rsm.json", "{")
        self.assertIn("./oven.rsm.json: json: ", "\n".join(self.round()))
        self.folder.joinpath("a.test.json").unlink()
        self.assertIn("./b.test.json: tests/0/services/oven/rsm: reference: ", "\n".join(self.round()))
        self.assertEqual(self.junit(), [("a", True), ("b", True)])  # of the last run that was not refused
        self.write("oven.rsm.json", OVEN)
        self.assertEqual(self.round(), ["ok    ./b.test.json: b", "1 tests, 0 failed"])
        self.assertEqual(self.junit(), [("b", True)])
        self.assertEqual(self.ended(), 0)

    def test_while_a_file_is_wrong_the_code_is_that_of_wrong_files(self):
        self.round()
        self.write("a.test.json", "{")
        self.round()
        self.write("open.rcm.json", self.folder.joinpath("open.rcm.json").read_text() + "\n")
        self.assertRegex(self.round()[0], r"\A\./a\.test\.json: json: ")
        self.write("a.test.json", {"race_test": 1, "model": "baking.rcm.json", "tests": [test_of("a", [{"result": 1}])]})
        self.assertEqual(self.round()[:2], ["ok    ./a.test.json: a", "ok    ./b.test.json: b"])
        self.write("a.test.json", "{")
        self.round()
        self.assertEqual(self.ended(), 2)

    def test_a_wrong_file_is_said_and_read_again(self):
        self.round()
        self.write("a.test.json", "{")
        [error] = self.round()
        self.assertRegex(error, r"\A\./a\.test\.json: json: ")
        self.folder.joinpath("a.test.json").unlink()
        self.assertEqual(self.round(), [])
        self.write("b.test.json", self.folder.joinpath("b.test.json").read_text() + "\n")
        self.assertEqual(self.round()[-1], "1 tests, 0 failed")
        self.assertEqual(self.ended(), 0)


class WrongFiles(TestCase):
    """Each is refused as a whole, with the place, and nothing of it runs."""

    def refused(self, content):
        """`path: code` of each error."""
        self.write("fine.test.json", {"race_test": 1, "model": "baking.rcm.json", "tests": [test_of(answers=[{"result": 1}])]})
        self.write("baking.test.json", content)
        status, output, errors = self.race("fine.test.json", "baking.test.json")
        self.assertEqual((status, output), (2, ""), errors)
        lines = [line.split(": ", 3) for line in errors.splitlines()]
        self.assertEqual({line[0] for line in lines}, {"baking.test.json"}, errors)
        return [": ".join(line[1:3]) for line in lines]

    def test_are_each_a_clear_error(self):
        one = lambda **how: {"race_test": 1, "tests": [test_of(answers=[{"result": 1}]), {**test_of("b", [{"result": 1}]), **how}]}
        oven = lambda **how: one(services={"oven": {"rsm": "oven.rsm.json", **how}})
        answer = lambda **how: oven(answers=[{"operation": "bake", **how}])
        for content, error in (
                ({"race_test": 2, "tests": [test_of()]}, "race_test: version"),
                ({"race_test": 1, "tests": []}, "tests: missing"),
                ({"race_test": 1, "model": "none.rcm.json", "tests": [test_of()]}, "model: io"),
                (one(name="bakes"), "tests/1/name: duplicate"),
                (one(expect={}), "tests/1/expect: missing"),
                (one(expect={"tolerance": 1, "fired": []}), "tests/1/expect: missing"),
                (one(outcome="baked"), "tests/1/outcome: unknown_field"),
                (one(expect={"outcome": "eaten"}), "tests/1/expect/outcome: not_found"),
                (one(expect={"order": ["Bake/Dough.done"]}), "tests/1/expect/order/0: not_found"),
                (one(expect={"results": {"rolls": 1}}), "tests/1/expect/results/rolls: not_found"),
                (one(expect={"calls": [{"service": "oven", "operation": "fry"}]}), "tests/1/expect/calls/0/operation: not_found"),
                (one(expect={"calls": [{"service": "pan", "operation": "fry"}]}), "tests/1/expect/calls/0/service: not_found"),
                (one(arguments={"hours": 1}), "tests/1/arguments/hours: unknown_name"),
                (one(state="Mix"), "tests/1/state: not_found"),
                (one(state="Open", expect={"outcome": "open"}), "tests/1/arguments/why: missing"),
                (one(limit=1e9), "tests/1/limit: out_of_range"),
                (one(services={"pan": {}}), "tests/1/services/pan: missing"),
                (one(services={"timer": {}}, cell=True), "tests/1/services/timer: conflict"),
                (oven(rsm="none.rsm.json"), "tests/1/services/oven/rsm: io"),
                (oven(events=[{"event": "cold"}]), "tests/1/services/oven/events/0: not_found"),
                (oven(samples={"hot": "very"}), "tests/1/services/oven/samples/hot: type"),
                (answer(), "tests/1/services/oven/answers/0: missing"),
                (answer(result=1, never=True), "tests/1/services/oven/answers/0: conflict"),
                (answer(result="a loaf"), "tests/1/services/oven/answers/0/result: type"),
                (answer(error={"text": "x"}), "tests/1/services/oven/answers/0/error: type"),
                (oven(answers=[{"operation": "open", "error": {"code": "stuck"}}]), "tests/1/services/oven/answers/0/error: constant"),
        ):
            with self.subTest(error=error):
                self.assertIn(error, self.refused(content))

    def test_so_is_what_is_no_json(self):
        self.write("baking.test.json", "{")
        self.assertRegex(self.race("baking.test.json")[2], r"\Abaking\.test\.json: json: ")

    def test_so_is_a_wrong_model_by_its_own_name(self):
        self.write("baking.rcm.json", models.document("baking", {"state": "Bake", "first": "Nowhere"}))
        self.write("baking.test.json", {"race_test": 1, "tests": [test_of()]})
        status, output, errors = self.race("baking.test.json")
        self.assertEqual((status, output), (2, ""))
        self.assertRegex(errors, r"\Abaking\.rcm\.json: Bake: first: ")

    def test_a_folder_without_tests_is_one(self):
        self.assertEqual(self.race(".")[0], 2)


if __name__ == "__main__":
    unittest.main()
