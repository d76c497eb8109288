"""Tasks made of skills in the form of api/skills.md: the demo's example, what happens if a step fails, and loops."""
import json
import math
import unittest

import models
from cell import BODIES, NAMES
from scenario import answer, bump, link, run, task
from skills import DOCUMENT, KNOWN, LIBRARY, SKILLS, errors, run_skills, squeeze, take

TASK = "Application/Move_a_part"
CUBE = BODIES[NAMES["Cube"]]["pose"]
PUT_BACK = {"act": "place", "part": NAMES["Cube"], "pose": CUBE}
PLACED = [0.45, 0, 0.02]


def example(*acts, **options):
    return run(DOCUMENT, *acts, database=options.pop("database", KNOWN), **options)


def cube(out):
    return out.last["cell"]["bodies"][NAMES["Cube"]]["position"]


def loop(times, *links, until=()):
    """A document whose task does the links again and again. `until`: ports of them that end the loop, `STEP.port.NAME`."""
    names = [each["state"] for each in links]
    body = {"state": "Body", "children": [{**each, "ports": [{"name": "success", "to": to}]} if to else each
                                          for each, to in zip(links, [*names[1:], None], strict=True)], "first": names[0],
            "ports": [{"name": "success", "when": f"chi.{names[-1]}.port.success", "to": "Count"}]}
    if until:
        body["ports"].append({"name": "done", "when": " or ".join(f"chi.{port}" for port in until)})
    count = {**link("Repeat", "Count", times=times), "ports": [{"name": "again", "to": "Body"}]}
    return models.document("looping", {
        "state": "Root", "meta": {"loop": True}, "children": [body, count], "first": "Body",
        "ports": [{"name": "success", "when": "chi.Count.port.done" + (" or chi.Body.port.done" if until else "")}]},
        library=DOCUMENT["library"])


class Form(unittest.TestCase):
    """The stored example is what RACE-One can edit."""

    def check(self, task, top=False):
        children = {child["state"]: child for child in task["children"]}
        ports = {port["name"]: port["when"] for port in task["ports"]}
        self.assertEqual((list(ports), task["first"]), (["success", "error"], task["children"][0]["state"]))
        steps = [child for child in task["children"] if child.get("link") not in ("Retry", "WhatNow")]
        for step, following in zip(steps, [*steps[1:], None], strict=True):
            if top:
                self.check(step)
                continue
            to = {port["name"]: port.get("to") for port in step.get("ports", [])}
            self.assertEqual(to.get("success"), following and following["state"])
            failing = {to.get(error) for error in errors(step["link"])}
            self.assertEqual(len(failing), 1, step["state"])
            stops = [error for error in errors(step["link"]) if f"chi.{step['state']}.port.{error}" in ports["error"].split(" or ")]
            self.assertEqual(stops, errors(step["link"]) if failing == {None} else [])
            self.assertTrue(failing <= {None, f"{step['state']}_retry", f"{step['state']}_ask"})
        self.assertEqual(ports["success"], f"chi.{steps[-1]['state']}.port.success")
        handlers = [name for name in children if name.endswith(("_retry", "_ask"))]
        self.assertEqual(list(children), [*(step["state"] for step in steps), *handlers])

    def test_the_example_has_the_form_of_tasks(self):
        self.check(DOCUMENT["root"], top=True)
        self.assertTrue({each["link"] for each in DOCUMENT["root"]["children"][0]["children"]} <= {*SKILLS, "Retry", "WhatNow"})
        self.assertEqual(LIBRARY["Repeat"]["keep"], True)


