"""One bit of a file of the data folder is flipped while no server runs: the next server says so, or nothing is different.

RACE_FLIPS says how many are tried (40), RACE_SEED which; RACE_FLIP=folder:file:bit tries one.
"""
import concurrent.futures
import os
import random
import shutil
import tempfile
import unittest
from pathlib import Path

import models
from client import Stream
from crash_scenario import COMMANDED, EDITED, EDITS, TASK, Connection, Scenario
from traced_server import TracedServer, data_folder

FLIPS = int(os.environ.get("RACE_FLIPS", "40"))
SEED = int(os.environ.get("RACE_SEED", "1"))
FILES = ("race.sqlite", "race.sqlite-wal", "database.sqlite", "database.sqlite-wal")
ENOUGH = 30  # flips, that one of them is named: of 40, 16 are
KEYS = ("k0", "k50", "k98")
NAMED = {"corrupt", "storage", "io"}  # codes of errors that tell of damage


class Interrupted(Scenario):
    """The scenario, up to its commands: then the run waits."""

    def run(self, connection, edits_first=True):
        self.connection = connection
        self.edit(lambda: None)
        self.command()

    def tell(self, command, body=None):
        if command != "resume":
            super().tell(command, body)


def reading():
    """A task that reads the keys: their values, or the codes of errors."""
    def state(key, after):
        return {"state": key, "entry": f"svc.db.get('{key}')",
                "ports": [{"name": "next", "when": "svc.db.get.result or svc.db.get.error", **after}]}
    return models.document("reading", {
        "state": "Root", "results": [{"name": "values", "initial": []}],
        "actions": [{"when": "available(svc.db.get.result)", "do": "res.values.append(svc.db.get.result)"},
                    {"when": "svc.db.get.error", "do": "res.values.append(svc.db.get.error.code)"}],
        "children": [state(key, {"to": after} if after else {}) for key, after in zip(KEYS, (*KEYS[1:], None), strict=True)],
        "first": KEYS[0], "ports": [{"name": "done", "when": f"len(res.values) == {len(KEYS)}"}]})


def answers(connection):
    """Path -> (status, answer): everything that the server keeps."""
    paths = ["/cores", "/cores/1", "/cores/1/state", "/cores/1/journal",
             f"/cores/1/derivations?from=1&to={COMMANDED}", "/runs", "/runs/1", "/runs/2", "/runs/2/journal", "/runs/2/native",
             f"/runs/2/derivations?from=1&to={len(KEYS) + 1}"]
    for name, last in ((EDITED, EDITS), (TASK, 1), ("reading", 1)):
        paths += [f"/documents/{name}", f"/documents/{name}/revisions"]
        paths += [f"/documents/{name}/revisions/{revision}" for revision in range(1, last + 1)]
    found = {path: connection.request("GET", path) for path in paths}
    found["values"] = values(connection)
    return found


def values(connection):
    """(status, results) of a new core that reads the keys."""
    status, core = connection.request("POST", "/cores", {"document": "reading", "arguments": {}})
    if status != 201:
        return status, core
    scenario = Scenario(connection, core["id"])
    scenario.tell("start")
    scenario.wait()
    return 200, connection.get(f"/cores/{core['id']}").get("results", {})


def read(data):
    """(answers, log) of a server on this folder; (None, what it said): it refuses to begin."""
    with TracedServer(data) as server:
        if not server.port:
            status, said = server.ended()
            assert status == 2 and said.strip(), (status, said)
            return None, said
        with Connection(server.port) as connection, Stream(server.port) as stream:
            found = answers(connection)
            stream.subscribe("log")
            log = str(stream.message())
        assert server.stop()[0] == 0
    return found, log


