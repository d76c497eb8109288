// Which elements of a drawing stand for the rows of a difference.
import { kSigns, type ChangeKind, type DifferenceRow } from "../edit/difference/rows";
import type { Tree } from "../edit/tree";

/** What is drawn by itself: states, barriers and ports. */
const isDrawn = (kind: string | undefined): boolean => kind === "state" || kind === "barrier" || kind === "port";

/** The element of `after` that a row leads to: itself; of what was removed, the nearest around it that is still there. Nothing: the document. */
export function placeOfRow(before: Tree, after: Tree, { id }: DifferenceRow): string | undefined {
  let at = id;
  while (at !== "" && !after.elements.has(at)) at = before.elements.get(at)?.parent ?? "";
  return at === "" ? undefined : at;
}

/** The same in a third document, which is shown: the nearest element that it has. */
export function placeInShown(before: Tree, after: Tree, shown: Tree, row: DifferenceRow): string | undefined {
  let at = placeOfRow(before, after, row) ?? "";
  while (at !== "" && !shown.elements.has(at)) at = after.elements.get(at)?.parent ?? "";
  return at === "" ? undefined : at;
}

/** Rows by the elements that are drawn for them: `isShown` tells of an element whether it is, else the state around it is asked. */
export function rowsByPlace(before: Tree, after: Tree, rows: readonly DifferenceRow[], isShown: (id: string) => boolean): ReadonlyMap<string, readonly DifferenceRow[]> {
  const found = new Map<string, DifferenceRow[]>();
  for (const row of rows) {
    let at = placeOfRow(before, after, row) ?? "";
    while (at !== "" && !(isDrawn(after.elements.get(at)?.kind) && isShown(at))) at = after.elements.get(at)?.parent ?? "";
    if (at === "") continue;
    const known = found.get(at);
    if (known === undefined) found.set(at, [row]);
    else known.push(row);
  }
  return found;
}

export interface Mark {
  readonly kind: ChangeKind;
  readonly sign: string;
  readonly text: string;
}

/** The mark of an element with these rows: what was added is new as a whole, else something of it or in it changed. */
export function markOf(id: string, rows: readonly DifferenceRow[]): Mark {
  const own = rows.find((row) => row.id === id)?.kind;
  const [first] = rows;
  const kind = own ?? (rows.length === 1 && first !== undefined ? (first.kind === "removed" ? "removed" : "changed") : "changed");
  const text = rows.map((row) => `${row.kind}: ${row.name}${row.text === "" ? "" : `: ${row.text}`}`).join("\n");
  return { kind, sign: kSigns[kind], text };
}
