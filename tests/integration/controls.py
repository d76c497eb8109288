"""People at the controls of a cell: the WebSocket /api/v1/control/hold (asyncapi.yaml, `control`)."""
import contextlib
import json
import threading
import time

from client import TIMEOUT, check
from websocket_client import WebSocketClient

BEAT = 0.05  # [s] twice as often as a page: a busy machine may keep a thread of Python waiting
SILENCE = 0.25


class Controls(WebSocketClient):
    """One person's connection. What is told is checked against its schema."""

    def __init__(self, server, token=None):
        super().__init__(server.port, "/api/v1/control/hold", TIMEOUT, token=token or server.token)
        self.server, self.number, self.calls = server, 0, 0
        self.sending = threading.Lock()
        self.beating, self.beats = threading.Event(), None

    def say(self, kind, **more):
        with self.sending:
            self.send({"type": kind, **more})

    def hear(self):
        return check("control_message", self.receive())

    def until(self, kind):
        """The next message of a kind; others are skipped."""
        while (message := self.hear())["kind"] != kind:
            continue
        return message

    def take(self, **more):
        """Asks for the controls; the answer."""
        self.say("take", **more)
        answer = self.hear()
        if answer["kind"] == "taken":
            self.taken(answer)
        return answer

    def taken(self, answer):
        self.number, self.secret = answer["number"], answer["secret"]
        self.beat()

    def beat(self):
        """Is heard each BEAT, until silent()."""
        self.beating = threading.Event()
        self.beats = threading.Thread(target=self._beat, args=(self.beating,), daemon=True)
        self.beats.start()

    def _beat(self, ended):
        while not ended.wait(BEAT):
            try:
                self.say("beat")
            except OSError:
                return

    def silent(self):
        self.beating.set()
        if self.beats:
            self.beats.join()

    def close(self):
        self.silent()
        super().close()

    def call(self, service, operation, **kwargs):
        """The response to a call by hand: {"result"} or {"error"}, without its number."""
        self.calls += 1
        self.say("call", number=self.calls, service=service, operation=operation, kwargs=kwargs)
        response = self.until("response")
        assert response["number"] == self.calls, response
        return {key: value for key, value in response.items() if key in ("result", "error")}

    def request(self, method, path, body=None):
        """(status, answer) of a request that proves to have the controls."""
        return self.server.request(method, "/api/v1" + path, body, {"Race-Control": self.secret})

    def set_mode(self, mode):
        status, answer = self.request("PUT", "/control/mode", {"mode": mode})
        assert status == 200, answer
        return check("control", answer)

    def programming(self):
        """Takes the controls, in the mode in which things are moved by hand."""
        answer = self.take()
        assert answer["kind"] == "taken", answer
        self.set_mode("programming")
        return self


class RecordedControls(Controls):
    """Keeps its messages as they were sent."""

    def __init__(self, server, token=None):
        self.sent = []
        super().__init__(server, token)

    def send(self, message):
        self.sent.append(message if isinstance(message, str) else json.dumps(message))
        super().send(self.sent[-1])

    def recorded(self, kind):
        return [text for text in self.sent if json.loads(text)["type"] == kind]


@contextlib.contextmanager
def pressed(person, operation, **kwargs):
    """A button is held meanwhile: an operation of the robot is called again and again, whatever is answered, until the
    connection ends."""
    released = threading.Event()

    def hold():
        with contextlib.suppress(OSError):
            while not released.wait(0.05):
                person.call("robot", operation, **kwargs)

    button = threading.Thread(target=hold)
    button.start()
    try:
        yield
    finally:
        released.set()
        button.join()


def held(person, turn=0.3):
    """The button of a jog. `turn`: of the base [rad/s]."""
    return pressed(person, "jog", joints=[turn, 0, 0, 0, 0, 0, 0])


def eventually(found, timeout=TIMEOUT):
    """The first true value of found()."""
    end = time.monotonic() + timeout
    while not (value := found()):
        assert time.monotonic() < end, "it does not come"
        time.sleep(0.01)
    return value
