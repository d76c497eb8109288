"""The cell as a process: the server shows its world, people and scripts act in it, and it is unavailable without the process."""
import http.client
import json
import signal
import tempfile
import time
import unittest
from pathlib import Path

import test_person
from client import PROJECT, Server, check
from component_process import LONG_HEARTBEAT, ComponentClient, ComponentProcess, service, wait_available
from motions import Arm, moving

DEMO = PROJECT / "deploy/demo"
RED = {"name": "red", "shape": {"box": [0.1, 0.1, 0.1]}, "fixed": False,
       "pose": {"position": [0, 0, 1], "orientation": [0, 0, 0, 1]}}
TABLE = {**RED, "name": "table", "fixed": True}
WORLD = {"scene": {"robots": [], "bodies": [RED, TABLE]}, "files": {}}
NESTED_URDF = "<robot name='r'>" + "<a>" * 300_000 + "</a>" * 300_000 + "</robot>"  # a parser that recurses would not return
CHAINED_URDF = "<robot name='r'><link name='0'/>" + "".join(
    f"<link name='{i}'/><joint name='j{i}' type='fixed'><parent link='{i - 1}'/><child link='{i}'/></joint>"
    for i in range(1, 20_000)) + "</robot>"
NO_HANDS = {"hands": [], "absent": []}


def pose(time=1, **bodies):
    return {"type": "pose", "pose": {"time": time, "joints": {}, "bodies": bodies}}


class RemoteCellTest(unittest.TestCase):
    """A server without a scene of its own; the cell process brings it."""

    OPTIONS = LONG_HEARTBEAT

    def setUp(self):
        self.server = Server("--remote", "cell", *self.OPTIONS)
        self.addCleanup(self.server.stop)

    def start_cell(self):
        process = ComponentProcess(self.server, "cell", "--folder", str(DEMO))
        self.addCleanup(process.__exit__)
        wait_available(self.server, "robot")
        return process

    def assert_unavailable(self):
        """Each request about the world is answered `unavailable` at once."""
        for path in ("/cell", "/cell/lwr_wsg50.urdf", "/cell/person"):
            self.assertEqual(self.server.get(path, status=503)["errors"][0]["code"], "unavailable", path)
        self.server.post("/cell/person", {"act": "release"}, status=503)


class PersonAtRemoteCell(RemoteCellTest, test_person.Person):
    """All tests of a local cell hold for a remote one."""

    def setUp(self):
        RemoteCellTest.setUp(self)
        self.start_cell()
        self.part = next(body["name"] for body in self.server.get("/cell", "scene")["bodies"] if not body["fixed"])


class RemoteWorld(RemoteCellTest):
    def test_scene_and_poses_equal_those_of_a_local_cell(self):
        self.assert_unavailable()
        self.start_cell()
        with Server("--demo", str(DEMO)) as server_with_cell:
            scene = server_with_cell.get("/cell", "scene")
            self.assertEqual(self.server.get("/cell", "scene"), scene)
            urdf = scene["robots"][0]["urdf"]
            self.assertEqual(self.server.get(f"/cell/{urdf}"), server_with_cell.get(f"/cell/{urdf}"))
            with server_with_cell.stream() as local, self.server.stream() as remote:
                for stream in (local, remote):
                    stream.subscribe("cell/pose")
                poses = [stream.until(lambda m: m["channel"] == "cell/pose")[-1]["data"] for stream in (local, remote)]
            for part in ("joints", "bodies"):
                self.assertEqual(*(poses[i][part].keys() for i in range(2)))
        self.server.get("/cell/other.urdf", status=404)

    def test_after_a_kill_the_page_sees_a_new_world(self):
        with self.server.stream() as page:
            page.subscribe("cell/pose")
            process = self.start_cell()
            part = next(body["name"] for body in self.server.get("/cell", "scene")["bodies"] if not body["fixed"])
            self.server.post("/cell/person", {"act": "take", "part": part}, "person")
            self.server.post("/cell/person", {"act": "grab", "body": "link_5", "keep": 60}, "person")
            page.until(lambda m: part not in m["data"]["bodies"] and "hands" in m["data"])
            process.kill()
            wait_available(self.server, "robot", False)
            self.assert_unavailable()
            self.start_cell()
            self.assertEqual(self.server.get("/cell/person", "person"), NO_HANDS)
            page.until(lambda m: part in m["data"]["bodies"] and "hands" not in m["data"])
        self.server.post("/cell/person", {"act": "take", "part": part}, "person")


class LongNames(RemoteCellTest):
    def test_commands_with_long_names_are_refused_and_the_cell_stays(self):
        self.start_cell()
        for act in ({"act": "grab", "body": "@"}, {"act": "push", "body": "@", "force": [0, 1, 0], "duration": 1},
                    {"act": "take", "part": "@"}, {"act": "place", "part": "@"}):
            for length, status in ((200, 404), (201, 400), (2000, 400), (500_000, 400)):
                named = {field: "é" * length if value == "@" else value for field, value in act.items()}
                answer = self.server.post("/cell/person", named, status=status)
                self.assertLess(len(str(answer)), 2000, (act, length))
        self.server.post("/cell/person", {"act": "release", "hand": "é" * 64}, "person")
        self.server.post("/cell/person", {"act": "release", "hand": "é" * 65}, status=422)
        self.assertEqual(self.server.get("/cell/person", "person"), NO_HANDS)


