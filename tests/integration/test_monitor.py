"""A service that violates its RSM is reported with rule and call and blocks nobody (R18); calls of one that throws are answered."""
import unittest

import models
from client import ROGUE, Server


class Monitor(unittest.TestCase):
    def rogue(self, server):
        return next(s for s in server.get("/services", "services")["services"] if s["key"] == "rogue")

    def test_violations_are_reported_with_rule_and_call(self):
        with Server(program=ROGUE) as server, server.stream() as stream:
            stream.subscribe("services")
            stream.message()
            core = server.core(models.calling("rogue", "behave"))
            self.assertEqual(server.ended(core)["outcome"], "result")
            self.assertEqual(self.rogue(server)["violations"], [])
            core = server.core(models.calling("rogue", "jump"))
            self.assertEqual(server.ended(core)["outcome"], "result")
            server.wait_for(lambda: len(self.rogue(server)["violations"]) == 2)
            violations = self.rogue(server)["violations"]
            self.assertEqual([v["rule"] for v in violations], ["Trans2", "respond"])
            self.assertEqual((violations[1]["operation"], violations[1]["call"]), ("jump", 2))
            shown = stream.until(lambda m: len(m["data"]["services"][0]["violations"]) == 2)[-1]
            self.assertEqual(shown["data"]["services"][0]["violations"], violations)

    def test_a_service_that_throws_is_answered_unavailable_and_the_server_goes_on(self):
        with Server(program=ROGUE) as server:
            core = server.core(models.calling("rogue", "die"))
            self.assertEqual(server.ended(core)["results"], {"code": "unavailable"})
            self.assertFalse(self.rogue(server)["available"])
            core = server.core(models.calling("rogue", "behave"))
            self.assertEqual(server.ended(core)["results"], {"code": "unavailable"})
            core = server.core(models.ticking("still", last=2))
            self.assertEqual(server.ended(core)["outcome"], "done")


if __name__ == "__main__":
    unittest.main()
