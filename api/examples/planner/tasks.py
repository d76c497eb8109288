"""What is to be run, as tasks of steps that link skills: a task for each move. compose.py writes it."""
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from .goal import Goal
from .search import Move

ROOT = "Sorting"  # the state that has the tasks
NEXT = "Next"  # the state within it whose oracle chooses one of the tasks that it has (choosing.py)
FINAL = ("stopped",)  # ports of steps after which nothing is moved again: a person has stopped the robot
HOME = "home"  # the taught pose in which the arm hides nothing from the camera
LOWEST = 0.02  # [m]: the tool takes flat parts here, as SearchObject says
SLACK = 0.002  # [m] above the table from which a part falls
OPENING = 0.08  # [m] between the fingers when they go around a part; the widest is 0.05
Json = Any


@dataclass(frozen=True)
class Step:
    """A link to a skill. `takes`: parameter -> (step, result). `goes_on`: an error of it leads to the next step, else it stops the task."""

    name: str
    skill: str
    values: Mapping[str, Json] = field(default_factory=dict)
    takes: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    goes_on: bool = False


@dataclass(frozen=True)
class Task:
    """Steps that are done one after the other. `label`: of the part that they move. `within`: the state in ROOT that has it; none: ROOT."""

    name: str
    title: str
    steps: tuple[Step, ...]
    label: str | None = None
    within: str | None = None

    @property
    def path(self) -> str:
        """Below ROOT."""
        return self.name if self.within is None else f"{self.within}/{self.name}"


@dataclass(frozen=True)
class Draft:
    """A document before it is written. `library`: the library states that it has. `goal`: of one whose first task is done after errors, and
    the others as a service chooses them; none: all are done one after the other."""

    name: str
    title: str
    tasks: tuple[Task, ...]
    library: tuple[str, ...]
    goal: Goal | None = None


def pose_name(number: int, move: Move) -> str:
    """The name of the taught pose at which the part of a move is put down: at most 32 characters, another one for each number."""
    return re.sub(r"[^A-Za-z0-9_-]", "_", f"plan_{number}_{move.spot}_{move.label}")[:32]


def poses_of(moves: Sequence[Move], heights: Mapping[str, float], home: Mapping[str, Json]) -> dict[str, Json]:
    """What the database has to know: each place, as the tool is there with the part between its fingers, pointing down.

    `heights` [m]: of the parts by label, when they stand. A taught pose has joints, too, which `PlaceAt` does not use, and no operation
    computes: they are those of `home`.
    """
    position = lambda move: [*move.at, max(heights[move.label], LOWEST) + SLACK]
    return {f"pose_{pose_name(number, move)}": {"pose": {"position": position(move), "orientation": [1, 0, 0, 0]}, "q": home["q"]}
            for number, move in enumerate(moves, 1)}


def task_of(number: int, move: Move, speed: float) -> Task:
    """A part is looked for, picked and placed, or only placed, if it is held."""
    place = Step("Place", "PlaceAt", {"pose": pose_name(number, move), "speed": speed})
    pick = (Step("Aside", "MoveTo", {"pose": HOME, "speed": speed}), Step("Search", "SearchObject", {"labels": [move.label]}),
            Step("Pick", "PickFound", {"speed": speed, "opening": OPENING}, {"found": ("Search", "found")}))
    title = f"{move.label} to {move.spot}"[:40]
    return Task(f"Move{number}_{identifier(move.label)}", title, (place,) if move.held else (*pick, place), move.label)


def sorting(name: str, moves: Sequence[Move], speed: float) -> Draft:
    """All moves, one after the other, told to who stands by; then the arm goes out of the way."""
    text = f"I sort: {', '.join(f'{move.label} to {move.spot}' for move in moves)}"
    say = Step("Say", "Say", {"text": text[:200]}, goes_on=True)
    tell = Task("Tell", "Say what comes", (say, Step("Wait", "WaitTime", {"duration": 0.5})))
    end = Task("End", "Out of the way", (Step("Aside", "MoveTo", {"pose": HOME, "speed": speed}),))
    return draft(name, "Sort parts", (tell, *(task_of(number, move, speed) for number, move in enumerate(moves, 1)), end))


def aside(speed: float, *, goes_on: bool) -> Task:
    """After an error, when the arm may stand anywhere: the tool rises from between the parts, and the arm goes out of the camera's view.
    `goes_on`: also if the tool cannot rise, whatever keeps it from that: who runs it looks whether a person does."""
    steps = (Step("Up", "MoveBy", {"direction": "up", "distance": 0.1, "speed": speed}, goes_on=goes_on),
             Step("Aside", "MoveTo", {"pose": HOME, "speed": speed}))
    return Task("Aside", "Out of the way", steps)


def going_aside(name: str, speed: float) -> Draft:
    return draft(name, "Go out of the way", (aside(speed, goes_on=True),))


def choice_name(move: Move) -> str:
    """The task of a move, where one is chosen."""
    return f"Move_{identifier(move.label)}_to_{identifier(move.spot)}"


def choice_of(number: int, move: Move, speed: float) -> Task:
    """One of the moves that can be chosen: the arm is out of the camera's view again at its end."""
    task = task_of(number, move, speed)
    back = Step("Back", "MoveTo", {"pose": HOME, "speed": speed})
    return replace(task, name=choice_name(move), steps=(*task.steps, back), within=NEXT)


def asking(name: str, goal: Goal, moves: Sequence[Move]) -> Draft:
    """A service is asked before each move which of these comes next; after an error, the arm goes out of the way first."""
    choices = (choice_of(number, move, goal.speed) for number, move in enumerate(moves, 1))
    tasks = (aside(goal.speed, goes_on=False), *choices)
    return replace(draft(name, "Sort parts, asking before each move", tasks), goal=goal)


def calibrating(name: str, speed: float) -> Draft:
    """Finds out where the camera stands, and stores it."""
    step = Step("Calibrate", "CalibrateCamera", {"speed": speed})
    return draft(name, "Calibrate the camera", (Task("Calibrate", "Calibrate the camera", (step,)),))


def draft(name: str, title: str, tasks: tuple[Task, ...]) -> Draft:
    """With the skills that it links; what these link, `check` finds missing."""
    return Draft(name, title, tasks, tuple(dict.fromkeys(step.skill for task in tasks for step in task.steps)))


def identifier(text: str) -> str:
    """What is left of a text in the name of a state."""
    return re.sub(r"\W", "_", text, flags=re.ASCII)


def steps_of(draft: Draft) -> dict[str, Step]:
    """The steps by their paths."""
    return {f"{ROOT}/{task.path}/{step.name}": step for task in draft.tasks for step in task.steps}
