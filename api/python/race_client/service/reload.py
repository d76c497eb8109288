"""A program that begins anew whenever a file beside it is saved."""
import json
import signal
import subprocess
import sys
import time
from collections.abc import Iterable
from contextlib import suppress
from importlib.util import cache_from_source
from pathlib import Path
from typing import NoReturn

RELOAD = "--reload"
TASK = ".rcm.json"  # the end of the name of a file with a task
LOOK = 0.2  # seconds between looks at the files
END_TIME = 5.0  # seconds for the program to end

Stamps = dict[Path, tuple[int, int]]


def run_anew_when_saved() -> NoReturn:
    """Runs this program without RELOAD, again whenever a .py or .json file of its folder is saved, until SIGINT or SIGTERM end it.

    Tasks (.rcm.json) and what is hidden are none of its files, as `race push` writes them. While a file has an error of syntax it is named,
    and what runs goes on. A program that has ended is run again when a file is saved.
    """
    words = [word for word in sys.orig_argv[1:] if word != RELOAD]
    folder = Path(sys.argv[0]).resolve().parent
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: sys.exit(0))
    child = None
    try:
        while True:
            stamps = stamps_of(folder)
            forget_compiled(stamps)
            child = subprocess.Popen([sys.executable, *words])
            wait_for_change(folder, stamps, child)
            end(child)
            say("saved: begins anew")
    finally:
        if child is not None:
            end(child)


def wait_for_change(folder: Path, stamps: Stamps, child: "subprocess.Popen[bytes]") -> None:
    """Returns once something was saved that can be run."""
    has_ended = False
    while True:
        time.sleep(LOOK)
        if not has_ended and child.poll() is not None:
            has_ended = True
            say(f"it has ended with status {child.returncode}; it begins anew when a file is saved")
        now = stamps_of(folder)
        if now == stamps:
            continue
        wrong = [text for path in now if (text := syntax_error(path))]
        if not wrong:
            return
        say("\n".join(wrong))
        stamps = now


def stamps_of(folder: Path) -> Stamps:
    """When each file was saved, and how long it is."""
    stamps = {}
    for path in sorted([*folder.glob("*.py"), *folder.glob("*.json")]):
        if path.name.endswith(TASK) or path.name.startswith("."):
            continue
        try:
            status = path.stat()
        except OSError:  # it is being replaced
            continue
        stamps[path] = (status.st_mtime_ns, status.st_size)
    return stamps


def forget_compiled(files: Iterable[Path]) -> None:
    """Python takes a compiled module for that of a file of the same second and length: what was saved again in a second would be missed."""
    for path in files:
        if path.suffix == ".py":
            with suppress(OSError):  # there is none
                Path(cache_from_source(str(path))).unlink()


def syntax_error(path: Path) -> str:
    """FILE:LINE and what is wrong with a file of Python or JSON; empty: nothing."""
    try:
        if path.suffix == ".py":
            compile(path.read_text(), str(path), "exec")
        else:
            json.loads(path.read_text())
    except (SyntaxError, ValueError) as error:
        return f"{path}:{getattr(error, 'lineno', None) or 1}: error: {getattr(error, 'msg', error)}; what was saved before goes on"
    except OSError:
        return ""
    return ""


def end(child: "subprocess.Popen[bytes]") -> None:
    """Ends the program."""
    child.terminate()
    try:
        child.wait(END_TIME)
    except subprocess.TimeoutExpired:
        child.kill()
        child.wait()


def say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)
