"""Ten cores that diverge, each again soon after its fault, do not hold up a good core: the gaps between the deltas of its state
have a p99 of at most twice that alone.
"""
import subprocess
import unittest

import models
import overload
from client import Server
from overload import Load, p99

CORES = 10
SECONDS = 8  # of each measurement
LEAST_BUSY = 0.5  # of the looks at a diverging core: it runs


def diverging():
    """Computes for some tenths of a second until its fault, so that it can be kept busy; its start waits for nothing."""
    task = models.diverging(numbers=3000)
    begin = {"state": "Begin", "entry": "svc.timer.wait(0)",
             "ports": [{"name": "next", "when": "svc.timer.wait.result", "to": "A"}]}
    task["root"] |= {"first": "Begin", "children": [begin, *task["root"]["children"]]}
    return task


class DivergingCores(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        server = Server(stderr=subprocess.DEVNULL)
        cls.addClassCleanup(server.stop)
        core = server.core(overload.good())
        cls.alone = overload.measured_gaps(server, core, SECONDS)
        load = Load(overload.cores_of(diverging, CORES), server)
        server.wait_for(lambda: len(server.get("/cores", "cores")["cores"]) > CORES)
        cls.gaps = overload.measured_gaps(server, core, SECONDS)
        cls.told = load.end()
        print(f"gap p99 {1000 * p99(cls.gaps):.1f} ms (alone {1000 * p99(cls.alone):.1f} ms; longest {1000 * max(cls.gaps):.0f} ms "
              f"of {len(cls.gaps)}); {cls.told['begun']} diverging runs, busy {100 * cls.told['busy']:.0f} %", flush=True)

    def test_the_load_is_one(self):
        self.assertGreater(self.told["busy"], LEAST_BUSY)
        self.assertGreater(self.told["begun"], CORES)

    def test_a_good_core_goes_on(self):
        self.assertLessEqual(p99(self.gaps), overload.MOST_GAP * p99(self.alone))


if __name__ == "__main__":
    unittest.main()
