"""Exit codes of every command: 0 fine, 1 the run or check found something, 2 bad input; and what `-` reads."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import models
from client import PROGRAM, Server

WRONG = models.document("wrong", {"state": "Root", "first": "Nowhere"})
FILES = {
    "fine.rcm.json": json.dumps(models.ticking(last=1)),
    "faulty.rcm.json": json.dumps(models.faulty()),
    "wrong.rcm.json": json.dumps(WRONG),
    "many.rcm.json": json.dumps(models.document("many", {"state": "Root", "children": [{"state": "A", "first": "B"}] * 150})),
    "fine.rsm.json": json.dumps({"rsm": 1, "name": "tap", "events": [{"name": "drop"}]}),
    "wrong.rsm.json": json.dumps({"rsm": 1, "name": "tap", "events": [{"name": "drop"}, {"name": "drop"}]}),
    "script.json": json.dumps({"steps": [{}, {"events": [{"service": "timer", "event": "tick"}]}, {}]}),
    "operator.json": json.dumps({"operator": 1, "acts": []}),
    "fine.test.json": json.dumps({"race_test": 1, "tests": [{"name": "ticks", "expect": {"outcome": "done"}}]}),
    "failing.test.json": json.dumps({"race_test": 1, "model": "faulty.rcm.json",
                                      "tests": [{"name": "ends", "expect": {"status": "ended"}}]}),
    "wrong.test.json": json.dumps({"race_test": 1, "tests": []}),
    "no.json": "{",
}
NOWHERE = ("--server", "http://127.0.0.1:1")

# (code, command line): FINE, FAULTY and so on are documents of FILES, FOLDER holds them all and no data, DATA is the folder
# of a server that has ended, SERVER one that runs.
TABLE = (
    (0, ("--version",)), (0, ("--help",)), (2, ()), (2, ("dance",)), (2, ("--version", "more")), (2, ("help", "dance")),
    (0, ("check", "fine.rcm.json")), (0, ("check", "fine.rcm.json", "fine.rsm.json", "faulty.rcm.json")),
    (1, ("check", "wrong.rcm.json")), (1, ("check", "fine.rcm.json", "wrong.rcm.json")),
    (1, ("check", "fine.rcm.json", "wrong.rsm.json")), (1, ("check", "fine.rsm.json")),
    (2, ("check", "no.json")), (2, ("check", "none.json")), (2, ("check", "wrong.rcm.json", "none.json")), (2, ("check", ".")),
    (0, ("translate", "fine.rcm.json")), (2, ("translate", "wrong.rcm.json")), (2, ("translate", "none.json")),
    (0, ("fmt", "fine.rcm.json")), (2, ("fmt", "wrong.rcm.json")), (2, ("fmt", "no.json")), (2, ("fmt", "--write", "-")),
    (0, ("derive", "fine.rcm.json", "script.json")), (1, ("derive", "faulty.rcm.json", "script.json")),
    (2, ("derive", "wrong.rcm.json", "script.json")), (2, ("derive", "fine.rcm.json", "no.json")),
    (2, ("derive", "fine.rcm.json", "script.json", "--order", "x")),
    (0, ("run", "fine.rcm.json", "--fast")), (1, ("run", "faulty.rcm.json", "--fast")),
    (1, ("run", "fine.rcm.json", "--fast", "--arguments", '{"last": 1000000}', "--limit", "1")),
    (2, ("run", "wrong.rcm.json")), (2, ("run", "none.json")), (2, ("run", "fine.rcm.json", "--arguments", "[")),
    (2, ("run", "fine.rcm.json", "--operator", "no.json")), (2, ("run", "fine.rcm.json", "--operator", "operator.json")),
    (0, ("test", "fine.test.json")), (1, ("test", "fine.test.json", "failing.test.json")), (2, ("test", "wrong.test.json")),
    (2, ("test", "fine.test.json", "none.test.json")), (2, ("test", "no.json")), (2, ("test",)),
    (0, ("replay", "1", "--data", "DATA", "--hash")), (2, ("replay", "9", "--data", "DATA")), (2, ("replay", "no.json")),
    (2, ("replay", "none.json")), (2, ("replay", "1", "--data", "none")),
    (0, ("runs", "--data", "DATA")), (2, ("runs", "--data", "none")), (2, ("runs",)),
    (0, ("backup", "--data", "DATA")), (2, ("backup", "--data", "no-folder")), (2, ("backup", "--data", "DATA", "a", "b")),
    (2, ("restore", "--data", "DATA", "none")), (2, ("restore",)),
    (0, ("core", "list", "--server", "SERVER")), (1, ("core", "show", "9", "--server", "SERVER")),
    (2, ("core", "list", *NOWHERE)), (2, ("core", "dance")), (2, ("core", "list", "--server", "ftp://x")),
    (2, ("core", "list", "--server", "SERVER", "--ca", "ca.pem")), (2, ("boot", "list", "--server", "SERVER", "--ca", "ca.pem")),
    (0, ("boot", "list", "--server", "SERVER")), (1, ("boot", "remove", "a", "--server", "SERVER")), (2, ("boot", "list", *NOWHERE)),
    (0, ("mcp", "--server", "SERVER")), (0, ("mcp", *NOWHERE)), (2, ("mcp", "--server", "ftp://x")), (2, ("mcp", "--token-file", "none")),
    (2, ("mcp", "--server", "SERVER", "--ca", "ca.pem")),
    (0, ("account", "list", "--data", "accounts")), (2, ("account", "add", "ada", "--data", "accounts")), (2, ("account", "dance")),
    (2, ("account", "list", "--data", "SERVER_DATA")),
    (2, ("login", "ada", "--server", "SERVER")), (2, ("login", "ada", *NOWHERE)), (2, ("login", "--server", "SERVER")),
    (2, ("login", "ada", "--server", "http://192.0.2.1:80")), (1, ("logout", "--server", "SERVER")), (2, ("logout", "--server", "x")),
    (0, ("models", "--server", "SERVER")), (2, ("models", *NOWHERE)),
    (0, ("pull", "--into", "pulled", "--server", "SERVER")), (1, ("pull", "none", "--server", "SERVER")), (2, ("pull", *NOWHERE)),
    (2, ("pull", "a/b", "--server", "SERVER")), (2, ("pull", "--into", "fine.rcm.json", "--server", "SERVER")),
    (0, ("push", "--new", "fine.rcm.json", "--server", "SERVER")), (1, ("push", "faulty.rcm.json", "--server", "SERVER")),
    (0, ("push", "--new", "faulty.rcm.json", "--server", "SERVER")),
    (2, ("push", "no.json", "--server", "SERVER")), (2, ("push", "fine.rcm.json", *NOWHERE)), (2, ("push",)),
    (0, ("bundle", "fine", "--server", "SERVER")), (2, ("bundle", "fine", "--server", "SERVER")),
    (0, ("bundle", "fine", "--force", "--server", "SERVER")), (1, ("bundle", "none", "--server", "SERVER")),
    (2, ("bundle", "a/b", "--server", "SERVER")), (2, ("bundle", "fine", *NOWHERE)), (2, ("bundle",)),
    (0, ("install", "fine.bundle.json", "--as", "again", "--server", "SERVER")),
    (1, ("install", "fine.bundle.json", "--as", "again", "--server", "SERVER")),
    (0, ("install", "fine.bundle.json", "--as", "again", "--replace", "--server", "SERVER")),
    (1, ("install", "fine.rcm.json", "--server", "SERVER")), (2, ("install", "no.json", "--server", "SERVER")),
    (2, ("install", "none.json", "--server", "SERVER")), (2, ("install", "fine.rcm.json", *NOWHERE)), (2, ("install",)),
    (0, ("start", "fine", "--server", "SERVER")), (0, ("start", "fine", "--wait", "--server", "SERVER")),
    (1, ("start", "faulty", "--wait", "--server", "SERVER")), (1, ("start", "none", "--server", "SERVER")), (2, ("start", "a", *NOWHERE)),
    (2, ("start", "a", "--arguments", "[]", "--server", "SERVER")), (1, ("stop", "9", "--server", "SERVER")), (2, ("stop", "9", *NOWHERE)),
    (2, ("stop",)), (2, ("stop", "9", "--cell")), (2, ("stop", "--cell", *NOWHERE)),
    (0, ("services", "--server", "SERVER")), (2, ("services", *NOWHERE)), (2, ("call", "timer", *NOWHERE)),
    (0, ("call", "timer.wait", "seconds=0", "--server", "SERVER")), (1, ("call", "timer.wait", "seconds=-1", "--server", "SERVER")),
    (1, ("call", "none.wait", "--server", "SERVER")), (2, ("call", "timer.wait", "0", "--server", "SERVER")),
    (0, ("trace", "2", "--server", "SERVER")), (1, ("trace", "3", "--server", "SERVER")), (1, ("trace", "99", "--server", "SERVER")),
    (0, ("trace", "--run", "2", "--server", "SERVER")), (2, ("trace", "1", *NOWHERE)), (2, ("trace",)), (2, ("trace", "1", "--run", "1")),
    (0, ("log", "--server", "SERVER")), (2, ("log", *NOWHERE)),
    (0, ("completion", "bash")), (2, ("completion", "fish")), (0, ("completion", "words", "--", "")), (0, ("man",)), (2, ("man", "x")),
    (2, ("service", "oven", *NOWHERE)), (2, ("service", "database")), (2, ("service", "database", "--server", "ftp://x")),
    (2, ("serve", "--remote", "oven")), (2, ("serve", "--data", "/proc/no")), (2, ("serve", "--operator", "no.json")),
)
COMMANDS = ("serve", "service", "run", "test", "runs", "replay", "backup", "restore", "core", "boot", "account", "login", "logout",
            "models", "pull", "push", "bundle", "install", "start", "stop", "services", "call", "trace", "log", "completion", "mcp",
            "derive", "check", "translate", "fmt", "man")
# What a command needs at least.
WORDS = {"service": ("database", *NOWHERE), "run": ("fine.rcm.json",), "test": ("fine.test.json",), "replay": ("no.json",),
         "runs": ("--data", "none"),
         "restore": ("none",), "core": ("list",), "boot": ("list",),
         "account": ("list", "--data", "accounts"), "derive": ("fine.rcm.json", "script.json"),
         "check": ("fine.rcm.json",), "translate": ("fine.rcm.json",), "fmt": ("fine.rcm.json",),
         "login": ("ada", *NOWHERE), "logout": NOWHERE,
         "models": NOWHERE, "pull": NOWHERE, "push": ("fine.rcm.json", *NOWHERE), "bundle": ("fine", *NOWHERE),
         "install": ("fine.rcm.json", *NOWHERE), "start": ("a", *NOWHERE), "stop": ("1", *NOWHERE),
         "services": NOWHERE, "call": ("timer.wait", *NOWHERE), "trace": ("1", *NOWHERE), "log": NOWHERE,
         "completion": ("fish",)}


class CommandCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        held = tempfile.TemporaryDirectory()
        cls.addClassCleanup(held.cleanup)
        cls.folder = held.name
        for name, text in FILES.items():
            Path(cls.folder, name).write_text(text)
        with Server(data=f"{cls.folder}/data") as server:
            server.ended(server.core(models.ticking("kept", last=1)))
        cls.server = Server()
        cls.addClassCleanup(cls.server.stop)

    def race(self, *words, text=""):
        """(status, stdout, stderr), in the folder of FILES, with `text` as standard input."""
        places = {"DATA": f"{self.folder}/data", "SERVER": f"http://127.0.0.1:{self.server.port}",
                  "SERVER_DATA": self.server.data}
        out = subprocess.run([PROGRAM, *(places.get(word, word) for word in words)], input=text, capture_output=True, text=True,
                             timeout=60, check=False, cwd=self.folder)
        return out.returncode, out.stdout, out.stderr


class Codes(CommandCase):
    def test_are_those_of_the_table(self):
        for code, words in TABLE:
            with self.subTest(words=words):
                status, _, errors = self.race(*words)
                self.assertEqual(status, code, errors)
                if code == 2:
                    self.assertTrue(errors)
        self.assertEqual({words[0] for _, words in TABLE if words} & set(COMMANDS), set(COMMANDS))

    def test_every_command_refuses_what_it_does_not_know(self):
        for command in COMMANDS:
            words = (command, *WORDS.get(command, ()))
            for wrong, said in ((("--no-such-thing",), "--no-such-thing: unknown_field: "), (("--hepl",), "did you mean `--help`?")):
                status, output, errors = self.race(*words, *wrong)
                self.assertEqual((status, output), (2, ""), words)
                self.assertIn(said, errors)
        for command in ("serve", "service", "run", "runs", "replay", "mcp", "derive", "translate"):
            status, _, errors = self.race(command, *WORDS.get(command, ()), "one-more")
            self.assertEqual((status, errors.splitlines()[0]), (2, "one-more: syntax: is a word too many"), command)
        for command in ("service", "run", "test", "replay", "restore", "core", "boot", "account", "derive", "check", "translate", "fmt"):
            status, _, errors = self.race(command)
            self.assertEqual(status, 2)
            self.assertRegex(errors, r"\A[A-Z]+: missing: ")
        for command, option in (("serve", "--port"), ("run", "--seed"), ("core", "--server"), ("backup", "--data"), ("derive", "--order")):
            status, _, errors = self.race(command, *WORDS.get(command, ()), option)
            self.assertEqual((status, errors.splitlines()[0]), (2, f"{option}: missing: the option needs a value"))

    def test_a_misspelled_word_is_answered_with_the_one_that_is_meant(self):
        for words, meant in ((("chekc",), "check"), (("serve", "--prot", "1"), "--port"), (("serve", "--heart=2"), "--heartbeat"),
                             (("run", "fine.rcm.json", "--sed", "1"), "--seed"), (("--verison",), "--version")):
            status, _, errors = self.race(*words)
            self.assertEqual(status, 2)
            self.assertIn(f"; did you mean `{meant}`?", errors)
        self.assertNotIn("did you mean", self.race("run", "--x")[2])

    def test_what_is_wrong_in_a_file_is_named_with_the_file(self):
        for words, file in ((("check", "fine.rcm.json", "wrong.rcm.json"), "wrong.rcm.json"), (("run", "wrong.rcm.json"), "wrong.rcm.json"),
                            (("translate", "wrong.rcm.json"), "wrong.rcm.json"),
                            (("fmt", "fine.rcm.json", "wrong.rcm.json"), "wrong.rcm.json"),
                            (("derive", "wrong.rcm.json", "script.json"), "wrong.rcm.json")):
            self.assertRegex(self.race(*words)[2], rf"(?m)^{file}: Root: first: ")
        for words in (("check", "no.json"), ("fmt", "no.json"), ("run", "no.json"), ("derive", "fine.rcm.json", "no.json"),
                      ("replay", "no.json"), ("serve", "--operator", "no.json"), ("run", "fine.rcm.json", "--operator", "no.json")):
            self.assertTrue(self.race(*words)[2].startswith("no.json: json: "), words)
        for words in (("check", "none"), ("fmt", "none"), ("run", "none"), ("derive", "none", "script.json"), ("replay", "none"),
                      ("translate", "none")):
            self.assertEqual(self.race(*words)[2], "none: io: cannot be read: No such file or directory\n")

    def test_check_lists_each_file_with_its_errors(self):
        status, output, errors = self.race("check", "--json", "wrong.rcm.json", "fine.rcm.json", "wrong.rsm.json", "none")
        files = json.loads(output)["files"]
        self.assertEqual((status, [(each["file"], [(e["path"], e["code"]) for e in each["errors"]]) for each in files]), (2, [
            ("wrong.rcm.json", [("Root", "first")]), ("fine.rcm.json", []), ("wrong.rsm.json", [("", "duplicate")]),
            ("none", [("", "io")])]))
        self.assertEqual([line.split(": ")[0] for line in errors.splitlines()], ["wrong.rcm.json", "wrong.rsm.json", "none"])
        status, output, errors = self.race("check", "--json", "many.rcm.json", "wrong.rcm.json")
        many, wrong = json.loads(output)["files"]
        self.assertEqual((status, len(many["errors"]), many["more_errors"], "more_errors" in wrong), (1, 200, True, False))
        lines = errors.splitlines()
        self.assertEqual((len(lines), lines[200]), (202, "many.rcm.json: there are more errors, which are not listed"))
        status, output, _ = self.race("run", "--json", "wrong.rcm.json")
        [error] = json.loads(output)["errors"]
        self.assertEqual((status, error["file"], error["path"], error["code"]), (2, "wrong.rcm.json", "Root", "first"))


class Unreadable(CommandCase):
    """Whatever stands in the place of a file: a line says which and why, and the status is 2."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name in ("cell.json", "scene.json", "parts.json", "database.json"):  # as folders, pipes, and what fails to be read
            for kind in ("folder", "pipe", "broken"):
                path = Path(cls.folder, f"{kind}-{name}", name)
                path.parent.mkdir()
                if kind == "folder":
                    path.mkdir()
                elif kind == "pipe":
                    os.mkfifo(path)
                else:
                    path.symlink_to("/proc/self/mem")  # reading it is EIO

    def test_files_of_the_command_line(self):
        for file, why in ((".", "Is a directory"), ("/proc/self/mem", "Input/output error"), ("none", "No such file or directory"),
                          (300 * "x", "File name too long"), ("fine.rcm.json/x", "Not a directory")):
            for words in (("check", file), ("check", "fine.rcm.json", file), ("fmt", file), ("fmt", "--write", file),
                          ("translate", file), ("derive", file, "script.json"), ("derive", "fine.rcm.json", file), ("run", file),
                          ("run", "fine.rcm.json", "--fast", "--operator", file), ("replay", file), ("serve", "--operator", file),
                          ("serve", "--config", file)):
                with self.subTest(words=words):
                    self.assertEqual(self.race(*words)[::2], (2, f"{file}: io: cannot be read: {why}\n"))

    def test_files_of_a_cell(self):
        for folder in sorted(path for path in Path(self.folder).iterdir() if path.is_dir() and "-" in path.name):
            name = folder.name.partition("-")[2]
            if name == "parts.json":  # is read for a camera alone
                continue
            for words in (("run", "fine.rcm.json", "--fast", "--cell", folder),
                          ("serve", "--port", "0", "--data", f"{self.folder}/cell", "--demo", folder)):
                with self.subTest(words=words):
                    status, _, errors = self.race(*map(str, words))
                    self.assertEqual((status, errors.count("\n")), (2, 1), errors)
                    self.assertIn(f"{folder.name}/{name}: io: ", errors)


