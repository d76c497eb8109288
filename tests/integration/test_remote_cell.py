"""The cell as a process: the server shows its world, persons and scripts act in it, and nothing is left when it is gone."""
import http.client
import json
import signal
import tempfile
import unittest
from pathlib import Path

import test_person
from client import PROJECT, Server, check
from component_process import LONG_HEARTBEAT, ComponentClient, ComponentProcess, service, wait_available

DEMO = PROJECT / "deploy/demo"
RED = {"name": "red", "shape": {"box": [0.1, 0.1, 0.1]}, "fixed": False,
       "pose": {"position": [0, 0, 1], "orientation": [0, 0, 0, 1]}}
TABLE = {**RED, "name": "table", "fixed": True}
WORLD = {"scene": {"robots": [], "bodies": [RED, TABLE]}, "files": {}}
NESTED = "<robot name='r'>" + "<a>" * 300_000 + "</a>" * 300_000 + "</robot>"  # a parser that recurses would not return
CHAINED = "<robot name='r'><link name='0'/>" + "".join(
    f"<link name='{i}'/><joint name='j{i}' type='fixed'><parent link='{i - 1}'/><child link='{i}'/></joint>"
    for i in range(1, 20_000)) + "</robot>"
NOBODY = {"hands": [], "absent": []}


def pose(time=1, **bodies):
    return {"type": "pose", "pose": {"time": time, "joints": {}, "bodies": bodies}}


class Elsewhere(unittest.TestCase):
    """A server that has no scene of its own, and a cell that has."""

    OPTIONS = LONG_HEARTBEAT

    def setUp(self):
        self.server = Server("--remote", "cell", *self.OPTIONS)
        self.addCleanup(self.server.stop)

    def begin(self):
        process = ComponentProcess(self.server, "cell", "--folder", str(DEMO))
        self.addCleanup(process.__exit__)
        wait_available(self.server, "robot")
        return process

    def away(self):
        """Each question for the world is refused, at once."""
        for path in ("/cell", "/cell/lwr_wsg50.urdf", "/cell/person"):
            self.assertEqual(self.server.get(path, status=503)["errors"][0]["code"], "unavailable", path)
        self.server.post("/cell/person", {"act": "release"}, status=503)


class PersonElsewhere(Elsewhere, test_person.Person):
    """All that a person does, as if the cell were in the server."""

    def setUp(self):
        Elsewhere.setUp(self)
        self.begin()
        self.part = next(body["name"] for body in self.server.get("/cell", "scene")["bodies"] if not body["fixed"])


class World(Elsewhere):
    def test_it_looks_as_it_would_in_the_server(self):
        self.away()
        self.begin()
        with Server("--demo", str(DEMO)) as inside:
            scene = inside.get("/cell", "scene")
            self.assertEqual(self.server.get("/cell", "scene"), scene)
            urdf = scene["robots"][0]["urdf"]
            self.assertEqual(self.server.get(f"/cell/{urdf}"), inside.get(f"/cell/{urdf}"))
            with inside.stream() as here, self.server.stream() as there_:
                for stream in (here, there_):
                    stream.subscribe("cell/pose")
                poses = [stream.until(lambda m: m["channel"] == "cell/pose")[-1]["data"] for stream in (here, there_)]
            for part in ("joints", "bodies"):
                self.assertEqual(*(poses[i][part].keys() for i in range(2)))
        self.server.get("/cell/other.urdf", status=404)

    def test_what_comes_after_a_kill_is_a_new_world_that_the_page_sees(self):
        with self.server.stream() as page:
            page.subscribe("cell/pose")
            process = self.begin()
            part = next(body["name"] for body in self.server.get("/cell", "scene")["bodies"] if not body["fixed"])
            self.server.post("/cell/person", {"act": "take", "part": part}, "person")
            self.server.post("/cell/person", {"act": "grab", "body": "link_5", "keep": 60}, "person")
            page.until(lambda m: part not in m["data"]["bodies"] and "hands" in m["data"])
            process.kill()
            wait_available(self.server, "robot", False)
            self.away()
            self.begin()
            self.assertEqual(self.server.get("/cell/person", "person"), NOBODY)
            page.until(lambda m: part in m["data"]["bodies"] and "hands" not in m["data"])
        self.server.post("/cell/person", {"act": "take", "part": part}, "person")


class Named(Elsewhere):
    def test_an_act_at_what_has_a_name_of_any_length_is_refused_and_the_cell_stays(self):
        self.begin()
        for act in ({"act": "grab", "body": "@"}, {"act": "push", "body": "@", "force": [0, 1, 0], "duration": 1},
                    {"act": "take", "part": "@"}, {"act": "place", "part": "@"}):
            for length, status in ((200, 404), (201, 400), (2000, 400), (500_000, 400)):
                named = {field: "é" * length if value == "@" else value for field, value in act.items()}
                answer = self.server.post("/cell/person", named, status=status)
                self.assertLess(len(str(answer)), 2000, (act, length))
        self.server.post("/cell/person", {"act": "release", "hand": "é" * 64}, "person")
        self.server.post("/cell/person", {"act": "release", "hand": "é" * 65}, status=422)
        self.assertEqual(self.server.get("/cell/person", "person"), NOBODY)


class Hanging(Elsewhere):
    OPTIONS = ("--heartbeat", "1")

    def test_an_act_that_waits_for_a_cell_that_hangs_is_unavailable_when_it_is_lost(self):
        process = self.begin()
        process.signal(signal.SIGSTOP)
        answer = self.server.post("/cell/person", {"act": "grab", "body": "link_5", "keep": 60}, status=503)
        self.assertEqual(answer["errors"][0]["message"], "the process of the cell is not there")
        process.signal(signal.SIGCONT)
        wait_available(self.server, "robot")
        self.assertEqual(self.server.get("/cell/person", "person"), NOBODY)


