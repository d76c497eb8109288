"""The Python client library, plain and asyncio, with real servers: what api/conversations cannot say: races, bounds, lost servers."""
import shutil
import tempfile
import time
import unittest

import models
from client import TIMEOUT, Server
from python_clients import KINDS, race_client
from test_tls import LanServer

RaceError = race_client.RaceError


def sets(core_state):
    """A state whose lists have no order, for comparison."""
    state = core_state["state"]
    return {**state, "active": set(state["active"]), "ports": set(state["ports"]),
            "activated": {path: set(ports) for path, ports in state["activated"].items()}}


def until_over(race, core):
    """The core once a request tells its end, too: the stream may have told it a moment before."""
    end = time.monotonic() + TIMEOUT
    while (now := race.cores.get(core))["status"] in ("ready", "running") and time.monotonic() < end:
        time.sleep(0.02)
    return now


class Conversation(unittest.TestCase):
    """What both clients have: `connect` makes one."""

    connect = None

    def client(self, server=None, **how):
        client = self.connect(f"http://127.0.0.1:{(server or self.server).port}", **how)
        self.addCleanup(client.close)
        return client

    def refused(self, status, code, function, *arguments, **named):
        with self.assertRaises(RaceError) as caught:
            function(*arguments, **named)
        self.assertEqual((caught.exception.status, caught.exception.code), (status, code), str(caught.exception))
        return caught.exception


class WithServer(Conversation):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()
        cls.addClassCleanup(cls.server.stop)

    def setUp(self):
        self.race = self.client()


class Requests:
    def test_what_is_no_json_is_not_sent(self):
        with self.assertRaises(ValueError):
            self.race.documents.put("nan", {"rcm": float("nan")})
        with self.assertRaises(TypeError):
            self.race.documents.put("object", {"rcm": object()})
        with self.assertRaises(ValueError):
            self.race.send(race_client.calls.get_document("ticking", if_none_match='"1"\r\nX-Evil: 1'))

    def test_a_token_with_other_characters_is_not_sent(self):
        for token in ("", "a b", "a\r\nX-Evil: 1", "ä"):
            with self.assertRaises(ValueError):
                self.client(token=token)


class Runs:
    def core(self, document):
        self.race.documents.put(document["name"], document)
        return self.race.cores.create(document["name"])["id"]

    def test_folded_deltas_are_the_state_of_a_run_at_any_time(self):
        core = self.core(models.hurrying("folded"))
        with self.race.cores.follow(core, quiet=TIMEOUT) as updates:
            self.race.cores.start(core)
            for step in (5, 40, 80):
                while (update := next(updates)).state["core"]["step"] < step:
                    pass
                self.race.cores.pause(core)
                self.server.wait(core, lambda c: c["paused"] and c["micro"] == 0)
                state = self.race.cores.state(core)
                while update.state["core"]["step"] < state["core"]["step"]:
                    update = next(updates)
                self.assertEqual(sets(update.state), sets(state))
                self.assertIn("Root", update.state["state"]["active"])
                self.race.cores.resume(core)
            self.assertEqual(self.race.cores.abort(core)["status"], "aborted")
            self.assertEqual(list(updates)[-1].state["core"]["status"], "aborted")

    def test_derivations_come_page_by_page(self):
        core = self.core(models.hurrying("long"))
        self.race.cores.start(core)
        self.server.wait(core, lambda c: c["step"] > 230)
        self.race.cores.abort(core)
        last = self.race.cores.get(core)["step"]
        steps = list(self.race.cores.derivations(core))
        self.assertEqual([each["step"] for each in steps], list(range(1, last + 1)))
        self.assertEqual(steps[0]["micro"][0]["rule"], self.server.get(f"/cores/{core}/derivations?from=1")["steps"][0]["micro"][0]["rule"])
        self.assertEqual([each["step"] for each in self.race.cores.derivations(core, first=99, last=102)], [99, 100, 101, 102])
        self.assertEqual(list(self.race.runs.derivations(core, first=200)), steps[199:])
        self.refused(404, "not_found", list, self.race.runs.derivations("987654"))

    def test_a_wait_that_is_too_short_says_so_and_the_run_goes_on(self):
        core = self.core(models.hurrying("waited"))
        self.race.cores.start(core)
        begun = time.monotonic()
        refused = self.refused(0, "timeout", self.race.cores.wait, core, timeout=0.5)
        self.assertLess(time.monotonic() - begun, 3)
        self.assertEqual(refused.message, f"core {core} is not over after 0.5 s: its status is running")
        self.assertEqual(self.race.cores.abort(core)["status"], "aborted")
        self.assertEqual(self.race.cores.wait(core, timeout=TIMEOUT)["status"], "aborted")

    def test_a_slow_reader_loses_steps_but_not_the_state_or_the_connection(self):
        core = self.core(models.hurrying("fast"))
        with self.race.cores.follow(core, quiet=TIMEOUT, capacity=20) as updates:
            self.assertEqual(next(updates).kind, "snapshot")
            self.race.cores.start(core)
            time.sleep(2)
            self.race.cores.abort(core)
            time.sleep(1)
            heard = list(updates)
        self.assertLessEqual(len(heard), 21)
        self.assertEqual(heard[0].kind, "snapshot")
        self.assertGreater(heard[0].merged, 20)
        self.assertEqual({each.kind for each in heard[1:]} - {"delta", "snapshot"}, set())
        self.assertEqual(sets(heard[-1].state), sets(self.race.cores.state(core)))


