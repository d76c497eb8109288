"""api/tutorial.md, followed literally: its commands, in its order, do and print what the page says. Only the port is another one."""
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from client import PROGRAM, PROJECT, TIMEOUT

PAGE = PROJECT / "api/tutorial.md"
FENCE = "```"
OWN_TERMINAL, SAVE = "In a terminal of its own:", re.compile(r"Save this as `([^`]+)`:")


def blocks():
    """(the line before, kind, text) of each block; of one that follows another at once, the line is its fence."""
    before, kind, lines = "", None, []
    for line in PAGE.read_text().splitlines():
        if kind is None and line.startswith(FENCE):
            kind, lines = line.removeprefix(FENCE), []
        elif kind is None:
            before = line or before
        elif line == FENCE:
            yield before, kind, "\n".join(lines) + "\n"
            before, kind = FENCE, None
        else:
            lines.append(line)


class Reader:
    """Somebody who follows the page in a folder that looks like a checkout."""

    def __init__(self, case):
        held = tempfile.TemporaryDirectory()
        case.addCleanup(held.cleanup)
        self.folder = Path(held.name)
        (self.folder / "build/release").mkdir(parents=True)
        (self.folder / "build/release/race").symlink_to(Path(PROGRAM).resolve())
        for name in ("api", "deploy"):
            (self.folder / name).symlink_to(PROJECT / name)
        self.case, self.terminals, self.server, self.read = case, [], None, 0
        variables = {name: value for name, value in os.environ.items() if not name.startswith(("RACE_", "PYTHON"))}
        self.environment = {**variables, "PATH": "/usr/bin:/bin", "PYTHONDONTWRITEBYTECODE": "1",
                            "XDG_STATE_HOME": str(self.folder / "state")}

    def with_port(self, command):
        """The command for the server of this test."""
        if " serve " in command:
            return f"{command} --port 0"
        return re.sub(r"(race (?:services|call|push|start)|python3)( [^|\n]*)", rf"\1\2 --server {self.server} ", command)

    def in_own_terminal(self, command):
        """A command that goes on; what it prints is in a file."""
        output = self.folder / f"terminal{len(self.terminals)}"
        with open(output, "w") as file:
            terminal = subprocess.Popen(["bash", "-c", self.with_port(command)], cwd=self.folder, env=self.environment,
                                        stdin=subprocess.DEVNULL, stdout=file, stderr=file, start_new_session=True)
        self.case.addCleanup(self.end, terminal)
        self.terminals.append(output)
        self.read = 0
        if self.server is None:
            self.server = self.wait_for(r"listens on (http://\S+)").group(1)

    def end(self, terminal):
        """Ctrl-C."""
        os.killpg(terminal.pid, signal.SIGINT)
        try:
            terminal.wait(TIMEOUT)
        except subprocess.TimeoutExpired:
            os.killpg(terminal.pid, signal.SIGKILL)
            terminal.wait()

    def done(self, command):
        """What a command prints that ends."""
        out = subprocess.run(["bash", "-c", self.with_port(command)], cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL,
                             capture_output=True, text=True, timeout=3 * TIMEOUT, check=False)
        self.case.assertEqual(out.returncode, 0, (command, out.stdout, out.stderr))
        return out.stdout

    def wait_for(self, pattern):
        """Until the newest terminal shows it, below what was waited for before."""
        end = time.monotonic() + TIMEOUT
        while not (found := re.compile(pattern).search(self.terminals[-1].read_text(), self.read)):
            self.case.assertLess(time.monotonic(), end, f"no {pattern} in: {self.terminals[-1].read_text()}")
            time.sleep(0.05)
        self.read = found.end()
        return found


class Tutorial(unittest.TestCase):
    def test_what_the_page_says_happens(self):
        reader, said, has_printed, steps = Reader(self), "", False, 0
        for before, kind, text in blocks():
            with self.subTest(text):
                steps += 1
                if kind == "json":
                    (reader.folder / SAVE.search(before).group(1)).write_text(text)
                elif kind == "sh" and before == OWN_TERMINAL:
                    reader.in_own_terminal(text.strip())
                    has_printed = False
                elif kind == "sh":
                    said, has_printed = reader.done(text.strip()), True
                elif before == FENCE and has_printed:
                    self.assertEqual(said, text)
                else:  # of the terminal; calls are numbered over all services
                    reader.wait_for(re.sub(r"call \d+", r"call \\d+", re.escape(text.strip()).replace(r"\ ", " ")))
        self.assertGreater(steps, 12)

    def test_the_template_has_less_than_30_lines(self):
        self.assertLess(len((PROJECT / "api/templates/gripper_python/gripper.py").read_text().splitlines()), 30)


if __name__ == "__main__":
    unittest.main()
