"""Proposed changes of documents: who may propose and decide, what is refused, told, kept, and bounded; of several who accept, one does."""
import threading
import unittest

import models
from accounts import ROLES, AccountServer
from client import Stream, check
from server_case import ServerCase

MOST, MOST_OF_AUTHOR, MOST_DECIDED, LONGEST = 100, 20, 200, 2000


def better(last=7, name="task"):
    return models.ticking(name, last=last)


def codes(answer):
    return [(error["path"], error["code"]) for error in answer["errors"]]


class ProposalCase(ServerCase):
    """A server with the document `task`."""

    def setUp(self):
        super().setUp()
        self.server.put("/documents/task", models.ticking("task"), "document_entry")

    def propose(self, document=None, name="task", revision=1, author="agent", status=201, **more):
        body = {"document": better(name=name) if document is None else document, "revision": revision, **more}
        return self.server.post(f"/documents/{name}/proposals?author={author}", body, "proposal", status)

    def proposal(self, id):
        return self.server.get(f"/proposals/{id}", "proposal")

    def accept(self, id, author="Ada", status=200):
        return self.server.post(f"/proposals/{id}/accept?author={author}", None, "proposal", status)

    def decline(self, id, reason=None, status=200):
        return self.server.post(f"/proposals/{id}/decline?author=Ada", {} if reason is None else {"reason": reason}, "proposal", status)

    def withdraw(self, id, status=200):
        return self.server.expect("DELETE", f"/proposals/{id}", None, "proposal", status)

    def listed(self, query=""):
        return [each["id"] for each in self.server.get("/proposals" + query, "proposals")["proposals"]]

    def entry(self, name="task"):
        return self.server.get(f"/documents/{name}", "document_entry")


