"""Sockets, tasks and waiting of the asyncio client; plain/net.py has the same for the plain client. Failures are OSError."""
import asyncio
from collections.abc import Callable, Coroutine
from typing import Any

from ..address import Address

POLL = 5.0  # seconds after which a reader looks whether it shall end; a task is ended at once all the same
PIECE = 65536  # bytes


class Connection:
    """A TCP connection, with TLS if the address says so."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._reader, self._writer = reader, writer

    @classmethod
    async def open(cls, address: Address, timeout: float) -> "Connection":
        async with asyncio.timeout(timeout):
            return cls(*await asyncio.open_connection(address.host, address.port, ssl=address.tls))

    async def send(self, data: bytes, timeout: float) -> None:
        async with asyncio.timeout(timeout):
            self._writer.write(data)
            await self._writer.drain()

    async def receive(self, timeout: float) -> bytes:
        """What has come; nothing: the connection has ended."""
        async with asyncio.timeout(timeout):
            return await self._reader.read(PIECE)

    def is_stale(self) -> bool:
        """Whether nothing can be asked over it: it has ended meanwhile."""
        return self._reader.at_eof() or self._reader.exception() is not None or self._writer.is_closing()

    def close(self) -> None:
        self._writer.transport.abort()


class Signal:
    """Wakes one who waits."""

    def __init__(self) -> None:
        self._event = asyncio.Event()

    def set(self) -> None:
        self._event.set()

    def clear(self) -> None:
        self._event.clear()

    async def wait(self, timeout: float | None) -> None:
        """TimeoutError: nobody has woken it in time."""
        async with asyncio.timeout(timeout):
            await self._event.wait()


class Background:
    """Something that goes on beside the caller until it ends by itself or is ended."""

    def __init__(self, run: Callable[[], Coroutine[Any, Any, None]]) -> None:
        self._task = asyncio.create_task(run())

    async def end(self) -> None:
        self._task.cancel()
        await asyncio.wait([self._task])


async def pause(seconds: float) -> None:
    """Lets some time go by."""
    await asyncio.sleep(seconds)
