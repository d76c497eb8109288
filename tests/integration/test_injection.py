"""Strings of attackers (hostile_strings.py: 200 paths, 200 injections) in every route of openapi.yaml, and in the pages.

A place is a parameter of a route's path or query, a string of its body, the name of a field or parameter that it does not know.
Every route gets every string, every place a string of every class: with 16 + 18 classes, not each string at each place. A place at
which a password would be hashed gets one of each class alone; of the bodies with more than ten strings, those of RACE_SEED are taken.

What holds: nothing is answered 5xx but a documented 503; an error is a problem document with a listed status; no header is split off
from a string, no answer has what is in /etc/passwd or a secret of the data folder, and no line of the log is forged. The server opens
nothing for writing outside of its data folder, no file that a string names, and executes nothing (strace). Afterwards it is well, and
so is what it keeps. What is logged of strings is logged of processes that are refused: each string is the name of one's service, too.
"""
import contextlib
import itertools
import json
import os
import queue
import random
import re
import shutil
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

import models
from accounts import AccountServer
from client import PROJECT, TIMEOUT, check
from component_process import ComponentClient
from hostile_strings import ESCAPE, FORGED, LOOP, PASSWD_LINK, injection_strings, path_strings
from injection_places import PAGES, places
from interface import check_listed
from keep_alive import Answer, KeepAlive
from traced_opens import OpenTrace
from traced_server import LOG_LINE

SEED = int(os.environ.get("RACE_SEED", random.randrange(10**6)))
CLASSES = [*injection_strings().values(), *path_strings().values()]
CLIENTS = 4
MOST_BUSY = 0.02  # of the answers, that may be 503: what is not answered is not tested
HEADERS = {"server", "content-type", "content-length", "cache-control", "connection", "x-content-type-options", "x-frame-options",
           "content-security-policy", "cross-origin-opener-policy", "cross-origin-resource-policy", "referrer-policy", "www-authenticate",
           "allow", "location", "etag", "retry-after", "upgrade", "content-disposition", "vary", "idempotency-replayed"}
KEPT = {"/health": "health", "/documents": "documents", "/documents/target": "document_entry", "/documents/target/revisions": "revisions",
        "/accounts": "accounts", "/runs": "runs", "/cores": "cores", "/boot": "boot", "/audit": "audit", "/backups": "backups",
        "/cell": "scene", "/services": "services", "/proposals": "proposals"}
LOGIN = ("POST", "/api/v1/login")  # first: after ten that fail, no name is looked at any more
# What the server may read outside of its folders once it runs, whatever it is asked: what memory (glibc), threads and the clock need.
SYSTEM_FILES = ("/proc/sys/vm/overcommit_memory", "/sys/devices/system/cpu/", "/dev/urandom", "/etc/localtime", "/usr/share/zoneinfo/")


def combinations(all_places):
    """(place, string): every string at some place, at every place some string of every class."""
    cheap = [place for place in all_places if not place.is_costly]
    for number, strings in enumerate(CLASSES):
        turned = itertools.cycle(cheap[number % len(cheap):] + cheap[:number % len(cheap)])
        yield from zip(turned, itertools.islice(itertools.cycle(strings), max(len(strings), len(cheap))), strict=False)
        yield from ((place, strings[number % len(strings)]) for place in all_places if place.is_costly)


def secrets(data):
    """What no answer may have: lines of /etc/passwd, the token of processes, a database as it is on the disk."""
    lines = [line for line in Path("/etc/passwd").read_bytes().splitlines() if line]
    return [*lines, Path(data, "processes.token").read_bytes().strip(), b"SQLite format 3"]


def shape(value):
    """The keys and types of a JSON value."""
    if isinstance(value, dict):
        return tuple((key, shape(each)) for key, each in value.items())
    return frozenset(map(shape, value)) if isinstance(value, list) else type(value)


