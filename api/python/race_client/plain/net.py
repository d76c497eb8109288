"""Sockets, threads and waiting of the plain client; aio/net.py has the same for the asyncio client. Failures are OSError."""
import select
import socket
import threading
import time
from collections.abc import Callable

from ..address import Address

POLL = 0.2  # seconds after which a reader looks whether it shall end
PIECE = 65536  # bytes


class Connection:
    """A TCP connection, with TLS if the address says so."""

    def __init__(self, connected: socket.socket) -> None:
        self._socket = connected

    @classmethod
    def open(cls, address: Address, timeout: float) -> "Connection":
        end = time.monotonic() + timeout
        connected = socket.create_connection((address.host, address.port), timeout)
        try:
            connected.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            if address.tls is not None:
                connected.settimeout(max(0.001, end - time.monotonic()))
                connected = address.tls.wrap_socket(connected, server_hostname=address.host)
        except BaseException:
            connected.close()
            raise
        return cls(connected)

    def send(self, data: bytes, timeout: float) -> None:
        self._socket.settimeout(timeout)
        self._socket.sendall(data)

    def receive(self, timeout: float) -> bytes:
        """What has come; nothing: the connection has ended."""
        self._socket.settimeout(timeout)
        return self._socket.recv(PIECE)

    def is_stale(self) -> bool:
        """Whether nothing can be asked over it: it has ended meanwhile, or something came that nobody has asked for."""
        try:
            return has_input(self._socket)
        except (OSError, ValueError):
            return True  # nobody knows

    def close(self) -> None:
        self._socket.close()


def has_input(connected: socket.socket) -> bool:
    """Whether reading would not wait. ValueError: there is no `poll` here, and too many files are open for `select`."""
    if not hasattr(select, "poll"):
        return bool(select.select([connected], [], [], 0)[0])
    poll = select.poll()
    poll.register(connected, select.POLLIN)
    return bool(poll.poll(0))


class Signal:
    """Wakes one who waits."""

    def __init__(self) -> None:
        self._event = threading.Event()

    def set(self) -> None:
        self._event.set()

    def clear(self) -> None:
        self._event.clear()

    def wait(self, timeout: float | None) -> None:
        """TimeoutError: nobody has woken it in time."""
        if not self._event.wait(timeout):
            raise TimeoutError


class Background:
    """Something that goes on beside the caller until it ends by itself or is told to end."""

    def __init__(self, run: Callable[[], None]) -> None:
        self._thread = threading.Thread(target=run, name="race_client", daemon=True)
        self._thread.start()

    def end(self) -> None:
        self._thread.join(5 * POLL)  # it ends by itself; if it is connecting, later


def pause(seconds: float) -> None:
    """Lets some time go by."""
    time.sleep(seconds)
