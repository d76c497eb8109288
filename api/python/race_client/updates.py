"""What a client that follows a core has heard of it, without sockets: numbers, gaps, folding, and a bounded queue for its reader."""
import json
import threading
from collections import deque
from dataclasses import dataclass
from typing import Literal, cast

from .errors import PROTOCOL, RaceError, failure
from .fold import fold, is_over
from .messages import CoreDelta, CoreState, SubscribeRequest

CAPACITY = 1000  # updates that wait for a slow reader
FOLDED = {"active", "ports", "activated", "parameters", "results", "variables"}  # of a state (state.json)


@dataclass(frozen=True)
class Update:
    """What has happened to a core that is followed.

    `kind`: `snapshot`: `state` is whole and new; `delta`: `delta` led to `state`; `disconnected`: the connection is lost, for `reason`,
    and is being made again: `state` is the last that is known; `connected`: it is there again, and a snapshot or deltas follow.
    `state`: core and values as they are after it (core_state.json), the same for who has read all updates as for who comes late.
    `merged`: of a snapshot, how many updates were put together in it, as they came faster than they were read.
    """

    kind: Literal["snapshot", "delta", "disconnected", "connected"]
    state: CoreState
    delta: CoreDelta | None = None
    merged: int = 0
    reason: str = ""


class CoreUpdates:
    """The channel core/{id}/state. One side tells it what comes from the server, the other takes updates; from any thread."""

    def __init__(self, core: str, capacity: int = CAPACITY) -> None:
        self._channel = f"core/{core}/state"
        self._capacity = capacity
        self._lock = threading.Lock()
        self._queue: deque[Update] = deque()
        self._state: CoreState | None = None
        self._last: int | None = None  # number of the last message
        self._is_lost = False
        self._has_gap = False  # deltas mean nothing until the snapshot comes that was asked for
        self._failure: Exception | None = None

    @property
    def is_over(self) -> bool:
        """Whether no more can come: the run is over, or following it has failed."""
        with self._lock:
            return self._failure is not None or (self._state is not None and is_over(self._state["core"]["status"]))

    @property
    def has_state(self) -> bool:
        """Whether a snapshot has ever come."""
        with self._lock:
            return self._state is not None

    @property
    def needs_snapshot(self) -> bool:
        """Whether the server owes a snapshot: nothing else it sends means anything."""
        with self._lock:
            return self._last is None

    def opened(self) -> str:
        """There is a connection: what to say on it first, to get all that was missed, or a new snapshot."""
        with self._lock:
            if self._is_lost and self._state is not None:
                self._put(Update("connected", self._state))
            self._is_lost = self._has_gap = False
            return self._subscription(self._last)

    def lost(self, reason: str) -> None:
        """The connection has ended."""
        with self._lock:
            self._is_lost = True
            if self._state is not None:
                self._put(Update("disconnected", self._state, reason=reason))

    def fail(self, error: Exception) -> None:
        """Nothing more can be heard, for this error; the reader gets it behind all updates."""
        with self._lock:
            self._failure = self._failure or error

    def received(self, text: str) -> str | None:
        """A message of the server; what to say to it: nothing, or, after a gap, that a new snapshot is needed.

        RaceError: the channel has ended, or this is no message.
        """
        try:
            message = json.loads(text)
            channel, kind, number, data = message["channel"], message["kind"], message["sequence"], message["data"]
            with self._lock:
                if kind == "error" and channel in ("", self._channel):
                    raise RaceError(0, data["errors"], data.get("more_errors") is True)
                if channel != self._channel:
                    return None
                return self._take(kind, number, data)
        except (ValueError, KeyError, TypeError, AttributeError):
            raise failure(PROTOCOL, f"this is no message of the stream: {text[:200]}") from None

    def pop(self) -> Update | None:
        """The next update; None: there is none now. Raises the error of `fail` when all updates before it were read."""
        with self._lock:
            if self._queue:
                return self._queue.popleft()
        self.raise_failure()
        return None

    def raise_failure(self) -> None:
        """Raises the error of `fail`, if there is one."""
        if self._failure is not None:
            raise self._failure

    def _take(self, kind: str, number: int, data: object) -> str | None:
        if kind == "snapshot":
            self._has_gap = False
            self._state = snapshot(data)
            self._put(Update("snapshot", self._state))
        elif kind == "delta" and not self._has_gap:
            if self._state is None or self._last is None or number != self._last + 1:
                self._has_gap, self._last = True, None
                return self._subscription(None)
            delta = cast(CoreDelta, data)
            self._state = fold(self._state, delta)
            self._put(Update("delta", self._state, delta))
        else:
            return None
        self._last = number
        return None

    def _put(self, update: Update) -> None:
        """Behind the others; if there are too many, one snapshot takes the place of all, behind the last news of the connection."""
        self._queue.append(update)
        if len(self._queue) <= self._capacity:
            return
        news = [each for each in self._queue if each.kind in ("disconnected", "connected")][-2:]
        merged = sum(each.merged or 1 for each in self._queue if each.kind in ("snapshot", "delta"))
        self._queue = deque([*news, Update("snapshot", update.state, merged=merged)])

    def _subscription(self, since: int | None) -> str:
        request: SubscribeRequest = {"type": "subscribe", "channel": self._channel}
        if since is not None:
            request["since"] = since
        return json.dumps(request)


def snapshot(data: object) -> CoreState:
    """The data of a snapshot, held against the fields that folding needs."""
    state = cast(CoreState, data)
    if "status" not in state["core"] or FOLDED - state["state"].keys():
        raise KeyError("status")
    return state
