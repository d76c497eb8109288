"""The completion of bash and the manual page: both are made of the table of commands."""
import re
import subprocess
import unittest

import models
from accounts import PASSWORD, AccountServer
from client import PROGRAM, Server
from race_command import Person

# What bash does: COMP_WORDS has what is typed in pieces, at `:` and `=` too.
COMPLETE = """
eval "$("$1" completion bash)"
complete -p race
compopt() { echo "compopt $*"; }
shift
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_race
printf '%s\\n' "${COMPREPLY[@]}"
"""


class Bash(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()
        cls.addClassCleanup(cls.server.stop)
        for name in ("pick", "place"):
            cls.server.put(f"/documents/{name}", models.ticking(name))

    def setUp(self):
        self.person = Person(self, f"http://127.0.0.1:{self.server.port}")

    def complete(self, *words, url=None):
        """What bash offers for the last word; SERVER among the words is the option of the server, as bash takes it apart."""
        url = url or self.person.url
        parts = [part for word in words for part in (["--server", *re.split("(:)", url)] if word == "SERVER" else [word])]
        out = subprocess.run(["bash", "--norc", "-uc", COMPLETE, "bash", PROGRAM, PROGRAM, *parts], capture_output=True, text=True,
                             timeout=60, check=False, cwd=self.person.folder, env=self.person.environment())
        self.assertEqual((out.returncode, out.stderr), (0, ""))
        first, *offered = out.stdout.splitlines()
        self.assertEqual(first, "complete -F _race race")
        return [word for word in offered if word]

    def test_commands_options_and_values(self):
        self.assertEqual(self.complete("ru"), ["run", "runs"])
        self.assertEqual(self.complete("run", "--fa"), ["--fast"])
        self.assertEqual(self.complete("account", "add", "ada", "--role", "="), ["observer", "operator", "developer", "admin", "process"])
        self.assertEqual(self.complete("account", "add", "ada", "--role", "=", "ad"), ["admin"])
        self.assertEqual(self.complete("completion", ""), ["bash"])
        self.assertEqual(self.complete("dance", ""), [])

    def test_files_and_folders_are_those_of_bash(self):
        self.assertEqual(self.complete("check", "f"), ["compopt -o default"])
        self.assertEqual(self.complete("pull", "--into", ""), ["compopt -o dirnames"])

    def test_names_come_from_the_server(self):
        core = self.server.core(models.ticking(last=1))
        self.assertEqual(self.complete("start", "SERVER", "pl"), ["place"])
        self.assertEqual(self.complete("pull", "SERVER", "pick", "p"), ["pick", "place"])
        for command in ("trace", "stop"):
            self.assertIn(core, self.complete(command, "SERVER", ""))
        self.assertEqual(self.complete("call", "SERVER", "timer.w"), ["timer.wait"])

    def test_a_server_that_is_not_there_or_refuses_offers_nothing(self):
        self.assertEqual(self.complete("start", "SERVER", "", url="http://127.0.0.1:1"), [])
        self.assertEqual(self.complete("start", "SERVER", "", url="ftp://x"), [])
        with AccountServer() as server:
            url = f"http://127.0.0.1:{server.port}"
            server.put("/documents/secret", models.ticking("secret"))
            self.assertEqual(self.complete("start", "SERVER", "", url=url), [])
            self.person.done("login", "observer", text=PASSWORD + "\n", url=url)
            self.assertEqual(self.complete("start", "SERVER", "", url=url), ["secret"])

    def test_is_well_formed(self):
        script = subprocess.run([PROGRAM, "completion", "bash"], capture_output=True, text=True, check=True).stdout
        checked = subprocess.run(["shellcheck", "--shell", "bash", "-"], input=script, capture_output=True, text=True, check=False)
        self.assertEqual(checked.stdout, "")
        for words in (("completion", "fish"), ("completion", "bash", "x"), ("completion", "words")):
            self.assertEqual(subprocess.run([PROGRAM, *words], capture_output=True, check=False).returncode, 2)


class ManualPage(unittest.TestCase):
    REQUESTS = {".TH", ".SH", ".SS", ".TP", ".PP", ".B", ".I", ".RB", ".br"}

    @classmethod
    def setUpClass(cls):
        cls.text = subprocess.run([PROGRAM, "man"], capture_output=True, text=True, check=True).stdout

    def commands(self):
        overview = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout
        return re.findall(r"^  race (\S+)", overview, re.MULTILINE)

    def test_has_every_command_and_option(self):
        sections = re.split(r"^\.S[SH] ", self.text, flags=re.MULTILINE)
        by_command = {section.split("\n")[0].removeprefix("race "): section for section in sections}
        for command in self.commands():
            section = by_command[command].replace("\\-", "-")
            helped = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True).stdout
            for option in re.findall(r"^  (--\S+)", helped, re.MULTILINE):
                self.assertIn(f"\n.TP\n\\fB{option}", section)

    def test_is_of_requests_that_are_known(self):
        for line in self.text.splitlines():
            if line.startswith((".", "'")):
                self.assertIn(line.split(" ")[0], self.REQUESTS, line)
            self.assertNotRegex(line, r"(?<!\\)-", "a hyphen where a minus is meant")
            self.assertNotIn("`", line)
        self.assertTrue(self.text.startswith(".TH RACE 1 "))
        for section in ("NAME", "SYNOPSIS", "DESCRIPTION", "COMMANDS", "EXIT STATUS", "ENVIRONMENT", "FILES"):
            self.assertIn(f"\n.SH {section}\n", self.text)

    def test_is_fine_with_groff(self):
        out = subprocess.run(["groff", "-man", "-Tutf8", "-ww"], input=self.text, capture_output=True, text=True, check=False)
        self.assertEqual((out.returncode, out.stderr), (0, ""))
        self.assertIn("\n   race start\n", re.sub(r".\x08", "", out.stdout))  # a bold letter is one that is printed twice


if __name__ == "__main__":
    unittest.main()
