"""What is wrong with a draft, and what mends it: by the path and the code of each error.

`check` of the server knows the rules of documents (core/SEMANTICS.md, section 1). Two more that it does not look at are held here, and told
in the same form: a parameter has a value in the range that its skill offers (`out_of_range`), and the services of a skill are there
(`unavailable`). Both would only fail while the arm moves.
"""
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from race_client import Client

from .compose import document_of
from .refusal import Refused
from .skills import Skill, closure_of, links_in, meta_of
from .tasks import Draft, Step, Task, steps_of

Error = Mapping[str, Any]  # path, code, message
ROUNDS = 4  # of check and repair; each mends all that was told


def errors_of(draft: Draft, skills: Mapping[str, Skill], here: frozenset[str], race: Client) -> list[Error]:
    """What the server refuses, then what would fail later. `here`: the keys of the services that are available."""
    told: list[Error] = [dict(error) for error in race.documents.check(document_of(draft, skills), name=draft.name)]
    return [*told, *later_errors(draft, skills, here)]


def later_errors(draft: Draft, skills: Mapping[str, Skill], here: frozenset[str]) -> list[Error]:
    """Values out of their ranges, and services that are not there, by step."""
    found: list[Error] = []
    for path, step in steps_of(draft).items():
        skill = skills[step.skill]
        for name, value in step.values.items():
            low, high = range_of(skill, name)
            if isinstance(value, (int, float)) and not low <= value <= high:
                found.append({"path": path, "code": "out_of_range", "message": f"`{name}` is {low:g} to {high:g}, not {value:g}"})
        for key in sorted(skill.services() - here):
            found.append({"path": path, "code": "unavailable", "message": f"the service {key} is not there"})
    return found


def range_of(skill: Skill, parameter: str) -> tuple[float, float]:
    """What the skill offers."""
    meta = meta_of(skill.parameters.get(parameter, {}))
    return meta.get("min", float("-inf")), meta.get("max", float("inf"))


def repaired(draft: Draft, errors: Sequence[Error], skills: Mapping[str, Skill]) -> Draft:
    """The draft without these errors, which others may follow. Refused: there is no way to mend one of them."""
    after = draft
    for error in errors:
        repair = REPAIRS.get(error["code"])
        if repair is None:
            raise refusal(error)
        after = repair(after, error, skills)
    if errors and after == draft:
        raise refusal(errors[0])
    return after


def refusal(error: Error) -> Refused:
    return Refused(f"{error['path']}: {error['code']}: {error['message']}")


def add_linked(draft: Draft, error: Error, skills: Mapping[str, Skill]) -> Draft:
    """`link_unknown`: what the state at the path links comes into the library, with all that it needs itself."""
    owner = skills_state(draft, error["path"], skills)
    if owner is None:
        raise refusal(error)
    links, library = owner
    if not all(link in library for link in links):
        raise refusal(error)
    needed = {name for link in links for name in closure_of(link, library)}
    return replace(draft, library=(*draft.library, *sorted(needed - set(draft.library))))


def skills_state(draft: Draft, path: str, skills: Mapping[str, Skill]) -> tuple[list[str], Mapping[str, Any]] | None:
    """What the state at a path links, and the library that has it."""
    step = steps_of(draft).get(path)
    if step is not None:
        return [step.skill], skills[step.skill].library
    place, _, name = path.partition("/")
    name = name.split("/")[0]
    for used in steps_of(draft).values():
        library = skills[used.skill].library
        if place == "library" and name in library:
            return links_in(library[name]), library
    return None


def into_range(draft: Draft, error: Error, skills: Mapping[str, Skill]) -> Draft:
    """`out_of_range`: the nearest values that the skill offers."""
    def mend(step: Step) -> Step:
        return replace(step, values={name: nearest(value, *range_of(skills[step.skill], name)) for name, value in step.values.items()})
    return with_step(draft, error, mend)


def nearest(value: Any, low: float, high: float) -> Any:
    return min(max(value, low), high) if isinstance(value, (int, float)) and not low <= value <= high else value


def drop_unknown(draft: Draft, error: Error, skills: Mapping[str, Skill]) -> Draft:
    """`link_parameter`: what the skill of this server has not is left to it."""
    def mend(step: Step) -> Step:
        known = skills[step.skill].parameters
        return replace(step, values={name: value for name, value in step.values.items() if name in known})
    return with_step(draft, error, mend)


def leave_out(draft: Draft, error: Error, skills: Mapping[str, Skill]) -> Draft:
    """`unavailable`: a step after whose errors the task goes on is not needed."""
    step = steps_of(draft).get(error["path"])
    if step is not None and not step.goes_on:
        raise refusal(error)
    return with_step(draft, error, lambda _: None)


def with_step(draft: Draft, error: Error, mend: Callable[[Step], Step | None]) -> Draft:
    """The draft with the step at the error's path mended, or left out. An error before may have left it out already."""
    _, _, name = error["path"].partition("/")
    tasks = tuple(replace(task, steps=tuple(mended(task, name, mend))) for task in draft.tasks)
    return replace(draft, tasks=tuple(task for task in tasks if task.steps))


def mended(task: Task, path: str, mend: Callable[[Step], Step | None]) -> list[Step]:
    steps = [mend(step) if f"{task.path}/{step.name}" == path else step for step in task.steps]
    return [step for step in steps if step is not None]


REPAIRS: Mapping[str, Callable[[Draft, Error, Mapping[str, Skill]], Draft]] = {
    "link_unknown": add_linked, "out_of_range": into_range, "link_parameter": drop_unknown, "unavailable": leave_out}
