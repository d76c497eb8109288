"""Many authors edit a task at once while it runs; and the disk fills up while somebody edits. RACE_CROWD_EDITS says how many
edits (300), RACE_SEED which, and of which task."""
import concurrent.futures
import itertools
import os
import re
import shutil
import tempfile
import unittest
from contextlib import closing

import models
from client import PROJECT, Stream
from crash_scenario import Connection
from document_replica import Replica, digest
from live_run import LiveRun, check_invariants
from random_author import RandomAuthor
from random_task import random_task
from server_case import ServerCase
from stored_data import as_derived, derivations, replay
from traced_server import TracedServer

EDITS = int(os.environ.get("RACE_CROWD_EDITS", "300"))
SEED = int(os.environ.get("RACE_SEED", "1"))
AUTHORS = ("Ada", "Bob", "Cyd", "Dan", "Eve", "Flo", "Gus", "Hal")
SESSION = (PROJECT / "server/editing/document_session.h").read_text()
REMEMBERED = int(re.search(r"kHistory\{\.edits = (\d+)", SESSION)[1])  # edits, undos among them, by the server
AT_LEAST = EDITS // 15  # edits that the run gets, and other inputs between them: an edit that waits has the later ones in it


class Log(Replica):
    """A replica that reads the channel from the first revision to the last. `digests`: of the document at each."""

    def __init__(self, stream):
        super().__init__()
        self.stream, self.digests = stream, {}
        stream.subscribe("document/crowd")
        self.take(stream.message())

    def take(self, message):
        super().take(message)
        self.digests[self.revision] = digest(self.document)

    def read_until(self, revision):
        while self.revision < revision:
            self.take(self.stream.message())


