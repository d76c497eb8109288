"""A WebSocket of the asyncio client."""
import time

from ..address import Address
from ..deadline import Deadline
from ..errors import CONNECTION, failure, socket_errors
from ..websocket_protocol import WebSocketProtocol
from .net import Connection

SILENCE = 20.0  # seconds without a word of the server after which it is asked whether it is there, and after which it is not
SEND_TIMEOUT = 10.0  # seconds for the server to take a message


class AsyncWebSocket:
    """One connection. Whoever reads it answers its pings by that; a server that falls silent is lost after 40 s."""

    def __init__(self, address: Address, connection: Connection, protocol: WebSocketProtocol) -> None:
        self._where = str(address)
        self._connection, self._protocol = connection, protocol
        self._heard = time.monotonic()
        self._has_asked = False
        self._texts: list[str] = []

    @classmethod
    async def open(cls, address: Address, path: str, token: str | None, timeout: float) -> "AsyncWebSocket":
        """RaceError: there is no server, or it refuses (its status and codes)."""
        deadline = Deadline(timeout)
        with socket_errors(str(address), is_sent=False):
            protocol = WebSocketProtocol(address, path, token)
            opened = cls(address, await Connection.open(address, deadline.left()), protocol)
            try:
                while not protocol.is_open:
                    await opened._flush(deadline.left())
                    opened._texts += protocol.received(await opened._connection.receive(deadline.left()))
            except BaseException:
                opened._connection.close()
                raise
            return opened

    async def send(self, text: str) -> None:
        """Sends a text message. RaceError: the connection has ended."""
        with socket_errors(self._where):
            self._protocol.send(text)
            await self._flush(SEND_TIMEOUT)

    async def receive(self, timeout: float) -> list[str]:
        """Text messages that have come; none: nothing has within `timeout` seconds. RaceError: the connection has ended."""
        if self._texts:
            texts, self._texts = self._texts, []
            return texts
        with socket_errors(self._where):
            try:
                data = await self._connection.receive(timeout)
            except TimeoutError:
                await self._ask_whether_it_is_there()
                return []
            self._heard, self._has_asked = time.monotonic(), False
            texts = self._protocol.received(data)
            await self._flush(SEND_TIMEOUT)
            return texts

    def close(self) -> None:
        """Ends the connection, without a word."""
        self._connection.close()

    async def _ask_whether_it_is_there(self) -> None:
        silent = time.monotonic() - self._heard
        if silent > 2 * SILENCE:
            raise failure(CONNECTION, f"{self._where} is silent")
        if silent > SILENCE and not self._has_asked:
            self._has_asked = True
            self._protocol.ping()
            await self._flush(SEND_TIMEOUT)

    async def _flush(self, timeout: float) -> None:
        if data := self._protocol.output():
            await self._connection.send(data, timeout)
