"""The demonstrator with units that are processes of their own: each is killed, and hangs, in the middle; a person says go on."""
import json
import signal
import tempfile
import time
import unittest
from pathlib import Path

import cell
import models
from client import PATIENCE, Server, check
from test_components import Process, there

UNITS = {"cell": ["robot", "gripper", "camera"], "recognition": ["obj_rec"], "database": ["db"], "display": ["display"], "audio": ["audio"]}
CALIBRATION, TABLE, WORK = "Demonstrator/Calibration", "Demonstrator/Table", "Demonstrator/Table/Work"
PICK, PLACE, COLLISION = f"{WORK}/Task/Pick", f"{WORK}/Task/Place", f"{WORK}/Collision"
KILL, HANG = signal.SIGKILL, signal.SIGSTOP
# Stands where the arm carries the first part: it is met once, and falls over.
POST = {"name": "post", "shape": {"box": [0.04, 0.04, 0.25]}, "mass": 2.0, "friction": 0.7, "colour": "#808080",
        "pose": {"position": [0.55, 0.12, 0.125], "orientation": [0, 0, 0, 1]}}
HIT, STUCK, GONE = "The arm has met something", "could not be picked or placed", "fingers do not hold"
STILL, UNCALIBRATED = "The search cannot go on", "The calibration was interrupted"


