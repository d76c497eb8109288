"""What is on the table: recognised objects, seen from the origin o, and what the gripper holds."""
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from race_client import Client

Point = tuple[float, float]  # x and y in o [m]
Vector = Sequence[float]

LOOKS = 3  # pictures: a part may be missed in one
MIN_CONFIDENCE = 0.6
AREA = ((0.25, -0.55), (0.95, 0.55))  # of the table [m], as the skill SearchObject has it
HIGHEST = 0.2  # [m]: what is above does not stand on the table
UPRIGHT = 0.9  # cosine of the angle up to which a part stands
TOOL = "Tool"  # the calibration body of the robot, which is no part


@dataclass(frozen=True)
class Part:
    """A part that stands, or lies, at `at`; `height` [m] is that of its frame above the table."""

    label: str
    at: Point
    height: float
    upright: bool
    confidence: float


@dataclass(frozen=True)
class Scene:
    """`parts` on the table by label. `holds`: whether there is a part in the gripper."""

    parts: Mapping[str, Part]
    holds: bool

    def without(self, label: str | None) -> "Scene":
        """The scene but for the part in the gripper, which the camera may see there."""
        return replace(self, parts={each: part for each, part in self.parts.items() if each != label})


def rotate(orientation: Vector, v: Vector) -> list[float]:
    """A vector rotated by a unit quaternion [x, y, z, w]."""
    x, y, z, w = orientation
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    t = [2 * each for each in cross([x, y, z], v)]
    return [a + w * b + c for a, b, c in zip(v, t, cross([x, y, z], t), strict=True)]


def part_of(o_t_c: Mapping[str, Any], recognised: Mapping[str, Any]) -> Part | None:
    """A recognised object in o; None: it does not stand on the table, or it is not sure what it is."""
    pose = recognised["pose"]
    x, y, z = (a + b for a, b in zip(o_t_c["position"], rotate(o_t_c["orientation"], pose["position"]), strict=True))
    up = rotate(o_t_c["orientation"], rotate(pose["orientation"], [0, 0, 1]))
    (left, right), (near, far) = zip(*AREA, strict=True)
    is_there = left <= x <= right and near <= y <= far and 0 < z < HIGHEST
    if not is_there or recognised["label"] == TOOL or recognised["confidence"] < MIN_CONFIDENCE:
        return None
    return Part(recognised["label"], (x, y), z, up[2] >= UPRIGHT, recognised["confidence"])


def best_of(parts: Sequence[Part]) -> dict[str, Part]:
    """Of each label the surest: two parts of one label are not told apart."""
    return {part.label: part for part in sorted(parts, key=lambda part: part.confidence)}


def is_calibrated(race: Client) -> bool:
    """Whether it is known where the camera stands."""
    return "o_t_c" in race.services.call("db", "list", "o_t_c")


def look(race: Client) -> Scene:
    """The scene now; the arm has to be out of the camera's view. ServiceError: why there is none."""
    o_t_c = race.services.call("db", "get", "o_t_c")
    parts: list[Part] = []
    for _ in range(LOOKS):
        seen = race.services.call("obj_rec", "look")["objects"]
        parts += [part for each in seen if (part := part_of(o_t_c, each)) is not None]
    return Scene(best_of(parts), race.services.call("gripper", "state")["holding"])
