"""Loads of a server, and clients that measure it meanwhile: each in a process of its own, so that none holds up another.

A load is a function of (server, over): it goes on until the event `over` is set, and returns what it has to tell. Of the server
it uses no more than the port.
"""
import contextlib
import http.client
import itertools
import json
import multiprocessing
import os
import socket
import statistics
import time
import traceback
import warnings
from concurrent.futures import ThreadPoolExecutor

import hostile_tasks
import models
from client import TIMEOUT, Stream
from floods import Flood, display_process, is_open, subscribe

HOSTILE_CORES = 20
SLOW_READERS = 200
IDLE_CONNECTIONS = 50
LOOKS_PER_STOP = 10  # at all cores of a kind
MOST_GAP = 2  # times the gap of a good core alone


class Load:
    """A process that executes a load, at once. `nice`: it stands for clients on other machines, which take no processor from
    the server and from those that measure."""

    def __init__(self, load, server, nice=0):
        self.nice = nice
        self.over = multiprocessing.Event()
        self.results, theirs = multiprocessing.Pipe(duplex=False)
        self.process = multiprocessing.Process(target=self.run, args=(load, server, theirs), daemon=True)
        self.process.start()

    def run(self, load, server, results):
        os.nice(self.nice)
        warnings.simplefilter("ignore", ResourceWarning)  # where one fails, its sockets are closed by its end
        try:
            results.send((load(server, self.over), None))
        except BaseException:  # is the test's
            results.send((None, f"{load.__name__}: {traceback.format_exc()}"))

    def end(self):
        """What it has to tell."""
        self.over.set()
        result, failure = self.results.recv()
        self.process.join()
        assert failure is None, failure
        return result

    def kill(self):
        self.process.kill()
        self.process.join()


def ask(server, method, path, body=None):
    """(status, answer, seconds), on a connection of its own; unlike Server.request, no time goes into checks."""
    begun = time.monotonic()
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=TIMEOUT)
    with contextlib.closing(connection):
        headers = {} if body is None else {"Content-Type": "application/json"}
        connection.request(method, f"/api/v1{path}", None if body is None else json.dumps(body), headers)
        response = connection.getresponse()
        answer = response.read()
    return response.status, json.loads(answer) if answer else None, time.monotonic() - begun


class HostileCores:
    """Cores of a kind, which it keeps busy: one whose run is over is created anew, one that is interrupted is resumed."""

    def __init__(self, server, task, count):
        self.server, self.count = server, count
        self.document = task()
        self.name = self.document["name"]
        self.cores = []
        self.begun = self.seen = self.running = 0  # runs and resumptions; looks at a core, and those at which it ran
        self.stops = []  # [s]

    def say(self, method, path, body=None, accepted=()):
        """The answer; nothing if the server refuses with an accepted status."""
        status, answer, _ = ask(self.server, method, path, body)
        assert status < 300 or status in accepted, f"{method} {path}: {status} {answer}"
        return answer if status < 300 else None

    def begin(self):
        core = self.say("POST", "/cores", {"document": self.name})["id"]
        self.say("POST", f"/cores/{core}/start")
        self.cores.append(core)
        self.begun += 1

    def replace(self, core):
        """Not yet, if its run takes long to be read back (503)."""
        if self.say("DELETE", f"/cores/{core}", accepted=(503,)):
            self.cores.remove(core)
            self.begin()

    def look_after(self, core):
        """Sees to it that it does something."""
        status = self.say("GET", f"/cores/{core}")["status"]
        self.seen += 1
        if status == "running":
            self.running += 1
        elif status == "interrupted":
            self.begun += 1
            self.say("POST", f"/cores/{core}/resume", accepted=(409, 413, 503, 507))  # as the run is, or was just before
        else:
            self.replace(core)

    def stop(self, core):
        """409: it has just ended by itself. Who is told that the run was interrupted just then asks again, on the same clock."""
        begun, status = time.monotonic(), 0
        while status not in (200, 409) and time.monotonic() < begun + TIMEOUT:
            status, answer, _ = ask(self.server, "POST", f"/cores/{core}/stop")
        if status != 409:
            assert status == 200, f"the stop of core {core}: {status} {answer}"
            self.stops.append(time.monotonic() - begun)

    def keep_busy(self, over):
        """Until the end; now and then one is stopped, in the end all are, and removed."""
        self.say("PUT", f"/documents/{self.name}", self.document)
        for _ in range(self.count):
            self.begin()
        for look in itertools.count(1):
            for core in list(self.cores):
                self.look_after(core)
            if look % LOOKS_PER_STOP == 0:
                self.stop(self.cores[0])
            if over.wait(0.3):
                break
        for core in self.cores:
            self.stop(core)
        for core in self.cores:
            self.say("DELETE", f"/cores/{core}", accepted=(503,))
        return self

    def told(self):
        return {"begun": self.begun, "busy": self.running / max(1, self.seen), "stops": self.stops}


