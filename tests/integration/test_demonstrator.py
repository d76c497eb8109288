"""The demonstrator of the thesis' appendix A, whole and unattended: headless, on the real server, replayed, and begun again."""
import functools
import hashlib
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from cell import BODIES, DATABASE, DEMO, DOCUMENT, FALSE, NAMES, O_T_C, SYMMETRY, TAUGHT
from client import PROGRAM, Server, check
from geometry import angle, moved, turned_by
from test_commands import race

MODEL, SCRIPT = DEMO / "demonstrator.rcm.json", DEMO / "operator.json"
WORK = "Demonstrator/Table/Work/"
SEEDS = [int(seed) for seed in os.environ.get("RACE_SEEDS", "8").split(",")]  # besides 7
FOLDER = tempfile.TemporaryDirectory(prefix="race-test-")
KNOWN = Path(FOLDER.name, "known.sqlite")  # what the database knows after a whole run


@dataclass(frozen=True)
class Told:
    """A run that is over: `inputs` of its macro steps in order, `doing`: number of a macro step -> what was active after
    it, for those in which a collision was told and those before; `bodies`: where the world has everything; `lasted`: s of world time."""
    outcome: str
    results: dict
    lasted: float
    bodies: dict
    inputs: list
    doing: dict

    def events(self, name):
        return [each["data"] for each in self.inputs if each.get("event") == name]

    def answers(self, service, operation):
        """Results of an operation, in order."""
        return [i["result"] for i in self.inputs
                if "result" in i and (i["service"], i["operation"]) == (service, operation)]


def collided(inputs):
    """Numbers of the macro steps in which a collision was told."""
    return [n for n, each in enumerate(inputs, 1) if each.get("event") == "collision"]


def run(*options, seed=7):
    status, lines, errors = race("run", MODEL, "--fast", "--seed", seed, "--json", *options)
    assert status == 0, (seed, errors, lines[-1:])
    return lines


@functools.cache
def lines(seed=7, attempt=1):
    """What a run with the operator's script prints; the second time it keeps what it learns."""
    return run("--operator", SCRIPT, *(["--database", KNOWN] if attempt == 2 else []), seed=seed)


def told(lines):
    reports = [json.loads(line) for line in lines]
    steps, last = [r for r in reports if "step" in r], reports[-1]
    active, doing = set(), {}
    for step in steps:
        active = active - {s for s, now in step["active"].items() if not now} | {s for s, now in step["active"].items() if now}
        doing[step["step"]] = active
    cell = check("cell_pose", last["cell"])
    return Told(last["outcome"], last["results"], cell["time"], cell["bodies"], [step["input"] for step in steps], doing)


@functools.cache
def headless(seed=7):
    return told(lines(seed))


def serve():
    """(the same on the server, its script as exported)"""
    with Server("--demo", str(DEMO), "--operator", str(SCRIPT)) as server:
        began = time.monotonic()
        core = server.core(DOCUMENT)
        ended = server.ended(core, timeout=300)
        lasted = time.monotonic() - began
        with server.stream() as stream:
            stream.subscribe("cell/pose")
            cell = stream.message()["data"]
        inputs = [entry["input"] for entry in server.get(f"/cores/{core}/journal")["entries"]]
        state = lambda n: server.get(f"/cores/{core}/derivations?from={n}", "derivations")["steps"][0]["state"]
        doing = {n: set(state(n)["active"]) for hit in collided(inputs) for n in (hit - 1, hit)}
        script = server.get(f"/cores/{core}/script", "script")
    print(f"unattended on the server: {lasted:.0f} s", file=sys.stderr)
    return Told(ended.get("outcome"), ended["results"], cell["time"], cell["bodies"], inputs, doing), script


@functools.cache
def serving():
    return ThreadPoolExecutor(1).submit(serve)


def served():
    return serving().result()


def setUpModule():
    if not sys.argv[1:]:  # of all tests: it takes two minutes in real time, and headless runs are made meanwhile
        serving()


