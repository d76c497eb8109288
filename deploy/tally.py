#!/usr/bin/python3
"""tally.py FOLDER: sums the JUnit reports below FOLDER and prints `PASSED FAILED`.

A CTest report counts a program as one test; where the program left its own report in the folder `cases` beside it,
its cases count instead. A program that fails although no case of its report did (it crashed, or a sanitizer reported an error)
is one failure more.
"""
import sys
import xml.etree.ElementTree as xml
from pathlib import Path


def count(cases):
    """(passed, failed) of testcase elements; skipped ones count as neither."""
    failed = sum(1 for case in cases if case.find("failure") is not None or case.find("error") is not None)
    skipped = sum(1 for case in cases if case.find("skipped") is not None)
    return len(cases) - failed - skipped, failed


def count_report(path):
    passed = failed = 0
    for case in xml.parse(path).getroot().iter("testcase"):
        own = path.parent / "cases" / f"{case.get('name')}.xml"
        case_passed, case_failed = count([case])
        if own.exists():
            case_passed, own_failed = count(list(xml.parse(own).getroot().iter("testcase")))
            case_failed = max(case_failed, own_failed)
        passed += case_passed
        failed += case_failed
    return passed, failed


def main():
    reports = [p for p in Path(sys.argv[1]).rglob("*.xml") if p.parent.name != "cases"]
    totals = [count_report(p) for p in reports]
    print(sum(p for p, _ in totals), sum(f for _, f in totals))


if __name__ == "__main__":
    main()
