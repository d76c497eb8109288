// Who has changed a field last, as far as this page has seen it: for the text beside a draft that somebody else has overtaken.
import { useEffect } from "react";
import { listenToStream } from "../../client";
import { editing } from "../editing";

const authors = new Map<string, string>();

/** The author of the last change of a field; empty: not known here. */
export const lastAuthor = (id: string, field: string): string => authors.get(`${id}/${field}`) ?? "";

/** Follows the edits of the document that is open. */
export function useAuthors(): void {
  useEffect(() => {
    const update = (update: Parameters<Parameters<typeof listenToStream>[0]["update"]>[0]) => {
      if (update.type !== "document_edited" || update.edit.document !== editing.get().document) return;
      for (const operation of update.edit.operations)
        if (operation.op === "set") authors.set(`${operation.id}/${operation.key === undefined ? operation.field : `${operation.field}:${operation.key}`}`, update.edit.author);
    };
    return listenToStream({ update, connection: () => undefined }).end;
  }, []);
}
