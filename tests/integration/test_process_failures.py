"""The demonstrator with units that are processes of their own: each is killed, and hangs, in the middle; a person says go on."""
import json
import math
import signal
import tempfile
import time
import unittest
from pathlib import Path

import cell
import models
from client import TIMEOUT, Server, check
from component_process import ComponentProcess, service, wait_available, wait_until
from geometry import angle

UNITS = {"cell": ["robot", "gripper", "camera"], "recognition": ["obj_rec"], "database": ["db"], "display": ["display"], "audio": ["audio"]}
CALIBRATION, TABLE, WORK = "Demonstrator/Calibration", "Demonstrator/Table", "Demonstrator/Table/Work"
COLLECT, INTERRUPTED = f"{CALIBRATION}/CameraCalibration/Collect", f"{CALIBRATION}/CameraCalibration/Trouble"
PICK, PLACE, COLLISION = f"{WORK}/Task/Pick", f"{WORK}/Task/Place", f"{WORK}/Collision"
KILL, HANG = signal.SIGKILL, signal.SIGSTOP
# Stands where the arm carries the first part: it is met once, and falls over.
POST = {"name": "post", "shape": {"box": [0.04, 0.04, 0.25]}, "mass": 2.0, "friction": 0.7, "colour": "#808080",
        "pose": {"position": [0.55, 0.12, 0.125], "orientation": [0, 0, 0, 1]}}
HIT, STUCK, GONE = "The arm has met something", "could not be picked or placed", "fingers do not hold"
STILL, UNCALIBRATED = "The search cannot go on", "The calibration was interrupted"


class Mortal(unittest.TestCase):
    def here(self, parts, *bodies, database=None, sound=False):
        """A server for these parts and bodies, all units elsewhere, and a phone that may make sounds or not."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.values, self.folder = Path(folder.name, "values.sqlite"), Path(folder.name, "cell")
        self.parts = parts
        known = {**cell.DATABASE, "o_t_c": cell.O_T_C}
        cell.copied(self.folder, {"scene.json": cell.scene(parts, *bodies), "database.json": database or known})
        self.server = Server("--remote", ",".join(UNITS), "--heartbeat", "2")
        self.addCleanup(self.server.stop)
        self.processes, self.answered, self.heard = {}, set(), set()
        for unit in UNITS:
            self.begin(unit)
        self.phone = self.server.stream()
        self.addCleanup(self.phone.close)
        self.phone.send_checked({"type": "display", "name": "phone", "sound": sound})

    def go(self, begin="Table"):
        self.core = self.server.core(cell.DOCUMENT, {"begin": begin, "speed": 1.0})

    def begin(self, unit):
        options = {"database": ["--folder", self.folder, "--database", self.values], "audio": []}
        self.processes[unit] = ComponentProcess(self.server, unit, *map(str, options.get(unit, ["--folder", self.folder])))
        self.addCleanup(self.processes[unit].__exit__)
        self.are(True, unit)

    def are(self, available, *units):
        for unit in units:
            for service in UNITS[unit]:
                wait_available(self.server, service, available)

    def until_active(self, state):
        with self.server.stream() as stream:
            stream.subscribe(f"core/{self.core}/state")
            active, end = set(), time.monotonic() + 3 * TIMEOUT
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
        self.reply(self.asked(text), button)

    def reply(self, question, button="Continue"):
        self.answered.add(question["id"])
        self.phone.send_checked({"type": "answer", "question": question["id"], "answer": button})

    def sounds(self, name):
        """What the phone shows as it begins to play this sound; a test says when it is over, or never."""
        new = lambda sound: sound.get("name") == name and sound["id"] not in self.heard
        shown = self.phone.until(lambda m: new(m["data"].get("sound", {})))[-1]["data"]
        self.heard.add(shown["sound"]["id"])
        return shown

    def played(self, name):
        """The phone plays this sound to its end; gives what it shows meanwhile."""
        shown, call = self.sounds(name), self.pending("audio", "play")
        self.phone.send_checked({"type": "played", "sound": shown["sound"]["id"]})
        self.assertEqual(self.response(call).get("result"), {"sound": name, "displays": ["phone"]})
        return shown

    def pending(self, key, operation):
        """The number of the core's newest call of this operation, once it waits for its answer."""
        calls = []
        mine = lambda p: (p.get("core"), p["operation"]) == (self.core, operation)
        wait_until(lambda: calls.extend(p["core_call"] for p in service(self.server, key)["pending"] if mine(p)) or calls)
        return calls[-1]

    def responses(self):
        """What the calls of the core were answered so far, in order."""
        entries = self.server.get(f"/cores/{self.core}/journal")["entries"]
        return [e["input"] for e in entries if e["input"]["kind"] == "response"]

    def response(self, call):
        """What this call was answered, once it was."""
        found = []
        wait_until(lambda: found.extend(r for r in self.responses() if r["call"] == call) or found)
        return found[0]

    def refused(self):
        """Services of which the core has got `unavailable` so far, in order."""
        return [r["service"] for r in self.responses() if r.get("error", {}).get("code") == "unavailable"]

    def lost(self, how, unit, call):
        """The unit is struck while this call of the core waits for it, and the call is answered `unavailable`."""
        self.strike(how, unit)
        self.assertEqual(self.response(call).get("error", {}).get("code"), "unavailable")

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


