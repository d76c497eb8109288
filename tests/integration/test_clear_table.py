"""The demonstrator clears a whole table: parts are skipped, lost, moved, shown by a person and put down anywhere."""
import math
import unittest

from cell import BODIES, DATABASE, DOCUMENT, NAMES, O_T_C, TAUGHT
from scenario import LET_GO, answer, bump, drag, gesture, lead, link, part, run, task, touch

ROOT = "Demonstrator/Table"
PICK, PLACE = f"{ROOT}/Work/Task/Pick", f"{ROOT}/Work/Task/Place"
CARRY, TEACH = f"{PLACE}/Carry/Approach/Across", f"{PLACE}/TeachPose"
KNOWN = {**DATABASE, "o_t_c": O_T_C}


def clear_table(*acts, parts, database=KNOWN, limit=150, **arguments):
    """The demonstrator at a table with these parts."""
    return run(DOCUMENT, *acts, parts=parts, database=database, limit=limit, arguments={"begin": "Table", "speed": 1.0, **arguments})


def placed(out):
    return [each["label"] for each in out.results["placed"]]


def put(label, *position):
    return {"act": "place", "part": NAMES[label], "pose": {"position": list(position), "orientation": [0, 0, 0, 1]}}


def question(text, after=0.2):
    return {"display": {"text": text}, "after": after}


class SkippedParts(unittest.TestCase):
    def test_a_part_that_is_skipped_is_not_looked_for_again(self):
        out = clear_table(bump(CARRY, force=-40.0), answer("Skip"), parts=("Cube", "Box"))
        self.assertEqual((out.name, len(placed(out)), len(out.results["skipped"])), ("success", 1, 1))
        self.assertEqual({*placed(out), *out.results["skipped"]}, {"Cube", "Box"})
        skipped = NAMES[out.results["skipped"][0]]
        self.assertLess(math.dist(out.last["cell"]["bodies"][skipped]["position"], BODIES[skipped]["pose"]["position"]), 0.02)

    def test_a_part_whose_place_is_occupied_is_brought_back(self):
        x, y, _ = DATABASE["o_t_place_Cube"]["position"]
        occupied = {"do": put("Box", x, y, 0.025)}
        out = clear_table(occupied, answer("Skip", question("has met something")), parts=("Cube", "Box"))
        self.assertEqual((out.name, placed(out), out.results["skipped"]), ("success", [], ["Cube"]))
        self.assertIn(f"{ROOT}/Work/GiveUp.success", out.fired)
        self.assertIn("The table is clear: 0 parts were placed, Cube skipped.", out.texts())

    def test_showing_a_skipped_part_takes_it_back_into_the_task(self):
        shows = [bump(f"{PICK}/Approach/Across"), answer("Skip"), gesture(f"{ROOT}/SearchObject", 40),
                 {"when": question("Which part", 0.8), "do": [put("Cube", 0.5, 0.0, 0.02), {"act": "answer", "button": "Cube"}]},
                 *lead(f"{ROOT}/ShowPart/TeachPose", [0, 0, -0.293])]
        out = clear_table(*shows, parts=("Cube",))
        self.assertEqual((out.name, placed(out), out.results["skipped"]), ("success", ["Cube"], []))


class ShowPart(unittest.TestCase):
    def test_a_person_shows_the_part_that_recognition_does_not_find(self):
        shows = [gesture(f"{ROOT}/SearchObject", 40),
                 {"when": question("Which part", 0.8), "do": [put("Cube", 0.5, 0.0, 0.02), {"act": "answer", "button": "Cube"}]},
                 *lead(f"{ROOT}/ShowPart/TeachPose", [0, 0, -0.293])]
        out = clear_table({"do": {"act": "take", "part": NAMES["Cube"]}}, *shows, parts=("Cube",))
        self.assertEqual((out.name, placed(out)), ("success", ["Cube"]))
        self.assertIn(f"{ROOT}/SearchObject.by_hand", out.fired)
        at, place = out.last["cell"]["bodies"][NAMES["Cube"]]["position"], DATABASE["o_t_place_Cube"]["position"]
        self.assertLess(math.dist(at, place), 0.02)

    def test_showing_can_be_cancelled(self):
        out = clear_table(gesture(f"{ROOT}/SearchObject", 40), answer("None", question("Which part")), parts=())
        self.assertEqual((out.name, out.fired.count(f"{ROOT}/ShowPart.none")), ("success", 1))

    def test_waiting_for_a_shown_part_times_out(self):
        out = clear_table(gesture(f"{ROOT}/SearchObject", 40), parts=(), answer_timeout=3.0)
        self.assertEqual((out.name, f"{ROOT}/ShowPart.error" in out.fired), ("error", True))


