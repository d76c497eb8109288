"""Each error of each skill of the demo, from a cause in the cell; then the arm holds still, and the skill says why."""
import contextlib
import math
import unittest
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

from cell import DATABASE, DEMO, NAMES, SCENE
from client import Server
from controls import Controls
from motions import insisting
from scenario import answer, bump, link
from skills import HELD, LIBRARY, ON_STAND, SKILLS, STAND, errors, run_skills, squeeze, take, task_of

AWAY = "svc.robot.move({'joints': [0.6, -0.35, 0.0, 1.6, 0.0, -1.19, 0.0]}, speed=0.02)"  # for longer than any test
FINGERS = "svc.gripper.release(width=0.02, speed=0.005)"
STOP, STOP_FINGERS = "svc.robot.stop()", "svc.gripper.stop()"
LONG = "x" * 1001  # longer than a key of the database
ON_SIDE = {"position": [0.5, 0.2, 0.02], "orientation": [0, 0.707106781, 0, 0.707106781]}


@dataclass
class Case:
    """A skill that ends at an error: with these parameters, after these skills, while this happens."""
    parameters: dict = field(default_factory=dict)
    before: tuple = ()
    acts: tuple = ()
    options: dict = field(default_factory=dict)


def case(*acts, before=(), options=None, **parameters):
    return Case(parameters, tuple(before), acts, options or {})


def absent(service, **more):
    return case(options={"absent": service}, **more)


def beside(code, after=None, **more):
    """Something else calls a service, at the beginning or after so many seconds."""
    return case(options={"beside": code if after is None else (after, code)}, **more)


def motion(skill, state, **parameters):
    """Errors of a motion of the arm by `skill`, which is active as `state` from the beginning on."""
    return {"collision": case(bump(f"Root/{skill}/{state}", 0.2), **parameters), "stopped": beside(STOP, 0.3, **parameters),
            "busy": beside(AWAY, **parameters), "no_robot": absent("robot", **parameters), "setting": case(**parameters | {"speed": 2.0})}


def posed(skill, state="Move"):
    return {**motion(skill, state, pose="give"), "no_pose": case(pose="nowhere"), "unreachable": case(pose="far"),
            "no_database": absent("db", pose="give")}


def held_before(cases):
    """The cube is between the fingers before."""
    def after_that(options):
        beside = options.get("beside")
        return options | {"further": [STAND]} | ({"beside": (beside[0] + 1, beside[1])} if isinstance(beside, tuple) else {})

    return {error: Case(c.parameters, (HELD,), (*ON_STAND, *c.acts), after_that(c.options)) for error, c in cases.items()}


def picking(skill, **parameters):
    grab = f"Root/{skill}/Grab"
    there = parameters.get("nothing", parameters)
    parameters = {key: value for key, value in parameters.items() if key != "nothing"}
    return {**motion(skill, "Grab/Above", **parameters), **held_before({"occupied": case(**parameters)}), "no_part": case(**there),
            "lost": case(take(active=f"{grab}/Lift", after=0.3), **parameters), "blocked": case(squeeze(f"{grab}/Open"), **parameters),
            "no_gripper": absent("gripper", **parameters)}


def placing(skill, pose, **parameters):
    put = f"Root/{skill}/Put"
    held = {"lost": case(take(active=f"{put}/Above", after=0.3), **pose), "blocked": case(squeeze(f"{put}/Release"), **pose),
            "unreachable": case(**parameters, pose="far"), **motion(skill, "Put/Above", **pose)}
    return {**held_before(held), "no_part": case(**pose), "no_gripper": absent("gripper", **pose),
            "no_pose": case(pose="nowhere"), "no_database": absent("db", **pose)}


FOUND = {"label": "Cube", "pose": {"position": [0.55, -0.15, 0.02], "orientation": [1, 0, 0, 0]}}
NOTHING = {"label": "Cube", "pose": {"position": [0.45, 0.0, 0.02], "orientation": [1, 0, 0, 0]}}
FAR_AWAY = {"label": "Cube", "pose": {"position": [2.0, 0.0, 0.02], "orientation": [1, 0, 0, 0]}}
WALL = {"name": "wall", "shape": {"box": [0.02, 0.6, 0.6]}, "mass": 0, "friction": 0.5, "colour": "#777777",
        "pose": {"position": [1.2, 0, 0.7], "orientation": [0, 0, 0, 1]}}
