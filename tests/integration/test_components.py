"""Services as processes of their own: killed, stopped and started again while a core goes on; and a process that is this test."""
import json
import os
import signal
import socket
import subprocess
import tempfile
import unittest

import models
import test_displays
from client import PROGRAM, PROJECT, TIMEOUT, Server
from component_process import (LONG_HEARTBEAT, ComponentClient, ComponentProcess, component_client, service, token_file,
                               wait_available)
from traced_server import LOG_LINE

DEMO = str(PROJECT / "deploy/demo")
POSE = {"position": [0.1, 0.2, 0.3], "orientation": [0.0, 0.0, 0.0, 1.0]}


def run(server, document, arguments=None):
    return server.ended(server.core(document, arguments))


class ComponentProtocol(unittest.TestCase):
    """The protocol of components, with this test in the role of the process."""

    def connect(self, server):
        client = ComponentClient(server)
        self.addCleanup(client.close)
        return client

    def hello(self, server, key="db", **changed):
        component = {"key": key, "type": "database", "rsm": service(server, "db")["rsm"], **changed}
        return {"type": "hello", "protocol": 1, "components": [component]}

    def welcome(self, server):
        client = self.connect(server)
        client.send_checked(self.hello(server))
        client.next("welcome")
        wait_available(server, "db")
        return client

    def test_a_core_takes_its_error_port_when_the_process_dies_in_a_call(self):
        with Server("--remote", "database", *LONG_HEARTBEAT) as server:
            client = self.welcome(server)
            core = server.core(models.calling("db", "list"))
            call = client.next("call")
            self.assertEqual((call["key"], call["operation"]), ("db", "list"))
            self.assertEqual(service(server, "db")["pending"][0]["call"], call["call"])
            client.close()
            ended = server.ended(core)
            self.assertEqual((ended["outcome"], ended["results"]), ("error", {"code": "unavailable"}))
            self.assertEqual(service(server, "db")["pending"], [])

    def test_the_answer_of_a_process_is_the_answer_of_the_service(self):
        with Server("--remote", "database", *LONG_HEARTBEAT) as server:
            client = self.welcome(server)
            core = server.core(models.reading(), {"key": "pose"})
            call = client.next("call")
            transition = next(t for t in service(server, "db")["rsm"]["transitions"] if t["operation"] == "get")
            client.send_checked({"type": "transition", "key": "db", "id": transition["id"], "call": call["call"]})
            client.send_checked({"type": "result", "key": "db", "call": call["call"], "value": POSE})
            self.assertEqual(server.ended(core)["results"], {"value": POSE})
            self.assertEqual(service(server, "db")["violations"], [])

    def test_a_process_that_answers_no_ping_is_disconnected(self):
        with Server("--remote", "database", "--heartbeat", "2") as server:
            client = self.welcome(server)
            core = server.core(models.calling("db", "list"))
            client.next("call")
            self.assertEqual(server.ended(core)["results"], {"code": "unavailable"})
            with self.assertRaises(ConnectionError):
                while True:
                    client.message()

    def test_a_wrong_hello_is_refused_with_the_reason(self):
        with Server("--remote", "database", *LONG_HEARTBEAT) as server:
            def refusal(hello):
                client = self.connect(server)
                client.send(hello)
                error = client.next("refused")["errors"][0]
                with self.assertRaises(ConnectionError):
                    client.message()
                return error["path"], error["code"]
            rsm = service(server, "db")["rsm"]
            self.assertEqual(refusal(self.hello(server, key="timer")), ("timer", "not_found"))
            self.assertEqual(refusal(self.hello(server, type="oracle")), ("db", "type"))
            self.assertEqual(refusal(self.hello(server, rsm={**rsm, "operations": rsm["operations"][1:]}))[0], "db")
            self.assertEqual(refusal({**self.hello(server), "protocol": 2}), ("protocol", "version"))
            self.assertEqual(refusal({"type": "pong", "number": 1}), ("type", "type"))
            self.assertEqual(refusal({"type": "sing"}), ("type", "type"))
            self.assertFalse(service(server, "db")["available"])
            self.welcome(server)
            self.assertEqual(refusal(self.hello(server)), ("db", "conflict"))
            self.assertTrue(service(server, "db")["available"])

    def test_a_protocol_violation_disconnects_the_process_and_the_server_goes_on(self):
        with Server("--remote", "database", *LONG_HEARTBEAT) as server:
            for broken in ({"type": "event", "key": "robot", "name": "x", "data": 1}, {"type": "result", "key": "db"},
                           {"type": "welcome", "time": 1}):
                client = self.welcome(server)
                client.send(broken)
                client.next("refused")
                wait_available(server, "db", False)

    def test_an_invalid_display_request_disconnects_the_process_and_removes_its_question(self):
        def ask(client, function, arguments):
            client.send(json.dumps({"type": "request", "key": "display", "number": 3, "function": function,
                                  "arguments": arguments}))

        question = {"question": "Go?", "buttons": ["OK"]}
        with Server("--remote", "display", *LONG_HEARTBEAT) as server, server.stream() as shown:
            for function, arguments, path in (("show_image", {"image": "/etc/passwd"}, "image"),
                                              ("ask", {"question": "x" * 2001, "buttons": ["OK"]}, "question"),
                                              ("ask", {**question, "display": "a/b"}, "display"),
                                              ("play", {"sound": "beep"}, "play"), ("take", {"all": True}, "arguments")):
                shown.send_checked({"type": "display", "name": "main"})
                client = component_client(server, "display")
                self.addCleanup(client.close)
                ask(client, "ask", question)
                reply = client.next("reply")
                self.assertEqual((reply["number"], type(reply["value"])), (3, int), reply)
                shown.until(lambda m, value=reply["value"]: m["data"].get("question", {}).get("id") == value)
                ask(client, function, arguments)
                self.assertEqual(client.next("refused")["errors"][0]["path"], path)
                wait_available(server, "display", False)
                shown.until(lambda m: "question" not in m["data"])

    def test_a_foreign_origin_is_refused(self):
        with Server("--remote", "database", *LONG_HEARTBEAT) as server:
            with ComponentClient(server, origin="http://foreign.example") as foreign:
                self.assertEqual(foreign.status, 403)
            own = {"Authorization": f"Bearer {token_file(server).read_text().strip()}"}
            self.assertEqual(server.request("GET", "/api/v1/components", headers=own)[0], 426)


