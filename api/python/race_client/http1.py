"""HTTP/1.1 of one connection, without its socket: h11 has the protocol, and this the server's kind of request and answer."""
from typing import Any

import h11

from .address import Address
from .call import Answer, Call
from .errors import PROTOCOL, failure

MAX_ANSWER = 64 * 1024 * 1024  # bytes; the server's largest answers have 16 MiB


class Exchange:
    """Requests over one connection, one after the other."""

    def __init__(self, address: Address) -> None:
        self._host = address.authority
        self._h11 = h11.Connection(h11.CLIENT)
        self._head: h11.Response | None = None
        self._body = bytearray()

    def begin(self, call: Call[Any], token: str | None) -> bytes:
        """The bytes of a request. ValueError: a header has characters that no header has."""
        content = call.content()
        headers = {"Host": self._host, **{name: value for name, value in call.headers.items() if value is not None}}
        if token is not None:
            headers["Authorization"] = f"Bearer {token}"
        if content is not None:
            headers["Content-Type"] = "application/json"
        if call.method != "GET":
            headers["Content-Length"] = str(len(content or b""))
        self._head, self._body = None, bytearray()
        try:
            parts = [self._h11.send(h11.Request(method=call.method, target=call.target, headers=list(headers.items())))]
        except h11.LocalProtocolError as error:
            raise ValueError(f"{call.method} {call.path}: {error}") from None
        if content:
            parts.append(self._h11.send(h11.Data(data=content)))
        parts.append(self._h11.send(h11.EndOfMessage()))
        return b"".join(part for part in parts if part)

    def received(self, data: bytes) -> Answer | None:
        """The answer, once all of it has come. ConnectionError: the connection ended before; RaceError: it is no HTTP or too large."""
        if not data:
            raise ConnectionResetError("the server has closed the connection")
        try:
            self._h11.receive_data(data)
            return self._answer()
        except h11.RemoteProtocolError as error:
            raise failure(PROTOCOL, f"{self._host} does not speak HTTP as a server of RACE does: {error}") from None

    def _answer(self) -> Answer | None:
        while True:
            event = self._h11.next_event()
            if isinstance(event, h11.Response):
                self._head = event
            elif isinstance(event, h11.Data):
                self._body += event.data
                if len(self._body) > MAX_ANSWER:
                    raise failure(PROTOCOL, f"the answer has more than {MAX_ANSWER} bytes")
            elif isinstance(event, h11.EndOfMessage) and self._head is not None:
                headers = {name.decode("latin-1").lower(): value.decode("latin-1") for name, value in self._head.headers}
                return Answer(self._head.status_code, headers, bytes(self._body))
            elif event is h11.NEED_DATA or event is h11.PAUSED:
                return None

    def is_reusable(self) -> bool:
        """Whether another request may follow the answer; if so, the connection is made ready for it."""
        if self._h11.our_state is h11.DONE and self._h11.their_state is h11.DONE:
            self._h11.start_next_cycle()
            return True
        return False
