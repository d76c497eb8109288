"""The worked example planner (api/examples/planner), importable, and as a process, started as its README says."""
import re
import shlex
import subprocess
import sys

from client import PROJECT
from python_clients import LIBRARY

EXAMPLES = PROJECT / "api" / "examples"
assert str(LIBRARY) in sys.path
sys.path.insert(0, str(EXAMPLES))

README = (EXAMPLES / "planner" / "README.md").read_text()
COMMAND, OPTIONS = re.search(r"^    (PYTHONPATH=\S+ python3 -m planner) (--seed \d+)$", README, re.MULTILINE).groups()
ENVIRONMENT = {"PYTHONDONTWRITEBYTECODE": "1", "PATH": "/usr/bin:/bin"}


def plan(port, *options, timeout=240):
    """(exit code, lines) of the planner at the server on this port."""
    line = f"{COMMAND} {shlex.join([*options, '--server', f'http://127.0.0.1:{port}'])}"
    done = subprocess.run(line, shell=True, cwd=PROJECT, env=ENVIRONMENT, capture_output=True, text=True, timeout=timeout, check=False)
    return done.returncode, (done.stdout + done.stderr).splitlines()
