"""What the example planner decides without a server: goals that are refused, moves, documents of skills, and how it mends them."""
import dataclasses
import itertools
import json
import math
import random
import sys
import unittest
from pathlib import Path

import planners
from played_server import PlayedServer
from skills import DOCUMENT

from planner import repair, tasks
from planner.compose import document_of
from planner.goal import GRID, Goal, check_goal, check_scene, is_in_reach, read_goal
from planner.refusal import Refused
from planner.run import PLANS, Sorter
from planner.scene import Part, Scene, best_of, part_of
from planner.search import CLEARANCE, Move, Problem, find_moves, problem_of
from planner.skills import Skill, services_in
from planner.table import APART, BODIES, FLAWS, table_by_seed

LIBRARY = {state["state"]: state for state in DOCUMENT["library"]}
SKILLS = {name: Skill(state, LIBRARY, DOCUMENT["services"]) for name, state in LIBRARY.items() if state["meta"].get("skill")}
HERE = frozenset(DOCUMENT["services"])
MOVES = [Move("Cube", "A1", GRID["A1"], held=False), Move("Box", "B2", GRID["B2"], held=False)]


def scene(holds=False, **parts):
    """`parts`: label -> name of a place, or x and y."""
    at = {label: GRID.get(where, where) for label, where in parts.items()}
    return Scene({label: Part(label, xy, 0.02, True, 0.9) for label, xy in at.items()}, frozenset(BODIES), holds)


def moves(goal, here, held=None):
    return [(move.label, move.spot) for move in find_moves(problem_of(Goal(goal), here, held))]


def follow(problem, found):
    """Where each part is after the moves, each of which is held against what picking and placing require."""
    at = dict(problem.start)
    for i, move in enumerate(found):
        assert move.held == (i == 0 and problem.holding == move.label), move
        if not move.held:
            assert at.pop(move.label) in problem.spots, "picked where the arm reaches"
        assert move.spot in problem.spots, move
        assert all(math.dist(move.at, problem.positions[other]) >= CLEARANCE for other in at.values()), (move, at)
        at[move.label] = move.spot
    return at


def fewest(problem):
    """How many moves are needed at least, by trying all."""
    start = frozenset(problem.start.items())
    seen, level, count = {start}, [start], 0
    while True:
        if any(all(dict(at).get(part) == spot for part, spot in problem.goal.items()) for at in level):
            return count
        after = set()
        for at in level:
            for part, spot in at:
                rest = at - {(part, spot)}
                for to, xy in problem.spots.items():
                    if spot in problem.spots and all(math.dist(xy, problem.positions[each]) >= CLEARANCE for _, each in rest):
                        after.add(rest | {(part, to)})
        level = after - seen
        seen, count = seen | level, count + 1


class Goals(unittest.TestCase):
    def refused(self, text, function, *arguments):
        with self.assertRaises(Refused) as caught:
            function(*arguments)
        self.assertEqual(str(caught.exception), text)

    def test_that_are_impossible_are_refused_with_the_reason(self):
        known = frozenset(BODIES)
        for goal, text in ((Goal({"Cup": "A1"}), "the camera knows no part Cup"), (Goal({"Cube": "Z9"}), "there is no place Z9"),
                           (Goal({"Cube": "Far"}, {"Far": (0.9, 0.3)}), "the place Far of the Cube is out of reach"),
                           (Goal({"Cube": "A1", "Box": "A1"}), "2 parts are to be at the place A1")):
            self.refused(text, check_goal, goal, known)
        check_goal(Goal({"Cube": "A1", "Box": "A2"}), known)

    def test_for_which_parts_are_missing_are_refused(self):
        goal = Goal({"Cube": "A1"})
        lying = dataclasses.replace(scene(Cube="B1").parts["Cube"], upright=False)
        self.refused("there is no Cube on the table", check_scene, goal, scene(Box="A2"), None)
        self.refused("the Cube is out of reach", check_scene, goal, scene(Cube=(0.9, 0.3)), None)
        self.refused("the Cube lies on its side", check_scene, goal, Scene({"Cube": lying}, frozenset(BODIES), False), None)
        self.refused("there is a part in the gripper", check_scene, goal, scene(holds=True, Cube="B1"), None)
        check_scene(goal, scene(holds=True), "Cube")

    def test_are_read_from_files(self):
        self.assertEqual(read_goal('{"parts": {"Cube": "A1"}}'), Goal({"Cube": "A1"}, GRID, 1.0))
        self.assertEqual(read_goal('{"parts": {"Cube": "P"}, "places": {"P": [0.4, 0.1]}, "speed": 0.5}'),
                         Goal({"Cube": "P"}, {"P": (0.4, 0.1)}, 0.5))
        for wrong in ("", "[]", "{}", '{"parts": {}}', '{"parts": {"Cube": 1}}', '{"parts": {"Cube": "A1"}, "speed": true}',
                      '{"parts": {"Cube": "A1"}, "speed": NaN}', '{"parts": {"Cube": "A1"}, "places": {"A1": [1]}}',
                      '{"parts": {"Cube": "A1"}, "places": {"A/1": [0.4, 0]}}', '{"parts": {"Cube": "A1"}, "what": 1}'):
            with self.subTest(wrong), self.assertRaises(ValueError):
                read_goal(wrong)


