"""race trace and log: what a run does and what the server says, at once and as it goes on."""
import base64
import hashlib
import json
import re
import signal
import socket
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

import models
from accounts import PASSWORD, AccountServer
from client import PROGRAM, TIMEOUT, Server
from race_command import Person
from test_tls import LanServer


def telling(case, message):
    """The URL of a server that answers one client of the stream, with one message."""
    listener = socket.create_server(("127.0.0.1", 0))

    def answer():
        with listener, listener.accept()[0] as client:
            request = b""
            while b"\r\n\r\n" not in request:
                request += client.recv(4096)
            key = re.search(rb"(?i)sec-websocket-key: (\S+)", request)[1]
            accepted = base64.b64encode(hashlib.sha1(key + b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest()).decode()
            client.sendall(b"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                           b"Sec-WebSocket-Accept: " + accepted.encode() + b"\r\n\r\n")
            client.recv(4096)  # what it subscribes
            text = json.dumps(message).encode()
            size = bytes([len(text)]) if len(text) < 126 else b"\x7e" + len(text).to_bytes(2, "big")
            client.sendall(b"\x81" + size + text)
            while client.recv(4096):
                pass

    thread = threading.Thread(target=answer, daemon=True)
    thread.start()
    case.addCleanup(thread.join, TIMEOUT)
    return f"http://127.0.0.1:{listener.getsockname()[1]}"


class CommandCase(unittest.TestCase):
    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.stop)
        self.person = Person(self, f"http://127.0.0.1:{self.server.port}")

    def derived(self, core):
        """The output of `race derive --text` for the script of a core."""
        with tempfile.TemporaryDirectory() as folder:
            model, script = Path(folder, "model.json"), Path(folder, "script.json")
            model.write_text(json.dumps(self.server.get(f"/cores/{core}/native")["document"]))
            script.write_text(json.dumps(self.server.get(f"/cores/{core}/script")))
            return subprocess.run([PROGRAM, "derive", "--text", model, script], capture_output=True, text=True, check=False).stdout


class Trace(CommandCase):
    def test_is_what_derive_prints(self):
        core = self.server.core(models.ticking(last=3))
        self.server.ended(core)
        text = self.person.done("trace", core)
        self.assertEqual(text, self.derived(core))
        self.assertEqual(text.splitlines()[-1], "ended: done")
        self.assertEqual(self.person.done("trace", "--run", core), text)
        self.assertEqual(self.person.done("trace", core, "--follow"), text)

    def test_of_many_steps_comes_in_parts(self):
        core = self.server.core(models.hurrying())
        self.server.wait(core, lambda state: state["step"] > 250)
        self.server.post(f"/cores/{core}/stop")
        journal = json.dumps(self.server.get(f"/cores/{core}/journal"))
        replayed = subprocess.run([PROGRAM, "replay", "--text", "-"], input=journal, capture_output=True, text=True, check=False).stdout
        self.assertEqual(self.person.done("trace", core).splitlines()[:-1], replayed.splitlines()[:-1])

    def test_begins_where_it_is_told(self):
        core = self.server.core(models.ticking(last=3))
        steps = self.server.ended(core)["step"]
        lines = self.person.done("trace", core, "--first", steps).splitlines()
        self.assertEqual((lines[0], lines[-1]), (f"step {steps}", "ended: done"))
        self.assertEqual(self.person.done("trace", core, "--first", steps + 1), "ended: done\n")
        self.assertEqual(self.person.race("trace", core, "--first", "0")[0], 2)

    def test_as_json_is_a_step_a_line(self):
        core = self.server.core(models.ticking(last=3))
        steps = self.server.ended(core)["step"]
        *lines, end = map(json.loads, self.person.done("trace", core, "--json").splitlines())
        self.assertEqual((lines, end), (self.server.get(f"/cores/{core}/derivations?from=1&to={steps}")["steps"],
                                        {"status": "ended", "outcome": "done"}))

    def test_follows_a_run_to_its_end(self):
        self.server.put("/documents/ticking", models.ticking(last=8))
        core = self.person.done("start", "ticking").strip()
        following = self.person.start("trace", core, "--follow")
        self.assertEqual(following.stdout.readline(), "step 1\n")
        status, output, errors = self.person.finish(following)
        self.assertEqual((status, errors), (0, ""))
        self.assertEqual("step 1\n" + output, self.derived(core))

    def test_of_a_run_that_goes_on_ends_with_its_status(self):
        core = self.server.core(models.ticking(last=1000))
        self.server.wait(core, lambda state: state["step"] > 2)
        self.assertEqual(self.person.done("trace", core).splitlines()[-1], "running")
        following = self.person.start("trace", core, "--follow")
        self.assertEqual(following.stdout.readline(), "step 1\n")
        following.send_signal(signal.SIGINT)
        status, output, errors = self.person.finish(following)
        self.assertEqual((status, errors), (0, ""))
        self.assertTrue(self.derived(core).startswith("step 1\n" + output))

    def test_of_a_faulty_run_is_1(self):
        core = self.server.core(models.faulty())
        self.server.ended(core)
        status, output, _ = self.person.race("trace", core)
        self.assertEqual((status, "zero_division" in output.splitlines()[-1]), (1, True))
        self.assertEqual(self.person.race("trace", "77")[0], 1)

    def test_of_a_core_that_has_not_begun_is_its_status(self):
        core = self.server.core(models.ticking(), start=False)
        self.assertEqual(self.person.done("trace", core), "ready\n")


class Log(CommandCase):
    def lines(self, text):
        return [line.split(None, 2) for line in text.splitlines()]

    def test_shows_the_last_lines(self):
        core = self.server.core(models.ticking(last=1))
        self.server.ended(core)
        lines = self.lines(self.person.done("log"))
        self.assertIn(f"core/{core}", [source for _, source, _ in lines])
        self.assertEqual(sorted(lines, key=lambda line: float(line[0])), lines)
        entries = [json.loads(line) for line in self.person.done("log", "--json").splitlines()]
        self.assertEqual([entry["source"] for entry in entries], [source for _, source, _ in lines])

    def test_follows_it_until_ctrl_c(self):
        following = self.person.start("log", "--follow")
        core = self.server.core(models.ticking(last=1))
        while f" core/{core} " not in following.stdout.readline():
            self.assertIsNone(following.poll())
        following.send_signal(signal.SIGINT)
        status, _, errors = self.person.finish(following)
        self.assertEqual((status, errors), (0, ""))

    def test_ends_with_the_server(self):
        with Server() as server:
            server.core(models.ticking(last=1))
            following = Person(self, f"http://127.0.0.1:{server.port}").start("log", "--follow", "--json")
            following.stdout.readline()
        status, _, errors = self.person.finish(following)
        self.assertEqual((status, ": unavailable: " in errors), (2, True))

    def test_says_why_there_is_none(self):
        for data, status, said in (({"errors": [{"path": "log", "code": "unavailable", "message": "too many ask"}]}, 1,
                                    "log: unavailable: too many ask\n"),
                                   ({"entries": 7}, 2, ": io: sends what is no log\n")):
            url = telling(self, {"channel": "log", "sequence": 1, "kind": "error", "data": data})
            result, output, errors = self.person.race("log", url=url)
            self.assertEqual((result, output), (status, ""))
            self.assertTrue(errors.endswith(said), errors)

    def test_needs_a_login_where_there_are_accounts(self):
        with AccountServer() as server:
            person = Person(self, f"http://127.0.0.1:{server.port}")
            status, _, errors = person.race("log")
            self.assertEqual((status, "rights: " in errors, "`race login" in errors), (1, True, True))
            person.done("login", "observer", text=PASSWORD + "\n")
            person.done("log")

    def test_comes_over_tls(self):
        with LanServer() as server:
            person = Person.in_network(self, server)
            person.done("log", "--ca", server.authority, RACE_TOKEN=server.admin)


if __name__ == "__main__":
    unittest.main()
