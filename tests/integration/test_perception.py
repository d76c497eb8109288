"""Perception in the demonstrator: calibration by leading the arm, gestures, search by recognition or by a person."""
import functools
import json
import math
import tempfile
import unittest
from pathlib import Path

import scenario
import models
from cell import BODIES, DEMO, DOCUMENT, NAMES, O_T_C, OPERATOR, SCENE
from client import Server, check
from geometry import angle, rotate
from scenario import link

ELBOW = {"body": "link_4"}
HANDS = [{"act": "grab", "hand": "hand", "body": "gripper", "point": [0, 0, 0.05], "damping": 60}]


def run(state, acts=(), cell=None, without=(), **parameters):
    """Runs the library state as the root of a task until it ends. `acts` None: no person and no display. `cell`: replaced files of the
    cell's folder; `without`: missing files. The database knows the pose of the camera."""
    document = models.document(state, link(state, "Root", **parameters), library=DOCUMENT["library"])
    outcome = scenario.run(document, *(acts or ()), displays=None if acts is None else ("phone",), limit=200, database={"o_t_c": O_T_C},
                           files=cell, without=without)
    assert outcome.last["status"] == "ended", outcome.last
    return outcome


def push(force, at=0.5, duration=0.6, **where):
    """An intended push at the tool, or at `where`: the force rises for 0.2 s."""
    where = where or {"body": "gripper", "point": [0, 0, 0.15]}
    return {"when": {"time": at}, "do": {"act": "push", "force": force, "duration": duration, "rise": 0.2, **where}}


def take(*names):
    return {"do": [{"act": "take", "part": name} for name in names]}


@functools.cache
def calibration(attempt=1):
    """A calibration with the demonstrator's operator script and an unknown camera."""
    return run("CameraCalibration", OPERATOR["acts"], cell={"database.json": {}})


