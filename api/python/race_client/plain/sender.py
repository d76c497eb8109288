# Made from ../aio/sender.py by generate/main.py.
"""What documents, cores, runs and services need of the plain client."""
from collections.abc import Iterator, Callable
from typing import Protocol, TypeVar

from ..call import Call
from ..errors import RaceError
from ..messages import Derivations, TraceStep
from .following import Following

Answered = TypeVar("Answered")
PAGE = 100  # macro steps of an answer with derivations, at most (openapi.yaml)


class Sender(Protocol):
    """The client that they belong to."""

    def send(self, call: Call[Answered], *, timeout: float | None = None) -> Answered:
        """As Client.send."""
        ...

    def follow(self, core: str, *, quiet: float | None = None, patience: float = 60.0, capacity: int = 1000,
               within: float | None = None) -> Following:
        """As Client.follow."""
        ...


def send_twice(client: Sender, call: Call[Answered]) -> Answered:
    """A request with a key or token of its own, by which the server does it once: if its answer does not come, it is sent again."""
    try:
        return client.send(call)
    except RaceError as error:
        if not error.may_be_done:
            raise
    try:
        return client.send(call)
    except RaceError as error:
        error.may_be_done = error.may_be_done or error.status == 0  # by the first time
        raise


def derivation_pages(page: Callable[[int, int], Derivations], first: int, last: int) -> Iterator[TraceStep]:
    """Macro steps `first` to `last`."""
    while first <= last:
        steps = page(first, min(last, first + PAGE - 1))["steps"]
        yield from steps
        if not steps:
            return
        first = steps[-1]["step"] + 1
