"""Accounts, tokens and tickets; who may not use what; authors; the audit log."""
import http.client
import json
import shutil
import subprocess
import time
import unittest

import models
from accounts import PASSWORD, ROLES, AccountServer, race_account
from client import TIMEOUT, Server, Stream, check


class AccountCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = AccountServer()
        cls.addClassCleanup(cls.server.stop)

    def login(self, name, password=PASSWORD, status=200):
        return self.server.expect("POST", "/login", {"name": name, "password": password}, "login_answer", status)


class Logins(AccountCase):
    def test_a_password_brings_a_token_of_the_account(self):
        answer = self.login("developer")
        self.assertEqual(answer["account"]["role"], "developer")
        self.assertAlmostEqual(answer["expires"], (time.time() + 12 * 3600) * 1000, delta=60_000)
        own = {"Authorization": f"Bearer {answer['token']}"}
        me = check("me", self.server.request("GET", "/api/v1/me", headers=own)[1])
        self.assertEqual(me, {"accounts": True, "name": "developer", "role": "developer", "local": False})
        self.assertEqual(self.server.request("POST", "/api/v1/logout", headers=own)[0], 200)
        self.assertEqual(self.server.request("GET", "/api/v1/documents", headers=own)[0], 401)

    def test_a_name_that_is_none_and_a_wrong_password_look_the_same(self):
        wrong, nobody = (self.login(name, "wrong password", 401) for name in ("observer", "nobody"))
        self.assertEqual(wrong, nobody)
        process = self.login("speaker", "", 401)
        self.assertEqual(process, nobody, "a process has no password")

    def test_who_is_not_known_learns_nothing(self):
        for path in ("/documents", "/cores", "/nothing", "/accounts", "/me/password", "/stream"):
            status, answer = self.server.request("GET", "/api/v1" + path, headers={"Authorization": ""})
            self.assertEqual((status, answer["errors"][0]["code"]), (401, "login"), path)
        self.assertEqual(self.server.ask(None, "GET", "/api/v1/health"), 200)
        status, me = self.server.request("GET", "/api/v1/me", headers={"Authorization": ""})
        self.assertEqual((status, me), (200, {"accounts": True}))

    def test_passwords_cannot_be_guessed_fast(self):
        with AccountServer() as server:
            guess = {"name": "admin", "password": "guess number"}
            statuses = [server.request("POST", "/api/v1/login", guess)[0] for _ in range(14)]
            self.assertEqual(statuses[:10], [401] * 10)
            self.assertEqual(statuses[-1], 429)
            right = {"name": "admin", "password": PASSWORD}
            status, answer = server.request("POST", "/api/v1/login", right)
            self.assertEqual((status, answer["errors"][0]["code"]), (429, "attempts"))
            self.assertEqual(server.ask("admin", "GET", "/api/v1/documents"), 200, "tokens are not concerned")

    def test_the_owner_logs_in_where_they_did_before_while_others_guess(self):
        with AccountServer() as server:
            def login(address, password):
                connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=TIMEOUT, source_address=(address, 0))
                connection.request("POST", "/api/v1/login", json.dumps({"name": "admin", "password": password}),
                                   {"Content-Type": "application/json", "Host": f"127.0.0.1:{server.port}"})
                status = connection.getresponse().status
                connection.close()
                return status

            self.assertEqual(login("127.0.0.1", PASSWORD), 200)
            guesses = [login(f"127.0.0.{address}", "guess number") for address in range(2, 8) for _ in range(10)]
            self.assertEqual(guesses[:50], [401] * 50)
            self.assertIn(429, guesses)
            self.assertEqual(login("127.0.0.9", PASSWORD), 429, "from elsewhere they wait")
            self.assertEqual(login("127.0.0.1", PASSWORD), 200)

    def test_a_new_password_needs_the_old_one_and_ends_what_it_has_brought(self):
        token = self.login("operator")["token"]
        own = {"Authorization": f"Bearer {token}"}

        def change(old, new):
            return self.server.request("PUT", "/api/v1/me/password", {"old": old, "password": new}, own)[0]

        self.assertEqual(change("another one", "a new password"), 403)
        self.assertEqual(change(PASSWORD, "short"), 400)
        self.assertEqual(change(PASSWORD, "a new password"), 200)
        self.assertEqual(self.server.request("GET", "/api/v1/documents", headers=own)[0], 401)
        self.login("operator", status=401)
        self.login("operator", "a new password")
        self.server.put("/accounts/operator", {"password": PASSWORD}, "account")


