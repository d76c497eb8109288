"""A client of RACE servers: `Client` waits for each answer, `AsyncClient` is for asyncio; both offer the same.

    from race_client import Client

    with Client("http://127.0.0.1:8080") as race:
        core = race.cores.run("pick", {"pose": "object_pose"}, timeout=120)
        print(core["outcome"], core["results"])

`messages` has the types of all that is sent and answered, `calls` a function for each route. Units are SI; times are said.
"""
from . import calls, messages
from .aio.client import AsyncClient
from .errors import RaceError, ServiceError
from .plain.client import Client
from .updates import Update

__all__ = ["AsyncClient", "Client", "RaceError", "ServiceError", "Update", "calls", "messages"]
