"""A client of Server-Sent Events, on Python's library alone: what a program without a WebSocket does."""
import http.client
import json

from client import TIMEOUT, check


class Events:
    """Follows a core; every event is held against stream_message.json. `status` is that of the answer."""

    def __init__(self, port, core, last=None, token=None):
        """`last`: the id of the last event that it has."""
        self.connection = http.client.HTTPConnection("127.0.0.1", port, timeout=TIMEOUT)
        self.begin(self.connection, f"/api/v1/cores/{core}/events", last, token)

    def begin(self, connection, path, last=None, token=None, **more):
        headers = {"Accept": "text/event-stream", **more}
        if last is not None:
            headers["Last-Event-ID"] = str(last)
        if token is not None:
            headers["Authorization"] = f"Bearer {token}"
        connection.request("GET", path, headers=headers)
        self.answer = connection.getresponse()
        self.status, self.comments = self.answer.status, 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """As a client that crashes."""
        self.answer.close()
        self.connection.close()

    def fields(self):
        """The fields of the next event; {}: the answer has ended, as it should."""
        found = {}
        while line := self.answer.readline():
            text = line.decode().removesuffix("\n")
            assert line.endswith(b"\n") and "\r" not in text, line
            name, _, value = text.partition(": ")
            if text == "" and found:
                return found
            if text.startswith(":"):
                self.comments += 1
            elif text:
                assert name in ("id", "event", "data") and name not in found, text
                found[name] = value
        assert not found, f"it ends within an event: {found}"
        return {}

    def event(self):
        """The next message; None: the answer has ended."""
        fields = self.fields()
        if not fields:
            return None
        message = check("stream_message", json.loads(fields["data"]))
        assert fields["event"] == message["kind"], fields
        assert fields.get("id") == (None if message["kind"] == "error" else str(message["sequence"])), fields
        return message

    def until(self, condition):
        """All messages up to and including the first for which condition(message) holds."""
        messages = []
        while not messages or not condition(messages[-1]):
            message = self.event()
            assert message is not None, f"it ends after {len(messages)} messages"
            messages.append(message)
        return messages
