"""Words of dictionaries: what inputs are made of, and what has no place in them."""
import re

from seeds.messages import requests
from seeds.project import ROOT, objects, read
from seeds.texts import robots


def of_schemas(*names):
    """Keys and constants of schemas."""
    words = set()
    for name in names:
        for item in objects(read(ROOT / f"api/schemas/{name}.json")):
            properties = item.get("properties", {})
            words.update(properties if isinstance(properties, dict) else ())
            words.update(word for word in [*item.get("enum", []), item.get("const")] if isinstance(word, str))
    return words


def of_code():
    """Names and operators that the sources of the language have as texts; names of the target's state."""
    sources = "".join(path.read_text(encoding="utf-8") for path in sorted((ROOT / "core/language").rglob("*.cpp")))
    return set(re.findall(r'"([a-z_]{2,16}|[-+*/%<>=!:.&|^~@]{1,3})"', sources)) | {
        "par.a", "res.out", "res.x", "var.n", "chi.C.x", "port.p", "svc.t.data.x", "svc.t.op.result", "svc[x]",
        "f'{x:{y}}'", "\n    "}


def of_robots():
    return set(re.findall(r"<[a-z]+|[a-z]+=", "".join(robots()))) | {
        "<!--", "-->", "<?xml", "]]>", "<![CDATA[", "<!DOCTYPE", "&lt;", "&#x0;", "1e999", "nan"}


def of_requests():
    return set(re.findall(r"[A-Za-z-]+:|HTTP/1\.\d|[A-Z]{3,}", "".join(requests()))) | {
        "\r\n", "\r\n\r\n", "\n", "%00", "%2F", "%", "chunked", "[::1]:8080", "127.0.0.1:8080",
        "Content-Length: 0\r\n", "Content-Length: 18446744073709551616"}
