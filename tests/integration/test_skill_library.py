"""What the skills of the demo's documents say of themselves (api/skills.md), and that each is complete alone."""
import json
import re
import tempfile
import unittest
from pathlib import Path

import models
from cell import DEMO, read
from skills import DOCUMENT, LIBRARY, SKILLS
from test_commands import race

DEMONSTRATOR = read("demonstrator.rcm.json")
CATEGORIES = {"motion", "gripper", "vision", "people", "flow"}
DOMAINS = {"pose", "label", "labels", "found", "speed", "force", "distance", "duration", "count", "text", "sound", "colour", "direction"}
SUPPORT = {"Retry": ["again", "give_up"], "WhatNow": ["abort", "retry", "skip"], "Repeat": ["again", "done"]}
OUTCOMES = {"SearchObject": {"none"}, "AskPerson": {"no"}, "Palletise": {"full"}, "Count": {"reached"}}  # beside the nominal ones
OF_DEMONSTRATOR = {"SearchObject": {"abort", "by_hand", "clear"}, "HapticGesture": {"x_minus", "y_plus", "y_minus", "z_plus", "z_minus"}}
SENTENCE = "^[A-Z][^.]*\\.$"  # one, of several words
CODE = ("entry", "exit", "when", "do", "after", "from")


def elements(value):
    """All objects in a JSON value."""
    if isinstance(value, dict):
        yield value
        value = list(value.values())
    if isinstance(value, list):
        for item in value:
            yield from elements(item)


def linked(state, library):
    """The names of the library states that a state links, and that they link."""
    names = {each["link"] for each in elements(state) if "link" in each}
    return names.union(*(linked(library[name], library) for name in names))


def services(states):
    """The keys of the services that code names; a port with `after` needs the timer."""
    code = [each[key] for each in elements(states) for key in CODE if isinstance(each.get(key), str)]
    timer = {"timer"} if any("after" in each for each in elements(states)) else set()
    return {key for text in code for key in re.findall(r"\bsvc\.(\w+)", text)} | timer


def nominal(skill):
    outcomes = [port for port in skill["ports"] if "advice" not in port["meta"]]
    marked = [port for port in outcomes if port["meta"].get("nominal")] or [port for port in outcomes if port["name"] == "success"]
    return (marked or outcomes)[0]["name"]


def skills_of(document):
    return [state for state in document["library"] if state["meta"].get("skill")]


ALL = [(document, skill) for document in (DOCUMENT, DEMONSTRATOR) for skill in skills_of(document)]


