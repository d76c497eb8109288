"""Clients that flood the stream or read nothing, and processes of services that flood the cores: the server's memory stays
bounded, others are served meanwhile, and SIGTERM ends the server while the flood goes on.

Each flood has a server of its own; they last RACE_FLOOD seconds each (20), beside each other.
"""
import itertools
import os
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import models
from client import Server, Stream
from component_process import LONG_HEARTBEAT
from floods import COUNTING, Flood, display_process, is_open, resident, subscribe, unsubscribe

SECONDS = float(os.environ.get("RACE_FLOOD", "20"))
CEILING = 150e6  # [bytes] that the server may grow by
CEILING_OF_MESSAGES = 300e6  # with what messages of the stream may take (server/stream/hub.h: kMaxBytes)
END = 10  # [s] from SIGTERM to the end: it takes one, and some when ten servers and their floods share two processors


class Crowd(threading.Thread):
    """Clients that ask for the states of cores again and again and read nothing; who is refused comes again."""

    def __init__(self, server, cores, clients):
        super().__init__(daemon=True)
        self.server, self.clients = server, clients
        self.messages = itertools.cycle([subscribe(f"core/{core}/state") for core in cores])
        self.over = threading.Event()
        self.refused = False
        self.said = 0

    def run(self):
        streams = [None] * self.clients
        for i, message in zip(itertools.cycle(range(self.clients)), self.messages):
            if self.over.is_set():
                break
            try:
                if streams[i] is None:
                    streams[i] = Stream(self.server.port)
                    streams[i].socket.settimeout(0.2)
                streams[i].send(message)
                self.said += 1
            except OSError:
                if streams[i] is not None:
                    streams[i].close()
                streams[i] = None
        for stream in filter(None, streams):
            stream.close()

    def end(self):
        self.over.set()
        self.join()


@dataclass
class Result:
    said: int = 0
    refused: bool = False  # all floods were
    grown: float = 0  # [bytes] at most
    slowest: float = 0  # [s] answer of the health
    ended: float = 0  # [s] from SIGTERM on, with the flood going on
    core: dict = field(default_factory=dict)  # in the end

    def __str__(self):
        core = f", {self.core['status']} at {self.core['step']}, {self.core['waiting']} wait" if self.core else ""
        return (f"{self.said:.0f} messages, +{self.grown / 1e6:.0f} MB, health within {1000 * self.slowest:.0f} ms, "
                f"ends in {self.ended:.1f} s{core}")


def measure(server, floods, core=None):
    """What happens during the floods; ends the server."""
    result, before = Result(), resident(server)
    end = time.monotonic() + SECONDS
    for flood in floods:
        flood.start()
    while time.monotonic() < end and any(flood.is_alive() for flood in floods):
        asked = time.monotonic()
        server.get("/health", "health")
        result.slowest = max(result.slowest, time.monotonic() - asked)
        result.grown = max(result.grown, resident(server) - before)
        time.sleep(0.1)
    if core:
        result.core = server.get(f"/cores/{core}", "core")
    result.refused = all(flood.refused for flood in floods)
    asked = time.monotonic()
    server.stop()
    result.ended = time.monotonic() - asked
    for flood in floods:
        flood.end()
    result.said = sum(flood.said for flood in floods)
    return result


def pulse():
    """Has a large state, its argument, and changes all the time."""
    return models.document("pulse", {
        "state": "Root", "parameters": [{"name": "value"}], "first": "A",
        "children": [{"state": name, "ports": [{"name": "next", "after": "0.05", "to": other}]}
                     for name, other in ("AB", "BA")]})


def by_clients(messages, clients=2):
    """Of clients of the stream: messages(core, i) are those of client i. Others are served meanwhile."""
    server = Server()
    try:
        core = server.core(pulse(), {"value": ["x" * 1000] * 300})
        floods = [Flood(Stream(server.port), messages(core, i)) for i in range(clients)]
        # Before the floods are cut, which read nothing: after 10 s, and with the last of them this ends.
        served = threading.Timer(min(SECONDS / 2, 5), lambda: others.append(state_of(server, core)))
        others = []
        served.start()
        result = measure(server, floods)
        served.join()
        assert others == ["snapshot"], others
        return result
    finally:
        server.process.kill()


def state_of(server, core):
    """What comes first of a core's state."""
    with server.stream() as stream:
        stream.subscribe(f"core/{core}/state")
        return stream.message()["kind"]


def by_a_crowd():
    """Of clients that read nothing of large states, which change all the time: no two have the same messages."""
    server = Server()
    try:
        cores = [server.core(pulse(), {"value": ["x" * 1000] * 900}) for _ in range(9)]
        return measure(server, [Crowd(server, cores, 100)])
    finally:
        server.process.kill()


