"""Services that processes bring of themselves: listed at once, called by tasks, gone and back with another RSM; who may not bring them."""
import json
import tempfile
import time
import unittest
from pathlib import Path

import models
from accounts import AccountServer
from client import Server
from component_process import LONG_HEARTBEAT, ComponentClient, service, wait_available
from test_impostors import refusal_of

SWITCH = {"rsm": 1, "name": "switch", "operations": [{"name": "flip", "error": "any"}], "events": [{"name": "flipped", "data": "bool"}],
          "states": [{"name": "Off", "events": ["flipped"]}, {"name": "Lit", "events": ["flipped"]}], "init": "Off",
          "transitions": [{"id": "up", "src": "Off", "dst": "Lit", "operation": "flip"},
                          {"id": "down", "src": "Lit", "dst": "Off", "operation": "flip"}]}
DIMMER = {"rsm": 1, "name": "dimmer", "operations": [{"name": "dim"}], "events": [], "states": [{"name": "Dark"}], "init": "Dark",
          "transitions": [{"id": "dim", "src": "Dark", "dst": "Dark", "operation": "dim"}]}


def hello(*components, **more):
    return {"type": "hello", "protocol": 1, **more,
            "components": [{"key": key, "type": kind, "rsm": rsm} for key, kind, rsm in components or [("lamp", "lamp", SWITCH)]]}


