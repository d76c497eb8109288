"""Every cell of api/rights.json: each route, channel and message, asked for by nobody and by an account of each role."""
import json
import re
import unittest

from accounts import ROLES, AccountServer
from client import PROJECT, Stream, check
from interface import INTERFACE

RIGHTS = check("rights", json.loads((PROJECT / "api/rights.json").read_text()))
ASKERS = (None, "speaker", *ROLES)
# What stands for the parameters of a pattern: nothing of that name is there, so nothing changes.
NOTHING = {"number": "7", "revision": "7", "run": "7777777", "id": "7777777", "digest": "0" * 64}


def may(asker, right):
    """Whether the account, which is named as its role, has the right."""
    if right == "anyone":
        return True
    if right == "process" or asker == "speaker":
        return (right, asker) == ("process", "speaker")
    return asker is not None and ROLES.index(asker) >= ROLES.index(right)


def filled(pattern):
    return re.sub(r"\{(\w+)\}", lambda match: NOTHING.get(match[1], "nothing"), pattern)


class Rights(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = AccountServer()
        cls.addClassCleanup(cls.server.stop)

    def answer(self, asker, method, path):
        """(status, code of the first error) of a request whose body fits no route."""
        headers = {"Authorization": "" if asker is None else f"Bearer {self.server.tokens[asker]}"}
        body = None if method in ("GET", "DELETE") else {"no_such_field": 1}
        status, answer = self.server.request(method, path, body, headers)
        return status, answer["errors"][0]["code"] if status >= 400 else ""

    def test_each_route_is_for_whom_the_table_says(self):
        cells = 0
        for row, right in RIGHTS["routes"].items():
            method, pattern = row.split()
            for asker in ASKERS:
                with self.subTest(row=row, asker=asker):
                    status, code = self.answer(asker, method, filled(pattern))
                    denied = (401, "login") if asker is None else (403, "rights")
                    if may(asker, right):
                        self.assertNotIn((status, code), ((401, "login"), (403, "rights")))
                    else:
                        self.assertEqual((status, code), denied)
                    cells += 1
        self.assertEqual(cells, len(ASKERS) * len(RIGHTS["routes"]))

    def test_each_route_of_the_interface_has_a_row(self):
        routes = {f"{method.upper()} {path}" for path, methods in INTERFACE["paths"].items() for method in methods
                  if method in ("get", "put", "post", "delete")}
        self.assertEqual(set(RIGHTS["routes"]), routes)

    def test_who_only_looks_on_changes_nothing_by_the_table(self):
        """The others here read the table that the server has, too: a wrong row would be right for them."""
        for_everybody = {row for row, right in RIGHTS["routes"].items() if right in ("anyone", "observer") and not row.startswith("GET ")}
        self.assertEqual(for_everybody, {"POST /api/v1/stop", "POST /api/v1/login", "POST /api/v1/pair", "POST /api/v1/logout",
                                         "PUT /api/v1/me/password", "POST /api/v1/tickets"})
        messages = {kind for kind, right in RIGHTS["messages"].items() if right in ("anyone", "observer")}
        self.assertEqual(messages, {"subscribe", "unsubscribe", "gather", "presence"})
        self.assertEqual(RIGHTS["routes"]["GET /api/v1/control/hold"], "operator")

    def test_each_channel_and_message_is_for_whom_the_table_says(self):
        for asker in ROLES:
            with Stream(self.server.port, token=self.server.tokens[asker]) as stream:
                self.assertEqual(stream.status, 101)
                for channel, right in RIGHTS["channels"].items():
                    stream.send({"type": "subscribe", "channel": filled(channel)})
                    self.expect(stream, filled(channel), may(asker, right))
                for kind, right in RIGHTS["messages"].items():
                    stream.send({"type": kind, "no_such_field": 1})
                    self.expect(stream, "", may(asker, right))

    def expect(self, stream, channel, allowed):
        """The next error on the channel is, or is not, one of rights; a snapshot is none."""
        message = stream.until(lambda m: m.get("channel", "") == channel and m["kind"] in ("error", "snapshot", "delta"))[-1]
        code = message["data"]["errors"][0]["code"] if message["kind"] == "error" else ""
        self.assertEqual(code != "rights", allowed, message)

    def test_a_message_without_a_row_is_no_message(self):
        with Stream(self.server.port, token=self.server.tokens["admin"]) as stream:
            stream.send({"type": "reboot"})
            self.assertEqual(stream.message()["data"]["errors"][0]["code"], "type")

    def test_nobody_and_processes_open_no_stream(self):
        for token in (None, self.server.tokens["speaker"], "race_" + "x" * 43):
            with Stream(self.server.port, token=token) as stream:
                self.assertIn(stream.status, (401, 403))

    def test_a_path_that_is_written_otherwise_has_the_same_right(self):
        for path in ("/api/v1/%61ccounts", "/api/v1/accounts/", "/api/v1//accounts", "/api/v1/accounts?x=1", "/API/v1/accounts",
                     "/api/v1/./accounts", "/api/v1/x/../accounts", "/api/v1/accounts%00", "/api/v1/accounts;x", "/api/v2/accounts"):
            for asker in (None, "observer"):
                bearer = "" if asker is None else f"Bearer {self.server.tokens[asker]}"
                answer = self.server.send_raw((f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{self.server.port}\r\nConnection: close\r\n"
                                               f"Authorization: {bearer}\r\n\r\n").encode())
                self.assertIn(answer.split()[1], (b"400", b"401", b"403", b"404"), (path, asker))


if __name__ == "__main__":
    unittest.main()