def by_a_process(*heartbeat, paused=False):
    """Of a process of a service that says events to a core."""
    server = Server("--remote", "display", *heartbeat)
    try:
        flood = Flood(*display_process(server))
        core = server.core(COUNTING)
        if paused:
            server.post(f"/cores/{core}/pause")
        return measure(server, [flood], core)
    finally:
        server.process.kill()


def by_silence():
    """How long a client stays connected that has asked for much and reads nothing [s]."""
    with Server() as server:
        core = server.core(models.storing("large"), {"value": ["x" * 1000] * 900}, start=False)
        with server.stream() as silent:
            for _ in range(40):  # until the buffers of its socket are full
                silent.subscribe(f"core/{core}/state")
                time.sleep(0.05)
            asked = time.monotonic()
            while time.monotonic() - asked < 20 and is_open(silent.socket):
                time.sleep(0.2)
            return time.monotonic() - asked


FLOODS = {
    "one_channel_again_and_again": lambda: by_clients(lambda core, i: [subscribe(f"core/{core}/state")] * 1000),
    "a_channel_joined_and_left": lambda: by_clients(
        lambda core, i: [say(f"core/{core}/{channel}") for channel in ("state", "derivation")
                         for say in (subscribe, unsubscribe)] * 500),
    "other_names_of_one_channel": lambda: by_clients(
        lambda core, i: [subscribe(f"core/{'0' * n}{core}/state") for n in range(5000)]),
    "channels_that_are_not_there": lambda: by_clients(
        lambda core, i: [subscribe(f"document/nothing{i}x{n}") for n in range(20_000)]),
    "messages_that_are_none": lambda: by_clients(lambda core, i: ['{"type": "nothing"}'] * 1000),
    "a_crowd_that_reads_nothing": by_a_crowd,
    "events_to_a_core_that_runs": lambda: by_a_process(*LONG_HEARTBEAT),
    "events_to_a_core_that_is_paused": lambda: by_a_process(*LONG_HEARTBEAT, paused=True),
    "events_without_a_sign_of_life": lambda: by_a_process("--heartbeat", "1"),
    "silence": by_silence,
}


class FloodsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        pool = ThreadPoolExecutor(len(FLOODS))

        def begin(number, flood):
            time.sleep(0.5 * number)  # so that they end one after the other: the end is timed
            return flood()

        cls.results = {name: pool.submit(begin, number, flood) for number, (name, flood) in enumerate(FLOODS.items())}
        pool.shutdown(wait=False)

    def result(self, name, ceiling=CEILING, least=1000):
        """Of a flood of at least so many messages; the server kept its bounds."""
        result = self.results[name].result()
        print(f"{name}: {result}", flush=True)
        self.assertGreater(result.said, least, "that is no flood")
        self.assertLess(result.grown, ceiling)
        self.assertLess(result.ended, END)
        return result

    def test_one_channel_again_and_again(self):
        self.result("one_channel_again_and_again")

    def test_a_channel_joined_and_left(self):
        self.result("a_channel_joined_and_left")

    def test_other_names_of_one_channel(self):
        self.result("other_names_of_one_channel")

    def test_channels_that_are_not_there(self):
        self.result("channels_that_are_not_there")

    def test_messages_that_are_none(self):
        self.result("messages_that_are_none")

    def test_a_crowd_that_reads_nothing(self):
        self.result("a_crowd_that_reads_nothing", CEILING_OF_MESSAGES)

    def test_a_core_that_runs_keeps_up_or_is_interrupted(self):
        core = self.result("events_to_a_core_that_runs", least=10_000).core
        self.assertGreater(core["step"], 1000)
        if core["status"] == "interrupted":
            self.assertEqual(core["interruption"]["reason"], "overload")

    def test_a_core_that_is_paused_is_interrupted(self):
        core = self.result("events_to_a_core_that_is_paused", least=10_000).core
        self.assertEqual((core["status"], core["interruption"]["reason"]), ("interrupted", "overload"))
        self.assertLessEqual(core["waiting"], 10_000)

    def test_a_process_that_gives_no_sign_of_life_is_lost(self):
        self.assertTrue(self.result("events_without_a_sign_of_life").refused)

    def test_who_does_not_read_is_cut(self):
        took = self.results["silence"].result()
        print(f"cut after {took:.0f} s", flush=True)
        self.assertLess(took, 20)
        self.assertGreater(took, 5, "a client may be slow for some seconds")


if __name__ == "__main__":
    unittest.main()
