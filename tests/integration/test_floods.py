"""Clients that flood the stream, and processes of services that flood the cores: the server's memory stays bounded, and
others are served meanwhile.

RACE_FLOOD says for how many seconds each flood lasts (5).
"""
import json
import os
import re
import socket
import threading
import time
import unittest
from pathlib import Path

import models
from client import Server, Stream
from component_process import LONG_HEARTBEAT, ComponentClient, service, wait_available

SECONDS = float(os.environ.get("RACE_FLOOD", "5"))
CEILING = 150e6  # [bytes] that the server may grow by


def resident(server):
    """[bytes]"""
    status = Path(f"/proc/{server.process.pid}/status").read_text()
    return 1024 * int(re.search(r"VmRSS:\s*(\d+)", status).group(1))


class Flood(threading.Thread):
    """A client that says what messages() gives, one after the other, and never reads."""

    def __init__(self, stream, messages):
        super().__init__()
        self.stream = stream
        self.stream.socket.settimeout(0.2)
        self.messages = messages
        self.said = 0
        self.refused = False

    def run(self):
        end = time.monotonic() + SECONDS
        # Many messages in one write: the server has to be busier than this client.
        for message in self.messages:
            if time.monotonic() > end:
                return
            self.stream.protocol.send_text(message.encode())
            self.said += 1
            if self.said % 200 == 0 and not self.write(b"".join(self.stream.protocol.data_to_send()), end):
                return

    def write(self, data, end):
        """False: the time is over, or the server has closed the connection."""
        while data and time.monotonic() < end:
            try:
                data = data[self.stream.socket.send(data):]
            except TimeoutError:  # it has to wait: so it should be
                pass
            except OSError:
                self.refused = True
                return False
        return not data


def is_open(connection):
    """Whether the other side has not closed it; nothing is read."""
    return connection.getsockopt(socket.IPPROTO_TCP, socket.TCP_INFO, 1)[0] == 1  # TCP_ESTABLISHED


def forever(*messages):
    while True:
        yield from messages


def subscribe(channel):
    return f'{{"type": "subscribe", "channel": "{channel}"}}'


def unsubscribe(channel):
    return f'{{"type": "unsubscribe", "channel": "{channel}"}}'


def watch(server, floods):
    """Until they have ended: the most memory that the server had [bytes], the longest answer of its health [s]."""
    for flood in floods:
        flood.start()
    most, slowest = resident(server), 0
    while any(flood.is_alive() for flood in floods):
        asked = time.monotonic()
        server.get("/health", "health")
        slowest = max(slowest, time.monotonic() - asked)
        most = max(most, resident(server))
        time.sleep(0.1)
    for flood in floods:
        flood.join()
        flood.stream.close()
    return most, slowest


class ProcessFlood(unittest.TestCase):
    """A process of a service says events as fast as it can, to a core that takes each in a macro step of its own."""

    COUNTING = models.document("count", {
        "state": "Root", "variables": [{"name": "n", "initial": 0}],
        "actions": [{"when": "svc.display.button", "do": "var.n = var.n + 1"}]}, services={"display": "display"})

    def connect(self, server):
        client = ComponentClient(server.port)
        rsm = service(server, "display")["rsm"]
        client.send_checked({"type": "hello", "protocol": 1, "components": [{"key": "display", "type": "display", "rsm": rsm}]})
        client.next("welcome")
        wait_available(server, "display")
        return client

    def flood(self, paused):
        server = Server("--remote", "display", *LONG_HEARTBEAT)
        self.addCleanup(server.process.kill)
        client = self.connect(server)
        core = server.core(self.COUNTING)
        if paused:
            server.post(f"/cores/{core}/pause")
        before = resident(server)
        event = json.dumps({"type": "event", "key": "display", "name": "button",
                            "data": {"button": "x" * 200, "display": "main"}})
        process = Flood(client, forever(event))
        most, slowest = watch(server, [process])
        info = server.get(f"/cores/{core}", "core")
        begun = time.monotonic()
        server.stop()
        ended = time.monotonic() - begun
        print(f"{self.id().rpartition('.')[2]}: {process.said} events, +{(most - before) / 1e6:.0f} MB, health within "
              f"{1000 * slowest:.0f} ms, {info['status']} at {info['step']}, {info['waiting']} wait, ends in {ended:.1f} s", flush=True)
        self.assertGreater(process.said, 10_000, "that is no flood")
        self.assertLess(most - before, CEILING)
        self.assertLess(ended, 5)
        return info

    def test_a_core_that_runs_keeps_up_or_is_interrupted(self):
        info = self.flood(paused=False)
        self.assertGreater(info["step"], 1000)
        if info["status"] == "interrupted":
            self.assertEqual(info["interruption"]["reason"], "overload")

    def test_a_core_that_is_paused_is_interrupted(self):
        info = self.flood(paused=True)
        self.assertEqual((info["status"], info["interruption"]["reason"]), ("interrupted", "overload"))
        self.assertLessEqual(info["waiting"], 10_000)


class FloodTest(unittest.TestCase):
    def flood(self, messages, clients=2):
        """How many messages were said while the server stayed within its bounds."""
        with Server() as server:
            large = models.storing("large")
            core = server.core(large, {"value": ["x" * 1000] * 300}, start=False)
            before = resident(server)
            floods = [Flood(Stream(server.port), messages(core, i)) for i in range(clients)]
            most, slowest = watch(server, floods)
            said = sum(flood.said for flood in floods)
            print(f"{self.id().rpartition('.')[2]}: {said} messages, +{(most - before) / 1e6:.0f} MB, "
                  f"health within {1000 * slowest:.0f} ms", flush=True)
            self.assertLess(most - before, CEILING)
            self.assertGreater(said, 1000, "that is no flood")
            with server.stream() as stream:  # it serves others as before
                stream.subscribe(f"core/{core}/state")
                self.assertEqual(stream.message()["kind"], "snapshot")

    def test_one_channel_again_and_again(self):
        self.flood(lambda core, i: forever(subscribe(f"core/{core}/state")))

    def test_a_channel_joined_and_left(self):
        self.flood(lambda core, i: forever(subscribe(f"core/{core}/state"), unsubscribe(f"core/{core}/state"),
                                           subscribe(f"core/{core}/derivation"), unsubscribe(f"core/{core}/derivation")))

    def test_other_names_of_one_channel(self):
        self.flood(lambda core, i: (subscribe(f"core/{'0' * (n % 5000)}{core}/state") for n in range(10**9)))

    def test_channels_that_are_not_there(self):
        self.flood(lambda core, i: (subscribe(f"document/nothing{i}x{n}") for n in range(10**9)))

    def test_who_does_not_read_is_cut(self):
        with Server() as server:
            core = server.core(models.storing("large"), {"value": ["x" * 1000] * 900}, start=False)
            with server.stream() as silent:
                for _ in range(40):  # until the buffers of its socket are full
                    silent.subscribe(f"core/{core}/state")
                    time.sleep(0.05)
                asked = time.monotonic()
                while time.monotonic() - asked < 20 and is_open(silent.socket):
                    time.sleep(0.2)
                took = time.monotonic() - asked
                print(f"cut after {took:.0f} s", flush=True)
                self.assertLess(took, 20)
                self.assertGreater(took, 5, "a client may be slow for some seconds")

    def test_messages_that_are_none(self):
        self.flood(lambda core, i: forever('{"type": "nothing"}'))


if __name__ == "__main__":
    unittest.main()
