"""race login and logout: who asks, at which server, and what is said when nobody may."""
import json
import os
import pty
import signal
import termios
import unittest

from accounts import PASSWORD, AccountServer
from client import Server
from race_command import Person
from test_tls import LanServer


class Logins(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = AccountServer()
        cls.addClassCleanup(cls.server.stop)

    def setUp(self):
        self.person = Person(self, f"http://127.0.0.1:{self.server.port}")

    def login(self, name="developer", password=PASSWORD, **how):
        return self.person.race("login", name, text=password + "\n", **how)

    def test_commands_use_the_token_that_is_kept(self):
        status, _, errors = self.person.race("core", "list")
        self.assertEqual(status, 1)
        self.assertIn(f"`race login --server {self.person.url}` logs you in\n", errors)
        status, output, errors = self.login()
        self.assertEqual((status, errors), (0, ""))
        self.assertRegex(output, r"\Alogged in as developer, until \d{4}-\d\d-\d\d \d\d:\d\d UTC\n\Z")
        self.assertEqual(self.person.race("core", "list"), (0, "", ""))
        [file] = self.person.tokens()
        self.assertEqual((file.stat().st_mode & 0o777, file.parent.stat().st_mode & 0o777), (0o600, 0o700))
        self.assertNotIn(json.loads(file.read_text())["token"], output)

    def test_a_wrong_password_keeps_nothing(self):
        status, output, errors = self.login(password="wrong horse battery")
        self.assertEqual((status, output), (1, ""))
        self.assertIn("login: there is no account of this name with this password", errors)
        self.assertNotIn("`race login", errors)
        self.assertEqual(self.person.tokens(), [])
        self.assertEqual(self.person.race("login", "developer")[::2], (2, "password: missing: the standard input has no password\n"))
        self.assertIn("NAME: missing: ", self.person.race("login", text=PASSWORD + "\n")[2])

    def test_logout_ends_it_at_the_server(self):
        self.login()
        token = json.loads(self.person.tokens()[0].read_text())["token"]
        me = {"Authorization": f"Bearer {token}"}
        self.assertEqual(self.server.request("GET", "/api/v1/cores", None, me)[0], 200)
        self.assertEqual(self.person.race("logout"), (0, "", ""))
        self.assertEqual(self.person.tokens(), [])
        self.assertEqual(self.server.request("GET", "/api/v1/cores", None, me)[0], 401)
        status, _, errors = self.person.race("logout")
        self.assertEqual((status, "not_found: you are not logged in" in errors), (1, True))

    def test_a_login_that_has_ended_says_so_and_needs_the_password_alone(self):
        self.login()
        token = json.loads(self.person.tokens()[0].read_text())["token"]
        self.server.request("POST", "/api/v1/logout", None, {"Authorization": f"Bearer {token}"})
        status, _, errors = self.person.race("core", "list")
        self.assertEqual(status, 1)
        self.assertIn(f"your login has ended: `race login --server {self.person.url}` again\n", errors)
        self.assertIn("logged in as developer", self.person.done("login", text=PASSWORD + "\n"))
        self.assertEqual(self.person.race("core", "list")[0], 0)
        self.server.request("POST", "/api/v1/logout", None, {"Authorization": f"Bearer {token}"})
        self.assertEqual(self.person.race("logout"), (0, "", ""))

    def test_a_file_and_the_variable_come_before_it(self):
        self.login("observer")
        file = self.person.folder / "token"
        file.write_text(self.server.tokens["operator"])
        file.chmod(0o600)
        stop = ("core", "stop", "77")  # of an operator
        self.assertIn("rights: ", self.person.race(*stop)[2])
        self.assertIn("not_found: ", self.person.race(*stop, "--token-file", file)[2])
        self.assertIn("not_found: ", self.person.race(*stop, RACE_TOKEN=self.server.tokens["operator"])[2])
        file.write_text("race_" + 43 * "x")
        status, _, errors = self.person.race(*stop, "--token-file", file, RACE_TOKEN=self.server.tokens["operator"])
        self.assertEqual(status, 1)
        self.assertIn(f"the token in {file} has ended, or is of another server\n", errors)
        self.assertIn("the token in RACE_TOKEN has ended, or ", self.person.race(*stop, RACE_TOKEN="race_" + 43 * "x")[2])

    def test_a_token_goes_to_no_other_server(self):
        self.login()
        with AccountServer() as other:  # where this token would be nobody's
            _, _, errors = self.person.race("core", "list", url=f"http://127.0.0.1:{other.port}")
            self.assertIn("logs you in", errors)
            self.assertNotIn("has ended", errors)
        with Server() as other:  # a token that is not known is refused, also without accounts
            self.assertEqual(self.person.race("core", "list", url=f"http://127.0.0.1:{other.port}")[0], 0)

    def test_a_file_that_others_may_read_is_refused(self):
        self.login()
        [file] = self.person.tokens()
        file.chmod(0o644)
        status, _, errors = self.person.race("core", "list")
        self.assertEqual((status, errors), (2, f"{file}: not_accepted: others may use this file: it needs the permissions 0600\n"))

    def test_a_password_goes_to_another_machine_by_https_alone(self):
        for url in ("http://192.0.2.1:8080", "http://127.0.0.1.example.org:8080"):
            status, _, errors = self.login(url=url)
            self.assertEqual((status, errors.split(": ")[:2]), (2, ["--server", "not_accepted"]))
        for words in (("login", "developer"), ("logout",)):
            status, _, errors = self.person.race(*words, text=PASSWORD + "\n", url="ftp://x")
            self.assertEqual((status, errors.split(": ")[:2]), (2, ["--server", "syntax"]))


class Terminal(unittest.TestCase):
    def setUp(self):
        self.ours, self.its = pty.openpty()
        self.addCleanup(os.close, self.ours)
        self.addCleanup(os.close, self.its)

    def shows(self):
        """Whether the terminal shows what is typed."""
        return bool(termios.tcgetattr(self.ours)[3] & termios.ECHO)

    def said(self, process, prompt):
        """What is on stderr, up to this prompt."""
        text = ""
        while not text.endswith(prompt):
            more = process.stderr.read(1)
            self.assertTrue(more, text)
            text += more
        return text

    def test_a_password_is_not_shown(self):
        with AccountServer() as server:
            process = Person(self, f"http://127.0.0.1:{server.port}").start("login", stdin=self.its)
            self.said(process, "Account: ")
            self.assertTrue(self.shows())
            os.write(self.ours, b"developer\n")
            self.assertEqual(self.said(process, "Password: "), "Password: ")
            self.assertFalse(self.shows())
            os.write(self.ours, PASSWORD.encode() + b"\n")
            status, output, errors = Person.finish(process)
            self.assertEqual((status, output.startswith("logged in as developer, "), errors), (0, True, "\n"))
        self.assertTrue(self.shows())

    def test_ctrl_c_lets_the_terminal_show_again(self):
        process = Person(self, "http://127.0.0.1:1").start("login", "developer", stdin=self.its)
        self.said(process, "Password: ")
        self.assertFalse(self.shows())
        process.send_signal(signal.SIGINT)
        self.assertEqual(Person.finish(process)[0], -signal.SIGINT)
        self.assertTrue(self.shows())


class OverTls(unittest.TestCase):
    def test_logs_in_where_the_authority_is_trusted(self):
        with LanServer() as server:
            person = Person.in_network(self, server)
            self.assertEqual(person.race("login", "developer", text=PASSWORD + "\n")[0], 2)
            self.assertEqual(person.race("login", "developer", "--ca", server.authority, text=PASSWORD + "\n")[0], 0)
            self.assertEqual(person.race("core", "list", "--ca", server.authority)[0], 0)
            self.assertEqual(person.race("core", "list", url=f"http://127.0.0.1:{server.port}")[0], 1)  # another URL


if __name__ == "__main__":
    unittest.main()
