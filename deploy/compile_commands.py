"""deploy/compile_commands.py BUILD: the compile commands of a build (BUILD/compile_commands.json) as JSON, one for each
source: a file that a unity build joins with others (deploy/cmake/unity.cmake) gets the command of what joins it."""
import json
import re
import sys
from pathlib import Path


def commands_of(build):
    """The entries of BUILD/compile_commands.json, one for each source of ours."""
    entries = []
    for entry in json.loads((Path(build) / "compile_commands.json").read_text()):
        joined = entry["file"]
        if "/Unity/unity_" not in joined:
            entries.append(entry)
            continue
        for source in re.findall(r'^#include "([^"]+)"', Path(joined).read_text(), re.MULTILINE):
            command = entry["command"].replace(f"-c {joined}", f"-c {source}")
            entries.append({"directory": entry["directory"], "command": command, "file": source})
    return entries


if __name__ == "__main__":
    print(json.dumps(commands_of(sys.argv[1]), indent=1))
