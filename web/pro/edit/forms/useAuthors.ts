// Who has changed a field last, as far as this page has seen it: for the text beside a draft that somebody else has overtaken.
import { useEffect } from "react";
import { listenToOthers } from "../editing";

const authors = new Map<string, string>();

/** The author of the last change of a field; empty: not known here. */
export const lastAuthor = (id: string, field: string): string => authors.get(`${id}/${field}`) ?? "";

/** Follows the edits of the document that is open. */
export function useAuthors(): void {
  useEffect(
    () =>
      listenToOthers(({ operations, author }) => {
        for (const operation of operations)
          if (operation.op === "set") authors.set(`${operation.id}/${operation.key === undefined ? operation.field : `${operation.field}:${operation.key}`}`, author);
      }),
    [],
  );
}
