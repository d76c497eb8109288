"""Clients that hold what others need: connections, bodies that do not come, processes that nobody knows. Health is answered and
cores stop meanwhile, memory stays bounded, and the server ends at once when it is told to.
"""
import contextlib
import json
import select
import signal
import socket
import statistics
import threading
import time
import unittest

import models
from client import TIMEOUT, Server, Stream, check
from component_process import LONG_HEARTBEAT, ComponentClient
from floods import is_open, resident
from websockets.frames import OP_CLOSE, OP_TEXT

MIB = 1 << 20
MOST_UNSENT = 512 * 1024  # [bytes] that the kernel keeps of a connection (kSendBuffer in server/http/listener.cpp)
CEILING = 150e6  # [bytes] that the server may grow by
BUDGET = 64 * MIB  # of bodies, answers and first messages (server/http/listener.h)
HELLO = 4 * MIB
MOST_OF_ADDRESS, RESERVED = 448, 16  # connections (server/http/connections.h)


def held(server, text, count):
    """So many connections, each of which has said the text."""
    connections = []
    for _ in range(count):
        connection = socket.create_connection(("127.0.0.1", server.port), timeout=TIMEOUT)
        with contextlib.suppress(OSError):  # the server may have closed it
            connection.sendall(text)
        connections.append(connection)
    return connections


def answered(connection):
    """The status of the answer that comes first; 0: the server has closed the connection."""
    try:
        answer = connection.recv(65536)
    except ConnectionError:
        return 0
    return int(answer.split()[1]) if answer else 0


def unsent(server, connection):
    """What the kernel keeps for a connection until its client takes it [bytes] (proc(5), /proc/net/tcp)."""
    ports = f":{server.port:04X}", f":{connection.getsockname()[1]:04X}"
    with open("/proc/net/tcp") as table:
        rows = [row.split() for row in table]
    [queues] = [row[4] for row in rows if row[1].endswith(ports[0]) and row[2].endswith(ports[1])]
    return int(queues.split(":")[0], 16)


class Case(unittest.TestCase):
    """Each test has a server of its own."""
    OPTIONS = ()

    def setUp(self):
        self.server = Server(*self.OPTIONS)
        self.host = f"Host: 127.0.0.1:{self.server.port}\r\n"
        self.connections = []

    def tearDown(self):
        for connection in self.connections:
            connection.close()
        self.server.stop()  # which may have ended

    def hold(self, text, count):
        self.connections += held(self.server, text.encode(), count)
        return self.connections[-count:]


