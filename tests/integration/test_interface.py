"""api/asyncapi.yaml has every message of the WebSockets once, in its direction, and every channel of the stream. No server is needed."""
import json
import re
import unittest

import yaml

from interface import API

ASYNC = yaml.safe_load((API / "asyncapi.yaml").read_text())
STREAM = ASYNC["channels"]["stream"]["messages"]


def channel_names():
    """The patterns of the server, such as core/{id}/state."""
    return set(re.findall(r'Channel = "([^"]+)";', (API.parent / "server/wire/channel_names.h").read_text()))


def schema_of(reference):
    """What `schemas/FILE#/$defs/NAME` means."""
    file, name = reference.split("#/$defs/")
    return json.loads((API / file).read_text())["$defs"][name]


def reference_of(message):
    return message["payload"]["schema"]["$ref"]


def messages_of(action, channel):
    """References of all messages that operations send or receive on a connection."""
    pointers = [message["$ref"].split("/") for operation in ASYNC["operations"].values()
                if operation["action"] == action and operation["channel"]["$ref"] == f"#/channels/{channel}"
                for message in operation["messages"]]
    return sorted(reference_of(ASYNC["channels"][pointer[2]]["messages"][pointer[4]]) for pointer in pointers)


class Messages(unittest.TestCase):
    def test_each_is_sent_or_received_by_one_operation(self):
        for file, action, channel in (("stream_request", "receive", "stream"), ("stream_message", "send", "stream"),
                                      ("component_request", "receive", "components"),
                                      ("component_message", "send", "components")):
            with self.subTest(file):
                alternatives = json.loads((API / f"schemas/{file}.json").read_text())["oneOf"]
                self.assertEqual(messages_of(action, channel),
                                 sorted(f"schemas/{file}.json{each['$ref']}" for each in alternatives))

    def test_are_named_as_their_schemas(self):
        for channel in ASYNC["channels"].values():
            for name, message in channel["messages"].items():
                words = reference_of(message).split("/")[-1].split("_")
                self.assertEqual(name, words[0] + "".join(map(str.capitalize, words[1:])))


class Channels(unittest.TestCase):
    def test_are_those_of_the_server(self):
        self.assertEqual({message["x-channel"] for message in STREAM.values() if "x-channel" in message}, channel_names())

    def test_are_those_of_the_schemas(self):
        wanted = schema_of("schemas/stream_request.json#/$defs/channel")["pattern"]
        for name, message in STREAM.items():
            if "x-channel" not in message:
                continue
            with self.subTest(name):
                example = re.sub(r"{\w+}", "a", message["x-channel"])
                channel = schema_of(reference_of(message))["properties"]["channel"]
                self.assertRegex(example, channel.get("pattern", f"^{channel.get('const')}$"))
                self.assertRegex(example, wanted)


if __name__ == "__main__":
    unittest.main()
