"""A task by chance that never ends and never faults by itself: it moves by time-outs and by ticks of the timer."""
import random

import models


def random_task(name, seed):
    """Rings of states in a ring of states, one of which forks."""
    return RandomTask(random.Random(f"{seed}/{name}")).document(name)


class RandomTask:
    def __init__(self, chance):
        self.random = chance

    def document(self, name):
        ring = [self.composite(f"S{i}") for i in range(self.random.randint(2, 4))]
        ring.insert(self.random.randint(1, len(ring)), self.concurrent("P"))
        return models.document(name, {**self.counting("Root"), "children": self.connect(ring), "first": "S0"})

    def composite(self, name):
        ring = self.connect([self.counting(f"T{i}") for i in range(self.random.randint(2, 4))])
        return {**self.counting(name), "children": ring, "first": "T0"}

    def concurrent(self, name):
        """Begins with a fork, into regions that meet at a barrier; what becomes of them, it is left as the others are."""
        regions = [self.composite(f"R{i}") for i in range(self.random.randint(2, 3))]
        begin, *_ = states = [self.counting("Begin"), *regions]
        begin["ports"] = [self.port("Fork")]
        for region in regions:
            region["ports"] = [self.port("Join")]
        barriers = [{"barrier": "Fork", "to": [region["state"] for region in regions]}, {"barrier": "Join", "to": ["Begin"]}]
        return {**self.counting(name), "children": [*states, *barriers], "first": "Begin"}

    def counting(self, name):
        return {"state": name, "variables": [{"name": "n", "initial": 0}],
                "actions": [{"when": "svc.timer.tick", "do": "var.n = var.n + 1"}]}

    def connect(self, states):
        for state, following in zip(states, states[1:] + states[:1], strict=True):
            state["ports"] = [self.port(following["state"])]
        return states

    def port(self, to):
        """Each waits for something that comes from outside, so no macro step goes round a ring (SEMANTICS section 11)."""
        when = self.random.choice(({"after": f"{self.random.randint(2, 12) / 100}"}, {"when": "svc.timer.tick"},
                                   {"when": f"svc.timer.tick and var.n % {self.random.randint(1, 3)} == 0"}))
        return {"name": "next", **when, "to": to}
