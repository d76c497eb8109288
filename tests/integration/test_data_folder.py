"""A data folder is one server's: another one says so and ends; a server that was killed leaves no lock."""
import subprocess
import unittest
from pathlib import Path

import models
from client import PROGRAM, TIMEOUT, Server
from server_case import ServerCase


def race(*words):
    """(status, stderr) of a command that ends by itself."""
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=TIMEOUT, check=False)
    return done.returncode, done.stderr


class DataFolder(ServerCase):
    def is_refused(self, *words):
        status, said = race(*words)
        self.assertEqual((status, said), (2, f"{self.data}: conflict: another server uses this folder\n"))

    def test_a_second_server_says_who_has_it_and_changes_nothing(self):
        core = self.server.core(models.ticking(last=1_000_000))
        for _ in range(3):
            self.is_refused("serve", "--port", "0", "--data", self.data)
        self.assertEqual(self.server.get(f"/cores/{core}", "core")["status"], "running")
        self.server.post(f"/cores/{core}/stop", None, "core")
        self.restart()

    def test_nothing_is_restored_below_a_server(self):
        backup = self.server.post("/backups", None, "backup", 201)["name"]
        self.is_refused("restore", "--data", self.data, f"{self.data}/backups/{backup}")
        self.assertEqual(race("backup", "--data", self.data), (0, ""))
        self.server.stop()
        self.assertEqual(race("restore", "--data", self.data, f"{self.data}/backups/{backup}"), (0, ""))
        self.server = Server(data=self.data)

    def test_a_killed_server_leaves_no_lock(self):
        self.server.core(models.ticking(last=1_000_000))
        for _ in range(3):
            self.kill()

    def test_a_link_to_the_folder_is_the_same_folder(self):
        link = self.data + "-link"
        Path(link).symlink_to(self.data)
        self.addCleanup(Path(link).unlink)
        status, said = race("serve", "--port", "0", "--data", link)
        self.assertEqual((status, said), (2, f"{link}: conflict: another server uses this folder\n"))

    def test_another_folder_is_free(self):
        with Server():
            self.is_refused("serve", "--port", "0", "--data", self.data)


if __name__ == "__main__":
    unittest.main()
