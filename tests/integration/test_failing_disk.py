"""The disk is full or fails (ENOSPC, EIO) at one operation, or from one on: the server goes on and says so, nothing that it
acknowledged is lost, and what was halted goes on when the disk works again.

RACE_DISK_POINTS says how many operations are tried (40; "all"), RACE_SEED which; RACE_POINT=phase:call:n tries one.
"""
import concurrent.futures
import os
import shutil
import unittest

from crash_scenario import EDITED, STEPS, TASK, Connection, Scenario, edit, edit_request, task
from fault_points import PHASES, choose, new_folder, record, remove_prepared_folder
from stored_data import Folder
from traced_server import WRITES, TracedServer

POINTS = os.environ.get("RACE_DISK_POINTS", "40")
SEED = int(os.environ.get("RACE_SEED", "1"))
CALLS = (*WRITES, "pread64")
TOLD = 0.5  # of the disks that fail for ever: what fails near the end of a thread's calls may disturb nobody
NEXT = {"ready": "start", "interrupted": "resume"}  # what a person does in this status


class Persistent(Scenario):
    """The client of the scenario, who goes on when the server refuses because of the disk. `is_told`: that the disk fails."""

    def __init__(self, reads_fail=False):
        super().__init__()
        self.reads_fail, self.is_told = reads_fail, False
        self.count = 0  # of edits that were sent

    def ask(self, method, path, body=None):
        """The answer; None: it is refused because of the disk."""
        status, answer = self.connection.request(method, path, body)
        if status in (500, 507):  # what cannot be read may as well be damaged
            assert status == 507 or self.reads_fail, answer
            assert [error["code"] for error in answer["errors"]] == ["storage" if status == 507 else "corrupt"], answer
            self.is_told = True
            return None
        assert status in (200, 201), f"{method} {path}: {status} {str(answer)[:500]}"
        return answer

    def edit(self, between):
        for number in range(1, 21):
            self.count += 1
            if not self.edits:
                stored = self.ask("PUT", f"/documents/{EDITED}", edit(number))
            else:
                request = {**edit_request(number, max(self.edits)), "request": f"e{self.count}"}
                stored = self.ask("POST", f"/documents/{EDITED}/edits", request)
            if stored:
                self.acknowledge(stored, number)
            between()

    def rotate(self):
        pass

    def command(self):
        """Creates the core and starts it, as far as the disk lets it."""
        if self.core is None:
            if not self.ask("PUT", f"/documents/{TASK}", task()):
                return
            if not (core := self.ask("POST", "/cores", {"document": TASK, "arguments": {}})):
                return
            self.core = core["id"]
        status = super().observe()
        if status in NEXT:
            self.ask("POST", f"/cores/{self.core}/{NEXT[status]}")

    def observe(self):
        return super().observe() if self.core else "ready"

    def note(self, core):
        self.is_told |= core["status"] == "interrupted"
        return super().note(core)


class Check:
    """What holds when a call fails with this error, once or from then on."""

    def __init__(self, point, error, forever):
        self.point, self.error, self.forever = point, error, forever
        self.phase = PHASES[point.phase]
        self.data = new_folder(self.phase)
        self.folder = Folder(self.data)

    def run(self):
        """Whether anybody was told that the disk fails. Error: AssertionError, whatever does not hold."""
        fault = f"error={self.error}:when={self.point.number}{'+' if self.forever else ''}"
        scenario = Persistent(self.point.call == "pread64")
        with TracedServer(self.data, fault, (self.point.call,), self.phase.files) as server:
            if server.port:
                with Connection(server.port) as connection:
                    scenario.run(connection, self.phase.edits_first)
                    self.check_halted(scenario)
                    if self.forever:
                        server.end_faults()
                    self.check_end(scenario)
                status, said = server.stop()
                assert status == 0, (status, said)
            else:
                status, said = server.ended()
                assert status == 2 and self.data in said, (status, said)
                scenario.is_told = True
        self.check_again(scenario)
        return scenario.is_told

    def check_halted(self, scenario):
        """A run whose journal failed has halted, and does not go on while the disk fails."""
        if scenario.observe() != "interrupted":
            return
        core = scenario.connection.get(f"/cores/{scenario.core}")
        assert core["interruption"]["reason"] == "storage", core
        if self.forever:
            scenario.command()
            scenario.wait()
            assert scenario.observe() in ("interrupted", "ended")

    def check_end(self, scenario):
        """The disk works: edits are stored, and the run goes on to its end."""
        for _ in range(3):  # a fault that comes once may come only now
            scenario.edit(lambda: None)
            scenario.command()
            scenario.wait()
        assert scenario.observe() == "ended"
        core = scenario.connection.get(f"/cores/{scenario.core}")
        assert (core["outcome"], core["step"]) == ("done", STEPS), core
        answers = core["results"]["answers"]
        keys = set(self.folder.keys_now())
        for n, answer in enumerate(answers):
            assert answer in ("stored", "unavailable", "storage"), answer
            scenario.is_told |= answer == "storage"
            assert (n in keys) == (answer == "stored") or answer == "unavailable", (n, answer)
        assert len(answers) == STEPS - 1 and keys <= set(range(STEPS - 1))

    def check_again(self, scenario):
        """Another server finds all that was acknowledged, and nothing that was refused."""
        journal = self.folder.journal()
        with TracedServer(self.data) as server, Connection(server.port) as connection:
            scenario.check_edits(connection)
            if scenario.edits:
                assert connection.get(f"/documents/{EDITED}")["revision"] == len(scenario.edits)
            assert server.stop() == (0, "")
        assert self.folder.journal() == journal and len(journal) == (STEPS if scenario.core else 0)


def checked(point, error, forever):
    """Whether anybody was told that the disk fails; the error, if there is one."""
    check = Check(point, error, forever)
    try:
        return check.run(), None
    except Exception as wrong:  # whatever it is, the point belongs to it
        return True, f"RACE_POINT={':'.join(map(str, point))} {error} {forever}: {type(wrong).__name__}: {str(wrong)[:2000]}"
    finally:
        shutil.rmtree(check.data)


class FailingDisk(unittest.TestCase):
    @classmethod
    def tearDownClass(cls):
        remove_prepared_folder()

    def test_the_server_goes_on_whatever_operation_fails(self):
        points = [point for name in PHASES for point in record(name, CALLS, lambda *_: None)[0]]
        points = [point for point in points if point.call != "unlink"]  # SQLite does not need it to succeed
        chosen = choose(points, POINTS, SEED)
        ways = [(error, forever) for error in ("ENOSPC", "EIO") for forever in (False, True)]
        cases = [(point, *way) for i, point in enumerate(chosen)
                 for way in (ways if POINTS == "all" or "RACE_POINT" in os.environ else [ways[i % len(ways)]])]
        print(f"{len(chosen)} of {len(points)} points, seed {SEED}", flush=True)
        with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
            results = list(pool.map(checked, *zip(*cases, strict=True), chunksize=4))
        errors = [error for _, error in results if error]
        self.assertEqual(errors, [], f"{len(errors)} of {len(cases)}")
        told = [is_told for (_, _, forever), (is_told, _) in zip(cases, results, strict=True) if forever]
        print(f"{sum(told)} of {len(told)} that fail for ever were told to somebody")
        self.assertTrue("RACE_POINT" in os.environ or sum(told) >= TOLD * len(told))


if __name__ == "__main__":
    unittest.main()
