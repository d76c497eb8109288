"""Components outside the server: real processes (`race service`), and the test itself in the role of one."""
import subprocess
import time
from pathlib import Path

from client import PROGRAM, TIMEOUT, check
from websocket_client import WebSocketClient

LONG_HEARTBEAT = ("--heartbeat", "30")  # for tests in which nothing hangs: a machine under load may be slow


def token_file(server):
    """The token of processes of the user that the server has."""
    return Path(server.data) / "processes.token"


class ComponentProcess:
    """`race service NAME` for a server. As a context manager it is killed at the end of the block."""

    def __init__(self, server, name, *options):
        command = [PROGRAM, "service", name, "--server", f"http://127.0.0.1:{server.port}",
                   "--token-file", str(token_file(server)), *options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def kill(self):
        self.process.kill()
        self.process.wait(TIMEOUT)

    def signal(self, number):
        self.process.send_signal(number)


class ComponentClient(WebSocketClient):
    """The test in the role of a component process; every message of the server is held against component_message.json."""

    def __init__(self, server, origin=None, token=None):
        token = token or token_file(server).read_text().strip()
        super().__init__(server.port, "/api/v1/components", TIMEOUT, origin, token)

    def send_checked(self, message):
        """Sends a message that is of component_request.json."""
        self.send(check("component_request", message))

    def message(self):
        """The next message."""
        return check("component_message", self.receive())

    def next(self, kind):
        """The next message of this type, if it comes soon; answers pings and skips news in between."""
        end = time.monotonic() + TIMEOUT
        while (message := self.message())["type"] != kind:
            assert message["type"] in ("ping", "news"), message
            assert time.monotonic() < end, f"no {kind} comes"
            if message["type"] == "ping":
                self.send_checked({"type": "pong", "number": message["number"]})
        return message


def component_client(server, key):
    """The test in the role of the process with the service `key`, whose type is named alike; the server has welcomed it."""
    client = ComponentClient(server)
    client.send_checked({"type": "hello", "protocol": 1, "components": [
        {"key": key, "type": key, "rsm": service(server, key)["rsm"]}]})
    client.next("welcome")
    return client


def service(server, key):
    """The service as GET /services lists it; one that no process has brought yet: not available."""
    listed = server.get("/services", "services")["services"]
    return next((s for s in listed if s["key"] == key), {"key": key, "available": False, "state": ""})


def wait_until(condition, timeout=TIMEOUT):
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        if condition():
            return
        time.sleep(0.005)
    raise AssertionError(f"the condition does not hold within {timeout} s")


def wait_available(server, key, available=True):
    """Waits until the server lists the service as available, or as not available."""
    wait_until(lambda: service(server, key)["available"] == available)
