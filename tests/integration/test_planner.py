"""The example planner sorts tables by seed in the simulated cell, or says why not: held against where the bodies are.

RACE_PLANNER_SEEDS: the tables, as `1,2,3`, or `all` for the twenty that deploy/soak tries; else six of them, of every kind.
"""
import contextlib
import functools
import math
import os
import queue
import re
import sys
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import planners
from cell import DATABASE, NAMES, O_T_C, SCENE, copy_cell
from client import Server
from geometry import rotate
from python_clients import race_client

from planner.goal import GRID, Goal, read_goal
from planner.refusal import Refused
from planner.run import PLANS, Sorter
from planner.scene import Part, Scene, look
from planner.search import find_moves, problem_of
from planner.table import BODIES, Table, lay, table_by_seed

ASKED = os.environ.get("RACE_PLANNER_SEEDS", "2,3,6,7,18,20")
SEEDS = range(1, 21) if ASKED == "all" else [int(seed) for seed in ASKED.split(",")]
SERVERS = 3  # at a time: each takes a third of a processor core
THERE = 0.015  # [m]
REASONS = {"absent": "there is no {last} on the table", "far": "the place Far of the {last} is out of reach",
           "double": "2 parts are to be at the place {first}"}
FOLDER = tempfile.TemporaryDirectory(prefix="race-test-")


@functools.cache
def cell():
    """The demo's, whose camera is calibrated."""
    return str(copy_cell(Path(FOLDER.name, "cell"), {"database.json": {**DATABASE, "o_t_c": O_T_C}}))


def poses(server):
    with contextlib.closing(server.stream()) as stream:
        stream.subscribe("cell/pose")
        return stream.message()["data"]


@dataclass(frozen=True)
class Sorted:
    """What the planner has said of a table, where everything is then, and the cores that it has made."""

    status: int
    lines: list
    cell: dict
    cores: list
    seconds: float


def sort(seed, servers):
    server = servers.get()
    try:
        begun, before = time.monotonic(), {core["id"] for core in server.get("/cores")["cores"]}
        status, lines = planners.plan(server.port, "--seed", str(seed))
        cores = [core for core in server.get("/cores")["cores"] if core["id"] not in before]
        return Sorted(status, lines, poses(server), cores, time.monotonic() - begun)
    finally:
        servers.put(server)


@functools.cache
def tables():
    """Each seed's, sorted on a few servers at once."""
    servers = queue.Queue()
    with contextlib.ExitStack() as stack:
        for _ in range(min(SERVERS, len(SEEDS))):
            servers.put(stack.enter_context(Server("--demo", cell())))
        with ThreadPoolExecutor(SERVERS) as pool:
            found = dict(zip(SEEDS, pool.map(lambda seed: sort(seed, servers), SEEDS), strict=True))
    for seed, out in found.items():
        print(f"seed {seed}: {out.lines[-1]} after {out.seconds:.0f} s and {len(out.cores)} runs", file=sys.stderr)
    return found


class CellAssertions(unittest.TestCase):
    def assert_at(self, bodies, label, place, within=THERE):
        """The part stands at the place."""
        pose = bodies[NAMES[label]]
        self.assertLess(math.dist(pose["position"][:2], place), within, label)
        self.assertAlmostEqual(pose["position"][2], BODIES[label][1], delta=0.004, msg=label)
        if label != "Cube":
            self.assertGreater(rotate(pose["orientation"], [0, 0, 1])[2], 0.98, f"{label} stands")


