#!/usr/bin/env python3
"""Makes the meshes of arm6 and arm7 from their dimensions: COLLADA to be seen, coarser STL to touch. With --check it compares them."""
import sys
from pathlib import Path

from generator import arm6, arm7
from generator.mesh_files import collada, stl
from generator.robot import Robot
from generator.solids import Detail, mesh_of
from generator.written import write_or_check

HERE = Path(__file__).resolve().parent
SEEN, TOUCHED = Detail(sides=18, edge=3, bend=3), Detail(sides=12, edge=1, bend=1)


def meshes_of(robot: Robot) -> dict[Path, bytes]:
    files = {}
    for link, pieces in robot.pieces.items():
        folder = HERE / robot.name / "meshes"
        seen = [(piece.colour, mesh_of(piece, SEEN)) for piece in pieces]
        files[folder / "visual" / f"{link}.dae"] = collada(seen, robot.colours)
        files[folder / "collision" / f"{link}.stl"] = stl([mesh_of(piece, TOUCHED) for piece in pieces])
    return files


if __name__ == "__main__":
    sys.exit(write_or_check(meshes_of(arm6.robot()) | meshes_of(arm7.robot()), __doc__))
