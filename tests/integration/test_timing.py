"""When what happened in a run, and what waited at an earlier moment: live, stored, and of a run of another server."""
import hashlib
import json
import shutil
import tempfile
import time
import unittest
from itertools import pairwise

import models
from client import Server

SECOND = 1_000_000
WAIT = 0.3  # [s]


def waiting_once(name="once"):
    """Waits once, and ends."""
    return models.document(name, {
        "state": "Root", "entry": f"svc.timer.wait({WAIT})", "ports": [{"name": "done", "when": "svc.timer.wait.result"}]})


def two_waits(name="both"):
    """Two calls whose answers come while the run is paused, each in a macro step of its own."""
    def wait(me, seconds):
        return {"state": me, "entry": f"svc.timer.wait({seconds})",
                "ports": [{"name": "done", "when": "svc.timer.wait.result", "to": "Join"}]}
    return models.document(name, {
        "state": "Root", "first": "Split",
        "children": [{"barrier": "Split", "to": ["A", "B"]}, wait("A", 0.1), wait("B", 0.2),
                     {"barrier": "Join", "to": ["After"]}, {"state": "After"}]})


class Timing(unittest.TestCase):
    def setUp(self):
        self.data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, self.data)

    def times(self, server, run):
        return server.get(f"/runs/{run}/timing", "timing")

    def check_times(self, timing, steps, least, most):
        """The answer came after the call by so much [s]."""
        self.assertEqual([step["step"] for step in timing["steps"]], list(range(1, steps + 1)))
        self.assertTrue(all(earlier["time"] <= later["time"] for earlier, later in pairwise(timing["steps"])))
        called, answered = timing["steps"][0], timing["steps"][-1]
        self.assertNotIn("arrived", called)
        self.assertLessEqual(answered["arrived"], answered["time"])
        took = (answered["arrived"] - called["time"]) / SECOND
        self.assertGreaterEqual(took, least)
        self.assertLessEqual(took, most)
        self.assertGreaterEqual(timing["until"], answered["time"])

    def test_a_call_lasts_as_long_as_it_took(self):
        with Server(data=self.data) as server:
            begin = time.monotonic()
            core = server.core(waiting_once())
            steps = server.ended(core)["step"]
            live = self.times(server, core)
            self.check_times(live, steps, WAIT - 0.01, time.monotonic() - begin)
            run = server.get(f"/runs/{core}", "run")
            self.assertLessEqual(live["steps"][-1]["time"] / 1000, run["ended"] - run["created"] + 2)
            server.expect("DELETE", f"/cores/{core}", None, "core", 200)
            self.assertEqual(self.times(server, core)["steps"], live["steps"])
            self.assertEqual(server.get(f"/runs/{core}/timing?from=2&to=2", "timing")["steps"], live["steps"][1:2])
            for query in ("from=0", "from=3&to=2", f"to={steps + 1}", "from=x"):
                server.get(f"/runs/{core}/timing?{query}", status=400)
            server.get("/runs/99/timing", status=404)
            file = server.get(f"/runs/{core}/export", "run_file")
        with Server() as other:  # also with those of its file
            imported = other.post("/runs", file, "run", 201)["id"]
            self.assertEqual(self.times(other, imported)["steps"], live["steps"])
            self.assertEqual(other.get(f"/runs/{imported}/export", "run_file")["timing"], file["timing"])
            timeless = {key: value for key, value in file.items() if key != "timing"}
            unknown = other.post("/runs", timeless, "run", 201)["id"]
            self.assertEqual(self.times(other, unknown), {"steps": [], "services": [], "until": 0})
            self.assertNotIn("waiting", other.get(f"/runs/{unknown}/past?step=1", "past"))
            self.assertEqual(other.get(f"/runs/{imported}/past?step=1", "past")["waiting"]["count"], 1)
        with Server(data=self.data) as again:
            self.assertEqual(self.times(again, core)["steps"], live["steps"])

    def seen(self, server, core):
        now = server.get(f"/cores/{core}", "core")
        past = server.get(f"/cores/{core}/past?step={now['step']}" + (f"&micro={now['micro']}" if now["micro"] else ""), "past")
        return (past["step"], past["micro"]), now["waiting"], past["waiting"]

    def test_what_waited_is_what_was_seen_then(self):
        with Server(data=self.data) as server:
            core = server.core(two_waits(), start=False)
            server.post(f"/cores/{core}/pause", None, "core")
            server.post(f"/cores/{core}/start", None, "core")
            server.post(f"/cores/{core}/step", {"kind": "micro"}, "core")
            while not server.get(f"/cores/{core}/past?step=1", "past")["open_calls"]:
                server.post(f"/cores/{core}/step", {"kind": "micro"}, "core")
            seen = {}
            for _ in range(100):
                if server.get(f"/cores/{core}", "core")["step"] == 1:
                    server.wait(core, lambda c: c["waiting"] == 2)  # both have come in the first macro step
                moment, live, then = self.seen(server, core)
                self.assertEqual(then["count"], live)
                self.assertEqual(len(then["inputs"]), live)
                texts = "".join(json.dumps(each["input"], separators=(",", ":"), ensure_ascii=False) + "\n" for each in then["inputs"])
                self.assertEqual(then["digest"], hashlib.sha256(texts.encode()).hexdigest())
                seen[moment] = then
                if moment[0] == 3:
                    break
                server.post(f"/cores/{core}/step", {"kind": "micro"}, "core")
                server.wait(core, lambda c: not c["stepping"])
            self.assertEqual({waiting["count"] for waiting in seen.values()}, {0, 1, 2})
            server.post(f"/cores/{core}/stop", None, "core")
            server.expect("DELETE", f"/cores/{core}", None, "core", 200)
        with Server(data=self.data) as server:  # and they are the same when all of it is past
            for (step, micro), then in seen.items():
                back = server.get(f"/runs/{core}/past?step={step}&micro={micro}", "past")["waiting"]
                self.assertEqual((back["count"], back["digest"]), (then["count"], then["digest"]), (step, micro))
                self.assertEqual([each["time"] for each in back["inputs"]], [each["time"] for each in then["inputs"]])
            first = server.get(f"/runs/{core}/past?step=1", "past")["waiting"]
            self.assertEqual([each["step"] for each in first["inputs"]], [2, 3])

    def test_what_a_crash_takes_with_it_is_not_known(self):
        server = Server(data=self.data)
        self.addCleanup(server.kill)
        core = server.core(two_waits(), start=False)
        server.post(f"/cores/{core}/pause", None, "core")
        server.post(f"/cores/{core}/start", None, "core")
        server.post(f"/cores/{core}/step", {"kind": "macro"}, "core")
        server.wait(core, lambda c: c["waiting"] == 2)
        self.assertEqual(server.get(f"/cores/{core}/past?step=1&micro=0", "past")["waiting"]["count"], 0)
        server.kill()
        with Server(data=self.data) as server:
            self.assertNotIn("waiting", server.get(f"/cores/{core}/past?step=1&micro=0", "past"))
            now = server.get(f"/cores/{core}/past?step=1", "past")["waiting"]  # the calls are lost (R7)
            self.assertEqual([each["input"]["error"]["code"] for each in now["inputs"]], ["unavailable"] * 2)
            self.assertEqual(self.times(server, core)["steps"], [])


class Why(unittest.TestCase):
    def test_a_stored_run_explains_its_ports_as_its_core_did(self):
        with Server() as server:
            core = server.core(models.ticking("why", last=3))
            server.ended(core)
            questions = [f"why?port=Root/{port}{at}" for port in ("Ping.next", "Pong.next")
                         for at in ("", "&step=2&micro=0", "&step=3&micro=0")]
            answers = [server.get(f"/cores/{core}/{question}", "why") for question in [*questions, "why?port=Root.done"]]
            server.expect("DELETE", f"/cores/{core}", None, "core", 200)
            self.assertEqual([server.get(f"/runs/{core}/{question}", "why") for question in [*questions, "why?port=Root.done"]], answers)
            self.assertTrue(answers[-1]["active"])
            for question, status in (("port=Root.other", 404), ("", 422), ("port=Root.done&step=1", 422),
                                     ("port=Root.done&step=99&micro=0", 400)):
                server.get(f"/runs/{core}/why?{question}", status=status)
            server.get("/runs/99/why?port=Root.done", status=404)


if __name__ == "__main__":
    unittest.main()
