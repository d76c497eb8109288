// The proofs of a macro step as one list of rows: of a long one, a page draws those in view.
import type { Derivation } from "../../generated/messages";
import { notable, type ProofPath } from "./proof";

/** What a reader folded and unfolded. At first, the nodes are open at which something notable happens. */
export interface Folding {
  /** Every node is open. */
  readonly all: boolean;
  /** Paths of the nodes that were turned since (`keyOf`). */
  readonly turned: ReadonlySet<string>;
}

export const kAsFirst: Folding = { all: false, turned: new Set() };

/** A node that is seen: its parents are open. */
export interface ProofRow {
  readonly node: Derivation;
  readonly path: ProofPath;
  /** The path as a text, which tells it from the others of its proof. */
  readonly key: string;
  /** Its number among the premises of its parent, from 1, and how many these are. */
  readonly position: number;
  readonly siblings: number;
  /** Undefined: it has no premises. */
  readonly open: boolean | undefined;
}

export const keyOf = (path: ProofPath): string => path.join(".");

/** The rows of one proof, in pre-order. */
export function proofRows(root: Derivation, { all, turned }: Folding): readonly ProofRow[] {
  const rows: ProofRow[] = [];
  const visit = (node: Derivation, path: ProofPath, position: number, siblings: number) => {
    const key = keyOf(path);
    const open = node.premises.length === 0 ? undefined : (all || notable(node)) !== turned.has(key);
    rows.push({ node, path, key, position, siblings, open });
    if (open === true) node.premises.forEach((premise, i) => visit(premise, [...path, i], i + 1, node.premises.length));
  };
  visit(root, [], 1, 1);
  return rows;
}

/** Turns a node: one that is open folds. */
export function turn({ all, turned }: Folding, key: string): Folding {
  const next = new Set(turned);
  if (!next.delete(key)) next.add(key);
  return { all, turned: next };
}

/** A proof in the list: its title is row `start`, its nodes follow. */
export interface ProofPlace {
  readonly micro: number;
  readonly start: number;
  readonly rows: readonly ProofRow[];
}

/** Proofs one below the other, an empty row between two; `count`: rows of all. */
export function placeProofs(proofs: readonly (readonly ProofRow[])[]): { readonly places: readonly ProofPlace[]; readonly count: number } {
  const places: ProofPlace[] = [];
  let start = 0;
  for (const [micro, rows] of proofs.entries()) {
    places.push({ micro, start, rows });
    start += rows.length + 2;
  }
  return { places, count: Math.max(0, start - 1) };
}

/** Where a node is in the list. */
export interface ProofCursor {
  readonly micro: number;
  readonly key: string;
}

/** The row of the list at which the node is, or undefined if it is not seen. */
export function rowOf(places: readonly ProofPlace[], { micro, key }: ProofCursor): number | undefined {
  const place = places[micro];
  const at = place?.rows.findIndex((row) => row.key === key) ?? -1;
  return place === undefined || at < 0 ? undefined : place.start + 1 + at;
}

/** The node before or after this one, over the end of a proof into the next; undefined at the ends. */
export function nextNode(places: readonly ProofPlace[], from: ProofCursor, by: 1 | -1): ProofCursor | undefined {
  const place = places[from.micro];
  if (place === undefined) return undefined;
  const row = place.rows[place.rows.findIndex((each) => each.key === from.key) + by];
  if (row !== undefined) return { micro: from.micro, key: row.key };
  const beside = places[from.micro + by];
  const reached = by === 1 ? beside?.rows[0] : beside?.rows.at(-1);
  return reached === undefined ? undefined : { micro: from.micro + by, key: reached.key };
}