def cores_of(task, count):
    """The load of so many cores of a kind; it has to tell what HostileCores.told() says."""
    def cores(server, over):
        return HostileCores(server, task, count).keep_busy(over).told()
    return cores


def hostile_cores(server, over):
    """What there is to tell of each kind (HostileCores.told()), by name."""
    kinds = hostile_tasks.KINDS
    counts = [len(range(i, HOSTILE_CORES, len(kinds))) for i in range(len(kinds))]
    with ThreadPoolExecutor(len(kinds)) as pool:
        loads = [cores_of(kind, count) for kind, count in zip(kinds, counts, strict=True)]
        told = pool.map(lambda load: load(server, over), loads)
        return {kind.__name__: each for kind, each in zip(kinds, told, strict=True)}


class SlowReader:
    """A client that subscribes to what is said most and takes some bytes a second, or none; when it is cut, it comes again."""

    def __init__(self, number):
        self.number = number
        self.stream = None
        self.cuts = 0

    def go_on(self, server, cores):
        if self.stream and not is_open(self.stream.socket):
            self.cuts += 1
            self.close()
        if not self.stream:
            self.connect(server, cores)
        elif self.number % 2:
            with contextlib.suppress(BlockingIOError, ConnectionError):
                self.stream.socket.recv(16, socket.MSG_DONTWAIT)

    def connect(self, server, cores):
        mine = [cores[(self.number + i) % len(cores)] for i in range(min(4, len(cores)))]
        channels = [f"core/{core}/{what}" for core in mine for what in ("state", "derivation")]
        try:
            self.stream = Stream(server.port)
            for channel in ["log", "cell/pose", "cores", *channels]:
                self.stream.send(subscribe(channel))
        except ConnectionError:
            self.close()

    def close(self):
        if self.stream:
            self.stream.close()
        self.stream = None


def slow_readers(server, over):
    """How often the server has cut one."""
    readers = [SlowReader(number) for number in range(SLOW_READERS)]
    while not over.wait(1):
        cores = [core["id"] for core in ask(server, "GET", "/cores")[1]["cores"]]
        for reader in readers:
            reader.go_on(server, cores)
    for reader in readers:
        reader.close()
    return sum(reader.cuts for reader in readers)


def flooding_process(server, over):
    """How many events it has sent. A process that gives no sign of life is lost, and comes again."""
    said = 0
    while not over.is_set():
        flood = Flood(*display_process(server))
        flood.start()
        while flood.is_alive() and not over.wait(0.1):
            pass
        flood.end()
        said += flood.said
    return said


def idle_connections(server, over):
    """How often the server has closed one. Half of them have asked for something before."""
    connections, closed = [], 0
    request = f"GET /api/v1/health HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n\r\n".encode()
    while not over.wait(0.2):
        gone = [each for each in connections if not is_open(each)]
        closed += len(gone)
        for each in gone:
            each.close()
            connections.remove(each)
        while len(connections) < IDLE_CONNECTIONS:
            connections.append(socket.create_connection(("127.0.0.1", server.port), timeout=TIMEOUT))
            if len(connections) % 2:
                connections[-1].sendall(request)
    return closed


LOADS = {hostile_cores: 0, slow_readers: 10, flooding_process: 10, idle_connections: 10}  # how nice each is: the first measures, too


def good():
    """Waits for 20 ms, again and again."""
    waiting = lambda me, other: {"state": me, "entry": "svc.timer.wait(0.02)",
                                 "ports": [{"name": "next", "when": "svc.timer.wait.result", "to": other}]}
    return models.document("good", {"state": "Root", "first": "A", "children": [waiting("A", "B"), waiting("B", "A")]})


def p99(values):
    return statistics.quantiles(values, n=100)[98]


def health(server, over):
    """How long each answer takes [s]."""
    took = []
    while not over.wait(0.02):
        status, _, seconds = ask(server, "GET", "/health")
        assert status == 200, status
        took.append(seconds)
    return took


def gaps_of(core):
    """The measurement of the gaps between the messages of its state [s]."""
    def gaps(server, over):
        times = []
        with Stream(server.port) as stream:
            stream.send(subscribe(f"core/{core}/state"))
            while not over.is_set():
                assert stream.receive()["kind"] in ("snapshot", "delta")
                times.append(time.monotonic())
        return [later - earlier for earlier, later in itertools.pairwise(times)]
    return gaps


def measured_gaps(server, core, seconds):
    """gaps_of(core) in this time."""
    gaps = Load(gaps_of(core), server)
    time.sleep(seconds)
    return gaps.end()
