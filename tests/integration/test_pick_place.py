"""Pick, Place and TeachPose of the demonstrator in the demo's cell, also interrupted by collisions."""
import math
import unittest

from cell import BODIES, DATABASE, NAMES, TAUGHT
from scenario import LET_GO, answer, bump, lead, link, part, run, task, touch

TASK = "Root/Work/Task"
APPROACH, GRASP = f"{TASK}/Pick/Approach/Across", f"{TASK}/Pick/Grasp"
CARRY = f"{TASK}/Place/Carry/Approach/Across"


def work(label="Cube", **parameters):
    return link("Work", **part(label), speed=1.0, **parameters)


def pick_again(label="Cube"):
    return link("Pick", "Again", **part(label), speed=1.0)


def resumed(out):
    """The innermost state of the task that is active each time a person has answered that it goes on, below the task."""
    reports = [r for r in out.reports if {"Root/Work/Collision.continue", "Root/Work/Trouble.resume"} & {*r.get("fired", [])}]
    active = ([state for state, now in r["active"].items() if now and state.startswith(TASK)] for r in reports)
    return [max(states, key=len).removeprefix(f"{TASK}/") for states in active]


class Interruptions(unittest.TestCase):
    def test_every_step_is_resumed_where_that_is_safe(self):
        """The step begins anew: a motion goes up first, and before a part is carried on the gripper is checked."""
        points = {"Pick/Approach/Down": "Pick/Approach/Up", "Pick/Grasp": "Pick/Grasp", "Pick/Retreat": "Pick/Retreat",
                  "Place/Carry/Approach/Down": "Place/Carry/Look", "Place/SetDown/Release": "Place/SetDown/Release",
                  "Place/Retreat": "Place/Retreat"}
        acts = [act for state in points for act in (bump(f"{TASK}/{state}"), answer("Continue"))]
        out = run(task(work()), *acts)
        self.assertEqual(resumed(out), list(points.values()))
        self.assertEqual((out.name, out.fired.count(f"{TASK}/Pick/Release.success")), ("success", 1))

    def test_approach_restarts_from_where_the_arm_is(self):
        out = run(task(work()), bump(APPROACH), answer("Continue"))
        self.assertEqual(out.name, "success")
        self.assertEqual([p for p in out.fired if "/Pick/Dispatcher." in p],
                         [f"Root/Work/Task/Pick/Dispatcher.{to}" for to in ("to_Release", "to_Approach")])
        self.assertNotIn("Root/Work/Task/Pick/Approach.error", out.fired)

    def test_grasp_goes_on_and_keeps_where_it_was(self):
        out = run(task(work()), bump(GRASP), answer("Continue"))
        self.assertEqual(out.name, "success")
        self.assertEqual(out.fired.count("Root/Work/Task/Pick/Approach.success"), 1)
        self.assertEqual((out.calls.count("gripper.grasp"), out.calls.count("gripper.release")), (2, 2))

    def test_placing_goes_on_with_the_part_in_the_gripper(self):
        out = run(task(work()), bump(CARRY, force=-40.0), answer("Continue"))
        self.assertEqual((out.name, out.fired.count("Root/Work/Task/Pick.success")), ("success", 1))

    def test_letting_go_is_repeated(self):
        release = "Root/Work/Task/Place/SetDown/Release"
        out = run(task(work(), pick_again()), bump(release), answer("Continue"))
        self.assertEqual((out.fired.count("Root/Work.success"), out.name), (1, "no_part"))  # no part is left at its old place

    def test_an_intended_touch_continues_without_a_display_and_an_accident_does_not(self):
        haptic = "Root/Work/Collision/Haptic"
        out = run(task(work()), bump(APPROACH), bump(f"{haptic}/Touch"), touch(f"{haptic}/Touch", 1.0), displays=())
        self.assertEqual((out.name, [c["classification"] for c in out.events("contact")]),
                         ("success", ["accidental", "accidental", "intended"]))
        felt, left = (next(r["input"]["data"] for r in out.reports if port in r.get("fired", []))
                      for port in (f"{haptic}/Touch.success", f"{haptic}.success"))
        self.assertEqual(felt["classification"], "intended")
        self.assertLess(max(abs(force) for force in left["f_ext_hat"]), 12)

    def test_waiting_for_a_person_ends_after_answer_timeout(self):
        out = run(task(work(answer_timeout=3.0)), bump(APPROACH), displays=())
        self.assertEqual(out.name, "error")
        self.assertAlmostEqual(out.time("Root/Work.error") - out.time("Root/Work/Task.collision"), 3.1, delta=0.2)

    def test_skip_leaves_open_fingers_and_the_part_where_it_was(self):
        for state, after, way in ((APPROACH, 0.1, "Open"), (GRASP, 0.1, "Open"), (GRASP, 0.8, "SetDown")):
            out = run(task(work(), pick_again(), after="skip"), bump(state, after), answer("Skip"))
            self.assertEqual((out.name, out.fired.count("Root/Work.skip")), ("success", 1), (state, after))
            self.assertEqual(out.fired.count(f"Root/Work/GiveUp/Task/{way}.success"), 1, (state, after))

    def test_skip_brings_a_part_that_is_held_back(self):
        out = run(task(work(), pick_again(), after="skip"), bump(CARRY, force=-40.0), answer("Skip"))
        self.assertEqual((out.name, out.fired.count("Root/Work/GiveUp/Task/SetDown.success")), ("success", 1))
        self.assertAlmostEqual(out.results["Again_actual_width"], 0.04, delta=0.002)

    def test_a_collision_while_a_part_is_given_up_is_answered_too(self):
        back = "Root/Work/GiveUp/Task/Carry/Approach/Across"
        out = run(task(work(), pick_again(), after="skip"), bump(CARRY, force=-40.0), answer("Skip"), bump(back), answer("Continue"))
        self.assertEqual((out.name, out.fired.count("Root/Work/GiveUp/Task.collision")), ("success", 1))

    def test_abort_stands_still_and_keeps_what_is_held(self):
        for state, force, holding in ((APPROACH, 40.0, False), (GRASP, 40.0, False), (CARRY, -40.0, True)):
            out = run(task(work()), bump(state, force=force), answer("Abort"))
            self.assertEqual((out.name, out.results["gripper"]["holding"]), ("abort", holding), state)
            collision = out.calls.index("gripper.stop")
            self.assertNotIn("robot.move", out.calls[collision:], state)


