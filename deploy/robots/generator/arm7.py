"""The seven-axis arm: published figures, and the shapes that are ours. Frames and sources: README.md of arm7."""
from math import pi

from .frames import joint_of_craig
from .robot import Joint, Link, Robot
from .solids import Piece, bar
from .vectors import Matrix, Vector

NAME = "arm7"
TOTAL = 18.0  # kg, with the base

# theta = q; d [m], a [m], alpha [rad] by Craig (proximal): a and alpha are of the link before
CRAIG = ((0.333, 0.0, 0.0), (0.0, 0.0, -pi / 2), (0.316, 0.0, pi / 2), (0.0, 0.0825, pi / 2), (0.384, -0.0825, -pi / 2),
         (0.0, 0.0, pi / 2), (0.0, 0.088, pi / 2))
FLANGE = 0.107  # m, along the last axis
# kg; centre of mass [m] in the link's frame; ixx ixy ixz iyy iyz izz [kg m2] about it
DYNAMICS = (
    (4.970684, (3.875e-03, 2.081e-03, -1.750e-01), (7.0337e-01, -1.3900e-04, 6.7720e-03, 7.0661e-01, 1.9169e-02, 9.1170e-03)),
    (0.646926, (-3.141e-03, -2.872e-02, 3.495e-03), (7.9620e-03, -3.9250e-03, 1.0254e-02, 2.8110e-02, 7.0400e-04, 2.5995e-02)),
    (3.228604, (2.7518e-02, 3.9252e-02, -6.6502e-02), (3.7242e-02, -4.7610e-03, -1.1396e-02, 3.6155e-02, -1.2805e-02, 1.0830e-02)),
    (3.587895, (-5.317e-02, 1.04419e-01, 2.7454e-02), (2.5853e-02, 7.7960e-03, -1.3320e-03, 1.9552e-02, 8.6410e-03, 2.8323e-02)),
    (1.225946, (-1.1953e-02, 4.1065e-02, -3.8437e-02), (3.5549e-02, -2.1170e-03, -4.0370e-03, 2.9474e-02, 2.2900e-04, 8.6270e-03)),
    (1.666555, (6.0149e-02, -1.4117e-02, -1.0517e-02), (1.9640e-03, 1.0900e-04, -1.1580e-03, 4.3540e-03, 3.4100e-04, 5.4330e-03)),
    (7.35522e-01, (1.0517e-02, -4.252e-03, 6.1597e-02), (1.2516e-02, -4.2800e-04, -1.1960e-03, 1.0027e-02, -7.4100e-04, 4.8150e-03)),
)
RANGES = ((-2.8973, 2.8973), (-1.7628, 1.7628), (-2.8973, 2.8973), (-3.0718, -0.0698), (-2.8973, 2.8973), (-0.0175, 3.7525),
          (-2.8973, 2.8973))  # rad
SPEEDS = (2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61)  # rad/s
TORQUES = (87.0, 87.0, 87.0, 87.0, 12.0, 12.0, 12.0)  # Nm

COLOURS = {"white": (0.9, 0.9, 0.88), "grey": (0.45, 0.47, 0.5), "accent": (0.88, 0.5, 0.14)}


X, Y = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)


def _fork(width: float, radius: float, path: tuple, radii: tuple[float, ...], wide: Vector) -> list[Piece]:
    """Two discs at the ends of the axis z, each with a flat arm along `path`; z of the path is for the positive side."""
    pieces = []
    for side in (1, -1):
        pieces += [bar("white", (0, 0, side * (width - 0.022)), (0, 0, side * width), radius, 0.007),
                   bar("accent", (0, 0, side * (width - 0.006)), (0, 0, side * (width + 0.003)), radius * 0.6, 0.002),
                   Piece("white", tuple((x, y, side * z) for x, y, z in path), radii, 0.01, 0.36, wide)]
    return pieces