class Administration(AccountCase):
    def test_accounts_are_made_changed_and_removed(self):
        self.server.post("/accounts", {"name": "eve", "role": "observer", "password": PASSWORD}, "account", 201)
        names = [account["name"] for account in self.server.get("/accounts", "accounts")["accounts"]]
        self.assertEqual(names, sorted([*ROLES, "eve", "speaker"]))
        self.assertEqual(self.login("eve")["account"]["role"], "observer")
        self.server.put("/accounts/eve", {"role": "developer"}, "account")
        self.assertEqual(self.login("eve")["account"]["role"], "developer")
        self.server.post("/accounts", {"name": "eve", "role": "admin", "password": PASSWORD}, status=409)
        self.server.expect("DELETE", "/accounts/eve", None, "account_removed", 200)
        self.server.expect("DELETE", "/accounts/eve", None, None, 404)
        self.login("eve", status=401)

    def test_what_is_no_account_is_refused_with_the_field(self):
        for body, status, path in (({"name": "a b", "role": "admin"}, 422, "name"), ({"name": "a", "role": "king"}, 400, "role"),
                                   ({"name": "a", "role": "admin", "password": "short"}, 400, "password"),
                                   ({"name": "a", "role": "process"}, 422, "groups"), ({"role": "admin"}, 422, "name"),
                                   ({"name": "a", "role": "process", "groups": ["oven"]}, 400, "groups/0"),
                                   ({"name": "a", "role": "admin", "hash": "x"}, 422, "hash")):
            answer = self.server.post("/accounts", body, status=status)
            self.assertEqual(answer["errors"][0]["path"], path)

    def test_the_last_admin_stays(self):
        self.assertEqual(self.server.expect("DELETE", "/accounts/admin", None, None, 409)["errors"][0]["code"], "conflict")
        self.server.put("/accounts/admin", {"role": "observer"}, status=409)

    def test_tokens_are_listed_without_their_secret_and_revoked(self):
        made = self.server.post("/accounts/observer/tokens", {"label": "plotter", "days": 7}, "token_created", 201)
        self.assertRegex(made["token"], r"^race_[\w-]{43}$")
        listed = self.server.get("/accounts/observer/tokens", "account_tokens")["tokens"]
        entry = next(token for token in listed if token["digest"] == made["digest"])
        self.assertEqual(entry["label"], "plotter")
        self.assertNotIn(made["token"], json.dumps(listed))
        own = {"Authorization": f"Bearer {made['token']}"}
        self.assertEqual(self.server.request("GET", "/api/v1/documents", headers=own)[0], 200)
        self.server.expect("DELETE", f"/accounts/observer/tokens/{made['digest']}", None, "token_removed", 200)
        self.assertEqual(self.server.request("GET", "/api/v1/documents", headers=own)[0], 401)


class Streams(AccountCase):
    def stream(self, account):
        return Stream(self.server.port, token=self.server.tokens[account])

    def test_a_ticket_opens_one_stream(self):
        ticket = self.server.post("/tickets", None, "ticket")["ticket"]
        with Stream(self.server.port, ticket=ticket) as stream:
            self.assertEqual(stream.status, 101)
            stream.subscribe("cores")
            stream.until(lambda m: m["kind"] == "snapshot")
        with Stream(self.server.port, ticket=ticket) as again, Stream(self.server.port) as nobody:
            self.assertEqual((again.status, nobody.status), (401, 401))

    def test_a_message_needs_its_right(self):
        self.server.put("/documents/t", models.ticking("t"), "document_entry")
        edit = {"type": "edit", "document": "t", "request": "e1", "revision": 1, "author": "operator",
                "operations": [{"op": "set", "id": "nothing", "field": "doc", "value": "x"}]}
        with self.stream("operator") as stream:
            stream.send_checked(edit)
            refused = stream.until(lambda m: m["kind"] == "error")[-1]
            self.assertEqual(refused["data"]["errors"][0]["code"], "rights")
        with self.stream("observer") as stream:
            stream.send_checked({"type": "display", "name": "phone"})
            refused = stream.until(lambda m: m["kind"] == "error")[-1]
            self.assertEqual(refused["data"]["errors"][0]["code"], "rights")

    def test_ends_when_its_account_may_no_more(self):
        self.server.post("/accounts", {"name": "guest", "role": "observer", "password": PASSWORD}, "account", 201)
        token = self.login("guest")["token"]
        with Stream(self.server.port, token=token) as stream:
            stream.subscribe("cores")
            stream.until(lambda m: m["kind"] == "snapshot")
            self.server.expect("DELETE", "/accounts/guest", None, "account_removed", 200)
            with self.assertRaises(ConnectionError):
                stream.until(lambda m: False)


