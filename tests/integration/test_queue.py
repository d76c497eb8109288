"""Queued runs: one after the other, by whoever queued them; what pauses the queue, and what a restart leaves of it."""
import itertools
import shutil
import tempfile
import time
import unittest

import models
from accounts import AccountServer
from client import PROJECT, Server, check
from controls import Controls

ENDED = ("ended", "refused", "cancelled")


class QueueCase(unittest.TestCase):
    def queue(self, document, key=None, **more):
        """(status, queued_run.json or problem) of a run that is queued."""
        headers = {} if key is None else {"Idempotency-Key": key}
        status, answer = self.server.request("POST", "/api/v1/queue", {"document": document, **more}, headers)
        if status == 201:
            check("queued_run", answer)
        return status, answer

    def queued(self, document, **more):
        """The id of a run that is queued."""
        status, answer = self.queue(document, **more)
        self.assertEqual(status, 201, answer)
        return answer["id"]

    def run_of(self, number):
        return self.server.get(f"/queue/{number}", "queued_run")

    def until(self, number, *status):
        """The queued run, once it has one of these."""
        self.server.wait_for(lambda: self.run_of(number)["status"] in status)
        return self.run_of(number)

    def paused(self):
        return self.server.get("/queue", "queue").get("paused")

    def until_paused(self):
        self.server.wait_for(self.paused)
        return self.paused()

    def resume(self):
        return self.server.post("/queue/resume", None, "queue")


