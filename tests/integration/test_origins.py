"""Whose pages may ask the server: every pair of Host and Origin is held, with and without accounts, for a request that
changes something, for the stream's upgrade and for the components'. A Host that is no name of the server (DNS rebinding) is
answered 421, one that cannot be a Host 400 (RFC 9112, 3.2), an Origin that is not the server's own 403 (CSRF, and pages that
open its WebSockets), all of them before anybody is asked who they are; and what is refused changes nothing. What a form can
send (text/plain and the like) is no body, and nothing allows a foreign page to read an answer (CORS).
"""
import itertools
import json
import re
import unittest

import models
from accounts import AccountServer
from client import Server
from component_process import token_file

# PORT is the server's. Of what a Host has (RFC 9110, 7.2: a name or address, perhaps a port), what the server answers:
OWN_HOSTS = ("127.0.0.1:PORT", "localhost:PORT", "[::1]:PORT", "LOCALHOST:PORT", "LocalHost:PORT", " \t127.0.0.1:PORT \t")
# 421: a Host, but of others: names that an attacker may own, and other spellings of this machine, which no page of ours has.
OTHER_HOSTS = (
    "evil.example:PORT", "evil.example", "127.0.0.1", "localhost", "[::1]", "127.0.0.1:1", "127.0.0.1:80", "localhost:443", "127.0.0.1:",
    "127.0.0.1:0PORT", "localhost.:PORT", "127.0.0.1.:PORT", "127.0.0.1.evil.example:PORT", "localhost.evil.example:PORT",
    "evil.localhost:PORT", "127.0.0.1.nip.io:PORT", "evil-127.0.0.1:PORT", "notlocalhost:PORT", "2130706433:PORT", "017700000001:PORT",
    "0x7f000001:PORT", "0x7f.0.0.1:PORT", "0177.0.0.1:PORT", "127.1:PORT", "127.0.1:PORT", "127.0.0.2:PORT", "127.000.000.001:PORT",
    "0.0.0.0:PORT", "0:PORT", "192.168.0.1:PORT", "[::]:PORT", "[::ffff:127.0.0.1]:PORT", "[::ffff:7f00:1]:PORT",
    "[0:0:0:0:0:0:0:1]:PORT", "[::2]:PORT", "%31%32%37.0.0.1:PORT", "%6cocalhost:PORT", "", ":PORT")
# 400: none at all.
NO_HOSTS = (
    "user@127.0.0.1:PORT", "user:password@127.0.0.1:PORT", "127.0.0.1:PORT@evil.example", "http://127.0.0.1:PORT", "127.0.0.1:PORT/",
    "127.0.0.1:PORT/evil", "127.0.0.1:PORT#evil", "127.0.0.1:PORT?evil", "127.0.0.1:PORT, evil.example", "127.0.0.1 :PORT",
    "evil.example 127.0.0.1:PORT", "::1:PORT", "[::1:PORT", "127.0.0.1:PORT:PORT", "127.0.0.1:x", "127.0.0.1\\evil:PORT",
    "l\u043ecalhost:PORT")
