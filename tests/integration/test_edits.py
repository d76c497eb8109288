"""Several authors edit a document, over REST and the stream: what is rebased, rejected, undone, shown and kept."""
import json
import unittest

import models
from client import PROJECT
from document_replica import Replica, apply, elements
from server_case import ServerCase


def task(name="task", **root):
    return models.document(name, {
        "state": "Root", "meta": {"id": "r"}, "first": "A",
        "variables": [{"name": "v", "initial": 0, "meta": {"id": "v"}}],
        "children": [
            {"state": "A", "meta": {"id": "a"}, "ports": [{"name": "done", "when": "var.v > 0", "to": "B", "meta": {"id": "ad"}}]},
            {"state": "B", "meta": {"id": "b"}, "children": [{"state": "X", "meta": {"id": "x"}}], "first": "X"},
            {"state": "C", "meta": {"id": "c"}},
            {"barrier": "Both", "to": ["B", "C"], "meta": {"id": "both"}}], **root})


def doc(id, text):
    return {"op": "set", "id": id, "field": "doc", "value": text}


def insert(id, after=None, parent="r"):
    place = {"after": after} if after else {}
    return {"op": "insert", "parent": parent, "list": "children", **place, "node": {"state": id.upper(), "meta": {"id": id}}}


def remove(id):
    return {"op": "remove", "id": id}


def codes(answer):
    return [(error["path"], error["code"]) for error in answer["errors"]]


class EditTest(ServerCase):
    """A server with the document `task`."""

    def setUp(self):
        super().setUp()
        self.server.put("/documents/task", task(), "document_entry")

    def edit(self, *operations, author="Ada", revision=1, status=200, name="task", **more):
        what = {"operations": list(operations)} if operations else {}
        body = {"revision": revision, "author": author, **what, **more}
        return self.server.post(f"/documents/{name}/edits", body, "accepted_edit", status)

    def entry(self, name="task"):
        return self.server.get(f"/documents/{name}", "document_entry")

    def document(self, name="task"):
        return self.entry(name)["document"]

    def element(self, id):
        return next(each for each, *_ in elements(self.document()) if each["meta"]["id"] == id)

    def children(self):
        return [child["meta"]["id"] for child in self.document()["root"]["children"]]

    def subscribe(self, stream, replica, since=None):
        stream.subscribe("document/task", since)
        if since is None:
            replica.take(stream.message())


class Vectors(unittest.TestCase):
    def test_the_replica_of_these_tests_applies_what_every_client_does(self):
        folder = PROJECT / "api/examples/edits"
        files = sorted([*folder.glob("apply.*.json"), *folder.glob("compound.*.json")])
        self.assertGreater(len(files), 10)
        for file in files:
            vector = json.loads(file.read_text())
            apply(vector["document"], vector["edit"]["operations"])
            self.assertEqual(vector["document"], vector["result"], file.name)


