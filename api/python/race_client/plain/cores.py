# Made from ../aio/cores.py by generate/main.py.
"""Cores of the plain client: each hosts one run of a document."""
import uuid
from collections.abc import Iterator, Mapping

from .. import calls
from ..deadline import Deadline
from ..errors import TIMEOUT, RaceError, failure
from ..fold import is_over
from ..messages import Core, CoreCreate, CoreStart, CoreState, Json, TraceStep
from .following import Following
from .sender import Sender, derivation_pages, send_twice


class Cores:
    """The cores of the server. `id` is the number of a core, as text, and of its run."""

    def __init__(self, client: Sender) -> None:
        self._client = client

    def all(self) -> list[Core]:
        """All cores, running or not."""
        return self._client.send(calls.list_cores())["cores"]

    def get(self, id: str) -> Core:
        """One core: `status`, `step` (macro steps begun), `outcome`, `results`, `fault`. RaceError 404 `not_found`."""
        return self._client.send(calls.get_core(id))

    def create(self, document: str, arguments: Mapping[str, Json] | None = None, *, live: bool = False,
                     key: str | None = None) -> Core:
        """A core of the document's last revision, which waits to be started. `arguments`: of the root's parameters, over their values.

        `live`: it follows the edits of the document. `key`: of this request, else a new one; if its answer does not come it is sent
        again with it, and one core is made. RaceError 422: an argument does not fit, or the document has violations; 409 `conflict`:
        there are 128 cores.
        """
        body: CoreCreate = {"document": document, "live": live, "arguments": dict(arguments or {})}
        return send_twice(self._client, calls.create_core(body, idempotency_key=key or uuid.uuid4().hex))

    def start(self, id: str, arguments: Mapping[str, Json] | None = None, *, control: str | None = None) -> Core:
        """Starts a core that waits; `arguments` take the place of those that it was created with.

        `control`: the secret of who has the controls of the cell. RaceError 409 `conflict`: it was started before; `stopped`: the cell
        is; `leased`: somebody else has the controls. 422: an argument does not fit.
        """
        body: CoreStart = {} if arguments is None else {"arguments": dict(arguments)}
        return self._client.send(calls.start_core(id, body, race_control=control))

    def pause(self, id: str) -> Core:
        """Holds it between macro steps; inputs wait. RaceError 409: it is over."""
        return self._client.send(calls.pause_core(id))

    def resume(self, id: str, *, control: str | None = None) -> Core:
        """Lets a paused or interrupted core go on. RaceError 409: it is over, or as of `start`."""
        return self._client.send(calls.resume_core(id, race_control=control))

    def abort(self, id: str) -> Core:
        """Ends its run between macro steps: `status` becomes `aborted`, and what its services move stops.

        RaceError 409: it does not run.
        """
        return self._client.send(calls.stop_core(id))

    def delete(self, id: str) -> Core:
        """Removes the core, which is stopped before; its run stays in `runs`."""
        return self._client.send(calls.delete_core(id))

    def state(self, id: str) -> CoreState:
        """What is active, and all values, after the last step."""
        return self._client.send(calls.get_core_state(id))

    def follow(self, id: str, *, quiet: float | None = None, patience: float = 60.0, capacity: int = 1000,
               within: float | None = None) -> Following:
        """Its updates until the run is over, over the stream: a context manager, and within it an iterator.

        `quiet`: seconds without an update after which the iterator raises RaceError `timeout` (None: never, for a run may do nothing
        for long). `patience`: seconds for which a lost connection is made again. `capacity`: updates that wait for a slow reader
        until they are put together. `within`: seconds for entering it (None: three times the client's). Errors: as of Following.
        """
        return self._client.follow(id, quiet=quiet, patience=patience, capacity=capacity, within=within)

    def wait(self, id: str, *, timeout: float) -> Core:
        """The core once its run is over: `status` ended (with `outcome` and `results`), faulted (with `fault`) or aborted.

        RaceError `timeout`: after as many seconds it is not, and the message says what it is instead; it goes on.
        """
        deadline = Deadline(timeout)
        core = self._client.send(calls.get_core(id), timeout=timeout)
        if is_over(core["status"]):
            return core
        status = core["status"]
        try:
            with self._client.follow(id, patience=timeout, within=deadline.left()) as updates:
                while (update := updates.next(deadline.left())) is not None:
                    status = update.state["core"]["status"]
                    if is_over(status):
                        return update.state["core"]
        except (TimeoutError, RaceError) as error:
            if isinstance(error, RaceError) and error.code != TIMEOUT:
                raise
        raise failure(TIMEOUT, f"core {id} is not over after {timeout} s: its status is {status}")

    def run(self, document: str, arguments: Mapping[str, Json] | None = None, *, timeout: float) -> Core:
        """Creates a core, starts it and waits for its end: errors of all three. It stays, for its derivations, until `delete`."""
        core = self.create(document, arguments)
        self.start(core["id"])
        return self.wait(core["id"], timeout=timeout)

    def derivations(self, id: str, *, first: int = 1, last: int | None = None) -> Iterator[TraceStep]:
        """The derivations of macro steps `first` to `last` (None: all so far), in order; they come page by page, computed anew each time.

        A step has its `input`, its micro steps as proof trees (`micro`) and the `calls` that it has sent.
        """
        if last is None:
            last = self.get(id)["step"]
        page = lambda begin, end: self._client.send(calls.get_derivations(id, from_=begin, to=end))
        yield from derivation_pages(page, first, last)
