"""Routes of api/openapi.yaml: runs. Made by generate/main.py. The request filter of the server may also refuse each."""
from ..call import Call, segment
from ..messages import (Derivations, Journal, Native, Past, Run, RunComparison, RunFile, RunPicture, RunPictures, RunRemoved,
                        RunSamples, Runs, Script, Task, TaskTest, Timing, Why)


def list_runs(*, document: str | None = None, before: int | None = None, limit: int | None = None) -> Call[Runs]:
    """The stored runs, the newest first; at most 100 of an answer.

    document: Only those of this document.

    before: Only those with a smaller number.

    400: A parameter is out of its range (`out_of_range`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", "/api/v1/runs", query={"document": document, "before": before, "limit": limit})


def import_run(body: RunFile, *, idempotency_key: str | None = None) -> Call[Run]:
    """Stores the file of a run, of this server or another one, under a new number.

    A file has at most 16 MiB and 642 levels, where other bodies have 4 MiB and 64. It is checked whole: its chain is computed
    anew, and the run is done again, with at most 4 million micro steps, in at most 20 seconds and within the budgets of a new
    run. Its document is not stored. Nothing of it is executed.

    idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
    the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
    requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
    409 (`conflict`). The last 1000 answers are kept, while the server runs.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    409: `conflict`: a run does not take an entry of its journal.

    413: `too_large`: the file, its samples, or the work or time that its run takes.

    422: Every violation of the format; `version`; or `corrupt`: the record or the chain is not that of the journal.

    503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot be read
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/runs", headers={"Idempotency-Key": idempotency_key}, body=body)


def import_run_task(body: RunFile, *, idempotency_key: str | None = None) -> Call[Task]:
    """As import_run, but answered before it is done: get_task says what it comes to. The server works on 16 such requests at most
    (503, `unavailable`).

    idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
    the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
    requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
    409 (`conflict`). The last 1000 answers are kept, while the server runs.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    409: `conflict`: a run does not take an entry of its journal.

    413: `too_large`: the file, its samples, or the work or time that its run takes.

    422: Every violation of the format; `version`; or `corrupt`: the record or the chain is not that of the journal.

    503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot be read
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/runs", headers={"Idempotency-Key": idempotency_key, "Prefer": "respond-async"}, body=body)


def get_run(run: str) -> Call[Run]:
    """One stored run.

    404: There is nothing of this name or number (`not_found`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}")


def delete_run(run: str) -> Call[RunRemoved]:
    """Removes a run from the store with its journal, also one that is damaged.

    404: There is nothing of this name or number (`not_found`).

    409: `conflict`: a core has this run; delete the core first.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("DELETE", f"/api/v1/runs/{segment(run)}")


def get_run_native(run: str) -> Call[Native]:
    """The model that was executed.

    404: There is nothing of this name or number (`not_found`).

    422: `version`: an earlier version of the server executed it, by other semantics.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/native")


