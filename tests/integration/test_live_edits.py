"""Cores that follow the edits of their documents while they run, and what a person forces in them (SEMANTICS section 9)."""
import json
import subprocess
import tempfile
import time
import unittest

import models
from client import PROGRAM, Server
from server_case import ServerCase


def waiting(name, first="A", **more):
    """A, B and C one after the other, as far as their ports are forced."""
    return models.document(name, {
        "state": "Root", "variables": [{"name": "n", "initial": 1}], "results": [{"name": "sum", "initial": 0}],
        "children": [{"state": "A", "ports": [{"name": "next", "when": "False", "to": "B"}]},
                     {"state": "B", "ports": [{"name": "next", "when": "False", "to": "C"}]},
                     {"state": "C"}],
        "first": first, "ports": [{"name": "done", "when": "res.sum > 100"}], **more})


class LiveEdits(unittest.TestCase):
    """One server for all; each test has documents of its own."""

    @classmethod
    def setUpClass(cls):
        cls.server = Server()

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def stored(self, name):
        return self.server.get(f"/documents/{name}", "document_entry")

    def edit(self, name, change, draft=False):
        """Stores the document as change(document) makes it; its revision."""
        document = self.stored(name)["document"]
        change(document)
        path = f"/documents/{name}" + ("?draft=true" if draft else "")
        return self.server.put(path, document, "document_entry")["revision"]

    def live(self, document, start=True):
        core = self.server.core(document, start=start)
        self.assertEqual(self.server.put(f"/cores/{core}/live", {"live": True}, "core")["live"], True)
        return core

    def at(self, core, revision):
        """The core, once it executes the revision."""
        return self.server.wait(core, lambda c: c["revision"] == revision and "waiting_edit" not in c)

    def active(self, core):
        return self.server.get(f"/cores/{core}/state", "core_state")["state"]["active"]

    def state(self, core):
        return self.server.get(f"/cores/{core}/state", "core_state")["state"]

    def force(self, core, path, scope, name, value=None, status=200):
        body = {"path": path, "scope": scope, "name": name}
        if scope != "port":
            body["value"] = value
        return self.server.post(f"/cores/{core}/force", body, "core" if status == 200 else None, status=status)

    def test_a_running_task_goes_on_with_its_values_in_the_edited_model(self):
        core = self.live(models.ticking("going", last=1000000))
        self.server.wait(core, lambda c: c["step"] > 3)
        before = self.state(core)["results"]["Root"]["n"]
        revision = self.edit("going", lambda d: d["root"]["ports"][0].update(name="enough", when="res.n >= 10"))
        self.at(core, revision)
        ended = self.server.ended(core)
        self.assertEqual((ended["status"], ended["outcome"], ended["revision"]), ("ended", "enough", revision))
        self.assertGreaterEqual(ended["results"]["n"], max(10, before))
        self.assertGreater(ended["model"], 1)

    def test_an_edit_waits_for_the_active_state_that_it_removes_and_says_so(self):
        core = self.live(waiting("removes"))

        def remove_a(document):
            root = document["root"]
            root["children"] = [c for c in root["children"] if c["state"] != "A"]
            root["first"] = "B"
        ids = {c["state"]: c["meta"]["id"] for c in self.stored("removes")["document"]["root"]["children"]}
        revision = self.edit("removes", remove_a)
        held = self.server.wait(core, lambda c: "waiting_edit" in c)
        self.assertEqual(held["waiting_edit"], {"revision": revision, "waits": [{"path": "Root/A", "id": ids["A"]}]})
        self.assertEqual((held["revision"], held["model"]), (revision - 1, 0))
        # A later edit has it in it: one edit waits, to the last revision.
        revision = self.edit("removes", lambda d: d["root"]["variables"][0].update(doc="later"))
        self.server.wait(core, lambda c: c["waiting_edit"]["revision"] == revision)
        self.force(core, "Root/A", "port", "next")
        self.at(core, revision)
        self.assertEqual(self.active(core), ["Root", "Root/B"])

    def test_a_draft_is_refused_until_its_violations_are_gone(self):
        core = self.live(waiting("draft"))
        wrong = self.edit("draft", lambda d: d["root"]["children"][0]["ports"][0].update(to="Nowhere"), draft=True)
        refused = self.server.wait(core, lambda c: "refused_edit" in c)["refused_edit"]
        self.assertEqual((refused["revision"], [e["code"] for e in refused["errors"]]), (wrong, ["port_target"]))
        right = self.edit("draft", lambda d: d["root"]["children"][0]["ports"][0].update(to="C"))
        self.assertNotIn("refused_edit", self.at(core, right))
        self.force(core, "Root/A", "port", "next")
        self.assertEqual(self.active(core), ["Root", "Root/C"])

    def test_a_core_that_is_not_live_stays_as_it_is_until_it_is(self):
        core = self.server.core(waiting("still"))
        revision = self.edit("still", lambda d: d["root"]["variables"].append({"name": "new", "initial": 7}))
        time.sleep(0.3)
        self.assertEqual(self.server.get(f"/cores/{core}", "core")["revision"], revision - 1)
        self.server.put(f"/cores/{core}/live", {"live": True}, "core")
        self.at(core, revision)
        self.assertEqual(self.state(core)["variables"]["Root"], {"n": 1, "new": 7})
        self.assertEqual(self.server.put(f"/cores/{core}/live", {"live": False}, "core")["live"], False)

    def test_a_core_that_has_not_begun_is_loaded_anew(self):
        core = self.live(waiting("ready"), start=False)
        revision = self.edit("ready", lambda d: d["root"].update(first="C"))
        ready = self.at(core, revision)
        self.assertEqual((ready["status"], ready["model"], ready["live"]), ("ready", 0, True))
        self.server.post(f"/cores/{core}/start", None, "core")
        self.assertEqual(self.active(core), ["Root", "Root/C"])

    def test_layout_notes_and_comments_alone_are_no_step_of_the_run(self):
        core = self.live(waiting("layout"))
        before = self.server.get(f"/cores/{core}", "core")["step"]
        root = self.server.get("/documents/layout", "document_entry")["document"]["root"]["meta"]["id"]
        comment = {"about": root, "author": "Ada", "time": "2026-11-26T01:00:00Z", "text": "Why?"}
        for fields in ({"layout": {root: {"x": 1, "y": 2}}}, {"meta": {"notes": {root: "a note"}}},
                       {"meta": {"comment:1": comment, "resolved:1": {"author": "Bob", "time": "later"}}}):
            with self.subTest(fields=fields):
                revision = self.edit("layout", lambda d, fields=fields: d.update(fields))
                after = self.at(core, revision)
                self.assertEqual((after["step"], after["model"]), (before, 0))

    def test_a_paused_core_gets_the_edit_when_it_goes_on(self):
        core = self.live(waiting("paused"))
        self.server.post(f"/cores/{core}/pause", None, "core")
        revision = self.edit("paused", lambda d: d["root"]["children"][0].update(state="First", ports=[
            {**d["root"]["children"][0]["ports"][0], "when": "True"}]) or d["root"].update(first="First"))
        held = self.server.wait(core, lambda c: "waiting_edit" in c)
        self.assertEqual(held["waiting_edit"], {"revision": revision, "waits": []})
        self.assertEqual(self.active(core), ["Root", "Root/A"])
        self.server.post(f"/cores/{core}/resume", None, "core")
        self.at(core, revision)
        self.assertEqual(self.active(core), ["Root", "Root/B"])

    def test_what_is_forced_is_in_the_journal_and_its_replay(self):
        core = self.live(waiting("forced"))
        revision = self.edit("forced", lambda d: d["root"]["variables"].append({"name": "x", "initial": 0}))
        self.at(core, revision)
        self.force(core, "Root", "var", "x", {"any": [1, 2.5]})
        self.assertEqual(self.state(core)["variables"]["Root"]["x"], {"any": [1, 2.5]})
        self.force(core, "Root/A", "port", "next")
        self.assertEqual(self.active(core), ["Root", "Root/B"])
        self.assertEqual(self.force(core, "Root", "res", "sum", 101)["outcome"], "done")
        journal = self.server.get(f"/cores/{core}/journal", "journal")
        self.assertEqual([e["input"]["kind"] for e in journal["entries"]], ["start", "edit", "force", "force", "force"])
        self.assertEqual(journal["entries"][1]["input"]["revision"], revision)
        live = self.server.get(f"/cores/{core}/derivations?from=1&to=5", "derivations")["steps"]
        self.assertEqual([s["input"]["kind"] for s in live], ["start", "edit", "force", "force", "force"])
        with tempfile.TemporaryDirectory() as folder:
            for name, content in (("model", journal["header"]["native"]["document"]),
                                  ("script", self.server.get(f"/cores/{core}/script", "script"))):
                with open(f"{folder}/{name}", "w", encoding="utf-8") as file:
                    json.dump(content, file)
            derived = json.loads(subprocess.run([PROGRAM, "derive", f"{folder}/model", f"{folder}/script"],
                                                capture_output=True, check=True, timeout=60).stdout)
        self.assertEqual([s["micro"] for s in derived["steps"]], [s["micro"] for s in live])
        self.assertEqual(derived["outcome"], "done")

    def test_what_cannot_be_forced_is_refused(self):
        core = self.live(waiting("refusing"))
        self.assertEqual([self.force(core, *what, status=status)["errors"][0]["code"] for status, *what in [
            (404, "Root/Z", "var", "n", 1), (404, "Root", "var", "none", 1), (404, "Root/A", "port", "none"),
            (409, "Root/B", "port", "next"), (413, "Root", "var", "n", "x" * 1000001)]],
            ["not_found", "not_found", "not_found", "conflict", "too_large"])
        errors = self.server.post(f"/cores/{core}/force", {"path": "Root", "scope": "chi", "name": "n"}, status=422)["errors"]
        self.assertEqual([(e["path"], e["code"]) for e in errors], [("scope", "type")])
        self.server.post(f"/cores/{core}/stop", None, "core")
        self.force(core, "Root", "var", "n", 1, status=409)
        self.server.put(f"/cores/{core}/live", {"live": True}, status=409)

    def test_watchers_get_the_whole_state_and_the_native_model_after_an_edit(self):
        core = self.live(waiting("watched"))
        stream = self.server.stream()
        stream.subscribe(f"core/{core}/state")
        stream.until(lambda m: m["kind"] == "snapshot")
        revision = self.edit("watched", lambda d: d["root"]["children"].append({"state": "D"}))
        after = stream.until(lambda m: m["kind"] == "snapshot" and m["data"]["core"]["revision"] == revision)[-1]["data"]
        self.assertEqual(after["state"]["active"], ["Root", "Root/A"])
        native = self.server.get(f"/cores/{core}/native", "native")
        self.assertEqual([c["state"] for c in native["document"]["root"]["children"]], ["A", "B", "C", "D"])
        self.assertEqual(native["origin"]["Root/D"], "Root/D")
        self.force(core, "Root", "var", "n", 5)
        delta = stream.until(lambda m: m["kind"] == "delta" and "input" in m["data"])[-1]["data"]
        self.assertEqual((delta["input"]["kind"], delta["variables"]), ("force", {"Root": {"n": 5}}))
        stream.close()

    def test_breakpoints_follow_their_elements(self):
        core = self.live(waiting("breakpoints"))
        ids = {c["state"]: c["meta"]["id"] for c in self.stored("breakpoints")["document"]["root"]["children"]}
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": [{"when": "entered", "id": ids["B"]},
                                                                       {"when": "entered", "path": "Root/C"}]}, "core")

        def change(document):
            document["root"]["children"][1]["state"] = "Renamed"
            document["root"]["children"][0]["ports"][0]["to"] = "Renamed"
            document["root"]["children"][1]["ports"] = []
            document["root"]["children"].pop()
        revision = self.edit("breakpoints", change)
        self.assertEqual(self.at(core, revision)["breakpoints"], [{"when": "entered", "id": ids["B"]}])
        self.assertEqual(self.force(core, "Root/A", "port", "next")["paused"], True)
        self.assertEqual(self.active(core), ["Root", "Root/Renamed"])