class Example(unittest.TestCase):
    def assert_placed(self, out, where=None):
        self.assertEqual(out.name, "success", out.fired[-4:])
        self.assertLess(math.dist(cube(out), where or PLACED), 0.005)

    def test_it_moves_the_cube_without_anybody(self):
        out = example(displays=None)
        self.assert_placed(out)
        self.assertEqual(out.asked(), [])

    def test_it_tries_again_before_it_asks_and_a_person_helps(self):
        helps = {"when": {"display": {"text": "failed"}, "after": 0.2}, "do": [PUT_BACK, {"act": "answer", "button": "Retry"}]}
        out = example(take(), helps)
        self.assert_placed(out)
        self.assertEqual(out.asked(), ["Pick the cube has failed: the fingers met nothing. Let go of the arm before you answer: it may "
                                       "move. What is to be done?"])
        ports = ("Pick.no_part", "Pick_retry.again", "Pick_retry.give_up")
        self.assertEqual([out.fired.count(f"{TASK}/{port}") for port in ports], [3, 2, 1])

    def test_a_person_leaves_steps_out_or_stops_the_task(self):
        asks = {"when": {"display": {"text": "failed"}, "after": 0.2}}
        skips = [{**asks, "do": {"act": "answer", "button": "Skip"}}] * 2
        out = example(take(), *skips)
        self.assertEqual((out.name, len(out.asked()), out.fired.count(f"{TASK}/Place.no_part")), ("success", 2, 1))
        self.assertEqual(example(take(), {**asks, "do": {"act": "answer", "button": "Abort"}}).name, "error")

    def test_a_collision_in_each_phase_of_picking_is_tried_again_without_anybody(self):
        """A part that is in the fingers already is not let go."""
        grab = f"{TASK}/Pick/Grab"
        closing = (("Close", after, 2) for after in (0.1, 0.7, 0.8))
        phases = (("Open", 0, 1), ("Above", 0.1, 1), ("Down", 0.1, 1), *closing, ("Lift", 0.1, 1))
        for state, after, grasps in phases:
            out = example(bump(f"{grab}/{state}", after), displays=())
            self.assertEqual((out.fired.count(f"{TASK}/Pick.collision"), out.calls.count("gripper.grasp")), (1, grasps), (state, after))
            self.assert_placed(out)

    def test_a_collision_in_each_phase_of_placing_is_gone_on_with(self):
        """A part that was let go is not sought between the fingers."""
        put, again = f"{TASK}/Place/Put", answer("Retry", {"display": {"text": "failed"}, "after": 0.5})
        for state in ("Above", "Down", "Release", "Up"):
            out = example(bump(f"{put}/{state}", 0.05 if state == "Release" else 0.2, force=-40.0), again)
            self.assertEqual((out.fired.count(f"{TASK}/Place.collision"), len(out.asked())), (1, 1), state)
            self.assert_placed(out)

    def test_where_the_arm_begins_does_not_matter(self):
        """Also low beside a part, and with another part in the fingers."""
        for begin in ([link("MoveLinear", "Begin", pose="place")], [link("MoveTo", "Begin", pose="give")]):
            out = run_skills(*begin, link("PickAt", pose="part"), link("PlaceAt", pose="place"))
            self.assert_placed(out)

    def test_without_a_display_it_waits_for_one_and_the_arm_stands(self):
        out = example(take(), displays=(), limit=60)
        self.assertIsNone(out.name)
        self.assertGreater(out.calls.count("display.ask"), 5)
        self.assertNotIn("robot.move", out.calls[out.calls.index("display.ask"):])


class AskingAPerson(unittest.TestCase):
    def test_a_question_is_asked_however_long_its_texts_are(self):
        long = "\N{GREEK SMALL LETTER ALPHA}" * 3000
        for parameters in ({}, {"step": long, "why": long}):
            out = run_skills(link("WhatNow", **parameters), acts=[answer("Skip", {"display": {"text": "What is to be done?"}})])
            self.assertEqual(out.name, "skip")


class GoingOn(unittest.TestCase):
    def test_a_part_that_was_taken_out_meanwhile_is_picked_anew(self):
        """The lift was interrupted with the part in the fingers; a person puts it back before the retry."""
        hit = bump(f"{TASK}/Pick/Grab/Lift", 0.8)
        out = example(hit, take(fires=f"{TASK}/Pick.collision", after=0.1), {"when": {"after": 0.2}, "do": PUT_BACK})
        self.assertEqual((out.name, out.calls.count("gripper.grasp")), ("success", 2))
        self.assertLess(math.dist(cube(out), PLACED), 0.005)

    def test_fingers_that_did_not_open_are_asked_about_and_the_task_goes_on(self):
        out = example(squeeze(f"{TASK}/Place/Put/Release"), answer("Retry", {"display": {"text": "failed"}, "after": 2.5}))
        self.assertEqual((out.name, out.fired.count(f"{TASK}/Place.blocked")), ("success", 1))
        self.assertLess(math.dist(cube(out), PLACED), 0.01)

    def test_a_part_that_was_counted_too_late_is_not_placed_twice(self):
        """The database fails when the part stands in the grid: until it is counted, that alone is tried again."""
        document = task(link("PickAt", pose="part"), link("Palletise", pose="place"), link("Retry", times=2), document=DOCUMENT)
        _, palletise, retry = document["root"]["children"]
        palletise["ports"] = [{"name": "no_database", "to": "Retry"}]
        retry["ports"] = [{"name": "again", "to": "Palletise"}]
        document["root"]["ports"] = [{"name": "no_database", "when": "chi.Retry.port.give_up"}]
        out = run(json.loads(json.dumps(document).replace("svc.db.add", "svc.absent.add")), database=KNOWN)
        self.assertEqual((out.name, out.calls.count("absent.add"), out.calls.count("gripper.release")), ("no_database", 3, 2))
        self.assertLess(math.dist(cube(out), PLACED), 0.005)


