"""Clients that flood a server, and how it does meanwhile: for the tests of floods, connections and overload."""
import json
import re
import socket
import threading
from pathlib import Path

import models
from component_process import component_client, wait_available


def resident(server):
    """[bytes]"""
    status = Path(f"/proc/{server.process.pid}/status").read_text()
    return 1024 * int(re.search(r"VmRSS:\s*(\d+)", status).group(1))


class Flood(threading.Thread):
    """A client that says its messages again and again, as fast as it can, and never reads."""

    def __init__(self, connection, messages):
        super().__init__(daemon=True)
        self.socket = connection.socket
        self.socket.settimeout(0.2)
        self.over = threading.Event()
        self.refused = False
        self.said = 0
        # As bytes, made once: the server has to be busier than this client.
        for message in messages:
            connection.protocol.send_text(message.encode())
        self.data = memoryview(b"".join(connection.protocol.data_to_send()))
        self.share = len(messages) / len(self.data)

    def run(self):
        at = 0
        while not self.over.is_set():
            try:
                sent = self.socket.send(self.data[at:at + 2**18])
            except TimeoutError:  # it has to wait: so it should be
                continue
            except OSError:
                self.refused = True
                return
            at = (at + sent) % len(self.data)
            self.said += sent * self.share

    def end(self):
        self.over.set()
        self.join()
        self.socket.close()


def is_open(connection):
    """Whether the other side has not closed it; nothing is read."""
    return connection.getsockopt(socket.IPPROTO_TCP, socket.TCP_INFO, 1)[0] == 1  # TCP_ESTABLISHED


def subscribe(channel):
    return f'{{"type": "subscribe", "channel": "{channel}"}}'


def unsubscribe(channel):
    return f'{{"type": "unsubscribe", "channel": "{channel}"}}'


# Takes each event in a macro step of its own.
COUNTING = models.document("count", {
    "state": "Root", "variables": [{"name": "n", "initial": 0}],
    "actions": [{"when": "svc.display.button", "do": "var.n = var.n + 1"}]}, services={"display": "display"})


def display_process(server):
    """The process of the server's display, which answers nothing; and 1000 events of it, as messages."""
    process = component_client(server, "display")
    wait_available(server, "display")
    event = json.dumps({"type": "event", "key": "display", "name": "button",
                        "data": {"button": "x" * 200, "display": "main"}})
    return process, [event] * 1000
