"""Components as processes: the same services, killed, stopped and started again while a core goes on."""
import json
import os
import signal
import socket
import struct
import subprocess
import tempfile
import time
import unittest

import models
import test_displays
from client import PATIENCE, PROGRAM, PROJECT, Server, Stream, check

DEMO = str(PROJECT / "deploy/demo")
CALM = ("--heartbeat", "30")  # where nothing hangs: a machine under load may be slow
POSE = {"position": [0.1, 0.2, 0.3], "orientation": [0.0, 0.0, 0.0, 1.0]}


class Process:
    """`race service NAME` for a server; killed with the block."""

    def __init__(self, server, name, *options):
        command = [PROGRAM, "service", name, "--server", f"http://127.0.0.1:{server.port}", *options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def kill(self):
        self.process.kill()
        self.process.wait(PATIENCE)

    def signal(self, number):
        self.process.send_signal(number)


class Wire(Stream):
    """A process of components, byte by byte; what the server says is held against component_message.json."""

    PATH = "/api/v1/components"

    def say(self, message):
        self.send(check("component_request", message))

    def message(self):
        first, second = self.take(2)
        size = second & 0x7F
        if size == 126:
            (size,) = struct.unpack("!H", self.take(2))
        payload = self.take(size)
        if first & 0x0F != 1:
            raise ConnectionError(f"closed: {payload!r}")
        return check("component_message", json.loads(payload))

    def next(self, kind):
        """The next message of this type; pings between are answered, news ignored."""
        while (message := self.message())["type"] != kind:
            assert message["type"] in ("ping", "news"), message
            if message["type"] == "ping":
                self.say({"type": "pong", "number": message["number"]})
        return message


def service(server, key):
    return next(s for s in server.get("/services", "services")["services"] if s["key"] == key)


def wait(what, patience=PATIENCE):
    end = time.monotonic() + patience
    while time.monotonic() < end:
        if what():
            return
        time.sleep(0.005)
    raise AssertionError("it does not come")


def there(server, key, available=True):
    wait(lambda: service(server, key)["available"] == available)


def run(server, document, arguments=None):
    return server.ended(server.core(document, arguments))


class Wired(unittest.TestCase):
    """One connection whose other end is this test."""

    def wire(self, server):
        wire = Wire(server.port)
        self.addCleanup(wire.socket.close)
        return wire

    def hello(self, server, key="db", **changed):
        component = {"key": key, "type": "database", "rsm": service(server, "db")["rsm"], **changed}
        return {"type": "hello", "protocol": 1, "components": [component]}

    def welcome(self, server):
        wire = self.wire(server)
        wire.say(self.hello(server))
        wire.next("welcome")
        there(server, "db")
        return wire

    def test_a_core_takes_its_error_port_when_the_process_dies_in_a_call(self):
        with Server("--remote", "database", *CALM) as server:
            wire = self.welcome(server)
            core = server.core(models.calling("db", "list"))
            call = wire.next("call")
            self.assertEqual((call["key"], call["operation"]), ("db", "list"))
            self.assertEqual(service(server, "db")["pending"][0]["call"], call["call"])
            wire.socket.close()
            ended = server.ended(core)
            self.assertEqual((ended["outcome"], ended["results"]), ("error", {"code": "unavailable"}))
            self.assertEqual(service(server, "db")["pending"], [])

    def test_the_answer_of_a_process_is_that_of_the_service(self):
        with Server("--remote", "database", *CALM) as server:
            wire = self.welcome(server)
            core = server.core(models.reading(), {"key": "pose"})
            call = wire.next("call")
            transition = next(t for t in service(server, "db")["rsm"]["transitions"] if t["operation"] == "get")
            wire.say({"type": "transition", "key": "db", "id": transition["id"], "call": call["call"]})
            wire.say({"type": "result", "key": "db", "call": call["call"], "value": POSE})
            self.assertEqual(server.ended(core)["results"], {"value": POSE})
            self.assertEqual(service(server, "db")["violations"], [])

    def test_who_answers_no_ping_is_lost(self):
        with Server("--remote", "database", "--heartbeat", "1") as server:
            wire = self.welcome(server)
            core = server.core(models.calling("db", "list"))
            wire.next("call")
            self.assertEqual(server.ended(core)["results"], {"code": "unavailable"})
            with self.assertRaises(ConnectionError):
                while True:
                    wire.message()

    def test_a_wrong_hello_is_refused_with_the_reason(self):
        with Server("--remote", "database", *CALM) as server:
            def refusal(hello):
                wire = self.wire(server)
                wire.send(json.dumps(hello))
                error = wire.next("refused")["errors"][0]
                with self.assertRaises(ConnectionError):
                    wire.message()
                return error["path"], error["code"]
            rsm = service(server, "db")["rsm"]
            self.assertEqual(refusal(self.hello(server, key="robot")), ("robot", "not_found"))
            self.assertEqual(refusal(self.hello(server, type="oracle")), ("db", "type"))
            self.assertEqual(refusal(self.hello(server, rsm={**rsm, "operations": rsm["operations"][1:]}))[0], "db")
            self.assertEqual(refusal({**self.hello(server), "protocol": 2}), ("protocol", "version"))
            self.assertEqual(refusal({"type": "pong", "number": 1}), ("type", "type"))
            self.assertEqual(refusal({"type": "sing"}), ("type", "type"))
            self.assertFalse(service(server, "db")["available"])
            self.welcome(server)
            self.assertEqual(refusal(self.hello(server)), ("db", "conflict"))
            self.assertTrue(service(server, "db")["available"])

    def test_who_breaks_the_protocol_is_lost_and_the_server_goes_on(self):
        with Server("--remote", "database", *CALM) as server:
            for broken in ({"type": "event", "key": "robot", "name": "x", "data": 1}, {"type": "result", "key": "db"},
                           {"type": "welcome", "time": 1}):
                wire = self.welcome(server)
                wire.send(json.dumps(broken))
                wire.next("refused")
                there(server, "db", False)

    def test_who_asks_the_screens_for_what_no_display_shows_is_lost_with_its_question(self):
        def ask(wire, function, arguments):
            wire.send(json.dumps({"type": "request", "key": "display", "number": 3, "function": function,
                                  "arguments": arguments}))

        question = {"question": "Go?", "buttons": ["OK"]}
        with Server("--remote", "display", *CALM) as server, server.stream() as shown:
            for function, arguments, path in (("show_image", {"image": "/etc/passwd"}, "image"),
                                              ("ask", {"question": "x" * 2001, "buttons": ["OK"]}, "question"),
                                              ("ask", {**question, "display": "a/b"}, "display"),
                                              ("play", {"sound": "beep"}, "play"), ("take", {"all": True}, "arguments")):
                shown.send(check("stream_request", {"type": "display", "name": "main"}))
                wire = self.wire(server)
                wire.say({"type": "hello", "protocol": 1, "components": [
                    {"key": "display", "type": "display", "rsm": service(server, "display")["rsm"]}]})
                wire.next("welcome")
                ask(wire, "ask", question)
                reply = wire.next("reply")
                self.assertEqual((reply["number"], type(reply["value"])), (3, int), reply)
                shown.until(lambda m: m["data"].get("question", {}).get("id") == reply["value"])
                ask(wire, function, arguments)
                self.assertEqual(wire.next("refused")["errors"][0]["path"], path)
                there(server, "display", False)
                shown.until(lambda m: "question" not in m["data"])

    def test_the_door_lets_no_page_of_another_server_in(self):
        with Server("--remote", "database", *CALM) as server:
            with Wire(server.port, ["Origin: http://elsewhere.example"]) as elsewhere:
                self.assertEqual(elsewhere.status, 403)
            self.assertEqual(server.request("GET", "/api/v1/components")[0], 426)


class Screens:
    """A server whose displays and sounds are the work of two processes."""

    def setUp(self):
        self.server = Server("--remote", "display,audio", *self.HEARTBEAT)
        self.streams = []
        self.processes = {}
        for name in ("display", "audio"):
            self.start(name)

    def tearDown(self):
        for process in self.processes.values():
            process.__exit__()
        super().tearDown()

    def start(self, name):
        if name in self.processes:
            self.processes[name].__exit__()
        self.processes[name] = Process(self.server, name)
        there(self.server, name)

    def gone(self, display, part):
        """The display shows no such part any more."""
        display.until(lambda m: m["kind"] != "error" and part not in m["data"])


class ScreensElsewhere(Screens, test_displays.Displays):
    """All that displays and sounds do, as if their services were in the server."""

    HEARTBEAT = CALM


class ScreensLost(Screens, test_displays.DisplayCase):
    """What becomes of what is shown when the process behind it dies or hangs."""

    HEARTBEAT = ("--heartbeat", "1")

    def asked(self, display):
        """A core that waits for an answer, and its question."""
        core = self.server.core(test_displays.asking("display.ask('Go?')"))
        return core, self.shown(display, "question")

    def answers(self, display):
        """A question is asked and answered."""
        core, question = self.asked(display)
        self.say(display, {"type": "answer", "question": question["id"], "answer": "OK"})
        self.assertEqual(self.server.ended(core)["results"]["answer"], {"answer": "OK", "display": "main"})

    def playing(self, display):
        core = self.server.core(test_displays.asking("audio.play('collision', 1, 20)"))
        return core, self.shown(display, "sound")

    def plays(self, display):
        """A sound is played to its end."""
        core, sound = self.playing(display)
        self.say(display, {"type": "played", "sound": sound["id"]})
        self.assertEqual(self.server.ended(core)["outcome"], "answered")

    def test_the_question_of_a_killed_display_is_taken_away_and_cannot_be_answered(self):
        display = self.display()
        core, question = self.asked(display)
        self.processes["display"].kill()
        self.assertEqual(self.code(core), "unavailable")
        self.gone(display, "question")
        self.say(display, {"type": "answer", "question": question["id"], "answer": "OK"})
        self.assertEqual(display.until(lambda m: m["kind"] == "error")[-1]["data"]["errors"][0]["code"], "conflict")
        self.start("display")
        self.answers(display)
        self.assertEqual(service(self.server, "display")["violations"], [])

    def test_what_was_pressed_while_no_display_was_there_is_not_told_afterwards(self):
        display = self.display()
        self.server.core(test_displays.asking("display.show_text('Insert the part', ['Done', 'Stop'])"))
        self.shown(display, "message")
        self.processes["display"].kill()
        there(self.server, "display", False)
        self.say(display, {"type": "press", "button": "Stop"})
        self.say(display, {"type": "press", "button": "none"})
        display.until(lambda m: m["kind"] == "error")  # the server has got both
        pressed = models.document("pressed", {
            "state": "Root", "results": [{"name": "button"}],
            "actions": [{"when": "svc.display.button", "do": "res.button = svc.display.button.button"}],
            "ports": [{"name": "done", "when": "available(res.button)"}]})
        core = self.server.core(pressed)
        self.start("display")
        self.answers(display)
        self.say(display, {"type": "press", "button": "Done"})
        self.assertEqual(self.server.ended(core)["results"]["button"], "Done")

    def test_a_display_that_hangs_is_lost_with_its_question_and_comes_back(self):
        display = self.display()
        core, _ = self.asked(display)
        self.processes["display"].signal(signal.SIGSTOP)
        self.assertEqual(self.code(core), "unavailable")
        self.gone(display, "question")
        self.processes["display"].signal(signal.SIGCONT)
        there(self.server, "display")
        self.answers(display)

    def test_the_sound_of_a_killed_audio_is_silenced(self):
        display = self.display(sound=True)
        core, _ = self.playing(display)
        self.processes["audio"].kill()
        self.assertEqual(self.code(core), "unavailable")
        self.gone(display, "sound")
        self.start("audio")
        self.plays(display)
        self.assertEqual(service(self.server, "audio")["violations"], [])

    def test_an_audio_that_hangs_is_lost_with_its_sound_and_comes_back(self):
        display = self.display(sound=True)
        core, _ = self.playing(display)
        self.processes["audio"].signal(signal.SIGSTOP)
        self.assertEqual(self.code(core), "unavailable")
        self.gone(display, "sound")
        self.processes["audio"].signal(signal.SIGCONT)
        there(self.server, "audio")
        self.plays(display)


class Processes(unittest.TestCase):
    def test_a_database_of_its_own_answers_and_keeps_its_values_over_a_kill(self):
        with tempfile.TemporaryDirectory() as folder, Server("--remote", "database", *CALM) as server:
            self.assertEqual(run(server, models.calling("db", "list"))["results"], {"code": "unavailable"})
            file = os.path.join(folder, "values.sqlite")
            with Process(server, "database", "--database", file) as process:
                there(server, "db")
                self.assertEqual(run(server, models.storing(), {"key": "pose", "value": POSE})["results"], {"read": POSE})
                process.kill()
                there(server, "db", False)
                self.assertEqual(run(server, models.calling("db", "list"))["results"], {"code": "unavailable"})
            with Process(server, "database", "--database", file):
                there(server, "db")
                self.assertEqual(run(server, models.reading(), {"key": "pose"})["results"], {"value": POSE})
            self.assertEqual(service(server, "db")["violations"], [])

    def test_a_process_that_hangs_is_lost_and_comes_back_when_it_goes_on(self):
        with Server("--remote", "database", "--heartbeat", "1") as server:
            with Process(server, "database") as process:
                there(server, "db")
                process.signal(signal.SIGSTOP)
                self.assertEqual(run(server, models.calling("db", "list"))["results"], {"code": "unavailable"})
                process.signal(signal.SIGCONT)
                there(server, "db")
                self.assertEqual(run(server, models.calling("db", "list"))["outcome"], "result")

    def test_robot_and_gripper_are_one_process(self):
        with Server("--remote", "cell", "--demo", DEMO, *CALM) as server:
            with Process(server, "cell", "--folder", DEMO) as process:
                there(server, "robot")
                there(server, "gripper")
                core = server.core(models.calling("gripper", "state"))
                self.assertEqual(server.ended(core)["outcome"], "result")
                process.kill()
                there(server, "robot", False)
                there(server, "gripper", False)

    def test_pictures_pass_from_process_to_process(self):
        seeing = models.document("seeing", {
            "state": "Root", "entry": "svc.obj_rec.start()",
            "ports": [{"name": "seen", "when": "svc.obj_rec.recognized_objects"},
                      {"name": "error", "when": "svc.obj_rec.start.error"}]})
        with Server("--remote", "cell,recognition", "--demo", DEMO, *CALM) as server:
            with Process(server, "cell", "--folder", DEMO), Process(server, "recognition", "--folder", DEMO):
                there(server, "camera")
                there(server, "obj_rec")
                self.assertEqual(run(server, seeing)["outcome"], "seen")
                self.assertEqual(service(server, "obj_rec")["violations"] + service(server, "camera")["violations"], [])

    def test_a_process_waits_for_its_server_and_ends_when_it_is_told(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        command = [PROGRAM, "service", "database", "--server", f"http://127.0.0.1:{port}"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.assertIn("waits for the server", process.stdout.readline())
        process.terminate()
        self.assertEqual(process.wait(PATIENCE), 0)
        process.stdout.close()

    def test_what_is_wrong_is_said_and_exit_code_2(self):
        with Server(*CALM) as server:
            url = f"http://127.0.0.1:{server.port}"
            for words, reason in ((["database", "--server", url], "no service of this key waits"),
                                  (["oven", "--server", url], "there is no such unit"),
                                  (["database", "--server", "ftp://x"], "http://HOST:PORT"),
                                  (["database"], "cell, recognition, database, display, audio"),
                                  (["cell", "--server", url, "--folder", "/nowhere"], "/nowhere")):
                ended = subprocess.run([PROGRAM, "service", *words], capture_output=True, text=True, timeout=PATIENCE)
                self.assertEqual(ended.returncode, 2, words)
                self.assertIn(reason, ended.stderr)
        ended = subprocess.run([PROGRAM, "serve", "--port", "0", "--remote", "oven"], capture_output=True, text=True,
                               timeout=PATIENCE)
        self.assertEqual(ended.returncode, 2)
        self.assertIn("there is no such unit", ended.stderr)


if __name__ == "__main__":
    unittest.main()
