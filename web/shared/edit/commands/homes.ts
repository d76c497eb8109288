// The states into which others can move, by their paths: names alone may be those of several states.
import { elementOf, type Tree } from "../tree";
import { nameOfElement } from "./command";
import { reasonAgainstMovingInto } from "./move";

export interface Home {
  readonly id: string;
  /** `Root/Pick`, or `library/Grasp/Close`. */
  readonly path: string;
}

export interface Homes {
  /** The nearest first: those with the fewest steps up and down to where they are now. */
  readonly shown: readonly Home[];
  /** So many others there are. */
  readonly more: number;
}

/** More than so many are no list to look through. */
const kMost = 40;

/** From the outermost state, or the library, to `id`. */
function lineOf(tree: Tree, id: string): readonly string[] {
  const { parent, list } = elementOf(tree, id);
  if (list === undefined) return [id];
  return list === "library" ? ["", id] : [...lineOf(tree, parent), id];
}

const distance = (one: readonly string[], other: readonly string[]): number => {
  const shared = one.findIndex((id, i) => id !== other[i]);
  return one.length + other.length - 2 * (shared < 0 ? one.length : shared);
};

const pathText = (tree: Tree, line: readonly string[]): string => line.map((id) => (id === "" ? "library" : nameOfElement(tree, id))).join("/");

/** Requires at least one of `ids`, and that none is below another. */
export function homesFor(tree: Tree, ids: readonly string[]): Homes {
  const from = lineOf(tree, ids[0] ?? tree.root).slice(0, -1);
  const found = [...tree.elements.values()].filter(({ kind, id }) => kind === "state" && reasonAgainstMovingInto(tree, ids, id) === undefined).map(({ id }) => ({ id, line: lineOf(tree, id) }));
  const near = found.map((home) => ({ ...home, far: distance(from, home.line) })).sort((a, b) => a.far - b.far);
  return { shown: near.slice(0, kMost).map(({ id, line }) => ({ id, path: pathText(tree, line) })), more: Math.max(0, near.length - kMost) };
}
