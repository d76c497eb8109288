"""Many authors edit one document at once; and the disk fills up while somebody does. RACE_EDITS says how many edits (300),
RACE_SEED which."""
import concurrent.futures
import os
import shutil
import tempfile
import unittest
from contextlib import closing

import models
from client import Stream
from crash_scenario import Connection
from document_replica import Replica
from random_author import RandomAuthor
from server_case import ServerCase
from traced_server import TracedServer

EDITS = int(os.environ.get("RACE_EDITS", "300"))
SEED = int(os.environ.get("RACE_SEED", "1"))
AUTHORS = ("Ada", "Bob", "Cyd", "Dan", "Eve", "Flo", "Gus", "Hal")
UNDOABLE = 600  # edits, with their undos, that the server's history is sure to remember


def crowded(name="crowd"):
    return models.document(name, {"state": "Root", "meta": {"id": "r"}, "children": [
        {"state": f"S{i}", "meta": {"id": f"s{i}"}, "children": [{"state": "T", "meta": {"id": f"t{i}"}}]} for i in range(4)]})


class Crowd(ServerCase):
    def entry(self):
        return self.server.get("/documents/crowd", "document_entry")

    def test_all_have_the_same_document_and_the_disk_has_it_and_undo_of_everything_gives_the_first(self):
        print(f"{EDITS} edits, seed {SEED}", flush=True)
        first = self.server.put("/documents/crowd", crowded(), "document_entry")["document"]
        authors = [RandomAuthor(self.server, name, SEED) for name in AUTHORS]
        log = Replica()  # from the first revision to the last
        with self.server.stream() as stream, concurrent.futures.ThreadPoolExecutor(len(authors)) as pool:
            stream.subscribe("document/crowd")
            log.take(stream.message())
            done = [pool.submit(author.run, EDITS // len(authors)) for author in authors]
            for each in done:
                each.result()
            last = self.entry()
            while log.revision < last["revision"]:
                log.take(stream.message())
            self.assertEqual(log.document, last["document"])
            for author in authors:
                author.read_until(last["revision"])
                self.assertEqual(author.replica.document, last["document"], author.name)
            own = sorted(revision for author in authors for revision in author.accepted.values())
            self.assertEqual(own, list(range(2, last["revision"] + 1)))  # each once
            print(f"{len(own)} accepted, {sum(author.refused for author in authors)} refused", flush=True)
            if EDITS <= UNDOABLE:
                self.undo_everything(log, stream)
                self.assertEqual(self.entry()["document"], first)
                self.assertEqual(log.document, first)
            last = self.entry()
        for author in authors:
            author.stream.close()
        self.kill()
        self.assertEqual(self.entry(), last)
        for revision, document in log.texts.items():
            self.assertEqual(self.server.get(f"/documents/crowd/revisions/{revision}", "document_entry")["document"], document,
                             revision)

    def undo_everything(self, log, stream):
        """The latest edit that is in effect first: then nothing is rejected."""
        in_effect = {}
        for revision, accepted in sorted(log.accepted.items()):
            if accepted["kind"] == "undo":
                del in_effect[accepted["of"]]
            else:
                in_effect[revision] = accepted["author"]
        while in_effect:
            revision, author = max(in_effect.items())
            undone = self.server.post("/documents/crowd/edits", {"revision": log.revision, "author": author, "undo": True},
                                      "accepted_edit")
            self.assertEqual(undone["of"], revision)
            del in_effect[revision]
            log.take(stream.message())


class FullDisk(unittest.TestCase):
    """The disk has no room from some write on, then has again: 507 meanwhile, and what was acknowledged is there."""

    def fill_up(self, at, error="ENOSPC"):
        data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, data)
        acknowledged, refused = {}, []
        with TracedServer(data) as server, Connection(server.port) as connection:
            connection.expect("PUT", "/documents/crowd", crowded())
            self.assertEqual(server.stop(), (0, ""))
        # strace counts the writes of each thread: the first makes 16 before it listens; those that serve edits take turns.
        with TracedServer(data, f"error={error}:when={at}+", calls=("pwrite64",)) as server:
            self.assertTrue(server.port)
            with Connection(server.port) as connection, closing(Stream(server.port)) as stream:
                replica = Replica()
                stream.subscribe("document/crowd")
                replica.take(stream.message())
                for number in range(30):
                    status, answer = self.edit(connection, number)
                    if status == 200:
                        acknowledged[answer["revision"]] = number
                    else:
                        self.assertEqual((status, [e["code"] for e in answer["errors"]]), (507, ["storage"]))
                        refused.append(number)
                self.assertTrue(acknowledged and refused, (at, acknowledged, refused))
                server.end_faults()
                for number in refused:  # with the same tokens: what was stored all the same is not stored twice
                    status, answer = self.edit(connection, number)
                    self.assertEqual(status, 200, answer)
                    acknowledged[answer["revision"]] = number
                while replica.revision < 31:
                    replica.take(stream.message())
                self.assertEqual(replica.document, connection.get("/documents/crowd")["document"])
            server.kill()
        with TracedServer(data) as server, Connection(server.port) as connection:
            self.assertEqual(connection.get("/documents/crowd")["revision"], 31)
            self.assertEqual(sorted(acknowledged), list(range(2, 32)))
            for revision, number in acknowledged.items():
                stored = connection.get(f"/documents/crowd/revisions/{revision}")["document"]["root"]["children"]
                self.assertEqual(stored[0]["doc"], f"edit {number}")
            self.assertEqual(server.stop(), (0, ""))

    @staticmethod
    def edit(connection, number):
        change = {"op": "set", "id": "s0", "field": "doc", "value": f"edit {number}"}
        return connection.request("POST", "/documents/crowd/edits",
                                  {"revision": 1, "author": "Ada", "request": f"t-{number}", "operations": [change]})

    def test_nothing_that_was_acknowledged_is_lost(self):
        for at in range(25, 34, 2):
            with self.subTest(at):
                self.fill_up(at)

    def test_nor_if_it_fails(self):
        self.fill_up(26, "EIO")


if __name__ == "__main__":
    unittest.main()