class Calibration(unittest.TestCase):
    def test_a_hand_that_leads_the_arm_shows_where_the_camera_is(self):
        run = calibration()
        self.assertEqual(run.name, "success")
        moves = run.called("robot", "move")
        self.assertEqual([m["args"][0].keys() for m in moves], [{"joints"}])  # home, when all is done
        found = run.results["o_t_c"]
        self.assertLess(math.dist(found["position"], O_T_C["position"]), 0.005)
        self.assertLess(angle(found["orientation"], O_T_C["orientation"]), 1)
        stored = [c["args"] for c in run.called("db", "add") if c["args"][0] == "o_t_c"]
        self.assertEqual(stored, [["o_t_c", found]])

    def test_it_takes_ten_places_far_apart_and_reports_the_residual(self):
        results = calibration().results
        self.assertGreaterEqual(results["samples"], 10)
        self.assertGreaterEqual(results["spread"], 0.3)
        self.assertTrue(0 < results["residual_position"] < 0.01, results)
        self.assertTrue(0 < results["residual_angle"] < 0.0175, results)

    def test_it_beeps_for_each_sample_and_reports_where_nothing_is_seen(self):
        run = calibration()
        self.assertEqual([c["args"][0] for c in run.called("audio", "play")], ["beep"] * run.results["samples"] + ["question"])
        texts = run.texts()
        self.assertEqual(sum("10 of 10 places" in t for t in texts), 1)
        self.assertEqual(sum("does not see" in t for t in texts), 1)

    def test_the_camera_works_only_while_the_arm_rests(self):
        run = calibration()
        looks = [p for p in run.fired if "/Look." in p or "/DetectObject." in p]
        self.assertEqual(len(run.called("obj_rec", "start")), len(looks))
        self.assertEqual(len(run.called("obj_rec", "stop")), len(looks))

    def test_the_same_seed_gives_the_same_run(self):
        self.assertEqual(calibration(1).reports, calibration(2).reports)

    def test_an_arm_that_never_rests_gives_no_sample(self):
        there_and_back = [[0.5, 0.1 * (-1) ** i, 0.35] for i in range(40)]
        drag = {"act": "drag", "hand": "hand", "path": there_and_back, "speed": 0.3}
        outcome = run("CameraCalibration", [{"do": [*HANDS, drag]}], answer_timeout=3, hands=1)
        self.assertEqual((outcome.name, outcome.called("obj_rec", "start")), ("error", []))
        self.assertEqual(outcome.called("robot", "change_behavior")[-1]["args"], ["position"])

    def test_a_picture_during_which_the_arm_moves_gives_no_sample(self):
        jog = {"act": "push", "body": "gripper", "force": [0, 10, 0], "duration": 0.1}
        jogs = {"always": True, "when": {"active": "Root/Collect/Look"}, "do": jog}
        outcome = run("CameraCalibration", [jogs], answer_timeout=3, hands=1)
        self.assertEqual(outcome.name, "error")
        self.assertIn("Root/Collect/Look.moved", outcome.fired)
        self.assertNotIn("Root/Collect/Look.seen", outcome.fired)

    def test_samples_that_scatter_are_refused(self):
        lead = {"when": {"display": {"text": "1 of 2"}}, "do": [*HANDS, {"act": "drag", "hand": "hand", "by": [0, 0.1, 0]}]}
        outcome = run("CameraCalibration", [lead], samples=2, spread=0.05, max_position=1e-5)
        self.assertEqual(outcome.name, "error")
        self.assertIn("Root/Average.error", outcome.fired)
        self.assertEqual((outcome.called("db", "add"), outcome.called("robot", "move")), ([], []))

    def test_places_too_near_to_each_other_are_not_enough(self):
        outcome = run("CameraCalibration", samples=1, spread=0.05, answer_timeout=2, hands=1)
        self.assertEqual(outcome.name, "error")
        self.assertEqual([p for p in outcome.fired if p in ("Root/Collect/Look.seen", "Root/Collect.error")],
                         ["Root/Collect/Look.seen", "Root/Collect.error"])

    def test_places_that_stay_too_near_are_reported_for_a_person_to_decide(self):
        drag = lambda text: {"when": {"display": {"text": text}}, "do": {"act": "drag", "hand": "hand", "by": [0, 0.05, 0]}}
        decide = lambda button: {"when": {"display": {"text": "3 of 1 places are there, only 0."}, "after": 0.2},
                                 "do": {"act": "answer", "button": button}}
        outcome = run("CameraCalibration", [{"do": HANDS}, drag("1 of 1 places, but they are only 0.0 m apart, not 0.3 m."),
                                            drag("2 of 1 places, but they are only 0.0"), decide("Continue"), decide("Abort")],
                      samples=1, answer_timeout=4)
        self.assertEqual((outcome.name, outcome.fired.count("Root/Collect/Decide.error")), ("abort", 1))
        self.assertEqual(outcome.texts()[-1], "3 of 1 places are there. Lead the arm to another one and hold it still until it beeps.")

    def test_it_ends_at_error_without_display_or_recognition_or_pictures(self):
        self.assertEqual(run("CameraCalibration", None).name, "error")
        self.assertIn("Root/Collect/Look.error", run("CameraCalibration", without=["parts.json"], hands=1).fired)
        late = run("CameraCalibration", timeout=0.05, hands=1)
        self.assertEqual((late.name, "Root/Collect/Look.error" in late.fired), ("error", True))

    def test_samples_are_kept_when_a_person_goes_on_after_an_error(self):
        resume = {"when": {"display": {"text": "1 of 2 places are there"}, "after": 0.2}, "do": {"act": "answer", "button": "Continue"}}
        lead = {"when": {"active": "Root/Collect", "after": 0.3, "count": 1},
                "do": [*HANDS, {"act": "drag", "hand": "hand", "by": [0, 0.1, 0]}]}
        done = {"when": {"display": {"text": "Let go of the arm, it moves"}, "after": 0.5},
                "do": [{"act": "release", "hand": "hand"}, {"act": "answer", "button": "Done"}]}
        outcome = run("CameraCalibration", [resume, lead, done], samples=2, spread=0.05, answer_timeout=4)
        self.assertEqual((outcome.name, outcome.results["samples"]), ("success", 2))
        self.assertEqual((outcome.fired.count("Root/Collect.error"), outcome.fired.count("Root/Collect/Look.seen")), (1, 2))

    def test_the_arm_does_not_move_before_somebody_has_let_go(self):
        outcome = run("CameraCalibration", samples=1, spread=0, hands=1)
        self.assertEqual((outcome.name, outcome.called("robot", "move")), ("error", []))
        self.assertEqual(len(outcome.called("display", "ask")), 1)

    def test_has_calibration_asks_the_database(self):
        known = run("HasCalibration")
        self.assertEqual((known.name, known.results["o_t_c"]), ("yes", O_T_C))
        self.assertEqual(run("HasCalibration", cell={"database.json": {}}).name, "no")


LISTING_5_1 = """\
f_ext_hat = svc.robot.robot_state.f_ext_hat
axis = ['x', 'y', 'z']
f_max = 0
axis_max = 'none'
for i in range(len(f_ext_hat)):
    if axis[i] in par.axes:
        f = f_ext_hat[i]
        if abs(f) > par.f_min and abs(f) > f_max:
            f_max = abs(f)
            if f > 0:
                axis_max = axis[i] + '+'
            else:
                axis_max = axis[i] + '-'
res.axis = axis_max
"""