class Authors(AccountCase):
    def test_a_change_is_of_who_makes_it(self):
        def put(author):
            return self.server.request("PUT", f"/api/v1/documents/mine{author}", models.ticking("mine"))

        status, entry = put("")
        self.assertEqual((status, entry["author"]), (201, "admin"))
        for author, said in (("?author=admin~x", 200), ("?author=eve", 403), ("?author=admin2", 403)):
            status, answer = put(author)
            self.assertEqual(status, said, author)
            if said == 403:
                self.assertEqual((answer["errors"][0]["path"], answer["errors"][0]["code"]), ("author", "rights"))


class Audit(AccountCase):
    def test_says_who_has_changed_what(self):
        self.server.put("/documents/audited", models.ticking("audited"), "document_entry")
        self.server.ask("observer", "DELETE", "/api/v1/documents/audited")
        self.login("developer")
        self.login("developer", "wrong password", 401)
        self.server.get("/documents", "documents")
        self.server.wait_for(lambda: len(self.server.get("/audit", "audit")["entries"]) >= 3)
        entries = self.server.get("/audit?limit=3", "audit")["entries"]
        self.assertEqual([(e["account"], e["action"], e["outcome"]) for e in entries],
                         [("developer", "POST /api/v1/login", "401"), ("developer", "POST /api/v1/login", "200"),
                          ("admin", "PUT /api/v1/documents/audited", "201")])
        self.assertEqual({e["address"] for e in entries}, {"127.0.0.1"})
        self.assertLess(abs(entries[0]["time"] - time.time() * 1000), 60_000)


    def test_a_stranger_cannot_fill_it(self):
        with AccountServer() as server:
            for body, headers in (({"name": "admin", "password": "guess number"}, {}), ({"name": 1}, {}), ("{", {})):
                for _ in range(30):
                    server.request("POST", "/api/v1/login", body, {"Authorization": "", **headers})
            for _ in range(30):
                server.ask(None, "POST", "/api/v1/login?more=1")
                server.ask(None, "POST", "/api/v1/stop")
            server.put("/documents/last", models.ticking("last"), "document_entry")
            rows = [(e["action"], e["outcome"]) for e in server.audited("PUT")]
            self.assertEqual(set(rows), {("POST /api/v1/login", "401"), ("POST /api/v1/stop", "200"),
                                         ("PUT /api/v1/documents/last", "201")})
            self.assertLessEqual(rows.count(("POST /api/v1/login", "401")), 15)
            self.assertEqual(rows.count(("POST /api/v1/stop", "200")), 2, "the one that latches, and one a minute")


class Demo(unittest.TestCase):
    def test_a_server_without_accounts_is_open_until_it_has_one(self):
        with Server() as server, server.stream() as stream:
            self.assertEqual(server.get("/me", "me"), {"accounts": False, "role": "admin", "local": True})
            server.post("/accounts", {"name": "eve", "role": "observer", "password": PASSWORD}, status=422)
            server.post("/accounts", {"name": "ada", "role": "admin", "password": PASSWORD}, "account", 201)
            self.assertEqual(server.request("GET", "/api/v1/documents")[0], 401)
            with self.assertRaises(ConnectionError):  # whoever it was
                stream.until(lambda m: False)

    def test_the_command_line_lists_what_it_has_made(self):
        with AccountServer() as server:
            data = server.data
            with self.assertRaises(subprocess.CalledProcessError) as held:
                race_account(data, "list")
            self.assertIn("another server uses this folder", held.exception.stderr)
            server.own = False
        self.addCleanup(shutil.rmtree, data)
        lines = [line.split() for line in race_account(data, "list").splitlines()]
        self.assertEqual(lines, [["admin"] * 2, ["developer"] * 2, ["observer"] * 2, ["operator"] * 2, ["speaker", "process", "audio"]])


if __name__ == "__main__":
    unittest.main()
