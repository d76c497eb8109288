"""WebSocket frames, right and wrong, byte by byte over a bare socket (RFC 6455); what the server says is read strictly.

For what no library sends; websocket_client.py is for all else.
"""
import base64
import hashlib
import json
import socket
import time
from dataclasses import dataclass, field

from client import TIMEOUT

CONTINUATION, TEXT, BINARY, CLOSE, PING, PONG = 0, 1, 2, 8, 9, 10
MASK = b"\x12\x34\x56\x78"
KEY = "dGhlIHNhbXBsZSBub25jZQ=="  # of section 1.3
HEADERS = {"Host": "127.0.0.1:PORT", "Connection": "Upgrade", "Upgrade": "websocket", "Sec-WebSocket-Version": "13",
           "Sec-WebSocket-Key": KEY}
SILENCE = 4  # [s] after which a server that should have ended a connection has not


def accept_of(key):
    """What the server proves with that it has read the key (4.2.2)."""
    return base64.b64encode(hashlib.sha1((key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").encode()).digest()).decode()


def frame(opcode, payload=b"", fin=True, reserved=0, mask=MASK, form=None, length=None):
    """`mask` None: not masked. `form`: 0, 2 or 8 bytes of length, else as few as possible. `length`: another one than the payload's."""
    length = len(payload) if length is None else length
    form = (0 if length < 126 else 2 if length < 65536 else 8) if form is None else form
    short = {0: length, 2: 126, 8: 127}[form]
    head = bytes([fin << 7 | reserved << 4 | opcode, (mask is not None) << 7 | short]) + length.to_bytes(8, "big")[8 - form:]
    if mask is None:
        return head + payload
    masked = bytes(byte ^ mask[place % 4] for place, byte in enumerate(payload)) if any(mask) else payload
    return head + mask + masked


def fragments(payload, sizes, opcode=TEXT, between=b""):
    """A message in frames of these sizes, the last of which has the rest; `between` two of them."""
    parts = []
    for size in sizes:
        parts.append(payload[:size])
        payload = payload[size:]
    parts.append(payload)
    frames = [frame(opcode if number == 0 else CONTINUATION, part, fin=number == len(parts) - 1) for number, part in enumerate(parts)]
    return between.join(frames)


def close(code=None, reason=b""):
    return frame(CLOSE, (b"" if code is None else code.to_bytes(2, "big")) + reason)


@dataclass
class Said:
    """What a server has said: pairs of what and which (pong and payload, close and code, message and channel); whether it has ended."""
    events: list = field(default_factory=list)
    ended: bool = False


class RawWebSocket:
    """A connection to `path`; a context manager."""

    def __init__(self, port, path, token=None):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=TIMEOUT)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.buffer = b""
        headers = dict(HEADERS) | ({"Authorization": f"Bearer {token}"} if token else {})
        self.socket.sendall(request_text("GET", path, headers.items(), port))
        status, answered = self.read_head()
        assert status == 101 and answered["sec-websocket-accept"] == accept_of(KEY), (status, answered)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def read_head(self):
        """(status, headers) of the answer to the handshake."""
        while b"\r\n\r\n" not in self.buffer:
            self.buffer += self.receive()
        head, self.buffer = self.buffer.split(b"\r\n\r\n", 1)
        return head_of(head)

    def send(self, pieces, pause=0):
        """One piece after the other; a server that has heard enough may have closed the connection."""
        for piece in pieces:
            try:
                self.socket.sendall(piece)
            except (BrokenPipeError, ConnectionResetError):
                return
            time.sleep(pause)

    def receive(self):
        data = self.socket.recv(1 << 16)
        if not data:
            raise ConnectionError("the server closed the connection")
        return data

    def take(self, count):
        while len(self.buffer) < count:
            self.buffer += self.receive()
        taken, self.buffer = self.buffer[:count], self.buffer[count:]
        return taken

    def read_frame(self):
        """(opcode, payload) of the server's next frame, which must be a right one."""
        first, second = self.take(2)
        assert first & 0xF0 == 0x80 and second < 0x80, "a server masks nothing (5.1), uses no extension (5.2), sends in one frame"
        opcode, length = first & 0x0F, second
        if second > 125:
            length = int.from_bytes(self.take({126: 2, 127: 8}[second]), "big")
            assert length > {126: 125, 127: 65535}[second] and opcode < CLOSE, "in as few bytes as possible (5.2), controls have 125 (5.5)"
        return opcode, self.take(length)

    def read_until(self, last):
        """What it says up to this event; None: until it ends. Nothing comes after a close frame (5.5.1)."""
        said = Said()
        self.socket.settimeout(SILENCE)
        try:
            while last is None or last not in said.events:
                opcode, payload = self.read_frame()
                assert not any(what == "close" for what, _ in said.events), "it speaks after its close frame"
                said.events.append(event_of(opcode, payload))
        except TimeoutError:
            pass
        except ConnectionError:
            said.ended = True
        return said


def event_of(opcode, payload):
    if opcode == CLOSE:
        assert len(payload) != 1, payload
        return "close", int.from_bytes(payload[:2], "big") if payload else None
    if opcode == TEXT:
        message = json.loads(payload)
        return "message", message.get("channel", message.get("type"))
    return {BINARY: "binary", PING: "ping", PONG: "pong"}[opcode], payload


def request_text(method, path, headers, port, version="HTTP/1.1"):
    lines = [f"{method} {path} {version}".rstrip(), *(f"{name}: {value}" for name, value in headers)]
    return ("\r\n".join(lines) + "\r\n\r\n").replace("PORT", str(port)).encode()


def head_of(head):
    first, *lines = head.decode("latin-1").split("\r\n")
    return int(first.split()[1]), {name.lower(): value for name, value in (line.split(": ", 1) for line in lines)}

