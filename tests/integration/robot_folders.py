"""The robot folders of deploy/robots: URDFs with their kinematics, and the boxes around meshes. Independent of what generates them."""
import math
import struct
import xml.etree.ElementTree as ET
from pathlib import Path

ROBOTS = Path(__file__).resolve().parents[2] / "deploy" / "robots"
COLLADA = "{http://www.collada.org/2005/11/COLLADASchema}"


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column, strict=True)) for column in zip(*b, strict=True)] for row in a]


def transform(xyz=(0, 0, 0), rpy=(0, 0, 0)):
    """A 4x4 matrix of URDF's <origin>: rotations about the fixed axes x, y, z."""
    (cr, cp, cy), (sr, sp, sy) = (tuple(map(f, rpy)) for f in (math.cos, math.sin))
    return [[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, xyz[0]],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, xyz[1]],
            [-sp, cp * sr, cp * cr, xyz[2]], [0, 0, 0, 1]]


def placed(pose, point):
    return [sum(a * b for a, b in zip(row, (*point, 1), strict=True)) for row in pose[:3]]


def numbers(element, name, count=3):
    text = element.get(name) if element is not None else None
    return [float(word) for word in text.split()] if text else [0.0] * count


class Urdf:
    def __init__(self, path):
        self.path = path
        self.xml = ET.parse(path).getroot()
        self.links = {link.get("name"): link for link in self.xml.findall("link")}
        self.joint_to = {joint.find("child").get("link"): joint for joint in self.xml.findall("joint")}

    def chain(self, tip="tcp"):
        """Joints from the root to the link `tip`."""
        joints = []
        while tip in self.joint_to:
            joints.insert(0, self.joint_to[tip])
            tip = joints[0].find("parent").get("link")
        return joints

    def moving(self):
        return [joint for joint in self.chain() if joint.get("type") != "fixed"]

    def poses(self, q):
        """Of each link on the way to `tcp`, seen from the root; `q` [rad] of the joints that move."""
        pose, angles = transform(), iter(q)
        poses = {self.chain()[0].find("parent").get("link"): pose}
        for joint in self.chain():
            origin = joint.find("origin")
            pose = product(pose, transform(numbers(origin, "xyz"), numbers(origin, "rpy")))
            if joint.get("type") != "fixed":
                assert joint.find("axis").get("xyz") == "0 0 1", joint.get("name")
                pose = product(pose, transform(rpy=(0, 0, next(angles))))
            poses[joint.find("child").get("link")] = pose
        return poses

    def mass(self, link):
        return float(self.links[link].find("inertial/mass").get("value"))

    def centre(self, link):
        return numbers(self.links[link].find("inertial/origin"), "xyz")

    def inertia(self, link):
        xx, xy, xz, yy, yz, zz = (float(self.links[link].find("inertial/inertia").get(name))
                                  for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
        return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]

    def meshes(self, link, kind):
        """Files of the link's meshes; a package is a folder below ROBOTS whose package.xml says its name."""
        packages = {ET.parse(file).getroot().findtext("name"): file.parent for file in ROBOTS.glob("*/package.xml")}
        files = []
        for mesh in self.links[link].findall(f"{kind}/geometry/mesh"):
            scheme, _, rest = mesh.get("filename").partition("://")
            package, _, name = rest.partition("/")
            assert scheme == "package" and package in packages, mesh.get("filename")
            files.append(packages[package] / name)
        return files


def triangles_of(file):
    if file.suffix == ".stl":
        return struct.unpack_from("<I", file.read_bytes(), 80)[0]
    return sum(int(element.get("count")) for element in ET.parse(file).iter(COLLADA + "triangles"))


def corners_of(file):
    """All corners [m]; of COLLADA, which says z up and metres."""
    if file.suffix == ".stl":
        data = file.read_bytes()
        count = struct.unpack_from("<I", data, 80)[0]
        assert len(data) == 84 + 50 * count, file
        return [data_corner for i in range(count) for data_corner in
                (struct.unpack_from("<3f", data, 84 + 50 * i + 12 * corner) for corner in (1, 2, 3))]
    root = ET.parse(file).getroot()
    assert root.find(f"{COLLADA}asset/{COLLADA}up_axis").text == "Z_UP" and root.find(f"{COLLADA}asset/{COLLADA}unit").get("meter") == "1"
    corners = []
    for array in root.iter(COLLADA + "float_array"):
        if "corners" in array.get("id"):
            values = [float(word) for word in array.text.split()]
            corners += list(zip(values[::3], values[1::3], values[2::3], strict=True))
    return corners


def box_around(corners):
    return [(min(values), max(values)) for values in zip(*corners, strict=True)]


def meet(a, b):
    """Whether two boxes along the same axes have a point in common."""
    return all(low_a <= high_b and low_b <= high_a for (low_a, high_a), (low_b, high_b) in zip(a, b, strict=True))
