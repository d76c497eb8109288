"""What documents, cores, runs and services need of the asyncio client."""
from collections.abc import AsyncIterator, Awaitable, Callable
from typing import Protocol, TypeVar

from ..call import Call
from ..errors import RaceError
from ..messages import Derivations, TraceStep
from .following import AsyncFollowing

Answered = TypeVar("Answered")
PAGE = 100  # macro steps of an answer with derivations, at most (openapi.yaml)


class AsyncSender(Protocol):
    """The client that they belong to."""

    async def send(self, call: Call[Answered], *, timeout: float | None = None) -> Answered:
        """As AsyncClient.send."""
        ...

    def follow(self, core: str, *, quiet: float | None = None, patience: float = 60.0, capacity: int = 1000,
               within: float | None = None) -> AsyncFollowing:
        """As AsyncClient.follow."""
        ...


async def send_twice(client: AsyncSender, call: Call[Answered]) -> Answered:
    """A request with a key or token of its own, by which the server does it once: if its answer does not come, it is sent again."""
    try:
        return await client.send(call)
    except RaceError as error:
        if not error.may_be_done:
            raise
    try:
        return await client.send(call)
    except RaceError as error:
        error.may_be_done = error.may_be_done or error.status == 0  # by the first time
        raise


async def derivation_pages(page: Callable[[int, int], Awaitable[Derivations]], first: int, last: int) -> AsyncIterator[TraceStep]:
    """Macro steps `first` to `last`."""
    while first <= last:
        steps = (await page(first, min(last, first + PAGE - 1)))["steps"]
        for step in steps:
            yield step
        if not steps:
            return
        first = steps[-1]["step"] + 1
