"""The demonstrator of the thesis' appendix A, whole and unattended: headless, on the real server, and with units that die."""
import functools
import json
import math
import unittest

from cell import BODIES, DATABASE, DEMO, DOCUMENT, FALSE, NAMES, O_T_C, TAUGHT
from client import Server, check
from geometry import angle, moved, tilt
from test_commands import race

SCRIPT = DEMO / "operator.json"
WORK = "Demonstrator/Table/Work/"


@functools.cache
def headless(attempt=1):
    """What a run with the operator's script printed."""
    status, lines, errors = race("run", DEMO / "demonstrator.rcm.json", "--fast", "--seed", 7, "--operator", SCRIPT, "--json")
    assert status == 0, errors
    return lines


class Demonstrated(unittest.TestCase):
    """What holds of every unattended run, wherever it was."""

    def calibrated(self, results):
        self.assertLess(math.dist(results["o_t_c"]["position"], O_T_C["position"]), 0.005)
        self.assertLess(angle(results["o_t_c"]["orientation"], O_T_C["orientation"]), 1)

    def placed(self, results, bodies):
        """All five stand in the world where they belong: the taught one where the task was shown. The false part was not touched."""
        places = {part["label"]: part["o_t_x"] for part in results["placed"]}
        self.assertEqual((set(places), len(results["placed"]), results["skipped"]), (set(NAMES), 5, []))
        for label, name in NAMES.items():
            is_at, place = bodies[name], DATABASE.get(f"o_t_place_{label}", places[label])
            self.assertLess(math.dist(is_at["position"], place["position"]), 0.02, label)
            self.assertLess(tilt(is_at["orientation"]), 3, label)
            area = DATABASE["place_area"]
            self.assertTrue(all(low < at < high for low, at, high in zip(area["min"], is_at["position"], area["max"])), label)
        self.assertLess(math.dist(bodies[FALSE]["position"], BODIES[FALSE]["pose"]["position"]), 0.001)


class Headless(Demonstrated):
    def setUp(self):
        self.reports = [json.loads(line) for line in headless()]
        self.last = self.reports[-1]

    def fired(self):
        return [(r["input"], port) for r in self.reports for port in r.get("fired", [])]

    def test_it_calibrates_and_places_five_parts(self):
        self.assertEqual(self.last["outcome"], "success")
        self.calibrated(self.last["results"])
        self.placed(self.last["results"], check("cell_pose", self.last["cell"])["bodies"])

    def test_the_same_seed_gives_the_same_run(self):
        self.assertEqual(headless(1), headless(2))

    def test_it_survives_collisions_of_each_severity_one_while_grasping(self):
        met, grasping = [], False
        active = set()
        for r in self.reports:
            if any(port == WORK + "Task.collision" for port in r.get("fired", [])):
                met.append(r["input"]["data"]["severity"])
                grasping = grasping or WORK + "Task/Pick/Grasp" in active
            elif met and r.get("input", {}).get("event") == "collision" and WORK + "Collision" in active:
                met[-1] = r["input"]["data"]["severity"]
            for state, is_active in r.get("active", {}).items():
                (active.add if is_active else active.discard)(state)
        self.assertEqual(met, ["light", "medium", "severe"])
        self.assertTrue(grasping)
        ways = [port for _, port in self.fired() if port in (WORK + "Collision/Haptic.success", WORK + "Collision/Display.success")]
        self.assertEqual([way.split("/")[-1] for way in ways], ["Display.success", "Haptic.success", "Display.success"])

    def test_the_place_that_is_missing_is_taught_once(self):
        added = [c["args"][0] for r in self.reports for c in r.get("calls", []) if (c["service"], c["operation"]) == ("db", "add")]
        self.assertEqual([key for key in added if key.startswith("o_t_place")], [f"o_t_place_{TAUGHT}"])

    def test_what_is_told_by_recognition_is_never_the_false_part(self):
        """Nothing that it ever saw lies where the false part does."""
        seen = [thing for r in self.reports if r.get("input", {}).get("event") == "recognized_objects"
                for thing in r["input"]["data"]["objects"] if thing["label"] != "Tool"]
        self.assertGreater(len(seen), 10)
        self.assertEqual({thing["label"] for thing in seen}, set(NAMES))
        camera = self.last["results"]["o_t_c"]
        for thing in seen:
            at = moved(camera, thing["pose"]["position"])
            self.assertGreater(math.dist(at, BODIES[FALSE]["pose"]["position"]), 0.05, thing)


class OnTheServer(Demonstrated):
    def test_it_does_the_same_in_real_time(self):
        with Server("--demo", str(DEMO), "--operator", str(SCRIPT)) as server:
            core = server.core(DOCUMENT)
            ended = server.ended(core, patience=300)
            with server.stream() as stream:
                stream.subscribe("cell/pose")
                bodies = stream.message()["data"]["bodies"]
        self.assertEqual(ended["outcome"], "success")
        self.calibrated(ended["results"])
        self.placed(ended["results"], bodies)


if __name__ == "__main__":
    unittest.main()
