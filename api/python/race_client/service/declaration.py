"""What a class offers: its operations, its RSM, which is made of them or given, and where each of these stands in a file."""
import inspect
import json
import re
import typing
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar, overload

from ..messages import Json
from .generated_rsm import generated_rsm

Function = TypeVar("Function", bound=Callable[..., Any])
MARK = "_race_operation"  # of a method that is an operation
RESERVED = {"emit", "events", "halt", "key", "log", "pause", "rsm", "run", "speed_limit", "state", "take", "type", "version"}  # of Service


class DeclarationError(Exception):
    """A class is no service; the message begins with FILE:LINE."""


@dataclass(frozen=True)
class Marks:
    """What `operation` says of a method."""

    flags: Mapping[str, bool]
    busy: str | None
    stops: str | None
    parameters: Mapping[str, Mapping[str, Json]]
    result: Json


@overload
def operation(function: Function, /) -> Function: ...


@overload
def operation(*, moves: bool = ..., safe: bool = ..., reads: bool = ..., busy: str | None = ..., stops: str | None = ...,
              parameters: Mapping[str, Mapping[str, Json]] | None = ..., result: Json = ...) -> Callable[[Function], Function]: ...


def operation(function: Function | None = None, /, *, moves: bool = False, safe: bool = False, reads: bool = False, busy: str | None = None,
              stops: str | None = None, parameters: Mapping[str, Mapping[str, Json]] | None = None, result: Json = None) -> Any:
    """Makes a method an operation: tasks call it by its name, and what it returns is the result.

    `moves`: it may set something in the cell in motion. `safe`: it stops what is in motion; called without arguments, also when the cell
    is stopped. `reads`: it changes nothing. `busy`: a state in which the service is until the method returns, and in which it takes this
    operation, and others that are `busy`, not again. `stops`: a state of another one that is `busy`: that ends with the error `stopped`.
    `parameters`: by name, more about a parameter than its annotation and default say: `type`, `unit`, `min`, `max`, `doc`. `result`: its
    type. Types are those of RSM: "number", "string", {"record": {...}} and so on.
    """
    flags = {name: True for name, on in (("moves", moves), ("safe", safe), ("reads", reads)) if on}
    marks = Marks(flags, busy, stops, parameters or {}, result)

    def mark(method: Function) -> Function:
        setattr(method, MARK, marks)
        return method

    return mark if function is None else mark(function)


