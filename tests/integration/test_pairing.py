"""A phone is let in with a code; tokens whose role is below their account's; where the network reaches the server."""
import http.client
import json
import time
import unittest

import models
from accounts import PASSWORD, AccountServer
from client import TIMEOUT, Server, Stream, check
from test_tls import LanServer

PHONE = {"role": "operator", "name": "phone1"}
NONE = "A" * 22  # the code of nobody
DAY = 24 * 3600 * 1000  # [ms]


class PairingCase(unittest.TestCase):
    SERVER = AccountServer

    def setUp(self):
        self.server = self.SERVER()
        self.addCleanup(self.server.stop)

    def as_token(self, token, method, path, body=None):
        """(status, answer) of a request with a token; None: without one."""
        return self.server.request(method, "/api/v1" + path, body, {"Authorization": f"Bearer {token}" if token else ""})

    def code(self, account="operator", **more):
        """A code that an account has made, and the answer that has it."""
        status, made = self.as_token(self.server.tokens[account], "POST", "/pairings", {**PHONE, **more})
        self.assertEqual(status, 201, made)
        check("pairing_created", made)
        return made["code"]

    def pair(self, code, status=200):
        got, answer = self.as_token(None, "POST", "/pair", {"code": code})
        self.assertEqual(got, status, answer)
        return check("pair_answer" if status == 200 else "problem", answer)

    def me(self, token):
        status, me = self.as_token(token, "GET", "/me")
        self.assertEqual(status, 200)
        return check("me", me)

    def tokens(self, account):
        return self.server.get(f"/accounts/{account}/tokens", "account_tokens")["tokens"]


