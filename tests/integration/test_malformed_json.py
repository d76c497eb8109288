"""Malformed and hostile JSON: on every route that takes a body, and as every kind of message of the two WebSockets.

A route, a kind of message of the stream and the first message of a process get at least 300 texts, made of a valid one
(malformed_json.py), the other kinds of a process 80 of theirs: some are no JSON (truncated, commas, NaN, comments, bad UTF-8, lone
surrogates, a key twice), some are beyond its limits (levels, numbers, bytes), some are one field away from what its schema takes
(RACE_SEED chooses). A route answers each 4xx with a problem document, the stream an error; the connection of a process ends with
`refused`. Documents, cores, runs, accounts, boot list and the rest are the same before and after, and the server is well.
"""
import json
import os
import random
import re
import time
import unittest

import models
from accounts import AccountServer
from body_examples import body_schemas, examples, fitting, with_value
from client import PROJECT, TIMEOUT, Server, Stream, check
from component_process import LONG_HEARTBEAT, ComponentClient, service, token_file
from controls import Controls
from interface import check_listed
from keep_alive import KeepAlive
from malformed_json import Mutations, no_json
from websockets.frames import OP_CLOSE

SEED = int(os.environ.get("RACE_SEED", random.randrange(10**6)))
TEXTS, MUTATIONS = 300, 120  # of a route or kind: at least, and how many of them its schema alone refuses
STREAM_BYTES, CONTROL_BYTES, RUN_LEVELS, PROCESS_LEVELS, BODY_BYTES = 65536, 16384, 642, 72, 4 << 20
NOT_JSON = {"json", "too_deep", "constant", "out_of_range", "too_large"}  # codes of a text that no schema has seen
TOO_LARGE = 90  # of the texts for the stream, at most, that are too large or no UTF-8: they end the connection
OF_KIND = 40  # of the texts of a kind of message of a process, of both sorts: each needs a process of its own
PROMPT = 5  # [s] in which a process is refused
LATER = ("edit", "presence")  # are answered when they are done
STATE = ("/documents", "/documents/target", "/documents/target/revisions", "/documents/target/breakpoints?author=admin", "/cores", "/runs",
         "/boot", "/accounts", "/accounts/observer/tokens", "/accounts/admin/tokens", "/backups", "/cell/person", "/me")


def texts_of(schema, values, depth=64):
    """Malformed texts, and then those that only the schema refuses."""
    return no_json(values[0], depth), [json.dumps(value).encode() for value in Mutations(schema, SEED).sample(values, MUTATIONS)]


def codes_of(schema, text):
    """Those of a refusal of a malformed text. Documents and runs are read on with an integer out of range, whose path is named."""
    return NOT_JSON | {"unknown_field"} if schema in ("document", "run_file") and re.search(rb'"x": -?\d{19,}}$', text) else NOT_JSON


