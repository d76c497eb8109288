"""The handling states of the demonstrator: picked, placed, taught, and interrupted by collisions, in the demo's cell."""
import json
import math
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import models
from cell import BODIES, DATABASE, DEMO, DOCUMENT, NAMES, O_T_C, TAUGHT
from client import PROGRAM, check

LIBRARY = DOCUMENT["library"]
APPROACH, GRASP = "Root/Work/Task/Pick/Approach/Across", "Root/Work/Task/Pick/Grasp"
CARRY = "Root/Work/Task/Place/SetDown/Approach/Across"
QUESTION = {"display": {"text": "What is to be done?"}, "after": 0.2}


def part(label):
    return {"label": label, "o_t_x": BODIES[NAMES[label]]["pose"]}


def link(of, name=None, **parameters):
    return {"state": name or of, "link": of, "parameters": [{"name": k, "value": v} for k, v in parameters.items()]}


def task(*links, after="success"):
    """Library states one after the other, the first left through `after`, the others through `success`; each other port, and those of
    the last, end the task. Results: where the tool is (`pose`), what the gripper does (`gripper`), those of the links (`Pick_at`)."""
    library = {state["state"]: state for state in LIBRARY}
    found, ends = [], {}
    for i, each in enumerate(links):
        name, of, onward = each["state"], library[each["link"]], "success" if i else after
        found += [(f"{name}_{r['name']}", f"chi.{name}.res.{r['name']}") for r in of.get("results", [])]
        for port in (p["name"] for p in of["ports"]):
            if port == onward and each is not links[-1]:
                each["ports"] = [{"name": port, "to": links[i + 1]["state"]}]
            else:
                ends.setdefault(port, []).append(f"chi.{name}.port.{port}")
    return models.document("handling", {
        "state": "Root", "results": [{"name": name} for name in ("pose", "gripper", *dict(found))],
        "actions": [{"when": "svc.robot.robot_state", "do": "res.pose = svc.robot.robot_state.pose"},
                    {"when": "svc.gripper.gripper_state", "do": "res.gripper = svc.gripper.gripper_state"},
                    *({"when": f"available({value})", "do": f"res.{name} = {value}"} for name, value in found)],
        "children": list(links), "first": links[0]["state"],
        "ports": [{"name": name, "when": " or ".join(whens)} for name, whens in ends.items()]}, library=LIBRARY)


class Outcome:
    """What `race run` told: the summary, and what happened in order of time."""

    def __init__(self, lines):
        self.reports = [json.loads(line) for line in lines]
        self.last = self.reports[-1]
        self.name, self.results = self.last.get("outcome"), self.last["results"]
        self.fired = [port for r in self.reports for port in r.get("fired", [])]
        self.calls = [f"{c['service']}.{c['operation']}" for r in self.reports for c in r.get("calls", [])]

    def events(self, name):
        inputs = [r["input"] for r in self.reports if r.get("input", {}).get("event") == name]
        return [each["data"] for each in inputs]

    def time(self, port, index=0):
        return [r["time"] for r in self.reports if port in r.get("fired", [])][index]


def run(document, *acts, displays=("phone",), limit=120, arguments=None, database=DATABASE):
    script = check("operator", {"operator": 1, "displays": list(displays), "acts": list(acts)})
    with tempfile.TemporaryDirectory() as folder:
        model, operator = Path(folder, "model.rcm.json"), Path(folder, "operator.json")
        model.write_text(json.dumps(document))
        operator.write_text(json.dumps(script))
        cell = shutil.copytree(DEMO, Path(folder, "cell"))
        (cell / "database.json").write_text(json.dumps(database))
        out = subprocess.run([PROGRAM, "run", model, "--cell", cell, "--fast", "--json", "--seed", "7", "--limit", str(limit),
                              "--operator", operator, "--arguments", json.dumps(arguments or {})],
                             capture_output=True, text=True, timeout=280)
    assert out.returncode in (0, 1) and "refused" not in out.stdout, out.stderr + out.stdout[-2000:]
    return Outcome(out.stdout.splitlines())