class Scenes(unittest.TestCase):
    CAMERA = {"position": [1.0, 0.0, 1.0], "orientation": [1.0, 0.0, 0.0, 0.0]}  # looks straight down: half a turn about x

    def part(self, position, orientation=(1.0, 0.0, 0.0, 0.0), **more):
        pose = {"position": position, "orientation": orientation}
        return part_of(self.CAMERA, {"label": "Cube", "confidence": 0.9, "pose": pose, **more})

    def test_an_object_is_told_where_it_stands_in_o(self):
        part = self.part([-0.5, 0.2, 0.98])
        for value, expected in zip((*part.at, part.height), (0.5, -0.2, 0.02), strict=True):
            self.assertAlmostEqual(value, expected)
        self.assertTrue(part.upright)
        self.assertFalse(self.part([-0.5, 0.2, 0.98], [0.0, 0.0, 0.0, 1.0]).upright, "its z points down")
        quarter = [math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)]  # of a turn about x
        self.assertFalse(self.part([-0.5, 0.2, 0.98], quarter).upright)

    def test_what_is_no_part_on_the_table_does_not_count(self):
        for position in ([-0.9, 0.0, 0.98], [-0.5, 0.7, 0.98], [-0.5, 0.0, 0.7], [-0.5, 0.0, 1.1]):
            self.assertIsNone(self.part(position), position)
        self.assertIsNone(self.part([-0.5, 0.0, 0.98], label="Tool"))
        self.assertIsNone(self.part([-0.5, 0.0, 0.98], confidence=0.5))

    def test_of_two_with_one_label_the_surer_counts(self):
        sure, unsure = (Part("Cube", (x, 0.0), 0.02, True, x) for x in (0.9, 0.7))
        self.assertEqual(best_of([sure, unsure]), {"Cube": sure})


