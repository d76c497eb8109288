"""race models, pull and push: documents as files in git, by two people who change them."""
import json
import sqlite3
import subprocess
import tempfile
import unittest
from contextlib import closing
from pathlib import Path

import models
from accounts import PASSWORD, AccountServer
from client import PROGRAM, Server
from race_command import Person

RECORD = ".race-pulled.json"


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()
        cls.addClassCleanup(cls.server.stop)
        cls.url = f"http://127.0.0.1:{cls.server.port}"

    def setUp(self):
        for document in self.server.get("/documents")["documents"]:
            self.server.expect("DELETE", f"/documents/{document['name']}", None, None, 200)
        self.ada, self.bob = Person(self, self.url), Person(self, self.url)
        self.put("tick")

    def put(self, name, doc=None):
        document = models.ticking(name)
        if doc:
            document["root"]["doc"] = doc
        return self.server.put(f"/documents/{name}", document)

    def revision(self, name="tick"):
        return self.server.get(f"/documents/{name}")["revision"]

    def file(self, person, name="tick"):
        return person.folder / f"{name}.rcm.json"

    def edit(self, person, doc, name="tick"):
        file = self.file(person, name)
        document = json.loads(file.read_text())
        document["root"]["doc"] = doc
        file.write_text(json.dumps(document))
        return file

    def doc(self, name="tick"):
        return self.server.get(f"/documents/{name}")["document"]["root"].get("doc")

    def test_models_lists_documents_and_drafts(self):
        self.server.expect("PUT", "/documents/broken?draft=true", models.document("broken", {"state": "R", "first": "X"}), None, (200, 201))
        self.assertRegex(self.ada.done("models"), r"\Abroken +revision \d+  draft, 1 error\ntick +revision \d+\n\Z")
        self.assertEqual(self.ada.json("models"), self.server.get("/documents", "documents"))

    def test_models_lists_all_pages(self):
        names = [f"d{n:04}" for n in range(1001)]
        with Server() as server:
            for name in names:
                server.expect("PUT", f"/documents/{name}?draft=true", {}, None, (200, 201))
            listed = self.ada.json("models", url=f"http://127.0.0.1:{server.port}")["documents"]
        self.assertEqual([each["name"] for each in listed], names)

    def test_pull_writes_what_fmt_writes(self):
        self.assertEqual(self.ada.done("pull"), f"./tick.rcm.json: revision {self.revision()}\n")
        text = self.file(self.ada).read_text()
        self.assertEqual(json.loads(text), self.server.get("/documents/tick")["document"])
        formatted = subprocess.run([PROGRAM, "fmt", str(self.file(self.ada))], capture_output=True, text=True, check=True).stdout
        self.assertEqual(text, formatted)
        self.assertEqual(self.ada.done("pull"), "")
        self.assertEqual(self.ada.json("pull")["files"], [{"file": "./tick.rcm.json", "revision": self.revision(), "result": "unchanged"}])
        self.assertEqual(sorted(path.name for path in self.ada.folder.iterdir()), [RECORD, "tick.rcm.json"])

    def test_pull_takes_some_into_a_folder(self):
        self.put("tock")
        self.ada.done("pull", "tock", "--into", "models/here")
        self.assertEqual([path.name for path in sorted((self.ada.folder / "models/here").iterdir())], [RECORD, "tock.rcm.json"])
        status, _, errors = self.ada.race("pull", "nothing", "tick")
        self.assertEqual((status, errors), (1, "nothing: not_found: the server has no document of this name\n"))
        self.assertTrue(self.file(self.ada).exists())
        self.assertEqual(self.ada.race("pull", "../tick")[0], 2)

    def test_push_sends_a_change_and_the_next_pull_brings_it(self):
        self.ada.done("pull")
        self.bob.done("pull")
        before = self.revision()
        file = self.edit(self.ada, "by Ada")
        self.assertEqual(self.ada.done("push", "tick.rcm.json", "--message", "a reason & more"), f"tick.rcm.json: revision {before + 1}\n")
        self.assertEqual((self.doc(), self.server.get("/documents/tick")["message"]), ("by Ada", "a reason & more"))
        self.assertIn('\n  "', file.read_text())  # as the server has it
        self.assertEqual(self.ada.done("push", "tick.rcm.json"), "tick.rcm.json: the server has it\n")
        self.assertEqual(self.bob.done("pull"), f"./tick.rcm.json: revision {before + 1}\n")
        self.assertEqual(self.file(self.bob).read_text(), file.read_text())

    def test_elements_get_ids_in_the_file(self):
        self.ada.done("pull")
        document = json.loads(self.file(self.ada).read_text())
        document["root"]["children"].append({"state": "New"})
        self.file(self.ada).write_text(json.dumps(document))
        self.ada.done("push", "tick.rcm.json")
        self.assertTrue(json.loads(self.file(self.ada).read_text())["root"]["children"][-1]["meta"]["id"])
        self.assertEqual(self.ada.done("pull"), "")

    def test_the_work_of_others_is_not_overwritten(self):
        self.ada.done("pull")
        self.bob.done("pull")
        self.edit(self.ada, "by Ada")
        self.ada.done("push", "tick.rcm.json")
        mine = self.edit(self.bob, "by Bob").read_text()
        for words in (("push", "tick.rcm.json"), ("push", "tick.rcm.json", "--new"), ("pull",), ("pull", "tick", "--dry-run")):
            status, output, errors = self.bob.race(*words)
            self.assertEqual((status, output), (1, ""), words)
            self.assertIn("tick.rcm.json: conflict: ", errors)
            self.assertIn("`race pull --force tick", errors)
            self.assertEqual((self.doc(), self.file(self.bob).read_text()), ("by Ada", mine))
        self.assertIn("changes are dropped", self.bob.done("pull", "tick", "--force"))
        self.edit(self.bob, "by Ada and Bob")
        self.bob.done("push", "tick.rcm.json")
        self.assertEqual(self.doc(), "by Ada and Bob")

    def test_changes_stay_if_the_server_has_nothing_new(self):
        self.ada.done("pull")
        mine = self.edit(self.ada, "by Ada").read_text()
        self.assertEqual(self.ada.done("pull"), "./tick.rcm.json: has changes that the server does not have\n")
        self.assertEqual(self.file(self.ada).read_text(), mine)
        self.ada.done("pull", "--force")
        self.assertNotIn("by Ada", self.file(self.ada).read_text())

    def test_a_record_in_git_is_that_of_the_files(self):
        def git(person, *words):
            return subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x@example.org", "-c", "init.defaultBranch=main", *words],
                                  cwd=person.folder, capture_output=True, text=True, check=True).stdout

        self.put("tock")
        self.ada.done("pull")
        git(self.ada, "init", "-q")
        git(self.ada, "add", ".")
        git(self.ada, "commit", "-qm", "pulled")
        git(self.bob, "clone", "-q", str(self.ada.folder), ".")
        self.edit(self.ada, "by Ada")
        self.ada.done("push", "tick.rcm.json")
        git(self.ada, "commit", "-qam", "Ada's")
        self.edit(self.bob, "by Bob", "tock")
        self.bob.done("push", "tock.rcm.json")  # of the clone, which never pulled
        git(self.bob, "commit", "-qam", "Bob's")
        git(self.bob, "pull", "-q", "--no-rebase", "--no-edit")  # merges the records, too
        self.assertEqual(self.bob.done("pull"), "")
        self.edit(self.bob, "by both")
        self.bob.done("push", "tick.rcm.json")
        self.assertEqual((self.doc(), self.doc("tock")), ("by both", "by Bob"))

    def test_new_documents_are_made_on_request_alone(self):
        self.file(self.ada, "fresh").write_text(json.dumps(models.ticking("fresh")))
        status, _, errors = self.ada.race("push", "fresh.rcm.json")
        self.assertEqual((status, errors.split(": ")[:2]), (1, ["fresh.rcm.json", "not_found"]))
        self.assertEqual(self.ada.done("push", "--new", "--dry-run", "fresh.rcm.json"), "fresh.rcm.json: would be pushed\n")
        self.assertEqual(self.ada.json("push", "--new", "--dry-run", "fresh.rcm.json"),
                         {"files": [{"file": "fresh.rcm.json", "result": "pushed"}]})
        self.assertEqual(len(self.server.get("/documents")["documents"]), 1)
        self.ada.done("push", "--new", "fresh.rcm.json")
        self.assertEqual(self.revision("fresh") > 0, True)
        self.file(self.ada).write_text(json.dumps(models.ticking("tick")))  # not pulled, and another text
        status, _, errors = self.ada.race("push", "--new", "tick.rcm.json")
        self.assertEqual((status, errors.split(": ")[:2]), (1, ["tick.rcm.json", "conflict"]))

    def test_a_document_that_was_removed_is_made_again_on_request_alone(self):
        self.ada.done("pull")
        self.server.expect("DELETE", "/documents/tick", None, None, 200)
        self.edit(self.ada, "by Ada")
        self.assertEqual(self.ada.race("push", "tick.rcm.json")[0], 1)
        self.ada.done("push", "--new", "tick.rcm.json")
        self.assertEqual(self.doc(), "by Ada")

    def test_violations_are_told_with_the_file(self):
        self.ada.done("pull")
        document = json.loads(self.file(self.ada).read_text())
        document["root"]["first"] = "Nowhere"
        self.file(self.ada).write_text(json.dumps(document))
        before = self.revision()
        status, _, errors = self.ada.race("push", "tick.rcm.json")
        self.assertEqual(status, 1)
        self.assertRegex(errors, r"\Atick\.rcm\.json: Root: first: ")
        self.assertEqual(self.revision(), before)
        self.ada.done("push", "--draft", "tick.rcm.json")
        self.assertEqual(len(self.server.get("/documents/tick")["errors"]), 1)
        self.bob.done("pull")
        self.assertEqual(self.file(self.bob).read_text(), self.file(self.ada).read_text())

    def test_what_is_wrong_in_one_file_sends_none(self):
        self.ada.done("pull")
        self.edit(self.ada, "by Ada")
        self.file(self.ada, "bad").write_text("{")
        self.file(self.ada, "list").write_text("[]")
        for wrong, code in (("bad.rcm.json", "json"), ("list.rcm.json", "type"), ("none.rcm.json", "io"), (RECORD, "name"), (".", "name"),
                            ("./tick.rcm.json", "duplicate")):
            status, output, errors = self.ada.race("push", "tick.rcm.json", wrong)
            self.assertEqual((status, output), (2, ""), errors)
            self.assertTrue(errors.startswith(f"{wrong}: {code}: "), errors)
        self.assertIsNone(self.doc())

    def test_another_server_with_the_same_revision_is_noticed(self):
        self.ada.done("pull")
        with Server() as other:
            url = f"http://127.0.0.1:{other.port}"
            for n in range(self.revision()):
                document = models.ticking("tick")
                document["root"]["doc"] = f"another {n}"
                other.put("/documents/tick", document)
            self.edit(self.ada, "by Ada")
            self.assertEqual(self.ada.race("push", "tick.rcm.json", url=url)[0], 1)
            self.assertEqual(self.ada.race("pull", url=url)[0], 1)

    def test_a_record_that_is_none_is_refused(self):
        self.ada.done("pull")
        (self.ada.folder / RECORD).write_text("<<<<<<< ours")
        for words in (("pull",), ("push", "tick.rcm.json")):
            status, _, errors = self.ada.race(*words)
            self.assertEqual((status, errors.split(": ")[:2]), (2, [f"./{RECORD}", "not_accepted"]))

    def test_a_folder_that_cannot_be_written_changes_nothing(self):
        self.ada.done("pull")
        before = self.file(self.ada).read_bytes()
        self.put("tick", "newer")
        status, _, errors = self.ada.race("pull", "--into", "/proc/none")
        self.assertEqual((status, errors.split(": ")[1]), (2, "io"))
        self.assertEqual(self.file(self.ada).read_bytes(), before)


