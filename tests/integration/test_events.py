"""A core followed by Server-Sent Events: whole runs, gaps, slow readers, rights, and how the answer ends."""
import http.client
import signal
import socket
import time
import unittest

import models
from accounts import AccountServer
from client import TIMEOUT, Server, Stream
from events import Events
from test_stream import apply, normalized
from test_tls import LanServer


def loud():
    """Each macro step carries a long text, so what a client leaves unread soon fills the buffers of its socket."""
    child = lambda me, other: {"state": me, "results": [{"name": "t"}], "entry": "res.t = 'x' * 100000\nsvc.db.get('none')",
                               "ports": [{"name": "next", "when": "svc.db.get.error", "to": other}]}
    return models.document("loud", {"state": "Root", "children": [child("A", "B"), child("B", "A")], "first": "A"})


def silent_reader(port, core):
    """A client that asks for events and never reads, with a small buffer for what comes."""
    connection = socket.socket()
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 65536)
    connection.settimeout(TIMEOUT)
    connection.connect(("127.0.0.1", port))
    connection.sendall(f"GET /api/v1/cores/{core}/events HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode())
    return connection


def is_cut(connection):
    """Whether the server has reset it, though nothing is read."""
    return connection.getsockopt(socket.IPPROTO_TCP, socket.TCP_INFO, 1) != b"\x01"  # TCP_ESTABLISHED


class EventsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()
        cls.addClassCleanup(cls.server.stop)

    def follow(self, core, last=None):
        events = Events(self.server.port, core, last)
        self.addCleanup(events.close)
        return events

    def remove(self, core):
        self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)

    def test_a_whole_run_is_followed(self):
        core = self.server.core(models.storing("followed"), {"value": {"deep": [1, 2.5, None], "text": "a\nb\r\u2028"}}, start=False)
        events = self.follow(core)
        self.assertEqual(events.status, 200)
        self.assertEqual(events.answer.getheader("Content-Type"), "text/event-stream")
        self.assertEqual(events.answer.getheader("Cache-Control"), "no-store")
        self.assertEqual(events.answer.getheader("X-Content-Type-Options"), "nosniff")
        snapshot = events.event()
        self.assertEqual((snapshot["kind"], snapshot["channel"]), ("snapshot", f"core/{core}/state"))
        self.server.post(f"/cores/{core}/start", None, "core")
        deltas = events.until(lambda m: m["data"]["core"]["status"] == "ended")
        numbers = [m["sequence"] for m in [snapshot, *deltas]]
        self.assertEqual(numbers, list(range(numbers[0], numbers[0] + len(numbers))))
        state = snapshot["data"]
        for delta in deltas:
            self.assertEqual(delta["kind"], "delta")
            state = apply(state, delta["data"])
        self.assertEqual(normalized(state), normalized(self.server.get(f"/cores/{core}/state", "core_state")))

    def test_events_are_the_messages_of_the_stream(self):
        core = self.server.core(models.ticking("both", last=6), start=False)
        events = self.follow(core)
        with self.server.stream() as stream:
            stream.subscribe(f"core/{core}/state")
            ours, theirs = [events.event()], [stream.message()]
            self.server.post(f"/cores/{core}/start", None, "core")
            is_end = lambda m: m["data"]["core"]["status"] == "ended"
            self.assertEqual(ours + events.until(is_end), theirs + stream.until(is_end))

    def test_who_comes_back_goes_on_without_a_gap(self):
        core = self.server.core(models.ticking("resumed", last=100000))
        with Events(self.server.port, core) as events:
            seen = events.until(lambda m: m["kind"] == "delta")[-1]
        self.server.wait(core, lambda c: c["step"] >= seen["data"]["core"]["step"] + 3)
        with Events(self.server.port, core, last=seen["sequence"]) as events:
            again = events.event()
            self.assertEqual((again["kind"], again["sequence"]), ("delta", seen["sequence"] + 1))
        for number in (5, again["sequence"] + 10**9):  # of an earlier server; never used
            with Events(self.server.port, core, last=number) as events:
                self.assertEqual(events.event()["kind"], "snapshot")
        self.remove(core)

    def test_what_is_no_id_is_refused(self):
        core = self.server.core(models.ticking("none"), start=False)
        for number in ("", "x", "-1", "1.5", "9" * 30):
            status, answer = self.server.request("GET", f"/api/v1/cores/{core}/events", headers={"Last-Event-ID": number})
            self.assertEqual((status, answer["errors"][0]["code"], answer["errors"][0]["path"]), (400, "out_of_range", "Last-Event-ID"))

    def test_a_core_that_is_not_there_and_a_parameter_too_many_are_refused(self):
        status, answer = self.server.request("GET", "/api/v1/cores/7777777/events")
        self.assertEqual((status, answer["errors"][0]["code"]), (404, "not_found"))
        core = self.server.core(models.ticking("more"), start=False)
        self.assertEqual(self.server.request("GET", f"/api/v1/cores/{core}/events?channel=log")[0], 400)
        self.assertEqual(self.server.request("POST", f"/api/v1/cores/{core}/events")[0], 405)

    def test_head_has_the_header_alone(self):
        core = self.server.core(models.ticking("head"), start=False)
        connection = http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=TIMEOUT)
        self.addCleanup(connection.close)
        connection.request("HEAD", f"/api/v1/cores/{core}/events")
        answer = connection.getresponse()
        self.assertEqual((answer.status, answer.getheader("Content-Type"), answer.read()), (200, "text/event-stream", b""))

    def test_the_answer_ends_with_its_core(self):
        core = self.server.core(models.ticking("removed", last=100000))
        events = self.follow(core)
        events.until(lambda m: m["kind"] == "delta")
        self.remove(core)
        error = events.until(lambda m: m["kind"] == "error")[-1]
        self.assertEqual(error["data"]["errors"][0]["code"], "not_found")
        self.assertIsNone(events.event())

    def test_a_client_of_http_1_0_gets_no_chunks(self):
        core = self.server.core(models.ticking("old"), start=False)
        with socket.create_connection(("127.0.0.1", self.server.port), TIMEOUT) as connection:
            connection.sendall(f"GET /api/v1/cores/{core}/events HTTP/1.0\r\nHost: 127.0.0.1:{self.server.port}\r\n\r\n".encode())
            text = b""
            while b"data: " not in text:
                piece = connection.recv(65536)
                self.assertTrue(piece, text)
                text += piece
        head, _, body = text.partition(b"\r\n\r\n")
        self.assertNotIn(b"chunked", head)
        self.assertRegex(body, rb"\Aid: \d+\nevent: snapshot\ndata: {")

    def test_a_comment_comes_when_nothing_else_does(self):
        core = self.server.core(models.ticking("still"), start=False)
        events = self.follow(core)
        events.event()
        began = time.monotonic()
        events.answer.readline()
        self.assertAlmostEqual(time.monotonic() - began, 15, delta=2)

    def test_who_says_more_than_the_request_is_cut(self):
        core = self.server.core(models.ticking("more_said"), start=False)
        events = self.follow(core)
        events.event()
        events.answer.fp.raw._sock.sendall(b"GET / HTTP/1.1\r\n\r\n")
        with self.assertRaises(ConnectionError):
            events.event()

    def test_who_reads_nothing_is_cut_while_others_go_on(self):
        core = self.server.core(loud(), start=False)
        silent = silent_reader(self.server.port, core)
        self.addCleanup(silent.close)
        events = self.follow(core)
        state = events.event()["data"]
        self.server.post(f"/cores/{core}/start", None, "core")
        began = time.monotonic()
        while not is_cut(silent):
            message = events.event()
            state = message["data"] if message["kind"] == "snapshot" else apply(state, message["data"])
            self.assertLess(time.monotonic() - began, TIMEOUT)
        self.assertGreater(time.monotonic() - began, 5, "a client may be slow for some seconds")
        self.server.post(f"/cores/{core}/pause", None, "core")
        last = self.server.get(f"/cores/{core}", "core")["step"]
        while state["core"]["step"] < last:
            message = events.event()
            state = message["data"] if message["kind"] == "snapshot" else apply(state, message["data"])
        self.assertEqual(normalized(state)["state"], normalized(self.server.get(f"/cores/{core}/state", "core_state"))["state"])
        self.remove(core)

    def test_who_reads_slowly_gets_a_snapshot_for_what_was_missed(self):
        core = self.server.core(loud() | {"name": "slow_reader"}, start=False)
        events = self.follow(core)
        numbers, kinds = [events.event()["sequence"]], []
        self.server.post(f"/cores/{core}/start", None, "core")
        self.server.wait(core, lambda c: c["step"] > 1000)
        self.server.post(f"/cores/{core}/pause", None, "core")
        last, step = self.server.get(f"/cores/{core}", "core")["step"], 0
        while step < last:
            message = events.event()
            numbers.append(message["sequence"])
            kinds.append(message["kind"])
            step = message["data"]["core"]["step"]
            if message["kind"] == "delta":
                self.assertEqual(numbers[-1], numbers[-2] + 1)
        self.assertIn("snapshot", kinds)
        self.assertLess(len(kinds), 1000)
        self.remove(core)


