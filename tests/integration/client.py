"""The server under test, an HTTP client and a client of the stream; every answer is validated against api/."""
import http.client
import json
import os
import re
import shutil
import socket
import subprocess
import tempfile
import threading
import time
from pathlib import Path

import jsonschema

from interface import check_listed, schema_of
from websocket_client import WebSocketClient

PROJECT = Path(__file__).resolve().parents[2]
SCHEMAS = {path.stem: json.loads(path.read_text()) for path in (PROJECT / "api" / "schemas").glob("*.json")}
BY_ADDRESS = {schema["$id"]: schema for schema in SCHEMAS.values()}
PROGRAM = os.environ.get("RACE_PROGRAM", str(PROJECT / "build/release/race"))
ROGUE = os.environ.get("RACE_ROGUE", "")
# Headers of every answer, for browsers: nothing of other servers, no frames, no window of another page, no address of ours to others.
PAGE_RULES = ("Content-Security-Policy: default-src 'self'; img-src 'self' data:; object-src 'none'; base-uri 'none'; "
              "form-action 'none'; frame-ancestors 'none'", "X-Frame-Options: DENY", "X-Content-Type-Options: nosniff",
              "Cross-Origin-Opener-Policy: same-origin", "Cross-Origin-Resource-Policy: same-origin",
              "Referrer-Policy: same-origin")
TIMEOUT = 20  # seconds until a test gives up; no test needs them
# Data folders are in memory: a disk that is busy with something else interrupts runs, which is not what is tested. A
# kill loses nothing that is in the page cache, and strace's failures are not the disk's: a real disk would add nothing
# but time. What a loss of power does is tested below SQLite (tests/unit).
tempfile.tempdir = "/dev/shm" if os.path.isdir("/dev/shm") else None


def validator(name):
    schema = SCHEMAS[name]
    resolver = jsonschema.RefResolver(schema["$id"], schema, store=BY_ADDRESS)
    return jsonschema.Draft202012Validator(schema, resolver=resolver)


VALIDATORS = {}
VALIDATING = threading.Lock()  # a resolver keeps where it is, for all threads


def check(name, value):
    """Asserts that value is valid against schemas/name.json; returns it."""
    with VALIDATING:
        if name not in VALIDATORS:
            VALIDATORS[name] = validator(name)
        error = jsonschema.exceptions.best_match(VALIDATORS[name].iter_errors(value))
    if error is not None:
        raise AssertionError(f"not {name}.json: {error.message[:500]} at {list(error.absolute_path)}")
    return value


