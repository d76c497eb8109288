"""The example planner sorts tables by seed in the simulated cell, or says why not: held against where the bodies are.

RACE_PLANNER_SEEDS: the tables, as `1,2,3`, or `all` for the twenty that deploy/soak tries; else five of them, of every kind.
"""
import contextlib
import functools
import math
import queue
import re
import sys
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import planners
from cell import NAMES, SCENE
from client import Server
from planner_cell import CellAssertions, cell, poses
from python_clients import race_client

from planner.goal import Goal
from planner.scene import Part, Scene, look
from planner.search import find_moves, problem_of
from planner.table import BODIES, Table, lay, table_by_seed

ALL = range(1, 21)
SAMPLE = (2, 4, 6, 18, 20)  # two moves, for one part stands in the way; none needed; refused, for each flaw
SEEDS = ALL if planners.IS_LONG else [int(seed) for seed in planners.SEEDS.split(",")] if planners.SEEDS else SAMPLE
SERVERS = 3 if planners.IS_LONG else 1  # at a time: each takes a third of a processor core
REASONS = {"absent": "there is no {last} on the table", "far": "the place Far of the {last} is out of reach",
           "double": "2 parts are to be at the place {first}"}


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


def truth(table):
    """The scene as the table was laid."""
    return Scene({label: Part(label, at, BODIES[label][1], True, 1.0) for label, (at, _) in table.parts.items()}, False)


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

    def test_the_sample_has_every_kind(self):
        kinds = {(table.flaw, len(find_moves(problem_of(table.goal, truth(table), None))) if table.flaw == "none" else None)
                 for table in map(table_by_seed, SAMPLE)}
        self.assertEqual(kinds, {("none", 0), ("none", 2), ("absent", None), ("far", None), ("double", None)})


class Looking(unittest.TestCase):
    def test_what_is_seen_is_where_it_is(self):
        parts = {"Cube": (0.45, -0.3), "Box": (0.57, 0.1), "Block": (0.6, -0.1), "Tape": (0.42, 0.4)}
        with Server("--demo", cell()) as server, race_client.Client(f"http://127.0.0.1:{server.port}") as race:
            lay(race, Table({label: (at, 0.3) for label, at in parts.items()}, Goal({}), "none"))
            seen = look(race)
        self.assertEqual((set(seen.parts), seen.holds), (set(parts), False))
        for label, part in seen.parts.items():
            self.assertLess(math.dist(part.at, parts[label]), 0.005, label)
            self.assertTrue(part.upright, label)


if __name__ == "__main__":
    unittest.main()
