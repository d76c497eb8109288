"""race serve --config, --check-config and --log-level: what configures a server, and the log that it writes."""
import json
import re
import socket
import subprocess
import tempfile
import unittest
from pathlib import Path

import models
from client import PROGRAM, PROJECT, TIMEOUT, Server, check

LINE = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z (error|warning|info|debug) ([^ ]+): (.*)")


class LoggedServer(Server):
    """A server whose stderr is a file."""

    def __init__(self, *options):
        self.log = tempfile.TemporaryFile("w+")  # noqa: SIM115 closed with this
        super().__init__(*options, stderr=self.log)

    def stop(self):
        super().stop()
        self.log.seek(0)
        self.text = self.log.read()
        self.log.close()

    def lines(self):
        """(level, component, message) of each line, once it has ended; all that is on stderr is such a line."""
        return [LINE.fullmatch(line).groups() for line in self.text.splitlines()]


class Case(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name)

    def config(self, text):
        path = self.folder / "config.json"
        path.write_text(text if isinstance(text, str) else json.dumps(text))
        return path

    def serve(self, *words, text=""):
        """(status, stdout, lines of stderr) of a server that does not start."""
        out = subprocess.run([PROGRAM, "serve", *map(str, words)], input=text, capture_output=True, text=True, timeout=TIMEOUT,
                             check=False, cwd=self.folder)
        return out.returncode, out.stdout, out.stderr.splitlines()