class Mortal(unittest.TestCase):
    def here(self, parts, *bodies, database=None):
        """A server for these parts and bodies, all units elsewhere, and a phone."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.values, self.folder = Path(folder.name, "values.sqlite"), Path(folder.name, "cell")
        self.parts = parts
        known = {**cell.DATABASE, "o_t_c": cell.O_T_C}
        cell.copied(self.folder, {"scene.json": cell.scene(parts, *bodies), "database.json": database or known})
        self.server = Server("--remote", ",".join(UNITS), "--heartbeat", "2")
        self.addCleanup(self.server.stop)
        self.processes, self.answered = {}, set()
        for unit in UNITS:
            self.begin(unit)
        self.phone = self.server.stream()
        self.addCleanup(self.phone.socket.close)
        self.phone.send(check("stream_request", {"type": "display", "name": "phone", "sound": False}))

    def go(self, begin="Table"):
        self.core = self.server.core(cell.DOCUMENT, {"begin": begin, "speed": 1.0})

    def begin(self, unit):
        options = {"database": ["--folder", self.folder, "--database", self.values], "audio": []}
        self.processes[unit] = Process(self.server, unit, *map(str, options.get(unit, ["--folder", self.folder])))
        self.addCleanup(self.processes[unit].__exit__)
        self.are(True, unit)

    def are(self, available, *units):
        for unit in units:
            for service in UNITS[unit]:
                there(self.server, service, available)

    def until_active(self, state):
        with self.server.stream() as stream:
            stream.subscribe(f"core/{self.core}/state")
            active, end = set(), time.monotonic() + 3 * PATIENCE
            while state not in active:
                message = stream.message()
                if message["kind"] == "snapshot":
                    active = set(message["data"]["state"]["active"])
                for node, now in message["data"].get("active", {}).items() if message["kind"] == "delta" else ():
                    (active.add if now else active.discard)(node)
                status = message["data"]["core"]["status"]
                self.assertTrue(state in active or status in ("ready", "running"), f"{status} before {state} was active")
                self.assertLess(time.monotonic(), end, f"{state} does not become active, but {sorted(active)}")

    def strike(self, how, *units, during=None):
        """Something happens to the units while the state is active; it ends when the server knows."""
        if during:
            self.until_active(during)
        for unit in units:
            self.processes[unit].signal(how)
        self.are(False, *units)

    def mend(self, *units):
        """The units are back: another process, or the same when it goes on."""
        for unit in units:
            if self.processes[unit].process.poll() is None:
                self.processes[unit].signal(signal.SIGCONT)
                self.are(True, unit)
            else:
                self.begin(unit)

    def asked(self, text):
        """The question of this text that has not been answered yet, once the phone shows it."""
        new = lambda q: text in q.get("text", "") and q["id"] not in self.answered
        return self.phone.until(lambda m: new(m["data"].get("question", {})))[-1]["data"]["question"]

    def answer(self, text, button="Continue"):
        """Answers the question of this text."""
        question = self.asked(text)
        self.answered.add(question["id"])
        self.phone.send(check("stream_request", {"type": "answer", "question": question["id"], "answer": button}))

    def refused(self):
        """Services of which the core has got `unavailable` so far, in order."""
        entries = self.server.get(f"/cores/{self.core}/journal")["entries"]
        return [e["input"]["service"] for e in entries if e["input"].get("error", {}).get("code") == "unavailable"]

    def struck(self, how, *units, during, asks, missed):
        """The units are struck; the task is refused by the service that it misses, asks, and goes on when they are back."""
        before = len(self.refused())
        self.strike(how, *units, during=during)
        self.until_active(asks)
        self.assertIn(missed, self.refused()[before:], (units, during))
        self.mend(*units)

    def succeeds(self, skipped=()):
        ended = self.server.ended(self.core, 60)
        self.assertEqual(ended.get("outcome"), "success", ended)
        self.assertEqual((sorted(part["label"] for part in ended["results"]["placed"]), ended["results"]["skipped"]),
                         (sorted(set(self.parts) - set(skipped)), list(skipped)))
        self.assertEqual([s["violations"] for s in self.server.get("/services", "services")["services"] if s["violations"]], [])


class Struck(Mortal):
    """Each time: an error port, a question, Continue, and every part is placed once."""

    def test_the_task_goes_on_where_it_was(self):
        self.here(["Cube", "Box"])
        self.go()
        self.struck(KILL, "cell", during=f"{PICK}/Approach/Across", asks=f"{WORK}/Trouble", missed="robot")
        self.answer(STUCK)
        self.struck(KILL, "database", during=f"{PICK}/Retreat", asks=f"{WORK}/Trouble", missed="db")
        self.answer(STUCK)
        self.struck(HANG, "recognition", during=f"{PLACE}/SetDown/Retreat", asks=f"{TABLE}/Trouble", missed="obj_rec")
        self.answer(STILL)
        # The person cannot even be asked until there is a display again.
        self.struck(HANG, "database", "display", during=f"{PICK}/Retreat", asks=f"{WORK}/Trouble", missed="db")
        self.answer(STUCK)
        self.struck(KILL, "recognition", "display", during=f"{PLACE}/SetDown/Retreat", asks=f"{TABLE}/Trouble", missed="obj_rec")
        self.answer(STILL)
        self.succeeds()

    def test_a_part_that_is_gone_with_its_cell_is_looked_for_again(self):
        self.here(["Cube"])
        self.go()
        self.struck(HANG, "cell", during=f"{PLACE}/SetDown/Approach/Across", asks=f"{WORK}/Trouble", missed="robot")
        self.answer(STUCK)
        self.answer(GONE)  # a cell that is back, from whatever, begins its world anew: the part lies where it was
        self.succeeds()


class Met(Mortal):
    """A unit is struck while the arm stands still because it has met something."""

    def setUp(self):
        self.here(["Cube"], POST)
        self.go()

    def test_with_its_cell_it_loses_what_it_held(self):
        self.strike(KILL, "cell", during=COLLISION)
        self.answer(HIT)
        self.until_active(f"{WORK}/Trouble")
        self.assertIn("gripper", self.refused())  # the first that is asked whether the part is still there
        (self.folder / "scene.json").write_text(json.dumps(cell.scene(self.parts)))  # nobody has put up the post again
        self.mend("cell")
        self.answer(STUCK)
        self.answer(GONE)
        self.succeeds()

    def test_a_part_is_given_up_when_its_cell_is_back(self):
        self.answer(HIT, "Skip")
        self.struck(KILL, "cell", during=f"{WORK}/GiveUp/Task/Back", asks=f"{WORK}/Stuck", missed="robot")
        self.answer("could not be given up")
        self.succeeds(skipped=["Cube"])

    def test_a_display_that_is_back_is_asked_again(self):
        self.until_active(COLLISION)
        self.answered.add(self.asked(HIT)["id"])  # it goes unanswered with the display
        self.strike(KILL, "display")
        self.until_active(f"{COLLISION}/Display/Absent")
        self.assertEqual(set(self.refused()), {"display"})
        self.mend("display")
        self.answer(HIT)
        self.succeeds()


class Begun(Mortal):
    """A unit is not there when it is needed first."""

    def test_the_database_may_be_back_when_a_person_says_so(self):
        self.here([])
        self.strike(KILL, "database")
        self.go("Calibration")
        self.until_active(f"{CALIBRATION}/Trouble")
        self.assertIn("db", self.refused())
        self.mend("database")
        self.answer(UNCALIBRATED)
        self.succeeds()

    def test_a_calibration_that_nobody_can_be_led_through_is_asked_about(self):
        self.here([], database=cell.DATABASE)
        self.strike(KILL, "display")
        self.go("Calibration")
        self.until_active(f"{CALIBRATION}/Trouble")
        self.assertIn("display", self.refused())
        self.mend("display")
        stored = self.server.core(models.storing(), {"key": "o_t_c", "value": cell.O_T_C})  # another task knows it by now
        self.assertEqual(self.server.ended(stored)["outcome"], "success")
        self.answer(UNCALIBRATED)
        self.succeeds()

    def test_nobody_waits_for_a_sound_for_ever(self):
        self.here([])
        self.processes["audio"].signal(HANG)  # it cannot answer any more
        self.go()
        self.strike(KILL, "audio", during=f"{TABLE}/Beep")
        self.succeeds()
        self.assertEqual(self.refused(), ["audio"])


if __name__ == "__main__":
    unittest.main()
