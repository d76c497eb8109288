"""The schemas of api/schemas, and the names that their types have in Python; names are as in web/generate."""
import json
import re
from pathlib import Path
from typing import Any

API = Path(__file__).resolve().parents[2]
SCHEMAS: dict[str, dict[str, Any]] = {path.name: json.loads(path.read_text()) for path in sorted((API / "schemas").glob("*.json"))}
# Types whose names are not those of their schemas, as there or in typing is something else of that name.
NAMES = {"samples.json": "RunSamples", "service.json": "Rsm", "state.json": "RunState", "type.json": "ValueType"}


def resolve(reference: str, base: str) -> str:
    """The address of what `reference` means in the file `base`: FILE, or FILE#POINTER for a part."""
    file, _, pointer = reference.removeprefix("schemas/").partition("#")
    return f"{file or base}#{pointer}" if pointer else file or base


def look_up(address: str) -> Any:
    """The schema at an address."""
    file, _, pointer = address.partition("#")
    found: Any = SCHEMAS[file]
    for key in pointer.split("/")[1:]:
        found = found[key]
    return found


def camel(words: str) -> str:
    return "".join(word[:1].upper() + word[1:] for word in re.split(r"[^A-Za-z0-9]+", words))


def type_name(address: str) -> str | None:
    """`core_delta.json` -> CoreDelta, `core.json#/$defs/fault` -> Fault; None for a part that is no definition."""
    if address in NAMES:
        return NAMES[address]
    match = re.fullmatch(r"(\w+)\.json", address) or re.fullmatch(r"\w+\.json#/\$defs/(\w+)", address)
    return camel(match.group(1)) if match else None
