"""Operations that requests call: without the controls what moves nothing; within a time, and few at once."""
import concurrent.futures
import time
import unittest

from accounts import AccountServer
from client import PROJECT, Server
from controls import SILENCE, Controls
from motions import HOME, Arm

DEMO = str(PROJECT / "deploy/demo")
MOVE = {"operation": "move", "kwargs": {"target": {"joints": HOME}, "speed": 0.2}}


class CallCase(unittest.TestCase):
    def setUp(self):
        self.server = Server("--demo", DEMO)
        self.addCleanup(self.server.stop)

    def call(self, service, operation, *args, **kwargs):
        body = {"operation": operation, **({"args": args} if args else {}), **({"kwargs": kwargs} if kwargs else {})}
        return self.server.post(f"/services/{service}/calls", body, "service_response")

    def refused(self, service, body, status):
        return self.server.post(f"/services/{service}/calls", body, None, status)["errors"][0]

    def person(self):
        person = Controls(self.server)
        self.addCleanup(person.close)
        return person


class Calls(CallCase):
    def test_are_answered_with_the_response(self):
        self.assertEqual(self.call("db", "add", "greeting", {"text": "hello"}), {"result": "greeting"})
        self.assertEqual(self.call("db", "get", key="greeting"), {"result": {"text": "hello"}})
        self.assertEqual(self.call("db", "get", "nothing")["error"]["code"], "not_found")
        self.assertEqual(self.call("robot", "jump")["error"]["code"], "unavailable")
        self.assertEqual(self.call("db", "get")["error"]["code"], "missing", "an argument")

    def test_that_fit_no_schema_or_service_are_refused(self):
        for body, path in (({}, "operation"), ({"operation": 1}, "operation"), ({"operation": "get", "args": {}}, "args"),
                           ({"operation": "get", "kwargs": []}, "kwargs"), ({"operation": "get", "service": "db"}, "service")):
            self.assertEqual(self.refused("db", body, 422)["path"], path, body)
        for service in ("nobody", "DB", "db%20"):
            self.assertEqual(self.refused(service, {"operation": "get"}, 404)["code"], "not_found")

    def test_a_response_that_is_too_large_is_an_error(self):
        text = "x" * (17 * 1024)
        self.assertEqual(self.call("db", "add", "large", text), {"result": "large"})
        self.assertEqual(self.call("db", "get", "large")["error"]["code"], "too_large")

    def test_one_that_takes_long_is_answered_in_time_and_abandoned(self):
        begun = time.monotonic()
        refused = self.refused("timer", {"operation": "wait", "args": [600]}, 503)
        self.assertEqual(refused["code"], "unavailable")
        self.assertAlmostEqual(time.monotonic() - begun, 5, delta=1.5)
        self.server.wait_for(lambda: not next(s for s in self.server.get("/services")["services"] if s["key"] == "timer")["pending"])

    def test_at_most_16_wait(self):
        with concurrent.futures.ThreadPoolExecutor(40) as clients:
            begun = time.monotonic()
            def wait(_):
                status, answer = self.server.request("POST", "/api/v1/services/timer/calls", {"operation": "wait", "args": [2]})
                return status, status == 503 and time.monotonic() - begun < 1.5, answer
            answers = list(clients.map(wait, range(40)))
        self.assertEqual([status for status, _, _ in answers].count(200), 16, answers)
        self.assertTrue(all(at_once for status, at_once, _ in answers if status == 503), "the others are refused at once")
        self.assertEqual(self.call("timer", "wait", 0)["result"].keys(), {"elapsed"}, "and there is room again")


class Motions(CallCase):
    def setUp(self):
        super().setUp()
        self.arm = Arm(self.server)
        self.addCleanup(self.arm.close)

    def test_what_moves_needs_the_controls(self):
        self.assertEqual(self.refused("robot", MOVE, 409)["code"], "leased")
        status, answer = self.server.request("POST", "/api/v1/services/robot/calls", MOVE, {"Race-Control": "control_" + "x" * 43})
        self.assertEqual((status, answer["errors"][0]["code"]), (409, "leased"))
        self.arm.stands_for(0.5)

    def test_passes_what_a_call_by_hand_does(self):
        person = self.person()
        person.take()
        self.assertEqual(person.request("POST", "/services/robot/calls", MOVE)[1]["error"]["code"], "not_accepted", "in execution mode")
        person.set_mode("programming")
        status, answer = person.request("POST", "/services/robot/calls", MOVE)
        self.assertEqual(status, 200)
        self.assertIn("pose", answer["result"])
        lease = {"service": "robot", "core": f"control/{person.number}"}
        self.assertIn(lease, self.server.get("/control", "control")["leases"])
        self.assertIn("pose", person.call("robot", "move", target={"joints": HOME})["result"], "the same hand")
        self.server.post("/stop")
        self.assertEqual(person.request("POST", "/services/robot/calls", MOVE)[1]["error"]["code"], "stopped")
        self.assertIn("error", person.request("POST", "/services/db/calls", {"operation": "get", "args": ["x"]})[1], "moves nothing")

    def test_ends_with_who_has_the_controls(self):
        person = self.person().programming()
        far = {"operation": "move", "kwargs": {"target": {"joints": [1.2, *HOME[1:]]}, "speed": 0.2}}
        with concurrent.futures.ThreadPoolExecutor(1) as client:
            moving = client.submit(person.request, "POST", "/services/robot/calls", far)
            self.arm.wait(moving=True)
            person.silent()
            self.arm.wait(moving=False)
            status, answer = moving.result()
        self.assertEqual(status, 200)
        self.assertIn("error", answer)
        self.assertEqual(person.request("POST", "/services/robot/calls", far)[0], 409, "they have them no more")
        self.arm.stands_for(0.5)

    def test_a_jog_that_is_held_over_a_stop_moves_nothing(self):
        person = self.person().programming()
        jog = {"operation": "jog", "kwargs": {"joints": [0.3, 0, 0, 0, 0, 0, 0]}}

        def hold(seconds):
            end, answers = time.monotonic() + seconds, []
            while time.monotonic() < end:
                answers.append(person.request("POST", "/services/robot/calls", jog)[0])
                time.sleep(0.05)
            return answers

        self.assertEqual(set(hold(0.7)), {200})
        self.arm.wait(moving=True)
        self.server.post("/stop")
        self.server.post("/stop/reset")
        self.assertEqual(set(hold(0.7)), {409})
        self.arm.wait(moving=False)
        self.arm.stands_for(0.5)

    def test_a_stop_by_a_request_ends_a_jog_that_a_person_holds(self):
        person = self.person().programming()

        def hold(seconds):
            end, codes = time.monotonic() + seconds, []
            while time.monotonic() < end:
                codes.append(person.call("robot", "jog", joints=[0.3, 0, 0, 0, 0, 0, 0]).get("error", {}).get("code"))
                time.sleep(0.05)
            return codes

        with concurrent.futures.ThreadPoolExecutor(1) as hand:
            held = hand.submit(hold, 2)
            self.arm.wait(moving=True)
            self.assertEqual(self.call("robot", "stop"), {"result": None}, "without the controls")
            self.arm.wait(moving=False)
            codes = held.result()
        self.assertIn("stopped", codes)
        self.assertEqual(set(codes[:codes.index("stopped")]), {None})
        self.assertEqual(set(codes[codes.index("stopped"):]), {"stopped"}, "until the button is let go of")
        self.arm.stands_for(0.5)
        time.sleep(2 * SILENCE)  # the poses have come meanwhile
        self.assertEqual(set(hold(0.3)), {None}, "the button was let go of, and pressed again")
        self.arm.wait(moving=True)