class Waking(Elsewhere):
    def test_a_cell_that_wakes_does_nothing_that_was_given_up(self):
        process = self.begin()
        process.signal(signal.SIGSTOP)
        for act in ({"act": "grab", "body": "link_5", "keep": 60}, {"act": "take", "part": "cube_red"}):
            answer = self.server.post("/cell/person", act, status=503)
            self.assertIn("this is not done", answer["errors"][0]["message"])
        process.signal(signal.SIGCONT)
        self.assertEqual(self.server.get("/cell/person", "person"), NOBODY)


class Script(unittest.TestCase):
    def test_it_acts_in_the_cell_and_goes_on_over_what_is_refused(self):
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


class Wired(Elsewhere):
    """A cell whose other end is this test."""

    def hello(self, world):
        client = ComponentClient(self.server.port)
        self.addCleanup(client.close)
        component = {"key": "gripper", "type": "gripper", "rsm": service(self.server, "gripper")["rsm"]}
        client.send(json.dumps({"type": "hello", "protocol": 1, "components": [component], "world": world}))
        return client

    def act(self, client):
        """The act that somebody has asked for, for which the process is ready."""
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

    def test_poses_are_wanted_while_a_page_watches(self):
        client = self.welcome()
        with self.server.stream() as page:
            page.subscribe("cell/pose")
            self.assertTrue(client.next("watch")["on"])
            client.say(pose(2, red=RED["pose"]))
            self.assertEqual(page.message()["data"], pose(2, red=RED["pose"])["pose"])
        self.assertFalse(client.next("watch")["on"])
        client.say(pose(3))  # that was on its way
        again = self.server.stream()
        self.addCleanup(again.close)
        again.subscribe("cell/pose")
        self.assertTrue(client.next("watch")["on"])
        client.close()
        wait_available(self.server, "gripper", False)
        self.assertTrue(self.welcome().next("watch")["on"])

    def test_a_process_without_a_world_is_a_cell_without_one(self):
        client = self.welcome(None)
        self.away()
        with self.server.stream() as page:
            page.subscribe("cell/pose")
            client.send(json.dumps(pose()))
            self.assertEqual(self.refusal(client), ("type", "not_found"))

    def test_a_world_that_does_not_fit_is_refused(self):
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
                ({"scene": {"robots": [robot], "bodies": []}, "files": {"a.urdf": NESTED}}, "world/files/a.urdf"),
                ({"scene": {"robots": [robot], "bodies": []}, "files": {"a.urdf": CHAINED}}, "world/files/a.urdf")):
            got = self.refusal(self.hello(world))
            self.assertIn(path, got[0], (world, got))
        self.welcome()

    def test_what_it_says_of_its_world_that_does_not_fit_loses_it_and_the_server_goes_on(self):
        page = self.server.stream()
        self.addCleanup(page.close)
        page.subscribe("cell/pose")
        at = RED["pose"]
        for said, path in (
                (pose("now"), "time"), (pose(blue=at), "pose/bodies/blue"), (pose(table=at), "pose/bodies/table"),
                (pose(red=[1]), "pose/bodies/red"), ({"type": "pose", "pose": 1}, "pose"),
                ({"type": "pose", "pose": {**pose()["pose"], "hands": [{"hand": "h"}]}}, "hands/0"),
                ({"type": "done", "number": 7, "person": NOBODY}, "number"),
                ({"type": "failed", "number": 7, "error": {"path": "", "code": "conflict", "message": ""}}, "number")):
            client = self.welcome()
            client.next("watch")
            client.send(said)
            got = self.refusal(client)
            self.assertIn(path, got[0], (said, got))
        self.away()

    def test_an_answer_to_an_act_reaches_who_acts_or_loses_the_process(self):
        for answer, status, said in (
                ({"type": "failed", "error": {"path": "body", "code": "conflict", "message": "asleep"}}, 409, "asleep"),
                ({"type": "failed", "error": {"path": "", "code": "tired", "message": ""}}, 503, "not there"),
                ({"type": "done", "person": {"hands": [], "absent": ["table"]}}, 503, "not there"),
                ({"type": "done", "person": {"hands": [], "absent": ["red"]}}, 200, "red")):
            client = self.welcome()
            with Asking(self.server, {"act": "push", "body": "x", "force": [0, 1, 0], "duration": 1}) as asking:
                act = self.act(client)
                self.assertEqual((act["act"]["force"], act["act"]["body"]), ([0, 1, 0], "x"))
                client.send(json.dumps({**answer, "number": act["number"]}))
                got = asking.answer()
            self.assertEqual(got[0], status, answer)
            self.assertIn(said, got[1])
            client.close()
            wait_available(self.server, "gripper", False)

    def test_a_hand_says_how_long_it_stays(self):
        client = self.welcome()
        for keep in ({}, {"keep": 60}):
            with Asking(self.server, {"act": "grab", "body": "red", **keep}) as asking:
                act = self.act(client)
                self.assertEqual(act["act"]["keep"], keep.get("keep", 0.5))
                client.send_checked({"type": "done", "number": act["number"], "person": NOBODY})
                self.assertEqual(asking.answer()[0], 200)


class Asking:
    """An act that is sent now, and whose answer is read later."""

    def __init__(self, server, act):
        self.connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=20)
        self.connection.request("POST", "/api/v1/cell/person", json.dumps(check("person_act", act)),
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
