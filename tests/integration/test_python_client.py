"""The Python client library: one list of conversations, held with a real server by the plain client and by the asyncio client."""
import shutil
import tempfile
import time
import unittest

import models
from accounts import PASSWORD, AccountServer
from client import TIMEOUT, Server
from python_clients import KINDS, race_client
from test_tls import LanServer

RaceError, ServiceError = race_client.RaceError, race_client.ServiceError


def wrong(name="wrong"):
    """A document with a violation of structure and one of code."""
    document = models.ticking(name)
    document["root"]["first"] = "Nowhere"
    document["root"]["ports"][0]["when"] = "res.n >="
    return document


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


class Documents:
    def test_a_wrong_document_is_checked_as_it_is_refused(self):
        found = self.race.documents.check(wrong())
        self.assertEqual([(each["path"], each["code"]) for each in found], [("Root", "first"), ("Root.done", "syntax")])
        self.assertEqual(found[0]["message"], "`first`: there is no child `Nowhere`")
        self.assertEqual((found[1]["text"], found[1]["line"]), ("when", 1))
        refused = self.refused(422, "first", self.race.documents.put, "wrong", wrong())
        self.assertEqual((refused.errors, refused.path, refused.message), (found, "Root", found[0]["message"]))
        self.assertIn("Root.done: syntax: ", str(refused))

    def test_a_check_stores_nothing(self):
        self.assertEqual(self.race.documents.check(models.ticking("unstored"), name="unstored"), [])
        self.refused(404, "not_found", self.race.documents.get, "unstored")
        stored = self.race.documents.put("kept", models.ticking("kept"))
        changed = models.ticking("kept", last=7)
        self.assertEqual(self.race.documents.check(changed, name="kept"), [])
        self.assertEqual(self.race.documents.get("kept"), stored)

    def test_a_document_is_put_under_a_condition(self):
        first = self.race.documents.put("held", models.ticking("held"), is_new=True, author="Ada", message="begin")
        self.assertEqual((first["revision"], first["author"], first["message"], first["errors"]), (1, "Ada", "begin", []))
        self.refused(412, "conflict", self.race.documents.put, "held", models.ticking("held"), is_new=True)
        second = self.race.documents.put("held", models.ticking("held", last=6), if_revision=1)
        self.refused(412, "conflict", self.race.documents.put, "held", models.ticking("held", last=7), if_revision=1)
        self.assertEqual(self.race.documents.get("held"), second)
        self.assertEqual(self.race.documents.get("held", revision=1)["document"], first["document"])
        self.assertEqual([each["revision"] for each in self.race.documents.revisions("held")["revisions"]], [2, 1])
        self.refused(412, "conflict", self.race.documents.delete, "held", if_revision=1)
        self.assertEqual(self.race.documents.delete("held", if_revision=2), {"removed": "held"})

    def test_a_draft_keeps_its_violations(self):
        draft = self.race.documents.put("draft", wrong("draft"), draft=True)
        self.assertEqual(draft["errors"], self.race.documents.check(wrong("draft")))
        self.assertIn(("draft", 2), [(each["name"], each["errors"]) for each in self.race.documents.all()])
        self.refused(422, "first", self.race.cores.create, "draft")

    def test_an_edit_is_made_once_and_refused_by_what_others_did(self):
        root = self.race.documents.put("edited", models.ticking("edited"))["document"]["root"]["meta"]["id"]
        change = [{"op": "set", "id": root, "field": "doc", "value": "counts"}]
        accepted = self.race.documents.edit("edited", change, revision=1, request="e1", author="Ada")
        self.assertEqual((accepted["revision"], accepted["author"], accepted["operations"]), (2, "Ada", change))
        self.assertEqual(self.race.documents.edit("edited", change, revision=1, request="e1", author="Ada"), accepted)
        other = [{**change[0], "value": "counts ticks"}]
        self.assertEqual(self.race.documents.edit("edited", other, revision=1)["revision"], 3, "rebased")
        ping = self.race.documents.get("edited")["document"]["root"]["children"][0]["meta"]["id"]
        self.race.documents.edit("edited", [{"op": "remove", "id": ping}], revision=3, author="Ada")
        late = [{"op": "set", "id": ping, "field": "doc", "value": "late"}]
        refused = self.refused(409, "conflict", self.race.documents.edit, "edited", late, revision=3, author="Bob")
        self.assertEqual(refused.path, "operations/0/id")
        self.assertIn("Ada", refused.message)
        self.assertEqual(self.race.documents.get("edited")["document"]["root"]["doc"], "counts ticks")

    def test_names_are_one_part_of_a_path(self):
        for name in ("a?draft=true", "a#b", "%2e%2e", "ä b"):
            with self.subTest(name):
                refused = self.refused(422, "name", self.race.documents.put, name, models.ticking())
                self.assertEqual(refused.errors[0]["path"], name)
        self.refused(404, "not_found", self.race.documents.put, "a/../../cores", models.ticking())

    def test_what_is_no_json_is_not_sent(self):
        with self.assertRaises(ValueError):
            self.race.documents.put("nan", {"rcm": float("nan")})
        with self.assertRaises(TypeError):
            self.race.documents.put("object", {"rcm": object()})
        with self.assertRaises(ValueError):
            self.race.send(race_client.calls.get_document("ticking", if_none_match='"1"\r\nX-Evil: 1'))


