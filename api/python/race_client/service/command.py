"""Services as a program: its command line, its end, and its new start when a file is saved."""
import argparse
import asyncio
import logging
import os
import signal
import sys
from pathlib import Path
from typing import NoReturn

from ..address import Address, checked_token
from ..errors import RaceError
from .declaration import DeclarationError
from .hosted import Hosted
from .reload import RELOAD, run_anew_when_saved
from .service import Service
from .session import keep_connected

SERVER = "http://127.0.0.1:8080"
TOKEN_FILE = Path("data/processes.token")  # of a server that runs in the same folder


async def serve(*services: Service, server: str = SERVER, token: str | None = None, token_file: str | None = None,
                ca_file: str | None = None) -> None:
    """Offers services until it is cancelled; connects again whenever that is needed.

    `token`: of an account of the role `process` with the group `own`; else that in `token_file`, else the variable RACE_TOKEN, else the
    file data/processes.token, which a server makes for processes of its own user. `ca_file`: of an https server.
    DeclarationError: a class is no service. RaceError: the server refuses them. OSError, ValueError: there is no such token or server.
    """
    await keep_connected([Hosted(service) for service in services], Address.parse(server, ca_file), lambda: token_of(token, token_file))


def token_of(token: str | None, file: str | None) -> str | None:
    """The token of a process; read anew each time, as the server may have made it meanwhile."""
    if token is None and file is None:
        token = os.environ.get("RACE_TOKEN")
        file = str(TOKEN_FILE) if token is None and TOKEN_FILE.exists() else None
    return checked_token(Path(file).read_text().strip() if token is None and file is not None else token)


def run(*services: Service) -> NoReturn:
    """Offers services until SIGINT or SIGTERM, as the command line says, and ends the process: with 0, or 2 if they are refused."""
    options = parser().parse_args()
    if options.reload:
        run_anew_when_saved()
    logging.basicConfig(format="%(message)s", level=logging.INFO, stream=sys.stderr)
    try:
        hosted = [Hosted(service) for service in services]
        address = Address.parse(options.server, options.ca_file)
        status = asyncio.run(until_signal(hosted, address, options.token_file))
    except (DeclarationError, OSError, ValueError) as error:
        print(error, file=sys.stderr)
        status = 2
    sys.exit(status)


async def until_signal(hosted: list[Hosted], address: Address, token_file: str | None) -> int:
    """The exit status."""
    work = asyncio.create_task(keep_connected(hosted, address, lambda: token_of(None, token_file)))
    for number in (signal.SIGINT, signal.SIGTERM):
        # Once: a second signal, as of a parent that gets Ctrl-C, too, would not let what moves be halted.
        asyncio.get_running_loop().add_signal_handler(number, lambda: work.cancelling() or work.cancel())
    try:
        await work
    except asyncio.CancelledError:
        pass
    except RaceError as error:
        for each in error.errors:
            of = next((one.declaration for one in hosted if one.declaration.key == each["path"]), hosted[0].declaration)
            print(f"{of.where()}: error: {of.key}: {each['code']}: {each['message']}", file=sys.stderr)
        return 2
    return 0


def parser() -> argparse.ArgumentParser:
    """The command line of every service."""
    options = argparse.ArgumentParser(description="Offers services at a server of RACE.", allow_abbrev=False)
    options.add_argument("--server", metavar="URL", default=SERVER, help="where it runs (%(default)s)")
    options.add_argument("--token-file", metavar="FILE", help="the token of the process; else RACE_TOKEN, else data/processes.token")
    options.add_argument("--ca-file", metavar="FILE", help="of an https server: its authority, tls/ca.pem of its data folder")
    options.add_argument(RELOAD, action="store_true", help="begins anew when a .py or .json file beside it is saved")
    return options