class RemoteDisplayServer:
    """A server whose services display and audio are processes."""

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
        self.processes[name] = ComponentProcess(self.server, name)
        wait_available(self.server, name)

    def wait_removed(self, display, part):
        """Waits until the display no longer shows this part."""
        display.until(lambda m: m["kind"] != "error" and part not in m["data"])


class RemoteDisplays(RemoteDisplayServer, test_displays.Displays):
    """All tests of local displays and sounds hold for remote ones."""

    HEARTBEAT = LONG_HEARTBEAT


class RemoteDisplayFailures(RemoteDisplayServer, test_displays.DisplayCase):
    """What displays show is removed when the process behind it dies or hangs."""

    HEARTBEAT = ("--heartbeat", "2")

    def ask(self, display):
        """Starts a core that asks; returns the core and the question."""
        core = self.server.core(test_displays.asking("display.ask('Go?')"))
        return core, self.shown(display, "question")

    def ask_and_answer(self, display):
        """Asks a question and answers it."""
        core, question = self.ask(display)
        display.send_checked({"type": "answer", "question": question["id"], "answer": "OK"})
        self.assertEqual(self.server.ended(core)["results"]["answer"], {"answer": "OK", "display": "main"})

    def start_sound(self, display):
        core = self.server.core(test_displays.asking("audio.play('collision', 1, 20)"))
        return core, self.shown(display, "sound")

    def play_to_end(self, display):
        """Plays a sound to its end."""
        core, sound = self.start_sound(display)
        display.send_checked({"type": "played", "sound": sound["id"]})
        self.assertEqual(self.server.ended(core)["outcome"], "answered")

    def test_the_question_of_a_killed_display_is_removed_and_cannot_be_answered(self):
        display = self.display()
        core, question = self.ask(display)
        self.processes["display"].kill()
        self.assertEqual(self.code(core), "unavailable")
        self.wait_removed(display, "question")
        display.send_checked({"type": "answer", "question": question["id"], "answer": "OK"})
        self.assertEqual(display.until(lambda m: m["kind"] == "error")[-1]["data"]["errors"][0]["code"], "conflict")
        self.start("display")
        self.ask_and_answer(display)
        self.assertEqual(service(self.server, "display")["violations"], [])

    def test_buttons_pressed_without_a_display_service_are_dropped(self):
        display = self.display()
        self.server.core(test_displays.asking("display.show_text('Insert the part', ['Done', 'Stop'])"))
        self.shown(display, "message")
        self.processes["display"].kill()
        wait_available(self.server, "display", False)
        display.send_checked({"type": "press", "button": "Stop"})
        display.send_checked({"type": "press", "button": "none"})
        display.until(lambda m: m["kind"] == "error")  # the server has got both
        pressed = models.document("pressed", {
            "state": "Root", "results": [{"name": "button"}],
            "actions": [{"when": "svc.display.button", "do": "res.button = svc.display.button.button"}],
            "ports": [{"name": "done", "when": "available(res.button)"}]})
        core = self.server.core(pressed)
        self.start("display")
        self.ask_and_answer(display)
        display.send_checked({"type": "press", "button": "Done"})
        self.assertEqual(self.server.ended(core)["results"]["button"], "Done")

    def test_a_hanging_display_loses_its_question_and_reconnects(self):
        display = self.display()
        core, _ = self.ask(display)
        self.processes["display"].signal(signal.SIGSTOP)
        self.assertEqual(self.code(core), "unavailable")
        self.wait_removed(display, "question")
        self.processes["display"].signal(signal.SIGCONT)
        wait_available(self.server, "display")
        self.ask_and_answer(display)

    def test_the_sound_of_a_killed_audio_process_stops(self):
        display = self.display(sound=True)
        core, _ = self.start_sound(display)
        self.processes["audio"].kill()
        self.assertEqual(self.code(core), "unavailable")
        self.wait_removed(display, "sound")
        self.start("audio")
        self.play_to_end(display)
        self.assertEqual(service(self.server, "audio")["violations"], [])

    def test_a_hanging_audio_process_loses_its_sound_and_reconnects(self):
        display = self.display(sound=True)
        core, _ = self.start_sound(display)
        self.processes["audio"].signal(signal.SIGSTOP)
        self.assertEqual(self.code(core), "unavailable")
        self.wait_removed(display, "sound")
        self.processes["audio"].signal(signal.SIGCONT)
        wait_available(self.server, "audio")
        self.play_to_end(display)


