"""The one exception of the library, and how the failures of sockets become it."""
import json
import ssl
from collections.abc import Iterator
from contextlib import contextmanager
from typing import cast

from .messages import Json, ServerError

# Codes that are not the server's; all others are (api/openapi.yaml names them by route).
CONNECTION = "connection"  # there is no connection, or it ended
TIMEOUT = "timeout"  # no connection or no answer in time
CERTIFICATE = "certificate"  # the server is not known by its certificate; nothing was sent
PROTOCOL = "protocol"  # what came is not what api/ promises


class RaceError(Exception):
    """What was asked for is not done, or not known to be done.

    `status`: the HTTP status of the server's refusal; 0 if none came by HTTP.
    `errors`: each reason, with `path` (node, port or field; empty: the whole), `code` and `message`, and for code text with `text`,
    `line` and `column`: at least one and at most 200; `more_errors` says that there are more.
    `code`, `path`, `message`: of the first. A program branches on `code`: of the server, or `connection`, `timeout`, `certificate`
    or `protocol` (above).
    `may_be_done`: whether the request may have been done all the same, as it was sent (`is_sent`) and no answer has come that can be read.
    """

    def __init__(self, status: int, errors: list[ServerError], more_errors: bool = False, *, is_sent: bool = True) -> None:
        self.status = status
        self.errors = errors
        self.more_errors = more_errors
        first = errors[0]
        self.path, self.code, self.message = first["path"], first["code"], first["message"]
        self.may_be_done = is_sent and status == 0 and self.code != CERTIFICATE
        super().__init__("\n".join(line_of(error) for error in errors) + ("\n..." if more_errors else ""))


class ServiceError(RaceError):
    """A service has answered a call with an error.

    `service` and `operation` name the call; `error` is the whole value, with at least `code`; the RSM says what else it has.
    """

    def __init__(self, service: str, operation: str, error: Json) -> None:
        self.service, self.operation, self.error = service, operation, error
        fields = error if isinstance(error, dict) else {}
        message = str(fields.get("message", f"{service}.{operation} has failed"))
        super().__init__(200, [{"path": f"{service}.{operation}", "code": str(fields.get("code", "error")), "message": message}])


def line_of(error: ServerError) -> str:
    """`path: code: message`, as the command line of the server prints it."""
    return ": ".join(part for part in (error["path"], error["code"], error["message"]) if part)


def failure(code: str, message: str, *, is_sent: bool = True) -> RaceError:
    """An error that is not the server's."""
    return RaceError(0, [{"path": "", "code": code, "message": message}], is_sent=is_sent)


def refusal(status: int, body: bytes) -> RaceError:
    """The error of an answer with problem details (api/schemas/problem.json), or of one that should have them."""
    try:
        problem = json.loads(body)
        errors = [{**each, **{key: str(each[key]) for key in ("path", "code", "message")}} for each in problem["errors"]]
        return RaceError(status, cast(list[ServerError], errors), problem.get("more_errors") is True)
    except (ValueError, KeyError, TypeError, IndexError):
        message = f"status {status} without problem details: not a server of RACE?"
        return RaceError(status, [{"path": "", "code": PROTOCOL, "message": message}])


@contextmanager
def socket_errors(where: str, *, is_sent: bool = True) -> Iterator[None]:
    """Failures of sockets within become RaceError; `where` is the address for its message, `is_sent`: a request may be sent within."""
    try:
        yield
    except TimeoutError:
        raise failure(TIMEOUT, f"{where} does not answer in time", is_sent=is_sent) from None
    except ssl.SSLCertVerificationError as error:
        raise failure(CERTIFICATE, f"{where} is not known by its certificate: {error.verify_message}") from None
    except OSError as error:
        message = f"{where} cannot be reached: {error.strerror or error or type(error).__name__}"
        raise failure(CONNECTION, message, is_sent=is_sent) from None
