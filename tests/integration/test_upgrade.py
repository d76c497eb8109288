"""A data folder of an older version of the program: all of it is there after the start, and nothing is lost on the way."""
import hashlib
import json
import resource
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import unittest
from pathlib import Path

import models
from accounts import folder_with_accounts, token_of
from client import PROGRAM, TIMEOUT, Server, check
from traced_server import TracedServer

# Of the first version: SQL as its program made it.
FIRST = """
CREATE TABLE document (name TEXT PRIMARY KEY, revision INTEGER NOT NULL, text TEXT NOT NULL);
PRAGMA user_version = 1;
"""
# What later versions than the fourth have added.
SINCE_FOURTH = ("removal", "revision_edit", "removed_document", "document_breakpoints", "timing", "picturing", "picture",
                "proposal")
KEPT = ("document", "revision", "run", "entry", "header", "boot")


def version_of(store):
    with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as connection:
        version = connection.execute("PRAGMA user_version").fetchone()[0]
    connection.close()
    return version


def rows_of(store):
    """The rows of the tables that all versions since the fourth have, by table."""
    with sqlite3.connect(store) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
        rows = {table: connection.execute(f"SELECT * FROM {table} ORDER BY 1, 2").fetchall() for table in KEPT}
    connection.close()
    return rows


