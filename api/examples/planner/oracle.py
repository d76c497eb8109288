"""The planner as a service of its own, `Oracle`: a task asks it before each move which of its children comes next (choosing.py).

It plans anew at each call, by what the camera sees then: whatever has happened since the last one.
"""
import asyncio
import contextlib
import signal
from collections.abc import Callable, Mapping, Sequence

from race_client import Client, RaceError
from race_client.service import Service, ServiceFailure, operation, serve

from . import tasks
from .choosing import ORACLE, SORTED
from .goal import Goal, check_goal, check_scene, goal_of, is_in_reach
from .refusal import Refused
from .run import Runner
from .scene import Scene, look
from .search import Move, find_moves, problem_of
from .skills import read_skills

MAX_MOVES = 12  # of one run, also in vain: five parts that change places need seven


def next_child(goal: Goal, scene: Scene, moves: int) -> str:
    """The name of the child that comes next after so many `moves`. Refused: the goal cannot be reached from this scene."""
    check_scene(goal, scene, None)
    plan = find_moves(problem_of(goal, scene, None))
    if not plan:
        return SORTED
    if moves >= MAX_MOVES:
        raise Refused(f"{moves} moves were not enough")
    return tasks.choice_name(plan[0])


class Oracle(Service):
    """`connect`: a client of the server at which it looks, for each call. `say` is told each decision."""

    key = ORACLE

    def __init__(self, connect: Callable[[], Client], say: Callable[[str], None] = print) -> None:
        self._connect, self._say = connect, say

    @operation(reads=True, result="string", parameters={
        "parts": {"type": "any", "doc": "Which part belongs at which place: {\"Cube\": \"A1\"}"},
        "places": {"type": "any", "unit": "m", "doc": "Where these are, and others that are free: {\"A1\": [0.42, 0.1]}"},
        "moves": {"min": 0, "doc": "Moves that were made already"}})
    def decide(self, parts: Mapping[str, str], places: Mapping[str, Sequence[float]], moves: int = 0) -> str:
        """`Sorted`, or `Move_LABEL_to_PLACE`. The arm has to be out of the camera's view. Error `refused`: why this cannot be reached;
        `invalid`: no such goal; others: of what was asked on the way, as of the camera."""
        try:
            child = self._decided(goal_from(parts, places), moves)
        except Refused as refused:
            raise self._failure("refused", str(refused)) from None
        except RaceError as error:
            raise self._failure(error.code, str(error)) from None
        self._say(f"next: {child}")
        return child

    def _decided(self, goal: Goal, moves: int) -> str:
        with self._connect() as race:
            check_goal(goal, frozenset(race.services.call("obj_rec", "labels")))
            return next_child(goal, look(race), moves)

    def _failure(self, code: str, message: str) -> ServiceFailure:
        self._say(f"no next move: {message}")
        return ServiceFailure(code, message)


def goal_from(parts: object, places: object) -> Goal:
    """ServiceFailure `invalid`: a task has asked with what is none."""
    try:
        return goal_of({"parts": parts, "places": places})
    except ValueError as error:
        raise ServiceFailure("invalid", str(error)) from None


def all_moves(goal: Goal, scene: Scene) -> list[Move]:
    """Every move that may be needed: each part that stands there, as any may be in the way, to each place in reach."""
    places = [(name, at) for name, at in goal.places.items() if is_in_reach(at)]
    return [Move(label, place, at, held=False) for label, part in sorted(scene.parts.items()) if part.upright for place, at in places]


def store(race: Client, goal: Goal, name: str, say: Callable[[str], None] = print) -> None:
    """Writes the task that asks, with the moves that the table now allows. Refused: the server does not accept it, or cannot run it;
    RaceError: it, or a service, refuses or is gone."""
    home = race.services.call("db", "get", f"pose_{tasks.HOME}")
    runner = Runner(race, read_skills(race), say, name)
    runner.calibrate(goal.speed)
    scene = look(race)
    moves = all_moves(goal, scene)
    heights = {label: part.height for label, part in scene.parts.items()}
    runner.store(tasks.asking(name, goal, moves), tasks.poses_of(moves, heights, home))
    say(f"stored: {name}, with {len(moves)} moves to choose from")


async def offer(oracle: Oracle, server: str, token_file: str | None, ca_file: str | None) -> None:
    """Until Ctrl-C or SIGTERM. RaceError: the server refuses it; OSError, ValueError: it has no token of a process."""
    work = asyncio.create_task(serve(oracle, server=server, token_file=token_file, ca_file=ca_file))
    for number in (signal.SIGINT, signal.SIGTERM):
        asyncio.get_running_loop().add_signal_handler(number, work.cancel)
    with contextlib.suppress(asyncio.CancelledError):
        await work
