"""The demonstrator with every unit a process of its own: each is killed, and hangs, in the middle; a person says go on."""
import json
import shutil
import signal
import tempfile
import unittest
from pathlib import Path

from client import PROJECT, Server, check
from test_components import Process, there

DEMO = PROJECT / "deploy/demo"
UNITS = {"cell": "robot", "recognition": "obj_rec", "database": "db", "display": "display", "audio": "audio"}
TABLE, WORK = "Demonstrator/Table", "Demonstrator/Table/Work"
PICK, PLACE = f"{WORK}/Task/Pick", f"{WORK}/Task/Place"
KILL, HANG = signal.SIGKILL, signal.SIGSTOP
CUBE, BOX = "cube_red", "cube_blue"


class Mortal(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.cell = Path(self.folder.name, "cell")
        shutil.copytree(DEMO, self.cell)
        scene = json.loads((DEMO / "scene.json").read_text())
        scene["bodies"] = [body for body in scene["bodies"] if body["mass"] == 0 or body["name"] in (CUBE, BOX)]
        database = json.loads((DEMO / "database.json").read_text()) | {"o_t_c": scene["camera"]["pose"]}
        (self.cell / "scene.json").write_text(json.dumps(scene))
        (self.cell / "database.json").write_text(json.dumps(database))
        self.server = Server("--remote", ",".join(UNITS), "--heartbeat", "2")
        self.addCleanup(self.server.stop)
        self.processes = {}
        for unit in UNITS:
            self.begin(unit)
        self.phone = self.server.stream()
        self.addCleanup(self.phone.socket.close)
        self.phone.send(check("stream_request", {"type": "display", "name": "phone", "sound": False}))
        self.core = self.server.core(json.loads((DEMO / "demonstrator.rcm.json").read_text()), {"begin": "Table", "speed": 1.0})

    def begin(self, unit):
        options = {"database": ["--folder", self.cell, "--database", Path(self.folder.name, "values.sqlite")], "audio": []}
        self.processes[unit] = Process(self.server, unit, *map(str, options.get(unit, ["--folder", self.cell])))
        self.addCleanup(self.processes[unit].__exit__)
        there(self.server, UNITS[unit])

    def until_active(self, state):
        """Until the state is active."""
        with self.server.stream() as stream:
            stream.subscribe(f"core/{self.core}/state")
            active = set()
            while state not in active:
                message = stream.message()
                if message["kind"] == "snapshot":
                    active = set(message["data"]["state"]["active"])
                for node, now in message["data"].get("active", {}).items() if message["kind"] == "delta" else ():
                    (active.add if now else active.discard)(node)

    def strike(self, how, units, state):
        """Something happens to the units while the state is active: the task comes to the end that asks a person."""
        self.until_active(state)
        for unit in units:
            self.processes[unit].signal(how)
        for unit in units:
            there(self.server, UNITS[unit], False)

    def mend(self, how, units):
        """The units are back: another process, or the same when it goes on."""
        for unit in units:
            if how == HANG:
                self.processes[unit].signal(signal.SIGCONT)
                there(self.server, UNITS[unit])
            else:
                self.processes[unit].kill()
                self.begin(unit)

    def resume(self, asks):
        """The question of this state is answered once it is shown."""
        self.until_active(f"{asks}/Trouble/Asking/Ask")
        question = self.phone.until(lambda m: "Continue" in m["data"].get("question", {}).get("buttons", ()))[-1]["data"]["question"]
        self.phone.send(check("stream_request", {"type": "answer", "question": question["id"], "answer": "Continue"}))

    def struck(self, how, units, state, asks):
        self.strike(how, units, state)
        self.until_active(f"{asks}/Trouble")
        self.mend(how, units)
        self.resume(asks)

    def test_the_task_takes_its_error_ports_and_goes_on_where_it_was(self):
        self.struck(KILL, ["cell"], f"{PICK}/Approach/Across", WORK)
        self.struck(HANG, ["cell"], f"{PICK}/Approach/Across", WORK)
        self.struck(KILL, ["database"], f"{PICK}/Retreat", WORK)
        self.struck(HANG, ["recognition"], f"{PLACE}/SetDown/Retreat", TABLE)
        # The person cannot even be asked until there is a display again.
        self.struck(HANG, ["database", "display"], f"{PICK}/Retreat", WORK)
        self.struck(KILL, ["recognition", "display"], f"{PLACE}/SetDown/Retreat", TABLE)
        self.processes["audio"].signal(HANG)  # nobody waits for a sound for ever
        ended = self.server.ended(self.core, 60)
        self.assertEqual((ended["outcome"], ended["results"]["skipped"]), ("success", []))
        self.assertEqual({part["label"] for part in ended["results"]["placed"]}, {"Cube", "Box"})
        self.assertEqual([s["violations"] for s in self.server.get("/services", "services")["services"] if s["violations"]], [])


if __name__ == "__main__":
    unittest.main()
