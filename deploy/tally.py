#!/usr/bin/python3
"""tally.py FOLDER: sums the JUnit reports below FOLDER and prints `PASSED FAILED`.

A CTest report counts a program as one test; where the program left its own report in the folder `cases` beside it,
its cases count instead. A program that fails although no case of its report did (it crashed, or a sanitizer reported an error)
is one failure more. So is a report that is not whole: its program crashed, or is writing it.
"""
import sys
import xml.etree.ElementTree as xml
from pathlib import Path


def read(path):
    """The testcase elements of a report; nothing if it is not whole."""
    try:
        return list(xml.parse(path).getroot().iter("testcase"))
    except xml.ParseError:
        return None


def count(cases):
    """(passed, failed) of testcase elements; skipped ones count as neither."""
    if cases is None:
        return 0, 1
    failed = sum(1 for case in cases if case.find("failure") is not None or case.find("error") is not None)
    skipped = sum(1 for case in cases if case.find("skipped") is not None)
    return len(cases) - failed - skipped, failed


def count_report(path):
    programs = read(path)
    if programs is None:
        return count(None)
    passed = failed = 0
    for program in programs:
        own = path.parent / "cases" / f"{program.get('name')}.xml"
        program_passed, program_failed = count([program])
        if own.exists():
            program_passed, own_failed = count(read(own))
            program_failed = max(program_failed, own_failed)
        passed += program_passed
        failed += program_failed
    return passed, failed


def main():
    reports = [p for p in Path(sys.argv[1]).rglob("*.xml") if p.parent.name != "cases"]
    totals = [count_report(p) for p in reports]
    print(sum(p for p, _ in totals), sum(f for _, f in totals))


if __name__ == "__main__":
    main()
