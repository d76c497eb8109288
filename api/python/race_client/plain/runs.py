# Made from ../aio/runs.py by generate/main.py.
"""Stored runs of the plain client: they stay when their cores are gone."""
from collections.abc import Iterator

from .. import calls
from ..messages import Journal, Run, RunFile, RunRemoved, TraceStep
from .sender import Sender, derivation_pages


class Runs:
    """The runs that the server has stored. `id` is the number of a run, as text, and of the core that hosts it."""

    def __init__(self, client: Sender) -> None:
        self._client = client

    def all(self, *, document: str | None = None) -> Iterator[Run]:
        """Each run, of one document or of all, the newest first. They come page by page."""
        before: int | None = None
        while True:
            page = self._client.send(calls.list_runs(document=document, before=before))
            yield from page["runs"]
            before = page.get("next")
            if before is None:
                return

    def get(self, id: str) -> Run:
        """One run: `status`, `outcome`, `results`, `arguments`, `steps`, when it was `created` and `ended` [ms since 1970, UTC]."""
        return self._client.send(calls.get_run(id))

    def derivations(self, id: str, *, first: int = 1, last: int | None = None) -> Iterator[TraceStep]:
        """As `cores.derivations`.

        RaceError 422 `version`: another version of the server executed it; 413 `too_large`: its replay takes too long.
        """
        if last is None:
            last = self.get(id)["steps"]
        page = lambda begin, end: self._client.send(calls.get_run_derivations(id, from_=begin, to=end))
        yield from derivation_pages(page, first, last)

    def journal(self, id: str) -> Journal:
        """Header and inputs of the run, of which it is a function. RaceError 413 `too_large`: more than 16 MiB."""
        return self._client.send(calls.get_run_journal(id))

    def export(self, id: str) -> RunFile:
        """All of a run in one file, which any server of this version opens. RaceError 413 `too_large`: more than 16 MiB."""
        return self._client.send(calls.export_run(id))

    def delete(self, id: str) -> RunRemoved:
        """Removes it from the store. RaceError 409 `conflict`: a core has it."""
        return self._client.send(calls.delete_run(id))
