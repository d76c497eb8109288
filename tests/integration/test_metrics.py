"""GET /metrics: the whole text held against a parser of its own, and its values against what the test has done."""
import http.client
import math
import re
import unittest
from itertools import pairwise

import models
from accounts import AccountServer
from client import PROJECT, Server
from component_process import LONG_HEARTBEAT, component_client
from controls import Controls
from events import Events
from interface import INTERFACE

NAME = r"[a-zA-Z_:][a-zA-Z0-9_:]*"
SAMPLE = re.compile(rf"({NAME})(?:\{{(.*)\}})? (\S+)")
LABEL = re.compile(r'([a-zA-Z_][a-zA-Z0-9_]*)="((?:[^"\\\n]|\\[\\"n])*)"(?:,|$)')
ESCAPES = {"\\\\": "\\", '\\"': '"', "\\n": "\n"}
SUFFIXES = ("_bucket", "_sum", "_count")


class Malformed(Exception):
    """The text is no exposition."""


def need(condition, what):
    if not condition:
        raise Malformed(what)


def labels_of(text):
    labels, at = {}, 0
    while text and at < len(text):
        found = LABEL.match(text, at)
        need(found, f"labels {text!r}")
        need(found[1] not in labels, f"label {found[1]} stands twice")
        labels[found[1]] = re.sub(r"\\.", lambda each: ESCAPES[each[0]], found[2])
        at = found.end()
    need(not text or not text.endswith(","), f"labels {text!r}")
    return labels


def parse(text):
    """({name: type}, {(name, ((label, value), ...)): value}) of an exposition of format 0.0.4."""
    need(text.endswith("\n"), "the last line has no end")
    types, helped, samples, family, closed = {}, set(), {}, None, set()
    for line in text.split("\n")[:-1]:
        if line.startswith("#"):
            kind, name, rest = re.fullmatch(rf"# (HELP|TYPE) ({NAME}) (.+)", line).groups()
            if kind == "HELP":
                need(name not in helped, f"two HELP of {name}")
                helped.add(name)
                closed.add(family)
                family = name
                need(family not in closed, f"{family} begins again")
            else:
                need(name == family and name not in types, f"TYPE of {name}")
                need(rest in ("counter", "gauge", "histogram"), f"type {rest}")
                types[name] = rest
            continue
        found = SAMPLE.fullmatch(line)
        need(found, f"line {line!r}")
        name, labels = found[1], labels_of(found[2])
        base = next((name.removesuffix(s) for s in SUFFIXES if name.endswith(s) and types.get(name.removesuffix(s)) == "histogram"), name)
        need(base == family and family in types, f"{name} is not of the family {family}")
        need((base != name) == (types[base] == "histogram"), f"{name} in a {types[base]}")
        key = (name, tuple(sorted(labels.items())))
        need(key not in samples, f"{key} stands twice")
        samples[key] = float(found[3])
        need(types[base] == "gauge" or samples[key] >= 0, f"{key} is negative")
    need(set(types) == helped, "HELP and TYPE differ")
    for name, kind in types.items():
        need(not name.startswith("race_") or (kind == "counter") == name.endswith("_total"), f"{name} is a {kind}")
        if kind == "histogram":
            check_histogram(name, samples)
    return types, samples


def check_histogram(name, samples):
    series = {}
    for (sample, labels), value in samples.items():
        if sample == name + "_bucket":
            rest = tuple(label for label in labels if label[0] != "le")
            series.setdefault(rest, []).append((float(dict(labels)["le"]), value))
    for rest, buckets in series.items():
        need(buckets == sorted(buckets), f"buckets of {name} {rest} go down")
        need(all(a <= b for (_, a), (_, b) in pairwise(buckets)), f"{name} {rest} is not cumulative")
        need(buckets[-1] == (math.inf, samples[(name + "_count", rest)]), f"+Inf of {name} {rest}")
        need((name + "_sum", rest) in samples, f"{name} {rest} has no sum")


def ask(server, token=None, path="/metrics"):
    """(status, content type, text)"""
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=20)
    connection.request("GET", path, headers={"Authorization": f"Bearer {token}"} if token else {})
    response = connection.getresponse()
    answer = response.status, response.getheader("Content-Type"), response.read().decode()
    connection.close()
    return answer


