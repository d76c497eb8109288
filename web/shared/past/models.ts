// The model that a run executed in each macro step: that of its header, with the edits of its journal up to then.
import type { Journal, Native } from "../../generated/messages";
import { apply } from "../edit/apply";
import { Refusal } from "../edit/refusal";
import { documentOf, readTree, type Tree } from "../edit/tree";
import type { JsonValue } from "../json";

/** Gives the model of a macro step, the same object for steps between which nothing was edited; a refusal says why it is not known. */
export type ModelsOfRun = (step: number) => Native | Refusal;

interface Version { readonly since: number; readonly native: Native }

/** What changes in the origins of paths; `null` takes one out. */
function changedOrigin(origin: Native["origin"], changes: Readonly<Record<string, string | null>>): Native["origin"] {
  const all: readonly (readonly [string, string | null])[] = Object.entries({ ...origin, ...changes });
  return Object.fromEntries(all.flatMap(([path, from]) => (from === null ? [] : [[path, from] as const])));
}

function versionsOf({ header, entries }: Journal): { readonly versions: readonly Version[]; readonly refused?: { readonly since: number; readonly refusal: Refusal } } {
  const versions: Version[] = [{ since: 0, native: header.native }];
  let native = header.native;
  let tree: Tree | Refusal | undefined;
  for (const { position, input } of entries) {
    if (input.kind !== "edit") continue;
    tree ??= readTree(native.document as unknown as JsonValue);
    const applied = tree instanceof Refusal ? tree : apply(tree, input.edit);
    if (applied instanceof Refusal) return { versions, refused: { since: position, refusal: applied } };
    tree = applied.tree;
    native = { document: documentOf(tree), origin: changedOrigin(native.origin, input.origin ?? {}) };
    versions.push({ since: position, native });
  }
  return { versions };
}

export function modelsOfRun(journal: Journal): ModelsOfRun {
  const { versions, refused } = versionsOf(journal);
  return (step) => {
    if (refused !== undefined && step >= refused.since) return refused.refusal;
    return versions.filter(({ since }) => since <= step).at(-1)?.native ?? journal.header.native;
  };
}
