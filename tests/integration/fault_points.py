"""Where a fault may be injected: every system call of the scenario on files of the data folder, as recorded runs have them."""
import collections
import functools
import os
import random
import shutil
import tempfile

from crash_scenario import EDITS, STEPS, Connection, Scenario
from traced_server import DATABASE, STORE, TracedServer, data_folder

# What is traced, and what the client does first. The writes of the threads that serve edits, of the one that writes
# journals, and of the database's come first in one phase each, so that their counts reach every one.
Phase = collections.namedtuple("Phase", "files new edits_first")
PHASES = {
    "new-folder": Phase(STORE + DATABASE, True, True),
    "edits": Phase(STORE, False, True),
    "steps": Phase(STORE, False, False),
    "database": Phase(DATABASE, False, False),
}

# The first thread that makes this call for the n-th time on the files of the phase.
Point = collections.namedtuple("Point", "phase call number")


@functools.cache
def prepared_folder():
    """A data folder that a server has made and left."""
    data = data_folder()
    server = TracedServer(data)
    assert server.stop() == (0, "")
    return data


def remove_prepared_folder():
    shutil.rmtree(prepared_folder())
    prepared_folder.cache_clear()


def new_folder(phase):
    """A folder to begin the phase in; the caller removes it."""
    data = data_folder()
    if not phase.new:
        shutil.copytree(prepared_folder(), data, dirs_exist_ok=True)
    return data


def record(name, calls, look):
    """(points of the phase, look(folder, connection)) of the whole scenario, not disturbed."""
    phase = PHASES[name]
    data = new_folder(phase)
    with tempfile.NamedTemporaryFile("r") as trace:
        server = TracedServer(data, record=trace.name, calls=calls, files=phase.files)
        with Connection(server.port) as connection:
            scenario = Scenario()
            scenario.run(connection, phase.edits_first)
            assert scenario.complete and scenario.step == STEPS and len(scenario.edits) == EDITS
            seen = look(data, connection)
        assert server.stop() == (0, "")
        most = most_of_a_thread(trace, only_first=phase.new)
    shutil.rmtree(data)
    points = [Point(name, call, n + 1) for call in sorted(most) for n in range(most[call])]
    assert points, f"the recorded run of {name} makes none of the calls {calls}"
    return points, seen


def most_of_a_thread(trace, only_first):
    """System call -> how often the thread makes it that makes it most often; of the first thread alone, if only that counts:
    the one that makes the files."""
    counts = collections.defaultdict(collections.Counter)
    for line in trace:
        thread, _, rest = line.partition(" ")
        if "(" in rest:
            counts[thread][rest.strip().partition("(")[0]] += 1
    most = collections.Counter()
    for count in list(counts.values())[:1 if only_first else None]:
        most |= count
    return most


def choose(points, count, seed):
    """Spread evenly over all, with a random beginning. RACE_POINT=phase:call:n chooses one; `count`: "all", or a number, no
    more than there are."""
    if one := os.environ.get("RACE_POINT"):
        phase, call, number = one.split(":")
        return [Point(phase, call, int(number))]
    count = len(points) if count == "all" else int(count)
    assert 0 < count <= len(points), f"{count} points are asked for, there are {len(points)}"
    first = random.Random(seed).random()
    return [points[int((i + first) * len(points) / count)] for i in range(count)]
