"""A gripper of your own, 1 mm in 10 ms: replace what `move` does by what your device needs."""
from race_client.service import Service, operation

STROKE = 0.11  # [m] between the fingers


class Gripper(Service):
    key = "my_gripper"
    events = {"moved": "number"}
    width = STROKE

    @operation(moves=True, busy="Moving", parameters={"width": {"unit": "m", "min": 0, "max": STROKE}})
    def move(self, width: float):
        while abs(width - self.width) > 0.0005:
            self.pause(0.01)  # ends here if `stop` was called, or the server is lost
            self.width = round(self.width + (0.001 if width > self.width else -0.001), 3)
        self.emit("moved", self.width)
        return {"width": width}

    @operation(safe=True, stops="Moving")
    def stop(self):
        """The fingers stay where they are."""

    @operation(reads=True, result={"record": {"width": "number"}})
    def get(self):
        return {"width": self.width}


Gripper().run()
