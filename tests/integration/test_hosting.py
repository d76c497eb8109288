"""Cores over REST and from the command line; and what a server starts when it begins, also after it was killed."""
import json
import shutil
import subprocess
import tempfile
import unittest

import models
from client import PROGRAM, Server


class Command:
    """`race core` or `race boot` on a server."""

    def __init__(self, server):
        self.url = f"http://127.0.0.1:{server.port}"

    def run(self, *words, url=None):
        """(exit code, lines of stdout, stderr)"""
        out = subprocess.run([PROGRAM, *words, "--server", url or self.url], capture_output=True, text=True, timeout=60, check=False)
        return out.returncode, out.stdout.splitlines(), out.stderr

    def lines(self, *words):
        """The words of each line that a command prints; it must be fine."""
        status, lines, errors = self.run(*words)
        assert (status, errors) == (0, ""), f"{words}: {status} {errors}"
        return [line.split() for line in lines]

    def json(self, *words):
        status, lines, errors = self.run(*words, "--json")
        assert (status, errors) == (0, ""), f"{words}: {status} {errors}"
        return json.loads("\n".join(lines))


class Hosting(unittest.TestCase):
    """One server for all; each test has documents of its own."""

    @classmethod
    def setUpClass(cls):
        cls.server = Server()
        cls.command = Command(cls.server)

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def store(self, *documents):
        for document in documents:
            self.server.put(f"/documents/{document['name']}", document, "document_entry")

    def test_a_core_is_started_with_other_arguments_than_it_was_created_with(self):
        core = self.server.core(models.ticking("begin"), {"last": 1000}, start=False)
        # A later revision is not what the core executes.
        later = models.ticking("begin")
        later["root"]["ports"][0]["name"] = "other"
        self.store(later)
        errors = self.server.post(f"/cores/{core}/start", {"arguments": {"colour": 1}}, status=422)["errors"]
        self.assertEqual([(e["path"], e["code"]) for e in errors], [("arguments/colour", "unknown_name")])
        unchanged = self.server.get(f"/cores/{core}", "core")
        self.assertEqual((unchanged["status"], unchanged["arguments"]), ("ready", {"last": 1000}))
        started = self.server.post(f"/cores/{core}/start", {"arguments": {"last": 2}}, "core")
        self.assertEqual((started["id"], started["arguments"]), (core, {"last": 2}))
        ended = self.server.ended(core)
        self.assertEqual((ended["status"], ended["outcome"], ended["results"]), ("ended", "done", {"n": 2}))
        self.server.post(f"/cores/{core}/start", {"arguments": {"last": 3}}, status=409)
        self.assertEqual(self.server.get(f"/cores/{core}", "core")["arguments"], {"last": 2})

    def test_a_start_without_arguments_keeps_those_of_the_creation(self):
        for body in (None, {}):
            core = self.server.core(models.ticking("keep"), {"last": 2}, start=False)
            self.server.post(f"/cores/{core}/start", body, "core")
            self.assertEqual(self.server.ended(core)["results"], {"n": 2})
        core = self.server.core(models.ticking("keep"), {"last": 2}, start=False)
        self.server.post(f"/cores/{core}/start", {"arguments": {}}, "core")
        self.assertEqual(self.server.ended(core)["results"], {"n": 5})

    def test_another_document_or_revision_is_loaded_into_a_core_that_has_not_begun(self):
        core = self.server.core(models.ticking("first"), {"last": 3}, start=False)
        self.store(models.storing("second"))
        loaded = self.server.post(f"/cores/{core}/load", {"document": "second", "arguments": {"value": 7}}, "core")
        self.assertEqual((loaded["id"], loaded["document"], loaded["status"], loaded["arguments"]),
                         (core, "second", "ready", {"value": 7}))
        self.assertEqual([c["document"] for c in self.server.get("/cores", "cores")["cores"] if c["id"] == core], ["second"])
        second = models.storing("second")
        second["root"]["ports"][0]["name"] = "stored"
        self.store(second)
        self.server.post(f"/cores/{core}/load", {"document": "second", "arguments": {"value": 8}}, "core")
        self.server.post(f"/cores/{core}/start", None, "core")
        ended = self.server.ended(core)
        self.assertEqual((ended["outcome"], ended["results"]), ("stored", {"read": 8}))
        self.server.post(f"/cores/{core}/load", {"document": "first"}, status=409)

    def test_what_cannot_be_loaded_leaves_the_core_as_it_is(self):
        core = self.server.core(models.ticking("stays"), {"last": 2}, start=False)
        for body, status, refused in (
                ({"document": "nothing"}, 404, [("nothing", "not_found")]), ({}, 422, [("document", "missing")]),
                ({"document": "stays", "arguments": []}, 422, [("arguments", "type")]),
                ({"document": "stays", "more": 1}, 422, [("more", "unknown_field")]),
                ({"document": "stays", "arguments": {"colour": 1}}, 422, [("arguments/colour", "unknown_name")]),
                ("{", 400, [("", "json")])):
            with self.subTest(body=body):
                errors = self.server.post(f"/cores/{core}/load", body, status=status)["errors"]
                self.assertEqual([(e["path"], e["code"]) for e in errors], refused)
        for body, status, refused in (([], 422, [("", "type")]), ({"arguments": 1}, 422, [("arguments", "type")]),
                                      ({"last": 1}, 422, [("last", "unknown_field")]), ("{", 400, [("", "json")])):
            with self.subTest(body=body):
                errors = self.server.post(f"/cores/{core}/start", body, status=status)["errors"]
                self.assertEqual([(e["path"], e["code"]) for e in errors], refused)
        self.server.post("/cores/999999/load", {"document": "stays"}, status=404)
        self.server.post("/cores/999999/start", {"arguments": {}}, status=404)
        same = self.server.get(f"/cores/{core}", "core")
        self.assertEqual((same["document"], same["status"], same["arguments"]), ("stays", "ready", {"last": 2}))

    def test_the_command_line_hosts_a_core_through_its_life(self):
        self.store(models.ticking("shell"), models.storing("shelf"))
        [[core, document, status, step]] = self.command.lines("core", "create", "shelf")
        self.assertEqual((document, status, step), ("shelf", "ready", "0"))
        self.command.lines("core", "load", core, "shell", "--arguments", '{"last": 1000000}')
        self.assertEqual(self.server.get(f"/cores/{core}", "core")["arguments"], {"last": 1000000})
        self.assertIn([core, "shell", "ready", "0"], self.command.lines("core", "list"))
        [[_, _, status, *_]] = self.command.lines("core", "start", core)
        self.assertEqual(status, "running")
        [[_, _, status, _, end]] = self.command.lines("core", "pause", core)
        self.assertEqual((status, end), ("running", "paused"))
        self.assertEqual(self.command.json("core", "show", core)["paused"], True)
        self.command.lines("core", "resume", core)
        self.assertEqual(self.command.json("core", "show", core)["paused"], False)
        self.assertEqual(self.command.lines("core", "stop", core)[0][2], "aborted")
        self.command.lines("core", "delete", core)
        self.server.get(f"/cores/{core}", status=404)
        self.assertNotIn(core, [line[0] for line in self.command.lines("core", "list")])

    def test_the_command_line_starts_with_arguments(self):
        self.store(models.ticking("three"))
        [[core, *_]] = self.command.lines("core", "create", "three", "--arguments", '{"last": 3}', "--start")
        self.server.ended(core)
        [[_, _, status, step, outcome]] = self.command.lines("core", "show", core)
        self.assertEqual((status, outcome), ("ended", "done"))
        self.assertGreater(int(step), 0)
        self.assertEqual(self.command.json("core", "show", core)["results"], {"n": 3})
        [[core, *_]] = self.command.lines("core", "create", "three")
        self.command.lines("core", "start", core, "--arguments", '{"last": 1}')
        self.assertEqual(self.server.ended(core)["results"], {"n": 1})
        [[core, *_]] = self.command.lines("core", "create", "three")
        self.command.lines("core", "load", core, "three", "--arguments", '{"last": 2}', "--start")
        self.assertEqual(self.server.ended(core)["results"], {"n": 2})

    def test_the_command_line_starts_nothing_with_arguments_that_do_not_fit(self):
        self.store(models.storing("fitting"))
        [[core, *_]] = self.command.lines("core", "create", "fitting", "--arguments", '{"value": 7}')
        for arguments, status, refused in (("[7]", 2, "--arguments: type: "), ("7", 2, "--arguments: type: "),
                                           ('{"value": }', 2, "--arguments: json: "),
                                           ('{"value": 8, "colour": 1}', 1, "arguments/colour: unknown_name: ")):
            with self.subTest(arguments=arguments):
                got, lines, errors = self.command.run("core", "start", core, "--arguments", arguments)
                self.assertEqual((got, lines), (status, []))
                self.assertTrue(errors.startswith(refused), errors)
                waiting = self.command.json("core", "show", core)
                self.assertEqual((waiting["status"], waiting["arguments"]), ("ready", {"value": 7}))
        self.command.lines("core", "start", core, "--arguments", '{"key": "fit", "value": [1, {"a": 2.5}]}')
        self.assertEqual(self.server.ended(core)["results"], {"read": [1, {"a": 2.5}]})

    def test_a_run_that_faulted_is_shown_with_its_fault_and_status_1(self):
        core = self.server.core(models.faulty("broken"))
        self.server.ended(core)
        status, [line], errors = self.command.run("core", "show", core)
        self.assertEqual((status, errors), (1, ""))
        self.assertEqual(line.split()[:3], [core, "broken", "faulted"])
        self.assertIn("Root: zero_division: ", line)
        self.assertEqual(self.command.run("core", "list")[0], 0)

    def test_what_the_server_refuses_is_printed_with_status_1(self):
        core = self.server.core(models.ticking("refusing"))
        for words, refused in ((("start", core), ": conflict: "), (("load", core, "refusing"), ": conflict: "),
                               (("show", "999999"), "999999: not_found: "), (("show", "a/../b"), ": not_found: "),
                               (("create", "nothing"), "nothing: not_found: "),
                               (("create", "refusing", "--arguments", '{"colour": 1}'), "arguments/colour: unknown_name: ")):
            with self.subTest(words=words):
                status, lines, errors = self.command.run("core", *words)
                self.assertEqual((status, lines), (1, []))
                self.assertIn(refused, errors)
        status, lines, errors = self.command.run("core", "show", "999999", "--json")
        self.assertEqual((status, json.loads("\n".join(lines))["errors"][0]["code"]), (1, "not_found"))
        self.assertIn("999999: not_found: ", errors)

    def test_bad_input_ends_with_status_2(self):
        for words, refused in ((("core",), "ACTION: missing: "), (("core", "dance"), "ACTION: syntax: "),
                               (("core", "show"), "ACTION: syntax: "), (("core", "load", "1"), "ACTION: syntax: "),
                               (("core", "list", "1"), "ACTION: syntax: "),
                               (("core", "pause", "1", "--arguments", "{}"), "--arguments: unknown_field: "),
                               (("core", "start", "1", "--start"), "--start: unknown_field: "),
                               (("core", "create", "a", "--arguments", "[]"), "--arguments: type: "),
                               (("core", "create", "a", "--arguments", "{"), "--arguments: json: "),
                               (("core", "list", "--slow"), "--slow: unknown_field: "),
                               (("boot",), "ACTION: missing: "), (("boot", "dance"), "ACTION: syntax: "),
                               (("boot", "set"), "ACTION: syntax: "), (("boot", "list", "a"), "ACTION: syntax: "),
                               (("boot", "set", "a", "--arguments", "1"), "--arguments: type: ")):
            with self.subTest(words=words):
                status, lines, errors = self.command.run(*words)
                self.assertEqual((status, lines), (2, []))
                self.assertTrue(errors.startswith(refused), errors)
        for group in ("core", "boot"):
            status, _, errors = self.command.run(group, "list", url="ftp://here")
            self.assertEqual((status, errors[:18]), (2, "--server: syntax: "))
            nowhere = "http://127.0.0.1:1"
            status, _, errors = self.command.run(group, "list", url=nowhere)
            self.assertEqual((status, errors.startswith(f"{nowhere}: unavailable: ")), (2, True))


