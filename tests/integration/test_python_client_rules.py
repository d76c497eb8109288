"""What the Python client library decides without a server: folding, gaps, bounds, errors; and that what is generated is up to date."""
import base64
import hashlib
import inspect
import json
import os
import re
import resource
import select
import socket
import ssl
import subprocess
import sys
import threading
import time
import unittest
from functools import partial
from unittest import mock

import yaml

from client import PROJECT
from python_clients import KINDS, LIBRARY, race_client
from race_client import calls
from race_client.address import Address
from race_client.aio import client as aio_client
from race_client.aio.client import AsyncClient
from race_client.call import Answer, Call
from race_client.errors import RaceError, failure, socket_errors
from race_client.fold import fold
from race_client.plain import client as plain_client
from race_client.plain import websocket
from race_client.plain.sender import send_twice
from race_client.updates import CoreUpdates

EMPTY = {"active": [], "ports": [], "activated": {}, "parameters": {}, "results": {}, "variables": {}}
NO_CHANGE = {"active": {}, "ports": {}, "activated": {}, "parameters": {}, "results": {}, "variables": {}, "unset": {}, "fired": [],
             "calls": []}


def core(step, status="running"):
    return {"id": "1", "status": status, "step": step}


def message(kind, number, data, channel="core/1/state"):
    return json.dumps({"channel": channel, "kind": kind, "sequence": number, "data": data})


def snapshot(number, step=0, **state):
    return message("snapshot", number, {"core": core(step), "state": {**EMPTY, **state}})


def delta(number, step, status="running", **changes):
    return message("delta", number, {**NO_CHANGE, "core": core(step, status), **changes})


def heard(updates):
    found = []
    while (update := updates.pop()) is not None:
        found.append(update)
    return found


class Folding(unittest.TestCase):
    def test_a_delta_changes_what_it_names_and_nothing_else(self):
        before = {"core": core(1), "state": {
            "active": ["Root", "Root/A"], "ports": ["Root/A.done"], "activated": {"Root/Both": ["Root/A.done"], "Root/Two": ["x"]},
            "parameters": {"Root": {"a": 1, "b": 2}, "Root/A": {"c": 3}}, "results": {}, "variables": {"Root": {"v": 0}}}}
        kept = json.loads(json.dumps(before))
        after = fold(before, {**NO_CHANGE, "core": core(2), "active": {"Root/A": False, "Root/B": True, "Root": True},
                              "ports": {"Root/A.done": False}, "activated": {"Root/Both": [], "Root/Three": ["y"]},
                              "parameters": {"Root": {"b": 5}}, "results": {"Root": {"r": None}},
                              "unset": {"parameters": {"Root": ["a"], "Root/A": ["c"]}, "variables": {"Root": ["v"]}}})
        self.assertEqual(after, {"core": core(2), "state": {
            "active": ["Root", "Root/B"], "ports": [], "activated": {"Root/Two": ["x"], "Root/Three": ["y"]},
            "parameters": {"Root": {"b": 5}}, "results": {"Root": {"r": None}}, "variables": {}}})
        self.assertEqual(before, kept, "an update that was handed out stays as it is")


