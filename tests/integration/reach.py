"""Inverse kinematics of the arms of deploy/robots, in Python: damped least squares within the ranges of the joints."""
import math

from robot_folders import numbers

DAMPING = 1e-3
LONGEST = 0.3  # rad, of a step
REACHED = 1e-6  # m and rad


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _column(pose, axis):
    return [row[axis] for row in pose[:3]]


def _way(pose, goal):
    """From a pose to another: translation, and rotation vector (half a turn apart it is 0, too)."""
    turns = [_cross(_column(pose, axis), _column(goal, axis)) for axis in range(3)]
    return [b - a for a, b in zip(_column(pose, 3), _column(goal, 3), strict=True)] + [sum(turn[i] for turn in turns) / 2 for i in range(3)]


def _solve(matrix, vector):
    """Gauss and Jordan's elimination, with pivots."""
    rows = [[*row, value] for row, value in zip(matrix, vector, strict=True)]
    for i in range(len(rows)):
        pivot = max(range(i, len(rows)), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k, row in enumerate(rows):
            if k != i:
                share = row[i] / rows[i][i]
                rows[k] = [x - share * y for x, y in zip(row, rows[i], strict=True)]
    return [row[-1] / row[i] for i, row in enumerate(rows)]


def joints_at(urdf, goal, start, steps=300):
    """Joints [rad] at which `tcp` has the pose `goal`, a 4x4 matrix, searched from `start`; none, if they are not found."""
    links = [joint.find("child").get("link") for joint in urdf.moving()]
    limits = [[numbers(joint.find("limit"), key)[0] for key in ("lower", "upper")] for joint in urdf.moving()]
    q = list(start)
    for _ in range(steps):
        poses = urdf.poses(q)
        way = _way(poses["tcp"], goal)
        aligned = all(sum(x * y for x, y in zip(_column(poses["tcp"], i), _column(goal, i), strict=True)) > 0 for i in range(3))
        if math.hypot(*way) < REACHED and aligned:
            return q
        tool = _column(poses["tcp"], 3)
        jacobian = []  # a row for each joint
        for link in links:
            axis = _column(poses[link], 2)
            jacobian.append(_cross(axis, [a - b for a, b in zip(tool, _column(poses[link], 3), strict=True)]) + axis)
        square = [[sum(row[i] * row[k] for row in jacobian) + DAMPING * (i == k) for k in range(6)] for i in range(6)]
        pull = _solve(square, way)
        change = [sum(a * b for a, b in zip(row, pull, strict=True)) for row in jacobian]
        share = min(1, LONGEST / max(map(abs, change)))
        q = [min(max(angle + share * step, low), high) for angle, step, (low, high) in zip(q, change, limits, strict=True)]
    return None
