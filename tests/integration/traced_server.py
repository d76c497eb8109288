"""`race serve` whose system calls on the files of its data folder fail, or kill it: strace injects the fault (apt: strace)."""
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

from client import PROGRAM, TIMEOUT

# A line of its log (server/log/line_log.h); whatever else is on stderr is a failure.
LOG_LINE = re.compile(r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z (error|warning|info|debug) .*\n", re.MULTILINE)
# What changes a file, or makes a change of it durable.
WRITES = ("pwrite64", "write", "fdatasync", "fsync", "ftruncate", "unlink", "rename", "fallocate")
STORE = ("race.sqlite", "race.sqlite-wal", "race.sqlite-shm", "race.sqlite-journal")
DATABASE = ("database.sqlite", "database.sqlite-wal", "database.sqlite-shm", "database.sqlite-journal")


def data_folder():
    """An empty folder; the caller removes it."""
    return tempfile.mkdtemp(prefix="race-test-")


def strace():
    """The path of strace. Without it there is no test: it is in deploy/packages/test.txt."""
    path = shutil.which("strace")
    assert path, "these tests need strace: deploy/install"
    return path


class TracedServer:
    """`race serve`, under strace if there is something to trace.

    `inject` is strace's fault, as "error=ENOSPC:when=5+", on `calls` on `files` of the data folder; counts are of each
    thread and each system call of its own. `record`: a file that gets each such call, a line. The process is our own
    child, so that its status is known; end_faults() ends strace and leaves the server.
    """

    def __init__(self, data, inject=None, calls=WRITES, files=STORE, record=None, options=()):
        self.data = data
        command = [PROGRAM, "serve", "--port", "0", "--data", data, *options]
        if inject or record:
            command = [*self.trace(inject, calls, files, record), *command]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        match = re.search(r":(\d+)$", self.process.stdout.readline().strip())
        self.port = int(match.group(1)) if match else None  # None: it ended before it listened

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Leaves no process behind, whatever failed."""
        if self.process.returncode is None:
            self.kill()

    def trace(self, inject, calls, files, record):
        # -D: strace is the grandchild; -I2: SIGTERM ends it. No --seccomp-bpf: with it, strace 6.1 injects no signal, and
        # when strace has ended, every traced call fails.
        words = [strace(), "-D", "-I2", "-f", "-qq", "-o", record or "/dev/null", "-e", "trace=" + ",".join(calls)]
        for file in files:
            words += ["-P", str(Path(self.data, file))]
        words += ["-P", self.data]
        if inject:
            words += ["-e", f"inject={','.join(calls)}:{inject}"]
        return words

    def end_faults(self):
        """Ends strace: from now on every call does what it should."""
        status = Path(f"/proc/{self.process.pid}/status")
        tracer = lambda: int(re.search(r"TracerPid:\s*(\d+)", status.read_text()).group(1))
        os.kill(tracer(), signal.SIGTERM)
        while tracer():
            time.sleep(0.001)

    def kill(self):
        """SIGKILL; its status."""
        self.process.kill()
        return self.ended()

    def stop(self):
        """Ends it as a service manager does; its status."""
        self.process.terminate()
        return self.ended()

    def ended(self):
        """Waits until it has ended: (status, what it said on stderr, but for the lines of its log)."""
        _, said = self.process.communicate(timeout=TIMEOUT)
        return self.process.returncode, LOG_LINE.sub("", said)

    def remove(self):
        """Ends it and removes its folder."""
        assert self.stop()[0] == 0
        shutil.rmtree(self.data)