class Updates(unittest.TestCase):
    def setUp(self):
        self.updates = CoreUpdates("1", capacity=5)
        self.assertEqual(json.loads(self.updates.opened()), {"type": "subscribe", "channel": "core/1/state"})
        self.assertIsNone(self.updates.received(snapshot(10)))

    def test_deltas_follow_without_a_gap(self):
        self.updates.received(delta(11, 1, active={"Root": True}))
        self.assertEqual([(each.kind, each.state["state"]["active"]) for each in heard(self.updates)],
                         [("snapshot", []), ("delta", ["Root"])])

    def test_a_gap_asks_for_one_new_snapshot_and_takes_nothing_before_it(self):
        self.assertEqual(json.loads(self.updates.received(delta(12, 2))), {"type": "subscribe", "channel": "core/1/state"})
        self.assertIsNone(self.updates.received(delta(13, 3)), "it was asked for already")
        self.assertTrue(self.updates.needs_snapshot)
        self.updates.received(snapshot(14, 4))
        self.updates.received(delta(15, 5))
        self.assertEqual([(each.kind, each.state["core"]["step"]) for each in heard(self.updates)],
                         [("snapshot", 0), ("snapshot", 4), ("delta", 5)])

    def test_a_new_connection_goes_on_behind_the_last_message(self):
        self.updates.received(delta(11, 1))
        self.updates.lost("closed")
        self.assertEqual(json.loads(self.updates.opened())["since"], 11)
        self.updates.received(delta(12, 2))
        self.assertEqual([each.kind for each in heard(self.updates)], ["snapshot", "delta", "disconnected", "connected", "delta"])

    def test_a_slow_reader_gets_one_snapshot_for_all_and_the_news_of_the_connection(self):
        self.updates.lost("closed")
        self.updates.opened()
        for number in range(11, 1000):
            self.updates.received(delta(number, number))
        found = heard(self.updates)
        self.assertLessEqual(len(found), 5)
        self.assertEqual([each.kind for each in found[:3]], ["disconnected", "connected", "snapshot"])
        self.assertEqual(found[-1].state["core"]["step"], 999)
        self.assertEqual(sum(each.merged or 1 for each in found[2:]), 990, "the first snapshot and 989 deltas")

    def test_it_is_over_with_the_run(self):
        self.assertFalse(self.updates.is_over)
        self.updates.received(delta(11, 1, "ended"))
        self.assertTrue(self.updates.is_over)

    def test_an_error_of_the_channel_is_raised_behind_what_came_before(self):
        with self.assertRaises(RaceError) as caught:
            self.updates.received(message("error", 11, {"errors": [{"path": "core/1/state", "code": "not_found", "message": "gone"}]}))
        self.updates.fail(caught.exception)
        self.assertEqual(self.updates.pop().kind, "snapshot")
        with self.assertRaises(RaceError):
            self.updates.pop()

    def test_what_is_no_message_is_an_error_and_other_channels_are_not_its(self):
        self.assertIsNone(self.updates.received(message("delta", 99, {}, channel="cores")))
        for text in ("", "[]", "{}", "null", message("delta", 11, {}), message("snapshot", 11, {"core": {}, "state": {}}),
                     message("delta", 11, [])):
            with self.assertRaises(RaceError) as caught:
                self.updates.received(text)
            self.assertEqual(caught.exception.code, "protocol", text)


class Answers(unittest.TestCase):
    def read(self, status, body):
        with self.assertRaises(RaceError) as caught:
            Call("GET", "/api/v1/health").read(Answer(status, {}, body))
        return caught.exception

    def test_problem_details_are_the_error(self):
        errors = [{"path": "Root", "code": "first", "message": "no child"}, {"path": "", "code": "json", "message": "no JSON"}]
        error = self.read(422, json.dumps({"errors": errors, "more_errors": True}).encode())
        self.assertEqual((error.status, error.errors, error.more_errors), (422, errors, True))
        self.assertEqual(str(error), "Root: first: no child\njson: no JSON\n...")

    def test_what_is_of_no_server_of_race_is_said_to_be(self):
        for body in (b"", b"<html>", b"[]", b"{}", b'{"errors": []}', b'{"errors": [{}]}', b'{"errors": 1}'):
            self.assertEqual((self.read(502, body).status, self.read(502, body).code), (502, "protocol"))
        for body in (b"", b"<html>", b"[]", b"null", b"\xff"):
            self.assertEqual(self.read(200, body).code, "protocol")

    def test_failures_of_sockets_are_told_apart(self):
        for error, code in ((TimeoutError(), "timeout"), (ConnectionResetError(), "connection"),
                            (socket.gaierror(-2, "unknown"), "connection"), (ssl.SSLError(1, "no TLS"), "connection")):
            with self.assertRaises(RaceError) as caught, socket_errors("http://x"):
                raise error
            self.assertEqual(caught.exception.code, code)


class Sender:
    """Fails with one error after the other."""

    def __init__(self, *errors):
        self.errors = list(errors)

    def send(self, call):
        raise self.errors.pop(0)