class Metrics(unittest.TestCase):
    OPTIONS = ("--demo", str(PROJECT / "deploy/demo"))

    def setUp(self):
        self.server = Server(*self.OPTIONS)
        self.addCleanup(self.server.stop)

    def metrics(self):
        status, kind, text = ask(self.server)
        self.assertEqual((status, kind), (200, "text/plain; version=0.0.4; charset=utf-8"))
        self.types, samples = parse(text)
        return samples

    def value(self, name, samples=None, **labels):
        return (samples or self.metrics()).get((name, tuple(sorted(labels.items()))))

    def test_counters_grow_and_values_are_those_of_what_was_done(self):
        before = self.metrics()
        for _ in range(5):
            self.server.get("/documents", "documents")
        for _ in range(3):
            self.server.get("/documents/nothing", status=404)
        self.server.request("GET", "/api/v1/nothing")
        core = self.server.core(models.ticking(last=20))
        self.server.ended(core)
        steps = self.server.get(f"/cores/{core}", "core")["step"]
        waiting = self.server.core(models.waiting(60.0))
        after = self.metrics()
        kinds = dict(self.types)
        for key, value in before.items():
            if kinds[key[0]] == "counter" if key[0] in kinds else True:  # those of histograms, too
                self.assertGreaterEqual(after[key], value, key)

        def grown(name, **labels):
            key = (name, tuple(sorted(labels.items())))
            return after.get(key, 0) - before.get(key, 0)
        self.assertEqual(grown("race_http_requests_total", method="GET", route="/api/v1/documents", code="2xx"), 5)
        self.assertEqual(grown("race_http_requests_total", method="GET", route="/api/v1/documents/{name}", code="4xx"), 3)
        self.assertEqual(grown("race_http_requests_total", method="other", route="other", code="4xx"), 1)
        self.assertEqual(grown("race_http_request_duration_seconds_count", method="GET", route="/api/v1/documents"), 5)
        self.assertGreater(grown("race_http_request_duration_seconds_sum", method="GET", route="/api/v1/documents"), 0)
        self.assertGreaterEqual(grown("race_journal_entries_total"), steps)
        self.assertEqual(self.value("race_cores", after, status="running"), 1)
        self.assertEqual(self.value("race_cores", after, status="ended"), 1)
        self.assertGreater(grown("race_cell_steps_total"), 0)
        self.assertLess(grown("race_cell_late_steps_total"), grown("race_cell_steps_total"))
        self.assertGreater(grown("race_log_lines_total", level="info"), 2)
        for name, least, most in (("process_resident_memory_bytes", 1e7, 1e9), ("process_threads", 10, 100), ("process_open_fds", 8, 300),
                                  ("race_store_size_bytes", 1e4, 1e9)):
            labels = {"file": "race.sqlite"} if name.startswith("race_store") else {}
            self.assertTrue(least < self.value(name, after, **labels) < most, (name, self.value(name, after, **labels)))
        self.server.post(f"/cores/{waiting}/stop", None, "core")

    def test_states_are_those_of_now(self):
        self.assertEqual(self.value("race_cell_stopped"), 0)
        self.server.post("/stop", None, "control")
        self.assertEqual(self.value("race_cell_stopped"), 1)
        self.server.post("/stop/reset", None, "control")
        self.assertEqual(self.value("race_cell_stopped"), 0)
        streams = [self.server.stream() for _ in range(3)]
        # The server hears of the end of a connection on its own time.
        self.server.wait_for(lambda: self.value("race_connections") == 4)
        self.assertEqual(self.value("race_websockets", kind="stream"), 3)
        for each in streams:
            each.close()
        self.server.wait_for(lambda: self.value("race_connections") == 1)
        self.server.wait_for(lambda: self.value("race_websockets", kind="stream") == 0)
        core = self.server.core(models.ticking("followed"), start=False)
        with Events(self.server.port, core):
            self.assertEqual(self.value("race_event_streams"), 1)
        self.server.wait_for(lambda: self.value("race_event_streams") == 0)
        person = Controls(self.server)
        self.server.wait_for(lambda: self.value("race_websockets", kind="control") == 1)
        person.close()
        self.server.wait_for(lambda: self.value("race_websockets", kind="control") == 0)
        self.assertEqual(self.value("race_service_available", service="robot"), 1)
        with Server("--remote", "audio", *LONG_HEARTBEAT) as other:
            self.assertEqual(parse(ask(other)[2])[1][("race_service_available", (("service", "audio"),))], 0)
            with component_client(other, "audio"):
                samples = parse(ask(other)[2])[1]
                self.assertEqual(samples[("race_service_available", (("service", "audio"),))], 1)
                self.assertEqual(samples[("race_websockets", (("kind", "components"),))], 1)

    def test_labels_are_few_whatever_is_asked(self):
        for number in range(200):
            self.server.request("GET", f"/api/v1/documents/name{number}")
            self.server.request("GET", f"/api/v1/nothing{number}\"\\")
        samples = self.metrics()
        patterns = {*INTERFACE["paths"], "other"}
        for name, labels in samples:
            route = dict(labels).get("route")
            self.assertTrue(route is None or route in patterns, (name, labels))
        self.assertLess(len(samples), 300)
        self.assertEqual(self.value("race_http_requests_total", samples, method="other", route="other", code="4xx"), 200)

    def test_what_is_refused_at_a_websocket_is_counted_at_its_route(self):
        paths = ("/api/v1/stream", "/api/v1/control/hold", "/api/v1/components")
        self.assertEqual({path for path in INTERFACE["paths"] if "101" in INTERFACE["paths"][path].get("get", {}).get("responses", {})},
                         set(paths))
        with AccountServer() as server:
            for path in paths:
                self.assertEqual(server.ask(None, "GET", path), 401)
            samples = parse(ask(server, server.tokens["observer"])[2])[1]
        for path in paths:
            key = ("race_http_requests_total", (("code", "4xx"), ("method", "GET"), ("route", path)))
            self.assertEqual(samples.get(key), 1, path)

    def test_each_family_and_kind_is_in_the_table_of_the_operator(self):
        samples = self.metrics()
        lines = (PROJECT / "deploy/README.md").read_text().splitlines()
        table = {found[1]: line for line in lines if (found := re.match(rf"^\| `({NAME})`", line))}
        self.assertEqual(set(table), set(self.types))
        kinds = {dict(labels)["kind"] for name, labels in samples if name == "race_websockets"}
        self.assertEqual(kinds, set(re.findall(r"`(\w+)` \(", table["race_websockets"])))


