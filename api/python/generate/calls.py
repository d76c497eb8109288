"""Functions of all routes, from api/openapi.yaml: what one sends, and what it answers, without sending it."""
import keyword
import re
import textwrap
from typing import Any

import yaml

from schemas import API, look_up, resolve, type_name

INTERFACE: dict[str, Any] = yaml.safe_load((API / "openapi.yaml").read_text())
BASE = "openapi.yaml"
SIMPLE = {"string": "str", "integer": "int", "number": "float", "boolean": "bool"}
WIDTH = 130


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


def snake(name: str) -> str:
    """`putDocument` -> put_document, `If-Match` -> if_match, `from` -> from_."""
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).replace("-", "_").lower()
    return f"{words}_" if keyword.iskeyword(words) else words


def json_address(content: dict[str, Any]) -> str | None:
    """The schema of a JSON body or answer."""
    found = content.get("application/json")
    return resolve(found["schema"]["$ref"], BASE) if found else None


class Route:
    """A method of a path, as openapi.yaml has it."""

    def __init__(self, path: str, method: str, operation: dict[str, Any], shared: list[Any]) -> None:
        self.path, self.method, self.operation = path, method, operation
        parameters = [component(each) for each in [*shared, *operation.get("parameters", [])]]
        self.parameters = {where: [each for each in parameters if each["in"] == where] for where in ("path", "query", "header")}
        self.name = snake(operation["operationId"])
        body = operation.get("requestBody", {})
        self.body = json_address(body.get("content", {}))
        self.body_required = body.get("required", False)
        answers = [component(answer) for status, answer in operation["responses"].items() if status in ("200", "201")]
        self.answer = json_address(answers[0].get("content", {})) if answers else None
        content = operation["responses"].get("200", {}).get("content", {})
        self.goes_on = "101" in operation["responses"] or "text/event-stream" in content  # no call: the answer has no end

    @property
    def module(self) -> str:
        """The first word of its path; one that has no other route goes with the server's."""
        word = self.path.removeprefix("/api/v1").split("/")[1]
        return word if sum(f"/api/v1/{word}" in path for path in INTERFACE["paths"]) > 1 else "server"

    def arguments(self) -> tuple[list[str], list[str]]:
        """Of the function: by position, and by name."""
        first = [f"{snake(each['name'])}: {kind_of(each)}" for each in self.parameters["path"]]
        if self.body:
            first.append(f"body: {type_name(self.body)}" + ("" if self.body_required else " | None = None"))
        named = [f"{snake(each['name'])}: {kind_of(each)}" + ("" if each.get("required") else " | None = None")
                 for each in [*self.parameters["query"], *self.parameters["header"]]]
        return first, named

    def text(self) -> str:
        """The function."""
        first, named = self.arguments()
        answer = type_name(self.answer) if self.answer else "str"
        head = f"def {self.name}({', '.join([*first, *(['*', *named] if named else [])])}) -> Call[{answer}]:"
        target = re.sub(r"{(\w+)}", lambda name: f"{{segment({snake(name.group(1))})}}", self.path)
        words = [f'"{self.method.upper()}"', f'{"f" if "{" in target else ""}"{target}"']
        for where, name in (("query", "query"), ("header", "headers")):
            if self.parameters[where]:
                pairs = ", ".join(f'"{each["name"]}": {snake(each["name"])}' for each in self.parameters[where])
                words.append(f"{name}={{{pairs}}}")
        if self.body:
            words.append("body=body")
        if not self.answer:
            words.append('answers="text"')
        return "\n".join([*wrapped(head, "("), *self.docstring(), *wrapped(f"    return Call({', '.join(words)})", "(")])

    def docstring(self) -> list[str]:
        """Summary, description, parameters, and by status what refuses it."""
        operation = self.operation
        parts = [operation["summary"], operation.get("description", "")]
        about = [each for where in self.parameters.values() for each in where if each.get("description")]
        parts += [f"{snake(each['name'])}: {each['description']}" for each in about]
        parts += [f"{status}: {component(each)['description']}" for status, each in operation["responses"].items()
                  if re.fullmatch("[45]\\d\\d", status)]
        lines = []
        for part in parts:
            text = " ".join(part.split())
            if text:
                lines += ["", *textwrap.wrap(text, WIDTH - 4, break_long_words=False, break_on_hyphens=False)]
        quotes = 'r"""' if any("\\" in line for line in lines) else '"""'
        lines = [f"    {line}".rstrip() for line in lines[1:]]
        lines[0] = f"    {quotes}{lines[0].strip()}"
        return [*lines, '    """'] if len(lines) > 1 else [lines[0] + '"""']


def kind_of(parameter: dict[str, Any]) -> str:
    return SIMPLE.get(component(parameter["schema"]).get("type", "string"), "str")


def wrapped(line: str, bracket: str) -> list[str]:
    """A long line, broken behind commas and indented below its first bracket."""
    indent = " " * (line.index(bracket) + 1)
    lines = [line]
    while len(lines[-1]) > WIDTH and (at := lines[-1].rfind(", ", 0, WIDTH - 1)) > len(indent):
        lines[-1:] = [lines[-1][: at + 1], indent + lines[-1][at + 2 :]]
    return lines


def all_routes() -> list[Route]:
    """Every route but the WebSockets, in the order of openapi.yaml."""
    routes = [Route(path, method, operation, methods.get("parameters", []))
              for path, methods in INTERFACE["paths"].items()
              for method, operation in methods.items() if method in ("get", "put", "post", "delete")]
    return [route for route in routes if not route.goes_on]


def stream_path() -> str:
    """The path of the stream."""
    return next(path for path, methods in INTERFACE["paths"].items() if methods.get("get", {}).get("operationId") == "openStream")


def calls_text(module: str, routes: list[Route]) -> str:
    """The module with the functions of these routes."""
    used = sorted({name for route in routes for address in (route.body, route.answer) if address and (name := type_name(address))})
    has_segments = any(route.parameters["path"] for route in routes)
    imports = wrapped(f"from ..messages import ({', '.join(used)})", "(")
    if len(imports) == 1:
        imports = [f"from ..messages import {', '.join(used)}"]
    title = f"Routes of api/openapi.yaml: {module}. Made by generate/main.py. The request filter of the server may also refuse each."
    head = [f'"""{title}"""',
            f"from ..call import Call{', segment' if has_segments else ''}", *(imports if used else [])]
    return "\n".join(head) + "\n" + "".join(f"\n\n{route.text()}\n" for route in routes)
