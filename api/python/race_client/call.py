"""A request that was not sent yet, and how its answer is read."""
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Generic, Literal, TypeVar, cast
from urllib.parse import quote, urlencode

from .errors import PROTOCOL, RaceError, failure, refusal

Answered = TypeVar("Answered")


@dataclass(frozen=True)
class Answer:
    """Of the server: status, headers by their names in lower case, and body."""

    status: int
    headers: Mapping[str, str]
    body: bytes


@dataclass(frozen=True)
class Call(Generic[Answered]):
    """One request: `calls` makes them, `send` of a client sends them. Of `query` and `headers`, None is left out."""

    method: str
    path: str
    query: Mapping[str, object] = field(default_factory=dict)
    headers: Mapping[str, str | None] = field(default_factory=dict)
    body: object = None
    answers: Literal["json", "text"] = "json"

    @property
    def target(self) -> str:
        """Path and query."""
        query = urlencode({name: text_of(value) for name, value in self.query.items() if value is not None})
        return f"{self.path}?{query}" if query else self.path

    def content(self) -> bytes | None:
        """The body. ValueError: it has NaN or an infinity; TypeError: something that is no JSON."""
        return None if self.body is None else json.dumps(self.body, allow_nan=False).encode()

    def read(self, answer: Answer) -> Answered:
        """What the answer says. RaceError: a refusal, or no answer of a server of RACE."""
        if answer.status == 304:
            raise RaceError(304, [{"path": "", "code": "not_modified", "message": "the client has this revision"}])
        if not 200 <= answer.status < 300:
            raise refusal(answer.status, answer.body)
        if self.answers == "text":
            return cast(Answered, answer.body.decode(errors="replace"))
        try:
            value = json.loads(answer.body)
        except ValueError:
            value = None
        if not isinstance(value, dict):
            raise failure(PROTOCOL, f"{self.method} {self.path} was not answered with a JSON object: not a server of RACE?")
        return cast(Answered, value)


def segment(value: object) -> str:
    """A value as one part of a path."""
    return quote(text_of(value), safe="")


def text_of(value: object) -> str:
    """As it stands in a path or query: of a bool, `true` or `false`."""
    return ("true" if value else "false") if isinstance(value, bool) else str(value)
