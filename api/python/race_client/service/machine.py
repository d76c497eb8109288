"""The present state of one service, by its RSM: which calls it takes, and which transitions answer them. Without sockets and threads."""
from collections.abc import Mapping
from dataclasses import dataclass

from ..messages import Json

Transition = Mapping[str, Json]


@dataclass(frozen=True)
class Resolved:
    """A call whose answer was deferred, and is due; `code`: it is the error of this code; None: the result."""

    call: int
    code: str | None


class Machine:
    """Begins in the first state. Its rules are those of core/SEMANTICS.md, section 5."""

    def __init__(self, rsm: Mapping[str, Json]) -> None:
        self.state: str = rsm.get("init", "")
        self.is_interface = not rsm.get("states")
        self._transitions: dict[str, Transition] = {each["id"]: each for each in rsm.get("transitions", [])}
        self._deferred: dict[str, list[int]] = {}  # by the transition that took them

    def transition(self, name: str) -> Transition:
        """KeyError: there is none of this id."""
        return self._transitions[name]

    def accepting(self, operation: str) -> Transition | None:
        """The transition by which the present state takes a call; None: it rejects it."""
        return next((each for each in self._transitions.values() if each.get("operation") == operation and self._leaves_here(each)), None)

    def take(self, transition: Transition, call: int = 0) -> tuple[list[Resolved], int]:
        """Takes it: the calls that it answers, and the one that has no answer any more, as this call has its place (0: none)."""
        self.state = transition["dst"]
        superseded = 0
        named = 0 if transition.get("operation") else call  # by an operation: it has a call of its own
        if transition.get("operation") and transition.get("defer"):
            waiting = self._deferred.setdefault(transition["id"], [])
            if waiting and not transition.get("concurrent"):
                superseded = waiting.pop()
            waiting.append(call)
        return [Resolved(each, transition.get("error")) for each in self._answered_by(transition, named)], superseded

    def ending(self, transition: Transition, code: str | None) -> Transition | None:
        """The transition that answers a call that `transition` took: with an error of this code, or with a result."""
        all_ = [self._transitions[name] for name in transition.get("defer", []) if not self._transitions[name].get("operation")]
        here = [each for each in all_ if self._leaves_here(each)] or all_
        fitting = [each for each in here if code is not None and each.get("error") == code]
        return next(iter([*fitting, *(each for each in here if not each.get("error"))]), None)

    def drop(self, call: int) -> None:
        """The call has been answered otherwise."""
        for waiting in self._deferred.values():
            if call in waiting:
                waiting.remove(call)

    def _leaves_here(self, transition: Transition) -> bool:
        return transition.get("src") in (None, self.state)

    def _answered_by(self, transition: Transition, call: int) -> list[int]:
        """One without `src` answers all; else those that are deferred to it: of concurrent ones the one that it names, or the earliest."""
        ends_all = transition.get("src") is None
        deferring = [name for name, waiting in self._deferred.items()
                     if waiting and (ends_all or transition["id"] in self._transitions[name].get("defer", []))]
        concurrent = [] if ends_all else [name for name in deferring if self._transitions[name].get("concurrent")]
        one = call or min((self._deferred[name][0] for name in concurrent), default=0)
        answered: list[int] = []
        for name in deferring:
            waiting = self._deferred[name]
            chosen = [each for each in waiting if each == one] if name in concurrent else list(waiting)
            answered += chosen
            self._deferred[name] = [each for each in waiting if each not in chosen]
        return answered
