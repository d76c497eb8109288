"""Thousands of calls that wait for a service that answers none: what one more costs does not depend on how many wait, the
cell keeps real time, and at their bound they are refused.
"""
import json
import time
import unittest

import models
from client import Server
from component_process import LONG_HEARTBEAT, component_client, service, wait_available, wait_until

MOST = 10_000  # calls of a service that may wait
CALLS = 500  # of the task at each event

ASKING = models.document("asking", {
    "state": "Root", "results": [{"name": "code"}],
    "actions": [{"when": "svc.display.button", "do": f"for i in range({CALLS}):\n    svc.display.clear()"},
                {"when": "svc.display.clear.error", "do": "res.code = svc.display.clear.error.code"}],
    "ports": [{"name": "refused", "when": "available(res.code)"}]}, services={"display": "display"})


class PendingCalls(unittest.TestCase):
    def setUp(self):
        self.server = Server("--remote", "display", *LONG_HEARTBEAT)
        self.addCleanup(self.server.stop)
        self.process = component_client(self.server, "display")  # which hears the calls and answers none
        self.addCleanup(self.process.close)
        wait_available(self.server, "display")
        self.core = self.server.core(ASKING)

    def pending(self):
        services = self.server.get("/services")["services"]
        return next(each for each in services if each["key"] == "display")["pending_count"]

    def call(self, until):
        """The task calls until so many calls wait; returns for how long [s]."""
        event = json.dumps({"type": "event", "key": "display", "name": "button", "data": {"button": "x", "display": "main"}})
        begun = time.monotonic()
        for _ in range((until - self.pending()) // CALLS):
            self.process.send(event)
        wait_until(lambda: self.pending() == until)
        return time.monotonic() - begun

    def test_twice_as_many_take_twice_as_long_and_the_cell_keeps_real_time(self):
        late = self.server.core(models.waiting(0.5), start=False)
        first = self.call(MOST // 2)
        begun = time.monotonic()
        self.server.post(f"/cores/{late}/start")
        second = self.call(MOST)
        self.server.ended(late)
        waited = time.monotonic() - begun
        print(f"{MOST // 2} calls in {first:.2f} s, as many again in {second:.2f} s, half a second of the cell in {waited:.2f} s",
              flush=True)
        self.assertLess(second, 2 * first + 1)
        self.assertLess(waited, 3)
        self.assertEqual(len(service(self.server, "display")["pending"]), 32)

    def test_more_are_refused_and_a_process_that_ends_answers_all(self):
        self.call(MOST)
        core = self.server.core(models.calling("display", "clear", name="one_more"))
        self.assertEqual(self.server.ended(core)["results"], {"code": "unavailable"})
        self.assertEqual(self.pending(), MOST)
        self.process.close()
        self.assertEqual(self.server.ended(self.core)["results"], {"code": "unavailable"})
        self.assertEqual(self.pending(), 0)


if __name__ == "__main__":
    unittest.main()