class Restarts(Conversation):
    def restart(self, server, data):
        """SIGKILL, some time, and another server at the same address."""
        server.kill()
        time.sleep(0.7)
        again = Server(data=data, port=server.port)
        self.addCleanup(again.stop)
        return again


class Restarted:
    def test_a_client_that_follows_is_told_that_the_server_was_away_and_goes_on(self):
        data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, data)
        server = Server(data=data)
        race = self.client(server)
        race.documents.put("ticking", models.ticking(last=8))
        core = race.cores.create("ticking")["id"]
        with race.cores.follow(core, quiet=TIMEOUT) as updates:
            race.cores.start(core)
            while next(updates).state["state"]["results"].get("Root", {}).get("n", 0) < 2:
                pass
            self.restart(server, data)
            kinds = []
            while (update := next(updates)).kind != "snapshot":
                kinds.append(update)
            self.assertEqual([each.kind for each in kinds if each.kind != "delta"], ["disconnected", "connected"])
            self.assertRegex(next(each.reason for each in kinds if each.kind == "disconnected"), "closed|reached|reset")
            self.assertEqual((update.state["core"]["status"], update.state["core"]["interruption"]["reason"]), ("interrupted", "restart"))
            race.cores.resume(core)
            last = list(updates)[-1].state
        self.assertEqual((last["core"]["outcome"], last["core"]["results"]), ("done", {"n": 8}))
        self.assertEqual(until_over(race, core), last["core"])

    def test_a_server_that_does_not_come_back_ends_it(self):
        data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, data)
        server = Server(data=data)
        race = self.client(server)
        race.documents.put("ticking", models.ticking())
        core = race.cores.create("ticking")["id"]
        with race.cores.follow(core, patience=0.5) as updates:
            self.assertEqual(next(updates).kind, "snapshot")
            server.kill()
            self.assertEqual(next(updates).kind, "disconnected")
            self.refused(0, "connection", next, updates)
        self.assertIn(f"http://127.0.0.1:{server.port} cannot be reached", self.unreached(race))
        with self.assertRaises(RaceError) as caught, race.cores.follow(core):
            pass
        self.assertEqual(caught.exception.code, "connection")

    def unreached(self, race):
        """The message of a client without a server; it shows nothing of the libraries below."""
        error = self.refused(0, "connection", race.health)
        self.assertFalse(error.may_be_done)
        self.assertTrue(error.__cause__ is None and error.__suppress_context__)
        return str(error)


class Network(Conversation):
    @classmethod
    def setUpClass(cls):
        cls.server = LanServer()
        cls.addClassCleanup(cls.server.stop)

    def secure(self, **how):
        """A client of its address in the network."""
        name = next((each for each in self.server.names if not each.endswith(".local")), None)
        self.assertIsNotNone(name, "the server is reached by an address")
        host = f"[{name}]" if ":" in name else name
        race = self.connect(f"https://{host}:{self.server.lan_port}", **how)
        self.addCleanup(race.close)
        return race


class Tls:
    def test_a_server_is_known_by_its_authority(self):
        race = self.secure(ca_file=self.server.authority, token=self.server.admin)
        race.documents.put("ticking", models.ticking())
        core = race.cores.create("ticking", {"last": 2})["id"]
        race.cores.start(core)
        self.assertEqual(race.cores.wait(core, timeout=TIMEOUT)["results"], {"n": 2})
        self.assertEqual([each["name"] for each in race.documents.all()], ["ticking"])

    def test_a_server_that_is_not_known_gets_nothing(self):
        stranger = self.secure(token=self.server.admin)
        self.assertFalse(self.refused(0, "certificate", stranger.health).may_be_done)
        with self.assertRaises(RaceError) as caught, stranger.cores.follow("1"):
            pass
        self.assertEqual(caught.exception.code, "certificate")

    def test_a_wrong_address_is_said_before_anything_is_sent(self):
        for url in ("http://192.0.2.1:8080", "ftp://127.0.0.1", "127.0.0.1:8080", "http://127.0.0.1:8080/api", "http://a:b@127.0.0.1"):
            with self.assertRaises(ValueError):
                self.connect(url)
        with self.assertRaises(ValueError):
            self.secure(ca_file=__file__)


BASES = {WithServer: (Requests, Runs), Restarts: (Restarted,), Network: (Tls,)}
for base, conversations in BASES.items():
    for conversation in conversations:
        for kind, connect in KINDS.items():
            case = type(f"{conversation.__name__}_{kind}", (conversation, base), {"connect": staticmethod(connect)})
            globals()[case.__name__] = case


if __name__ == "__main__":
    unittest.main()
