// What a run does now, in words.
import type { LiveState } from "../run/liveState";

/** `SearchObject`: `Search object`; `place_area`: `Place area`. */
export function wordsOf(name: string): string {
  const words = name.replace(/_/g, " ").replace(/([a-z0-9])([A-Z])/g, "$1 $2").replace(/([A-Z])([A-Z][a-z])/g, "$1 $2").trim();
  return words
    .split(/\s+/)
    .map((word, i) => (i === 0 ? `${word.charAt(0).toUpperCase()}${word.slice(1)}` : /^[A-Z]{2,}$/.test(word) ? word : word.toLowerCase()))
    .join(" ");
}

export interface Activity {
  /** Below the root, from the outside in: where it is. */
  readonly within: readonly string[];
  /** What is done there. */
  readonly now: string;
  /** So many further things go on beside it. */
  readonly others: number;
}

/** Of the active nodes without an active child the one that lies deepest, of these the first. Nothing: nothing is active. */
export function activityOf({ active }: Pick<LiveState, "active">): Activity | undefined {
  const parents = new Set(active.flatMap((path) => (path.includes("/") ? [path.slice(0, path.lastIndexOf("/"))] : [])));
  const leaves = active.filter((path) => !parents.has(path));
  const depth = (path: string): number => path.split("/").length;
  const [first, ...rest] = leaves;
  if (first === undefined) return undefined;
  const deepest = rest.reduce((found, path) => (depth(path) > depth(found) ? path : found), first);
  const names = deepest.split("/").map(wordsOf);
  return { within: names.slice(1, -1), now: names.at(-1) ?? "", others: rest.length };
}