class SentTwice(unittest.TestCase):
    def failed(self, *errors):
        sender = Sender(*errors)
        with self.assertRaises(RaceError) as caught:
            send_twice(sender, Call("POST", "/api/v1/cores"))
        return caught.exception, len(sender.errors)

    def test_what_was_not_sent_is_not_sent_again(self):
        refused = failure("connection", "refused", is_sent=False)
        self.assertEqual(self.failed(refused, failure("timeout", "late")), (refused, 1))
        self.assertFalse(refused.may_be_done)

    def test_what_was_sent_once_may_be_done_whatever_becomes_of_the_second_time(self):
        for code, is_sent in (("timeout", True), ("connection", False), ("certificate", False)):
            last = failure(code, "last", is_sent=is_sent)
            self.assertEqual(self.failed(failure("connection", "ended"), last), (last, 0))
            self.assertTrue(last.may_be_done)


class Addresses(unittest.TestCase):
    def test_a_file_of_an_authority_that_cannot_be_used_is_named(self):
        for file, why in (("/nowhere/ca.pem", "No such file or directory"), (__file__, "no certificate of an authority")):
            for connect in KINDS.values():
                with self.assertRaisesRegex(ValueError, f"^{file} .*{why}"):
                    connect("https://127.0.0.1", ca_file=file)


def json_answer(value, status="200 OK"):
    body = json.dumps(value)
    return f"HTTP/1.1 {status}\r\nContent-Length: {len(body)}\r\n\r\n{body}".encode()


