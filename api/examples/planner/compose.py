"""Writes a draft as a document in the form of api/skills.md, so that RACE-One opens it as time lines."""
from collections.abc import Mapping, Sequence
from typing import Any

from . import choosing
from .refusal import Refused
from .skills import PLANNED, Skill
from .tasks import FINAL, NEXT, ROOT, Draft, Step, Task, steps_of

Json = Any


def document_of(draft: Draft, skills: Mapping[str, Skill]) -> dict[str, Json]:
    """The document. Refused: the server has not the skill of a step."""
    for step in steps_of(draft).values():
        if step.skill not in skills:
            raise Refused(f"the server has no skill {step.skill}")
    linked = {step.skill for step in steps_of(draft).values()}
    library = {name: state for skill in linked for name, state in skills[skill].library.items() if name in draft.library}
    keys = sorted({key for skill in linked for key in skills[skill].services()})
    types = {key: kind for skill in linked for key, kind in skills[skill].types.items()}
    services = {key: types[key] for key in keys if key in types}
    return {"rcm": 1, "name": draft.name, "services": services if draft.goal is None else {**services, **choosing.SERVICES},
            "library": [library[name] for name in draft.library if name in library], "root": root_of(draft, skills)}


def root_of(draft: Draft, skills: Mapping[str, Skill]) -> dict[str, Json]:
    """The tasks one after the other, or as they are chosen."""
    meta = {"title": draft.title, PLANNED: True}
    if draft.goal is not None:
        aside, *choices = draft.tasks
        moves = [choice_node(task, skills) for task in choices]
        return {**choosing.root_of(draft.goal, task_node(aside, NEXT, skills), moves), "meta": meta}
    nodes = [task_node(task, following, skills) for task, following in with_next(draft.tasks)]
    ends = [f"chi.{draft.tasks[-1].name}.port.success"]
    return composite(ROOT, meta, nodes, ends, [f"chi.{task.name}.port.error" for task in draft.tasks])


def choice_node(task: Task, skills: Mapping[str, Skill]) -> dict[str, Json]:
    """A task that is chosen. It ends with `stopped`, not `error`, where nothing may be moved again."""
    node = task_node(task, None, skills)
    finals = [f"chi.{step.name}.port.{port}" for step in task.steps for port in skills[step.skill].errors if port in FINAL]
    return {**node, "ports": [{"name": "stopped", "when": " or ".join(finals) or "False"}, *node["ports"]]}


def with_next(items: Sequence[Any]) -> list[tuple[Any, str | None]]:
    """Each with the name of the one after it."""
    return list(zip(items, [*(item.name for item in items[1:]), None], strict=True))


def task_node(task: Task, following: str | None, skills: Mapping[str, Skill]) -> dict[str, Json]:
    """A task that leads to the `following` one. What its last step may end with ends it, but for errors that stop it."""
    last = task.steps[-1]
    skill = skills[last.skill]
    ends = [skill.nominal, *skill.outcomes, *(skill.errors if last.goes_on else ())]
    stops = [f"chi.{step.name}.port.{port}" for step in task.steps if not step.goes_on for port in skills[step.skill].errors]
    nodes = [step_node(step, onward, skills[step.skill]) for step, onward in with_next(task.steps)]
    node = composite(task.name, {"title": task.title}, nodes, [f"chi.{last.name}.port.{port}" for port in ends], stops)
    return leading(node, ["success"], following)


def step_node(step: Step, following: str | None, skill: Skill) -> dict[str, Json]:
    """All that does not stop the task leads to the next step: also what a search has not found, which the pick then says."""
    values = [{"name": name, "value": value} for name, value in step.values.items()]
    takes = [{"name": name, "from": f"chi.{source}.res.{result}"} for name, (source, result) in step.takes.items()]
    node = {"state": step.name, "link": skill.name, **({"parameters": values + takes} if values or takes else {})}
    return leading(node, [skill.nominal, *skill.outcomes, *(skill.errors if step.goes_on else ())], following)


def leading(node: dict[str, Json], ports: Sequence[str], to: str | None) -> dict[str, Json]:
    """The node with these ports leading to a sibling; none: nowhere."""
    if to is None:
        return node
    declared = {port["name"]: port for port in node.get("ports", [])}
    return {**node, "ports": [*({**port, "to": to} if name in ports else port for name, port in declared.items()),
                              *({"name": name, "to": to} for name in ports if name not in declared)]}


def composite(name: str, meta: Mapping[str, Json], nodes: list[dict[str, Json]], ends: Sequence[str],
              stops: Sequence[str]) -> dict[str, Json]:
    """A task: it ends with `success` by one of `ends`, with `error` by one of `stops`."""
    ports = [{"name": "success", "when": " or ".join(ends)}, {"name": "error", "when": " or ".join(stops) or "False"}]
    return {"state": name, "children": nodes, "first": nodes[0]["state"], "ports": ports, "meta": meta}
