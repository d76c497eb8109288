"""The Python client library of api/python, plain and asyncio, behind one face: a conversation is written once and held with both."""
import asyncio
import inspect
import sys
import threading

from client import PROJECT, TIMEOUT

LIBRARY = PROJECT / "api" / "python"
sys.path.insert(0, str(LIBRARY))

import race_client  # noqa: E402  (its folder is known only now)

LOOP = asyncio.new_event_loop()
threading.Thread(target=LOOP.run_forever, daemon=True).start()


class Blocking:
    """An object of the asyncio client, whose methods wait for their results; what they do happens in a loop that goes on meanwhile."""

    def __init__(self, inner):
        self._inner = inner

    def __getattr__(self, name):
        value = getattr(self._inner, name)
        return (lambda *arguments, **named: self._call(value, *arguments, **named)) if inspect.isroutine(value) else blocking(value)

    def __enter__(self):
        self._call(self._inner.__aenter__)
        return self

    def __exit__(self, *error):
        self._call(self._inner.__aexit__, *error)

    def __iter__(self):
        return self

    def __next__(self):
        try:
            return self._call(self._inner.__anext__)
        except StopAsyncIteration:
            raise StopIteration from None

    @staticmethod
    def _call(function, *arguments, **named):
        async def call():
            result = function(*arguments, **named)
            return await result if inspect.isawaitable(result) else result

        return blocking(asyncio.run_coroutine_threadsafe(call(), LOOP).result(6 * TIMEOUT))


def blocking(value):
    """What is of the asyncio client, or comes one by one, as Blocking; all else as it is."""
    is_ours = type(value).__module__.startswith("race_client.aio")
    return Blocking(value) if is_ours or inspect.isasyncgen(value) else value


# How each client is made: arguments as of race_client.Client.
KINDS = {"plain": race_client.Client, "asyncio": lambda *address, **how: Blocking(race_client.AsyncClient(*address, **how))}