class Teaching(unittest.TestCase):
    TEACH = "Root/Work/Task/Place/TeachPose"
    HELD = {"when": {"active": f"{TEACH}/Grip", "after": 0.2},
            "do": [{"act": "grab", "hand": "hand", "body": "gripper", "keep": 60}, {"act": "answer", "button": "Done"}]}

    def test_a_taught_place_is_stored_and_used(self):
        stored = link("GetPose", "Stored", key=f"o_t_place_{TAUGHT}")
        ways = [[-0.28, 0.15, 0.05], [0, 0, -0.196]]
        out = run(task(work(TAUGHT), stored), *lead(self.TEACH, *ways))
        self.assertEqual((out.name, out.calls.count("db.add")), ("success", 1))
        place = out.results["Work_o_t_x"]
        self.assertEqual(out.results["Stored_pose"]["position"], place["position"])
        led = [a + b for a, b in zip(BODIES[NAMES[TAUGHT]]["pose"]["position"][:2], ways[0][:2], strict=True)]
        self.assertLess(math.dist(led, place["position"][:2]), 0.02)
        found = run(task(work(TAUGHT), link("Pick", "Again", label=TAUGHT, o_t_x=place, speed=1.0)), *lead(self.TEACH, *ways))
        self.assertAlmostEqual(found.results["Again_actual_width"], 0.04, delta=0.002)

    def test_teaching_that_is_interrupted_begins_anew(self):
        """The arm may have been pushed from the pose that was taught."""
        *stored, let_go, gone = lead(self.TEACH, [-0.28, 0.15, 0.05], [0, 0, -0.196])
        hit = [bump(f"{self.TEACH}/LetGo"), answer("Continue")]
        still = [answer("Done", {"active": f"{self.TEACH}/{state}", "after": 0.2}) for state in ("Grip", "Lead")]
        out = run(task(work(TAUGHT)), *stored, *hit, *still, let_go, gone)
        self.assertEqual((out.name, resumed(out)), ("success", ["Place/TeachPose/Grip/Deadline/After_over"]))
        self.assertEqual(out.calls.count("db.add"), 2)

    def test_a_grasp_is_stored_in_the_parts_frame(self):
        below = {"position": [0.5, 0.0, 0.02], "orientation": [0, 0, 1, 0]}
        away = {"do": [{"act": "take", "part": "cube_blue"}, {"act": "place", "part": "cube_red", "pose": below}]}
        document = task(link("Pick", label="Thing", o_t_x=below, speed=1.0), link("GetPose", "Stored", key="x_t_g_Thing"))
        out = run(document, away, *lead("Root/Pick/TeachPose", [0, 0, -0.293]))
        self.assertEqual(out.name, "success")
        self.assertAlmostEqual(out.results["Pick_actual_width"], 0.04, delta=0.002)
        self.assertLess(math.dist(out.results["Stored_pose"]["position"], (0, 0, 0)), 0.01)

    def test_a_bump_into_a_compliant_arm_does_not_end_teaching(self):
        out = run(task(work(TAUGHT)), self.HELD, bump(f"{self.TEACH}/Lead"), answer("Cancel", {"after": 0.5}), answer("Abort"))
        self.assertEqual([c["reaction"] for c in out.events("collision")], ["none"])
        self.assertEqual((out.name, out.fired.count("Root/Work/Task.collision")), ("abort", 0))
        self.assertEqual(out.fired.count("Root/Work/Task/Place/TeachPose.error"), 1)

    def test_the_arm_becomes_compliant_only_when_somebody_holds_it(self):
        out = run(task(work(TAUGHT, answer_timeout=2.0)), displays=("phone",))
        self.assertIn(f"{self.TEACH}/Grip.error", out.fired)
        self.assertNotIn("robot.change_behavior", out.calls[:out.calls.index("display.clear")])
        self.assertGreater(out.results["pose"]["position"][2], 0.195)

    def test_cancel_and_timeout_are_errors_that_store_nothing_and_hold_the_arm(self):
        teach, held = link("TeachPose", key="new", answer_timeout=2.0), answer("Done", {"active": "Root/TeachPose/Grip", "after": 0.2})
        cancel = answer("Cancel", {"active": "Root/TeachPose/Lead", "after": 0.5})
        for acts, way in (([], "Grip"), ([held], "Lead"), ([held, cancel], "Lead")):
            out = run(task(teach, link("Rise", travel=0.4), after="error"), *acts)
            self.assertEqual((out.name, f"Root/TeachPose/{way}.error" in out.fired), ("success", True))
            self.assertNotIn("db.add", out.calls)
            self.assertGreater(out.results["pose"]["position"][2], 0.395)

    def test_without_a_display_it_is_an_error_at_once(self):
        out = run(task(link("TeachPose", key="new")), displays=())
        self.assertEqual(out.name, "error")
        self.assertLess(out.last["time"], 0.1)