class Search(unittest.TestCase):
    def test_what_is_there_is_not_moved(self):
        self.assertEqual(moves({"Cube": "A1"}, scene(Cube="A1", Box="A2")), [])
        self.assertEqual(moves({"Cube": "A1"}, scene(Cube=(GRID["A1"][0] + 0.01, GRID["A1"][1]))), [])

    def test_a_part_in_the_way_is_moved_aside_before(self):
        found = moves({"Cube": "A1"}, scene(Cube=(0.5, -0.3), Box="A1"))
        self.assertEqual((len(found), found[0][0], found[1]), (2, "Box", ("Cube", "A1")))
        found = moves({"Cube": "A1"}, scene(Cube=(0.5, -0.3), Box=(GRID["A1"][0], GRID["A1"][1] - 0.08)))
        self.assertEqual((len(found), found[0][0]), (2, "Box"), "beside the place, but too near")

    def test_two_parts_change_places_by_a_third(self):
        found = moves({"Cube": "A1", "Box": "A2"}, scene(Cube="A2", Box="A1"))
        self.assertEqual(len(found), 3)
        self.assertEqual(found[0][0], found[2][0])

    def test_a_part_that_is_held_is_put_down_first(self):
        self.assertEqual(moves({"Cube": "A1"}, scene(holds=True), "Cube"), [("Cube", "A1")])
        found = find_moves(problem_of(Goal({"Cube": "A1"}), scene(holds=True, Box="A1"), "Cube"))
        self.assertEqual([(move.label, move.held) for move in found], [("Cube", True), ("Box", False), ("Cube", False)])

    def test_a_part_that_is_held_does_not_stand_where_it_is_seen(self):
        self.assertEqual(moves({"Cube": "A1"}, scene(holds=True, Cube="A2"), "Cube"), [("Cube", "A1")])

    def test_without_room_it_says_so(self):
        places = {"A": (0.5, 0.0), "B": (0.5, 0.2)}
        full = scene(Cube=places["A"], Box=places["B"])
        with self.assertRaisesRegex(Refused, "no order of moves"):
            find_moves(problem_of(Goal({"Cube": "B", "Box": "A"}, places), full, None))

    def test_a_part_that_cannot_be_reached_stays_and_blocks(self):
        problem = problem_of(Goal({"Cube": "A"}, {"A": (0.7, 0.2), "B": (0.5, 0.0)}), scene(Cube=(0.5, -0.3), Box=(0.8, 0.22)), None)
        with self.assertRaisesRegex(Refused, "no order of moves"):
            find_moves(problem)

    def test_random_tables_take_the_fewest_moves(self):
        """Against a search that tries everything."""
        by = random.Random(1)
        spots = {name: GRID[name] for name in ("A1", "A2", "B1", "B3")}
        for _ in range(200):
            labels = by.sample(sorted(BODIES), by.randint(1, 3))
            start = dict(zip(labels, by.sample(sorted(spots), len(labels)), strict=True))
            wanted = by.sample(labels, by.randint(1, len(labels)))
            goal = dict(zip(wanted, by.sample(sorted(spots), len(wanted)), strict=True))
            problem = Problem(spots, start, spots, goal)
            found = find_moves(problem)
            at = follow(problem, found)
            self.assertEqual({label: at[label] for label in goal}, goal)
            self.assertEqual(len(found), fewest(problem))


class Skills(unittest.TestCase):
    def test_are_read_with_ports_and_services(self):
        self.assertEqual((SKILLS["PickFound"].nominal, SKILLS["PickFound"].outcomes), ("success", ()))
        self.assertEqual(SKILLS["SearchObject"].outcomes, ("none",))
        self.assertIn("no_part", SKILLS["PickFound"].errors)
        self.assertEqual((SKILLS["AskPerson"].nominal, SKILLS["AskPerson"].outcomes), ("yes", ("no",)))
        ports = [{"name": "success"}, {"name": "no", "meta": {"advice": "?"}}, {"name": "best", "meta": {"nominal": True}}]
        marked = Skill({"state": "Marked", "ports": ports}, {}, {})
        self.assertEqual((marked.nominal, marked.outcomes, marked.errors), ("best", ("success",), ("no",)))
        self.assertEqual(SKILLS["PickFound"].services(), {"robot", "gripper", "timer"})
        self.assertEqual(SKILLS["SearchObject"].services(), {"obj_rec", "db", "timer"})
        state = {"entry": "svc.a.b()", "meta": {"do": "svc.c.d()"}, "children": [{"ports": [{"when": "svc.e.f"}]}]}
        self.assertEqual(services_in(state), {"a", "e"})

    def test_the_closure_is_all_that_is_linked(self):
        found = SKILLS["PickFound"].closure()
        self.assertTrue({"PickFound", "Grab", "MoveTool", "RiseTo"} <= found.keys())
        self.assertTrue(all(link in found for state in found.values() for link in json.dumps(state).split('"link": "')[1:]
                            for link in [link.partition('"')[0]]))


def whole(draft):
    """The draft with all that its skills link."""
    return dataclasses.replace(draft, library=tuple(dict.fromkeys(name for skill in draft.library for name in SKILLS[skill].closure())))


