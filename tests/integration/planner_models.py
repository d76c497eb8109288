"""What the tests of the example planner without a cell work on: the demo's skills, scenes and moves."""
import dataclasses

import planners  # noqa: F401  (where the planner is)
from skills import DOCUMENT

from planner.goal import GRID
from planner.scene import Part, Scene
from planner.search import Move
from planner.skills import Skill

LIBRARY = {state["state"]: state for state in DOCUMENT["library"]}
SKILLS = {name: Skill(state, LIBRARY, DOCUMENT["services"]) for name, state in LIBRARY.items() if state["meta"].get("skill")}
HERE = frozenset(DOCUMENT["services"])  # keys of services
MOVES = [Move("Cube", "A1", GRID["A1"], held=False), Move("Box", "B2", GRID["B2"], held=False)]


def scene(holds=False, **parts):
    """`parts`: label -> name of a place, or x and y."""
    at = {label: GRID.get(where, where) for label, where in parts.items()}
    return Scene({label: Part(label, xy, 0.02, True, 0.9) for label, xy in at.items()}, holds)


def lying(here, label):
    """The scene with this part on its side."""
    return dataclasses.replace(here, parts={**here.parts, label: dataclasses.replace(here.parts[label], upright=False)})


def whole(draft):
    """The draft with all that its skills link."""
    return dataclasses.replace(draft, library=tuple(dict.fromkeys(name for skill in draft.library for name in SKILLS[skill].closure())))
