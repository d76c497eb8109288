"""Poses as tests measure them: quaternions are unit lists [x, y, z, w], angles are in degrees, lengths in metres."""
import math


def angle(a, b):
    """Degrees between two orientations, 0..180."""
    return math.degrees(2 * math.acos(min(1, abs(sum(x * y for x, y in zip(a, b))))))


def turned(orientation, v):
    """The vector, turned by a quaternion."""
    q, w = orientation[:3], orientation[3]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    t = [2 * x for x in cross(q, v)]
    return [x + w * y + z for x, y, z in zip(v, t, cross(q, t))]


def moved(pose, point):
    """A point of the pose's frame, in the frame in which the pose is."""
    return [a + b for a, b in zip(pose["position"], turned(pose["orientation"], point))]


def product(a, b):
    """The rotation b, then a."""
    (x, y, z, w), (p, q, r, s) = a, b
    return [w * p + x * s + y * r - z * q, w * q - x * r + y * s + z * p, w * r + x * q - y * p + z * s, w * s - x * p - y * q - z * r]


def alike(turns):
    """All orientations in which a body looks the same: what its turns make of each other."""
    group = [[0.0, 0.0, 0.0, 1.0]]
    for one in group:  # grows meanwhile
        group += [new for new in (product(one, turn) for turn in turns) if all(angle(new, old) > 0.1 for old in group)]
    return group


def turned_by(a, b, symmetry):
    """Degrees between two orientations of a body, in which turns of its symmetry ({axis, order}; order 0: any turn about the axis)
    make no difference."""
    turns = [[math.sin(math.pi / s["order"]) * v for v in s["axis"]] + [math.cos(math.pi / s["order"])] for s in symmetry if s["order"]]
    rounds = [s["axis"] for s in symmetry if not s["order"]]
    same = [product(b, turn) for turn in alike(turns)]
    if not rounds:
        return min(angle(a, each) for each in same)
    between = lambda u, v: math.degrees(math.acos(max(-1, min(1, sum(x * y for x, y in zip(u, v))))))
    return min(between(turned(a, rounds[0]), turned(each, rounds[0])) for each in same)
