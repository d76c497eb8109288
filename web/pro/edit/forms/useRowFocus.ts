// The focus of a list while its rows come, go and move: it goes where it is wanted once the rows are there.
import { useLayoutEffect, useRef, type RefObject } from "react";

type Wanted = { readonly row: string; readonly part: "handle" | "first" } | { readonly element: HTMLElement } | "add";

/** What in a list has the focus next. */
function find(list: HTMLElement | null, wanted: Wanted): HTMLElement | null | undefined {
  if (wanted === "add") return undefined;
  if ("element" in wanted) return wanted.element.isConnected ? wanted.element : null;
  const row = list?.querySelector(`[data-row="${CSS.escape(wanted.row)}"]`);
  return row?.querySelector<HTMLElement>(wanted.part === "handle" ? ".row-handle" : ".row-content :is(input, textarea, select, .cm-content)");
}

export function useRowFocus(list: RefObject<HTMLElement | null>) {
  const wanted = useRef<Wanted>(undefined);
  const section = useRef<HTMLElement>(undefined);
  useLayoutEffect(() => {
    if (list.current !== null) section.current = list.current.parentElement ?? undefined;
    const now = wanted.current;
    if (now === undefined) return;
    const found = now === "add" ? section.current?.querySelector<HTMLElement>("[data-add]") : find(list.current, now);
    if (found === null || found === undefined) return;
    wanted.current = undefined;
    if (document.activeElement !== found) found.focus();
    if (found instanceof HTMLInputElement && "row" in (now as object)) found.select();
  });
  return {
    /** A row that is there, or comes. */
    toRow(row: string | undefined, part: "handle" | "first") {
      if (row === undefined) return;
      wanted.current = { row, part };
      if (part !== "handle") return;
      // Of a row that is there nothing is drawn anew.
      find(list.current, wanted.current)?.focus();
    },
    /** What has it now keeps it: an element that is moved in the page loses it. */
    stay() {
      if (document.activeElement instanceof HTMLElement) wanted.current = { element: document.activeElement };
    },
    /** The list is empty: the button that adds a row. */
    toAdd() {
      wanted.current = "add";
    },
  };
}