class Fixture:
    """A server under strace, with accounts, the demo and pages, in which all is there that a route can name."""

    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix="race-test-")
        self.web = Path(self.folder, "web")
        self.web.mkdir()
        Path(self.web, "index.html").write_text("<p>")
        for name, target in ((ESCAPE, "/etc"), (PASSWD_LINK, "/etc/passwd"), (LOOP, LOOP)):
            Path(self.web, name).symlink_to(target)
        self.trace = OpenTrace(Path(self.folder, "opened"))
        self.log = Path(self.folder, "log")
        with self.log.open("w") as log:
            self.server = AccountServer("--demo", str(PROJECT / "deploy/demo"), "--web", str(self.web), under=self.trace.words, stderr=log)
        self.secrets = secrets(self.server.data)

    def remove(self):
        """Also a server that a test has not ended."""
        if self.server.process.poll() is None:
            self.server.kill()
        shutil.rmtree(self.server.data, ignore_errors=True)
        shutil.rmtree(self.folder)

    def fill(self):
        """Stores one of each kind, and knows the values of parameters by their names."""
        server = self.server
        server.put("/documents/target", json.loads((PROJECT / "api/examples/document.ids.json").read_text()), "document_entry")
        run = server.core(models.ticking(last=1))
        server.ended(run)
        core = server.core(models.ticking(last=1), start=False)
        digest = server.get("/accounts/observer/tokens", "account_tokens")["tokens"][0]["digest"]
        scene = server.get("/cell", "scene")
        self.backup = server.post("/backups", None, "backup", 201)["name"]
        proposed = {"document": models.ticking(), "note": "why"}
        self.proposal = server.post("/documents/proposed/proposals", proposed, "proposal", 201)["id"]
        self.values = {"run": run, "with": run, "id": core, "digest": digest, "file": scene["robots"][0]["urdf"], "number": "0",
                       "service": "db", "revision": "1", "step": "1", "author": "admin"}
        self.begun = time.time()

    def known(self, pattern, name):
        if name == "name":
            return {"documents": "target", "accounts": "observer", "backups": self.backup}[pattern.split("/")[3]]
        if name == "id" and pattern.startswith("/api/v1/proposals/"):
            return self.proposal
        return self.values[name]