class Tables(CellAssertions):
    def test_each_is_sorted_or_refused_with_its_reason(self):
        for seed, out in tables().items():
            table = table_by_seed(seed)
            with self.subTest(seed=seed, table=table, lines=out.lines[-8:]):
                if table.flaw == "none":
                    self.assertEqual((out.status, out.lines[-1]), (0, "sorted"))
                    for label, place in table.goal.parts.items():
                        self.assert_at(out.cell["bodies"], label, table.goal.places[place])
                    self.assertEqual(set(out.cell["bodies"]), {NAMES[label] for label in table.parts}, "none was lost")
                    continue
                labels = list(table.goal.parts)
                reason = REASONS[table.flaw].format(first=table.goal.parts[labels[0]], last=labels[-1])
                self.assertEqual((out.status, out.lines[-1]), (1, f"refused: {reason}"))

    def test_what_is_refused_moves_nothing(self):
        for seed, out in tables().items():
            table = table_by_seed(seed)
            if table.flaw == "none":
                continue
            with self.subTest(seed=seed):
                self.assertEqual(out.cores, [])
                for label, (at, _) in table.parts.items():
                    self.assert_at(out.cell["bodies"], label, at, 0.005)
                joints = [out.cell["joints"][f"a{i}"] for i in range(1, 8)]
                self.assertLess(max(abs(a - b) for a, b in zip(joints, SCENE["robot"]["q"], strict=True)), 0.01)

    def test_each_first_document_is_refused_once_and_mended(self):
        for seed, out in tables().items():
            if not out.cores:
                continue
            with self.subTest(seed=seed):
                told = [line.split(": ") for line in out.lines if line.startswith("  refused: ")]
                self.assertIn(["library/PickFound/Grab", "link_unknown"], [words[1:3] for words in told])
                self.assertEqual({words[2] for words in told} - {"link_unknown"},
                                 {"out_of_range"} if table_by_seed(seed).goal.speed > 1 else set())
                self.assertEqual(out.cores[0]["status"], "ended")

    def test_no_more_moves_than_needed(self):
        """If nothing goes wrong: as many as a search on the true table finds."""
        for seed, out in tables().items():
            table = table_by_seed(seed)
            plans = [line for line in out.lines if re.match(r"plan \d", line)]
            if table.flaw != "none" or len(plans) > 1:
                continue
            true = find_moves(problem_of(table.goal, truth(table), None))
            self.assertEqual(len(plans[0].split(",")) if plans else 0, len(true), (seed, plans))


def truth(table):
    """The scene as the table was laid."""
    return Scene({label: Part(label, at, BODIES[label][1], True, 1.0) for label, (at, _) in table.parts.items()}, frozenset(BODIES), False)


class Replanning(CellAssertions):
    """Somebody interferes when a step has ended; in this process, so that the test hears of it."""

    @classmethod
    def setUpClass(cls):
        cls.server = Server("--demo", cell())
        cls.addClassCleanup(cls.server.stop)
        cls.race = race_client.Client(f"http://127.0.0.1:{cls.server.port}")
        cls.addClassCleanup(cls.race.close)

    def sort(self, parts, goal, acts=(), every=False, plans=PLANS):
        """What the sorter has said. `acts`: (text of a step, commands of a person when it is said first, or every time)."""
        lay(self.race, Table({label: (at, 0.0) for label, at in parts.items()}, Goal(goal), "none"))
        lines, waiting = [], list(acts)

        def say(text):
            lines.append(text)
            for act in [act for act in waiting if act[0] in text]:
                if not every:
                    waiting.remove(act)
                for command in act[1]:
                    self.server.post("/cell/person", command)

        try:
            Sorter(self.race, Goal(goal), say, plans=plans).sort()
            lines.append("sorted")
        except Refused as refused:
            lines.append(f"refused: {refused}")
        return lines

    @staticmethod
    def put(label, x, y):
        return {"act": "place", "part": NAMES[label], "pose": {"position": [x, y, BODIES[label][1]], "orientation": [0, 0, 0, 1]}}

    def plans(self, lines):
        return [line for line in lines if line.startswith("plan ")]

    def test_a_part_that_is_moved_meanwhile_is_looked_for_again(self):
        out = self.sort({"Cube": (0.5, -0.2)}, {"Cube": "A1"}, [("Search: A part was found", [self.put("Cube", 0.55, -0.35)])])
        self.assertEqual((out[-1], len(self.plans(out))), ("sorted", 2), out)
        self.assertTrue(any("Pick: No part is between the fingers" in line for line in out), out)
        self.assert_at(poses(self.server)["bodies"], "Cube", GRID["A1"])

    def test_a_part_that_is_taken_away_is_refused(self):
        out = self.sort({"Cube": (0.5, -0.2)}, {"Cube": "A1"}, [("Search: A part was found", [{"act": "take", "part": NAMES["Cube"]}])])
        self.assertEqual((out[-1], len(self.plans(out))), ("refused: there is no Cube on the table", 1), out)

    def test_a_place_that_is_taken_after_it_was_planned_is_cleared(self):
        """The part meets another one that was put there; it is still held, put down elsewhere or brought there later."""
        out = self.sort({"Cube": (0.5, -0.2), "Box": (0.5, -0.4)}, {"Cube": "A1"},
                        [("Pick: The part is in the gripper", [self.put("Box", *GRID["A1"])])])
        self.assertEqual(out[-1], "sorted", out)
        self.assertGreater(len(self.plans(out)), 1, out)
        self.assert_at(poses(self.server)["bodies"], "Cube", GRID["A1"])

    def test_plans_are_bounded(self):
        out = self.sort({"Cube": (0.5, -0.2)}, {"Cube": "A1"}, every=True, plans=2, acts=[
            ("Search: A part was found", [self.put("Cube", 0.55, -0.35)]), ("Pick: No part", [self.put("Cube", 0.5, -0.2)])])
        self.assertTrue(out[-1].startswith("refused: 2 plans were not enough; the last was stopped: Move1_Cube/Pick: No part"), out)
        self.assertEqual(len(self.plans(out)), 2)

    def test_what_is_seen_is_where_it_is(self):
        parts = {"Cube": (0.45, -0.3), "Box": GRID["B1"], "Block": (0.6, -0.1), "Tape": GRID["A3"]}
        lay(self.race, Table({label: (at, 0.3) for label, at in parts.items()}, Goal({}), "none"))
        seen = look(self.race)
        self.assertEqual((set(seen.parts), seen.holds), (set(parts), False))
        for label, part in seen.parts.items():
            self.assertLess(math.dist(part.at, parts[label]), 0.005, label)
            self.assertTrue(part.upright, label)


