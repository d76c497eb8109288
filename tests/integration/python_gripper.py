"""Services of tests/integration/test_python_service.py, as a program."""
import asyncio
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "api/python"))

from race_client.service import Service, ServiceFailure, operation, run


class Gripper(Service):
    key = "grip"
    version = "1.2"
    events = {"moved": "number"}
    halts = 0

    @operation(moves=True, busy="Moving", parameters={"width": {"unit": "m", "min": 0, "max": 0.11}})
    def move(self, width: float, speed: float = 0.1):
        """Moves the fingers."""
        if width == 0.01:
            raise ServiceFailure("jammed", "the fingers are jammed", force=5.0)
        for _ in range(int(width * 1000)):
            self.pause(0.05)
        self.emit("moved", width)
        return {"width": width, "speed": speed}

    @operation(safe=True, stops="Moving")
    def stop(self):
        self.halts += 1

    @operation(reads=True, result="int")
    def count(self):
        return self.halts

    @operation
    def lie(self):
        self.emit("moved", "far")

    @operation
    def fail(self):
        return {}["nothing"]

    @operation
    async def think(self, seconds: float):
        await asyncio.sleep(seconds)
        return self.state


class Timer(Service):
    key = "patience"
    rsm = "patience.rsm.json"

    async def begin(self):
        await asyncio.sleep(0.05)
        return "begun"

    async def wait(self, seconds):
        await asyncio.sleep(seconds)
        return seconds


if __name__ == "__main__":
    run(Gripper(), Timer())