class StandardInput(CommandCase):
    def test_stands_for_any_file(self):
        for file, words in (("fine.rcm.json", ("check", "-")), ("fine.rsm.json", ("check", "fine.rcm.json", "-")),
                            ("fine.rcm.json", ("fmt", "-")), ("fine.rcm.json", ("translate", "-")),
                            ("fine.rcm.json", ("run", "-", "--fast")),
                            ("fine.rcm.json", ("derive", "-", "script.json")), ("script.json", ("derive", "fine.rcm.json", "-")),
                            ("wrong.rcm.json", ("check", "-"))):
            named = tuple(file if word == "-" else word for word in words)
            status, output, errors = self.race(*named)
            self.assertEqual(self.race(*words, text=FILES[file]), (status, output, errors.replace(f"{file}: ", "-: ")), words)
        journal = self.server.get(f"/cores/{self.server.core(models.ticking('piped', last=1))}/journal")
        self.assertEqual(self.race("replay", "-", "--hash", text=json.dumps(journal))[0], 0)
        self.assertIn("-: json: ", self.race("run", "fine.rcm.json", "--operator", "-", text="{")[2])

    def test_is_read_once(self):
        for words, second in ((("check", "-", "-"), "FILE"), (("derive", "-", "-"), "SCRIPT"), (("fmt", "-", "a", "-"), "MODEL"),
                              (("run", "-", "--operator", "-"), "--operator")):
            status, _, errors = self.race(*words)
            self.assertEqual((status, errors.split(": ")[:2]), (2, [second, "duplicate"]))

    def test_is_bounded(self):
        for words in (("check", "-"), ("check", "/dev/zero"), ("replay", "-")):
            with open("/dev/zero", "rb") as endless:
                out = subprocess.run([PROGRAM, *words], stdin=endless, capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual((out.returncode, out.stderr.split(": ")[:2]), (2, [words[-1], "too_large"]))



if __name__ == "__main__":
    unittest.main()