class Runs:
    def core(self, document, arguments=None):
        self.race.documents.put(document["name"], document)
        return self.race.cores.create(document["name"], arguments)["id"]

    def test_a_run_with_arguments_is_followed_to_its_end(self):
        core = self.core(models.storing(), {"key": "at_creation"})
        value = {"position": [0.1, 0.2, 0.3]}
        with self.race.cores.follow(core, quiet=TIMEOUT) as updates:
            first = next(updates)
            self.assertEqual((first.kind, first.state["core"]["status"]), ("snapshot", "ready"))
            self.assertEqual(self.race.cores.start(core, {"key": "pose", "value": value})["status"], "running")
            heard = list(updates)
            self.assertIsNone(updates.next(), "its end stays its end")
        self.assertEqual({each.kind for each in heard}, {"delta"})
        self.assertEqual([call["operation"] for each in heard for call in each.delta["calls"]], ["add", "get"])
        last = heard[-1].state
        self.assertEqual((last["core"]["outcome"], last["core"]["results"]), ("success", {"read": value}))
        self.assertEqual(until_over(self.race, core), last["core"])
        self.assertEqual(sets(last), sets(self.race.cores.state(core)))
        self.assertEqual(self.race.runs.get(core)["results"], {"read": value})
        self.assertEqual(self.race.cores.wait(core, timeout=TIMEOUT), last["core"])

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

    def test_a_run_that_faults_says_why(self):
        self.race.documents.put("faulty", models.faulty())
        core = self.race.cores.run("faulty", timeout=TIMEOUT)
        self.assertEqual((core["status"], core["fault"]["kind"], core["fault"]["at"]), ("faulted", "zero_division", "Root"))

    def test_a_quiet_core_is_no_error_unless_asked_for(self):
        core = self.core(models.ticking("quiet"))
        with self.race.cores.follow(core, quiet=0.3) as updates:
            self.assertEqual(next(updates).kind, "snapshot")
            self.refused(0, "timeout", next, updates)
            self.race.cores.delete(core)
            ended = self.refused(0, "not_found", updates.next, TIMEOUT)
        self.assertEqual(ended.errors[0]["code"], "not_found", "the channel has ended")

    def test_what_the_server_refuses_is_an_error_with_path_and_code(self):
        self.assertEqual(self.refused(422, "unknown_name", self.core, models.ticking("typed"), {"lst": 1}).path, "arguments/lst")
        core = self.core(models.ticking("begun"))
        self.race.cores.start(core)
        self.refused(409, "conflict", self.race.cores.start, core)
        self.refused(404, "not_found", self.race.cores.create, "nowhere")
        self.refused(404, "not_found", self.race.cores.get, "987654")
        self.refused(0, "not_found", self.race.cores.follow("987654").__enter__)

    def test_a_request_that_is_sent_again_makes_one_core(self):
        self.race.documents.put("once", models.ticking("once"))
        first = self.race.cores.create("once", key="k1")
        self.assertEqual(self.race.cores.create("once", key="k1"), first)
        self.assertEqual(len([each for each in self.race.cores.all() if each["document"] == "once"]), 1)

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

    def test_runs_stay_when_their_cores_are_gone(self):
        core = self.core(models.ticking("stored", last=1))
        self.race.cores.start(core)
        self.race.cores.wait(core, timeout=TIMEOUT)
        self.refused(409, "conflict", self.race.runs.delete, core)
        self.race.cores.delete(core)
        run, = self.race.runs.all(document="stored")
        self.assertEqual((run["id"], run["status"], run["results"]), (core, "ended", {"n": 1}))
        self.assertEqual(len(self.race.runs.journal(core)["entries"]), run["steps"])
        self.assertEqual(self.race.runs.export(core)["run"]["document"], "stored")
        self.assertEqual(self.race.runs.delete(core), {"removed": core})


