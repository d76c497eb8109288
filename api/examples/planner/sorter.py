"""Sorts: looks, plans, has the plan run, and plans again after what went wrong."""
from collections.abc import Callable, Sequence

from race_client import Client

from . import tasks
from .goal import Goal, check_goal, check_scene
from .refusal import Refused
from .run import Failure, Runner
from .scene import look
from .search import Move, find_moves, problem_of
from .skills import read_skills

PLANS = 4


class Sorter:
    """Sorts the parts of one server. `say` is told each step; `name`: of the document that is written; `plans`: that are run at most."""

    def __init__(self, race: Client, goal: Goal, say: Callable[[str], None] = print, *, name: str = "sorting", plans: int = PLANS) -> None:
        self._race, self._goal, self._say, self._name, self._plans = race, goal, say, name, plans
        self._heights: dict[str, float] = {}  # of parts, as they were seen last

    def sort(self) -> None:
        """Returns when all parts were seen at their places. Refused: why not; RaceError: the server, or a service, refuses or is gone."""
        skills = read_skills(self._race)
        self._say(f"skills: {', '.join(sorted(skills))}")
        check_goal(self._goal, frozenset(self._race.services.call("obj_rec", "labels")))
        home = self._race.services.call("db", "get", f"pose_{tasks.HOME}")
        runner = Runner(self._race, skills, self._say, self._name)
        runner.calibrate(self._goal.speed)
        failure: Failure | None = None
        for count in range(1, self._plans + 1):
            moves = self._plan(failure)
            if not moves:
                return
            self._say(f"plan {count}: {', '.join(f'{move.label} to {move.spot}' for move in moves)}")
            failure = runner.run(tasks.sorting(self._name, moves, self._goal.speed), tasks.poses_of(moves, self._heights, home))
            if failure is not None:
                runner.complete(tasks.going_aside(self._name, self._goal.speed))
        if self._plan(failure):
            raise Refused(f"{self._plans} plans were not enough" + (f"; the last was stopped: {failure.text}" if failure else ""))

    def _plan(self, failure: Failure | None) -> Sequence[Move]:
        """The moves that lead from what is seen now to the goal."""
        scene = look(self._race)
        held = failure.label if failure and scene.holds else None
        scene = scene.without(held)
        parts = (f"{label} ({part.at[0]:.2f}, {part.at[1]:.2f})" for label, part in sorted(scene.parts.items()))
        self._say(f"on the table: {', '.join(parts) or 'nothing'}" + (f"; in the gripper: {held}" if held else ""))
        self._heights.update((label, part.height) for label, part in scene.parts.items() if part.upright)
        check_scene(self._goal, scene, held)
        return find_moves(problem_of(self._goal, scene, held))
