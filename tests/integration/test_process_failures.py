"""The demonstrator with its services in processes of their own: each is killed or hangs during the run, and a person continues it."""
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

GROUPS = {"cell": ["robot", "gripper", "camera"], "recognition": ["obj_rec"], "database": ["db"], "display": ["display"],
          "audio": ["audio"]}
CALIBRATION, TABLE, WORK = "Demonstrator/Calibration", "Demonstrator/Table", "Demonstrator/Table/Work"
COLLECT, INTERRUPTED = f"{CALIBRATION}/CameraCalibration/Collect", f"{CALIBRATION}/CameraCalibration/Trouble"
PICK, PLACE, COLLISION = f"{WORK}/Task/Pick", f"{WORK}/Task/Place", f"{WORK}/Collision"
KILL, HANG = signal.SIGKILL, signal.SIGSTOP
# Stands in the way of the first part: the arm hits it once, and it falls over.
POST = {"name": "post", "shape": {"box": [0.04, 0.04, 0.25]}, "mass": 2.0, "friction": 0.7, "colour": "#808080",
        "pose": {"position": [0.55, 0.12, 0.125], "orientation": [0, 0, 0, 1]}}
HIT, STUCK, GONE = "The arm has met something", "could not be picked or placed", "fingers do not hold"
STILL, UNCALIBRATED = "The search cannot go on", "The calibration was interrupted"


