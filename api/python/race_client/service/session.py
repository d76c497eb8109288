"""The connection of services to the server: what is said on it, and that it is made again when it is lost."""
import asyncio
import json
import logging
import time
from collections.abc import Callable, Sequence

from ..address import Address
from ..aio.websocket import AsyncWebSocket
from ..errors import CONNECTION, PROTOCOL, TIMEOUT, RaceError, failure
from ..messages import Json
from .hosted import Hosted

LOG = logging.getLogger("race_client.service")
PATH = "/api/v1/components"
PROTOCOL_NUMBER = 1
OPEN_TIMEOUT = 5.0  # seconds, also for the server to welcome
RETRIES = (0.1, 0.2, 0.5, 1.0)  # seconds between attempts to connect; the last again and again
MAX_OUT = 10_000  # messages that the server has not taken
TAKEN_TIME = 10.0  # seconds for a process that was there before to be missed


async def keep_connected(hosted: Sequence[Hosted], address: Address, token: Callable[[], str | None]) -> None:
    """Offers services at a server, for ever. One that has been welcome connects again, whatever ended the connection. RaceError: the server
    refuses them; OSError, ValueError: there is no token."""
    attempts = 0
    taken_since: float | None = None
    while True:
        session: Session | None = None
        began = time.monotonic()
        try:
            session = Session(await AsyncWebSocket.open(address, PATH, token(), OPEN_TIMEOUT), hosted)
            await session.run()
        except RaceError as error:
            was_welcome = session is not None and session.is_welcome
            if was_welcome:
                attempts = 0 if time.monotonic() > began + RETRIES[-1] else attempts
                taken_since = None
            is_taken = not was_welcome and any(each["message"].endswith("has a process already") for each in error.errors)
            if is_taken:
                taken_since = taken_since or time.monotonic()
            if not was_welcome and not passes(error) and not (is_taken and taken_since and time.monotonic() < taken_since + TAKEN_TIME):
                raise
            if was_welcome or attempts == 0:
                LOG.warning("%s: %s", ", ".join(each.declaration.key for each in hosted), error.message)
        await asyncio.sleep(RETRIES[min(attempts, len(RETRIES) - 1)])
        attempts += 1


def passes(error: RaceError) -> bool:
    """Whether it may be otherwise soon: there is no server, or it has much to do."""
    return error.code in (CONNECTION, TIMEOUT) or error.status == 503


class Session:
    """One connection."""

    def __init__(self, socket: AsyncWebSocket, hosted: Sequence[Hosted]) -> None:
        self._socket = socket
        self._hosted = {each.declaration.key: each for each in hosted}
        self._out: asyncio.Queue[str] = asyncio.Queue()
        self._heartbeat = OPEN_TIMEOUT
        self._heard, self._is_halted = time.monotonic(), False
        self.is_welcome = False

    async def run(self) -> None:
        """Until the connection ends. RaceError: always; it was lost, or the server has refused the services."""
        components = [each.component() for each in self._hosted.values()]
        self.say({"type": "hello", "protocol": PROTOCOL_NUMBER, "components": components, "violations": True})
        writer = asyncio.create_task(self._write())
        try:
            while True:
                for text in await self._socket.receive(self._heartbeat / 2):
                    await self._received(text)
                await self._notice_silence()
        finally:
            writer.cancel()
            self._socket.close()
            await asyncio.gather(*(each.lost() for each in self._hosted.values()))

    def say(self, message: dict[str, Json]) -> None:
        """Sends it soon, in order. What a server does not take ends the connection."""
        if self._out.qsize() >= MAX_OUT:
            self._socket.close()
            return
        self._out.put_nowait(json.dumps(message))

    async def _write(self) -> None:
        try:
            while True:
                await self._socket.send(await self._out.get())
        except RaceError:
            self._socket.close()  # who reads learns it

    async def _received(self, text: str) -> None:
        try:
            message = json.loads(text)
            kind = message["type"]
        except (ValueError, KeyError, TypeError):
            raise failure(PROTOCOL, f"this is no message of the server: {text[:200]}") from None
        self._heard, self._is_halted = time.monotonic(), False
        if kind == "ping":
            self.say({"type": "pong", "number": message["number"]})
        elif kind == "refused":
            raise RaceError(0, message["errors"])
        elif kind == "welcome":
            self._heartbeat = message.get("heartbeat", 1000) / 1000
            self.is_welcome = True
            for each in self._hosted.values():
                each.connected(self.say)
                LOG.info("%s: connected", each.declaration.key)
        elif message.get("key") in self._hosted:
            self._hosted[message["key"]].received(message)

    async def _notice_silence(self) -> None:
        silent = time.monotonic() - self._heard
        if not self.is_welcome and silent > OPEN_TIMEOUT:
            raise failure(TIMEOUT, "the server does not welcome the services")
        if self.is_welcome and silent > self._heartbeat and not self._is_halted:
            self._is_halted = True
            LOG.warning("the server is silent: services halt")
            await asyncio.gather(*(each.silent() for each in self._hosted.values()))
