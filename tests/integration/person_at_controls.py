"""A person's client, as a process that can be stopped and killed: takes the controls, moves the arm by hand, and is heard until its end.

PORT TARGET: moves to the joints TARGET (JSON) slowly; says `moves` once it does.
"""
import json
import sys
import time
from types import SimpleNamespace

from controls import Controls

if __name__ == "__main__":
    person = Controls(SimpleNamespace(port=int(sys.argv[1]), token=None))
    assert person.take()["kind"] == "taken"
    person.say("call", number=1, service="robot", operation="move", kwargs={"target": {"joints": json.loads(sys.argv[2])}, "speed": 0.2})
    print("moves", flush=True)
    time.sleep(60)
