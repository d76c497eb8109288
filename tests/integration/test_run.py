"""deploy/run as a new user starts it: builds what is missing, serves the page and the demo, stops at Ctrl-C."""
import http.client
import json
import os
import signal
import socket
import subprocess
import tempfile
import unittest

from client import PROJECT


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as probe:
        return probe.getsockname()[1]


def run(*options):
    return subprocess.Popen([PROJECT / "deploy/run", "--headless", *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            text=True, start_new_session=True)


def interrupt(program):
    """Sends SIGINT to the process group, as Ctrl-C in its terminal."""
    if program.poll() is None:
        os.killpg(program.pid, signal.SIGINT)


class Run(unittest.TestCase):
    def get(self, port, path):
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
        connection.request("GET", path)
        response = connection.getresponse()
        text = response.read().decode()
        connection.close()
        self.assertEqual(response.status, 200, text[:500])
        return text

    def started(self, *options):
        """Starts a demo and waits until it reports that it runs; (program, port)."""
        port = free_port()
        program = run("--port", str(port), "--data", self.enterContext(tempfile.TemporaryDirectory()), *options)
        self.addCleanup(program.stdout.close)
        self.addCleanup(program.wait)
        self.addCleanup(interrupt, program)
        output = []
        for line in program.stdout:
            output.append(line)
            if line.startswith("RACE runs at"):
                self.assertIn(f"http://127.0.0.1:{port} ", line)
                return program, port
        raise AssertionError("".join(output[-30:]))

    def enterContext(self, context):
        value = context.__enter__()
        self.addCleanup(context.__exit__, None, None, None)
        return value

    def test_it_serves_the_page_and_a_demo_that_runs_until_it_is_stopped(self):
        for options, document in (((), "pick"), (("--demonstrator",), "demonstrator")):
            program, port = self.started(*options)
            self.assertIn("<!doctype html>", self.get(port, "/").lower())
            self.assertEqual(json.loads(self.get(port, "/api/v1/health"))["status"], "ok")
            cores = json.loads(self.get(port, "/api/v1/cores"))["cores"]
            self.assertEqual([(core["document"], core["status"]) for core in cores], [(document, "running")])
            refused = run("--port", str(port))
            self.assertIn(f"port {port} is in use", refused.communicate(timeout=60)[0])
            self.assertEqual(refused.returncode, 1)
            interrupt(program)
            self.assertIn("RACE stopped", program.stdout.read())
            self.assertEqual(program.wait(20), 0)

    def test_invalid_options_are_refused_before_anything_is_built(self):
        for options in (("--port", "0"), ("--port", "x"), ("--port",), ("--data",), ("--data=",), ("--hurry",)):
            program = run(*options)
            self.assertNotEqual(program.communicate(timeout=10)[0], "")
            self.assertIn(program.returncode, (1, 2), options)

    def test_option_values_may_follow_a_space_or_an_equals_sign(self):
        for options in (("--data", "x", "--port", "0"), ("--data=x", "--port=0")):
            self.assertIn("from 1 to 65535, got '0'", run(*options).communicate(timeout=10)[0])


if __name__ == "__main__":
    unittest.main()
