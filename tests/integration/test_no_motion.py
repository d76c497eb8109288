"""After a restart, a reconnect, a replay, an edit, a stop or another mode the arm stands until a person acts anew.

Each test ends with that act, and the motion that it causes: the same poses show both.
"""
import contextlib
import json
import time
import unittest

import models
from client import Server
from controls import RecordedControls, eventually, held
from motions import FAR, HOME, Arm, StillArm, insisting, moving
from test_control import DEMO, ControlCase

WINDOW = 1.5  # [s of the cell] without a motion


def waiting():
    """Moves to a place near by, waits, and moves on once an edit lets it. It takes an input at each tick."""
    return models.document("waiting", {
        "state": "Root", "first": "Begin", "results": [{"name": "n", "initial": 0}],
        "actions": [{"when": "svc.timer.tick", "do": "res.n = res.n + 1"}],
        "children": [
            {"state": "Begin", "entry": f"svc.robot.move({{'joints': {[0.1, *HOME[1:]]}}})",
             "ports": [{"name": "there", "when": "svc.robot.move.result", "to": "Wait"}]},
            {"state": "Wait", "ports": [{"name": "next", "when": "False", "to": "Go"}]},
            {"state": "Go", "entry": f"svc.robot.move({{'joints': {FAR}}}, speed=0.2)"}]})


class NoMotion(ControlCase):
    def setUp(self):
        super().setUp()
        self.arm.close()  # poses that a stream has kept meanwhile are old: each look is a new one

    def recorded(self):
        person = RecordedControls(self.server)
        self.addCleanup(person.close)
        return person

    def moves(self):
        with contextlib.closing(Arm(self.server)) as arm:
            arm.wait(moving=True)

    def stops(self):
        with contextlib.closing(StillArm(self.server)) as arm:
            arm.wait(moving=False)

    @contextlib.contextmanager
    def standing(self):
        """The arm does not move meanwhile, nor for WINDOW afterwards."""
        with contextlib.closing(StillArm(self.server)) as arm:
            begin = time.monotonic()
            yield
            arm.stands_for(time.monotonic() - begin + WINDOW)

    def kill(self):
        """SIGKILL, and another server on the same folder."""
        self.server.kill()
        own = self.server.own
        self.server = Server("--demo", DEMO, data=self.server.data)
        self.server.own = own

    def assert_refused(self, secret, core):
        """Whatever a person does by the secret of controls that they have no more."""
        for method, path, body in (("PUT", "/control/mode", {"mode": "programming"}), ("POST", f"/cores/{core}/start", None),
                                   ("POST", f"/cores/{core}/resume", None), ("POST", f"/cores/{core}/step", {"kind": "macro"}),
                                   ("POST", f"/cores/{core}/confirm_edit", {"revision": 1})):
            status, answer = self.server.request(method, "/api/v1" + path, body, {"Race-Control": secret})
            self.assertEqual((status, answer["errors"][0]["code"]), (409, "leased"), path)

    def answers(self, person, texts):
        """The kinds and codes of the answers to messages of another connection, sent again byte for byte."""
        self.assertTrue(texts)
        found = set()
        for text in texts:
            with person.sending:
                person.send(text)
            answer = person.hear()
            found.add((answer["kind"], answer.get("error", answer).get("code")))
        return found

    def jogs(self, person):
        with held(person):
            self.moves()

    def moving_by_hand(self):
        """A person whose motion by hand, to a place far away, is under way."""
        person = self.recorded().programming()
        person.say("call", number=0, service="robot", operation="move", kwargs={"target": {"joints": FAR}, "speed": 0.2})
        self.moves()
        return person

    def taking(self):
        person = self.recorded()
        self.assertEqual(person.take()["kind"], "taken")
        return person

    def does(self, person, core, what, body=None):
        status, answer = person.request("POST", f"/cores/{core}/{what}", body)
        self.assertEqual(status, 200, answer)

    def supervised(self, document):
        """A run, and who began it."""
        core, person = self.server.core(document, start=False), self.taking()
        self.does(person, core, "start", {"supervised": True})
        return core, person