def get_run_derivations(run: str, *, from_: int | None = None, to: int | None = None) -> Call[Derivations]:
    """The derivations of macro steps, recomputed from the journal; at most 100 steps of an answer.

    from_: First macro step; else the last one.

    to: Last macro step; else `from`.

    400: A parameter is out of its range (`out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    409: `conflict`: a run does not take an entry of its journal.

    413: `too_large`: the replay takes longer than 20 seconds.

    422: `version`: an earlier version of the server executed it, by other semantics.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot be read
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/derivations", query={"from": from_, "to": to})


def get_run_past(run: str, *, step: int, micro: int | None = None) -> Call[Past]:
    """The stored run as it was at a micro step, recomputed from the journal. Nothing of it is done again; robots and services stay
    where they are.

    step: A macro step of it.

    micro: After this many micro steps of it; absent, or more than it has: at its end.

    400: A parameter is out of its range (`out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    409: `conflict`: a run does not take an entry of its journal.

    413: `too_large`: the replay takes longer than 20 seconds.

    422: `version`: an earlier version of the server executed it, by other semantics.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot be read
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/past", query={"step": step, "micro": micro})


def get_run_why(run: str, *, port: str | None = None, state: str | None = None, action: int | None = None,
                parameter: str | None = None, step: int | None = None, micro: int | None = None) -> Call[Why]:
    """Why a port of the stored run fired or an action was executed, or not, or what gave a parameter its value, recomputed from the
    journal.

    port: A port, as Root/A.success; or `state` with one of `action` and `parameter`.

    state: The state of the action or parameter, as Root/A.

    action: Its number within the state, from 0.

    parameter: Its name.

    step: With `micro`: as things were in this macro step; else as they are at the end of what is stored.

    micro: Before this micro step of it, and when the turn of what is asked about comes in it; those that the derivation of the
    step lists.

    400: A parameter is out of its range (`out_of_range`).

    404: No such run, port, action or parameter.

    409: `conflict`: a run does not take an entry of its journal.

    413: `too_large`: the replay takes longer than 20 seconds.

    422: `missing`: what is asked about, or one of `step` and `micro`; or `version`.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot be read
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/why", query={"port": port, "state": state, "action": action,
                "parameter": parameter, "step": step, "micro": micro})


def get_run_journal(run: str) -> Call[Journal]:
    """Header and inputs of the run, in order of delivery; the run is a function of these.

    404: There is nothing of this name or number (`not_found`).

    413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
    /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.

    422: `version`: an earlier version of the server executed it, by other semantics.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/journal")


def get_run_script(run: str) -> Call[Script]:
    """The run as a script; with the model of `native` (as a document), `race derive` gives this run's derivations.

    404: There is nothing of this name or number (`not_found`).

    413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
    /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.

    422: `version`: an earlier version of the server executed it, by other semantics.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/script")


def get_run_samples(run: str) -> Call[RunSamples]:
    """Where everything in the cell was while the run was running. Empty without a world.

    404: There is nothing of this name or number (`not_found`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/samples")


def get_run_pictures(run: str) -> Call[RunPictures]:
    """Which pictures of cameras are kept of the time in which the run was running.

    404: There is nothing of this name or number (`not_found`).

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/pictures")


def get_run_picture(run: str, number: int) -> Call[RunPicture]:
    """One of these pictures.

    number: Of the list.

    404: There is nothing of this name or number (`not_found`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/pictures/{segment(number)}")


def get_run_timing(run: str, *, from_: int | None = None, to: int | None = None) -> Call[Timing]:
    """When macro steps of the run began, when the inputs came that they deliver, and which states services had meanwhile; at most
    1000 steps of an answer.

    from_: First macro step; else 999 before `to`.

    to: Last macro step; else the last one of the run.

    400: A parameter is out of its range (`out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/timing", query={"from": from_, "to": to})


def export_run(run: str) -> Call[RunFile]:
    """All of a run in one file, which any server opens.

    404: There is nothing of this name or number (`not_found`).

    413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
    /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.

    422: `version`: an earlier version of the server executed it, by other semantics.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/export")


def get_run_test(run: str) -> Call[TaskTest]:
    """A test of the run as a file for `race test`: its inputs as what mocks answer, and what came of them as what is expected.

    400: `out_of_range`: the run took longer than a test may, a day. `too_deep`: its data is deeper than that of a test may be.

    404: There is nothing of this name or number (`not_found`).

    409: `conflict`: a run does not take an entry of its journal.

    413: `too_large`: the test would have more than 4 MiB (4194304 bytes), the journal has more than 16 MiB, or the replay takes
    longer than 20 seconds.

    422: `not_accepted`: the run is not over, or somebody has edited, forced or aborted it; or `version`.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot be read
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/test")


def compare_run(run: str, *, with_: str, from_: int | None = None) -> Call[RunComparison]:
    """The first macro step of which the derivations, calls or states of two runs differ, and the first derivation in it that does;
    at most 2000 steps of an answer.

    with_: The other run.

    from_: The macro step to begin with; else the first one.

    400: A parameter is out of its range (`out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    409: `conflict`: a run does not take an entry of its journal.

    413: `too_large`: the replay takes longer than 20 seconds.

    422: `missing`: with which run; or `version`.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: Three replays are asked for already, or those before take long (`unavailable`): ask again. Or the store cannot be read
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/runs/{segment(run)}/compare", query={"with": with_, "from": from_})
