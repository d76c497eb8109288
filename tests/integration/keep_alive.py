"""HTTP over one socket that is kept: requests are sent byte by byte as the test has them, answers are read strictly.

For tests that ask thousands of things, some of which no HTTP library would send.
"""
import contextlib
import json
import socket
from dataclasses import dataclass

from client import TIMEOUT


@dataclass
class Answer:
    status: int
    headers: list  # (name, value), in their order; names in lower case
    body: bytes

    def header(self, name):
        """The value; None: it is not there. One that stands twice is an error of the server."""
        values = [value for each, value in self.headers if each == name]
        assert len(values) < 2, self.headers
        return values[0] if values else None

    def json(self):
        return json.loads(self.body)


class KeepAlive:
    """A client with one connection at a time: a new one when the server has closed the last one."""

    def __init__(self, port, token=None):
        self.port = port
        self.always = f"Host: 127.0.0.1:{port}\r\n" + (f"Authorization: Bearer {token}\r\n" if token else "")
        self.socket = None
        self.buffer = b""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        if self.socket:
            self.socket.close()
        self.socket, self.buffer = None, b""

    def ask(self, method, target, body=None, content_type="application/json"):
        """The answer to a request; target and body are sent as they are (bytes)."""
        head = method.encode() + b" " + target + b" HTTP/1.1\r\n" + self.always.encode()
        if body is not None:
            head += f"Content-Type: {content_type}\r\nContent-Length: {len(body)}\r\n".encode()
        return self.send(head + b"\r\n" + (body or b""))

    def send(self, request):
        """The answer to these bytes. Nothing may be left of an earlier answer: it would be a split one."""
        assert not self.buffer, self.buffer
        if not self.socket:
            self.socket = socket.create_connection(("127.0.0.1", self.port), timeout=TIMEOUT)
            self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):  # the server refuses it before its end, and has said why
            self.socket.sendall(request)
        answer = self.read()
        if answer.header("connection") == "close":
            self.close()
        return answer

    def read(self):
        head, self.buffer = self.read_until(b"\r\n\r\n")
        first, *lines = head.decode("latin-1").split("\r\n")
        version, status, _ = first.split(" ", 2)
        assert version == "HTTP/1.1", first
        headers = [(name.lower(), value) for name, value in (line.split(": ", 1) for line in lines)]
        answer = Answer(int(status), headers, b"")
        length = int(answer.header("content-length") or 0)
        while len(self.buffer) < length:
            self.buffer += self.receive()
        answer.body, self.buffer = self.buffer[:length], self.buffer[length:]
        return answer

    def read_until(self, mark):
        while mark not in self.buffer:
            self.buffer += self.receive()
        return self.buffer.split(mark, 1)

    def receive(self):
        data = self.socket.recv(1 << 16)
        if not data:
            raise ConnectionError("the server closed the connection")
        return data
