"""Texts made of a valid one that are no JSON within the limits, and values that are none of its schema: invalid by construction."""
import copy
import json
import random

from body_examples import fields, with_value
from client import validator

TRUNCATIONS = 40  # of a text, at most
# As the value of one more field.
NO_VALUES = (
    b"NaN", b"-NaN", b"Infinity", b"-Infinity", b"inf", b"+1", b".5", b"1.", b"01", b"-01", b"-", b"--1", b"0x10", b"1e", b"1e+",
    b"1_000", b"\xef\xbc\x92", b"1,5", b"True", b"None", b"nil", b"undefined", b"TRUE", b"nul", b"truefalse", b"'x'", b"`x`", b"x", b"@",
    b"/x/", b"(1)", b"<x>", b"1 2", b"[1,]", b"[,1]", b"[,]", b"[1,,2]", b"[1;2]", b"[1 2]", b"[1", b"1]", b"{\"a\"}", b"{\"a\":}",
    b"{\"a\" 1}", b"{\"a\":1,}", b"{a:1}", b"{'a':1}", b"{1:1}", b"{null:1}", b"{,}", b"{\"a\":1 \"b\":2}", b"{\"a\":1;\"b\":2}",
    b"{\"a\"=1}", b"{[]:1}", b"{\"a\":1", b"{\"a\":1]")
BAD_STRINGS = (
    b"\\ud800", b"\\udc00", b"\\ud800\\ud800", b"\\udc00\\ud800", b"\\ud800x", b"\\uD800\\u0041", b"\\udbff", b"\\udfff\\udfff", b"\\x41",
    b"\\u12", b"\\uXYZW", b"\\u{41}", b"\\", b"\\0", b"\\a", b"\\'", b"\n", b"\r", b"\t", b"\0", b"\x01", b"\x1f", b"\xff", b"\xfe\xff",
    b"\x80", b"\xc3", b"\xc3\x28", b"\xe2\x82", b"\xe2\x28\xa1", b"\xf0\x9f\xa4", b"\xc0\xaf", b"\xc1\xbf", b"\xe0\x80\xaf",
    b"\xf0\x80\x80\xaf", b"\xed\xa0\x80", b"\xed\xa0\x80\xed\xb0\x80", b"\xf4\x90\x80\x80", b"\xf5\x80\x80\x80", b"\xf8\x88\x80\x80\x80",
    b"\xe9")
OUT_OF_RANGE = (
    b"1e999", b"-1e999", b"1e309", b"9223372036854775808", b"-9223372036854775809", b"18446744073709551616", b"1" + b"0" * 400,
    b"1" * 100000, b"1e99999999999999999999")
AFTER = (
    b",", b"}", b"]", b"{}", b"[]", b"1", b"null", b'"', b";", b":", b"x", b"\0", b"\0{}", b"\x0c", b"\x1a", b"\xff", b"//", b"# x",
    b"/* x */", b"\xef\xbb\xbf", b"\n---\n", b"\x1e{}")
BEFORE = (
    b",", b"{", b"[", b"}", b"//\n", b"/* x */", b"# x\n", b"<!-- -->", b")]}',\n", b"while(1);", b"x=", b"callback(", b"\0", b"\x1e",
    b"\x0b", b"\xa0", b"\xc2\xa0", b"\xff\xfe", b"\xef\xbb", b"\xef\xbb\xbf\xef\xbb\xbf", b"-", b"json ")
# In place of a field: what a wrong type may be, a small one and one that is hard to hold.
WRONG = (
    None, True, False, 0, 1, -1, 1.5, 1e308, 2**63 - 1, "", "x", "\0", "x" * 2000, [], {}, [[]], [None], {"": None}, {"x": {"x": {}}},
    [0] * 300)
KEYS = (
    "__proto__", "constructor", "prototype", "toString", "", "\0", " ", "$ref", "$schema", "x" * 1000, "\u202e", "rcm ", "Type", "op",
    "hasOwnProperty")


def within(text, field):
    """The text of an object with one more field."""
    return text[:-1].rstrip() + (b"" if text[1:-1].strip() == b"" else b", ") + field + b"}"


def nested(levels, before, inner, after):
    return before * levels + inner + after * levels


