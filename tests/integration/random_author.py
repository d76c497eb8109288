"""A client that edits a document at random, over REST or on the stream: it is late, loses messages on their way and answers on
theirs, loses its connection, comes back and sends again what was not answered."""
import http.client
import json
import random
import time

from client import TIMEOUT
from document_replica import Replica
from random_edits import RandomEdits


class RandomAuthor:
    """One author: knows the document as far as it has read the channel. `accepted`: revisions of own edits, by token;
    `unsure`: tokens of those that were on their way when a connection was lost: one may arrive after the answer to its second."""

    def __init__(self, server, document, name, seed):
        self.server, self.document, self.name = server, document, name
        self.random = random.Random(f"{seed}/{name}")
        self.edits, self.replica, self.stream = RandomEdits(name, self.random), Replica(), None
        self.accepted, self.restored, self.unsure, self.refused, self.sent, self.lost = {}, set(), set(), 0, 0, 0

    def run(self, edits):
        """So many edits, accepted or refused."""
        self.connect()
        for _ in range(edits):
            time.sleep(self.random.random() ** 4 * 0.05)
            if self.happens(0.05):
                self.reconnect(self.random.random() * 0.3)
            self.edit(self.edits.next(self.replica))

    def edit(self, wish):
        if "restore" in wish:
            self.restore(wish["restore"])
            return
        request = {"revision": self.replica.revision, "author": self.name, "request": self.token(), **wish}
        (self.edit_on_stream if self.happens(0.6) else self.edit_over_rest)(request)

    def restore(self, revision):
        stored = self.server.post(f"/documents/{self.document}/restore", {"revision": revision, "author": self.name}, "document_entry")
        self.restored.add(stored["revision"])
        self.read_until(stored["revision"])

    def token(self):
        self.sent += 1
        return f"{self.name}-{self.sent}"

    def happens(self, chance):
        return self.random.random() < chance

    # Transport

    def connect(self):
        self.stream = self.server.stream()
        self.stream.subscribe(f"document/{self.document}", self.replica.sequence)
        if self.replica.sequence is None:
            self.read()

    def reconnect(self, seconds=0.0):
        """The connection is lost, with what was on its way; another one, after these seconds."""
        self.stream.close()
        time.sleep(seconds)
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
        message = {"type": "edit", "document": self.document, **wish}
        if self.happens(0.06):  # lost before it was sent
            self.lost += 1
            self.reconnect(self.random.random() * 0.1)
        self.stream.send_checked(message)
        while self.happens(0.1):  # was it accepted?
            self.lost += 1
            self.unsure.add(wish["request"])
            self.reconnect(self.random.random() * 0.02)
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
        path = f"/api/v1/documents/{self.document}/edits"
        while self.happens(0.08):  # its answer is not read
            self.lost += 1
            self.unsure.add(wish["request"])
            connection = http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=TIMEOUT)
            connection.request("POST", path, json.dumps(wish), {"Content-Type": "application/json"})
            connection.close()
        status, answer = self.server.request("POST", path, wish)
        if status == 200:
            self.note(answer, wish)
            again = self.happens(0.1)
            assert not again or self.server.request("POST", path, wish)[1]["revision"] == answer["revision"]
        else:
            assert status in (409, 422), (status, answer, wish)
            self.note_refusal(answer, wish)
        if self.happens(0.5):  # else the next edit is a late one
            self.read_until(answer.get("revision", 0))

    def note(self, accepted, wish):
        assert (accepted["author"], accepted["request"]) == (self.name, wish["request"]), (accepted, wish)
        assert self.accepted.setdefault(wish["request"], accepted["revision"]) == accepted["revision"]

    def note_refusal(self, answer, wish):
        assert wish["request"] not in self.accepted and answer["errors"], (answer, wish)
        self.refused += 1
