"""A server without a cell, for the example planner: it does what a document of skills says with parts that are names and places."""
import contextlib
import math

from skills import DOCUMENT
from skills import errors as errors_of

from planner.table import BODIES
from race_client import ServiceError, Update

DOWN = {"position": [0.0, 0.0, 0.0], "orientation": [0.0, 0.0, 0.0, 1.0]}
KEYS = ("robot", "gripper", "obj_rec", "db", "display", "audio", "timer")


class PlayedServer:
    """Plays `documents`, `services` and `cores` of race_client.Client. `parts`: label -> [x, y]. `fail`: path of a step -> ports that it
    ends with, one in each run, before it does what it should. `away`: keys of services. `runs`: the documents that ran."""

    def __init__(self, parts, fail=(), away=(), status="ended", database=()):
        self.parts, self.held = {label: list(at) for label, at in parts.items()}, None
        self.fail = {path: list(ports) for path, ports in dict(fail).items()}
        self.database = {"o_t_c": DOWN, "pose_home": {"pose": DOWN, "q": [0.0] * 7}, **dict(database)}
        self.away, self.status, self.stored, self.runs, self.deleted, self.outcome = away, status, {}, [], [], None
        self.documents = self.services = self.cores = self

    # documents
    def all(self):
        """Of documents, and of services."""
        return [{"name": "skills", "errors": 0, "key": key, "available": key not in self.away} for key in KEYS]

    def check(self, document, *, name):
        library, found = {state["state"] for state in document["library"]}, []
        states = [("Sorting", document["root"]), *((f"library/{state['state']}", state) for state in document["library"])]
        while states:
            path, state = states.pop()
            if state.get("link") not in (None, *library):
                found.append({"path": path, "code": "link_unknown", "message": f"the library has no state `{state['link']}`"})
            states += [(f"{path}/{child['state']}", child) for child in state.get("children", []) if "state" in child]
        return found

    def put(self, name, document, **_):
        assert self.check(document, name=name) == []
        self.stored[name] = document

    # services
    def call(self, service, operation, *arguments):
        poses = {label: {**DOWN, "position": [*at, BODIES[label][1]]} for label, at in self.parts.items()}
        seen = [{"label": label, "confidence": 0.9, "pose": pose} for label, pose in poses.items()]
        answers = {"look": {"objects": seen}, "labels": list(BODIES), "state": {"holding": self.held is not None},
                   "list": [key for key in self.database if key.startswith("".join(map(str, arguments[:1])))]}
        if operation == "add":
            self.database[arguments[0]] = arguments[1]
        elif operation == "get" and arguments[0] not in self.database:
            raise ServiceError(service, operation, {"code": "not_found", "message": f"the database has no `{arguments[0]}`"})
        return answers.get(operation, self.database.get(arguments[0] if arguments else ""))

    # cores
    def get(self, name):
        if name == "skills":
            return {"document": DOCUMENT}
        return {"status": self.status, "outcome": self.outcome}

    def create(self, name):
        self.runs.append(self.stored[name])
        return {"id": name}

    def start(self, core):
        pass

    def delete(self, core):
        self.deleted.append(core)

    def follow(self, core):
        return contextlib.nullcontext(Played(self.run(self.stored[core]["root"])))

    def run(self, root):
        """The updates of a run, one for each step."""
        whys, self.outcome = {}, "error"
        for task in root["children"]:
            for step in task["children"]:
                path = f"Sorting/{task['state']}/{step['state']}"
                port = self.port_of(path, {each["name"]: each.get("value") for each in step.get("parameters", [])}, step["link"])
                whys = {**whys, path: {"why": "" if port == "success" else f"because of {port}"}}
                yield Update("delta", {"state": {"results": whys}}, {"fired": [f"{path}/Within.success", f"{path}.{port}"]})
                goes_on = any(each["name"] == port and "to" in each for each in step.get("ports", []))
                if port in errors_of(step["link"]) and not goes_on:
                    return
        self.outcome = "success"

    def port_of(self, path, values, skill):
        """What the step does, and how it ends."""
        if self.fail.get(path):
            port, act = self.fail[path].pop(0)
            act(self)
            if port is not None:
                return port
        if skill == "SearchObject":
            self.found = values["labels"][0]
            return "success" if self.found in self.parts else "none"
        if skill == "PickFound":
            if self.held is not None or self.found not in self.parts:
                return "occupied" if self.held is not None else "no_found"
            self.held = self.found
            del self.parts[self.held]
        if skill == "PlaceAt":
            at = self.database[f"pose_{values['pose']}"]["pose"]["position"][:2]
            if self.held is None:
                return "no_part"
            if any(math.dist(at, other) < 0.1 for other in self.parts.values()):
                return "collision"
            self.parts[self.held], self.held = at, None
        if skill == "CalibrateCamera":
            self.database["o_t_c"] = DOWN
        return "success"


class Played:
    """Updates that come one by one."""

    def __init__(self, updates):
        self.updates = updates

    def next(self, timeout):
        return next(self.updates, None)
