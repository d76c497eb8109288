"""Tasks that move the arm, and how the arm moves."""
import models
from client import TIMEOUT

FAR = [1.2, -0.35, 0, 1.6, 0, -1.19, 0]  # rad: a turn of the base from where it starts
HOME = [0, -0.35, 0, 1.6, 0, -1.19, 0]


def moving(name="moving", target=None, speed=0.2, **more):
    """Moves to joints, for seconds; ends at `there`, or at `failed` with the code of the error."""
    move = f"svc.robot.move({{'joints': {target or FAR}}}, speed={speed})"
    return models.document(name, {
        "state": "Root", "entry": move, "results": [{"name": "code"}],
        "actions": [{"when": "svc.robot.move.error", "do": "res.code = svc.robot.move.error.code"}],
        "ports": [{"name": "there", "when": "svc.robot.move.result"}, {"name": "failed", "when": "available(res.code)"}], **more})


def insisting(name="insisting"):
    """Moves to and fro, and again whenever that fails: what a stop has to end."""
    def state(own, other, target):
        return {"state": own, "entry": f"svc.robot.move({{'joints': {target}}}, speed=0.2)",
                "ports": [{"name": "next", "when": "svc.robot.move.result", "to": other},
                          {"name": "again", "when": "svc.robot.move.error", "to": own}]}
    return models.document(name, {"state": "Root", "first": "To", "children": [state("To", "Fro", FAR), state("Fro", "To", HOME)]})


class Arm:
    """How the arm moves, by the poses of the cell, 30 in a second."""

    STANDING = 1e-3  # rad between two poses

    def __init__(self, server):
        self.stream = server.stream()
        self.stream.subscribe("cell/pose")

    def close(self):
        self.stream.close()

    def pose(self):
        """(time [s], joints [rad]) of the next pose."""
        data = self.stream.until(lambda m: m["channel"] == "cell/pose")[-1]["data"]
        return data["time"], data["joints"]

    def wait(self, moving, timeout=TIMEOUT):
        """Waits until it moves, or stands; returns how long that took [s of the cell]."""
        begin, before = self.pose()
        while True:
            now, joints = self.pose()
            if (max(abs(joints[name] - before[name]) for name in before) > self.STANDING) == moving:
                return now - begin
            assert now - begin < timeout, f"the arm {'stands' if moving else 'moves'} for {timeout} s"
            before = joints

    def stands_for(self, seconds):
        """Asserts that it does not move meanwhile."""
        begin, first = self.pose()
        now, joints = begin, first
        while now < begin + seconds:
            now, joints = self.pose()
            moved = max(abs(joints[name] - first[name]) for name in first)
            assert moved < 10 * self.STANDING, f"the arm has moved by {moved} rad within {now - begin} s"


class StillArm(Arm):
    """Sees smaller motions: one that holds its position moves by less than 1e-15 rad."""

    STANDING = 1e-5
