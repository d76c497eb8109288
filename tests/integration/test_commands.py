"""The command line: race run, and what every command does with bad input."""
import json
import re
import resource
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

import models
from client import PROGRAM, PROJECT

DEMO = PROJECT / "deploy/demo"


def race(*arguments, document=None):
    """(status, lines of stdout, stderr); DOCUMENT among the arguments is the file of `document`."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "model.rcm.json")
        if document is not None:
            path.write_text(document if isinstance(document, str) else json.dumps(document))
        words = [str(path) if a == "DOCUMENT" else str(a) for a in arguments]
        out = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=280, check=False)
    return out.returncode, out.stdout.splitlines(), out.stderr


class Format(unittest.TestCase):
    def test_it_gives_ids_which_stay(self):
        status, lines, _ = race("fmt", "DOCUMENT", document=models.ticking())
        document = json.loads("\n".join(lines))
        self.assertEqual((status, models.without_ids(document)), (0, models.ticking()))
        self.assertTrue(document["root"]["children"][0]["ports"][0]["meta"]["id"])
        document["root"]["state"] = "Renamed"
        _, renamed, _ = race("fmt", "DOCUMENT", document=document)
        self.assertEqual([line for line in renamed if line not in lines], ['    "state": "Renamed",'])


    def write(self, document, limit=None, **options):
        """(status, what the file holds then, the names of all files) after `race fmt --write`, with a limit of file sizes."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "model.rcm.json")
            path.write_text(document)
            link = Path(folder, "link")
            link.symlink_to(path.name)
            path.chmod(0o640)
            before = path.stat()
            bound = (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))) if limit else None
            out = subprocess.run([PROGRAM, "fmt", "--write", str(link)], capture_output=True, text=True, timeout=280, check=False,
                                 preexec_fn=bound, **options)
            self.assertTrue(link.is_symlink())
            self.assertEqual(path.stat().st_mode, before.st_mode)
            self.assertEqual(path.stat().st_ino == before.st_ino, path.read_text() == document)
            return out.returncode, path.read_text(), sorted(file.name for file in Path(folder).iterdir())

    def test_writing_replaces_the_file_behind_a_link(self):
        document = json.dumps(models.ticking())
        _, lines, _ = race("fmt", "DOCUMENT", document=document)
        formatted = "\n".join(lines) + "\n"
        self.assertEqual(self.write(document), (0, formatted, ["link", "model.rcm.json"]))
        self.assertEqual(self.write(formatted), (0, formatted, ["link", "model.rcm.json"]))

    def test_a_write_that_fails_or_is_interrupted_leaves_the_file(self):
        document = json.dumps(models.ticking())
        # Without the signal, the write fails; with it, the program ends.
        self.assertEqual(self.write(document, 100, restore_signals=False), (2, document, ["link", "model.rcm.json"]))
        self.assertEqual(self.write(document, 100)[:2], (-signal.SIGXFSZ, document))

    def test_what_could_not_be_read_again_is_refused(self):
        deep = '{"rcm": 1, "root": {"state": "R", "meta": ' + "[" * 62 + "]" * 62 + "}}"
        self.assertEqual(self.write(deep), (2, deep, ["link", "model.rcm.json"]))
        self.assertEqual(race("check", "DOCUMENT", document=deep)[0], 0)
        _, _, error = race("fmt", "DOCUMENT", document=deep)
        self.assertIn(": too_deep: ", error)


class Derive(unittest.TestCase):
    def outcome(self, order):
        """Of a task of which two ports can fire."""
        ports = [{"name": name, "when": "True"} for name in ("p", "q")]
        with tempfile.TemporaryDirectory() as folder:
            script = Path(folder, "script.json")
            script.write_text('{"steps": [{}]}')
            status, lines, error = race("derive", "--order", order, "DOCUMENT", script, document={
                "rcm": 1, "name": "racing", "root": {"state": "Root", "ports": ports}})
        return status, json.loads("\n".join(lines)).get("outcome"), error

    def test_another_order_shows_a_race(self):
        self.assertEqual([self.outcome(order)[1] for order in ("declared", "reversed")], ["p", "q"])
        self.assertEqual({self.outcome(seed)[1] for seed in range(10)}, {"p", "q"})
        self.assertEqual(self.outcome(7), self.outcome(7))
        for order in ("", "backwards", "-1", "1.5", "99999999999999999999"):
            status, _, error = self.outcome(order)
            self.assertEqual((status, error.split(":")[:2]), (2, ["--order", " type"]))


