"""Which browser tests deploy/test tries once more: few, none that hold a stop, and each of them counts by its second try alone."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

DEPLOY = Path(__file__).resolve().parents[2] / "deploy"


def suite(name, *, fails):
    failure = "<failure/>" if fails else ""
    return f'<testsuite name="tests/browser/{name}.test.ts"><testcase name="good"/><testcase name="bad">{failure}</testcase></testsuite>'


class SecondTry(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.report = Path(folder.name) / "vitest.xml"

    def ask(self, failing, passing=()):
        suites = [suite(name, fails=True) for name in failing] + [suite(name, fails=False) for name in passing]
        self.report.write_text(f"<testsuites>{''.join(suites)}</testsuites>")
        return subprocess.run([sys.executable, "-B", DEPLOY / "second_try.py", self.report], capture_output=True, text=True, check=False)

    def tally(self):
        return subprocess.check_output([sys.executable, "-B", DEPLOY / "tally.py", self.report.parent], text=True).split()

    def test_files_that_failed_are_named_and_no_longer_count(self):
        answer = self.ask(["forms", "one"], ["pro"])
        self.assertEqual((answer.returncode, answer.stdout.split()), (0, ["tests/browser/forms.test.ts", "tests/browser/one.test.ts"]))
        self.assertEqual(self.tally(), ["2", "0"])
        self.assertIn("forms", self.report.with_name("vitest.xml.first").read_text())

    def test_what_fails_again_counts(self):
        self.ask(["forms"])
        self.report.with_name("again.xml").write_text(f"<testsuites>{suite('forms', fails=True)}</testsuites>")
        self.assertEqual(self.tally(), ["1", "1"])

    def test_many_are_not_tried_again(self):
        self.assertEqual(self.ask(["a", "b", "c", "d"]).returncode, 1)
        self.assertEqual(self.tally(), ["4", "4"])

    def test_what_holds_a_stop_has_one_try(self):
        for name in ["control", "lostPage", "lostServer", "stop"]:
            with self.subTest(name):
                self.assertEqual(self.ask(["forms", name]).returncode, 1)
                self.assertTrue((DEPLOY.parent / f"tests/browser/{name}.test.ts").exists())

    def test_a_run_without_a_failed_test_is_not_tried_again(self):
        self.assertEqual(self.ask([], ["pro"]).returncode, 1)


if __name__ == "__main__":
    unittest.main()
