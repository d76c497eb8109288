"""One person at a time has the controls: nobody else moves the cell, or begins a run; what moved by them stops with them."""
import collections
import contextlib
import threading
import time
import unittest

import models
from accounts import PASSWORD, AccountServer
from client import PROJECT, Server
from controls import Controls, eventually, pressed
from motions import FAR, HOME, Arm, insisting, moving

DEMO = str(PROJECT / "deploy/demo")


class ControlCase(unittest.TestCase):
    SERVER = Server

    def setUp(self):
        self.server = self.SERVER("--demo", DEMO)
        self.addCleanup(self.end)
        self.arm = Arm(self.server)
        self.addCleanup(self.arm.close)

    def end(self):
        """Of the server that is there then."""
        self.server.stop()

    def person(self, token=None):
        person = Controls(self.server, token)
        self.addCleanup(person.close)
        self.assertEqual(person.status, 101)
        return person

    def control(self):
        return self.server.get("/control", "control")

    def holder(self):
        return (self.control()["holder"] or {}).get("number")

    def status(self, core):
        return self.server.get(f"/cores/{core}", "core")

    def move(self, person, target, speed=0.2):
        """Begins a motion by hand, and does not wait for its end."""
        person.say("call", number=0, service="robot", operation="move", kwargs={"target": {"joints": target}, "speed": speed})
        self.arm.wait(moving=True)


class Taking(ControlCase):
    def test_one_person_has_them_until_they_give_them_back(self):
        alice, bob = self.person(), self.person()
        number = alice.take()["number"]
        self.assertEqual(self.control()["holder"], {"number": number, "by": "somebody at 127.0.0.1"})
        self.assertEqual(bob.take()["code"], "leased")
        self.assertEqual(alice.take()["code"], "conflict", "they have them already")
        alice.silent()
        alice.say("release")
        alice.until("released")
        self.assertIsNone(self.control()["holder"])
        self.assertGreater(bob.take()["number"], number)

    def test_who_is_silent_loses_them_and_is_told(self):
        alice = self.person()
        alice.take()
        time.sleep(1)
        self.assertEqual(self.holder(), alice.number)
        alice.silent()
        self.assertEqual(alice.until("lost")["code"], "leased")
        self.assertIsNone(self.holder())
        alice.say("beat")
        self.assertEqual(alice.hear()["kind"], "lost")

    def test_whose_connection_ends_has_them_no_more_at_once(self):
        alice = self.person()
        alice.take()
        alice.socket.close()
        eventually(lambda: self.holder() is None)
        entries = lambda: self.server.get("/audit?limit=50", "audit")["entries"]
        ends = eventually(lambda: [e["outcome"] for e in entries() if e["action"] == "control end"])
        self.assertEqual(ends, ["closed"], "not for their silence")

    def test_a_message_that_does_not_fit_is_refused_and_changes_nothing(self):
        alice = self.person()
        alice.take()
        for text in ("", "{", "[]", "{}", '{"type": "jump"}', '{"type": "take", "force": 1}', '{"type": "beat", "more": 1}',
                     '{"type": "call"}', '{"type": "call", "number": -1, "service": "robot", "operation": "stop"}',
                     '{"type": "call", "number": 1, "service": 3, "operation": "stop"}',
                     '{"type": "call", "number": 1, "service": "robot", "operation": "stop", "kwargs": []}'):
            with alice.sending:
                alice.send(text)
            self.assertEqual(alice.hear()["kind"], "refused", text)
        self.assertEqual(self.holder(), alice.number)