class Queue(QueueCase):
    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.stop)
        for document in (models.ticking("short", last=2), models.ticking("long", last=100000), models.faulty("faulty")):
            self.server.put(f"/documents/{document['name']}", document, "document_entry")

    def test_runs_go_one_after_the_other(self):
        first = self.queued("short", name="first", arguments={"last": 3})
        others = [self.queued("short") for _ in range(3)]
        runs = [self.until(each, *ENDED) for each in (first, *others)]
        self.assertEqual([run["status"] for run in runs], ["ended"] * 4)
        self.assertEqual([(run["end"], run["outcome"]) for run in runs], [("ended", "done")] * 4)
        self.assertEqual((runs[0]["name"], runs[0]["arguments"]), ("first", {"last": 3}))
        stored = [self.server.get(f"/runs/{run['core']}", "run") for run in runs]
        self.assertEqual(self.server.get(f"/cores/{runs[0]['core']}", "core")["results"], {"n": 3})
        for before, after in itertools.pairwise(stored):
            self.assertLessEqual(before["ended"], after["created"])

    def test_a_page_is_some_of_them_in_order(self):
        first = self.queued("long")
        ids = [first, *(self.queued("short") for _ in range(4))]
        self.until(first, "running")
        page = self.server.get("/queue?limit=2", "queue")
        self.assertEqual(([run["id"] for run in page["runs"]], page["waiting"]), (ids[:2], 4))
        rest = self.server.get(f"/queue?after={page['next']}", "queue")
        self.assertEqual([run["id"] for run in rest["runs"]], ids[2:])
        self.assertNotIn("next", rest)
        self.assertEqual(self.server.request("GET", "/api/v1/queue?limit=101")[0], 400)

    def test_what_is_wrong_is_refused_when_it_is_queued(self):
        for body, status, path, code in (
                ({"document": "nothing"}, 404, "nothing", "not_found"),
                ({"document": "short", "arguments": {"colour": 1}}, 422, "arguments/colour", "unknown_name"),
                ({"document": "short", "on_fault": "perhaps"}, 400, "on_fault", "out_of_range"),
                ({"document": "short", "name": "x" * 101}, 413, "name", "too_large"),
                ({"document": "short", "later": True}, 422, "later", "unknown_field"),
                ({}, 422, "document", "missing"),
                ({"document": "short", "arguments": {"last": ["x" * 70000]}}, 413, "arguments", "too_large")):
            with self.subTest(body=str(body)[:100]):
                got, answer = self.server.request("POST", "/api/v1/queue", body)
                error = answer["errors"][0]
                self.assertEqual((got, error["path"], error["code"]), (status, path, code))
        self.assertEqual(self.server.get("/queue", "queue"), {"waiting": 0, "runs": []})

    def test_a_key_queues_once(self):
        status, first = self.queue("long", key="once")
        self.assertEqual((status, self.queue("long", key="once")[1]["id"]), (201, first["id"]))
        self.assertEqual(len(self.server.get("/queue", "queue")["runs"]), 1)

    def test_one_that_waits_is_cancelled(self):
        first, second = self.queued("long"), self.queued("short")
        self.until(first, "running")
        self.server.wait_for(lambda: "core" in self.run_of(first))
        self.assertEqual(self.server.expect("DELETE", f"/queue/{second}", None, "queued_run", 200)["status"], "cancelled")
        for number, status in ((second, 409), (first, 409), ("77", 404)):
            self.server.expect("DELETE", f"/queue/{number}", None, None, status)
        self.server.get("/queue/77", status=404)
        core = self.run_of(first)["core"]
        self.server.post(f"/cores/{core}/stop", None, "core")
        self.assertEqual(self.until_paused(), {"reason": "aborted", "run": first})

    def test_a_fault_pauses_the_queue_unless_its_run_says_otherwise(self):
        ids = [self.queued("faulty", on_fault="go_on"), self.queued("faulty"), self.queued("short")]
        self.assertEqual(self.until_paused(), {"reason": "faulted", "run": ids[1]})
        self.assertEqual([self.run_of(each)["status"] for each in ids], ["ended", "ended", "waiting"])
        self.assertNotIn("paused", self.resume())
        self.assertEqual(self.until(ids[2], *ENDED)["outcome"], "done")

    def test_a_stop_of_the_cell_begins_nothing_and_neither_does_its_reset(self):
        first, second = self.queued("long", on_fault="go_on"), self.queued("short")
        self.until(first, "running")
        self.server.post("/stop", None, "control")
        self.assertEqual(self.until(first, "ended")["end"], "aborted")
        self.assertEqual(self.server.request("POST", "/api/v1/queue/resume")[0], 409)
        self.server.post("/stop/reset", None, "control")
        third = self.queued("short")
        time.sleep(0.2)
        self.assertEqual([self.run_of(each)["status"] for each in (second, third)], ["waiting"] * 2)
        self.resume()
        self.assertEqual(self.until(third, *ENDED)["outcome"], "done")

    def test_what_is_queued_while_the_cell_is_stopped_waits(self):
        self.server.post("/stop", None, "control")
        first = self.queued("short")
        self.assertEqual(self.until_paused(), {"reason": "stopped"})
        self.server.post("/stop/reset", None, "control")
        time.sleep(0.2)
        self.assertEqual(self.run_of(first)["status"], "waiting")
        self.resume()
        self.assertEqual(self.until(first, *ENDED)["outcome"], "done")

    def test_it_has_a_bound(self):
        self.until(self.queued("long"), "running")
        for _ in range(100):
            self.queued("short")
        status, answer = self.queue("short")
        self.assertEqual((status, answer["errors"][0]["code"]), (409, "conflict"))


class Restart(QueueCase):
    def test_a_restart_leaves_nothing_of_it(self):
        data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, data)
        with Server(data=data) as self.server:
            for document in (models.ticking("short", last=2), models.ticking("long", last=100000)):
                self.server.put(f"/documents/{document['name']}", document, "document_entry")
            first = self.queued("long")
            self.queued("short")
            self.until(first, "running")
            self.server.wait_for(lambda: "core" in self.run_of(first))
            core = self.run_of(first)["core"]
        with Server(data=data) as self.server:
            self.assertEqual(self.server.get("/queue", "queue"), {"waiting": 0, "runs": []})
            self.assertEqual(self.server.get(f"/cores/{core}", "core")["status"], "interrupted")
            self.server.post(f"/cores/{core}/stop", None, "core")
            time.sleep(0.2)
            self.assertEqual([each["id"] for each in self.server.get("/cores", "cores")["cores"]], [core])

    def test_a_restored_backup_cancels_what_waits(self):
        with Server() as self.server:
            self.server.put("/documents/short", models.ticking("short", last=2), "document_entry")
            backup = self.server.post("/backups", None, "backup", 201)
            self.server.post("/stop", None, "control")
            status, first = self.queue("short", key="once")
            self.assertEqual(status, 201)
            self.until_paused()
            self.server.expect("POST", "/backups/20200101T000000.000Z/restore", None, None, 404)
            self.assertEqual(self.run_of(first["id"])["status"], "waiting")
            self.assertEqual(self.queue("short", key="once")[1]["id"], first["id"])
            self.server.post(f"/backups/{backup['name']}/restore", None, "backup")
            self.assertEqual(self.run_of(first["id"])["status"], "cancelled")
            self.assertNotEqual(self.queue("short", key="once")[1]["id"], first["id"])