class Silenced(Mortal):
    """Audio is struck while the task waits for the end of its last sound."""

    def ends_without_its_sound(self, how):
        self.here([], sound=True)
        self.go()
        self.until_active(f"{TABLE}/Beep")
        self.lost(how, "audio", self.pending("audio", "play"))
        self.succeeds()
        self.assertEqual(self.refused(), ["audio"])

    def test_the_task_ends_without_a_sound_whose_process_is_killed(self):
        self.ends_without_its_sound(KILL)

    def test_the_task_ends_without_a_sound_whose_process_hangs(self):
        self.ends_without_its_sound(HANG)


def drags(text):
    """How far each hand of the demo's operator leads the arm on when a display shows this [m]."""
    acts = next(act["do"] for act in cell.OPERATOR["acts"] if text in act.get("when", {}).get("display", {}).get("text", ""))
    return {act["hand"]: act["by"] for act in acts}


GRAB = cell.OPERATOR["acts"][0]["do"]
FROM = {place: drags(f"{place} of 10 places") for place in range(1, 10)}
LOWER = drags("does not see")  # above the fourth place the camera sees nothing


class Led(Mortal):
    """Units are struck while a person leads the arm through the calibration: no sample is lost, and none counts twice."""

    def act(self, **act):
        self.server.post("/cell/person", check("person_act", act), "person")

    def hold(self):
        """All hands take the arm, once it gives way."""
        self.until_active(f"{COLLECT}/AwaitRest")
        for act in GRAB:
            self.act(**act, keep=60)

    def let_go(self):
        for act in GRAB:
            self.act(act="release", hand=act["hand"])

    def lead(self, *ways):
        """The hands draw the arm along the sum of these ways, and keep it there."""
        for hand in ways[0]:
            by = [sum(axis) for axis in zip(*(way[hand] for way in ways))]
            self.act(act="drag", hand=hand, by=by, speed=0.25, keep=60)

    def kept(self, count):
        """Another sample: the phone says how many there are, and beeps."""
        self.assertIn(f"{count} of 10 places. ", self.played("beep")["message"]["text"])

    def silenced(self, how):
        """Another sample, of whose beep nobody hears the end."""
        self.sounds("beep")
        self.lost(how, "audio", self.pending("audio", "play"))
        self.mend("audio")

    def test_the_calibration_goes_on_with_the_samples_that_it_has(self):
        self.here([], database=cell.DATABASE, sound=True)
        self.go("Calibration")
        self.kept(1)  # where the arm is
        self.hold()

        self.lead(FROM[1])
        self.silenced(KILL)
        self.lead(FROM[2])
        self.kept(3)

        self.struck(KILL, "cell", during=f"{COLLECT}/AwaitRest", asks=INTERRUPTED, missed="robot")
        self.answer("3 of 10 places are there")
        self.hold()  # a cell that is back begins its world anew, with the arm at the first place
        self.lead(FROM[1], FROM[2], FROM[3], LOWER)
        self.kept(4)

        before = len(self.refused())
        self.strike(KILL, "recognition", during=f"{COLLECT}/AwaitRest")
        self.lead(FROM[4])  # it is missed at the next place
        self.until_active(INTERRUPTED)
        self.assertIn("obj_rec", self.refused()[before:])
        self.mend("recognition")
        question = self.asked("4 of 10 places are there")
        self.processes["recognition"].signal(HANG)  # nobody knows yet
        self.reply(question)
        self.lost(HANG, "recognition", self.pending("obj_rec", "start"))
        self.until_active(INTERRUPTED)
        self.mend("recognition")
        self.answer("4 of 10 places are there")
        self.kept(5)

        before = len(self.refused())
        self.processes["display"].signal(HANG)
        self.lead(FROM[5])
        self.assertNotIn("6 of 10", self.played("beep")["message"]["text"])  # missed by nobody who hears the beep
        self.assertEqual(self.refused()[before:], ["display"])
        self.mend("display")

        self.lead(FROM[6])
        self.silenced(HANG)
        for place in (7, 8, 9):
            self.lead(FROM[place])
            self.kept(place + 1)

        self.asked("Calibrated from 10 places")
        self.let_go()
        self.lost(HANG, "display", self.pending("display", "ask"))
        self.until_active(f"{CALIBRATION}/Trouble")
        self.mend("display")
        self.answer(UNCALIBRATED)
        self.played("success")
        self.succeeds()
        found = self.server.ended(self.core)["results"]["o_t_c"]
        self.assertLess(math.dist(found["position"], cell.O_T_C["position"]), 0.005)
        self.assertLess(angle(found["orientation"], cell.O_T_C["orientation"]), 1)
        stored = self.server.core(models.reading(), {"key": "o_t_c"})
        self.assertEqual(self.server.ended(stored)["results"]["value"], found)


if __name__ == "__main__":
    unittest.main()
