"""The skills of the demo do in the cell what their titles say."""
import math
import unittest

from cell import BODIES, DATABASE, NAMES, O_T_C, SYMMETRY
from geometry import angle, angle_up_to_symmetry
from scenario import HANDS, answer, drag, link, touch
from skills import HELD, HOME, KNOWN, ON_STAND, STAND, TAUGHT, run_skills, take

PICK = link("PickAt", pose="part")
CUBE = NAMES["Cube"]


def position(out):
    return out.results["pose"]["position"]


def body(out, label="Cube"):
    return out.last["cell"]["bodies"][NAMES[label]]


class SkillCase(unittest.TestCase):
    def assert_at(self, where, target, within=0.002):
        self.assertLess(math.dist(where, target), within, (where, target))

    def succeeds(self, *links, outcome="success", **options):
        out = run_skills(*links, **options)
        self.assertEqual(out.name, outcome, out.results)
        return out


class Motions(SkillCase):
    def test_to_a_taught_pose(self):
        out = self.succeeds(link("MoveTo", pose="give", speed=1.0))
        self.assert_at(position(out), TAUGHT["give"]["pose"]["position"])

    def test_straight_to_a_taught_pose(self):
        out = self.succeeds(link("MoveLinear", pose="give"))
        target = TAUGHT["give"]["pose"]["position"]
        self.assert_at(position(out), target)
        way = [(t - h) / math.dist(target, HOME) for t, h in zip(target, HOME, strict=True)]
        for state in out.events("robot_state"):
            off = [p - h for p, h in zip(state["pose"]["position"], HOME, strict=True)]
            along = sum(a * b for a, b in zip(off, way, strict=True))
            self.assert_at(off, [along * w for w in way], 0.001)

    def test_a_bit_into_each_direction(self):
        for direction, way in {"forward": [1, 0, 0], "back": [-1, 0, 0], "left": [0, 1, 0], "right": [0, -1, 0], "up": [0, 0, 1],
                               "down": [0, 0, -1]}.items():
            out = self.succeeds(link("MoveBy", direction=direction, distance=0.05, speed=1.0))
            self.assert_at(position(out), [h + 0.05 * w for h, w in zip(HOME, way, strict=True)])


