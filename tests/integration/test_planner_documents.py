"""What the example planner reads and writes without a server: skills, documents in the form of api/skills.md, and how it mends them."""
import dataclasses
import json
import sys
import unittest
from pathlib import Path

import planners
from planner_models import HERE, LIBRARY, MOVES, SKILLS, whole
from played_server import PlayedServer
from skills import DOCUMENT

from planner import repair, tasks
from planner.compose import document_of
from planner.goal import GRID
from planner.refusal import Refused
from planner.search import Move
from planner.skills import Skill, is_planned, read_skills, services_in


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
        self.assertEqual(Skill({"state": "Fails", "ports": ports[1:2]}, {}, {}).nominal, "success")
        state = {"entry": "svc.a.b()", "meta": {"do": "svc.c.d()"}, "children": [{"ports": [{"when": "svc.e.f"}]}]}
        self.assertEqual(services_in(state), {"a", "e"})

    def test_the_closure_is_all_that_is_linked(self):
        found = SKILLS["PickFound"].closure()
        self.assertTrue({"PickFound", "Grab", "MoveTool", "RiseTo"} <= found.keys())
        self.assertTrue(all(link in found for state in found.values() for link in json.dumps(state).split('"link": "')[1:]
                            for link in [link.partition('"')[0]]))


    def test_are_those_of_the_document_that_has_the_most_but_for_what_was_planned(self):
        server = PlayedServer({})
        few = {"library": [{**LIBRARY["MoveTo"], "doc": "another one"}], "root": {"state": "R"}}
        planned = document_of(whole(Compose.DRAFTS[0]), SKILLS)
        server.stored = {"few": [few], **server.stored, "planned": [{**planned, "library": [*LIBRARY.values(), *few["library"]]}]}
        self.assertEqual(read_skills(server), SKILLS)
        self.assertEqual([is_planned(each) for each in (planned, DOCUMENT, few, {}, {"root": 1}, {"root": {"meta": 1}})],
                         [True, False, False, False, False, False])


class Compose(unittest.TestCase):
    """The form of api/skills.md, as web/shared/timeline reads it."""

    DRAFTS = (tasks.sorting("sorting", MOVES, 1.0), tasks.going_aside("sorting", 1.0), tasks.calibrating("sorting", 1.0),
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
        poses = tasks.poses_of(MOVES, {"Cube": 0.04, "Box": 0.015}, {"pose": {}, "q": [0.0] * 7})
        self.assertEqual({name: pose["pose"]["position"] for name, pose in poses.items()},
                         {"pose_plan_1_A1_Cube": [*GRID["A1"], 0.042], "pose_plan_2_B2_Box": [*GRID["B2"], 0.022]})

    def test_names_are_those_of_states_and_poses_whatever_parts_are_called(self):
        label = "M8 nut, größer als die anderen"
        odd = [Move(f"{label} {i}", f"where {label} was", GRID["B2"], held=False) for i in range(2)]
        for move in odd:
            self.assertRegex(tasks.task_of(1, move, 1.0).name, r"^[A-Za-z_][A-Za-z0-9_]*$")
            self.assertRegex(tasks.pose_name(12, move), r"^[A-Za-z0-9_-]{1,32}$")
        self.assertEqual(len(tasks.poses_of(odd, dict.fromkeys((move.label for move in odd), 0.02), {"q": []})), 2, "each move has its own")

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


class Package(unittest.TestCase):
    def test_it_uses_the_client_library_and_pythons_own_alone(self):
        for path in Path(planners.EXAMPLES, "planner").glob("*.py"):
            for line in path.read_text().splitlines():
                if line.startswith(("import ", "from ")):
                    name = line.split()[1].split(".")[0]
                    self.assertIn(name, {"", "race_client", *sys.stdlib_module_names}, f"{path.name}: {line}")


if __name__ == "__main__":
    unittest.main()