class OverRest(EditTest):
    def test_an_edit_is_a_revision_with_author_message_and_operations(self):
        accepted = self.edit(doc("a", "first"), message="why")
        self.assertEqual((accepted["document"], accepted["revision"], accepted["author"], accepted["message"]),
                         ("task", 2, "Ada", "why"))
        self.assertEqual((accepted["kind"], accepted["operations"], accepted["undo"], accepted["redo"]),
                         ("change", [doc("a", "first")], 1, 0))
        entry = self.entry()
        self.assertEqual((entry["revision"], entry["author"], entry["message"], entry["origin"]),
                         (2, "Ada", "why", {"kind": "edit"}))
        self.assertEqual((self.element("a")["doc"], entry["time"]), ("first", accepted["time"]))

    def test_late_edits_of_two_authors_are_rebased(self):
        self.edit(insert("n", "a"), author="Ada")
        late = self.edit(insert("m", "a"), doc("c", "Bob's"), author="Bob")
        self.assertEqual(late["revision"], 3)
        self.assertEqual(self.children(), ["a", "m", "n", "b", "c", "both"])
        self.edit(remove("n"), author="Ada", revision=3)
        self.assertEqual(self.edit(insert("o", "n"), author="Bob", revision=3)["operations"], [insert("o", "m")])
        self.edit(doc("c", "Ada's, later"), author="Ada")  # of what both set, the later one is
        self.assertEqual(self.element("c")["doc"], "Ada's, later")

    def test_a_rejection_names_author_and_revision_and_changes_nothing(self):
        self.edit(remove("c"), {"op": "set", "id": "both", "field": "to", "value": ["B"]}, author="Ada")
        refused = self.edit(doc("b", "ok"), doc("c", "no"), author="Bob", status=409)
        [error] = refused["errors"]
        self.assertEqual((error["path"], error["code"]), ("operations/1/id", "conflict"))
        self.assertIn("Ada", error["message"])
        self.assertIn("2", error["message"])
        self.assertEqual(self.entry()["revision"], 2)
        self.assertNotIn("doc", self.element("b"))

    def test_if_match_is_a_strict_precondition_and_stands_for_the_revision(self):
        path, body = "/api/v1/documents/task/edits", {"author": "Bob", "operations": [doc("a", "x")]}
        status, accepted = self.server.request("POST", path, body, {"If-Match": '"1"'})
        self.assertEqual((status, accepted["revision"]), (200, 2))
        status, refused = self.server.request("POST", path, body, {"If-Match": '"1"'})
        self.assertEqual((status, codes(refused)), (412, [("If-Match", "conflict")]))
        status, refused = self.server.request("POST", path, {**body, "revision": 1}, {"If-Match": '"3"'})
        self.assertEqual((status, codes(refused)), (412, [("If-Match", "conflict")]))
        status, refused = self.server.request("POST", path, body)
        self.assertEqual((status, codes(refused)), (400, [("revision", "missing")]))
        for tag in ('W/"2"', "2", '""', '"0"', '"-2"', '"2", "3"', "*", '"99999999999999999999"'):
            status, refused = self.server.request("POST", path, body, {"If-Match": tag})
            self.assertEqual((status, codes(refused)), (400, [("If-Match", "out_of_range")]), tag)
        self.assertEqual(self.entry()["revision"], 2)

    def test_what_does_not_fit_is_refused_with_its_path(self):
        one = {"operations": [doc("a", "x")]}
        for body, status, refused in (
                ([], 422, [("", "type"), ("operations", "missing")]), ({"revision": 1}, 422, [("operations", "missing")]),
                ({"revision": 1, "undo": True, "redo": True}, 422, [("operations", "missing")]),
                ({"revision": 1, "undo": False}, 400, [("undo", "out_of_range")]),
                ({"revision": 0, **one}, 400, [("revision", "out_of_range")]),
                ({"revision": 2, **one}, 400, [("revision", "out_of_range")]),
                ({"revision": 1, "request": "a b", **one}, 422, [("request", "name")]),
                ({"revision": 1, "request": "x" * 65, **one}, 422, [("request", "name")]),
                ({"revision": 1, "author": "x" * 101, **one}, 413, [("author", "too_large")]),
                ({"revision": 1, "message": "x" * 1001, **one}, 413, [("message", "too_large")]),
                ({"revision": 1, "more": 1, **one}, 422, [("more", "unknown_field")]),
                ({"revision": 1, "operations": [doc("a", "x"), {"op": "burn"}]}, 422, [("operations/1/op", "name")]),
                ({"revision": 1, "operations": [doc("nobody", "x")]}, 422, [("operations/0/id", "not_found")]),
                ({"revision": 1, "operations": [insert("a")]}, 422, [("operations/0/node", "duplicate")]),
                ({"revision": 1, "compound": {"kind": "burn"}}, 422, [("compound/kind", "name")]),
                ({"revision": 1, "compound": {"kind": "rename", "id": "nobody", "name": "N"}}, 422,
                 [("compound/id", "not_found")]),
                ({"revision": 1, "undo": True}, 422, [("", "not_found")]),
                ({"revision": 1, "redo": True}, 422, [("", "not_found")])):
            with self.subTest(str(body)[:80]):
                answer = self.server.post("/documents/task/edits", body, status=status)
                self.assertEqual(codes(answer), refused)
        self.assertEqual(self.server.post("/documents/task/edits", "{", status=400)["errors"][0]["code"], "json")
        self.edit(doc("a", "x"), name="nobody", status=404)
        self.assertEqual(self.entry()["revision"], 1)

    def test_undo_and_redo_are_by_author_and_go_on_after_a_restart(self):
        first = self.document()
        self.edit(doc("a", "Ada's"), author="Ada")
        self.edit(doc("b", "Bob's"), author="Bob")
        undone = self.edit(author="Ada", undo=True)
        self.assertEqual((undone["kind"], undone["of"], undone["undo"], undone["redo"]), ("undo", 2, 0, 1))
        self.assertEqual(self.entry()["origin"], {"kind": "undo", "revision": 2})
        self.assertNotIn("doc", self.element("a"))
        self.assertEqual(self.element("b")["doc"], "Bob's")
        self.kill()
        redone = self.edit(author="Ada", redo=True)
        self.assertEqual((redone["kind"], redone["of"], redone["undo"], redone["redo"]), ("redo", 4, 1, 0))
        self.assertEqual(self.element("a")["doc"], "Ada's")
        self.kill()
        for author in ("Bob", "Ada"):
            self.assertEqual(self.edit(author=author, undo=True)["kind"], "undo")
            self.assertEqual(codes(self.edit(author=author, undo=True, status=422)), [("", "not_found")])
        self.assertEqual(self.document(), first)

    def test_undo_is_rejected_if_others_have_changed_the_same(self):
        self.edit(doc("a", "Ada's"), author="Ada")
        self.edit(doc("a", "Bob's"), author="Bob", revision=2)
        refused = self.edit(author="Ada", undo=True, status=409)
        self.assertIn("Bob", refused["errors"][0]["message"])
        self.kill()
        self.edit(author="Bob", undo=True)
        self.assertEqual(self.edit(author="Ada", undo=True)["of"], 2)

    def test_every_compound_is_made_and_can_be_undone(self):
        first = self.document()
        for compound, holds in (
                ({"kind": "rename", "id": "b", "name": "Bee"},
                 lambda d: d["root"]["children"][0]["ports"][0]["to"] == "Bee" and d["root"]["children"][3]["to"] == ["Bee", "C"]),
                ({"kind": "rename_service", "key": "timer", "name": "clock"}, None),
                ({"kind": "connect", "from": "ad", "to": "c"}, lambda d: d["root"]["children"][0]["ports"][0]["to"] == "C"),
                ({"kind": "connect", "from": "ad"}, lambda d: "to" not in d["root"]["children"][0]["ports"][0]),
                ({"kind": "disconnect", "barrier": "both", "state": "c"},
                 lambda d: d["root"]["children"][3]["to"] == ["B"]),
                ({"kind": "group", "ids": ["b"], "name": "Group"},
                 lambda d: d["root"]["children"][1]["state"] == "Group" and d["root"]["children"][1]["children"][0]["state"] == "B"),
                ({"kind": "ungroup", "id": "b"}, lambda d: d["root"]["children"][1]["state"] == "X"),
                ({"kind": "duplicate", "id": "c"}, lambda d: d["root"]["children"][3]["state"] == "C2"),
                ({"kind": "extract", "id": "b", "name": "Shared"},
                 lambda d: [state["state"] for state in d["library"]] == ["Shared"])):
            with self.subTest(compound["kind"]):
                revision = self.entry()["revision"]
                status, answer = self.server.request(
                    "POST", "/api/v1/documents/task/edits", {"revision": 1, "author": "Ada", "compound": compound})
                if holds is None:  # this document has nothing of the kind, and the server says so
                    self.assertEqual((status, answer["errors"][0]["path"].split("/")[0]), (422, "compound"), answer)
                    self.assertEqual(self.entry()["revision"], revision)
                    continue
                self.assertEqual(status, 200, answer)
                self.assertTrue(holds(self.document()), self.document())
                self.edit(author="Ada", undo=True)
                self.assertEqual(self.document(), first)

    def test_services_are_renamed_and_groups_taken_apart(self):
        first = task("more", actions=[{"when": "svc.timer.tick", "do": "var.v = 1"}])
        self.server.put("/documents/more", first, "document_entry")
        self.edit(name="more", compound={"kind": "rename_service", "key": "timer", "name": "clock"})
        self.assertEqual(self.document("more")["root"]["actions"][0]["when"], "svc.clock.tick")
        self.edit(name="more", compound={"kind": "group", "ids": ["b"], "name": "Group"})
        [group] = [child for child in self.document("more")["root"]["children"] if child.get("state") == "Group"]
        self.edit(name="more", compound={"kind": "ungroup", "id": group["meta"]["id"]})
        self.assertEqual([child["meta"]["id"] for child in self.document("more")["root"]["children"]], ["a", "b", "c", "both"])

    def test_an_edit_that_is_sent_again_is_not_made_twice(self):
        body = {"request": "t-1", "message": "once"}
        first = self.edit(insert("n", "a"), **body)
        self.assertEqual(first["request"], "t-1")
        self.edit(doc("a", "meanwhile"), author="Bob")
        self.assertEqual(self.edit(insert("n", "a"), **body), first)
        self.kill()
        self.assertEqual(self.edit(insert("n", "a"), **body), first)
        self.assertEqual(self.entry()["revision"], 3)
        # The same token of somebody else is another edit.
        self.assertEqual(self.edit(doc("b", "x"), author="Bob", request="t-1")["revision"], 4)

    def test_a_draft_is_edited_and_its_findings_come_with_each_edit(self):
        wrong = self.edit({"op": "set", "id": "ad", "field": "to", "value": "Nowhere"})
        self.assertEqual(codes(wrong), [("Root/A.done", "port_target")])
        entry = self.entry()
        self.assertEqual((codes(entry), entry["errors"]), (codes(wrong), wrong["errors"]))
        self.assertEqual(self.server.get("/documents", "documents")["documents"][0]["errors"], 1)
        self.server.post("/cores", {"document": "task"}, status=422)
        self.assertEqual(self.edit(author="Ada", undo=True)["errors"], [])
        self.server.post("/cores", {"document": "task"}, "core", 201)

    def test_a_draft_whose_shape_is_wrong_is_put_as_a_whole(self):
        self.server.put("/documents/task?draft=true", {"root": {"state": 7}}, "document_entry")
        refused = self.edit(doc("a", "x"), revision=2, status=409)
        self.assertEqual(refused["errors"][0]["code"], "conflict")
        self.server.put("/documents/task", task(), "document_entry")
        self.assertEqual(self.edit(doc("a", "x"), revision=3)["revision"], 4)


