"""Documents and values survive a restart, message numbers are not used again, and a time-out of a run begins anew."""
import shutil
import tempfile
import time
import unittest

import models
from client import Server
from server_case import ServerCase


class Restart(unittest.TestCase):
    def setUp(self):
        self.data = tempfile.mkdtemp(prefix="race-test-")

    def tearDown(self):
        shutil.rmtree(self.data)

    def test_the_database_and_documents_survive(self):
        pose = {"position": [0.1, 0.2, 0.3], "orientation": [0.0, 0.0, 0.0, 1.0]}
        with Server(data=self.data) as server:
            core = server.core(models.storing(), {"key": "pose", "value": pose})
            self.assertEqual(server.ended(core)["outcome"], "success")
            stored = server.get("/documents/storing", "document_entry")
        self.assertEqual(models.without_ids(stored["document"]), models.storing())
        with Server(data=self.data) as server:
            self.assertEqual(server.get("/documents/storing", "document_entry"), stored)
            self.assertEqual(server.get("/cores", "cores")["cores"], [])
            core = server.core(models.reading(), {"key": "pose"})
            ended = server.ended(core)
            self.assertEqual((ended["outcome"], ended["results"]), ("found", {"value": pose}))
            core = server.core(models.reading(), {"key": "other"})
            self.assertEqual(server.ended(core)["outcome"], "missing")

    def test_message_numbers_increase_over_a_restart(self):
        numbers = []
        for _ in range(2):
            with Server(data=self.data) as server, server.stream() as stream:
                stream.subscribe("cores", since=numbers[-1] if numbers else None)
                message = stream.message()
                self.assertEqual(message["kind"], "snapshot")
                numbers.append(message["sequence"])
        self.assertGreater(numbers[1], numbers[0])


class TimeOut(ServerCase):
    def test_the_time_of_a_run_that_was_interrupted_begins_anew_when_it_is_resumed(self):
        core = self.server.core(models.waiting(3.0))
        self.server.wait(core, lambda c: c["step"] > 0)
        time.sleep(0.5)
        self.kill()
        self.assertEqual(self.server.get(f"/cores/{core}", "core")["status"], "interrupted")
        resumed = time.monotonic()
        self.server.post(f"/cores/{core}/resume", None, "core")
        self.assertEqual(self.server.ended(core)["outcome"], "late")
        self.assertGreater(time.monotonic() - resumed, 2.9, "not the rest of the time alone")


if __name__ == "__main__":
    unittest.main()
