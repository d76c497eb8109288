"""Bundles: a document as one file with the interfaces of its services; installed elsewhere, it says which of them it lacks."""
import copy
import json
import subprocess
import tempfile
import unittest
from pathlib import Path

import models
from client import PROGRAM, Server
from component_process import LONG_HEARTBEAT, ComponentClient, wait_available
from test_own_services import DIMMER, SWITCH, hello

FLIPPING = {**models.calling("lamp", "flip", "flipping"), "services": {"lamp": "lamp"}}


def codes(answer):
    return sorted((error["path"], error["code"]) for error in answer["errors"])


class Bundles(unittest.TestCase):
    def setUp(self):
        self.server = Server(*LONG_HEARTBEAT)
        self.addCleanup(self.server.stop)

    def offer(self, rsm, kind="lamp"):
        """The process of a lamp."""
        client = ComponentClient(self.server)
        self.addCleanup(client.close)
        client.send_checked(hello(("lamp", kind, rsm)))
        client.next("welcome")
        wait_available(self.server, "lamp")
        return client

    def bundle(self, document=FLIPPING):
        self.server.put(f"/documents/{document['name']}", document, "document_entry")
        return self.server.get(f"/documents/{document['name']}/bundle", "bundle")

    def install(self, bundle, name, status=201):
        return self.server.post(f"/bundles?as={name}", bundle, "bundle_installed", status)

    def lacking(self, bundle, name):
        return [(each["path"], each["code"]) for each in self.install(bundle, name)["lacking"]]

    def test_has_the_document_and_the_interfaces_of_its_services(self):
        self.offer(SWITCH)
        bundle = self.bundle()
        self.assertEqual(bundle["document"], self.server.get("/documents/flipping")["document"])
        self.assertEqual(bundle["services"], {"lamp": {"type": "lamp", "rsm": SWITCH}})

    def test_names_services_that_are_nowhere_and_those_that_the_document_does_not_declare(self):
        document = models.document("waiting", {
            "state": "Root", "entry": "svc.oven.heat()\nsvc[par.which].start()", "parameters": [{"name": "which", "value": "oven"}],
            "ports": [{"name": "done", "when": "svc.door.closed"}, {"name": "late", "after": "1"}]})
        services = self.bundle({**document, "services": {"lamp": "lamp"}})["services"]
        self.assertEqual({key: services[key] for key in ("oven", "door", "lamp")}, {"oven": {}, "door": {}, "lamp": {"type": "lamp"}})
        self.assertEqual(services["timer"]["rsm"]["name"], "timer", "the time-out of a port needs it")
        self.assertEqual(len(services), 4, "`svc[...]` names none")

    def test_says_which_services_it_lacks(self):
        client = self.offer(SWITCH)
        bundle = self.bundle()
        self.assertEqual(self.lacking(bundle, "all_there"), [])
        client.close()
        wait_available(self.server, "lamp", False)
        self.assertEqual(self.lacking(bundle, "away"), [("lamp", "unavailable")])
        client = self.offer(DIMMER)
        self.assertEqual(self.lacking(bundle, "without_flip"), [("lamp", "missing")])
        client.close()
        wait_available(self.server, "lamp", False)
        slow = {**SWITCH, "operations": [{"name": "flip", "parameters": [{"name": "seconds"}], "error": "any"}]}
        client = self.offer(slow)
        self.assertEqual(self.lacking(bundle, "other_parameters"), [("lamp", "conflict")])
        self.assertEqual(self.lacking({**bundle, "services": {}}, "parameters_unknown"), [])
        told = {**bundle, "services": {"lamp": {"rsm": {**slow, "operations": [{"name": "flip", "error": "any", "parameters": [
            {"name": "seconds", "doc": "how long"}]}]}}}}
        self.assertEqual(self.lacking(told, "other_words"), [])
        client.close()
        wait_available(self.server, "lamp", False)
        self.offer(SWITCH, "oven")
        self.assertEqual(self.lacking(bundle, "other_type"), [("lamp", "type")])
        undeclared = copy.deepcopy(bundle)
        del undeclared["document"]["services"]
        self.assertEqual(self.lacking(undeclared, "other_type_than_the_bundle_says"), [("lamp", "type")])

    def test_is_installed_as_a_new_document_or_under_a_condition(self):
        bundle = self.bundle()
        self.assertEqual(self.install(bundle, "again"), {"name": "again", "revision": 1, "lacking": [
            {"path": "lamp", "code": "not_found", "message": "there is no service of this key here"}]})
        stored = self.server.get("/documents/again", "document_entry")
        self.assertEqual(stored["document"], bundle["document"])
        self.assertEqual(codes(self.server.post("/bundles?as=again", bundle, status=409)), [("again", "conflict")])
        changed = copy.deepcopy(bundle)
        changed["document"]["root"]["doc"] = "Flips the lamp"
        for match, status in (('"7"', 412), ('"1"', 200), ('"1"', 412)):
            self.assertEqual(self.server.request("POST", "/api/v1/bundles?as=again", changed, {"If-Match": match})[0], status, match)
        self.assertEqual(self.server.get("/documents/again")["revision"], 2)

    def test_what_is_wrong_is_refused_whole(self):
        bundle = self.bundle()
        lamp = {"type": "lamp", "rsm": SWITCH}
        wrong = (({**bundle, "bundle": 2}, [("bundle", "version")]), ({**bundle, "more": 1}, [("more", "unknown_field")]),
                 ({"bundle": 1}, [("document", "missing"), ("name", "missing")]), ([], [("", "type")]),
                 ({**bundle, "document": []}, [("document", "type")]), ({**bundle, "name": 5}, [("name", "type")]),
                 ({**bundle, "services": []}, [("services", "type")]), ({**bundle, "services": {"a b": {}}}, [("services/a b", "name")]),
                 ({**bundle, "services": {"lamp": {**lamp, "key": "x"}}}, [("services/lamp/key", "unknown_field")]),
                 ({**bundle, "services": {"lamp": {"rsm": {**SWITCH, "init": "Nowhere"}}}}, [("services/lamp/rsm", "reference")]),
                 ({**bundle, "services": {f"s{n}": {} for n in range(101)}}, [("services", "too_large")]),
                 ({**bundle, "document": {**FLIPPING, "root": {"state": "Root", "first": "Nowhere"}}}, [("Root", "first")]))
        for text, expected in wrong:
            status, answer = self.server.request("POST", "/api/v1/bundles?as=wrong", text)
            self.assertGreaterEqual(status, 400, expected)
            self.assertEqual(codes(answer), expected)
        self.assertEqual(codes(self.server.post("/bundles?as=a/b", bundle, status=422)), [("a/b", "name")])
        self.server.get("/documents/wrong", status=404)
        self.install({**bundle, "services": {f"s{n}": {} for n in range(100)}}, "many")

    def test_a_draft_is_no_bundle(self):
        draft = {**FLIPPING, "name": "draft", "root": {"state": "Root", "first": "A"}}
        self.server.put("/documents/draft?draft=true", draft, "document_entry")
        self.server.get("/documents/draft/bundle", status=422)
        self.server.get("/documents/nowhere/bundle", status=404)


