"""A server without a cell, for the example planner: it does what a document of skills says with parts that are names and places."""
import contextlib
import math
from types import SimpleNamespace

from skills import DOCUMENT
from skills import errors as errors_of

from planner.table import BODIES
from race_client import RaceError, ServiceError, Update

DOWN = {"position": [0.0, 0.0, 0.0], "orientation": [0.0, 0.0, 0.0, 1.0]}
KEYS = ("robot", "gripper", "obj_rec", "db", "display", "audio", "timer")
BETWEEN_FINGERS = [0.5, 0.0, 0.18]  # where the camera sees a part that is held, if it does


class PlayedServer:
    """Plays `documents`, `services` and `cores` of race_client.Client. `parts`: label -> [x, y]. `fail`: path of a step -> (port, act): it
    ends with the port (None: as it should), one in each run, and `act(server)` is what somebody does then. `away`: keys of services.
    `status`: of runs that are over. `runs`: the documents that ran; `deleted`: cores."""

    def __init__(self, parts, fail=(), away=(), status="ended"):
        self.parts, self.held, self.sees_held = {label: list(at) for label, at in parts.items()}, None, False
        self.fail = {path: list(ports) for path, ports in dict(fail).items()}
        self.database = {"o_t_c": DOWN, "pose_home": {"pose": DOWN, "q": [0.0] * 7}}
        self.away, self.status, self.outcome, self.runs, self.deleted = away, status, None, [], []
        self.stored = {"skills": [DOCUMENT]}  # name -> revisions
        self.documents = SimpleNamespace(all=self.all_documents, get=self.get_document, check=self.check, put=self.put)
        self.services = SimpleNamespace(call=self.call, all=lambda: [{"key": key, "available": key not in self.away} for key in KEYS])
        self.cores = SimpleNamespace(create=self.create, start=lambda core: None, get=self.get_core, delete=self.deleted.append,
                                     follow=lambda core: contextlib.nullcontext(Played(self.run(self.runs[-1]["root"]))))

    def all_documents(self):
        return [{"name": name, "errors": 0} for name in self.stored]

    def get_document(self, name):
        if name not in self.stored:
            raise RaceError(404, [{"path": name, "code": "not_found", "message": "there is no such document"}])
        return {"document": self.stored[name][-1], "revision": len(self.stored[name])}

    def check(self, document, *, name):
        library, found = {state["state"] for state in document["library"]}, []
        states = [("Sorting", document["root"]), *((f"library/{state['state']}", state) for state in document["library"])]
        while states:
            path, state = states.pop()
            if state.get("link") not in (None, *library):
                found.append({"path": path, "code": "link_unknown", "message": f"the library has no state `{state['link']}`"})
            states += [(f"{path}/{child['state']}", child) for child in state.get("children", []) if "state" in child]
        return found

    def put(self, name, document, *, if_revision, is_new, author, message):
        assert self.check(document, name=name) == []
        revisions = self.stored.setdefault(name, [])
        if (if_revision or 0) != len(revisions) or is_new != (not revisions):
            raise RaceError(412, [{"path": name, "code": "conflict", "message": "it has another revision"}])
        revisions.append(document)
        return {"revision": len(revisions)}

    def call(self, service, operation, *arguments):
        poses = {label: {**DOWN, "position": [*at, BODIES[label][1]]} for label, at in self.parts.items()}
        if self.held and self.sees_held:
            poses[self.held] = {**DOWN, "position": BETWEEN_FINGERS}
        seen = [{"label": label, "confidence": 0.9, "pose": pose} for label, pose in poses.items()]
        answers = {"look": {"objects": seen}, "labels": list(BODIES), "state": {"holding": self.held is not None},
                   "list": [key for key in self.database if key.startswith("".join(map(str, arguments[:1])))]}
        if operation == "add":
            self.database[arguments[0]] = arguments[1]
        elif operation == "get" and arguments[0] not in self.database:
            raise ServiceError(service, operation, {"code": "not_found", "message": f"the database has no `{arguments[0]}`"})
        return answers.get(operation, self.database.get(arguments[0] if arguments else ""))

    def create(self, name):
        self.runs.append(self.stored[name][-1])
        return {"id": str(len(self.runs)), "revision": len(self.stored[name])}

    def get_core(self, core):
        return {"status": self.status, "outcome": self.outcome}

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
