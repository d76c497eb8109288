"""Services of one's own in Python (race_client.service): programs at a server, and the rules of their parts without one."""
import asyncio
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

import models
from client import TIMEOUT, Server
from component_process import LONG_HEARTBEAT, service, token_file, wait_available
from python_clients import LIBRARY

from race_client.service import DeclarationError, Service, operation
from race_client.service.arguments import check_arguments
from race_client.service.declaration import Declaration
from race_client.service.hosted import MAX_CALLS, Hosted
from race_client.service.machine import Machine, Resolved
from race_client.service.session import MAX_OUT, Session
from race_client.service.values import check_value, checked_error

HERE = Path(__file__).resolve().parent
PROGRAM = HERE / "python_gripper.py"


class Program:
    """A service as a program; what it prints is in a file."""

    runner: tuple[str, ...] = ("/usr/bin/python3", "-B")

    def __init__(self, case, server, program=PROGRAM, *options):
        held = tempfile.TemporaryDirectory()
        case.addCleanup(held.cleanup)
        self.case, self.output = case, Path(held.name, "output")
        command = [*self.runner, str(program), "--server", f"http://127.0.0.1:{server.port}",
                   "--token-file", str(token_file(server)), *options]
        with open(self.output, "w") as file:
            self.process = subprocess.Popen(command, stdout=file, stderr=file, env={"PYTHONPATH": str(LIBRARY), "PATH": "/usr/bin:/bin"})
        case.addCleanup(self.end)

    def end(self, number=signal.SIGTERM):
        """Its exit status."""
        self.process.send_signal(number)
        try:
            return self.process.wait(TIMEOUT)
        finally:
            self.process.kill()
            self.process.wait()

    def said(self):
        return self.output.read_text()

    def wait_for(self, pattern, count=1):
        end = time.monotonic() + TIMEOUT
        while len(found := re.findall(pattern, self.said())) < count:
            self.case.assertLess(time.monotonic(), end, f"no {pattern} in: {self.said()}")
            time.sleep(0.02)
        return found[-1]


def line_of(text, program=PROGRAM):
    """The number of the first line of the program that has this text."""
    return next(number for number, line in enumerate(program.read_text().splitlines(), 1) if text in line)


def calling(call, name="calling"):
    """A task that makes one call: `result` with its value, or `error` with the error."""
    answer = call.partition("(")[0]
    return models.document(name, {
        "state": "Root", "entry": call, "results": [{"name": "value"}, {"name": "error"}],
        "actions": [{"when": f"{answer}.result", "do": f"res.value = {answer}.result"},
                    {"when": f"{answer}.error", "do": f"res.error = {answer}.error"}],
        "ports": [{"name": "result", "when": "available(res.value)"}, {"name": "error", "when": "available(res.error)"}]})


