"""Finds the moves that bring parts to their places: A* over states of the table, with two operators in the manner of STRIPS.

    pick(p, s)    requires  hand empty, at(p, s), reachable(s)
                  then      holding(p); no more at(p, s), hand empty
    place(p, s)   requires  holding(p), reachable(s), and nothing at s or so near that the fingers would meet it
                  then      at(p, s), hand empty; no more holding(p)

A spot is a named place, or `where LABEL was` at first, a name that no place has. A part in the way, also one that is not of the goal,
is moved aside.
"""
import heapq
import itertools
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from .goal import Goal, is_at, is_in_reach
from .refusal import Refused
from .scene import Point, Scene

CLEARANCE = 0.13  # [m] between the middles of two parts
MAX_STATES = 200_000  # that are looked at: with 5 parts on 11 spots there are fewer


@dataclass(frozen=True)
class Move:
    """A part is brought to a spot at `at`; it is `held` already, or it is to be picked."""

    label: str
    spot: str
    at: Point
    held: bool


@dataclass(frozen=True)
class Problem:
    """`spots` that can be reached; `start`: part -> spot, also one that cannot be reached; `positions`: of all these [m] in o;
    `goal`: part -> spot; `holding`: the part in the gripper, which is not in `start`."""

    spots: Mapping[str, Point]
    start: Mapping[str, str]
    positions: Mapping[str, Point]
    goal: Mapping[str, str]
    holding: str | None = None

    def is_free(self, spot: str, state: "State") -> bool:
        here = self.positions[spot]
        return all(math.dist(here, self.positions[other]) >= CLEARANCE for _, other in state.at)


@dataclass(frozen=True, order=True)
class State:
    """`holding`: a part, or nothing (empty text). `at`: (part, spot), in the order of the parts."""

    holding: str
    at: tuple[tuple[str, str], ...]


def problem_of(goal: Goal, scene: Scene, held: str | None) -> Problem:
    """The spots and parts of a scene, in which the part in the gripper (`held`) is not."""
    spots = {name: at for name, at in goal.places.items() if is_in_reach(at)}
    positions, start = dict(spots), {}
    for label, part in sorted(scene.parts.items()):
        here = [name for name, at in spots.items() if is_at(at, part.at)] if part.upright else []  # what lies is not picked
        start[label] = here[0] if here else f"where {label} was"
        if not here:
            positions[start[label]] = part.at
            if is_in_reach(part.at) and part.upright:
                spots[start[label]] = part.at
    return Problem(spots, start, positions, goal.parts, held)


def steps_from(problem: Problem, state: State) -> Iterator[State]:
    """The states to which one pick or place leads."""
    if not state.holding:
        for part, spot in state.at:
            if spot in problem.spots:
                yield State(part, tuple(each for each in state.at if each[0] != part))
        return
    for spot in problem.spots:
        if problem.is_free(spot, state):
            yield State("", tuple(sorted((*state.at, (state.holding, spot)))))


def lower_bound(problem: Problem, state: State) -> int:
    """How many picks and places are needed at least."""
    away = sum(2 for part, spot in state.at if problem.goal.get(part, spot) != spot)
    return away + (1 if state.holding else 0)


def find_moves(problem: Problem) -> list[Move]:
    """The fewest moves that reach the goal; none: it is reached. Refused: there are none that do."""
    first = State(problem.holding or "", tuple(sorted(problem.start.items())))
    order = itertools.count()
    waiting = [(lower_bound(problem, first), next(order), 0, first)]
    came_from: dict[State, State | None] = {first: None}
    cost = {first: 0}
    while waiting:
        _, _, spent, state = heapq.heappop(waiting)
        if spent > cost[state]:
            continue
        if lower_bound(problem, state) == 0:
            return moves_of(problem, state, came_from)
        if len(cost) > MAX_STATES:
            raise Refused("the search for moves takes too long")
        for after in steps_from(problem, state):
            if spent + 1 < cost.get(after, math.inf):
                cost[after], came_from[after] = spent + 1, state
                heapq.heappush(waiting, (spent + 1 + lower_bound(problem, after), next(order), spent + 1, after))
    raise Refused("no order of moves leads to the goal: the parts leave too little room")


def moves_of(problem: Problem, last: State, came_from: Mapping[State, State | None]) -> list[Move]:
    """What leads to the last state: each place, with the pick before it."""
    moves: list[Move] = []
    after, state = last, came_from[last]
    while state is not None:
        if state.holding:
            spot = dict(after.at)[state.holding]
            moves.append(Move(state.holding, spot, problem.spots[spot], held=came_from[state] is None))
        after, state = state, came_from[state]
    return moves[::-1]