def make(killed):
    """A folder whose server was stopped, or was killed: its log of writes is still to be taken over."""
    data = data_folder()
    server = TracedServer(data)
    with Connection(server.port) as connection:
        Interrupted().run(connection)
        connection.expect("PUT", "/documents/reading", reading())
        assert values(connection) == (200, {"values": [0, 50, 98]})
        # The log's last transactions, whose damage looks as if they had not been durable (check_log): nobody asks for these.
        for document in (reading(), models.ticking("reading")):
            connection.expect("PUT", "/documents/last", {**document, "name": "last"})
    status = (server.kill if killed else server.stop)()[0]
    assert status == (-9 if killed else 0)
    return data


def is_named(path, was, now, log):
    """Whether the answer that is not the same tells of the damage."""
    status, answer = now
    if path == "values" and status == 200:  # each is as it was, or an error
        old, new = was[1]["values"], answer.get("values", ())
        return len(old) == len(new) and all(b == a or b in NAMED for a, b in zip(old, new, strict=True))
    if path == "/runs" and status == 200:  # the damaged ones beside the others
        named = {error["path"] for error in answer.get("damaged", ())}
        return [run for run in was[1]["runs"] if f"runs/{run['id']}" not in named] == answer["runs"]
    if status in (500, 503, 507) and {error["code"] for error in answer["errors"]} <= NAMED:
        return True
    return path.startswith("/cores") and "cannot be rebuilt" in log


def flipped(original, expected, file, bit):
    """What differs in silence after the bit was flipped; "" if nothing does. And whether anything was named."""
    with tempfile.TemporaryDirectory() as copy:
        shutil.copytree(original, copy, dirs_exist_ok=True)
        path = Path(copy, file)
        content = bytearray(path.read_bytes())
        content[bit // 8] ^= 1 << bit % 8
        path.write_bytes(content)
        try:
            found, log = read(copy)
        except Exception as wrong:  # whatever it is, the flip belongs to it
            return f"{type(wrong).__name__}: {wrong}", True
    if found is None:
        return "", True
    different = {path for path in expected if found[path] != expected[path]}
    silent = [path for path in sorted(different) if not is_named(path, expected[path], found[path], log)]
    return (f"{silent}: {str(found[silent[0]])[:300]}" if silent else ""), bool(different)


class BitFlips(unittest.TestCase):
    def setUp(self):
        self.folders = {"stopped": make(False), "killed": make(True)}
        for folder in self.folders.values():
            self.addCleanup(shutil.rmtree, folder)

    def flips(self):
        """(folder, file, bit): files of all sizes equally often."""
        if one := os.environ.get("RACE_FLIP"):
            folder, file, bit = one.split(":")
            return [(folder, file, int(bit))]
        chance = random.Random(SEED)
        files = [(name, file) for name, folder in self.folders.items() for file in FILES if Path(folder, file).exists()]
        chosen = [files[i % len(files)] for i in range(FLIPS)]
        return [(name, file, chance.randrange(8 * Path(self.folders[name], file).stat().st_size)) for name, file in chosen]

    def test_a_flipped_bit_is_named_or_harmless(self):
        expected = {}
        for name, folder in self.folders.items():
            with tempfile.TemporaryDirectory() as copy:
                shutil.copytree(folder, copy, dirs_exist_ok=True)
                expected[name], _ = read(copy)
                core = expected[name]["/cores/1"][1]
                self.assertEqual((core["status"], core["step"]), ("interrupted", COMMANDED))
                self.assertEqual({status for status, _ in expected[name].values()}, {200})
        flips = self.flips()
        print(f"{len(flips)} flips, seed {SEED}", flush=True)
        with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
            work = [pool.submit(flipped, self.folders[name], expected[name], file, bit) for name, file, bit in flips]
            results = [job.result() for job in work]
        named = sum(named for _, named in results)
        print(f"{named} of them were named")
        wrong = [f"RACE_FLIP={name}:{file}:{bit}: {silent}" for (name, file, bit), (silent, _) in zip(flips, results, strict=True)
                 if silent]
        self.assertEqual(wrong, [])
        self.assertTrue(named or len(flips) < ENOUGH)


if __name__ == "__main__":
    unittest.main()