class Bodies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = AccountServer("--demo", str(PROJECT / "deploy/demo"))
        cls.addClassCleanup(cls.server.stop)
        cls.server.put("/documents/target", models.ticking("target"), "document_entry")
        core = cls.server.core(models.ticking(), start=False)
        cls.names = {"{id}": core, "{service}": "db", "/documents/{name}": "/documents/target", "/accounts/{name}": "/accounts/observer"}
        cls.client = KeepAlive(cls.server.port, cls.server.token)
        cls.addClassCleanup(cls.client.close)
        cls.asked = 0

    def path(self, pattern):
        for parameter, name in self.names.items():
            pattern = pattern.replace(parameter, name)
        return pattern

    def state(self):
        return {path: self.server.request("GET", "/api/v1" + path) for path in STATE}

    def refusal(self, method, pattern, body):
        """(status, codes) of the answer, which must be a listed problem."""
        answer = self.client.ask(method, self.path(pattern).encode(), body)
        self.__class__.asked += 1
        self.assertTrue(400 <= answer.status < 500, f"{answer.status} {answer.body[:300]}")
        self.assertEqual(answer.header("content-type"), "application/problem+json")
        problem = check("problem", answer.json())
        check_listed(method, pattern, answer.status, problem)
        return answer.status, {error["code"] for error in problem["errors"]}

    def test_every_route_refuses_every_text_and_changes_nothing(self):
        before, begun = self.state(), time.monotonic()
        for (method, pattern), schema in body_schemas().items():
            malformed, others = texts_of(schema, list(fitting(schema)), RUN_LEVELS if schema == "run_file" else 64)
            self.assertGreaterEqual(len(malformed) + len(others), TEXTS, schema)
            for body in malformed:
                with self.subTest(route=f"{method} {pattern}", malformed=body[:200], seed=SEED):
                    _, codes = self.refusal(method, pattern, body)
                    self.assertLessEqual(codes, codes_of(schema, body))
            for body in others:
                with self.subTest(route=f"{method} {pattern}", schema=schema, body=body[:500], seed=SEED):
                    self.refusal(method, pattern, body)
        print(f"seed {SEED}: {self.asked} bodies in {time.monotonic() - begun:.1f} s", flush=True)
        self.assertEqual(self.state(), before)
        self.server.get("/health", "health")

    def test_a_string_of_megabytes_is_refused_or_as_good_as_a_short_one(self):
        before = self.state()
        for (method, pattern), schema in body_schemas().items():
            text = json.dumps(next(fitting(schema))).encode()
            for size in (BODY_BYTES // 2, BODY_BYTES + 1):
                with self.subTest(route=f"{method} {pattern}", size=size):
                    body = text[:-1] + (b"" if text == b"{}" else b", ") + b'"x": "' + b"x" * size + b'"}'
                    self.refusal(method, pattern, body)
        self.assertEqual(self.state(), before)

    def test_a_route_without_a_body_takes_none(self):
        before = self.state()
        pause = f"/cores/{self.names['{id}']}/pause"
        for method, path in (("POST", "/tickets"), ("POST", "/backups"), ("POST", pause), ("DELETE", "/documents/target"),
                             ("POST", "/logout"), ("DELETE", "/accounts/observer"), ("GET", "/documents"), ("GET", "/boot")):
            for body in (b"{", b"[]", b"null", b'{"x": 1}', b"{}{}", b"\xff", b"[" * 100_000, b'{"a": 1, "a": 1}'):
                with self.subTest(method=method, path=path, body=body[:20]):
                    self.refusal(method, "/api/v1" + path, body)
        self.assertEqual(self.state(), before)

    def test_the_file_of_a_run_that_was_changed_is_refused_as_what_a_client_has_sent(self):
        """Its schema takes it: what is wrong is known only when the run is done again."""
        good = examples("run_file")[0]
        self.refuse_changes(good, {
            ("run", "chain"): "0" * 64, ("run", "steps"): 3, ("run", "results"): {"n": 2}, ("run", "arguments"): {"last": 2},
            ("run", "status"): "aborted", ("journal", "entries", 1, "input", "data"): {"time": 0.2}})

    def test_what_a_run_keeps_beside_its_journal_is_held_against_its_schema_too(self):
        good = examples("run_file")[0]
        self.refuse_changes(good, {("samples", 0, "pose", "joints", "a1"): None, ("samples", 0, "pose", "bodies", "x"): 1,
                                   ("samples", 0, "pose", "hands"): 1, ("services", "timer"): {}, ("run", "results"): True})

    def refuse_changes(self, good, changes):
        """Path -> what stands there instead: each by itself is refused."""
        before = self.state()
        for path, value in changes.items():
            with self.subTest(path=path, value=value):
                self.refusal("POST", "/api/v1/runs", json.dumps(with_value(good, path, value)).encode())
        self.assertEqual(self.state(), before)

    def test_every_code_of_a_refusal_is_listed_with_its_status(self):
        """An author whom the sender may not be, beside what is wrong with the rest."""
        for route, schema in (("restore", "document_restore"), ("branch", "document_branch"), ("edits", "edit_request")):
            with self.subTest(route):
                body = {**examples(schema)[0], "author": "Ada", "no_such_field": 1}
                self.refusal("POST", "/api/v1/documents/{name}/" + route, json.dumps(body).encode())


class Messages:
    @classmethod
    def setUpClass(cls):
        cls.server = Server("--remote", "database", *LONG_HEARTBEAT)
        cls.addClassCleanup(cls.server.stop)
        for name in ("pick", "target"):  # of the examples, and another one
            cls.server.put(f"/documents/{name}", models.ticking(name), "document_entry")
        cls.server.core(models.ticking("target"), start=False)
        cls.token = token_file(cls.server).read_text().strip()
        database = {"key": "db", "type": "database", "rsm": service(cls.server, "db")["rsm"]}
        cls.hello = {"type": "hello", "protocol": 1, "components": [database]}

    def state(self):
        paths = ("/documents", "/documents/pick", "/documents/pick/revisions", "/cores", "/runs", "/boot")
        return {path: self.server.request("GET", "/api/v1" + path) for path in paths}

    def kinds(self, schema):
        """Kind of message -> its examples."""
        found = {}
        for message in examples(schema):
            found.setdefault(message["type"], []).append(message)
        return found


class StreamMessages(Messages, unittest.TestCase):
    def test_every_kind_is_answered_with_an_error_and_changes_nothing(self):
        before, begun, sent = self.state(), time.monotonic(), 0
        for kind, values in self.kinds("stream_request").items():
            malformed, others = texts_of("stream_request", values)
            texts = [text for text in malformed + others if len(text) <= STREAM_BYTES and is_utf8(text)]
            self.assertGreaterEqual(len(texts), TEXTS - TOO_LARGE, kind)
            stream = Stream(self.server.port)
            for text in texts:
                with self.subTest(kind=kind, text=text[:300], seed=SEED):
                    sent += 1
                    try:
                        codes = self.refuse(stream, kind, text, f"none/{sent}")
                        self.assertTrue(text in others or codes <= NOT_JSON, codes)
                    except (AssertionError, OSError):
                        stream.close()
                        stream = Stream(self.server.port)
                        raise
            stream.close()
        print(f"seed {SEED}: {sent} messages of the stream in {time.monotonic() - begun:.1f} s", flush=True)
        self.assertEqual(self.state(), before)
        self.server.get("/health", "health")

    def refuse(self, stream, kind, text, mark):
        """The codes of the error with which the text is answered; a question after it has another one: so nothing else was said."""
        stream.protocol.send_text(text)
        stream.flush()
        stream.send({"type": "subscribe", "channel": mark})
        said = [stream.receive()]
        while isinstance(said[-1], dict) and said[-1]["channel"] != mark:
            said.append(stream.receive())
        if len(said) < 2 and kind in LATER:
            said.insert(0, stream.receive())
        check("stream_message", said[0])
        self.assertEqual([message["kind"] in ("error", "edit_refused") for message in said], [True, True], said)
        return {error["code"] for error in said[0]["data"]["errors"]}

    def test_a_message_that_is_too_large_or_no_text_ends_the_connection(self):
        message = b'{"type": "gather"}'
        cases = [(message + b" " * STREAM_BYTES, 1009), (b'{"x": "' + b"x" * STREAM_BYTES + b'"}', 1009), (b"[" * 100_000, 1009)]
        cases += [(text, 1007) for text in no_json(json.loads(message)) if not is_utf8(text)]
        for text, code in cases:
            with self.subTest(text=text[:50]), Stream(self.server.port) as stream:
                stream.protocol.send_text(text)
                stream.flush()
                self.assertIn(closed(stream), (code, None))
        with Stream(self.server.port) as stream:
            stream.protocol.send_binary(message)
            stream.flush()
            self.assertIn(closed(stream), (1003, None))


class ControlMessages(Messages, unittest.TestCase):
    """Of people at the controls: each is answered by one `refused`, and leaves them where they are."""

    def test_every_kind_is_refused_and_nothing_is_changed(self):
        begun, sent = time.monotonic(), 0
        with Controls(self.server) as person:
            self.assertEqual(person.take()["kind"], "taken")
            before = self.state()
            for kind, values in self.kinds("control_request").items():
                malformed, others = texts_of("control_request", values)
                for text in [each for each in (*malformed, *others) if is_utf8(each) and len(each) <= CONTROL_BYTES]:
                    sent += 1
                    with self.subTest(kind=kind, text=text[:300], seed=SEED):
                        with person.sending:
                            person.send(text.decode())
                        self.assertEqual(person.hear()["kind"], "refused")
            self.assertEqual(self.state(), before)
            self.assertEqual(self.server.get("/control", "control")["holder"]["number"], person.number)
        print(f"seed {SEED}: {sent} messages of the controls in {time.monotonic() - begun:.1f} s", flush=True)
        self.assertGreaterEqual(sent, TEXTS)

    def test_a_message_that_is_too_large_or_no_text_ends_the_connection(self):
        for large in (b'{"type": "beat"}' + b" " * CONTROL_BYTES, b"[" * 100_000):
            with Controls(self.server) as person:
                person.protocol.send_text(large)
                person.flush()
                self.assertIn(closed(person), (1009, None))


class ProcessMessages(Messages, unittest.TestCase):
    def test_every_first_message_is_refused(self):
        before, begun, sent = self.state(), time.monotonic(), 0
        for kind, values in self.kinds("component_request").items():
            malformed, others = texts_of("component_request", values if kind != "hello" else [self.hello], PROCESS_LEVELS)
            for text in [*malformed, *others] if kind == "hello" else [json.dumps(values[0]).encode()]:
                sent += 1
                with self.subTest(kind=kind, text=text[:300], seed=SEED), ComponentClient(self.server, token=self.token) as client:
                    self.refuse(client, kind, text)
        print(f"seed {SEED}: {sent} first messages of processes in {time.monotonic() - begun:.1f} s", flush=True)
        self.assertGreaterEqual(sent, TEXTS)
        self.assertEqual(self.state(), before)

    def test_every_kind_is_refused_and_ends_the_connection(self):
        before, begun, sent, chosen = self.state(), time.monotonic(), 0, random.Random(SEED)
        for kind, values in self.kinds("component_request").items():
            malformed, others = texts_of("component_request", values, PROCESS_LEVELS)
            for text in [*chosen.sample(malformed, min(OF_KIND, len(malformed))), *chosen.sample(others, min(OF_KIND, len(others)))]:
                sent += 1
                with self.subTest(kind=kind, text=text[:300], seed=SEED), self.welcome() as client:
                    codes = self.refuse(client, kind, text)
                    if text in malformed and is_utf8(text):
                        self.assertLessEqual(codes, NOT_JSON)
        print(f"seed {SEED}: {sent} messages of processes in {time.monotonic() - begun:.1f} s", flush=True)
        self.assertEqual(self.state(), before)
        self.server.get("/health", "health")

    def welcome(self):
        """A process that is welcome, once the place of the one before is free."""
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            client = ComponentClient(self.server, token=self.token)
            client.send(self.hello)
            if client.message()["type"] == "welcome":
                return client
            client.close()
        raise AssertionError("the place of a process stays taken")

    def refuse(self, client, kind, text):
        """The codes of the refusal, after which the connection ends."""
        if kind == "publish":
            client.protocol.send_binary(len(text).to_bytes(4, "big") + text)
        else:
            client.protocol.send_text(text)
        client.flush()
        if kind != "publish" and not is_utf8(text):
            self.assertIn(closed(client), (1007, None))
            return set()
        client.socket.settimeout(PROMPT)
        try:
            refused = client.next("refused")
        except TimeoutError:
            self.fail("it is not refused")
        self.assertIsNone(closed(client))
        return {error["code"] for error in refused["errors"]}


def is_utf8(text):
    try:
        return bool(text.decode()) or True
    except UnicodeDecodeError:
        return False


def closed(client):
    """The code with which the server ends the connection before it says anything else; None: without a close frame."""
    try:
        frame = client.event()
    except ConnectionError:
        return None
    assert frame.opcode is OP_CLOSE, frame
    return int.from_bytes(frame.data[:2], "big")


if __name__ == "__main__":
    unittest.main()
