"""What the project has that seeds are made of."""
import json
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent.parent
CASES = sorted(path.parent for path in (ROOT / "tests/conformance").glob("*/model.json"))
EXAMPLES = ROOT / "api/examples"


def read(path):
    """The JSON of a file; None if it is none, as some cases want it."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        return None


def compact(value):
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False)


def examples(pattern):
    return [read(path) for path in sorted(EXAMPLES.glob(pattern))]


def models():
    found = [read(case / "model.json") for case in CASES]
    return [model for model in found if isinstance(model, dict)]


def scripts():
    """{case: script} of the cases that have one."""
    return {case: read(case / "script.json") for case in CASES if (case / "script.json").exists()}


def objects(value):
    """All objects in a JSON value, outer ones first."""
    if isinstance(value, dict):
        yield value
    for item in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        yield from objects(item)
