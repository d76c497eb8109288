"""`race` as a person uses it: with a home of its own, in a folder, at a server."""
import json
import os
import re
import subprocess
import tempfile
import threading
from pathlib import Path

from client import PROGRAM, TIMEOUT


class Person:
    """Somebody with a home (where logins are kept) and a folder, at the server of `url`."""

    def __init__(self, case, url):
        held = tempfile.TemporaryDirectory()
        case.addCleanup(held.cleanup)
        self.case, self.url, self.folder = case, url, Path(held.name, "work")
        self.folder.mkdir()
        self.state = Path(held.name, "state")

    def environment(self):
        kept = {name: value for name, value in os.environ.items() if name not in ("RACE_TOKEN", "RACE_CA")}
        return {**kept, "XDG_STATE_HOME": str(self.state)}

    def start(self, *words, stdin=subprocess.DEVNULL):
        """A `race` that goes on; the test ends it with finish()."""
        process = subprocess.Popen([PROGRAM, *words, "--server", self.url], cwd=self.folder, env=self.environment(), text=True,
                                   stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.case.addCleanup(process.kill)
        return process

    def race(self, *words, text="", url=None, **variables):
        """(status, stdout, stderr) of a command that asks the server."""
        out = subprocess.run([PROGRAM, *map(str, words), "--server", url or self.url], input=text, capture_output=True, text=True,
                             timeout=60, check=False, cwd=self.folder, env={**self.environment(), **variables})
        return out.returncode, out.stdout, out.stderr

    @staticmethod
    def finish(process):
        """(status, the rest of stdout, stderr) of one of start(), once it has ended by itself."""
        late = threading.Timer(TIMEOUT, process.kill)
        late.start()
        with process:  # communicate() would leave out what readline() has read ahead
            output, errors = process.stdout.read(), process.stderr.read()
        late.cancel()
        return process.returncode, output, errors

    def done(self, *words, **how):
        """stdout of one that must be fine."""
        status, output, errors = self.race(*words, **how)
        assert status == 0, (words, status, output, errors)
        return output

    def json(self, *words, **how):
        return json.loads(self.done(*words, "--json", **how))

    @classmethod
    def in_network(cls, case, server):
        """Somebody at a server of the local network (test_tls.LanServer); skips the test on a machine without an address there."""
        if not re.fullmatch(r"[\d.]+", server.name):
            case.skipTest("this machine has no address in a network")
        return cls(case, f"https://{server.name}:{server.lan_port}")

    def tokens(self):
        """The files of logins."""
        return sorted(self.state.rglob("*.json"))
