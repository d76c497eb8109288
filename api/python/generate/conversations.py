"""The conversation of what is not there: each route that can answer 404, asked at a new server, which has nothing."""
import json
import re
from pathlib import Path
from typing import Any

from routes import Route, component
from schemas import API

FOLDER = API / "conversations"
EXAMPLES = API / "examples"
FILE = FOLDER / "nothing.json"
# Parts of paths, by their names, that nothing has; a server without a cell has no files of one.
NAMES = {"digest": "0" * 64, "file": "nothing.urdf", "id": "987654", "name": "nothing", "number": 1, "revision": 1, "run": "987654",
         "service": "nobody"}
NAMES_OF = {"backups": {"name": "20200101T000000.000Z"}}
# What a route wants to be asked, beside what it requires.
QUERIES = {"getWhy": {"port": "Root.done"}, "getRunWhy": {"port": "Root.done"}}
REQUIRED = {"author": "Ada", "step": 1, "with": "987655"}
# A token that has ended meanwhile is not there, but no conversation has that moment.
NEVER = {"logOut"}
# Bodies of which api/examples has none.
BODIES: dict[str, Any] = {"core_live.json": {"live": True}, "force.json": {"path": "Root", "scope": "var", "name": "n", "value": 1}}


def is_asked(route: Route) -> bool:
    """Whether it says at once that there is nothing."""
    return "404" in route.operation["responses"] and not route.is_deferred and route.operation_id not in NEVER


def example(address: str) -> Any:
    """A body: the first example of its schema."""
    name = address.removesuffix(".json")
    return BODIES.get(address) or json.loads(min(EXAMPLES.glob(f"{name}.*.json")).read_text())


def step(route: Route) -> dict[str, Any]:
    """Asks for it, and says what refuses that."""
    names = {**NAMES, **NAMES_OF.get(route.module, {})}
    asked: dict[str, Any] = {"call": route.operation_id}
    if route.parameters["path"]:
        asked["path"] = {each["name"]: names[each["name"]] for each in route.parameters["path"]}
    query = {each["name"]: REQUIRED[each["name"]] for each in route.parameters["query"] if each.get("required")}
    if query | QUERIES.get(route.operation_id, {}):
        asked["query"] = query | QUERIES.get(route.operation_id, {})
    if route.body:
        asked["body"] = example(route.body) if route.body_required else None
    description = component(route.operation["responses"]["404"])["description"]
    code = re.search(r"`(\w+)`", description)
    return {**asked, "refused": {"status": 404, **({"code": code.group(1)} if code else {})}}


def outputs(routes: list[Route]) -> dict[Path, str]:
    """The file of the conversation."""
    steps = [step(route) for route in routes if is_asked(route)]
    text = {"about": "What is not there. Made of openapi.yaml by api/python/generate/main.py.",
            "conversations": [{"title": "what is not there is refused by each route that names something", "steps": steps}]}
    return {FILE: json.dumps(text, indent=1, ensure_ascii=False) + "\n"}
