"""RFC 6455 over bare sockets: handshakes and frames, right and wrong (websocket_cases.py), on the three sockets of the server.

Each case names its section and has exactly what that allows: which close code, if a close frame is sent at all (7.1.7: SHOULD), which
pong, which answer; and that a connection which goes on answers what comes next. A refused handshake is a problem document with a status
of openapi.yaml. Between them stand what the RFC leaves open: unknown close codes, keys that a server need not decode.
"""
import concurrent.futures
import json
import time
import unittest

from client import Server, check
from component_process import token_file
from interface import check_listed
from raw_websocket import PING, TEXT, RawWebSocket, Said, accept_of, frame, head_of, request_text
from websocket_cases import cases, message
from websocket_handshakes import BAD, GOOD, changed

# Connections: of processes that nobody knows, few have room.
AT_ONCE = {"/api/v1/stream": 32, "/api/v1/control/hold": 32, "/api/v1/components": 10}


class Frames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server("--remote", "database")
        cls.addClassCleanup(cls.server.stop)
        cls.token = token_file(cls.server).read_text().strip()
        cls.cases = cases()

    def tearDown(self):
        self.server.get("/health", "health")

    def open(self, path):
        return RawWebSocket(self.server.port, path, self.token if path.endswith("components") else None)

    def said(self, path, case):
        """What the server says to it. Who is to go on is asked something: what comes up to that answer counts."""
        with self.open(path) as connection:
            connection.send(case.sent, case.pause)
            if case.ends:
                return connection.read_until(None)
            is_stream = path.endswith("stream")
            connection.send([frame(TEXT, message("none/last")) if is_stream else frame(PING, b"last")])
            last = ("message", "none/last") if is_stream else ("pong", b"last")
            said = connection.read_until(last)
            self.assertIn(last, said.events)
            said.events.remove(last)
            return said

    def hold(self, path, chosen):
        begun = time.monotonic()
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE[path]) as clients:
            found = {str(case): (case, clients.submit(self.said, path, case)) for case in chosen}
        self.assertEqual(len(found), len(chosen), "two cases have one name")
        for name, (case, said) in found.items():
            with self.subTest(name, path=path):
                self.assertTrue(case.allows(said.result()), said.result())
        silent = [name for name, (case, said) in found.items() if case.ends and not said.result().events]
        self.assertLess(len(silent), len(chosen) / 10, f"SHOULD say why (7.1.7): {silent}")
        print(f"{len(chosen)} cases of {path} in {time.monotonic() - begun:.1f} s", flush=True)

    def test_every_case_on_the_stream(self):
        self.assertGreaterEqual(len(self.cases) + len(GOOD) + len(BAD), 250)
        self.hold("/api/v1/stream", self.cases)

    def test_those_that_are_no_messages_of_the_stream_on_the_others_too(self):
        for path in ("/api/v1/components", "/api/v1/control/hold"):
            self.hold(path, [case for case in self.cases if not case.stream_only])

    def test_what_a_case_does_not_allow_is_noticed(self):
        never = ([("message", "none/never")], [("pong", b"never")], [("binary", b"")], [("close", 4711)], 2 * [("close", 4711)])
        for case in self.cases:
            wrong = [Said(events, ended) for ended in (False, True) for events in never]
            wrong += [Said([], not case.ends), Said([("close", 1002)], False)]
            for said in wrong:
                with self.subTest(str(case)):
                    self.assertFalse(case.allows(said), said)

    def handshake(self, path, method, version, headers):
        """(status, headers, body)"""
        if path.endswith("components"):
            headers = [*headers, ("Authorization", f"Bearer {self.token}")]
        answer = self.server.send_raw(request_text(method, path, headers, self.server.port, version))
        head, _, body = answer.partition(b"\r\n\r\n")
        return *head_of(head), body

    def test_right_handshakes_are_answered_with_the_key(self):
        for path in AT_ONCE:
            for section, name, method, version, headers, statuses in GOOD:
                with self.subTest(section=section, name=name, path=path):
                    status, answered, body = self.handshake(path, method, version, headers)
                    self.assertIn(status, statuses)
                    if status == 101:
                        self.hold_answer(headers, answered, body)

    def hold_answer(self, headers, answered, body):
        """4.2.2; no protocol and no extension is chosen, as the server has none, and nothing is said before the client does."""
        key = next(value.strip() for name, value in headers if name.lower() == "sec-websocket-key")
        self.assertEqual(answered["sec-websocket-accept"], accept_of(key))
        self.assertEqual((answered["upgrade"].lower(), answered["connection"].lower()), ("websocket", "upgrade"))
        self.assertEqual({"sec-websocket-protocol", "sec-websocket-extensions"} & set(answered), set())
        self.assertEqual(body, b"")

    def test_wrong_handshakes_are_refused_with_a_problem(self):
        for path in AT_ONCE:
            for section, name, method, version, headers, statuses in BAD:
                with self.subTest(section=section, name=name, path=path):
                    status, answered, body = self.handshake(path, method, version, headers)
                    self.assertIn(status, statuses)
                    if section == "4.4":
                        self.assertEqual(answered.get("sec-websocket-version"), "13")
                    if status != 101:
                        self.assertEqual(answered.get("content-type"), "application/problem+json", body[:200])
                        check_listed(method, path, status, check("problem", json.loads(body)))

    def test_an_upgrade_elsewhere_is_no_upgrade(self):
        """RFC 9110, 7.8: a server may ignore it; 4.2.2: what is not there is not found."""
        for path, expected in (("/api/v1/health", 200), ("/api/v1/documents", 200), ("/api/v1/nothing", 404), ("/api/v1/stream/", 404),
                               ("/", 404)):
            with self.subTest(path):
                self.assertEqual(self.handshake(path, "GET", "HTTP/1.1", changed())[0], expected)


if __name__ == "__main__":
    unittest.main()
