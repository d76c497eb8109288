"""Smooth solids as triangle meshes: round bars along straight or bent paths, with rounded edges. Pure functions; metres."""
import math
from dataclasses import dataclass

from .vectors import Vector, add, cross, dot, length, minus, scaled, unit


@dataclass(frozen=True)
class Detail:
    """How fine a mesh is: corners around, rings of a rounded edge (1: it is sharp), rings between two points of a bent path."""
    sides: int
    edge: int
    bend: int


@dataclass(frozen=True)
class Piece:
    """A bar of one colour: through the points of `path`, with the radius `radii[i]` at point i. It is round, or `flat` times as
    thick across the direction `wide`."""
    colour: str
    path: tuple[Vector, ...]
    radii: tuple[float, ...]
    edge: float = 0.006  # radius of the rounded edges at both ends
    flat: float = 1.0
    wide: Vector | None = None


@dataclass
class Mesh:
    corners: list[Vector]
    triangles: list[tuple[int, int, int]]  # counter-clockwise, seen from outside


def bar(colour: str, start: Vector, end: Vector, radius: float, edge: float = 0.006) -> Piece:
    """A cylinder from `start` to `end`."""
    return Piece(colour, (start, end), (radius, radius), edge)


def _between(a: float, b: float, c: float, d: float, t: float) -> float:
    """Catmull and Rom's spline from b (t = 0) to c (t = 1)."""
    return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))


def _bent(piece: Piece, rings: int) -> tuple[list[Vector], list[float]]:
    """Points and radii along a smooth curve through those of the piece."""
    values = [(*point, radius) for point, radius in zip(piece.path, piece.radii, strict=True)]
    if len(values) == 2:
        return list(piece.path), list(piece.radii)
    ends = [tuple(2 * p - q for p, q in zip(values[0], values[1], strict=True)), *values,
            tuple(2 * p - q for p, q in zip(values[-1], values[-2], strict=True))]
    curve = []
    for i in range(1, len(ends) - 2):
        for k in range(rings):
            curve.append(tuple(_between(a, b, c, d, k / rings) for a, b, c, d in zip(*ends[i - 1:i + 3], strict=True)))
    curve.append(values[-1])
    return [value[:3] for value in curve], [value[3] for value in curve]


def _edge(point: Vector, inwards: Vector, radius: float, edge: float, count: int) -> list[tuple[Vector, float]]:
    """Centres and radii of the rings from the flat end to the side."""
    if count == 1:
        return [(point, radius)]
    rings = []
    for k in range(count):
        angle = math.pi / 2 * k / (count - 1)
        rings.append((add(point, scaled(inwards, edge * (1 - math.cos(angle)))), radius - edge * (1 - math.sin(angle))))
    return rings


def _rings(piece: Piece, detail: Detail) -> tuple[list[Vector], list[float]]:
    points, radii = _bent(piece, detail.bend)
    first, last = unit(minus(points[1], points[0])), unit(minus(points[-2], points[-1]))
    edge = piece.edge
    kept = [(point, radius) for point, radius in zip(points, radii, strict=True)
            if dot(minus(point, points[0]), first) > 1.2 * edge and dot(minus(point, points[-1]), last) > 1.2 * edge]
    ends = [_edge(points[0], first, radii[0], edge, detail.edge), _edge(points[-1], last, radii[-1], edge, detail.edge)]
    rings = ends[0] + kept + ends[1][::-1]
    return [ring[0] for ring in rings], [ring[1] for ring in rings]


def _across(direction: Vector, before: Vector | None) -> Vector:
    """A unit vector across `direction`: the one before, turned as little as possible, so that the skin does not twist."""
    if before is None:
        axis = min(range(3), key=lambda i: abs(direction[i]))
        before = tuple(1.0 if i == axis else 0.0 for i in range(3))
    return unit(minus(before, scaled(direction, dot(before, direction))))


def _rounded(point: Vector) -> Vector:
    """To 1 um, without negative zeros: equal files on every machine."""
    return tuple(round(value, 6) + 0.0 for value in point)


def mesh_of(piece: Piece, detail: Detail) -> Mesh:
    """The skin of a piece, closed."""
    points, radii = _rings(piece, detail)
    sides = detail.sides
    mesh = Mesh([], [])
    across = piece.wide
    for i, point in enumerate(points):
        direction = unit(minus(points[min(i + 1, len(points) - 1)], points[max(i - 1, 0)]))
        across = _across(direction, across)
        other = cross(direction, across)
        for side in range(sides):
            angle = 2 * math.pi * side / sides
            offset = add(scaled(across, radii[i] * math.cos(angle)), scaled(other, piece.flat * radii[i] * math.sin(angle)))
            mesh.corners.append(_rounded(add(point, offset)))
    for i in range(len(points) - 1):
        for side in range(sides):
            a, b = i * sides + side, i * sides + (side + 1) % sides
            mesh.triangles += [(a, b, b + sides), (a, b + sides, a + sides)]
    for point, ring, turned in ((points[0], 0, True), (points[-1], len(points) - 1, False)):
        mesh.corners.append(_rounded(point))
        middle = len(mesh.corners) - 1
        for side in range(sides):
            a, b = ring * sides + side, ring * sides + (side + 1) % sides
            mesh.triangles.append((middle, b, a) if turned else (middle, a, b))
    return mesh


def normals_of(mesh: Mesh) -> list[Vector]:
    """A unit vector for each corner: the mean of its triangles' normals, by area."""
    sums: list[Vector] = [(0.0, 0.0, 0.0)] * len(mesh.corners)
    for triangle in mesh.triangles:
        a, b, c = (mesh.corners[i] for i in triangle)
        normal = cross(minus(b, a), minus(c, a))
        for i in triangle:
            sums[i] = add(sums[i], normal)
    return [unit(total) if length(total) > 0 else (0.0, 0.0, 1.0) for total in sums]
