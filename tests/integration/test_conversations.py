"""api/conversations, held against openapi.yaml and asyncapi.yaml: what a step says can be said; what patterns mean. Without a server."""
import json
import re
import unittest

import jsonschema
import yaml

from conversation_values import API, FOLDER, Values, mismatch
from conversations import ROUTES, all_conversations
from interface import INTERFACE
from python_clients import race_client

ASYNC_INTERFACE = yaml.safe_load((API / "asyncapi.yaml").read_text())
STEPS = [(conversation["title"], step) for _, conversation in all_conversations() for step in conversation["steps"]]
CALLS = [(title, step, ROUTES.get(step["call"])) for title, step in STEPS if "call" in step]


def values_in(value):
    """All that is within a value."""
    yield value
    for each in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from values_in(each)


class Form(unittest.TestCase):
    def test_every_file_is_of_the_schema(self):
        schema = json.loads((FOLDER / "format/conversations.schema.json").read_text())
        for path in FOLDER.glob("*.json"):
            with self.subTest(path.name):
                jsonschema.Draft202012Validator(schema).validate(json.loads(path.read_text()))

    def test_titles_are_different(self):
        titles = [conversation["title"] for _, conversation in all_conversations()]
        self.assertEqual(sorted(titles), sorted(set(titles)))

    def test_names_were_given_before(self):
        for _, conversation in all_conversations():
            known = set()
            for step in conversation["steps"]:
                used = {each[1:] for each in values_in({key: value for key, value in step.items() if key != "save"})
                        if isinstance(each, str) and each.startswith("$")}
                for name in used - known - step.get("let", {}).keys():
                    self.assertTrue(Values()[name], f"{name} of {conversation['title']}")
                known |= {*step.get("let", {}), *step.get("save", {})}

    def test_patterns_mean_what_the_examples_say(self):
        examples = json.loads((FOLDER / "format/patterns.json").read_text())
        self.assertGreater(len(examples["patterns"]), 40)
        for pattern, value, fits in examples["patterns"]:
            with self.subTest(pattern=pattern, value=value):
                self.assertEqual(mismatch(pattern, value, examples["saved"]) is None, fits)


class Contract(unittest.TestCase):
    def test_every_operation_is_in_a_conversation(self):
        called = {step["call"] for _, step, _ in CALLS}
        self.assertEqual(called - ROUTES.keys(), set(), "openapi.yaml has no such operations")
        self.assertEqual(ROUTES.keys() - called, set(), "no conversation calls these")

    def test_what_a_call_sends_is_of_its_operation(self):
        for title, step, route in CALLS:
            with self.subTest(title, call=step["call"]):
                self.assertEqual([*step.get("path", {})], [each["name"] for each in route.parameters["path"]])
                self.assertEqual("body" in step, route.body is not None)
                self.assertFalse(route.body_required and step["body"] is None, "it needs a body")
                for where, name in (("query", "query"), ("header", "headers")):
                    given, known = step.get(name, {}).keys(), {each["name"]: each for each in route.parameters[where]}
                    self.assertLessEqual(given, known.keys())
                    if "refused" not in step:
                        self.assertLessEqual({each for each, parameter in known.items() if parameter.get("required")}, given)

    def test_what_refuses_a_call_is_listed(self):
        for title, step, route in CALLS:
            if "refused" in step:
                with self.subTest(title, call=step["call"]):
                    refused = step["refused"]
                    codes = INTERFACE["x-request-filter"].get(str(refused["status"]), [])
                    self.assertTrue(str(refused["status"]) in route.operation["responses"] or refused.get("code") in codes)

    def test_methods_are_of_the_client(self):
        with race_client.Client() as race:
            for title, step in STEPS:
                if "ask" in step:
                    group, _, method = step["ask"].rpartition(".")
                    self.assertTrue(callable(getattr(getattr(race, group) if group else race, method)), title)

    def test_what_is_followed_is_a_channel_of_the_stream(self):
        """Its updates are the two messages of it."""
        messages = ASYNC_INTERFACE["channels"]["stream"]["messages"]
        of_state = {name for name, message in messages.items() if message.get("x-channel") == "core/{id}/state"}
        self.assertEqual({re.search("Snapshot|Delta", name)[0].lower() for name in of_state}, {"snapshot", "delta"})
        kinds = {each["kind"] for _, step in STEPS for each in values_in(step.get("answer")) if isinstance(each, dict) and "next" in step
                 and "kind" in each}
        self.assertLessEqual(kinds, {"snapshot", "delta", "disconnected", "connected"})


if __name__ == "__main__":
    unittest.main()
