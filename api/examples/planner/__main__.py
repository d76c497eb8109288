"""Sorts parts: `python3 -m planner --help`. Its last line is `sorted`, or `refused: ` with the reason."""
import argparse
import os
import sys
from pathlib import Path

from race_client import Client, RaceError

from .goal import Goal, read_goal
from .refusal import Refused
from .run import Sorter
from .table import lay, table_by_seed

SORTED, REFUSED, WRONG = 0, 1, 2  # exit codes; argparse has 2, too


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="planner", description="Sorts the parts on the table with the skills of a RACE server.")
    parser.add_argument("--server", default="http://127.0.0.1:8080", metavar="URL")
    parser.add_argument("--ca", metavar="FILE", help="authority of an https server; the token of an account is in RACE_TOKEN")
    parser.add_argument("--document", default="sorting", metavar="NAME", help="under which the task is stored (sorting)")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--goal", metavar="FILE", help="JSON: which part at which place; the table stays as it is")
    what.add_argument("--seed", type=int, metavar="N", help="resets the demo's cell and lays a table by chance, with a goal by chance")
    return parser.parse_args()


def goal_of(options: argparse.Namespace, race: Client) -> Goal:
    if options.goal is not None:
        return read_goal(Path(options.goal).read_text(encoding="utf-8"))
    table = table_by_seed(options.seed)
    lay(race, table)
    return table.goal


def main() -> int:
    options = arguments()
    with Client(options.server, token=os.environ.get("RACE_TOKEN"), ca_file=options.ca) as race:
        try:
            goal = goal_of(options, race)
            print(f"goal: {', '.join(f'{label} to {place}' for label, place in goal.parts.items())}", flush=True)
            Sorter(race, goal, lambda text: print(text, flush=True), name=options.document).sort()
        except (Refused, RaceError) as error:
            print(f"refused: {error}")
            return REFUSED
        except (OSError, ValueError) as error:
            print(f"--goal: {error}", file=sys.stderr)
            return WRONG
    print("sorted")
    return SORTED


if __name__ == "__main__":
    sys.exit(main())