class Gesture(unittest.TestCase):
    def test_its_function_is_that_of_the_thesis(self):
        gesture = next(state for state in DOCUMENT["library"] if state["state"] == "HapticGesture")
        get_axis = next(child for child in gesture["children"] if child["state"] == "GetAxis")
        self.assertIn(LISTING_5_1, [action["do"] for action in get_axis["actions"]])

    def test_gives_the_axis_along_which_somebody_pushes(self):
        for axis, force in (("x+", [40, 0, 0]), ("x-", [-40, 0, 0]), ("y+", [0, 40, 0]), ("y-", [0, -40, 0]),
                            ("z+", [0, 0, 40]), ("z-", [0, 0, -40])):
            outcome = run("HapticGesture", [push(force)])
            self.assertEqual((outcome.results["axis"], outcome.name[0]), (axis, axis[0]), force)
            self.assertEqual(outcome.name[1:], {"+": "_plus", "-": "_minus"}[axis[1]])

    def test_a_push_at_the_elbow_is_felt_as_the_equivalent_force_at_the_tool(self):
        """The result is an axis of f_ext_hat at the tool centre point. Only joints 1 to 3 feel the elbow, so forwards and sideways
        more force is needed, and up cannot be distinguished from back: both turn joint 2."""
        for force, axis in (([40, 0, 0], "x+"), ([-40, 0, 0], "x-"), ([0, 70, 0], "y+"), ([0, -70, 0], "y-"),
                            ([0, 0, 150], "x-"), ([0, 0, -150], "x+")):
            self.assertEqual(run("HapticGesture", [push(force, **ELBOW)]).results["axis"], axis, force)
        for force in ([0, 40, 0], [0, 0, 70]):
            self.assertEqual(run("HapticGesture", [push(force, **ELBOW)], timeout=2).name, "timeout", force)

    def test_pushing_the_elbow_forwards_is_taken_for_a_vertical_gesture(self):
        """The equivalent force is not along an axis and has a z component. People must push the tool."""
        for force, port in (([40, 0, 0], "abort"), ([-40, 0, 0], "by_hand")):
            outcome = run("SearchObject", [take("can_yellow"), push(force, **ELBOW)], labels=["Tape"], pictures=15)
            self.assertEqual(outcome.name, port, force)

    def test_ignores_light_pushes_and_axes_not_asked_for(self):
        pushes = [push([0, 0, -8], at=0.3), push([0, 0, -25], at=1), push([0, 60, 0], at=2), push([0, 0, 45], at=3)]
        outcome = run("HapticGesture", pushes, f_min=32.0, axes=["x", "z"])
        self.assertEqual(outcome.results["axis"], "z+")
        self.assertEqual(outcome.fired.count("Root/WaitContact.contact"), 3)  # 8 N are no contact
        self.assertEqual(outcome.fired.count("Root/GetAxis.none"), 2)

    def test_times_out(self):
        outcome = run("HapticGesture", timeout=1.5)
        self.assertEqual(outcome.name, "timeout")
        self.assertAlmostEqual(outcome.last["time"], 1.5, delta=0.2)

    def test_ends_at_error_without_a_robot(self):
        self.assertEqual(run("HapticGesture", None, without=["scene.json"]).name, "error")