class Persons(QueueCase):
    """A run that moves the arm begins by the rules of a start, whoever has queued it and when."""

    def test_in_programming_mode_only_who_has_the_controls_begins_one(self):
        with Server("--demo", str(PROJECT / "deploy/demo")) as self.server:
            self.server.put("/documents/short", models.ticking("short", last=2), "document_entry")
            person = Controls(self.server).programming()
            self.addCleanup(person.close)
            status, theirs = person.request("POST", "/queue", {"document": "short"})
            self.assertEqual(status, 201)
            self.assertEqual(self.until(theirs["id"], *ENDED)["outcome"], "done")
            others = self.queued("short")
            self.assertEqual(self.until(others, *ENDED)["errors"][0]["code"], "leased")
            self.assertEqual(self.paused(), {"reason": "refused", "run": others})
            status, late = person.request("POST", "/queue", {"document": "short"})
            self.assertEqual(status, 201)
            person.close()
            self.server.wait_for(lambda: self.server.get("/control", "control")["holder"] is None)
            self.resume()
            self.assertEqual(self.until(late["id"], *ENDED)["errors"][0]["code"], "leased")
            nobodys = self.queued("short")
            self.resume()
            self.assertEqual(self.until(nobodys, *ENDED)["errors"][0]["code"], "conflict")
            cores = lambda: [core["status"] for core in self.server.get("/cores", "cores")["cores"]]
            self.server.wait_for(lambda: cores() == ["ended"])  # what was refused leaves no core

    def test_who_is_not_who_they_were_begins_nothing(self):
        with AccountServer() as self.server:
            for document in (models.ticking("short", last=2), models.ticking("long", last=100000)):
                self.server.put(f"/documents/{document['name']}", document, "document_entry")
            self.assertEqual(self.server.ask("observer", "POST", "/api/v1/queue", {"document": "short"}), 403)
            self.assertEqual(self.server.ask("observer", "GET", "/api/v1/queue"), 200)
            self.assertEqual(self.server.ask("operator", "POST", "/api/v1/queue", {"document": "long"}), 201)
            self.assertEqual(self.server.ask("operator", "POST", "/api/v1/queue", {"document": "short"}), 201)
            self.assertEqual(self.server.ask("developer", "POST", "/api/v1/queue", {"document": "short"}), 201)
            first = self.until("1", "running")
            self.server.wait_for(lambda: "core" in self.run_of("1"))
            self.assertEqual(first["by"], "operator")
            self.server.expect("DELETE", "/accounts/operator", None, "account_removed", 200)
            self.server.post(f"/cores/{self.run_of('1')['core']}/stop", None, "core")
            self.until_paused()
            self.resume()
            self.assertEqual(self.until("2", *ENDED)["errors"][0]["code"], "rights")
            self.server.put("/accounts/developer", {"role": "operator"}, "account")  # who still may, and is another
            self.resume()
            self.assertEqual(self.until("3", *ENDED)["errors"][0]["code"], "rights")
            rows = [(row["account"], row["action"], row["outcome"]) for row in self.server.audited("queue start 3")]
            self.assertIn(("operator", "queue start 2", "rights"), rows)


if __name__ == "__main__":
    unittest.main()
