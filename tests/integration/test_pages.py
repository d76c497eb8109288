"""The built pages (web/dist) as the server sends them: compressed as the client accepts it, and not again if the client has them."""
import gzip
import http.client
import subprocess
import unittest

from client import PAGE_RULES, PROJECT, TIMEOUT, Server

WEB = PROJECT / "web/dist"
LEAST_SIZE = 1024  # bytes of a file that is compressed (web/compress.ts)
CODINGS = ("br", "gzip", "identity")
DECODE = "process.stdout.write(require('node:zlib').brotliDecompressSync(require('node:fs').readFileSync(0)))"


def decode(coding, body):
    if coding == "gzip":
        return gzip.decompress(body)
    if coding == "br":
        return subprocess.run(["node", "-e", DECODE], input=body, stdout=subprocess.PIPE, check=True, timeout=TIMEOUT).stdout
    return body


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        assert WEB.is_dir(), "build the pages first: npm --prefix web run build"
        cls.server = Server("--web", str(WEB))
        cls.scripts = sorted(f"/assets/{file.name}" for file in WEB.glob("assets/*.js"))
        cls.worker = next(path for path in cls.scripts if "elk-worker" in path)

    @classmethod
    def tearDownClass(cls):
        cls.server.stop()

    def setUp(self):
        self.connection = http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=TIMEOUT)
        self.addCleanup(self.connection.close)

    def request(self, path, method="GET", **headers):
        """(response, body), of one connection that stays open. A header's name is written with underscores."""
        self.connection.putrequest(method, path, skip_accept_encoding=True)
        for name, value in headers.items():
            self.connection.putheader(name.replace("_", "-"), value)
        self.connection.endheaders()
        response = self.connection.getresponse()
        return response, response.read()

    def test_each_script_and_style_is_sent_in_each_coding(self):
        for file in WEB.glob("assets/*"):
            if file.suffix not in (".js", ".css") or file.stat().st_size < LEAST_SIZE:
                continue
            tags = set()
            for coding in CODINGS:
                with self.subTest(file.name, coding=coding):
                    response, body = self.request(f"/assets/{file.name}", Accept_Encoding=coding)
                    self.assertEqual(response.status, 200)
                    self.assertEqual(response.getheader("Content-Encoding", "identity"), coding)
                    self.assertEqual(response.getheader("Content-Length"), str(len(body)))
                    self.assertEqual(decode(coding, body), file.read_bytes())
                    self.assertEqual(response.getheader("Vary"), "Accept-Encoding")
                    self.assertEqual(response.getheader("Cache-Control"), "public, max-age=31536000, immutable")
                    kind = {".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8"}[file.suffix]
                    self.assertEqual(response.getheader("Content-Type"), kind)
                    rules, stops = response.getheader("Content-Security-Policy").split("; connect-src 'self' ")
                    self.assertEqual(rules, PAGE_RULES[0].split(": ", 1)[1])
                    ports = self.server.get("/control", "control")["stop_ports"]
                    self.assertEqual(stops.split(), [f"http://{name}:{ports[0]['stop_port']}" for name in ("localhost", "127.0.0.1")])
                    tags.add(response.getheader("ETag"))
            self.assertEqual(len(tags), len(CODINGS))

    def test_the_worker_that_draws_leaves_at_less_than_600_kb(self):
        self.assertGreater(len(self.request(self.worker)[1]), 1_500_000)
        for coding in ("gzip", "gzip, deflate, br, zstd"):
            with self.subTest(coding):
                self.assertLess(len(self.request(self.worker, Accept_Encoding=coding)[1]), 600_000)

    def test_what_is_not_compressed_is_sent_as_it_is(self):
        font = next(WEB.glob("assets/*.woff2"))
        for path, file in (("/", WEB / "index.html"), (f"/assets/{font.name}", font)):
            with self.subTest(path):
                response, body = self.request(path, Accept_Encoding="gzip, br")
                self.assertEqual((response.status, body), (200, file.read_bytes()))
                self.assertIsNone(response.getheader("Content-Encoding"))

    def test_head_has_the_headers_of_get(self):
        for coding in CODINGS:
            with self.subTest(coding):
                answer, body = self.request(self.worker, Accept_Encoding=coding)
                head, nothing = self.request(self.worker, method="HEAD", Accept_Encoding=coding)
                self.assertEqual((head.status, head.getheaders()), (200, answer.getheaders()))
                self.assertEqual((int(head.getheader("Content-Length")), nothing), (len(body), b""))

    def test_what_the_client_has_is_not_sent_again(self):
        for path, coding in (("/pro/", "identity"), (self.worker, "gzip"), (self.worker, "br")):
            with self.subTest(path, coding=coding):
                tag = self.request(path, Accept_Encoding=coding)[0].getheader("ETag")
                for method in ("GET", "HEAD"):
                    response, body = self.request(path, method=method, Accept_Encoding=coding, If_None_Match=tag)
                    self.assertEqual((response.status, body), (304, b""))
                    self.assertEqual((response.getheader("ETag"), response.getheader("Vary")), (tag, "Accept-Encoding"))
                    self.assertIsNone(response.getheader("Content-Length"))
                self.assertEqual(self.request(path, Accept_Encoding=coding, If_None_Match='"other"')[0].status, 200)
        tag = self.request(self.worker, Accept_Encoding="gzip")[0].getheader("ETag")
        self.assertEqual(self.request(self.worker, Accept_Encoding="br", If_None_Match=tag)[0].status, 200)

    def test_a_coding_that_there_is_not_is_refused_if_no_other_will_do(self):
        response, body = self.request("/", Accept_Encoding="gzip, identity;q=0")
        self.assertEqual((response.status, response.getheader("Vary")), (406, "Accept-Encoding"))
        self.assertIn(b"not_acceptable", body)
        self.assertEqual(self.request(self.worker, Accept_Encoding="gzip, identity;q=0")[0].status, 200)

    def test_compressed_copies_have_no_paths(self):
        for ending in (".gz", ".br"):
            self.assertTrue((WEB / (self.worker[1:] + ending)).is_file())
            self.assertEqual(self.request(self.worker + ending)[0].status, 404)

    def test_ranges_are_not_served(self):
        response, body = self.request(self.worker, Range="bytes=0-9")
        self.assertEqual((response.status, body), (200, (WEB / self.worker[1:]).read_bytes()))


if __name__ == "__main__":
    unittest.main()