class Ends(unittest.TestCase):
    def test_the_answer_ends_with_the_server(self):
        server = Server()
        core = server.core(models.ticking("last_words"), start=False)
        with Events(server.port, core) as events:
            events.event()
            server.process.send_signal(signal.SIGTERM)
            while events.event():
                pass
        server.process.wait(TIMEOUT)
        server.stop()

    def test_a_token_that_ends_ends_its_answer(self):
        with AccountServer() as server:
            core = server.core(models.ticking("revoked"), start=False)
            with Events(server.port, core, token=server.tokens["observer"]) as events:
                events.event()
                server.expect("DELETE", "/accounts/observer", None, "account_removed", 200)
                began = time.monotonic()
                self.assertIsNone(events.event())
                self.assertLess(time.monotonic() - began, 5)

    def test_nobody_and_processes_get_no_events(self):
        with AccountServer() as server:
            core = server.core(models.ticking("rights"), start=False)
            for account, status in ((None, 401), ("speaker", 403)):
                self.assertEqual(server.ask(account, "GET", f"/api/v1/cores/{core}/events"), status)
            with Stream(server.port, token=server.tokens["observer"]) as stream, \
                    Events(server.port, core, token=server.tokens["observer"]) as events:
                stream.subscribe(f"core/{core}/state")
                self.assertEqual(events.event(), stream.message())


class OverTls(Events):
    def __init__(self, server, core):
        self.connection = http.client.HTTPConnection(server.where, server.lan_port, timeout=TIMEOUT)
        self.connection.sock = server.connect(server.trust())
        self.begin(self.connection, f"/api/v1/cores/{core}/events", token=server.admin, Host=server.host)


class Tls(unittest.TestCase):
    def test_events_come_over_tls_and_end_with_the_server(self):
        server = LanServer()
        server.token = server.admin
        core = server.core(models.ticking("over_tls", last=3), start=False)
        with OverTls(server, core) as events:
            self.assertEqual(events.event()["kind"], "snapshot")
            server.post(f"/cores/{core}/start", None, "core")
            events.until(lambda m: m["data"]["core"]["status"] == "ended")
            server.process.send_signal(signal.SIGTERM)
            while events.event():
                pass
        server.process.wait(TIMEOUT)
        server.stop()


if __name__ == "__main__":
    unittest.main()