class Loops(unittest.TestCase):
    def test_steps_are_done_so_many_times(self):
        out = run(loop(3, link("WaitTime", duration=0.5)))
        self.assertEqual((out.name, out.fired.count("Root/Body.success")), ("success", 3))

    def test_or_for_ever(self):
        out = run(loop(0, link("WaitTime", duration=0.5)), limit=20)
        self.assertEqual((out.name, out.fired.count("Root/Body.success")), (None, 40))

    def test_steps_that_take_no_time_do_not_end_the_run(self):
        out = run(loop(200, link("Count", target=0)))
        self.assertEqual((out.name, out.texts()[-1]), ("success", "200 parts"))

    def test_until_a_step_says_so(self):
        out = run(loop(0, link("Count", target=3), link("WaitTime", duration=0.5), until=["Count.port.reached"]))
        self.assertEqual((out.name, out.fired.count("Root/Body.done"), out.fired.count("Root/Body/WaitTime.success")), ("success", 1, 2))

    def test_or_so_many_times_if_no_step_says_so_before(self):
        out = run(loop(2, link("Count", target=3), link("WaitTime", duration=0.5), until=["Count.port.reached"]))
        self.assertEqual((out.name, out.fired.count("Root/Body.done"), out.fired.count("Root/Body/WaitTime.success")), ("success", 0, 2))

    def test_a_loop_within_a_loop_ends_alone_and_begins_anew_in_each_round(self):
        inner = loop(0, link("Count", target=2), link("WaitTime", duration=0.1), until=["Count.port.reached"])["root"]
        document = loop(3, link("WaitTime", duration=0.1))
        body = document["root"]["children"][0]
        body["children"].insert(0, {**inner, "state": "Inner", "ports": [{**inner["ports"][0], "to": "WaitTime"}]})
        body["first"] = "Inner"
        out = run(document)
        rounds = [out.fired.count(f"Root/Body/{port}") for port in ("Inner/Body.done", "Inner/Body/Count.success", "WaitTime.success")]
        self.assertEqual((out.name, rounds), ("success", [3, 3, 3]))


class Pallets(unittest.TestCase):
    """A pallet of two places is filled by a loop, from a place to which parts are brought."""
    PICK, GRID = link("PickAt", pose="part"), link("Palletise", pose="place", columns=2, rows=1, direction="right")
    NEXT = {"when": {"fires": "Root/Body/Palletise.success"},
            "do": {"act": "place", "part": NAMES["Box"], "pose": {**CUBE, "position": [*CUBE["position"][:2], 0.025]}}}

    def fill(self, *acts):
        until = ["Palletise.port.full", "PickAt.port.no_part"]
        out = run(loop(0, self.PICK, self.GRID, until=until), *acts, database=KNOWN, parts=("Cube", "Box"))
        self.assertEqual((out.name, out.fired.count("Root/Body.done"), out.fired.count("Root/Count.again")), ("success", 1, 1))
        self.assertLess(math.dist(cube(out), PLACED), 0.005)
        return out

    def test_until_the_pallet_is_full(self):
        out = self.fill(self.NEXT)
        self.assertEqual(out.fired.count("Root/Body/Palletise.full"), 1)
        x, y, _ = PLACED
        self.assertLess(math.dist(out.last["cell"]["bodies"][NAMES["Box"]]["position"][:2], [x, y - 0.08]), 0.005)

    def test_or_until_there_is_no_part_more(self):
        out = self.fill()
        self.assertEqual((out.fired.count("Root/Body/PickAt.no_part"), out.fired.count("Root/Body/Palletise.full")), (1, 0))


if __name__ == "__main__":
    unittest.main()