BLIND = {"files": {"scene.json": {key: value for key, value in SCENE.items() if key != "camera"}}}
DONE = answer("Done", {"active": "Root/TeachPose/Grip", "after": 0.1})
GRIP, LEAD = "Root/TeachPose/Grip", "Root/TeachPose/Guide/Lead"

CASES = {
    "MoveTo": posed("MoveTo"),
    "MoveLinear": posed("MoveLinear"),
    "MoveBy": {**motion("MoveBy", "Move", distance=0.2), "unreachable": case(distance=3.0)},
    "OpenGripper": {"blocked": case(squeeze("Root/OpenGripper/Open")), "stopped": beside(STOP_FINGERS, 0.05), "busy": beside(FINGERS),
                    "no_gripper": absent("gripper"), "setting": case(width=0.2)},
    "CloseGripper": {"no_part": case(), "stopped": beside(STOP_FINGERS, 0.1), "busy": beside(FINGERS), "no_gripper": absent("gripper"),
                     "setting": case(force=500.0)},
    "PickAt": {**picking("PickAt", pose="part", nothing={"pose": "place"}), "no_pose": case(pose="nowhere"),
               "unreachable": case(pose="far"), "no_database": absent("db", pose="part")},
    "PickFound": {**picking("PickFound", found=FOUND, nothing={"found": NOTHING}), "unreachable": case(found=FAR_AWAY), "no_found": case()},
    "PlaceAt": placing("PlaceAt", {"pose": "place"}),
    "Palletise": placing("Palletise", {"pose": "place"}),
    "NewGrid": {"no_database": absent("db", pose="place"), "setting": case(pose=LONG)},
    "SearchObject": {
        "lying": case({"do": {"act": "place", "part": NAMES["Block"], "pose": ON_SIDE}}, labels=["Block"]),
        "uncalibrated": case(options={"database": DATABASE}), "no_camera": absent("obj_rec"), "no_database": absent("db"),
        "setting": case(labels=["Elephant"])},
    "CalibrateCamera": {
        **motion("CalibrateCamera", "Tour/Go", height=0.5), "not_seen": case(options={"further": [WALL]}),
        "scatter": case(max_position=0.0001, speed=1.0), "no_camera": absent("obj_rec"), "no_database": absent("db", speed=1.0),
        "unreachable": case(postures=[[9.0, 0, 0, 0, 0, 0, 0]])},
    "WaitForGesture": {"timeout": case(patience=1.0), "busy": beside(AWAY), "no_robot": absent("robot")},
    "AskPerson": {"no_answer": case(patience=1.0), "no_display": case(options={"displays": ()}),
                  "taken": beside("svc.display.clear()", 0.2), "setting": case(yes="Same", no="Same")},
    "Say": {"no_display": case(options={"displays": ()}), "no_speaker": absent("audio", sound="beep"), "setting": case(sound="moo")},
    "HandOver": {
        **held_before({**motion("HandOver", "Go", pose="give"), "nobody": case(pose="home", patience=1.0), "unreachable": case(pose="far"),
                       "lost": case(take(active="Root/HandOver/Go", after=0.3), pose="give"),
                       "blocked": case({"when": {"active": "Root/HandOver/Pull", "after": 0.3}, "do": {
                           "act": "push", "body": "gripper", "point": [0, 0, 0.05], "force": [0, 25, 0], "duration": 0.8, "rise": 0.3}},
                           squeeze("Root/HandOver/Open"), pose="home")}),
        "no_part": case(pose="give"), "no_gripper": absent("gripper", pose="give"), },
    "TeachPose": {
        "cancelled": case(answer("Cancel", {"active": GRIP, "after": 0.1}), pose="new"), "no_answer": case(pose="new", patience=1.0),
        "no_display": case(pose="new", options={"displays": ()}), "taken": beside("svc.display.clear()", 0.2, pose="new"),
        "stopped": case(DONE, answer("Done", {"active": LEAD, "after": 1.0}), pose="new", options={"beside": (0.6, STOP)}),
        "busy": case(DONE, pose="new", options={"beside": AWAY}), "no_robot": case(DONE, pose="new", options={"absent": "robot"}),
        "no_database": case(DONE, answer("Done", {"active": LEAD, "after": 0.2}), pose="new", options={"absent": "db"}),
        "setting": case(pose="a b")},
    "WaitTime": {},
    "Count": {"no_database": absent("db"), "setting": case(what=LONG)},
}
CASES["Palletise"] |= held_before({"setting": case(pose="place", row_direction="right")})
CASES["HandOver"] |= held_before({"no_pose": case(pose="nowhere"), "no_database": absent("db", pose="give")})
ONLY_ON_A_SERVER = {("WaitForGesture", "stopped")}


