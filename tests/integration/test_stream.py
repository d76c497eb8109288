"""The stream: a snapshot, then deltas without gaps; reconnection; slow clients; content equal to the run."""
import unittest

import models
from client import PROJECT, Server


def apply(state, delta):
    """Applies a core_delta to a core_state, as a client does."""
    whole = {"core": delta["core"], "state": {key: value.copy() for key, value in state["state"].items()}}
    new = whole["state"]
    for field in ("active", "ports"):
        names = [name for name in new[field] if delta[field].get(name, True)]
        names += [name for name, on in delta[field].items() if on and name not in names]
        new[field] = names
    for barrier, ports in delta["activated"].items():
        new["activated"].pop(barrier, None)
        if ports:
            new["activated"][barrier] = ports
    for field in ("parameters", "results", "variables"):
        values = {path: dict(entries) for path, entries in new[field].items()}
        for path, names in delta["unset"].get(field, {}).items():
            for name in names:
                values[path].pop(name)
        for path, entries in delta[field].items():
            values.setdefault(path, {}).update(entries)
        new[field] = {path: entries for path, entries in values.items() if entries}
    return whole


def normalized(state):
    """The state with its unordered lists sorted."""
    return {**state, "state": {**state["state"], "active": sorted(state["state"]["active"]),
                               "ports": sorted(state["state"]["ports"])}}


class StreamTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server("--demo", str(PROJECT / "deploy/demo"))

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def test_a_snapshot_and_its_deltas_are_the_state(self):
        core = self.server.core(models.storing("shown"), {"value": {"deep": [1, 2.5, None]}}, start=False)
        with self.server.stream() as stream:
            stream.subscribe(f"core/{core}/state")
            snapshot = stream.message()
            self.assertEqual((snapshot["kind"], snapshot["data"]["core"]["status"]), ("snapshot", "ready"))
            self.server.post(f"/cores/{core}/start", None, "core")
            deltas = stream.until(lambda m: m["data"]["core"]["status"] == "ended")
        numbers = [m["sequence"] for m in [snapshot, *deltas]]
        self.assertEqual(numbers, list(range(numbers[0], numbers[0] + len(numbers))))
        state = snapshot["data"]
        for delta in deltas:
            self.assertEqual(delta["kind"], "delta")
            state = apply(state, delta["data"])
        self.assertEqual(normalized(state), normalized(self.server.get(f"/cores/{core}/state", "core_state")))
        fired = [port for delta in deltas for port in delta["data"]["fired"]]
        self.assertEqual(fired, ["Root/Add.success", "Root/Get.success", "Root.success"])
        calls = [call["operation"] for delta in deltas for call in delta["data"]["calls"]]
        self.assertEqual(calls, ["add", "get"])

    def test_a_core_that_others_have_started_with_new_arguments_is_shown_to_who_comes_then(self):
        core = self.server.core(models.storing("anew"), {"value": 1}, start=False)
        with self.server.stream() as before, self.server.stream() as after:
            for channel in ("state", "derivation"):
                before.subscribe(f"core/{core}/{channel}")
                before.message()
            self.server.post(f"/cores/{core}/start", {"arguments": {"value": 2}}, "core")
            self.server.wait(core, lambda c: c["status"] == "ended")
            for channel in ("state", "derivation"):
                after.subscribe(f"core/{core}/{channel}")
                self.assertEqual(after.message()["kind"], "snapshot", channel)

    def test_a_client_that_reconnects_gets_what_it_missed(self):
        core = self.server.core(models.ticking("missed", last=100000))
        channel = f"core/{core}/state"
        with self.server.stream() as stream:
            stream.subscribe(channel)
            seen = stream.until(lambda m: m["kind"] == "delta")
        self.server.wait(core, lambda c: c["step"] >= seen[-1]["data"]["core"]["step"] + 3)
        with self.server.stream() as stream:
            stream.subscribe(channel, since=seen[-1]["sequence"])
            first = stream.message()
            self.assertEqual((first["kind"], first["sequence"]), ("delta", seen[-1]["sequence"] + 1))
        with self.server.stream() as stream:
            stream.subscribe(channel, since=5)  # of an earlier server
            self.assertEqual(stream.message()["kind"], "snapshot")
        with self.server.stream() as stream:
            stream.subscribe(channel, since=first["sequence"] + 10**9)  # never used
            self.assertEqual(stream.message()["kind"], "snapshot")
        self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)

    def test_a_second_subscriber_sees_the_same_from_its_snapshot_on(self):
        core = self.server.core(models.ticking("both", last=100000))
        channel = f"core/{core}/state"
        with self.server.stream() as first, self.server.stream() as second:
            first.subscribe(channel)
            first.until(lambda m: m["kind"] == "delta")
            second.subscribe(channel)
            theirs = [second.message() for _ in range(6)]
            self.assertEqual(theirs[0]["kind"], "snapshot")
            ours = first.until(lambda m: m["sequence"] == theirs[-1]["sequence"])
            common = {m["sequence"]: m for m in ours}
            for message in theirs[1:]:
                if message["sequence"] in common:
                    self.assertEqual(message, common[message["sequence"]])
            state = theirs[0]["data"]
            for message in theirs[1:]:
                state = apply(state, message["data"])
            self.assertEqual(state["core"], theirs[-1]["data"]["core"])
        self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)

    def test_messages_come_together_for_who_asks_for_it(self):
        core = self.server.core(models.hurrying("together"))
        channel = f"core/{core}/state"
        with self.server.stream() as single, self.server.stream() as together:
            together.send_checked({"type": "gather"})
            for stream in (single, together):
                stream.subscribe(channel)
            arrays = [together.messages() for _ in range(20)]
            messages = [message for array in arrays for message in array]
            self.assertGreater(len(messages), 2 * len(arrays), "steps of 1 ms, arrays of 20 ms")
            self.assertEqual([m["kind"] for m in messages[:2]], ["snapshot", "delta"])
            numbers = [m["sequence"] for m in messages]
            self.assertEqual(numbers, list(range(numbers[0], numbers[0] + len(numbers))))
            theirs = single.until(lambda m: m["sequence"] == numbers[-1])[1:]
            same = min(len(theirs), len(messages) - 1)
            self.assertGreater(same, len(arrays))
            self.assertEqual(messages[-same:], theirs[-same:])
        self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)

    def test_who_gathers_gets_a_lone_message_as_an_array_too_and_errors(self):
        with self.server.stream() as stream:
            stream.send_checked({"type": "gather"})
            stream.send({"type": "gather", "period": 1})
            refused, = stream.messages()
            self.assertEqual((refused["kind"], refused["data"]["errors"][0]["path"]), ("error", "period"))
            stream.subscribe("cores")
            self.assertEqual([m["kind"] for m in stream.messages()], ["snapshot"])

    def test_subscribing_within_a_macro_step_loses_no_change(self):
        core = self.server.core(models.chain("within"), start=False)
        self.server.post(f"/cores/{core}/pause", None, "core")
        self.server.post(f"/cores/{core}/start", None, "core")
        micro = lambda: self.server.post(f"/cores/{core}/step", {"kind": "micro"}, "core")
        with self.server.stream() as first, self.server.stream() as second:
            first.subscribe(f"core/{core}/state")
            views = [first.message()["data"]]
            for _ in range(3):
                micro()
            second.subscribe(f"core/{core}/state")
            views.append(second.message()["data"])
            self.assertEqual(views[1]["core"]["micro"], 3)
            micro()
            self.server.post(f"/cores/{core}/step", {"kind": "macro"}, "core")
            for number, stream in enumerate((first, second)):
                for delta in stream.until(lambda m: m["data"]["core"]["micro"] == 0):
                    self.assertEqual(delta["kind"], "delta")
                    views[number] = apply(views[number], delta["data"])
        state = normalized(self.server.get(f"/cores/{core}/state", "core_state"))
        self.assertEqual([normalized(view) for view in views], [state, state])

    def test_derivations_of_the_live_run_are_those_of_its_replay(self):
        core = self.server.core(models.ticking("derived", last=4), start=False)
        with self.server.stream() as stream:
            stream.subscribe(f"core/{core}/derivation")
            self.assertEqual(stream.message()["data"], {"next": 1})
            self.server.post(f"/cores/{core}/start", None, "core")
            ended = self.server.ended(core)
            live = []
            while len(live) < ended["step"]:
                live += stream.message()["data"]["steps"]
        replayed = self.server.get(f"/cores/{core}/derivations?from=1&to={ended['step']}", "derivations")["steps"]
        for ours, theirs in zip(live, replayed, strict=True):
            self.assertEqual((ours["step"], ours["input"], ours["micro"], ours["calls"], ours["first"], ours["complete"]),
                             (theirs["step"], theirs["input"], theirs["micro"], theirs["calls"], 0, True))

    def test_the_recorder_starts_with_the_first_watcher(self):
        core = self.server.core(models.ticking("late", last=100000))
        self.server.wait(core, lambda c: c["step"] >= 3)
        for _ in range(2):
            with self.server.stream() as stream:
                stream.subscribe(f"core/{core}/derivation")
                messages = [stream.message(), stream.message()]
            self.assertEqual(messages[0]["kind"], "snapshot")
            self.assertGreaterEqual(messages[0]["data"]["next"], 4)
            self.assertGreaterEqual(messages[1]["data"]["steps"][0]["step"], messages[0]["data"]["next"])
            self.assertTrue(messages[1]["data"]["steps"][0]["micro"])
        self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)

    def test_cores_services_and_log(self):
        with self.server.stream() as stream:
            for channel in ("cores", "services", "log"):
                stream.subscribe(channel)
                first = stream.until(lambda m, name=channel: m["channel"] == name)[-1]
                self.assertEqual(first["kind"], "snapshot")
            document = models.calling("timer", "cancel", "heard")
            document["root"]["exit"] = "print('leaving')"
            core = self.server.core(document)
            awaited = [lambda m: m["channel"] == "log" and m["data"]["entries"][0]["text"] == "leaving",
                       lambda m: m["channel"] == "services" and m["data"]["services"][0]["key"] == "timer"]

            def is_last(message):
                awaited[:] = [each for each in awaited if not each(message)]
                return not awaited
            messages = stream.until(is_last)
            self.server.ended(core)
            self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)
            messages += stream.until(lambda m: m["channel"] == "cores" and "removed" in m["data"])
            states = [m["data"]["core"]["status"] for m in messages
                      if m["channel"] == "cores" and m["data"].get("core", {}).get("id") == core]
            self.assertEqual((states[0], states[-1]), ("ready", "ended"))

    def test_the_cores_channel_reports_status_changes_only(self):
        with self.server.stream() as stream:
            stream.subscribe("cores")
            stream.message()
            core = self.server.core(models.ticking("counted", last=6))
            ours = lambda m: m["data"].get("core", {}).get("id") == core
            reported = [m for m in stream.until(lambda m: ours(m) and m["data"]["core"]["status"] == "ended") if ours(m)]
            self.assertEqual([m["data"]["core"]["status"] for m in reported], ["ready", "running", "ended"])

    def test_a_channel_ends_with_its_core(self):
        core = self.server.core(models.ticking("removed", last=100000))
        with self.server.stream() as stream:
            stream.subscribe(f"core/{core}/state")
            stream.message()
            self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)
            ended = stream.until(lambda m: m["kind"] == "error")[-1]
            self.assertEqual(ended["data"]["errors"][0]["code"], "not_found")

    def test_a_client_that_does_not_read_its_answers_is_disconnected(self):
        with self.server.stream() as stream:
            for number in range(600):  # each is answered with an error that names it
                stream.send({"type": "subscribe", "channel": f"{number}/" + 60_000 * "x"})
            answers = 0
            with self.assertRaises(ConnectionError):
                while True:
                    stream.receive()
                    answers += 1
            self.assertLess(answers, 600)

    def test_stopping_or_deleting_a_run_calls_the_safe_operations_of_its_services(self):
        gripping = models.document("gripping", {"state": "Root", "entry": "svc.gripper.release(width=par.width, speed=0.005)",
                                                "parameters": [{"name": "width", "value": 0.0}]})
        gripper = lambda m: next((s for s in m["data"]["services"] if s["key"] == "gripper"), {})
        for method, command in (("POST", "/stop"), ("DELETE", "")):
            with self.subTest(method=method), self.server.stream() as stream:
                stream.subscribe("services")
                stream.message()
                core = self.server.core(gripping, {"width": 0.0 if command else 0.11})
                stream.until(lambda m: gripper(m).get("last") == "release")
                self.server.expect(method, f"/cores/{core}{command}", None, "core", 200)
                stopped = gripper(stream.until(lambda m: gripper(m).get("last") not in (None, "release"))[-1])
                self.assertEqual(stopped["last"], "stop")

    def test_the_cell_moves_in_world_time(self):
        with self.server.stream() as stream:
            stream.subscribe("cell/pose")
            first, second = stream.message(), stream.message()
            self.assertGreater(second["sequence"], first["sequence"])
            self.assertGreater(second["data"]["time"], first["data"]["time"])
            scene = self.server.get("/cell", "scene")
            movable = {body["name"] for body in scene["bodies"] if not body["fixed"]}
            self.assertEqual(set(first["data"]["bodies"]), movable)
            stream.send({"type": "unsubscribe", "channel": "cell/pose"})
            stream.subscribe("cores")
            poses = [first, second, *stream.until(lambda m: m["channel"] == "cores")[:-1]]
            # Without subscribers no poses are made: half a second later the numbers continue where they were.
            later = self.server.get("/health", "health")["time"] + 0.5
            while self.server.get("/health", "health")["time"] < later:
                pass
            stream.subscribe("cell/pose")
            again = stream.until(lambda m: m["channel"] == "cell/pose")[-1]
            self.assertLess(again["sequence"], poses[-1]["sequence"] + 8)

    def test_a_client_that_does_not_read_falls_back_to_a_snapshot(self):
        # Each macro step carries a long text, so the queue soon exceeds what a client may leave unread.
        document = models.document("loud", {
            "state": "Root", "variables": [{"name": "text", "initial": ""}],
            "children": [
                {"state": "A", "entry": "svc.db.get('none')",
                 "ports": [{"name": "next", "when": "svc.db.get.error", "to": "B"}]},
                {"state": "B", "results": [{"name": "t"}], "entry": "res.t = 'x' * 100000\nsvc.db.get('none')",
                 "ports": [{"name": "next", "when": "svc.db.get.error", "to": "A"}]}],
            "first": "A"})
        core = self.server.core(document, start=False)
        with self.server.stream() as slow:
            slow.subscribe(f"core/{core}/state")
            snapshot = slow.message()
            self.server.post(f"/cores/{core}/start", None, "core")
            self.server.wait(core, lambda c: c["step"] > 2000)
            self.server.post(f"/cores/{core}/pause", None, "core")
            numbers, kinds = [snapshot["sequence"]], []
            last = self.server.get(f"/cores/{core}", "core")["step"]
            state = snapshot["data"]
            while state["core"]["step"] < last:
                message = slow.message()
                numbers.append(message["sequence"])
                kinds.append(message["kind"])
                state = message["data"] if message["kind"] == "snapshot" else apply(state, message["data"])
                if message["kind"] == "delta":
                    self.assertEqual(numbers[-1], numbers[-2] + 1)
        self.assertIn("snapshot", kinds)
        self.assertLess(len(kinds), 2000)
        self.assertEqual(normalized(state)["state"], normalized(self.server.get(f"/cores/{core}/state", "core_state"))["state"])
        self.server.expect("DELETE", f"/cores/{core}", None, "core", 200)


if __name__ == "__main__":
    unittest.main()
