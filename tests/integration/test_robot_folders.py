"""deploy/robots: kinematics, masses and meshes of the six- and the seven-axis arm against the published figures. Without a server."""
import json
import math
import random
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ET

from reach import joints_at
from robot_folders import ROBOTS, Urdf, box_around, corners_of, meet, numbers, placed, product, transform, triangles_of

# a, alpha, d by Denavit and Hartenberg, distal: Universal Robots, "DH parameters for calculations of kinematics and dynamics", UR5e
UR5E = [(0, math.pi / 2, 0.1625), (-0.425, 0, 0), (-0.3922, 0, 0), (0, math.pi / 2, 0.1333), (0, -math.pi / 2, 0.0997), (0, 0, 0.0996)]
UR5E_LINKS = [(3.761, (0, -0.02561, 0.00193)), (8.058, (0.2125, 0, 0.11336)), (2.846, (0.15, 0, 0.0265)), (1.37, (0, -0.0018, 0.01634)),
              (1.3, (0, 0.0018, 0.01634)), (0.365, (0, 0, -0.001159))]
# a, alpha, d by Craig, proximal: Franka Control Interface documentation, Panda; the last one is the flange
PANDA = [(0, 0, 0.333), (0, -math.pi / 2, 0), (0, math.pi / 2, 0.316), (0.0825, math.pi / 2, 0), (-0.0825, -math.pi / 2, 0.384),
         (0, math.pi / 2, 0), (0.088, math.pi / 2, 0), (0, 0, 0.107)]
# Postures in which the tool of a cell starts, as in deploy/demo: at [0.4998, 0, 0.3134] with the orientation [1, 0, 0, 0]; README.md
STARTS = {"arm6": [-0.27, -1.593, 1.6553, -1.633, -1.5708, -0.27], "arm7": [0, -0.1665, 0, -2.1746, 0, 2.0081, 0]}


def turn(angle):
    return transform(rpy=(0, 0, angle))


def distal(rows, q):
    """Frames of Denavit and Hartenberg from the base outwards, each at the far end of its link."""
    pose, poses = transform(), []
    for (a, alpha, d), angle in zip(rows, q, strict=True):
        for step in (turn(angle), transform((0, 0, d)), transform((a, 0, 0)), transform(rpy=(alpha, 0, 0))):
            pose = product(pose, step)
        poses.append(pose)
    return poses


def proximal(rows, q):
    """Craig's frames from the base outwards, each at the near end of its link."""
    pose, poses = transform(), []
    for (a, alpha, d), angle in zip(rows, q, strict=True):
        for step in (transform(rpy=(alpha, 0, 0)), transform((a, 0, 0)), turn(angle), transform((0, 0, d))):
            pose = product(pose, step)
        poses.append(pose)
    return poses


def minors(m):
    """The leading ones, all positive where a symmetric matrix is positive definite."""
    return (m[0][0], m[0][0] * m[1][1] - m[0][1] * m[1][0],
            m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))


