"""Processes of services prove who they are, and for which groups; a second one is refused and logged, and the first goes on."""
import unittest

import models
from accounts import AccountServer
from client import Server, check
from component_process import LONG_HEARTBEAT, ComponentClient, ComponentProcess, service, wait_available


def hello(server, key):
    known = service(server, key)
    return {"type": "hello", "protocol": 1, "components": [{"key": key, "type": known["type"], "rsm": known["rsm"]}]}


def refusal_of(client, message):
    """(path, code) with which the server refuses a hello, and ends the connection."""
    client.send(check("component_request", message))
    error = client.next("refused")["errors"][0]
    try:
        while True:
            client.message()
    except ConnectionError:
        return error["path"], error["code"]


class Impostors(unittest.TestCase):
    def connect(self, server, token=None):
        client = ComponentClient(server, token=token)
        self.addCleanup(client.close)
        return client

    def lines(self, server):
        with server.stream() as log:
            log.subscribe("log")
            snapshot = log.until(lambda m: m["kind"] == "snapshot")[-1]
            return [entry["text"] for entry in snapshot["data"]["entries"]]

    def refusals(self, server):
        return [line for line in self.lines(server) if "is refused" in line]

    def test_nobody_is_a_service_without_the_token_of_the_data_folder(self):
        with Server("--remote", "database", *LONG_HEARTBEAT) as server:
            for token in ("race_" + "x" * 43, "x"):
                self.assertEqual(self.connect(server, token).status, 403, token)
            self.assertFalse(service(server, "db")["available"])
            self.connect(server).send_checked(hello(server, "db"))
            wait_available(server, "db")

    def test_a_process_brings_the_groups_of_its_account_alone(self):
        with AccountServer("--remote", "audio,database", *LONG_HEARTBEAT) as server:
            speaker = server.tokens["speaker"]
            self.assertEqual(refusal_of(self.connect(server, speaker), hello(server, "db")), ("db", "rights"))
            self.assertFalse(service(server, "db")["available"])
            self.connect(server, speaker).send_checked(hello(server, "audio"))
            wait_available(server, "audio")
            self.assertIn("db: rights", "\n".join(self.refusals(server)))
            for person in ("observer", "admin"):
                self.assertEqual(self.connect(server, server.tokens[person]).status, 403, person)

    def test_a_second_process_is_refused_and_logged_and_tasks_go_on_asking_the_first(self):
        with AccountServer("--remote", "database", *LONG_HEARTBEAT) as server:
            first = self.connect(server)
            first.send_checked(hello(server, "db"))
            first.next("welcome")
            for _ in range(3):
                self.assertEqual(refusal_of(self.connect(server), hello(server, "db")), ("db", "conflict"))
            self.assertTrue(service(server, "db")["available"])
            server.core(models.calling("db", "list"))
            self.assertEqual(first.next("call")["operation"], "list")
            self.assertEqual(len(self.refusals(server)), 3)
            rows = lambda: [(e["action"], e["outcome"]) for e in server.get("/audit", "audit")["entries"]]
            server.wait_for(lambda: rows().count(("process db", "conflict")) >= 3)
            self.assertEqual(rows().count(("process db", "conflict")), 3)

    def test_a_real_process_that_is_refused_ends_with_the_reason(self):
        with AccountServer("--remote", "database", *LONG_HEARTBEAT) as server, ComponentProcess(server, "database") as first:
            wait_available(server, "db")
            with ComponentProcess(server, "database") as second:
                _, said = second.process.communicate(timeout=20)
                self.assertEqual(second.process.returncode, 2)
                self.assertIn("db: conflict: the server refuses: has a process already", said)
            self.assertIsNone(first.process.poll())
            self.assertTrue(service(server, "db")["available"])

    def test_who_was_removed_is_a_service_no_longer(self):
        with AccountServer("--remote", "audio", "--heartbeat", "4") as server:  # it asks four times in that
            self.connect(server, server.tokens["speaker"]).send_checked(hello(server, "audio"))
            wait_available(server, "audio")
            self.assertEqual(server.ask("admin", "DELETE", "/api/v1/accounts/speaker"), 200)
            wait_available(server, "audio", False)
            self.assertIn("lost: its account may do that no more", "\n".join(self.lines(server)))
            self.assertEqual(self.connect(server, server.tokens["speaker"]).status, 401)


if __name__ == "__main__":
    unittest.main()
