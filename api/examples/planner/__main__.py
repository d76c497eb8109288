"""Sorts parts: `python3 -m planner --help`. Its last line is `sorted`, or `refused: ` with the reason."""
import argparse
import os
import signal
import sys
from pathlib import Path

from race_client import Client, RaceError

from .goal import Goal, read_goal
from .refusal import Refused
from .sorter import Sorter
from .table import lay, table_by_seed

SORTED, REFUSED = 0, 1  # exit codes; that of a wrong command is argparse's, 2
URL = "http://127.0.0.1:8080"


def goal_file(path: str) -> Goal:
    """The goal in a file. ArgumentTypeError: it cannot be read, or is none."""
    try:
        return read_goal(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise argparse.ArgumentTypeError(f"{path}: {error}") from None


def parser() -> argparse.ArgumentParser:
    options = argparse.ArgumentParser(prog="planner", description="Sorts the parts on the table with the skills of a RACE server.")
    options.add_argument("--server", default=URL, metavar="URL", help=f"({URL})")
    options.add_argument("--ca", metavar="FILE", help="authority of an https server; the token of an account is in RACE_TOKEN")
    options.add_argument("--document", default="sorting", metavar="NAME", help="under which the task is stored (sorting)")
    what = options.add_mutually_exclusive_group(required=True)
    what.add_argument("--goal", type=goal_file, metavar="FILE", help="JSON: which part at which place; the table stays as it is")
    what.add_argument("--seed", type=int, metavar="N", help="resets the demo's cell and lays a table by chance, with a goal by chance")
    return options


def sort(race: Client, options: argparse.Namespace) -> None:
    """Refused, RaceError: why not."""
    goal = options.goal
    if goal is None:
        table = table_by_seed(options.seed)
        lay(race, table)
        goal = table.goal
    say = lambda text: print(text, flush=True)
    say(f"goal: {', '.join(f'{label} to {place}' for label, place in goal.parts.items())}")
    Sorter(race, goal, say, name=options.document).sort()


def main() -> int:
    command = parser()
    options = command.parse_args()
    try:
        race = Client(options.server, token=os.environ.get("RACE_TOKEN") or None, ca_file=options.ca)
    except ValueError as error:
        command.error(str(error))
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as Ctrl-C: what it has set in motion is stopped before it ends
    with race:
        try:
            sort(race, options)
        except (Refused, RaceError) as error:
            print(f"refused: {'; '.join(str(error).splitlines())}")
            return REFUSED
        except KeyboardInterrupt:
            print("refused: it was interrupted")
            return REFUSED
    print("sorted")
    return SORTED


if __name__ == "__main__":
    sys.exit(main())