class Rights(unittest.TestCase):
    def test_an_observer_with_a_token_reads_and_failed_logins_are_counted(self):
        with AccountServer() as server:
            self.assertEqual(ask(server)[0], 401)
            token = server.tokens["observer"]
            for _ in range(4):
                server.request("POST", "/api/v1/login", {"name": "observer", "password": "wrong password"}, {"Authorization": ""})
            status, _, text = ask(server, token)
            self.assertEqual(status, 200)
            samples = parse(text)[1]
            self.assertEqual(samples[("race_logins_failed_total", ())], 4)
            self.assertEqual(samples[("race_http_requests_total", (("code", "4xx"), ("method", "GET"), ("route", "/metrics")))], 1)


class Parser(unittest.TestCase):
    """The parser refuses what is wrong."""

    GOOD = ('# HELP race_a_total A.\n# TYPE race_a_total counter\nrace_a_total{x="a\\"\\\\\\n,}"} 1\n'
            '# HELP race_b B.\n# TYPE race_b histogram\nrace_b_bucket{le="1"} 1\nrace_b_bucket{le="+Inf"} 2\n'
            'race_b_sum 3\nrace_b_count 2\n')

    def test_takes_what_is_right(self):
        self.assertEqual(parse(self.GOOD)[1][("race_a_total", (("x", 'a"\\\n,}'),))], 1)

    def test_refuses_what_is_wrong(self):
        wrong = (("# HELP race_a_total A.\n", ""), ("counter", "gauge"), ("counter", "count"), ('le="+Inf"} 2', 'le="+Inf"} 0'),
                 ("race_b_count 2", "race_b_count 3"), ("race_b_sum 3\n", ""), ("race_b_sum 3\n", "race_b_sum 3\nrace_b_sum 3\n"),
                 ('\\"', '"'), ("} 1\n# HELP", "} 1"), ("race_b_count 2\n", "race_b_count 2\n# HELP race_a_total A.\n"),
                 ("race_a_total{", "race-a_total{"), ("race_b_count 2\n", "race_b_count 2"))
        for old, new in wrong:
            self.assertNotEqual(self.GOOD.replace(old, new), self.GOOD)
            with self.assertRaises((Malformed, AttributeError, KeyError, ValueError), msg=(old, new)):
                parse(self.GOOD.replace(old, new))


if __name__ == "__main__":
    unittest.main()
