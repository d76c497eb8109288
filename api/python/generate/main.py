#!/usr/bin/env python3
"""generate/main.py [--check]: makes what race_client has from api/: messages.py, calls/ and plain/; the calls of ../typescript and of
../cpp/client; and the conversation of ../conversations that openapi.yaml says. With --check it writes nothing, names the files that are
not up to date, and ends with 1 if there are any. Needs python3-yaml."""
import sys
from pathlib import Path

import conversations
import cpp
import typescript
from calls import calls_text, snake
from messages import messages_text
from plain import plain_text
from routes import Route, all_routes, stream_path
from schemas import API

PACKAGE = Path(__file__).resolve().parents[1] / "race_client"
# What the client sends and reads on the stream; bodies and answers of REST come from openapi.yaml.
STREAM = ["problem.json", "core_delta.json", "stream_request.json#/$defs/subscribe_request", "stream_message.json#/$defs/envelope"]
WRITTEN_TWICE = "net.py"


def outputs() -> dict[Path, str]:
    """Every generated file, and what it must have."""
    routes = all_routes()
    modules = {name: [route for route in routes if route.module == name] for name in sorted({route.module for route in routes})}
    files = {**typescript.outputs(modules), **cpp.outputs(routes), **conversations.outputs(routes)}
    for name, group in modules.items():
        files[PACKAGE / "calls" / f"{name}.py"] = calls_text(name, group)
    files[PACKAGE / "calls" / "__init__.py"] = init_text(modules)
    addresses = [address for route in routes for address in (route.body, route.answer) if address]
    files[PACKAGE / "messages.py"] = messages_text([*dict.fromkeys([*addresses, *STREAM])])
    for path in sorted((PACKAGE / "aio").glob("*.py")):
        if path.name != WRITTEN_TWICE:
            files[PACKAGE / "plain" / path.name] = plain_text(path.name, path.read_text())
    return files


def init_text(modules: dict[str, list[Route]]) -> str:
    imports = [f"from .{name} import {', '.join(sorted(snake(route.operation_id) for route in group))}" for name, group in modules.items()]
    lines = []
    for line in imports:
        head, _, names = line.partition(" import ")
        lines += [f"{head} import (", *(f"    {name}," for name in names.split(", ")), ")"]
    names = sorted(snake(route.operation_id) for group in modules.values() for route in group)
    head = '"""All routes of the server, a function for each: what it sends and answers. Made by generate/main.py."""'
    listed = [f'    "{name}",' for name in ["STREAM_PATH", *names]]
    return "\n".join([head, *lines, "", f'STREAM_PATH = "{stream_path()}"', "", "__all__ = [", *listed, "]", ""])


def main() -> int:
    """Writes the files, or says which are not up to date."""
    only_check = sys.argv[1:] == ["--check"]
    wanted = outputs()
    kept = {PACKAGE / "plain" / WRITTEN_TWICE}
    there = {*(PACKAGE / "calls").glob("*.py"), *(PACKAGE / "plain").glob("*.py"), *typescript.CALLS.glob("*.ts")} - kept
    stale = [path for path, text in wanted.items() if not path.exists() or path.read_text() != text]
    surplus = sorted(there - wanted.keys())
    for path in [*stale, *surplus]:
        name = path.relative_to(API.parent)
        print(f"{name}: not up to date" if only_check else name)
    if not only_check:
        for path in stale:
            path.parent.mkdir(exist_ok=True)
            path.write_text(wanted[path])
        for path in surplus:
            path.unlink()
    return 1 if only_check and (stale or surplus) else 0


if __name__ == "__main__":
    sys.exit(main())
