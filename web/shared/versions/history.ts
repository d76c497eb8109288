// The revisions of a document that the page has loaded, as a value, and what an event makes of it.
import { assertNever } from "../assertNever";
import type { DocumentRevision, Revisions } from "../../generated/messages";
import type { Range } from "./range";

export interface History {
  /** Whether the list is shown. */
  readonly shown: boolean;
  /** What is compared; nothing: no revision is chosen. */
  readonly range: Range | undefined;
  /** The document whose revisions these are. */
  readonly document: string | undefined;
  /** The newest first, without gaps. */
  readonly revisions: readonly DocumentRevision[];
  /** There are older ones: those before this. */
  readonly next: number | undefined;
  /** Why they could not be loaded. */
  readonly reason: string | undefined;
}

export type HistoryEvent =
  | { readonly type: "show"; readonly shown: boolean }
  | { readonly type: "compare"; readonly range: Range | undefined }
  /** Another document is open; nothing: none. */
  | { readonly type: "document"; readonly document: string | undefined }
  | { readonly type: "loaded"; readonly page: Revisions }
  | { readonly type: "failed"; readonly document: string; readonly reason: string };

export const noHistory: History = { shown: false, range: undefined, document: undefined, revisions: [], next: undefined, reason: undefined };

/** The revisions with a page of them. What is older than the page stays where it follows without a gap. */
function withPage(history: History, { revisions: page, next }: Revisions): History {
  const [newest, oldest] = [page[0], page.at(-1)];
  if (newest === undefined || oldest === undefined) return { ...history, revisions: [], next: undefined, reason: undefined };
  const newer = history.revisions.filter(({ revision }) => revision > newest.revision);
  const older = history.revisions.filter(({ revision }) => revision < oldest.revision);
  const follows = older[0]?.revision === oldest.revision - 1;
  const isBehind = newer.at(-1)?.revision === newest.revision + 1;
  return { ...history, revisions: [...(isBehind ? newer : []), ...page, ...(follows ? older : [])], next: follows ? history.next : next, reason: undefined };
}

export function applyHistory(history: History, event: HistoryEvent): History {
  switch (event.type) {
    case "show":
      return event.shown === history.shown ? history : { ...history, shown: event.shown, range: event.shown ? history.range : undefined };
    case "compare":
      return { ...history, shown: history.shown || event.range !== undefined, range: event.range };
    case "document":
      return event.document === history.document ? history : { ...noHistory, document: event.document };
    case "loaded":
      return event.page.name === history.document ? withPage(history, event.page) : history;
    case "failed":
      return event.document === history.document ? { ...history, reason: event.reason } : history;
    default:
      return assertNever(event);
  }
}
