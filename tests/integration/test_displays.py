"""Displays on the stream: a client announces itself as one, its answers reach the task, invalid messages are refused."""
import unittest

import models
from client import Server


def asking(operation, name="asking"):
    """Calls an operation of the display: `answered` with its result, or `failed` with the code of its error."""
    call = f"svc.{operation.split('(')[0]}"
    return models.document(name, {
        "state": "Root", "entry": f"svc.{operation}", "results": [{"name": "answer"}, {"name": "code"}],
        "actions": [{"when": f"{call}.result", "do": f"res.answer = {call}.result"},
                    {"when": f"{call}.error", "do": f"res.code = {call}.error.code"}],
        "ports": [{"name": "answered", "when": "available(res.answer)"},
                  {"name": "failed", "when": "available(res.code)"}]})


class DisplayCase(unittest.TestCase):
    def setUp(self):
        self.server = Server()
        self.streams = []

    def tearDown(self):
        for stream in self.streams:
            stream.close()
        self.server.stop()

    def display(self, name="main", sound=False, **more):
        """A connected display that has received its first content."""
        stream = self.server.stream()
        self.streams.append(stream)
        stream.send_checked({"type": "display", "name": name, "sound": sound, **more})
        first = stream.message()
        self.assertEqual((first["channel"], first["kind"]), (f"display/{name}", "snapshot"))
        return stream

    def shown(self, stream, part):
        """Waits until the display shows this part; returns it."""
        return stream.until(lambda m: part in m["data"])[-1]["data"][part]

    def code(self, core):
        ended = self.server.ended(core)
        self.assertEqual(ended["outcome"], "failed", ended)
        return ended["results"]["code"]