class LostParts(unittest.TestCase):
    def test_a_part_that_falls_is_reported_at_once_and_found_again(self):
        falls = {"when": {"active": CARRY, "after": 0.3}, "do": {"act": "take", "part": NAMES["Cube"]}}
        back = {"when": question("do not hold the part Cube"), "do": [put("Cube", 0.5, 0.0, 0.02), {"act": "answer", "button": "Continue"}]}
        out = clear_table(falls, back, parts=("Cube",))
        self.assertEqual((out.name, placed(out)), ("success", ["Cube"]))
        self.assertEqual(out.fired.count(f"{PLACE}/Carry/Approach.lost"), 1)
        self.assertEqual(out.fired.count(f"{ROOT}/SearchObject.success"), 2)
        self.assertEqual(out.calls.count("robot.stop"), 1)

    def test_a_part_that_was_moved_is_searched_again(self):
        moved = {"when": {"active": f"{PICK}/Approach"}, "do": put("Cube", 0.5, 0.1, 0.02)}
        out = clear_table(moved, answer("Continue"), parts=("Cube",))
        self.assertEqual((out.name, placed(out), len(out.asked())), ("success", ["Cube"], 1))
        self.assertEqual(out.fired.count(f"{ROOT}/SearchObject.success"), 2)

    def test_a_part_that_stays_away_is_reported_as_missing(self):
        away = {"when": {"active": f"{PICK}/Approach"}, "do": {"act": "take", "part": NAMES["Cube"]}}
        out = clear_table(away, answer("Continue"), parts=("Cube",))
        self.assertEqual((out.name, placed(out), out.results["skipped"], out.results["missing"]), ("success", [], [], ["Cube"]))
        self.assertIn("The table is clear: 0 parts were placed, Cube lost.", out.texts())

    def test_a_part_that_falls_while_the_arm_stands_stops_the_transport(self):
        falls = {"when": {"active": f"{ROOT}/Work/Collision", "after": 0.3}, "do": {"act": "take", "part": NAMES["Cube"]}}
        out = clear_table(bump(CARRY, force=-40.0), falls, answer("Continue"), answer("Abort", question("do not hold")), parts=("Cube",))
        self.assertEqual((out.name, out.fired.count(f"{PLACE}/Carry/Look.empty")), ("abort", 1))

    def test_a_part_on_its_side_must_be_set_upright_by_a_person(self):
        on_its_side = {"position": [0.5, 0.0, 0.02], "orientation": [0, math.sqrt(0.5), 0, math.sqrt(0.5)]}
        lying = {"act": "place", "part": NAMES["Block"], "pose": on_its_side}
        up = {"when": question("The part Block lies on its side"),
              "do": [put("Block", 0.5, 0.0, 0.04), {"act": "answer", "button": "Continue"}]}
        out = clear_table({"do": lying}, up, parts=("Block",))
        self.assertEqual((out.name, placed(out), len(out.asked())), ("success", ["Block"], 1))


