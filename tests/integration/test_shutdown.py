"""SIGTERM and SIGINT: motions are stopped, clients are told why, nothing that was acknowledged is lost, within a time."""
import contextlib
import json
import os
import re
import shutil
import signal
import socket
import struct
import subprocess
import tempfile
import threading
import time
import unittest

from websockets.frames import OP_CLOSE, OP_TEXT

import models
from client import PROGRAM, PROJECT, TIMEOUT, Server
from crash_scenario import Connection
from component_process import LONG_HEARTBEAT, ComponentProcess, component_client, wait_available
from motions import Arm, insisting, moving
from traced_server import STORE, TracedServer

DEMO = str(PROJECT / "deploy/demo")
SOON = 4  # [s] for the end of a server, whatever is under way
IN_TIME = 10  # [s] whatever hangs


class Case(unittest.TestCase):
    def setUp(self):
        self.data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, self.data)
        self.servers = []

    def serve(self, *options):
        server = Server(*options, data=self.data)
        self.addCleanup(self.clean, server)
        return server

    @staticmethod
    def clean(server):
        if server.process.poll() is None:
            server.process.kill()
            server.process.wait()
        server.process.stdout.close()

    def end(self, server, number=signal.SIGTERM, within=SOON, status=0):
        """Sends the signal; returns how long the server took [s]."""
        begin = time.monotonic()
        server.process.send_signal(number)
        self.assertEqual(server.process.wait(TIMEOUT), status)
        took = time.monotonic() - begin
        self.assertLess(took, within)
        return took

    @staticmethod
    def last_words(stream):
        """(messages, code, reason): all that comes until the close frame."""
        messages, text = [], b""
        while True:
            frame = stream.event()
            if frame.opcode is OP_CLOSE:
                return messages, struct.unpack("!H", frame.data[:2])[0], frame.data[2:].decode()
            if frame.opcode is OP_TEXT:
                text = frame.data
                messages.append(json.loads(text))


