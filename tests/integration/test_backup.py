"""Backups: made while tasks run and documents are put, brought back while the server runs or by the command line."""
import shutil
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

import models
from client import PROGRAM, Server


def race(*arguments):
    """(status, stdout, stderr)"""
    out = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60, check=False)
    return out.returncode, out.stdout.strip(), out.stderr


def stored(server, key):
    """The value of the key in the database, by a task that reads it; None: there is none."""
    ended = server.ended(server.core(models.reading(), {"key": key}))
    return ended["results"]["value"] if ended["outcome"] == "found" else None


def store(server, key, value):
    assert server.ended(server.core(models.storing(), {"key": key, "value": value}))["outcome"] == "success"


class Backups(unittest.TestCase):
    def setUp(self):
        self.data = Path(tempfile.mkdtemp(prefix="race-test-"))

    def tearDown(self):
        shutil.rmtree(self.data)

    def test_it_brings_back_documents_and_values_of_its_moment(self):
        with Server(data=str(self.data)) as server:
            store(server, "x", 1)
            server.put("/documents/ticking", models.ticking(), "document_entry")
            documents = server.get("/documents", "documents")
            backup = server.post("/backups", None, "backup", 201)
            self.assertEqual(server.get("/backups", "backups")["backups"], [backup])
            store(server, "x", 2)
            server.put("/documents/chain", models.chain(), "document_entry")
            server.put("/documents/ticking", models.ticking(last=7), "document_entry")
            server.post(f"/backups/{backup['name']}/restore", None, "backup")
            self.assertEqual(server.get("/documents", "documents"), documents)
            server.get("/documents/chain", status=404)
            self.assertEqual(stored(server, "x"), 1)
        with Server(data=str(self.data)) as server:
            self.assertEqual(stored(server, "x"), 1)
            self.assertEqual(server.expect("DELETE", f"/backups/{backup['name']}", None, "backup", 200), backup)
            self.assertEqual(server.get("/backups", "backups")["backups"], [])
            server.post(f"/backups/{backup['name']}/restore", None, status=404)

    def test_it_is_whole_while_values_and_documents_are_written(self):
        with Server(data=str(self.data)) as server:
            stop = threading.Event()

            def write():
                number = 0
                while not stop.is_set():
                    server.put("/documents/ticking", models.ticking(last=5 + number), "document_entry")
                    core = server.core(models.storing(), {"key": "x", "value": number})
                    server.ended(core)
                    server.expect("DELETE", f"/cores/{core}", None, "core", 200)
                    number += 1

            writer = threading.Thread(target=write)
            writer.start()
            names = [server.post("/backups", None, "backup", 201)["name"] for _ in range(5)]
            stop.set()
            writer.join()
            for name in reversed(names):
                server.post(f"/backups/{name}/restore", None, "backup")
                # A run that was under way then is interrupted now.
                for core in server.get("/cores", "cores")["cores"]:
                    self.assertIn(core["status"], ("interrupted", "ready"))
                    server.expect("DELETE", f"/cores/{core['id']}", None, "core", 200)
                value = stored(server, "x")
                listed = {entry["name"]: entry["revision"] for entry in server.get("/documents", "documents")["documents"]}
                # The documents are copied before the values; a document is put before its value is stored.
                if value is not None and "ticking" in listed:
                    self.assertGreaterEqual(value, listed["ticking"] - 2)

    def test_it_is_refused_while_a_run_is_not_over(self):
        with Server(data=str(self.data)) as server:
            name = server.post("/backups", None, "backup", 201)["name"]
            core = server.core(models.ticking(last=1_000_000))
            errors = server.post(f"/backups/{name}/restore", None, status=409)["errors"]
            self.assertEqual(errors[0]["code"], "conflict")
            server.post(f"/cores/{core}/stop", None, "core")
            server.post(f"/backups/{name}/restore", None, "backup")
            self.assertEqual(server.get("/cores", "cores")["cores"], [])

    def test_a_damaged_one_is_refused_and_nothing_is_changed(self):
        with Server(data=str(self.data)) as server:
            store(server, "x", 1)
            name = server.post("/backups", None, "backup", 201)["name"]
            store(server, "x", 2)
            path = self.data / "backups" / name / "database.sqlite"
            content = bytearray(path.read_bytes())
            content[len(content) // 2] ^= 4
            path.write_bytes(content)
            cores = server.get("/cores", "cores")
            errors = server.post(f"/backups/{name}/restore", None, status=500)["errors"]
            self.assertEqual(errors[0]["code"], "corrupt")
            self.assertEqual(server.get("/cores", "cores"), cores)
            self.assertEqual(stored(server, "x"), 2)

    def test_there_are_twenty_at_most(self):
        with Server(data=str(self.data)) as server:
            for _ in range(20):
                server.post("/backups", None, "backup", 201)
            self.assertEqual(server.post("/backups", None, status=409)["errors"][0]["code"], "conflict")

    def test_the_command_line_backs_up_a_running_server_and_restores_a_stopped_one(self):
        copy = self.data / "copy"
        data = self.data / "data"
        with Server(data=str(data)) as server:
            store(server, "x", 1)
            self.assertEqual(race("backup", "--data", data, copy), (0, str(copy), ""))
            self.assertEqual(race("backup", "--data", data, copy)[0], 2)
            status, folder, _ = race("backup", "--data", data)
            self.assertEqual(status, 0)
            self.assertEqual([Path(folder).name], [b["name"] for b in server.get("/backups", "backups")["backups"]])
            store(server, "x", 2)
            status, _, error = race("restore", "--data", data, copy)
            self.assertEqual(status, 2)
            self.assertIn("conflict", error)
            last = server.core(models.ticking())
        (data / "database.sqlite").write_bytes(b"x" * 8192)
        self.assertEqual(race("restore", "--data", data, copy), (0, "", ""))
        self.assertEqual([kept.stat().st_size for kept in data.glob("database.sqlite.damaged-*")], [8192])
        self.assertEqual(list(data.glob("race.sqlite.damaged-*")), [])
        with Server(data=str(data)) as server:
            self.assertEqual(stored(server, "x"), 1)
            self.assertGreater(int(server.core(models.ticking())), int(last), "numbers do not go back")
        new = self.data / "new"
        self.assertEqual(race("restore", "--data", new, copy)[0], 0)
        with Server(data=str(new)) as server:
            self.assertEqual(stored(server, "x"), 1)

    def test_the_command_line_says_what_is_no_backup(self):
        self.assertEqual(race("backup", "--data", self.data / "none")[0], 2)
        status, _, error = race("restore", "--data", self.data, self.data / "none")
        self.assertEqual(status, 2)
        self.assertIn("cannot be read", error)


if __name__ == "__main__":
    unittest.main()
