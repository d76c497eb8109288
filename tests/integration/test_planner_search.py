"""What the example planner makes of a scene: goals that are refused, the fewest moves; without a server."""
import itertools
import math
import random
import unittest

import planners  # noqa: F401  (where the planner is)
from planner_models import lying, scene

from planner.goal import GRID, Goal, check_goal, check_scene, is_in_reach, read_goal
from planner.refusal import Refused
from planner.scene import Part, best_of, part_of
from planner.search import CLEARANCE, Problem, find_moves, problem_of
from planner.table import BESIDE, BODIES, FLAWS, table_by_seed

LABELS = frozenset(BODIES)


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
        for goal, text in ((Goal({"Cup": "A1"}), "the camera knows no part Cup"), (Goal({"Cube": "Z9"}), "there is no place Z9"),
                           (Goal({"Cube": "Far"}, {"Far": (0.9, 0.3)}), "the place Far of the Cube is out of reach"),
                           (Goal({"Cube": "A1", "Box": "A1"}), "2 parts are to be at the place A1")):
            self.refused(text, check_goal, goal, LABELS)
        check_goal(Goal({"Cube": "A1", "Box": "A2"}), LABELS)

    def test_for_which_parts_are_missing_are_refused(self):
        goal = Goal({"Cube": "A1"})
        self.refused("there is no Cube on the table", check_scene, goal, scene(Box="A2"), None)
        self.refused("the Cube is out of reach", check_scene, goal, scene(Cube=(0.9, 0.3)), None)
        self.refused("the Cube lies on its side", check_scene, goal, lying(scene(Cube="B1"), "Cube"), None)
        self.refused("there is a part in the gripper", check_scene, goal, scene(holds=True, Cube="B1"), None)
        check_scene(goal, scene(holds=True), "Cube")

    def test_are_read_from_files(self):
        self.assertEqual(read_goal('{"parts": {"Cube": "A1"}}'), Goal({"Cube": "A1"}, GRID, 1.0))
        self.assertEqual(read_goal('{"parts": {"Cube": "P"}, "places": {"P": [0.4, 0.1]}, "speed": 0.5}'),
                         Goal({"Cube": "P"}, {"P": (0.4, 0.1)}, 0.5))
        for wrong in ("", "[]", "{}", '{"parts": {}}', '{"parts": {"Cube": 1}}', '{"parts": {"Cube": "A1"}, "speed": true}',
                      '{"parts": {"Cube": "A1"}, "speed": NaN}', '{"parts": {"Cube": "A1"}, "speed": 1' + 400 * "0" + "}",
                      '{"parts": {"Cube": "A1"}, "places": {"A1": [1]}}',
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

    def test_a_part_that_lies_is_not_moved_aside(self):
        with self.assertRaisesRegex(Refused, "no order of moves"):
            moves({"Cube": "A1"}, lying(scene(Cube="B3", Box="A1"), "Box"))

    def test_places_are_not_taken_for_where_parts_were(self):
        """Whatever a goal calls its places."""
        names = ("from_Box", "Box", "where_B")
        for name in names:
            goal = read_goal(f'{{"parts": {{"Box": "{name}"}}, "places": {{"{name}": [0.5, 0.1]}}}}')
            [move] = find_moves(problem_of(goal, scene(Box=(0.5, -0.2)), None))
            self.assertEqual((move.spot, move.at), (name, (0.5, 0.1)))

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


class Tables(unittest.TestCase):
    def test_seeds_lay_tables_of_all_kinds(self):
        tables = [table_by_seed(seed) for seed in range(1, 21)]
        self.assertEqual({table.flaw for table in tables}, set(FLAWS))
        self.assertEqual([table_by_seed(seed) for seed in range(1, 21)], tables, "a seed is one table")
        for table in tables:
            places = [at for at, _ in table.parts.values()]
            self.assertTrue(all(math.dist(a, b) >= BESIDE for a, b in itertools.combinations(places, 2)))
            self.assertTrue(all(is_in_reach(at) for at in places))

    def test_their_goals_are_reached_or_refused_as_their_flaws_say(self):
        reasons = {"absent": "there is no", "far": "out of reach", "double": "parts are to be at"}
        for seed in range(1, 201):
            table = table_by_seed(seed)
            here = scene(**{label: at for label, (at, _) in table.parts.items()})
            try:
                check_goal(table.goal, LABELS)
                check_scene(table.goal, here, None)
                problem = problem_of(table.goal, here, None)
                at = follow(problem, find_moves(problem))
                self.assertEqual({label: at[label] for label in table.goal.parts}, table.goal.parts)
                self.assertEqual(table.flaw, "none", seed)
            except Refused as refused:
                self.assertIn(reasons.get(table.flaw, "?"), str(refused), seed)


if __name__ == "__main__":
    unittest.main()