class Pairing(PairingCase):
    def test_a_phone_stands_at_the_cell_if_an_admin_says_so_or_who_does_themselves(self):
        """Nobody makes a display of their own, from afar, that hands the controls over to them."""
        for account, is_local in (("operator", False), ("developer", False), ("admin", True)):
            with self.subTest(account=account):
                self.assertIs(self.me(self.pair(self.code(account))["token"])["local"], is_local)

    def test_a_code_brings_a_token_of_who_made_it(self):
        answer = self.pair(self.code("developer", place="table", days=7))
        self.assertEqual((answer["account"]["name"], answer["role"], answer["name"], answer["place"]),
                         ("developer", "operator", "phone1", "table"))
        self.assertAlmostEqual(answer["expires"], time.time() * 1000 + 7 * DAY, delta=60_000)
        self.assertEqual(self.me(answer["token"]), {"accounts": True, "name": "developer", "role": "operator", "local": False})
        listed = next(token for token in self.tokens("developer") if token["label"] == "phone: phone1")
        self.assertEqual((listed["role"], "local" in listed, listed["name"], listed["expires"]),
                         ("operator", False, "phone1", answer["expires"]))
        usual = self.pair(self.code())
        self.assertNotIn("place", usual)
        self.assertAlmostEqual(usual["expires"], time.time() * 1000 + 30 * DAY, delta=60_000)

    def test_its_token_may_what_its_role_may_and_hands_the_controls_over(self):
        for role, statuses in (("observer", (200, 403, 403)), ("operator", (200, 200, 403))):
            token = self.pair(self.code("admin", role=role))["token"]
            self.assertEqual(tuple(self.as_token(token, method, path)[0] for method, path in (
                ("GET", "/documents"), ("POST", "/stop/reset"), ("GET", "/accounts"))), statuses, role)
        answer = ("POST", "/control/answer", {"request": 1, "allow": True})
        self.assertEqual(self.as_token(self.server.tokens["operator"], *answer)[0], 403)
        self.assertEqual(self.as_token(token, *answer)[0], 404, "nobody has asked")

    def test_its_stream_has_the_role_of_the_token(self):
        token = self.pair(self.code("developer"))["token"]
        with Stream(self.server.port, token=token) as stream:
            stream.send_checked({"type": "display", "name": "phone1"})
            stream.subscribe("display/phone1")
            stream.until(lambda m: m["kind"] == "snapshot" and m["channel"] == "display/phone1")
            stream.send({"type": "edit", "no_such_field": 1})
            self.assertEqual(stream.until(lambda m: m["kind"] == "error")[-1]["data"]["errors"][0]["code"], "rights")

    def test_a_code_is_used_once_and_a_wrong_one_is_answered_alike(self):
        code = self.code()
        self.pair(code)
        used, none = self.pair(code, 401), self.pair(NONE, 401)
        self.assertEqual(used, none)
        self.assertEqual(none["errors"][0]["code"], "pairing")

    def test_codes_cannot_be_guessed_fast(self):
        code = self.code()
        self.assertEqual([self.pair(NONE, 401)["status"] for _ in range(10)], [401] * 10)
        self.assertEqual(self.pair(code, 429)["errors"][0]["code"], "attempts")
        login = self.as_token(None, "POST", "/login", {"name": "admin", "password": PASSWORD})
        self.assertEqual(login[0], 429, "they count as logins")
        connection = http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=TIMEOUT, source_address=("127.0.0.2", 0))
        connection.request("POST", "/api/v1/pair", json.dumps({"code": code}), {"Content-Type": "application/json"})
        self.assertEqual(connection.getresponse().status, 200, "others are not kept out")
        connection.close()

    def refused(self, account):
        """That no code is made any more, which waits for a time; the message."""
        status, problem = self.as_token(self.server.tokens[account], "POST", "/pairings", PHONE)
        self.assertEqual((status, check("problem", problem)["errors"][0]["code"]), (429, "too_many"))
        return problem["errors"][0]["message"]

    def test_at_most_64_codes_wait_and_8_of_an_account(self):
        def log_in(account):
            self.server.tokens[account] = self.server.post(f"/accounts/{account}/tokens", {"label": "x"}, "token_created", 201)["token"]

        def code(account):
            log_in(account)
            return self.code(account)

        for number in range(8):
            guest = f"guest{number}"
            self.server.post("/accounts", {"name": guest, "role": "operator"}, "account", 201)
            codes = [code(guest) for _ in range(8)]
            if number < 7:
                log_in(guest)
                self.assertIn("8 codes of the account", self.refused(guest))
        self.assertIn("64 codes", self.refused("admin"))
        self.pair(codes[0])
        self.code("admin")

    def test_a_new_code_of_a_login_replaces_its_older_one(self):
        codes = [self.code() for _ in range(20)]
        self.assertEqual(self.pair(codes[-2], 401)["errors"][0]["code"], "pairing")
        self.pair(codes[-1])

    def test_who_may_no_more_lets_nobody_in(self):
        changes = {"observer": lambda: self.server.put("/accounts/guest", {"role": "observer"}, "account"),
                   "removed": lambda: self.server.expect("DELETE", "/accounts/guest", None, "account_removed", 200)}
        for name, change in changes.items():
            self.server.post("/accounts", {"name": "guest", "role": "operator", "password": PASSWORD}, "account", 201)
            made = self.server.post("/accounts/guest/tokens", {"label": "page"}, "token_created", 201)
            self.server.tokens["guest"] = made["token"]
            paired, code = self.pair(self.code("guest"))["token"], self.code("guest")
            change()
            self.assertEqual(self.pair(code, 401)["errors"][0]["code"], "pairing", name)
            if name == "observer":
                self.assertEqual(self.me(paired)["role"], "observer", "what is let in may less, too")
                self.server.expect("DELETE", "/accounts/guest", None, "account_removed", 200)
            self.assertEqual(self.as_token(paired, "GET", "/documents")[0], 401)

    def test_its_token_is_revoked_as_others_are_and_logs_out(self):
        for end in ("revoked", "logged out"):
            token = self.pair(self.code())["token"]
            with Stream(self.server.port, token=token) as stream:
                stream.subscribe("cores")
                stream.until(lambda m: m["kind"] == "snapshot")
                if end == "revoked":
                    digest = next(each["digest"] for each in self.tokens("operator") if "name" in each)
                    self.server.expect("DELETE", f"/accounts/operator/tokens/{digest}", None, "token_removed", 200)
                else:
                    self.assertEqual(self.as_token(token, "POST", "/logout")[0], 200)
                with self.assertRaises(ConnectionError):
                    stream.until(lambda m: False)
            self.assertEqual(self.as_token(token, "GET", "/documents")[0], 401)

    def test_a_phone_lets_nobody_in_so_it_ends_when_it_was_to(self):
        for role in ("operator", "observer"):
            phone = self.pair(self.code("admin", role=role))["token"]
            status, problem = self.as_token(phone, "POST", "/pairings", {**PHONE, "role": "observer"})
            self.assertEqual((status, check("problem", problem)["errors"][0]["code"]), (403, "rights"))

    def test_what_is_no_phone_is_refused_with_the_field(self):
        for more, status, path in (({"role": "developer"}, 400, "role"), ({"role": "admin"}, 400, "role"),
                                   ({"role": "process"}, 400, "role"), ({"role": "king"}, 400, "role"),
                                   ({"name": "all"}, 422, "name"), ({"name": "a b"}, 422, "name"),
                                   ({"name": "x" * 33}, 422, "name"), ({"place": ""}, 422, "place"), ({"days": 0}, 400, "days"),
                                   ({"days": 366}, 400, "days"), ({"local": True}, 422, "local")):
            got, problem = self.as_token(self.server.tokens["operator"], "POST", "/pairings", {**PHONE, **more})
            self.assertEqual((got, problem["errors"][0]["path"]), (status, path), more)

    def test_the_audit_log_has_both_without_the_code(self):
        code = self.code("developer")
        self.pair(code)
        self.pair(code, 401)
        self.server.put("/documents/last", models.ticking("last"), "document_entry")
        entries = self.server.audited("PUT")
        self.assertEqual([(e.get("account", ""), e["action"], e["outcome"]) for e in entries[1:4]],
                         [("", "POST /api/v1/pair", "401"), ("developer", "POST /api/v1/pair", "200"),
                          ("developer", "POST /api/v1/pairings", "201")])
        self.assertNotIn(code, json.dumps(entries))


