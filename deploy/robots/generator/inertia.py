"""Inertia of a link of which only the mass is published: that of solid cylinders. Pure functions; kilograms and metres.

Each piece of the link's shape counts as a solid cylinder from its first to its last point, with the mean of its radii: of mass m,
radius r and length l it has m r^2 / 2 about its axis and m (3 r^2 + l^2) / 12 across it. The link's mass is divided among them by
volume; their tensors are added up about their common centre by Steiner's theorem. Where pieces lie in each other, both count.
"""
from math import pi

from .solids import Piece
from .vectors import Matrix, Vector, add, dot, length, minus, scaled, unit


def _cylinder(piece: Piece) -> tuple[float, Vector, Vector, float, float]:
    """Volume, centre, axis, radius, length."""
    start, end = piece.path[0], piece.path[-1]
    radius, long = sum(piece.radii) / len(piece.radii), length(minus(end, start))
    return pi * radius**2 * long, scaled(add(start, end), 0.5), unit(minus(end, start)), radius, long


def cylinder_inertia(mass: float, pieces: list[Piece]) -> Matrix:
    """The tensor about the centre of the pieces, along the axes of the link's frame."""
    cylinders = [_cylinder(piece) for piece in pieces]
    volume = sum(cylinder[0] for cylinder in cylinders)
    centre = (0.0, 0.0, 0.0)
    for part, place, *_ in cylinders:
        centre = add(centre, scaled(place, part / volume))
    total = [[0.0] * 3 for _ in range(3)]
    for part, place, axis, radius, long in cylinders:
        m, away = mass * part / volume, minus(place, centre)
        along, across = m * radius**2 / 2, m * (3 * radius**2 + long**2) / 12
        for i in range(3):
            for j in range(3):
                same = 1.0 if i == j else 0.0
                total[i][j] += across * same + (along - across) * axis[i] * axis[j] + m * (dot(away, away) * same - away[i] * away[j])
    return tuple(tuple(row) for row in total)
