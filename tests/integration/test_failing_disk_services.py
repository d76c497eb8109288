"""What a run has set in motion is told to stop when its journal is not stored, because the disk fails or hangs, by nobody's
call; it moves again when a person resumes it."""
import time
import unittest

import models
from client import PROJECT, TIMEOUT, Stream, check
from component_process import LONG_HEARTBEAT, ComponentClient
from crash_scenario import Connection
from traced_server import STORE, TracedServer, data_folder

# The journal's entry fails; each tick of the timer is one.
FULL, HANGING = "error=ENOSPC:when=25+", "delay_enter=30000000:when=25"  # microseconds
DEMO = PROJECT / "deploy/demo"


def busy(call, answered):
    """Calls once, and counts ticks meanwhile; ends when the call is `answered`, with the code of its error."""
    return models.document("busy", {
        "state": "Root", "entry": call, "results": [{"name": "n", "initial": 0}, {"name": "code"}],
        "actions": [{"when": "svc.timer.tick", "do": "res.n = res.n + 1"},
                    {"when": f"{answered}.error", "do": f"res.code = {answered}.error.code"}],
        "ports": [{"name": "result", "when": f"{answered}.result"}, {"name": "error", "when": "available(res.code)"}]})


class Services(unittest.TestCase):
    def server(self, fault, *options):
        data = data_folder()
        assert TracedServer(data, options=options).stop()[0] == 0  # its files are made
        server = TracedServer(data, inject=fault, calls=("fdatasync",), files=STORE, options=options)
        self.addCleanup(server.remove)
        self.connection = Connection(server.port)
        self.addCleanup(self.connection.close)
        return server

    def start(self, document):
        self.connection.expect("PUT", "/documents/busy", document)
        core = self.connection.expect("POST", "/cores", {"document": "busy", "arguments": {}})["id"]
        self.connection.expect("POST", f"/cores/{core}/start")
        return core

    def core(self, core):
        return check("core", self.connection.get(f"/cores/{core}"))

    def wait(self, core, status):
        while (now := self.core(core))["status"] == "running":
            pass
        self.assertEqual(now["status"], status)
        return now

    def test_safe_operations_are_called_when_the_journal_fails(self):
        server = self.server(FULL, "--remote", "audio", *LONG_HEARTBEAT)
        with ComponentClient(server) as audio:
            rsm, = (s["rsm"] for s in self.connection.get("/services")["services"] if s["key"] == "audio")
            audio.send_checked({"type": "hello", "protocol": 1, "components": [{"key": "audio", "type": "audio", "rsm": rsm}]})
            audio.next("welcome")
            core = self.start(busy("svc.audio.play('beep')", "svc.audio.play"))
            self.assertEqual(audio.next("call")["operation"], "play")
            self.assertEqual(self.wait(core, "interrupted")["interruption"]["reason"], "storage")
            self.assertEqual(self.next_call(audio), "stop")
            server.end_faults()
            self.connection.expect("POST", f"/cores/{core}/resume")
            self.assertEqual(self.wait(core, "ended")["results"]["code"], "unavailable")

    def test_the_robot_stops_when_the_journal_fails(self):
        self.check_stopped(FULL, 0.1)

    def test_the_robot_stops_when_the_disk_hangs(self):
        self.check_stopped(HANGING, 0.02)

    def check_stopped(self, fault, speed):
        server = self.server(fault, "--demo", str(DEMO))
        begin = self.height()
        core = self.start(busy(f"svc.robot.move({{'offset': [0.0, 0.0, -0.2]}}, kind='lin', speed={speed})", "svc.robot.move"))
        self.assertEqual(self.wait(core, "interrupted")["interruption"]["reason"], "storage")
        stopped = self.at_rest(server)
        self.assertEqual(self.connection.request("POST", f"/cores/{core}/resume", {})[0], 507)
        server.end_faults()
        way = begin - self.height()
        self.assertTrue(0.001 < way < 0.15, f"it moved {way} m of 0.2 m")
        self.resume(core)
        self.assertEqual(self.wait(core, "ended")["results"]["code"], "unavailable")
        self.assertEqual(self.at_rest(server), stopped)

    def resume(self, core):
        """As soon as the disk has answered."""
        end = time.monotonic() + TIMEOUT
        while (answer := self.connection.request("POST", f"/cores/{core}/resume"))[0] == 507:
            self.assertLess(time.monotonic(), end, "the disk does not answer")
        self.assertEqual(answer[0], 200, answer)

    def next_call(self, audio):
        """The operation that is called next, if it is called soon."""
        end = time.monotonic() + TIMEOUT
        while (message := audio.message())["type"] != "call":
            self.assertLess(time.monotonic(), end, "nothing is called")
            if message["type"] == "ping":
                audio.send_checked({"type": "pong", "number": message["number"]})
        return message["operation"]

    def height(self):
        """Of the tool centre point [m]."""
        core = self.start(models.document("busy", {
            "state": "Root", "results": [{"name": "z"}], "ports": [{"name": "seen", "when": "available(res.z)"}],
            "actions": [{"when": "svc.robot.robot_state", "do": "res.z = svc.robot.robot_state.pose.position[2]"}]}))
        return self.wait(core, "ended")["results"]["z"]

    def at_rest(self, server):
        """The angles of the joints [rad, to 0.1 mrad], once they have been the same in ten poses from now on."""
        with Stream(server.port) as stream:
            stream.subscribe("cell/pose")
            same, last = 0, None
            while same < 10:
                now = stream.until(lambda m: m["channel"] == "cell/pose")[-1]["data"]["joints"]
                now = {name: round(angle, 4) for name, angle in now.items()}
                same = same + 1 if now == last else 0
                last = now
        return last


if __name__ == "__main__":
    unittest.main()