class Ends(Case):
    def test_runs_are_interrupted_and_wait_for_a_person(self):
        server = self.serve()
        ticking = [server.core(models.ticking(f"ticking{number}", last=1_000_000)) for number in range(3)]
        ready = server.core(models.ticking("ready"), start=False)
        over = server.core(models.ticking("over", last=1))
        server.ended(over)
        for core in ticking:
            server.wait(core, lambda c: c["step"] > 20)
        before = {core: server.get(f"/cores/{core}", "core")["step"] for core in ticking}
        self.end(server)
        server = self.serve()
        for core in ticking:
            state = server.get(f"/cores/{core}", "core")
            self.assertEqual((state["status"], state["interruption"]["reason"]), ("interrupted", "restart"))
            self.assertGreaterEqual(state["step"], before[core], "what was told is there")
            server.post(f"/cores/{core}/resume", None, "core")
            server.wait(core, lambda c, s=state: c["step"] > s["step"])
        self.assertEqual(server.get(f"/cores/{ready}", "core")["status"], "ready")
        self.assertEqual(server.get(f"/runs/{over}", "run")["status"], "ended")
        for core in ticking:
            server.post(f"/cores/{core}/stop", None, "core")
        self.end(server, signal.SIGINT)

    def test_clients_are_told_why_before_they_are_closed(self):
        server = self.serve()
        with server.stream() as stream, server.stream() as other:
            stream.subscribe("log")
            stream.until(lambda m: m["kind"] == "snapshot")
            server.process.terminate()
            messages, code, reason = self.last_words(stream)
            self.assertEqual((code, reason), (1001, "the server ends"))
            lines = [line["text"] for m in messages if m["channel"] == "log" for line in m["data"]["entries"]]
            self.assertIn("ends: SIGTERM", lines)
            self.assertEqual(self.last_words(other)[1:], (1001, "the server ends"))
        self.assertEqual(server.process.wait(TIMEOUT), 0)

    def test_without_anything_under_way_it_takes_no_time(self):
        self.assertLess(self.end(self.serve()), 0.7)
        self.assertLess(self.end(self.serve("--demo", DEMO)), 1.5)

    def test_a_second_signal_ends_it_at_once(self):
        server = self.serve("--remote", "audio", *LONG_HEARTBEAT)
        with component_client(server, "audio") as process:  # which never answers
            server.process.terminate()
            self.assertEqual(process.next("call")["operation"], "stop")
            time.sleep(0.2)
            self.end(server, within=0.5, status=-signal.SIGTERM)
        server = self.serve("--remote", "audio", *LONG_HEARTBEAT)
        with component_client(server, "audio") as process:
            server.process.send_signal(signal.SIGINT)  # as a terminal, and then a script that it has interrupted, too
            process.next("call")
            self.assertGreater(self.end(server), 1)

    def test_clients_that_take_nothing_and_floods_keep_nobody(self):
        server = self.serve("--demo", DEMO)
        core = server.core(moving(speed=0.05))
        server.wait(core, lambda c: c["step"] > 0)
        deaf = [server.stream() for _ in range(3)]
        for each in deaf:
            each.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            for channel in ("cell/pose", "cores", "log", f"core/{core}/state"):
                each.subscribe(channel)
        half = [socket.create_connection(("127.0.0.1", server.port)) for _ in range(20)]
        for each in half:
            each.sendall(b"PUT /api/v1/documents/half HTTP/1.1\r\nHost: localhost\r\nContent-Le")
        over = threading.Event()

        def flood():
            while not over.is_set():
                try:
                    with socket.create_connection(("127.0.0.1", server.port), timeout=1) as connection:
                        connection.sendall(f"GET /api/v1/documents HTTP/1.1\r\nHost: localhost:{server.port}\r\n\r\n".encode() * 50)
                        while connection.recv(65536):
                            pass
                except OSError:
                    pass
        threads = [threading.Thread(target=flood, daemon=True) for _ in range(8)]
        for thread in threads:
            thread.start()
        time.sleep(1)
        try:
            self.end(server)
        finally:
            over.set()
            for thread in threads:
                thread.join(TIMEOUT)
            for each in half:
                each.close()
            for each in deaf:
                each.close()

    def test_what_was_acknowledged_is_there(self):
        server = self.serve()
        server.put("/documents/edited", models.ticking("edited"), "document_entry")
        acknowledged, stored, over = [], [], threading.Event()

        def edit(author):
            number = 0
            while not over.is_set():
                number += 1
                document = models.ticking(f"{author}-{number}")
                try:
                    status, _ = server.request("PUT", f"/api/v1/documents/{document['name']}", document)
                    again, entry = server.request("PUT", "/api/v1/documents/edited", models.ticking("edited", last=number * 10 + 5))
                except OSError:
                    return
                except (ValueError, AssertionError):  # half an answer
                    return
                if status in (200, 201):
                    acknowledged.append(document["name"])
                if again == 200:
                    stored.append(entry["revision"])
        threads = [threading.Thread(target=edit, args=(f"author{number}",)) for number in range(4)]
        for thread in threads:
            thread.start()
        time.sleep(0.7)
        server.wait_for(lambda: len(acknowledged) > 10)
        self.end(server)
        over.set()
        for thread in threads:
            thread.join(TIMEOUT)
        self.assertGreater(len(acknowledged), 10)
        server = self.serve()
        for name in acknowledged:
            server.get(f"/documents/{name}", "document_entry")
        self.assertGreaterEqual(server.get("/documents/edited", "document_entry")["revision"], max(stored))
        self.end(server)


class Motions(Case):
    def assert_stands_when_closed(self, server, task):
        """The arm moves by the task; after SIGTERM it has stopped while the server still tells its poses."""
        arm = Arm(server)
        self.addCleanup(arm.close)
        core = server.core(task)
        arm.wait(moving=True)
        self.end_seen(server)
        messages, code, reason = self.last_words(arm.stream)
        self.assertEqual((code, reason), (1001, "the server ends"))
        poses = [m["data"] for m in messages if m["channel"] == "cell/pose"]
        self.assertGreater(len(poses), 5, "it is seen to stop")
        last, before = poses[-1]["joints"], poses[-4]["joints"]
        self.assertLess(max(abs(last[joint] - before[joint]) for joint in last), 1e-3, "it stands")
        self.assertEqual(server.process.wait(TIMEOUT), 0)
        return core

    @staticmethod
    def end_seen(server):
        server.process.terminate()

    def assert_nothing_moves_after_a_restart(self, core, *options):
        server = self.serve(*options)
        state = server.get(f"/cores/{core}", "core")
        self.assertEqual((state["status"], state["interruption"]["reason"]), ("interrupted", "restart"))
        self.assertIsNone(server.get("/control", "control")["stopped"])
        return server

    def test_in_its_own_world(self):
        for task in (moving(speed=0.2), insisting()):
            core = self.assert_stands_when_closed(self.serve("--demo", DEMO), task)
            server = self.assert_nothing_moves_after_a_restart(core, "--demo", DEMO)
            arm = Arm(server)
            arm.stands_for(0.5)
            arm.close()
            server.post(f"/cores/{core}/stop", None, "core")
            self.end(server)

    def test_in_a_process_of_its_own(self):
        for task in (moving(speed=0.2), insisting()):
            server = self.serve("--remote", "cell", *LONG_HEARTBEAT)
            with ComponentProcess(server, "cell", "--folder", DEMO):
                wait_available(server, "robot")
                core = self.assert_stands_when_closed(server, task)
            self.end(self.assert_nothing_moves_after_a_restart(core, "--remote", "cell"))

    def test_a_process_is_told_to_stop_and_waited_for(self):
        server = self.serve("--remote", "audio", *LONG_HEARTBEAT)
        with component_client(server, "audio") as process:
            server.process.terminate()
            call = process.next("call")
            self.assertEqual(call["operation"], "stop")
            time.sleep(0.5)
            self.assertIsNone(server.process.poll(), "it waits for the answer")
            begin = time.monotonic()
            process.send_checked({"type": "transition", "key": "audio", "id": "stop_idle", "call": call["call"]})
            process.send_checked({"type": "result", "key": "audio", "call": call["call"], "value": None})
            server.process.wait(TIMEOUT)
            self.assertLess(time.monotonic() - begin, 1)
            self.assertEqual(server.process.returncode, 0)


