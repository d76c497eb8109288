"""Which files a process opens, and what it executes: strace writes both into a file (apt: strace)."""
import codecs
import os
import re
import time
from dataclasses import dataclass
from pathlib import Path

from client import TIMEOUT
from traced_server import strace

CALLS = ("?open", "openat", "openat2", "?creat", "execve", "execveat", "?fork", "?vfork")  # `?`: not on every machine
LINE = re.compile(r"^(?P<pid>\d+) +(?P<time>[\d.]+) (?P<call>\w+)\((?P<arguments>.*)$", re.MULTILINE)
OPENED = re.compile(r'^(?:(?:AT_FDCWD|\d+)(?:<(?P<folder>[^>]*)>)?, )?"(?P<path>(?:[^"\\]|\\.)*)", (?P<how>[^)]*)')
WRITES = re.compile(r"O_WRONLY|O_RDWR|O_CREAT|O_TRUNC|O_APPEND|O_TMPFILE")


@dataclass(frozen=True)
class Opened:
    time: float  # [s] since 1970
    path: str  # absolute, without `..`
    writes: bool


class OpenTrace:
    """What strace says of a server that was started with Server(under=trace.words)."""

    def __init__(self, file):
        self.file = Path(file)
        # -D: the server is our child; --seccomp-bpf: only these calls cost time, as long as strace is there.
        self.words = [strace(), "-D", "-f", "--seccomp-bpf", "-q", "-y", "-ttt", "-o", str(file), "-e", "trace=" + ",".join(CALLS)]

    def text(self, pid):
        """All of it, once the process has ended."""
        end = time.monotonic() + TIMEOUT
        ended = re.compile(rf"^{pid} .*\+\+\+ (exited|killed)", re.MULTILINE)
        while not ended.search(text := self.file.read_text(errors="surrogateescape")):
            assert time.monotonic() < end, "strace has not written the end"
            time.sleep(0.02)
        return text

    def calls(self, pid, *names):
        """(name, arguments) of the calls of these names."""
        return [(line["call"], line["arguments"]) for line in LINE.finditer(self.text(pid)) if line["call"] in names]

    def opened(self, pid):
        """Each open, also one that failed."""
        lines = LINE.finditer(self.text(pid))
        return [opened(line) for line in lines if line["call"] in ("open", "openat", "openat2", "creat")]


def opened(line):
    found = OPENED.match(line["arguments"])
    assert found, f"not understood: {line[0]}"
    path = codecs.escape_decode(found["path"].encode())[0].decode(errors="surrogateescape")
    path = os.path.normpath(os.path.join(found["folder"] or "/", path))
    return Opened(float(line["time"]), path, line["call"] == "creat" or bool(WRITES.search(found["how"])))