class Measured:
    """How a run is measured against the cell."""

    def calibrated(self, told):
        o_t_c = told.results["o_t_c"]
        self.assertLess(math.dist(o_t_c["position"], O_T_C["position"]), 0.005)
        self.assertLess(angle(o_t_c["orientation"], O_T_C["orientation"]), 1)
        self.assertTrue(0 < told.results["residual_position"] < 0.01, told.results)
        self.assertTrue(0 < told.results["residual_angle"] < math.radians(1), told.results)

    def placed(self, told, labels=frozenset(NAMES)):
        """They stand in the world where they were let go, and that is where they belong. The false part was not touched."""
        results, bodies, area = told.results, told.bodies, DATABASE["place_area"]
        let_go = {part["label"]: part["o_t_x"] for part in results["placed"]}
        self.assertEqual((told.outcome, sorted(part["label"] for part in results["placed"]), results["skipped"]),
                         ("success", sorted(labels), []))
        for label in labels:
            is_at = bodies[NAMES[label]]
            for place in let_go[label], DATABASE.get(f"o_t_place_{label}", let_go[label]):
                self.assertLess(math.dist(is_at["position"], place["position"]), 0.005, label)
                self.assertLess(turned_by(is_at["orientation"], place["orientation"], SYMMETRY[label]), 3, label)
            self.assertTrue(all(low < at < high for low, at, high in zip(area["min"], is_at["position"], area["max"])), label)
        self.assertLess(math.dist(bodies[FALSE]["position"], BODIES[FALSE]["pose"]["position"]), 0.001)

    def survived(self, told):
        """A display answers the first and the last; nobody but the hand at the arm the one between."""
        story, grasping = [], False
        for n, each in enumerate(told.inputs, 1):
            if each.get("event") == "collision" and WORK + "Collision" in told.doing[n - 1]:
                story[-1] = each["data"]["severity"]  # more of the same
            elif each.get("event") == "collision" and WORK + "Collision" in told.doing[n]:
                story.append(each["data"]["severity"])
                grasping = grasping or WORK + "Task/Pick/Grasp" in told.doing[n - 1]
            elif each.get("operation") == "choose" and "result" in each:
                story.append(each["result"])
        self.assertEqual((story, grasping), (["light", "Continue", "medium", "severe", "Continue"], True))


class Demonstrated(Measured):
    """What holds of every unattended run, wherever it was: `told`."""

    def test_it_calibrates_the_camera_and_says_how_well(self):
        self.calibrated(self.told)

    def test_it_places_five_parts_where_they_belong(self):
        self.placed(self.told)

    def test_it_survives_collisions_of_each_severity_one_while_grasping(self):
        self.survived(self.told)

    def test_the_place_that_is_missing_is_taught_once(self):
        added = [key for key in self.told.answers("db", "add") if key.startswith("o_t_place")]
        self.assertEqual(added, [f"o_t_place_{TAUGHT}"])

    def test_nobody_waits_for_it_longer_than_three_minutes(self):
        """Of world time, which passes on the server as it does for a person."""
        self.assertLess(self.told.lasted, 180)

    def test_what_is_told_by_recognition_is_never_the_false_part(self):
        """Nothing that it ever saw lies where the false part does."""
        seen = [thing for event in self.told.events("recognized_objects") for thing in event["objects"] if thing["label"] != "Tool"]
        self.assertGreater(len(seen), 10)
        self.assertEqual({thing["label"] for thing in seen}, set(NAMES))
        for thing in seen:
            at = moved(self.told.results["o_t_c"], thing["pose"]["position"])
            self.assertGreater(math.dist(at, BODIES[FALSE]["pose"]["position"]), 0.05, thing)


class Headless(Demonstrated, unittest.TestCase):
    told = property(lambda self: headless())

    def test_the_same_seed_gives_the_same_run(self):
        self.assertEqual(lines(attempt=1), lines(attempt=2))

    def test_other_seeds_come_to_the_same_end(self):
        for seed in SEEDS:
            with self.subTest(seed=seed):
                told = headless(seed)
                self.assertNotEqual(told.results, headless().results)
                self.calibrated(told)
                self.placed(told)
                self.survived(told)


