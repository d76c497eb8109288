"""The RSM of a class whose operations say in which states the service is meanwhile. Pure."""
from collections.abc import Mapping

from ..messages import Json

READY = "Ready"  # the first state, and the one in which nothing is busy


def generated_rsm(name: str, operations: list[dict[str, Json]], states: Mapping[str, tuple[str | None, str | None]],
                  events: Mapping[str, Json]) -> dict[str, Json]:
    """`states`: of each operation, the state that it makes busy, and the one that it stops. `events`: the type of each, or all of it.

    One that is busy leads from READY to its state, and back when it is done. Every other is taken in each state, and answered by itself;
    one that stops leads back to READY. Each event may come in each state.
    """
    names = [READY, *dict.fromkeys(busy for busy, _ in states.values() if busy)]
    transitions: list[dict[str, Json]] = []
    for operation, (busy, stops) in states.items():
        if busy:
            enders = [transition_id(each, busy) for each, (_, stopped) in states.items() if stopped == busy]
            done = f"{operation}_done"
            transitions.append({"id": operation, "src": READY, "dst": busy, "operation": operation, "defer": [done, *enders]})
            transitions.append({"id": done, "src": busy, "dst": READY})
            continue
        for state in names:
            ends = state == stops
            transitions.append({"id": transition_id(operation, state), "src": state, "dst": READY if ends else state,
                                "operation": operation, **({"error": "stopped"} if ends else {})})
    listed = [{"name": event, **event_fields(what)} for event, what in events.items()]
    return {"rsm": 1, "name": name, "operations": operations, "events": listed,
            "states": [{"name": state, **({"events": list(events)} if events else {})} for state in names],
            "init": READY, "transitions": transitions}


def event_fields(what: Json) -> dict[str, Json]:
    """What an event has beside its name, of the type of its data, or of all of it."""
    return what if isinstance(what, dict) and "data" in what else {"data": what}


def transition_id(operation: str, state: str) -> str:
    """Of an operation that several states take."""
    return f"{operation}_{state}"