OWN_ORIGINS = ("http://127.0.0.1:PORT", "http://localhost:PORT", "http://[::1]:PORT", "HTTP://LOCALHOST:PORT")
OTHER_ORIGINS = (
    "http://evil.example", "http://evil.example:PORT", "https://evil.example", "null", "NULL", "", "*", "https://127.0.0.1:PORT",
    "ws://127.0.0.1:PORT", "http://127.0.0.1", "http://127.0.0.1:1", "http://localhost", "http://localhost:80", "http://localhost:443",
    "127.0.0.1:PORT", "//127.0.0.1:PORT", "http:127.0.0.1:PORT", "http:/127.0.0.1:PORT", "http://127.0.0.1:PORT/",
    "http://127.0.0.1:PORT/pro", "http://127.0.0.1:PORT?x", "http://127.0.0.1:PORT#x", "http://127.0.0.1.evil.example:PORT",
    "http://localhost.evil.example:PORT", "http://evil.example/http://127.0.0.1:PORT", "http://evil.example?http://127.0.0.1:PORT",
    "http://evil.example#http://127.0.0.1:PORT", "http://127.0.0.1:PORT@evil.example", "http://user@127.0.0.1:PORT",
    "http://127.0.0.1:PORT.evil.example", "http://127.0.0.1:0PORT", "http://localhost.:PORT", "http://127.0.0.1.:PORT",
    "http://evil.localhost:PORT", "http://2130706433:PORT", "http://017700000001:PORT", "http://0x7f000001:PORT",
    "http://0x7f.0.0.1:PORT", "http://0177.0.0.1:PORT", "http://127.1:PORT", "http://0.0.0.0:PORT", "http://[::ffff:127.0.0.1]:PORT",
    "http://[0:0:0:0:0:0:0:1]:PORT", "http://[::]:PORT", "http://%31%32%37.0.0.1:PORT", "file://", "file:///127.0.0.1:PORT",
    "chrome-extension://abcdefghijklmnop", "data:text/html,x", "about:blank", "http://l\u043ecalhost:PORT",
    "http://127.0.0.1:PORT http://evil.example", "http://evil.example http://127.0.0.1:PORT",
    "http://127.0.0.1:PORT, http://evil.example")
HOST, ORIGIN, EVIL = "127.0.0.1:PORT", "http://127.0.0.1:PORT", "http://evil.example"
OK = 0  # not refused: 201 of what is changed, 101 of a WebSocket

# (values of Host, values of Origin, status)
PAIRS = [
    *(((host,), (), OK) for host in OWN_HOSTS), *(((host,), (), 421) for host in OTHER_HOSTS), *(((host,), (), 400) for host in NO_HOSTS),
    *(((HOST,), (origin,), OK) for origin in OWN_ORIGINS), *(((HOST,), (origin,), 403) for origin in OTHER_ORIGINS),
    (("localhost:PORT",), (ORIGIN,), OK), (("[::1]:PORT",), ("http://localhost:PORT",), OK), (("localhost:PORT",), (EVIL,), 403),
    (("[::1]:PORT",), (EVIL,), 403), (("LOCALHOST:PORT",), ("null",), 403),
    # A name of the attacker that leads here: the browser takes the page for one of that server.
    (("evil.example:PORT",), ("http://evil.example:PORT",), 421), (("evil.example:PORT",), (ORIGIN,), 421),
    (("127.1:PORT",), ("http://127.1:PORT",), 421), ((), (), 400), ((), (ORIGIN,), 400), ((), (EVIL,), 400), ((HOST, HOST), (), 400),
    ((HOST, "evil.example"), (), 400),
    (("evil.example", HOST), (), 400), ((HOST, HOST), (EVIL,), 400), ((HOST,), (ORIGIN, EVIL), 403), ((HOST,), (EVIL, ORIGIN), 403),
    ((HOST,), (ORIGIN, ORIGIN), 403), ((HOST,), ("null", ORIGIN), 403)]
UPGRADE = ("Connection: Upgrade", "Upgrade: websocket", "Sec-WebSocket-Version: 13", "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==")
JSON = "Content-Type: application/json"
# What a form of a foreign page can send, without asking (Fetch: CORS-safelisted), and what only looks like JSON.
SIMPLE = ("text/plain", "text/plain; charset=utf-8", "text/plain;application/json", "application/x-www-form-urlencoded",
          "multipart/form-data; boundary=x", "application/jsonp", "application/json-patch+json", "text/json", "json", "", None)


