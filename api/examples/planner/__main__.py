"""Sorts parts: `python3 -m planner --help`. Its last line is `sorted`, or `refused: ` with the reason. With --oracle it answers tasks that
ask it before each move."""
import argparse
import asyncio
import logging
import os
import signal
import sys
from pathlib import Path

from race_client import Client, RaceError

from .goal import Goal, read_goal
from .oracle import Oracle, offer, store
from .refusal import Refused
from .sorter import Sorter
from .table import lay, table_by_seed

DONE, REFUSED = 0, 1  # exit codes; that of a wrong command is argparse's, 2
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
    options.add_argument("--oracle", action="store_true",
                         help="only stores a task that asks before each move, and answers it as the service Oracle until Ctrl-C")
    options.add_argument("--token-file", metavar="FILE",
                         help="of --oracle: the token of a process; else that in RACE_TOKEN, else data/processes.token")
    what = options.add_mutually_exclusive_group(required=True)
    what.add_argument("--goal", type=goal_file, metavar="FILE", help="JSON: which part at which place; the table stays as it is")
    what.add_argument("--seed", type=int, metavar="N", help="resets the demo's cell and lays a table by chance, with a goal by chance")
    return options


def say(text: str) -> None:
    print(text, flush=True)


def client(options: argparse.Namespace) -> Client:
    """ValueError: there is no such server or token."""
    return Client(options.server, token=os.environ.get("RACE_TOKEN") or None, ca_file=options.ca)


def wanted(race: Client, options: argparse.Namespace) -> Goal:
    """What is wanted; of a seed, the table is laid."""
    goal = options.goal
    if goal is None:
        table = table_by_seed(options.seed)
        lay(race, table)
        goal = table.goal
    say(f"goal: {', '.join(f'{label} to {place}' for label, place in goal.parts.items())}")
    return goal


def sort(race: Client, options: argparse.Namespace) -> None:
    """Refused, RaceError: why not."""
    Sorter(race, wanted(race, options), say, name=options.document).sort()
    say("sorted")


def answer(race: Client, options: argparse.Namespace) -> None:
    """As sort(), but that a task is only stored; then answers it, and others, until Ctrl-C."""
    store(race, wanted(race, options), options.document, say)
    logging.basicConfig(format="%(message)s", level=logging.INFO)  # when it is connected, and what it has said wrongly
    try:
        asyncio.run(offer(Oracle(lambda: client(options), say), options.server, options.token_file, options.ca))
    except (OSError, ValueError) as error:
        raise Refused(f"there is no token of a process: {error}") from None


def main() -> int:
    command = parser()
    options = command.parse_args()
    try:
        race = client(options)
    except ValueError as error:
        command.error(str(error))
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # as Ctrl-C: what it has set in motion is stopped before it ends
    with race:
        try:
            (answer if options.oracle else sort)(race, options)
        except (Refused, RaceError) as error:
            print(f"refused: {'; '.join(str(error).splitlines())}")
            return REFUSED
        except KeyboardInterrupt:
            print("refused: it was interrupted")
            return REFUSED
    return DONE


if __name__ == "__main__":
    sys.exit(main())
