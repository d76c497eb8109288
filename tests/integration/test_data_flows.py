"""Data flows between services: who publishes and reads them; camera pictures for pages, sent only while somebody watches."""
import base64
import itertools
import struct
import unittest

import models
from client import PROJECT, Server
from component_process import LONG_HEARTBEAT, ComponentProcess, service, wait_available, wait_until

DEMO = str(PROJECT / "deploy/demo")
CHANNEL = "flow/camera/frame"


def camera_flow(server):
    """The camera's flow as the server lists it."""
    return service(server, "camera")["publishes"][0]


def wait_idle(server):
    wait_until(lambda: camera_flow(server) == {"flow": "frame", "watchers": 0, "rate_hz": 0})


def recognizing():
    """Starts recognition and leaves it on until the task is stopped."""
    return models.document("seeing", {"state": "Root", "entry": "svc.obj_rec.start()", "exit": "svc.obj_rec.stop()",
                                      "ports": [{"name": "never", "when": "svc.timer.elapsed"}]})


class DataFlows(unittest.TestCase):
    def read_picture(self, message):
        """The depths [mm] and colours of a picture, pixel by pixel."""
        picture = message["data"]["picture"]
        count = picture["width"] * picture["height"]
        self.assertEqual((picture["width"], picture["height"]), (320, 240))
        depths = struct.unpack(f"<{count}H", base64.b64decode(picture["depth"], validate=True))
        colours = base64.b64decode(picture["colour"], validate=True)
        self.assertEqual(len(colours), 3 * count)
        return depths, [colours[i:i + 3] for i in range(0, 3 * count, 3)]

    def assert_shows_the_cell(self, message):
        depths, colours = self.read_picture(message)
        measured = [depth for depth in depths if depth]
        self.assertGreater(len(measured), len(depths) / 2)
        self.assertTrue(min(measured) >= 800 and max(measured) <= 4100, (min(measured), max(measured)))
        self.assertGreater(max(measured) - min(measured), 200)
        self.assertGreater(len(set(colours)), 1000)

    def test_services_list_the_flows_they_publish_and_read(self):
        with Server("--demo", DEMO) as server:
            services = {s["key"]: s for s in server.get("/services", "services")["services"]}
            self.assertEqual({key: [f["flow"] for f in s["publishes"]] for key, s in services.items() if s["publishes"]},
                             {"camera": ["frame", "cloud"], "robot": ["control"]})
            self.assertEqual({key: s["subscribes"] for key, s in services.items() if s["subscribes"]},
                             {"obj_rec": [{"service": "camera", "flow": "frame", "listening": False}]})
            wait_idle(server)

    def test_packets_flow_while_a_run_needs_them(self):
        with Server("--demo", DEMO) as server, server.stream() as stream:
            stream.subscribe("services")
            stream.message()
            core = server.core(recognizing())
            listed = {}
            def flows(message):
                for each in message["data"]["services"]:
                    listed[each["key"]] = each
                return ("camera" in listed and listed["camera"]["publishes"][0]["rate_hz"] > 0
                        and "obj_rec" in listed and listed["obj_rec"]["subscribes"][0]["listening"])
            stream.until(flows)
            self.assertEqual(listed["camera"]["publishes"][0]["last"]["header"]["encoding"], "depth16_mm+rgb8")
            server.expect("POST", f"/cores/{core}/stop", None, "core", 200)
            stream.until(lambda m: not flows(m))
            wait_idle(server)

    def test_the_camera_publishes_only_while_somebody_watches(self):
        with Server("--demo", DEMO) as server:
            with server.stream() as one, server.stream() as other:
                one.subscribe(CHANNEL)
                self.assert_shows_the_cell(one.message())
                other.subscribe(CHANNEL)
                other.message()
                self.assertEqual(camera_flow(server)["watchers"], 1)  # the channel, for all its subscribers
                one.send({"type": "unsubscribe", "channel": CHANNEL})
                other.message()
                wait_until(lambda: camera_flow(server)["rate_hz"] > 0)
            wait_idle(server)

    def test_a_page_gets_at_most_five_pictures_a_second(self):
        with Server("--demo", DEMO) as server, server.stream() as stream:
            stream.subscribe(CHANNEL)
            times = [stream.message()["data"]["time"] for _ in range(6)]
            for before, after in itertools.pairwise(times):
                self.assertGreaterEqual(after - before, 0.19)

    def test_a_slow_page_gets_only_the_newest_picture(self):
        with Server("--demo", DEMO) as server, server.stream() as slow, server.stream() as quick:
            quick.subscribe(CHANNEL)
            slow.subscribe(CHANNEL)
            first = slow.message()["sequence"]
            last = quick.until(lambda m: m["sequence"] >= first + 30)[-1]["sequence"]
            seen = [m["sequence"] for m in slow.until(lambda m: m["sequence"] >= last)]
            self.assertLess(len(seen), last - first)

    def test_unknown_flows_are_refused(self):
        with Server("--demo", DEMO) as server, server.stream() as stream:
            for channel in ("flow/camera/sound", "flow/oven/frame", "flow/obj_rec/frame"):
                stream.subscribe(channel)
                refused = stream.message()
                self.assertEqual((refused["kind"], refused["channel"]), ("error", channel))
                self.assertEqual([(e["code"], e["path"]) for e in refused["data"]["errors"]], [("not_found", channel)])
            for channel in ("flow/camera", "flow//frame", "flow/"):
                stream.send({"type": "subscribe", "channel": channel})
                self.assertEqual(stream.message()["data"]["errors"][0]["code"], "not_found")
            wait_idle(server)

    def test_a_camera_in_another_process_behaves_the_same(self):
        with Server("--remote", "cell", "--demo", DEMO, *LONG_HEARTBEAT) as server, server.stream() as stream:
            stream.subscribe(CHANNEL)  # before it is there
            with ComponentProcess(server, "cell", "--folder", DEMO) as process:
                wait_available(server, "camera")
                self.assert_shows_the_cell(stream.message())
                wait_until(lambda: camera_flow(server)["rate_hz"] > 0)
                stream.send({"type": "unsubscribe", "channel": CHANNEL})
                wait_idle(server)
                stream.subscribe(CHANNEL)
                stream.message()
                process.kill()
                wait_until(lambda: camera_flow(server) == {"flow": "frame", "watchers": 1, "rate_hz": 0})
            with ComponentProcess(server, "cell", "--folder", DEMO):
                stream.until(lambda m: m["data"]["time"] > 0)


if __name__ == "__main__":
    unittest.main()