class Changes(CallCase):
    def test_what_runs_may_read_is_changed_by_who_has_the_controls_alone(self):
        self.assertEqual(self.call("db", "add", "pose_home", 1), {"result": "pose_home"})
        alice = self.person()
        alice.take()
        for service, operation in (("db", "add"), ("db", "remove"), ("display", "ask"), ("timer", "wait")):
            self.assertEqual(self.refused(service, {"operation": operation, "args": ["pose_home"]}, 409)["code"], "leased", operation)
        self.assertEqual(self.call("db", "get", "pose_home"), {"result": 1})
        self.assertIn("pose_home", self.call("db", "list")["result"])
        self.assertIn("q", self.call("robot", "state")["result"])
        self.assertEqual(self.call("robot", "stop"), {"result": None}, "what is safe")
        status, answer = alice.request("POST", "/services/db/calls", {"operation": "add", "args": ["pose_home", 2]})
        self.assertEqual((status, answer), (200, {"result": "pose_home"}))


class Shares(unittest.TestCase):
    def test_what_waits_keeps_out_nothing_that_reads_or_stops(self):
        with AccountServer("--demo", DEMO) as server, concurrent.futures.ThreadPoolExecutor(4) as clients:
            wait = ("POST", "/api/v1/services/timer/calls", {"operation": "wait", "args": [3]})
            waiting = [clients.submit(server.ask, "operator", *wait) for _ in range(4)]
            timer = lambda: next(each for each in server.get("/services")["services"] if each["key"] == "timer")
            server.wait_for(lambda: len(timer()["pending"]) == 4)
            self.assertEqual(server.ask("operator", *wait), 429)
            for service, operation in (("robot", "state"), ("robot", "stop")):
                self.assertEqual(server.ask("operator", "POST", f"/api/v1/services/{service}/calls", {"operation": operation}), 200)
            self.assertEqual([each.result() for each in waiting], [200] * 4)

    def test_an_account_does_not_keep_out_the_others(self):
        with AccountServer("--demo", DEMO) as server, concurrent.futures.ThreadPoolExecutor(10) as clients:
            wait = ("POST", "/api/v1/services/timer/calls", {"operation": "wait", "args": [3]})
            waiting = [clients.submit(server.ask, "operator", *wait) for _ in range(10)]
            done = lambda: sorted(each.result() for each in waiting if each.done())
            server.wait_for(lambda: done() == [429] * 6)
            self.assertEqual(server.ask("developer", "POST", "/api/v1/services/timer/calls", {"operation": "wait", "args": [0]}), 200)
            self.assertEqual(sorted(each.result() for each in waiting), [200] * 4 + [429] * 6)


class Rights(unittest.TestCase):
    def test_an_operator_calls_and_the_audit_log_has_it(self):
        with AccountServer("--demo", DEMO) as server:
            call = ("POST", "/api/v1/services/db/calls", {"operation": "add", "args": ["x", 1]})
            self.assertEqual([server.ask(account, *call) for account in (None, "observer", "operator")], [401, 403, 200])
            entry, = server.audited("service call", limit=1)
            self.assertEqual((entry["account"], entry["action"], entry["outcome"]), ("operator", "service call db.add", "accepted"))
            self.assertEqual(server.ask("operator", "POST", "/api/v1/services/db/calls", {"operation": "get", "args": ["x"]}), 200)
            self.assertEqual(server.ask("operator", "POST", "/api/v1/services/db/calls", {"operation": "remove", "args": ["x"]}), 200)
            self.assertEqual(server.audited("service call db.remove", limit=2)[1], entry, "what only reads has no row")


if __name__ == "__main__":
    unittest.main()