class Search(unittest.TestCase):
    def test_finds_every_part_where_the_scene_has_it(self):
        for label in NAMES:
            outcome = run("SearchObject", labels=[label])
            results, there = outcome.results, BODIES[NAMES[label]]["pose"]
            self.assertEqual((outcome.name, results["label"]), ("success", label))
            self.assertLess(math.dist(results["o_t_x"]["position"], there["position"]), 0.005, label)
            # The grasp is from above, across the side x of the part (cubes: any side; Tape: any direction).
            tool = results["pose"]
            self.assertLess(math.dist(tool["position"][:2], there["position"][:2]), 0.005, label)
            self.assertLess(rotate(tool["orientation"], [0, 0, 1])[2], -0.9999)
            across, x = rotate(tool["orientation"], [0, 1, 0]), rotate(there["orientation"], [1, 0, 0])
            self.assertLess(angle(tool["orientation"], [1, 0, 0, 0]), 91, label)
            if label in ("Block", "Bar"):
                self.assertGreater(abs(sum(a * b for a, b in zip(across, x, strict=True))), math.cos(math.radians(3)), label)
            self.assertEqual(outcome.called("db", "add")[-1]["args"], ["object_pose", tool])
            self.assertGreater(outcome.results["confidence"], 0.6)

    def test_never_finds_the_decoy(self):
        outcome = run("SearchObject", [take(*NAMES.values())])
        self.assertEqual(outcome.name, "clear")  # the decoy is still there
        self.assertEqual((outcome.results, outcome.called("db", "add")), ({}, []))

    def test_ignores_parts_already_placed_or_outside_the_area(self):
        x, y, _ = BODIES[NAMES["Box"]]["pose"]["position"]
        around = {"min": [x - 0.05, y - 0.05], "max": [x + 0.05, y + 0.05]}
        beside = {"min": [x + 0.05, -0.55], "max": [0.95, 0.55]}
        self.assertEqual(run("SearchObject", labels=["Box"], placed=[around]).name, "clear")
        self.assertEqual(run("SearchObject", labels=["Box"], area=beside).name, "clear")
        self.assertEqual(run("SearchObject", labels=["Box"], placed=[beside], area=around).name, "success")

    def test_a_gesture_preempts_it(self):
        for port, force in (("abort", [0, 0, -40]), ("by_hand", [0, 0, 40])):
            outcome = run("SearchObject", [take("can_yellow"), push(force)], labels=["Tape"], pictures=15)
            self.assertEqual((outcome.name, outcome.results), (port, {}))
            self.assertLess(outcome.last["time"], 1)
            self.assertEqual(outcome.sent[-1]["operation"], "stop")  # of recognition, by the exit of the preempted state

    def test_a_push_to_the_side_does_not_preempt_it(self):
        outcome = run("SearchObject", [take("can_yellow"), push([0, 40, 0], at=0.3)], labels=["Tape"], pictures=6)
        self.assertEqual(outcome.name, "clear")
        self.assertIn("Root/HapticGesture/WaitContact.contact", outcome.fired)

    def test_ends_at_error_at_once_without_calibration_recognition_or_pictures(self):
        detect = "Root/ObjectRecognition/DetectObject.error"
        scene = {key: value for key, value in SCENE.items() if key != "camera"}
        self.assertEqual(run("SearchObject", cell={"database.json": {}}).name, "uncalibrated")
        for outcome, port in ((run("SearchObject", labels=["Spoon"]), detect),
                              (run("SearchObject", without=["parts.json"]), detect),
                              (run("SearchObject", cell={"scene.json": scene}), detect),
                              (run("SearchObject", timeout=0.05), detect)):
            self.assertEqual((outcome.name, port in outcome.fired), ("error", True), port)
            self.assertLess(outcome.last["time"], 1)


class LostDisplay(unittest.TestCase):
    """On the server, in real time: the display disconnects while the arm is led, and another one connects at the end."""

    def test_the_calibration_goes_on_while_the_display_is_gone(self):
        led = [act for act in OPERATOR["acts"] if "of 10 places" in act.get("when", {}).get("display", {}).get("text", "")]
        seen = [{**act, "when": {"fires": "Demonstrator/Calibration/CameraCalibration/Collect/Look.seen", "after": 0.3}} for act in led]
        below = [act for act in OPERATOR["acts"] if act.get("when", {}).get("display", {}).get("text") == "does not see"]
        low = [{**act, "when": {"fires": "Demonstrator/Calibration/CameraCalibration/Collect/Look.unseen", "after": 0.5}} for act in below]
        grab = {"when": {"active": "Demonstrator/Calibration/CameraCalibration/Collect"}, "do": OPERATOR["acts"][0]["do"]}
        script = {"operator": 1, "acts": [grab, *seen, *low]}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "operator.json")
            path.write_text(json.dumps(check("operator", script)))
            with Server("--demo", str(DEMO), "--operator", str(path)) as server, server.stream() as first:
                first.send_checked({"type": "display", "name": "phone", "sound": False})
                core = server.core(DOCUMENT, start=False)
                server.post(f"/cores/{core}/start", None, "core")
                first.until(lambda m: "1 of 10 places" in m["data"].get("message", {}).get("text", ""))
                first.close()
                with server.stream() as second:
                    second.subscribe(f"core/{core}/state")
                    second.until(lambda m: m["data"].get("results", {}).get("Demonstrator/Calibration/CameraCalibration", {}).get("o_t_c"))
                    second.send_checked({"type": "display", "name": "tablet", "sound": False})
                    asked = second.until(lambda m: "calibration was interrupted" in m["data"].get("question", {}).get("text", ""))[-1]
                    second.send_checked({"type": "answer", "question": asked["data"]["question"]["id"], "answer": "Abort"})
                    self.assertEqual(server.ended(core)["outcome"], "abort")
                fired = json.dumps(server.get(f"/cores/{core}/journal"))
        self.assertIn("no_display", fired)


if __name__ == "__main__":
    unittest.main()
