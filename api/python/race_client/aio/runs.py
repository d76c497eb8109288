"""Stored runs of the asyncio client: they stay when their cores are gone."""
from collections.abc import AsyncIterator

from .. import calls
from ..messages import Journal, Run, RunFile, RunRemoved, TraceStep
from .sender import AsyncSender, derivation_pages


class AsyncRuns:
    """The runs that the server has stored. `id` is the number of a run, as text, and of the core that hosts it."""

    def __init__(self, client: AsyncSender) -> None:
        self._client = client

    async def all(self, *, document: str | None = None) -> AsyncIterator[Run]:
        """Each run, of one document or of all, the newest first. They come page by page."""
        before: int | None = None
        while True:
            page = await self._client.send(calls.list_runs(document=document, before=before))
            for run in page["runs"]:
                yield run
            before = page.get("next")
            if before is None:
                return

    async def get(self, id: str) -> Run:
        """One run: `status`, `outcome`, `results`, `arguments`, `steps`, when it was `created` and `ended` [ms since 1970, UTC]."""
        return await self._client.send(calls.get_run(id))

    async def derivations(self, id: str, *, first: int = 1, last: int | None = None) -> AsyncIterator[TraceStep]:
        """As `cores.derivations`.

        RaceError 422 `version`: another version of the server executed it; 413 `too_large`: its replay takes too long.
        """
        if last is None:
            last = (await self.get(id))["steps"]
        page = lambda begin, end: self._client.send(calls.get_run_derivations(id, from_=begin, to=end))
        async for step in derivation_pages(page, first, last):
            yield step

    async def journal(self, id: str) -> Journal:
        """Header and inputs of the run, of which it is a function. RaceError 413 `too_large`: more than 16 MiB."""
        return await self._client.send(calls.get_run_journal(id))

    async def export(self, id: str) -> RunFile:
        """All of a run in one file, which any server of this version opens. RaceError 413 `too_large`: more than 16 MiB."""
        return await self._client.send(calls.export_run(id))

    async def delete(self, id: str) -> RunRemoved:
        """Removes it from the store. RaceError 409 `conflict`: a core has it."""
        return await self._client.send(calls.delete_run(id))