class Programs(unittest.TestCase):
    def start(self, *options, **how):
        self.server = Server(*(options or LONG_HEARTBEAT), **how)
        self.addCleanup(self.stop_server)
        program = Program(self, self.server)
        wait_available(self.server, "grip")
        return program

    def stop_server(self):
        """The one that runs then."""
        self.server.stop()

    def results(self, call, name="calling"):
        return self.server.ended(self.server.core(calling(call, name)))["results"]

    def call(self, operation, **kwargs):
        return self.server.post("/services/grip/calls", {"operation": operation, "kwargs": kwargs}, "service_response")

    def test_its_rsm_is_made_of_the_class(self):
        self.start()
        rsm = service(self.server, "grip")["rsm"]
        move = rsm["operations"][0]
        self.assertEqual([each["name"] for each in rsm["operations"]], ["move", "stop", "count", "lie", "fail", "think"])
        self.assertEqual(move["parameters"], [{"name": "width", "type": "number", "unit": "m", "min": 0.0, "max": 0.11},
                                              {"name": "speed", "type": "number", "value": 0.1}])
        self.assertEqual((move["moves"], move["doc"], rsm["operations"][1]["safe"]), (True, "Moves the fingers.", True))
        self.assertEqual((rsm["meta"], rsm["init"], [s["name"] for s in rsm["states"]]), ({"version": "1.2"}, "Ready", ["Ready", "Moving"]))

    def test_its_methods_answer_calls_and_it_keeps_to_its_rsm(self):
        self.start()
        self.assertEqual(self.results("svc.grip.move(0.002, speed=0.2)")["value"], {"width": 0.002, "speed": 0.2})
        jammed = {"code": "jammed", "message": "the fingers are jammed", "force": 5.0}
        self.assertEqual(self.results("svc.grip.move(0.01)")["error"], jammed)
        self.assertEqual(self.results("svc.grip.move(0.2)")["error"]["code"], "out_of_range")
        self.assertEqual(self.results("svc.grip.move('far')")["error"]["code"], "invalid")
        self.assertEqual(self.results("svc.grip.think(0.01)")["value"], "Ready")
        self.assertEqual(self.call("count"), {"result": 0})
        shown = service(self.server, "grip")
        self.assertEqual((shown["state"], shown["pending"]), ("Ready", []))
        self.assertEqual([v["rule"] for v in shown["violations"]], ["type"], "the argument of a task that is a text")

    def test_while_it_is_busy_it_rejects_answers_what_reads_and_is_stopped(self):
        self.start()
        core = self.server.core(calling("svc.grip.move(0.1)", "moving"))
        self.server.wait_for(lambda: service(self.server, "grip")["state"] == "Moving")
        self.assertEqual(self.results("svc.grip.move(0.001)", "second")["error"]["code"], "leased", "another run has it")
        self.assertEqual(self.call("count"), {"result": 0})
        self.assertEqual(self.call("think", seconds=0.01), {"result": "Moving"})
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

    def test_a_call_that_is_taken_in_every_state_and_answered_later_has_the_result_of_its_method(self):
        self.start()
        self.assertEqual(self.results("svc.patience.begin()")["value"], "begun")
        self.assertEqual(service(self.server, "patience")["violations"], [])

    def test_a_violation_is_shown_at_the_line_of_its_declaration(self):
        program = self.start()
        self.call("lie")
        program.wait_for(rf"python_gripper\.py:{line_of('events = ')}: violation: type: event `moved`: .*")

    def test_a_method_that_fails_is_an_error_and_shown(self):
        program = self.start()
        error = self.call("fail")["error"]
        self.assertEqual((error["code"], error["message"]), ("failed", "KeyError: 'nothing'"))
        program.wait_for(rf"python_gripper\.py:{line_of('def fail') - 1}: error: `fail` has failed")
        self.assertEqual(self.call("count"), {"result": 0})

    def test_it_halts_when_the_server_is_lost_and_connects_again(self):
        data = tempfile.TemporaryDirectory()
        self.addCleanup(data.cleanup)
        program = self.start(*LONG_HEARTBEAT, data=data.name)
        port = self.server.port
        self.server.core(calling("svc.grip.move(0.1)", "moving"))
        self.server.wait_for(lambda: service(self.server, "grip")["state"] == "Moving")
        self.server.kill()
        program.wait_for("grip, patience: ")
        self.server = Server(*LONG_HEARTBEAT, data=data.name, port=port)
        wait_available(self.server, "grip")
        self.assertEqual(self.call("count"), {"result": 1}, "`stop` was called, as it is safe")
        self.assertEqual(service(self.server, "grip")["state"], "Ready")
        program.wait_for("grip: connected", 2)

    def test_it_halts_when_the_server_is_silent_and_goes_on(self):
        program = self.start("--heartbeat", "1")
        self.server.core(calling("svc.grip.move(0.1)", "moving"))
        self.server.wait_for(lambda: service(self.server, "grip")["state"] == "Moving")
        self.server.process.send_signal(signal.SIGSTOP)
        program.wait_for("the server is silent: services halt")
        self.server.process.send_signal(signal.SIGCONT)
        wait_available(self.server, "grip")
        self.server.wait_for(lambda: service(self.server, "grip")["available"] and self.call("count").get("result", 0) >= 1)

    def test_ends_on_sigterm_and_is_gone(self):
        program = self.start()
        self.assertEqual(program.end(), 0)
        wait_available(self.server, "grip", False)

    def test_who_is_refused_ends_with_the_reason_and_the_line(self):
        with Server(*LONG_HEARTBEAT) as server, tempfile.TemporaryDirectory() as folder:
            named = Path(folder, "named.py")
            named.write_text(PROGRAM.read_text().replace('key = "grip"', 'key = "timer"'))
            shutil.copy(HERE / "patience.rsm.json", folder)
            program = Program(self, server, named)
            self.assertEqual(program.process.wait(TIMEOUT), 2)
            self.assertIn(f"named.py:{line_of('class Gripper')}: error: timer: not_found: no service of this key waits", program.said())
            nobody = Program(self, server, PROGRAM, "--token-file", "/nowhere")
            self.assertEqual(nobody.process.wait(TIMEOUT), 2)
            self.assertIn("/nowhere", nobody.said())


