"""What a client does while the server is killed: 60 edits and a run of 200 steps; and what the server acknowledged."""
import json
import socket
import time

import models
from client import TIMEOUT

EDITS = 60
STEPS = 200
COMMANDED = 100  # steps that the client asks for, one by one; then the run goes on by itself
TASK = "recording"
EDITED = "edited"


def task():
    """Stores a value under a key of its own, again and again: one call is open, and each answer is a macro step. So the
    database shows which calls were executed. What came of a call, "stored" or the code of its error, is in `answers`."""
    def state(me, other):
        return {"state": me, "parameters": [{"name": "n", "from": "len(res.answers)"}],
                "entry": "svc.db.add('k' + str(par.n), par.n)",
                "ports": [{"name": "next", "when": "svc.db.add.result or svc.db.add.error", "to": other}]}
    return models.document(TASK, {
        "state": "Root", "results": [{"name": "answers", "initial": []}],
        "actions": [{"when": "svc.db.add.result", "do": "res.answers.append('stored')"},
                    {"when": "svc.db.add.error", "do": "res.answers.append(svc.db.add.error.code)"}],
        "children": [state("Ping", "Pong"), state("Pong", "Ping")], "first": "Ping",
        "ports": [{"name": "done", "when": f"len(res.answers) >= {STEPS - 1}"}]})


def edit(number):
    """The document after this edit, from 1; its text has up to a few pages of SQLite."""
    return models.document(EDITED, {
        "state": "Root", "doc": f"edit {number} " + "x" * (number * 997 % 9000), "meta": {"id": "root"},
        "parameters": [{"name": "number", "value": number, "meta": {"id": "number"}}],
        "ports": [{"name": "next", "when": "False"}]})


def edit_request(number, seen):
    """The body of this edit, from 2, by somebody who has seen this revision."""
    return {"revision": seen, "request": f"e{number}", "operations": [
        {"op": "set", "id": "number", "field": "value", "value": number},
        {"op": "set", "id": "root", "field": "doc", "value": edit(number)["root"]["doc"]}]}


class Connection:
    """HTTP on one connection that is kept, as cheap as it can be: nothing is validated, test_routes.py does that."""

    def __init__(self, port):
        self.host = f"127.0.0.1:{port}"
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=TIMEOUT)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.file = self.socket.makefile("rb")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.file.close()
        self.socket.close()

    def request(self, method, path, body=None):
        """(status, parsed answer). Error, when the server dies: OSError."""
        head = f"{method} /api/v1{path} HTTP/1.1\r\nHost: {self.host}\r\n"
        text = b""
        if body is not None:
            text = json.dumps(body).encode()
            head += f"Content-Type: application/json\r\nContent-Length: {len(text)}\r\n"
        self.socket.sendall(head.encode() + b"\r\n" + text)
        status = int(self.line()[9:12])
        length = 0
        while field := self.line():
            if field.lower().startswith(b"content-length:"):
                length = int(field[15:])
        answer = self.file.read(length)
        if len(answer) < length:
            raise ConnectionError("the server has died")
        return status, json.loads(answer) if answer else None

    def line(self):
        line = self.file.readline()
        if not line.endswith(b"\n"):
            raise ConnectionError("the server has died")
        return line.rstrip()

    def expect(self, method, path, body=None, status=(200, 201)):
        got, answer = self.request(method, path, body)
        assert got in status, f"{method} {path}: {got} {str(answer)[:500]}"
        return answer

    def get(self, path):
        return self.expect("GET", path)


class Scenario:
    """The client, and what it was told before the server died."""

    def __init__(self, connection=None, core=None):
        self.connection = connection
        self.edits = {}  # acknowledged: revision -> (time, doc)
        self.core = core  # its id, once its creation was acknowledged
        self.step = 0  # of the core, as it was told last
        self.complete = False

    def run(self, connection, edits_first):
        """All of it. OSError: the server has died."""
        self.connection = connection
        if edits_first:
            self.edit(self.rotate)
            self.command()
        else:
            self.command()
            self.edit(self.observe)
        self.wait()
        self.complete = True

    def edit(self, between):
        for number in range(1, EDITS + 1):
            if number == 1:
                stored = self.connection.expect("PUT", f"/documents/{EDITED}", edit(number))
            else:
                stored = self.connection.expect("POST", f"/documents/{EDITED}/edits", edit_request(number, number - 1))
            self.acknowledge(stored, number)
            between()

    def acknowledge(self, stored, number):
        self.edits[stored["revision"]] = (stored["time"], edit(number)["root"]["doc"])

    def check_edits(self, connection):
        """Every edit that was acknowledged is there."""
        for revision, acknowledged in self.edits.items():
            stored = connection.get(f"/documents/{EDITED}/revisions/{revision}")
            assert (stored["time"], stored["document"]["root"]["doc"]) == acknowledged, revision

    def rotate(self):
        """Asks as often as the server has other handler threads, which take turns: one of them gets all edits, so that
        strace's counts, which are of a thread, reach every one of their writes."""
        for _ in range(3):
            self.connection.get("/health")

    def command(self):
        """Creates the core and starts it; it makes its first steps by commands, then it runs."""
        self.connection.expect("PUT", f"/documents/{TASK}", task())
        self.core = self.connection.expect("POST", "/cores", {"document": TASK, "arguments": {}})["id"]
        for command in ("pause", "start"):
            self.tell(command)
        for number in range(1, COMMANDED + 1):
            self.tell("step", {"kind": "macro"})
            while self.step < number:
                self.observe()
        self.tell("resume")

    def tell(self, command, body=None):
        self.note(self.connection.expect("POST", f"/cores/{self.core}/{command}", body))

    def observe(self):
        """The status of the core."""
        return self.note(self.connection.get(f"/cores/{self.core}"))

    def wait(self):
        """The status of the core, once it does not run."""
        end = time.monotonic() + TIMEOUT
        while (status := self.observe()) == "running":
            time.sleep(0.001)  # and leave the processor to the server
            assert time.monotonic() < end, f"the run stays at step {self.step}"
        return status

    def note(self, core):
        assert core["step"] >= self.step, (core, self.step)
        self.step = core["step"]
        return core["status"]
