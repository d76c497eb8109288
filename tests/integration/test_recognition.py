"""Camera and recognition: a task that searches a part in the demo's cell, and requests that look without a task."""
import json
import math
import unittest

import models
from accounts import AccountServer
from cell import BODIES, NAMES, O_T_C, SYMMETRY
from client import PROJECT, Server
from component_process import service
from controls import Controls
from geometry import transform
from test_commands import race

DEMO = PROJECT / "deploy/demo"
SCENE = json.loads((DEMO / "scene.json").read_text())


def searching():
    """Starts recognition of `label`: `found` with the part's pose in o, or `refused`."""
    take = ("for o in svc.obj_rec.recognized_objects.objects:\n"
            "    if o.label == par.label:\n"
            "        res.o_t_x = geo.compose(par.o_t_c, o.pose)\n")
    return models.document("looking", {
        "state": "Look", "results": [{"name": "o_t_x"}],
        "parameters": [{"name": "label", "value": "Tape"}, {"name": "o_t_c", "value": SCENE["camera"]["pose"]}],
        "entry": "svc.obj_rec.start([par.label])", "exit": "svc.obj_rec.stop()",
        "actions": [{"when": "svc.obj_rec.recognized_objects", "do": take}],
        "ports": [{"name": "found", "when": "available(res.o_t_x)"},
                  {"name": "refused", "when": "svc.obj_rec.start.error"}]})


def search(label, seed=7):
    arguments = json.dumps({"label": label})
    status, lines, errors = race("run", "DOCUMENT", "--fast", "--json", "--cell", DEMO, "--seed", seed, "--limit", 5,
                                 "--arguments", arguments, document=searching())
    assert lines, errors
    return status, lines, json.loads(lines[-1])


class Recognition(unittest.TestCase):
    def test_a_part_is_found_where_the_scene_has_it(self):
        body = next(b for b in SCENE["bodies"] if b["name"] == "can_yellow")
        status, _, last = search("Tape")
        self.assertEqual((status, last["outcome"]), (0, "found"))
        self.assertLess(math.dist(last["results"]["o_t_x"]["position"], body["pose"]["position"]), 0.005)

    def test_the_same_seed_gives_the_same_run(self):
        first = search("Cube")[1]
        self.assertEqual(first, search("Cube")[1])
        self.assertNotEqual(first, search("Cube", seed=8)[1])

    def test_an_unknown_label_is_refused(self):
        status, lines, last = search("Spoon")
        self.assertEqual((status, last["outcome"]), (0, "refused"))
        self.assertIn("there is no part `Spoon`", "\n".join(lines))


class Looks(unittest.TestCase):
    def call(self, server, operation, key="obj_rec"):
        return server.post(f"/services/{key}/calls", {"operation": operation}, "service_response")

    def assert_sees_the_cell(self, seen):
        """The parts are where the scene has them; the tool is a part, too."""
        places = {o["label"]: transform(O_T_C, o["pose"]["position"]) for o in seen["objects"]}
        self.assertEqual(places.keys() - {"Tool"}, NAMES.keys())
        for label, name in NAMES.items():
            self.assertLess(math.dist(places[label], BODIES[name]["pose"]["position"]), 0.005, label)

    def test_a_request_learns_what_the_camera_sees_and_nothing_moves(self):
        with Server("--demo", str(DEMO)) as server:
            before = self.call(server, "state", "robot")["result"]["q"]
            first = self.call(server, "look")["result"]
            self.assert_sees_the_cell(first)
            self.assertGreater(self.call(server, "look")["result"]["time"], first["time"])
            self.assertEqual(self.call(server, "labels"), {"result": list(SYMMETRY)})
            now = self.call(server, "state", "robot")["result"]["q"]
            self.assertLess(math.dist(before, now), 1e-3)
            self.assertEqual(server.get("/control", "control")["leases"], [])
            recognition = service(server, "obj_rec")
            self.assertEqual((recognition["state"], recognition["violations"]), ("Idle", []))
            self.assertFalse(recognition["subscribes"][0]["listening"])

    def test_it_is_looked_while_somebody_else_has_the_controls(self):
        with Server("--demo", str(DEMO)) as server:
            alice = Controls(server)
            self.addCleanup(alice.close)
            alice.take()
            self.assert_sees_the_cell(self.call(server, "look")["result"])

    def test_a_run_that_recognizes_goes_on(self):
        with Server("--demo", str(DEMO)) as server:
            core = server.core(models.document("seeing", {
                "state": "Root", "entry": "svc.obj_rec.start(['Tape'])", "exit": "svc.obj_rec.stop()",
                "variables": [{"name": "pictures", "initial": 0}, {"name": "wrong", "initial": 0}],
                "actions": [{"when": "svc.obj_rec.recognized_objects", "do": (
                    "var.pictures += 1\n"
                    "for o in svc.obj_rec.recognized_objects.objects:\n"
                    "    if o.label != 'Tape':\n"
                    "        var.wrong += 1\n")}],
                "ports": [{"name": "disturbed", "when": "var.wrong > 0"}, {"name": "seen", "when": "var.pictures >= 20"}]}))
            server.wait_for(lambda: service(server, "obj_rec")["state"] == "Recognizing")
            seen = self.call(server, "look")["result"]
            self.assertEqual([o["label"] for o in seen["objects"]], ["Tape"], "what the run looks for")
            self.assertEqual(self.call(server, "labels"), {"result": list(SYMMETRY)})
            self.assertEqual(service(server, "obj_rec")["state"], "Recognizing")
            self.assertEqual(server.ended(core)["outcome"], "seen")
            self.assertEqual(service(server, "obj_rec")["violations"], [])

    def test_an_observer_is_not_answered(self):
        with AccountServer("--demo", str(DEMO)) as server:
            calls = "/api/v1/services/obj_rec/calls"
            statuses = [server.ask(account, "POST", calls, {"operation": "labels"}) for account in ("observer", "operator")]
            self.assertEqual(statuses, [403, 200])


if __name__ == "__main__":
    unittest.main()
