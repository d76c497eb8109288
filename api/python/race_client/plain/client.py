# Made from ../aio/client.py by generate/main.py.
"""The plain client: who asks which server, and what it offers."""
import os
from types import TracebackType
from typing import TypeVar

from .. import calls
from ..address import Address, checked_token
from ..call import Call
from ..errors import RaceError
from ..messages import Control, Empty, Health, LoginAnswer, Me
from .cores import Cores
from .documents import Documents
from .following import Following, passes
from .http import Http
from .net import pause
from .runs import Runs
from .services import Services

Answered = TypeVar("Answered")

STOP_TRIES, STOP_TIMEOUT, STOP_PAUSE = 3, 3.0, 0.1  # how often a stop is sent, and seconds for each and in between


class Client:
    """A client of one server. `documents`, `cores`, `runs` and `services` have what is asked most; `send` sends any other route of `calls`.

    `url`: `http://127.0.0.1:8080`, or `https://HOST:PORT` of another machine. `token`: of an account (`race account token`), or by
    `log_in`; a server without accounts needs none. `ca_file`: the authority of an https server (`tls/ca.pem` of its data folder).
    `timeout`: seconds for each answer. ValueError: one of these can be none. Nothing is connected before the first request.
    Close it, or use it as a context manager. What refuses a request, or keeps its answer away, is a RaceError.
    """

    def __init__(self, url: str = "http://127.0.0.1:8080", *, token: str | None = None, ca_file: str | os.PathLike[str] | None = None,
                 timeout: float = 20.0) -> None:
        self._address = Address.parse(url, ca_file)
        self._token = checked_token(token)
        self._timeout = timeout
        self._http = Http(self._address)
        self.documents = Documents(self)
        self.cores = Cores(self)
        self.runs = Runs(self)
        self.services = Services(self)

    def __enter__(self) -> "Client":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """Closes the connections that are kept for further requests."""
        self._http.close()

    def send(self, call: Call[Answered], *, timeout: float | None = None) -> Answered:
        """The answer to a request of `calls`, within `timeout` seconds (else those of the client). RaceError: refused, or no answer."""
        return call.read(self._http.ask(call, self._token, self._timeout if timeout is None else timeout))

    def follow(self, core: str, *, quiet: float | None = None, patience: float = 60.0, capacity: int = 1000,
               within: float | None = None) -> Following:
        """As `cores.follow`."""
        return Following(self._address, self._token, core, timeout=self._timeout, quiet=quiet, patience=patience, capacity=capacity,
                              within=within)

    def log_in(self, name: str, password: str) -> LoginAnswer:
        """Asks as this account from now on, for twelve hours at most. RaceError 401 `login`: no such name and password; 429 `attempts`."""
        answer = self.send(calls.log_in({"name": name, "password": password}))
        self._token = checked_token(answer["token"])
        return answer

    def log_out(self) -> Empty:
        """Ends the token; the server knows this client no more."""
        answer = self.send(calls.log_out())
        self._token = None
        return answer

    def me(self) -> Me:
        """Who asks: `name` and `role` of the account, if the server has `accounts`."""
        return self.send(calls.get_me())

    def health(self) -> Health:
        """The server answers: `version`, `time` [s] of its clock, whether it has a `cell`."""
        return self.send(calls.get_health())

    def stop_cell(self) -> Control:
        """Stops everything that moves, and all runs, until `reset_stop`. Needs no account. This is not a safety function.

        It is sent over a new connection, and, as it may be done twice, again if no answer comes: three times, for 3 s each.
        """
        call, may_be_done, tries = calls.stop_cell(), False, STOP_TRIES
        while True:
            try:
                return call.read(self._http.ask(call, self._token, min(STOP_TIMEOUT, self._timeout), is_new=True))
            except RaceError as error:
                tries -= 1
                may_be_done = error.may_be_done = error.may_be_done or may_be_done
                if tries == 0 or not (passes(error) or error.status == 503):
                    raise
            pause(STOP_PAUSE)

    def reset_stop(self) -> Control:
        """Motions may begin again; none does by this."""
        return self.send(calls.reset_stop())
