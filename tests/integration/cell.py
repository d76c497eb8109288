"""The cell of the demo as its files describe it, and which body of the scene is which part."""
import json

from client import PROJECT

DEMO = PROJECT / "deploy/demo"


def read(name):
    return json.loads((DEMO / name).read_text())


DOCUMENT = read("demonstrator.rcm.json")
OPERATOR = read("operator.json")
DATABASE = read("database.json")  # as it is before anything ran
SCENE = read("scene.json")
BODIES = {body["name"]: body for body in SCENE["bodies"]}
O_T_C = SCENE["camera"]["pose"]  # where the camera really is
NAMES = {"Tape": "can_yellow", "Block": "block_green", "Box": "cube_blue", "Cube": "cube_red", "Bar": "bar_violet"}
FALSE = "fake_yellow"  # looks like a part to the careless
TAUGHT = next(label for label in NAMES if f"o_t_place_{label}" not in DATABASE)  # the one whose place nobody knows yet