class Deciding(ProposalCase):
    def test_a_proposal_changes_nothing_until_it_is_accepted(self):
        before = self.entry()
        made = self.propose(note="seven ticks are enough")
        self.assertEqual(self.entry(), before)
        self.assertEqual({key: made[key] for key in ("document", "base_revision", "author", "note", "status")},
                         {"document": "task", "base_revision": 1, "author": "agent", "note": "seven ticks are enough", "status": "open"})
        self.assertEqual(models.without_ids(made["proposed"])["root"], better()["root"])
        self.assertEqual(made["proposed"]["root"]["meta"], before["document"]["root"]["meta"], "it keeps the ids of its revision")
        self.assertEqual(self.proposal(made["id"]), made)
        accepted = self.accept(made["id"])
        self.assertEqual((accepted["status"], accepted["decided_by"], accepted["revision"]), ("accepted", "Ada", 2))
        after = self.entry()
        self.assertEqual((after["revision"], after["author"], after["message"]), (2, "Ada", "seven ticks are enough"))
        self.assertEqual(after["origin"], {"kind": "proposal", "author": "agent", "proposal": made["id"]})
        self.assertEqual(after["document"], made["proposed"])
        self.assertEqual(self.server.get("/documents/task/revisions", "revisions")["revisions"][0]["origin"], after["origin"])
        self.assertEqual(codes(self.accept(made["id"], status=409)), [(made["id"], "conflict")])
        self.decline(made["id"], status=409)
        self.withdraw(made["id"], 409)

    def test_who_accepts_can_take_it_back_also_after_a_restart(self):
        self.server.post("/documents/task/edits", {"revision": 1, "author": "Ada~1", "operations": [
            {"op": "set", "id": self.entry()["document"]["root"]["meta"]["id"], "field": "doc", "value": "x"}]}, "accepted_edit")
        self.accept(self.propose(revision=2)["id"], "Ada~1")
        self.restart()
        undone = self.server.post("/documents/task/edits", {"revision": 3, "author": "Ada~1", "undo": True}, "accepted_edit")
        self.assertEqual((undone["revision"], undone["of"]), (4, 3))
        self.assertEqual(self.entry()["document"]["root"]["doc"], "x")

    def test_a_new_document_is_proposed_and_made(self):
        made = self.propose(name="fresh", revision=None)
        self.assertIsNone(made["base_revision"])
        self.server.get("/documents/fresh", status=404)
        absent = self.server.post("/documents/other/proposals", {"document": better(name="other")}, "proposal", 201)
        self.assertIsNone(absent["base_revision"])
        self.assertEqual(self.accept(made["id"])["revision"], 1)
        self.assertEqual(self.entry("fresh")["origin"]["kind"], "proposal")
        self.propose(name="fresh", revision=None, status=409)

    def test_one_of_an_earlier_revision_stays_open_and_says_that_it_is_outdated(self):
        made, rival = self.propose(), self.propose(better(9))
        self.accept(rival["id"])
        self.assertEqual(self.proposal(made["id"])["status"], "outdated")
        refused = self.accept(made["id"], status=409)
        self.assertEqual(codes(refused), [("task", "conflict")])
        self.assertIn("the last revision is 2", refused["errors"][0]["message"])
        self.assertEqual(self.entry()["revision"], 2)
        self.assertEqual(self.listed("?status=outdated"), [made["id"]])
        self.assertEqual(self.listed("?status=open"), [])
        self.assertEqual(self.propose(revision=1, status=409)["errors"][0]["code"], "conflict")
        self.assertEqual(self.decline(made["id"], "too late")["reason"], "too late")
        self.server.expect("DELETE", "/documents/task", None, "document_removed", 200)
        self.assertEqual(self.proposal(rival["id"])["status"], "accepted")

    def test_what_could_not_be_stored_is_refused_as_when_it_is_put(self):
        wrong = better()
        wrong["root"]["first"] = "Nowhere"
        torn = {**better(), "more": 1}
        for document in (wrong, torn, {}):
            put = self.server.put("/documents/task", document, status=422)
            self.assertEqual(self.propose(document, status=422)["errors"], put["errors"])
        for body, path in (({}, "document"), ({"document": []}, "document"), ({"document": better(), "revision": 0}, "revision"),
                           ({"document": better(), "revision": "1"}, "revision"), ({"document": better(), "note": 1}, "note"),
                           ({"document": better(), "more": 1}, "more")):
            with self.subTest(path):
                refused = self.server.post("/documents/task/proposals", body, status=422)
                self.assertIn(path, [error["path"] for error in refused["errors"]])
        self.server.post("/documents/no%20name/proposals", {"document": better()}, status=422)
        self.propose(name="nothing", revision=1, status=409)
        self.assertEqual(self.listed(), [])

    def test_there_is_nothing_of_a_number_that_none_has(self):
        for id in ("7", "x", "-1", "99999999999999999999"):
            self.server.get(f"/proposals/{id}", status=404)
            self.accept(id, status=404)
            self.decline(id, status=404)
            self.withdraw(id, 404)
        for query in ("?status=opened", "?limit=0", "?limit=101", "?after=x"):
            self.server.get("/proposals" + query, status=400)

    def test_declined_without_a_body_and_withdrawn(self):
        made, other = self.propose(), self.propose(better(9))
        self.assertEqual(self.server.request("POST", f"/api/v1/proposals/{made['id']}/decline")[1]["status"], "declined")
        self.assertNotIn("reason", self.proposal(made["id"]))
        self.assertEqual(self.withdraw(other["id"])["status"], "withdrawn")
        self.assertEqual(self.entry()["revision"], 1)

    def test_sent_again_with_its_key_it_is_made_once(self):
        body = {"document": better(), "revision": 1}
        answers = [self.server.request("POST", "/api/v1/documents/task/proposals", body, {"Idempotency-Key": "k1"}) for _ in range(2)]
        self.assertEqual(answers[0], answers[1])
        self.assertEqual(self.listed(), [answers[0][1]["id"]])

    def test_of_many_who_accept_at_once_exactly_one_does(self):
        for round in range(1, 6):
            ids = [self.propose(better(10 + 2 * round + i), revision=round)["id"] for i in range(2)]
            answers = []

            def decide(id, ids=ids, answers=answers):
                answers.append(self.server.request("POST", f"/api/v1/proposals/{id}/accept")[0])

            threads = [threading.Thread(target=decide, args=(ids[i % 2],)) for i in range(6)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertEqual(sorted(answers), [200] + 5 * [409])
            self.assertEqual(self.entry()["revision"], round + 1)
            statuses = sorted(self.proposal(id)["status"] for id in ids)
            self.assertEqual(statuses, ["accepted", "outdated"])


class Keeping(ProposalCase):
    def test_they_are_kept_over_a_restart_and_a_crash(self):
        made, taken = self.propose(note="why"), self.propose(better(9))
        self.accept(taken["id"])
        kept = [self.proposal(each["id"]) for each in (made, taken)]
        for again in (self.restart, self.kill):
            again()
            self.assertEqual([self.proposal(each["id"]) for each in (made, taken)], kept)
            with self.server.stream() as stream:
                stream.subscribe("proposals")
                self.assertEqual([each["id"] for each in stream.message()["data"]["proposals"]], [made["id"]])

    def test_a_backup_has_them_and_no_number_comes_twice(self):
        kept = self.propose()
        backup = self.server.post("/backups", None, "backup", 201)["name"]
        self.decline(kept["id"])
        later = self.propose(better(9))
        with self.server.stream() as stream:
            stream.subscribe("proposals")
            stream.message()
            self.server.post(f"/backups/{backup}/restore", None, "backup")
            told = stream.until(lambda m: m["kind"] == "snapshot")[-1]
            self.assertEqual([each["id"] for each in told["data"]["proposals"]], [kept["id"]])
        self.assertEqual(self.proposal(kept["id"])["status"], "open")
        self.server.get(f"/proposals/{later['id']}", status=404)
        self.assertGreater(int(self.propose(better(9))["id"]), int(later["id"]))

    def test_they_are_listed_in_pages(self):
        ids = [self.propose(better(10 + i))["id"] for i in range(5)]
        other = self.propose(name="fresh", revision=None)["id"]
        page = self.server.get("/proposals?document=task&limit=3", "proposals")
        self.assertEqual(([each["id"] for each in page["proposals"]], page["next"]), (ids[:3], ids[2]))
        last = self.server.get(f"/proposals?document=task&limit=3&after={page['next']}", "proposals")
        self.assertEqual(([each["id"] for each in last["proposals"]], "next" in last), (ids[3:], False))
        self.assertEqual(self.listed("?document=fresh"), [other])
        self.assertEqual(self.listed(), [*ids, other])
        self.assertNotIn("proposed", page["proposals"][0])

    def test_they_are_bounded(self):
        for i in range(MOST_OF_AUTHOR):
            self.propose(author=f"a~{i}")
        self.assertEqual(codes(self.propose(author="a~x", status=413)), [("author", "too_large")])
        for i in range(MOST_OF_AUTHOR, MOST):
            self.propose(author=f"b{i}")
        self.assertEqual(codes(self.propose(author="c", status=413)), [("", "too_large")])
        self.assertEqual(len(self.listed()), MOST)
        self.withdraw(self.listed("?limit=1")[0])
        self.propose(author="a~x")
        self.assertEqual(codes(self.propose(author="d" * 101, status=413)), [("author", "too_large")])

    def test_notes_and_reasons_are_bounded(self):
        self.propose(note=(LONGEST + 1) * "n", status=413)
        made = self.propose(note=LONGEST * "é")
        self.decline(made["id"], (LONGEST + 1) * "r", status=413)
        self.assertEqual(len(self.decline(made["id"], LONGEST * "é")["reason"]), LONGEST)

    def test_of_the_decided_ones_the_last_are_kept(self):
        first = self.propose()["id"]
        self.decline(first)
        for _ in range(MOST_DECIDED - 1):
            self.withdraw(self.propose()["id"])
        self.proposal(first)
        self.withdraw(self.propose()["id"])
        self.server.get(f"/proposals/{first}", status=404)


class Telling(ProposalCase):
    def told(self, stream, count):
        """(id, status) of the next so many."""
        found = []
        while len(found) < count:
            message = stream.message()
            self.assertEqual((message["channel"], message["kind"]), ("proposals", "delta"))
            found += [(each["id"], each["status"]) for each in message["data"]["proposals"]]
        return found

    def test_the_channel_tells_of_each_change_of_an_open_one(self):
        before = self.propose(note="why")["id"]
        with self.server.stream() as stream:
            stream.subscribe("proposals")
            first = stream.message()
            self.assertEqual(first["kind"], "snapshot")
            shown = self.proposal(before)
            del shown["proposed"]
            self.assertEqual(first["data"], {"proposals": [shown]})
            made, fresh = self.propose(better(9))["id"], self.propose(name="fresh", revision=None)["id"]
            self.decline(before)
            self.assertEqual(self.told(stream, 3), [(made, "open"), (fresh, "open"), (before, "declined")])
            root = self.entry()["document"]["root"]["meta"]["id"]
            for revision in (1, 2):
                self.server.post("/documents/task/edits", {"revision": revision, "author": "Eve", "operations": [
                    {"op": "set", "id": root, "field": "doc", "value": f"{revision}"}]}, "accepted_edit")
            self.server.put("/documents/fresh", better(name="fresh"), "document_entry")
            self.server.expect("DELETE", "/documents/fresh", None, "document_removed", 200)
            self.accept(fresh)
            self.assertEqual(self.told(stream, 4), [(made, "outdated"), (fresh, "outdated"), (fresh, "open"), (fresh, "accepted")])

    def test_a_run_that_follows_the_document_goes_on_with_it(self):
        core = self.server.core(models.ticking("live", last=1000000))
        self.server.put(f"/cores/{core}/live", {"live": True}, "core")
        made = self.propose(models.ticking("live", last=1), name="live")
        self.assertEqual(self.server.get(f"/cores/{core}", "core")["revision"], 1)
        self.accept(made["id"])
        self.server.wait(core, lambda c: c["revision"] == 2 and "waiting_edit" not in c)

    def test_who_has_the_document_open_gets_it_as_an_edit(self):
        made = self.propose()["id"]
        with self.server.stream() as stream:
            stream.subscribe("document/task")
            stream.message()
            self.accept(made)
            accepted = stream.message()
            self.assertEqual((accepted["kind"], accepted["data"]["revision"], accepted["data"]["author"]), ("delta", 2, "Ada"))


class Rights(unittest.TestCase):
    """With accounts. That each route is for whom the table says: test_rights."""

    def setUp(self):
        self.server = AccountServer()
        self.addCleanup(self.server.stop)
        self.server.put("/documents/task", models.ticking("task"), "document_entry")

    def ask(self, account, method, path, body=None):
        headers = {"Authorization": f"Bearer {self.server.tokens[account]}"}
        return self.server.request(method, "/api/v1" + path, body, headers)

    def propose(self, account, author=""):
        query = f"?author={author}" if author else ""
        return self.ask(account, "POST", f"/documents/task/proposals{query}", {"document": better(), "revision": 1})

    def test_who_may_propose_decide_and_withdraw(self):
        self.assertEqual(self.propose("observer")[0], 403)
        made = {role: check("proposal", self.propose(role)[1]) for role in ROLES[1:]}
        self.assertEqual([each["author"] for each in made.values()], list(ROLES[1:]))
        self.assertEqual(self.propose("operator", "admin")[0], 403, "nobody proposes as somebody else")
        self.assertEqual(self.propose("operator", "operator~p1")[1]["author"], "operator~p1")
        for what in ("accept", "decline"):
            self.assertEqual(self.ask("operator", "POST", f"/proposals/{made['operator']['id']}/{what}")[0], 403)
        status, refused = self.ask("operator", "DELETE", f"/proposals/{made['admin']['id']}")
        self.assertEqual((status, codes(refused)), (403, [(made["admin"]["id"], "rights")]))
        self.assertEqual(self.ask("operator", "DELETE", f"/proposals/{made['operator']['id']}")[1]["decided_by"], "operator")
        self.assertEqual(self.ask("developer", "DELETE", f"/proposals/{made['admin']['id']}")[1]["status"], "withdrawn")
        accepted = self.ask("developer", "POST", f"/proposals/{made['developer']['id']}/accept")[1]
        self.assertEqual((accepted["decided_by"], accepted["revision"]), ("developer", 2))
        self.assertEqual(self.ask("observer", "GET", f"/proposals/{made['developer']['id']}")[0], 200)

    def test_the_audit_log_says_who_proposed_and_who_decided(self):
        made = self.propose("operator")[1]["id"]
        self.ask("developer", "POST", f"/proposals/{made}/accept")
        rows = self.server.audited("accept")
        self.assertEqual([(row["account"], row["action"], row["outcome"]) for row in rows[:2]],
                         [("developer", f"POST /api/v1/proposals/{made}/accept", "200"),
                          ("operator", "POST /api/v1/documents/task/proposals", "201")])

    def test_what_somebody_has_proposed_whose_account_is_removed_is_decided_all_the_same(self):
        made = self.propose("operator")[1]["id"]
        self.server.expect("DELETE", "/accounts/operator", None, "account_removed", 200)
        self.assertEqual(self.propose("operator")[0], 401)
        self.assertEqual(self.ask("developer", "POST", f"/proposals/{made}/accept")[1]["author"], "operator")

    def test_an_observer_hears_of_them(self):
        with Stream(self.server.port, token=self.server.tokens["observer"]) as stream:
            stream.subscribe("proposals")
            self.assertEqual(stream.message()["data"], {"proposals": []})
            made = self.propose("operator")[1]["id"]
            self.assertEqual(stream.message()["data"]["proposals"][0]["id"], made)


if __name__ == "__main__":
    unittest.main()
