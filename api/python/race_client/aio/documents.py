"""Documents of the asyncio client: tasks in RCM (core/SEMANTICS.md, section 1), with their revisions."""
import uuid
from collections.abc import AsyncIterator, Mapping, Sequence
from typing import cast

from .. import calls
from ..errors import RaceError
from ..messages import AcceptedEdit, Document, DocumentEntry, DocumentRemoved, DocumentSummary, Edit, EditRequest, Revisions, ServerError
from .sender import AsyncSender, send_twice

NO_REVISION = 2**31 - 1  # a document has at most 100000


def tag(revision: int | None) -> str | None:
    """A revision as If-Match has it."""
    return None if revision is None else f'"{revision}"'


class AsyncDocuments:
    """The documents of the server."""

    def __init__(self, client: AsyncSender) -> None:
        self._client = client

    async def all(self) -> AsyncIterator[DocumentSummary]:
        """Each document by name: `name`, last `revision`, and how many `errors` it has (0: it can run). They come page by page."""
        after: str | None = None
        while True:
            page = await self._client.send(calls.list_documents(after=after))
            for summary in page["documents"]:
                yield summary
            after = page.get("next")
            if after is None:
                return

    async def get(self, name: str, *, revision: int | None = None) -> DocumentEntry:
        """The `document`, its `revision` (the last one, or the one asked for), who made it, and its `errors`. RaceError 404 `not_found`."""
        if revision is None:
            return await self._client.send(calls.get_document(name))
        return await self._client.send(calls.get_revision(name, revision))

    async def put(self, name: str, document: Mapping[str, object], *, if_revision: int | None = None, is_new: bool = False,
                  draft: bool = False, author: str | None = None, message: str | None = None) -> DocumentEntry:
        """Stores a document as the next revision, whole or not at all; the answer has it as it is stored, with ids.

        `if_revision`: only if this is the last revision; `is_new`: only if there is no document of this name; else RaceError 412
        `conflict`. `draft`: it may have violations, which the answer lists; else they are a RaceError 422 with path, code and message
        of each. `message`: why it was changed.
        """
        return await self._client.send(calls.put_document(
            name, cast(Document, document), draft=draft, author=author, message=message, if_match=tag(if_revision),
            if_none_match="*" if is_new else None))

    async def check(self, document: Mapping[str, object], *, name: str = "check") -> list[ServerError]:
        """The violations that the document has (none: it can be stored and run), 200 at most. Nothing is stored.

        The server checks a document before it looks at the condition under which it would store it: this asks for one that does
        not hold. Needs the right to change documents. RaceError: it cannot be checked, such as 413 `too_large`.
        """
        call = calls.put_document(name, cast(Document, document), if_match=tag(NO_REVISION))
        try:
            await self._client.send(call)
        except RaceError as error:
            if error.status == 412:
                return []
            if error.status == 422:
                return error.errors
            raise
        raise AssertionError("the server has stored a document under a condition that does not hold")

    async def edit(self, name: str, operations: Sequence[Mapping[str, object]], *, revision: int, request: str | None = None,
                   author: str | None = None, message: str | None = None) -> AcceptedEdit:
        """Applies operations (edit.json: insert, remove, move, set; elements by id), as a whole or not at all, also while it runs.

        `revision`: that the author has seen: what others have done since stays. RaceError 409 `conflict`: they changed the same thing;
        422: an operation cannot be applied. `request`: a token of the edit, else a new one; an edit whose answer does not come is
        sent again with it, and made once. The answer has the new `revision`, and the violations (`errors`) that the document has then.
        """
        edit = cast(Edit, {"operations": list(operations)})
        body: EditRequest = {"revision": revision, "request": request or uuid.uuid4().hex, "operations": edit["operations"]}
        if author is not None:
            body["author"] = author
        if message is not None:
            body["message"] = message
        return await send_twice(self._client, calls.edit_document(name, body))

    async def revisions(self, name: str, *, before: int | None = None) -> Revisions:
        """Who changed it, when [ms since 1970, UTC] and why: 100 revisions, the newest first; `next` is `before` of the next page."""
        return await self._client.send(calls.list_revisions(name, before=before))

    async def delete(self, name: str, *, if_revision: int | None = None) -> DocumentRemoved:
        """Removes it with all revisions; its runs stay.

        RaceError 409 `conflict`: a run of it is not over; 412: `if_revision` is not the last one.
        """
        return await self._client.send(calls.delete_document(name, if_match=tag(if_revision)))
