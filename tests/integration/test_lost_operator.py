"""How soon the arm brakes when the person who moves it by hand is lost, however that comes; measured by what the robot says of itself.

RACE_TRIALS: of each kind (5). The figures are printed; the bound is that of the slowest.
"""
import contextlib
import itertools
import json
import os
import signal
import socket
import statistics
import struct
import subprocess
import sys
import time
import unittest
from pathlib import Path

import models
from client import PROJECT, Server
from controls import Controls, eventually, pressed
from motions import HOME, Arm

DEMO = str(PROJECT / "deploy/demo")
TRIALS = int(os.environ.get("RACE_TRIALS", "5"))
BOUND = 0.3  # [s] until it brakes
PERIOD = 0.01  # [s] between two states of the robot
BRAKES = 4.0  # [rad/s2]; a move speeds up and slows down by less than 1, and brakes with 8
MICRO = 1e6


def watching():
    """A run that hears each state of the robot, and so keeps it in its journal; it moves nothing."""
    return models.document("watching", {"state": "Root", "results": [{"name": "dq"}],
                                        "actions": [{"when": "svc.robot.robot_state", "do": "res.dq = svc.robot.robot_state.dq"}]})


class Watch:
    """The speed of the first joint over time, as the robot says it."""

    def __init__(self, server):
        self.server = server
        self.core = server.core(watching())

    def speeds(self, begin):
        """[(time [s since 1970], |dq| [rad/s])] from `begin` on."""
        created = self.server.get(f"/runs/{self.core}", "run")["created"] / 1000
        last = self.server.get(f"/cores/{self.core}", "core")["step"]
        first = max(1, last - 499)
        times = {step["step"]: created + step["arrived"] / MICRO
                 for step in self.server.get(f"/runs/{self.core}/timing?from={first}&to={last}", "timing")["steps"] if "arrived" in step}
        steps = [step for some in range(first, last + 1, 100)
                 for step in self.server.get(f"/cores/{self.core}/derivations?from={some}&to={min(some + 99, last)}")["steps"]]
        speeds = [(times[step["step"]], abs(step["input"]["data"]["dq"][0])) for step in steps
                  if step["step"] in times and step["input"]["kind"] == "event"]
        return [each for each in speeds if each[0] >= begin]

    def braking(self, lost):
        """(s until it brakes, s until it stands) after the person was lost."""
        speeds = self.speeds(lost - 0.1)
        brakes = next((now for (now, speed), (_, later) in itertools.pairwise(speeds)
                       if now >= lost - PERIOD and speed - later > BRAKES * PERIOD), None)
        assert brakes is not None, f"it did not brake: {speeds[::10]}"
        stands = next(now for now, speed in speeds if now > brakes and speed < 1e-3)
        return max(0.0, brakes - lost), stands - lost


class LostOperator(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server("--demo", DEMO, stderr=subprocess.DEVNULL)
        cls.addClassCleanup(cls.server.stop)
        cls.watch = Watch(cls.server)
        person = Controls(cls.server).programming()
        assert "result" in person.call("robot", "move", target={"joints": HOME}, speed=0.5)
        person.close()

    def far(self):
        """Joints far from where the arm is: a turn of the base that takes seconds."""
        with contextlib.closing(Arm(self.server)) as arm:
            base = next(iter(arm.pose()[1].values()))
        return [-1.5 if base > 0 else 1.5, *HOME[1:]]

    def wait(self, moving):
        """By poses from now on: those that a stream has kept meanwhile are old."""
        with contextlib.closing(Arm(self.server)) as arm:
            arm.wait(moving)
            if not moving:
                arm.stands_for(0.2)

    def measure(self, name, lose):
        """`lose` moves the arm and loses who does; it returns when that was [s since 1970]."""
        times = []
        for _ in range(TRIALS):
            eventually(lambda: self.server.get("/control", "control")["holder"] is None)
            lost = lose(self.far())
            self.wait(moving=False)
            times.append(self.watch.braking(lost))
        brakes, stands = zip(*times, strict=True)
        median, slowest, last = (1000 * time for time in (statistics.median(brakes), max(brakes), max(stands)))
        print(f"{name}: brakes after {median:.0f} ms (median), {slowest:.0f} (slowest of {TRIALS}); stands after {last:.0f}", flush=True)
        self.assertLessEqual(max(brakes), BOUND)

    def moving_person(self, target):
        person = Controls(self.server)
        self.assertEqual(person.take()["kind"], "taken")
        person.say("call", number=1, service="robot", operation="move", kwargs={"target": {"joints": target}, "speed": 0.2})
        self.wait(moving=True)
        time.sleep(0.8)
        return person

    def in_process(self, target, end):
        """Who is lost by `end` in this process."""
        person = self.moving_person(target)
        lost = time.time()
        end(person)
        self.addCleanup(person.close)
        return lost

    def test_a_connection_that_is_closed(self):
        self.measure("close", lambda target: self.in_process(target, lambda person: person.close()))

    def test_a_connection_that_is_reset(self):
        def reset(person):
            person.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            person.close()
        self.measure("RST", lambda target: self.in_process(target, reset))

    def test_silence(self):
        def silent(person):
            person.beating.set()
        self.measure("silence", lambda target: self.in_process(target, silent))

    def led(self, target, end):
        """Who guides the arm and is lost by `end`, while a hand goes on pulling it."""
        person = Controls(self.server)
        self.addCleanup(person.close)
        self.assertEqual(person.take()["kind"], "taken")
        self.hand(act="grab", body="gripper", limit=20, keep=60)
        with pressed(person, "guide"):
            self.hand(act="drag", by=[0, 0.8 if target[0] > 0 else -0.8, 0], speed=0.3, keep=60)
            self.wait(moving=True)
            time.sleep(0.8)
            lost = time.time()
            end(person)
        return lost

    def hand(self, **command):
        self.server.post("/cell/person", command, "person")

    def test_a_connection_that_is_closed_while_a_hand_leads_the_arm(self):
        self.addCleanup(self.hand, act="release")
        self.measure("guided, close", lambda target: self.led(target, lambda person: person.close()))

    def process(self, target, signals):
        program = Path(__file__).parent / "person_at_controls.py"
        words = [sys.executable, "-B", program, str(self.server.port), json.dumps(target)]
        person = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
        self.assertEqual(person.stdout.readline().strip(), "moves")
        self.wait(moving=True)
        time.sleep(0.8)
        lost = time.time()
        os.kill(person.pid, signals)
        self.addCleanup(person.stdout.close)
        self.addCleanup(person.wait)
        self.addCleanup(person.kill)
        return lost

    def test_a_client_that_is_stopped(self):
        self.measure("SIGSTOP", lambda target: self.process(target, signal.SIGSTOP))

    def test_a_client_that_is_killed(self):
        self.measure("SIGKILL", lambda target: self.process(target, signal.SIGKILL))


if __name__ == "__main__":
    unittest.main()