class Origins:
    """The tests of one kind of server; TOKEN and PROCESS are what its clients send."""

    @classmethod
    def setUpClass(cls):
        cls.server = cls.make_server()
        cls.addClassCleanup(cls.server.stop)
        cls.names = (f"probe{number}" for number in itertools.count())

    def lines(self, hosts, origins):
        pairs = [*(("Host", host) for host in hosts), *(("Origin", origin) for origin in origins)]
        return [f"{name}: {value}".replace("PORT", str(self.server.port)) for name, value in pairs]

    def ask(self, first, lines, token, body=""):
        """(status, head) of a request of somebody with a token; an error must be a problem document."""
        bearer = [] if token is None else [f"Authorization: Bearer {token}"]
        length = [f"Content-Length: {len(body)}"] if body else []
        text = "\r\n".join([f"{first} HTTP/1.1", *lines, *bearer, *length]) + "\r\n\r\n" + body
        answer = self.server.send_raw(text.encode())
        head, _, rest = answer.partition(b"\r\n\r\n")
        status = int(head.split()[1])
        if status >= 400 and not first.startswith("HEAD"):
            self.assertEqual(json.loads(rest)["status"], status, text)
        return status, head.decode().lower()

    def change(self, hosts, origins, token, kind=JSON):
        """Stores a document of a new name: (name, status)."""
        name = next(self.names)
        lines = [*self.lines(hosts, origins), *([kind] if kind else [])]
        return name, self.ask(f"PUT /api/v1/documents/{name}", lines, token, json.dumps(models.ticking(name)))[0]

    def upgrade(self, path, hosts, origins, token):
        return self.ask(f"GET {path}", [*self.lines(hosts, origins), *UPGRADE], token)[0]

    def documents(self):
        return {each["name"] for each in self.server.get("/documents", "documents")["documents"]}

    def hold(self, ask, fine):
        """Asserts that ask(hosts, origins) is the status of each pair, and `fine` where nothing is refused."""
        for hosts, origins, status in PAIRS:
            with self.subTest(hosts=hosts, origins=origins):
                self.assertEqual(ask(hosts, origins), status or fine)

    def test_there_are_enough_pairs_and_none_twice(self):
        self.assertGreaterEqual(len(PAIRS), 40)
        self.assertEqual(len(PAIRS), len({pair[:2] for pair in PAIRS}))

    def test_a_request_that_changes_something_is_of_an_own_page_or_of_none(self):
        before, stored = self.documents(), set()

        def ask(hosts, origins):
            name, status = self.change(hosts, origins, self.token)
            if status == 201:
                stored.add(name)
            return status

        self.hold(ask, 201)
        self.assertEqual(self.documents() - before, stored)

    def test_the_stream_is_opened_by_an_own_page_or_by_none(self):
        self.hold(lambda hosts, origins: self.upgrade("/api/v1/stream", hosts, origins, self.token), 101)

    def test_the_controls_are_opened_by_an_own_page_or_by_none(self):
        self.hold(lambda hosts, origins: self.upgrade("/api/v1/control/hold", hosts, origins, self.token), 101)

    def test_components_connect_from_an_own_page_or_from_none(self):
        self.hold(lambda hosts, origins: self.upgrade("/api/v1/components", hosts, origins, self.process), 101)

    def test_only_the_host_decides_who_reads_and_no_answer_allows_other_pages(self):
        for hosts, origins, status in PAIRS:
            for method in ("GET", "HEAD"):
                with self.subTest(method=method, hosts=hosts, origins=origins):
                    got, head = self.ask(f"{method} /api/v1/documents", self.lines(hosts, origins), self.token)
                    self.assertEqual(got, 200 if status in (OK, 403) else status)
                    self.assertNotIn("access-control-", head)
                    self.assertIn("cross-origin-resource-policy: same-origin", head)

    def test_a_preflight_of_a_foreign_page_is_given_nothing(self):
        for origin, status in ((EVIL, 403), ("null", 403), (ORIGIN, 405)):
            lines = ["Access-Control-Request-Method: PUT", "Access-Control-Request-Headers: content-type, authorization"]
            got, head = self.ask("OPTIONS /api/v1/documents/probe", [*self.lines((HOST,), (origin,)), *lines], self.token)
            self.assertEqual(got, status)
            self.assertNotIn("access-control-", head)

    def test_what_a_form_sends_is_no_body(self):
        before = self.documents()
        for content_type in SIMPLE:
            kind = None if content_type is None else f"Content-Type: {content_type}"
            for origins, status in (((), 415), ((ORIGIN,), 415), ((EVIL,), 403), (("null",), 403)):
                with self.subTest(content_type=content_type, origins=origins):
                    self.assertEqual(self.change((HOST,), origins, self.token, kind)[1], status)
        self.assertEqual(self.documents(), before)

    def test_a_form_without_a_field_is_refused_too(self):
        for route in ("POST /api/v1/backups", "POST /api/v1/tickets", "POST /api/v1/cores/1/stop", "DELETE /api/v1/documents/pick",
                      "POST /api/v1/cell/reset", "POST /api/v1/logout"):
            for origin in (EVIL, "null"):
                lines = [*self.lines((HOST,), (origin,)), "Content-Type: application/x-www-form-urlencoded", "Content-Length: 0"]
                self.assertEqual(self.ask(route, lines, self.token)[0], 403, route)
        self.assertEqual(self.server.get("/backups", "backups")["backups"], [])

    def test_what_a_proxy_would_say_counts_for_nothing(self):
        forwarded = [f"{name}: 127.0.0.1:{self.server.port}" for name in ("X-Forwarded-Host", "X-Host", "X-Original-Host")]
        forwarded += [f"Forwarded: host=127.0.0.1:{self.server.port}", f"Referer: http://127.0.0.1:{self.server.port}/"]
        foreign = ["X-Forwarded-Host: evil.example", "Referer: http://evil.example/"]
        for hosts, origins, lines, status in ((("evil.example:PORT",), (), forwarded, 421), ((HOST,), (EVIL,), forwarded, 403),
                                              ((HOST,), (ORIGIN,), foreign, 200)):
            got = self.ask("POST /api/v1/tickets", [*self.lines(hosts, origins), *lines], self.token)[0]
            self.assertEqual(got, status)


