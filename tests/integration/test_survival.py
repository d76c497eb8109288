"""Nothing ends the server but SIGTERM and SIGINT: not a disk that fails under a page, nor SIGHUP, nor a lack of memory. What
cannot begin says why, and with which code."""
import contextlib
import http.client
import json
import os
import resource
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

import models
from client import PROGRAM, PROJECT, TIMEOUT, Server
from random_task import random_task
from traced_server import TracedServer, data_folder

DEMO = PROJECT / "deploy/demo"
MEMORY = "race: out_of_memory: "
MIB = 1 << 20


def get(port, path):
    """(status, body)"""
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=TIMEOUT)
    with contextlib.closing(connection):
        connection.request("GET", path)
        response = connection.getresponse()
        return response.status, response.read()


class Pages(unittest.TestCase):
    def test_a_page_that_the_disk_does_not_give_is_an_error_of_its_request(self):
        with tempfile.TemporaryDirectory() as web:
            broken = Path(web, "broken.html")
            broken.write_text("<p>broken")
            Path(web, "fine.html").write_text("<p>fine")
            options = ("--web", web)
            server = TracedServer(data_folder(), "error=EIO", ("read", "readv", "pread64"), (str(broken),), options=options)
            self.addCleanup(server.remove)
            for _ in range(3):
                status, body = get(server.port, "/broken.html")
                self.assertEqual((status, [each["code"] for each in json.loads(body)["errors"]]), (500, ["io"]))
                self.assertNotIn(web.encode(), body)
                self.assertEqual(get(server.port, "/fine.html"), (200, b"<p>fine"))
            server.end_faults()
            self.assertEqual(get(server.port, "/broken.html"), (200, b"<p>broken"))


class Signals(unittest.TestCase):
    def test_sighup_is_ignored(self):
        with TracedServer(data_folder()) as server:
            server.process.send_signal(signal.SIGHUP)
            self.assertEqual(get(server.port, "/api/v1/health")[0], 200)
            self.assertEqual(server.stop(), (0, ""))

    def test_it_ends_while_live_cores_get_edits(self):
        for round in range(20):
            server = Server()
            task = server.put("/documents/task", random_task("task", 1), "document_entry")["document"]
            core = server.post("/cores", {"document": "task", "arguments": {}}, "core", 201)["id"]
            server.put(f"/cores/{core}/live", {"live": True})
            server.post(f"/cores/{core}/start")
            for revision in range(1, 2 + round % 5):
                change = {"op": "set", "id": task["root"]["meta"]["id"], "field": "doc", "value": str(revision)}
                server.post("/documents/task/edits", {"revision": revision, "author": "Ada", "operations": [change]})
            server.stop()

    def test_sigterm_and_sigint_end_it(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            with TracedServer(data_folder()) as server:
                server.process.send_signal(number)
                self.assertEqual(server.ended(), (0, ""))


class Memory(unittest.TestCase):
    def start(self, limit):
        """`race serve` in an address space of `limit` bytes: (its port or None, its status, what it said on stderr)."""
        with tempfile.TemporaryDirectory() as data:
            command = [PROGRAM, "serve", "--port", "0", "--data", data, "--demo", str(DEMO), "--log-level", "error"]
            bounded = ["/usr/bin/env", "bash", "-c", f'ulimit -c 0; ulimit -v {limit // 1024}; exec "$@"', "race", *command]
            with subprocess.Popen(bounded, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
                line = process.stdout.readline()
                process.terminate()
                _, said = process.communicate(timeout=TIMEOUT)
        return line, process.returncode, said

    def test_an_address_space_that_is_too_small_is_an_error_at_the_start(self):
        limits = [size * MIB for size in (40, 80, 120, *range(160, 1000, 40))]
        began = 0
        for limit in limits:
            with self.subTest(mib=limit // MIB):
                line, status, said = self.start(limit)
                self.assertGreaterEqual(status, 0, f"ended by signal {-status}: {said}")
                began += bool(line)
                if not line:  # 127: the dynamic linker has no room for the libraries
                    self.assertIn(status, (2, 127), said)
                    self.assertTrue(said)
        self.assertGreater(began, 0, "there is room in the largest")
        self.assertLess(began, len(limits))

    def test_a_request_for_which_there_is_no_memory_ends_alone(self):
        server = Server("--log-level", "error", stderr=subprocess.DEVNULL)
        self.addCleanup(server.stop)
        pid = server.process.pid
        core = server.core(models.ticking("kept", last=10**9))
        # In memory more than 100 MB: more than the 64 MiB of address space that malloc reserves for each of its arenas.
        large = json.dumps({"rcm": 1, "name": "large", "x": [{}] * 1_300_000}, separators=(",", ":"))
        size = int(Path(f"/proc/{pid}/statm").read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")
        unlimited = resource.prlimit(pid, resource.RLIMIT_AS, (size + 16 * MIB, resource.RLIM_INFINITY))
        answers = []
        for _ in range(20):
            try:
                answers.append(server.request("PUT", "/api/v1/documents/large", large)[0])
            except (ConnectionError, http.client.HTTPException):  # not even for its body
                answers.append(0)
        resource.prlimit(pid, resource.RLIMIT_AS, unlimited)
        self.assertIn(503, answers)
        self.assertTrue(set(answers) <= {0, 422, 503}, answers)
        self.assertEqual(server.request("PUT", "/api/v1/documents/large", large)[0], 422)
        self.assertIn(server.get(f"/cores/{core}", "core")["status"], ("running", "faulted", "interrupted"))
        server.get("/health", "health")


if __name__ == "__main__":
    unittest.main()