class Boot(unittest.TestCase):
    """What a server starts when it begins; each test has a folder of its own."""

    def setUp(self):
        self.data = tempfile.mkdtemp(prefix="race-test-")

    def tearDown(self):
        shutil.rmtree(self.data)

    def log(self, server):
        with server.stream() as stream:
            stream.subscribe("log")
            [message] = stream.until(lambda m: m["channel"] == "log")
            return [entry["text"] for entry in message["data"]["entries"]]

    def cores(self, server):
        return {core["document"]: core for core in server.get("/cores", "cores")["cores"]}

    def prepare(self, entries, *documents):
        """Stores the documents and the list, with a server that ends then."""
        with Server(data=self.data) as server:
            for document in documents:
                server.put(f"/documents/{document['name']}?draft=true", document, "document_entry")
            self.assertEqual(server.put("/boot", {"entries": entries}, "boot")["entries"], entries)
            self.assertEqual(server.get("/cores", "cores")["cores"], [], "nothing is started before the server begins again")

    def test_documents_are_started_with_their_arguments_when_the_server_begins(self):
        entries = [{"document": "short", "arguments": {"last": 2}}, {"document": "long", "arguments": {"last": 1000000}}]
        self.prepare(entries, models.ticking("long"), models.ticking("short"))
        with Server(data=self.data) as server:
            self.assertEqual(server.get("/boot", "boot")["entries"], entries)
            cores = self.cores(server)
            self.assertEqual(set(cores), {"short", "long"})
            self.assertLess(int(cores["short"]["id"]), int(cores["long"]["id"]), "in the order of the list")
            self.assertEqual(server.ended(cores["short"]["id"])["results"], {"n": 2})
            self.assertEqual(cores["long"]["status"], "running")
            self.assertIn(f"boot: short is started as core {cores['short']['id']}", self.log(server))

    def test_what_cannot_be_started_is_logged_and_the_others_are_started(self):
        entries = [{"document": "argument", "arguments": {"colour": 1}}, {"document": "service", "arguments": {}},
                   {"document": "draft", "arguments": {}}, {"document": "fine", "arguments": {}}]
        draft = models.ticking("draft")
        draft["root"]["first"] = "Nobody"
        self.prepare(entries, draft, models.ticking("argument"), models.ticking("service") | {"services": {"timer": "clock"}},
                     models.ticking("fine"))
        with Server(data=self.data) as server:
            self.assertEqual(set(self.cores(server)), {"fine"})
            text = "\n".join(self.log(server))
            self.assertIn("boot: argument is not started: arguments/colour: unknown_name: ", text)
            self.assertIn("boot: service is not started: services/timer: type: ", text)
            self.assertIn("boot: draft is not started: Root: first: ", text)
            self.assertIn("boot: fine is started as core ", text)

    def test_a_run_that_was_killed_waits_for_a_person_and_is_not_started_anew(self):
        entries = [{"document": "endless", "arguments": {"last": 1000000}}]
        self.prepare(entries, models.ticking("endless"))
        server = Server(data=self.data)
        core = self.cores(server)["endless"]["id"]
        server.wait(core, lambda c: c["step"] > 10)
        server.kill()
        for _ in range(2):  # it waits over restarts, too
            with Server(data=self.data) as server:
                [waiting] = server.get("/cores", "cores")["cores"]
                self.assertEqual((waiting["id"], waiting["status"]), (core, "interrupted"))
                self.assertIn(f"boot: endless is not started: its run {core} is interrupted", self.log(server))
        with Server(data=self.data) as server:
            self.assertEqual(server.get(f"/cores/{core}", "core")["step"], waiting["step"])
            server.post(f"/cores/{core}/resume", None, "core")
            server.wait(core, lambda c: c["status"] == "running" and c["step"] > waiting["step"] + 10)
            server.post(f"/cores/{core}/stop", None, "core")
        with Server(data=self.data) as server:
            cores = [c for c in server.get("/cores", "cores")["cores"] if c["status"] == "running"]
            self.assertEqual([c["document"] for c in cores], ["endless"], "a run that is over is followed by another one")
            self.assertNotEqual(cores[0]["id"], core)

    def test_a_document_with_an_open_run_is_not_started_a_second_time(self):
        arguments = {"last": 1000000}
        self.prepare([{"document": name, "arguments": arguments} for name in ("waiting", "going", "other")],
                     *(models.ticking(name) for name in ("waiting", "going", "other")))
        with Server(data=self.data) as server:
            first = self.cores(server)
            for name in ("waiting", "other"):
                server.post(f"/cores/{first[name]['id']}/stop", None, "core")
            ready = server.core(models.ticking("waiting"), start=False)  # it never begins
            server.wait(first["going"]["id"], lambda c: c["step"] > 0)
        with Server(data=self.data) as server:
            cores = {(c["document"], c["id"], c["status"]) for c in server.get("/cores", "cores")["cores"]}
            started = self.cores(server)["other"]["id"]
            self.assertEqual(cores, {("waiting", ready, "ready"), ("going", first["going"]["id"], "interrupted"),
                                     ("other", started, "running")})
            self.assertNotEqual(started, first["other"]["id"])
            text = self.log(server)
            self.assertIn(f"boot: waiting is not started: its run {ready} is ready", text)
            self.assertIn(f"boot: going is not started: its run {first['going']['id']} is interrupted", text)

    def test_a_list_that_is_none_is_refused_and_changes_nothing(self):
        entry = {"document": "mine", "arguments": {}}
        self.prepare([entry], models.ticking("mine"))
        with Server(data=self.data) as server:
            for body, status, refused in (
                    ({}, 422, [("entries", "missing")]), ({"entries": 1}, 422, [("entries", "type")]),
                    ({"entries": [], "more": 1}, 422, [("more", "unknown_field")]),
                    ({"entries": [1, {"document": 2}, {}, {"document": "mine", "arguments": [], "when": 1}]}, 422,
                     [("entries/0", "type"), ("entries/1/document", "type"), ("entries/2/document", "missing"),
                      ("entries/3/arguments", "type"), ("entries/3/when", "unknown_field")]),
                    ({"entries": [entry, entry]}, 422, [("entries/1/document", "duplicate")]),
                    ({"entries": [{"document": "a"}, entry, {"document": "b"}]}, 404,
                     [("entries/0/document", "not_found"), ("entries/2/document", "not_found")]),
                    ({"entries": [{"document": f"d{i}"} for i in range(65)]}, 413, [("entries", "too_large")]),
                    ("{", 400, [("", "json")])):
                with self.subTest(body=str(body)[:100]):
                    errors = server.put("/boot", body, status=status)["errors"]
                    self.assertEqual([(e["path"], e["code"]) for e in errors], refused)
            self.assertEqual(server.get("/boot", "boot")["entries"], [entry])

    def test_the_command_line_changes_the_list(self):
        with Server(data=self.data) as server:
            boot = Command(server)
            for name in ("a", "b"):
                server.put(f"/documents/{name}", models.ticking(name), "document_entry")
            self.assertEqual(boot.lines("boot", "list"), [])
            self.assertEqual(boot.lines("boot", "set", "a"), [["a", "{}"]])
            boot.lines("boot", "set", "b", "--arguments", '{"last":1}')
            self.assertEqual(boot.lines("boot", "set", "a", "--arguments", '{"last":2}'), [["a", '{"last":2}'], ["b", '{"last":1}']])
            entries = [{"document": "a", "arguments": {"last": 2}}, {"document": "b", "arguments": {"last": 1}}]
            self.assertEqual(boot.json("boot", "list"), {"entries": entries})
            self.assertEqual(server.get("/boot", "boot")["entries"], entries)
            self.assertEqual(boot.lines("boot", "remove", "a"), [["b", '{"last":1}']])
            status, lines, errors = boot.run("boot", "remove", "a")
            self.assertEqual((status, lines, errors.startswith("a: not_found: ")), (1, [], True))
            status, lines, errors = boot.run("boot", "set", "nothing")
            self.assertEqual((status, lines, errors.startswith("entries/1/document: not_found: ")), (1, [], True))
            self.assertEqual(server.get("/boot", "boot")["entries"], entries[1:])


if __name__ == "__main__":
    unittest.main()