PIECES: dict[str, list[Piece]] = {
    "base_link": [Piece("white", ((-0.12, 0, 0.052), (-0.06, 0, 0.055), (0, 0, 0.058)), (0.042, 0.05, 0.056), 0.012),
                  bar("grey", (0, 0, 0), (0, 0, 0.02), 0.09, 0.006),
                  bar("grey", (-0.095, 0, 0), (-0.095, 0, 0.02), 0.05, 0.006),
                  Piece("white", ((0, 0, 0.015), (0, 0, 0.05), (0, 0, 0.09), (0, 0, 0.1405)), (0.084, 0.074, 0.064, 0.0605), 0.003)],
    "link_1": [bar("grey", (0, 0, -0.193), (0, 0, -0.186), 0.057, 0.001),
               Piece("white", ((0, 0, -0.187), (0, 0, -0.12), (0, 0, -0.05), (0, 0, 0)), (0.061, 0.06, 0.052, 0.043), 0.004),
               bar("white", (0, -0.044, 0), (0, 0.044, 0), 0.06, 0.006)],
    "link_2": [*_fork(0.067, 0.063, ((0, 0, 0.0525), (0, -0.06, 0.05), (0, -0.14, 0.034)), (0.047, 0.046, 0.034), X),
               Piece("white", ((0, -0.073, 0), (0, -0.095, 0), (0, -0.135, 0), (0, -0.1905, 0)),
                     (0.034, 0.053, 0.061, 0.061), 0.006)],
    "link_3": [bar("grey", (0, 0, -0.1265), (0, 0, -0.119), 0.056, 0.001),
               Piece("white", ((0, 0, -0.12), (0.002, 0, -0.07), (0.035, 0, -0.018), (0.0825, 0, 0)), (0.06, 0.058, 0.051, 0.04), 0.006),
               bar("white", (0.0825, -0.039, 0), (0.0825, 0.039, 0), 0.053, 0.006)],
    "link_4": [*_fork(0.061, 0.056, ((0, 0, 0.0475), (-0.035, 0.04, 0.0455), (-0.08, 0.097, 0.031)), (0.042, 0.041, 0.03), X),
               Piece("white", ((-0.0815, 0.05, 0), (-0.0825, 0.072, 0), (-0.0825, 0.1, 0), (-0.0825, 0.1305, 0)),
                     (0.034, 0.05, 0.056, 0.056), 0.006)],
    "link_5": [bar("grey", (0, 0, -0.254), (0, 0, -0.2465), 0.052, 0.001),
               Piece("white", ((0, 0, -0.2475), (0, 0, -0.19), (0, 0, -0.1), (0, 0, 0)), (0.055, 0.053, 0.041, 0.036), 0.006),
               bar("white", (0, -0.037, 0), (0, 0.037, 0), 0.046, 0.006)],
    "link_6": [*_fork(0.058, 0.048, ((0, 0, 0.046), (0.04, -0.002, 0.043), (0.085, -0.002, 0.028)), (0.035, 0.034, 0.034), Y),
               bar("white", (0.088, 0.043, 0), (0.088, -0.0455, 0), 0.046, 0.01),
               bar("accent", (0.088, 0.037, 0), (0.088, 0.047, 0), 0.03, 0.003)],
    "link_7": [bar("grey", (0, 0, 0.045), (0, 0, 0.0525), 0.042, 0.001),
               bar("white", (0, 0, 0.0515), (0, 0, 0.099), 0.046, 0.01),
               bar("grey", (0, 0, 0.096), (0, 0, 0.107), 0.0315, 0.001)],
}


def _tensor(ixx: float, ixy: float, ixz: float, iyy: float, iyz: float, izz: float) -> Matrix:
    return ((ixx, ixy, ixz), (ixy, iyy, iyz), (ixz, iyz, izz))


def robot() -> Robot:
    """At q = 0 the arm stands upright, with the flange downwards; joint 4 does not reach 0."""
    names = list(PIECES)
    links = [Link(names[0], TOTAL - sum(mass for mass, *_ in DYNAMICS), (-0.02, 0.0, 0.06))]
    joints = []
    for i, (mass, centre, moments) in enumerate(DYNAMICS):
        joints.append(Joint(f"joint_{i + 1}", names[i], names[i + 1], *joint_of_craig(*CRAIG[i]), RANGES[i], TORQUES[i], SPEEDS[i]))
        links.append(Link(names[i + 1], mass, centre, _tensor(*moments)))
    flange = Joint("flange_mount", names[-1], "flange", (0.0, 0.0, FLANGE), (0.0, 0.0, 0.0))
    return Robot(NAME, links, joints, flange, PIECES, COLOURS)