class RolesBelow(PairingCase):
    def test_a_token_may_the_lower_of_the_two_roles(self):
        self.server.post("/accounts", {"name": "guest", "role": "developer", "password": PASSWORD}, "account", 201)
        made = self.server.post("/accounts/guest/tokens", {"label": "program", "role": "operator"}, "token_created", 201)["token"]
        self.assertEqual(self.me(made), {"accounts": True, "name": "guest", "role": "operator", "local": False})
        edit = ("PUT", "/documents/mine", models.ticking("mine"))
        self.assertEqual(self.as_token(made, *edit)[0], 403)
        for of_account, role in (("observer", "observer"), ("admin", "operator")):
            self.server.put("/accounts/guest", {"role": of_account}, "account")
            self.assertEqual(self.me(made)["role"], role)
        listed, = self.tokens("guest")
        self.assertEqual((listed["role"], "local" in listed, "name" in listed), ("operator", False, False))

    def test_a_token_is_not_made_for_more_than_its_account_may(self):
        for account, scope, status, path in (("observer", {"role": "operator"}, 422, "role"),
                                             ("speaker", {"role": "observer"}, 422, "role"),
                                             ("speaker", {"local": True}, 422, "local"), ("admin", {"role": "process"}, 422, "role"),
                                             ("admin", {"role": "king"}, 400, "role"), ("admin", {"local": 1}, 422, "local")):
            problem = self.server.post(f"/accounts/{account}/tokens", {"label": "x", **scope}, None, status)
            self.assertEqual(problem["errors"][0]["path"], path, (account, scope))

    def test_one_of_a_display_hands_the_controls_over(self):
        made = self.server.post("/accounts/operator/tokens", {"label": "display", "local": True}, "token_created", 201)["token"]
        self.assertTrue(self.me(made)["local"])
        self.assertFalse(self.me(self.server.tokens["operator"])["local"])


class WithoutAccounts(unittest.TestCase):
    def test_a_code_is_refused_and_the_first_account_makes_one_possible(self):
        with Server() as server:
            for path, body in (("/pairings", PHONE), ("/pair", {"code": NONE})):
                self.assertEqual(server.post(path, body, None, 409)["errors"][0]["code"], "no_accounts")
            server.post("/accounts", {"name": "ada", "role": "admin", "password": PASSWORD}, "account", 201)
            self.assertEqual(server.post("/pairings", PHONE, None, 401)["errors"][0]["code"], "login")
            server.token = server.post("/login", {"name": "ada", "password": PASSWORD}, "login_answer")["token"]
            made = server.post("/pairings", PHONE, "pairing_created", 201)
            self.assertEqual(server.post("/pair", {"code": made["code"]}, "pair_answer")["account"]["name"], "ada")


class Addresses(unittest.TestCase):
    def test_there_are_none_on_this_machine_alone(self):
        with Server() as server:
            self.assertEqual(server.get("/addresses", "addresses"), {"addresses": []})

    def test_are_those_that_the_log_names_and_lead_to_the_server(self):
        server = LanServer()
        self.addCleanup(server.stop)
        server.token = server.admin
        host = [f"[{name}]" if ":" in name else name for name in server.names]
        expected = [{"url": f"https://{name}:{server.lan_port}"} for name in host]
        self.assertGreater(len(expected), 0)
        self.assertEqual(server.get("/addresses", "addresses")["addresses"], expected)
        made = server.post("/pairings", PHONE, "pairing_created", 201)
        self.assertEqual(made["addresses"], expected)
        body = json.dumps({"code": made["code"]})
        status, _, answer = server.ask("/api/v1/pair", "POST", headers={"Content-Type": "application/json"}, body=body)
        self.assertEqual((status, json.loads(answer)["name"]), (200, "phone1"), "over TLS, as a phone")


if __name__ == "__main__":
    unittest.main()