class Damage(unittest.TestCase):
    def test_what_is_damaged_is_named_and_the_rest_is_pulled(self):
        with tempfile.TemporaryDirectory() as data:
            with Server(data=data) as server:
                for name in ("tick", "tock"):
                    server.put(f"/documents/{name}", models.ticking(name))
            with closing(sqlite3.connect(Path(data, "race.sqlite"))) as store, store:
                store.execute("UPDATE revision SET author = 'Eve' WHERE document = 'tick'")
            with Server(data=data) as server:
                person = Person(self, f"http://127.0.0.1:{server.port}")
                for command, said in (("models", "tock "), ("pull", "./tock.rcm.json: revision 1\n")):
                    status, output, errors = person.race(command)
                    self.assertEqual((status, output.startswith(said), errors.split(": ")[:2]), (1, True, ["tick/revisions/1", "corrupt"]))
                self.assertEqual([path.name for path in sorted(person.folder.iterdir())], [RECORD, "tock.rcm.json"])


class Rights(unittest.TestCase):
    def test_an_observer_pulls_and_may_not_push(self):
        with AccountServer() as server:
            server.put("/documents/tick", models.ticking("tick"))
            person = Person(self, f"http://127.0.0.1:{server.port}")
            person.done("login", "observer", text=PASSWORD + "\n")
            person.done("pull")
            file = person.folder / "tick.rcm.json"
            file.write_text(file.read_text().replace('"tick"', '"tock"'))
            status, _, errors = person.race("push", "tick.rcm.json")
            self.assertEqual((status, "rights: " in errors), (1, True))


if __name__ == "__main__":
    unittest.main()
