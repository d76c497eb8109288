"""Vectors, rotations and poses of three dimensions, as tuples. Pure functions; metres and radians."""
import math

Vector = tuple[float, float, float]
Matrix = tuple[Vector, Vector, Vector]  # rows
Pose = tuple[Matrix, Vector]  # rotation and translation

UNIT: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def scaled(a: Vector, by: float) -> Vector:
    return (a[0] * by, a[1] * by, a[2] * by)


def minus(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a: Vector) -> float:
    return math.sqrt(dot(a, a))


def unit(a: Vector) -> Vector:
    return scaled(a, 1 / length(a))


def apply(m: Matrix, v: Vector) -> Vector:
    return (dot(m[0], v), dot(m[1], v), dot(m[2], v))


def transposed(m: Matrix) -> Matrix:
    return tuple(zip(*m, strict=True))


def product(a: Matrix, b: Matrix) -> Matrix:
    columns = transposed(b)
    return tuple(tuple(dot(row, column) for column in columns) for row in a)


def about_x(angle: float) -> Matrix:
    c, s = math.cos(angle), math.sin(angle)
    return ((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c))


def about_y(angle: float) -> Matrix:
    c, s = math.cos(angle), math.sin(angle)
    return ((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c))


def about_z(angle: float) -> Matrix:
    c, s = math.cos(angle), math.sin(angle)
    return ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0))


def from_rpy(rpy: Vector) -> Matrix:
    """URDF's: about the fixed axes x, y, z, in this order."""
    return product(about_z(rpy[2]), product(about_y(rpy[1]), about_x(rpy[0])))


def after(a: Pose, b: Pose) -> Pose:
    """The pose `b`, given in the frame `a`."""
    return product(a[0], b[0]), add(a[1], apply(a[0], b[1]))


def placed(pose: Pose, point: Vector) -> Vector:
    return add(pose[1], apply(pose[0], point))
