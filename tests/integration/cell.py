"""The demo's cell as its files describe it, and the mapping of part labels to bodies of the scene."""
import json
import shutil
from pathlib import Path

from client import PROJECT

DEMO = PROJECT / "deploy/demo"


def read(name):
    return json.loads((DEMO / name).read_text())


DOCUMENT = read("demonstrator.rcm.json")
OPERATOR = read("operator.json")
DATABASE = read("database.json")  # before any run
SCENE = read("scene.json")
BODIES = {body["name"]: body for body in SCENE["bodies"]}
SYMMETRY = {part["label"]: part.get("symmetry", []) for part in read("parts.json")["parts"]}
O_T_C = SCENE["camera"]["pose"]  # true pose of the camera
NAMES = {"Tape": "can_yellow", "Block": "block_green", "Box": "cube_blue", "Cube": "cube_red", "Bar": "bar_violet"}
DECOY = "fake_yellow"  # similar to a part, but none
TAUGHT = next(label for label in NAMES if f"o_t_place_{label}" not in DATABASE)  # the part whose place must be taught


def copy_cell(folder, files=None, without=()):
    """Copies the cell to `folder`. `files`: replaced content by file name; `without`: files to leave out. Without cell.json, so that it
    has the services for which there are files."""
    shutil.copytree(DEMO, folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("cell.json"))
    for name, content in (files or {}).items():
        Path(folder, name).write_text(json.dumps(content))
    for name in without:
        Path(folder, name).unlink()
    return folder


def scene(parts, *further):
    """The scene with only these parts (labels) and with further bodies."""
    names = {NAMES[label] for label in parts}
    return SCENE | {"bodies": [b for b in SCENE["bodies"] if b["mass"] == 0 or b["name"] in names] + list(further)}