class OfAllDocuments(unittest.TestCase):
    def test_a_skill_has_a_title_an_icon_a_category_and_a_description(self):
        titles = []
        self.assertEqual({document["name"] for document, _ in ALL}, {"skills", "demonstrator"})
        for _, skill in ALL:
            meta = skill["meta"]
            self.assertRegex(meta["icon"], "^[a-z]{2,12}$")
            self.assertIn(meta["category"], CATEGORIES)
            self.assertTrue(1 <= len(meta["title"]) <= 40 and skill["doc"].endswith("."))
            titles.append(meta["title"])
        self.assertEqual(sorted(titles), sorted(set(titles)))

    def test_parameters_are_described_and_their_values_are_in_range(self):
        for document, skill in ALL:
            for parameter in skill.get("parameters", []):
                meta, value, where = parameter["meta"], parameter.get("value"), (skill["state"], parameter["name"])
                if not meta.get("internal"):
                    self.assertTrue(meta["title"] and parameter["type"], where)
                    self.assertTrue(parameter.get("doc", "").endswith(".") or document is DEMONSTRATOR, where)
                self.assertIn(meta.get("domain", "text"), DOMAINS, where)
                if "min" in meta and not isinstance(value, list):
                    self.assertTrue(meta["min"] <= value <= meta["max"] and meta["step"] > 0, where)
                    steps = (value - meta["min"]) / meta["step"]
                    self.assertAlmostEqual(steps, round(steps), 6, where)
                if "choices" in meta:
                    self.assertIn(value, [choice["value"] for choice in meta["choices"]])
                    self.assertTrue(all(choice["title"] for choice in meta["choices"]))
                if isinstance(value, (int, float)) and not isinstance(value, bool):
                    self.assertTrue("min" in meta or "domain" not in meta, where)

    def test_a_skill_that_teaches_a_pose_is_marked_and_no_other_is(self):
        for document, skill in ALL:
            keeps = "svc.robot.record_pose" in json.dumps(skill) and "svc.db.add" in json.dumps(skill)
            for parameter in skill.get("parameters", []):
                meta, where = parameter["meta"], (document["name"], skill["state"], parameter["name"])
                self.assertEqual(meta.get("teaches", False), keeps and meta.get("domain") == "pose", where)

    def test_a_port_that_is_no_outcome_says_what_to_do(self):
        for document, skill in ALL:
            known = (OF_DEMONSTRATOR if document is DEMONSTRATOR else OUTCOMES).get(skill["state"], set()) | {nominal(skill)}
            self.assertTrue(known <= {port["name"] for port in skill["ports"]}, skill["state"])
            poses = [parameter for parameter in skill.get("parameters", []) if parameter["meta"].get("domain") == "pose"]
            for port in skill["ports"]:
                meta, where = port["meta"], (document["name"], skill["state"], port["name"])
                self.assertRegex(meta["title"], "^[A-Z].*[^.!]$", where)
                if port["name"] in known:
                    self.assertNotIn("advice", meta, where)
                    continue
                self.assertRegex(meta.get("advice", ""), SENTENCE, where)
                self.assertGreaterEqual(len(meta["advice"].split()), 2, where)
                self.assertFalse(re.search(r"\bpose\b", meta["advice"]) and not poses, where)  # it has none that could be chosen

    def test_what_to_do_is_no_title_of_an_error(self):
        for _, skill in ALL:
            errors = [port["meta"] for port in skill["ports"] if "advice" in port["meta"]]
            self.assertEqual(len({meta["title"] for meta in errors}), len(errors), skill["state"])
            self.assertFalse({meta["title"] for meta in errors} & {meta["advice"].rstrip(".") for meta in errors}, skill["state"])

    def test_a_skill_is_complete_with_what_it_links(self):
        for document, skill in ALL:
            library = {state["state"]: state for state in document["library"]}
            copied = [library[name] for name in sorted(linked(skill, library) | {skill["state"]})]
            own = {key: document["services"][key] for key in services(copied)}
            values = [{"name": p["name"], "value": "x"} for p in skill["parameters"] if "value" not in p] if "parameters" in skill else []
            root = {"state": "Root", "children": [{"state": "Step", "link": skill["state"], "parameters": values}], "first": "Step"}
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder, "copied.rcm.json")
                path.write_text(json.dumps(models.document("copied", root, library=copied, services=own)))
                status, output, errors = race("check", path)
            self.assertEqual((status, output, errors), (0, [], ""))

    def test_documents_are_as_fmt_writes_them(self):
        for name in ("skills", "demonstrator"):
            path = DEMO / f"{name}.rcm.json"
            self.assertEqual("\n".join(race("fmt", path)[1]) + "\n", path.read_text(), name)


class OfSkills(unittest.TestCase):
    def test_what_a_skill_needs_from_a_person_is_a_pose_at_most(self):
        for skill in SKILLS.values():
            missing = [parameter for parameter in skill.get("parameters", []) if "value" not in parameter]
            self.assertTrue(all(parameter["meta"]["domain"] == "pose" for parameter in missing), skill["state"])

    def test_each_can_say_what_went_wrong_and_its_outcomes_are_known(self):
        for name, skill in SKILLS.items():
            self.assertIn({"why": ""}, [{each["name"]: each.get("initial")} for each in skill["results"]], name)
            outcomes = {port["name"] for port in skill["ports"] if "advice" not in port["meta"]}
            self.assertEqual(outcomes - {nominal(skill)}, OUTCOMES.get(name, set()), name)

    def test_beside_skills_there_are_the_support_states(self):
        support = {name: sorted(port["name"] for port in state["ports"]) for name, state in LIBRARY.items() if state["meta"].get("support")}
        self.assertEqual(support, SUPPORT)
        self.assertGreaterEqual(len(SKILLS), 14)

    def test_all_that_is_in_the_library_is_linked_by_a_skill_or_is_offered(self):
        offered = {*SKILLS, *SUPPORT}
        used = set().union(*(linked(LIBRARY[name], LIBRARY) for name in offered))
        self.assertEqual(used | offered, set(LIBRARY))


if __name__ == "__main__":
    unittest.main()
