"""What api/openapi.yaml promises of every route: problem details, Location, entity tags, pages, refused parameters and bodies."""
import http.client
import json
import unittest

import models
from client import TIMEOUT, Server, check
from interface import check_listed


class Contract(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def ask(self, method, path, body=None, **headers):
        """(status, headers, parsed JSON; None: no content)."""
        connection = http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=TIMEOUT)
        if body is not None:
            headers["Content-Type"] = "application/json"
        fields = {name.replace("_", "-"): value for name, value in headers.items()}
        connection.request(method, "/api/v1" + path, body=None if body is None else json.dumps(body), headers=fields)
        response = connection.getresponse()
        text = response.read()
        connection.close()
        answer = json.loads(text) if text else None
        check_listed(method, "/api/v1" + path, response.status, answer)
        return response.status, dict(response.getheaders()), answer

    def test_a_refusal_has_problem_details(self):
        for method, path, body, status, title, code in (
                ("GET", "/documents/none", None, 404, "Not Found", "not_found"),
                ("PUT", "/documents/x", [], 422, "Unprocessable Entity", "type"),
                ("PATCH", "/health", None, 405, "Method Not Allowed", "method"),
                ("GET", "/stream", None, 426, "Upgrade Required", "upgrade")):
            with self.subTest(path=path):
                got, headers, problem = self.ask(method, path, body)
                self.assertEqual((got, headers["Content-Type"]), (status, "application/problem+json"))
                check("problem", problem)
                self.assertEqual((problem["status"], problem["title"]), (status, title))
                self.assertEqual(problem["detail"], problem["errors"][0]["message"])
                self.assertEqual(problem["errors"][0]["code"], code)
        self.assertEqual(self.ask("GET", "/stream")[1]["Upgrade"], "websocket")

    def test_a_parameter_that_a_route_does_not_have_is_refused(self):
        for path in ("/health?verbose=1", "/documents?Limit=1&x=", "/cores/1/state?limit=1", "/runs?=&befor=2"):
            with self.subTest(path):
                status, _, problem = self.ask("GET", path)
                self.assertEqual((status, problem["errors"][0]["code"]), (400, "unknown_field"))
        self.assertEqual(self.ask("GET", "/documents?Limit=1&x=")[2]["errors"][1]["path"], "x")

    def test_a_body_that_a_route_does_not_have_is_refused(self):
        core = self.server.core(models.ticking("body"), start=False)
        for path in (f"/cores/{core}/pause", f"/cores/{core}/resume", f"/cores/{core}/stop", "/backups", "/backups/x/restore"):
            with self.subTest(path):
                self.assertEqual(self.ask("POST", path, {"force": True})[2]["errors"][0]["path"], "force")
                self.assertEqual(self.ask("POST", path, [])[0], 422)
        self.assertEqual(self.ask("DELETE", f"/cores/{core}", {"now": 1})[0], 422)
        self.assertEqual(self.ask("POST", f"/cores/{core}/pause", {})[0], 200)
        self.assertEqual(self.ask("DELETE", f"/cores/{core}")[0], 200)

    def test_what_is_created_has_a_location(self):
        status, headers, _ = self.ask("PUT", "/documents/located", models.ticking("located"))
        self.assertEqual((status, headers["Location"], headers["ETag"]), (201, "/api/v1/documents/located", '"1"'))
        made = [("/documents/located/branch", {"as": "branched"}), ("/cores", {"document": "located"}), ("/backups", None)]
        for path, body in made:
            with self.subTest(path):
                status, headers, answer = self.ask("POST", path, body)
                self.assertEqual(status, 201)
                self.assertEqual(self.ask("GET", headers["Location"].removeprefix("/api/v1"))[2], answer)
        run = self.server.core(models.ticking("runs", last=1), {"last": 1})
        self.server.ended(run)
        status, headers, _ = self.ask("POST", "/runs", self.server.get(f"/runs/{run}/export"))
        self.assertEqual(status, 201)
        self.assertTrue(self.server.get(headers["Location"].removeprefix("/api/v1"), "run")["imported"])

    def test_what_creates_does_so_once_for_a_key(self):
        self.server.put("/documents/once", models.ticking("once"), "document_entry")
        body = {"document": "once"}
        status, headers, core = self.ask("POST", "/cores", body, Idempotency_Key="k1")
        self.assertEqual(status, 201)
        again, replayed, same = self.ask("POST", "/cores", body, Idempotency_Key='"k1"')
        self.assertEqual((again, same, replayed["Location"], replayed["Idempotency-Replayed"]), (201, core, headers["Location"], "true"))
        self.assertNotIn("Idempotency-Replayed", headers)
        self.assertNotEqual(self.ask("POST", "/cores", body, Idempotency_Key="k2")[2]["id"], core["id"])
        self.assertEqual(self.ask("POST", "/cores", {"document": "once", "arguments": {}}, Idempotency_Key="k1")[0], 422)
        self.assertEqual(self.ask("POST", "/cores", body, Idempotency_Key="no key")[0], 400)
        self.assertEqual(self.ask("POST", "/cores", {"document": "nobody"}, Idempotency_Key="k3")[0], 404)
        self.assertEqual(self.ask("POST", "/cores", body, Idempotency_Key="k3")[0], 201)
        for path, create in (("/documents/once/branch", {"as": "branch_once"}), ("/backups", None)):
            with self.subTest(path):
                first, second = (self.ask("POST", path, create, Idempotency_Key="of" + path.replace("/", "_")) for _ in range(2))
                self.assertEqual((first[0], first[2]), (second[0], second[2]))

    def test_a_document_has_a_tag(self):
        name, task = "/documents/tagged", models.ticking("tagged")
        self.assertEqual(self.ask("PUT", name, task, If_Match='"1"')[0], 412)
        self.assertEqual(self.ask("PUT", name, task, If_None_Match="*")[0], 201)
        self.assertEqual(self.ask("PUT", name, task, If_None_Match="*")[0], 412)
        task["root"]["doc"] = "other"
        self.assertEqual(self.ask("PUT", name, task, If_Match='"7"')[0], 412)
        self.assertEqual(self.ask("PUT", name + "?revision=7", task)[0], 409)
        self.assertEqual(self.ask("PUT", name + "?revision=1", task, If_Match='"2"')[0], 400)
        self.assertEqual(self.ask("PUT", name, task, If_None_Match='"1"')[0], 400)
        status, headers, _ = self.ask("PUT", name, task, If_Match='"1"')
        self.assertEqual((status, headers["ETag"]), (200, '"2"'))
        self.assertEqual(self.ask("GET", name)[1]["ETag"], '"2"')
        status, headers, body = self.ask("GET", name, If_None_Match='"1", "2"')
        self.assertEqual((status, headers["ETag"], body), (304, '"2"', None))
        self.assertNotIn("Content-Type", headers)
        self.assertEqual(self.ask("GET", name, If_None_Match='"1"')[0], 200)
        self.assertEqual(self.ask("GET", name + "/revisions/1")[1]["ETag"], '"1"')
        self.assertEqual(self.ask("GET", name + "/revisions/1", If_None_Match='"1"')[0], 304)
        self.assertEqual(self.ask("POST", name + "/restore", {"revision": 1}, If_Match='"1"')[0], 412)
        status, headers, _ = self.ask("POST", name + "/restore", {"revision": 1}, If_Match='"2"')
        self.assertEqual((status, headers["ETag"]), (200, '"3"'))
        root = self.ask("GET", name)[2]["document"]["root"]["meta"]["id"]
        edit = {"operations": [{"op": "set", "id": root, "field": "doc", "value": "x"}]}
        status, headers, _ = self.ask("POST", name + "/edits", edit, If_Match='"3"')
        self.assertEqual((status, headers["ETag"]), (200, '"4"'))
        self.assertEqual(self.ask("DELETE", name, If_Match='"3"')[0], 412)
        self.assertEqual(self.ask("DELETE", name, If_Match='"4"')[0], 200)
        self.assertEqual(self.ask("PUT", name, task)[1]["ETag"], '"5"')

    def test_a_document_that_is_used_is_not_removed(self):
        core = self.server.core(models.ticking("used", last=3), {"last": 3}, start=False)
        self.assertEqual(self.ask("DELETE", "/documents/used")[0], 409)
        self.server.post(f"/cores/{core}/start", None, "core")
        self.server.ended(core)
        self.server.put("/boot", {"entries": [{"document": "used"}]}, "boot")
        self.assertEqual(self.ask("DELETE", "/documents/used")[2]["errors"][0]["code"], "conflict")
        self.server.put("/boot", {"entries": []}, "boot")
        self.assertEqual(self.server.expect("DELETE", "/documents/used", None, "document_removed", 200), {"removed": "used"})
        self.server.get("/documents/used", status=404)
        self.server.expect("DELETE", "/documents/used", None, None, 404)
        self.assertEqual(self.server.get(f"/runs/{core}", "run")["document"], "used")
        self.server.get(f"/runs/{core}/derivations", "derivations")

    def test_lists_have_pages(self):
        for i in range(5):
            self.server.put(f"/documents/page{i}", models.ticking(f"page{i}"), "document_entry")
        names, after = [], ""
        while after is not None:
            page = self.server.get(f"/documents?limit=2&after={after}", "documents")
            self.assertLessEqual(len(page["documents"]), 2)
            names += [entry["name"] for entry in page["documents"]]
            after = page.get("next")
        self.assertEqual(names, [entry["name"] for entry in self.server.get("/documents", "documents")["documents"]])
        self.assertEqual(names, sorted(set(names)))
        for limit in ("0", "1001", "x", ""):
            self.server.get(f"/documents?limit={limit}", status=400)
        task = models.ticking("page0")
        for i in range(3):
            task["root"]["doc"] = str(i)
            self.server.put("/documents/page0", task, "document_entry")
        first = self.server.get("/documents/page0/revisions?limit=3", "revisions")
        self.assertEqual(([each["revision"] for each in first["revisions"]], first["next"]), ([4, 3, 2], 2))
        last = self.server.get(f"/documents/page0/revisions?limit=3&before={first['next']}", "revisions")
        self.assertEqual([each["revision"] for each in last["revisions"]], [1])
        self.assertNotIn("next", last)


if __name__ == "__main__":
    unittest.main()
