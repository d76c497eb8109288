"""The server is killed (SIGKILL) at a write: nothing that it acknowledged is lost, and nothing moves by itself.

It dies as it makes a call, before that has an effect; so what a kill after call n leaves is what one before call n + 1
leaves. A recorded run of each phase says which points there are (fault_points.py).
RACE_CRASH_POINTS says how many are tried (120; "all"), RACE_SEED which; RACE_POINT=phase:call:n tries one.
"""
import concurrent.futures
import math
import os
import shutil
import time
import unittest

from crash_scenario import EDITED, STEPS, Connection, Scenario, edit, edit_request
from fault_points import PHASES, choose, new_folder, record, remove_prepared_folder
from stored_data import Folder, Reference, derivations, replay
from traced_server import WRITES, TracedServer

POINTS = os.environ.get("RACE_CRASH_POINTS", "120")
REPLAYED = 8  # one in so many is replayed by another process
WATCHED = 8  # at most so many of those that leave a run are watched for some time after the restart
PAUSE = 0.3  # [s] for so long
SEED = int(os.environ.get("RACE_SEED", "1"))


class Check:
    """What holds after a kill at a point."""

    def __init__(self, point, reference, pause):
        self.point, self.reference, self.pause = point, reference, pause
        self.data = new_folder(PHASES[point.phase])
        self.folder = Folder(self.data)

    def run(self):
        """Whether the server died there. Error: AssertionError, whatever does not hold."""
        scenario = self.kill()
        before, keys = self.folder.journal(), self.folder.keys()
        self.check_files(scenario, before, keys)
        with TracedServer(self.data) as server:
            assert server.port, f"the server does not start again: {server.ended()}"
            with Connection(server.port) as connection:
                self.check_edits(connection, scenario)
                time.sleep(self.pause)
                run = self.check_core(connection, scenario, before)
                assert sorted(self.folder.keys()) == sorted(keys), "something was stored before the run was resumed"
                if run == "interrupted":
                    self.check_resumed(connection, len(before), keys)
            assert server.stop() == (0, "")
        after = self.folder.journal()  # and its files are sound
        if after and self.point.number % REPLAYED == 0:
            self.check_replay(after)
        return not scenario.complete

    def kill(self):
        phase = PHASES[self.point.phase]
        scenario = Scenario()
        fault = f"signal=SIGKILL:when={self.point.number}"
        with TracedServer(self.data, fault, (self.point.call,), phase.files) as server:
            if server.port:
                try:
                    with Connection(server.port) as connection:
                        scenario.run(connection, phase.edits_first)
                except OSError:  # it has died
                    pass
            status, said = server.kill() if scenario.complete else server.ended()
        assert (status, said) == (-9, ""), (status, said)
        return scenario

    def check_files(self, scenario, journal, keys):
        """What was acknowledged or had an effect is in the journal, and the journal is the one of the same run."""
        steps = len(journal)
        assert steps >= scenario.step, f"{scenario.step} steps were told, {steps} are stored"
        assert journal == self.reference.journal[:steps]
        assert set(range(steps - 1)) <= set(keys) <= set(range(steps)), f"{steps} steps, but stored: {sorted(keys)}"

    def check_edits(self, connection, scenario):
        """Every revision that was acknowledged is there; what was in flight is there or is not."""
        acknowledged = len(scenario.edits)
        status, last = connection.request("GET", f"/documents/{EDITED}")
        assert status == (200 if acknowledged else 404) or (status, acknowledged) == (200, 0), (status, last)
        scenario.check_edits(connection)
        if acknowledged > 1:  # what is sent again is not made again
            again = connection.expect("POST", f"/documents/{EDITED}/edits", edit_request(acknowledged, 1))
            assert again["revision"] == acknowledged, again
            assert connection.get(f"/documents/{EDITED}") == last
        if status == 200:
            assert last["revision"] in (acknowledged, acknowledged + 1), last["revision"]
            assert last["document"]["root"]["doc"] == edit(last["revision"])["root"]["doc"]

    def check_core(self, connection, scenario, journal):
        """The run is there as its journal says, and waits. Its status; None: it was never created, or is over."""
        cores = connection.get("/cores")["cores"]
        if len(journal) == STEPS or not cores:
            assert not cores and (len(journal) == STEPS or not scenario.core), cores
            return None
        core, = cores
        if not journal:
            assert (core["status"], core["step"]) == ("ready", 0), core
            return "ready"
        assert (core["status"], core["step"], core["micro"]) == ("interrupted", len(journal), 0), core
        assert core["interruption"]["reason"] == "restart", core
        stored = connection.get(f"/cores/{core['id']}/journal")["entries"]
        assert len(stored) == len(journal)
        return "interrupted"

    def check_resumed(self, connection, steps, keys):
        """The run goes on to its end: the call that was open is answered, but not sent again."""
        scenario = Scenario(connection, "1")
        scenario.tell("resume")
        scenario.wait()
        core = connection.get("/cores/1")
        assert (core["status"], core["outcome"], core["step"]) == ("ended", "done", STEPS), core
        assert core["results"]["answers"] == [
            "stored" if n + 1 != steps else "unavailable" for n in range(STEPS - 1)], core["results"]
        lost = {steps - 1} - set(keys)
        assert set(self.folder.keys()) == set(range(STEPS - 1)) - lost
        assert derivations(connection, "1", steps) == self.reference.derivations[:steps]

    def check_replay(self, journal):
        """The journal's hash is that of what was executed, and each stored checkpoint is what a replay comes to."""
        assert journal[-1][1].lower() in replay("1", self.data, "--hash")


def checked(point, reference, pause):
    """Whether the server died at the point; the error, if there is one."""
    check = Check(point, reference, pause)
    try:
        return check.run(), None
    except Exception as error:  # whatever it is, the point belongs to it
        return True, f"RACE_POINT={':'.join(map(str, point))}: {type(error).__name__}: {str(error)[:2000]}"
    finally:
        shutil.rmtree(check.data)


def pauses(points):
    """For each point, how long nothing may move after the restart."""
    with_run = [point for point in points if not PHASES[point.phase].edits_first]
    watched = with_run[::max(1, math.ceil(len(with_run) / WATCHED))]
    return [PAUSE if point in watched else 0 for point in points]


class Crash(unittest.TestCase):
    @classmethod
    def tearDownClass(cls):
        remove_prepared_folder()

    def test_a_kill_at_any_write_loses_nothing_and_moves_nothing(self):
        points, reference = [], None
        for name in PHASES:
            found, reference = record(name, WRITES, Reference)
            points += found
        chosen = choose(points, POINTS, SEED)
        print(f"{len(chosen)} of {len(points)} points, seed {SEED}", flush=True)
        with concurrent.futures.ProcessPoolExecutor(os.cpu_count()) as pool:
            results = list(pool.map(checked, chosen, [reference] * len(chosen), pauses(chosen), chunksize=4))
        errors = [error for _, error in results if error]
        self.assertEqual(errors, [], f"{len(errors)} of {len(chosen)}")
        died = sum(1 for killed, _ in results if killed)
        print(f"the server was killed at {died} of them")
        self.assertGreaterEqual(died, 0.9 * len(chosen))


if __name__ == "__main__":
    unittest.main()