class Reloading(unittest.TestCase):
    def test_saved_code_is_taken_over_and_a_slip_is_not(self):
        with Server(*LONG_HEARTBEAT) as server, tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "gripper.py")
            path.write_text(PROGRAM.read_text())
            shutil.copy(HERE / "patience.rsm.json", folder)
            program = Program(self, server, path, "--reload")
            wait_available(server, "grip")
            path.write_text(PROGRAM.read_text().replace('"1.2"', '"1.3"').replace("def count", "def number"))
            server.wait_for(lambda: service(server, "grip")["available"] and service(server, "grip")["rsm"]["meta"] == {"version": "1.3"})
            self.assertIn("number", [each["name"] for each in service(server, "grip")["rsm"]["operations"]])
            path.write_text(path.read_text() + "\ndef broken(:\n")
            program.wait_for(r"gripper\.py:\d+: error: invalid syntax; what was saved before goes on")
            self.assertTrue(service(server, "grip")["available"])
            path.write_text("raise SystemExit(3)\n")
            program.wait_for("it has ended with status 3")
            wait_available(server, "grip", False)
            path.write_text(PROGRAM.read_text())
            server.wait_for(lambda: service(server, "grip")["available"] and service(server, "grip")["rsm"]["meta"] == {"version": "1.2"})
            self.assertEqual(program.end(signal.SIGINT), 0)
            wait_available(server, "grip", False)

    def reloaded(self, server, text):
        """A program with this text that begins anew when a file is saved: itself, and its file."""
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        path = Path(held.name, "gripper.py")
        path.write_text(text)
        shutil.copy(HERE / "patience.rsm.json", path.parent)
        return Program(self, server, path, "--reload"), path

    def wait_version(self, server, version):
        server.wait_for(lambda: (grip := service(server, "grip")) and grip["available"] and grip["rsm"]["meta"] == {"version": version})

    def test_what_is_saved_while_it_starts_is_taken_over(self):
        saving = ('own = Path(__file__)\nif "--reload" not in sys.argv and not own.with_name("saved").exists():\n'
                  '    own.with_name("saved").touch()\n    own.write_text(own.read_text().replace(\'"1.2"\', \'"1.3"\'))\n\n')
        with Server(*LONG_HEARTBEAT) as server:
            self.reloaded(server, PROGRAM.read_text().replace("if __name__", saving + "if __name__"))
            self.wait_version(server, "1.3")

    def test_it_does_not_begin_anew_while_another_file_has_a_slip(self):
        with Server(*LONG_HEARTBEAT) as server:
            program, path = self.reloaded(server, PROGRAM.read_text())
            self.wait_version(server, "1.2")
            (path.parent / "other.json").write_text("{")
            program.wait_for(r"other\.json:1: error: ")
            path.write_text(PROGRAM.read_text().replace('"1.2"', '"1.3"'))
            program.wait_for(r"other\.json:1: error: ", 2)
            (path.parent / "other.json").write_text("{}")
            self.wait_version(server, "1.3")
            self.assertEqual(len(re.findall("saved: begins anew", program.said())), 1)

    def test_a_module_that_is_saved_twice_in_a_second_is_read_anew(self):
        def save(version, time_ns):
            new = path.parent / "version.new"
            new.write_text(f'VERSION = "{version}"\n')
            os.utime(new, ns=(time_ns, time_ns))
            new.replace(path.parent / "version.py")

        text = PROGRAM.read_text().replace('version = "1.2"', "version = VERSION")
        with Server(*LONG_HEARTBEAT) as server, tempfile.TemporaryDirectory() as folder:
            compiling = mock.patch.object(Program, "runner", ("/usr/bin/python3", "-X", f"pycache_prefix={folder}/compiled"))
            path = Path(folder, "gripper.py")
            save("1.2", 1_700_000_000_000_000_000)
            path.write_text(text.replace("import sys\n", "import sys\nfrom version import VERSION\n", 1))
            shutil.copy(HERE / "patience.rsm.json", folder)
            with compiling:
                Program(self, server, path, "--reload")
            self.wait_version(server, "1.2")
            save("1.3", 1_700_000_000_500_000_000)
            self.wait_version(server, "1.3")