def reach(skill, error):
    chosen = CASES[skill][error]
    return run_skills(*chosen.before, link(skill, **chosen.parameters), acts=chosen.acts, rest=error, **chosen.options)


class Errors(unittest.TestCase):
    def test_each_has_a_cause(self):
        wanted = {(skill, error) for skill in SKILLS for error in errors(skill)}
        self.assertEqual({(skill, error) for skill, cases in CASES.items() for error in cases} | ONLY_ON_A_SERVER, wanted)

    def assert_stands(self, out):
        """The arm has held still for the last 0.2 s."""
        last = [state["pose"]["position"] for state in out.events("robot_state")][-20:]
        for position in last:
            self.assertLess(math.dist(position, last[-1]), 0.002)

    def test_each_is_reached_by_its_cause_and_says_why(self):
        with ThreadPoolExecutor(2) as pool:
            outs = [(skill, error, pool.submit(reach, skill, error)) for skill, cases in CASES.items() for error in cases]
            for skill, error, out in outs:
                with self.subTest(skill=skill, error=error):
                    self.assertEqual((out.result().name, out.result().last.get("fault")), (error, None), out.result().results)
                    self.assertTrue(out.result().results["why"])
                    led = out.result().called("robot", "change_behavior")
                    self.assertTrue(not led or led[-1]["args"] == ["position"])
                    if error != "busy":
                        self.assert_stands(out.result())

    def test_a_value_that_is_no_part_or_no_pose_ends_no_run(self):
        for value in ("Cube", {"label": "Cube"}, 1, []):
            self.assertEqual(run_skills(link("PickFound", found=value)).name, "no_found", value)
            out = run_skills(link("MoveTo", pose="odd"), database={"pose_odd": value})
            self.assertEqual(out.name, "no_pose", value)
        self.assertEqual(run_skills(link("CalibrateCamera", postures=[], samples=0)).name, "setting")

    def test_without_pictures_a_search_does_not_say_that_there_is_no_part(self):
        silent = {"beside": (0.05, "svc.obj_rec.stop()")}
        for options, why in ((BLIND, "camera: unavailable"), (silent, "no picture has come")):
            out = run_skills(link("SearchObject"), **options)
            self.assertEqual((out.name, out.results["why"]), ("no_camera", why))


class OnServer(unittest.TestCase):
    """What only comes to pass where there are people at the controls and other runs."""

    def setUp(self):
        self.server = Server("--demo", str(DEMO))
        self.addCleanup(self.server.stop)

    def ended(self, core):
        core = self.server.ended(core)
        return core.get("outcome"), core["results"]["why"]

    def test_it_stores_them_with_the_other_documents_of_the_demo(self):
        entry = self.server.get("/documents/skills", "document_entry")
        self.assertEqual((entry["errors"], [state["state"] for state in entry["document"]["library"]]), ([], list(LIBRARY)))

    def test_a_gesture_is_not_waited_for_after_another_mode_until_a_person_lets_the_run_go_on(self):
        core = self.server.core(task_of(link("WaitTime", duration=1.5), link("WaitForGesture")))
        with contextlib.closing(Controls(self.server)) as person:
            person.programming()
            person.set_mode("execution")
            outcome, why = self.ended(core)
            self.assertEqual(outcome, "stopped")
            self.assertIn("stopped", why)

    def test_an_arm_that_another_run_drives_is_busy(self):
        core = self.server.core(insisting())
        outcome, why = self.ended(self.server.core(task_of(link("MoveTo", pose="give"))))
        self.assertEqual(outcome, "busy")
        self.assertIn(f"run {core}", why)


if __name__ == "__main__":
    unittest.main()
