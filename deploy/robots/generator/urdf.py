"""URDF of a robot: alone, and with the gripper of another URDF at its flange. Pure functions of texts and values."""
import xml.etree.ElementTree as ET

from .inertia import cylinder_inertia
from .robot import Joint, Link, Robot
from .vectors import Matrix, Vector

FOLDERS = (("visual", "dae"), ("collision", "stl"))


def _number(value: float) -> str:
    return f"{value:.15g}" if abs(value) > 1e-15 else "0"


def _rounded(value: float) -> str:
    return f"{value:.6g}"


def _vector(vector: Vector) -> str:
    return " ".join(_number(round(value, 15)) for value in vector)


def _inertia(tensor: Matrix) -> str:
    names = (("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2))
    largest = max(abs(value) for row in tensor for value in row)
    return " ".join(f'{name}="{_rounded(tensor[i][j] if abs(tensor[i][j]) > 1e-12 * largest else 0)}"' for name, i, j in names)


def _link(robot: Robot, link: Link) -> list[str]:
    inertia = _inertia(link.inertia or cylinder_inertia(link.mass, robot.pieces[link.name]))
    mass = _number(round(link.mass, 9))
    centre = " ".join(_rounded(value) for value in link.centre)
    lines = [f'  <link name="{link.name}">',
             f'    <inertial><origin xyz="{centre}"/><mass value="{mass}"/><inertia {inertia}/></inertial>']
    lines += [f'    <{kind}><geometry><mesh filename="package://{robot.name}/meshes/{kind}/{link.name}.{ending}"/></geometry></{kind}>'
              for kind, ending in FOLDERS]
    return [*lines, "  </link>"]


def _joint(joint: Joint) -> list[str]:
    lines = [f'  <joint name="{joint.name}" type="{"revolute" if joint.limits else "fixed"}">',
             f'    <parent link="{joint.parent}"/><child link="{joint.child}"/>',
             f'    <origin xyz="{_vector(joint.xyz)}" rpy="{_vector(joint.rpy)}"/>']
    if joint.limits:
        lower, upper = joint.limits
        lines.append(f'    <axis xyz="0 0 1"/><limit lower="{_number(lower)}" upper="{_number(upper)}" '
                     f'effort="{_number(joint.torque)}" velocity="{_number(joint.speed)}"/>')
    return [*lines, "  </joint>"]


def urdf_of(robot: Robot) -> str:
    """The arm, with the frames `flange` and, at the same place, `tcp`."""
    lines = ['<?xml version="1.0"?>', "<!-- Written by deploy/robots/make_urdfs.py. Sources of the figures: README.md of the robot. -->",
             f'<robot name="{robot.name}">']
    for i, link in enumerate(robot.links):
        lines += (_joint(robot.joints[i - 1]) if i else []) + _link(robot, link)
    tool = Joint("tcp_mount", "flange", "tcp", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    for joint in (robot.flange, tool):
        lines += [*_joint(joint), f'  <link name="{joint.child}"/>']
    return "\n".join([*lines, "</robot>", ""])


def _behind(joints: list[ET.Element], link: str) -> list[ET.Element]:
    """The joints behind a link, each after the one that carries it."""
    found = []
    for joint in joints:
        if joint.find("parent").get("link") == link:
            found += [joint, *_behind(joints, joint.find("child").get("link"))]
    return found


def with_gripper(arm: str, cell: str, turned: float) -> str:
    """The arm of one URDF with what another has from its link `gripper` on, with its `tcp`: mounted at the flange, turned about its axis
    by `turned` rad."""
    robot, source = ET.fromstring(arm), ET.fromstring(cell)
    robot.set("name", robot.get("name") + "_gripper")
    for element in robot.findall("*[@name='tcp']") + robot.findall("*[@name='tcp_mount']"):
        robot.remove(element)
    mount = ET.SubElement(robot, "joint", name="gripper_mount", type="fixed")
    ET.SubElement(mount, "parent", link="flange")
    ET.SubElement(mount, "child", link="gripper")
    ET.SubElement(mount, "origin", xyz="0 0 0", rpy=f"0 0 {_number(turned)}")
    links = {link.get("name"): link for link in source.findall("link")}
    parts = [links["gripper"]]
    for joint in _behind(source.findall("joint"), "gripper"):
        parts += [joint, links[joint.find("child").get("link")]]
    robot.extend(parts)
    used = {material.get("name") for part in parts for material in part.iter("material")}
    for i, material in enumerate(material for material in source.findall("material") if material.get("name") in used):
        robot.insert(i, material)
    ET.indent(robot)
    comment = "Written by deploy/robots/make_urdfs.py: the arm, and the gripper of deploy/demo/lwr_wsg50.urdf."
    head = f'<?xml version="1.0"?>\n<!-- {comment} -->\n'
    return head + ET.tostring(robot, encoding="unicode") + "\n"
