"""A run that follows the edits of its document, and what holds after each macro step (core/SEMANTICS.md section 9)."""
import time

from client import TIMEOUT
from document_replica import digest


class LiveRun:
    """Of a core that the server makes of the document and starts."""

    def __init__(self, server, document):
        self.server, self.document, self.forced = server, document, 0
        self.core = server.post("/cores", {"document": document, "arguments": {}}, "core", 201)["id"]
        for command, body in (("live", {"live": True}), ("start", None)):
            (server.put if body else server.post)(f"/cores/{self.core}/{command}", body, "core")

    def info(self):
        core = self.server.get(f"/cores/{self.core}", "core")
        assert core["status"] == "running", core
        return core

    def follow(self):
        """Until it is at the last revision of the document, which is sound. What it waits for it names: if that is still
        active after a while, it is left by force."""
        last, end, patience = self.entry(), time.monotonic() + TIMEOUT, time.monotonic() + 1
        assert not last["errors"], last["errors"]
        while (core := self.info())["revision"] < last["revision"]:
            assert time.monotonic() < end, core
            assert "refused_edit" not in core or core["refused_edit"]["revision"] < last["revision"], core
            waiting = core.get("waiting_edit", {"revision": 0})
            if waiting["revision"] == last["revision"] and time.monotonic() > patience:
                assert waiting["waits"], core
                self.leave(waiting["waits"])
            time.sleep(0.02)
        assert self.digest() == digest(meaning(self.server.get(f"/documents/{self.document}/native", "native")["document"]))

    def leave(self, waits):
        """Each of these active states, or the nearest one above it that has a port, through that."""
        root = self.native()["root"]
        for wait in waits:
            path, port, state = wait["path"].split("/"), None, root
            for depth, name in enumerate(path[1:], 2):
                state = next(child for child in state["children"] if name in (child.get("state"), child.get("barrier")))
                if state.get("ports"):
                    port = {"path": "/".join(path[:depth]), "scope": "port", "name": state["ports"][0]["name"]}
            assert port, f"nothing leads out of {wait}"
            status, answer = self.server.request("POST", f"/api/v1/cores/{self.core}/force", port)
            assert status in (200, 404, 409), answer  # it has left it by itself, or is another model meanwhile
            self.forced += status == 200

    def entry(self):
        return self.server.get(f"/documents/{self.document}", "document_entry")

    def native(self):
        return self.server.get(f"/cores/{self.core}/native", "native")["document"]

    def digest(self):
        return digest(meaning(self.native()))

    def journal(self):
        """What was delivered, in order: "start", "edit", "event", ..."""
        return [entry["input"]["kind"] for entry in self.server.get(f"/cores/{self.core}/journal", "journal")["entries"]]


def meaning(document):
    """The document without what no run depends on, and none follows: its layout and notes."""
    return {key: value for key, value in document.items() if key not in ("layout", "meta")}


def check_invariants(state):
    """Of a state (state.json) between macro steps."""
    above = lambda path: path.rpartition("/")[0]
    active = set(state["active"])
    assert active and all(above(path) in active for path in active if "/" in path), state["active"]
    for port in state["ports"]:
        owner = port.rpartition(".")[0]
        assert owner not in active and (above(owner) in active or "/" not in owner), (port, state["active"])
    for barrier, ports in state["activated"].items():
        assert ports and above(barrier) in active, (barrier, ports, state["active"])
