"""The network: `race serve --lan` is reached over TLS alone, by its own names, by who trusts its authority, and with accounts."""
import http.client
import json
import re
import shutil
import socket
import ssl
import struct
import subprocess
import tempfile
import time
import unittest
import warnings
from pathlib import Path

from accounts import PASSWORD, folder_with_accounts, token_of
from client import PROGRAM, TIMEOUT, Server


def bracketed(name):
    return f"[{name}]" if ":" in name else name


class LanServer(Server):
    """A server of accounts in the network, too. `lan`: (name, port) pairs of its addresses there; `authority`: a file."""

    def __init__(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.lan_port = free.getsockname()[1]
        data = folder_with_accounts()
        self.admin = token_of(data, "admin")
        self.log = Path(data) / "server.log"
        with self.log.open("w", encoding="utf-8") as log:
            super().__init__("--lan", "--lan-port", str(self.lan_port), data=data, stderr=log)
        self.own = True
        self.authority = str(Path(data) / "tls" / "ca.pem")
        end = time.monotonic() + TIMEOUT
        while "its authority" not in self.log.read_text():
            assert time.monotonic() < end, "the server does not say where its network is"
            time.sleep(0.01)
        self.names = re.findall(r"serves the network at https://\[?([^\]\s]+?)\]?:\d+$", self.log.read_text(), re.MULTILINE)
        self.name = self.names[0]
        self.where = "127.0.0.1" if self.name.endswith(".local") else self.name  # without a name service
        self.host = f"{bracketed(self.name)}:{self.lan_port}"

    def connect(self, context):
        raw = socket.create_connection((self.where, self.lan_port), TIMEOUT)
        return context.wrap_socket(raw, server_hostname=self.name)

    def trust(self):
        return ssl.create_default_context(cafile=self.authority)

    def ask(self, path, method="GET", context=None, headers=None, body=None):
        """(status, headers, body) over TLS."""
        connection = http.client.HTTPConnection(self.where, self.lan_port, timeout=TIMEOUT)
        connection.sock = self.connect(context or self.trust())
        connection.request(method, path, body, {"Host": self.host, **(headers or {})})
        answer = connection.getresponse()
        result = answer.status, dict(answer.getheaders()), answer.read()
        connection.close()
        return result

    def plain(self, data):
        """All that comes back for some bytes without TLS."""
        with socket.create_connection((self.where, self.lan_port), TIMEOUT) as connection:
            connection.sendall(data)
            answer = b""
            while True:
                try:
                    piece = connection.recv(65536)
                except ConnectionResetError:
                    return answer
                if not piece:
                    return answer
                answer += piece


class Tls(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = LanServer()
        cls.addClassCleanup(cls.server.stop)

    def authorization(self):
        return {"Authorization": f"Bearer {self.server.admin}"}

    def test_who_trusts_the_authority_reaches_the_server_by_its_address(self):
        self.assertEqual(self.server.ask("/api/v1/health")[0], 200)
        self.assertEqual(self.server.ask("/api/v1/documents")[0], 401)
        self.assertEqual(self.server.ask("/api/v1/documents", headers=self.authorization())[0], 200)

    def test_who_does_not_trust_it_is_warned(self):
        with self.assertRaises(ssl.SSLCertVerificationError):
            self.server.ask("/api/v1/health", context=ssl.create_default_context())

    def test_the_authority_is_for_everybody_with_its_fingerprint(self):
        blind = ssl.create_default_context()
        blind.check_hostname = False
        blind.verify_mode = ssl.CERT_NONE
        status, headers, body = self.server.ask("/api/v1/authority", context=blind)
        self.assertEqual((status, headers["Content-Type"]), (200, "application/x-x509-ca-cert"))
        self.assertEqual(body.decode(), Path(self.server.authority).read_text())
        self.assertIn(f"its authority, by SHA-256: {headers['X-Fingerprint-SHA256']}", self.server.log.read_text())

    def test_versions_before_1_2_are_refused(self):
        for version in (ssl.TLSVersion.TLSv1_2, ssl.TLSVersion.TLSv1_3):
            context = self.server.trust()
            context.minimum_version = context.maximum_version = version
            self.assertEqual(self.server.ask("/api/v1/health", context=context)[0], 200)
        old = self.server.trust()
        old.set_ciphers("ALL:@SECLEVEL=0")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)
            old.minimum_version, old.maximum_version = ssl.TLSVersion.TLSv1, ssl.TLSVersion.TLSv1_1
        with self.assertRaisesRegex(ssl.SSLError, "ALERT_PROTOCOL_VERSION"):
            self.server.connect(old)

    def test_plain_http_is_led_to_the_page_on_trust_whatever_it_asks(self):
        token = self.authorization()["Authorization"]
        for request in ("GET / HTTP/1.1\r\nHost: x\r\n\r\n",
                        f"POST /api/v1/cores HTTP/1.1\r\nHost: x\r\nAuthorization: {token}\r\nContent-Length: 0\r\n\r\n"):
            answer = self.server.plain(request.encode()).decode()
            self.assertTrue(answer.startswith("HTTP/1.1 307 "), answer)
            self.assertIn(f"Location: https://{bracketed(self.server.where)}:{self.server.lan_port}/trust/\r\n", answer)
            self.assertIn("Connection: close", answer)

    def test_noise_gets_an_alert_at_most(self):
        for noise in (b"\x00\x01noise\r\n\r\n", b"\x16\x03\x01\xff\xff" + b"x" * 100, b"SSH-2.0-race\r\n"):
            answer = self.server.plain(noise)
            self.assertIn(answer[:1], (b"", b"\x15"), answer)

    def test_foreign_names_and_pages_are_refused_there_too(self):
        own = self.server.host
        for host in (f"127.0.0.1:{self.server.lan_port}", f"evil.example:{self.server.lan_port}", f"localhost:{self.server.port}"):
            self.assertEqual(self.server.ask("/api/v1/health", headers={"Host": host})[0], 421, host)
        login = json.dumps({"name": "admin", "password": PASSWORD})
        for origin, status in ((f"https://{own}", 200), (f"http://{own}", 403), ("https://evil.example", 403), ("null", 403)):
            headers = {"Origin": origin, "Content-Type": "application/json"}
            self.assertEqual(self.server.ask("/api/v1/login", "POST", headers=headers, body=login)[0], status, origin)

    def test_a_stream_is_opened_with_a_ticket(self):
        status, _, body = self.server.ask("/api/v1/tickets", "POST", headers=self.authorization())
        self.assertEqual(status, 200)
        ticket = json.loads(body)["ticket"]
        secure, host = self.server.connect(self.server.trust()), self.server.host
        secure.sendall((f"GET /api/v1/stream?ticket={ticket} HTTP/1.1\r\nHost: {host}\r\nOrigin: https://{host}\r\nUpgrade: websocket\r\n"
                        "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: MDEyMzQ1Njc4OWFiY2RlZg==\r\n\r\n").encode())
        self.assertIn(b"101 Switching Protocols", secure.recv(4096))
        text = json.dumps({"kind": "subscribe", "channels": ["log"]}).encode()
        secure.sendall(struct.pack("!BB4x", 0x81, 0x80 | len(text)) + text)  # masked with zeros
        self.assertEqual(secure.recv(4096)[:1], b"\x81", "the first message of the channel")
        secure.close()

    def test_loopback_stays_without_tls(self):
        self.assertEqual(self.server.request("GET", "/api/v1/health")[0], 200)


class Refusals(unittest.TestCase):
    def serve(self, data, *options):
        return subprocess.run([PROGRAM, "serve", "--port", "0", "--data", data, "--lan", *options], capture_output=True,
                              text=True, timeout=TIMEOUT, check=False)

    def test_a_server_in_a_network_needs_an_account(self):
        data = tempfile.mkdtemp(prefix="race-test-")
        self.addCleanup(shutil.rmtree, data)
        ended = self.serve(data)
        self.assertEqual(ended.returncode, 2)
        self.assertIn("--lan: not_accepted: a server in a network needs accounts: race account add NAME --role admin", ended.stderr)

    def test_a_key_that_others_may_read_is_refused(self):
        data = folder_with_accounts()
        self.addCleanup(shutil.rmtree, data)
        with socket.socket() as taken:  # so that it ends when the certificate is made
            taken.bind(("0.0.0.0", 0))
            taken.listen()
            self.assertEqual(self.serve(data, "--lan-port", str(taken.getsockname()[1])).returncode, 2)
        key = Path(data) / "tls" / "ca.key"
        key.chmod(0o644)
        ended = self.serve(data)
        self.assertEqual(ended.returncode, 2)
        self.assertIn("not_accepted: others may use this key", ended.stderr)


if __name__ == "__main__":
    unittest.main()