class Hangs(Case):
    def test_a_disk_that_hangs_ends_it_as_after_a_crash_and_it_says_so(self):
        server = self.serve()
        server.put("/documents/kept", models.ticking("kept"), "document_entry")
        self.end(server)
        with TracedServer(self.data, "delay_enter=15000000:when=1+", ("fdatasync",), STORE) as traced, Connection(traced.port) as client:
            def put():
                with contextlib.suppress(OSError):
                    client.request("PUT", "/documents/lost", models.ticking("lost"))
            asking = threading.Thread(target=put)
            asking.start()
            asking.join(1)
            self.assertTrue(asking.is_alive(), "the disk hangs")
            begin = time.monotonic()
            traced.process.terminate()
            said = next((line for line in traced.process.stderr if line.startswith("race:")), "")
            took = time.monotonic() - begin
            asking.join(TIMEOUT)
            status, _ = traced.ended()  # strace lets it go when its delay is over
        print(f"ended after {took:.1f} s", flush=True)
        self.assertEqual(status, 1)
        self.assertEqual(said, "race: the disk or a service does not let the server end; it ends as it is\n")
        self.assertLess(took, IN_TIME)
        server = self.serve()
        server.get("/documents/kept", "document_entry")
        self.end(server)

    def test_the_process_of_a_service_that_is_halted_keeps_nobody(self):
        server = self.serve("--remote", "cell", *LONG_HEARTBEAT)
        with ComponentProcess(server, "cell", "--folder", DEMO) as cell:
            wait_available(server, "robot")
            core = server.core(moving(speed=0.2))
            server.wait(core, lambda c: c["step"] > 0)
            cell.process.send_signal(signal.SIGSTOP)
            try:
                self.assertGreater(self.end(server), 1, "it waits for the answer of what is safe")
            finally:
                cell.process.send_signal(signal.SIGCONT)


class ServiceManager(Case):
    def test_is_told_when_it_serves_and_when_it_ends(self):
        for abstract in (False, True):
            name = f"{self.data}/notify" if not abstract else f"\0race-test-{os.getpid()}"
            with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
                manager.bind(name)
                manager.settimeout(TIMEOUT)
                environment = {**os.environ, "NOTIFY_SOCKET": name.replace("\0", "@")}
                command = [PROGRAM, "serve", "--port", "0", "--data", f"{self.data}/kept"]
                with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as process:
                    try:
                        state = manager.recv(100)
                    except TimeoutError:
                        process.kill()
                        raise
                    self.assertEqual(state, b"READY=1")
                    port = int(re.search(r":(\d+)$", process.stdout.readline().strip())[1])
                    with socket.create_connection(("127.0.0.1", port)):
                        process.terminate()
                        self.assertEqual(manager.recv(100), b"STOPPING=1")
                    self.assertEqual(process.wait(TIMEOUT), 0)

    def test_one_that_is_not_there_keeps_nobody(self):
        for name in ("", "/", "relative", "/nowhere/at/all", "@nobody", "/" + "x" * 300):
            command = [PROGRAM, "serve", "--port", "0", "--data", f"{self.data}/kept"]
            with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env={**os.environ, "NOTIFY_SOCKET": name}) as process:
                self.assertIn("race listens", process.stdout.readline())
                process.terminate()
                self.assertEqual(process.wait(TIMEOUT), 0)


if __name__ == "__main__":
    unittest.main()
