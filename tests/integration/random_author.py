"""A client that edits a document at random, over REST or on the stream, with delays, lost connections and edits sent again."""
import random
import time

from document_replica import Replica, elements

KINDS = {"parameters": {}, "variables": {"initial": 1}, "children": {}, "ports": {"when": "True"}}


class RandomAuthor:
    """One author: knows the document as far as it has read the channel. `accepted`: revisions of own edits, by token."""

    def __init__(self, server, name, seed):
        self.server, self.name, self.random = server, name, random.Random(f"{seed}/{name}")
        self.replica, self.stream, self.accepted, self.refused, self.sent = Replica(), None, {}, 0, 0

    def run(self, edits):
        """So many edits, accepted or refused."""
        self.connect()
        for _ in range(edits):
            time.sleep(self.random.random() ** 4 * 0.05)
            if self.random.random() < 0.05:
                self.reconnect()
            wish = {"revision": self.replica.revision, "author": self.name, "request": self.token(), **self.wish()}
            (self.edit_on_stream if self.random.random() < 0.6 else self.edit_over_rest)(wish)

    def token(self):
        self.sent += 1
        return f"{self.name}-{self.sent}"

    # Transport

    def connect(self):
        self.stream = self.server.stream()
        self.stream.subscribe("document/crowd", self.replica.sequence)
        if self.replica.sequence is None:
            self.read()

    def reconnect(self):
        self.stream.close()
        time.sleep(self.random.random() * 0.02)
        self.connect()

    def read(self):
        message = self.stream.message()
        assert message["kind"] != "error", message
        if message["kind"] in ("snapshot", "delta"):
            self.replica.take(message)
        return message

    def read_until(self, revision):
        while self.replica.revision < revision:
            self.read()

    def edit_on_stream(self, wish):
        message = {"type": "edit", "document": "crowd", **wish}
        self.stream.send_checked(message)
        if self.random.random() < 0.1:  # was it accepted?
            self.reconnect()
            self.stream.send_checked(message)
        while True:
            data = (answer := self.read())["data"]
            if answer["kind"] == "snapshot" or data.get("request") != wish["request"]:
                continue
            if answer["kind"] == "edit_refused":
                self.note_refusal(data, wish)
            else:
                self.note(data, wish)
            return

    def edit_over_rest(self, wish):
        status, answer = self.server.request("POST", "/api/v1/documents/crowd/edits", wish)
        if status == 200:
            self.note(answer, wish)
            again = self.random.random() < 0.1
            assert not again or self.server.request("POST", "/api/v1/documents/crowd/edits", wish)[1]["revision"] == answer["revision"]
        else:
            assert status in (409, 422), (status, answer, wish)
            self.note_refusal(answer, wish)
        if self.random.random() < 0.5:  # else the next edit is a late one
            self.read_until(answer.get("revision", 0))

    def note(self, accepted, wish):
        assert (accepted["author"], accepted["request"]) == (self.name, wish["request"]), (accepted, wish)
        assert self.accepted.setdefault(wish["request"], accepted["revision"]) == accepted["revision"]

    def note_refusal(self, answer, wish):
        assert wish["request"] not in self.accepted and answer["errors"], (answer, wish)
        self.refused += 1

    # What it wants

    def wish(self):
        kind = self.random.random()
        if kind < 0.12:
            return {"undo": True}
        if kind < 0.17:
            return {"redo": True}
        if kind < 0.3:
            return {"compound": self.compound()}
        return {"operations": [self.operation() for _ in range(self.random.choice((1, 1, 1, 2, 3)))]}

    def pick(self, only_states=False):
        return self.random.choice([e["meta"]["id"] for e, *_ in elements(self.replica.document) if "state" in e or not only_states])

    def node(self, kind):
        self.sent += 1
        name = self.random.choice("MNOPQ") + str(self.random.randrange(30))
        return {"state" if kind == "children" else "name": name, **KINDS[kind], "meta": {"id": f"{self.name}{self.sent}"}}

    def place(self, kind):
        parent = self.pick(only_states=True)
        siblings = [e["meta"]["id"] for e, _, p, name in elements(self.replica.document) if p == parent and name == kind]
        after = {"after": self.random.choice(siblings)} if siblings and self.random.random() < 0.7 else {}
        return {"parent": parent, "list": kind, **after}

    def operation(self):
        op, id = self.random.random(), self.pick()
        if op < 0.4:
            kind = self.random.choice(list(KINDS))
            return {"op": "insert", **self.place(kind), "node": self.node(kind)}
        if op < 0.5:
            return {"op": "remove", "id": id}
        if op < 0.6:
            return {"op": "move", "id": self.pick(only_states=True), **self.place("children")}
        if op < 0.7:
            entry = {"value": {"x": self.random.randrange(99)}} if self.random.random() < 0.8 else {}
            return {"op": "set", "id": "", "field": self.random.choice(("layout", "meta")), "key": id, **entry}
        if op < 0.8:
            return {"op": "set", "id": id, "field": "meta", "key": "title", "value": self.name}
        return {"op": "set", "id": id, "field": "doc", "value": f"{self.name} {self.sent}"}

    def compound(self):
        state, name = self.pick(only_states=True), f"G{self.sent}"
        return self.random.choice((
            {"kind": "rename", "id": state, "name": name}, {"kind": "duplicate", "id": state},
            {"kind": "group", "ids": [state], "name": name}, {"kind": "ungroup", "id": state},
            {"kind": "extract", "id": state, "name": name}))
