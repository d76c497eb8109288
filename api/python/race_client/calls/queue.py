"""Routes of api/openapi.yaml: queue. Made by generate/main.py. The request filter of the server may also refuse each."""
from ..call import Call, segment
from ..messages import Queue, QueuedRun, QueuedRunCreate


def list_queue(*, after: int | None = None, limit: int | None = None) -> Call[Queue]:
    """The runs that wait their turn, and those before them, in order; at most 100 of an answer.

    after: Only those with a larger id.

    400: A parameter is out of its range (`out_of_range`).
    """
    return Call("GET", "/api/v1/queue", query={"after": after, "limit": limit})


def queue_run(body: QueuedRunCreate, *, idempotency_key: str | None = None, race_control: str | None = None) -> Call[QueuedRun]:
    """Queues a run. It begins when all before it are over; at once, if there are none.

    The document and the arguments are checked now, and this revision is what is executed. It begins as its maker would begin it
    then (POST cores, then POST start): they must still be who they were, with the same token, and have the controls of the cell
    if they had them now (Race-Control). If that is not so, or it may not begin for another reason, it is refused, and the queue
    pauses. It also pauses after a run that was aborted, after a fault unless `on_fault` is go_on, and instead of beginning a run
    while the cell is stopped; the reset of the stop begins nothing. A run that is paused or interrupted is not over. The queue is
    empty after a restart of the server, and after a backup is restored all that waits is cancelled.

    idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
    the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
    requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
    409 (`conflict`). The last 1000 answers are kept, while the server runs.

    race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell.
    409 (`leased`): they have them no more.

    400: The body is no JSON or out of its limits (`json`, `too_deep`), or `on_fault` is none of its values (`out_of_range`).

    404: No such document (`not_found`).

    409: 100 runs wait already, or a backup was restored meanwhile (`conflict`); or who sends it has the controls no more
    (`leased`).

    413: `too_large`: the arguments or the name.

    422: The request does not fit its schema, an argument does not fit, or the document has violations.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/queue", headers={"Idempotency-Key": idempotency_key, "Race-Control": race_control}, body=body)


def resume_queue() -> Call[Queue]:
    """The queue goes on after a pause. The next run begins as whoever queued it.

    409: The cell is stopped (`stopped`): reset it first.
    """
    return Call("POST", "/api/v1/queue/resume")


def get_queued_run(id: str) -> Call[QueuedRun]:
    """One queued run.

    404: There is nothing of this name or number (`not_found`).
    """
    return Call("GET", f"/api/v1/queue/{segment(id)}")


def cancel_queued_run(id: str) -> Call[QueuedRun]:
    """Cancels a run that waits. One that runs is stopped at its core.

    404: There is nothing of this name or number (`not_found`).

    409: It does not wait any more (`conflict`).
    """
    return Call("DELETE", f"/api/v1/queue/{segment(id)}")