class HangingCell(RemoteCellTest):
    OPTIONS = ("--heartbeat", "1")

    def test_a_command_to_a_hanging_cell_is_answered_unavailable(self):
        process = self.start_cell()
        process.signal(signal.SIGSTOP)
        answer = self.server.post("/cell/person", {"act": "grab", "body": "link_5", "keep": 60}, status=503)
        self.assertEqual(answer["errors"][0]["message"], "the process of the cell is not there")
        process.signal(signal.SIGCONT)
        wait_available(self.server, "robot")
        self.assertEqual(self.server.get("/cell/person", "person"), NO_HANDS)


class HungServer(RemoteCellTest):
    OPTIONS = ("--heartbeat", "1")

    def test_the_arm_stops_when_the_server_is_silent(self):
        self.start_cell()
        arm = Arm(self.server)
        self.addCleanup(arm.close)
        core = self.server.core(moving(speed=0.05))  # for half a minute
        arm.wait(moving=True)
        self.server.process.send_signal(signal.SIGSTOP)
        time.sleep(2.5)
        self.server.process.send_signal(signal.SIGCONT)
        self.assertEqual(self.server.ended(core)["results"], {"code": "stopped"})
        arm.wait(moving=False)
        arm.stands_for(0.5)
        self.assertTrue(service(self.server, "robot")["available"], "it was never lost")
        self.assertEqual(service(self.server, "robot")["violations"], [])


class ResumedCell(RemoteCellTest):
    def test_a_cell_that_resumes_does_not_execute_abandoned_commands(self):
        process = self.start_cell()
        process.signal(signal.SIGSTOP)
        for act in ({"act": "grab", "body": "link_5", "keep": 60}, {"act": "take", "part": "cube_red"}):
            answer = self.server.post("/cell/person", act, status=503)
            self.assertIn("this is not done", answer["errors"][0]["message"])
        process.signal(signal.SIGCONT)
        self.assertEqual(self.server.get("/cell/person", "person"), NO_HANDS)


class OperatorScript(unittest.TestCase):
    def test_it_acts_in_the_cell_and_goes_on_after_a_refused_act(self):
        nothing = {"act": "push", "body": "link_9", "force": [0, 1, 0], "duration": 1}
        script = {**test_person.PUSHES, "acts": [{"doc": "at nothing", "do": nothing}, *test_person.PUSHES["acts"]]}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "operator.json")
            path.write_text(json.dumps(script))
            with Server("--remote", "cell", "--operator", str(path), *LONG_HEARTBEAT) as server:
                with server.stream() as log, ComponentProcess(server, "cell", "--folder", str(DEMO)):
                    log.subscribe("log")
                    wait_available(server, "robot")
                    for name in ("once", "twice"):
                        ended = server.ended(server.core(test_person.waiting(name)))
                        self.assertEqual((ended["status"], ended["outcome"]), ("ended", "done"))
                    refused = "acts/0: at nothing: refused: body: not_found: there is no link or part `link_9`"
                    log.until(lambda m: refused in [entry["text"] for entry in m["data"]["entries"]])


