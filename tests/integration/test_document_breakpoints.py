"""The breakpoints that people keep at a document: by name, over restarts, until the document is removed; whole or refused."""
import unittest
from urllib.parse import quote

import models
from server_case import ServerCase

TESTED = {"when": "tested", "path": "Root/Pong.next", "enabled": True}
CALLED = {"when": "called", "before": True, "service": "timer", "operation": "wait", "enabled": False}
FULFILLED = {"when": "fulfilled", "path": "Root/Pong", "condition": "True", "enabled": True}


class DocumentBreakpoints(ServerCase):
    def setUp(self):
        super().setUp()
        self.server.put("/documents/task", models.ticking("task"))

    def path(self, author, document="task"):
        return f"/documents/{document}/breakpoints?author={quote(author, safe='')}"

    def kept(self, author):
        return self.server.get(self.path(author), "document_breakpoints")["breakpoints"]

    def keep(self, author, breakpoints):
        return self.server.put(self.path(author), {"breakpoints": breakpoints}, "document_breakpoints")["breakpoints"]

    def test_they_are_those_of_each_person_also_after_a_restart(self):
        self.assertEqual(self.kept("Ada"), [])
        self.assertEqual(self.keep("Ada", [TESTED, CALLED]), [TESTED, CALLED])
        self.keep("Zoë/2", [FULFILLED])
        self.restart()
        self.assertEqual((self.kept("Ada"), self.kept("Zoë/2"), self.kept("Eve")), ([TESTED, CALLED], [FULFILLED], []))
        self.keep("Ada", [])
        self.assertEqual(self.kept("Ada"), [])

    def test_a_core_takes_those_that_are_enabled(self):
        kept = self.keep("Ada", [TESTED, FULFILLED])
        core = self.server.core(models.ticking("task"), start=False)
        wanted = [{key: each[key] for key in each if key != "enabled"} for each in kept]
        self.assertEqual(self.server.put(f"/cores/{core}/breakpoints", {"breakpoints": wanted}, "core")["breakpoints"], wanted)

    def test_a_core_has_those_of_each_person_who_replaces_their_own(self):
        core = self.server.core(models.ticking("task"), start=False)
        one, two = {"when": "entered", "path": "Root/Pong"}, {"when": "left", "path": "Root/Pong"}

        def put(author, breakpoints, **expected):
            return self.server.put(f"/cores/{core}/breakpoints{author}", {"breakpoints": breakpoints}, **expected)

        of = {author: lambda each, author=author: {**each, "author": author} for author in ("Ada", "Zoë")}
        put("?author=Ada", [one, two])
        put(f"?author={quote('Zoë')}", [one])
        self.assertEqual(self.server.get(f"/cores/{core}", "core")["breakpoints"], [of["Ada"](one), of["Ada"](two), of["Zoë"](one)])
        self.assertEqual(put("?author=Ada", [two], schema="core")["breakpoints"], [of["Zoë"](one), of["Ada"](two)])
        self.assertEqual(put("?author=Ada", [], schema="core")["breakpoints"], [of["Zoë"](one)])
        put("?author=Ada", 99 * [two], schema="core")
        for author, breakpoints, status, path in (("?author=", [], 422, "author"), (f"?author={101 * 'a'}", [], 413, "author"),
                                                  ("?author=Ada", 100 * [two], 413, "breakpoints"),
                                                  ("?author=Ada", [{"when": "entered", "path": "Root/None"}], 404, "breakpoints/0/path")):
            with self.subTest(path):
                self.assertEqual([error["path"] for error in put(author, breakpoints, status=status)["errors"]], [path])
        self.assertEqual(len(self.server.get(f"/cores/{core}", "core")["breakpoints"]), 100, "what is refused changes nothing")
        self.assertEqual(put("", [one], schema="core")["breakpoints"], [one], "who does not say who sets them replaces those of all")

    def test_they_go_with_their_document(self):
        self.keep("Ada", [TESTED])
        self.server.expect("DELETE", "/documents/task", None, "document_removed", 200)
        self.assertEqual(self.kept("Ada"), [])
        self.server.put(self.path("Ada"), {"breakpoints": [TESTED]}, status=404)
        self.server.put("/documents/task", models.ticking("task"))
        self.assertEqual(self.kept("Ada"), [])

    def test_what_is_wrong_is_named_and_nothing_is_kept(self):
        self.keep("Ada", [TESTED])
        for wrong, path, status in (
                ([TESTED, {**CALLED, "when": "now"}], "breakpoints/1/when", 422), ([{"when": "fault"}], "breakpoints/0/enabled", 422),
                ([{**TESTED, "enabled": 1}], "breakpoints/0/enabled", 422), ([{**TESTED, "more": 1}], "breakpoints/0/more", 422),
                ([{**TESTED, "path": "R" * 1001}], "breakpoints/0/path", 413),
                ([{**CALLED, "service": "s" * 101}], "breakpoints/0/service", 413),
                ([TESTED] * 101, "breakpoints", 413)):
            with self.subTest(path):
                errors = self.server.put(self.path("Ada"), {"breakpoints": wrong}, status=status)["errors"]
                self.assertIn(path, {error["path"] for error in errors})
        self.assertEqual(self.kept("Ada"), [TESTED])
        for author, status in (("", 422), ("a" * 101, 413)):
            self.server.get(self.path(author), status=status)
            self.server.put(self.path(author), {"breakpoints": []}, status=status)


if __name__ == "__main__":
    unittest.main()