class ProcessFailureTest(unittest.TestCase):
    def start_cell(self, parts, *bodies, database=None, sound=False):
        """Starts a server, all processes for a cell with these parts and bodies, and a phone as display, with or without sound."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.values, self.folder = Path(folder.name, "values.sqlite"), Path(folder.name, "cell")
        self.parts = parts
        known = {**cell.DATABASE, "o_t_c": cell.O_T_C}
        cell.copy_cell(self.folder, {"scene.json": cell.scene(parts, *bodies), "database.json": database or known})
        self.server = Server("--remote", ",".join(GROUPS), "--heartbeat", "2")
        self.addCleanup(self.server.stop)
        self.processes, self.known_questions, self.known_sounds = {}, set(), set()
        for group in GROUPS:
            self.start_process(group)
        self.phone = self.server.stream()
        self.addCleanup(self.phone.close)
        self.phone.send_checked({"type": "display", "name": "phone", "sound": sound})

    def start_task(self, begin="Table"):
        self.core = self.server.core(cell.DOCUMENT, {"begin": begin, "speed": 1.0})

    def start_process(self, group):
        options = {"database": ["--folder", self.folder, "--database", self.values], "audio": []}
        self.processes[group] = ComponentProcess(self.server, group, *map(str, options.get(group, ["--folder", self.folder])))
        self.addCleanup(self.processes[group].__exit__)
        self.wait_processes(True, group)

    def wait_processes(self, available, *groups):
        for group in groups:
            for key in GROUPS[group]:
                wait_available(self.server, key, available)

    def until_active(self, state):
        with self.server.stream() as stream:
            stream.subscribe(f"core/{self.core}/state")
            active, end = set(), time.monotonic() + 3 * TIMEOUT
            while state not in active:
                message = stream.receive()  # not checked: states may last for less than a second
                if message["kind"] == "snapshot":
                    active = set(message["data"]["state"]["active"])
                for node, now in message["data"].get("active", {}).items() if message["kind"] == "delta" else ():
                    (active.add if now else active.discard)(node)
                status = message["data"]["core"]["status"]
                self.assertTrue(state in active or status in ("ready", "running"), f"{status} before {state} was active")
                self.assertLess(time.monotonic(), end, f"{state} does not become active, but {sorted(active)}")

    def break_processes(self, how, *groups, during=None):
        """Sends a signal to the processes while the state is active; returns when the server has noticed."""
        if during:
            self.until_active(during)
        for group in groups:
            if how == KILL:
                self.processes[group].kill()
            else:
                self.processes[group].signal(how)
        self.wait_processes(False, *groups)

    def restore(self, *groups):
        """Continues the processes, or starts new ones in place of killed ones."""
        for group in groups:
            if self.processes[group].process.poll() is None:
                self.processes[group].signal(signal.SIGCONT)
                self.wait_processes(True, group)
            else:
                self.start_process(group)

    def wait_question(self, text):
        """Waits until the phone shows an unanswered question with this text; returns it."""
        new = lambda q: text in q.get("text", "") and q["id"] not in self.known_questions
        return self.phone.until(lambda m: new(m["data"].get("question", {})))[-1]["data"]["question"]

    def answer(self, text, button="Continue"):
        """Answers the question of this text."""
        self.reply(self.wait_question(text), button)

    def reply(self, question, button="Continue"):
        self.known_questions.add(question["id"])
        self.phone.send_checked({"type": "answer", "question": question["id"], "answer": button})

    def wait_sound(self, name):
        """Waits until the phone begins to play this sound; returns what it shows. The test reports the end of the sound, or never."""
        new = lambda sound: sound.get("name") == name and sound["id"] not in self.known_sounds
        shown = self.phone.until(lambda m: new(m["data"].get("sound", {})))[-1]["data"]
        self.known_sounds.add(shown["sound"]["id"])
        return shown

    def play_sound(self, name):
        """The phone plays this sound to its end; returns what it shows meanwhile."""
        shown, call = self.wait_sound(name), self.pending("audio", "play")
        self.phone.send_checked({"type": "played", "sound": shown["sound"]["id"]})
        self.assertEqual(self.response(call).get("result"), {"sound": name, "displays": ["phone"]})
        return shown

    def pending(self, key, operation):
        """Waits until a call of this operation is pending; returns the number of the newest."""
        calls = []
        is_own = lambda p: (p.get("core"), p["operation"]) == (self.core, operation)
        wait_until(lambda: calls.extend(p["core_call"] for p in service(self.server, key)["pending"] if is_own(p)) or calls)
        return calls[-1]

    def responses(self):
        """The responses to calls of the core so far, in order."""
        entries = self.server.get(f"/cores/{self.core}/journal")["entries"]
        return [e["input"] for e in entries if e["input"]["kind"] == "response"]

    def response(self, call):
        """Waits for the response to this call; returns it."""
        found = []
        wait_until(lambda: found.extend(r for r in self.responses() if r["call"] == call) or found)
        return found[0]

    def unavailable_services(self):
        """Services that were `unavailable` for the core so far, in order."""
        return [r["service"] for r in self.responses() if r.get("error", {}).get("code") == "unavailable"]

    def wait_missed(self, service, before=0):
        """Waits until the core has been told that the service is `unavailable`, after so many that it was told before."""
        wait_until(lambda: service in self.unavailable_services()[before:])

    def break_in_call(self, how, group, call):
        """Sends a signal to the process while this call is pending; the call must be answered `unavailable`."""
        self.break_processes(how, group)
        self.assertEqual(self.response(call).get("error", {}).get("code"), "unavailable")

    def break_and_restore(self, how, *groups, during, asks, missed):
        """Sends a signal to the processes; the task finds service `missed` unavailable and asks; then the processes are restored."""
        before = len(self.unavailable_services())
        self.break_processes(how, *groups, during=during)
        self.until_active(asks)
        self.wait_missed(missed, before)
        self.restore(*groups)

    def assert_success(self, skipped=()):
        ended = self.server.ended(self.core, 60)
        self.assertEqual(ended.get("outcome"), "success", ended)
        self.assertEqual((sorted(part["label"] for part in ended["results"]["placed"]), ended["results"]["skipped"]),
                         (sorted(set(self.parts) - set(skipped)), list(skipped)))
        self.assertEqual([s["violations"] for s in self.server.get("/services", "services")["services"] if s["violations"]], [])


class ResumedTasks(ProcessFailureTest):
    """Each failure leads to an error port, a question and Continue; in the end every part is placed once."""

    def test_the_task_resumes_where_it_was(self):
        self.start_cell(["Cube", "Box"])
        self.start_task()
        self.break_and_restore(KILL, "cell", during=f"{PICK}/Approach/Across", asks=f"{WORK}/Trouble", missed="robot")
        self.answer(STUCK)
        self.break_and_restore(KILL, "database", during=f"{PICK}/Retreat", asks=f"{WORK}/Trouble", missed="db")
        self.answer(STUCK)
        self.break_and_restore(HANG, "recognition", during=f"{PLACE}/Retreat", asks=f"{TABLE}/Trouble", missed="obj_rec")
        self.answer(STILL)
        # The person can be asked only when there is a display again.
        self.break_and_restore(HANG, "database", "display", during=f"{PICK}/Retreat", asks=f"{WORK}/Trouble", missed="db")
        self.answer(STUCK)
        self.break_and_restore(KILL, "recognition", "display", during=f"{PLACE}/Retreat", asks=f"{TABLE}/Trouble", missed="obj_rec")
        self.answer(STILL)
        self.assert_success()

    def test_a_part_lost_with_its_cell_is_searched_again(self):
        self.start_cell(["Cube"])
        self.start_task()
        self.break_and_restore(HANG, "cell", during=f"{PLACE}/Carry/Approach/Across", asks=f"{WORK}/Trouble", missed="robot")
        self.answer(STUCK)
        self.answer(GONE)  # a restarted cell has a new world: the part is where it was at first
        self.assert_success()


class FailuresAfterCollision(ProcessFailureTest):
    """A process fails while the arm stands still after a collision."""

    def setUp(self):
        self.start_cell(["Cube"], POST)
        self.start_task()

    def test_a_held_part_is_lost_with_the_cell(self):
        self.break_processes(KILL, "cell", during=COLLISION)
        self.answer(HIT)
        self.until_active(f"{WORK}/Trouble")
        self.wait_missed("gripper")  # the first service that is asked about the part
        (self.folder / "scene.json").write_text(json.dumps(cell.scene(self.parts)))  # the new world has no post
        self.restore("cell")
        self.answer(STUCK)
        self.answer(GONE)
        self.assert_success()

    def test_a_part_is_given_up_once_the_cell_is_back(self):
        self.answer(HIT, "Skip")
        self.break_and_restore(KILL, "cell", during=f"{WORK}/GiveUp/Task/Carry", asks=f"{WORK}/Stuck", missed="robot")
        self.answer("could not be given up")
        self.assert_success(skipped=["Cube"])

    def test_a_display_that_is_back_is_asked_again(self):
        self.until_active(COLLISION)
        self.known_questions.add(self.wait_question(HIT)["id"])  # it disappears with the display
        self.break_processes(KILL, "display")
        self.until_active(f"{COLLISION}/Display/Absent")
        self.assertEqual(set(self.unavailable_services()), {"display"})
        self.restore("display")
        self.answer(HIT)
        self.assert_success()


class MissingAtStart(ProcessFailureTest):
    """A process is missing when it is first needed."""

    def test_the_task_continues_when_a_person_confirms_the_database_is_back(self):
        self.start_cell([])
        self.break_processes(KILL, "database")
        self.start_task("Calibration")
        self.until_active(f"{CALIBRATION}/Trouble")
        self.wait_missed("db")
        self.restore("database")
        self.answer(UNCALIBRATED)
        self.assert_success()

    def test_a_calibration_without_a_display_asks_once_one_is_back(self):
        self.start_cell([], database=cell.DATABASE)
        self.break_processes(KILL, "display")
        self.start_task("Calibration")
        self.until_active(f"{CALIBRATION}/Trouble")
        self.wait_missed("display")
        self.restore("display")
        stored = self.server.core(models.storing(), {"key": "o_t_c", "value": cell.O_T_C})  # another task stores it meanwhile
        self.assertEqual(self.server.ended(stored)["outcome"], "success")
        self.answer(UNCALIBRATED)
        self.assert_success()


class AudioFailures(ProcessFailureTest):
    """The audio process fails while the task waits for the end of its last sound."""

    def check_end_without_sound(self, how):
        self.start_cell([], sound=True)
        self.start_task()
        self.until_active(f"{TABLE}/Beep")
        self.break_in_call(how, "audio", self.pending("audio", "play"))
        self.assert_success()
        self.assertEqual(self.unavailable_services(), ["audio"])

    def test_the_task_ends_when_the_audio_process_is_killed(self):
        self.check_end_without_sound(KILL)

    def test_the_task_ends_when_the_audio_process_hangs(self):
        self.check_end_without_sound(HANG)


def drag_vectors(text):
    """How far each hand of the demo's operator script moves the arm when a display shows this text [m]."""
    acts = next(act["do"] for act in cell.OPERATOR["acts"] if text in act.get("when", {}).get("display", {}).get("text", ""))
    return {act["hand"]: act["by"] for act in acts}