class Commands(unittest.TestCase):
    def race(self, *words, status=0):
        out = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=60, check=False, cwd=self.folder)
        self.assertEqual(out.returncode, status, (words, out.stdout, out.stderr))
        return out.stdout, out.stderr

    def test_from_one_server_to_another_by_a_file(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = held.name
        with Server(*LONG_HEARTBEAT) as one, Server(*LONG_HEARTBEAT) as other:
            here, there = (("--server", f"http://127.0.0.1:{server.port}") for server in (one, other))
            one.put("/documents/flipping", FLIPPING, "document_entry")
            self.assertEqual(self.race("bundle", "flipping", *here)[0], "flipping.bundle.json\n")
            bundle = json.loads(Path(self.folder, "flipping.bundle.json").read_text())
            self.assertEqual(bundle, one.get("/documents/flipping/bundle"))
            said = self.race("install", "flipping.bundle.json", *there)[0]
            self.assertEqual(said, "flipping: revision 1\n  lacks lamp: not_found: there is no service of this key here\n")
            self.assertEqual(other.get("/documents/flipping")["document"], bundle["document"])
            self.assertIn("conflict", self.race("install", "flipping.bundle.json", *there, status=1)[1])
            self.race("install", "flipping.bundle.json", "--replace", *there)
            Path(self.folder, "kept").write_text("kept")
            self.assertIn("is there already", self.race("bundle", "flipping", "--out", "kept", *here, status=2)[1])
            self.assertEqual(Path(self.folder, "kept").read_text(), "kept")


if __name__ == "__main__":
    unittest.main()
