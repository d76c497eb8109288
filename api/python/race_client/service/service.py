"""The base class of services, and what their methods raise."""
import asyncio
import contextvars
import threading
import time
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from ..messages import Json

if TYPE_CHECKING:
    from .hosted import Hosted


class ServiceFailure(Exception):
    """Raised by a method: the error that answers its call. `code` is what tasks branch on; `more`: further fields."""

    def __init__(self, code: str, message: str = "", **more: Json) -> None:
        super().__init__(message or code)
        self.error: dict[str, Json] = {"code": code, **({"message": message} if message else {}), **more}


class Stopped(Exception):
    """Raised by `pause` in a method whose call is over: another operation has stopped it, or the server is lost. End what moves."""


class RunningCall:
    """A call while its method is at work; of any thread."""

    def __init__(self, number: int, operation: str, transition: Mapping[str, Json]) -> None:
        self.number, self.operation, self.transition = number, operation, transition
        self.ended = threading.Event()  # nobody waits for its answer any more
        self.task: asyncio.Task[None] | None = None


CURRENT: contextvars.ContextVar[RunningCall | None] = contextvars.ContextVar("race_call", default=None)


class Service:
    """A service: subclasses set `key`, and have methods that are operations (`operation`). Each begins anew in its first state when the
    server is connected: what they keep is theirs.

    A plain method runs on a thread of its own, one with `async` in the loop of asyncio; meanwhile other calls come, as the RSM allows.
    """

    key: ClassVar[str] = ""  # as in svc.KEY
    type: ClassVar[str] = ""  # what kind of service it is; its key, if it says nothing
    version: ClassVar[str | None] = None  # for people: the RSM has it as `meta.version`
    events: ClassVar[Mapping[str, Json]] = {}  # name -> the type of its data (of RSM), or {"data": TYPE, "sampled": True, ...}
    rsm: ClassVar[Mapping[str, Json] | str | Path | None] = None  # an RSM, or a file of one beside this; None: made of the class

    speed_limit: float | None = None  # [m/s] what moves must not be faster, whatever was asked for; None: there is no limit
    _hosted: "Hosted | None" = None

    @property
    def state(self) -> str:
        """The present state of the RSM; empty: the service is not connected."""
        return self._hosted.state if self._hosted else ""

    def emit(self, event: str, data: Json = None) -> None:
        """Announces an event. From any thread; without a server, nobody hears of it."""
        if self._hosted:
            self._hosted.emit(event, data)

    def take(self, transition: str) -> None:
        """Takes a transition of the RSM that no call brings, by its id. From any thread. Those that answer calls are taken when their
        methods end."""
        if self._hosted:
            self._hosted.take_by_id(transition)

    def log(self, text: str) -> None:
        """A line for people in the log of the server. From any thread."""
        if self._hosted:
            self._hosted.announce_soon({"type": "log", "text": text[:300]})

    def pause(self, seconds: float) -> None:
        """Waits within a plain method. Stopped: its call is over."""
        call = CURRENT.get()
        if call is None:  # while it halts
            time.sleep(seconds)
        elif call.ended.wait(seconds):
            raise Stopped

    def halt(self) -> None:
        """The server is lost, or silent: nothing may move. A service that does not say what is to be done has its `safe` operations
        called. It is called further when the server is there again."""

    def run(self) -> None:
        """Offers this service until the process ends; reads the command line (race_client.service.run)."""
        from .command import run

        run(self)