class Run(unittest.TestCase):
    def test_the_last_line_says_how_it_ended(self):
        status, lines, _ = race("run", "DOCUMENT", "--fast", "--json", document=models.ticking(last=3))
        last = json.loads(lines[-1])
        self.assertEqual((status, last["status"], last["outcome"], last["results"]), (0, "ended", "done", {"n": 3}))

    def test_fast_runs_are_the_same_run(self):
        arguments = ("run", "DOCUMENT", "--fast", "--json", "--seed", 7, "--arguments", '{"value": [1, {"a": 2.5}]}')
        runs = [race(*arguments, document=models.storing()) for _ in range(3)]
        self.assertEqual(runs[0], runs[1])
        self.assertEqual(runs[0], runs[2])
        self.assertEqual(json.loads(runs[0][1][-1])["results"], {"read": [1, {"a": 2.5}]})

    def test_real_time_gives_the_same_outcome(self):
        status, lines, _ = race("run", "DOCUMENT", "--json", document=models.ticking(last=2))
        self.assertEqual((status, json.loads(lines[-1])["outcome"]), (0, "done"))

    def test_a_time_out_that_is_entered_often_comes_at_last(self):
        status, lines, _ = race("run", "DOCUMENT", "--fast", "--json", document=models.waiting(0.2, times=1200))
        self.assertEqual((status, json.loads(lines[-1])["outcome"]), (0, "late"))

    def test_a_faulted_run_ends_with_status_1(self):
        status, lines, _ = race("run", "DOCUMENT", "--fast", "--json", document=models.faulty())
        last = json.loads(lines[-1])
        self.assertEqual((status, last["status"], last["fault"]["kind"]), (1, "faulted", "zero_division"))

    def test_a_run_without_an_end_stops_at_its_limit(self):
        status, lines, _ = race("run", "DOCUMENT", "--fast", "--json", "--limit", 2, document=models.chain())
        self.assertEqual((status, json.loads(lines[-1])["status"]), (1, "running"))

    def test_pick_lifts_the_part(self):
        status, lines, _ = race("run", DEMO / "pick.rcm.json", "--fast", "--json")
        last = json.loads(lines[-1])
        self.assertEqual((status, last["outcome"]), (0, "success"))
        self.assertAlmostEqual(last["results"]["actual_width"], 0.04, delta=0.002)

    def test_pick_without_a_pose_ends_at_error(self):
        status, lines, _ = race("run", DEMO / "pick.rcm.json", "--fast", "--json", "--arguments", '{"pose": "unknown"}')
        entered = [path for line in lines[:-1] for path, on in json.loads(line)["active"].items() if on]
        self.assertEqual((status, json.loads(lines[-1])["outcome"]), (0, "error"))
        self.assertNotIn("Pick/Approach", entered)

    def test_pick_without_a_part_retreats_and_ends_at_error(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("scene.json", "lwr_wsg50.urdf"):
                Path(folder, name).write_text((DEMO / name).read_text())
            nowhere = {"position": [0.45, 0.0, 0.1], "orientation": [1, 0, 0, 0]}
            Path(folder, "database.json").write_text(json.dumps({"object_pose": nowhere}))
            status, lines, _ = race("run", DEMO / "pick.rcm.json", "--cell", folder, "--fast", "--json")
        fired = [port for line in lines[:-1] for port in json.loads(line)["fired"]]
        self.assertEqual((status, json.loads(lines[-1])["outcome"]), (0, "error"))
        self.assertEqual([p for p in fired if p.startswith(("Pick/Grasp", "Pick/CheckPart"))],
                         ["Pick/Grasp.error", "Pick/CheckPart.error"])


class Help(unittest.TestCase):
    COMMANDS = ("serve", "service", "run", "test", "runs", "replay", "backup", "restore", "core", "boot", "account", "login", "logout",
                "models", "pull", "push", "bundle", "install", "start", "stop", "services", "call", "trace", "log", "mcp", "completion",
                "derive", "check", "translate", "fmt", "man")

    def test_overview_names_each_command_with_its_options(self):
        status, lines, errors = race("--help")
        self.assertEqual((status, errors), (0, ""))
        calls = [line.split() for line in lines if line.startswith("  race ")]
        self.assertEqual([words[1] for words in calls], list(self.COMMANDS))
        for words in calls:  # the same as of the command itself
            self.assertIn(f"usage: {' '.join(words)}", race(words[1], "--help")[1])
        for words in (("-h",), ("help",)):
            self.assertEqual(race(*words), (0, lines, ""))
        self.assertEqual(race(), (2, [], "\n".join(lines) + "\n"))

    def test_help_of_a_command_explains_each_option(self):
        for command in self.COMMANDS:
            status, lines, errors = race(command, "--help")
            self.assertEqual((status, errors), (0, ""))
            for words in ((command, "-h"), ("help", command), ("--help", command), (command, "DOCUMENT", "--help")):
                self.assertEqual(race(*words), (0, lines, ""), words)
            explained = [line.split()[0] for line in lines[2:] if line.startswith("  --")]
            named = [word.strip("[]") for word in lines[1].split() if word.startswith(("--", "[--"))]
            if command in ("serve", "service", "run"):
                self.assertEqual(explained, named)

    def test_wrong_use_prints_the_usage_as_an_error(self):
        for words in (("service",), ("run",), ("derive", "x"), ("replay",), ("check",), ("translate",), ("fmt",), ("serve", "x")):
            status, lines, errors = race(*words)
            self.assertEqual((status, lines), (2, []))
            wrong, usage = errors.splitlines()[:2]
            self.assertRegex(wrong, "^([A-Z]+: missing|x: syntax): ")
            self.assertTrue(usage.startswith(f"usage: race {words[0]} "), errors)


class Version(unittest.TestCase):
    def test_is_that_of_the_project(self):
        project = re.search(r"project\(race VERSION (\S+)", (PROJECT / "CMakeLists.txt").read_text())[1]
        status, lines, errors = race("--version")
        self.assertEqual((status, lines[0], errors), (0, f"race {project}", ""))
        self.assertRegex(lines[1], r"^compiler: \w+ [\d.]+, \w+$")


class BadInput(unittest.TestCase):
    def test_a_wrong_document_is_reported_with_path_and_code_and_status_2(self):
        wrong = models.document("wrong", {"state": "Root", "first": "Nowhere"})
        for words in (("run", "DOCUMENT"), ("check", "DOCUMENT"), ("translate", "DOCUMENT"), ("fmt", "DOCUMENT")):
            status, _, errors = race(*words, document=wrong)
            self.assertEqual(status, 1 if words[0] == "check" else 2, words)
            self.assertIn("Root: first: ", errors)
        status, lines, _ = race("run", "DOCUMENT", "--json", document=wrong)
        self.assertEqual(json.loads("\n".join(lines))["errors"][0]["code"], "first")

    def test_an_unknown_option_is_named(self):
        for command in ("serve", "run", "check", "translate", "fmt"):
            words = (command,) if command == "serve" else (command, "DOCUMENT")
            status, lines, errors = race(*words, "--slow", document=models.ticking())
            self.assertEqual((status, lines, errors), (2, [], "--slow: unknown_field: there is no such option\n"))

    def test_wrong_options_end_with_status_2(self):
        for words in (("run",), ("run", "a", "b"), ("run", "DOCUMENT", "--slow"), ("run", "DOCUMENT", "--seed"),
                      ("run", "DOCUMENT", "--seed", "x"), ("run", "DOCUMENT", "--arguments", "["),
                      ("run", "DOCUMENT", "--arguments", "[]"), ("run", "/nowhere.json"),
                      ("run", "DOCUMENT", "--arguments", '{"colour": 1}'), ("serve", "--port", "99999"),
                      ("serve", "--data", "/proc/no"), ("serve", "more"), ("dance",), ()):
            status, _, errors = race(*words, document=models.ticking())
            self.assertEqual(status, 2, words)
            self.assertTrue(errors, words)


if __name__ == "__main__":
    unittest.main()