class OnTheServer(Demonstrated, unittest.TestCase):
    told = property(lambda self: served()[0])


def script_of(inputs):
    """The steps of a script (core/SEMANTICS.md, section 7) that give these inputs one by one; the first macro step has none."""
    kinds = {"event": "events", "response": "responses"}
    return [{kinds[i["kind"]]: [{key: value for key, value in i.items() if key != "kind"}]} if i["kind"] in kinds else {}
            for i in inputs]


def derived(script):
    """(hash of what `race derive` prints, outcome, results of the root at the end); what it prints is half a gigabyte."""
    path = Path(FOLDER.name, "script.json")
    path.write_text(json.dumps(script))
    hashed, tail = hashlib.sha256(), b""
    with subprocess.Popen([PROGRAM, "derive", MODEL, path], stdout=subprocess.PIPE) as process:
        while chunk := process.stdout.read(1 << 20):
            hashed.update(chunk)
            tail = (tail + chunk)[-(2 << 20):]
    tail = tail.decode(errors="ignore")
    state, end = json.JSONDecoder().raw_decode(tail.rpartition('\n   "state": ')[2])
    outcome = re.search(r'"outcome": "(\w+)"', tail[tail.rindex('\n "status": '):])
    return hashed.hexdigest(), outcome and outcome.group(1), state["results"]["Demonstrator"]


class Replayed(unittest.TestCase):
    """A run is a function of its inputs."""

    def test_what_the_server_exports_gives_its_outcome_and_results(self):
        told, script = served()
        self.assertEqual(script["steps"], script_of(told.inputs))
        _, outcome, results = derived(script)
        self.assertEqual((outcome, results), (told.outcome, told.results))

    def test_the_same_seed_gives_the_same_derivations(self):
        frame = {key: value for key, value in served()[1].items() if key != "steps"}
        first, second = (derived(frame | {"steps": script_of(told(lines(attempt=n)).inputs)}) for n in (1, 2))
        self.assertEqual(first, second)
        self.assertEqual(first[1:], (headless().outcome, headless().results))


class Again(Measured, unittest.TestCase):
    """On a database that an earlier run has left behind."""

    def run_again(self, *without, acts=(), **arguments):
        lines(attempt=2)
        acts = [{"do": [{"act": "take", "part": NAMES[label]} for label in without]}, *acts]
        script = Path(FOLDER.name, "operator.json")
        script.write_text(json.dumps(check("operator", {"operator": 1, "displays": ["phone"], "acts": acts})))
        return told(run("--operator", script, "--database", KNOWN, "--limit", 120, "--arguments", json.dumps(arguments)))

    def test_what_is_known_is_neither_calibrated_nor_taught_again(self):
        again = self.run_again("Box", "Block", "Bar")
        self.placed(again, {"Cube", TAUGHT})
        self.assertEqual(set(again.answers("db", "add")), {"object_pose"})
        self.assertEqual(again.results["o_t_c"], headless().results["o_t_c"])
        self.assertNotIn("residual_position", again.results)  # nobody has measured

    def test_what_is_known_is_calibrated_again_if_that_is_asked_for(self):
        nobody_leads = {"when": {"display": {"text": "places are there, but no more come"}}, "do": {"act": "answer", "button": "Abort"}}
        again = self.run_again(*NAMES, acts=[nobody_leads], recalibrate=True, patience=10.0)
        self.assertEqual((again.outcome, again.results.get("o_t_c")), ("abort", None))
        self.assertEqual(len(again.answers("obj_rec", "start")), 1)  # it has looked for the tool

    def test_a_clear_table_is_a_success_at_once(self):
        again = self.run_again(*NAMES, begin="Table")
        self.placed(again, set())
        self.assertEqual(again.answers("gripper", "grasp"), [])


if __name__ == "__main__":
    unittest.main()