class Server:
    """`race serve` on a free port with its own data folder. As a context manager it stops at the end of the block."""

    token = None  # of an account, which every request has

    def __init__(self, *options, data=None, program=None, stderr=None, under=(), port=0):
        """`under`: words of a command that starts it, in the same process, as `strace -D`. `port`: 0 is a free one."""
        self.own = data is None
        self.data = data or tempfile.mkdtemp(prefix="race-test-")
        command = [program, self.data, *options] if program else [PROGRAM, "serve", "--port", str(port), "--data", self.data, *options]
        self.process = subprocess.Popen([*under, *command], stdout=subprocess.PIPE, stderr=stderr, text=True)
        line = self.process.stdout.readline()
        match = re.search(r":(\d+)$", line.strip())
        assert match, f"the server did not start: {line!r}"
        self.port = int(match.group(1))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        """Sends SIGTERM, as a service manager does; the server must end by itself with status 0."""
        self.process.terminate()
        try:
            status = self.process.wait(TIMEOUT)
        finally:
            self.process.kill()
            self.process.stdout.close()
        if self.own:
            shutil.rmtree(self.data)
        assert status == 0, f"the server ended with status {status}"

    def kill(self):
        """Sends SIGKILL; the data folder stays."""
        self.process.kill()
        self.process.wait(TIMEOUT)
        self.process.stdout.close()

    def request(self, method, path, body=None, headers=None):
        """(status, parsed JSON or text); openapi.yaml must list the status for this route."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=TIMEOUT)
        headers = dict(headers or {})
        if self.token is not None:
            headers.setdefault("Authorization", f"Bearer {self.token}")
        if body is not None and not isinstance(body, (str, bytes)):
            body = json.dumps(body)
        if body is not None:
            headers.setdefault("Content-Type", "application/json")
        connection.request(method, path, body=body, headers=headers)
        response = connection.getresponse()
        text = response.read().decode()
        connection.close()
        is_json = response.getheader("Content-Type", "") in ("application/json", "application/problem+json")
        answer = json.loads(text) if is_json else text
        check_listed(method, path, response.status, answer)
        return response.status, answer

    def get(self, path, schema=None, status=200):
        return self.expect("GET", path, None, schema, status)

    def post(self, path, body=None, schema=None, status=200):
        return self.expect("POST", path, body, schema, status)

    def put(self, path, body, schema=None, status=None):
        """200, and 201 for a document of a new name, unless `status` says otherwise."""
        if status is None:
            status = (200, 201) if re.match("/documents/[^/]+$", path) else 200
        return self.expect("PUT", path, body, schema, status)

    def expect(self, method, path, body, schema, status):
        got, answer = self.request(method, "/api/v1" + path, body)
        assert got in (status if isinstance(status, tuple) else (status,)), f"{method} {path}: {got} {str(answer)[:500]}"
        if got >= 400:
            check("problem", answer)
        elif schema:
            assert schema == schema_of(method, "/api/v1" + path, got), f"openapi.yaml has no {schema} for {method} {path}"
            check(schema, answer)
        return answer

    def core(self, document, arguments=None, start=True):
        """Stores the document (a dict) under its name and creates a core of it; returns the id of the core."""
        self.put(f"/documents/{document['name']}", document, "document_entry")
        core = self.post("/cores", {"document": document["name"], "arguments": arguments or {}}, "core", 201)
        if start:
            self.post(f"/cores/{core['id']}/start", None, "core")
        return core["id"]

    def wait(self, core, condition, timeout=TIMEOUT):
        """The core (core.json), once condition(core) holds."""
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            state = self.get(f"/cores/{core}", "core")
            if condition(state):
                return state
            time.sleep(0.01)
        raise AssertionError(f"core {core} stays {state}")

    def ended(self, core, timeout=TIMEOUT):
        return self.wait(core, lambda c: c["status"] not in ("ready", "running"), timeout)

    def wait_for(self, condition, timeout=TIMEOUT):
        """Returns once condition() holds."""
        end = time.monotonic() + timeout
        while not condition():
            assert time.monotonic() < end, "it does not come to that"
            time.sleep(0.05)

    def audited(self, action, limit=1000):
        """The last rows of the audit log, the last first, once the last is of that action.

        A row is written a moment after what it is of is answered.
        """
        rows = []

        def is_written():
            rows[:] = self.get(f"/audit?limit={limit}", "audit")["entries"]
            return rows and action in rows[0]["action"]

        self.wait_for(is_written)
        return rows

    def stream(self):
        return Stream(self.port, token=self.token)

    def send_raw(self, data):
        """For a hostile client: the server's answer to these bytes on a bare socket, until it closes the connection."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=TIMEOUT) as connection:
            connection.sendall(data)
            connection.shutdown(socket.SHUT_WR)
            answer = b""
            while chunk := connection.recv(65536):
                answer += chunk
        return answer


class Stream(WebSocketClient):
    """A client of /api/v1/stream; every message is held against stream_message.json."""

    def __init__(self, port, origin=None, token=None, ticket=None):
        path = "/api/v1/stream" if ticket is None else f"/api/v1/stream?ticket={ticket}"
        super().__init__(port, path, TIMEOUT, origin, token)

    def send_checked(self, message):
        """Sends a message that is of stream_request.json."""
        self.send(check("stream_request", message))

    def subscribe(self, channel, since=None):
        message = {"type": "subscribe", "channel": channel}
        if since is not None:
            message["since"] = since
        self.send_checked(message)

    def message(self):
        """The next message."""
        return check("stream_message", self.receive())

    def messages(self):
        """The next messages of a client that has asked for `gather`."""
        messages = self.receive()
        assert isinstance(messages, list) and messages, messages
        return [check("stream_message", message) for message in messages]

    def until(self, condition, timeout=6 * TIMEOUT):
        """All messages up to and including the first for which condition(message) holds."""
        messages, end = [], time.monotonic() + timeout
        while time.monotonic() < end:
            messages.append(self.message())
            if condition(messages[-1]):
                return messages
        raise AssertionError(f"{len(messages)} messages, but not the expected one; the last: {str(messages[-1])[:500]}")
