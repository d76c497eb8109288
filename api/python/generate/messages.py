"""Python types of messages: a TypedDict for each object of api/schemas, an alias for all else that has a name."""
import keyword
import re
import textwrap
from typing import Any

from schemas import camel, look_up, resolve, type_name

HEADER = '''"""Types of all messages: bodies and answers of REST, and the stream. Made from api/schemas by generate/main.py.

Meaning, units and ranges of each field stand in the schema that the type names. Fields that a newer server adds are there, too.
"""
from __future__ import annotations

from typing import Any, Literal, NotRequired, Required, TypeAlias, TypedDict

Json: TypeAlias = Any  # null, bool, int, float, str, list or dict; its user knows which
'''
WIDTH = 136
SIMPLE = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "null": "None"}


class Types:
    """Collects the types that are asked for, and all that these refer to."""

    def __init__(self) -> None:
        self.texts: dict[str, str] = {}
        self.addresses: dict[str, str] = {}

    def refer(self, address: str) -> str:
        """The Python type of the schema at `address`."""
        name = type_name(address)
        base = address.partition("#")[0]
        if name is None:
            return self.type_of(look_up(address), base, camel(address.rpartition("/")[2]))
        if self.addresses.setdefault(name, address) != address:
            raise ValueError(f"{self.addresses[name]} and {address} are both named {name}")
        if name not in self.texts:
            self.texts[name] = ""  # it may refer to itself
            self.define(name, look_up(address), base, f"api/schemas/{address}")
        return name

    def define(self, name: str, schema: Any, base: str, source: str) -> None:
        """Gives a schema a name."""
        schema = self.merged(schema, base)
        if self.is_record(schema):
            self.texts[name] = self.record(name, schema, base, source)
        else:
            self.texts[name] = f"# {source}\n{name}: TypeAlias = {quoted(self.type_of(schema, base, name), len(name) + 14)}"

    def merged(self, schema: Any, base: str) -> Any:
        """With the properties of what it refers to beside others, such as the envelope of a message."""
        if not isinstance(schema, dict) or "$ref" not in schema or not ({"properties", "required"} & schema.keys()):
            return schema
        address = resolve(schema["$ref"], base)
        other = self.merged(look_up(address), address.partition("#")[0])
        if address.partition("#")[0] != base:
            other = {**other, "properties": {key: absolute(value, address.partition("#")[0])
                                             for key, value in other.get("properties", {}).items()}}
        return {**other, **{key: value for key, value in schema.items() if key != "$ref"},
                "properties": {**other.get("properties", {}), **schema.get("properties", {})},
                "required": [*other.get("required", []), *schema.get("required", [])]}

    @staticmethod
    def is_record(schema: Any) -> bool:
        return isinstance(schema, dict) and "properties" in schema

    def record(self, name: str, schema: Any, base: str, source: str) -> str:
        """The text of a TypedDict; by its function if a field is a word of Python."""
        required = set(schema.get("required", []))
        fields = {key: self.type_of(value, base, name + camel(key)) for key, value in schema["properties"].items()}
        if any(keyword.iskeyword(key) or not key.isidentifier() for key in fields):
            lines = [f'    "{key}": {quoted(("Required" if key in required else "NotRequired") + f"[{value}]", len(key) + 8)},'
                     for key, value in fields.items()]
            return "\n".join([f"# {source}", f'{name} = TypedDict("{name}", {{', *lines, "})"])
        lines = [f"    {key}: {value_text(key in required, value, len(key) + 6)}" for key, value in fields.items()]
        return "\n".join([f"class {name}(TypedDict):", f'    """{source}"""', *lines])

    def type_of(self, schema: Any, base: str, name: str) -> str:
        """The type of a schema that has no name of its own; `name` is for a record within it."""
        if schema is True:
            return "Json"
        schema = self.merged(schema, base)
        if "$ref" in schema:
            return self.refer(resolve(schema["$ref"], base))
        if "const" in schema:
            return literal([schema["const"]])
        if "enum" in schema:
            return literal(schema["enum"])
        if self.is_record(schema):
            self.define(name, schema, base, f"a part of api/schemas/{base}")
            return name
        for key in ("oneOf", "anyOf"):
            if key in schema and not all(set(each) <= {"required"} for each in schema[key]):
                return union(self.type_of(each, base, name + self.distinction(each, number)) for number, each in enumerate(schema[key]))
        return self.by_kind(schema, base, name)

    def by_kind(self, schema: Any, base: str, name: str) -> str:
        kind = schema.get("type")
        if isinstance(kind, list):
            return union(self.by_kind({**schema, "type": each}, base, name) for each in kind)
        if kind == "array":
            return f"list[{self.type_of(schema.get('items', True), base, name + 'Item')}]"
        if kind == "object":
            return f"dict[str, {self.type_of(schema.get('additionalProperties') or True, base, name + 'Value')}]"
        return SIMPLE.get(kind, "Json")

    @staticmethod
    def distinction(schema: Any, number: int) -> str:
        """What tells an alternative apart: the constant that it has, or its required fields."""
        if not isinstance(schema, dict):
            return str(number)
        constants = [value["const"] for value in schema.get("properties", {}).values() if isinstance(value, dict) and "const" in value]
        words = constants[:1] if constants and isinstance(constants[0], str) else schema.get("required", [])
        return camel("_".join(words)) or str(number)


def absolute(schema: Any, file: str) -> Any:
    """A copy of a schema of `file` whose references hold in any file."""
    if isinstance(schema, list):
        return [absolute(each, file) for each in schema]
    if not isinstance(schema, dict):
        return schema
    return {key: resolve(value, file) if key == "$ref" else absolute(value, file) for key, value in schema.items()}


def literal(values: list[Any]) -> str:
    return f"Literal[{', '.join(map(repr, values))}]"


def union(types: Any) -> str:
    """Alternatives, each once; with `Json` among them it is that."""
    found = sorted(dict.fromkeys(types), key=lambda each: each == "None")
    return "Json" if "Json" in found else " | ".join(found)


def quoted(text: str, before: int = 0) -> str:
    """As a text of Python; on several lines if it is too long for the rest of one, behind `before` characters."""
    text = text.replace("\\", "\\\\").replace('"', '\\"')
    if before + len(text) < WIDTH:
        return f'"{text}"'
    pieces = [""]
    for word in re.split(r"(?<= )", text):
        if len(pieces[-1]) + len(word) > WIDTH - 20:
            pieces.append("")
        pieces[-1] += word
    return "(\n" + "".join(f'        "{piece}"\n' for piece in pieces) + "    )"


def value_text(is_required: bool, value: str, before: int) -> str:
    """The type of a field; on several lines if it is too long for the rest of one, behind `before` characters."""
    text = value if is_required else f"NotRequired[{value}]"
    if before + len(text) < WIDTH:
        return text
    lines = textwrap.wrap(text, WIDTH - 10, break_long_words=False, break_on_hyphens=False)
    return "(\n" + "".join(f"        {line}\n" for line in lines) + "    )"


def messages_text(addresses: list[str]) -> str:
    """The module with the types of the messages at `addresses`, by name."""
    types = Types()
    for address in addresses:
        types.refer(address)
    return HEADER + "".join(f"\n\n{text}\n" if text.startswith("class") else f"\n{text}\n" for _, text in sorted(types.texts.items()))
