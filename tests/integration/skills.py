"""The skills of the demo (api/skills.md), run one after the other in the demo's cell, with what goes wrong there."""
import copy
import json

from cell import BODIES, DATABASE, DECOY, NAMES, O_T_C, read, scene
from scenario import link, run, task

DOCUMENT = read("skills.rcm.json")
LIBRARY = {state["state"]: state for state in DOCUMENT["library"]}
SKILLS = {name: state for name, state in LIBRARY.items() if state["meta"].get("skill")}
TAUGHT = {name.removeprefix("pose_"): value for name, value in DATABASE.items() if name.startswith("pose_")}
FAR = {"pose": {"position": [2.0, 0.0, 0.1], "orientation": [1, 0, 0, 0]}, "q": [9.0, 0, 0, 0, 0, 0, 0]}
REST = 0.6  # s
KNOWN = {**DATABASE, "o_t_c": O_T_C, "pose_far": FAR}
HOME = TAUGHT["home"]["pose"]["position"]
STAND = {"name": "stand", "shape": {"box": [0.03, 0.03, HOME[2] - 0.02]}, "mass": 2, "friction": 0.8, "colour": "#888888",
         "pose": {"position": [*HOME[:2], HOME[2] / 2 - 0.01], "orientation": [0, 0, 0, 1]}}
HELD = link("CloseGripper", "Held")  # takes the cube where the arm is, with STAND and these acts
ON_STAND = ({"do": {"act": "place", "part": NAMES["Cube"], "pose": {"position": HOME, "orientation": [0, 0, 0, 1]}}},
            {"when": {"fires": "Root/Held.success"}, "do": {"act": "take", "part": "stand"}})


def errors(skill):
    """The names of its ports that are errors."""
    return [port["name"] for port in SKILLS[skill]["ports"] if "advice" in port["meta"]]


def task_of(*links, after="success", beside=None, absent=None, rest=None):
    """A task of skills. Its result `why` is that of the last one. `beside`: code that is run at the beginning, or (seconds, code);
    `absent`: the key of a service that is not there; `rest`: a port of the last one after which the task goes on for REST."""
    document = task(*copy.deepcopy(links), after=after, document=DOCUMENT)
    root, last = document["root"], links[-1]["state"]
    root["results"].append({"name": "why", "initial": ""})
    if links[-1]["link"] in SKILLS:
        root["actions"].append({"when": f"chi.{last}.res.why != ''", "do": f"res.why = chi.{last}.res.why"})
    if rest is not None:
        root["children"][-1]["ports"] = [{"name": rest, "to": "Rest"}]
        root["children"].append({"state": "Rest", "ports": [{"name": "over", "after": str(REST)}]})
        next(port for port in root["ports"] if port["name"] == rest)["when"] = "chi.Rest.port.over"
    if beside is not None:
        seconds, code = beside if isinstance(beside, tuple) else (None, beside)
        acting = {"state": "Acting", "entry": code}
        wait = {"state": "Wait", "ports": [{"name": "over", "after": str(seconds), "to": "Acting"}]}
        now = {"state": "Beside", "children": [wait, acting], "first": "Wait"} if seconds is not None else {**acting, "state": "Beside"}
        root["children"] = [now, *root["children"], {"barrier": "Both", "to": ["Beside", root["first"]]}]
        root["first"] = "Both"
    if absent is not None:
        document = json.loads(json.dumps(document).replace(f"svc.{absent}.", f"svc.absent_{absent}."))
    return document


def run_skills(*links, acts=(), database=None, further=(), parts=tuple(NAMES), **options):
    """Runs skills one after the other; `options` of task_of() and run(). `further`: more bodies of the scene."""
    of_task = {key: options.pop(key) for key in ("after", "beside", "absent", "rest") if key in options}
    files = {"scene.json": scene(parts, BODIES[DECOY], *further), **options.pop("files", {})}
    return run(task_of(*links, **of_task), *acts, database=KNOWN if database is None else database, parts=parts, files=files, **options)


def squeeze(state, after=0.02):
    """Two hands keep the fingers from opening for a while, when the state is active."""
    push = lambda finger, force: {"act": "push", "body": finger, "force": [0, force, 0], "duration": 2.0}
    return {"when": {"active": state, "after": after}, "do": [push("finger_left", 100), push("finger_right", -100)]}


def take(label="Cube", **when):
    """The experimenter takes a part away."""
    return {"when": when, "do": {"act": "take", "part": NAMES[label]}} if when else {"do": {"act": "take", "part": NAMES[label]}}