class Parts(SkillCase):
    def test_the_gripper_opens_to_a_width(self):
        out = self.succeeds(link("OpenGripper", width=0.05))
        self.assertAlmostEqual(out.results["gripper"]["width"], 0.05, delta=0.001)
        self.assertAlmostEqual(out.results["OpenGripper_width"], 0.05, delta=0.001)

    def test_the_gripper_closes_around_a_part(self):
        out = self.succeeds(HELD, link("WaitTime"), acts=ON_STAND, further=[STAND])
        self.assertTrue(out.results["gripper"]["holding"])
        self.assertAlmostEqual(out.results["Held_width"], 0.04, delta=0.001)

    def test_a_part_is_picked_and_placed_at_taught_poses(self):
        out = self.succeeds(PICK)
        self.assertTrue(out.results["gripper"]["holding"])
        self.assertAlmostEqual(body(out)["position"][2], 0.17, delta=0.003)
        out = self.succeeds(PICK, link("PlaceAt", pose="place"))
        self.assert_at(body(out)["position"], [0.45, 0, 0.02], 0.005)
        self.assertLess(angle(body(out)["orientation"], [0, 0, 0, 1]), 3)
        self.assertFalse(out.results["gripper"]["holding"])
        self.assertAlmostEqual(position(out)[2], 0.171, delta=0.002)

    def test_a_part_that_was_found_is_picked(self):
        for label in NAMES:
            search = link("SearchObject", labels=[label])
            pick = {**link("PickFound"), "parameters": [{"name": "found", "from": "chi.SearchObject.res.found"}]}
            x, y, z = [0.45, 0.0, max(BODIES[NAMES[label]]["pose"]["position"][2], 0.02) + 0.001]
            put = {"pose": {"position": [x, y, z], "orientation": [1, 0, 0, 0]}, "q": HOME}
            out = self.succeeds(search, pick, link("PlaceAt", pose="put"), database={**KNOWN, "pose_put": put})
            found = out.results["SearchObject_found"]
            true = BODIES[NAMES[label]]["pose"]
            self.assert_at(found["o_t_x"]["position"], true["position"], 0.004)
            self.assertLess(angle_up_to_symmetry(found["o_t_x"]["orientation"], true["orientation"], SYMMETRY[label]), 4)
            self.assert_at(body(out, label)["position"][:2], [x, y], 0.005)

    def test_any_part_is_found_but_never_the_tool(self):
        out = self.succeeds(link("SearchObject"))
        self.assertIn(out.results["SearchObject_found"]["label"], NAMES)
        out = self.succeeds(link("SearchObject"), parts=(), outcome="none")
        self.assertNotIn("SearchObject_found", out.results)

    def test_a_grid_is_filled_place_by_place_and_begun_anew(self):
        x, y, _ = TAUGHT["place"]["pose"]["position"]
        grid = link("Palletise", pose="place", columns=2, rows=2, column_distance=0.06, row_distance=0.05, direction="right",
                    row_direction="back")
        first = ((0, 0), "success", 1)
        third, last = ((0, 1), "success", 3), ((1, 1), "full", 0)
        for stored, (column, row), outcome, kept in ((None, *first), (2, *third), (3, *last), (4, *first), ("?", *first)):
            known = KNOWN if stored is None else KNOWN | {"grid_place": stored}
            out = self.succeeds(PICK, grid, database=known, outcome=outcome, parts=("Cube",))
            self.assert_at(body(out)["position"], [x - 0.05 * row, y - 0.06 * column, 0.02], 0.005)
            self.assertEqual(out.called("db", "add")[-1]["args"], ["grid_place", kept])
            self.assertEqual(out.results["Palletise_count"], 2 * row + column + 1)

    def test_a_grid_can_be_stacked(self):
        grid = link("Palletise", pose="place", columns=1, rows=3, row_distance=0.05, row_direction="up")
        below = {"do": {"act": "place", "part": NAMES["Box"], "pose": {"position": [0.45, 0, 0.025], "orientation": [0, 0, 0, 1]}}}
        out = self.succeeds(PICK, grid, database={**KNOWN, "grid_place": 1}, acts=[below])
        self.assert_at(body(out)["position"], [0.45, 0, 0.07], 0.005)

    def test_a_new_grid_begins_at_its_first_place(self):
        out = self.succeeds(link("NewGrid", pose="place"), PICK, link("Palletise", pose="place"), database={**KNOWN, "grid_place": 5})
        self.assertEqual([call["args"] for call in out.called("db", "add")], [["grid_place", 0], ["grid_place", 1]])


class Camera(SkillCase):
    def test_the_arm_calibrates_the_camera_by_itself(self):
        for start in ([], [PICK], [link("MoveTo", pose="give", speed=1.0)]):
            out = self.succeeds(*start, link("CalibrateCamera", speed=1.0), database=DATABASE, displays=None)
            o_t_c = out.results["CalibrateCamera_o_t_c"]
            self.assert_at(o_t_c["position"], O_T_C["position"], 0.005)
            self.assertLess(angle(o_t_c["orientation"], O_T_C["orientation"]), 0.5)
            self.assertEqual(out.called("db", "add")[-1]["args"], ["o_t_c", o_t_c])
            self.assertGreaterEqual(out.results["CalibrateCamera_samples"], 8)
            self.assertTrue(0 < out.results["CalibrateCamera_residual_position"] < 0.005)
            self.assertTrue(0 < out.results["CalibrateCamera_residual_angle"] < math.radians(0.5))