class WithoutAccounts(Origins, unittest.TestCase):
    token = None

    @staticmethod
    def make_server():
        return Server()

    @property
    def process(self):
        return token_file(self.server).read_text().strip()

    def test_a_foreign_page_never_becomes_the_admin_that_everybody_is_here(self):
        body = json.dumps({"name": "eve", "role": "admin", "password": "an example password"})
        rebound = ("evil.example:PORT",)
        for hosts, origins, status in (((HOST,), (EVIL,), 403), (rebound, (), 421), (rebound, (ORIGIN,), 421)):
            self.assertEqual(self.ask("POST /api/v1/accounts", [*self.lines(hosts, origins), JSON], None, body)[0], status)
        self.assertEqual(self.server.get("/accounts", "accounts")["accounts"], [])


class WithAccounts(Origins, unittest.TestCase):
    @staticmethod
    def make_server():
        return AccountServer()

    @property
    def token(self):
        return self.server.tokens["admin"]

    @property
    def process(self):
        return self.server.tokens["speaker"]

    def test_who_is_not_known_is_asked_after_host_and_origin(self):
        self.hold(lambda hosts, origins: self.change(hosts, origins, None)[1], 401)
        for path in ("/api/v1/stream", "/api/v1/control/hold", "/api/v1/components"):
            self.hold(lambda hosts, origins, path=path: self.upgrade(path, hosts, origins, None), 401)

    def test_a_ticket_opens_no_stream_for_a_foreign_page(self):
        for hosts, origins, status in (((HOST,), (EVIL,), 403), ((HOST,), ("null",), 403), (("evil.example:PORT",), (), 421),
                                       ((HOST,), (ORIGIN,), 101)):
            ticket = self.server.post("/tickets", None, "ticket")["ticket"]
            self.assertRegex(ticket, re.compile(r"^\S+$"))
            self.assertEqual(self.upgrade(f"/api/v1/stream?ticket={ticket}", hosts, origins, None), status)

    def test_a_foreign_page_does_not_log_in(self):
        body = json.dumps({"name": "admin", "password": "correct horse battery"})
        for hosts, origins, status in (((HOST,), (EVIL,), 403), (("evil.example:PORT",), (), 421), ((HOST,), (ORIGIN,), 200)):
            self.assertEqual(self.ask("POST /api/v1/login", [*self.lines(hosts, origins), JSON], None, body)[0], status)


if __name__ == "__main__":
    unittest.main()
