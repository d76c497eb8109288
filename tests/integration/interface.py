"""api/openapi.yaml, against which answers are validated: statuses and schemas of a route, and the codes of the request filter."""
import re
from pathlib import Path

import yaml

API = Path(__file__).resolve().parents[2] / "api"
INTERFACE = yaml.safe_load((API / "openapi.yaml").read_text())
ROUTES = [(re.compile(re.sub(r"{\w+}", "[^/]+", path)), methods) for path, methods in INTERFACE["paths"].items()]


def responses(method, target):
    """Status -> response, as openapi.yaml lists them for a request; empty if there is no such route or method."""
    path = target.partition("?")[0]
    methods = next((methods for pattern, methods in ROUTES if pattern.fullmatch(path)), {})
    operation = methods.get("get" if method == "HEAD" else method.lower(), {"responses": {}})
    return {status: resolve(response) for status, response in operation["responses"].items()}


def resolve(response):
    if "$ref" not in response:
        return response
    return INTERFACE["components"]["responses"][response["$ref"].removeprefix("#/components/responses/")]


def check_listed(method, target, status, answer):
    """Asserts that openapi.yaml lists the status for the route, or the status and code for the request filter."""
    listed = responses(method, target)
    if str(status) in listed or (status == 404 and not listed):
        return
    codes = {error["code"] for error in answer.get("errors", [])} if isinstance(answer, dict) else set()
    allowed = set(INTERFACE["x-request-filter"].get(str(status), []))
    assert codes and codes <= allowed, f"openapi.yaml does not list {status} ({sorted(codes)}) of {method} {target}"


def schema_of(method, target, status):
    """The name of the schema of a JSON answer; None for another content type."""
    content = responses(method, target)[str(status)].get("content", {}).get("application/json")
    return content and re.fullmatch(r"schemas/(\w+)\.json", content["schema"]["$ref"]).group(1)