class Processes(unittest.TestCase):
    def test_a_database_process_keeps_its_values_over_a_kill(self):
        with tempfile.TemporaryDirectory() as folder, Server("--remote", "database", *LONG_HEARTBEAT) as server:
            self.assertEqual(run(server, models.calling("db", "list"))["results"], {"code": "unavailable"})
            file = os.path.join(folder, "values.sqlite")
            with ComponentProcess(server, "database", "--database", file) as process:
                wait_available(server, "db")
                self.assertEqual(run(server, models.storing(), {"key": "pose", "value": POSE})["results"], {"read": POSE})
                process.kill()
                wait_available(server, "db", False)
                self.assertEqual(run(server, models.calling("db", "list"))["results"], {"code": "unavailable"})
            with ComponentProcess(server, "database", "--database", file):
                wait_available(server, "db")
                self.assertEqual(run(server, models.reading(), {"key": "pose"})["results"], {"value": POSE})
            self.assertEqual(service(server, "db")["violations"], [])

    def test_a_hanging_process_is_disconnected_and_reconnects(self):
        with Server("--remote", "database", "--heartbeat", "2") as server:
            with ComponentProcess(server, "database") as process:
                wait_available(server, "db")
                process.signal(signal.SIGSTOP)
                self.assertEqual(run(server, models.calling("db", "list"))["results"], {"code": "unavailable"})
                process.signal(signal.SIGCONT)
                wait_available(server, "db")
                self.assertEqual(run(server, models.calling("db", "list"))["outcome"], "result")

    def test_robot_and_gripper_are_one_process(self):
        with Server("--remote", "cell", "--demo", DEMO, *LONG_HEARTBEAT) as server:
            with ComponentProcess(server, "cell", "--folder", DEMO) as process:
                wait_available(server, "robot")
                wait_available(server, "gripper")
                core = server.core(models.calling("gripper", "state"))
                self.assertEqual(server.ended(core)["outcome"], "result")
                process.kill()
                wait_available(server, "robot", False)
                wait_available(server, "gripper", False)

    def test_pictures_pass_from_process_to_process(self):
        seeing = models.document("seeing", {
            "state": "Root", "entry": "svc.obj_rec.start()",
            "ports": [{"name": "seen", "when": "svc.obj_rec.recognized_objects"},
                      {"name": "error", "when": "svc.obj_rec.start.error"}]})
        with Server("--remote", "cell,recognition", "--demo", DEMO, *LONG_HEARTBEAT) as server:
            with ComponentProcess(server, "cell", "--folder", DEMO), ComponentProcess(server, "recognition", "--folder", DEMO):
                wait_available(server, "camera")
                wait_available(server, "obj_rec")
                self.assertEqual(run(server, seeing)["outcome"], "seen")
                self.assertEqual(service(server, "obj_rec")["violations"] + service(server, "camera")["violations"], [])

    def test_a_process_waits_for_its_server_and_ends_on_sigterm(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        command = [PROGRAM, "service", "database", "--server", f"http://127.0.0.1:{port}"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            line = process.stderr.readline()
            self.assertRegex(line, LOG_LINE)
            self.assertIn(f" info database: waits for the server at http://127.0.0.1:{port}: ", line)
            process.terminate()
            self.assertEqual(process.wait(TIMEOUT), 0)
            self.assertEqual(process.stdout.read(), "")

    def test_wrong_use_is_reported_with_exit_code_2(self):
        with Server(*LONG_HEARTBEAT) as server:
            url = f"http://127.0.0.1:{server.port}"
            for words, reason in ((["database", "--server", url], "no service of this key waits"),
                                  (["oven", "--server", url], "there is no such component group"),
                                  (["database", "--server", "ftp://x"], "http://HOST:PORT"),
                                  (["database"], "cell, recognition, database, display, audio"),
                                  (["cell", "--server", url, "--folder", "/nowhere"], "/nowhere")):
                token = ("--token-file", str(token_file(server)))
                ended = subprocess.run([PROGRAM, "service", *words, *token], capture_output=True, text=True, timeout=TIMEOUT, check=False)
                self.assertEqual(ended.returncode, 2, words)
                self.assertIn(reason, ended.stderr)
        ended = subprocess.run([PROGRAM, "serve", "--port", "0", "--remote", "oven"], capture_output=True, text=True,
                               timeout=TIMEOUT, check=False)
        self.assertEqual(ended.returncode, 2)
        self.assertIn("there is no such component group", ended.stderr)


if __name__ == "__main__":
    unittest.main()
