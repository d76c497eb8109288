// The document as the run executes it: the tree of that revision, from what was edited here, else from the server.
import { useDeferredValue, useMemo } from "react";
import { differenceRows, differsInDrawing, type DifferenceRow } from "../../shared/edit/difference/rows";
import { difference } from "../../shared/edit/difference/difference";
import { Refusal } from "../../shared/edit/refusal";
import { readTree, type Tree } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import { runOfDocument } from "../../shared/live/shownRun";
import { watchedCore } from "../../shared/session/session";
import { api, session } from "../client";
import { createStore, useSelected } from "../store";
import { editing, useEditing } from "../edit/editing";
import { useRunOfDocument } from "./shownRun";

/** Trees by document and revision; `reason`: why there is none. */
type Known = ReadonlyMap<string, Tree | { readonly reason: string }>;
/** `connected`: what could not be loaded is asked for again. */
type Learnt = { readonly key: string; readonly tree: Tree | { readonly reason: string } } | "connected";

/** So many revisions are kept: a run that follows edits executes one of the last. */
const kKept = 40;
const keyOf = (document: string, revision: number): string => `${revision}/${document}`;

const store = createStore<Known, Learnt>(new Map(), (known, learnt) => {
  if (learnt === "connected") return new Map([...known].filter(([, tree]) => !("reason" in tree)));
  const { key, tree } = learnt;
  if (known.get(key) === tree) return known;
  const others = [...known].filter(([other]) => other !== key).slice(1 - kKept);
  return new Map([...others, [key, tree]]);
});

const loading = new Set<string>();

async function load(document: string, revision: number): Promise<void> {
  const key = keyOf(document, revision);
  if (loading.has(key)) return;
  loading.add(key);
  try {
    const entry = await api.documentAt(document, revision);
    const tree = readTree(entry.document as JsonValue);
    store.dispatch({ key, tree: tree instanceof Refusal ? { reason: tree.message } : tree });
  } catch (error) {
    store.dispatch({ key, tree: { reason: error instanceof Error ? error.message : String(error) } });
  } finally {
    loading.delete(key);
  }
}

/** What was edited here need not be loaded: a revision is what it was when it was confirmed. */
editing.listen(() => {
  const { document, session: edited } = editing.get();
  if (document !== undefined && edited?.confirmed !== undefined) store.dispatch({ key: keyOf(document, edited.confirmed.revision), tree: edited.confirmed.tree });
});

function loadExecuted(): void {
  const { document, session: edited } = editing.get();
  const core = runOfDocument(watchedCore(session.get()), document);
  if (core === undefined || document === undefined || edited?.confirmed === undefined) return;
  if (!store.get().has(keyOf(document, core.revision))) void load(document, core.revision);
}
editing.listen(loadExecuted);

let connection = session.get().connection;
session.listen(() => {
  const before = connection;
  connection = session.get().connection;
  if (before !== connection && connection === "open") store.dispatch("connected");
  loadExecuted();
});

/** The document as the run of it executes it; nothing: it is not here, or there is no run. */
export function useExecuted(): Tree | { readonly reason: string } | undefined {
  const core = useRunOfDocument();
  const key = core && keyOf(core.document, core.revision);
  return useSelected(store, (known) => (key === undefined ? undefined : known.get(key)));
}

export interface Compared {
  readonly before: Tree;
  readonly after: Tree;
  readonly rows: readonly DifferenceRow[];
  /** Places or notes are not the same, either. */
  readonly inDrawing: boolean;
}

let last: Compared | undefined;

function compared(before: Tree, after: Tree): Compared {
  if (last?.before === before && last.after === after) return last;
  const found = difference(before, after);
  last = { before, after, rows: differenceRows(before, after, found), inDrawing: differsInDrawing(found) };
  return last;
}

/** What is edited, compared with what runs; nothing: there is nothing to compare. While one types it may be a moment behind. */
export function useCompared(): Compared | undefined {
  const before = useExecuted();
  const after = useDeferredValue(useEditing((now) => now.session?.view));
  return useMemo(() => (before === undefined || "reason" in before || after === undefined ? undefined : compared(before, after)), [before, after]);
}
