"""The state of a run from a snapshot and the deltas after it (api/schemas/core_state.json, core_delta.json). Pure: nothing is changed."""
from collections.abc import Iterable, Mapping

from .messages import CoreDelta, CoreState, Json, RunState

OVER = ("ended", "faulted", "aborted")  # statuses of a run that is over


def is_over(status: str) -> bool:
    """Whether a run with this status is over for good."""
    return status in OVER


def fold(before: CoreState, delta: CoreDelta) -> CoreState:
    """What is after a delta. Lists are in the order in which their elements became active; an order of the model is not kept."""
    state, unset = before["state"], delta["unset"]
    after: RunState = {
        "active": members(state["active"], delta["active"]),
        "ports": members(state["ports"], delta["ports"]),
        "activated": {path: ports for path, ports in {**state["activated"], **delta["activated"]}.items() if ports},
        "parameters": values(state["parameters"], delta["parameters"], unset.get("parameters", {})),
        "results": values(state["results"], delta["results"], unset.get("results", {})),
        "variables": values(state["variables"], delta["variables"], unset.get("variables", {})),
    }
    return {"core": delta["core"], "state": after}


def members(before: Iterable[str], changes: Mapping[str, bool]) -> list[str]:
    """Names that are active now."""
    kept = [name for name in before if changes.get(name, True)]
    known = set(kept)
    return kept + [name for name, is_active in changes.items() if is_active and name not in known]


def values(before: Mapping[str, dict[str, Json]], changes: Mapping[str, dict[str, Json]],
           unset: Mapping[str, list[str]]) -> dict[str, dict[str, Json]]:
    """Path -> name -> value, without those that are set no more."""
    after = dict(before)
    for path in {*changes, *unset}:
        gone = unset.get(path, [])
        both = {**before.get(path, {}), **changes.get(path, {})}
        after[path] = {name: value for name, value in both.items() if name not in gone}
        if not after[path]:
            del after[path]
    return after
