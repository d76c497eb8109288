"""What a server has stored, as its files and its answers have it."""
import json
import shutil
import sqlite3
import subprocess
import tempfile
from pathlib import Path

from client import PROGRAM
from crash_scenario import STEPS

DERIVATIONS = 100  # macro steps of one answer


class Folder:
    """A data folder, as the server left it. Its files are read in a copy: reading would tidy up the log."""

    def __init__(self, data):
        self.data = Path(data)

    def copied(self, name, table, query):
        """Rows of the table in the file as a server would find it; none if it is not there, or not yet made."""
        if not (self.data / name).exists():
            return []
        with tempfile.TemporaryDirectory(dir=self.data.parent) as copy:
            for file in (name, name + "-wal", name + "-journal"):
                if (self.data / file).exists():
                    shutil.copy(self.data / file, copy)
            with sqlite3.connect(Path(copy, name)) as connection:
                assert connection.execute("PRAGMA integrity_check").fetchall() == [("ok",)], name
                exists = connection.execute("SELECT 1 FROM sqlite_master WHERE name = ?", [table]).fetchall()
                found = connection.execute(query).fetchall() if exists else []
            connection.close()
        return found

    def journal(self):
        """(input, chain) of each entry of the run."""
        return self.copied("race.sqlite", "entry", "SELECT input, hex(chain) FROM entry WHERE run = 1 ORDER BY position")

    def keys(self):
        """What the run has stored in the database: numbers of keys."""
        return [int(key[1:]) for key, in self.copied("database.sqlite", "record", "SELECT key FROM record")]

    def keys_now(self):
        """As keys(), but as the running server sees it: what a failed commit has left in the log does not count."""
        connection = sqlite3.connect((self.data / "database.sqlite").as_uri() + "?mode=ro", uri=True)
        found = connection.execute("SELECT key FROM record").fetchall()
        connection.close()
        return [int(key[1:]) for key, in found]


class Reference:
    """The same scenario, not disturbed: its journal and derivations."""

    def __init__(self, data, connection):
        self.journal = Folder(data).journal()
        self.derivations = derivations(connection, "1", STEPS)


def derivations(connection, core, last):
    """Of the macro steps 1 to last."""
    found = []
    for first in range(1, last + 1, DERIVATIONS):
        to = min(last, first + DERIVATIONS - 1)
        found += connection.get(f"/cores/{core}/derivations?from={first}&to={to}")["steps"]
    return found


def as_derived(step):
    """A macro step as `race replay` prints it."""
    calls = [{k: v for k, v in call.items() if k != "call"} for call in step["calls"]]
    return {"micro": step["micro"], "calls": calls, "state": step["state"]}


def replay(run, data, *options):
    """What `race replay` prints of the run."""
    done = subprocess.run([PROGRAM, "replay", run, "--data", data, *options], capture_output=True, text=True, timeout=280, check=False)
    assert done.returncode == 0, (done.stdout, done.stderr)
    return done.stdout if options else json.loads(done.stdout)
