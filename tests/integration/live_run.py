"""A run that follows the edits of its document, and what holds after each macro step (core/SEMANTICS.md section 9)."""
import collections
import time

from client import TIMEOUT
from document_replica import digest


class LiveRun:
    """Of a core that the server makes of the document and starts. `cores`: those that came to where nothing leads on, and
    the one that runs."""

    def __init__(self, server, document):
        self.server, self.document, self.forced, self.cores = server, document, 0, []
        self.tries = collections.Counter()  # to leave a state, by path
        self.begin()

    def begin(self):
        self.cores.append(self.server.post("/cores", {"document": self.document, "arguments": {}}, "core", 201)["id"])
        self.server.put(f"/cores/{self.core}/live", {"live": True}, "core")
        self.server.post(f"/cores/{self.core}/start", None, "core")

    @property
    def core(self):
        return self.cores[-1]

    def info(self):
        core = self.server.get(f"/cores/{self.core}", "core")
        assert core["status"] == "running", core
        return core

    def follow(self):
        """Until it is at the last revision of the document, which is sound. What it waits for it names: a state that
        is still active after a while is left by force."""
        last, end, force_from = self.entry(), time.monotonic() + TIMEOUT, time.monotonic() + 1
        assert not last["errors"], last["errors"]
        while (core := self.info())["revision"] < last["revision"]:
            assert time.monotonic() < end, core
            assert "refused_edit" not in core or core["refused_edit"]["revision"] < last["revision"], core
            waiting = core.get("waiting_edit", {"waits": []})
            if waiting["waits"] and time.monotonic() > force_from:
                self.leave(waiting["waits"][0]["path"])
            time.sleep(0.02)
        assert self.digest() == digest(meaning(self.server.get(f"/documents/{self.document}/native", "native")["document"]))

    def leave(self, path):
        """The active state there, or the nearest one above it (also above a barrier) that has a port, through that; where this
        leads back, through the next one above. Nothing leads out of a state of the root without ports (a group, say): then
        another core begins."""
        state, ports, above = self.native()["root"], [], path.partition("/")[0]
        for name in path.split("/")[1:]:
            children = state.get("children", ())
            if any(child.get("barrier") == name for child in children):
                break
            state = next((child for child in children if child.get("state") == name), None)
            if state is None:  # the run has got the edit meanwhile
                return
            above += f"/{name}"
            ports += [{"path": above, "scope": "port", "name": port["name"]} for port in state.get("ports", ())[:1]]
        self.tries[path] += 1
        ports = ports[:max(0, len(ports) - self.tries[path] // 4)]
        if not ports:
            self.server.post(f"/cores/{self.core}/stop", None, "core")
            self.tries.clear()
            self.begin()
            return
        status, answer = self.server.request("POST", f"/api/v1/cores/{self.core}/force", ports[-1])
        assert status in (200, 404, 409), answer  # else it was left, or is another model meanwhile
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