class Places(Case):
    def test_idle_connections_make_way(self):
        core = self.server.core(models.ticking("endless", last=10**9))
        idle = self.hold(f"GET /api/v1/health HTTP/1.1\r\n{self.host}\r\n", 700)
        self.assertEqual({answered(each) for each in idle[-300:]}, {200})
        self.server.get("/health", "health")
        self.server.get("/documents", "documents")
        self.server.post(f"/cores/{core}/stop", None, "core")
        self.assertGreater(sum(is_open(each) for each in idle), 300)
        self.assertFalse(any(is_open(each) for each in idle[:100]))

    def test_health_and_stop_are_answered_whoever_holds_the_connections(self):
        core = self.server.core(models.ticking("endless", last=10**9))
        self.hold(f"GET /api/v1/health HTTP/1.1\r\n{self.host}X-Half: ", 700)
        for _ in range(20):
            self.server.get("/health", "health")
        status, problem = self.server.request("GET", "/api/v1/documents")
        self.assertEqual((status, problem["errors"][0]["code"]), (503, "overload"))
        self.assertEqual(self.server.post(f"/cores/{core}/stop", None, "core")["status"], "aborted")
        self.server.wait_for(lambda: sum(is_open(each) for each in self.connections) <= MOST_OF_ADDRESS, 10)  # of others, a second

    def test_a_header_has_half_a_minute_however_it_drips(self):
        begun = time.monotonic()
        silent, dripping = self.hold(f"GET /api/v1/health HTTP/1.1\r\n{self.host}X-Half: ", 2)
        while is_open(dripping) and time.monotonic() < begun + 40:
            with contextlib.suppress(ConnectionError):
                dripping.send(b"x")
            time.sleep(0.5)
        self.assertFalse(is_open(dripping))
        self.assertGreater(time.monotonic() - begun, 25, "a client may be slow")
        self.server.wait_for(lambda: not is_open(silent), 5)

    def test_reserved_connections_whose_body_does_not_come_make_way(self):
        self.hold(f"GET /api/v1/health HTTP/1.1\r\n{self.host}X-Half: ", MOST_OF_ADDRESS)
        body = "Content-Type: application/json\r\nContent-Length: 2\r\n\r\n{"
        begun = time.monotonic()
        reserved = self.hold(f"POST /api/v1/cores/1/stop HTTP/1.1\r\n{self.host}{body}", RESERVED)
        time.sleep(0.1)  # for the server to read their headers
        self.server.get("/health", "health")
        took = time.monotonic() - begun
        print(f"health in place of a reserved connection: after {took:.2f} s", flush=True)
        self.assertEqual([is_open(each) for each in reserved[:2]], [False, True], "the oldest made way")
        self.assertLess(took, 1, "after that they end by themselves")

    def test_the_kernel_keeps_little_for_who_takes_nothing(self):
        document = models.document("large", {"state": "Root", "doc": "x" * 10**6})
        self.server.put("/documents/large", document, "document_entry")
        connection = socket.socket()
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.connect(("127.0.0.1", self.server.port))
        self.connections.append(connection)
        connection.sendall(f"GET /api/v1/documents/large HTTP/1.1\r\n{self.host}\r\n".encode())
        self.server.wait_for(lambda: unsent(self.server, connection) > MOST_UNSENT // 2)
        time.sleep(0.2)  # for more, if there were
        self.assertLessEqual(unsent(self.server, connection), MOST_UNSENT)

    def test_health_waits_for_nobody(self):
        large = {"rcm": 1, "root": {"state": "Root", "doc": "x" * 10**6}}
        for number in range(60):
            self.server.put(f"/documents/large{number}", {**large, "name": f"large{number}"}, "document_entry")
        end = threading.Event()

        def ask():
            while not end.is_set():
                for number in range(60):
                    with contextlib.suppress(OSError):
                        request = f"GET /api/v1/documents/large{number} HTTP/1.1\r\n{self.host}Connection: close\r\n\r\n"
                        self.server.send_raw(request.encode())

        clients = [threading.Thread(target=ask) for _ in range(8)]
        for client in clients:
            client.start()
        took = []
        for _ in range(100):
            begun = time.monotonic()
            answer = self.server.send_raw(f"GET /api/v1/health HTTP/1.1\r\n{self.host}Connection: close\r\n\r\n".encode())
            took.append(time.monotonic() - begun)
            self.assertTrue(answer.startswith(b"HTTP/1.1 200"))
        end.set()
        for client in clients:
            client.join()
        usual = statistics.quantiles(took, n=20)[-1]
        print(f"health: p95 {1000 * usual:.1f} ms, longest {1000 * max(took):.0f} ms", flush=True)
        self.assertLess(usual, 0.1)


class Memory(Case):
    OPTIONS = ("--remote", "database", *LONG_HEARTBEAT)

    def feed(self, connections, size):
        """Sends each connection up to `size` bytes, as much as the server takes; the most memory it had meanwhile [bytes]."""
        data, left = b" " * 65536, dict.fromkeys(connections, size)
        most, end = 0, time.monotonic() + 10
        for connection in connections:
            connection.setblocking(False)
        while left and time.monotonic() < end:
            _, writable, _ = select.select([], list(left), [], 0.5)
            if not writable:
                break
            for connection in writable:
                try:
                    left[connection] -= connection.send(data[:left[connection]])
                except BlockingIOError:
                    continue
                except OSError:
                    left[connection] = 0
                if not left[connection]:
                    del left[connection]
            most = max(most, resident(self.server))
        return max(most, resident(self.server))

    def test_bodies_that_do_not_come_share_a_budget(self):
        before = resident(self.server)
        header = f"PUT /api/v1/documents/x HTTP/1.1\r\n{self.host}Content-Type: application/json\r\nContent-Length: {4 * MIB}\r\n\r\n"
        connections = self.hold(header, 400)
        most = self.feed(connections, 4 * MIB - 1000)
        print(f"400 bodies: +{(most - before) / 1e6:.0f} MB", flush=True)
        self.assertLess(most - before, CEILING)
        self.server.wait_for(lambda: sum(is_open(each) for each in connections) <= BUDGET // (4 * MIB))
        waiting = [each for each in connections if is_open(each)]
        self.assertGreater(len(waiting), 0)
        status, problem = self.server.request("PUT", "/api/v1/documents/y", " " * MIB)
        self.assertEqual((status, problem["errors"][0]["code"]), (503, "overload"))
        self.server.core(models.ticking("small"))
        for each in waiting:
            each.close()
        self.server.wait_for(lambda: self.server.request("PUT", "/api/v1/documents/y", " " * MIB)[0] == 400)

    def test_processes_that_nobody_knows_share_it_too_and_have_five_seconds(self):
        before, begun = resident(self.server), time.monotonic()
        strangers = [ComponentClient(self.server) for _ in range(60)]
        self.connections += [each.socket for each in strangers]
        known = [each for each in strangers if each.status == 101]
        self.assertEqual(len(known), BUDGET // HELLO)
        self.assertEqual({each.status for each in strangers}, {101, 503})
        # The header of a frame of 4 MiB, masked with zeros, and most of it.
        for each in known:
            each.socket.sendall(b"\x81\xff" + (HELLO - 1).to_bytes(8, "big") + bytes(4))
        most = self.feed([each.socket for each in known], HELLO - 1000)
        print(f"{len(known)} strangers: +{(most - before) / 1e6:.0f} MB", flush=True)
        self.assertLess(most - before, CEILING)
        self.server.wait_for(lambda: not any(is_open(each.socket) for each in known))
        self.assertGreater(time.monotonic() - begun, 4)
        self.assertLess(time.monotonic() - begun, 12)
        with ComponentClient(self.server) as later:
            self.assertEqual(later.status, 101)

    def test_a_hello_has_at_most_four_mib(self):
        with ComponentClient(self.server) as stranger:
            with self.assertRaises(ConnectionError):
                stranger.send(json.dumps({"type": "hello", "protocol": 1, "components": ["x" * HELLO]}))
                stranger.receive()
        with ComponentClient(self.server) as stranger:
            stranger.send(json.dumps({"type": "hello", "protocol": 1, "components": ["x" * (HELLO - 1000)]}))
            self.assertEqual(check("component_message", stranger.receive())["type"], "refused")


class End(Case):
    OPTIONS = ("--remote", "database", *LONG_HEARTBEAT)

    def end(self):
        """SIGTERM; how long it takes [s]."""
        begun = time.monotonic()
        self.server.process.send_signal(signal.SIGTERM)
        self.assertEqual(self.server.process.wait(TIMEOUT), 0)
        return time.monotonic() - begun

    def test_websockets_get_a_close_frame(self):
        clients = [Stream(self.server.port), ComponentClient(self.server)]
        self.hold(f"GET /api/v1/health HTTP/1.1\r\n{self.host}\r\n", 50)
        clients[0].subscribe("log")
        clients[0].message()
        took = self.end()
        for client in clients:
            frame = client.event()
            while frame.opcode is OP_TEXT:  # the log's last line
                frame = client.event()
            self.assertEqual((frame.opcode, frame.data[:2]), (OP_CLOSE, (1001).to_bytes(2, "big")))
            client.close()
        print(f"ends in {took:.2f} s", flush=True)
        self.assertLess(took, 2)

    def test_it_waits_for_no_request_that_has_not_begun(self):
        large = {"rcm": 1, "name": "large", "root": {"state": "Root", "doc": "x" * (3 * MIB)}}
        self.server.put("/documents/large", large, "document_entry")
        self.hold(f"GET /api/v1/documents/large/native HTTP/1.1\r\n{self.host}\r\n", 400)
        took = self.end()
        print(f"400 clients wait: ends in {took:.2f} s", flush=True)
        self.assertLess(took, 2)


if __name__ == "__main__":
    unittest.main()