class Declarations(unittest.TestCase):
    def refusal(self, service):
        with self.assertRaises(DeclarationError) as raised:
            Declaration(service)
        return str(raised.exception)

    def test_what_is_wrong_is_named_with_its_line(self):
        class Nameless(Service):
            pass

        class Wrong(Service):
            key = "wrong"

            @operation(parameters={"width": {"unit": "m"}})
            def move(self, speed):
                pass

        class Idle(Service):
            key = "idle"

            @operation(stops="Moving")
            def stop(self):
                pass

        class Restless(Service):
            key = "restless"

            @operation(busy="Moving")
            def move(self):
                pass

            @operation(busy="Waiting", stops="Moving")
            def wait(self):
                pass

        class Loud(Service):
            key = "loud"
            rsm = {"rsm": 1, "name": "loud", "operations": [{"name": "log"}], "events": []}

        class Absent(Service):
            key = "absent"
            rsm = {"rsm": 1, "name": "absent", "operations": [{"name": "go"}], "events": []}

        class Fileless(Service):
            key = "fileless"
            rsm = "nowhere.rsm.json"

        for wrong, text in ((Nameless, "class Nameless"), (Wrong, '@operation(parameters={"width"'), (Idle, '@operation(stops="Moving")'),
                            (Restless, '@operation(busy="Waiting"'), (Loud, '[{"name": "log"}]'), (Absent, '{"name": "go"}')):
            line = next(n for n, each in enumerate(Path(__file__).read_text().splitlines(), 1) if text in each)
            self.assertRegex(self.refusal(wrong), rf"test_python_service\.py:{line}: error: ", wrong)
        self.assertIn("nowhere.rsm.json:1: error: ", self.refusal(Fileless))

    def test_a_violation_is_about_the_line_of_the_name_in_a_file(self):
        sys.path.insert(0, str(HERE))
        self.addCleanup(sys.path.remove, str(HERE))
        import python_gripper
        declaration = Declaration(python_gripper.Timer)
        wait = next(n for n, line in enumerate((HERE / "patience.rsm.json").read_text().splitlines(), 1) if '"wait"' in line)
        self.assertEqual(declaration.where("wait"), f"{HERE / 'patience.rsm.json'}:{wait}")
        over = declaration.where_violated({"operation": "", "message": "`over` waits for no call"})
        self.assertRegex(over, r"patience\.rsm\.json:\d+$")


