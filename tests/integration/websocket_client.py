"""A blocking WebSocket client: the protocol is that of python3-websockets (its part without I/O), the socket is ours.

It reads from the socket only when the test asks for a message, so a test can be a client that does not read.
"""
import contextlib
import json
import socket

from websockets.client import ClientConnection
from websockets.connection import OPEN
from websockets.frames import OP_CLOSE, OP_CONT, OP_TEXT
from websockets.uri import parse_uri


class WebSocketClient:
    """One connection. `status` is the HTTP status of the handshake: 101, or why the server refuses the connection."""

    def __init__(self, port, path, timeout, origin=None, token=None):
        self.protocol = ClientConnection(parse_uri(f"ws://127.0.0.1:{port}{path}"), origin=origin, max_size=None)
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=timeout)
        self.events = []
        request = self.protocol.connect()
        if token is not None:
            request.headers["Authorization"] = f"Bearer {token}"
        self.protocol.send_request(request)
        self.flush()
        self.status = self.event().status_code

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Closes the socket without a closing handshake, as a client that crashes or loses its network."""
        self.socket.close()

    def flush(self):
        for data in self.protocol.data_to_send():
            if data:  # nothing stands for the end of what is sent: the socket stays open until close()
                self.socket.sendall(data)

    def event(self):
        """The response to the handshake, then frames. Pings are answered by the library."""
        while not self.events:
            data = self.socket.recv(65536)
            if not data:
                raise ConnectionError("the server closed the connection")
            self.protocol.receive_data(data)
            self.events = self.protocol.events_received()
            with contextlib.suppress(ConnectionError):  # the server may have sent its last words and be closed
                self.flush()
            if self.protocol.parser_exc and not self.events:
                raise ConnectionError("the server broke the protocol") from self.protocol.parser_exc
        return self.events.pop(0)

    def send(self, message):
        """Sends a text message: a string as it is, else as JSON."""
        if self.protocol.state is not OPEN:
            raise ConnectionError("the connection is closed")
        self.protocol.send_text((message if isinstance(message, str) else json.dumps(message)).encode())
        self.flush()

    def receive(self):
        """The next message, parsed as JSON; its frames are joined."""
        text = b""
        while True:
            frame = self.event()
            if frame.opcode is OP_CLOSE:
                raise ConnectionError(f"closed: {frame.data!r}")
            if frame.opcode in (OP_TEXT, OP_CONT):
                text += frame.data
                if frame.fin:
                    return json.loads(text)