def bump(state, after=0.1, force=40.0):
    """An accident while the state is active: some ms of force."""
    return {"when": {"active": state, "after": after},
            "do": {"act": "push", "body": "link_6", "force": [0, force, 0], "duration": 0.06, "rise": 0.005}}


def touch(state, after=0.5):
    """Meant: the force rises and falls slowly."""
    return {"when": {"active": state, "after": after},
            "do": {"act": "push", "body": "gripper", "point": [0, 0, 0.05], "force": [0, 25, 0], "duration": 0.8, "rise": 0.3}}


def answer(button, when=QUESTION):
    return {"when": when, "do": {"act": "answer", "button": button}}


def lead(state, *ways):
    """Three hands lead the gripper, so that it does not turn, and let go when it holds itself."""
    hands = {"left": [0, 0.07, 0.05], "right": [0, -0.07, 0.05], "third": [0, 0, 0.13]}
    drag = lambda by: [{"act": "drag", "hand": h, "by": by, "speed": 0.3} for h in hands]
    grab = [{"act": "grab", "hand": h, "body": "gripper", "point": p, "keep": 60} for h, p in hands.items()]
    acts = [{"when": {"active": f"{state}/Lead", "after": 0.2}, "do": grab + drag(ways[0])}]
    for way, before in zip([*ways[1:], None], ways):
        pause = {"after": 1.2 + math.hypot(*before) / 0.3}
        acts.append({"when": pause, "do": drag(way)} if way else answer("Done", pause))
    return [*acts, {"when": {"active": f"{state}/LetGo", "after": 0.2}, "do": [{"act": "release", "hand": h} for h in hands]},
            answer("Done", {"after": 0.3})]


def work(label="Cube", **parameters):
    return link("Work", **part(label), speed=1.0, **parameters)


def again(label="Cube"):
    return link("Pick", "Again", **part(label), speed=1.0)


class Interrupted(unittest.TestCase):
    def test_approach_is_begun_again_from_where_the_arm_is(self):
        out = run(task(work()), bump(APPROACH), answer("Continue"))
        self.assertEqual(out.name, "success")
        self.assertEqual([p for p in out.fired if "/Pick/Dispatcher." in p],
                         [f"Root/Work/Task/Pick/Dispatcher.{to}" for to in ("to_Release", "to_GetPose")])
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
        out = run(task(work(), again()), bump(release), answer("Continue"))
        self.assertEqual((out.fired.count("Root/Work.success"), out.name), (1, "error"))  # where it was, nothing is left

    def test_a_meant_touch_goes_on_without_a_display_and_an_accident_does_not(self):
        haptic = "Root/Work/Collision/Haptic"
        out = run(task(work()), bump(APPROACH), bump(f"{haptic}/Touch"), touch(f"{haptic}/Touch", 1.0), displays=())
        self.assertEqual((out.name, [c["classification"] for c in out.events("contact")]),
                         ("success", ["accidental", "accidental", "intended"]))
        felt, left = (next(r["input"]["data"] for r in out.reports if port in r.get("fired", []))
                      for port in (f"{haptic}/Touch.success", f"{haptic}.success"))
        self.assertEqual(felt["classification"], "intended")
        self.assertLess(max(abs(force) for force in left["f_ext_hat"]), 12)

    def test_nobody_is_waited_for_longer_than_told(self):
        out = run(task(work(patience=3.0)), bump(APPROACH), displays=())
        self.assertEqual(out.name, "error")
        self.assertAlmostEqual(out.time("Root/Work.error") - out.time("Root/Work/Task.collision"), 3.1, delta=0.2)

    def test_skip_leaves_open_fingers_and_the_part_where_it_was(self):
        for state, after, way in ((APPROACH, 0.1, "Up"), (GRASP, 0.1, "Up"), (GRASP, 0.8, "Back")):
            out = run(task(work(), again(), after="skip"), bump(state, after), answer("Skip"))
            self.assertEqual((out.name, out.fired.count("Root/Work.skip")), ("success", 1), (state, after))
            self.assertEqual(out.fired.count(f"Root/Work/GiveUp/Task/{way}.success"), 1, (state, after))

    def test_skip_brings_a_part_that_is_held_back(self):
        out = run(task(work(), again(), after="skip"), bump(CARRY, force=-40.0), answer("Skip"))
        self.assertEqual((out.name, out.fired.count("Root/Work/GiveUp/Task/Back.success")), ("success", 1))
        self.assertAlmostEqual(out.results["Again_actual_width"], 0.04, delta=0.002)

    def test_a_collision_while_a_part_is_given_up_is_answered_too(self):
        back = "Root/Work/GiveUp/Task/Back/Approach/Across"
        out = run(task(work(), again(), after="skip"), bump(CARRY, force=-40.0), answer("Skip"), bump(back), answer("Continue"))
        self.assertEqual((out.name, out.fired.count("Root/Work/GiveUp/Task.collision")), ("success", 1))

    def test_abort_stands_still_and_keeps_what_is_held(self):
        for state, force, holding in ((APPROACH, 40.0, False), (GRASP, 40.0, False), (CARRY, -40.0, True)):
            out = run(task(work()), bump(state, force=force), answer("Abort"))
            self.assertEqual((out.name, out.results["gripper"]["holding"]), ("abort", holding), state)
            collision = out.calls.index("gripper.stop")
            self.assertNotIn("robot.move", out.calls[collision:], state)