class Declaration:
    """One service: `key`, `type`, `rsm`, and its methods by operation. DeclarationError: the class is none."""

    def __init__(self, service: type[Any]) -> None:
        self._class = service
        self._file = Path(inspect.getsourcefile(service) or "?")
        try:
            self._source, self._first = inspect.getsourcelines(service)
        except OSError:  # typed in
            self._source, self._first = [], 1
        self._rsm_file: Path | None = None
        self._rsm_lines: list[str] = []
        marked = {name: getattr(member, MARK) for name, member in inspect.getmembers(service) if hasattr(member, MARK)}
        lines = {name: getattr(service, name).__code__.co_firstlineno for name in marked}
        self._marked: dict[str, Marks] = {name: marked[name] for name in sorted(marked, key=lines.__getitem__)}
        self.key = self._text("key")
        self.type = self._text("type", self.key)
        self.rsm = self._rsm(getattr(service, "rsm", None))
        for each in self.rsm.get("operations", []):
            if each["name"] in RESERVED:
                raise self.error(f"`{each['name']}` is what every service has itself: an operation needs another name", each["name"])
            if not callable(getattr(service, each["name"], None)):
                raise self.error(f"the RSM has the operation `{each['name']}`, and {service.__name__} no method of this name", each["name"])

    def error(self, message: str, *names: str) -> DeclarationError:
        """An error at the place where one of these names is declared."""
        return DeclarationError(f"{self.where(*names)}: error: {message}")

    def where(self, *names: str) -> str:
        """FILE:LINE where the first of these names is declared that is; else that of the class."""
        for name in names:
            if self._rsm_file is not None and (number := line_with(self._rsm_lines, name)):
                return f"{self._rsm_file}:{number}"
            code = getattr(getattr(self._class, name, None), "__code__", None) if name and name not in RESERVED else None
            if code is not None:
                return f"{code.co_filename}:{code.co_firstlineno}"
            if number := line_with(self._source, name):
                return f"{self._file}:{self._first + number - 1}"
        return f"{self._file}:{self._first}"

    def where_violated(self, violation: Mapping[str, Json]) -> str:
        """FILE:LINE of what a message `violation` (api/schemas/component_message.json) is about."""
        return self.where(str(violation["operation"]), *re.findall(r"`(\w+)`", str(violation["message"])))

    def _text(self, name: str, otherwise: str | None = None) -> str:
        value = getattr(self._class, name, None) or otherwise
        if not isinstance(value, str) or not re.fullmatch(r"[A-Za-z_]\w{0,63}", value, re.ASCII):
            raise self.error(f"{self._class.__name__} needs a `{name}` of letters, digits and `_`, at most 64")
        return value

    def _rsm(self, given: Json) -> dict[str, Json]:
        if isinstance(given, dict):
            return given
        if given is not None:
            self._rsm_file = file = self._file.parent / given
            try:
                self._rsm_lines = file.read_text().splitlines()
                read = json.loads("\n".join(self._rsm_lines))
            except (OSError, ValueError) as error:
                raise DeclarationError(f"{file}:{getattr(error, 'lineno', 1)}: error: {error}") from None
            if not isinstance(read, dict):
                raise DeclarationError(f"{file}:1: error: an RSM is an object")
            return read
        stops = {marks.busy for marks in self._marked.values()}
        for name, marks in self._marked.items():
            if marks.busy is not None and marks.stops is not None:
                raise self.error(f"`{name}` is `busy`, and cannot stop another: have an operation for that", name)
            if marks.stops is not None and marks.stops not in stops:
                raise self.error(f"`{name}` stops `{marks.stops}`, in which nothing is busy", name)
        operations = [self._operation(name, marks) for name, marks in self._marked.items()]
        states = {name: (marks.busy, marks.stops) for name, marks in self._marked.items()}
        made = generated_rsm(self.key, operations, states, getattr(self._class, "events", {}))
        version = getattr(self._class, "version", None)
        return made if version is None else {**made, "meta": {"version": str(version)}}

    def _operation(self, name: str, marks: Marks) -> dict[str, Json]:
        method = getattr(self._class, name)
        parameters = list(inspect.signature(method).parameters.values())[1:]
        types = annotated_types(method)
        unknown = marks.parameters.keys() - {each.name for each in parameters}
        if unknown:
            raise self.error(f"`{name}` has no parameter `{min(unknown)}`", name)
        listed: list[dict[str, Json]] = []
        for each in parameters:
            listed.append({"name": each.name, **({"type": types[each.name]} if each.name in types else {}),
                           **({} if each.default is each.empty else {"value": each.default}), **(marks.parameters.get(each.name) or {})})
        doc = inspect.getdoc(method)
        return {"name": name, **({"parameters": listed} if listed else {}), **({} if marks.result is None else {"result": marks.result}),
                "error": "any", **marks.flags, **({"doc": doc} if doc else {})}


def annotated_types(method: Callable[..., Any]) -> dict[str, str]:
    """The types of RSM of parameters that are annotated with one of Python's that has one."""
    names = {bool: "bool", int: "int", float: "number", str: "string"}
    try:
        hints = typing.get_type_hints(method)
    except (NameError, TypeError):  # of names that are known to type checkers alone
        return {}
    return {name: names[hint] for name, hint in hints.items() if hint in names}


def line_with(lines: list[str], name: str) -> int:
    """The number of the first line that has the name in quotes; 0: none has."""
    return next((number for number, line in enumerate(lines, 1) if name and re.search(rf"""["']{re.escape(name)}["']""", line)), 0)