class Config(Case):
    def test_configures_a_server(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        path = self.config(check("server_config", {"port": 1, "data": str(self.folder / "kept"), "log_level": "error"}))
        command = [PROGRAM, "serve", "--config", path, "--port", str(port)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            self.assertEqual(process.stdout.readline(), f"race listens on http://127.0.0.1:{port}\n")
            process.terminate()
            _, errors = process.communicate(timeout=TIMEOUT)
        self.assertEqual((process.returncode, errors), (0, ""))
        self.assertTrue((self.folder / "kept" / "race.sqlite").is_file())

    def test_is_checked_without_a_start(self):
        for words, text in (((self.config({"data": "kept", "port": 0}),), ""), (("-",), '{"data": "kept"}')):
            self.assertEqual(self.serve("--check-config", "--config", *words, text=text), (0, "", []))
        example = PROJECT / "api/examples/server_config.demo.json"
        out = subprocess.run([PROGRAM, "serve", "--check-config", "--config", example], capture_output=True, text=True, timeout=TIMEOUT,
                             check=False, cwd=PROJECT)
        self.assertEqual((out.returncode, out.stdout, out.stderr), (0, "", ""))
        self.assertEqual([each.name for each in self.folder.iterdir()], ["config.json"])

    def test_all_that_is_wrong_is_listed_and_nothing_starts(self):
        path = self.config({"port": -1, "colour": 1, "headless": 1, "log_level": "loud", "remote": ["oven"], "data": "kept"})
        for words in (("--check-config",), ()):
            status, output, lines = self.serve("--config", path, *words)
            self.assertEqual((status, output), (2, ""))
            self.assertEqual([line.split(": ")[:3] for line in lines], [
                [str(path), "port", "out_of_range"], [str(path), "headless", "type"], [str(path), "log_level", "out_of_range"],
                [str(path), "colour", "unknown_field"], [str(path), "remote/0", "not_found"]])
        self.assertEqual([each.name for each in self.folder.iterdir()], ["config.json"])

    def test_what_is_no_configuration_is_refused(self):
        for text, code in (("{", "json"), ("[]", "type"), ('{"port": 1, "port": 2}', "json"), ("[" * 100, "too_deep")):
            status, _, lines = self.serve("--check-config", "--config", self.config(text))
            self.assertEqual((status, len(lines)), (2, 1), lines)
            self.assertIn(f": {code}: ", lines[0])
        for words, wrong in ((("--check-config",), "--config: missing: "), (("--config", "none"), "none: io: "),
                             (("--config",), "--config: missing: "),
                             (("--config", "-", "--operator", "-"), "--config: duplicate: "),
                             (("--log-level", "loud"), "--log-level: out_of_range: "),
                             (("--port", "1.5"), "--port: out_of_range: must be a whole number from 0 to 65535, got `1.5`"),
                             (("--port", "8e3"), "--port: out_of_range: must be a whole number from 0 to 65535, got `8e3`"),
                             (("--port", "80.0"), "--port: out_of_range: "), (("--port", "0x50"), "--port: out_of_range: "),
                             (("--demo", "nowhere"), "--demo: io: `nowhere` cannot be read: No such file or directory"),
                             (("--demo", "config.json"), "--demo: io: `config.json` cannot be read: Not a directory"),
                             (("--demo", "."), "--demo: not_found: `.` holds neither a cell (cell.json, scene.json) nor documents"),
                             (("--demo=",), "--demo: missing: the option needs a folder"),
                             (("--remote", "cell,cell"), "--remote: duplicate: ")):
            status, _, lines = self.serve(*words)
            self.assertEqual(status, 2)
            self.assertTrue(lines[0].startswith(wrong), lines)

    def test_the_operator_script_is_checked_too(self):
        path = self.config({"operator": str(self.folder / "none")})
        status, _, lines = self.serve("--check-config", "--config", path)
        self.assertEqual((status, lines), (2, [f"{self.folder / 'none'}: io: cannot be read: No such file or directory"]))


class Lines(Case):
    """The configuration as lines `key = value`."""

    def config(self, text):
        path = self.folder / "race.conf"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def wrong(self, text):
        """(line, path, code) of each error."""
        path = self.config(text)
        status, output, lines = self.serve("--check-config", "--config", path)
        self.assertEqual((status, output), (2, ""), lines)
        return [tuple(re.fullmatch(re.escape(str(path)) + r":(\d+): (?:([^ ]*): )?([a-z_]+): .*", line).groups()) for line in lines]

    def test_configure_a_server_and_options_come_first(self):
        path = self.config(f"# a comment\r\n\n  port = 1\r\n data={self.folder}/kept  \nheadless = true\nlan = false\n"
                           "remote = database\nheartbeat = 2.5\nlog-level = error\ndemo =\n")
        command = [PROGRAM, "serve", "--config", path, "--port", "0"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            address = re.fullmatch(r"race listens on http://127.0.0.1:(\d+)\n", process.stdout.readline())
            server = Server.__new__(Server)
            server.port = int(address[1])
            available = {each["key"]: each["available"] for each in server.get("/services")["services"]}
            process.terminate()
            _, errors = process.communicate(timeout=TIMEOUT)
        self.assertEqual((process.returncode, errors, available["db"]), (0, "", False))
        self.assertTrue((self.folder / "kept" / "race.sqlite").is_file())

    def test_all_that_is_wrong_is_listed_by_line(self):
        self.assertEqual(self.wrong(
            "port = 65536\ncolour = 1\nheadless = yes\n# port = 1\nport = 2\nlog-level = loud\nremote = cell,oven,cell\nheartbeat =\n"
            "keep_runs = 3\nkeep-runs = 1.5\nnothing\n = 4\ndata = \"x\"\nweb = dist # the pages\noperator = -\nlan\n"
            "config = other\ncheck-config = true\ndemo = a\0b\nlan-port = 0x50\n--keep-mb = 2\nkeep-mb = nan\n"),
            [("1", "port", "out_of_range"), ("2", "colour", "unknown_field"), ("3", "headless", "type"), ("5", "port", "duplicate"),
             ("6", "log-level", "out_of_range"), ("8", "heartbeat", "out_of_range"), ("9", "keep_runs", "unknown_field"),
             ("10", "keep-runs", "out_of_range"), ("11", None, "syntax"), ("12", None, "syntax"), ("13", "data", "syntax"),
             ("14", "web", "syntax"), ("15", "operator", "not_accepted"), ("16", None, "syntax"), ("17", "config", "unknown_field"),
             ("18", "check-config", "unknown_field"), ("19", None, "syntax"), ("20", "lan-port", "out_of_range"),
             ("21", "--keep-mb", "unknown_field"), ("22", "keep-mb", "out_of_range"), ("7", "remote/1", "not_found"),
             ("7", "remote/2", "duplicate")])
        self.assertEqual(self.wrong("port = -1\n"), [("1", "port", "out_of_range")])
        self.assertLessEqual(len(self.wrong("colour = 1\n" * 5000)), 200)
        self.assertIn("did you mean", self.serve("--config", self.config("prot = 1"))[2][0])
        path = self.config("port = 70000\n")
        status, _, lines = self.serve("--config", path, "--port", "0")
        self.assertEqual((status, lines[0].split(": ")[:3]), (2, [f"{path}:1", "port", "out_of_range"]))
        self.assertEqual([each.name for each in self.folder.iterdir()], ["race.conf"])

    def test_the_delivered_file_shows_each_option_with_its_default(self):
        text = (PROJECT / "deploy/race.conf").read_text()
        shown = re.findall(r"^#([a-z-]+) =(.*)$", text, re.MULTILINE)
        usage = subprocess.run([PROGRAM, "serve", "--help"], capture_output=True, text=True, timeout=TIMEOUT, check=True).stdout
        options = re.findall(r"^ +--([a-z-]+)(?: ([A-Z][A-Z,.]*))? {3,}(.*)$", usage, re.MULTILINE)
        options = [each for each in options if each[0] not in ("config", "check-config", "help")]
        self.assertGreater(len(options), 14)
        self.assertEqual([key for key, _ in shown], sorted((key for key, _ in shown), key=[key for key, *_ in options].index))
        self.assertEqual({key for key, _ in shown}, {key for key, *_ in options})
        values = {key: value.strip() for key, value in shown}
        for key, placeholder, meaning in options:
            fallback = re.search(r" \(([^ ()]*)\)$", meaning)
            if not placeholder:
                expected = "false"
            elif key == "operator":
                expected = "FILE"
            else:
                expected = fallback[1] if fallback else ""
            self.assertEqual(values[key], expected, key)
        self.assertEqual(self.serve("--check-config", "--config", self.config(text)), (0, "", []))
        uncommented = re.sub(r"^#([a-z-]+ =)", r"\1", text, flags=re.MULTILINE).replace("operator = FILE", "")
        self.assertEqual(self.serve("--check-config", "--config", self.config(uncommented)), (0, "", []))


class Log(Case):
    def lines(self, *options):
        """The log of a server that is asked, runs a task that prints, and one that faults."""
        printing = models.document("printing", {"state": "Root", "entry": "print('a\\n2026-01-01T00:00:00.000Z error server: forged')",
                                                "ports": [{"name": "done", "when": "True"}]})
        with LoggedServer(*options) as server:
            for document in (printing, models.faulty()):
                server.ended(server.core(document))
            for _ in range(20):
                server.get("/health")
        lines = server.lines()
        self.assertNotIn(("error", "server", "forged"), lines)
        return lines

    def test_has_a_line_for_what_begins_and_ends_and_none_for_requests(self):
        lines = self.lines()
        self.assertRegex(lines[0][2], r"^race \d.* listens on http://127.0.0.1:\d+, data in ")
        self.assertEqual((lines[0][:2], lines[-1]), (("info", "server"), ("info", "server", "ends")))
        self.assertIn(("info", "core/1", "printing: ended at done"), lines)
        self.assertEqual([(component, message.split(",")[0]) for level, component, message in lines if level == "error"],
                         [("core/2", "faulty: faulted")])
        self.assertLess(len(lines), 30)
        self.assertNotIn("debug", [level for level, *_ in lines])

    def test_has_the_levels_that_are_asked_for(self):
        self.assertEqual({level for level, *_ in self.lines("--log-level", "error")}, {"error"})
        self.assertIn(("debug", "core/1", r"a\n2026-01-01T00:00:00.000Z error server: forged"), self.lines("--log-level", "debug"))

    def test_nobody_waits_for_a_reader(self):
        for close in (False, True):  # a pipe that nobody reads, and one that is closed
            command = [PROGRAM, "serve", "--port", "0", "--data", self.folder / str(close), "--log-level", "debug"]
            with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
                port = int(re.search(r":(\d+)$", process.stdout.readline().strip())[1])
                if close:
                    process.stderr.close()
                client = Server.__new__(Server)
                client.port = port
                much = models.document("much", {
                    "state": "Root", "variables": [{"name": "n", "initial": 0}], "children": [{"state": "A"}], "first": "A",
                    "actions": [{"when": "svc.timer.tick", "do": "var.n = var.n + 1\nfor i in range(100):\n    print('x' * 1000)"}],
                    "ports": [{"name": "done", "when": "var.n > 5"}]})
                self.assertEqual(client.ended(client.core(much))["status"], "ended")
                process.terminate()
                self.assertEqual(process.wait(TIMEOUT), 0)
                if not close:
                    process.stderr.close()


if __name__ == "__main__":
    unittest.main()