class Taught(unittest.TestCase):
    TEACH = "Root/Work/Task/Place/TeachPose"

    def test_a_place_is_led_to_stored_and_used(self):
        stored = link("GetPose", "Stored", key=f"o_t_place_{TAUGHT}")
        ways = [[-0.28, 0.15, 0.05], [0, 0, -0.196]]
        out = run(task(work(TAUGHT), stored), *lead(self.TEACH, *ways))
        self.assertEqual((out.name, out.calls.count("db.add")), ("success", 1))
        place = out.results["Work_o_t_x"]
        self.assertEqual(out.results["Stored_pose"]["position"], place["position"])
        led = [a + b for a, b in zip(BODIES[NAMES[TAUGHT]]["pose"]["position"], (ways[0][0], ways[0][1]))]
        self.assertLess(math.dist(led, place["position"][:2]), 0.02)
        found = run(task(work(TAUGHT), link("Pick", "Again", label=TAUGHT, o_t_x=place, speed=1.0)), *lead(self.TEACH, *ways))
        self.assertAlmostEqual(found.results["Again_actual_width"], 0.04, delta=0.002)

    def test_a_grasp_is_stored_in_the_parts_frame(self):
        below = {"position": [0.5, 0.0, 0.02], "orientation": [0, 0, 1, 0]}
        away = {"do": [{"act": "take", "part": "cube_blue"}, {"act": "place", "part": "cube_red", "pose": below}]}
        document = task(link("Pick", label="Thing", o_t_x=below, speed=1.0), link("GetPose", "Stored", key="x_t_g_Thing"))
        out = run(document, away, *lead("Root/Pick/TeachPose", [0, 0, -0.293]))
        self.assertEqual(out.name, "success")
        self.assertAlmostEqual(out.results["Pick_actual_width"], 0.04, delta=0.002)
        self.assertLess(math.dist(out.results["Stored_pose"]["position"], (0, 0, 0)), 0.01)

    def test_a_bump_into_an_arm_that_gives_way_ends_no_teaching(self):
        out = run(task(work(TAUGHT)), bump(f"{self.TEACH}/Lead"), answer("Cancel", {"after": 0.5}), answer("Abort"))
        self.assertEqual([c["reaction"] for c in out.events("collision")], ["none"])
        self.assertEqual((out.name, out.fired.count("Root/Work/Task.collision")), ("abort", 0))
        self.assertEqual(out.fired.count("Root/Work/Task/Place/TeachPose.error"), 1)

    def test_cancel_and_silence_are_errors_that_store_nothing_and_hold_the_arm(self):
        teach = link("TeachPose", key="new", patience=2.0)
        for acts in ([answer("Cancel", {"display": {"button": "Cancel"}, "after": 0.5})], []):
            out = run(task(teach, link("Rise", travel=0.4), after="error"), *acts)
            self.assertEqual(out.name, "success")
            self.assertNotIn("db.add", out.calls)
            self.assertGreater(out.results["pose"]["position"][2], 0.395)

    def test_without_a_display_it_is_an_error_at_once(self):
        out = run(task(link("TeachPose", key="new")), displays=())
        self.assertEqual(out.name, "error")
        self.assertLess(out.last["time"], 0.1)