class Compose(unittest.TestCase):
    """The form of api/skills.md, as web/shared/timeline reads it."""

    DRAFTS = (tasks.sorting("sorting", MOVES, 1.0), tasks.going_aside("sorting", 1.0), tasks.calibrating("sorting"),
              tasks.sorting("sorting", [dataclasses.replace(MOVES[0], held=True)], 1.0),
              tasks.draft("looking", "Look", (tasks.Task("Look", "Look", (tasks.Step("Search", "SearchObject"),)),)))

    def check_task(self, task, document):
        library = {state["state"]: state for state in document["library"]}
        self.assertEqual(task.keys(), {"state", "children", "first", "ports", "meta"})
        ports = {port["name"]: set(port["when"].split(" or ")) for port in task["ports"]}
        self.assertEqual((list(ports), task["first"]), (["success", "error"], task["children"][0]["state"]))
        ends, stops = set(), set()
        for step, following in zip(task["children"], [*task["children"][1:], None], strict=True):
            name, to = step["state"], {port["name"]: port.get("to") for port in step.get("ports", [])}
            onward = following and following["state"]
            if "link" not in step:
                self.check_task(step, document)
                nominal, outcomes, errors = "success", (), ("error",)
            else:
                skill = Skill(library[step["link"]], library, {})
                nominal, outcomes, errors = skill.nominal, skill.outcomes, skill.errors
                self.assertTrue({each["name"] for each in step.get("parameters", [])} <= skill.parameters.keys())
                self.check_sources(step, skill, task, library)
            self.assertEqual([to.get(port) for port in (nominal, *outcomes)], [onward] * (1 + len(outcomes)), name)
            self.assertLessEqual(len({to.get(port) for port in errors}), 1, name)
            goes_on = to.get(errors[0]) is not None if errors else False
            stops |= set() if goes_on else {f"chi.{name}.port.{port}" for port in errors}
            ends |= {f"chi.{name}.port.{port}" for port in (nominal, *outcomes)} if following is None else set()
        self.assertEqual(ports, {"success": ends, "error": stops or {"False"}})

    def check_sources(self, step, skill, task, library):
        """A parameter of the domain `found` takes what a step before it finds."""
        before = [each["state"] for each in task["children"][:task["children"].index(step)]]
        for name, parameter in skill.parameters.items():
            if parameter.get("meta", {}).get("domain") != "found":
                continue
            given = {each["name"]: each for each in step["parameters"]}[name]
            self.assertTrue(any(given == {"name": name, "from": f"chi.{source}.res.found"} for source in before), given)

    def test_documents_are_time_lines(self):
        for draft in self.DRAFTS:
            document = document_of(whole(draft), SKILLS)
            self.check_task(document["root"], document)
            self.assertEqual({step.skill for step in tasks.steps_of(draft).values()}, set(draft.library))
            self.assertTrue(set(document["services"]) <= HERE)

    def test_web_reads_such_a_time_line(self):
        """What is held there is what is composed here: web/tests/timeline/planned.test.ts."""
        planned = json.loads((planners.PROJECT / "web/tests/timeline/planned.json").read_text())
        self.assertEqual(document_of(whole(self.DRAFTS[0]), SKILLS)["root"], planned)

    def test_every_required_parameter_has_a_value(self):
        for draft in self.DRAFTS:
            for path, step in tasks.steps_of(draft).items():
                required = {name for name, each in SKILLS[step.skill].parameters.items() if each.get("value") is None}
                self.assertLessEqual(required, {*step.values, *step.takes}, path)

    def test_places_are_poses_of_the_tool_above_them(self):
        here, home = scene(Cube=(0.5, -0.2), Box=(0.5, -0.4)), {"pose": {}, "q": [0.0] * 7}
        poses = tasks.poses_of(MOVES, here, {"Tape": 0.04}, home)
        self.assertEqual(set(poses), {"pose_plan_A1_Cube", "pose_plan_B2_Box"})
        self.assertEqual(poses["pose_plan_A1_Cube"]["pose"]["position"], [*GRID["A1"], 0.022])
        held = [Move("Tape", "A1", GRID["A1"], held=True)]
        self.assertEqual(tasks.poses_of(held, here, {"Tape": 0.04}, home)["pose_plan_A1_Tape"]["pose"]["position"][2], 0.042)

    def test_names_are_those_of_states_and_poses_whatever_parts_are_called(self):
        odd = Move("M8 nut, größer", "B2", GRID["B2"], held=False)
        task = tasks.task_of(1, odd, 1.0)
        self.assertRegex(task.name, r"^[A-Za-z_][A-Za-z0-9_]*$")
        self.assertRegex(tasks.pose_name(odd.label, "from_" + odd.label), r"^[A-Za-z0-9_-]{1,32}$")

    def test_a_missing_skill_is_refused(self):
        with self.assertRaisesRegex(Refused, "no skill PickFound"):
            document_of(self.DRAFTS[0], {name: skill for name, skill in SKILLS.items() if name != "PickFound"})


