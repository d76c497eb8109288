"""Services of the asyncio client: what they offer (RSM), and calls of their operations."""
from .. import calls
from ..errors import ServiceError
from ..messages import HostedService, Json, ServiceCall
from .sender import AsyncSender


class AsyncServices:
    """The services of the server, by their keys, as in `svc.KEY`."""

    def __init__(self, client: AsyncSender) -> None:
        self._client = client

    async def all(self) -> list[HostedService]:
        """All services: `key`, present `state`, whether it is `available`, and its `rsm` with operations, their parameters and units."""
        return (await self._client.send(calls.list_services()))["services"]

    async def call(self, service: str, operation: str, *arguments: Json, **named: Json) -> Json:
        """Calls an operation, with arguments by position and name, as its RSM has them; its result (null: None).

        ServiceError: the service answers with an error, of which `code` and `error` say more; `unavailable` also: it has no such
        operation. RaceError 404: no such service; 409 `leased`: it moves something, or somebody else has the controls; 429 and
        503 `unavailable`: too many wait, or there was no response within 5 s, and what it began may go on.
        """
        body: ServiceCall = {"operation": operation, "args": [*arguments], "kwargs": named}
        answer = await self._client.send(calls.call_service(service, body))
        if "error" in answer:
            raise ServiceError(service, operation, answer["error"])
        return answer.get("result")
