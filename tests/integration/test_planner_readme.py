"""The how-to of api/examples/planner/README.md: its commands, run in a folder that has what a checkout has, say what the page says."""
import contextlib
import os
import re
import shlex
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import planners
from client import PROGRAM, PROJECT, TIMEOUT

COMMANDS = re.findall(r"^    (\S.*)$", planners.README, re.MULTILINE)
GOAL = re.search(r"^```json\n(.*?)^```$", planners.README, re.MULTILINE | re.DOTALL).group(1)
SAID = re.findall(r"^```text\n(.*?)^```$", planners.README, re.MULTILINE | re.DOTALL)
NUMBER = r"-?\d+\.\d+"


@contextlib.contextmanager
def checkout():
    """A folder as the project's after the build: nothing of it but what the page names, and no data."""
    with tempfile.TemporaryDirectory(prefix="race-test-") as name:
        for folder in ("api", "deploy"):
            Path(name, folder).symlink_to(PROJECT / folder)
        Path(name, "build/release").mkdir(parents=True)
        Path(name, "build/release/race").symlink_to(os.path.abspath(PROGRAM))
        yield Path(name)


@contextlib.contextmanager
def served(command, folder):
    """The port of a server that is started so, but on a free port."""
    with subprocess.Popen([*shlex.split(command), "--port", "0"], cwd=folder, stdout=subprocess.PIPE, text=True) as process:
        try:
            yield re.search(r":(\d+)$", process.stdout.readline().strip()).group(1)
        finally:
            process.terminate()
            try:
                process.wait(TIMEOUT)
            finally:
                process.kill()


@contextlib.contextmanager
def answering(command, folder, port):
    """A command of the page that goes on, once it is connected; the file has what it says."""
    setting, *words = shlex.split(command)
    said = Path(folder, "terminal")
    with open(said, "w") as file, subprocess.Popen([*words, "--server", f"http://127.0.0.1:{port}"], cwd=folder, stdout=file, stderr=file,
                                                   env={**planners.ENVIRONMENT, **dict([setting.split("=", 1)])}) as process:
        try:
            end = time.monotonic() + TIMEOUT
            while "connected" not in said.read_text():
                assert time.monotonic() < end and process.poll() is None, said.read_text()
                time.sleep(0.05)
            yield said
            process.send_signal(signal.SIGINT)
            assert process.wait(TIMEOUT) == 0, said.read_text()
        finally:
            process.kill()


def run(command, folder, port):
    """(exit code, what it says) of a command of the page, at the server on this port."""
    line = f"{command} --server http://127.0.0.1:{port}"
    done = subprocess.run(line, shell=True, cwd=folder, env=planners.ENVIRONMENT, capture_output=True, text=True, timeout=240, check=False)
    return done.returncode, done.stdout + done.stderr


class Readme(unittest.TestCase):
    def assert_says(self, said, page):
        """The page leaves out what its `...` stands for; lengths differ by 0.02 m at most."""
        token = lambda text: ".*" if text == "..." else f"({NUMBER})" if re.fullmatch(NUMBER, text) else re.escape(text)
        match = re.fullmatch("".join(map(token, re.split(rf"(\.\.\.|{NUMBER})", page))), said, re.DOTALL)
        self.assertIsNotNone(match, f"{said}\nis not\n{page}")
        for number, expected in zip(match.groups(), re.findall(NUMBER, page), strict=True):
            self.assertAlmostEqual(float(number), float(expected), delta=0.02)

    def test_its_commands_do_what_the_page_says(self):
        install, build, serve, by_seed, by_goal, oracle, start = COMMANDS
        self.assertEqual((install, build), ("deploy/install", "deploy/build release race"), "deploy/test has done both")
        with checkout() as folder, served(serve, folder) as port:
            status, said = run(by_seed, folder, port)
            self.assertEqual(status, 0, said)
            self.assert_says(said, SAID[0])
            Path(folder, "goal.json").write_text(GOAL)
            status, said = run(by_goal, folder, port)
            self.assertEqual(status, 1, said)
            self.assert_says(said, SAID[1])
            with answering(oracle, folder, port) as terminal:
                status, said = run(start, folder, port)
                self.assertEqual(status, 0, said)
                self.assert_says(said, SAID[2])
            self.assert_says(terminal.read_text(), SAID[3])


if __name__ == "__main__":
    unittest.main()