class Repair(unittest.TestCase):
    DRAFT = tasks.sorting("sorting", MOVES, 1.2)

    def errors(self, draft, here=HERE):
        return repair.errors_of(draft, SKILLS, here, PlayedServer({}))

    def test_a_draft_is_refused_once_and_mended(self):
        errors = self.errors(self.DRAFT)
        self.assertEqual({error["code"] for error in errors}, {"link_unknown", "out_of_range"})
        self.assertIn(("library/PickFound/Grab", "link_unknown"), [(error["path"], error["code"]) for error in errors])
        mended = repair.repaired(self.DRAFT, errors, SKILLS)
        self.assertEqual(self.errors(mended), [])
        self.assertEqual({step.values.get("speed", 1.0) for step in tasks.steps_of(mended).values()}, {1.0})
        self.assertEqual(set(mended.library), {name for skill in self.DRAFT.library for name in SKILLS[skill].closure()})

    def test_a_value_is_brought_into_its_range_and_no_other(self):
        slow = tasks.sorting("sorting", MOVES, 0.01)
        error = {"path": "Sorting/Move1_Cube/Pick", "code": "out_of_range", "message": ""}
        before, after = tasks.steps_of(slow), tasks.steps_of(repair.repaired(slow, [error], SKILLS))
        self.assertEqual(after.pop(error["path"]).values, {"speed": 0.05, "opening": tasks.OPENING})
        del before[error["path"]]
        self.assertEqual(before, after)

    def test_a_parameter_that_the_skill_has_not_is_dropped(self):
        error = {"path": "Sorting/Move1_Cube/Pick", "code": "link_parameter", "message": "`PickFound` has no parameter `opening`"}
        state = {**LIBRARY["PickFound"], "parameters": [each for each in LIBRARY["PickFound"]["parameters"] if each["name"] != "opening"]}
        older = {**SKILLS, "PickFound": Skill(state, {**LIBRARY, "PickFound": state}, DOCUMENT["services"])}
        after = tasks.steps_of(repair.repaired(self.DRAFT, [error], older))[error["path"]]
        self.assertEqual((after.values, after.takes), ({"speed": 1.2}, {"found": ("Search", "found")}))

    def test_what_is_not_needed_is_left_out_where_its_service_is_not_there(self):
        draft = whole(tasks.sorting("sorting", MOVES, 1.0))
        errors = self.errors(draft, HERE - {"display", "audio"})
        self.assertEqual({(error["path"], error["code"]) for error in errors}, {("Sorting/Tell/Say", "unavailable")})
        mended = repair.repaired(draft, errors, SKILLS)
        self.assertEqual(self.errors(mended, HERE - {"display", "audio"}), [])
        self.assertNotIn("Sorting/Tell/Say", tasks.steps_of(mended))
        self.assertEqual(len(tasks.steps_of(mended)), len(tasks.steps_of(draft)) - 1)

    def test_what_cannot_be_mended_is_refused_with_path_and_code(self):
        draft = whole(tasks.sorting("sorting", MOVES, 1.0))
        with self.assertRaisesRegex(Refused, "Sorting/Move1_Cube/Pick: unavailable: the service gripper is not there"):
            repair.repaired(draft, self.errors(draft, HERE - {"gripper"}), SKILLS)
        for path, code in (("Sorting", "syntax"), ("library/Gone/X", "link_unknown"), ("library/PickFound/Grab", "link_unknown")):
            error = {"path": path, "code": code, "message": "it is there"}
            with self.assertRaisesRegex(Refused, f"{error['path']}: {error['code']}"):
                repair.repaired(draft, [error], SKILLS)
            fast = tasks.sorting("sorting", MOVES, 1.2)
            beside = {"path": "Sorting/End/Aside", "code": "out_of_range", "message": ""}  # can be mended
            with self.assertRaises(Refused):
                repair.repaired(fast, [beside, {**error, "code": "syntax"}], SKILLS)