class Rules(unittest.TestCase):
    """core/SEMANTICS.md, section 5."""

    def machine(self, *transitions):
        return Machine({"states": [{"name": "A"}, {"name": "B"}], "init": "A", "transitions": list(transitions)})

    def test_the_first_transition_of_the_present_state_takes_a_call(self):
        go = {"id": "go", "src": "A", "dst": "B", "operation": "go"}
        anywhere = {"id": "anywhere", "dst": "A", "operation": "go"}
        machine = self.machine(go, anywhere)
        self.assertIs(machine.accepting("go"), go)
        machine.take(go, 1)
        self.assertIs(machine.accepting("go"), anywhere)
        self.assertIsNone(machine.accepting("stay"))

    def test_a_later_call_supersedes_an_earlier_one(self):
        go = {"id": "go", "src": "A", "dst": "A", "operation": "go", "defer": ["done"]}
        done = {"id": "done", "src": "A", "dst": "A"}
        machine = self.machine(go, done)
        self.assertEqual(machine.take(go, 1), ([], 0))
        self.assertEqual(machine.take(go, 2), ([], 1))
        self.assertEqual(machine.take(done), ([Resolved(2, None)], 0))
        self.assertEqual(machine.take(done), ([], 0))

    def test_concurrent_calls_are_answered_one_by_one_or_all(self):
        wait = {"id": "wait", "src": "A", "dst": "A", "operation": "wait", "defer": ["over", "end"], "concurrent": True}
        over, end = {"id": "over", "src": "A", "dst": "A"}, {"id": "end", "dst": "A", "error": "ended"}
        machine = self.machine(wait, over, end)
        for call in (1, 2, 3, 4):
            machine.take(wait, call)
        self.assertEqual(machine.take(over, 3)[0], [Resolved(3, None)])
        self.assertEqual(machine.take(over)[0], [Resolved(1, None)])
        self.assertEqual(machine.take(end)[0], [Resolved(2, "ended"), Resolved(4, "ended")])

    def test_an_operation_ends_the_earliest_of_concurrent_calls(self):
        wait = {"id": "wait", "src": "A", "dst": "A", "operation": "wait", "defer": ["stop"], "concurrent": True}
        stop = {"id": "stop", "src": "A", "dst": "A", "operation": "stop", "error": "stopped"}
        machine = self.machine(wait, stop)
        for call in (1, 2):
            machine.take(wait, call)
        self.assertEqual(machine.take(stop, 3)[0], [Resolved(1, "stopped")])

    def test_an_error_leads_by_the_transition_of_its_code(self):
        go = {"id": "go", "src": "A", "dst": "B", "operation": "go", "defer": ["jam", "done", "stop"]}
        jam, done = {"id": "jam", "src": "B", "dst": "A", "error": "jammed"}, {"id": "done", "src": "B", "dst": "A"}
        machine = self.machine(go, jam, done, {"id": "stop", "src": "B", "dst": "A", "operation": "stop"})
        machine.take(go, 1)
        self.assertIs(machine.ending(go, "jammed"), jam)
        self.assertIs(machine.ending(go, "other"), done)
        self.assertIs(machine.ending(go, None), done)

    def test_arguments_are_held_against_the_parameters(self):
        def move(width, name="x", on=False):
            pass

        parameters = [{"name": "width", "type": "number", "min": 0, "max": 1, "unit": "m"}, {"name": "name", "type": "string"},
                      {"name": "on", "type": "bool"}]
        for args, kwargs, code in (([], {}, "invalid"), ([1, 2, 3, 4], {}, "invalid"), ([0.5], {"speed": 1}, "invalid"),
                                   ([-0.1], {}, "out_of_range"), ([1.1], {}, "out_of_range"), ([True], {}, "invalid"),
                                   (["1"], {}, "invalid"), ([1], {"name": 5}, "invalid"), ([1], {"on": 1}, "invalid")):
            self.assertEqual(check_arguments(move, parameters, args, kwargs)["code"], code, (args, kwargs))
        for args, kwargs in (([0], {}), ([1.0, "y", True], {}), ([], {"width": 0.5, "on": True})):
            self.assertIsNone(check_arguments(move, parameters, args, kwargs))
        self.assertEqual(check_arguments(move, parameters, [2], {})["message"], "`width` must be at least 0 and at most 1 m")


