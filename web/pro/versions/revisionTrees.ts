// Documents as they were in revisions: from what was edited here, else from the server.
import { Refusal } from "../../shared/edit/refusal";
import { readTree, type Tree } from "../../shared/edit/tree";
import type { JsonValue } from "../../shared/json";
import { api, session } from "../client";
import { editing } from "../edit/editing";
import { createStore, useSelected } from "../../page/store";
import { messageOf } from "../../shared/messageOf";

/** A document, or why it is not here. */
export type RevisionTree = Tree | { readonly reason: string };

/** By document and revision. */
type Known = ReadonlyMap<string, RevisionTree>;
/** `connected`: what could not be loaded is asked for again. */
type Learnt = { readonly key: string; readonly tree: RevisionTree } | "connected";

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
    store.dispatch({ key, tree: { reason: messageOf(error) } });
  } finally {
    loading.delete(key);
  }
}

/** Loads a revision that is not here. */
export function loadRevision(document: string, revision: number): void {
  if (!store.get().has(keyOf(document, revision))) void load(document, revision);
}

/** What was edited here need not be loaded: a revision is what it was when it was confirmed. */
editing.listen(() => {
  const { document, session: edited } = editing.get();
  if (document !== undefined && edited?.confirmed !== undefined) store.dispatch({ key: keyOf(document, edited.confirmed.revision), tree: edited.confirmed.tree });
});

let connection = session.get().connection;
session.listen(() => {
  const before = connection;
  connection = session.get().connection;
  if (before !== connection && connection === "open") store.dispatch("connected");
});

/** Nothing: it is not here, or none is asked for. */
export const useRevisionTree = (document: string | undefined, revision: number | undefined): RevisionTree | undefined =>
  useSelected(store, (known) => (document === undefined || revision === undefined ? undefined : known.get(keyOf(document, revision))));
