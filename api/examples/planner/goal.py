"""What is wanted: each of some parts at one of some places; and what makes that impossible before anything is planned."""
import json
import math
import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field

from .refusal import Refused
from .scene import Point, Scene

# [m] from the robot's base, with the tool pointing down at the table. No operation of the robot tells its reach, so this is
# what was tried with the arm of the demo.
REACH = (0.38, 0.76)
AT = 0.02  # [m] off a place, at which a part counts as there
NAME = re.compile(r"[A-Za-z0-9_]{1,8}")  # of a place: it becomes part of the name of a taught pose

GRID = {f"{row}{column}": (x, y) for row, x in (("A", 0.42), ("B", 0.57)) for column, y in ((1, 0.10), (2, 0.25), (3, 0.40))}


@dataclass(frozen=True)
class Goal:
    """`parts`: label -> name of its place. `places`: where they are [m] in o. `speed`: as a share of the arm's fastest."""

    parts: Mapping[str, str]
    places: Mapping[str, Point] = field(default_factory=lambda: GRID)
    speed: float = 1.0


def read_goal(text: str) -> Goal:
    """A goal as JSON: `{"parts": {"Cube": "A1"}, "places": {"A1": [0.42, 0.1]}, "speed": 1}`. ValueError: it is none."""
    return goal_of(json.loads(text))


def goal_of(value: object) -> Goal:
    """As read_goal, of JSON that was read already."""
    if not isinstance(value, dict) or not value.keys() <= {"parts", "places", "speed"}:
        raise ValueError("a goal is an object with parts, places and speed")
    parts, places, speed = value.get("parts"), value.get("places"), value.get("speed", 1.0)
    if not isinstance(parts, dict) or not parts or not all(isinstance(place, str) for place in parts.values()):
        raise ValueError("parts: an object, the name of a place for each label")
    if not is_number(speed):
        raise ValueError("speed: a number")
    if places is None:
        return Goal(parts, speed=speed)
    if not isinstance(places, dict) or not all(NAME.fullmatch(name) and is_point(at) for name, at in places.items()):
        raise ValueError("places: an object, x and y [m] for each name of 1 to 8 letters, digits and _")
    return Goal(parts, {name: (at[0], at[1]) for name, at in places.items()}, speed)


def is_number(value: object) -> bool:
    """Whether it is a number that can be a length or a share: neither true, nor NaN, nor beyond all bounds."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e6


def is_point(value: object) -> bool:
    return isinstance(value, list) and len(value) == 2 and all(is_number(each) for each in value)


def is_in_reach(at: Point) -> bool:
    return REACH[0] <= math.hypot(*at) <= REACH[1]


def is_at(a: Point, b: Point) -> bool:
    return math.dist(a, b) <= AT


def check_goal(goal: Goal, labels: frozenset[str]) -> None:
    """Refused: the goal is impossible, whatever is on the table. `labels`: of the parts that the camera knows."""
    for label, place in goal.parts.items():
        if label not in labels:
            raise Refused(f"the camera knows no part {label}")
        if place not in goal.places:
            raise Refused(f"there is no place {place}")
        if not is_in_reach(goal.places[place]):
            raise Refused(f"the place {place} of the {label} is out of reach")
    place, count = Counter(goal.parts.values()).most_common(1)[0]
    if count > 1:
        raise Refused(f"{count} parts are to be at the place {place}")


def check_scene(goal: Goal, scene: Scene, held: str | None) -> None:
    """Refused: a part of the goal cannot be taken as things are. `held`: the label of the part in the gripper."""
    if scene.holds and held is None:
        raise Refused("there is a part in the gripper")
    for label in sorted(goal.parts.keys() - {held}):
        part = scene.parts.get(label)
        if part is None:
            raise Refused(f"there is no {label} on the table")
        if not part.upright:
            raise Refused(f"the {label} lies on its side")
        if not is_in_reach(part.at):
            raise Refused(f"the {label} is out of reach")