GRAB = cell.OPERATOR["acts"][0]["do"]
FROM = {place: drag_vectors(f"{place} of 10 places") for place in range(1, 10)}
LOWER = drag_vectors("does not see")  # above the fourth place the camera sees nothing


class FailuresDuringCalibration(ProcessFailureTest):
    """Processes fail while a person leads the arm through the calibration: no sample is lost and none counts twice."""

    def act(self, **act):
        self.server.post("/cell/person", check("person_command", act), "person")

    def grab_arm(self):
        """All hands grab the arm once it is compliant."""
        self.until_active(f"{COLLECT}/AwaitRest")
        for act in GRAB:
            self.act(**act, keep=60)

    def release_arm(self):
        for act in GRAB:
            self.act(act="release", hand=act["hand"])

    def drag_arm(self, *ways):
        """The hands drag the arm along the sum of these vectors and keep it there."""
        for hand in ways[0]:
            by = [sum(axis) for axis in zip(*(way[hand] for way in ways), strict=True)]
            self.act(act="drag", hand=hand, by=by, speed=0.25, keep=60)

    def wait_sample(self, count):
        """Waits for another sample: the phone shows the count and beeps."""
        self.assertIn(f"{count} of 10 places. ", self.play_sound("beep")["message"]["text"])

    def wait_sample_without_sound(self, how):
        """Waits for another sample; the audio process fails during its beep."""
        self.wait_sound("beep")
        self.break_in_call(how, "audio", self.pending("audio", "play"))
        self.restore("audio")

    def test_the_calibration_keeps_its_samples_over_failures(self):
        self.start_cell([], database=cell.DATABASE, sound=True)
        self.start_task("Calibration")
        self.wait_sample(1)  # where the arm is
        self.grab_arm()

        self.drag_arm(FROM[1])
        self.wait_sample_without_sound(KILL)
        self.drag_arm(FROM[2])
        self.wait_sample(3)

        self.break_and_restore(KILL, "cell", during=f"{COLLECT}/AwaitRest", asks=INTERRUPTED, missed="robot")
        self.answer("3 of 10 places are there")
        self.grab_arm()  # a restarted cell has a new world, with the arm at the first place
        self.drag_arm(FROM[1], FROM[2], FROM[3], LOWER)
        self.wait_sample(4)

        before = len(self.unavailable_services())
        self.break_processes(KILL, "recognition", during=f"{COLLECT}/AwaitRest")
        self.drag_arm(FROM[4])  # noticed at the next place
        self.until_active(INTERRUPTED)
        self.wait_missed("obj_rec", before)
        self.restore("recognition")
        question = self.wait_question("4 of 10 places are there")
        self.processes["recognition"].signal(HANG)  # not noticed yet
        self.reply(question)
        self.break_in_call(HANG, "recognition", self.pending("obj_rec", "start"))
        self.until_active(INTERRUPTED)
        self.restore("recognition")
        self.answer("4 of 10 places are there")
        self.wait_sample(5)

        before = len(self.unavailable_services())
        self.processes["display"].signal(HANG)
        self.drag_arm(FROM[5])
        self.assertNotIn("6 of 10", self.play_sound("beep")["message"]["text"])  # the task needs no display here
        self.wait_missed("display", before)
        self.assertEqual(self.unavailable_services()[before:], ["display"])
        self.restore("display")

        self.drag_arm(FROM[6])
        self.wait_sample_without_sound(HANG)
        for place in (7, 8, 9):
            self.drag_arm(FROM[place])
            self.wait_sample(place + 1)

        self.wait_question("Calibrated from 10 places")
        self.release_arm()
        self.break_in_call(HANG, "display", self.pending("display", "ask"))
        self.until_active(f"{CALIBRATION}/Trouble")
        self.restore("display")
        self.answer(UNCALIBRATED)
        self.play_sound("success")
        self.assert_success()
        found = self.server.ended(self.core)["results"]["o_t_c"]
        self.assertLess(math.dist(found["position"], cell.O_T_C["position"]), 0.005)
        self.assertLess(angle(found["orientation"], cell.O_T_C["orientation"]), 1)
        stored = self.server.core(models.reading(), {"key": "o_t_c"})
        self.assertEqual(self.server.ended(stored)["results"]["value"], found)


if __name__ == "__main__":
    unittest.main()