class Services:
    def test_a_call_is_answered_with_a_result_or_an_error(self):
        self.assertEqual(self.race.services.call("db", "add", "greeting", {"text": "hello"}), "greeting")
        self.assertEqual(self.race.services.call("db", "get", key="greeting"), {"text": "hello"})
        with self.assertRaises(ServiceError) as caught:
            self.race.services.call("db", "get", "nothing")
        error = caught.exception
        self.assertEqual((error.service, error.operation, error.status, error.code), ("db", "get", 200, "not_found"))
        self.assertEqual(error.error, {"code": "not_found", "message": error.message})
        self.assertEqual(self.refused(200, "unavailable", self.race.services.call, "db", "jump").path, "db.jump")
        self.refused(404, "not_found", self.race.services.call, "nobody", "get")

    def test_services_say_what_they_offer(self):
        found = {each["key"]: each for each in self.race.services.all()}
        operations = [each["name"] for each in found["db"]["rsm"]["operations"]]
        self.assertTrue(found["db"]["available"])
        self.assertIn("get", operations)

    def test_any_other_route_is_a_call(self):
        self.assertIn("PTrigger", [each["rule"] for each in self.race.send(race_client.calls.get_rules())["rules"]])
        self.assertIn("race_http_requests_total", self.race.send(race_client.calls.get_metrics()))
        self.assertTrue(self.race.stop_cell()["stopped"])
        self.assertFalse(self.race.reset_stop()["stopped"])
        self.assertEqual(self.race.health()["status"], "ok")


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


class Accounts(Conversation):
    @classmethod
    def setUpClass(cls):
        cls.server = AccountServer()
        cls.addClassCleanup(cls.server.stop)


class Rights:
    def test_who_is_not_known_logs_in(self):
        race = self.client()
        self.refused(401, "login", lambda: list(race.documents.all()))
        self.assertEqual(race.me(), {"accounts": True})
        self.refused(401, "login", race.log_in, "developer", "wrong horse battery")
        self.assertEqual(race.log_in("developer", PASSWORD)["account"]["role"], "developer")
        self.assertEqual(race.me()["role"], "developer")
        self.assertEqual(race.documents.put("mine", models.ticking("mine"), is_new=True)["author"], "developer")
        core = race.cores.create("mine", {"last": 1})["id"]
        race.cores.start(core)
        self.assertEqual(race.cores.wait(core, timeout=TIMEOUT)["outcome"], "done", "the stream knows who it is, too")
        race.log_out()
        self.refused(401, "login", race.cores.get, core)
        with self.assertRaises(RaceError) as caught, race.cores.follow(core):
            pass
        self.assertEqual((caught.exception.status, caught.exception.code), (401, "login"))

    def test_a_token_may_do_what_its_role_may(self):
        observer = self.client(token=self.server.tokens["observer"])
        self.assertEqual(observer.me()["role"], "observer")
        self.refused(403, "rights", observer.documents.put, "theirs", models.ticking("theirs"))
        self.refused(403, "rights", observer.services.call, "db", "add", "x", 1)

    def test_a_token_with_other_characters_is_not_sent(self):
        for token in ("", "a b", "a\r\nX-Evil: 1", "ä"):
            with self.assertRaises(ValueError):
                self.client(token=token)


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


BASES = {WithServer: (Documents, Runs, Services), Restarts: (Restarted,), Accounts: (Rights,), Network: (Tls,)}
for base, conversations in BASES.items():
    for conversation in conversations:
        for kind, connect in KINDS.items():
            case = type(f"{conversation.__name__}_{kind}", (conversation, base), {"connect": staticmethod(connect)})
            globals()[case.__name__] = case


if __name__ == "__main__":
    unittest.main()
