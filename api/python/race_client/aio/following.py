"""A core that is followed over the stream by the asyncio client."""
import time
from types import TracebackType

from ..address import Address
from ..calls import STREAM_PATH
from ..deadline import Deadline
from ..errors import CONNECTION, TIMEOUT, RaceError, failure, socket_errors
from ..updates import CAPACITY, CoreUpdates, Update
from .net import POLL, Background, Signal, pause
from .websocket import AsyncWebSocket

FIRST_DELAY, LAST_DELAY = 0.1, 2.0  # seconds between attempts to connect again; each is twice as long as the one before


class AsyncFollowing:
    """The updates of a core (`cores.follow`), as a context manager and iterator: a snapshot, then deltas, until its run is over.

    It reads beside its user, answers pings and folds deltas, so a slow user does not lose the connection: beyond `capacity` updates
    that wait, one snapshot takes the place of all (`Update.merged`). A connection that is lost is made again, for `patience` seconds,
    and what was missed comes then, or a new snapshot; the updates `disconnected` and `connected` say so. After that, and for what no
    attempt will change (rights, no such core), the iterator raises RaceError, behind all updates that came before. Entering it waits for
    the first snapshot, so that what is done then is heard; it raises RaceError if there is no server, or no such core, or if it takes more
    than `within` seconds.
    """

    def __init__(self, address: Address, token: str | None, core: str, *, timeout: float, quiet: float | None = None,
                 patience: float = 60.0, capacity: int = CAPACITY, within: float | None = None) -> None:
        self._address, self._token = address, token
        self._timeout, self._quiet, self._patience = timeout, quiet, patience
        self._within = 3 * timeout if within is None else within
        self._updates = CoreUpdates(core, capacity)
        self._core = core
        self._signal = Signal()
        self._socket: AsyncWebSocket | None = None
        self._background: Background | None = None
        self._is_closing = False

    async def __aenter__(self) -> "AsyncFollowing":
        deadline = Deadline(self._within)
        self._socket = await self._open(min(self._timeout, self._within))
        self._background = Background(self._run)
        try:
            await self._wait_for_first(deadline)
        except BaseException:
            await self.close()
            raise
        return self

    async def __aexit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        await self.close()

    def __aiter__(self) -> "AsyncFollowing":
        return self

    async def __anext__(self) -> Update:
        update = await self.next(self._quiet)
        if update is None:
            raise StopAsyncIteration
        return update

    async def next(self, timeout: float | None = None) -> Update | None:
        """The next update; None: the run is over, and its last update was read.

        RaceError `timeout`: none comes within `timeout` seconds; another one: the connection or channel ended for good.
        """
        deadline = None if timeout is None else Deadline(timeout)
        while True:
            self._signal.clear()
            is_over = self._updates.is_over
            update = self._updates.pop()
            if update is not None or is_over:
                return update
            try:
                await self._signal.wait(None if deadline is None else deadline.left())
            except TimeoutError:
                raise failure(TIMEOUT, f"core {self._core}: no update within {timeout} s") from None

    async def close(self) -> None:
        """Ends it, also within an iteration."""
        self._is_closing = True
        if self._background is not None:
            await self._background.end()
        if self._socket is not None:
            self._socket.close()

    async def _wait_for_first(self, deadline: Deadline) -> None:
        """Until the first snapshot is there, so that nothing is missed of what its user does then; or raises why it does not come."""
        while True:
            self._signal.clear()
            if self._updates.has_state:
                return
            self._updates.raise_failure()
            with socket_errors(str(self._address)):
                await self._signal.wait(deadline.left())

    async def _open(self, timeout: float) -> AsyncWebSocket:
        return await AsyncWebSocket.open(self._address, STREAM_PATH, self._token, timeout)

    async def _run(self) -> None:
        """Reads until the run is over; whatever ends it before reaches the reader of the updates."""
        try:
            while self._socket is not None:
                try:
                    await self._read(self._socket)
                except RaceError as error:
                    if not passes(error) or not self._updates.has_state:
                        raise
                    self._updates.lost(error.message)
                    self._signal.set()
                finally:
                    self._socket.close()
                self._socket = None if self._is_done() else await self._open_again()
        except Exception as error:
            self._updates.fail(error)
        finally:
            self._signal.set()

    async def _read(self, socket: AsyncWebSocket) -> None:
        await socket.send(self._updates.opened())
        self._signal.set()
        owed = time.monotonic() + self._timeout
        while not self._is_done():
            if not self._updates.needs_snapshot:
                owed = time.monotonic() + self._timeout
            elif time.monotonic() > owed:
                raise failure(TIMEOUT, f"core {self._core}: {self._address} sends no snapshot")
            for text in await socket.receive(min(POLL, self._timeout)):
                answer = self._updates.received(text)
                if answer is not None:
                    await socket.send(answer)
                self._signal.set()

    async def _open_again(self) -> AsyncWebSocket | None:
        end, delay = time.monotonic() + self._patience, FIRST_DELAY
        while not self._is_closing:
            await pause(delay)
            try:
                return await self._open(self._timeout)
            except RaceError as error:
                if not passes(error) or time.monotonic() > end:
                    raise
            delay = min(2 * delay, LAST_DELAY)
        return None

    def _is_done(self) -> bool:
        return self._is_closing or self._updates.is_over


def passes(error: RaceError) -> bool:
    """Whether another connection may do better."""
    return error.code in (CONNECTION, TIMEOUT, "unavailable")