class Tables(unittest.TestCase):
    def test_seeds_lay_tables_of_all_kinds(self):
        tables = [table_by_seed(seed) for seed in range(1, 21)]
        self.assertEqual({table.flaw for table in tables}, set(FLAWS))
        self.assertEqual([table_by_seed(seed) for seed in range(1, 21)], tables, "a seed is one table")
        for table in tables:
            places = [at for at, _ in table.parts.values()]
            self.assertTrue(all(math.dist(a, b) >= min(0.14, APART) for a, b in itertools.combinations(places, 2)))
            self.assertTrue(all(is_in_reach(at) for at in places))

    def test_their_goals_are_reached_or_refused_as_their_flaws_say(self):
        reasons = {"absent": "there is no", "far": "out of reach", "double": "parts are to be at"}
        for seed in range(1, 201):
            table = table_by_seed(seed)
            here = scene(**{label: at for label, (at, _) in table.parts.items()})
            try:
                check_goal(table.goal, here.labels)
                check_scene(table.goal, here, None)
                problem = problem_of(table.goal, here, None)
                at = follow(problem, find_moves(problem))
                self.assertEqual({label: at[label] for label in table.goal.parts}, table.goal.parts)
                self.assertEqual(table.flaw, "none", seed)
            except Refused as refused:
                self.assertIn(reasons.get(table.flaw, "?"), str(refused), seed)


def nothing(server):
    """Nobody interferes."""


