"""Where a string of an attacker goes in: each parameter of each route of openapi.yaml, and each string of its body."""
import json
import random
import re
import urllib.parse
from dataclasses import dataclass

from body_examples import body_schemas, fitting, leaves, with_value
from interface import INTERFACE

MOST_LEAVES = 10  # of the strings of the bodies of a route; others are sampled
MARK = "@MARK@"
UNKNOWN = "no_such_parameter"
PAGES = ("GET", "/{page}")  # not in openapi.yaml: the files of --web


@dataclass(frozen=True)
class Place:
    method: str
    pattern: str
    kind: str  # path, query, body, or field: the name of one more field of the body
    name: str
    body: bytes | None = None  # with MARK in it, if the place is there

    def __str__(self):
        return f"{self.method} {self.pattern} {self.kind} {self.name}"

    @property
    def is_costly(self):
        """A password is hashed, which takes 0.1 s."""
        return self.pattern == "/api/v1/accounts" and self.name == "password"

    def request(self, known, string):
        """(target, body) with the string at this place. `known`: parameter of a path -> value that is there."""
        path = re.sub(r"\{(\w+)\}", lambda found: self.part(found[1], known, string), self.pattern).encode("latin-1")
        query = {name: value.encode() for name, value in needed(self.method, self.pattern, known).items() if name != self.name}
        if self.kind == "query":
            query[self.name] = string
        pairs = b"&".join(name.encode() + b"=" + in_target(value) for name, value in query.items())
        mark = json.dumps(MARK).encode()
        return path + (b"?" + pairs if pairs else b""), self.body and self.body.replace(mark, in_json(string))

    def part(self, name, known, string):
        return (in_target(string) if (self.kind, self.name) == ("path", name) else known(self.pattern, name).encode()).decode("latin-1")


def in_target(string):
    """As it is, if a path may have it; else percent-encoded."""
    if re.fullmatch(rb"[!-\"$-~]+", string):
        return string
    return urllib.parse.quote_from_bytes(string, safe="").encode()


def in_json(string):
    """In quotation marks; what is no UTF-8 stays so."""
    escape = lambda found: b"\\u%04x" % found[0][0]
    return b'"' + re.sub(rb'[\x00-\x1f"\\]', escape, string) + b'"'


def parameters(method, pattern, where):
    """Name -> whether it is needed."""
    methods = INTERFACE["paths"].get(pattern, {})
    listed = methods.get("parameters", []) + methods.get(method.lower(), {}).get("parameters", [])
    listed = [INTERFACE["components"]["parameters"][each["$ref"].rpartition("/")[2]] if "$ref" in each else each for each in listed]
    return {each["name"]: each.get("required", False) for each in listed if each["in"] == where}


def needed(method, pattern, known):
    """The parameters of a query without which a route looks at nothing else, and their values."""
    return {name: known(pattern, name) for name, required in parameters(method, pattern, "query").items() if required}


def bodies(schema, seed):
    """(name, body with MARK) for each string of the examples of a schema, or a sample of them; and for a field's name."""
    found = {}
    for example in fitting(schema):
        for path, value in leaves(example):
            if isinstance(value, str):
                found["/".join(map(str, path))] = json.dumps(with_value(example, path, MARK)).encode()
    chosen = list(found.items())
    if len(chosen) > MOST_LEAVES:
        chosen = random.Random(seed).sample(chosen, MOST_LEAVES)
    yield from (("body", *each) for each in chosen)
    yield "field", "", json.dumps({**next(fitting(schema)), MARK: 1}).encode()


def places(seed):
    """Route (method, pattern) -> its places. Each route has one more parameter in its query, which it does not know."""
    found = {PAGES: [Place(*PAGES, "path", "page")]}
    schemas = body_schemas()
    for pattern, methods in INTERFACE["paths"].items():
        for method in (each.upper() for each in methods if each != "parameters"):
            route = method, pattern
            body = json.dumps(next(fitting(schemas[route]))).encode() if route in schemas else None
            found[route] = [Place(*route, "path", name, body) for name in re.findall(r"\{(\w+)\}", pattern)]
            found[route] += [Place(*route, "query", name, body) for name in [*parameters(*route, "query"), UNKNOWN]]
            if body:
                found[route] += [Place(*route, kind, name, text) for kind, name, text in bodies(schemas[route], seed)]
    found["GET", "/api/v1/stream"].append(Place("GET", "/api/v1/stream", "query", "ticket"))
    return found
