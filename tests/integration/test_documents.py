"""Documents and drafts with every revision over REST: author, message, restore, branch; they survive a restart."""
import sqlite3
import time
import unittest
from contextlib import closing
from pathlib import Path

import models
from client import Server
from server_case import ServerCase


def task(name="task", doc="", **root):
    return models.document(name, {"state": "Root", "children": [{"state": "A"}], "doc": doc, **root})


def codes(answer):
    return [error["code"] for error in answer["errors"]]


class Documents(ServerCase):
    def put(self, body, query="", name="task"):
        return self.server.put(f"/documents/{name}{query}", body, "document_entry")

    def revisions(self, query="", name="task"):
        return self.server.get(f"/documents/{name}/revisions{query}", "revisions")["revisions"]

    def test_every_revision_is_kept_with_author_time_and_message(self):
        begin = int(time.time() * 1000) - 1000
        first = self.put(task(doc="one"), "?author=Ada&message=the+first+%C3%A4")
        second = self.put(task(doc="two"))
        self.assertEqual((first["revision"], first["author"], first["message"], first["origin"], first["errors"]),
                         (1, "Ada", "the first ä", {"kind": "put"}, []))
        self.assertEqual((second["revision"], second["author"], second["message"]), (2, "", ""))
        self.assertTrue(begin < first["time"] <= second["time"])
        self.assertEqual(self.put(task(doc="two"), "?author=Bob"), second)
        self.restart()
        self.assertEqual([each["revision"] for each in self.revisions()], [2, 1])
        self.assertEqual(self.server.get("/documents/task/revisions/1", "document_entry"), first)
        self.assertEqual(self.server.get("/documents/task", "document_entry"), second)
        self.assertEqual(self.server.get("/documents", "documents")["documents"],
                         [{"name": "task", "revision": 2, "errors": 0, "doc": "two"}])

    def test_one_that_is_damaged_is_named_and_the_others_are_as_before(self):
        self.put(task(doc="one"))
        self.put(task("other"), name="other")
        self.server.stop()
        with closing(sqlite3.connect(Path(self.data, "race.sqlite"))) as store, store:
            store.execute("UPDATE revision SET author = 'Eve' WHERE document = 'task'")
        self.server = Server(data=self.data)
        listed = self.server.get("/documents", "documents")
        self.assertEqual([each["name"] for each in listed["documents"]], ["other"])
        self.assertEqual([(each["path"], each["code"]) for each in listed["damaged"]], [("task/revisions/1", "corrupt")])
        self.assertEqual(codes(self.server.get("/documents/task", status=500)), ["corrupt"])
        self.server.core(task("third"))
        with self.server.stream() as stream:
            stream.subscribe("log")
            self.assertIn("revision 1 of the document `task` is damaged", str(stream.message()))

    def test_a_text_that_is_damaged_is_named_in_the_log_when_it_is_asked_for(self):
        self.put(task())
        self.put(task("other"), name="other")
        self.server.stop()
        with closing(sqlite3.connect(Path(self.data, "race.sqlite"))) as store, store:
            store.execute("UPDATE revision SET text = text || ' ' WHERE document = 'task'")
        self.server = Server(data=self.data)
        self.assertEqual(codes(self.server.get("/documents/task", status=500)), ["corrupt"])
        self.assertEqual(self.server.get("/documents/other", "document_entry")["errors"], [])
        with self.server.stream() as stream:
            stream.subscribe("log")
            self.assertIn("task/revisions/1: corrupt: revision 1 of the document `task` is damaged", str(stream.message()))

    def test_of_many_errors_the_first_are_listed(self):
        """3.2 MB in which 156 000 names are not known: more would be an answer of 19 MB."""
        lines = "\n".join(f"a{i}=b{i}+b{i}" for i in range(3120))
        entries = {"children": [{"state": f"S{i}", "entry": lines} for i in range(50)]}
        faulty = models.document("task", {"state": "Root", **entries})
        refused = self.server.put("/documents/task", faulty, status=422)
        self.assertEqual((len(refused["errors"]), refused["more_errors"]), (200, True))
        self.assertEqual([(error["path"], error["line"]) for error in refused["errors"][:3]], [("Root/S0", 1)] * 2 + [("Root/S0", 2)])
        self.put(faulty, "?draft=true")
        entry = self.server.get("/documents/task", "document_entry")
        # What was refused had no ids yet.
        places = [{key: value for key, value in error.items() if key != "id"} for error in entry["errors"]]
        self.assertEqual((places, entry["more_errors"]), (refused["errors"], True))
        self.assertEqual(self.server.get("/documents", "documents")["documents"][0]["errors"], 201)
        self.assertNotIn("more_errors", self.put(task(first="Nowhere"), "?draft=true"))

    def test_revisions_are_listed_by_pages(self):
        for i in range(103):
            self.put(task(doc=str(i)))
        self.assertEqual([each["revision"] for each in self.revisions()], list(range(103, 3, -1)))
        self.assertEqual([each["revision"] for each in self.revisions("?before=4")], [3, 2, 1])
        self.assertEqual([each["revision"] for each in self.revisions("?before=50&limit=2")], [49, 48])
        self.assertEqual(self.revisions("?before=1"), [])
        for query in ("?limit=101", "?limit=0", "?before=0", "?before=x", "?limit=1e1", "?before=99999999999999999999"):
            self.assertEqual(codes(self.server.get("/documents/task/revisions" + query, status=400)), ["out_of_range"])
        for path in ("/documents/other/revisions", "/documents/task/revisions/104", "/documents/task/revisions/0",
                     "/documents/task/revisions/x", "/documents/other/revisions/1"):
            self.assertEqual(codes(self.server.get(path, status=404)), ["not_found"])

    def test_a_draft_is_stored_with_its_errors_if_it_is_asked_for(self):
        draft = task(first="Nobody")
        self.assertEqual(codes(self.server.put("/documents/task", draft, status=422)), ["first"])
        self.assertEqual(codes(self.server.put("/documents/task?draft=false", draft, status=422)), ["first"])
        self.server.get("/documents/task", status=404)
        stored = self.put(draft, "?draft=true")
        self.assertEqual((codes(stored), stored["errors"][0]["path"]), (["first"], "Root"))
        self.assertTrue(stored["document"]["root"]["children"][0]["meta"]["id"])
        self.restart()
        self.assertEqual(self.server.get("/documents/task", "document_entry"), stored)
        self.assertEqual(self.server.get("/documents", "documents")["documents"][0]["errors"], 1)
        self.assertEqual(self.revisions()[0]["errors"], 1)
        self.assertEqual(codes(self.server.get("/documents/task/native", status=422)), ["first"])
        self.assertEqual(codes(self.server.post("/cores", {"document": "task"}, status=422)), ["first"])
        self.assertEqual(self.put(task(), "?draft=true")["errors"], [])
        self.server.post("/cores", {"document": "task"}, "core", 201)

    def test_a_draft_whose_shape_is_wrong_is_as_it_was_sent(self):
        torn = {"root": {"state": 7, "more": [1, 2.5, None]}, "x": {}}
        stored = self.put(torn, "?draft=true")
        self.assertEqual(stored["document"], torn)
        self.assertLessEqual({"version", "type", "unknown_field"}, set(codes(stored)))
        self.assertEqual(self.server.get("/documents/task", "document_entry"), stored)
        self.assertEqual(codes(self.server.put("/documents/task?draft=true", "{", status=400)), ["json"])
        self.assertEqual(codes(self.server.put("/documents/task?draft=true", "[]", status=422)), ["type"])
        self.assertEqual(codes(self.server.put("/documents/task?draft=yes", task(), status=400)), ["out_of_range"])

    def test_an_earlier_revision_is_restored_as_the_next_one(self):
        first = self.put(task(doc="one"))
        self.put(task(doc="two"))
        restored = self.server.post("/documents/task/restore", {"revision": 1, "author": "Ada", "message": "better"},
                                    "document_entry")
        self.assertEqual(restored["document"], first["document"])
        self.assertEqual((restored["revision"], restored["author"], restored["message"], restored["origin"]),
                         (3, "Ada", "better", {"kind": "restore", "revision": 1}))
        self.assertEqual(self.server.get("/documents/task", "document_entry"), restored)
        self.assertEqual(self.server.post("/documents/task/restore", {"revision": 1}, "document_entry"), restored)
        self.server.post("/documents/task/restore", {"revision": 4}, status=404)
        self.server.post("/documents/other/restore", {"revision": 1}, status=404)

    def test_a_revision_is_branched_with_its_ids(self):
        first = self.put(task(doc="one"))
        self.put(task(doc="two"))
        branch = self.server.post("/documents/task/branch", {"as": "mine", "revision": 1, "author": "Ada"},
                                  "document_entry", 201)
        self.assertEqual(branch["document"], first["document"])
        self.assertEqual((branch["name"], branch["revision"], branch["author"], branch["origin"]),
                         ("mine", 1, "Ada", {"kind": "branch", "document": "task", "revision": 1}))
        last = self.server.post("/documents/task/branch", {"as": "last"}, "document_entry", 201)
        self.assertEqual(last["origin"]["revision"], 2)
        self.assertEqual(codes(self.server.post("/documents/task/branch", {"as": "mine"}, status=409)), ["conflict"])
        self.assertEqual(codes(self.server.post("/documents/task/branch", {"as": "a b"}, status=422)), ["name"])
        self.server.post("/documents/task/branch", {"as": "new", "revision": 3}, status=404)
        self.server.post("/documents/other/branch", {"as": "new"}, status=404)

    def test_invalid_requests_are_refused_by_field(self):
        self.put(task())
        for path, body, refused in (
                ("restore", {}, [("revision", "missing")]), ("restore", [], [("", "type")]),
                ("restore", {"revision": 0}, [("revision", "type")]),
                ("restore", {"revision": 1.0, "author": 1, "more": 2},
                 [("revision", "type"), ("author", "type"), ("more", "unknown_field")]),
                ("branch", {}, [("as", "missing")]),
                ("branch", {"as": 1, "revision": "1"}, [("as", "type"), ("revision", "type")])):
            with self.subTest(path=path, body=body):
                errors = self.server.post(f"/documents/task/{path}", body, status=422)["errors"]
                self.assertEqual([(error["path"], error["code"]) for error in errors], refused)
        for path in ("restore", "branch"):
            self.server.post(f"/documents/task/{path}", "{", status=400)

    def test_author_and_message_have_bounds(self):
        self.put(task())
        for query, path in ((f"?author={101 * 'x'}", "author"), (f"?message={1001 * 'x'}", "message")):
            errors = self.server.put("/documents/task" + query, task(doc="two"), status=413)["errors"]
            self.assertEqual([(error["path"], error["code"]) for error in errors], [(path, "too_large")])
        for body in ({"author": 101 * "x"}, {"message": 1001 * "x"}):
            self.server.post("/documents/task/restore", body | {"revision": 1}, status=413)
            self.server.post("/documents/task/branch", body | {"as": "new"}, status=413)
        longest = self.put(task(doc="two"), f"?author={100 * 'x'}&message={1000 * 'y'}")
        self.assertEqual((longest["revision"], len(longest["message"])), (2, 1000))

    def test_a_change_of_another_revision_than_the_last_one_is_a_conflict(self):
        self.assertEqual(codes(self.server.put("/documents/task?revision=1", task(), status=409)), ["conflict"])
        self.put(task())
        self.assertEqual(self.put(task(doc="two"), "?revision=1")["revision"], 2)
        self.assertEqual(codes(self.server.put("/documents/task?revision=1", task(doc="three"), status=409)), ["conflict"])
        self.server.put("/documents/task?revision=0", task(), status=400)


if __name__ == "__main__":
    unittest.main()
