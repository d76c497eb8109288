"""A core that is busy, and a replay that takes long, delay those who ask for them, and nobody else."""
import shutil
import socket
import tempfile
import threading
import time
import unittest

import models
from client import TIMEOUT, Server
from component_process import LONG_HEARTBEAT, component_client

SOON = 1  # [s] what is not delayed takes a few milliseconds
CLIENTS = 8


def laps(name="laps", states=400, last=10):
    """With each tick of the timer, through all states in one macro step; ends after `last` ticks."""
    middle = [models.working(f"S{i}", f"S{i + 1}") for i in range(states)]
    return models.document(name, {
        "state": "Root", "results": [{"name": "n", "initial": 0}],
        "actions": [{"when": "svc.timer.tick", "do": "res.n = res.n + 1"}],
        "children": [*middle, {"state": f"S{states}", "ports": [{"name": "next", "when": "svc.timer.tick", "to": "S0"}]}],
        "first": "S0", "ports": [{"name": "done", "when": f"res.n >= {last}"}]})


def calling_then_diverging():
    """Plays a sound; with the next tick of the timer begins a macro step that does not end."""
    task = models.diverging(numbers=150000)
    task["root"] |= {"entry": "svc.audio.play('beep')", "first": "Wait", "children": [
        {"state": "Wait", "ports": [{"name": "next", "when": "svc.timer.tick", "to": "A"}]}, *task["root"]["children"]]}
    return task


class Asking(threading.Thread):
    """A client that asks for something; `answer` is (status, body), `seconds` how long it took."""

    def __init__(self, server, method, path):
        super().__init__()
        self.server, self.method, self.path = server, method, path
        self.start()

    def run(self):
        begin = time.monotonic()
        self.answer = self.server.request(self.method, "/api/v1" + self.path)
        self.seconds = time.monotonic() - begin


class BusyCores(unittest.TestCase):
    def setUp(self):
        self.server = Server()
        self.addCleanup(self.server.kill)
        self.idle = self.server.core(models.ticking("idle", last=10**9), start=False)

    def timed(self, method, path, body=None, status=200):
        begin = time.monotonic()
        self.server.expect(method, path, body, None, status)
        return time.monotonic() - begin

    def busy_core(self):
        """A core in a long macro step, which somebody wants to pause."""
        core = self.server.core(models.diverging())
        self.clients = [Asking(self.server, "POST", f"/cores/{core}/pause")]
        time.sleep(0.2)
        return core

    def test_clients_of_a_busy_core_delay_nobody_else(self):
        busy = self.busy_core()
        self.clients += [Asking(self.server, "GET", f"/cores/{busy}/state") for _ in range(CLIENTS)]
        time.sleep(0.2)
        for _ in range(5):
            self.assertLess(self.timed("GET", "/health"), SOON)
            self.assertLess(self.timed("GET", "/cores"), SOON)
            self.assertLess(self.timed("GET", f"/cores/{self.idle}/state"), SOON)
        self.assertLess(self.timed("POST", f"/cores/{self.idle}/start"), SOON)
        self.assertLess(self.timed("GET", f"/cores/{busy}/journal"), SOON, "what was told last")
        for client in self.clients:
            client.join()
            self.assertIn(client.answer[0], (200, 409, 503))

    def test_others_are_loaded_and_deleted_while_one_is_busy(self):
        other = self.server.core(models.ticking("idle", last=10**9), start=False)
        busy = self.busy_core()
        self.clients.append(Asking(self.server, "DELETE", f"/cores/{busy}"))
        time.sleep(0.2)
        self.assertLess(self.timed("POST", f"/cores/{self.idle}/load", {"document": "idle"}), SOON)
        self.assertLess(self.timed("DELETE", f"/cores/{other}"), SOON)
        for client in self.clients:
            client.join()
        self.assertEqual(self.clients[-1].answer[0], 200)
        self.server.wait_for(lambda: self.server.get(f"/runs/{busy}", "run")["status"] == "aborted")  # its run is stored as that