class ByHand(ControlCase):
    def test_only_who_has_them_moves_the_arm_and_only_in_programming_mode(self):
        alice, bob = self.person(), self.person()
        home = {"target": {"joints": HOME}}
        self.assertEqual(alice.call("robot", "move", **home)["error"]["code"], "leased")
        alice.take()
        self.assertEqual(alice.call("robot", "move", **home)["error"]["code"], "not_accepted")
        alice.set_mode("programming")
        self.assertIn("pose", alice.call("robot", "move", **home)["result"])
        self.assertEqual(bob.call("robot", "move", **home)["error"]["code"], "leased")
        self.assertEqual(self.control()["leases"], [{"service": "robot", "core": f"control/{alice.number}"}])

    def test_what_is_no_motion_is_called_in_either_mode(self):
        alice = self.person()
        alice.take()
        self.assertEqual(alice.call("db", "get", key="nothing")["error"]["code"], "not_found")
        self.assertEqual(alice.call("nobody", "get")["error"]["code"], "unavailable")
        self.assertEqual(alice.call("robot", "jump")["error"]["code"], "unavailable")

    def test_the_arm_stops_when_they_are_silent_leave_or_give_them_back(self):
        ends = {"silent": lambda person: person.silent(), "closed": lambda person: person.close(),
                "given back": lambda person: person.say("release")}
        for number, (name, end) in enumerate(ends.items()):
            with self.subTest(name):
                person = self.person().programming()
                self.move(person, FAR if number % 2 == 0 else HOME)
                end(person)
                self.assertLess(self.arm.wait(moving=False), 1.2)
                self.arm.stands_for(0.5)
                person.close()
                eventually(lambda: self.holder() is None)

    def test_a_stop_and_its_reset_leave_them_and_move_nothing(self):
        alice = self.person().programming()
        self.move(alice, FAR)
        self.server.post("/stop")
        self.arm.wait(moving=False)
        self.assertEqual(alice.until("response")["error"]["code"], "stopped")
        self.assertEqual(alice.call("robot", "move", target={"joints": HOME})["error"]["code"], "stopped")
        self.server.post("/stop/reset")
        self.arm.stands_for(0.5)
        self.assertIn("pose", alice.call("robot", "move", target={"joints": HOME}, speed=0.5)["result"])

    def test_at_most_16_calls_wait(self):
        alice = self.person().programming()
        self.move(alice, FAR)
        for number in range(1, 40):
            alice.say("call", number=number, service="timer", operation="wait", kwargs={"seconds": 30})
        codes = [alice.until("response")["error"]["code"] for _ in range(20)]
        self.assertIn("too_large", codes)
        self.assertEqual(self.holder(), alice.number)


