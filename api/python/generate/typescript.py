"""The functions of all routes in TypeScript: what one sends, and the validator of what it answers, without sending it.

Types and validators are not made here: web/generate makes them of the schemas that MESSAGES lists.
"""
import json
import re
import textwrap
from pathlib import Path

from routes import Route, kind_of, stream_path
from schemas import API, type_name

CALLS = API / "typescript" / "src" / "calls"
MESSAGES = API / "typescript" / "messages.json"
KINDS = {"string": "string", "integer": "number", "number": "number", "boolean": "boolean"}
WIDTH = 130


def camel(name: str) -> str:
    """`If-Match` -> ifMatch."""
    first, *others = name.split("-")
    return first[:1].lower() + first[1:] + "".join(others)


def type_of(address: str) -> str:
    """The type of a body or answer, as web/generate names it."""
    name = type_name(address)
    if name is None:
        raise ValueError(f"{address} has no name")
    return name


def parameters(route: Route) -> list[str]:
    """Of the function: by position, and in the end an object of those with names."""
    words = [f"{camel(each['name'])}: {kind_of(each, KINDS)}" for each in route.parameters["path"]]
    if route.body:
        words.append(f"body{'' if route.body_required else '?'}: Body<{type_of(route.body)}>")
    named = route.named_parameters()
    if named:
        fields = [f"readonly {camel(each['name'])}{'' if each.get('required') else '?'}: {kind_of(each, KINDS)}"
                  + ("" if each.get("required") else " | undefined") for each in named]
        is_required = any(each.get("required") for each in named)
        words.append(f"options: {{ {'; '.join(fields)} }}" + ("" if is_required else " = {}"))
    return words


def fields_of(route: Route) -> list[str]:
    """Of the call that the function returns."""
    target = re.sub(r"{(\w+)}", lambda name: f"${{segment({camel(name.group(1))})}}", route.path)
    fields = [f'method: "{route.method.upper()}"', f"path: `{target}`" if "$" in target else f'path: "{target}"']
    query = [f"{camel(each['name'])}: options.{camel(each['name'])}" for each in route.parameters["query"]]
    headers = [f"\"{each['name']}\": options.{camel(each['name'])}" for each in route.parameters["header"]]
    headers += [f'"{header}": "{value}"' for header, value in route.headers.items()]
    fields += [f"{name}: {{ {', '.join(pairs)} }}" for name, pairs in (("query", query), ("headers", headers)) if pairs]
    if route.body:
        fields.append("body")
    answer = type_of(route.answer) if route.answer else ""
    return [*fields, f"answer: schema.{answer[0].lower()}{answer[1:]}" if answer else 'answer: "text"']


def function_text(route: Route) -> str:
    """The function of a route; on several lines if it is too long for one."""
    fields = fields_of(route)
    head, words, result = f"export const {route.operation_id} = (", parameters(route), type_of(route.answer) if route.answer else "string"
    line = f"{head}{', '.join(words)}): Call<{result}> => ({{"
    if len(line) > WIDTH:
        line = head + "".join(f"\n  {word}," for word in words) + f"\n): Call<{result}> => ({{"
    whole = f"{line} {', '.join(fields)} }});"
    if len(whole) > WIDTH or "\n" in whole:
        whole = line + "".join(f"\n  {field}," for field in fields) + "\n});"
    return f"{comment(route)}\n{whole}\n"


def comment(route: Route) -> str:
    """What stands above the function of a route."""
    lines = []
    for text in route.paragraphs(camel):
        lines += ["", *textwrap.wrap(text.replace("*/", "*\\/"), WIDTH - 3, break_long_words=False, break_on_hyphens=False)]
    return "\n".join(["/**", *(f" * {line}".rstrip() for line in lines[1:]), " */"])


def calls_text(module: str, routes: list[Route]) -> str:
    """The module with the functions of these routes."""
    types = sorted({type_of(address) for route in routes for address in (route.body, route.answer) if address})
    names = ["segment"] if any(route.parameters["path"] for route in routes) else []
    names += ["type Body"] if any(route.body for route in routes) else []
    lines = [f"// Routes of api/openapi.yaml: {module}. Made by api/python/generate/main.py. The request filter may also refuse each.",
             f'import {{ {", ".join([*names, "type Call"])} }} from "../call.js";']
    if types:
        lines.append(f'import type {{ {", ".join(types)} }} from "../generated/messages.js";')
    if any(route.answer for route in routes):
        lines.append('import * as schema from "../generated/validators.js";')
    return "\n".join(lines) + "\n" + "".join(f"\n{function_text(route)}" for route in routes)


def index_text(modules: list[str]) -> str:
    """The module with the functions of all routes."""
    lines = ["// All routes of the server, a function for each: what it sends and answers. Made by api/python/generate/main.py.",
             *(f'export * from "./{name}.js";' for name in modules), "", f'export const kStreamPath = "{stream_path()}";', ""]
    return "\n".join(lines)


def messages_text(routes: list[Route]) -> str:
    """The schemas of all answers and bodies."""
    read, written = sorted({each.answer for each in routes if each.answer}), sorted({each.body for each in routes if each.body})
    about = "Schemas of what the routes of openapi.yaml answer (read) and are sent (written). Made by api/python/generate/main.py."
    return json.dumps({"about": about, "read": read, "written": written}, indent=2) + "\n"


def outputs(modules: dict[str, list[Route]]) -> dict[Path, str]:
    """Every generated file, and what it must have."""
    files = {CALLS / f"{name}.ts": calls_text(name, group) for name, group in modules.items()}
    files[CALLS / "index.ts"] = index_text([*modules])
    files[MESSAGES] = messages_text([route for group in modules.values() for route in group])
    return files
