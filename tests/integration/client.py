"""A server under test and its clients: HTTP and WebSocket over real sockets, answers held against openapi.yaml."""
import base64
import http.client
import json
import os
import re
import shutil
import socket
import struct
import subprocess
import tempfile
import time
from pathlib import Path

import jsonschema

from interface import check_listed, schema_of

PROJECT = Path(__file__).resolve().parents[2]
SCHEMAS = PROJECT / "api" / "schemas"
PROGRAM = os.environ.get("RACE_PROGRAM", str(PROJECT / "build/release/race"))
ROGUE = os.environ.get("RACE_ROGUE", "")
PATIENCE = 20  # seconds until a test gives up; no test needs them


def validator(name):
    path = SCHEMAS / f"{name}.json"
    schema = json.loads(path.read_text())
    resolver = jsonschema.RefResolver(path.as_uri(), schema)
    return jsonschema.Draft202012Validator(schema, resolver=resolver)


VALIDATORS = {}


def check(name, value):
    """value is of schemas/name.json; returns it."""
    if name not in VALIDATORS:
        VALIDATORS[name] = validator(name)
    error = jsonschema.exceptions.best_match(VALIDATORS[name].iter_errors(value))
    if error is not None:
        raise AssertionError(f"not {name}.json: {error.message[:500]} at {list(error.absolute_path)}")
    return value


class Server:
    """`race serve` on a free port with a folder of its own; ends with the block."""

    def __init__(self, *options, data=None, program=None):
        self.own = data is None
        self.data = data or tempfile.mkdtemp(prefix="race-test-")
        command = [program, self.data] if program else [PROGRAM, "serve", "--port", "0", "--data", self.data, *options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        match = re.search(r":(\d+)$", line.strip())
        assert match, f"the server did not start: {line!r}"
        self.port = int(match.group(1))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        """As a service manager stops it; it must end by itself and without complaint."""
        self.process.terminate()
        status = self.process.wait(PATIENCE)
        self.process.stdout.close()
        if self.own:
            shutil.rmtree(self.data)
        assert status == 0, f"the server ended with status {status}"

    def request(self, method, path, body=None, headers=None):
        """(status, parsed JSON or text); the status is one of the route."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE)
        headers = dict(headers or {})
        if body is not None and not isinstance(body, (str, bytes)):
            body = json.dumps(body)
        if body is not None:
            headers.setdefault("Content-Type", "application/json")
        connection.request(method, path, body=body, headers=headers)
        response = connection.getresponse()
        text = response.read().decode()
        connection.close()
        is_json = response.getheader("Content-Type", "").startswith("application/json")
        answer = json.loads(text) if is_json else text
        check_listed(method, path, response.status, answer)
        return response.status, answer

    def get(self, path, schema=None, status=200):
        return self.expect("GET", path, None, schema, status)

    def post(self, path, body=None, schema=None, status=200):
        return self.expect("POST", path, body, schema, status)

    def put(self, path, body, schema=None, status=200):
        return self.expect("PUT", path, body, schema, status)

    def expect(self, method, path, body, schema, status):
        got, answer = self.request(method, "/api/v1" + path, body)
        assert got == status, f"{method} {path}: {got} {str(answer)[:500]}"
        if status >= 400:
            check("errors", answer)
        elif schema:
            assert schema == schema_of(method, "/api/v1" + path, status), f"openapi.yaml has no {schema} for {method} {path}"
            check(schema, answer)
        return answer

    def core(self, document, arguments=None, start=True):
        """The id of a new core of a document (a dict), which is stored under its name."""
        self.put(f"/documents/{document['name']}", document, "document_entry")
        core = self.post("/cores", {"document": document["name"], "arguments": arguments or {}}, "core", 201)
        if start:
            self.post(f"/cores/{core['id']}/start", None, "core")
        return core["id"]

    def wait(self, core, what, patience=PATIENCE):
        """The core (core.json), once what(core) holds."""
        end = time.monotonic() + patience
        while time.monotonic() < end:
            state = self.get(f"/cores/{core}", "core")
            if what(state):
                return state
            time.sleep(0.01)
        raise AssertionError(f"core {core} stays {state}")

    def ended(self, core, patience=PATIENCE):
        return self.wait(core, lambda c: c["status"] not in ("ready", "running"), patience)

    def stream(self):
        return Stream(self.port)

    def raw(self, data):
        """What the server answers to these bytes, until it closes the connection."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=PATIENCE) as connection:
            connection.sendall(data)
            connection.shutdown(socket.SHUT_WR)
            answer = b""
            while chunk := connection.recv(65536):
                answer += chunk
        return answer


class Stream:
    """A client of /api/v1/stream; every message is held against stream_message.json."""

    PATH = "/api/v1/stream"

    def __init__(self, port, headers=()):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=PATIENCE)
        lines = [f"GET {self.PATH} HTTP/1.1", f"Host: 127.0.0.1:{port}", "Upgrade: websocket", "Connection: Upgrade",
                 "Sec-WebSocket-Key: " + base64.b64encode(os.urandom(16)).decode(), "Sec-WebSocket-Version: 13", *headers]
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
        self.buffer = b""
        while b"\r\n\r\n" not in self.buffer:
            self.receive()
        head, self.buffer = self.buffer.split(b"\r\n\r\n", 1)
        self.status = int(head.split()[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def receive(self):
        chunk = self.socket.recv(65536)
        if not chunk:
            raise ConnectionError("the server closed the stream")
        self.buffer += chunk

    def take(self, count):
        while len(self.buffer) < count:
            self.receive()
        data, self.buffer = self.buffer[:count], self.buffer[count:]
        return data

    def send_frame(self, opcode, payload):
        mask = os.urandom(4)
        size = len(payload)
        head = struct.pack("!BB", 0x80 | opcode, 0x80 | min(size, 126) if size < 126 else 0x80 | (126 if size < 65536 else 127))
        if size >= 126:
            head += struct.pack("!H" if size < 65536 else "!Q", size)
        self.socket.sendall(head + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(payload)))

    def send(self, message):
        self.send_frame(1, (message if isinstance(message, str) else json.dumps(message)).encode())

    def subscribe(self, channel, since=None):
        message = {"type": "subscribe", "channel": channel}
        if since is not None:
            message["since"] = since
        self.send(check("stream_request", message))

    def message(self):
        """The next message, put together from its frames."""
        whole = b""
        while True:
            first, second = self.take(2)
            size = second & 0x7F
            if size == 126:
                (size,) = struct.unpack("!H", self.take(2))
            elif size == 127:
                (size,) = struct.unpack("!Q", self.take(8))
            payload = self.take(size)
            opcode = first & 0x0F
            if opcode == 9:
                self.send_frame(10, payload)
            elif opcode == 8:
                raise ConnectionError(f"closed: {payload!r}")
            else:
                whole += payload
                if first & 0x80:
                    return check("stream_message", json.loads(whole))

    def until(self, what, patience=6 * PATIENCE):
        """All messages up to and including the first for which what(message) holds."""
        messages, end = [], time.monotonic() + patience
        while time.monotonic() < end:
            messages.append(self.message())
            if what(messages[-1]):
                return messages
        raise AssertionError(f"{len(messages)} messages, none of them the one; the last: {str(messages[-1])[:500]}")
