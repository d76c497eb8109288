"""Values and patterns of api/conversations (its README says what they mean)."""
import json
import re

from client import PROJECT

API = PROJECT / "api"
FOLDER = API / "conversations"


class Values(dict):
    """What was saved; else a task, or an example of api/examples, by its name."""

    def __missing__(self, name):
        file = next(path for path in (FOLDER / "tasks" / f"{name}.json", API / "examples" / f"{name}.json") if path.exists())
        self[name] = json.loads(file.read_text())
        return self[name]


def value_of(given, saved):
    """What is given in a step, with what its names mean."""
    if isinstance(given, str) and given.startswith("$"):
        return saved[given[1:]]
    if isinstance(given, list):
        return [value_of(each, saved) for each in given]
    if not isinstance(given, dict):
        return given
    if "$change" in given:
        return changed(value_of(given["$change"], saved), value_of(given["set"], saved))
    return {key: value_of(each, saved) for key, each in given.items()}


def at(value, pointer):
    """The part of a value at a JSON pointer; -1 is the last of a list."""
    for key in pointer.split("/")[1:]:
        value = value[int(key)] if isinstance(value, list) else value[key]
    return value


def changed(value, changes):
    """A copy with other values at these pointers."""
    copy = json.loads(json.dumps(value))
    for pointer, new in changes.items():
        before, _, key = pointer.rpartition("/")
        holder = at(copy, before)
        holder[int(key) if isinstance(holder, list) else key] = new
    return copy


def same(one, other):
    """Whether two JSON values are equal; true is not 1."""
    if isinstance(one, bool) or isinstance(other, bool):
        return one is other
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    return one == other


def fits(pattern, value, saved):
    return mismatch(pattern, value, saved) is None


def in_order(patterns, value, saved):
    elements = iter(value)
    return all(any(fits(pattern, each, saved) for each in elements) for pattern in patterns)


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


OPERATORS = {
    "$equals": lambda given, value, saved: same(value_of(given, saved), value),
    "$contains": lambda given, value, saved: isinstance(value, list) and any(fits(given, each, saved) for each in value),
    "$each": lambda given, value, saved: isinstance(value, list) and value != [] and all(fits(given, each, saved) for each in value),
    "$ordered": lambda given, value, saved: isinstance(value, list) and in_order(given, value, saved),
    "$size": lambda given, value, saved: isinstance(value, list) and len(value) == value_of(given, saved),
    "$matches": lambda given, value, saved: isinstance(value, str) and re.search(given, value) is not None,
    "$least": lambda given, value, saved: is_number(value) and value >= given,
}
ABSENT = {"$absent": True}


def shown(value):
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) < 400 else text[:400] + "..."


def first(reasons):
    return next((reason for reason in reasons if reason is not None), None)


def mismatch(pattern, value, saved, path=""):
    """Why a value does not fit a pattern, and where; None: it does."""
    if isinstance(pattern, str) and pattern.startswith("$"):
        pattern = {"$equals": pattern}
    name = next(iter(pattern)) if isinstance(pattern, dict) and len(pattern) == 1 else ""
    if name == "$all":
        return first(mismatch(each, value, saved, path) for each in pattern[name])
    if name in OPERATORS:
        holds = OPERATORS[name](pattern[name], value, saved)
    elif isinstance(pattern, dict) and isinstance(value, dict):
        return first(mismatch_of_field(wanted, key, value, saved, path) for key, wanted in pattern.items())
    elif isinstance(pattern, list) and isinstance(value, list) and len(pattern) == len(value):
        return first(mismatch(wanted, each, saved, f"{path}/{i}") for i, (wanted, each) in enumerate(zip(pattern, value, strict=True)))
    else:
        holds = not isinstance(pattern, (dict, list)) and same(pattern, value)
    return None if holds else f"{path or '/'}: {shown(value)} does not fit {shown(pattern)}"


def mismatch_of_field(pattern, key, value, saved, path):
    if pattern == ABSENT:
        return f"{path}/{key} is there" if key in value else None
    return mismatch(pattern, value[key], saved, f"{path}/{key}") if key in value else f"{path}/{key} is not there"
