"""The worked example planner (api/examples/planner): importable, and as a process, started as its README says."""
import os
import re
import shlex
import subprocess
import sys

from client import PROJECT
from python_clients import LIBRARY

EXAMPLES = PROJECT / "api" / "examples"
assert str(LIBRARY) in sys.path
sys.path.insert(0, str(EXAMPLES))

SEEDS = os.environ.get("RACE_PLANNER_SEEDS", "")
IS_LONG = SEEDS == "all"  # as deploy/soak asks: all tables, and all that takes long
README = (EXAMPLES / "planner" / "README.md").read_text()
COMMAND = re.search(r"^    (PYTHONPATH=\S+ python3 -m planner) --seed", README, re.MULTILINE).group(1)
ENVIRONMENT = {"PYTHONDONTWRITEBYTECODE": "1", "PATH": "/usr/bin:/bin"}


def start(port, *options):
    """The process of the planner at the server on this port (None: that of its options); what it says is on its stdout."""
    setting, *words = shlex.split(COMMAND)
    environment = {**ENVIRONMENT, **dict([setting.split("=", 1)])}
    server = [] if port is None else ["--server", f"http://127.0.0.1:{port}"]
    return subprocess.Popen([*words, *options, *server], cwd=PROJECT, env=environment, text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT)


def plan(port, *options, timeout=240):
    """(exit code, lines) of the planner, when it has ended."""
    with start(port, *options) as process:
        try:
            text, _ = process.communicate(timeout=timeout)
        finally:
            process.kill()
    return process.returncode, text.splitlines()
