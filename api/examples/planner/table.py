"""A table and a goal by seed, in the cell of the demo: what a person would put on it, and want."""
import math
import random
from dataclasses import dataclass

from race_client import Client, calls

from .goal import GRID, Goal
from .scene import Point

# Label -> the body of the demo's scene, and the height of its middle [m].
BODIES = {"Cube": ("cube_red", 0.02), "Box": ("cube_blue", 0.025), "Block": ("block_green", 0.04), "Tape": ("can_yellow", 0.04),
          "Bar": ("bar_violet", 0.015)}
DECOY = "fake_yellow"  # looks like a part, but is none
FREE = ((0.42, -0.42), (0.6, -0.05))  # of the table [m]: parts are put here, or on places
APART, BESIDE = 0.17, 0.14  # [m] between parts: from one that stands anywhere, and from one on a place (the next is 0.15 m away)
FAR = (0.9, 0.3)  # on the table, but out of reach
FLAWS = ("none", "absent", "far", "double")  # what makes a goal impossible


@dataclass(frozen=True)
class Table:
    """`parts`: label -> where it stands, and its turn [rad]. `flaw`: of FLAWS."""

    parts: dict[str, tuple[Point, float]]
    goal: Goal
    flaw: str


def table_by_seed(seed: int) -> Table:
    """One to three parts to sort, often with another, or each other, in the way; one goal in three or four is impossible."""
    by = random.Random(seed)
    flaw = by.choices(FLAWS, (10, 1, 1, 1))[0]
    labels = by.sample(sorted(BODIES), by.choice((2, 3, 3)))
    wanted = labels[: max(by.randint(1, 3), 2 if flaw == "double" else 1)]
    parts = positions(labels, by)
    goal, known = dict(zip(wanted, places_for(wanted, parts, by), strict=True)), dict(GRID)
    if flaw == "absent":
        del parts[wanted[-1]]
    elif flaw == "far":
        known["Far"], goal[wanted[-1]] = FAR, "Far"
    elif flaw == "double":
        goal[wanted[-1]] = goal[wanted[0]]
    return Table(parts, Goal(goal, known, by.choice((0.9, 1.0, 1.2))), flaw)


def places_for(wanted: list[str], parts: dict[str, tuple[Point, float]], by: random.Random) -> list[str]:
    """A place for each part, first of all those at which others stand, in every other table."""
    taken = [name for name, at in sorted(GRID.items()) if at in [each for each, _ in parts.values()]]
    order = by.sample(sorted(GRID), len(GRID))
    return (order if by.random() < 0.5 else [*taken[1:], *taken[:1], *(name for name in order if name not in taken)])[: len(wanted)]


def positions(labels: list[str], by: random.Random) -> dict[str, tuple[Point, float]]:
    """Where each part stands, and its turn [rad]. Every other one stands on a place, so that it may be in the way."""
    parts: dict[str, tuple[Point, float]] = {}
    while len(parts) < len(labels):
        (left, near), (right, far) = FREE
        on_place = by.random() < 0.5
        at = by.choice(sorted(GRID.values())) if on_place else (by.uniform(left, right), by.uniform(near, far))
        if all(math.dist(at, other) >= (BESIDE if on_place else APART) for other, _ in parts.values()):
            parts[labels[len(parts)]] = at, 0.0 if on_place else by.uniform(-1.5, 1.5)
    return parts


def lay(race: Client, table: Table) -> None:
    """Puts the cell back to its start, and these parts, and no others, on the table. What the database knows stays."""
    race.send(calls.reset_cell({"database": False}))
    for body in (*(body for body, _ in BODIES.values()), DECOY):
        race.send(calls.command_person({"act": "take", "part": body}))
    for label, (at, turn) in table.parts.items():
        body, height = BODIES[label]
        pose = {"position": [*at, height], "orientation": [0.0, 0.0, math.sin(turn / 2), math.cos(turn / 2)]}
        race.send(calls.command_person({"act": "place", "part": body, "pose": pose}))