class Bounds(unittest.TestCase):
    def test_a_value_that_the_server_would_not_read_is_none(self):
        for value in (float("nan"), float("inf"), 2**63, -(2**64), "\ud800", {"\udc00": 1}, {1, 2}, [object()]):
            with self.assertRaises((TypeError, ValueError)):
                check_value(value)
        for value in (None, 0, -(2**63), 1e21, "\U0001f600", {"a": [{"b": 1.5}]}):
            check_value(value)
        self.assertIn("its `code` is no text", checked_error({"code": 5})["message"])
        self.assertEqual(checked_error({"code": "jammed", "force": float("inf")})["code"], "failed")

    def test_what_the_server_does_not_take_is_bounded(self):
        class Socket:
            closed = 0

            def close(self):
                self.closed += 1

        socket = Socket()
        session = Session(socket, [])
        for _ in range(MAX_OUT):
            session.say({})
        self.assertEqual(socket.closed, 0)
        session.say({})
        self.assertEqual(socket.closed, 1)

    def test_a_hundred_are_at_work_and_no_more(self):
        class Busy(Service):
            key = "busy"

            @operation
            async def wait(self):
                await self.end.wait()

            @operation
            async def answer(self, value: int):
                return value

        async def talk():
            service, said = Busy(), []
            service.end = asyncio.Event()
            hosted = Hosted(service)
            hosted.connected(said.append)

            def call(number, name, *args):
                hosted.received({"type": "call", "key": "busy", "call": number, "operation": name, "args": list(args), "kwargs": {}})

            for number in range(1, MAX_CALLS + 1):
                call(number, "wait")
            call(101, "answer", 5)
            self.assertEqual((said[-1]["call"], said[-1]["error"]["code"]), (101, "too_many"))
            service.end.set()
            while len([each for each in said if each["type"] == "result"]) < MAX_CALLS:
                await asyncio.sleep(0.001)
            await asyncio.sleep(0)  # the last task ends
            call(102, "answer", 5)
            while said[-1].get("value") != 5:
                await asyncio.sleep(0.001)
            call(103, "nothing")
            self.assertEqual(said[-1], {"key": "busy", "type": "reject", "call": 103})

        asyncio.run(asyncio.wait_for(talk(), TIMEOUT))


class Silence(unittest.TestCase):
    """What is under way when nothing was heard for too long, without a server."""

    def after_silence(self, service, *names):
        """(the state, the answer of each call) of a service that is called, and then hears nothing."""
        async def talk():
            said = []
            hosted = Hosted(service)
            hosted.connected(said.append)
            for number, name in enumerate(names, 1):
                hosted.received({"type": "call", "key": service.key, "call": number, "operation": name, "args": [], "kwargs": {}})
            while len(service.begun) < len(names):
                await asyncio.sleep(0.001)
            await hosted.silent()
            while len(set(service.ended)) < len(names):
                await asyncio.sleep(0.001)
            answers = {each["call"]: each for each in said if each["type"] in ("result", "error")}
            return hosted.state, [answers[number].get("error", {}).get("code", "result") for number, _ in enumerate(names, 1)]

        service.begun, service.ended = [], []
        return asyncio.run(asyncio.wait_for(talk(), TIMEOUT))

    def test_silence_ends_what_is_under_way_but_for_what_is_safe(self):
        class Cart(Service):
            key = "cart"

            async def work(self, seconds):
                self.begun.append(seconds)
                try:
                    await asyncio.sleep(seconds)
                finally:
                    self.ended.append(seconds)

            @operation(moves=True, busy="Lifting")
            async def lift(self):
                await self.work(600)

            @operation(moves=True)
            async def drive(self):
                await self.work(601)

            @operation(moves=True)
            def roll(self):
                self.begun.append(602)
                try:
                    self.pause(602)
                finally:
                    self.ended.append(602)

            @operation(safe=True)
            async def brake(self):
                await self.work(0.1)

        class Simple(Cart):
            rsm = {"rsm": 1, "name": "simple", "events": [],
                   "operations": [{"name": "drive", "moves": True, "error": "any"}, {"name": "brake", "safe": True, "error": "any"}]}

        ended = ("Ready", ["stopped", "stopped", "stopped", "result"])
        self.assertEqual(self.after_silence(Cart(), "lift", "drive", "roll", "brake"), ended)
        self.assertEqual(self.after_silence(Simple(), "drive", "brake"), ("", ["stopped", "result"]))


if __name__ == "__main__":
    unittest.main()