class CommandLine(unittest.TestCase):
    def test_says_what_is_wrong_with_it(self):
        with Server("--demo", cell()) as server:
            for text, expected in (("{}", "parts: an object"), ("[", "Expecting value")):
                goal = Path(FOLDER.name, "goal.json")
                goal.write_text(text)
                status, lines = planners.plan(server.port, "--goal", str(goal))
                self.assertEqual(status, 2)
                self.assertRegex(lines[-1], f"^--goal: {expected}")
            goal.write_text('{"parts": {"Cup": "A1"}}')
            status, lines = planners.plan(server.port, "--goal", str(goal))
            self.assertEqual((status, lines[0], lines[-1]), (1, "goal: Cup to A1", "refused: the camera knows no part Cup"))
            self.assertEqual(planners.plan(server.port)[0], 2)
        self.assertEqual(planners.plan(server.port, "--goal", str(goal))[0], 1, "there is no server")

    def test_a_cell_without_recognition_or_a_taught_home_is_refused(self):
        unknown = {key: value for key, value in DATABASE.items() if key != "pose_home"}
        for changes, expected in (({"files": {"database.json": unknown}}, "db.get: not_found"), ({"without": ["parts.json"]}, "obj_rec")):
            folder = copy_cell(tempfile.mkdtemp(dir=FOLDER.name), **changes)
            with self.subTest(expected), Server("--demo", str(folder)) as server:
                goal = Path(FOLDER.name, "cube.json")
                goal.write_text('{"parts": {"Cube": "A1"}}')
                status, lines = planners.plan(server.port, "--goal", str(goal))
                self.assertEqual(status, 1)
                self.assertIn(f"refused: {expected}", lines[-1])
                self.assertEqual(server.get("/cores")["cores"], [])


class Readme(unittest.TestCase):
    def test_its_goal_is_one(self):
        text = re.search(r"^```json\n(.*?)^```$", planners.README, re.MULTILINE | re.DOTALL).group(1)
        self.assertEqual(read_goal(text).parts, {"Cube": "A1", "Box": "left"})

    def test_its_table_is_among_those_that_are_sorted(self):
        self.assertIn(int(planners.OPTIONS.split()[1]), range(1, 21))


if __name__ == "__main__":
    unittest.main()
