"""Requests that are answered before their work is done (Prefer: respond-async), and what they come to."""
import unittest

import models
from accounts import AccountServer
from client import Server, check

ASYNC = {"Prefer": "respond-async"}


class TaskCase(unittest.TestCase):
    def begin(self, method, path, body=None, **headers):
        """The task of a request that prefers to be answered at once."""
        status, task = self.server.request(method, "/api/v1" + path, body, {**ASYNC, **headers})
        self.assertEqual(status, 202, task)
        return check("task", task)

    def over(self, task):
        """The task, once its work is done; until then, what it says of its progress never goes back."""
        seen = []

        def is_over():
            seen.append(self.server.get(f"/tasks/{task['id']}", "task"))
            return seen[-1]["status"] != "running"

        self.server.wait_for(is_over)
        said = [each["progress"] for each in seen if "progress" in each]
        self.assertEqual(said, sorted(said, key=lambda each: each["done"]))
        self.assertLessEqual(len({(each["total"], each["unit"]) for each in said}), 1, said)
        for each in said:
            self.assertLessEqual(each["done"], each["total"])
        return seen[-1]

    def assert_all_of(self, task, unit, total=None):
        """That it says that all of so much is done."""
        progress = task["progress"]
        self.assertEqual((progress["done"], progress["unit"]), (progress["total"], unit))
        if total is not None:
            self.assertEqual(progress["total"], total)


class Tasks(TaskCase):
    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.stop)

    def test_a_backup_and_its_restore(self):
        self.server.put("/documents/kept", models.ticking("kept"), "document_entry")
        begun = self.begin("POST", "/backups")
        self.assertEqual(begun["request"], "POST /api/v1/backups")
        made = self.over(begun)
        self.assertEqual((made["status"], made["code"]), ("done", 201))
        self.assertEqual(self.server.get(made["location"].removeprefix("/api/v1"), "backup"), made["result"])
        self.assert_all_of(made, "bytes")
        self.server.put("/documents/new", models.ticking("new"), "document_entry")
        restored = self.over(self.begin("POST", f"/backups/{made['result']['name']}/restore"))
        self.assertEqual((restored["status"], restored["code"], restored["result"]), ("done", 200, made["result"]))
        self.assert_all_of(restored, "bytes")
        self.assertEqual([each["name"] for each in self.server.get("/documents", "documents")["documents"]], ["kept"])
        missing = self.over(self.begin("POST", "/backups/20200101T000000.000Z/restore"))
        self.assertEqual((missing["status"], missing["code"], missing["errors"][0]["code"]), ("failed", 404, "not_found"))
        self.assertNotIn("progress", missing)

    def test_the_import_of_a_run(self):
        core = self.server.core(models.ticking("moved", last=1), {"last": 1})
        self.server.ended(core)
        file = self.server.get(f"/runs/{core}/export")
        made = self.over(self.begin("POST", "/runs", file))
        self.assertEqual((made["status"], made["code"]), ("done", 201))
        self.assertEqual(self.server.get(made["location"].removeprefix("/api/v1"), "run"), made["result"])
        self.assert_all_of(made, "entries", 2 * file["run"]["steps"])
        refused = self.over(self.begin("POST", "/runs", {**file, "journal": 1}))
        self.assertEqual((refused["status"], refused["code"]), ("failed", 422))

    def test_many_at_once_keep_nobody_waiting(self):
        begun = [self.begin("POST", "/backups") for _ in range(16)]
        self.assertEqual(self.server.get("/documents", "documents")["documents"], [])
        codes = [self.over(each)["code"] for each in begun]
        self.assertEqual(set(codes) - {201, 409}, set())  # two of a millisecond are a conflict
        self.assertIn(201, codes)

    def test_who_does_not_prefer_it_is_answered_as_ever(self):
        self.server.post("/backups", None, "backup", 201)
        self.assertEqual(self.server.request("POST", "/api/v1/backups", None, {"Prefer": "wait=10"})[0], 201)
        self.server.put("/documents/other", models.ticking("other"), "document_entry")
        self.assertEqual(self.server.request("POST", "/api/v1/cores", {"document": "other"}, ASYNC)[0], 201)

    def test_a_key_begins_one_task(self):
        first, again = (self.begin("POST", "/backups", **{"Idempotency-Key": "once"}) for _ in range(2))
        self.assertEqual(first["id"], again["id"])
        self.over(first)
        self.assertEqual(len(self.server.get("/backups", "backups")["backups"]), 1)

    def test_what_is_over_or_not_there_is_not_cancelled(self):
        made = self.over(self.begin("POST", "/backups"))
        for number, status in ((made["id"], 409), ("77", 404)):
            self.server.expect("DELETE", f"/tasks/{number}", None, None, status)
        self.server.get("/tasks/77", status=404)


class Rights(TaskCase):
    def test_a_task_is_of_who_has_asked_and_of_admins(self):
        with AccountServer() as self.server:
            made = self.over(self.begin("POST", "/backups"))
            self.assertEqual(self.server.ask("admin", "GET", f"/api/v1/tasks/{made['id']}"), 200)
            self.assertEqual(self.server.ask("developer", "GET", f"/api/v1/tasks/{made['id']}"), 404)
            rows = [(row["action"], row["outcome"]) for row in self.server.audited("task ")]
            self.assertIn(("POST /api/v1/backups", "202"), rows)
            self.assertIn((f"task {made['id']}", "201"), rows)


if __name__ == "__main__":
    unittest.main()