class OwnServices(unittest.TestCase):
    def connect(self, server, token=None):
        client = ComponentClient(server, token=token)
        self.addCleanup(client.close)
        return client

    def offer(self, server, *components, **more):
        """A process that brings these, once it is welcome."""
        client = self.connect(server)
        client.send_checked(hello(*components, **more))
        client.next("welcome")
        return client

    def answer(self, client, transition, value=None):
        """Takes the next call by this transition, and answers it."""
        call = client.next("call")
        client.send_checked({"type": "transition", "key": call["key"], "id": transition, "call": call["call"]})
        client.send_checked({"type": "result", "key": call["key"], "call": call["call"], "value": value})
        return call

    def test_is_on_the_stream_within_two_seconds(self):
        with Server(*LONG_HEARTBEAT) as server, server.stream() as stream:
            stream.subscribe("services")
            stream.until(lambda m: m["kind"] == "snapshot")
            begun = time.monotonic()
            self.offer(server)
            lamps = []
            while not lamps or not lamps[-1]["available"]:
                lamps += [s for s in stream.message()["data"]["services"] if s["key"] == "lamp"]
            self.assertLess(time.monotonic() - begun, 2)
            self.assertEqual((lamps[0]["type"], lamps[0]["rsm"], lamps[0]["state"], lamps[0]["violations"]), ("lamp", SWITCH, "Off", []))
            self.assertEqual(service(server, "lamp")["rsm"], SWITCH)

    def test_a_task_that_waits_for_it_is_answered_unavailable_until_it_comes(self):
        with Server(*LONG_HEARTBEAT) as server:
            missing = server.core(models.calling("lamp", "flip"))
            self.assertEqual(server.ended(missing)["results"], {"code": "unavailable"})
            client = self.offer(server)
            core = server.core(models.calling("lamp", "flip"))
            self.answer(client, "up")
            self.assertEqual(server.ended(core)["outcome"], "result")
            self.assertEqual((service(server, "lamp")["state"], service(server, "lamp")["violations"]), ("Lit", []))

    def test_a_task_of_another_type_is_refused(self):
        with Server(*LONG_HEARTBEAT) as server:
            self.offer(server)
            document = {**models.calling("lamp", "flip"), "services": {"lamp": "oven"}}
            server.put(f"/documents/{document['name']}", document)
            errors = server.post("/cores", {"document": document["name"]}, status=422)["errors"]
            self.assertEqual([(e["path"], e["code"]) for e in errors], [("services/lamp", "type")])

    def test_dies_in_a_call_and_comes_back_with_another_rsm_while_a_run_uses_it(self):
        toggling = models.document("toggling", {
            "state": "Root", "results": [{"name": "codes", "initial": []}],
            "entry": "svc.lamp.flip()",
            "actions": [{"when": "svc.lamp.flip.error", "do": "res.codes = res.codes + [svc.lamp.flip.error.code]\nsvc.lamp.flip()"}],
            "ports": [{"name": "done", "when": "len(res.codes) >= 2"}]})
        with Server(*LONG_HEARTBEAT) as server, server.stream() as stream:
            stream.subscribe("services")
            client = self.offer(server)
            core = server.core(toggling)
            client.next("call")
            other = self.connect(server)
            other.send_checked(hello(("lamp", "lamp", DIMMER)))
            self.assertEqual(other.next("refused")["errors"][0]["code"], "conflict")
            client.close()
            self.assertEqual(server.ended(core)["results"]["codes"], ["unavailable", "unavailable"])
            self.offer(server, ("lamp", "dimmer", DIMMER))
            shown = stream.until(lambda m: m["kind"] == "snapshot" and any(s["rsm"] == DIMMER for s in m["data"]["services"]))[-1]
            self.assertEqual([s["type"] for s in shown["data"]["services"] if s["key"] == "lamp"], ["dimmer"])
            core = server.core(models.calling("lamp", "flip"))
            self.assertEqual(server.ended(core)["results"], {"code": "unavailable"})

    def test_a_run_goes_on_while_the_rsm_of_a_service_changes(self):
        """The run keeps the interface that it began with: the journal replays, and what the service has no more is unavailable."""
        waiting = models.document("waiting", {
            "state": "Root", "results": [{"name": "code"}],
            "children": [
                {"state": "Wait", "ports": [{"name": "flipped", "when": "svc.lamp.flipped", "to": "Call"}]},
                {"state": "Call", "entry": "svc.lamp.flip()", "ports": [{"name": "gone", "when": "svc.lamp.flip.error"}]}],
            "first": "Wait", "actions": [{"when": "svc.lamp.flip.error", "do": "res.code = svc.lamp.flip.error.code"}],
            "ports": [{"name": "done", "when": "available(res.code)"}]})
        richer = {**DIMMER, "events": [{"name": "flipped", "data": "bool"}], "states": [{"name": "Dark", "events": ["flipped"]}]}
        with Server(*LONG_HEARTBEAT) as server:
            first = self.offer(server)
            core = server.core(waiting)
            first.close()
            wait_available(server, "lamp", False)
            second = self.offer(server, ("lamp", "lamp", richer))
            second.send_checked({"type": "event", "key": "lamp", "name": "flipped", "data": True})
            self.assertEqual(server.ended(core)["results"], {"code": "unavailable"})
            run = server.get(f"/runs/{core}/derivations?from=1&to=1")
            self.assertEqual(run["steps"][0]["step"], 1)

    def test_who_asks_is_told_of_its_violations(self):
        with Server(*LONG_HEARTBEAT) as server:
            client = self.offer(server, violations=True)
            core = server.core(models.calling("lamp", "flip"))
            call = client.next("call")
            client.send_checked({"type": "transition", "key": "lamp", "id": "down", "call": call["call"]})
            told = client.next("violation")
            self.assertEqual((told["key"], told["rule"], told["call"], told["operation"]), ("lamp", "Trans1", call["call"], "flip"))
            self.assertEqual(service(server, "lamp")["violations"][0]["message"], told["message"])
            client.send_checked({"type": "result", "key": "lamp", "call": call["call"], "value": None})
            self.assertEqual(server.ended(core)["outcome"], "result")

    def test_each_of_10_000_lies_is_reported_and_a_core_goes_on(self):
        with Server(*LONG_HEARTBEAT) as server:
            client = self.offer(server, violations=True)
            good = server.core(models.ticking("good", last=20))
            told = []
            for lie in range(2500):
                client.send({"type": "result", "key": "lamp", "call": 10**6 + lie, "value": lie})
                client.send({"type": "reject", "key": "lamp", "call": 10**6 + lie})
                client.send({"type": "event", "key": "lamp", "name": "boom", "data": None})
                client.send({"type": "transition", "key": "lamp", "id": "nowhere"})
                while lie % 100 == 99 and len(told) < 4 * (lie + 1):
                    told.append(client.next("violation"))
            self.assertEqual(len(told), 10_000)
            rules = {rule: [m["call"] for m in told if m["rule"] == rule] for rule in ("respond", "R7", "declared")}
            self.assertEqual(rules["respond"], list(range(10**6, 10**6 + 2500)))
            self.assertEqual(rules["R7"], rules["respond"])
            self.assertEqual(len(rules["declared"]), 5000)
            self.assertEqual(server.ended(good)["outcome"], "done")
            self.assertEqual(len(service(server, "lamp")["violations"]), 100)

    def test_what_is_no_service_is_refused_with_the_reason(self):
        with Server(*LONG_HEARTBEAT) as server:
            for components, code in (([("timer", "timer", SWITCH)], "not_found"), ([("a b", "lamp", SWITCH)], "name"),
                                     ([("lamp", "lamp", {**SWITCH, "init": "Nowhere"})], "reference"),
                                     ([("lamp", "lamp", {"rsm": 1, "name": "lamp", "operations": [], "events": []})], "missing"),
                                     ([("lamp", "lamp", {**SWITCH, "meta": "x" * 70_000})], "too_large"),
                                     ([("lamp", "lamp", SWITCH), ("lamp", "lamp", SWITCH)], "conflict")):
                self.assertEqual(refusal_of(self.connect(server), hello(*components))[1], code, components[0][0])
            self.assertNotIn("lamp", [s["key"] for s in server.get("/services", "services")["services"]])

    def test_only_accounts_with_the_group_own_bring_them(self):
        with AccountServer(*LONG_HEARTBEAT) as server:
            self.assertEqual(refusal_of(self.connect(server, server.tokens["speaker"]), hello()), ("lamp", "rights"))
            for group, status in (("own", 201), ("odd", 400)):
                account = {"name": group, "role": "process", "groups": [group]}
                self.assertEqual(server.ask("admin", "POST", "/api/v1/accounts", account), status, group)