class Displays(DisplayCase):
    def test_without_a_display_a_question_is_an_error(self):
        self.assertEqual(self.code(self.server.core(asking("display.ask('Go?')"))), "no_display")
        self.assertEqual(self.code(self.server.core(asking("audio.play('beep')"))), "no_speaker")

    def test_the_first_answer_to_a_question_counts(self):
        left, right = self.display("left"), self.display("right")
        core = self.server.core(asking("display.ask('Go?', ['Yes', 'No'])"))
        question = self.shown(left, "question")
        self.assertEqual(question, self.shown(right, "question"))
        right.send_checked({"type": "answer", "question": question["id"], "answer": "No"})
        self.assertEqual(self.server.ended(core)["results"]["answer"], {"answer": "No", "display": "right"})
        left.send_checked({"type": "answer", "question": question["id"], "answer": "Yes"})
        late = left.until(lambda m: m["kind"] == "error")
        self.assertEqual(late[-1]["data"]["errors"][0]["code"], "conflict")
        self.assertNotIn("question", late[-2]["data"])

    def test_a_display_that_reconnects_gets_the_current_content(self):
        core = self.server.core(asking("display.ask('Go?')"), start=False)
        display = self.display()
        self.server.post(f"/cores/{core}/start", None, "core")
        question = self.shown(display, "question")
        display.close()
        again = self.server.stream()
        self.streams.append(again)
        again.send_checked({"type": "display", "name": "main"})
        snapshot = again.message()
        self.assertEqual((snapshot["kind"], snapshot["data"]["question"]), ("snapshot", question))
        again.send_checked({"type": "answer", "question": question["id"], "answer": "OK"})
        self.assertEqual(self.server.ended(core)["outcome"], "answered")

    def test_a_question_to_a_lost_display_is_answered_display_lost(self):
        display = self.display()
        core = self.server.core(asking("display.ask('Go?')"))
        self.shown(display, "question")
        display.close()
        self.assertEqual(self.code(core), "display_lost")

    def test_a_display_has_one_name_at_a_time(self):
        display = self.display("left")
        display.send_checked({"type": "display", "name": "right"})
        self.assertEqual(display.message()["data"], {"display": "right"})
        self.assertEqual(self.code(self.server.core(asking("display.show_text('Hello', display='left')"))), "no_display")
        self.server.core(asking("display.show_text('Hello', display='right')", "shown"))
        self.assertEqual(self.shown(display, "message"), {"text": "Hello", "buttons": []})

    def test_a_place_reaches_the_displays_that_are_there(self):
        left, right = self.display("left", place="gripper"), self.display("right")
        self.assertEqual(self.code(self.server.core(asking("display.ask('Go?', display='@door')"))), "no_display")
        core = self.server.core(asking("display.ask('Go?', ['Yes'], display='@gripper')", "at_place"))
        question = self.shown(left, "question")
        late = self.server.stream()
        self.streams.append(late)
        late.send_checked({"type": "display", "name": "late", "place": "gripper"})
        self.assertEqual(self.shown(late, "question"), question, "one that comes there later shows it, too")
        right.send_checked({"type": "answer", "question": question["id"], "answer": "Yes"})
        self.assertEqual(right.until(lambda m: m["kind"] == "error")[-1]["data"]["errors"][0]["code"], "conflict")
        late.send_checked({"type": "answer", "question": question["id"], "answer": "Yes"})
        self.assertEqual(self.server.ended(core)["results"]["answer"], {"answer": "Yes", "display": "late"})

    def test_a_task_hears_where_displays_come_and_go(self):
        core = self.server.core(models.document("watching", {
            "state": "Root", "results": [{"name": "came"}, {"name": "went"}],
            "actions": [{"when": "svc.display.connected", "do": "res.came = svc.display.connected"},
                        {"when": "svc.display.disconnected", "do": "res.went = svc.display.disconnected"}],
            "ports": [{"name": "gone", "when": "available(res.went)"}]}))
        display = self.display("phone", place="gripper")
        display.close()
        results = self.server.ended(core)["results"]
        self.assertEqual(results, {"came": {"display": "phone", "place": "gripper"}, "went": {"display": "phone", "place": "gripper"}})

    def test_progress_is_shown_until_something_else_is(self):
        display = self.display()
        self.server.core(asking("display.show_progress('Calibrating', 0.4)"))
        self.assertEqual(self.shown(display, "message"), {"text": "Calibrating", "buttons": [], "progress": 0.4})
        self.assertEqual(self.code(self.server.core(asking("display.show_progress('Calibrating', 1.5)", "wrong"))), "out_of_range")
        self.server.core(asking("display.show_text('Done')", "done"))
        self.assertEqual(self.shown(display, "message"), {"text": "Done", "buttons": []})

    def test_a_sound_ends_when_the_display_reports_it(self):
        display = self.display(sound=True)
        core = self.server.core(asking("audio.play('beep', 0.5, 2)"))
        sound = self.shown(display, "sound")
        self.assertEqual((sound["name"], sound["volume"], sound["repeat"]), ("beep", 0.5, 2))
        display.send_checked({"type": "played", "sound": sound["id"]})
        self.assertEqual(self.server.ended(core)["results"]["answer"], {"sound": "beep", "displays": ["main"]})

    def test_a_display_that_never_reports_does_not_block_the_task(self):
        self.display(sound=True)
        self.assertEqual(self.code(self.server.core(asking("audio.play('beep')"))), "speaker_lost")

    def test_a_watcher_sees_what_a_display_shows_without_being_one(self):
        self.display("left")
        with self.server.stream() as watcher:
            watcher.subscribe("display/left")
            self.assertEqual(watcher.message()["data"], {"display": "left"})
            self.server.core(asking("display.show_text('Hello')"))
            self.assertEqual(self.shown(watcher, "message")["text"], "Hello")
            watcher.send_checked({"type": "press", "button": "Stop"})
            refused = watcher.until(lambda m: m["kind"] == "error")[-1]
            self.assertEqual(refused["data"]["errors"][0]["code"], "conflict")

    def test_invalid_messages_of_a_display_are_refused(self):
        wrong = [({"type": "display"}, "missing"), ({"type": "display", "name": "all"}, "name"),
                 ({"type": "display", "name": "a/b"}, "name"), ({"type": "display", "name": "a", "sound": 1}, "type"),
                 ({"type": "display", "name": "a", "place": "a/b"}, "name"), ({"type": "display", "name": "a", "place": ""}, "name"),
                 ({"type": "display", "name": "a", "place": 1}, "type"), ({"type": "display", "name": "a", "loud": True}, "unknown_field"),
                 ({"type": "answer"}, "missing"),
                 ({"type": "answer", "question": "1", "answer": "x"}, "type"),
                 ({"type": "answer", "question": 1, "answer": "x"}, "conflict"),
                 ({"type": "press", "button": "x"}, "conflict"), ({"type": "press", "button": 1}, "type"),
                 ({"type": "played", "sound": 1.5}, "type"), ({"type": "played", "sound": 1}, "conflict"),
                 ({"type": "dance"}, "type"), ({"type": "subscribe", "channel": "display/nobody"}, "not_found")]
        with self.server.stream() as stream:
            for message, code in wrong:
                stream.send(message)
                answer = stream.message()
                self.assertEqual((answer["kind"], answer["data"]["errors"][0]["code"]), ("error", code), message)

    def test_services_conform_to_their_rsm(self):
        display = self.display(sound=True)
        asked = self.server.core(asking("display.ask('Go?')"))
        self.shown(display, "question")
        for number, operation in enumerate(["display.show_text('Hello')", "display.ask('?', [])", "display.clear()"]):
            self.server.ended(self.server.core(asking(operation, f"task{number}")))
        self.assertEqual(self.code(asked), "cleared")
        services = {s["key"]: s for s in self.server.get("/services", "services")["services"]}
        for key in ("display", "audio"):
            self.assertEqual((services[key]["state"], services[key]["violations"]), ("Idle", []))


if __name__ == "__main__":
    unittest.main()
