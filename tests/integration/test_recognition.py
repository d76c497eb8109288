"""Camera and recognition in a run: a task that searches a part in the demo's cell."""
import json
import math
import unittest

import models
from client import PROJECT
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


if __name__ == "__main__":
    unittest.main()
