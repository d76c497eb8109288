"""Routes of api/openapi.yaml: server. Made by generate/main.py. The request filter of the server may also refuse each."""
from ..call import Call, segment
from ..messages import (Addresses, Audit, Boot, Bundle, BundleInstalled, Empty, Health, Login, LoginAnswer, PairingCreate,
                        PairingCreated, Rules, Task, Ticket)


def get_health() -> Call[Health]:
    """The server answers. It asks nothing that may take long."""
    return Call("GET", "/api/v1/health")


def get_metrics() -> Call[str]:
    """What an operator of the server watches, in the text format 0.0.4 of Prometheus.

    Requests by route, clients, cores by status, macro steps, services, the lateness of the cell, logins that failed, lines of the
    log, and the process itself; deploy/README.md has a table. It asks nobody who may take long, so it may be asked often.
    """
    return Call("GET", "/metrics", answers="text")


def log_in(body: Login) -> Call[LoginAnswer]:
    """A token for a password. It ends after twelve hours, or with a logout or a new password.

    A name that nobody has is answered as a wrong password is, and as late. Failures are limited, of an address (10 at once, then
    one in 6 s) and of a name (50 at once, then one in 20 s). An account has 100 tokens; beyond that, its oldest login ends.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    401: There is no account of this name with this password (`login`).

    413: The account has 100 tokens that are no logins (`too_large`).

    422: Every violation of the request, or of the document that it brings or names.

    429: Too many logins or codes have failed, of this address or name (`attempts`); no password and no code was looked at.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot be written
    (`io`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/login", body=body)


def log_out() -> Call[Empty]:
    """Ends the token of the request. WebSockets that were opened by it end soon after.

    Without accounts there is none, and nothing is done.

    404: It has ended meanwhile (`not_found`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/logout")


def create_ticket() -> Call[Ticket]:
    """A ticket that opens a WebSocket (GET /api/v1/stream), once and within 30 s, for a browser, which cannot send a token with it.

    Who opens it is who has asked for the ticket. At most 1000 wait; the oldest go.
    """
    return Call("POST", "/api/v1/tickets")


def create_pairing(body: PairingCreate) -> Call[PairingCreated]:
    """A code with which a phone gets a token of the account of who asks, once and within 60 s.

    The page shows it as a QR code, with an address of the server. What the token may is the lower of its role and that of the
    account, also when that changes later. A login has one code: a new one replaces it. At most 64 codes wait, and 8 of an
    account.

    400: The body is no JSON or out of its limits (`json`, `too_deep`), or `role` or `days` is out of its range (`out_of_range`).

    409: The server has no accounts: who reaches it, on its machine alone, needs no code (`no_accounts`).

    422: The request does not fit its schema; `name`: that names no display.

    429: 64 codes wait already, or 8 of the account (`too_many`).
    """
    return Call("POST", "/api/v1/pairings", body=body)


def get_addresses() -> Call[Addresses]:
    """Where the network reaches this server; nowhere, if it listens on its own machine alone."""
    return Call("GET", "/api/v1/addresses")


def get_authority() -> Call[str]:
    """The certificate of the authority that has signed for this server, as PEM; a device that trusts it knows the server by it.

    404: There is nothing of this name or number (`not_found`).
    """
    return Call("GET", "/api/v1/authority", answers="text")


def get_audit(*, before: int | None = None, limit: int | None = None) -> Call[Audit]:
    """Who has changed what, the last first. At most 100000 rows are kept; the oldest go.

    A row for each request and message that changes something and that its sender may send, with the answer, also if that refuses
    it. What was sent is not in it. A row is there soon after its answer. Of logins with a wrong password, of wrong codes and of
    stops of a stopped cell there are few; of logins whose password or code was not looked at there are none.

    before: Only rows before this one: `next` of the answer before.

    limit: How many at most.

    400: A parameter is out of its range (`out_of_range`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", "/api/v1/audit", query={"before": before, "limit": limit})


def get_rules() -> Call[Rules]:
    """The rules of the semantics, in their order; every derivation names rules of this list."""
    return Call("GET", "/api/v1/rules")


def install_bundle(body: Bundle, *, as_: str | None = None, author: str | None = None, message: str | None = None,
                   if_match: str | None = None, idempotency_key: str | None = None) -> Call[BundleInstalled]:
    """Stores the document of a bundle, and says which services it lacks here. Refused whole if anything in it is wrong.

    as_: The name of the document, if it is not that of the bundle.

    message: Why.

    if_match: The strong tag of a revision: nothing is changed unless that is the last one.

    idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
    the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
    requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
    409 (`conflict`). The last 1000 answers are kept, while the server runs.

    400: The body is no JSON or out of its limits (`json`, `too_deep`), or a parameter is none (`out_of_range`); or the document
    with its ids would be too deep to be read again (`too_deep`).

    409: `conflict`: there is a document of this name, and no If-Match.

    412: `conflict`: the last revision is not that of If-Match, or there is a document although If-None-Match says that there is
    none.

    413: It has more than 100 services; or with its links the document has too many states, or its text with the ids would be too
    large to be read again; the author or message is too long; there are 10000 documents or 100000 revisions of it (`too_large`).

    422: Every violation of the request, or of the document that it brings or names.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/bundles", query={"as": as_, "author": author, "message": message},
                headers={"If-Match": if_match, "Idempotency-Key": idempotency_key}, body=body)


def get_task(id: str) -> Call[Task]:
    """How far the work of a request is that was answered 202, before that was done, and what it comes to.

    For who has sent the request, and admins. The last 100 are kept, while the server runs.

    404: There is nothing of this name or number (`not_found`).
    """
    return Call("GET", f"/api/v1/tasks/{segment(id)}")


def cancel_task(id: str) -> Call[Task]:
    """Tells the work to stop. It may be done all the same.

    404: There is nothing of this name or number (`not_found`).

    409: It is over, or cannot be told to stop, as a backup and its restore (`conflict`).
    """
    return Call("DELETE", f"/api/v1/tasks/{segment(id)}")


def get_boot() -> Call[Boot]:
    """What the server starts when it begins.

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", "/api/v1/boot")


def put_boot(body: Boot) -> Call[Boot]:
    """Replaces the list of what the server starts when it begins.

    When the server begins, a core of each document is created and started, in order, unless the document has a run that is not
    over: one that was interrupted waits for a person. What cannot be started is logged, and the others are started.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: No such document; every one.

    413: `too_large`: there are more than 64 entries.

    422: Every violation; `duplicate`: a document stands twice.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("PUT", "/api/v1/boot", body=body)