class AfterACrash(ServerCase):
    def test_an_edited_run_is_rebuilt_with_its_model_and_follows_nothing(self):
        core = self.server.core(waiting("crash"))
        self.server.put(f"/cores/{core}/live", {"live": True}, "core")
        document = self.server.get("/documents/crash", "document_entry")["document"]
        document["root"]["children"].append({"state": "D"})
        document["root"]["children"][0]["ports"][0]["to"] = "D"
        revision = self.server.put("/documents/crash", document, "document_entry")["revision"]
        self.server.wait(core, lambda c: c["revision"] == revision)
        self.server.post(f"/cores/{core}/force", {"path": "Root", "scope": "var", "name": "n", "value": 9}, "core")
        self.kill()
        back = self.server.get(f"/cores/{core}", "core")
        self.assertEqual((back["status"], back["revision"], back["live"]), ("interrupted", revision, False))
        self.assertEqual(len(self.server.get(f"/cores/{core}/native", "native")["document"]["root"]["children"]), 4)
        self.server.post(f"/cores/{core}/resume", None, "core")
        self.server.post(f"/cores/{core}/force", {"path": "Root/A", "scope": "port", "name": "next"}, "core")
        state = self.server.get(f"/cores/{core}/state", "core_state")["state"]
        self.assertEqual((state["active"], state["variables"]["Root"]["n"]), (["Root", "Root/D"], 9))


if __name__ == "__main__":
    unittest.main()
