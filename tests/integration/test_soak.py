"""The demonstrator, unattended and over and over again, with a page that watches it: the server's memory stays what it is.

For RACE_SOAK seconds (600): after the first two minutes, the resident memory grows by 5 % at most. Part of deploy/soak.
"""
import os
import statistics
import threading
import time
import unittest

from cell import BODIES, DEMO, DOCUMENT, NAMES
from client import TIMEOUT, Server
from floods import resident

SECONDS = float(os.environ.get("RACE_SOAK", "600"))
SETTLED = 120  # [s] until the memory is what it stays
WINDOW = 120  # [s]: figures are medians of that; a run, whose parts need more and less, takes some 95 s
GROWTH = 1.05
RUN = 300  # [s] that one may take


class Page(threading.Thread):
    """Watches a core as RACE-Pro does, until it is removed."""

    def __init__(self, server, core):
        super().__init__(daemon=True)
        self.stream = server.stream()
        for channel in (f"core/{core}/state", f"core/{core}/derivation", "cell/pose", "log", "services", "cores"):
            self.stream.send({"type": "subscribe", "channel": channel})
        self.messages, self.over = 0, False
        self.start()

    def run(self):
        while not self.over:
            self.stream.receive()
            self.messages += 1

    def end(self):
        """How many messages it got."""
        self.over = True  # poses come until then
        self.join(TIMEOUT)
        self.stream.close()
        return self.messages


class Memory(threading.Thread):
    """The resident memory of the server, once a second: (seconds since the beginning, bytes)."""

    def __init__(self, server):
        super().__init__(daemon=True)
        self.server, self.samples, self.over = server, [], threading.Event()
        self.begun = time.monotonic()
        self.start()

    def run(self):
        while not self.over.wait(1):
            self.samples.append((time.monotonic() - self.begun, resident(self.server)))

    def median(self, begin):
        """Of the window that begins then."""
        return statistics.median(bytes for at, bytes in self.samples if begin <= at < begin + WINDOW)


def put_parts_back(server):
    for name in NAMES.values():
        server.post("/cell/person", {"act": "place", "part": name, "pose": BODIES[name]["pose"]})


class Soak(unittest.TestCase):
    def run_once(self, server):
        """Returns how many messages its page got."""
        core = server.core(DOCUMENT)
        page = Page(server, core)
        ended = server.ended(core, RUN)
        self.assertEqual(ended.get("outcome"), "success", ended)
        messages = page.end()
        server.expect("DELETE", f"/cores/{core}", None, None, 200)
        put_parts_back(server)
        return messages

    def test_the_memory_is_flat(self):
        with Server("--demo", str(DEMO), "--operator", str(DEMO / "operator.json")) as server:
            memory, runs, messages = Memory(server), 0, 0
            while time.monotonic() < memory.begun + SECONDS:
                messages += self.run_once(server)
                runs += 1
            memory.over.set()
            memory.join(TIMEOUT)
        last = memory.samples[-1][0]
        before, after = memory.median(SETTLED), memory.median(last - WINDOW)
        most = max(bytes for _, bytes in memory.samples)
        print(f"{runs} runs and {messages} messages in {last:.0f} s: {before / 1e6:.1f} MB in the third and fourth minute, "
              f"{after / 1e6:.1f} MB in the last two, at most {most / 1e6:.1f} MB", flush=True)
        self.assertLessEqual(after, GROWTH * before)
        self.assertGreater(messages, 1000)


if __name__ == "__main__":
    unittest.main()
