"""The cell of the demo as its files describe it, and which body of the scene is which part."""
import json
import shutil
from pathlib import Path

from client import PROJECT

DEMO = PROJECT / "deploy/demo"


def read(name):
    return json.loads((DEMO / name).read_text())


DOCUMENT = read("demonstrator.rcm.json")
OPERATOR = read("operator.json")
DATABASE = read("database.json")  # as it is before anything ran
SCENE = read("scene.json")
BODIES = {body["name"]: body for body in SCENE["bodies"]}
SYMMETRY = {part["label"]: part.get("symmetry", []) for part in read("parts.json")["parts"]}
O_T_C = SCENE["camera"]["pose"]  # where the camera really is
NAMES = {"Tape": "can_yellow", "Block": "block_green", "Box": "cube_blue", "Cube": "cube_red", "Bar": "bar_violet"}
FALSE = "fake_yellow"  # looks like a part to the careless
TAUGHT = next(label for label in NAMES if f"o_t_place_{label}" not in DATABASE)  # the one whose place nobody knows yet


def copied(folder, files=None, without=()):
    """Copies the cell to `folder`. `files`: what a file has instead, by its name; `without`: files that it does not have."""
    shutil.copytree(DEMO, folder, dirs_exist_ok=True)
    for name, content in (files or {}).items():
        Path(folder, name).write_text(json.dumps(content))
    for name in without:
        Path(folder, name).unlink()
    return folder


def scene(parts, *further):
    """The scene with these parts alone, by label, and with further bodies."""
    names = {NAMES[label] for label in parts}
    return SCENE | {"bodies": [b for b in SCENE["bodies"] if b["mass"] == 0 or b["name"] in names] + list(further)}