class PlacedParts(unittest.TestCase):
    def test_a_place_outside_the_area_is_a_place_too(self):
        ways = [[0.02, -0.25, 0.05], [0, 0, -0.196]]
        out = clear_table(*lead(TEACH, *ways), parts=(TAUGHT,))
        self.assertEqual((out.name, placed(out)), ("success", [TAUGHT]))
        place = out.results["placed"][0]["o_t_x"]["position"]
        self.assertLess(place[1], DATABASE["place_area"]["min"][1], "this place is not in the area")
        self.assertLess(math.dist(out.last["cell"]["bodies"][NAMES[TAUGHT]]["position"], place), 0.02)

    def test_a_place_in_the_air_is_asked_for_again(self):
        lower = {"when": question("mm too high", 0.3), "do": drag([0, 0, -0.096])}
        grip, first, ready, let_go, gone = lead(TEACH, [-0.28, 0.15, -0.05])
        out = clear_table(grip, first, ready, lower, answer("Done", {"after": 1.5}), let_go, gone, parts=(TAUGHT,))
        self.assertEqual((out.name, placed(out)), ("success", [TAUGHT]))
        self.assertEqual([q.split(" mm")[1] for q in out.asked() if "mm too" in q],
                         [f" too high. Where is the part {TAUGHT} to be placed? Lead the gripper there, until the part stands."])
        self.assertEqual(out.calls.count("db.add") - out.fired.count(f"{ROOT}/SearchObject.success"), 1)

    def test_a_part_on_its_place_is_placed_though_the_rest_is_skipped(self):
        out = clear_table(bump(f"{PLACE}/Retreat", 0.2), answer("Skip"), parts=("Cube",))
        self.assertEqual((out.name, placed(out), out.results["skipped"]), ("success", ["Cube"], []))

    def test_a_part_that_is_moved_back_counts_once(self):
        back = {"when": {"active": f"{ROOT}/Aside", "count": 2}, "do": put("Cube", 0.5, 0.0, 0.02)}
        out = clear_table(back, parts=("Cube",))
        self.assertEqual((out.name, placed(out), out.fired.count(f"{ROOT}/Work.success")), ("success", ["Cube"], 2))

    def test_an_empty_table_is_clear(self):
        out = clear_table(parts=())
        self.assertEqual((out.name, out.results["placed"]), ("success", []))
        self.assertIn("The table is clear: 0 parts were placed.", out.texts())