class Restart(NoMotion):
    """After SIGKILL."""

    def boot(self, document):
        self.server.put(f"/documents/{document['name']}", document, "document_entry")
        self.server.put("/boot", {"entries": [{"document": document["name"], "arguments": {}}]}, "boot")

    def test_of_a_server_by_which_a_person_jogs(self):
        self.boot(moving("first"))
        core = self.server.core(moving("second"), start=False)
        alice = self.recorded().programming()
        with held(alice):
            self.moves()
            self.kill()
        with self.standing():
            self.assertIsNone(self.holder())
            self.assertEqual(self.control()["mode"], "programming")
            self.assert_refused(alice.secret, core)
            again = self.person()
            self.assertEqual(self.answers(again, alice.recorded("call")), {("response", "leased")})
            self.assertEqual(self.answers(again, alice.recorded("beat")), {("lost", "leased")})
            self.assertEqual(self.server.post(f"/cores/{core}/start", None, None, 409)["errors"][0]["code"], "conflict")
        self.assertNotIn("running", [each["status"] for each in self.server.get("/cores", "cores")["cores"]])
        self.jogs(self.person().programming())

    def test_of_a_server_whose_run_moves(self):
        self.boot(insisting())
        core = self.server.core(insisting())
        self.moves()
        self.kill()
        with self.standing():
            self.assertEqual(self.status(core)["status"], "interrupted")
            person = self.person()
            self.assertEqual(person.take()["kind"], "taken")
        person.close()
        eventually(lambda: self.holder() is None)
        self.assertEqual([each["id"] for each in self.server.get("/cores", "cores")["cores"]], [core], "it is not started anew")
        self.server.post(f"/cores/{core}/resume", None, "core")
        self.moves()

    def test_of_a_server_whose_supervised_run_moves(self):
        core, alice = self.supervised(insisting())
        self.moves()
        self.kill()
        with self.standing():
            self.assertEqual(self.status(core)["status"], "interrupted")
            self.assertIsNone(self.holder())
            self.assert_refused(alice.secret, core)
            refused = self.server.post(f"/cores/{core}/resume", {"supervised": True}, None, 409)["errors"][0]
            self.assertEqual(refused["code"], "conflict")
            bob = self.person()
            self.assertEqual(bob.take()["kind"], "taken")
        self.does(bob, core, "resume", {"supervised": True})
        self.moves()
        bob.close()
        self.stops()
        with self.standing():
            self.assertTrue(self.status(core)["paused"])


class Reconnect(NoMotion):
    """Connections that end, and others of the same clients."""

    def test_of_a_person_and_of_a_page_that_watches(self):
        core, alice = self.supervised(insisting())
        channels = (f"core/{core}/state", "control", "cores")
        last = {}
        with self.server.stream() as page:
            for channel in channels:
                page.subscribe(channel)
                last[channel] = page.until(lambda m, of=channel: m["channel"] == of)[-1]["sequence"]
        self.moves()
        alice.close()
        self.stops()
        with self.standing(), self.server.stream() as page:
            for channel in channels:
                page.subscribe(channel, since=last[channel])
            page.until(lambda m: m["channel"] == "control" and m["kind"] == "delta" and m["data"]["holder"] is None)
            self.assertTrue(self.status(core)["paused"])
            self.assertEqual(self.answers(self.person(), alice.recorded("beat")), {("lost", "leased")})
            self.assert_refused(alice.secret, core)
            again = self.person()
            self.assertEqual(again.take()["kind"], "taken")
            self.assert_refused(alice.secret, core)
        self.does(again, core, "resume")
        self.moves()

    def test_messages_of_a_connection_that_has_ended_are_sent_again(self):
        """`take` is what any person says, so it is refused while another one has the controls, and starts nothing."""
        alice = self.moving_by_hand()
        alice.close()
        self.stops()
        core = self.server.core(moving(), start=False)
        calls, beats, takes = (alice.recorded(kind) for kind in ("call", "beat", "take"))
        with self.standing():
            again = self.person()
            self.assertEqual(self.answers(again, calls + beats), {("response", "leased"), ("lost", "leased")})
            self.assertEqual(self.answers(again, takes), {("taken", None)})
            again.close()
            eventually(lambda: self.holder() is None)
            bob, again = self.person().programming(), self.person()
            self.assertEqual(self.answers(again, takes), {("refused", "leased")})
            self.assertEqual(self.answers(again, calls + beats), {("response", "leased"), ("lost", "leased")})
            self.assert_refused(alice.secret, core)
            self.assertEqual(self.holder(), bob.number)
        self.jogs(bob)


class Past(NoMotion):
    ROUTES = ("", "/native", "/journal", "/script", "/samples", "/pictures", "/timing", "/export")
    OF_STEPS = ("/past?step={0}", "/derivations?from={0}&to={0}")

    def test_who_looks_at_a_past_run_moves_nothing(self):
        core = self.server.core(moving(speed=0.6))
        self.moves()
        self.assertEqual(self.server.ended(core)["outcome"], "there")
        self.stops()
        with self.standing():
            imported = self.server.post("/runs", self.server.get(f"/runs/{core}/export", "run_file"), "run", 201)
            steps = range(1, imported["steps"] + 1)
            for path in (f"/runs/{core}", f"/runs/{imported['id']}", f"/cores/{core}"):
                routes = self.ROUTES if path.startswith("/runs") else ("", "/native", "/state", "/journal", "/script")
                for route in (*routes, *(route.format(step) for route in self.OF_STEPS for step in steps)):
                    self.server.get(path + route)
            self.server.get(f"/runs/{core}/compare?with={imported['id']}", "run_comparison")
            self.assertIn("svc.robot.move", json.dumps(self.server.get(f"/runs/{core}/native", "native")), "it has the motion")
        self.server.core(moving("back", HOME))
        self.moves()


