"""The skills that a server offers (api/skills.md): their parameters, ports and services."""
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from race_client import Client

State = Mapping[str, Any]  # of a document (api/schemas/state.json)
PLANNED = "planned"  # true in `meta` of the root of a document that the planner has written
CODE = ("entry", "exit", "when", "do", "from", "after")
SERVICE = re.compile(r"\bsvc\.([A-Za-z_]\w*)")


@dataclass(frozen=True)
class Skill:
    """A library state with `meta.skill`. `library`: all library states of its document; `types`: what services that expects."""

    state: State
    library: Mapping[str, State]
    types: Mapping[str, str]

    @property
    def name(self) -> str:
        return str(self.state["state"])

    @property
    def title(self) -> str:
        return str(meta_of(self.state).get("title", self.name))

    @property
    def parameters(self) -> Mapping[str, Mapping[str, Any]]:
        """By name, each as the document has it."""
        return {each["name"]: each for each in self.state.get("parameters", [])}

    @property
    def errors(self) -> tuple[str, ...]:
        """Names of the ports that say that it has failed."""
        return tuple(name for name, port in self._ports().items() if "advice" in meta_of(port))

    @property
    def nominal(self) -> str:
        """The port with which a task goes on; if the skill has errors alone, one that `check` will not know."""
        ports = self._ports()
        marked = [name for name, port in ports.items() if meta_of(port).get("nominal")]
        usual = ["success"] if "success" in ports else []
        return (*marked, *usual, *(name for name in ports if name not in self.errors), "success")[0]

    @property
    def outcomes(self) -> tuple[str, ...]:
        """The ports that are neither."""
        return tuple(name for name in self._ports() if name != self.nominal and name not in self.errors)

    def port_title(self, port: str) -> str:
        """What has happened, for people."""
        return str(meta_of(self._ports().get(port, {})).get("title", port))

    def closure(self) -> dict[str, State]:
        """The skill and all that it links, and these, by name."""
        return closure_of(self.name, self.library)

    def services(self) -> frozenset[str]:
        """The keys of the services that it needs."""
        return frozenset(key for state in self.closure().values() for key in services_in(state))

    def _ports(self) -> dict[str, Mapping[str, Any]]:
        return {port["name"]: port for port in self.state.get("ports", [])}


def meta_of(element: Mapping[str, Any]) -> Mapping[str, Any]:
    meta = element.get("meta", {})
    return meta if isinstance(meta, dict) else {}


def elements(value: Any) -> Iterator[Mapping[str, Any]]:
    """All objects within a state, itself first, but for what is `meta` or a value."""
    if isinstance(value, list):
        for each in value:
            yield from elements(each)
    elif isinstance(value, dict):
        yield value
        for field, each in value.items():
            if field not in ("meta", "value", "initial"):
                yield from elements(each)


def links_in(state: State) -> list[str]:
    """The library states that a state, or one within it, links."""
    return [each["link"] for each in elements(state) if isinstance(each.get("link"), str)]


def closure_of(name: str, library: Mapping[str, State]) -> dict[str, State]:
    """A library state and all that it links, and these, as far as the library has them."""
    found: dict[str, State] = {}
    waiting = [name]
    while waiting:
        state = library.get(waiting.pop())
        if state is not None and state["state"] not in found:
            found[state["state"]] = state
            waiting += links_in(state)
    return found


def services_in(state: State) -> set[str]:
    """The services that the code of a state names; what waits for a time needs the timer."""
    found: set[str] = set()
    for element in elements(state):
        for field in CODE:
            if isinstance(element.get(field), str):
                found |= set(SERVICE.findall(element[field]))
        found |= {"timer"} if "after" in element else set()
    return found


def read_skills(race: Client) -> dict[str, Skill]:
    """The skills by name, of the document that has the most: two documents may have different skills of one name.

    What the planner has written itself does not count: it has copies.
    """
    documents = [race.documents.get(summary["name"])["document"] for summary in race.documents.all() if not summary["errors"]]
    return max((skills_of(document) for document in documents if not is_planned(document)), key=len, default={})


def skills_of(document: Mapping[str, Any]) -> dict[str, Skill]:
    library = {state["state"]: state for state in document.get("library", [])}
    services = document.get("services", {})
    return {name: Skill(state, library, services) for name, state in library.items() if meta_of(state).get("skill") is True}


def is_planned(document: Mapping[str, Any]) -> bool:
    """Whether the planner has written a document, or draft of whatever shape."""
    root = document.get("root")
    return isinstance(root, dict) and meta_of(root).get(PLANNED) is True
