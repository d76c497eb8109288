#!/usr/bin/python3
"""check_includes.py [FOLDER]: the folders of core, services and server form no cycle by their includes, and rooms point one way.

Prints each violation with an include that causes it; exit status 1 if there is one.
"""
import re
import sys
from itertools import pairwise
from pathlib import Path

ROOMS = ("core", "services", "server")  # each may include the rooms before it
INCLUDE = re.compile(r'^\s*#include "((?:core|services|server)/[^"]+)"', re.MULTILINE)


def read_includes(root):
    """{folder: {included folder: "file includes file"}} of all C++ files."""
    edges = {}
    for room in ROOMS:
        for path in sorted((root / room).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            file = path.relative_to(root)
            targets = edges.setdefault(str(file.parent), {})
            for included in INCLUDE.findall(path.read_text(encoding="utf-8")):
                folder = str(Path(included).parent)
                if folder != str(file.parent):
                    targets.setdefault(folder, f"{file} includes {included}")
    return edges


def find_cycle(edges):
    """The folders of one cycle, the first again at the end; None if there is none."""
    done, path = set(), []

    def visit(folder):
        if folder in path:
            return [*path[path.index(folder):], folder]
        if folder in done:
            return None
        path.append(folder)
        for target in sorted(edges.get(folder, ())):
            cycle = visit(target)
            if cycle:
                return cycle
        path.pop()
        done.add(folder)
        return None

    for folder in sorted(edges):
        cycle = visit(folder)
        if cycle:
            return cycle
    return None


def violations(edges):
    """Sentences: a cycle, if there is one, and includes from a lower room."""
    found = []
    cycle = find_cycle(edges)
    if cycle:
        found.append("cycle: " + " -> ".join(cycle))
        found += [f"  {edges[a][b]}" for a, b in pairwise(cycle)]
    for folder, targets in sorted(edges.items()):
        for target, why in sorted(targets.items()):
            if ROOMS.index(target.split("/")[0]) > ROOMS.index(folder.split("/")[0]):
                found.append(f"{folder} must not use {target}: {why}")
    return found


def main():
    found = violations(read_includes(Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
    print("\n".join(found) or "no cycle")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