class LiveEdits(NoMotion):
    """Each lets the run move on."""

    def live(self, person=None, **how):
        """The run waits, and the arm stands."""
        core = self.server.core(waiting(), start=False)
        self.server.put(f"/cores/{core}/live", {"live": True}, "core")
        if person:
            self.does(person, core, "start", how)
        else:
            self.server.post(f"/cores/{core}/start", None, "core")
        eventually(lambda: "Root/Wait" in self.server.get(f"/cores/{core}/state", "core_state")["state"]["active"])
        self.stops()
        return core

    def edit(self, core):
        """Stores the revision; its number, once it waits for the run."""
        document = self.server.get("/documents/waiting", "document_entry")["document"]
        document["root"]["children"][1]["ports"][0]["when"] = "True"
        revision = self.server.put("/documents/waiting", document, "document_entry")["revision"]
        self.server.wait(core, lambda c: c.get("waiting_edit", {}).get("revision") == revision)
        return {"revision": revision}

    def unconfirmed(self, core):
        return self.status(core).get("waiting_edit", {}).get("unconfirmed", False)

    def test_of_a_run_that_a_person_has_paused(self):
        core = self.live()
        self.server.post(f"/cores/{core}/pause", None, "core")
        with self.standing():
            self.edit(core)
        self.assertTrue(self.status(core)["paused"])
        self.server.post(f"/cores/{core}/resume", None, "core")
        self.moves()

    def test_of_a_run_that_has_lost_its_person(self):
        alice = self.taking()
        core = self.live(alice, supervised=True)
        alice.close()
        self.server.wait(core, lambda c: c["paused"])
        with self.standing():
            edit = self.edit(core)
            bob = self.taking()
        with self.standing():
            self.does(bob, core, "resume")
            eventually(lambda: self.unconfirmed(core))
        self.does(bob, core, "confirm_edit", edit)
        self.moves()

    def test_of_a_run_in_execution_mode_that_waits_to_be_confirmed(self):
        alice = self.taking()
        core = self.live(alice)
        with self.standing():
            edit = self.edit(core)
            eventually(lambda: self.unconfirmed(core))
            refused = self.server.post(f"/cores/{core}/confirm_edit", edit, None, 409)["errors"][0]
            self.assertEqual(refused["code"], "leased")
        self.does(alice, core, "confirm_edit", edit)
        self.moves()

    def test_of_a_run_that_waits_to_be_confirmed_while_its_person_leaves(self):
        """Nobody has confirmed it: that they leave, or lose their connection, is no consent."""
        alice = self.taking()
        core = self.live(alice)
        edit = self.edit(core)
        eventually(lambda: self.unconfirmed(core))
        with self.standing():
            alice.close()
            eventually(lambda: self.holder() is None)
        self.assertTrue(self.unconfirmed(core))
        self.does(self.taking(), core, "confirm_edit", edit)
        self.moves()


class StopAndMode(NoMotion):
    def stop(self):
        self.server.post("/stop", None, "control")
        self.stops()

    def reset(self):
        self.server.post("/stop/reset", None, "control")

    def test_a_stop_of_a_run_is_released(self):
        core = self.server.core(insisting())
        self.moves()
        self.stop()
        with self.standing():
            self.reset()
        self.assertEqual(self.status(core)["status"], "aborted")
        self.server.post(f"/cores/{core}/resume", None, None, 409)
        self.server.core(insisting())
        self.moves()

    def test_a_stop_of_a_motion_by_hand_is_released(self):
        alice = self.moving_by_hand()
        self.stop()
        self.assertEqual(alice.until("response")["error"]["code"], "stopped")
        with self.standing():
            self.reset()
        self.assertEqual(self.holder(), alice.number)
        self.jogs(alice)

    def test_a_stop_is_released_while_a_button_is_still_held(self):
        """Somebody else may release it, and begins no motion by that: the button is to be let go first, as after a collision."""
        alice = self.person().programming()
        with held(alice):
            self.moves()
            self.stop()
            with self.standing():
                pass  # so what moves afterwards does not move on
            with self.standing():
                self.reset()
        time.sleep(0.5)
        self.jogs(alice)

    def test_another_mode_and_back(self):
        core = self.server.core(insisting())
        self.moves()
        alice = self.taking()
        alice.set_mode("programming")
        self.stops()
        with self.standing():
            self.assertTrue(self.status(core)["paused"])
        with self.standing():
            alice.set_mode("execution")
        self.assertTrue(self.status(core)["paused"])
        self.does(alice, core, "resume")
        self.moves()

    def test_another_mode_and_back_of_a_motion_by_hand(self):
        alice = self.moving_by_hand()
        alice.set_mode("execution")
        self.assertEqual(alice.until("response")["error"]["code"], "stopped")
        self.stops()
        with self.standing():
            alice.set_mode("programming")
        self.jogs(alice)


if __name__ == "__main__":
    unittest.main()
