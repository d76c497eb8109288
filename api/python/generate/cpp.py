"""The functions of all routes in C++: what one sends, without sending it; and, for the tests, the same by names and values of JSON."""
import re
import textwrap
from pathlib import Path

from calls import snake, wrapped
from routes import Route, kind_of
from schemas import API

CLIENT = API / "cpp" / "client"
BY_NAME = API.parent / "tests" / "client_cpp" / "calls_by_name.cpp"
KINDS = {"string": "std::string", "integer": "std::int64_t", "number": "double", "boolean": "bool"}
BORROWED = {"std::string": "std::string_view"}  # of a parameter by position
GIVEN = {"std::string": "text", "std::int64_t": "integer", "bool": "flag"}  # how the tests read one of a step
WIDTH = 120
HEADER = """\
// All routes of the server, a function for each: what it sends. Its comment says what Client::send() answers, and by
// status what refuses it; the request filter of the server may also refuse each. Made by api/python/generate/main.py.
// clang-format off
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "api/cpp/client/call.h"

namespace race::client::calls {
"""
SOURCE = """\
// Made by api/python/generate/main.py.
// clang-format off
#include "api/cpp/client/calls.h"

namespace race::client::calls {
"""
TABLE = """\
// The functions of calls.h by the names of their operations, for conversations. Made by api/python/generate/main.py.
// clang-format off
#include "tests/client_cpp/calls_by_name.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

#include "api/cpp/client/calls.h"

namespace race::client {
namespace {

struct NamedCall {
  std::string_view operation;
  Call (*call)(const Given& given);
};

constexpr NamedCall kCalls[] = {
"""
LOOK_UP = """\
};

}  // namespace

Call call_by_name(std::string_view operation, const Given& given) {
  const auto* const found = std::ranges::find(kCalls, operation, &NamedCall::operation);
  if (found == std::end(kCalls)) throw std::invalid_argument("no operation is named " + std::string(operation));
  return found->call(given);
}

}  // namespace race::client
"""


def name_of(name: str) -> str:
    """`putDocument` -> put_document, `If-Match` -> if_match; `from` is no keyword here."""
    return snake(name).removesuffix("_")


def options_type(route: Route) -> str:
    """Of the parameters that a caller may leave out."""
    return f"{route.operation_id[0].upper()}{route.operation_id[1:]}Options"


class Function:
    """What C++ needs to know of a route: its parameters by position, (name in the interface, type), and those of its options."""

    def __init__(self, route: Route) -> None:
        self.route, self.name = route, name_of(route.operation_id)
        named = route.named_parameters()
        self.first = [(each["name"], kind_of(each, KINDS))
                      for each in [*route.parameters["path"], *(each for each in named if each.get("required"))]]
        self.options = [(each["name"], kind_of(each, KINDS)) for each in named if not each.get("required")]

    def head(self, with_defaults: bool) -> str:
        """The declaration, without what ends it."""
        words = [f"{BORROWED.get(kind, kind)} {name_of(name)}" for name, kind in self.first]
        if self.route.body:
            words.append("const Value& body" if self.route.body_required
                         else "const std::optional<Value>& body" + (" = {}" if with_defaults else ""))
        if self.options:
            words.append(f"const {options_type(self.route)}& options" + (" = {}" if with_defaults else ""))
        return f"Call {self.name}({', '.join(words)})"

    def declaration(self) -> str:
        """In the header: its options, comment and head."""
        lines = []
        if self.options:
            lines += [f"struct {options_type(self.route)} {{",
                      *(f"  std::optional<{kind}> {name_of(name)} = {{}};" for name, kind in self.options), "};"]
        return "\n".join([*lines, *comment(self.route), *wrapped(f"{self.head(True)};", "(", WIDTH)]) + "\n"

    def definition(self) -> str:
        """In the source."""
        route = self.route
        parts = [f"segment({name_of(part[1:-1])})" if part.startswith("{") else f'"{part}"'
                 for part in re.split(r"({\w+})", route.path) if part]
        lines = [*wrapped(f"{self.head(False)} {{", "(", WIDTH),
                 f'  Call call{{.method = "{route.method.upper()}", .target = {" + ".join(parts)}}};']
        for where, function in (("query", "add_query"), ("header", "add_header")):
            for each in route.parameters[where]:
                value = name_of(each["name"]) if each.get("required") else f"options.{name_of(each['name'])}"
                lines.append(f'  {function}(call, "{each["name"]}", {value});')
        lines += [f'  add_header(call, "{header}", "{value}");' for header, value in route.headers.items()]
        lines += ["  call.body = body;"] if route.body else []
        lines += [] if route.answer else ["  call.is_text = true;"]
        return "\n".join([*lines, "  return call;", "}"]) + "\n"

    def row(self) -> str:
        """In the table of the tests."""
        words = [f'given.{GIVEN[kind]}("{name}")' for name, kind in self.first]
        if self.route.body:
            words.append("given.body()" if self.route.body_required else "given.body_if()")
        if self.options:
            fields = [f'.{name_of(name)} = given.{GIVEN[kind]}_if("{name}")' for name, kind in self.options]
            words.append(f"{{{', '.join(fields)}}}")
        head = f'    {{"{self.route.operation_id}", [](const Given&{" given" if words else ""}) {{'
        return "\n".join([head, *wrapped(f"       return calls::{self.name}({', '.join(words)});", "(", WIDTH), "     }},"]) + "\n"


def comment(route: Route) -> list[str]:
    """What stands above the declaration: what the route does, its body and answer, and what refuses it."""
    summary, *others = route.paragraphs(name_of)
    answer = f"Answers api/schemas/{route.answer}." if route.answer else "Answers a text."
    schemas = f"Body: api/schemas/{route.body}. {answer}" if route.body else answer
    lines: list[str] = []
    for text in (summary, schemas, *others):
        lines += ["", *textwrap.wrap(text, WIDTH - 4, break_long_words=False, break_on_hyphens=False)]
    return [f"/// {line}".rstrip() for line in lines[1:]]


def outputs(routes: list[Route]) -> dict[Path, str]:
    """Every generated file, and what it must have."""
    functions = [Function(route) for route in routes]
    end = "\n}  // namespace race::client::calls\n"
    return {CLIENT / "calls.h": HEADER + "".join(f"\n{each.declaration()}" for each in functions) + end,
            CLIENT / "calls.cpp": SOURCE + "".join(f"\n{each.definition()}" for each in functions) + end,
            BY_NAME: TABLE + "".join(each.row() for each in functions) + LOOK_UP}
