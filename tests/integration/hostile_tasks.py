"""Tasks that do within their budgets what is bad for others (core/SEMANTICS.md, section 8), over and over again.

Each goes on from macro step to macro step with a `wait` of no time, so that it always has something to do. Two come to the
end of a budget, in a fault or an interruption, and begin again when somebody says so.
"""
import models
from floods import COUNTING

LARGE = 100_000  # bytes


def repeated(name, work, times=1, variables=()):
    """Does the work so many times in each macro step, from one macro step to the next."""
    busy = {"state": "Busy", "keep": True, "variables": [{"name": "n", "initial": 0}, *variables],
            "entry": f"var.n += 1\n{work}\nif var.n % {times} == 0:\n    svc.timer.wait(0)",
            "ports": [{"name": "more", "when": f"var.n % {times} > 0", "to": "Again"},
                      {"name": "next", "when": "svc.timer.wait.result", "to": "Again"}]}
    again = {"state": "Again", "ports": [{"name": "next", "when": "True", "to": "Busy"}]}
    return models.document(name, {"state": "Root", "first": "Busy", "children": [busy, again]})


def steps():
    """Macro steps of nearly as many micro steps as may be, all cheap."""
    return repeated("steps", "pass", 2000)


def work():
    """Functions that use up their budget with large data, as many as a macro step may have."""
    return repeated("work", "\n".join([
        "numbers = [i * 7919 % 100003 for i in range(45000)]",
        "numbers.sort()",
        "text = 'a' * 300000",
        "found = text.find('b')",
        "text = text[1:] + 'a'"]), 10)


def prints():
    """Prints as much as a macro step may."""
    return repeated("prints", "line = 'x' * 1000\nfor i in range(900):\n    print(line)")


def growth():
    """A value that grows to what one may have, and is small again."""
    grow = f"var.large = (var.large if len(var.large) < 8 else []) + ['x' * {LARGE} + str(var.n)]"
    return repeated("growth", grow, variables=[{"name": "large", "initial": []}])


def calls():
    """Makes nearly as many calls as a macro step may have."""
    return repeated("calls", "for i in range(2400):\n    svc.db.get('nothing')\n    svc.timer.wait(0)")


def divergence():
    """Micro steps without end: a fault after 10 000."""
    to = lambda me, other: {"state": me, "ports": [{"name": "next", "when": "True", "to": other}]}
    return models.document("divergence", {"state": "Root", "first": "A", "children": [to("A", "B"), to("B", "A")]})


def conditions():
    """A macro step that computes for seconds: it is given up, and the run is interrupted."""
    return models.diverging("conditions")


def events():
    """A macro step for each event of the display."""
    return {**COUNTING, "name": "events"}


KINDS = (steps, work, prints, growth, calls, divergence, conditions, events)
