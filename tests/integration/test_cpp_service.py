"""Services of one's own in C++ (api/cpp): programs at a server. The rules of their parts are in tests/unit/services/remote (cpp_*)."""
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from client import PROJECT, TIMEOUT, Server
from component_process import LONG_HEARTBEAT, service, wait_available
from test_python_service import Program, calling, line_of

BUILD = Path(os.environ.get("RACE_BUILD", PROJECT / "build/release"))
PROGRAM, GRIPPER = BUILD / "tests/integration/cpp_services", BUILD / "tests/integration/gripper_cpp"
SOURCE = PROJECT / "tests/integration/cpp_services.cpp"
TEMPLATE = PROJECT / "api/templates/gripper_cpp"
BUILD_TIME = 180  # seconds


class CppProgram(Program):
    runner = ()

    def __init__(self, case, server, program=PROGRAM, *options):
        super().__init__(case, server, program, *options)


class Programs(unittest.TestCase):
    def start(self, *options, program=PROGRAM, key="grip", **how):
        self.server = Server(*(options or LONG_HEARTBEAT), **how)
        self.addCleanup(self.stop_server)
        started = CppProgram(self, self.server, program)
        wait_available(self.server, key)
        return started

    def stop_server(self):
        self.server.stop()  # the last one

    def results(self, call, name="calling"):
        return self.server.ended(self.server.core(calling(call, name)))["results"]

    def call(self, operation, key="grip", **kwargs):
        return self.server.post(f"/services/{key}/calls", {"operation": operation, "kwargs": kwargs}, "service_response")

    def begin_to_move(self):
        """The core that moves it for some seconds."""
        core = self.server.core(calling("svc.grip.move(0.1)", "moving"))
        self.server.wait_for(lambda: service(self.server, "grip")["state"] == "Moving")
        return core

    def test_its_rsm_is_made_of_the_declaration(self):
        self.start()
        rsm = service(self.server, "grip")["rsm"]
        move = rsm["operations"][0]
        self.assertEqual([each["name"] for each in rsm["operations"]], ["move", "stop", "count", "lie", "fail", "think"])
        self.assertEqual(move["parameters"], [{"name": "width", "type": "number", "unit": "m", "min": 0.0, "max": 0.11},
                                              {"name": "speed", "type": "number", "value": 0.1}])
        self.assertEqual((move["moves"], move["doc"], rsm["operations"][1]["safe"]), (True, "Moves the fingers.", True))
        self.assertEqual((rsm["meta"], rsm["init"], [s["name"] for s in rsm["states"]]), ({"version": "1.2"}, "Ready", ["Ready", "Moving"]))

    def test_its_handlers_answer_calls_and_it_keeps_to_its_rsm(self):
        self.start()
        self.assertEqual(self.results("svc.grip.move(0.002, speed=0.2)")["value"], {"width": 0.002, "speed": 0.2})
        jammed = {"code": "jammed", "message": "the fingers are jammed", "force": 5.0}
        self.assertEqual(self.results("svc.grip.move(0.01)")["error"], jammed)
        self.assertEqual(self.results("svc.grip.move(0.2)")["error"]["code"], "out_of_range")
        self.assertEqual(self.results("svc.grip.move('far')")["error"]["code"], "invalid")
        self.assertEqual(self.results("svc.grip.think()")["value"], "Ready")
        self.assertEqual(self.call("count"), {"result": 0})
        shown = service(self.server, "grip")
        self.assertEqual((shown["state"], shown["pending"]), ("Ready", []))
        self.assertEqual([v["rule"] for v in shown["violations"]], ["type"], "the argument of a task that is a text")

    def test_while_it_is_busy_it_answers_what_reads_and_is_stopped(self):
        self.start()
        core = self.begin_to_move()
        self.assertEqual(self.call("count"), {"result": 0})
        self.assertEqual(self.call("think"), {"result": "Moving"})
        self.assertEqual(self.call("stop"), {"result": None})
        self.assertEqual(self.server.ended(core)["results"]["error"], {"code": "stopped"})
        self.assertEqual(self.results("svc.grip.move(0.001)")["value"]["width"], 0.001)
        self.assertEqual(service(self.server, "grip")["violations"], [])

    def test_calls_that_may_be_concurrent_are_answered_when_each_is_done(self):
        self.start()
        late = self.server.core(calling("svc.patience.wait(0.6)", "late"))
        soon = self.server.core(calling("svc.patience.wait(0.1)", "soon"))
        self.assertEqual(self.server.ended(soon)["results"]["value"], 0.1)
        self.assertEqual(self.server.get(f"/cores/{late}")["status"], "running")
        self.assertEqual(self.server.ended(late)["results"]["value"], 0.6)
        self.assertEqual(service(self.server, "patience")["violations"], [])

    def test_a_call_that_is_taken_in_every_state_and_answered_later_has_the_result_of_its_handler(self):
        self.start()
        self.assertEqual(self.results("svc.patience.begin()")["value"], "begun")
        self.assertEqual(service(self.server, "patience")["violations"], [])

    def test_a_violation_is_shown_at_the_line_of_its_declaration(self):
        program = self.start()
        self.call("lie")
        program.wait_for(rf"cpp_services\.cpp:{line_of('gripper.event(', SOURCE)}: violation: type: event `moved`: .*")

    def test_a_handler_that_fails_is_an_error_and_shown(self):
        program = self.start()
        error = self.call("fail")["error"]
        self.assertEqual((error["code"], error["message"]), ("failed", "nothing"))
        program.wait_for(rf'cpp_services\.cpp:{line_of(chr(34) + "fail" + chr(34), SOURCE)}: error: `fail` has failed: nothing')
        self.assertEqual(self.call("count"), {"result": 0})

    def test_who_is_killed_in_a_call_is_unavailable_and_comes_back(self):
        program = self.start()
        core = self.begin_to_move()
        program.process.kill()
        self.assertEqual(self.server.ended(core)["results"]["error"]["code"], "unavailable")
        wait_available(self.server, "grip", False)
        CppProgram(self, self.server)
        wait_available(self.server, "grip")
        self.assertEqual(self.results("svc.grip.move(0.001)")["value"]["width"], 0.001)

    def test_it_halts_when_the_server_is_lost_and_connects_again(self):
        data = tempfile.TemporaryDirectory()
        self.addCleanup(data.cleanup)
        program = self.start(*LONG_HEARTBEAT, data=data.name)
        port = self.server.port
        self.begin_to_move()
        self.server.kill()
        program.wait_for("grip, patience: lost the server: ")
        self.server = Server(*LONG_HEARTBEAT, data=data.name, port=port)
        wait_available(self.server, "grip")
        self.assertEqual(self.call("count"), {"result": 1}, "`stop` was called, as it is safe")
        self.assertEqual(service(self.server, "grip")["state"], "Ready")
        program.wait_for("grip: connected", 2)

    def test_it_halts_when_the_server_is_silent_and_goes_on(self):
        self.start("--heartbeat", "1")
        self.begin_to_move()
        self.server.process.send_signal(signal.SIGSTOP)
        try:
            time.sleep(2.5)  # it halts after one second
        finally:
            self.server.process.send_signal(signal.SIGCONT)
        self.server.wait_for(lambda: service(self.server, "grip")["available"] and self.call("count").get("result", 0) >= 1)

    def test_ends_on_sigterm_and_is_gone(self):
        program = self.start()
        self.begin_to_move()
        self.assertEqual(program.end(), 0)
        wait_available(self.server, "grip", False)

    def test_who_is_refused_ends_with_the_reason_and_the_line(self):
        program = self.start()
        with self.subTest("the second with the same key"):
            second = CppProgram(self, self.server)
            self.assertEqual(second.process.wait(TIMEOUT), 2)
            place = rf"cpp_services\.cpp:{line_of('Service gripper(', SOURCE)}"
            self.assertRegex(second.said(), rf"{place}: error: grip: conflict: has a process already")
            self.assertIsNone(program.process.poll(), "the first goes on")
        for options, text in ((["--token-file", "/nowhere"], "/nowhere: io: "), (["--sever"], "--sever: syntax: ")):
            with self.subTest(options):
                nobody = CppProgram(self, self.server, PROGRAM, *options)
                self.assertEqual(nobody.process.wait(TIMEOUT), 2)
                self.assertIn(text, nobody.said())