class Injection(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.fixture = Fixture()
        cls.addClassCleanup(cls.fixture.remove)
        cls.fixture.fill()
        cls.places = places(SEED)
        cls.statuses, cls.wrong, cls.shapes = [], [], set()  # which threads may add to
        cls.work = queue.SimpleQueue()
        for route in (LOGIN, *(each for each in cls.places if each != LOGIN)):
            cls.work.put(route)
        begun = time.monotonic()
        clients = [threading.Thread(target=cls.ask_all) for _ in range(CLIENTS)]
        for client in clients:
            client.start()
        for client in clients:
            client.join()
        print(f"seed {SEED}: {len(cls.statuses)} requests to {len(cls.places)} routes at {sum(map(len, cls.places.values()))} places in "
              f"{time.monotonic() - begun:.1f} s, {cls.statuses.count(503)} answered 503", flush=True)
        cls.greeted = sum(cls.greet(string) for string in itertools.chain(*CLASSES))
        cls.look_afterwards()

    @classmethod
    def greet(cls, string):
        """A process whose service is named so: its refusal is in the log, with that name. Whether the string can be said."""
        try:
            name = string.decode()
        except UnicodeDecodeError:
            return False
        with ComponentClient(cls.fixture.server) as client:
            client.send({"type": "hello", "protocol": 1, "components": [{"key": name, "type": name, "rsm": {"rsm": 1, "name": name}}]})
            assert client.message()["type"] == "refused"
        return True

    @classmethod
    def look_afterwards(cls):
        """What the server says of itself; then it ends."""
        server = cls.fixture.server
        cls.afterwards = {}
        for path, schema in KEPT.items():
            cls.afterwards[path] = schema, *server.request("GET", "/api/v1" + path)
        cls.data, cls.pid = os.path.realpath(server.data), server.process.pid
        server.stop()

    @classmethod
    def ask_all(cls):
        """A client: takes one route after the other."""
        with KeepAlive(cls.fixture.server.port, cls.fixture.server.token) as client:
            with contextlib.suppress(queue.Empty):
                while True:
                    route = cls.work.get_nowait()
                    for place, string in combinations(cls.places[route]):
                        cls.ask(client, place, string)

    @classmethod
    def ask(cls, client, place, string):
        try:
            target, body = place.request(cls.fixture.known, string)
            answer = client.ask(place.method, target, body)
            cls.statuses.append(answer.status)
            cls.check(place, string, answer)
        except Exception as error:  # whatever it is: the other strings have their turn
            cls.wrong.append(f"{place}, {string[:80]!r}: {type(error).__name__} {str(error)[:300]}")
            client.close()

    @classmethod
    def check(cls, place, string, answer):
        names = [name for name, _ in answer.headers]
        assert set(names) <= HEADERS and len(names) == len(set(names)), f"headers {answer.headers}"
        leaked = [secret for secret in cls.fixture.secrets if secret in answer.body]
        assert not leaked, f"says {leaked}"
        if answer.status < 400:
            return
        assert answer.header("content-type") == "application/problem+json", answer
        problem = answer.json()
        if shape(problem) not in cls.shapes:  # of thousands alike, one is held against the schema
            check("problem", problem)
            cls.shapes.add(shape(problem))
        assert problem["status"] == answer.status
        assert answer.status < 500 or answer.status == 503, f"{answer.status} {problem}"
        elsewhere = place.kind == "path" and re.search(rb"[/?]|%(25)*2f", string, re.IGNORECASE)  # it may be another route's
        if not elsewhere and (place.method, place.pattern) != PAGES:
            check_listed(place.method, place.pattern, answer.status, problem)

    def test_every_route_gets_every_string_and_every_place_every_class(self):
        for route, its_places in self.places.items():
            pairs = list(combinations(its_places))
            self.assertEqual({string for _, string in pairs}, set(itertools.chain(*CLASSES)), route)
            self.assertEqual({(place, number) for number, strings in enumerate(CLASSES) for place, string in pairs if string in strings},
                             set(itertools.product(its_places, range(len(CLASSES)))))
        for strings in (path_strings(), injection_strings()):
            self.assertGreaterEqual(len(set(itertools.chain(*strings.values()))), 200)

    def test_every_answer_is_what_the_interface_says(self):
        self.assertEqual(self.wrong[:20], [], f"{len(self.wrong)} of {len(self.statuses)}")
        self.assertEqual(len(self.statuses), sum(len(list(combinations(its_places))) for its_places in self.places.values()))
        self.assertLess(self.statuses.count(503), MOST_BUSY * len(self.statuses))

    def test_an_answer_that_must_not_be_is_noticed(self):
        place = self.places["GET", "/api/v1/documents/{name}"][0]
        problem = {"status": 404, "title": "x", "detail": "x", "errors": [{"path": "", "code": "not_found", "message": "x"}]}
        kind = ("content-type", "application/problem+json")
        good = Answer(404, [kind], json.dumps(problem).encode())
        self.check(place, b"x", good)
        internal = json.dumps({**problem, "status": 500}).encode()
        for wrong in (Answer(500, [kind], internal), Answer(404, [kind], internal), Answer(404, [kind], b"{}"), Answer(404, [], good.body),
                      Answer(200, [("x-injected", "1")], b""), Answer(200, [kind, kind], b""), Answer(409, [kind], good.body),
                      *(Answer(200, [], b"x" + secret) for secret in self.fixture.secrets)):
            with self.assertRaises(AssertionError, msg=wrong):
                self.check(place, b"x", wrong)

    def test_the_server_is_well_afterwards(self):
        for path, (schema, status, answer) in self.afterwards.items():
            with self.subTest(path):
                self.assertEqual(status, 200, answer)
                check(schema, answer)

    def test_no_line_of_the_log_is_forged(self):
        text = self.fixture.log.read_text()
        self.assertEqual(LOG_LINE.sub("", text), "")
        self.assertGreaterEqual(text.count("is refused"), self.greeted)
        self.assertGreater(self.greeted, 300)
        self.assertNotIn("\n" + FORGED, text)
        self.assertIsNone(re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e]", text))

    def test_nothing_outside_of_the_data_folder_is_opened_for_writing(self):
        written = {each.path for each in self.fixture.trace.opened(self.pid) if each.writes and not self.is_in(self.data, each.path)}
        self.assertEqual(written, set())

    def test_no_file_is_opened_that_a_string_names(self):
        opened = [each.path for each in self.fixture.trace.opened(self.pid) if each.time > self.fixture.begun]
        self.assertGreater(len(opened), 0, "the pages, at least")
        outside = {path for path in opened if not self.is_in(self.data, path) and path != str(self.fixture.web / "index.html")}
        self.assertEqual({path for path in outside if not path.startswith(SYSTEM_FILES)}, set())

    def test_nothing_is_executed(self):
        executed = self.fixture.trace.calls(self.pid, "execve", "execveat", "fork", "vfork")
        self.assertEqual(len(executed), 1, executed)
        self.assertFalse(Path("/dev/shm/race-injected").exists())

    def test_the_trace_sees_what_is_opened_and_executed(self):
        trace = OpenTrace(Path(self.fixture.folder, "other"))
        written = Path(self.fixture.folder, "a \u00e9 \"file\"\n")
        words = ["sh", "-c", "cd /etc; echo x > \"$1\"; cat ../etc/passwd", "sh", str(written)]
        process = subprocess.Popen([*trace.words, *words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        process.wait(TIMEOUT)
        opened = trace.opened(process.pid)
        self.assertEqual([each.path for each in opened if each.writes], [str(written)])
        self.assertIn("/etc/passwd", [each.path for each in opened])
        self.assertGreaterEqual(len(trace.calls(process.pid, "execve")), 2)

    @staticmethod
    def is_in(folder, path):
        return path == folder or path.startswith(folder + "/")


if __name__ == "__main__":
    unittest.main()
