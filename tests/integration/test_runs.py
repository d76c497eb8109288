"""Stored runs: listed, opened, replayed, compared, exported and imported, removed."""
import http.client
import json
import shutil
import sqlite3
import subprocess
import tempfile
import threading
import time
import unittest
from contextlib import closing, suppress
from itertools import pairwise
from pathlib import Path

import models
from client import PROGRAM, PROJECT, Server
from stored_data import as_derived


def race(*words):
    """(status, stdout, stderr)"""
    out = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, timeout=280, check=False)
    return out.returncode, out.stdout, out.stderr


class Runs(unittest.TestCase):
    def setUp(self):
        self.data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, self.data)

    def run_once(self, server, document, arguments=None):
        """Runs a task to its end and deletes the core; gives its run and its derivations as the core told them."""
        core = server.core(document, arguments)
        ended = server.ended(core)
        steps = server.get(f"/cores/{core}/derivations?from=1&to={ended['step']}", "derivations")
        server.expect("DELETE", f"/cores/{core}", None, "core", 200)
        return server.get(f"/runs/{core}", "run"), steps

    def test_a_run_outlives_its_core_and_the_server(self):
        with Server(data=self.data) as server:
            run, derivations = self.run_once(server, models.ticking("kept", last=4), {"last": 3})
            self.assertEqual((run["document"], run["revision"], run["arguments"]), ("kept", 1, {"last": 3}))
            self.assertEqual((run["status"], run["outcome"], run["results"]), ("ended", "done", {"n": 3}))
            self.assertGreaterEqual(run["ended"], run["created"])
        with Server(data=self.data) as server:
            path = f"/runs/{run['id']}"
            self.assertEqual(server.get(path, "run"), run)
            self.assertEqual(server.get(f"{path}/derivations?from=1&to={run['steps']}", "derivations"), derivations)
            self.assertEqual(len(server.get(f"{path}/journal", "journal")["entries"]), run["steps"])
            self.assertEqual(len(server.get(f"{path}/script", "script")["steps"]), run["steps"])
            server.get(f"{path}/native", "native")
            self.assertEqual(server.get(f"{path}/samples", "samples"), {"samples": []})
            status, text, _ = race("replay", run["id"], "--data", self.data)  # while the server runs
            replayed = json.loads(text)
            self.assertEqual((status, replayed["status"], replayed["outcome"]), (0, "ended", "done"))
            self.assertEqual(replayed["steps"], [as_derived(step) for step in derivations["steps"]])
            status, text, _ = race("replay", run["id"], "--data", self.data, "--hash")
            self.assertEqual(status, 0)
            self.assertIn(f"steps {run['steps']}\nchain {run['chain']}\n", text)
            self.assertEqual(json.loads(race("runs", "--data", self.data, "--json")[1]), server.get("/runs", "runs"))

    def test_runs_are_listed_in_parts_and_by_document(self):
        with Server(data=self.data) as server:
            ids = []
            for name in ("one", "other", "one"):
                core = server.core(models.ticking(name), start=False)
                ids.append(core)
            listed = lambda query="": [run["id"] for run in server.get("/runs" + query, "runs")["runs"]]
            self.assertEqual(listed(), ids[::-1])
            self.assertEqual(listed("?document=one"), [ids[2], ids[0]])
            part = server.get("/runs?limit=2", "runs")
            self.assertEqual([run["id"] for run in part["runs"]], [ids[2], ids[1]])
            self.assertEqual(listed(f"?before={part['next']}"), [ids[0]])
            self.assertNotIn("next", server.get("/runs?limit=3", "runs"))
            for query in ("?limit=0", "?limit=101", "?limit=x", "?before=0"):
                server.get("/runs" + query, status=400)

    def test_a_file_of_a_run_opens_on_another_server(self):
        with Server(data=self.data) as server:
            run, derivations = self.run_once(server, models.storing(), {"key": "k", "value": [1, 2.5, None]})
            file = server.get(f"/runs/{run['id']}/export", "run_file")
        self.assertEqual(models.without_ids(file["document"]), models.storing())
        self.assertIn("db", file["services"])
        with Server() as server:
            server.post("/cores", {"document": "storing"}, status=404)
            imported = server.post("/runs", file, "run", 201)
            self.assertTrue(imported["imported"])
            for key in ("chain", "steps", "status", "outcome", "results", "created", "ended", "document", "revision"):
                self.assertEqual(imported[key], run[key], key)
            path = f"/runs/{imported['id']}"
            self.assertEqual(server.get(f"{path}/derivations?from=1&to={run['steps']}", "derivations"), derivations)
            again = server.get(f"{path}/export", "run_file")
            self.assertEqual({k: again[k] for k in ("journal", "services")}, {k: file[k] for k in ("journal", "services")})
            self.assertEqual(server.get("/cores", "cores")["cores"], [])
            file["journal"]["entries"][1]["input"]["result"] = {"other": 1}
            errors = server.post("/runs", file, status=422)["errors"]
            self.assertEqual([(error["path"], error["code"]) for error in errors], [("run/chain", "corrupt")])
            del file["run"], file["services"]
            errors = server.post("/runs", file, status=422)["errors"]
            self.assertLessEqual({("run", "missing"), ("services", "missing")},
                                 {(error["path"], error["code"]) for error in errors})
            server.post("/runs", "{", status=400)

    def test_a_server_that_ends_does_not_wait_for_a_long_replay(self):
        with Server(data=self.data) as server:
            core = server.core(models.slow(), start=False)
            begun = time.monotonic()
            server.post(f"/cores/{core}/start", {"arguments": {"lists": 20}}, "core")
            server.ended(core)
            lists = int(20 * 5 / (time.monotonic() - begun))  # so many take about five seconds
            core = server.core(models.slow(), {"lists": lists}, start=False)
            with suppress(AssertionError):  # it takes longer than a request waits
                server.post(f"/cores/{core}/start", None, "core")
            server.ended(core, 60)
            file = json.dumps(server.get(f"/runs/{core}/export", "run_file"))
        server = Server()
        answers = []
        asked = threading.Thread(target=self.import_into, args=(server, file, answers))
        asked.start()
        time.sleep(1)
        self.assertTrue(asked.is_alive(), answers)
        begun = time.monotonic()
        server.stop()
        asked.join()
        self.assertLess(time.monotonic() - begun, 3)
        self.assertIn(answers, ([], [503]), "the server may end before it answers")

    def import_into(self, server, file, answers):
        with suppress(OSError, http.client.HTTPException):
            answers.append(server.request("POST", "/api/v1/runs", file)[0])

    def test_a_file_of_an_earlier_build_has_the_same_hashes(self):
        """Literals: a build must read what an earlier one wrote. They change only with the version of journals, and the file."""
        status, text, errors = race("replay", PROJECT / "api/examples/run_file.ticking.json", "--hash")
        self.assertEqual((status, errors), (0, ""))
        self.assertEqual(text.split()[2:], [
            "chain", "f49306b52b8ed4cdfa88c9fe0671ca81a0ce6fd4b538986d1b196bc1834db353",
            "derivations", "bba8d3b49c6b85e0766db2abb6ad1fd5c743ffd966f25cc02673bc9032662737"])

    def test_a_file_is_replayed_by_the_command(self):
        with Server(data=self.data) as server:
            run, derivations = self.run_once(server, models.ticking("filed", last=3))
            file = server.get(f"/runs/{run['id']}/export", "run_file")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "run.json")
            path.write_text(json.dumps(file))
            status, text, _ = race("replay", path)
            self.assertEqual((status, json.loads(text)["steps"]), (0, [as_derived(step) for step in derivations["steps"]]))
            hashes = race("replay", path, "--hash")
            self.assertEqual(hashes[:2], race("replay", run["id"], "--data", self.data, "--hash")[:2])
            path.write_text(json.dumps(file["journal"]))
            self.assertEqual(race("replay", path, "--hash")[:2], hashes[:2])
            file["journal"]["entries"].pop()
            path.write_text(json.dumps(file))
            status, _, errors = race("replay", path)
            self.assertEqual(status, 2)
            self.assertIn("run/steps: corrupt: ", errors)

    def test_runs_are_compared(self):
        with Server(data=self.data) as server:
            key = {"key": "k", "value": 1}
            one, _ = self.run_once(server, models.storing("first"), key)
            same = server.post("/runs", server.get(f"/runs/{one['id']}/export", "run_file"), "run", 201)
            found = server.get(f"/runs/{one['id']}/compare?with={same['id']}", "run_comparison")
            self.assertEqual(found, {"same": True, "steps": [one["steps"]] * 2, "compared": one["steps"]})
            other, _ = self.run_once(server, models.storing("first"), {"key": "k", "value": 2})
            found = server.get(f"/runs/{one['id']}/compare?with={other['id']}", "run_comparison")
            self.assertFalse(found["same"])
            self.assertEqual(found["step"], 1)
            ours, theirs = found["first"]["micro"], found["second"]["micro"]
            self.assertEqual(ours[:found["micro"]], theirs[:found["micro"]])
            self.assertNotEqual(ours[found["micro"]], theirs[found["micro"]])
            self.assertNotEqual(found["first"]["calls"], found["second"]["calls"])
            server.get(f"/runs/{one['id']}/compare", status=422)
            server.get(f"/runs/{one['id']}/compare?with=99", status=404)
            server.get(f"/runs/{one['id']}/compare?with={same['id']}&from=99", status=400)

    def test_a_run_is_removed_once_no_core_has_it(self):
        with Server(data=self.data) as server:
            core = server.core(models.ticking("removed", last=1))
            server.ended(core)
            server.expect("DELETE", f"/runs/{core}", None, None, 409)
            server.expect("DELETE", f"/cores/{core}", None, "core", 200)
            self.assertEqual(server.expect("DELETE", f"/runs/{core}", None, "run_removed", 200), {"removed": core})
            for route in ("", "/derivations", "/journal", "/script", "/native", "/samples", "/export"):
                server.get(f"/runs/{core}{route}", status=404)
            server.get("/runs/x", status=404)
            later = server.core(models.ticking("removed"), start=False)
            self.assertGreater(int(later), int(core))

    def test_one_that_is_damaged_is_named_and_stays_and_the_others_are_hosted(self):
        with Server(data=self.data) as server:
            waiting, damaged = (server.core(models.ticking(name), start=False) for name in ("one", "other"))
        with closing(sqlite3.connect(Path(self.data, "race.sqlite"))) as store, store:
            store.execute("UPDATE run SET steps = 7 WHERE id = ?", [damaged])
            row = store.execute("SELECT * FROM run WHERE id = ?", [damaged]).fetchone()
        with Server(data=self.data) as server:
            self.assertEqual([core["id"] for core in server.get("/cores", "cores")["cores"]], [waiting])
            with server.stream() as stream:
                stream.subscribe("log")
                self.assertIn("cannot be rebuilt", str(stream.message()))
            listed = server.get("/runs", "runs")
            self.assertEqual([run["id"] for run in listed["runs"]], [waiting])
            self.assertEqual([(each["path"], each["code"]) for each in listed["damaged"]], [(f"runs/{damaged}", "corrupt")])
            self.assertEqual(server.get(f"/runs/{damaged}", status=500)["errors"], listed["damaged"])
            status, text, errors = race("runs", "--data", self.data)
            self.assertEqual((status, text.split()[0]), (1, waiting))
            self.assertIn(f"runs/{damaged}: corrupt: ", errors)
        with closing(sqlite3.connect(Path(self.data, "race.sqlite"))) as store:
            self.assertEqual(store.execute("SELECT * FROM run WHERE id = ?", [damaged]).fetchone(), row)

    def test_the_oldest_runs_are_removed_after_an_import(self):
        with Server("--keep-runs", "1", data=self.data) as server:
            run, _ = self.run_once(server, models.ticking("exported", last=1))
            file = server.get(f"/runs/{run['id']}/export", "run_file")
            imported = server.post("/runs", file, "run", 201)["id"]
            server.wait_for(lambda: [each["id"] for each in server.get("/runs", "runs")["runs"]] == [imported])

    def test_the_oldest_runs_are_removed_beyond_the_limit(self):
        with Server("--keep-runs", "2", data=self.data) as server:
            runs = [self.run_once(server, models.ticking("many", last=1))[0]["id"] for _ in range(4)]
            waiting = server.core(models.ticking("many"), start=False)
            server.wait_for(lambda: [run["id"] for run in server.get("/runs", "runs")["runs"]] == [waiting, runs[3], runs[2]])
        with Server("--keep-runs", "0", data=self.data) as server:  # at the start, too
            server.wait_for(lambda: [run["id"] for run in server.get("/runs", "runs")["runs"]] == [waiting])

    def test_the_cell_is_sampled_while_a_run_is_running(self):
        with Server("--demo", str(PROJECT / "deploy/demo"), data=self.data) as server:
            core = server.core(models.ticking("seen", last=1000))
            server.wait(core, lambda c: c["step"] > 0)
            with server.stream() as stream:
                stream.subscribe("cell/pose")
                first = stream.message()["data"]["time"]
                stream.until(lambda m: m["channel"] == "cell/pose" and m["data"]["time"] > first + 2)
            server.post(f"/cores/{core}/stop", None, "core")
            server.wait_for(lambda: server.get(f"/runs/{core}/samples", "samples")["samples"])
            samples = server.get(f"/runs/{core}/samples", "samples")["samples"]
            times = [sample["pose"]["time"] for sample in samples]
            self.assertGreaterEqual(len(times), 5)
            self.assertEqual(times, sorted(set(times)))
            self.assertGreaterEqual(min(later - earlier for earlier, later in pairwise(times)), 0.19)
            file = server.get(f"/runs/{core}/export", "run_file")
            self.assertEqual(file["samples"], samples)
            imported = server.post("/runs", file, "run", 201)
            self.assertEqual(server.get(f"/runs/{imported['id']}/samples", "samples")["samples"], samples)


class Commands(unittest.TestCase):
    def test_what_is_not_there_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            for words in (("runs", "--data", folder), ("replay", "1", "--data", folder)):
                status, _, errors = race(*words)
                self.assertEqual(status, 2)
                self.assertIn("race.sqlite: not_found: ", errors)
            with Server(data=folder):
                pass
            self.assertEqual(race("runs", "--data", folder), (0, "", ""))
            for run, code in (("1", "runs/1: not_found: "), ("one", "RUN: type: ")):
                status, _, errors = race("replay", run, "--data", folder)
                self.assertEqual(status, 2)
                self.assertIn(code, errors)


if __name__ == "__main__":
    unittest.main()