class Failures(unittest.TestCase):
    """After a failure in Work a person decides."""
    TAKEN = {"do": {"act": "take", "part": NAMES["Cube"]}}

    def test_continue_without_a_part_in_the_fingers_searches_again(self):
        out = run(task(work()), self.TAKEN, answer("Continue"))
        self.assertEqual((out.name, out.fired.count("Root/Work/Task.lost")), ("lost", 1))
        self.assertEqual(out.asked(), ["The fingers do not hold the part Cube. Continue looks for it again. " + LET_GO])

    def test_continue_repeats_the_step_that_failed(self):
        far = {"position": [2.0, 0.0, 0.02], "orientation": [0, 0, 0, 1]}
        out = run(task(link("Work", label="Cube", o_t_x=far)), answer("Continue"), answer("Abort"))
        self.assertEqual((out.name, resumed(out)), ("abort", ["Pick/Approach/Across"]))

    def test_continue_asks_again_for_a_place_that_was_not_taught(self):
        cancel = answer("Cancel", Teaching.HELD["when"])
        out = run(task(work(TAUGHT)), cancel, answer("Continue"), cancel, answer("Abort"))
        ports = ("Pick.success", "Place/GetPose.missing", "Place/TeachPose.error")
        self.assertEqual((out.name, [out.fired.count(f"{TASK}/{port}") for port in ports]), ("abort", [1, 1, 2]))

    def test_continue_lets_go_again_where_the_part_is(self):
        document = task(work())
        set_down = next(state for state in document["library"] if state["state"] == "SetDown")
        release = {"state": "Release", "ports": [{"name": "success", "when": "False"}, {"name": "error", "after": "0.1"}]}
        failing = {**set_down, "children": [each if each["state"] != "Release" else release for each in set_down["children"]]}
        document["library"] = [each if each is not set_down else failing for each in document["library"]]
        out = run(document, answer("Continue"), answer("Abort"))
        ports = ("Carry.success", "SetDown/CheckPart.success", "SetDown/Release.error")
        fired = [out.fired.count(f"{TASK}/Place/{port}") for port in ports]
        self.assertEqual((out.name, fired), ("abort", [1, 1, 2]))

    def test_skip_gives_it_up_and_abort_ends(self):
        for button, outcome in (("Skip", "skip"), ("Abort", "abort")):
            self.assertEqual(run(task(work()), self.TAKEN, answer(button)).name, outcome)

    def test_waiting_for_an_answer_times_out(self):
        out = run(task(link("Trouble", text="?", answer_timeout=5.0)), displays=())
        self.assertEqual(out.name, "error")
        self.assertGreater(out.calls.count("display.ask"), 1, "a display may come")

    def test_the_search_can_be_repeated_when_the_cause_is_repaired(self):
        far = {"position": [2.0, 0.0, 0.02], "orientation": [0, 0, 0, 1]}
        out = run(task(link("Work", label="Cube", o_t_x=far)), answer("Look again"))
        self.assertEqual((out.name, out.asked()),
                         ("lost", ["Part Cube could not be picked or placed (robot.move: unreachable). " + LET_GO]))


class MissingParts(unittest.TestCase):
    def test_without_a_part_the_arm_retreats_first(self):
        nowhere = {"position": [0.45, 0.0, 0.02], "orientation": [0, 0, 0, 1]}
        out = run(task(link("Pick", label="Cube", o_t_x=nowhere, speed=1.0)))
        self.assertEqual((out.name, out.results["gripper"]["holding"]), ("no_part", False))
        self.assertLess(out.time("Root/Pick/Grasp.error"), out.time("Root/Pick/Retreat.success"))
        self.assertGreater(out.results["pose"]["position"][2], 0.195)

    def test_nothing_is_placed_with_empty_fingers(self):
        out = run(task(link("Place", label="Cube", x_t_g=DATABASE["x_t_g_Cube"], speed=1.0)))
        self.assertEqual((out.name, out.calls.count("gripper.release")), ("no_part", 0))
        self.assertGreater(out.results["pose"]["position"][2], 0.195)


if __name__ == "__main__":
    unittest.main()
