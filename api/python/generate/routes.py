"""All routes of api/openapi.yaml as data, for the generators of each language."""
import re
from collections.abc import Callable
from typing import Any

import yaml

from schemas import API, look_up, resolve

INTERFACE: dict[str, Any] = yaml.safe_load((API / "openapi.yaml").read_text())
BASE = "openapi.yaml"


def component(value: Any) -> Any:
    """What a reference within openapi.yaml, or to api/schemas, means."""
    while isinstance(value, dict) and "$ref" in value:
        reference = value["$ref"]
        if not reference.startswith("#/"):
            return look_up(resolve(reference, BASE))
        value = INTERFACE
        for key in reference[2:].split("/"):
            value = value[key]
    return value


def json_address(content: dict[str, Any]) -> str | None:
    """The schema of a JSON body or answer."""
    found = content.get("application/json")
    return resolve(found["schema"]["$ref"], BASE) if found else None


DEFERRED = "202"  # of what is answered before it is done, for who prefers that


class Route:
    """A method of a path, as openapi.yaml has it. `body` and `answer`: addresses of their schemas; without one, the answer is text.

    `is_deferred`: as it answers who prefers to be answered before it is done. That answer has a schema of its own, so it is another call.
    """

    def __init__(self, path: str, method: str, operation: dict[str, Any], shared: list[Any], is_deferred: bool = False) -> None:
        self.path, self.method, self.operation, self.is_deferred = path, method, operation, is_deferred
        parameters = [component(each) for each in [*shared, *operation.get("parameters", [])]]
        parameters = [each for each in parameters if each["name"] != "Prefer"]
        self.parameters = {where: [each for each in parameters if each["in"] == where] for where in ("path", "query", "header")}
        self.headers = {"Prefer": "respond-async"} if is_deferred else {}
        self.operation_id: str = operation["operationId"] + ("Task" if is_deferred else "")
        body = operation.get("requestBody", {})
        self.body = json_address(body.get("content", {}))
        self.body_required = body.get("required", False)
        done = (DEFERRED,) if is_deferred else ("200", "201")
        answers = [component(answer) for status, answer in operation["responses"].items() if status in done]
        self.answer = json_address(answers[0].get("content", {})) if answers else None
        content = operation["responses"].get("200", {}).get("content", {})
        self.goes_on = "101" in operation["responses"] or "text/event-stream" in content  # no call: the answer has no end

    @property
    def module(self) -> str:
        """The first word of its path; one that has no other route goes with the server's."""
        word = self.path.removeprefix("/api/v1").split("/")[1]
        return word if sum(f"/api/v1/{word}" in path for path in INTERFACE["paths"]) > 1 else "server"

    def named_parameters(self) -> list[dict[str, Any]]:
        """Those that a caller gives by name: of the query, and headers."""
        return [*self.parameters["query"], *self.parameters["header"]]

    def paragraphs(self, named: Callable[[str], str]) -> list[str]:
        """Summary, description, parameters (as `named` calls them), and by status what refuses it; each in one line."""
        parts = [self.operation["summary"], self.operation.get("description", "")]
        if self.is_deferred:
            parts = [f"As {named(self.operation['operationId'])}, but answered before it is done: "
                     f"{named('getTask')} says what it comes to. The server works on 16 such requests at most (503, `unavailable`)."]
        about = [each for where in self.parameters.values() for each in where if each.get("description")]
        parts += [f"{named(each['name'])}: {each['description']}" for each in about]
        parts += [f"{status}: {component(each)['description']}" for status, each in self.operation["responses"].items()
                  if re.fullmatch("[45]\\d\\d", status)]
        return [text for part in parts if (text := " ".join(part.split()))]


def kind_of(parameter: dict[str, Any], kinds: dict[str, str]) -> str:
    """The type of a parameter, of those that a language has for the types of JSON."""
    return kinds[component(parameter["schema"]).get("type", "string")]


def all_routes() -> list[Route]:
    """Every route whose answer has an end, in the order of openapi.yaml; after one that can be deferred, that."""
    routes = [Route(path, method, operation, methods.get("parameters", []), is_deferred)
              for path, methods in INTERFACE["paths"].items()
              for method, operation in methods.items() if method in ("get", "put", "post", "delete")
              for is_deferred in ((False, True) if DEFERRED in operation["responses"] else (False,))]
    return [route for route in routes if not route.goes_on]


def stream_path() -> str:
    """The path of the stream."""
    return next(path for path, methods in INTERFACE["paths"].items() if methods.get("get", {}).get("operationId") == "openStream")