class OnTheStream(EditTest):
    def ask(self, stream, *operations, author="Ada", revision=1, request="t-1", **more):
        what = {"operations": list(operations)} if operations else {}
        stream.send_checked({"type": "edit", "document": "task", "request": request, "revision": revision,
                             "author": author, **what, **more})

    def test_a_subscriber_gets_the_document_then_every_edit_with_author_and_token(self):
        with self.server.stream() as stream:
            stream.subscribe("document/task")
            snapshot = stream.message()
            self.assertEqual((snapshot["kind"], snapshot["data"]),
                             ("snapshot", {"document": "task", "revision": 1, "json": self.document(), "errors": []}))
            over_rest = self.edit(doc("a", "x"), author="Bob", request="b-1")
            delta = stream.message()
            self.assertEqual((delta["kind"], delta["sequence"], delta["data"]), ("delta", snapshot["sequence"] + 1, over_rest))
            self.ask(stream, doc("b", "y"), revision=2, message="why")
            own = stream.message()["data"]
            self.assertEqual((own["author"], own["request"], own["message"], own["revision"]), ("Ada", "t-1", "why", 3))
            self.ask(stream, revision=3, request="t-2", undo=True)
            self.assertEqual(stream.message()["data"]["of"], 3)

    def test_who_is_not_subscribed_or_sends_again_is_told_alone(self):
        with self.server.stream() as stream, self.server.stream() as other:
            other.subscribe("document/task")
            other.message()
            self.ask(stream, doc("a", "x"))
            accepted = stream.message()
            self.assertEqual((accepted["channel"], accepted["kind"], accepted["data"]["revision"]),
                             ("document/task", "edit_accepted", 2))
            self.assertEqual(other.message()["data"], accepted["data"])
            self.ask(stream, doc("a", "x"))
            self.assertEqual(stream.message(), accepted)
            self.edit(doc("a", "end"), author="Bob", revision=2)
            self.assertEqual(other.message()["data"]["revision"], 3)

    def test_a_refusal_goes_to_its_sender_alone_with_the_reason(self):
        self.edit(remove("c"), {"op": "set", "id": "both", "field": "to", "value": ["B"]}, author="Bob")
        with self.server.stream() as stream, self.server.stream() as other:
            for each in (stream, other):
                each.subscribe("document/task")
                each.message()
            self.ask(stream, doc("c", "x"))
            refused = stream.message()
            data = refused["data"]
            self.assertEqual((refused["kind"], data["request"], data["author"], data["revision"], codes(data)),
                             ("edit_refused", "t-1", "Bob", 2, [("operations/0/id", "conflict")]))
            for number, (what, expected) in enumerate((
                    ({"undo": True}, [("", "not_found")]),
                    ({"operations": [{"op": "burn"}]}, [("operations/0/op", "name")]),
                    ({"operations": [], "compound": {}}, [("operations", "missing")]),
                    ({"undo": True, "more": 1}, [("more", "unknown_field")]))):
                stream.send({"type": "edit", "document": "task", "request": f"w-{number}", "revision": 1, **what})
                message = stream.message()
                self.assertEqual((message["kind"], message["data"]["request"], codes(message["data"])),
                                 ("edit_refused", f"w-{number}", expected))
            self.ask(stream, doc("a", "x"), request="t-3")
            self.assertEqual(other.message()["data"]["request"], "t-3")  # and nothing before it

    def test_without_a_token_there_is_an_error_and_no_edit(self):
        with self.server.stream() as stream:
            for more, expected in (({}, [("request", "missing")]), ({"request": "a b"}, [("request", "name")]),
                                   ({"request": 1}, [("request", "type")])):
                stream.send({"type": "edit", "document": "task", "revision": 1, "undo": True, **more})
                message = stream.message()
                self.assertEqual((message["kind"], codes(message["data"])), ("error", expected))
            stream.send({"type": "edit", "document": "a b", "request": "t", "revision": 1, "undo": True})
            self.assertEqual(codes(stream.message()["data"]), [("document", "name")])
            stream.send({"type": "edit", "document": "nobody", "request": "t", "revision": 1, "undo": True})
            message = stream.message()
            self.assertEqual((message["kind"], message["channel"], message["data"]["errors"][0]["code"]),
                             ("edit_refused", "document/nobody", "not_found"))
        self.assertEqual(self.entry()["revision"], 1)

    def test_there_is_no_channel_of_a_document_that_is_not_there(self):
        with self.server.stream() as stream:
            stream.subscribe("document/nobody")
            message = stream.message()
            self.assertEqual((message["kind"], message["data"]["errors"][0]["code"]), ("error", "not_found"))

    def test_who_comes_back_gets_what_was_missed_or_the_document(self):
        replica = Replica()
        with self.server.stream() as stream:
            self.subscribe(stream, replica)
            self.edit(doc("a", "seen"))
            replica.take(stream.message())
        for number in range(3):
            self.edit(doc("a", str(number)), insert(f"n{number}"))
        with self.server.stream() as stream:
            self.subscribe(stream, replica, replica.sequence)
            for _ in range(3):
                message = stream.message()
                self.assertEqual(message["kind"], "delta")
                replica.take(message)
        self.assertEqual(replica.document, self.document())
        self.kill()
        with self.server.stream() as stream:
            self.subscribe(stream, replica, replica.sequence)
            message = stream.message()
            self.assertEqual((message["kind"], message["data"]["json"]), ("snapshot", replica.document))

    def test_a_text_that_is_stored_meanwhile_arrives_as_an_edit(self):
        replica = Replica()
        with self.server.stream() as stream:
            self.subscribe(stream, replica)
            changed = self.document()
            changed["root"]["children"][0]["doc"] = "put"
            del changed["root"]["children"][2], changed["root"]["children"][2]
            self.server.put("/documents/task?author=Bob&message=put", changed, "document_entry")
            message = stream.message()
            self.assertEqual((message["kind"], message["data"]["author"], message["data"]["message"], message["data"]["kind"]),
                             ("delta", "Bob", "put", "change"))
            replica.take(message)
            self.assertEqual(replica.document, self.document())
            # Late edits are rebased on it, it can be undone, and a restored text is one, too.
            self.assertIn("Bob", self.edit(doc("c", "x"), status=409)["errors"][0]["message"])
            self.edit(doc("b", "y"))
            self.edit(author="Bob", undo=True)
            self.server.post("/documents/task/restore", {"revision": 2, "author": "Bob"}, "document_entry")
            for _ in range(3):
                replica.take(stream.message())
            self.assertEqual((replica.revision, replica.document), (5, self.document()))
            # What no edit leads to is a snapshot.
            self.server.put("/documents/task?draft=true", {"root": {"state": 7}}, "document_entry")
            message = stream.message()
            self.assertEqual((message["kind"], message["data"]["json"]), ("snapshot", {"root": {"state": 7}}))
            self.server.put("/documents/task", task(), "document_entry")
            replica.take(stream.message())
            self.edit(doc("a", "x"), revision=7)
            replica.take(stream.message())
            self.assertEqual((replica.revision, replica.document), (8, self.document()))

    def test_a_brought_back_backup_arrives_as_a_snapshot(self):
        backup = self.server.post("/backups", None, "backup", 201)["name"]
        replica = Replica()
        with self.server.stream() as stream:
            self.subscribe(stream, replica)
            self.edit(doc("a", "lost"))
            replica.take(stream.message())
            status, answer = self.server.request("POST", f"/api/v1/backups/{backup}/restore")
            self.assertEqual(status, 200, answer)
            message = stream.message()
            self.assertEqual((message["kind"], message["data"]["revision"], message["data"]["json"]),
                             ("snapshot", 1, self.document()))
            self.assertEqual(self.edit(doc("a", "again"))["revision"], 2)
            self.assertEqual(stream.message()["kind"], "delta")


if __name__ == "__main__":
    unittest.main()
