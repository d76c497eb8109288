"""Hostile and malformed requests: the server refuses each with a listed error and goes on."""
import contextlib
import json
import random
import tempfile
import unittest
from pathlib import Path

import models
from client import PAGE_RULES, Server, Stream
from interface import check_listed


class RequestFilter(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()
        cls.host = f"127.0.0.1:{cls.server.port}"

    @classmethod
    def tearDownClass(cls):
        cls.server.get("/health", "health")
        cls.server.stop()

    def status(self, data):
        answer = self.server.send_raw(data)
        self.assertTrue(answer)
        status, (method, target) = int(answer.split()[1]), data.decode("latin-1").split()[:2]
        check_listed(method, target, status, json.loads(answer.split(b"\r\n\r\n", 1)[1]))
        return status

    def head(self, *lines, first="GET /api/v1/health HTTP/1.1", host=True):
        lines = [first, *([f"Host: {self.host}"] if host else []), *lines]
        return ("\r\n".join(lines) + "\r\n\r\n").encode()

    def test_bad_json_is_refused(self):
        for body in ("", "{", "[1,]", "{} {}", '{"a": 1, "a": 2}', "\x00", b"\xff\xfe", '"\\ud800"', "NaN"):
            with self.subTest(body=body):
                self.assertIn(self.server.request("POST", "/api/v1/cores", body)[0], (400, 422))

    def test_json_depth_is_limited_to_64(self):
        self.assertEqual(self.server.request("POST", "/api/v1/cores", "[" * 65 + "]" * 65)[0], 400)
        self.assertEqual(self.server.request("POST", "/api/v1/cores", "[" * 64 + "]" * 64)[0], 422)
        self.assertEqual(self.server.request("POST", "/api/v1/cores", "[" * 100000)[0], 400)
        self.assertEqual(self.server.request("PUT", "/api/v1/documents/deep", '{"a":' * 100 + "1" + "}" * 100)[0], 400)

    def test_exactly_one_allowed_host_is_required(self):
        self.assertEqual(self.status(self.head()), 200)
        self.assertEqual(self.status(self.head("Host: localhost", host=False)), 421)
        self.assertEqual(self.status(self.head(f"Host: LOCALHOST:{self.server.port}", host=False)), 200)
        self.assertEqual(self.status(self.head("Host: evil.example", host=False)), 421)
        self.assertEqual(self.status(self.head(host=False)), 400)
        self.assertEqual(self.status(self.head(f"Host: {self.host}")), 400)

    def test_a_foreign_origin_may_not_change_anything(self):
        post = "POST /api/v1/cores HTTP/1.1"
        self.assertEqual(self.status(self.head("Origin: http://evil.example", first=post)), 403)
        self.assertEqual(self.status(self.head("Origin: null", first=post)), 403)
        self.assertEqual(self.status(self.head(f"Origin: http://{self.host}", first=post)), 400)  # no JSON
        self.assertEqual(self.status(self.head(f"Origin: https://{self.host}", first=post)), 403)
        self.assertEqual(self.status(self.head("Origin: http://evil.example")), 200)
        with Stream(self.server.port, origin=f"http://localhost:{self.server.port}") as stream:
            self.assertEqual(stream.status, 101)
        with Stream(self.server.port, origin="http://evil.example") as stream:
            self.assertEqual(stream.status, 403)

    def test_transfer_encoding_is_answered_501_before_any_body(self):
        for value in ("chunked", "gzip, chunked", "identity", "chunked, identity", "x"):
            with self.subTest(value=value):
                request = self.head(f"Transfer-Encoding: {value}", first="POST /api/v1/cores HTTP/1.1")
                self.assertIn(self.status(request), (501, 400) if value != "chunked" else (501,))
                self.assertIn(self.status(request + b"5\r\nhello\r\n0\r\n\r\n"), (501, 400))

    def test_sizes_are_limited(self):
        large = self.head("Content-Length: 5000000", "Content-Type: application/json", first="PUT /api/v1/documents/x HTTP/1.1")
        self.assertEqual(self.status(large), 413)
        self.assertEqual(self.status(large + b" " * 5000000), 413)
        self.assertEqual(self.status(self.head("X: " + "x" * 20000)), 431)
        self.assertEqual(self.status(self.head(first=f"GET /{'x' * 20000} HTTP/1.1")), 431)

    def test_a_body_must_be_json(self):
        status, _ = self.server.request("POST", "/api/v1/cores", "{}", {"Content-Type": "text/plain"})
        self.assertEqual(status, 415)

    def test_targets_are_decoded_or_refused(self):
        for target in ("/api/v1/cores/%zz", "/api/v1/cores/%ff", "/api/v1/cores?x=%c3%28", "/api/v1/cores/%0a", "http://a/b", "*", "/%"):
            with self.subTest(target=target):
                self.assertEqual(self.status(self.head(first=f"GET {target} HTTP/1.1")), 400)

    def test_head_is_get_without_the_body(self):
        head = self.head(first="HEAD /api/v1/health HTTP/1.1")
        answer = self.server.send_raw(head + self.head("Connection: close"))
        first, rest = answer.split(b"\r\n\r\n", 1)
        self.assertRegex(first, rb"^HTTP/1.1 200[\s\S]*Content-Length: [1-9]")
        self.assertTrue(rest.startswith(b"HTTP/1.1 200"))

    def test_browsers_are_told_what_pages_may_do(self):
        with tempfile.TemporaryDirectory() as web:
            Path(web, "index.html").write_text("<p>")
            with Server("--web", web) as server:
                for page in ("/", "/api/v1/health", "/nothing"):
                    request = f"GET {page} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nConnection: close\r\n\r\n"
                    head = server.send_raw(request.encode()).split(b"\r\n\r\n")[0].decode().split("\r\n")
                    for line in PAGE_RULES:  # of the first, where a stop is served besides (test_pages.py)
                        self.assertTrue(any(each.startswith(line) for each in head), (page, line))

    def test_random_bytes_do_no_harm(self):
        seed = 20260
        generator = random.Random(seed)
        for attempt in range(200):
            length = generator.randrange(1, 300)
            data = bytes(generator.randrange(256) for _ in range(length))
            if attempt % 2:
                cut = generator.randrange(5, 60)
                data = self.head()[:cut] + data
            with contextlib.suppress(ConnectionError):
                self.server.send_raw(data)
        self.server.get("/health", "health")

    def test_invalid_messages_on_the_stream_are_answered_with_errors(self):
        with self.server.stream() as stream:
            for message in ("{", "[]", '{"type": "subscribe"}', '{"type": "shout", "channel": "log"}',
                            '{"type": "subscribe", "channel": "core/99/state"}',
                            '{"type": "subscribe", "channel": "cell/pose"}',
                            '{"type": "subscribe", "channel": "log", "since": "x"}', "[" * 1000):
                stream.send(message)
                self.assertEqual(stream.message()["kind"], "error")
            # The fields of a message depend on its type: with a wrong type only that is reported.
            for message, wrong in (('{"type": "shout", "channel": 1, "loud": true}', ["type"]),
                                   ('{"type": "subscribe", "channel": 1, "loud": true}', ["channel", "loud"])):
                stream.send(message)
                paths = [error["path"] for error in stream.message()["data"]["errors"]]
                self.assertEqual(paths, wrong)
            stream.send("x" * 70000)
            with self.assertRaises(ConnectionError):
                stream.message()

    def test_malformed_frames_end_the_connection(self):
        mask = bytes(4)
        for name, frame in (("not masked", b"\x81\x02{}"), ("reserved opcode", b"\x83\x80" + mask),
                            ("reserved bits", b"\xf1\x80" + mask), ("fragmented ping", b"\x09\x80" + mask),
                            ("continuation of nothing", b"\x80\x80" + mask), ("2^63 bytes", b"\x81\xff" + b"\x7f" * 8 + mask),
                            ("not UTF-8", b"\x81\x81" + mask + b"\xff")):
            with self.subTest(name), self.server.stream() as stream:
                raw = stream.socket  # past the library, which sends no such frames
                raw.sendall(frame)
                answer = raw.recv(65536)
                self.assertIn(answer[:1], (b"", b"\x88"))  # nothing but a close frame
                while answer:
                    answer = raw.recv(65536)

    def test_close_codes_that_are_none_are_protocol_errors(self):
        mask, protocol_error = bytes(4), b"\x88\x02\x03\xea"  # 1002

        def answer(code):
            """What the server says to a close frame with this code, until it closes the connection."""
            with self.server.stream() as stream:
                stream.socket.sendall(b"\x88\x82" + mask + code.to_bytes(2, "big"))
                said = b""
                while data := stream.socket.recv(65536):
                    said += data
                return said

        for code in (0, 999, 1004, 1005, 1006, 1015, 2999, 5000, 5001, 65535):
            with self.subTest(code=code):
                self.assertEqual(answer(code), protocol_error)
        for code in (1000, 1001, 3000, 4999):
            with self.subTest(code=code):
                self.assertEqual(answer(code), b"\x88\x02" + code.to_bytes(2, "big"))

    def test_deep_values_of_a_task_do_no_harm(self):
        deep = models.document("deep", {
            "state": "Root", "results": [{"name": "x", "initial": []}],
            "entry": "y = []\nfor i in range(20000):\n    y = [y]\nres.x = y\nsvc.db.add('deep', y)",
            "ports": [{"name": "stored", "when": "svc.db.add.result"}, {"name": "refused", "when": "svc.db.add.error"}]})
        core = self.server.core(deep)
        ended = self.server.ended(core)
        self.assertIn(ended["status"], ("ended", "faulted"))
        self.server.request("GET", f"/api/v1/cores/{core}/state")
        self.server.request("GET", f"/api/v1/cores/{core}/derivations")


if __name__ == "__main__":
    unittest.main()