class CellProtocol(RemoteCellTest):
    """The protocol, with this test in the role of the cell process."""

    def hello(self, world):
        client = ComponentClient(self.server)
        self.addCleanup(client.close)
        component = {"key": "gripper", "type": "gripper", "rsm": service(self.server, "gripper")["rsm"]}
        client.send(json.dumps({"type": "hello", "protocol": 1, "components": [component], "world": world}))
        return client

    def act(self, client):
        """Reports ready for the offered command; returns the command."""
        client.send_checked({"type": "ready", "number": client.next("offer")["number"]})
        return client.next("act")

    def welcome(self, world=WORLD):
        client = self.hello(check("component_request", {"type": "hello", "protocol": 1, "components": [
            {"key": "x", "type": "x", "rsm": {}}], "world": world})["world"])
        client.next("welcome")
        wait_available(self.server, "gripper")
        return client

    def refusal(self, client):
        error = client.next("refused")["errors"][0]
        with self.assertRaises(ConnectionError):
            client.message()
        wait_available(self.server, "gripper", False)
        return error["path"], error["code"]

    def test_poses_are_requested_only_while_a_page_watches(self):
        client = self.welcome()
        with self.server.stream() as page:
            page.subscribe("cell/pose")
            self.assertTrue(client.next("watch")["on"])
            client.send_checked(pose(2, red=RED["pose"]))
            self.assertEqual(page.message()["data"], pose(2, red=RED["pose"])["pose"])
        self.assertFalse(client.next("watch")["on"])
        client.send_checked(pose(3))  # was already sent
        again = self.server.stream()
        self.addCleanup(again.close)
        again.subscribe("cell/pose")
        self.assertTrue(client.next("watch")["on"])
        client.close()
        wait_available(self.server, "gripper", False)
        self.assertTrue(self.welcome().next("watch")["on"])

    def test_a_process_without_a_world_gives_a_cell_without_one(self):
        client = self.welcome(None)
        self.assert_unavailable()
        with self.server.stream() as page:
            page.subscribe("cell/pose")
            client.send(json.dumps(pose()))
            self.assertEqual(self.refusal(client), ("type", "not_found"))

    def test_an_invalid_world_is_refused(self):
        def with_body(**changed):
            return {**WORLD, "scene": {"robots": [], "bodies": [{**RED, **changed}]}}

        robot = {"name": "robot", "urdf": "a.urdf", "pose": RED["pose"]}
        for world, path in (
                (1, "world"), ({"scene": WORLD["scene"]}, "files"), ({**WORLD, "extra": 1}, "extra"),
                (with_body(shape={"cone": 1}), "shape"), (with_body(pose=[0, 0, 1]), "pose"),
                (with_body(colour="javascript:"), "colour"), (with_body(shape={"sphere": -1}), "shape"),
                ({**WORLD, "scene": {"robots": [], "bodies": [RED, RED]}}, "world/scene/bodies/1"),
                ({**WORLD, "files": {"passwd": "x"}}, "world/files"),
                ({"scene": {"robots": [robot], "bodies": []}, "files": {"b.urdf": ""}}, "world/files/a.urdf"),
                ({"scene": {"robots": [robot], "bodies": []}, "files": {"a.urdf": "<html/>"}}, "world/files/a.urdf"),
                ({"scene": {"robots": [robot], "bodies": []}, "files": {"a.urdf": NESTED_URDF}}, "world/files/a.urdf"),
                ({"scene": {"robots": [robot], "bodies": []}, "files": {"a.urdf": CHAINED_URDF}}, "world/files/a.urdf")):
            got = self.refusal(self.hello(world))
            self.assertIn(path, got[0], (world, got))
        self.welcome()

    def test_invalid_messages_about_the_world_disconnect_the_process_and_the_server_goes_on(self):
        page = self.server.stream()
        self.addCleanup(page.close)
        page.subscribe("cell/pose")
        at = RED["pose"]
        for message, path in (
                (pose("now"), "time"), (pose(blue=at), "pose/bodies/blue"), (pose(table=at), "pose/bodies/table"),
                (pose(red=[1]), "pose/bodies/red"), ({"type": "pose", "pose": 1}, "pose"),
                ({"type": "pose", "pose": {**pose()["pose"], "hands": [{"hand": "h"}]}}, "hands/0"),
                ({"type": "done", "number": 7, "person": NO_HANDS}, "number"),
                ({"type": "failed", "number": 7, "error": {"path": "", "code": "conflict", "message": ""}}, "number")):
            client = self.welcome()
            client.next("watch")
            client.send(message)
            got = self.refusal(client)
            self.assertIn(path, got[0], (message, got))
        self.assert_unavailable()

    def test_the_answer_to_a_command_is_forwarded_or_disconnects_the_process(self):
        for answer, status, message in (
                ({"type": "failed", "error": {"path": "body", "code": "conflict", "message": "asleep"}}, 409, "asleep"),
                ({"type": "failed", "error": {"path": "", "code": "tired", "message": ""}}, 503, "not there"),
                ({"type": "done", "person": {"hands": [], "absent": ["table"]}}, 503, "not there"),
                ({"type": "done", "person": {"hands": [], "absent": ["red"]}}, 200, "red")):
            client = self.welcome()
            with PendingCommand(self.server, {"act": "push", "body": "x", "force": [0, 1, 0], "duration": 1}) as pending:
                act = self.act(client)
                self.assertEqual((act["act"]["force"], act["act"]["body"]), ([0, 1, 0], "x"))
                client.send(json.dumps({**answer, "number": act["number"]}))
                got = pending.answer()
            self.assertEqual(got[0], status, answer)
            self.assertIn(message, got[1])
            client.close()
            wait_available(self.server, "gripper", False)

    def test_a_grab_carries_its_keep_time(self):
        client = self.welcome()
        for keep in ({}, {"keep": 60}):
            with PendingCommand(self.server, {"act": "grab", "body": "red", **keep}) as pending:
                act = self.act(client)
                self.assertEqual(act["act"]["keep"], keep.get("keep", 0.5))
                client.send_checked({"type": "done", "number": act["number"], "person": NO_HANDS})
                self.assertEqual(pending.answer()[0], 200)


class PendingCommand:
    """A command that is sent now and whose answer is read later."""

    def __init__(self, server, act):
        self.connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=20)
        self.connection.request("POST", "/api/v1/cell/person", json.dumps(check("person_command", act)),
                                {"Content-Type": "application/json"})

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.connection.close()

    def answer(self):
        response = self.connection.getresponse()
        return response.status, response.read().decode()


if __name__ == "__main__":
    unittest.main()