def digests(folder):
    """Of the files, but for empty logs, which reading a store may make."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(Path(folder).rglob("*"))
            if path.is_file() and path.name != "lock" and not path.name.endswith("-shm") and path.stat().st_size > 0}


class Case(unittest.TestCase):
    def setUp(self):
        self.data = Path(tempfile.mkdtemp(prefix="race-test-"))
        self.addCleanup(shutil.rmtree, self.data)
        self.store = self.data / "race.sqlite"

    def make_first(self, name="race.sqlite", script=FIRST):
        with sqlite3.connect(self.data / name) as connection:
            connection.executescript(script)
            for number in range(3):
                connection.execute("INSERT INTO document VALUES (?, ?, ?)",
                                   (f"old{number}", number + 1, json.dumps(models.ticking(f"old{number}"))))
        connection.close()

    def make_fourth(self, folder):
        """Documents, a run that is over, one that was under way, one that waits, and a boot list, as version 4 left them."""
        with Server(data=str(folder)) as server:
            server.put("/documents/edited", models.ticking("edited"), "document_entry")
            server.put("/documents/edited", models.ticking("edited", last=7), "document_entry")
            server.ended(server.core(models.ticking("over", last=3)))
            running = server.core(models.ticking("running", last=10**6))
            server.core(models.ticking("ready"), start=False)
            server.put("/boot", {"entries": [{"document": "edited", "arguments": {}}]})
            server.wait(running, lambda c: c["step"] > 50)
        with sqlite3.connect(folder / "race.sqlite") as connection:
            for table in SINCE_FOURTH:
                connection.execute(f"DROP TABLE {table}")
            connection.execute("PRAGMA user_version = 4")
        connection.execute("VACUUM")
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.close()

    def copies(self):
        folder = self.data / "backups"
        return sorted(folder.iterdir()) if folder.exists() else []

    def refused(self, timeout=TIMEOUT, **how):
        """The lines of a server that does not start; its status must be that of bad input."""
        out = subprocess.run([PROGRAM, "serve", "--port", "0", "--data", self.data], capture_output=True, text=True, timeout=timeout,
                             check=False, **how)
        self.assertNotIn("listens", out.stdout)
        return out.returncode, out.stderr


class Upgrade(Case):
    def test_of_the_first_version(self):
        for name, script in (("race.sqlite", FIRST), ("documents.sqlite", FIRST.replace("= 1", "= 0"))):
            self.make_first(name, script)
            with Server(data=str(self.data)) as server:
                for number in range(3):
                    entry = server.get(f"/documents/old{number}", "document_entry")
                    self.assertEqual((entry["revision"], entry["origin"]["kind"]), (number + 1, "older"))
                    self.assertEqual(models.without_ids(entry["document"]), models.ticking(f"old{number}"))
                self.assertEqual(server.ended(server.core(models.ticking("old0", last=2)))["status"], "ended")
                copy, = server.get("/backups", "backups")["backups"]
            self.assertEqual(version_of(self.data / "backups" / copy["name"] / "race.sqlite"), int("= 1" in script))
            shutil.rmtree(self.data)
            self.data.mkdir()

    def test_of_runs_and_a_boot_list(self):
        self.make_fourth(self.data)
        before = rows_of(self.store)
        self.assertEqual(version_of(self.store), 4)
        with Server(data=str(self.data)) as server:
            self.assertEqual([run["status"] for run in server.get("/runs", "runs")["runs"]][-1], "ended")
            cores = {core["document"]: core["status"] for core in server.get("/cores", "cores")["cores"]}
            self.assertEqual((cores["running"], cores["ready"]), ("interrupted", "ready"))
            self.assertEqual([each["document"] for each in server.get("/boot")["entries"]], ["edited"])
            self.assertEqual(server.get("/documents/edited", "document_entry")["revision"], 2)
            self.assertEqual(len(server.get("/documents/edited/revisions")["revisions"]), 2)
            over = next(run for run in server.get("/runs", "runs")["runs"] if run["document"] == "over")
            self.assertGreater(len(server.get(f"/runs/{over['id']}/derivations?from=1&to=2")["steps"]), 0)
        copy, = self.copies()
        self.assertEqual(version_of(copy / "race.sqlite"), 4)
        self.assertEqual(rows_of(copy / "race.sqlite"), before)
        with Server(data=str(self.data)):
            self.assertEqual(len(self.copies()), 1, "once")
        out = subprocess.run([PROGRAM, "restore", copy, "--data", self.data], capture_output=True, text=True, timeout=TIMEOUT, check=False)
        self.assertEqual(out.returncode, 0, out.stderr)
        with Server(data=str(self.data)) as server:
            self.assertEqual(server.get("/documents/edited", "document_entry")["revision"], 2)

    def test_of_tokens_without_a_role_of_their_own(self):
        data = folder_with_accounts()
        self.addCleanup(shutil.rmtree, data)
        tokens = {role: token_of(data, role) for role in ("admin", "observer")}
        with sqlite3.connect(Path(data) / "accounts.sqlite") as connection:
            for column in ("role", "local", "display"):
                connection.execute(f"ALTER TABLE token DROP COLUMN {column}")
            connection.execute("PRAGMA user_version = 1")
        connection.close()
        for _ in ("upgraded", "as it is then"):
            with Server(data=data) as server:
                for role, token in tokens.items():
                    status, me = server.request("GET", "/api/v1/me", headers={"Authorization": f"Bearer {token}"})
                    self.assertEqual((status, check("me", me)["role"], me["local"]), (200, role, False))
                server.token = tokens["admin"]
                listed = server.get("/accounts/admin/tokens", "account_tokens")["tokens"]
                self.assertEqual([token.keys() & {"role", "local", "name"} for token in listed], [set()])
        self.assertEqual(version_of(Path(data) / "accounts.sqlite"), 2)

    def test_of_a_newer_version_is_refused_and_left_as_it_is(self):
        with Server(data=str(self.data)) as server:
            server.put("/documents/kept", models.ticking("kept"), "document_entry")
        with sqlite3.connect(self.store) as connection:
            connection.execute("PRAGMA user_version = 1000")
        connection.close()
        before = digests(self.data)
        status, errors = self.refused()
        self.assertEqual(status, 2)
        self.assertRegex(errors, f"^{self.store}: version: a newer version of the program wrote this file\n$")
        self.assertEqual(digests(self.data), before)


class Faults(Case):
    def setUp(self):
        super().setUp()
        self.original = Path(tempfile.mkdtemp(prefix="race-test-"))
        self.addCleanup(shutil.rmtree, self.original)
        self.make_fourth(self.original)
        self.before = rows_of(self.original / "race.sqlite")

    def renew(self):
        shutil.rmtree(self.data)
        shutil.copytree(self.original, self.data)

    def assert_old_or_new(self, what):
        """The store is whole, in one version or the other, and today's server finds all in it. Returns the version."""
        copy = self.data.parent / (self.data.name + "-look")
        shutil.copytree(self.data, copy)
        try:
            rows = rows_of(copy / "race.sqlite")
            version = version_of(copy / "race.sqlite")
        finally:
            shutil.rmtree(copy)
        self.assertIn(version, (4, 11), what)
        for table in KEPT:
            if version == 4:
                self.assertEqual(rows[table], self.before[table], (what, table))
            elif table != "run":  # of which the server may have changed some since
                self.assertLessEqual(set(self.before[table]), set(rows[table]), (what, table))
        for backup in self.copies():
            if (backup / "digests.json").exists() and not backup.name.startswith("."):
                self.assertEqual(rows_of(backup / "race.sqlite"), self.before, what)
        with Server(data=str(self.data)) as server:
            self.assertEqual(server.get("/documents/edited", "document_entry")["revision"], 2)
            self.assertLessEqual({"running", "ready"}, {core["document"] for core in server.get("/cores", "cores")["cores"]})
        return version

    def test_a_kill_at_any_write_leaves_the_old_or_the_new(self):
        versions, when, survived = [], 1, False
        while not survived and when < 60:
            self.renew()
            with TracedServer(str(self.data), inject=f"signal=SIGKILL:when={when}", calls=("pwrite64", "fdatasync")) as server:
                survived = server.port is not None
            if not survived:
                versions.append(self.assert_old_or_new(f"killed at {when}"))
            when += 1 if when < 12 else 4
        print(versions, flush=True)
        self.assertIn(4, versions)

    def test_a_full_disk_leaves_the_old_or_the_new(self):
        size = (self.original / "race.sqlite").stat().st_size
        versions = []
        for limit in (4096, size // 2, size - 4096, size, size + 4096, size + 16384, size + 65536):
            self.renew()

            def fill(most=limit):
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
            try:
                status, errors = self.refused(timeout=2, preexec_fn=fill)
                self.assertEqual(status, 2, errors)
                self.assertIn("storage", errors)
            except subprocess.TimeoutExpired:
                pass  # there was room: it serves
            versions.append(self.assert_old_or_new(f"{limit} bytes"))
        print(versions, flush=True)
        self.assertIn(4, versions)


if __name__ == "__main__":
    unittest.main()