class Failed(unittest.TestCase):
    """What fails in Work is a person's decision."""
    TAKEN = {"do": {"act": "take", "part": NAMES["Cube"]}}
    BACK = {"when": {**QUESTION, "after": 0.5},
            "do": [{"act": "place", "part": NAMES["Cube"], "pose": BODIES[NAMES["Cube"]]["pose"]}, {"act": "answer", "button": "Continue"}]}

    def test_continue_begins_to_pick_anew_when_the_part_is_there(self):
        out = run(task(work()), self.TAKEN, self.BACK)
        self.assertEqual((out.name, out.fired.count("Root/Work/Task/Pick.error")), ("success", 1))
        self.assertEqual(out.fired.count("Root/Work/Task/Pick/Grasp.error"), 1)

    def test_skip_gives_it_up_and_abort_ends(self):
        for button, outcome in (("Skip", "skip"), ("Abort", "abort")):
            self.assertEqual(run(task(work()), self.TAKEN, answer(button)).name, outcome)

    def test_nobody_is_waited_for_for_ever(self):
        out = run(task(link("Trouble", text="?", patience=5.0)), displays=())
        self.assertEqual(out.name, "error")
        self.assertGreater(out.calls.count("display.ask"), 1, "a display may come")


class Shown(unittest.TestCase):
    def test_a_hand_shows_the_part_that_no_eye_has_found(self):
        acts = [{"do": [{"act": "take", "part": name} for name in NAMES.values()]},
                {"when": {"active": "Demonstrator/Table/SearchObject", "after": 0.05},
                 "do": {"act": "push", "body": "gripper", "point": [0, 0, 0.15], "force": [0, 0, 40], "duration": 0.6, "rise": 0.2}},
                {"when": {"display": {"text": "Which part is it?"}, "after": 0.2},
                 "do": [{"act": "place", "part": NAMES["Cube"], "pose": {"position": [0.5, 0.0, 0.02], "orientation": [0, 0, 0, 1]}},
                        {"act": "answer", "button": "Cube"}]},
                *lead("Demonstrator/Table/ShowPart/TeachPose", [0, 0, -0.293])]
        out = run(DOCUMENT, *acts, arguments={"begin": "Table"}, database={**DATABASE, "o_t_c": O_T_C})
        self.assertEqual(out.name, "success")
        self.assertIn("Demonstrator/Table/SearchObject.by_hand", out.fired)
        self.assertEqual([part["label"] for part in out.results["placed"]], ["Cube"])
        at, place = out.last["cell"]["bodies"][NAMES["Cube"]]["position"], DATABASE["o_t_place_Cube"]["position"]
        self.assertLess(math.dist(at, place), 0.02)


class Missing(unittest.TestCase):
    def test_without_a_part_the_arm_retreats_first(self):
        nowhere = {"position": [0.45, 0.0, 0.02], "orientation": [0, 0, 0, 1]}
        out = run(task(link("Pick", label="Cube", o_t_x=nowhere, speed=1.0)))
        self.assertEqual((out.name, out.results["gripper"]["holding"]), ("error", False))
        self.assertLess(out.time("Root/Pick/Grasp.error"), out.time("Root/Pick/Retreat.success"))
        self.assertGreater(out.results["pose"]["position"][2], 0.195)

    def test_nothing_is_placed_with_empty_fingers(self):
        out = run(task(link("Place", label="Cube", x_t_g=DATABASE["x_t_g_Cube"], speed=1.0)))
        self.assertEqual((out.name, out.calls.count("gripper.release")), ("error", 0))
        self.assertGreater(out.results["pose"]["position"][2], 0.195)


if __name__ == "__main__":
    unittest.main()
