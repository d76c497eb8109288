# Made from ../aio/http.py by generate/main.py.
"""Requests of the plain client, over connections that are kept for the next ones."""
from collections import deque
from typing import Any

from ..address import Address
from ..call import Answer, Call
from ..deadline import Deadline
from ..errors import socket_errors
from ..http1 import Exchange
from .net import Connection

KEPT = 4  # connections that wait for the next request, at most


class Http:
    """The server's answers to calls. Several may be asked at the same time."""

    def __init__(self, address: Address) -> None:
        self._address = address
        self._kept: deque[tuple[Connection, Exchange]] = deque()

    def ask(self, call: Call[Any], token: str | None, timeout: float, *, is_new: bool = False) -> Answer:
        """The answer within `timeout` seconds. `is_new`: over a connection that was not used before. RaceError: there is none."""
        deadline = Deadline(timeout)
        with socket_errors(str(self._address)):
            kept = None if is_new else self._take_kept()
            if kept is not None:
                try:
                    return self._exchange(*kept, call, token, deadline)
                except ConnectionError:
                    if call.method != "GET":
                        raise  # it may have been done
            with socket_errors(str(self._address), is_sent=False):
                connection = Connection.open(self._address, deadline.left())
            return self._exchange(connection, Exchange(self._address), call, token, deadline)

    def close(self) -> None:
        """Closes what is kept."""
        while self._kept:
            self._kept.pop()[0].close()

    def _take_kept(self) -> tuple[Connection, Exchange] | None:
        while True:
            try:
                kept = self._kept.pop()
            except IndexError:
                return None
            if not kept[0].is_stale():
                return kept
            kept[0].close()

    def _exchange(self, connection: Connection, exchange: Exchange, call: Call[Any], token: str | None,
                        deadline: Deadline) -> Answer:
        try:
            connection.send(exchange.begin(call, token), deadline.left())
            answer = None
            while answer is None:
                answer = exchange.received(connection.receive(deadline.left()))
        except BaseException:
            connection.close()
            raise
        if len(self._kept) < KEPT and exchange.is_reusable():
            self._kept.append((connection, exchange))
        else:
            connection.close()
        return answer