class RobotFolders(unittest.TestCase):
    def setUp(self):
        self.urdfs = {name: Urdf(ROBOTS / name / "urdf" / f"{name}.urdf") for name in ("arm6", "arm7")}
        self.cells = {name: Urdf(ROBOTS / f"{name}_gripper.urdf") for name in self.urdfs}

    def postures(self, urdf, count=50):
        chance = random.Random(15)
        limits = [joint.find("limit") for joint in urdf.moving()]
        return [[chance.uniform(float(limit.get("lower")), float(limit.get("upper"))) for limit in limits] for _ in range(count)]

    def assert_close(self, a, b, message):
        for row_a, row_b in zip(a, b, strict=True):
            for x, y in zip(row_a, row_b, strict=True):
                self.assertAlmostEqual(x, y, delta=1e-9, msg=message)

    def test_the_six_axis_arm_moves_by_the_published_parameters(self):
        urdf = self.urdfs["arm6"]
        for q in self.postures(urdf):
            expected = [product(turn(math.pi), pose) for pose in distal(UR5E, q)]
            poses = urdf.poses(q)
            self.assert_close(poses["flange"], expected[-1], q)
            for i, (_, centre) in enumerate(UR5E_LINKS):
                link = f"link_{i + 1}"
                self.assert_close([placed(poses[link], urdf.centre(link))], [placed(expected[i], centre)], (link, q))

    def test_the_seven_axis_arm_moves_by_the_published_parameters(self):
        urdf = self.urdfs["arm7"]
        for q in self.postures(urdf):
            expected = proximal(PANDA, [*q, 0])
            poses = urdf.poses(q)
            for i in range(7):
                self.assert_close(poses[f"link_{i + 1}"], expected[i], q)
            self.assert_close(poses["flange"], expected[-1], q)

    def test_limits_are_the_published_ones(self):
        limits = {name: [[float(joint.find("limit").get(key)) for key in ("lower", "upper", "effort", "velocity")]
                         for joint in urdf.moving()] for name, urdf in self.urdfs.items()}
        full, half = 2 * math.pi, math.pi
        large, elbow, small = [-full, full, 150, half], [-half, half, 150, half], [-full, full, 28, half]
        self.assert_close(limits["arm6"], [large, large, elbow, small, small, small], "arm6")
        self.assertEqual(limits["arm7"], [[-2.8973, 2.8973, 87, 2.175], [-1.7628, 1.7628, 87, 2.175], [-2.8973, 2.8973, 87, 2.175],
                                          [-3.0718, -0.0698, 87, 2.175], [-2.8973, 2.8973, 12, 2.61], [-0.0175, 3.7525, 12, 2.61],
                                          [-2.8973, 2.8973, 12, 2.61]])

    def test_masses_are_the_published_ones(self):
        six, seven = self.urdfs.values()
        self.assertEqual([six.mass(f"link_{i}") for i in range(1, 7)], [mass for mass, _ in UR5E_LINKS])
        self.assertAlmostEqual(sum(six.mass(f"link_{i}") for i in range(1, 7)), 17.7, places=9)
        self.assertAlmostEqual(sum(seven.mass(f"link_{i}") for i in range(1, 8)), 16.062132, places=9)
        for urdf, total in ((six, 20.6), (seven, 18.0)):  # data sheets; the base is what they have more than the links
            self.assertAlmostEqual(sum(urdf.mass(link) for link in urdf.links if urdf.links[link].find("inertial") is not None), total)
            self.assertTrue(1 < urdf.mass("base_link") < 4)

    def test_inertias_are_those_of_bodies(self):
        oblique = 0
        for urdf in (*self.urdfs.values(), *self.cells.values()):
            for link, element in urdf.links.items():
                if element.find("inertial") is None:
                    continue
                tensor = urdf.inertia(link)
                half = sum(tensor[i][i] for i in range(3)) / 2
                # Positive, too, if no principal moment is greater than the sum of the others: the second moments of the mass.
                spread = [[half * (i == j) - tensor[i][j] for j in range(3)] for i in range(3)]
                self.assertTrue(all(minor > 0 for minor in minors(tensor) + minors(spread)), (urdf.path.name, link, tensor))
                radius = math.sqrt(half / urdf.mass(link))
                self.assertTrue(0.01 < radius < 0.4, (urdf.path.name, link, radius))
                oblique += tensor[0][1] != 0 or tensor[0][2] != 0 or tensor[1][2] != 0
        self.assertGreater(oblique, 8)

    def test_inertias_of_cylinders_are_those_of_textbooks(self):
        code = ("import json; from generator.inertia import cylinder_inertia; from generator.solids import bar\n"
                "one, two = [bar('', (0, 0, 1), (0, 0, 1.4), 0.1)], [bar('', (x, 0, 0), (x, 0, 0.4), 0.1) for x in (-0.5, 0.5)]\n"
                "print(json.dumps([cylinder_inertia(3, one), cylinder_inertia(6, two)]))")
        answer = subprocess.run([sys.executable, "-B", "-c", code], cwd=ROBOTS, capture_output=True, text=True, timeout=60, check=True)
        one, two = json.loads(answer.stdout)
        across, along = 3 * (3 * 0.01 + 0.16) / 12, 3 * 0.01 / 2
        self.assert_close(one, [[across, 0, 0], [0, across, 0], [0, 0, along]], "one")
        self.assert_close(two, [[2 * across, 0, 0], [0, 2 * across + 6 * 0.25, 0], [0, 0, 2 * along + 6 * 0.25]], "two")

    def test_meshes_are_there_and_small(self):
        for name, urdf in self.urdfs.items():
            files = {file for link in urdf.links for kind in ("visual", "collision") for file in urdf.meshes(link, kind)}
            there = {file for file in (ROBOTS / name / "meshes").rglob("*") if file.is_file()}
            self.assertEqual(files, there)
            self.assertEqual(len(files), 2 * (1 + len(urdf.moving())))
            self.assertLess(sum(file.stat().st_size for file in files), 500_000)  # bytes
            self.assertLess(sum(triangles_of(file) for file in files), 15_000)
            self.assertEqual(self.cells[name].meshes("link_1", "visual"), urdf.meshes("link_1", "visual"))

    def test_meshes_leave_no_gaps(self):
        for urdf in self.urdfs.values():
            poses = urdf.poses([0] * len(urdf.moving()))
            for joint in urdf.moving():
                parent, child = joint.find("parent").get("link"), joint.find("child").get("link")
                for kind in ("visual", "collision"):
                    boxes = [box_around([placed(poses[link], corner) for file in urdf.meshes(link, kind) for corner in corners_of(file)])
                             for link in (parent, child)]
                    self.assertTrue(meet(*boxes), (urdf.path.name, joint.get("name"), kind, boxes))

    def test_the_last_link_ends_at_the_flange(self):
        for urdf in self.urdfs.values():
            last = urdf.moving()[-1].find("child").get("link")
            height = numbers(urdf.joint_to["flange"].find("origin"), "xyz")[2]
            for kind, places in (("visual", 4), ("collision", 6)):
                box = box_around([corner for file in urdf.meshes(last, kind) for corner in corners_of(file)])
                self.assertAlmostEqual(box[2][1], height, places=places, msg=(urdf.path.name, kind))

    def test_the_tool_frame_is_at_the_flange_or_between_the_jaws(self):
        for name, urdf in self.urdfs.items():
            q = self.postures(urdf, 1)[0]
            self.assert_close(urdf.poses(q)["tcp"], urdf.poses(q)["flange"], name)
            cell = self.cells[name]
            self.assert_close([placed(cell.poses(q)["tcp"], (0, 0, 0))], [placed(cell.poses(q)["flange"], (0, 0, 0.15))], name)
            jaws = [joint for joint in cell.xml.findall("joint") if joint.get("type") == "prismatic"]
            self.assertEqual([joint.get("name") for joint in jaws], ["jaw_left", "jaw_right"])

    def test_the_tool_starts_as_in_the_demo(self):
        down = [[1, 0, 0, 0.4998], [0, -1, 0, 0], [0, 0, -1, 0.3134]]
        for name, q in STARTS.items():
            for row, expected in zip(self.cells[name].poses(q)["tcp"][:3], down, strict=True):
                for x, y in zip(row, expected, strict=True):
                    self.assertAlmostEqual(x, y, delta=2e-3, msg=name)

    def test_what_the_demo_handles_is_within_reach(self):
        scene, database = (json.loads((ROBOTS.parent / "demo" / name).read_text()) for name in ("scene.json", "database.json"))
        places = [body["pose"]["position"] for body in scene["bodies"] if body["mass"] > 0]
        places += [value["position"] for key, value in database.items() if key.startswith("o_t_place_")]
        places += [value["pose"]["position"] for key, value in database.items() if key.startswith("pose_")]
        self.assertGreater(len(places), 10)
        for name, urdf in self.cells.items():
            for x, y, z in places:
                for height in (z, max(z, 0.2)):  # where it stands, and where it is carried
                    for yaw in (0, math.pi / 2):  # the fingers across the robot, or along: the jaws are alike, so no more is needed
                        goal = product(transform((x, y, height), (0, 0, yaw)), transform(rpy=(math.pi, 0, 0)))
                        other = product(goal, turn(math.pi))
                        found = joints_at(urdf, goal, STARTS[name]) or joints_at(urdf, other, STARTS[name])
                        self.assertIsNotNone(found, (name, x, y, height, yaw))

    def test_packages_have_the_names_of_their_folders(self):
        for name in self.urdfs:
            package = ET.parse(ROBOTS / name / "package.xml").getroot()
            self.assertEqual((package.tag, package.findtext("name")), ("package", name))
            self.assertEqual([file.name for file in (ROBOTS / name).rglob("*.urdf")], [f"{name}.urdf"])

    def test_what_is_committed_is_what_is_generated(self):
        for script in ("make_meshes.py", "make_urdfs.py"):
            command = [sys.executable, "-B", ROBOTS / script, "--check"]
            answer = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual((answer.returncode, answer.stdout, answer.stderr), (0, "", ""))


if __name__ == "__main__":
    unittest.main()
