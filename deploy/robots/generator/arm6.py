"""The six-axis arm: published figures, and the shapes that are ours. Frames and sources: README.md of arm6."""
from math import pi

from .frames import link_frame_of_dh
from .robot import Joint, Link, Robot
from .solids import Piece, bar

NAME = "arm6"
TOTAL = 20.6  # kg, with the base

# theta = q; d [m], a [m], alpha [rad] by Denavit and Hartenberg (distal)
DH = ((0.1625, 0.0, pi / 2), (0.0, -0.425, 0.0), (0.0, -0.3922, 0.0), (0.1333, 0.0, pi / 2), (0.0997, 0.0, -pi / 2), (0.0996, 0.0, 0.0))
# kg, and the centre of mass in the DH frame of the link, which is at its far end
MASSES = ((3.761, (0.0, -0.02561, 0.00193)), (8.058, (0.2125, 0.0, 0.11336)), (2.846, (0.15, 0.0, 0.0265)),
          (1.37, (0.0, -0.0018, 0.01634)), (1.3, (0.0, 0.0018, 0.01634)), (0.365, (0.0, 0.0, -0.001159)))
RANGES = (2 * pi, 2 * pi, pi, 2 * pi, 2 * pi, 2 * pi)  # rad, both ways
TORQUES = (150.0, 150.0, 150.0, 28.0, 28.0, 28.0)  # Nm
SPEED = pi  # rad/s, of each joint

COLOURS = {"silver": (0.74, 0.76, 0.79), "dark": (0.17, 0.18, 0.2), "cap": (0.1, 0.42, 0.46)}


def _wrist(height: float, side: float) -> list[Piece]:
    """A housing along z and one across it, in which the next joint turns: `height` on the axis, `side` of it along y."""
    return [bar("dark", (0, 0, 0.0455), (0, 0, 0.0525), 0.0345, 0.001),
            bar("silver", (0, 0, 0.051), (0, 0, height + 0.043), 0.0385, 0.009),
            bar("cap", (0, 0, height + 0.036), (0, 0, height + 0.049), 0.033, 0.005),
            bar("silver", (0, 0, height), (0, side, height), 0.0375, 0.003)]


PIECES: dict[str, list[Piece]] = {
    "base_link": [bar("dark", (0, 0, 0), (0, 0, 0.024), 0.0745, 0.006),
                  Piece("silver", ((0, 0, 0.018), (0, 0, 0.04), (0, 0, 0.07), (0, 0, 0.0965)), (0.071, 0.063, 0.06, 0.06), 0.003),
                  bar("dark", (-0.05, 0, 0.05), (-0.083, 0, 0.05), 0.013, 0.003)],
    "link_1": [bar("dark", (0, 0, 0.096), (0, 0, 0.103), 0.0565, 0.001),
               bar("silver", (0, 0, 0.101), (0, 0, 0.1625), 0.0605, 0.003),
               bar("silver", (0, 0.058, 0.1625), (0, -0.0655, 0.1625), 0.061, 0.012),
               bar("cap", (0, 0.05, 0.1625), (0, 0.066, 0.1625), 0.052, 0.007)],
    "link_2": [bar("dark", (0, 0, 0.065), (0, 0, 0.0725), 0.0565, 0.001),
               bar("silver", (0, 0, 0.071), (0, 0, 0.197), 0.061, 0.012),
               bar("cap", (0, 0, 0.189), (0, 0, 0.205), 0.052, 0.007),
               Piece("silver", ((-0.02, 0, 0.138), (-0.09, 0, 0.138), (-0.34, 0, 0.138), (-0.41, 0, 0.138)),
                     (0.054, 0.047, 0.043, 0.045), 0.01),
               bar("silver", (-0.425, 0, 0.0745), (-0.425, 0, 0.188), 0.051, 0.011),
               bar("cap", (-0.425, 0, 0.18), (-0.425, 0, 0.195), 0.043, 0.006)],
    "link_3": [bar("dark", (0, 0, 0.0675), (0, 0, 0.075), 0.047, 0.001),
               bar("silver", (0, 0, 0.069), (0, 0, -0.045), 0.051, 0.011),
               bar("cap", (0, 0, -0.037), (0, 0, -0.052), 0.043, 0.006),
               Piece("silver", ((-0.02, 0, 0.0115), (-0.08, 0, 0.0115), (-0.32, 0, 0.0085), (-0.38, 0, 0.0075)),
                     (0.044, 0.039, 0.0345, 0.036), 0.008),
               bar("silver", (-0.3922, 0, 0.0465), (-0.3922, 0, -0.034), 0.0395, 0.009),
               bar("cap", (-0.3922, 0, -0.027), (-0.3922, 0, -0.04), 0.033, 0.005)],
    "link_4": _wrist(0.1333, -0.0465),
    "link_5": _wrist(0.0997, 0.0465),
    "link_6": [bar("dark", (0, 0, 0.0455), (0, 0, 0.0525), 0.0345, 0.001),
               bar("silver", (0, 0, 0.051), (0, 0, 0.093), 0.0385, 0.008),
               bar("dark", (0, 0, 0.09), (0, 0, 0.0996), 0.0315, 0.001)],
}


def robot() -> Robot:
    """At q = 0 the arm is stretched out along x of base_link."""
    names = list(PIECES)
    links = [Link(names[0], TOTAL - sum(mass for mass, _ in MASSES), (0.0, 0.0, 0.045))]
    joints = []
    for i, (mass, centre) in enumerate(MASSES):
        xyz, rpy = ((0.0, 0.0, 0.0), (0.0, 0.0, pi)) if i == 0 else link_frame_of_dh(*DH[i - 1])
        joints.append(Joint(f"joint_{i + 1}", names[i], names[i + 1], xyz, rpy, (-RANGES[i], RANGES[i]), TORQUES[i], SPEED))
        links.append(Link(names[i + 1], mass, link_frame_of_dh(*DH[i], centre)[0]))
    flange = Joint("flange_mount", names[-1], "flange", *link_frame_of_dh(*DH[-1]))
    return Robot(NAME, links, joints, flange, PIECES, COLOURS)
