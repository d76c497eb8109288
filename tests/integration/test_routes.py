"""Every route of api/openapi.yaml is reachable and its answers are valid against their schemas."""
import json
import time
import unittest

import models
from client import PROJECT, Server, check
from interface import check_listed


class Routes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server("--demo", str(PROJECT / "deploy/demo"))

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def test_server_health_rules_services_and_cell(self):
        health = self.server.get("/health", "health")
        self.assertTrue(health["cell"])
        self.assertLess(abs(health["started"] / 1000 - time.time()), 600)
        names = [rule["rule"] for rule in self.server.get("/rules", "rules")["rules"]]
        self.assertIn("PTrans1", names)
        services = self.server.get("/services", "services")["services"]
        self.assertEqual({s["key"]: s["type"] for s in services},
                         {"robot": "robot", "gripper": "gripper", "db": "database", "timer": "timer", "display": "display",
                          "audio": "audio", "camera": "KinectDriver",
                          "obj_rec": "ObjectRecognition"})
        scene = self.server.get("/cell", "scene")
        urdf = self.server.get("/cell/" + scene["robots"][0]["urdf"])
        self.assertIn("<robot", urdf)
        self.server.get("/cell/other.urdf", status=404)
        self.server.get("/cell/..%2Fscene.json", status=404)

    def test_a_document_is_stored_translated_and_given_back(self):
        document = models.ticking()
        stored = self.server.put("/documents/mine", document, "document_entry")
        again = self.server.put("/documents/mine", document, "document_entry")
        self.assertEqual(stored["revision"], again["revision"])
        document["root"]["doc"] = "changed"
        changed = self.server.put("/documents/mine", document, "document_entry")
        self.assertEqual(changed["revision"], stored["revision"] + 1)
        given_back = self.server.get("/documents/mine", "document_entry")["document"]
        self.assertEqual(models.without_ids(given_back), document)
        given_back["root"]["children"][0]["state"] = "Pang"
        given_back["root"]["children"][1]["ports"][0]["to"] = given_back["root"]["first"] = "Pang"
        renamed = self.server.put("/documents/mine", given_back, "document_entry")
        self.assertEqual(renamed["document"], given_back)
        self.assertTrue(renamed["document"]["root"]["children"][0]["meta"]["id"])
        names = [entry["name"] for entry in self.server.get("/documents", "documents")["documents"]]
        self.assertIn("mine", names)
        self.assertIn("pick", names)
        native = self.server.get("/documents/pick/native", "native")
        self.assertEqual(native["origin"]["Pick/Grasp"], "Pick/Grasp")

    def test_a_wrong_document_is_refused_whole_with_every_violation(self):
        wrong = models.document("wrong", {"state": "Root", "children": [{"state": "A"}, {"state": "A"}], "first": "B",
                                          "entry": "res.x = "})
        errors = self.server.put("/documents/wrong", wrong, status=422)["errors"]
        self.assertLessEqual({"duplicate", "first"}, {error["code"] for error in errors})
        self.assertEqual([(error["path"], error["line"]) for error in errors if error["code"] == "syntax"], [("Root", 1)])
        self.server.get("/documents/wrong", status=404)
        self.server.put("/documents/no%20name", models.ticking(), status=422)

    def test_a_core_through_its_life(self):
        core = self.server.core(models.ticking("life", last=3), {"last": 2}, start=False)
        path = f"/cores/{core}"
        self.assertEqual(self.server.get(path, "core")["status"], "ready")
        self.server.post(path + "/stop", status=409)
        self.server.post(path + "/start", None, "core")
        self.server.post(path + "/start", status=409)
        ended = self.server.ended(core)
        self.assertEqual((ended["status"], ended["outcome"], ended["results"]), ("ended", "done", {"n": 2}))
        self.server.get(path + "/state", "core_state")
        self.server.get(path + "/native", "native")
        self.server.get(path + "/journal", "journal")
        self.server.get(path + "/script", "script")
        steps = ended["step"]
        derivations = self.server.get(f"{path}/derivations?from=1&to={steps}", "derivations")
        self.assertEqual([s["step"] for s in derivations["steps"]], list(range(1, steps + 1)))
        self.server.get(f"{path}/derivations?from={steps + 1}", status=400)
        self.server.get(f"{path}/derivations?from=x", status=400)
        self.server.get(f"{path}/why?port=Root.done", "why")
        self.server.get(f"{path}/why?port=Root.nothing", status=404)
        self.server.get(f"{path}/why", status=422)
        for command in ("pause", "resume", "stop", "start"):
            self.server.post(f"{path}/{command}", status=409)
        self.server.expect("DELETE", path, None, "core", 200)
        for route in ("", "/state", "/native", "/journal", "/script", "/derivations", "/why?port=Root.done"):
            self.server.get(path + route, status=404)
        self.assertNotIn(core, [c["id"] for c in self.server.get("/cores", "cores")["cores"]])

    def test_invalid_bodies_are_refused_by_field(self):
        self.server.post("/cores", {"document": "nothing"}, status=404)
        for body, refused in (
                ({}, [("document", "missing")]), ([], [("", "type")]), ({"document": 1}, [("document", "type")]),
                ({"document": "pick", "speed": 1, "when": 2}, [("speed", "unknown_field"), ("when", "unknown_field")]),
                ({"document": "pick", "arguments": []}, [("arguments", "type")]),
                ({"document": "pick", "arguments": {"colour": 1, "size": 2}},
                 [("arguments/colour", "unknown_name"), ("arguments/size", "unknown_name")])):
            with self.subTest(body=body):
                errors = self.server.post("/cores", body, status=422)["errors"]
                self.assertEqual([(error["path"], error["code"]) for error in errors], refused)
        self.server.post("/cores", "{", status=400)
        self.server.put("/documents/other", models.ticking() | {"services": {"timer": "clock"}}, "document_entry")
        errors = self.server.post("/cores", {"document": "other"}, status=422)["errors"]
        self.assertEqual(errors[0]["path"], "services/timer")
        self.server.get("/cores/0", status=404)
        self.server.get("/cores/x", status=404)
        core = self.server.core(models.ticking("held"), start=False)
        self.server.post(f"/cores/{core}/step", {"kind": "micro"}, status=409)
        for body, paths in (({"kind": "back"}, ["kind"]), ({"kind": "until", "path": "Root/Pong"}, ["when"]),
                            ({"kind": "until", "path": "Root/Pong", "when": ""}, ["when"]),
                            ({"kind": "until", "when": "soon"}, ["path", "when"]),
                            ({"kind": "until", "when": "left"}, ["path"]),
                            ({"kind": "until", "path": "Root/Pong", "id": "a", "when": "left"}, ["path"]),
                            ({"kind": "micro", "path": "Root/Pong"}, ["path"])):
            with self.subTest(body=body):
                errors = self.server.post(f"/cores/{core}/step", body, status=422)["errors"]
                self.assertEqual([error["path"] for error in errors], paths)
        self.server.post(f"/cores/{core}/step", "{", status=400)
        one = {"when": "entered", "path": "Root/Pong"}
        for body, paths in (({}, ["breakpoints"]), ({"breakpoints": 1}, ["breakpoints"]), ({"breakpoints": [], "more": 1}, ["more"]),
                            ({"breakpoints": [one, {"when": "now"}, 1]},
                             ["breakpoints/1/path", "breakpoints/1/when", "breakpoints/2"]),
                            ({"breakpoints": [one | {"id": ""}]}, ["breakpoints/0/path"]),
                            ({"breakpoints": [one | {"when": ""}]}, ["breakpoints/0/when"]),
                            ({"breakpoints": [one | {"before": 1}]}, ["breakpoints/0/before"]),
                            ({"breakpoints": [one | {"service": "timer"}]}, ["breakpoints/0/service"]),
                            ({"breakpoints": [one | {"when": "fulfilled"}]}, ["breakpoints/0/condition"])):
            with self.subTest(body=str(body)[:100]):
                errors = self.server.put(f"/cores/{core}/breakpoints", body, status=422)["errors"]
                self.assertEqual([error["path"] for error in errors], paths)
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": 101 * [one]}, status=413)
        self.assertEqual(len(self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": 100 * [one]}, "core")["breakpoints"]), 100)
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": [{"when": "fired", "path": "Root/Pong"}]}, status=404)
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": [{"when": "entered", "id": "nobody"}]}, status=404)
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": [{"when": "called", "service": "nobody"}]}, status=404)
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": [one | {"condition": "1 +"}]}, status=422)
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": [one | {"condition": "True" + 497 * " "}]}, status=413)
        longest = [one | {"condition": "True" + 496 * " "}]
        self.assertEqual(self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": longest}, "core")["breakpoints"], longest)
        native = self.server.get(f"/cores/{core}/native", "native")["document"]["root"]
        by_id = [{"when": "entered", "id": native["children"][0]["meta"]["id"]},
                 {"when": "fired", "id": native["children"][0]["ports"][0]["meta"]["id"]}]
        self.assertEqual(self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": by_id}, "core")["breakpoints"], by_id)

    def test_unlisted_routes_are_not_found(self):
        self.server.get("/nothing", status=404)
        self.server.get("/cores/1/2/3", status=404)
        self.server.expect("PATCH", "/cores", {}, None, 405)
        status, _ = self.server.request("GET", "/")
        self.assertEqual(status, 404)

    def test_check_listed_rejects_unlisted_answers(self):
        refused = {"errors": [{"path": "", "code": "conflict", "message": ""}]}
        for method, target, status in (("GET", "/api/v1/health", 204), ("GET", "/api/v1/cores/1/past?step=1", 409),
                                       ("POST", "/api/v1/cores", 200), ("GET", "/api/v1/health", 400),
                                       ("GET", "/api/v1/rules", 404), ("PATCH", "/api/v1/cores", 409)):
            with self.subTest(target=target, status=status), self.assertRaises(AssertionError):
                check_listed(method, target, status, refused)

    def test_every_example_is_valid(self):
        examples = list((PROJECT / "api/examples").glob("*.json"))
        self.assertGreater(len(examples), 10)
        for example in examples:
            check(example.name.split(".")[0], json.loads(example.read_text()))


if __name__ == "__main__":
    unittest.main()
