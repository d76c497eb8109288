"""A client of `race mcp`: the process, and what it sends, each message held against mcp_schema.json."""
import json
import os
import queue
import subprocess
import threading
import time
from pathlib import Path

import jsonschema

from client import PROGRAM, TIMEOUT

SCHEMA = json.loads((Path(__file__).parent / "mcp_schema.json").read_text())
NEWEST = "2025-11-25"


def held(name, value):
    """The value, which fits `$defs/name` of the schema; without a name, the schema itself."""
    schema = SCHEMA if name is None else {"$ref": f"#/$defs/{name.replace('/', '~1')}", "$defs": SCHEMA["$defs"]}
    error = jsonschema.exceptions.best_match(jsonschema.Draft202012Validator(schema).iter_errors(value))
    assert error is None, f"no {name or 'message'}: {error.message[:500]} at {list(error.absolute_path)}"
    return value


class Agent:
    """`race mcp` with a client that reads all it says. As a context manager it closes its input and expects status 0."""

    def __init__(self, url, *options, version=NEWEST, token=None, state="/nonexistent"):
        """`version`: of the protocol, to initialize with; None: not to. `state`: where logins are kept."""
        environment = {key: value for key, value in os.environ.items() if key not in ("RACE_TOKEN", "RACE_CA")}
        environment["XDG_STATE_HOME"] = str(state)
        if token is not None:
            environment["RACE_TOKEN"] = token
        self.process = subprocess.Popen([PROGRAM, "mcp", "--server", url, *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, env=environment)
        self.said = queue.Queue()
        self.progress = []  # notifications
        self.number = 0
        threading.Thread(target=self._read, daemon=True).start()
        if version is not None:
            self.initialized = self.ask("initialize", {"protocolVersion": version, "capabilities": {},
                                                       "clientInfo": {"name": "test", "version": "1"}})
            self.notify("notifications/initialized")

    def _read(self):
        for line in self.process.stdout:
            self.said.put(line)
        self.said.put(None)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            assert self.end() == 0
        finally:
            self.process.kill()
            self.process.wait()
            self.process.stdout.close()
            self.process.stderr.close()

    def end(self):
        """Closes its input; its status."""
        if not self.process.stdin.closed:
            self.process.stdin.close()
        return self.process.wait(TIMEOUT)

    def send_raw(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        self.send_raw(json.dumps(message).encode() + b"\n")

    def notify(self, method, params=None):
        self.send({"jsonrpc": "2.0", "method": method, **({} if params is None else {"params": params})})

    def begin(self, method, params=None):
        """Sends a request; its id."""
        self.number += 1
        self.send({"jsonrpc": "2.0", "id": self.number, "method": method, **({} if params is None else {"params": params})})
        return self.number

    def receive(self, timeout=TIMEOUT):
        """The next message, or batch, as it is; None: no more come."""
        line = self.said.get(timeout=timeout)
        if line is None:
            return None
        message = json.loads(line)
        for each in message if isinstance(message, list) else [message]:
            held(None, each)
        return message

    def answer(self, timeout=TIMEOUT):
        """The next message that tells no progress."""
        end = time.monotonic() + timeout
        while True:
            message = self.receive(max(0.01, end - time.monotonic()))
            if not isinstance(message, dict) or message.get("method") != "notifications/progress":
                return message
            self.progress.append(message["params"])

    def ask(self, method, params=None, timeout=TIMEOUT):
        """The result of a request, held against the schema of its method."""
        number = self.begin(method, params)
        message = self.answer(timeout)
        assert message["id"] == number and "result" in message, message
        return held(method, message["result"])

    def refused(self, method, params=None):
        """The error of a request."""
        number = self.begin(method, params)
        message = self.answer()
        assert message["id"] == number and "error" in message, message
        return message["error"]

    def call(self, tool, timeout=TIMEOUT, **arguments):
        """What a tool answers."""
        result = self.ask("tools/call", {"name": tool, "arguments": arguments}, timeout)
        assert not result["isError"], result["structuredContent"]
        assert json.loads(result["content"][0]["text"]) == result["structuredContent"]
        return result["structuredContent"]

    def errors(self, tool, **arguments):
        """The errors of a call that the server refuses."""
        result = self.ask("tools/call", {"name": tool, "arguments": arguments})
        assert result["isError"], result["structuredContent"]
        return result["structuredContent"]["errors"]