class Cells(unittest.TestCase):
    def cell(self, **more):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        Path(folder.name, "lamp.rsm.json").write_text(json.dumps(SWITCH))
        Path(folder.name, "cell.json").write_text(json.dumps({"cell": 1, "services": {"timer": "timer", "memory": "database"}, **more}))
        return folder.name

    def test_a_cell_has_the_services_that_its_file_names(self):
        with Server("--demo", self.cell()) as server:
            self.assertEqual([s["key"] for s in server.get("/services", "services")["services"]], ["timer", "memory"])

    def test_expected_services_are_there_from_the_start_and_keep_their_rsm(self):
        folder = self.cell(expects={"lamp": {"type": "lamp", "rsm": "lamp.rsm.json"}})
        with Server("--demo", folder, *LONG_HEARTBEAT) as server:
            lamp = service(server, "lamp")
            self.assertEqual((lamp["available"], lamp["rsm"], lamp["type"]), (False, SWITCH, "lamp"))
            with ComponentClient(server) as other:
                self.assertEqual(refusal_of(other, hello(("lamp", "lamp", DIMMER))), ("lamp", "conflict"))
            with ComponentClient(server) as client:
                client.send_checked(hello())
                client.next("welcome")
                wait_available(server, "lamp")

    def test_the_cell_says_which_accounts_offer(self):
        with AccountServer("--demo", self.cell(offers={"accounts": ["workshop"]}), *LONG_HEARTBEAT) as server:
            tokens = {}
            for name in ("kitchen", "workshop"):
                account = {"name": name, "role": "process", "groups": ["own"]}
                self.assertEqual(server.ask("admin", "POST", "/api/v1/accounts", account), 201)
                tokens[name] = server.post(f"/accounts/{name}/tokens", {"label": "test"}, "token_created", 201)["token"]
            with ComponentClient(server, token=tokens["kitchen"]) as client:
                self.assertEqual(refusal_of(client, hello()), ("lamp", "rights"))
            with ComponentClient(server, token=tokens["workshop"]) as client:
                client.send_checked(hello())
                client.next("welcome")


if __name__ == "__main__":
    unittest.main()
