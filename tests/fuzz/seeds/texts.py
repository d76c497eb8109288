"""Documents, code and robots."""
from seeds.project import ROOT, compact, examples, models, objects, read, scripts

CODE = {"when", "do", "entry", "exit", "from", "after", "expr", "external"}  # fields of documents that hold code

ROBOT = """<?xml version="1.0"?><robot name="r"><!-- c --><material name="m"><color rgba="1 0.5 0 1"/></material>
<link name="a"><visual><origin xyz="0 0 1" rpy="0 0 0"/><geometry><{shape}/></geometry><material name="m"/></visual></link>
<link name="b"><inertial><origin xyz="0 0 0"/><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><geometry><{shape}/></geometry></collision></link>
<joint name="j" type="{type}"><parent link="a"/><child link="b"/><axis xyz="0 2 0"/>
<limit lower="-1" upper="1" effort="10" velocity="2"/><dynamics damping="1" friction="0"/></joint></robot>"""


def documents():
    """Documents, and descriptions of services."""
    services = [service for script in scripts().values() for service in script.get("services", {}).values()]
    pick = read(ROOT / "deploy/demo/pick.rcm.json")
    return [compact(each) for each in [*models(), *examples("document.*.json"), pick, *services]]


def codes():
    demonstrator = read(ROOT / "deploy/demo/demonstrator.rcm.json")
    texts = [text for model in [*models(), demonstrator] for item in objects(model)
             for key, text in item.items() if key in CODE and isinstance(text, str)]
    lines = (ROOT / "tests/unit/core/language/expressions.txt").read_text(encoding="utf-8").splitlines()
    expressions = [line for line in lines if line and not line.startswith("#")]
    return texts + [f"res.out = [{', '.join(expressions[i:i + 3])}]" for i in range(0, len(expressions), 3)]


def robots():
    demo = (ROOT / "deploy/demo/lwr_wsg50.urdf").read_text(encoding="utf-8")
    kinds = [('sphere radius="0.1"', "revolute"), ('box size="1 2 3"', "prismatic"),
             ('cylinder radius="1" length="2"', "fixed"), ('mesh filename="m.stl" scale="1 1 1"', "continuous")]
    return [demo, *(ROBOT.format(shape=shape, type=kind) for shape, kind in kinds)]
