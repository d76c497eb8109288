#!/usr/bin/python3
"""run.py [SECONDS] [--seed N] [--report FILE] [TARGET...]: runs the fuzz targets of build/fuzz, as many at a time as there are
processors: first on what was found earlier (regressions/TARGET), then with libFuzzer for so many seconds each.

Prints a line for each target. A crash, an error of a sanitizer, a hang or too much memory fails, with the input that
does it, which is kept below build/fuzz/found. The seed makes a run repeatable, up to the moment when it ends.
"""
import argparse
import base64
import os
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from xml.sax.saxutils import quoteattr

from targets import TARGETS

ROOT = Path(__file__).resolve().parent.parent.parent
BUILD = ROOT / "build/fuzz"
HANG = 20  # s that an input may take, while others use the processors
MEMORY = 2048  # MB
SYMBOLIZER = {f"{each}_SYMBOLIZER_PATH": "/usr/bin/addr2line" for each in ("ASAN", "UBSAN")}
SHOWN = 4096  # bytes of an input


def folder(kind, name):
    """BUILD/KIND/NAME, empty."""
    path = BUILD / kind / name
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir(parents=True)
    return path


def make_seeds(name, target):
    """The folder of the seeds and the dictionary."""
    made = folder("seeds", name)
    for number, seed in enumerate(dict.fromkeys(target.seeds())):
        (made / f"{number:04}").write_bytes(seed.encode())
    words = BUILD / "seeds" / f"{name}.dict"
    escaped = ("".join(chr(byte) if 32 <= byte < 127 and chr(byte) not in '"\\' else f"\\x{byte:02x}" for byte in word.encode())
               for word in sorted(target.words()) if word)
    words.write_text("".join(f'"{word}"\n' for word in escaped))
    return made, words


def libfuzzer(name, *arguments):
    """(status, output) of a target."""
    command = [BUILD / "tests/fuzz" / f"fuzz_{name}", f"-timeout={HANG}", f"-rss_limit_mb={MEMORY}",
               "-entropic=0",  # its counts of features took two thirds of the time of a large input
               *arguments]
    done = subprocess.run(command, env={**os.environ, **SYMBOLIZER}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False)
    return done.returncode, done.stdout.decode(errors="replace")


def last(pattern, text, otherwise="?"):
    found = re.findall(pattern, text)
    return found[-1] if found else otherwise


def describe(path, output):
    """Why an input fails, and the input."""
    why = [line for line in output.splitlines()
           if re.search(r"ERROR|SUMMARY|runtime error|does not hold|failed:|^ALARM", line)]
    stack = [line for line in output.splitlines() if re.match(r" +#\d+ .*(race::|/core/|/services/|/server/)", line)][:12]
    data = path.read_bytes()
    shown = base64.b64encode(data).decode() if len(data) <= SHOWN else f"({len(data)} bytes)"
    return "\n".join([f"  input {path.relative_to(ROOT)}", *(f"  {line}" for line in [*why, *stack]), f"  base64 {shown}"])


def summary(name, output, seconds):
    executions = int(last(r"stat::number_of_executed_units: (\d+)", output, "0"))
    coverage = last(r"cov: (\d+)", output)
    units = last(r"new_units_added: +(\d+)", output)
    slowest = last(r"slowest_unit_time_sec: +(\d+)", output)
    memory = last(r"peak_rss_mb: +(\d+)", output)
    return (f"{name:10} {executions:8} executions {executions / max(seconds, 1):7.0f}/s  coverage {coverage:>6}  "
            f"new units {units:>5}  slowest {slowest} s  memory {memory:>4} MB  ")


class Result:
    """What came of a target: a line, and the failures of its cases."""

    def __init__(self, name):
        self.name, self.line, self.cases, self.failures = name, "", [], {}

    def add(self, case, failure=None):
        self.cases.append(case)
        if failure:
            self.failures[case] = failure


def run_regressions(result):
    for path in sorted((ROOT / "tests/fuzz/regressions" / result.name).glob("*")):
        status, output = libfuzzer(result.name, path)
        result.add(f"regression {path.name}", describe(path, output) if status else None)


def run_target(name, seconds, seed):
    target, result = TARGETS[name], Result(name)
    run_regressions(result)
    made, words = make_seeds(name, target)
    found, corpus = folder("found", name), folder("corpus", name)
    begin = time.monotonic()
    status, output = libfuzzer(name, f"-max_total_time={seconds}", f"-seed={seed}", f"-max_len={target.most}", f"-dict={words}",
                               f"-artifact_prefix={found}/", "-print_final_stats=1", corpus, made)
    (BUILD / "found" / f"{name}.log").write_text(output)
    inputs = [path for path in sorted(found.iterdir()) if not path.name.startswith("slow-unit")]
    for path in inputs or ([made] if status else []):
        failure = describe(path, output) if path.is_file() else f"  ended with {status}:\n{output[-2000:]}"
        result.add(f"found {path.name}", failure)
    if not status:
        result.add("libFuzzer")
    result.line = summary(name, output, time.monotonic() - begin) + ("FAILED" if result.failures else "ok")
    return result


def write_report(path, results):
    """JUnit, as deploy/tally.py reads it."""
    cases = "".join(f"<testcase classname={quoteattr(result.name)} name={quoteattr(case)}>"
                    + (f"<failure message={quoteattr(result.failures[case])}/>" if case in result.failures else "") + "</testcase>\n"
                    for result in results for case in result.cases)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"<testsuite name=\"fuzz\">\n{cases}</testsuite>\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seconds", nargs="?", type=int, default=15)
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=" ".join(TARGETS))
    parser.add_argument("--seed", type=int, default=int(os.environ.get("RACE_SEED", "20261124")))
    parser.add_argument("--report", type=Path)
    options = parser.parse_args()
    names = options.targets or list(TARGETS)
    if unknown := set(names) - set(TARGETS):
        parser.error(f"there is no target {' '.join(sorted(unknown))}")
    print(f"seed {options.seed % 2**32}, {options.seconds} s each", flush=True)
    results = []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for result in pool.map(lambda name: run_target(name, options.seconds, options.seed % 2**32), names):
            print("\n".join([result.line, *result.failures.values()]), flush=True)
            results.append(result)
    if options.report:
        write_report(options.report, results)
    return 1 if any(result.failures for result in results) else 0


if __name__ == "__main__":
    sys.exit(main())
