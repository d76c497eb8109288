"""What is known of a robot before its URDF is written. Values; metres, radians, kilograms, seconds, newtons."""
from dataclasses import dataclass

from .solids import Piece
from .vectors import Matrix, Vector


@dataclass(frozen=True)
class Link:
    name: str
    mass: float
    centre: Vector  # of mass, in the link's frame
    inertia: Matrix | None = None  # about the centre; None: that of its shape, as solid cylinders


@dataclass(frozen=True)
class Joint:
    """Turns about z of the child's frame; fixed, if it has no range."""
    name: str
    parent: str
    child: str
    xyz: Vector
    rpy: Vector
    limits: tuple[float, float] | None = None
    torque: float = 0.0
    speed: float = 0.0


@dataclass(frozen=True)
class Robot:
    name: str
    links: list[Link]  # from the base outwards
    joints: list[Joint]
    flange: Joint
    pieces: dict[str, list[Piece]]  # by link
    colours: dict[str, Vector]