class Templates(unittest.TestCase):
    def test_the_gripper_is_short_and_moves(self):
        self.assertLess(len((TEMPLATE / "gripper.cpp").read_text().splitlines()), 30)
        with Server(*LONG_HEARTBEAT) as server:
            CppProgram(self, server, GRIPPER)
            wait_available(server, "my_gripper")
            self.assertEqual(server.ended(server.core(calling("svc.my_gripper.move(0.1)")))["results"]["value"], {"width": 0.1})
            call = {"operation": "get", "kwargs": {}}
            self.assertEqual(server.post("/services/my_gripper/calls", call, "service_response"), {"result": {"width": 0.1}})
            self.assertEqual(service(server, "my_gripper")["violations"], [])

    def test_is_built_against_a_build_as_its_page_says(self):
        commands = re.findall(r"^cmake .*", (TEMPLATE / "README.md").read_text(), re.MULTILINE)[:2]
        with tempfile.TemporaryDirectory(dir=BUILD) as folder:  # where programs may be executed
            Path(folder, "build").mkdir()
            Path(folder, "build/release").symlink_to(BUILD)
            subprocess.run(["cp", "-r", str(TEMPLATE), f"{folder}/my_gripper"], check=True)
            for command in commands:
                done = subprocess.run(["bash", "-c", command], cwd=folder, env={"PATH": "/usr/bin:/bin"}, check=False,
                                      capture_output=True, text=True, timeout=BUILD_TIME)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with Server(*LONG_HEARTBEAT) as server:
                CppProgram(self, server, Path(folder, "my_gripper/build/gripper"))
                wait_available(server, "my_gripper")

    def test_what_a_program_includes_is_the_standard_library_and_values(self):
        """Boost and nlohmann stay in the library: its header is cheap."""
        seen, waiting = set(), ["api/cpp/race_client/service.h"]
        while waiting:
            name = waiting.pop()
            seen.add(name)
            text = (PROJECT / name).read_text()
            waiting += [each for each in re.findall(r'^#include "([^"]+)"', text, re.MULTILINE) if each not in seen]
            for included in re.findall(r"^#include <([^>]+)>", text, re.MULTILINE):
                self.assertRegex(included, r"^[a-z_]+$", f"{name} includes it")
        self.assertEqual(seen, {"api/cpp/race_client/service.h", "core/value/value.h", "services/types.h"})


if __name__ == "__main__":
    unittest.main()
