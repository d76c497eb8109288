"""The WebSocket protocol of one connection, without its socket: that of python3-websockets, which is the same for both clients."""
from typing import Any

import websockets.client
from websockets.exceptions import WebSocketException
from websockets.frames import Close, Opcode
from websockets.http11 import Response
from websockets.uri import parse_uri

from .address import Address
from .errors import CONNECTION, PROTOCOL, failure, refusal

MAX_MESSAGE = 64 * 1024 * 1024  # bytes of text; the snapshot of a large model has some MiB
# Since websockets 11 it is called ClientProtocol.
PROTOCOL_TYPE: Any = getattr(websockets.client, "ClientProtocol", None) or websockets.client.ClientConnection


class WebSocketProtocol:
    """Handshake, then texts. What it has to say is in `output()`, after each other call."""

    def __init__(self, address: Address, path: str, token: str | None) -> None:
        scheme = "wss" if address.tls else "ws"
        self._where = str(address)
        self._protocol = PROTOCOL_TYPE(parse_uri(f"{scheme}://{address.authority}{path}"), max_size=MAX_MESSAGE)
        self._text = b""
        self.is_open = False
        request = self._protocol.connect()
        if token is not None:
            request.headers["Authorization"] = f"Bearer {token}"
        self._protocol.send_request(request)

    def output(self) -> bytes:
        """What is to be sent now; pings were answered, too."""
        return b"".join(self._protocol.data_to_send())

    def send(self, text: str) -> None:
        """Says a text message."""
        self._protocol.send_text(text.encode())

    def ping(self) -> None:
        """Asks whether the server is there: something comes back soon."""
        self._protocol.send_ping(b"")

    def close(self) -> None:
        """Says that no more follows, if the connection is open."""
        if self._protocol.state.name == "OPEN":
            self._protocol.send_close(1000)

    def received(self, data: bytes) -> list[str]:
        """The text messages that are complete with these bytes (none: the connection has ended).

        RaceError: the server refuses the connection (with its status), ends it, or breaks the protocol.
        """
        try:
            if data:
                self._protocol.receive_data(data)
            else:
                self._protocol.receive_eof()
        except (ValueError, LookupError, NotImplementedError, EOFError, WebSocketException) as error:
            raise failure(PROTOCOL if data else CONNECTION, f"{self._where} opens no WebSocket: {error}") from None
        texts = [text for event in self._protocol.events_received() if (text := self._text_of(event)) is not None]
        broken = self._protocol.parser_exc
        if broken is not None and not isinstance(broken, (EOFError, WebSocketException)):
            raise failure(PROTOCOL, f"{self._where} breaks the protocol of WebSockets: {broken}")
        if not data or (broken is not None and not texts):
            raise failure(CONNECTION, f"{self._where} has closed the connection")
        return texts

    def _text_of(self, event: Any) -> str | None:
        """The message that ends with a frame."""
        if isinstance(event, Response):
            if event.status_code != 101:
                raise refusal(event.status_code, event.body or b"")
            if self._protocol.handshake_exc is not None:
                raise failure(PROTOCOL, f"{self._where} opens no WebSocket: {self._protocol.handshake_exc}")
            self.is_open = True
            return None
        if event.opcode is Opcode.CLOSE:
            close = Close.parse(event.data)
            raise failure(CONNECTION, f"{self._where} has closed the connection: {close.code} {close.reason}".rstrip())
        if event.opcode is Opcode.TEXT or event.opcode is Opcode.CONT:
            self._text += event.data
            if event.fin:
                text, self._text = self._text.decode(), b""
                return text
        return None
