"""Valid bodies and messages: the files of api/examples, by schema, and what they lack; and what is made of them."""
import copy
import json
import re

from client import PROJECT
from interface import INTERFACE

# The last ones are those that a route takes without more ado: without a password, which is slow to hash, and of the first revision.
FOLDER = PROJECT / "api" / "examples"
MORE = {"force": [{"path": "Root", "scope": "par", "name": "last", "value": 3}], "core_live": [{"live": False}],
        "account_create": [{"name": "bea", "role": "observer"}],
        "component_request": [
            {"type": "result", "key": "db", "call": 7, "value": 1}, {"type": "reject", "key": "db", "call": 7},
            {"type": "event", "key": "db", "name": "x", "data": 1}, {"type": "log", "key": "db", "text": "x"},
            {"type": "subscribe", "key": "db", "service": "camera", "flow": "frame", "on": True}, {"type": "pong", "number": 1},
            {"type": "publish", "key": "db", "flow": "x", "time": 0.5, "header": {}}],
        "edit_request": [{"revision": 1, "author": "Ada", "operations": [{"op": "set", "id": "end", "field": "doc", "value": "x"}]}]}


def examples(schema):
    """The valid texts of a schema, parsed."""
    found = [json.loads(file.read_text()) for file in sorted(FOLDER.glob(f"{schema}.*.json"))] + MORE.get(schema, [])
    assert found, f"there is no example of {schema}"
    return found


def body_schemas():
    """(method, pattern) -> schema of each route of openapi.yaml that takes a body."""
    schemas = {}
    for pattern, methods in INTERFACE["paths"].items():
        for method, operation in methods.items():
            if method == "parameters" or "requestBody" not in operation:
                continue
            reference = operation["requestBody"]["content"]["application/json"]["schema"]["$ref"]
            schemas[method.upper(), pattern] = re.fullmatch(r"schemas/(\w+)\.json", reference)[1]
    return schemas


def leaves(value, path=()):
    """(path, value) of everything within that is no object and no list; a path is a tuple of keys and numbers."""
    if not isinstance(value, (dict, list)):
        yield path, value
        return
    for key, each in value.items() if isinstance(value, dict) else enumerate(value):
        yield from leaves(each, (*path, key))


def fields(value, path=()):
    """The paths of everything within an object or list, and the empty one of the whole."""
    yield path
    if isinstance(value, (dict, list)):
        for key, each in value.items() if isinstance(value, dict) else enumerate(value):
            yield from fields(each, (*path, key))


def with_value(whole, path, value):
    """A copy in which what is at the path is another value."""
    if not path:
        return value
    result = copy.deepcopy(whole)
    inner = result
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    return result


def fitting(schema):
    """The examples of a schema as the author and of the revision that are there: else nothing more of them is looked at."""
    there = {"author": "admin", "revision": 1}
    for example in examples(schema):
        fitting_one = example
        for path, _ in leaves(example):
            if path[-1] in there:
                fitting_one = with_value(fitting_one, path, there[path[-1]])
        yield fitting_one