class People(SkillCase):
    def test_a_push_is_waited_for(self):
        right = touch("Root/WaitForGesture/Push", 0.5, -25)
        out = self.succeeds(link("WaitForGesture"), acts=[right])
        self.assertEqual(out.results["WaitForGesture_direction"], "right")
        left = {**touch("Root/WaitForGesture/Push", 0.5, 25), "when": {"after": 1.5}}
        out = self.succeeds(link("WaitForGesture", direction="left"), acts=[right, left])
        self.assertEqual(out.results["WaitForGesture_direction"], "left")
        self.assertGreater(out.last["time"], 2.0)

    def test_a_question_goes_on_with_the_answer(self):
        for button, outcome in (("Good", "yes"), ("Bad", "no")):
            ask = link("AskPerson", question="How is it?", yes="Good", no="Bad")
            out = self.succeeds(ask, acts=[answer(button, {"display": {"text": "How is it?"}})], outcome=outcome)
            self.assertEqual(out.results["AskPerson_answer"], button)

    def test_a_text_is_shown_with_a_sound(self):
        out = self.succeeds(link("Say", text="Mind your fingers", sound="attention"))
        self.assertEqual((out.texts(), out.called("audio", "play")[0]["args"]), (["Mind your fingers"], ["attention"]))
        self.assertNotIn("audio.play", self.succeeds(link("Say")).calls)

    def test_a_part_is_handed_over_to_who_pulls_it(self):
        out = self.succeeds(PICK, link("HandOver", pose="give", speed=1.0), acts=[touch("Root/HandOver/Pull", 1.0, 25)])
        self.assert_at(position(out), TAUGHT["give"]["pose"]["position"], 0.02)
        self.assertFalse(out.results["gripper"]["holding"])
        self.assertLess(body(out)["position"][2], 0.1)  # nobody has held it

    def test_a_part_that_was_drawn_out_is_handed_over(self):
        out = self.succeeds(PICK, link("HandOver", pose="give", speed=1.0), acts=[take(active="Root/HandOver/Pull", after=0.5)])
        self.assertFalse(out.results["gripper"]["holding"])

    def test_a_pose_is_taught_by_hand(self):
        grab = [{"act": "grab", "hand": hand, "body": "gripper", "point": point, "keep": 60} for hand, point in HANDS.items()]
        acts = [{"when": {"active": "Root/TeachPose/Grip", "after": 0.2}, "do": [*grab, {"act": "answer", "button": "Done"}]},
                {"when": {"active": "Root/TeachPose/Guide/Lead", "after": 0.2}, "do": drag([0.1, 0.1, -0.1])},
                answer("Done", {"after": 2.0}),
                {"when": {"active": "Root/TeachPose/LetGo", "after": 0.2}, "do": [{"act": "release", "hand": hand} for hand in HANDS]},
                answer("Done", {"after": 0.5})]
        out = self.succeeds(link("TeachPose", pose="new"), link("MoveTo", pose="home"), link("MoveTo", "There", pose="new"), acts=acts)
        key, place = out.called("db", "add")[0]["args"]
        self.assertEqual((key, set(place)), ("pose_new", {"pose", "q"}))
        self.assertGreater(math.dist(place["pose"]["position"], HOME), 0.12)
        self.assert_at(position(out), place["pose"]["position"])


class Flow(SkillCase):
    def test_time_passes(self):
        self.assertAlmostEqual(self.succeeds(link("WaitTime", duration=2.5)).last["time"], 2.5, delta=0.02)

    def test_what_is_done_is_counted_and_shown(self):
        counts = [link("Count", f"Count{i}", what="cubes", target=2) for i in range(2)]
        out = self.succeeds(*counts, outcome="reached", database={"count_cubes": 0})
        self.assertEqual(out.texts(), ["1 of 2 cubes", "2 of 2 cubes"])
        self.assertEqual([call["args"] for call in out.called("db", "add")], [["count_cubes", 1], ["count_cubes", 0]])
        out = self.succeeds(link("Count"), database={"count_parts": 41}, displays=())
        self.assertEqual(out.results["Count_count"], 42)


if __name__ == "__main__":
    unittest.main()
