"""Routes of api/openapi.yaml: cores. Made by generate/main.py. The request filter of the server may also refuse each."""
from ..call import Call, segment
from ..messages import (Breakpoints, Core, CoreConfirmEdit, CoreCreate, CoreLive, CoreLoad, CoreResume, CoreStart, CoreState,
                        Cores, Derivations, Force, Journal, Native, Past, Script, StepRequest, Why)


def list_cores() -> Call[Cores]:
    """The cores, running or not."""
    return Call("GET", "/api/v1/cores")


def create_core(body: CoreCreate, *, idempotency_key: str | None = None) -> Call[Core]:
    """Makes a core of a document and arguments. It waits to be started.

    idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
    the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
    requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
    409 (`conflict`). The last 1000 answers are kept, while the server runs.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: No such document (`not_found`).

    409: There are 128 cores already, and no run of them is over, or a backup is being restored (`conflict`).

    422: The request does not fit its schema, an argument does not fit, or the document has violations.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/cores", headers={"Idempotency-Key": idempotency_key}, body=body)


def get_core(id: str) -> Call[Core]:
    """One core.

    id: Of a core.

    404: There is nothing of this name or number (`not_found`).
    """
    return Call("GET", f"/api/v1/cores/{segment(id)}")


def delete_core(id: str) -> Call[Core]:
    """Removes a core; one that runs is stopped first.

    id: Of a core.

    404: There is nothing of this name or number (`not_found`).

    409: It is being loaded or removed (`conflict`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("DELETE", f"/api/v1/cores/{segment(id)}")


def load_core(id: str, body: CoreLoad) -> Call[Core]:
    """Loads another document, its last revision, or other arguments into a core that has not begun. It waits to be started, as
    before.

    id: Of a core.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: No such core or document.

    409: Its run has begun, make another core; or it is being loaded or removed, or a backup is being restored (`conflict`).

    422: An argument does not fit, or the document has violations; nothing is changed.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/cores/{segment(id)}/load", body=body)


def start_core(id: str, body: CoreStart | None = None, *, race_control: str | None = None) -> Call[Core]:
    """Starts a core that waits; the first macro step activates the root. With arguments, these take the place of those that it was
    created with.

    id: Of a core.

    race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell.
    409 (`leased`): they have them no more.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    409: It was started before; or, as of resumeCore, it may not move.

    422: An argument does not fit, or the body is none; nothing is changed.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/cores/{segment(id)}/start", headers={"Race-Control": race_control}, body=body)


def pause_core(id: str) -> Call[Core]:
    """Holds a core between macro steps, also before its start. Inputs go on waiting.

    id: Of a core.

    404: There is nothing of this name or number (`not_found`).

    409: The run is over (`conflict`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/cores/{segment(id)}/pause")


def resume_core(id: str, body: CoreResume | None = None, *, race_control: str | None = None) -> Call[Core]:
    """Lets a paused or interrupted core go on. 409 also: `stopped`: the cell is; `leased`: somebody else has the controls of the
    cell; `conflict`: the run needs who begins it at the controls.

    id: Of a core.

    race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell.
    409 (`leased`): they have them no more.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    409: The run is over (`conflict`).

    422: The body does not fit its schema.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/cores/{segment(id)}/resume", headers={"Race-Control": race_control}, body=body)


def stop_core(id: str) -> Call[Core]:
    """Aborts a run between macro steps. No exit function runs; the safe operations of the services it called are invoked.

    id: Of a core.

    404: There is nothing of this name or number (`not_found`).

    409: It is over or was not started.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/cores/{segment(id)}/stop")


def step_core(id: str, body: StepRequest, *, race_control: str | None = None) -> Call[Core]:
    """Lets a paused core do one micro step, one macro step, or go on until what a breakpoint could name. It is paused afterwards,
    and while its step waits for an input; then another step may take its place.

    id: Of a core.

    race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell.
    409 (`leased`): they have them no more.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: No such state, port, action or operation.

    409: It is not paused; or, as of resumeCore, it may not move.

    422: The request is no step; every violation.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/cores/{segment(id)}/step", headers={"Race-Control": race_control}, body=body)


def confirm_core_edit(id: str, body: CoreConfirmEdit, *, race_control: str | None = None) -> Call[Core]:
    """An edit that waits for it may reach the run (core.json, `unconfirmed`); only who has the controls of the cell says so.

    id: Of a core.

    race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell.
    409 (`leased`): they have them no more.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    409: `conflict`: no edit to this revision waits; `leased`: who asks has not the controls.

    422: The body does not fit its schema.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).
    """
    return Call("POST", f"/api/v1/cores/{segment(id)}/confirm_edit", headers={"Race-Control": race_control}, body=body)


def set_breakpoints(id: str, body: Breakpoints, *, author: str | None = None) -> Call[Core]:
    """Sets where the core is paused, in place of what the same person has set before. Breakpoints end the step under way, too.

    id: Of a core.

    author: Who sets them: those of others stay. Without it they take the place of all.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: No such state, port, action or operation.

    409: The run is over (`conflict`).

    413: `too_large`: there are more than 100, with those of others; a condition has more than 500 characters, or the author more
    than 100.

    422: Every violation of the request, or of the document that it brings or names.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("PUT", f"/api/v1/cores/{segment(id)}/breakpoints", query={"author": author}, body=body)


def set_core_live(id: str, body: CoreLive) -> Call[Core]:
    """Whether the core follows the edits of its document. A running core gets each revision without violations between macro steps,
    as soon as everything active has a place in it; until then `waiting_edit` says what it waits for.

    id: Of a core.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    409: The run is over (`conflict`).

    422: Every violation of the request, or of the document that it brings or names.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("PUT", f"/api/v1/cores/{segment(id)}/live", body=body)


def force_core(id: str, body: Force, *, race_control: str | None = None) -> Call[Core]:
    """Sets a parameter, result or variable of a running core, or takes a port of an active state, in a macro step of its own. A
    paused core stays paused after it. As the run may move by that, who has the controls of the cell does it, if anybody has them.

    id: Of a core.

    race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell.
    409 (`leased`): they have them no more.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: No such core, state, value or port.

    409: It is not running, is paused in a macro step, or the state of the port is not active. `leased`: somebody else has the
    controls of the cell; `conflict`: nobody has, and the run needs who began it, or has moved something at a server with
    accounts.

    413: `too_large`: the value is beyond the budget of the run.

    422: Every violation of the request, or of the document that it brings or names.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/cores/{segment(id)}/force", headers={"Race-Control": race_control}, body=body)


def get_core_native(id: str) -> Call[Native]:
    """The native model that this core executes.

    id: Of a core.

    404: There is nothing of this name or number (`not_found`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/cores/{segment(id)}/native")


def get_core_state(id: str) -> Call[CoreState]:
    """What is active, and the values, after the last step.

    id: Of a core.

    404: There is nothing of this name or number (`not_found`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/cores/{segment(id)}/state")


def get_derivations(id: str, *, from_: int | None = None, to: int | None = None) -> Call[Derivations]:
    """The derivations of macro steps, recomputed from the journal; at most 100 steps of an answer.

    id: Of a core.

    from_: First macro step; else the last one.

    to: Last macro step; else `from`.

    400: A parameter is out of its range (`out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/cores/{segment(id)}/derivations", query={"from": from_, "to": to})


def get_core_script(id: str) -> Call[Script]:
    """The run so far as a script; with the model of `native` (as a document), `race derive` gives this run's derivations.

    id: Of a core.

    404: There is nothing of this name or number (`not_found`).

    413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
    /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/cores/{segment(id)}/script")


def get_core_journal(id: str) -> Call[Journal]:
    """Header and inputs of the run, in order of delivery; the run is a function of these.

    id: Of a core.

    404: There is nothing of this name or number (`not_found`).

    413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it,
    /api/v1/runs/{run}/derivations, or read the run where it is stored: `race replay RUN --data DIR`.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/cores/{segment(id)}/journal")


def get_why(id: str, *, port: str | None = None, state: str | None = None, action: int | None = None,
            parameter: str | None = None, step: int | None = None, micro: int | None = None) -> Call[Why]:
    """Why a port fired or does not fire, an action was executed or is not, or a parameter has its value.

    id: Of a core.

    port: A port, as Root/A.success; or `state` with one of `action` and `parameter`.

    state: The state of the action or parameter, as Root/A.

    action: Its number within the state, from 0.

    parameter: Its name.

    step: With `micro`: as things were in this macro step; else as they are now.

    micro: Before this micro step of it, and when the turn of what is asked about comes in it; those that the derivation of the
    step lists.

    400: A parameter is out of its range (`out_of_range`).

    404: No such core, port, action or parameter.

    409: `conflict`: more than one thing is asked about.

    422: `missing`: what is asked about, or one of `step` and `micro`

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/cores/{segment(id)}/why", query={"port": port, "state": state, "action": action,
                "parameter": parameter, "step": step, "micro": micro})


def get_past(id: str, *, step: int, micro: int | None = None) -> Call[Past]:
    """The run as it was at an earlier micro step, recomputed from the journal. Nothing of it is done again; robots and services stay
    where they are.

    id: Of a core.

    step: A macro step that has begun.

    micro: After this many micro steps of it; absent, or more than it has: at its end.

    400: A parameter is out of its range (`out_of_range`).

    404: There is nothing of this name or number (`not_found`).

    422: `missing`: the step

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", f"/api/v1/cores/{segment(id)}/past", query={"step": step, "micro": micro})
