"""Who is at a document, on the channels presence/NAME: told to others soon and not too often, bounded, and gone with the connection."""
import json
import time
import unittest

from client import SCHEMAS
from server_case import ServerCase

PERIOD = 0.04  # between two deltas of a document [s]
MOST = SCHEMAS["presence"]["$defs"]["presence_snapshot"]["properties"]["people"]["maxItems"]


class Presence(ServerCase):
    def client(self, document="task", subscribe=True):
        """A client, with the people that its snapshot has."""
        stream = self.server.stream()
        self.addCleanup(stream.close)
        if subscribe:
            stream.subscribe(f"presence/{document}")
            first = stream.message()
            self.assertEqual((first["channel"], first["kind"]), (f"presence/{document}", "snapshot"))
            stream.people = {person["id"]: person for person in first["data"]["people"]}
        return stream

    @staticmethod
    def say(stream, name, document="task", **activity):
        stream.send_checked({"type": "presence", "document": document, "name": name, **activity})

    def join(self, stream, name, **activity):
        """The id of the person."""
        self.say(stream, name, **activity)
        return stream.until(lambda m: m["kind"] == "joined")[-1]["data"]["id"]

    def until(self, stream, condition):
        """Follows the channel until condition(people) holds; returns how many deltas came."""
        deltas = 0
        while not condition(stream.people):
            message = stream.message()
            if message["kind"] == "delta":
                deltas += 1
                stream.people.update({person["id"]: person for person in message["data"]["people"]})
                for gone in message["data"]["left"]:
                    stream.people.pop(gone, None)
        return deltas

    def test_others_are_told_what_a_person_does(self):
        ada, bob = self.client(), self.client()
        doing = {"level": "root", "selection": ["a", "adone"], "text": {"element": "adone", "field": "when", "offset": 3},
                 "pointer": {"element": "a", "x": 1.5, "y": -2.0}}
        self.say(ada, "Ada", **doing)
        self.until(bob, lambda people: people)
        [shown] = bob.people.values()
        self.assertEqual(shown, {"name": "Ada", "id": shown["id"], "colour": 0, **doing})
        self.say(ada, "Ada")
        self.until(bob, lambda people: "text" not in people[shown["id"]])
        self.assertEqual(bob.people[shown["id"]], {"name": "Ada", "id": shown["id"], "colour": 0})
        self.assertEqual(self.client().people, bob.people)

    def test_two_of_one_name_are_told_apart(self):
        ada, other = self.client(), self.client()
        one, two = self.join(ada, "Ada"), self.join(other, "Ada")
        self.assertNotEqual(one, two)
        watcher = self.client()
        self.assertEqual([watcher.people[id]["name"] for id in (one, two)], ["Ada", "Ada"])
        self.assertNotEqual(watcher.people[one]["colour"], watcher.people[two]["colour"])

    def test_however_much_a_person_does_others_are_told_the_last_of_it_not_too_often(self):
        ada, bob = self.client(subscribe=False), self.client()
        begun = time.monotonic()
        for offset in range(2000):
            ada.send({"type": "presence", "document": "task", "name": "Ada", "text": {"field": "doc", "offset": offset}})
        deltas = self.until(bob, lambda people: any(each["text"]["offset"] == 1999 for each in people.values()))
        took = time.monotonic() - begun
        self.assertLessEqual(deltas, took / PERIOD + 2)
        print(f"2000 messages, {deltas} told in {took:.2f} s", flush=True)

    def test_they_are_told_soon(self):
        ada, bob = self.client(subscribe=False), self.client()
        took = []
        for offset in range(50):
            begun = time.monotonic()
            self.say(ada, "Ada", text={"field": "doc", "offset": offset})
            self.until(bob, lambda people, told=offset: any(each["text"]["offset"] == told for each in people.values()))
            took.append(time.monotonic() - begun)
        took.sort()
        print(f"told after {took[25] * 1000:.1f} ms (median), {took[-1] * 1000:.1f} ms (most)", flush=True)

    def test_who_leaves_is_gone(self):
        watcher, ada, bob, cyd = self.client(), self.client(), self.client(), self.client()
        ids = [self.join(stream, "Ada") for stream in (ada, bob, cyd)]
        self.until(watcher, lambda people: set(people) == set(ids))
        ada.send_checked({"type": "unsubscribe", "channel": "presence/task"})
        self.until(watcher, lambda people: set(people) == set(ids[1:]))
        bob.close()  # without a word
        self.until(watcher, lambda people: set(people) == {ids[2]})
        self.say(cyd, "Ada", document="other")
        self.until(watcher, lambda people: not people)

    def test_so_many_are_shown_and_who_comes_later_edits_all_the_same(self):
        self.server.put("/documents/task", {"rcm": 1, "root": {"state": "Root", "meta": {"id": "root"}}}, "document_entry")
        people = [self.client(subscribe=False) for _ in range(MOST)]
        for stream in people:
            self.join(stream, "Ada")
        late = self.client()
        self.assertEqual(len(late.people), MOST)
        self.say(late, "Bob")
        refused = late.until(lambda m: m["kind"] == "error")[-1]
        self.assertEqual((refused["channel"], refused["data"]["errors"][0]["code"]), ("presence/task", "too_large"))
        late.send_checked({"type": "edit", "document": "task", "request": "t-1", "revision": 1, "author": "Bob",
                           "operations": [{"op": "set", "id": "root", "field": "doc", "value": "Bob"}]})
        late.until(lambda m: m["kind"] == "edit_accepted")
        people[0].close()
        self.until(late, lambda there: len(there) == MOST - 1)
        self.join(late, "Bob")

    def test_what_is_no_presence_is_refused_and_nobody_is_told(self):
        bob, ada = self.client(), self.client(subscribe=False)
        long = {"selection": ["a"] * 33}
        for wrong, code in (({"name": ""}, "name"), ({"name": "x" * 41}, "too_large"), ({"name": "Ada", "id": 3}, "unknown_field"),
                            ({"name": "Ada", **long}, "too_large"),
                            ({"name": "Ada", "pointer": {"element": "a", "x": 1e9, "y": 0}}, "out_of_range"),
                            ({"name": "Ada", "document": "a/b"}, "name"), ({}, "missing")):
            ada.send({"type": "presence", "document": "task", **wrong})
            error = ada.message()
            self.assertEqual((error["channel"], error["kind"], error["data"]["errors"][0]["code"]), ("", "error", code), wrong)
        ada.send(json.loads('{"type": "presence", "document": "task", "name": "A\\u0000"}'))
        self.assertEqual(ada.message()["data"]["errors"][0]["code"], "name")
        self.join(ada, "Ada")
        self.assertEqual(self.until(bob, lambda people: people), 1)

    def test_nobody_is_taken_for_somebody_of_before_a_restart(self):
        ada = self.client()
        before = self.join(ada, "Ada")
        self.restart()
        again = self.client()
        self.assertEqual(again.people, {})
        self.assertGreater(self.join(again, "Ada"), before)


if __name__ == "__main__":
    unittest.main()
