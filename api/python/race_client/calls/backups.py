"""Routes of api/openapi.yaml: backups. Made by generate/main.py. The request filter of the server may also refuse each."""
from ..call import Call, segment
from ..messages import Backup, Backups, Task


def list_backups() -> Call[Backups]:
    """The backups that are whole, by time; also while another one is made.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("GET", "/api/v1/backups")


def create_backup(*, idempotency_key: str | None = None) -> Call[Backup]:
    """Copies all that the server keeps, as it is now; runs go on meanwhile. At most 20 are kept.

    idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
    the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
    requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
    409 (`conflict`). The last 1000 answers are kept, while the server runs.

    409: There are 20 already, or the request of this Idempotency-Key is under way (`conflict`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/backups", headers={"Idempotency-Key": idempotency_key})


def create_backup_task(*, idempotency_key: str | None = None) -> Call[Task]:
    """As create_backup, but answered before it is done: get_task says what it comes to. The server works on 16 such requests at most
    (503, `unavailable`).

    idempotency_key: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
    the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
    requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
    409 (`conflict`). The last 1000 answers are kept, while the server runs.

    409: There are 20 already, or the request of this Idempotency-Key is under way (`conflict`).

    500: What is stored is damaged (`corrupt`); the error names the part.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", "/api/v1/backups", headers={"Idempotency-Key": idempotency_key, "Prefer": "respond-async"})


def get_backup(name: str) -> Call[Backup]:
    """One backup.

    404: There is nothing of this name or number (`not_found`).
    """
    return Call("GET", f"/api/v1/backups/{segment(name)}")


def delete_backup(name: str) -> Call[Backup]:
    """Removes a backup.

    404: There is nothing of this name or number (`not_found`).

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("DELETE", f"/api/v1/backups/{segment(name)}")


def restore_backup(name: str) -> Call[Backup]:
    """Makes all that the server keeps what it was then. Cores are removed.

    404: There is nothing of this name or number (`not_found`).

    409: A run is not over (`conflict`).

    422: A newer version of the program made it (`version`).

    500: The backup is damaged (`corrupt`); nothing is changed.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/backups/{segment(name)}/restore")


def restore_backup_task(name: str) -> Call[Task]:
    """As restore_backup, but answered before it is done: get_task says what it comes to. The server works on 16 such requests at
    most (503, `unavailable`).

    404: There is nothing of this name or number (`not_found`).

    409: A run is not over (`conflict`).

    422: A newer version of the program made it (`version`).

    500: The backup is damaged (`corrupt`); nothing is changed.

    503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.

    507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
    interrupted. Ask again when it works.
    """
    return Call("POST", f"/api/v1/backups/{segment(name)}/restore", headers={"Prefer": "respond-async"})