class Jogging(ControlCase):
    """A button that is held: `jog` is called again and again."""

    TURN = {"joints": [0.3, 0, 0, 0, 0, 0, 0]}  # rad/s

    def hold(self, person, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.assertEqual(person.call("robot", "jog", **self.TURN), {"result": None})
            time.sleep(0.05)

    def test_the_arm_moves_while_it_is_held_and_stands_soon_after(self):
        alice = self.person().programming()
        self.hold(alice, 1)
        self.arm.wait(moving=True)
        self.assertEqual(alice.call("robot", "jog", joints=[0] * 7), {"result": None})
        self.arm.wait(moving=False)
        self.arm.stands_for(0.5)

    def test_who_is_heard_and_calls_no_more_moves_it_no_farther(self):
        alice = self.person().programming()
        self.hold(alice, 1)
        self.arm.wait(moving=True)
        self.arm.wait(moving=False)
        self.arm.stands_for(0.5)
        self.assertEqual(self.holder(), alice.number, "only the button was released")

    def test_others_and_other_modes_do_not_move_it(self):
        alice, bob = self.person(), self.person()
        self.assertEqual(bob.call("robot", "jog", **self.TURN)["error"]["code"], "leased")
        alice.take()
        self.assertEqual(alice.call("robot", "jog", **self.TURN)["error"]["code"], "not_accepted")
        self.arm.stands_for(0.5)

    def test_faster_than_it_may_be_is_refused(self):
        alice = self.person().programming()
        for velocity in ({"joints": [3.0, 0, 0, 0, 0, 0, 0]}, {"linear": [0.3, 0, 0]}, {"angular": [0, 2, 0]}):
            self.assertEqual(alice.call("robot", "jog", **velocity)["error"]["code"], "out_of_range")
        self.arm.stands_for(0.3)


class Guiding(ControlCase):
    """A hand leads the arm while a button is held: `guide` is called again and again."""

    def state(self):
        return next(s["state"] for s in self.server.get("/services", "services")["services"] if s["key"] == "robot")

    def pull(self, seconds):
        self.server.post("/cell/person", {"act": "push", "body": "gripper", "force": [0, 15, 0], "duration": seconds}, "person")

    def test_the_arm_follows_a_hand_while_it_is_held_and_holds_soon_after(self):
        alice = self.person().programming()
        self.assertEqual(alice.call("robot", "state")["result"]["mode"], "position")
        with pressed(alice, "guide"):
            self.pull(0.7)
            self.arm.wait(moving=True)
            time.sleep(0.5)
            self.assertEqual(self.state(), "Guiding")
        pose = alice.call("robot", "record_pose")["result"]
        self.assertEqual(alice.call("robot", "move", target={"joints": HOME})["error"]["code"], "not_accepted")
        eventually(lambda: self.state() == "Idle")
        with contextlib.closing(Arm(self.server)) as arm:  # by poses from now on
            arm.stands_for(0.5)
        now = alice.call("robot", "state")["result"]
        self.assertEqual((now["mode"], now["moving"]), ("position", False))
        self.assertGreater(now["pose"]["position"][1], 0.02)
        self.assertEqual(len(pose["q"]), 7)
        self.assertEqual(self.holder(), alice.number)

    def test_it_moves_the_arm_so_others_and_other_modes_do_not(self):
        alice, bob = self.person(), self.person()
        self.assertEqual(bob.call("robot", "guide")["error"]["code"], "leased")
        alice.take()
        self.assertEqual(alice.call("robot", "guide")["error"]["code"], "not_accepted")
        self.assertIn("pose", alice.call("robot", "state")["result"], "and this in any mode")

    def test_a_button_that_is_held_over_a_stop_guides_nothing_until_it_is_let_go_of(self):
        alice = self.person().programming()
        self.assertEqual(alice.call("robot", "guide"), {"result": None})
        self.server.post("/stop")
        self.server.post("/stop/reset")
        for _ in range(10):
            self.assertEqual(alice.call("robot", "guide")["error"]["code"], "stopped")
            time.sleep(0.05)
        self.assertEqual(self.state(), "Idle")
        time.sleep(0.3)
        self.assertEqual(alice.call("robot", "guide"), {"result": None})

    def test_a_button_that_is_pressed_while_the_cell_is_stopped_moves_nothing_after_the_reset(self):
        alice = self.person().programming()
        self.server.post("/stop")
        for number in range(12):
            if number == 4:
                self.server.post("/stop/reset")
            self.assertEqual(alice.call("robot", "jog", joints=[0, 0, 0, 0, 0, 0, 0.1])["error"]["code"], "stopped")
            time.sleep(0.05)
        time.sleep(0.3)
        self.assertEqual(alice.call("robot", "jog", joints=[0, 0, 0, 0, 0, 0, 0.1]), {"result": None})


class Audit(ControlCase):
    def rows(self):
        entries = self.server.get("/audit?limit=50", "audit")["entries"]
        return [(e["action"], e["outcome"]) for e in reversed(entries) if e["action"].startswith("control ")]

    def test_has_what_is_moved_by_hand_and_how_the_controls_end(self):
        alice, bob = self.person().programming(), self.person()
        self.assertEqual(bob.take()["code"], "leased")
        alice.call("robot", "move", target={"joints": HOME}, speed=0.5)
        for _ in range(5):
            alice.call("robot", "jog", joints=[0] * 7)
        alice.call("robot", "stop")
        alice.silent()
        alice.until("lost")
        bob.take()
        bob.close()
        expected = [("control take", "200"), ("control call robot.move", "accepted"), ("control call robot.jog", "accepted"),
                    ("control end", "silent"), ("control take", "200"), ("control end", "closed")]
        self.server.wait_for(lambda: len(self.rows()) >= len(expected))
        self.assertEqual(self.rows(), expected)


class Runs(ControlCase):
    def begin(self, person, core, **more):
        return person.request("POST", f"/cores/{core}/start", more or None)

    def test_nobody_else_begins_a_run(self):
        alice = self.person()
        alice.take()
        core = self.server.core(moving("mine"), start=False)
        refused = self.server.post(f"/cores/{core}/start", None, None, 409)["errors"][0]
        self.assertEqual(refused["code"], "leased")
        self.assertEqual(self.begin(alice, core)[0], 200)
        self.arm.wait(moving=True)
        alice.close()
        self.assertEqual(self.server.ended(core)["outcome"], "there", "it is not supervised")

    def test_a_supervised_run_is_paused_without_its_person_and_goes_on_with_one(self):
        alice = self.person()
        alice.take()
        core = self.server.core(insisting(), start=False)
        self.assertEqual(self.begin(alice, core, supervised=True)[0], 200)
        self.arm.wait(moving=True)
        self.assertTrue(self.status(core)["supervised"])
        alice.silent()
        self.arm.wait(moving=False)
        eventually(lambda: self.status(core)["paused"])
        self.arm.stands_for(0.5)
        refused = self.server.post(f"/cores/{core}/resume", None, None, 409)["errors"][0]
        self.assertEqual(refused["code"], "conflict")
        bob = self.person()
        bob.take()
        self.arm.stands_for(0.5)
        self.assertEqual(bob.request("POST", f"/cores/{core}/resume")[0], 200)
        self.arm.wait(moving=True)

    def test_programming_mode_stops_runs_and_each_needs_its_person(self):
        core = self.server.core(insisting())
        self.arm.wait(moving=True)
        alice = self.person()
        alice.take()
        self.assertEqual(alice.set_mode("programming")["mode"], "programming")
        self.arm.wait(moving=False)
        eventually(lambda: self.status(core)["paused"])
        self.assertIn("pose", alice.call("robot", "move", target={"joints": HOME}, speed=0.5)["result"])
        self.assertEqual(alice.request("POST", f"/cores/{core}/resume")[0], 200)
        self.arm.wait(moving=True)
        alice.close()
        self.arm.wait(moving=False)
        eventually(lambda: self.status(core)["paused"])

    def test_a_run_that_is_paused_makes_way_for_a_hand_once_the_mode_has_changed_and_goes_on(self):
        """As a page does that teaches a pose while a run waits (web/one/run/hold.ts)."""
        alice = self.person()
        alice.programming()
        core = self.server.core(insisting(), start=False)
        self.assertEqual(alice.request("POST", f"/cores/{core}/start")[0], 200)
        self.arm.wait(moving=True)
        self.assertEqual(alice.request("POST", f"/cores/{core}/pause")[0], 200)
        by_hand = {"target": {"joints": HOME}, "speed": 0.5}
        self.assertEqual(alice.call("robot", "move", **by_hand)["error"]["code"], "leased")
        alice.set_mode("execution")
        alice.set_mode("programming")
        self.assertIn("pose", alice.call("robot", "move", **by_hand)["result"])
        self.assertTrue(self.status(core)["paused"])
        alice.set_mode("execution")
        self.assertEqual(alice.request("POST", f"/cores/{core}/resume")[0], 200)
        self.arm.wait(moving=True)

    def test_the_mode_outlives_the_server_and_starts_nothing(self):
        alice = self.person().programming()
        alice.close()
        self.arm.close()
        self.server.own, own = False, self.server.own
        self.server.stop()
        self.server = self.SERVER("--demo", DEMO, data=self.server.data)
        self.server.own = own
        self.arm = Arm(self.server)
        self.assertEqual(self.control()["mode"], "programming")
        core = self.server.core(moving("mine"), start=False)
        self.assertEqual(self.server.post(f"/cores/{core}/start", None, None, 409)["errors"][0]["code"], "conflict")


class Edits(ControlCase):
    """Of a document that a run follows which moves the arm."""

    def edited(self, core):
        """Stores another revision; its number."""
        document = self.server.get("/documents/insisting", "document_entry")["document"]
        state = document["root"]["children"][0]
        state["ports"][1]["when"] = state["ports"][1]["when"] + " and True"
        return self.server.put("/documents/insisting", document, "document_entry")["revision"]

    def live(self, person=None):
        core = self.server.core(insisting(), start=False)
        self.server.put(f"/cores/{core}/live", {"live": True}, "core")
        if person is None:
            self.server.post(f"/cores/{core}/start")
        else:
            self.assertEqual(person.request("POST", f"/cores/{core}/start")[0], 200)
        self.arm.wait(moving=True)
        return core

    def test_who_has_the_controls_confirms_each_in_execution_mode(self):
        alice = self.person()
        alice.take()
        core = self.live(alice)
        for _ in range(2):
            revision = self.edited(core)
            eventually(lambda: self.status(core).get("waiting_edit", {}).get("unconfirmed"))
            time.sleep(0.3)
            self.assertLess(self.status(core)["revision"], revision)
            body = {"revision": revision}
            self.assertEqual(self.server.post(f"/cores/{core}/confirm_edit", body, None, 409)["errors"][0]["code"], "leased")
            status, answer = alice.request("POST", f"/cores/{core}/confirm_edit", {"revision": revision - 1})
            self.assertEqual((status, answer["errors"][0]["code"]), (409, "conflict"), "one that they have not seen")
            self.assertEqual(alice.request("POST", f"/cores/{core}/confirm_edit", body)[0], 200)
            self.assertNotIn("waiting_edit", self.server.wait(core, lambda c, to=revision: c["revision"] == to))

    def test_in_programming_mode_they_arrive_at_once(self):
        alice = self.person().programming()
        core = self.live(alice)
        revision = self.edited(core)
        self.server.wait(core, lambda c: c["revision"] == revision)

    def test_on_this_machine_alone_they_arrive_at_once_while_nobody_has_the_controls(self):
        core = self.live()
        revision = self.edited(core)
        self.server.wait(core, lambda c: c["revision"] == revision)


def other_share(name="otherShare"):
    """Changes how fast the arm moves; ends with the code of the error, or with none."""
    return models.document(name, {
        "state": "Root", "entry": "svc.robot.speed_override(0.5)", "results": [{"name": "code"}],
        "actions": [{"when": "svc.robot.speed_override.error", "do": "res.code = svc.robot.speed_override.error.code"}],
        "ports": [{"name": "set", "when": "svc.robot.speed_override.result"}, {"name": "failed", "when": "available(res.code)"}]})


class OtherMotions(ControlCase):
    """What else than a motion lets the arm move."""
    FORCED = {"path": "Root/To", "scope": "port", "name": "next"}

    def code(self, path, body=None):
        return self.server.post(path, body, None, 409)["errors"][0]["code"]

    def test_who_has_the_controls_alone_forces_values_of_runs(self):
        core = self.server.core(insisting())
        alice = self.person()
        alice.take()
        self.assertEqual(self.code(f"/cores/{core}/force", self.FORCED), "leased")
        self.assertEqual(alice.request("POST", f"/cores/{core}/force", self.FORCED)[0], 200)

    def test_a_supervised_run_that_has_lost_its_person_is_not_led_on_by_others(self):
        core = self.server.core(insisting(), start=False)
        alice = self.person()
        alice.take()
        self.assertEqual(alice.request("POST", f"/cores/{core}/start", {"supervised": True})[0], 200)
        self.arm.wait(moving=True)
        alice.close()
        self.server.wait(core, lambda c: c["paused"])
        self.assertEqual(self.code(f"/cores/{core}/force", self.FORCED), "conflict")

    def test_another_run_does_not_change_how_fast_the_arm_moves(self):
        moves = self.server.core(insisting())
        self.arm.wait(moving=True)
        other = self.server.core(other_share())
        self.assertEqual(self.server.wait(other, lambda c: c["status"] != "running")["results"]["code"], "leased")
        self.assertEqual(self.status(moves)["status"], "running")

    def test_who_has_the_controls_sets_how_fast_a_run_moves_and_it_goes_on_when_they_go(self):
        moves = self.server.core(insisting())
        self.arm.wait(moving=True)
        alice = self.person()
        alice.take()
        self.assertNotIn("error", alice.call("robot", "speed_override", share=0))
        self.arm.wait(moving=False)
        self.assertEqual(alice.call("robot", "state")["result"]["speed_override"], 0)
        self.assertEqual(self.status(moves)["status"], "running")
        self.assertNotIn("error", alice.call("robot", "speed_override", share=1))
        self.arm.wait(moving=True)
        alice.close()
        time.sleep(0.5)
        self.arm.wait(moving=True)
        self.assertEqual(self.status(moves)["status"], "running")

    def test_a_motion_whose_run_is_over_stops_with_its_person(self):
        core = self.server.core(models.document("leaving", {
            "state": "Root", "entry": f"svc.robot.move({{'joints': {FAR}}}, speed=0.2)",
            "ports": [{"name": "at_once", "when": "True"}]}), start=False)
        alice = self.person()
        alice.take()
        self.assertEqual(alice.request("POST", f"/cores/{core}/start", {"supervised": True})[0], 200)
        self.server.wait(core, lambda c: c["status"] == "ended")
        self.arm.wait(moving=True)
        alice.close()
        self.assertLess(self.arm.wait(moving=False), 1.2)

    def test_a_motion_by_hand_stops_with_its_person_though_they_have_begun_a_run_since(self):
        core = self.server.core(models.document("waiting", {"state": "Root", "entry": "svc.timer.wait(30)"}), start=False)
        alice = self.person().programming()
        self.move(alice, FAR)
        self.assertEqual(alice.request("POST", f"/cores/{core}/start")[0], 200)
        alice.close()
        self.assertLess(self.arm.wait(moving=False), 1.2)

    def test_the_cell_is_put_back_by_who_has_the_controls_alone_and_not_while_it_is_stopped(self):
        alice = self.person()
        alice.take()
        self.assertEqual(self.code("/cell/reset"), "leased")
        self.assertEqual(alice.request("POST", "/cell/reset")[0], 200)
        self.server.post("/stop", None, "control")
        self.assertEqual(self.code("/cell/reset"), "stopped")
        self.assertEqual(alice.request("POST", "/cell/reset")[0], 409)


class TakeOver(ControlCase):
    def ask(self):
        alice, bob = self.person().programming(), self.person()
        answer = bob.take(force=True)
        self.assertEqual(answer["kind"], "asked")
        self.assertEqual(self.control()["request"], {"id": answer["request"], "by": "somebody at 127.0.0.1"})
        return alice, bob, answer["request"]

    def test_a_person_at_the_cell_hands_them_over_and_what_moved_stops(self):
        alice, bob, request = self.ask()
        self.move(alice, FAR)
        control = self.server.post("/control/answer", {"request": request, "allow": True}, "control")
        bob.taken(bob.until("taken"))
        self.assertEqual(control["holder"]["number"], bob.number)
        self.assertIsNone(control["request"])
        alice.until("lost")
        self.arm.wait(moving=False)
        self.assertEqual(alice.call("robot", "move", target={"joints": HOME})["error"]["code"], "leased")
        self.assertIn("pose", bob.call("robot", "move", target={"joints": HOME}, speed=0.5)["result"])

    def test_or_refuses(self):
        alice, bob, request = self.ask()
        self.server.post("/control/answer", {"request": request, "allow": False}, "control")
        self.assertEqual(bob.hear()["kind"], "refused")
        self.assertEqual(self.holder(), alice.number)
        self.server.post("/control/answer", {"request": request, "allow": True}, None, 404)

    def test_a_request_ends_with_who_asks_and_with_who_has_them(self):
        alice, bob, _ = self.ask()
        carol = self.person()
        self.assertEqual(carol.take(force=True)["code"], "leased", "one asks at a time")
        bob.close()
        eventually(lambda: self.control()["request"] is None)
        self.assertEqual(carol.take(force=True)["kind"], "asked")
        alice.close()
        self.assertEqual(carol.hear()["kind"], "refused")
        self.assertIsNone(self.control()["request"])
        self.assertEqual(carol.take()["kind"], "taken")

    def test_with_accounts_only_a_display_at_the_cell_hands_them_over(self):
        with AccountServer("--demo", DEMO) as server:
            server.post("/accounts", {"name": "panel", "role": "operator", "password": PASSWORD, "groups": ["local"]}, "account", 201)
            panel = self.token(server, "panel")
            first, second = Controls(server, server.tokens["operator"]), Controls(server, server.tokens["developer"])
            first.take()
            request = second.take(force=True)["request"]
            body = {"request": request, "allow": True}
            for token in (server.tokens["operator"], server.tokens["developer"], server.token):
                status, answer = server.request("POST", "/api/v1/control/answer", body, {"Authorization": f"Bearer {token}"})
                self.assertEqual((status, answer["errors"][0]["code"]), (403, "rights"))
            status, answer = server.request("POST", "/api/v1/control/answer", body, {"Authorization": f"Bearer {panel}"})
            self.assertEqual((status, answer["holder"]["by"]), (200, "developer"))
            first.close()
            second.close()

    def token(self, server, account):
        """A token of it, of the server itself: the command line would need the data folder."""
        return server.post(f"/accounts/{account}/tokens", {"label": "test"}, None, 201)["token"]


class Races(ControlCase):
    PEOPLE, ATTEMPTS = 50, 200

    def test_of_many_who_take_them_one_has_them_and_nobody_else_moves_anything(self):
        wrong, takings, lock = [], [0], threading.Lock()
        holders, late = set(), set()  # late: who was silent for too long on a busy machine, and lost them by that

        def race(person):
            for _ in range(self.ATTEMPTS):
                try:
                    person.say("take")
                    answer = person.hear()
                    motion = person.call("robot", "jog", joints=[0] * 7)
                    if answer["kind"] != "taken":
                        if motion.get("error", {}).get("code") != "leased":
                            wrong.append((set(), f"somebody else moves the arm: {motion}"))
                        continue
                    with lock:
                        if holders:
                            wrong.append(({*holders, answer["number"]}, "have them at once"))
                        holders.add(answer["number"])
                        takings[0] += 1
                    if motion != {"result": None}:
                        wrong.append(({answer["number"]}, f"has them, and does not move the arm: {motion}"))
                    with lock:
                        holders.discard(answer["number"])
                    person.say("beat")
                    person.say("release")
                    told = [person.hear()["kind"]]
                    while told[-1] != "released":
                        told.append(person.hear()["kind"])
                    if told.count("lost") > 1:  # by silence, and for the beat; who gives them back hears it once
                        late.add(answer["number"])
                except OSError as error:
                    wrong.append((set(), str(error)))
                    return

        self.person().programming().close()
        eventually(lambda: self.holder() is None)
        people = [self.person() for _ in range(self.PEOPLE)]
        threads = [threading.Thread(target=race, args=(person,)) for person in people]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([each for each in wrong if not each[0] & late], [])
        self.assertGreater(takings[0] - len(late), 20)
        self.assertIsNone(self.holder())
        self.server.wait_for(lambda: self.recorded()["control take"] == self.recorded()["control end"])

    def recorded(self):
        """How many rows of the audit log each action has."""
        rows, page = collections.Counter(), {"next": 10**9}
        while "next" in page:
            page = self.server.get(f"/audit?before={page['next']}", "audit")
            rows.update(entry["action"] for entry in page["entries"])
        return rows


if __name__ == "__main__":
    unittest.main()