def truncated(text):
    """Beginnings of an object: none of them is whole. The empty one is left out: some bodies may be absent."""
    step = max(1, len(text) // TRUNCATIONS)
    return [text[:end] for end in range(1, len(text), step)]


def too_deep(text, depth):
    """Deeper than so many levels: by one, by far, with an end and without one."""
    lists = [nested(levels, b"[", b"", b"]") for levels in (depth, depth + 1, 10 * depth, 100_000)]
    objects = [nested(levels, b'{"a":', b"1", b"}") for levels in (depth, depth + 1, 10 * depth)]
    endless = [b"[" * 100_000, b'{"a":' * 20_000, b'[{"a":' * 9_000]
    return [*(within(text, b'"x": ' + each) for each in lists + objects), lists[1], objects[1], *endless]


def duplicated(value):
    """Each key of the object twice: as it is, and with another value, before and after."""
    pairs = [(json.dumps(key).encode(), json.dumps(each).encode()) for key, each in value.items()]
    text = json.dumps(value).encode()
    twice = [within(text, key + b": " + each) for key, each in pairs] + [within(text, key + b": null") for key, _ in pairs]
    return [*twice, within(text, b'"x": {"a": 1, "a": 2}'), within(text, b'"x": 1, "x": 1'), within(text, b'"x": 1, "\\u0078": 1')]


def misspelt(text):
    """Some signs of it are others, or in another order."""
    once = [text.replace(sign, other, 1) for sign, other in ((b"{", b"{,"), (b":", b"="), (b":", b"::"), (b"{", b""))]
    always = [text.replace(sign, other) for sign, other in ((b"}", b",}"), (b'"', b"'"), (b'"', b""), (b'"', b"\xe2\x80\x9c"))]
    return [*once, *always, b"{" + text + b"}", text[::-1]]


def foreign(text):
    """What is no UTF-8 without a mark, or another language."""
    coded = [text.decode().encode(code) for code in ("utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-7")]
    packed = [b"\xef\xbb\xbf" + text[:-1], b"\x1f\x8b\x08" + text, json.dumps(text.decode()).encode()[:-1]]
    return [*coded, *packed, b"\0" * 50, b"\xff" * 50, b"type=x&document=y", b"<xml/>", b"'", b'"', b"nul", b"{]", b"[}", b"]", b","]


def no_json(value, depth=64):
    """What is no JSON, made of an object that is valid, and what is beyond the limits. Each text once."""
    text = json.dumps(value).encode()
    quoted = [b'"' + each + b'"' for each in BAD_STRINGS]
    texts = [*truncated(text), *(text + each for each in AFTER), *(each + text for each in BEFORE), *duplicated(value)]
    texts += [*too_deep(text, depth), *misspelt(text), *foreign(text)]
    texts += [within(text, b'"x": ' + each) for each in (*NO_VALUES, *quoted, *OUT_OF_RANGE)]
    texts += [within(text, each + b": 1") for each in quoted]
    return [each for each in dict.fromkeys(texts) if not is_json(each, depth)]


def is_json(text, depth):
    """Whether Python takes it for JSON within the limits, as the server must: a mutation that happens to be none is left out."""
    def once(pairs):
        if len(dict(pairs)) < len(pairs):
            raise ValueError("twice")
        return dict(pairs)

    def number(digits):
        if not -(2**63) <= int(digits) < 2**63:
            raise ValueError(digits)
        return int(digits)

    def constant(name):
        raise ValueError(name)

    def finite(digits):
        if abs(float(digits)) == float("inf"):
            raise ValueError(digits)
        return float(digits)

    try:
        value = json.loads(text.decode(), object_pairs_hook=once, parse_int=number, parse_float=finite, parse_constant=constant)
        json.dumps(value, ensure_ascii=False).encode()
        return deep(value) <= depth
    except (ValueError, RecursionError):
        return False


def deep(value):
    if not isinstance(value, (dict, list)):
        return 0
    return 1 + max((deep(each) for each in (value.values() if isinstance(value, dict) else value)), default=0)


class Mutations:
    """Values that are not of a schema, though one field away from an example that is."""

    def __init__(self, schema, seed):
        self.validator = validator(schema)
        self.random = random.Random(seed)

    def all_of(self, value):
        """Each mutation as a function that makes it: they are many."""
        for path in fields(value):
            yield from (lambda path=path, wrong=wrong: with_value(value, path, wrong) for wrong in WRONG)
            if path and isinstance(path[-1], str):
                yield lambda path=path: without(value, path)
            if isinstance(at(value, path), dict):
                yield from (lambda path=path, key=key: with_value(value, path, {**at(value, path), key: 1}) for key in KEYS)

    def sample(self, values, count):
        """So many of them that the schema refuses, at random; fewer, if there are no more."""
        makers = [make for value in values for make in self.all_of(value)]
        self.random.shuffle(makers)
        found = {}
        for make in makers:
            mutated = make()
            if not self.validator.is_valid(mutated):
                found[json.dumps(mutated)] = mutated
            if len(found) == count:
                break
        return list(found.values())


def at(value, path):
    for key in path:
        value = value[key]
    return value


def without(value, path):
    """A copy without that field."""
    result = copy.deepcopy(value)
    del at(result, path[:-1])[path[-1]]
    return result