def opens_websocket(request):
    key = re.search(rb"(?i)sec-websocket-key: (\S+)", request)[1]
    accepted = base64.b64encode(hashlib.sha1(key + b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest())  # RFC 6455, 1.3
    head = (b"HTTP/1.1 101 Switching Protocols", b"Upgrade: websocket", b"Connection: Upgrade", b"Sec-WebSocket-Accept: " + accepted)
    return b"\r\n".join((*head, b"", b""))


def one_snapshot(_):
    """And a ping, so that there is an answer to wait for."""
    text = snapshot(1).encode()
    return b"\x81\x7e" + len(text).to_bytes(2) + text + b"\x89\x00"


ONE = json_answer({})
CLOSE, SILENT = b"", None  # instead of an answer: the connection is closed, or nothing is said


class FakeServer:
    """Answers each connection with these bytes, or its requests with each of a tuple of them, and then says nothing.

    An answer may be a function of the request."""

    def __init__(self, *answers):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.address = f"http://127.0.0.1:{self.listener.getsockname()[1]}"
        self.asked, self.kept = [], []
        threading.Thread(target=self.run, args=(answers,), daemon=True).start()

    def run(self, answers):
        for each in answers:
            connection, _ = self.listener.accept()
            self.kept.append(connection)
            for planned in each if isinstance(each, tuple) else (each,):
                self.asked.append(connection.recv(65536))
                answer = planned(self.asked[-1]) if callable(planned) else planned
                if answer is SILENT:
                    continue
                connection.sendall(answer)
                if answer == CLOSE or b"Connection: close" in answer:
                    connection.close()

    def close(self):
        for each in (self.listener, *self.kept):
            each.close()


class FakeServers(unittest.TestCase):
    def serve(self, *answers):
        server = FakeServer(*answers)
        self.addCleanup(server.close)
        return server

    def test_what_does_not_answer_is_given_up_in_time(self):
        for connect in KINDS.values():
            client = connect(self.serve(b"HTTP/1.1 200 OK\r\nContent-Length: 100\r\n\r\n{").address, timeout=0.3)
            with self.assertRaises(RaceError) as caught:
                client.health()
            self.assertEqual(caught.exception.code, "timeout")
            client.close()

    def test_what_speaks_no_http_or_ends_is_an_error(self):
        for connect in KINDS.values():
            cut = b"HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: 9\r\n\r\n{"
            for answer, code in ((b"SSH-2.0\r\n\r\n", "protocol"), (cut, "connection")):
                client = connect(self.serve(answer, answer).address, timeout=5)
                with self.assertRaises(RaceError) as caught:
                    client.health()
                self.assertEqual(caught.exception.code, code)
                with self.assertRaises(RaceError), client.cores.follow("1"):
                    pass
                client.close()

    def test_a_request_that_changes_something_is_sent_once_over_a_connection_that_ended(self):
        for connect in KINDS.values():
            server = self.serve(ONE, ONE)
            client = connect(server.address, timeout=5)
            self.assertEqual(client.health(), {})
            server.kept[0].close()
            self.assertEqual(client.send(Call("POST", "/api/v1/stop")), {}, "over a new connection")
            self.assertEqual([each.split(b" ")[0] for each in server.asked], [b"GET", b"POST"])
            client.close()

    def test_what_may_have_been_done_is_not_sent_again_and_what_only_reads_is(self):
        for connect in KINDS.values():
            server = self.serve((ONE, CLOSE), (ONE, CLOSE), ONE)
            client = connect(server.address, timeout=5)
            self.assertEqual([client.health(), client.health()], [{}, {}], "asked again over a new connection")
            with self.assertRaises(RaceError) as caught:
                client.send(Call("POST", "/api/v1/cores/1/start"))
            self.assertEqual((caught.exception.code, caught.exception.may_be_done), ("connection", True))
            self.assertEqual([each.split(b" ")[0] for each in server.asked], [b"GET", b"GET", b"GET", b"POST"])
            client.close()

    def test_what_was_never_sent_is_known_not_to_be_done(self):
        gone, silent = (socket.create_server(("127.0.0.1", 0)) for _ in range(2))
        self.addCleanup(silent.close)
        gone_port, silent_port = gone.getsockname()[1], silent.getsockname()[1]
        gone.close()
        for connect in KINDS.values():
            for address, code in ((f"http://127.0.0.1:{gone_port}", "connection"), (f"https://127.0.0.1:{silent_port}", "timeout")):
                client = connect(address, timeout=0.3)
                for ask in (partial(client.cores.start, "1"), client.cores.follow("1").__enter__):
                    with self.assertRaises(RaceError) as caught:
                        ask()
                    self.assertEqual((caught.exception.code, caught.exception.may_be_done), (code, False))
                client.close()

    def test_a_wait_ends_in_time_whatever_the_stream_does(self):
        running = json_answer(core(1))
        for connect in KINDS.values():
            for stream in (b"HTTP/1.1 101 Switching", opens_websocket, (opens_websocket, one_snapshot, CLOSE)):
                client = connect(self.serve(running, stream).address, timeout=3)
                begun = time.monotonic()
                with self.assertRaises(RaceError) as caught:
                    client.cores.wait("1", timeout=0.5)
                self.assertLess(time.monotonic() - begun, 2)
                self.assertEqual((caught.exception.code, caught.exception.message),
                                 ("timeout", "core 1 is not over after 0.5 s: its status is running"))
                client.close()

    def impatient(self):
        for module in (aio_client, plain_client):
            patched = mock.patch.object(module, "STOP_TIMEOUT", 0.3)
            patched.start()
            self.addCleanup(patched.stop)

    def test_a_stop_waits_for_no_connection_that_is_half_dead_and_is_sent_again(self):
        self.impatient()
        busy = json_answer({}, "503 Service Unavailable")
        for connect in KINDS.values():
            for first, second in ((SILENT, CLOSE), (CLOSE, busy), (busy, SILENT)):
                server = self.serve(ONE, first, second, ONE)
                race = connect(server.address, timeout=5)
                race.health()
                begun = time.monotonic()
                self.assertEqual(race.stop_cell(), {})
                self.assertLess(time.monotonic() - begun, 2)
                self.assertEqual([each.split(b" ")[0] for each in server.asked], [b"GET", b"POST", b"POST", b"POST"])
                race.close()

    def test_a_stop_is_given_up_at_last_and_may_be_done(self):
        self.impatient()
        wrong = json_answer({}, "404 Not Found")
        for connect in KINDS.values():
            for answers, times, how in (((SILENT,) * 9, 3, (0, "timeout", True)), ((SILENT, CLOSE, SILENT, ONE), 3, (0, "timeout", True)),
                                        ((wrong, ONE), 1, (404, "protocol", False))):
                server = self.serve(*answers)
                race = connect(server.address, timeout=5)
                with self.assertRaises(RaceError) as caught:
                    race.stop_cell()
                self.assertEqual((caught.exception.status, caught.exception.code, caught.exception.may_be_done), how)
                self.assertEqual(len(server.asked), times)
                race.close()

    def many_files(self):
        """From now on, sockets have larger numbers than `select` takes."""
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        self.assertGreater(hard, 1500)
        resource.setrlimit(resource.RLIMIT_NOFILE, (max(soft, 1500), hard))
        self.addCleanup(resource.setrlimit, resource.RLIMIT_NOFILE, (soft, hard))
        null = os.open(os.devnull, os.O_RDONLY)
        self.addCleanup(os.close, null)
        while (more := os.dup(null)) < 1024:
            self.addCleanup(os.close, more)
        self.addCleanup(os.close, more)

    def test_a_program_with_many_files_keeps_its_connections(self):
        self.many_files()
        for connect in KINDS.values():
            server = self.serve((ONE, ONE))
            client = connect(server.address, timeout=5)
            self.assertEqual([client.health(), client.health()], [{}, {}])
            client.close()

    def test_a_connection_that_cannot_be_looked_at_is_closed(self):
        self.many_files()
        server = self.serve(ONE, ONE)
        client = race_client.Client(server.address, timeout=5)
        with mock.patch.object(select, "poll"):
            del select.poll
            self.assertEqual([client.health(), client.health()], [{}, {}], "over a new connection")
        server.kept[0].settimeout(5)
        self.assertEqual(server.kept[0].recv(1), b"")
        client.close()

    def test_a_server_that_falls_silent_is_lost(self):
        self.addCleanup(setattr, websocket, "SILENCE", websocket.SILENCE)
        websocket.SILENCE = 0.2
        stream = websocket.WebSocket(Address.parse("http://127.0.0.1:1"), Silent(), websocket.WebSocketProtocol.__new__(Open))
        with self.assertRaises(RaceError) as caught:
            for _ in range(100):
                stream.receive(0.01)
        self.assertEqual((caught.exception.code, stream._protocol.pings), ("connection", 1))


class Silent:
    def receive(self, timeout):
        threading.Event().wait(timeout)
        raise TimeoutError

    def send(self, data, timeout):
        pass


class Open(websocket.WebSocketProtocol):
    pings = 0

    def ping(self):
        self.pings += 1

    def output(self):
        return b""


class Generated(unittest.TestCase):
    def run_python(self, *words):
        return subprocess.run([sys.executable, "-B", *words], cwd=LIBRARY, capture_output=True, text=True, timeout=120, check=False)

    def test_what_is_generated_is_up_to_date(self):
        done = self.run_python("generate/main.py", "--check")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""), "run api/python/generate/main.py")

    def test_the_types_hold(self):
        done = self.run_python("-m", "mypy", "--cache-dir", "/dev/null", "race_client")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_every_route_has_a_call_with_its_method_and_path(self):
        interface = yaml.safe_load((PROJECT / "api" / "openapi.yaml").read_text())
        routes = {(method.upper(), path) for path, methods in interface["paths"].items() for method, operation in methods.items()
                  if method != "parameters" and "101" not in operation["responses"]
                  and "text/event-stream" not in operation["responses"].get("200", {}).get("content", {})}
        made = set()
        for name in calls.__all__:
            if name == "STREAM_PATH":
                continue
            function = getattr(calls, name)
            parameters = inspect.signature(function).parameters.values()
            call = function(**{each.name: f"<{each.name}>" for each in parameters if each.default is each.empty})
            made.add((call.method, call.path.replace("%3C", "{").replace("%3E", "}")))
            self.assertTrue(function.__doc__)
        self.assertEqual(made, routes)

    def test_both_clients_offer_the_same_and_say_what_it_is(self):
        for ours, theirs in ((race_client.Client, AsyncClient), (race_client.Client("http://localhost").cores.__class__,
                                                                AsyncClient("http://localhost").cores.__class__)):
            public = lambda kind: {name: str(inspect.signature(value)).replace("Async", "") for name, value in vars(kind).items()
                                   if inspect.isfunction(value) and not name.startswith("_")}
            self.assertEqual(set(public(ours)), set(public(theirs)))
            for kind in (ours, theirs):
                for name in public(kind):
                    self.assertTrue(getattr(kind, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
