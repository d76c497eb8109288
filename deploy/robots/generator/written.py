"""Files that are generated: written, or compared with those that are there."""
import argparse
from pathlib import Path


def write_or_check(files: dict[Path, bytes], description: str) -> int:
    """Writes the files, or with --check says which of them differ. The exit status: 1, if one does."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--check", action="store_true", help="write nothing; fail if a file is not what would be written")
    if not parser.parse_args().check:
        for path, data in files.items():
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
        return 0
    different = [path for path, data in files.items() if not path.is_file() or path.read_bytes() != data]
    for path in different:
        print(f"{path}: is not what is generated")
    return 1 if different else 0