class Crowd(ServerCase):
    def entry(self):
        return self.server.get("/documents/crowd", "document_entry")

    def test_run_clients_server_and_disk_have_the_same_document_and_undo_of_everything_gives_the_first(self):
        print(f"{EDITS} edits, seed {SEED}", flush=True)
        first = self.server.put("/documents/crowd", random_task("crowd", SEED), "document_entry")["document"]
        run = LiveRun(self.server, "crowd")
        with self.server.stream() as stream:
            log = Log(stream)
            self.let_authors_edit(log)
            self.check_run(run, log)
            if self.undo_everything(log):
                self.assertEqual(digest(log.document), digest(first))
            else:
                print("the server has forgotten edits: what stays is not compared with the first document", flush=True)
            self.make_sound(log)
            self.assertEqual(digest(self.entry()["document"]), digest(log.document))
            run.follow()
        self.check_disk(run, log)

    def let_authors_edit(self, log):
        """All at once; then each of them has the document that the server has, and each accepted edit is in it once."""
        authors = [RandomAuthor(self.server, "crowd", name, SEED) for name in AUTHORS]
        with concurrent.futures.ThreadPoolExecutor(len(authors)) as pool:
            for each in [pool.submit(author.run, EDITS // len(authors)) for author in authors]:
                each.result()
        last = self.entry()
        for replica in (log, *authors):
            replica.read_until(last["revision"])
        self.assertEqual({name: digest(document) for name, document in
                          [("log", log.document), *((author.name, author.replica.document) for author in authors)]},
                         dict.fromkeys(("log", *AUTHORS), digest(last["document"])))
        self.check_accepted(log, authors)
        total = lambda count: sum(map(count, authors))
        print(f"{len(log.accepted)} accepted, {total(lambda a: a.refused)} refused, {total(lambda a: len(a.restored))} restored; "
              f"{total(lambda a: a.lost)} messages lost", flush=True)
        for author in authors:
            author.stream.close()

    def check_accepted(self, log, authors):
        """Each is what its author was told, and is made once. One that was refused may be made all the same, if it was sent
        twice and the first arrived last: what is refused is not remembered."""
        self.assertEqual(list(log.accepted), list(range(2, log.revision + 1)))
        told = {revision: token for author in authors for token, revision in author.accepted.items()}
        self.assertEqual(len(told), sum(len(author.accepted) for author in authors))
        unsure = set().union(*(author.unsure for author in authors))
        restored = set().union(*(author.restored for author in authors))
        made = {revision: accepted.get("request") for revision, accepted in log.accepted.items()}
        self.assertEqual(told, {revision: token for revision, token in made.items() if revision in told})
        late = [token for revision, token in made.items() if revision not in told and revision not in restored]
        self.assertLessEqual(set(late), unsure)
        tokens = [token for token in made.values() if token]
        self.assertEqual(len(tokens), len(set(tokens)))

    def check_run(self, run, log):
        """It went on while they edited, and gets the last revision."""
        journal = run.journal()
        carried = journal.count("edit")
        steps = len(journal) - carried
        print(f"{carried} carried, between {steps} other steps", flush=True)
        self.assertGreater(carried, AT_LEAST)
        self.assertGreater(steps, AT_LEAST)
        self.make_sound(log)
        run.follow()

    def make_sound(self, log):
        """Where the authors leave a draft, the last revision that could be executed is restored."""
        if log.errors:
            stored = self.server.post("/documents/crowd/restore", {"revision": log.sound, "author": "Ida"}, "document_entry")
            log.read_until(stored["revision"])

    def undo_everything(self, log):
        """The latest edit that is in effect first: so nothing is in its way (core/edit/README.md). Whether nothing stays. In a long
        run something may: what the server has forgotten, and what that is in the way of."""
        in_effect = {}
        for revision, accepted in sorted(log.accepted.items()):
            if accepted["kind"] == "undo":
                del in_effect[accepted["of"]]
            else:
                in_effect[revision] = accepted["author"]
        is_remembered = len(log.accepted) + len(in_effect) <= REMEMBERED
        before, blocked = len(in_effect), set()
        while candidates := in_effect.keys() - blocked:
            revision = max(candidates)
            request = {"revision": log.revision, "author": in_effect[revision], "undo": True}
            status, undone = self.server.request("POST", "/api/v1/documents/crowd/edits", request)
            if status == 200:
                self.assertEqual(undone["of"], revision)
                del in_effect[revision]
                blocked.clear()
                log.read_until(undone["revision"])
                continue
            codes = {error["code"] for error in undone["errors"]}
            if codes == {"not_found"}:
                self.assertFalse(is_remembered, (revision, undone))
                self.assertGreater(before - len(in_effect) + len(blocked), REMEMBERED // 4)
                break
            self.assertLessEqual(codes, {"duplicate", "conflict"}, (revision, undone))
            blocked.add(revision)
        print(f"{before - len(in_effect)} of {before} undone, {len(blocked)} blocked", flush=True)
        self.assertLess(len(blocked), before // 2)
        if is_remembered:
            self.assertEqual(in_effect, {})
        return not in_effect

    def check_disk(self, run, log):
        """A server that begins again has the same documents and the same run, and so has who replays that."""
        self.server.post(f"/cores/{run.core}/pause", None, "core")
        before, native, last = run.info(), run.digest(), self.entry()
        with Connection(self.server.port) as connection:
            steps = {core: derivations(connection, core, connection.get(f"/cores/{core}")["step"]) for core in run.cores}
        for step in itertools.chain(*steps.values()):
            check_invariants(step["state"])
        self.kill()
        run.server = self.server
        self.assertEqual(self.entry(), last)
        with Connection(self.server.port) as connection:
            for revision, expected in log.digests.items():
                self.assertEqual(digest(connection.get(f"/documents/crowd/revisions/{revision}")["document"]), expected, revision)
        after = self.server.get(f"/cores/{run.core}", "core")
        self.assertEqual((after["status"], after["step"]), ("interrupted", before["step"]))
        self.assertLessEqual(after["revision"], before["revision"])  # less: an edit that no run depends on is in no journal
        self.assertEqual(run.digest(), native)
        for core, derived in steps.items():
            chain = self.server.get(f"/runs/{core}", "run")["chain"]
            self.assertIn(f"steps {len(derived)}\nchain {chain}\n", replay(core, self.data, "--hash"))
            self.assertEqual(replay(core, self.data)["steps"], [as_derived(step) for step in derived])
        print(f"macro steps replayed: {list(map(len, steps.values()))}; {run.forced} forced")


class FullDisk(unittest.TestCase):
    """The disk has no room from some write on, then has again: 507 meanwhile, and what was acknowledged is there."""

    document = models.document("crowd", {"state": "Root", "children": [{"state": "S0", "meta": {"id": "s0"}}]})

    def fill_up(self, at, error="ENOSPC"):
        data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, data)
        acknowledged, refused = {}, []
        with TracedServer(data) as server, Connection(server.port) as connection:
            connection.expect("PUT", "/documents/crowd", self.document)
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
