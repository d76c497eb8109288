"""Scenarios: library states of the demonstrator run headless as tasks in the demo's cell, with a scripted person."""
import json
import math
import subprocess
import tempfile
from pathlib import Path

import models
from cell import BODIES, DATABASE, DOCUMENT, DECOY, NAMES, copy_cell, scene
from client import PROGRAM, check

LET_GO = "Let go of the arm before you answer: it may move. What is to be done?"
QUESTION = {"display": {"text": "What is to be done?"}, "after": 0.2}


def part(label):
    return {"label": label, "o_t_x": BODIES[NAMES[label]]["pose"]}


def link(of, name=None, **parameters):
    return {"state": name or of, "link": of, "parameters": [{"name": k, "value": v} for k, v in parameters.items()]}


def task(*links, after="success", library=(), document=DOCUMENT):
    """A task of the library states of `document` in sequence: the first is left through port `after`, the others through `success`; every
    other port, and those of the last, end the task. Results: pose of the tool (`pose`), state of the gripper (`gripper`), those of the
    links (`Pick_x_t_g`). `library`: further states that may be linked."""
    library = [*document["library"], *library]
    known = {state["state"]: state for state in library}
    found, ends = [], {}
    for i, each in enumerate(links):
        name, of, onward = each["state"], known[each["link"]], "success" if i else after
        for result in of.get("results", []):
            value = f"chi.{name}.res.{result['name']}"
            begins = result.get("initial", [])  # copied once it is another, as an action is done once in a macro step
            differs = "" if isinstance(begins, list) else f" and {value} != {begins!r}"
            found.append((f"{name}_{result['name']}", value, f"available({value}){differs}"))
        for port in (p["name"] for p in of["ports"]):
            if port == onward and each is not links[-1]:
                each["ports"] = [{"name": port, "to": links[i + 1]["state"]}]
            else:
                ends.setdefault(port, []).append(f"chi.{name}.port.{port}")
    return models.document("handling", {
        "state": "Root", "results": [{"name": name} for name in ("pose", "gripper", *(each[0] for each in found))],
        "actions": [{"when": "svc.robot.robot_state", "do": "res.pose = svc.robot.robot_state.pose"},
                    {"when": "svc.gripper.gripper_state", "do": "res.gripper = svc.gripper.gripper_state"},
                    *({"when": when, "do": f"res.{name} = {value}"} for name, value, when in found)],
        "children": list(links), "first": links[0]["state"],
        "ports": [{"name": name, "when": " or ".join(whens)} for name, whens in ends.items()]}, library=library)


class Outcome:
    """The output of `race run`: the summary and all reports in order of time."""

    def __init__(self, lines):
        self.reports = [json.loads(line) for line in lines]
        self.last = self.reports[-1]
        self.name, self.results = self.last.get("outcome"), self.last["results"]
        self.fired = [port for r in self.reports for port in r.get("fired", [])]
        self.sent = [call for r in self.reports for call in r.get("calls", [])]
        self.calls = [f"{c['service']}.{c['operation']}" for c in self.sent]

    def events(self, name):
        inputs = [r["input"] for r in self.reports if r.get("input", {}).get("event") == name]
        return [each["data"] for each in inputs]

    def time(self, port, index=0):
        return [r["time"] for r in self.reports if port in r.get("fired", [])][index]

    def called(self, service, operation):
        return [c for c in self.sent if (c["service"], c["operation"]) == (service, operation)]

    def texts(self):
        """The texts sent to displays, in order."""
        return [c["args"][0] for c in self.called("display", "show_text")]

    def asked(self):
        """The questions sent to displays, in order."""
        return [c["args"][0] for c in self.sent if c["service"] == "display" and c["operation"] in ("ask", "choose")]


def run(document, *acts, displays=("phone",), limit=120, arguments=None, database=DATABASE, parts=tuple(NAMES), files=None, without=()):
    """Runs the task headless with these acts of a person and these parts on the table. `displays` None: no person. `files`, `without`:
    changes of the cell, see copy_cell()."""
    files = {"database.json": database, "scene.json": scene(parts, BODIES[DECOY])} | (files or {})
    words = ["--fast", "--json", "--seed", "7", "--limit", str(limit), "--arguments", json.dumps(arguments or {})]
    with tempfile.TemporaryDirectory() as folder:
        model, operator = Path(folder, "model.rcm.json"), Path(folder, "operator.json")
        model.write_text(json.dumps(document))
        if displays is not None:
            operator.write_text(json.dumps(check("operator", {"operator": 1, "displays": list(displays), "acts": list(acts)})))
            words += ["--operator", operator]
        out = subprocess.run([PROGRAM, "run", model, "--cell", copy_cell(Path(folder, "cell"), files, without), *words],
                             capture_output=True, text=True, timeout=280, check=False)
    assert out.returncode in (0, 1) and "refused" not in out.stdout, out.stderr + out.stdout[-2000:]
    return Outcome(out.stdout.splitlines())


def bump(state, after=0.1, force=40.0, count=1):
    """An accidental collision while the state is active: a short force."""
    return {"when": {"active": state, "after": after, "count": count},
            "do": {"act": "push", "body": "link_6", "force": [0, force, 0], "duration": 0.06, "rise": 0.005}}


def touch(state, after=0.5, force=25, count=1):
    """An intended touch: the force rises and falls slowly."""
    return {"when": {"active": state, "after": after, "count": count},
            "do": {"act": "push", "body": "gripper", "point": [0, 0, 0.05], "force": [0, force, 0], "duration": 0.8, "rise": 0.3}}


def gesture(state, force):
    """An intended push up or down while the state is active."""
    return {"when": {"active": state, "after": 0.05},
            "do": {"act": "push", "body": "gripper", "point": [0, 0, 0.15], "force": [0, 0, force], "duration": 0.6, "rise": 0.2}}


def answer(button, when=QUESTION):
    return {"when": when, "do": {"act": "answer", "button": button}}


HANDS = {"left": [0, 0.07, 0.05], "right": [0, -0.07, 0.05], "third": [0, 0, 0.13]}


def drag(by, speed=0.3):
    """All hands drag the gripper, so that it does not turn."""
    return [{"act": "drag", "hand": h, "by": by, "speed": speed} for h in HANDS]


def lead(state, *ways):
    """Three hands grab the gripper, lead it along `ways` and release it when it holds its position."""
    grab = [{"act": "grab", "hand": h, "body": "gripper", "point": p, "keep": 60} for h, p in HANDS.items()]
    acts = [{"when": {"active": f"{state}/Grip", "after": 0.2}, "do": [*grab, {"act": "answer", "button": "Done"}]},
            {"when": {"active": f"{state}/Lead", "after": 0.2}, "do": drag(ways[0])}]
    for way, before in zip([*ways[1:], None], ways, strict=True):
        pause = {"after": 1.2 + math.hypot(*before) / 0.3}
        acts.append({"when": pause, "do": drag(way)} if way else answer("Done", pause))
    return [*acts, {"when": {"active": f"{state}/LetGo", "after": 0.2}, "do": [{"act": "release", "hand": h} for h in HANDS]},
            answer("Done", {"after": 0.3})]
