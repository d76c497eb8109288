"""The example planner as the service Oracle in the simulated cell: a task asks it before each move, and ends if it does not answer.

RACE_PLANNER_SEEDS: the tables, as in test_planner.py; `all`: also all that takes long.
"""
import contextlib
import math
import sys
import time
import unittest

import planners
from cell import NAMES, SCENE
from client import Server
from component_process import LONG_HEARTBEAT, ComponentClient, token_file, wait_available
from planner_cell import CellAssertions, cell, poses
from python_clients import race_client
from test_planner import REASONS, SEEDS
from test_planner_command import CUBE, goal_file
from test_planner_replanning import long, put

from planner.goal import GRID, Goal
from planner.oracle import Oracle, store
from planner.table import Table, lay, table_by_seed
from race_client.service.declaration import Declaration

RUN_TIMEOUT = 180  # seconds: MAX_MOVES take less
START = (0.5, -0.3)


class Asking(CellAssertions):
    @classmethod
    def setUpClass(cls):
        cls.server = Server("--demo", cell(), *LONG_HEARTBEAT)
        cls.addClassCleanup(cls.server.stop)
        cls.race = race_client.Client(f"http://127.0.0.1:{cls.server.port}")
        cls.addClassCleanup(cls.race.close)

    @contextlib.contextmanager
    def answering(self, *options):
        """The process of the planner that answers; it has stored the task."""
        with planners.start(self.server.port, "--oracle", "--token-file", str(token_file(self.server)), *options) as process:
            try:
                said = []
                while not said or "Oracle: connected" not in said[-1]:
                    said.append(process.stdout.readline())
                    self.assertNotEqual(said[-1], "", said)
                yield process
                if process.poll() is None:
                    process.terminate()
                    self.assertEqual(process.wait(10), 0)
            finally:
                process.kill()
        wait_available(self.server, "Oracle", False)

    def lay(self, parts):
        lay(self.race, Table({label: (at, 0.0) for label, at in parts.items()}, Goal({}), "none"))

    def start(self, **arguments):
        """A run of the task that was stored; its core."""
        core = self.server.post("/cores", {"document": "sorting", "arguments": arguments}, "core", 201)["id"]
        self.server.post(f"/cores/{core}/start", None, "core")
        return core

    def ended(self, core):
        """(outcome, why)"""
        out = self.server.ended(core, RUN_TIMEOUT)
        self.assertEqual(out["status"], "ended", out)
        return out["outcome"], out["results"]["why"]

    def joints(self):
        joints = poses(self.server)["joints"]
        return [joints[f"a{i}"] for i in range(1, 8)]

    def turned(self, before):
        """How far a joint is from where it was [rad]."""
        return max(abs(a - b) for a, b in zip(self.joints(), before, strict=True))

    def assert_stands(self):
        before = self.joints()
        time.sleep(0.5)
        self.assertLess(self.turned(before), 0.002)

    def test_each_is_sorted_or_refused_with_its_reason(self):
        for seed in SEEDS:
            table, begun = table_by_seed(seed), time.monotonic()
            labels = list(table.goal.parts)
            with self.subTest(seed=seed, table=table), self.answering("--seed", str(seed)):
                outcome, why = self.ended(self.start())
                bodies = poses(self.server)["bodies"]
                print(f"seed {seed}: {outcome} {why} after {time.monotonic() - begun:.0f} s", file=sys.stderr)
                if table.flaw == "none":
                    self.assertEqual((outcome, why), ("success", ""))
                    for label, place in table.goal.parts.items():
                        self.assert_at(bodies, label, table.goal.places[place])
                    continue
                reason = REASONS[table.flaw].format(first=table.goal.parts[labels[0]], last=labels[-1])
                self.assertEqual((outcome, why), ("error", reason))
                for label, (at, _) in table.parts.items():
                    self.assert_at(bodies, label, at, 0.005)
                self.assertLess(self.turned(SCENE["robot"]["q"]), 0.01)

    def test_without_a_token_of_a_process_it_is_refused(self):
        self.lay({"Cube": START})
        status, lines = planners.plan(self.server.port, "--oracle", "--token-file", "/none", "--goal", goal_file(CUBE))
        self.assertEqual(status, 1, lines)
        self.assertRegex(lines[-1], "^refused: there is no token of a process: .*No such file")

    @long
    def test_a_part_that_is_moved_meanwhile_is_moved_from_where_it_is_then(self):
        self.lay({"Cube": START})
        with self.answering("--goal", goal_file(CUBE)) as process:
            core = self.start()
            with self.race.cores.follow(core) as updates:
                found = "Sorting/Next/Move_Cube_to_A1/Search.success"
                self.assertTrue(any(update.delta and found in update.delta["fired"] for update in updates))
            self.server.post("/cell/person", put("Cube", 0.55, -0.35))
            self.assertEqual(self.ended(core), ("success", ""))
            self.assert_at(poses(self.server)["bodies"], "Cube", GRID["A1"])
            process.terminate()
            self.assertEqual(process.wait(10), 0)
            self.assertEqual(process.stdout.read(), "next: Move_Cube_to_A1\n" * 2 + "next: Sorted\n")

    def test_one_that_is_killed_while_the_arm_moves_ends_the_task_at_the_next_decision(self):
        parts, goal = {"Cube": START, "Box": (0.5, -0.1)}, {"Cube": "A1", "Box": "B3"}
        self.lay(parts)
        with self.answering("--goal", goal_file('{"parts": {"Cube": "A1", "Box": "B3"}}')) as process:
            before, core = self.joints(), self.start()
            self.server.wait_for(lambda: self.turned(before) > 0.05)
            process.kill()
            process.wait()
            wait_available(self.server, "Oracle", False)
            self.assertEqual(self.server.get(f"/cores/{core}")["status"], "running")
            self.assertEqual(self.ended(core), ("error", "planner: unavailable"))
        self.assert_stands()
        bodies = poses(self.server)["bodies"]
        moved, = (label for label in goal if math.dist(bodies[NAMES[label]]["position"][:2], parts[label]) > 0.1)
        self.assert_at(bodies, moved, GRID[goal[moved]])
        other, = goal.keys() - {moved}
        self.assert_at(bodies, other, parts[other], 0.005)

    def test_nothing_moves_without_one_or_with_one_that_names_no_move(self):
        self.lay({"Cube": START})
        store(self.race, Goal({"Cube": "A1"}), "sorting", lambda _: None)
        before = self.joints()
        self.assertEqual(self.ended(self.start()), ("error", "planner: unavailable"))
        client = ComponentClient(self.server)
        self.addCleanup(client.close)
        client.send_checked({"type": "hello", "protocol": 1, "components": [
            {"key": "Oracle", "type": "Oracle", "rsm": Declaration(Oracle).rsm}]})
        client.next("welcome")
        for answer in ("Move_Cup_to_A1", "Next", "sorted"):
            core = self.start(parts={"Cube": "B2"})
            call = client.next("call")
            self.assertEqual(call["args"], [{"Cube": "B2"}, {name: list(at) for name, at in GRID.items()}, 0])
            client.send_checked({"type": "transition", "key": "Oracle", "id": "decide_Ready", "call": call["call"]})
            client.send_checked({"type": "result", "key": "Oracle", "call": call["call"], "value": answer})
            self.assertEqual(self.ended(core), ("error", f"the planner chose {answer}, which is no move of this task"))
        self.assertLess(self.turned(before), 0.002)
        self.assert_at(poses(self.server)["bodies"], "Cube", START, 0.005)


if __name__ == "__main__":
    unittest.main()
