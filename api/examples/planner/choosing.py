"""Writes the states of a task that asks the service Oracle before each move which one comes next: an oracle of kind `external`
(core/SEMANTICS.md, section 6). Of the moves it knows their names, and how they end.

    Sorting   Next, again and again; after a move that has failed, Aside comes in between
    Next      enters the child that svc.Oracle.decide names: Sorted, or a move; without an answer that names one: Refused
"""
from collections.abc import Sequence
from typing import Any

from .goal import Goal
from .tasks import NEXT, ROOT

Json = Any
ORACLE = "Oracle"  # key and type of the service
SERVICES = {ORACLE: ORACLE}
ANSWER = f"svc.{ORACLE}.decide"
SORTED, REFUSED = "Sorted", "Refused"  # children beside the moves
WRONG = "which is no move of this task"  # an answer that names no child


def root_of(goal: Goal, aside: Json, moves: Sequence[Json]) -> dict[str, Json]:
    """`aside`: brings the arm out of the way, then leads to NEXT (port `error`: it does not). `moves`: with the ports `success`, `error`
    and `stopped`, after which nothing may be moved again. The result `why` is why the task has ended with `error`."""
    actions = [("chi.Next.res.why != ''", "res.why = chi.Next.res.why"),
               ("chi.Next.port.moved or chi.Next.port.failed", "var.moves += 1"),
               ("chi.Next.port.stopped", "res.why = 'the robot was stopped'"),
               ("chi.Aside.port.error", "res.why = 'the arm does not get out of the way'")]
    # The last two actions run in the micro step after the port has fired: `error` waits for what they write.
    error = "chi.Next.port.refused or (chi.Next.port.stopped or chi.Aside.port.error) and res.why != ''"
    return {"state": ROOT, "parameters": [{"name": "parts", "value": dict(goal.parts), "doc": "Which part belongs at which place"}],
            "results": [{"name": "why", "initial": "", "type": "string", "doc": "Why the parts are not sorted"}],
            "variables": [{"name": "moves", "initial": 0, "doc": "Moves that were made, also in vain"}],
            "actions": [{"when": when, "do": do} for when, do in actions], "children": [next_of(goal, moves), aside], "first": NEXT,
            "ports": [{"name": "success", "when": "chi.Next.port.sorted"}, {"name": "error", "when": error}]}


def next_of(goal: Goal, moves: Sequence[Json]) -> dict[str, Json]:
    """One decision, and the move that it names. The places are no parameters of the task: the poses of the moves are made for them."""
    ending = lambda port: " or ".join(f"chi.{move['state']}.port.{port}" for move in moves) or "False"
    actions = [(f"{ANSWER}.error", f"e = {ANSWER}.error\nres.why = e.get('message', 'planner: ' + e.code)"),
               (f"chi.{REFUSED} and {ANSWER}.result", f"res.why = f'the planner chose {{{ANSWER}.result}}, {WRONG}'")]
    ends = [{"state": name, "ports": [{"name": "done", "when": "True"}]} for name in (REFUSED, SORTED)]
    return {"state": NEXT, "meta": {"title": "The next move"},
            "parameters": [{"name": "parts", "from": "par.parts"}, {"name": "moves", "from": "var.moves"},
                           {"name": "places", "value": {name: list(at) for name, at in goal.places.items()}, "unit": "m"}],
            "results": [{"name": "why", "initial": "", "type": "string", "doc": "Why there is no next move"}],
            "actions": [{"when": when, "do": do} for when, do in actions], "children": [*ends, *moves], "first": REFUSED,
            "oracle": {"kind": "external", "call": f"{ANSWER}(par.parts, par.places, par.moves)"},
            "ports": [{"name": "sorted", "when": f"chi.{SORTED}.port.done"}, {"name": "refused", "when": f"chi.{REFUSED}.port.done"},
                      {"name": "stopped", "when": ending("stopped")}, {"name": "moved", "when": ending("success"), "to": NEXT},
                      {"name": "failed", "when": ending("error"), "to": "Aside"}]}
