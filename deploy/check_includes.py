#!/usr/bin/python3
"""check_includes.py [FOLDER]: the folders of core, services, server and api form no cycle by their includes, rooms point one way, and
some headers are for some folders alone.

Prints each violation with an include that causes it; exit status 1 if there is one.
"""
import re
import sys
from itertools import pairwise
from pathlib import Path

ROOMS = {  # room: the others that it may include. The client libraries of api are for programs outside: no room of RACE needs them
    "core": (), "services": ("core",), "server": ("core", "services"), "api": ("core", "services", "server"),
}
RESERVED = {  # header: the folders that may include it; tests may include all
    "core/semantics/run.h": ("core/semantics", "core/execution"),  # one driver of a run
}
INCLUDE = re.compile(r'^\s*#include "((?:core|services|server|api)/[^"]+)"', re.MULTILINE)


def read_includes(root):
    """Pairs (file, included file) of all C++ files."""
    files = (path for room in ROOMS for path in sorted((root / room).rglob("*")) if path.suffix in (".h", ".cpp"))
    return [(path.relative_to(root), Path(included))
            for path in files for included in INCLUDE.findall(path.read_text(encoding="utf-8"))]


def edges_of(includes):
    """{folder: {included folder: "file includes file"}}"""
    edges = {}
    for file, included in includes:
        if file.parent != included.parent:
            edges.setdefault(str(file.parent), {}).setdefault(str(included.parent), f"{file} includes {included}")
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


def find_reserved(root, includes):
    """Sentences: includes of reserved headers from other folders, and reserved headers that are not there."""
    missing = [f"there is no {header}, which is reserved" for header in RESERVED if not (root / header).is_file()]
    return missing + [f"{included} is for {' and '.join(RESERVED[str(included)])} alone: {file} includes it"
                      for file, included in includes
                      if str(file.parent) not in RESERVED.get(str(included), (str(file.parent),))]


def violations(root):
    """Sentences: a cycle, if there is one, includes from a lower room, and includes of reserved headers."""
    includes = read_includes(root)
    edges = edges_of(includes)
    found = find_reserved(root, includes)
    cycle = find_cycle(edges)
    if cycle:
        found.append("cycle: " + " -> ".join(cycle))
        found += [f"  {edges[a][b]}" for a, b in pairwise(cycle)]
    for folder, targets in sorted(edges.items()):
        for target, why in sorted(targets.items()):
            room, other = folder.split("/")[0], target.split("/")[0]
            if other != room and other not in ROOMS[room]:
                found.append(f"{folder} must not use {target}: {why}")
    return found


def main():
    found = violations(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    print("\n".join(found) or "includes are as they should be")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
