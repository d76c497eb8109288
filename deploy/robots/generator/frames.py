"""Where the frames of a URDF's links are, by Denavit and Hartenberg's parameters. Pure functions; metres and radians."""
from math import cos, sin

from .vectors import Vector, about_x, add, apply


def link_frame_of_dh(d: float, a: float, alpha: float, point: Vector = (0.0, 0.0, 0.0)) -> tuple[Vector, Vector]:
    """Distal parameters: the frame of a link in our URDF is DH's frame before it, turned by q about z. Answers the place,
    in this frame, of what has `point` in DH's frame of the link, and the angles (URDF's rpy) of DH's frame."""
    return add((a, 0.0, d), apply(about_x(alpha), point)), (alpha, 0.0, 0.0)


def joint_of_craig(d: float, a: float, alpha: float) -> tuple[Vector, Vector]:
    """Proximal parameters (Craig's): place and angles of a link's frame at q = 0 in the frame before it; a and alpha are of the
    link before."""
    return (a, -sin(alpha) * d, cos(alpha) * d), (alpha, 0.0, 0.0)
