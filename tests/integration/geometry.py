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


def tilt(orientation):
    """Degrees between the z of a body and that of the world, 0..180."""
    return math.degrees(math.acos(max(-1, min(1, turned(orientation, [0, 0, 1])[2]))))
