"""The conversations of api/conversations, held by the C++ client library (a program of tests/client_cpp); and the example of its README."""
import os
import re
import subprocess
import unittest

from client import PROJECT, TIMEOUT, Server
from conversations import SERVERS, all_conversations

FOLDER = PROJECT / "build/release/tests/client_cpp"
CONVERSATIONS = os.environ.get("RACE_CONVERSATIONS", str(FOLDER / "race_conversations"))
README = os.environ.get("RACE_CLIENT_README", str(FOLDER / "race_client_readme"))


def run(*command):
    """Status and output of a program."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=6 * TIMEOUT, check=False)
    return done.returncode, done.stdout


def conversation_test(file, conversation):
    """A test that holds a conversation."""
    def test(self):
        server = SERVERS[conversation.get("server", "plain")]()
        self.addCleanup(server.stop)
        tokens = [f"{account}={token}" for account, token in getattr(server, "tokens", {}).items()]
        said = run(CONVERSATIONS, f"http://127.0.0.1:{server.port}", f"{file}.json", conversation["title"], *tokens)
        self.assertEqual(said, (0, ""))

    return test


def conversation_cases():
    """A class for each file, with a test for each of its conversations, by names that nothing else has."""
    cases = {}
    for file, each in all_conversations():
        name = f"{file.capitalize()}_cpp"
        case = cases.setdefault(name, type(name, (unittest.TestCase,), {"__module__": __name__}))
        setattr(case, f"test_{each['title'].replace(' ', '_')}", conversation_test(file, each))
    return cases


globals().update(conversation_cases())


class Cpp(unittest.TestCase):
    def test_examples_of_patterns_hold(self):
        self.assertEqual(run(CONVERSATIONS), (0, ""))

    def test_the_example_of_the_readme_prints_what_it_says(self):
        blocks = re.findall(r"^```(\w+)\n(.*?)^```$", (PROJECT / "api/cpp/client/README.md").read_text(), re.MULTILINE | re.DOTALL)
        self.assertEqual([kind for kind, _ in blocks], ["cpp", "text"])
        self.assertEqual(blocks[0][1], (PROJECT / "tests/client_cpp/readme.cpp").read_text())
        with Server() as server:
            self.assertEqual(run(README, f"http://127.0.0.1:{server.port}"), (0, blocks[1][1]))


if __name__ == "__main__":
    unittest.main()