class Sorting(unittest.TestCase):
    """The whole planner, at a server that plays."""

    CUBE = {"Cube": (0.5, -0.2)}

    def sort(self, server, parts, **how):
        """What it has said, `sorted` or why not at the end."""
        lines = []
        try:
            Sorter(server, Goal(parts, speed=how.pop("speed", 1.0)), lines.append, **how).sort()
            return [*lines, "sorted"]
        except Refused as refused:
            return [*lines, f"refused: {refused}"]

    def assert_sorted(self, server, parts, plans, **how):
        out = self.sort(server, parts, **how)
        self.assertEqual((out[-1], sum(line.startswith("plan ") for line in out)), ("sorted", plans), out)
        for label, place in parts.items():
            self.assertLess(math.dist(server.parts[label], GRID[place]), 0.001)
        self.assertEqual((server.held, server.deleted), (None, []))
        return out

    def test_parts_are_brought_to_their_places(self):
        server = PlayedServer({"Cube": GRID["A2"], "Box": GRID["A1"], "Bar": (0.5, -0.3)})
        out = self.assert_sorted(server, {"Cube": "A1", "Box": "A2"}, 1)
        self.assertEqual(len(server.runs), 1)
        told = [line.strip().split(": ")[0] for line in out if "/" in line and "refused" not in line]
        self.assertEqual(told[:2] + told[-1:], ["Tell/Say", "Tell/Wait", "End/Aside"])
        self.assertEqual(len(told), 2 + 3 * 4 + 1, "the ports within skills are not told")
        self.assertIn("  Move1_Cube/Pick: The part is in the gripper", [line.replace("Move1_Box", "Move1_Cube") for line in out])

    def test_what_is_there_already_runs_nothing(self):
        server = PlayedServer({"Cube": GRID["A1"]})
        self.assert_sorted(server, {"Cube": "A1"}, 0)
        self.assertEqual(server.runs, [])

    def test_too_fast_is_as_fast_as_it_goes(self):
        server = PlayedServer(self.CUBE)
        out = self.assert_sorted(server, {"Cube": "A1"}, 1, speed=1.2)
        self.assertIn("  refused: Sorting/Move1_Cube/Pick: out_of_range: `speed` is 0.05 to 1, not 1.2", out)

    def test_after_an_error_it_goes_aside_looks_and_plans_again(self):
        moved = lambda server: server.parts.update(Cube=[0.55, -0.35])
        server = PlayedServer(self.CUBE, {"Sorting/Move1_Cube/Pick": [("no_part", moved)]})
        out = self.assert_sorted(server, {"Cube": "A1"}, 2)
        self.assertIn("  Move1_Cube/Pick: No part is between the fingers (because of no_part)", out)
        self.assertEqual([[task["state"] for task in run["root"]["children"]] for run in server.runs],
                         [["Tell", "Move1_Cube", "End"], ["Aside"], ["Tell", "Move1_Cube", "End"]])

    def test_a_part_in_the_hand_is_put_down_first(self):
        """Somebody has put another part there; it is not seen between the fingers, but its height is known."""
        blocked = lambda server: server.parts.update(Box=list(GRID["A1"]))
        server = PlayedServer({**self.CUBE, "Box": (0.5, -0.4)}, {"Sorting/Move1_Cube/Pick": [(None, blocked)]})
        out = self.assert_sorted(server, {"Cube": "A1"}, 2)
        self.assertTrue(any(line.endswith("in the gripper: Cube") for line in out), out)
        steps = [step["state"] for step in server.runs[2]["root"]["children"][1]["children"]]
        self.assertEqual(steps, ["Place"], "it is not looked for")

    def test_what_it_goes_on_after_is_not_what_has_stopped_it(self):
        fails = {"Sorting/Tell/Say": [("no_display", nothing)] * 2, "Sorting/Move1_Cube/Pick": [("blocked", nothing)]}
        server = PlayedServer(self.CUBE, fails)
        self.assertIn("stopped: Move1_Cube/Pick: ", self.sort(server, {"Cube": "A1"}, plans=1)[-1])
        self.assert_sorted(server, {"Cube": "A1"}, 1)

    def test_a_part_that_has_gone_is_refused(self):
        gone = lambda server: server.parts.clear()
        server = PlayedServer(self.CUBE, {"Sorting/Move1_Cube/Search": [(None, gone)]})
        out = self.sort(server, {"Cube": "A1"})
        self.assertEqual((out[-1], len(server.runs)), ("refused: there is no Cube on the table", 2))
        self.assertTrue(any("No part was found before this step" in line for line in out), out)

    def test_plans_are_bounded(self):
        for plans in (1, PLANS):
            server = PlayedServer(self.CUBE, {"Sorting/Move1_Cube/Pick": [("no_part", nothing)] * 99})
            out = self.sort(server, {"Cube": "A1"}, plans=plans)
            self.assertEqual(out[-1], f"refused: {plans} plans were not enough; the last was stopped: Move1_Cube/Pick: "
                                      "No part is between the fingers (because of no_part)")
            self.assertEqual(sum(line.startswith("plan ") for line in out), plans)

    def test_a_run_that_succeeds_but_leaves_the_part_elsewhere_is_planned_again(self):
        slipped = lambda server: server.parts.update(Cube=[0.5, -0.2])
        server = PlayedServer(self.CUBE, {"Sorting/End/Aside": [(None, slipped)]})
        self.assert_sorted(server, {"Cube": "A1"}, 2)

    def test_an_arm_that_cannot_go_aside_is_refused(self):
        fails = {"Sorting/Move1_Cube/Pick": [("collision", nothing)], "Sorting/Aside/Aside": [("no_robot", nothing)]}
        server = PlayedServer(self.CUBE, fails)
        self.assertRegex(self.sort(server, {"Cube": "A1"})[-1], "^refused: Aside/Aside: The robot does not answer")

    def test_a_run_that_ends_otherwise_is_refused(self):
        server = PlayedServer(self.CUBE, status="faulted")
        self.assertEqual(self.sort(server, {"Cube": "A1"})[-1], "refused: the run is faulted")
        self.assertEqual(server.deleted, ["sorting"])

    def test_an_unknown_camera_is_calibrated_first(self):
        server = PlayedServer(self.CUBE)
        del server.database["o_t_c"]
        self.assert_sorted(server, {"Cube": "A1"}, 1)
        self.assertEqual(server.runs[0]["root"]["meta"]["title"], "Calibrate the camera")

    def test_impossible_goals_run_nothing(self):
        cases = (({"Cube": "A1", "Box": "A1"}, "2 parts are to be at the place A1"), ({"Box": "A1"}, "there is no Box"),
                 ({"Cup": "A1"}, "the camera knows no part Cup"), ({"Cube": "Z1"}, "there is no place Z1"))
        for goal, reason in cases:
            server = PlayedServer(self.CUBE)
            self.assertIn(f"refused: {reason}", self.sort(server, goal)[-1])
            self.assertEqual(server.runs, [])

    def test_a_service_that_is_not_there_is_told_before_anything_moves(self):
        server = PlayedServer(self.CUBE, away=["gripper"])
        self.assertEqual(self.sort(server, {"Cube": "A1"})[-1],
                         "refused: Sorting/Move1_Cube/Pick: unavailable: the service gripper is not there")
        self.assertEqual(server.runs, [])
        server = PlayedServer(self.CUBE, away=["display", "audio"])
        self.assert_sorted(server, {"Cube": "A1"}, 1)


class Package(unittest.TestCase):
    def test_it_uses_the_client_library_and_pythons_own_alone(self):
        for path in Path(planners.EXAMPLES, "planner").glob("*.py"):
            for line in path.read_text().splitlines():
                if line.startswith(("import ", "from ")):
                    name = line.split()[1].split(".")[0]
                    self.assertIn(name, {"", "race_client", *sys.stdlib_module_names}, f"{path.name}: {line}")


if __name__ == "__main__":
    unittest.main()
