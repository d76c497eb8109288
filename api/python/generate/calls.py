"""The functions of all routes in Python: what one sends, and what it answers, without sending it."""
import keyword
import re
import textwrap

from routes import Route, kind_of
from schemas import type_name

KINDS = {"string": "str", "integer": "int", "number": "float", "boolean": "bool"}
WIDTH = 130


def snake(name: str) -> str:
    """`putDocument` -> put_document, `If-Match` -> if_match, `from` -> from_."""
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).replace("-", "_").lower()
    return f"{words}_" if keyword.iskeyword(words) else words


def arguments(route: Route) -> tuple[list[str], list[str]]:
    """Of the function: by position, and by name."""
    first = [f"{snake(each['name'])}: {kind_of(each, KINDS)}" for each in route.parameters["path"]]
    if route.body:
        first.append(f"body: {type_name(route.body)}" + ("" if route.body_required else " | None = None"))
    named = [f"{snake(each['name'])}: {kind_of(each, KINDS)}" + ("" if each.get("required") else " | None = None")
             for each in route.named_parameters()]
    return first, named


def function_text(route: Route) -> str:
    """The function of a route."""
    first, named = arguments(route)
    answer = type_name(route.answer) if route.answer else "str"
    head = f"def {snake(route.operation_id)}({', '.join([*first, *(['*', *named] if named else [])])}) -> Call[{answer}]:"
    target = re.sub(r"{(\w+)}", lambda name: f"{{segment({snake(name.group(1))})}}", route.path)
    words = [f'"{route.method.upper()}"', f'{"f" if "{" in target else ""}"{target}"']
    for where, name, fixed in (("query", "query", {}), ("header", "headers", route.headers)):
        pairs = [f'"{each["name"]}": {snake(each["name"])}' for each in route.parameters[where]]
        pairs += [f'"{header}": "{value}"' for header, value in fixed.items()]
        if pairs:
            words.append(f"{name}={{{', '.join(pairs)}}}")
    if route.body:
        words.append("body=body")
    if not route.answer:
        words.append('answers="text"')
    return "\n".join([*wrapped(head, "("), *docstring(route), *wrapped(f"    return Call({', '.join(words)})", "(")])


def docstring(route: Route) -> list[str]:
    """Of the function of a route."""
    lines = []
    for text in route.paragraphs(snake):
        lines += ["", *textwrap.wrap(text, WIDTH - 4, break_long_words=False, break_on_hyphens=False)]
    quotes = 'r"""' if any("\\" in line for line in lines) else '"""'
    lines = [f"    {line}".rstrip() for line in lines[1:]]
    lines[0] = f"    {quotes}{lines[0].strip()}"
    return [*lines, '    """'] if len(lines) > 1 else [lines[0] + '"""']


def wrapped(line: str, bracket: str, width: int = WIDTH) -> list[str]:
    """A long line, broken behind commas and indented below its first bracket."""
    indent = " " * (line.index(bracket) + 1)
    lines = [line]
    while len(lines[-1]) > width and (at := lines[-1].rfind(", ", 0, width - 1)) > len(indent):
        lines[-1:] = [lines[-1][: at + 1], indent + lines[-1][at + 2 :]]
    return lines


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
    return "\n".join(head) + "\n" + "".join(f"\n\n{function_text(route)}\n" for route in routes)