class Interruptions(unittest.TestCase):
    def test_two_collisions_one_after_the_other(self):
        out = clear_table(bump(CARRY, force=-40.0), answer("Continue"), bump(CARRY, force=-40.0), answer("Continue"), parts=("Cube",))
        self.assertEqual((out.name, placed(out), out.fired.count(f"{ROOT}/Work/Task.collision")), ("success", ["Cube"], 2))

    def test_a_bump_on_the_way_home_goes_on_with_a_touch(self):
        home = f"{ROOT}/Aside/Collision"
        out = clear_table(bump(f"{ROOT}/Aside/Move", 0.3, count=2), touch(f"{home}/Haptic/Touch"), parts=("Cube",))
        self.assertEqual((out.name, placed(out)), ("success", ["Cube"]))
        self.assertEqual(out.fired.count(f"{home}/Haptic.success"), 1)
        self.assertNotIn(f"{ROOT}/Aside.error", out.fired)

    def test_a_touch_that_becomes_a_hard_push_does_not_count_but_the_next_may(self):
        haptic = f"{ROOT}/Work/Collision/Haptic"
        out = clear_table(bump(f"{PICK}/Approach/Across"), touch(f"{haptic}/Touch", force=60),
                          touch(f"{haptic}/Touch", count=2), parts=("Cube",))
        self.assertEqual([c["classification"] for c in out.events("contact")], ["accidental", "intended", "intended"])
        self.assertEqual((out.name, placed(out)), ("success", ["Cube"]))
        self.assertEqual((out.fired.count(f"{haptic}/LetGo.pressed"), out.fired.count(f"{haptic}.success")), (1, 1))

    def test_a_part_that_an_aborted_task_holds_is_handed_to_a_person(self):
        document = task(link("Pick", **part("Cube"), speed=1.0), link("Demonstrator", begin="Table", speed=1.0), library=[DOCUMENT["root"]])
        taken = {"when": question("part in the gripper"),
                 "do": [{"act": "take", "part": NAMES["Cube"]}, {"act": "answer", "button": "Done"}]}
        out = run(document, taken, parts=("Cube",), database=KNOWN)
        self.assertEqual((out.name, out.results["Demonstrator_placed"]), ("success", []))
        taken_over = out.fired.index("Root/Demonstrator/Table/TakeOut/Open.success")
        self.assertLess(taken_over, out.fired.index("Root/Demonstrator/Table/Aside.success"), "the arm stands until then")

    def test_a_held_part_is_handed_over_before_it_is_searched_again(self):
        """Otherwise the arm would carry it home and drop it where the gripper opens next."""
        taken = {"when": question("part in the gripper"),
                 "do": [{"act": "take", "part": NAMES[TAUGHT]}, {"act": "answer", "button": "Done"}]}
        out = clear_table(answer("Cancel", question("Take hold of the arm")), answer("Look again"), taken, parts=(TAUGHT,))
        self.assertEqual((out.name, placed(out), out.results["missing"]), ("success", [], [TAUGHT]))
        happened = [f"{ROOT}/Work.lost", f"{ROOT}/TakeOut/Open.success", f"{ROOT}/Aside.success"]
        self.assertEqual([port for port in out.fired if port in happened], [happened[2], *happened])

    def test_a_gesture_that_stops_the_search_is_reported(self):
        out = clear_table(gesture(f"{ROOT}/SearchObject", -40), answer("Abort"), parts=())
        self.assertEqual((out.name, out.asked()), ("abort", ["A hand has stopped the search. " + LET_GO]))

    def test_a_failed_call_is_reported(self):
        out = run(DOCUMENT, answer("Abort"), parts=("Cube",), database=KNOWN, without=["parts.json"], arguments={"begin": "Table"})
        self.assertEqual((out.name, out.asked()), ("abort", ["The search cannot go on (obj_rec.start: unavailable). " + LET_GO]))

    def test_missing_database_keys_are_reported_by_name(self):
        lacking = lambda key: {name: value for name, value in KNOWN.items() if name != key}
        asks = lambda *acts, key: clear_table(*acts, answer("Abort"), parts=("Cube",), database=lacking(key)).asked()[-1]
        self.assertEqual(asks(key="place_area"), "The search cannot go on: the database has no place_area. " + LET_GO)
        shows = gesture(f"{ROOT}/SearchObject", 40), answer("Cube", question("Which part", 0.8))
        self.assertEqual(asks(*shows, key="x_t_g_Cube"), "The search cannot go on: nobody has taught how the Cube is grasped. " + LET_GO)

    def test_displays_stop_inviting_to_press_the_arm_when_that_is_a_collision(self):
        texts = clear_table(parts=("Cube",)).texts()
        self.assertEqual([text.split(".")[0] for text in texts],
                         ["I look for parts", "I take the Cube to its place", "I look for parts",
                          "The table is clear: 1 parts were placed"])


class KnownCamera(unittest.TestCase):
    def test_a_known_camera_is_reported_and_not_calibrated(self):
        out = run(DOCUMENT, parts=(), database=KNOWN)
        self.assertEqual((out.name, out.results["o_t_c"]), ("success", O_T_C))
        self.assertNotIn("residual_position", out.results)

    def test_a_table_without_a_known_camera_leads_to_its_calibration(self):
        out = clear_table(answer("Abort"), parts=(), database=DATABASE, limit=30, answer_timeout=3.0)
        self.assertIn(f"{ROOT}.uncalibrated", out.fired)
        self.assertIn("Lead the arm to 10 places", " ".join(out.texts()))

    def test_nobody_leads_the_arm_with_a_part_in_the_gripper(self):
        document = task(link("Pick", **part("Cube"), speed=1.0), link("Demonstrator", answer_timeout=2.0), library=[DOCUMENT["root"]])
        out = run(document, parts=("Cube",))
        self.assertEqual((out.name, out.asked()[0]),
                         ("error", "There is a part in the gripper. Hold it, then press Done: the fingers open."))
        self.assertNotIn("robot.change_behavior", out.calls)

    def test_recalibration_on_demand(self):
        tired = answer("Abort", question("places are there, but no more come"))
        out = run(DOCUMENT, tired, parts=(), database=KNOWN, arguments={"recalibrate": True, "answer_timeout": 20.0}, limit=100)
        self.assertEqual((out.name, "o_t_c" in out.results), ("abort", False))
        self.assertIn("Lead the arm to 10 places", " ".join(out.texts()))


if __name__ == "__main__":
    unittest.main()
