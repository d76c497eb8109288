"""One service while it is offered: its calls, its state, and what it says. All on the loop of asyncio, but for what says otherwise."""
import asyncio
import contextvars
import inspect
import logging
import threading
import traceback
from collections.abc import Callable
from typing import Any

from ..messages import Json
from .arguments import check_arguments
from .declaration import Declaration
from .machine import Machine, Transition
from .service import CURRENT, RunningCall, Service, ServiceFailure, Stopped
from .values import check_value, checked_error

LOG = logging.getLogger("race_client.service")
MAX_CALLS = 100  # methods at work at once
HALT_TIME = 2.0  # seconds for what is called when the server is lost

Say = Callable[[dict[str, Json]], None]


class Hosted:
    """Joins a Service to whoever brings messages of the server. DeclarationError: its class is none."""

    def __init__(self, service: Service) -> None:
        self.declaration = Declaration(type(service))
        self._service = service
        self._operations = {each["name"]: each for each in self.declaration.rsm.get("operations", [])}
        self._machine = Machine(self.declaration.rsm)
        self._say: Say | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self._thread = 0  # of the loop
        self._calls: dict[int, RunningCall] = {}
        self._tasks: set[asyncio.Task[None]] = set()  # also of calls that are over
        service._hosted = self

    @property
    def state(self) -> str:
        return self._machine.state if self._say else ""

    def component(self) -> dict[str, Json]:
        """As a hello names it."""
        return {"key": self.declaration.key, "type": self.declaration.type, "rsm": self.declaration.rsm}

    def connected(self, say: Say) -> None:
        """The server is there, and knows it in its first state."""
        self._machine, self._say = Machine(self.declaration.rsm), say
        self._service.speed_limit = None  # the server says it if there is one
        self._loop, self._thread = asyncio.get_running_loop(), threading.get_ident()

    async def lost(self) -> None:
        """The server is there no more: nobody waits for anything."""
        if self._say is None:
            return
        self._say = None
        for call in list(self._calls.values()):
            self._end(call)
        await self._halt()

    async def silent(self) -> None:
        """Nothing was heard for too long: what is under way ends, and is answered. What is safe and not busy goes on: it ends a motion."""
        for call in list(self._calls.values()):
            if call.transition.get("defer") or not self._operations[call.operation].get("safe"):
                self._answer(call, None, {"code": "stopped", "message": "the server is silent"})
                self._end(call)
        await self._halt()

    def received(self, message: dict[str, Json]) -> None:
        """A message of the server for this service."""
        if message["type"] == "call":
            self._called(message)
        elif message["type"] == "limit_speed":
            self._service.speed_limit = message["tool_speed"]
        elif message["type"] == "violation":
            of_call = f" (call {message['call']})" if message["call"] else ""
            where = self.declaration.where_violated(message)
            LOG.error("%s: violation: %s: %s%s", where, message["rule"], message["message"], of_call)

    def announce(self, message: dict[str, Json]) -> None:
        """Says something, if the server is there."""
        if self._say:
            self._say({"key": self.declaration.key, **message})

    def announce_soon(self, message: dict[str, Json]) -> None:
        """The same from any thread, in order."""
        self._soon(lambda: self.announce(message))

    def emit(self, event: str, data: Json) -> None:
        """From any thread. ValueError, TypeError: the data is no JSON."""
        check_value(data)
        self.announce_soon({"type": "event", "name": event, "data": data})

    def take_by_id(self, name: str) -> None:
        """From any thread. KeyError: there is no such transition."""
        transition = self._machine.transition(name)
        self._soon(lambda: self._take(transition))

    def _soon(self, work: Callable[[], None]) -> None:
        """Within the loop at once, as what its methods return comes after it."""
        if self._loop is None or self._loop.is_closed():
            return
        if threading.get_ident() == self._thread:
            work()
        else:
            self._loop.call_soon_threadsafe(work)

    # ---- Calls.

    def _called(self, message: dict[str, Json]) -> None:
        number, name = message["call"], message["operation"]
        transition = {} if self._machine.is_interface else self._machine.accepting(name)
        if transition is None or name not in self._operations:
            self.announce({"type": "reject", "call": number})
            return
        call = RunningCall(number, name, transition)
        self._calls[number] = call
        if transition:
            self._take(transition, number)
        method = getattr(self._service, name)
        parameters = self._operations[name].get("parameters", [])
        wrong = check_arguments(method, parameters, message["args"], message["kwargs"])
        if wrong is None and len(self._tasks) >= MAX_CALLS:
            wrong = {"code": "too_many", "message": f"{MAX_CALLS} calls are at work"}
        if wrong is not None:
            self._answer(call, None, wrong)
            return
        call.task = asyncio.create_task(self._run(call, lambda: method(*message["args"], **message["kwargs"]), method))
        self._tasks.add(call.task)
        call.task.add_done_callback(self._tasks.discard)

    async def _run(self, call: RunningCall, work: Callable[[], Any], method: Callable[..., Any]) -> None:
        """Has the method do its work. One that was stopped and has not ended yet is waited for: it may still move something."""
        if call.transition.get("defer"):
            while not call.ended.is_set() and (ending := self._ending_tasks()):
                await asyncio.wait(ending)
        if call.ended.is_set():
            return
        CURRENT.set(call)
        value, error = await self._outcome(call, work, method)
        self._answer(call, value, error)

    def _ending_tasks(self) -> set[asyncio.Task[None]]:
        """Those whose calls are over."""
        working = {asyncio.current_task(), *(each.task for each in self._calls.values())}
        return {task for task in self._tasks if task not in working}

    async def _outcome(self, call: RunningCall, work: Callable[[], Any], method: Callable[..., Any]) -> tuple[Json, Json]:
        """(result, error) of a method."""
        try:
            value = await invoke(work, method)
            check_value(value)
            return value, None
        except ServiceFailure as failure:
            return None, checked_error(failure.error)
        except Stopped:
            return None, {"code": "stopped"}
        except Exception as failure:
            where = self.declaration.where(call.operation)
            LOG.error("%s: error: `%s` has failed\n%s", where, call.operation, traceback.format_exc().rstrip())
            return None, {"code": "failed", "message": f"{type(failure).__name__}: {failure}"[:500]}

    def _answer(self, call: RunningCall, value: Json, error: Json) -> None:
        """Answers a call that still waits, by the transition that is due."""
        if call.ended.is_set():
            return
        if call.transition.get("defer"):
            ending = self._machine.ending(call.transition, error["code"] if error else None)
            if ending is not None:
                self._take(ending, call.number if call.transition.get("concurrent") else 0, call)
            self._machine.drop(call.number)
        self._respond(call, value, error)

    def _take(self, transition: Transition, number: int = 0, own: RunningCall | None = None) -> None:
        """Takes a transition; what it answers, but for `own` and the call that takes it, whose work begins, ends."""
        self.announce({"type": "transition", "id": transition["id"], **({"call": number} if number else {})})
        resolved, superseded = self._machine.take(transition, number)
        for each in resolved:
            other = self._calls.get(each.call)
            if other is not None and other is not own and each.call != number:
                self._respond(other, None, {"code": each.code} if each.code else None)
                self._end(other)
        if superseded in self._calls:
            self._end(self._calls[superseded])

    def _respond(self, call: RunningCall, value: Json, error: Json) -> None:
        answer = {"type": "error", "error": error} if error else {"type": "result", "value": value}
        self.announce({**answer, "call": call.number})
        self._calls.pop(call.number, None)
        call.ended.set()

    def _end(self, call: RunningCall) -> None:
        """Nobody waits for its answer: its method is to end, if it looks (`Service.pause`), or waits in asyncio."""
        self._calls.pop(call.number, None)
        call.ended.set()
        if call.task is not None and inspect.iscoroutinefunction(getattr(self._service, call.operation)):
            call.task.cancel()

    async def _halt(self) -> None:
        own = type(self._service).halt is not Service.halt
        safe = [name for name, each in self._operations.items() if each.get("safe")]
        for method in [self._service.halt] if own else [getattr(self._service, name) for name in safe]:
            try:
                await asyncio.wait_for(invoke(method, method), HALT_TIME)
            except Exception:
                LOG.error("%s: error: it cannot halt\n%s", self.declaration.where(), traceback.format_exc().rstrip())


async def invoke(work: Callable[[], Any], method: Callable[..., Any]) -> Any:
    """What a method returns: one with `async` here, a plain one on a thread of its own, which outlives nobody."""
    if inspect.iscoroutinefunction(method):
        return await work()
    loop = asyncio.get_running_loop()
    done: asyncio.Future[Any] = loop.create_future()
    context = contextvars.copy_context()

    def tell(result: Any, failure: BaseException | None) -> None:
        if done.done():
            return
        if failure is not None:
            done.set_exception(failure)
        else:
            done.set_result(result)

    def run() -> None:
        result, failure = None, None
        try:
            result = context.run(work)
        except BaseException as error:
            failure = error if isinstance(error, Exception) and not isinstance(error, StopIteration) else RuntimeError(repr(error))
        if not loop.is_closed():
            loop.call_soon_threadsafe(tell, result, failure)

    threading.Thread(target=run, name="race_service", daemon=True).start()
    return await done
