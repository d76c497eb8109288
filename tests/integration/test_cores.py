"""Cores on the real server: concurrent, paused and stepped, replayed, explained."""
import json
import subprocess
import tempfile
import unittest
from pathlib import Path

import models
from client import PROGRAM, Server


def strip(step):
    """A macro step as `race derive` prints it."""
    calls = [{k: v for k, v in call.items() if k != "call"} for call in step["calls"]]
    return {"micro": step["micro"], "calls": calls, "state": step["state"]}


class Cores(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def derive(self, core):
        """The output of `race derive` for the exported script."""
        with tempfile.TemporaryDirectory() as folder:
            model, script = Path(folder, "model.json"), Path(folder, "script.json")
            model.write_text(json.dumps(self.server.get(f"/cores/{core}/native", "native")["document"]))
            script.write_text(json.dumps(self.server.get(f"/cores/{core}/script", "script")))
            out = subprocess.run([PROGRAM, "derive", str(model), str(script)], capture_output=True, text=True, check=False)
        self.assertIn(out.returncode, (0, 1), out.stderr)
        return json.loads(out.stdout)

    def replay(self, core, change=lambda journal: None):
        """Exit status and output of `race replay` on the core's journal, changed."""
        journal = self.server.get(f"/cores/{core}/journal", "journal")
        change(journal)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "journal.json")
            path.write_text(json.dumps(journal))
            out = subprocess.run([PROGRAM, "replay", str(path)], capture_output=True, text=True, check=False)
        return out.returncode, json.loads(out.stdout)

    def paused_core(self, document, arguments=None):
        """A core that is paused before its first step."""
        core = self.server.core(document, arguments, start=False)
        self.server.post(f"/cores/{core}/pause", None, "core")
        self.server.post(f"/cores/{core}/start", None, "core")
        return core

    def step(self, core, **how):
        self.server.post(f"/cores/{core}/step", how, "core")
        return self.server.wait(core, lambda c: not c["stepping"])

    def active(self, core):
        return self.server.get(f"/cores/{core}/state", "core_state")["state"]["active"]

    def test_concurrent_cores_get_their_own_answers(self):
        document = models.storing()
        self.server.put("/documents/storing", document, "document_entry")
        cores = []
        for i in range(20):
            core = self.server.post("/cores", {"document": "storing", "arguments": {"key": f"k{i}", "value": [i]}}, "core", 201)
            cores.append(core["id"])
        for core in cores:
            self.server.post(f"/cores/{core}/start", None, "core")
        for i, core in enumerate(cores):
            ended = self.server.ended(core)
            self.assertEqual((ended["outcome"], ended["results"]), ("success", {"read": [i]}))
            self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)

    def test_the_exported_script_gives_the_same_derivations(self):
        core = self.server.core(models.ticking("replayed", last=7))
        ended = self.server.ended(core)
        ours = self.server.get(f"/cores/{core}/derivations?from=1&to={ended['step']}", "derivations")
        theirs = self.derive(core)
        self.assertEqual([strip(step) for step in ours["steps"]], theirs["steps"])
        self.assertEqual((ours["status"], ours["outcome"]), (theirs["status"], theirs["outcome"]))
        self.assertEqual(self.replay(core), (0, theirs))

    def test_a_journal_is_replayed_elsewhere_and_refused_if_it_is_of_another_run(self):
        core = self.server.core(models.storing("journaled"), {"key": "journaled", "value": 1})
        ended = self.server.ended(core)
        status, replayed = self.replay(core)
        ours = self.server.get(f"/cores/{core}/derivations?from=1&to={ended['step']}", "derivations")
        self.assertEqual((status, replayed["steps"]), (0, [strip(step) for step in ours["steps"]]))
        stopped = self.server.core(models.chain("stopped"))
        self.server.post(f"/cores/{stopped}/stop", None, "core")
        self.assertEqual(self.replay(stopped)[1]["status"], "aborted")
        faulted = self.server.core(models.faulty())
        self.server.ended(faulted)
        self.assertEqual((self.replay(faulted)[0], self.replay(faulted)[1]["status"]), (1, "faulted"))
        swap = lambda journal: journal["entries"][1]["input"].update(journal["entries"][2]["input"] | {"call": 1})
        status, refused = self.replay(core, swap)
        (error,) = refused["errors"]
        self.assertEqual(Path(error.pop("file")).name, "journal.json")
        self.assertEqual((status, error), (2, {"path": "entries/1", "code": "conflict", "message":
            "the run takes no response of db.get to call 1 here: the journal is of another run"}))
        status, refused = self.replay(core, lambda journal: journal["header"].update(semantics="2"))
        self.assertEqual((status, refused["errors"][0]["path"], refused["errors"][0]["code"]), (2, "header/semantics", "version"))

    def test_one_step_alone_equals_the_step_in_the_whole_run(self):
        core = self.server.core(models.ticking("asked", last=4))
        ended = self.server.ended(core)
        whole = self.server.get(f"/cores/{core}/derivations?from=1&to={ended['step']}", "derivations")["steps"]
        for step in reversed(whole):
            self.assertEqual(self.server.get(f"/cores/{core}/derivations?from={step['step']}", "derivations")["steps"], [step])

    def test_the_journal_has_every_input_in_order(self):
        core = self.server.core(models.storing("noted"), {"key": "noted", "value": [1, {"two": None}]})
        self.assertEqual(self.server.ended(core)["outcome"], "success")
        journal = self.server.get(f"/cores/{core}/journal", "journal")
        self.assertEqual(journal["header"]["arguments"], {"key": "noted", "value": [1, {"two": None}]})
        answer = lambda operation, call, result: {
            "kind": "response", "service": "db", "operation": operation, "call": call, "result": result}
        self.assertEqual(journal["entries"], [
            {"position": 1, "input": {"kind": "start"}}, {"position": 2, "input": answer("add", 1, "noted")},
            {"position": 3, "input": answer("get", 2, [1, {"two": None}])}])
        core = self.server.core(models.reading("unread"), {"key": "nobody has stored this"})
        self.assertEqual(self.server.ended(core)["outcome"], "missing")
        reported = self.server.get(f"/cores/{core}/journal", "journal")["entries"][-1]["input"]
        self.assertEqual((reported["kind"], "result" in reported, reported["error"]["code"]), ("response", False, "not_found"))

    def test_a_fault_is_shown_and_replayed(self):
        core = self.server.core(models.faulty())
        ended = self.server.ended(core)
        self.assertEqual((ended["status"], ended["fault"]["kind"], ended["fault"]["at"]), ("faulted", "zero_division", "Root"))
        theirs = self.derive(core)
        self.assertEqual((theirs["status"], theirs["fault"]), ("faulted", ended["fault"]))

    def test_calls_to_absent_services_are_answered_unavailable(self):
        core = self.server.core(models.calling("oven", "heat"))
        ended = self.server.ended(core)
        self.assertEqual((ended["outcome"], ended["results"]), ("error", {"code": "unavailable"}))
        theirs = self.derive(core)
        self.assertEqual(theirs["outcome"], "error")
        # No such service, an empty name, an operation with the name of an event.
        for service, operation in (("oven", "heat"), ("", "heat"), ("timer", "tick")):
            core = self.server.core(models.calling(service, operation, computed=True))
            ended = self.server.ended(core)
            self.assertEqual((ended["outcome"], ended["results"]), ("error", {"code": "unavailable"}))
            theirs = self.derive(core)
            ours = self.server.get(f"/cores/{core}/derivations?from=1&to={ended['step']}", "derivations")["steps"]
            self.assertEqual((theirs["outcome"], theirs["steps"]), ("error", [strip(step) for step in ours]))
        core = self.server.core(models.calling("timer", "cancel"))
        self.assertEqual(self.server.ended(core)["results"], {"code": "not_accepted"})

    def waits(self):
        """How many calls wait at the timer."""
        services = self.server.get("/services", "services")["services"]
        return len(next(service for service in services if service["key"] == "timer")["pending"])

    def test_a_time_out_that_is_entered_anew_leaves_its_place_at_the_timer(self):
        # More often than calls can wait there.
        often = self.server.core(models.waiting(60, times=1200, name="often"))
        self.server.wait(often, lambda core: core["micro"] == 0)
        state = self.server.get(f"/cores/{often}/state", "core_state")["state"]
        self.assertEqual(state["variables"]["Root/Ask"]["n"], 1200)
        self.server.wait_for(lambda: self.waits() == 1)
        other = self.server.core(models.waiting(0.2))
        self.assertEqual(self.server.ended(other)["outcome"], "late")
        self.assertEqual(self.server.get(f"/cores/{often}", "core")["status"], "running")
        self.server.expect("DELETE", f"/cores/{often}", None, "core", 200)
        self.server.wait_for(lambda: self.waits() == 0)
        again = self.server.core(models.waiting(0.2, times=1200, name="often"))
        self.assertEqual(self.server.ended(again)["outcome"], "late")

    def test_a_time_out_that_the_timer_refuses_is_a_fault(self):
        ended = self.server.ended(self.server.core(models.waiting(-1)))
        self.assertEqual((ended["status"], ended["fault"]["kind"], ended["fault"]["at"]), ("faulted", "value", "Root/Ask/After_late"))
        self.assertIn("time-out: invalid", ended["fault"]["message"])

    def test_micro_steps_one_by_one_are_the_macro_step(self):
        core = self.paused_core(models.chain())
        entered = []
        for _ in range(6):
            state = self.step(core, kind="micro")
            entered.append((state["micro"], self.active(core)[-1]))
        # A port fires in one micro step and is followed in the next.
        self.assertEqual(entered, [(1, "Root/S0"), (2, "Root"), (3, "Root/S1"), (4, "Root"), (5, "Root/S2"), (6, "Root")])
        partial = self.server.get(f"/cores/{core}/derivations", "derivations")["steps"]
        self.assertEqual((len(partial), len(partial[0]["micro"]), partial[0]["complete"]), (1, 6, False))
        state = self.step(core, kind="macro")
        self.assertEqual((state["step"], state["micro"], self.active(core)), (1, 0, ["Root", "Root/S3"]))
        whole = self.server.get(f"/cores/{core}/derivations", "derivations")["steps"][0]
        self.assertEqual(whole["micro"][:6], partial[0]["micro"])
        self.assertEqual(strip(whole), self.derive(core)["steps"][0])

    def test_why_before_a_step_knows_its_input(self):
        core = self.server.core(models.ticking("asked_why", last=4))
        self.server.ended(core)
        steps = self.server.get(f"/cores/{core}/derivations?from=1&to=3", "derivations")["steps"]
        self.assertEqual((steps[1]["input"]["kind"], steps[1]["micro"][0]["premises"][0]["rule"]), ("event", "SProp"))
        why = lambda step, micro: self.server.get(f"/cores/{core}/why?port=Root/Ping.next&step={step}&micro={micro}", "why")
        self.assertEqual([why(1, 1)["value"], why(2, 0)["value"]], [None, True])
        self.assertEqual([why(2, 0)["active"], why(2, 1)["active"]], [False, True])

    def test_a_core_runs_until_a_state_is_entered_or_left(self):
        core = self.paused_core(models.ticking("until", last=100))
        self.step(core, kind="until", path="Root/Pong", when="entered")
        self.assertEqual(self.active(core), ["Root", "Root/Pong"])
        self.step(core, kind="until", path="Root/Pong", when="left")
        self.assertEqual(self.active(core), ["Root"])
        before = self.server.get(f"/cores/{core}", "core")["step"]
        after = self.step(core, kind="until", path="Root/Pong", when="left")  # entered first, as it is not active
        self.assertEqual((after["paused"], self.active(core)), (True, ["Root"]))
        self.assertGreater(after["step"], before + 1)
        self.server.post(f"/cores/{core}/step", {"kind": "until", "path": "Root/Nowhere", "when": "left"}, status=404)

    def test_a_breakpoint_holds_a_core_each_time_it_is_reached(self):
        core = self.paused_core(models.ticking("broken", last=100))
        held = lambda: self.server.wait(core, lambda c: c["paused"])
        breakpoints = [{"when": "entered", "path": "Root/Pong"}, {"when": "fired", "path": "Root/Pong.next"}]
        reported = self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": breakpoints}, "core")
        self.assertEqual(reported["breakpoints"], breakpoints)
        seen = []
        for _ in range(4):
            self.server.post(f"/cores/{core}/resume", None, "core")
            self.assertGreater(held()["micro"], 0)
            seen.append(self.active(core))
        self.assertEqual(seen, 2 * [["Root", "Root/Pong"], ["Root"]])
        after = self.step(core, kind="until", path="Root/Ping", when="entered")
        self.assertEqual((after["paused"], self.active(core)), (True, ["Root", "Root/Ping"]))
        self.step(core, kind="until", path="Root/Ping", when="entered")
        self.assertEqual(self.active(core), ["Root", "Root/Pong"], "a breakpoint ends the step to elsewhere")
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": []}, "core")
        self.server.post(f"/cores/{core}/resume", None, "core")
        self.assertEqual(self.server.wait(core, lambda c: c["step"] > after["step"] + 20)["paused"], False)

    def test_a_breakpoint_holds_a_core_before_what_it_names_and_says_which_it_was(self):
        core = self.paused_core(models.ticking("before", last=100))
        breakpoints = [{"when": "entered", "path": "Root/Pong", "before": True}, {"when": "tested", "path": "Root/Pong.next"},
                       {"when": "fault"}]
        reported = self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": breakpoints}, "core")
        self.assertEqual(reported["breakpoints"], breakpoints)
        self.assertNotIn("reached", reported)
        for number in (0, 1, 0, 1):
            self.server.post(f"/cores/{core}/resume", None, "core")
            held = self.server.wait(core, lambda c: c["paused"])
            self.assertEqual((held["reached"], self.active(core)), ([number], ["Root"]), "Pong is not entered yet, or has been left")
        replaced = self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": []}, "core")
        self.assertNotIn("reached", replaced)
        self.assertNotIn("reached", self.step(core, kind="until", path="Root/Ping", when="entered"))

    def test_a_macro_step_that_is_held_before_its_first_micro_step_has_one_entry(self):
        core = self.server.core(models.ticking("untouched"), start=False)
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": [{"when": "entered", "path": "Root/Ping", "before": True}]}, "core")
        self.server.post(f"/cores/{core}/start", None, "core")
        held = self.server.wait(core, lambda c: c["paused"])
        self.assertEqual((held["step"], held["micro"]), (1, 0))
        self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": []}, "core")
        self.server.post(f"/cores/{core}/resume", None, "core")
        step = self.server.wait(core, lambda c: c["status"] != "running")["step"]
        kinds = [entry["input"]["kind"] for entry in self.server.get(f"/cores/{core}/journal", "journal")["entries"]]
        self.assertEqual((len(kinds), kinds.count("start")), (step, 1))
        self.assertEqual(len(self.server.get(f"/cores/{core}/derivations?from=1&to={step}", "derivations")["steps"]), step)

    def test_a_run_is_seen_as_it_was_and_back_again(self):
        core = self.paused_core(models.ticking("past", last=6))
        self.server.get(f"/cores/{core}/past?step=1", status=400)
        self.server.get(f"/cores/{core}/past", status=422)
        seen = {}
        now = self.server.get(f"/cores/{core}", "core")
        while now["status"] == "running":
            now = self.step(core, kind="micro")
            there = self.server.get(f"/cores/{core}/past?step={now['step']}" + (f"&micro={now['micro']}" if now["micro"] else ""), "past")
            self.assertEqual(there["state"], self.server.get(f"/cores/{core}/state", "core_state")["state"])
            self.assertEqual(there["step"], now["step"])
            seen[there["step"], there["micro"]] = there["digest"]
        self.assertGreater(len(seen), 12)
        self.assertEqual(len(set(seen.values())), len(seen), "no two moments are the same")
        for where in ("cores", "runs"):
            for (step, micro), digest in reversed(seen.items()):
                back = self.server.get(f"/{where}/{core}/past?step={step}&micro={micro}", "past")
                self.assertEqual((back["step"], back["micro"], back["digest"]), (step, micro, digest))
            self.server.get(f"/{where}/{core}/past?step={now['step'] + 1}", status=400)

    def test_the_live_derivations_are_those_of_the_replay(self):
        core = self.server.core(models.ticking("live", last=7), start=False)
        with self.server.stream() as stream:
            stream.subscribe(f"core/{core}/derivation")
            stream.message()
            self.server.post(f"/cores/{core}/start", None, "core")
            steps = self.server.ended(core)["step"]
            live = {}
            while len(live) < steps or not live[steps][-1]["complete"]:
                for part in stream.message()["data"]["steps"]:
                    live.setdefault(part["step"], []).append(part)
        replayed = self.server.get(f"/cores/{core}/derivations?from=1&to={steps}", "derivations")["steps"]
        joined = [{"input": live[n][0]["input"], "micro": [tree for part in live[n] for tree in part["micro"]],
                   "calls": [call for part in live[n] for call in part["calls"]]} for n in range(1, steps + 1)]
        self.assertEqual(joined, [{key: step[key] for key in ("input", "micro", "calls")} for step in replayed])

    def test_a_step_that_needs_an_input_is_paused_until_one_comes(self):
        core = self.paused_core(models.chain("waiting"))
        with self.server.stream() as stream:
            stream.subscribe("cores")
            stream.message()
            self.assertEqual(self.step(core, kind="macro")["step"], 1)
            reported = self.server.post(f"/cores/{core}/step", {"kind": "macro"}, "core")
            self.assertEqual((reported["status"], reported["paused"], reported["stepping"], reported["step"]), ("running", True, True, 1))
            self.assertEqual(self.server.get(f"/cores/{core}", "core"), reported)
            ours = lambda m: m["data"].get("core", {}).get("id") == core
            published = stream.until(lambda m: ours(m) and m["data"]["core"]["stepping"])[-1]["data"]["core"]
            self.assertEqual(published["paused"], True)
        self.assertEqual(self.server.post(f"/cores/{core}/pause", None, "core")["stepping"], False)
        self.server.post(f"/cores/{core}/step", {"kind": "until", "path": "Root/S0", "when": "entered"}, "core")
        self.server.post(f"/cores/{core}/step", {"kind": "macro"}, "core")
        # An event of the timer goes to every core that names it.
        self.server.core(models.document("alarm", {"state": "Root", "entry": "svc.timer.start(0.0)", "ports": [
            {"name": "over", "when": "svc.timer.start.result"}]}))
        ended = self.server.wait(core, lambda c: not c["stepping"])
        self.assertEqual((ended["outcome"], ended["paused"], ended["step"]), ("done", False, 2))

    def test_a_pause_changes_nothing_but_the_time(self):
        core = self.server.core(models.ticking("paused", last=6))
        for _ in range(3):
            self.server.post(f"/cores/{core}/pause", None, "core")
            before = self.server.get(f"/cores/{core}", "core")["step"]
            self.server.get(f"/cores/{core}/state", "core_state")
            self.assertEqual(self.server.get(f"/cores/{core}", "core")["step"], before)
            self.server.post(f"/cores/{core}/resume", None, "core")
        self.assertEqual(self.server.ended(core)["outcome"], "done")

    def test_stop_ends_a_run_between_macro_steps(self):
        core = self.server.core(models.ticking("stopped", last=1000))
        self.server.wait(core, lambda c: c["step"] >= 2)
        stopped = self.server.post(f"/cores/{core}/stop", None, "core")
        self.assertEqual(stopped["status"], "aborted")
        entries = self.server.get(f"/cores/{core}/journal", "journal")["entries"]
        self.assertEqual([e["position"] for e in entries], list(range(1, stopped["step"] + 1)))
        self.assertEqual(entries[0]["input"], {"kind": "start"})
        self.assertEqual(entries[-1]["input"], {"kind": "abort"})
        last = self.server.get(f"/cores/{core}/derivations", "derivations")["steps"][0]
        self.assertEqual((last["input"], last["micro"]), ({"kind": "abort"}, []))

    def test_why_names_the_atom_whose_change_fires_the_port(self):
        document = models.document("why", {
            "state": "Root", "parameters": [{"name": "a", "value": 1}],
            "children": [{"state": "A", "parameters": [{"name": "a", "from": "par.a"}],
                          "ports": [{"name": "go", "when": "par.a > 3 and not (par.a == 7)", "to": "B"},
                                    {"name": "wait", "when": "svc.timer.elapsed", "to": "B"}]},
                         {"state": "B"}],
            "first": "A"})
        core = self.server.core(document)
        why = self.server.get(f"/cores/{core}/why?port=Root/A.go", "why")
        self.assertEqual((why["value"], why["state_active"], why["active"]), (False, True, False))
        blocking = [(atom["text"], atom["wanted"]) for atom in why["atoms"] if atom["blocks"]]
        self.assertEqual(blocking, [("par.a > 3", True)])
        waits = self.server.get(f"/cores/{core}/why?port=Root/A.wait", "why")
        self.assertEqual((waits["value"], waits["atoms"][0]["service"]), (None, True))
        # With that value the port fires.
        other = self.server.core(document, {"a": 4})
        self.server.wait(other, lambda c: c["step"] == 1)
        self.assertEqual(self.active(other), ["Root", "Root/B"])

    def test_why_a_port_fired_is_explained_by_the_atoms_at_that_step(self):
        document = models.document("fired", {
            "state": "Root", "variables": [{"name": "v", "initial": 1}],
            "children": [{"state": "A", "exit": "pass", "ports": [{"name": "go", "when": "var.n == 1 or False", "to": "B"}],
                          "variables": [{"name": "n", "initial": 1}]},
                         {"state": "B"}],
            "first": "A"})
        core = self.server.core(document)
        self.server.wait(core, lambda c: c["step"] == 1)
        now = self.server.get(f"/cores/{core}/why?port=Root/A.go", "why")
        self.assertEqual(now["state_active"], False)
        micro = self.server.get(f"/cores/{core}/derivations?from=1", "derivations")["steps"][0]["micro"]
        fires = lambda node: node["rule"] == "PTrigger" or any(fires(p) for p in node["premises"])
        number = [fires(node) for node in micro].index(True)
        then = self.server.get(f"/cores/{core}/why?port=Root/A.go&step=1&micro={number}", "why")
        self.assertEqual((then["value"], then["state_active"], then["active"]), (True, True, False))
        self.assertEqual([(atom["text"], atom["value"]) for atom in then["atoms"]], [("var.n == 1", True), ("False", False)])
        after = self.server.get(f"/cores/{core}/why?port=Root/A.go&step=1&micro={number + 1}", "why")
        self.assertEqual((after["state_active"], after["active"]), (False, True))
        self.server.get(f"/cores/{core}/why?port=Root/A.go&step=9&micro=0", status=400)
        self.server.get(f"/cores/{core}/why?port=Root/A.go&step=0&micro=0", status=400)
        self.server.get(f"/cores/{core}/why?port=Root/A.go&step=1&micro=-1", status=400)
        self.server.get(f"/cores/{core}/why?port=Root/A.go&step=1", status=422)

    def test_why_an_action_is_executed_and_what_gives_a_parameter_its_value(self):
        document = models.document("asked", {
            "state": "Root", "variables": [{"name": "n", "initial": 0}],
            "actions": [{"when": "var.n == 0", "do": "var.n = 2"}, {"when": "svc.timer.elapsed", "do": "pass"}],
            "children": [{"state": "A", "ports": [{"name": "go", "when": "True", "to": "B"}]},
                         {"state": "B", "parameters": [{"name": "w", "from": "var.n * 3"}, {"name": "c", "value": 1}]}],
            "first": "A"})
        core = self.server.core(document)
        self.server.wait(core, lambda c: c["step"] == 1)
        ask = lambda query, **how: self.server.get(f"/cores/{core}/why?{query}", "why", **how)
        self.assertEqual((ask("state=Root&action=0")["executed"], ask("state=Root&action=1")["value"]), (True, None))
        w = ask("state=Root/B&parameter=w")
        self.assertEqual((w["value"], w["gives"], w["expression"], w["reads"]), (6, 6, "var.n * 3", [{"text": "var.n", "value": 2}]))
        self.assertNotIn("expression", ask("state=Root/B&parameter=c"))
        # In the micro step in which the value came about, the variable had become 2 before its turn.
        micro = self.server.get(f"/cores/{core}/derivations?from=1", "derivations")["steps"][0]["micro"]
        resolves = lambda node: node.get("parameter") == "w" or any(resolves(p) for p in node["premises"])
        then = ask(f"state=Root/B&parameter=w&step=1&micro={[resolves(node) for node in micro].index(True)}")
        self.assertEqual((then["turn"], then["gives"], "value" in then), (True, 6, False))
        # Of the stored run likewise.
        self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)
        run = f"/runs/{core}/why?state=Root&action=0"
        self.assertTrue(self.server.get(run, "why")["executed"])
        self.assertEqual(self.server.get(f"{run}&step=1&micro=1", "why").get("turn"), True)

    def test_why_asks_about_one_thing(self):
        core = self.server.core(models.document("one", {"state": "Root", "parameters": [{"name": "p", "value": 1}]}))
        for query, status, path in [("", 422, "port"), ("state=Root", 422, "action"), ("port=Root.x&state=Root&action=0", 409, "port"),
                                    ("state=Root&action=0&parameter=p", 409, "parameter"), ("state=Root&action=0", 404, "action"),
                                    ("state=Root&parameter=q", 404, "parameter"), ("state=Gone&parameter=p", 404, "state"),
                                    ("port=Root.x", 404, "port"), ("state=Root&action=x", 400, "action")]:
            with self.subTest(query):
                problem = self.server.get(f"/cores/{core}/why?{query}", status=status)
                self.assertEqual(problem["errors"][0]["path"], path)

    def test_the_log_reports_runs_and_unanswered_calls(self):
        core = self.server.core(models.document("calling", {
            "state": "Root", "entry": "svc.nobody.help()", "ports": [{"name": "sad", "when": "svc.nobody.help.error"}]}))
        self.server.ended(core)
        with self.server.stream() as stream:
            stream.subscribe("log")
            lines = [(line["source"], line["text"]) for line in stream.message()["data"]["entries"]]
        self.assertEqual([text for source, text in lines if source == f"core/{core}"],
                         ["calling: ready", "calling: running", "calling: ended at sad"])
        paused_core = self.paused_core(models.chain("quiet"))
        self.step(paused_core, kind="macro")
        with self.server.stream() as stream:
            stream.subscribe("log")
            lines += [(line["source"], line["text"]) for line in stream.message()["data"]["entries"]]
        self.assertEqual([text for source, text in lines if source == f"core/{paused_core}"], ["quiet: ready", "quiet: running"])
        self.assertIn(("nobody", f"cannot answer `help` of core {core}: there is no such service"), lines)

    def test_the_number_of_cores_is_limited(self):
        self.server.put("/documents/many", models.ticking("many"), "document_entry")
        ids = []
        while True:
            status, answer = self.server.request("POST", "/api/v1/cores", {"document": "many"})
            if status != 201:
                break
            ids.append(answer["id"])
            self.assertLessEqual(len(ids), 128)
        self.assertEqual((status, answer["errors"][0]["code"]), (409, "conflict"))
        self.assertEqual(len(self.server.get("/cores", "cores")["cores"]), 128)
        for core in ids:
            self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)


if __name__ == "__main__":
    unittest.main()
