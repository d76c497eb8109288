"""Sorts: looks, plans, writes, mends what `check` refuses, runs, follows, and plans again after what went wrong."""
import contextlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from race_client import Client, RaceError, Update

from . import repair, tasks
from .compose import document_of
from .goal import Goal, check_goal, check_scene
from .refusal import Refused
from .scene import call, is_calibrated, look
from .search import Move, find_moves, problem_of
from .skills import Skill, read_skills
from .tasks import ROOT, Draft, Step

PLANS = 4
PATIENCE = 120.0  # [s] without an update of the run after which it is ended
Say = Callable[[str], None]


@dataclass(frozen=True)
class Failure:
    """The error that has stopped a run. `label`: of the part that was moved."""

    text: str
    label: str | None


class Sorter:
    """Sorts the parts of one server. `say` is told each step; `name`: of the document that is written; `plans`: that are run at most."""

    def __init__(self, race: Client, goal: Goal, say: Say = print, *, name: str = "sorting", plans: int = PLANS) -> None:
        self._race, self._goal, self._say, self._name, self._plans = race, goal, say, name, plans
        self._skills: Mapping[str, Skill] = {}
        self._heights: dict[str, float] = {}  # as they were seen last

    def sort(self) -> None:
        """Returns when all parts were seen at their places. Refused: why not; RaceError: the server refuses or is gone."""
        self._skills = read_skills(self._race, besides=self._name)
        self._say(f"skills: {', '.join(sorted(self._skills))}")
        check_goal(self._goal, frozenset(call(self._race, "obj_rec", "labels")))
        self._home = call(self._race, "db", "get", "pose_home")
        self._calibrate()
        failure: Failure | None = None
        for count in range(self._plans + 1):
            moves = self._plan(failure)
            if not moves:
                return
            if count < self._plans:
                self._say(f"plan {count + 1}: {', '.join(f'{move.label} to {move.spot}' for move in moves)}")
                failure = self._run(tasks.sorting(self._name, moves, self._goal.speed))
                self._go_aside(failure)
        raise Refused(f"{self._plans} plans were not enough" + (f"; the last was stopped: {failure.text}" if failure else ""))

    def _calibrate(self) -> None:
        if is_calibrated(self._race):
            return
        self._say("nobody knows where the camera stands: it is calibrated")
        if failure := self._run(tasks.calibrating(self._name)):
            raise Refused(failure.text)

    def _plan(self, failure: Failure | None) -> Sequence[Move]:
        """The moves that lead from what is seen now to the goal; their places are in the database then."""
        scene = look(self._race)
        held = failure.label if failure and scene.holds else None
        parts = (f"{part.label} ({part.at[0]:.2f}, {part.at[1]:.2f})" for part in scene.parts.values())
        self._say(f"on the table: {', '.join(parts) or 'nothing'}" + (f"; in the gripper: {held}" if held else ""))
        check_scene(self._goal, scene, held)
        moves = find_moves(problem_of(self._goal, scene, held))
        for key, value in tasks.poses_of(moves, scene, self._heights, self._home).items():
            call(self._race, "db", "add", key, value)
        self._heights.update((label, part.height) for label, part in scene.parts.items() if label != held)
        return moves

    def _go_aside(self, failure: Failure | None) -> None:
        """After an error the arm may stand anywhere, also in the camera's view."""
        if failure and (stuck := self._run(tasks.going_aside(self._name, self._goal.speed))):
            raise Refused(stuck.text)

    def _run(self, draft: Draft) -> Failure | None:
        """Runs it, once it is accepted; None: it has succeeded."""
        draft = self._accepted(draft)
        self._race.documents.put(self._name, document_of(draft, self._skills), author="planner", message=draft.title)
        core = self._race.cores.create(self._name)["id"]
        is_over = False
        try:
            failure = self._follow(core, draft)
            is_over = True
            return failure
        finally:
            if not is_over:
                with contextlib.suppress(RaceError):
                    self._race.cores.delete(core)  # what it moves stops

    def _accepted(self, draft: Draft) -> Draft:
        """The draft, mended until nothing is wrong with it."""
        for _ in range(repair.ROUNDS):
            here = frozenset(service["key"] for service in self._race.services.all() if service["available"])
            errors = repair.errors_of(draft, self._skills, here, self._race)
            if not errors:
                return draft
            for error in errors:
                self._say(f"  refused: {error['path']}: {error['code']}: {error['message']}")
            draft = repair.repaired(draft, errors, self._skills)
        raise Refused("the document is refused however often it is mended")

    def _follow(self, core: str, draft: Draft) -> Failure | None:
        steps = tasks.steps_of(draft)
        labels = {f"{ROOT}/{task.name}/{step.name}": task.label for task in draft.tasks for step in task.steps}
        failure: Failure | None = None
        with self._race.cores.follow(core) as updates:
            self._race.cores.start(core)
            while (update := updates.next(PATIENCE)) is not None:
                for path, port in fired_by(update, steps):
                    text = self._report(path, steps[path], port, update)
                    if port in self._skills[steps[path].skill].errors:
                        failure = Failure(text, labels[path])  # the last one has stopped it, if anything has
        ended = self._race.cores.get(core)
        if ended["status"] != "ended":
            raise Refused(f"the run is {ended['status']}")
        return None if ended.get("outcome") == "success" else failure or Failure("the run has ended with an error", None)

    def _report(self, path: str, step: Step, port: str, update: Update) -> str:
        why = update.state["state"]["results"].get(path, {}).get("why")
        skill = self._skills[step.skill]
        text = f"{path.partition('/')[2]}: {skill.port_title(port)}" + (f" ({why})" if why else "")
        self._say(f"  {text}")
        return text


def fired_by(update: Update, steps: Mapping[str, Step]) -> list[tuple[str, str]]:
    """(path, port) of the steps that have ended with an update."""
    fired = update.delta["fired"] if update.delta is not None else []
    ends = [port.rpartition(".") for port in fired]
    return [(path, port) for path, _, port in ends if path in steps]