class LongReplays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()
        cls.long = [cls.server.core(laps()) for _ in range(3)]
        cls.short = cls.server.core(models.ticking("short", last=1))
        cls.steps = [cls.server.ended(core, 6 * TIMEOUT)["step"] for core in cls.long]
        cls.server.ended(cls.short)

    @classmethod
    def tearDownClass(cls):
        cls.server.kill()

    def ask_for_a_long_one(self, i):
        """A connection that has asked and does not read."""
        connection = socket.create_connection(("127.0.0.1", self.server.port), timeout=TIMEOUT)
        path = f"/api/v1/cores/{self.long[i]}/derivations?from=1&to={self.steps[i]}"
        connection.sendall(f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{self.server.port}\r\n\r\n".encode())
        time.sleep(0.3)
        return connection

    def test_a_replay_ends_when_its_client_has_gone(self):
        for i in range(len(self.long)):
            self.ask_for_a_long_one(i).close()
        begin = time.monotonic()
        self.server.get(f"/cores/{self.short}/derivations", "derivations")
        self.assertLess(time.monotonic() - begin, SOON)

    def test_z_the_server_ends_while_somebody_waits_for_a_replay(self):
        with self.ask_for_a_long_one(0):
            begin = time.monotonic()
            self.server.process.terminate()
            self.assertEqual(self.server.process.wait(TIMEOUT), 0)
            self.assertLess(time.monotonic() - begin, 2 * SOON)


class LongRebuilds(unittest.TestCase):
    def test_the_server_ends_while_a_run_is_read_back(self):
        server = Server()
        self.addCleanup(server.stop)
        core = server.core(models.diverging(numbers=150000))
        server.get(f"/cores/{core}/state", "core_state")  # what is told of a macro step is in the journal: it is done again
        interrupted = server.wait(core, lambda now: now["status"] == "interrupted", 3 * TIMEOUT)
        self.assertEqual(interrupted["interruption"]["reason"], "deadline")
        time.sleep(0.3)
        server.get(f"/cores/{core}/state", status=507)  # it is not read back yet
        begin = time.monotonic()
        server.process.terminate()
        self.assertEqual(server.process.wait(2 * TIMEOUT), 0)
        took = time.monotonic() - begin
        print(f"a run is read back: ends in {took:.2f} s", flush=True)
        self.assertLess(took, 2 * SOON)

    def test_a_run_that_takes_long_to_be_read_back_keeps_no_server_from_its_start_and_can_be_ended(self):
        data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, data)
        before = Server(data=data)
        core = before.core(models.diverging(numbers=150000))
        before.get(f"/cores/{core}/state", "core_state")
        before.kill()
        begin = time.monotonic()
        with Server(data=data) as server:
            started = time.monotonic() - begin
            self.assertLess(started, 5)
            self.assertEqual(server.get(f"/cores/{core}", "core")["status"], "interrupted")
            begin = time.monotonic()
            server.post(f"/cores/{core}/stop", None, "core")
            answered = time.monotonic() - begin
            again = server.request("POST", f"/api/v1/cores/{core}/stop")[0]
            self.assertIn(again, (200, 409), "409: it is over already")
            server.wait(core, lambda now: now["status"] == "aborted", TIMEOUT)
            ended = time.monotonic() - begin
            print(f"a run that takes long to be read back: the server starts in {started:.2f} s, the run has ended after "
                  f"{ended:.2f} s", flush=True)
            self.assertLess(answered, SOON)
            self.assertLess(ended, 2 * SOON, "nobody waits until it is read back")

    def test_what_a_run_called_is_told_to_stop_when_it_is_ended_while_it_is_read_back(self):
        data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, data)
        options = ("--remote", "audio", *LONG_HEARTBEAT)
        before = Server(*options, data=data)
        with component_client(before, "audio") as audio:
            core = before.core(calling_then_diverging())
            self.assertEqual(audio.next("call")["operation"], "play")
            state = lambda: before.get(f"/cores/{core}/state", "core_state")["state"]["active"]
            before.wait_for(lambda: "Root/Wait" not in state())  # the macro step that was told is in the journal
            before.kill()
        with Server(*options, data=data) as server, component_client(server, "audio") as audio:
            server.post(f"/cores/{core}/stop", None, "core")
            self.assertEqual(audio.next("call")["operation"], "stop")
            server.wait(core, lambda now: now["status"] == "aborted", TIMEOUT)


if __name__ == "__main__":
    unittest.main()
